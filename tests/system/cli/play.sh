#!/usr/bin/env bash
# gurney play from outside.
# usage: play.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

write_ventilator_job '</script><b>'\''quoted'\'' & \"more\"</b>'
{
  cat run.toml
  cat << 'TOML'
[study]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.2]
TOML
} > study.toml

expect 0 "run.h5" "$gurney" run run.toml -o run.h5 --no-figure
expect 0 "study.h5" "$gurney" run study.toml -o study.h5
play() { expect "$1" "$2" "$gurney" play "${@:3}"; }
play 2 "--output is required" run.h5
play 2 "must end in .html" run.h5 -o page.svg
play 1 "has no --run but 0" run.h5 --run 1 -o page.html
play 1 "choose one of its runs with --run N" study.h5 -o page.html
play 1 "has no run 9; it has runs 0 to 1" study.h5 --run 9 -o page.html
play 1 "--ghost 1: is named twice" study.h5 --run 0 --ghost 1 --ghost 1 -o page.html
play 1 "at most 4 runs" study.h5 --run 0 --run 0 --run 0 --run 0 --run 0 -o page.html
[ -e page.html ] && complain "a page was written for bad input"
play 0 "page.html" run.h5 -o page.html
play 1 "exists already" run.h5 -o page.html
cp page.html first.html
play 0 "page.html" run.h5 -o page.html --overwrite
cmp page.html first.html || complain "two pages of one run differ"
play 0 "both.html" study.h5 --run 0 --run 1 -o both.html
grep -q '"name":"run 1"' both.html || complain "run 1 is not named"
grep -q '"ghosts":null' both.html || complain "a page without ghosts has some"
play 1 "ghosts are of a study, around one of its runs" study.h5 --ghosts -o ghosts.html
play 1 "ghosts are of a study, around one of its runs" study.h5 --run 0 --run 1 --ghosts -o ghosts.html
play 1 "ghosts are of a study, around one of its runs" run.h5 --run 0 --ghosts -o ghosts.html
play 1 "has no run 9; it has runs 0 to 1" study.h5 --run 0 --ghost 9 -o ghosts.html
play 1 "must be another run of the configuration of run 0" study.h5 --run 0 --ghost 0 -o ghosts.html
play 2 "excludes" study.h5 --run 0 --ghost 1 --ghosts -o ghosts.html
play 1 "no other run of the configuration and level of run 0" study.h5 --run 0 --ghosts -o ghosts.html
[ -e ghosts.html ] && complain "a page of ghosts was written for bad input"
play 0 "ghosts.html" study.h5 --run 0 --ghost 1 -o ghosts.html
grep -q '<b>' page.html && complain "the title is not text"
grep -Eq '(src|href)="?(https?:|//)|@import|fetch\(|XMLHttpRequest' page.html && complain "the page asks for more"
[ "$(find . -name '*.html' -size +200k)" = "" ] || complain "a page of some seconds has more than 200 kB"
cp study.toml other.toml
sed -i 's/0.2\]/0.25]/' other.toml
mkdir scratch
TMPDIR=$PWD/scratch play 1 "is not the job of study.h5" study.h5 --run 0 --job other.toml -o other.html
[ "$(ls scratch)" = "" ] || complain "a scratch file is left"
exit $((failures > 0))
