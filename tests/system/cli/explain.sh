#!/usr/bin/env bash
# gurney explain from outside.
# usage: explain.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

write_ventilator_job '<b>'\''quoted'\'' & \"more\"</b>' 1.0
{
  cat run.toml
  cat << 'TOML'
[study]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.3]
TOML
} > study.toml
cat > items.toml << 'TOML'
schema = "gurney-job/1"
[[item]]
name = "<i>bed & \"co\""
equipment = "icu_bed"
brakes = true
[[item]]
name = "pole, a very long name of an infusion pole that stands beside the bed all night and day"
equipment = "infusion_pole"
position_m = [0, 2]
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.4, period_s = 0.8 }
use = "x"
TOML
cat > calm.toml << 'TOML'
schema = "gurney-job/1"
[item]
equipment = "icu_ventilator"
brakes = true
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.01, period_s = 0.5 }
use = "x"
TOML
for job in run items calm; do expect 0 "$job.h5" "$gurney" run $job.toml -o $job.h5 --no-figure; done
expect 0 "study.h5" "$gurney" run study.toml -o study.h5
explain() { expect "$1" "$2" "$gurney" explain "${@:3}"; }

# One run.
explain 0 "icu_ventilator moved up to" run.h5
for words in "What happened" "starts to slide or roll" "half cycle of the floor" "Margins" "no brake is on" "Energy of"; do
  grep -qF "$words" stdout || complain "does not state '$words'"
done
[ "$(awk 'length > 100' stdout)" = "" ] || complain "lines of more than 100 columns"
cp stdout of_run
explain 0 "did nothing: it moved less than 1 mm" calm.h5
explain 0 '"finding": "moved"' run.h5 --json
python3 -m json.tool stdout > run.json || complain "no JSON"
grep -q "b>'quoted'" run.json || complain "the title is missing"

# From another folder: the log states where the run was.
expect 0 "icu_ventilator moved up to" env -C / "$gurney" explain "$PWD/run.h5"

# A run of a study is that of the job.
explain 1 "choose one of its runs with --run N" study.h5
explain 1 "has no run 9; it has runs 0 to 1" study.h5 --run 9
explain 1 "has no --run but 0" run.h5 --run 1
explain 2 "must be a whole number, 0 or more" study.h5 --run -1
explain 0 "icu_ventilator moved up to" study.h5 --run 1
diff of_run stdout || complain "the run of the study is explained in other words"
# So is the file of a repeated run, here and from another folder; without its study it says so.
expect 0 "the same results" "$gurney" replay study.h5 1 -o again.h5 --no-figure
explain 0 "icu_ventilator moved up to" again.h5
diff of_run stdout || complain "the repeated run is explained in other words"
expect 0 "icu_ventilator moved up to" env -C / "$gurney" explain "$PWD/again.h5"
expect 0 "again.html" "$gurney" report again.h5 -o again.html
grep -qF "starts to slide or roll" again.html || complain "the report of a repeated run does not explain it"
mv study.h5 kept.h5
explain 1 "again.h5: is run 1 of the study study.h5, which does not exist any more" again.h5
mv kept.h5 study.h5
sed -i '/^study /d' again.log
explain 1 "again.h5: is one run of a study, and its log does not name which" again.h5

sed 's/0.3/0.31/' run.toml > other.toml
explain 1 "is not the job of run.h5" run.h5 --job other.toml
explain 1 "none.toml does not exist any more" run.h5 --job none.toml
explain 1 "not" run.toml

# The figure; hostile names are text in it.
explain 0 "why.svg" run.h5 -o why.svg
grep -q '<b>' why.svg && complain "the title is not text"
explain 1 "exists already" run.h5 -o why.svg
explain 2 "why.doc" run.h5 -o why.doc
explain 0 "why.pdf" run.h5 -o why.pdf --width 85mm --grey
explain 0 "pole, a very long name" items.h5 -o items.svg
grep -q '<i>' items.svg && complain "the name of an item is not text"
explain 0 '"items"' items.h5 --json
python3 -m json.tool stdout > items.json || complain "no JSON"

# The report of one run has the text; without its job it says why not.
expect 0 "run.html" "$gurney" report run.h5 -o run.html
for words in "What happened and why" "starts to slide or roll" "Energy of icu_ventilator"; do
  grep -qF "$words" run.html || complain "the report does not state '$words'"
done
expect 0 "items.html" "$gurney" report items.h5 -o items.html
grep -q '<i>' items.html && complain "the name of an item is not text in the report"
mv run.log kept.log
expect 0 "bare.html" "$gurney" report run.h5 -o bare.html
grep -qF "Not explained: run.h5: the job&#39;s file is not known" bare.html ||
  grep -qF "Not explained: run.h5: the job's file is not known" bare.html || complain "the report does not say why"
explain 1 "is not known; name it with --job" run.h5
explain 0 "icu_ventilator moved up to" run.h5 --job run.toml
mv kept.log run.log

# A weight that pulls is a load; springs and dampers have next to nothing of it.
expect 0 "pull.h5" "$gurney" run "$2/studies/jobs/pulling_test.toml" -o pull.h5 --no-figure
explain 0 "Energy of xu_trolley" pull.h5
awk '$1 == "end" { found = $4 > 40 && $10 > -5 && $10 < 5 } END { exit !found }' stdout ||
  complain "the work of the weight that pulls is not among the loads"

# Uplifts that the events leave out are counted.
sed '/^\[item\]/a brakes = true' run.toml | sed 's/pga_g = [0-9.]*/pga_g = 0.6/; s/"x"/"xyz"/; s/kind = "ricker".*}/kind = "clough_penzien" }/' > rocks.toml
expect 0 "rocks.h5" "$gurney" run rocks.toml -o rocks.h5 --no-figure
explain 0 "uplifts; the events have the" rocks.h5

# Variants.
explain 1 "--what-if, which is missing" run.h5 --replicas 3
explain 0 "all brakes on" run.h5 --what-if -j 1
for words in "Not tried" "none of its casters is braked" "there is nothing in the room" "would have prevented"; do
  grep -qF "$words" stdout || complain "does not state '$words'"
done
cp stdout one_thread
explain 0 "all brakes on" run.h5 --what-if -j 3
cmp one_thread stdout || complain "variants depend on the number of threads"
explain 0 "2 replicas of each" run.h5 --what-if --replicas 2
explain 0 '"conclusion"' run.h5 --what-if --json
python3 -m json.tool stdout > variants.json || complain "no JSON"
explain 0 "there is nothing to prevent" calm.h5 --what-if
exit $((failures > 0))
