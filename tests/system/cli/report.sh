#!/usr/bin/env bash
# gurney report from outside: pages of a run and of a study.
# usage: report.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

write_ventilator_job '<b>'\''quoted'\'' & \"more\"</b> \u65e5\u672c'
{
  cat run.toml
  cat << 'TOML'
[study]
measures = "PGA h1"
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.2, 0.4]
[[study.factor]]
name = "brakes"
[study.factor.level.off]
item.brakes = false
[study.factor.level."<i>on</i>"]
item.brakes = true
TOML
} > study.toml
expect 0 "run.h5" "$gurney" run run.toml -o run.h5 --no-figure
expect 0 "study.h5" "$gurney" run study.toml -o study.h5

has() { grep -qF -- "$2" "$1" || complain "$1 lacks '$2'"; }
has_not() { ! grep -qF -- "$2" "$1" || complain "$1 has '$2'"; }

expect 0 "run.html" "$gurney" report run.h5 -o run.html
expect 0 "study.html" "$gurney" report study.h5 -o study.html
for page in run.html study.html; do
  has "$page" "<title>&lt;b&gt;&#39;quoted&#39; &amp; &quot;more&quot;&lt;/b&gt; 日本</title>"
  has "$page" 'id="item-1-figure"'
  has_not "$page" "No drawing"
  has_not "$page" "<i>on"
  has_not "$page" 'src="'
  has_not "$page" 'href="http'
  has "$page" "$("$gurney" --version | awk '/^commit/ {print $2}')"
done
has run.html 'id="history-tilt-figure"'
has run.html 'settled to'
has study.html "Limit state overturned"
expect 0 "again.html" "$gurney" report study.h5 -o again.html
cmp study.html again.html || complain "two pages of one file differ"
expect 0 "far.html" "$gurney" report study.h5 --limit-state 'peak_displacement > 0.2 m' -o far.html
has far.html "peak_displacement &gt; 0.2 m"
has_not far.html "Limit state overturned"

# The page runs the job again with histories of single steps: what the file states of them stays.
{ cat run.toml; printf '[output]\nhistory_step_s = 0.252\n'; } > coarse.toml
expect 0 "a change of mass" "$gurney" run coarse.toml -o coarse.h5 --no-figure
grown=$(grep -oE 'grows [^ ]*-fold|shrinks to [^ ]* of its size' stdout)
expect 0 "coarse.html" "$gurney" report coarse.h5 -o coarse.html
has coarse.html "$grown"

echo '{"schema": "geojson/1"}' > foreign.json
expect 1 '"gurney-calibration/1"' "$gurney" report foreign.json -o x.html
"$gurney" verify alignment/crosswise --json > verified.json 2> stderr
expect 0 "verified.html" "$gurney" report verified.json -o verified.html
has verified.html "alignment/crosswise"
expect 1 "limit states, hazard and consequences are for the file of a study" \
  "$gurney" report verified.json --limit-state overturned -o x.html
has_not study.html 'id="loss'
expect 0 "loss.html" "$gurney" report study.h5 --consequences "$2/equipment/consequences.toml" -o loss.html
"$gurney" loss study.h5 --consequences "$2/equipment/consequences.toml" > loss.txt
has loss.html 'id="loss-figure"'
has loss.html "$(awk '/^Losses in/ {print; exit}' loss.txt)"
has loss.html "P(injury)"
expect 1 "limit states, hazard and consequences are for that of a study" \
  "$gurney" report run.h5 --consequences "$2/equipment/consequences.toml" -o x.html
expect 1 "prices.toml" "$gurney" report study.h5 --consequences prices.toml -o x.html
[ ! -e x.html ] || complain "a page in spite of an error"
expect 1 "run.html: exists already" "$gurney" report run.h5 -o run.html
expect 0 "run.html" "$gurney" report run.h5 -o run.html --overwrite
expect 2 "must end in .html" "$gurney" report run.h5 -o run.pdf
expect 1 "is the file of one run" "$gurney" report run.h5 --limit-state overturned -o x.html
expect 1 "missing.h5" "$gurney" report missing.h5 -o x.html
expect 1 "no_such" "$gurney" report study.h5 --limit-state 'no_such > 1 m' -o x.html
expect 2 "--output is required" "$gurney" report run.h5
[ -e x.html ] && complain "x.html was left"

exit $((failures > 0))
