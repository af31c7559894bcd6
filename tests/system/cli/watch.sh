#!/usr/bin/env bash
# gurney report --watch: the page of a running study, written again while it runs, whole once it ends.
# usage: watch.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

write_ventilator_job "a study to watch"
cat run.toml - > study.toml << TOML
[study]
angles_deg = [$(seq -s, 0 15 345)]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.2, 0.3, 0.4]
TOML
runs_of() { sed -n 's/.*<p>A study of \([0-9]*\) runs.*/\1/p' "$1"; }

expect 1 "none.h5.parts: no such folder" "$gurney" report none.h5.parts --watch -o page.html
begin study.toml study.h5
expect 0 "page.html" "$gurney" report study.h5.parts -o page.html
grep -q 'UNFINISHED: [0-9]* of 24 analysis cases of study.h5' page.html || complain "does not say how much is finished"
grep -q 'http-equiv="refresh"' page.html || complain "the page does not load itself again"
grep -q 'gurney replay' page.html && complain "gives commands for runs that will have other numbers"

"$gurney" report study.h5.parts --watch -o page.html > watched 2>&1 &
watching=$!
wait "$watching"
[ $? -eq 1 ] || complain "replaces a page without --overwrite"
"$gurney" report study.h5.parts --watch -o watched.html > watched 2>&1 &
watching=$!
wait_for watched.html
first=$(runs_of watched.html)
kill -INT "$watching"
wait "$watching"
[ $? -eq 130 ] || complain "does not end with 130 at Ctrl-C"
grep -q "interrupted" watched || complain "does not say that it was interrupted"
"$gurney" report study.h5.parts --watch -o watched.html --overwrite > watched 2>&1 &
watching=$!
ends 0 "study.h5"
wait "$watching"
[ $? -eq 0 ] || { cp watched stdout; complain "does not end with 0 when the study ends"; }
last=$(runs_of watched.html)
[ "${first:-0}" -gt 0 ] && [ "${last:-0}" -eq 96 ] && [ "$first" -lt "$last" ] ||
  complain "the page has $first runs at first and $last at the end"
expect 0 "whole.html" "$gurney" report study.h5 -o whole.html
cmp watched.html whole.html || complain "the last page is not that of the results"
expect 0 "again.html" "$gurney" report study.h5.parts --watch -o again.html

# A study that was interrupted is not waited for. It is too long to end before a loaded machine interrupts it.
sed "s/^angles_deg.*/angles_deg = [$(seq -s, 0 359)]/" study.toml > long.toml
begin long.toml stopped.h5
kill -INT "$process"
ends 130 "interrupted"
expect 0 "no process works on stopped.h5.parts" "$gurney" report stopped.h5.parts --watch -o stopped.html
grep -q UNFINISHED stopped.html || complain "the page of an interrupted study is not written"

exit $((failures > 0))
