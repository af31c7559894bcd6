#!/usr/bin/env bash
# `gurney new`: every kind of file is accepted and runs as it is, and nothing is overwritten.
# usage: new.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

for kind in job item caster room study calibration; do
  expect 0 "written  my_$kind" "$gurney" new "$kind" "my_$kind"
  eval "$(sed -n 's/^next *gurney/"$gurney"/p' stdout)" > next 2>&1 || complain "$kind: what it says to do next fails"
  expect 1 "exists already" "$gurney" new "$kind" "my_$kind"
done
for kind in job item caster room study; do expect 0 "valid" "$gurney" check "my_$kind.toml"; done
expect 0 "a valid single run" "$gurney" check my_job.toml
expect 0 "a valid study" "$gurney" check my_study.toml
expect 0 "Cr/R of R100" "$gurney" calibrate my_calibration -o calibrated

# An item on a new caster in a new room, and a study of it.
expect 0 "written" "$gurney" new item cart --caster my_caster.toml
mkdir jobs
expect 0 "written" "$gurney" new job jobs/all --item cart.toml --room my_room.toml
grep -q '^equipment = "../cart.toml"' jobs/all.toml || complain "the item is not named from the job's folder"
expect 0 "results" "$gurney" run jobs/all.toml -o all.h5 --no-figure
expect 0 "200 runs" bash -c '"$1" run my_study.toml -o study.h5 -q && "$1" show study.h5 && echo 200 runs' bash "$gurney"
expect 0 "displaced" "$gurney" fragility study.h5
expect 0 "off            displaced" "$gurney" fragility study.h5
expect 1 "my_cart: unknown item of equipment; for the file write my_cart.toml" \
  bash -c 'cp cart.toml my_cart.toml && "$1" equipment show my_cart' bash "$gurney"

# A job with a record of one's own, in another folder; with one component, and with a file that is none.
expect 0 "written" "$gurney" new job jobs/own --record "$2/groundmotions/records/synthetic_3c.csv"
expect 0 "record  synthetic_3c" "$gurney" check jobs/own.toml
grep -q "synthetic = " jobs/own.toml && complain "the synthetic motion stays beside the record"
one='a "one".csv'  # what a job must escape
expect 0 "$one" "$gurney" records make near_fault_pulse period_s=1 -o "$one"
expect 0 "written" "$gurney" new job one --record "$one"
grep -q '^use = "x"  # components that it has' one.toml || complain "the components are not stated"
expect 0 "a valid single run" "$gurney" check one.toml
cp "$one" NAMEd.csv
expect 0 "written" "$gurney" new job called --record NAMEd.csv
grep -q '^file = \["NAMEd.csv"\]' called.toml || complain "the name of the job is put into that of the record"
expect 1 "a job cannot name it" "$gurney" new job none --record $'not\xff.csv'
expect 1 "not a record in a known format" "$gurney" new job none --record one.toml
expect 1 "--record is for a job" "$gurney" new study none --record "$one"
expect 1 "gurney new job NAME --record '$one'" "$gurney" run "$one"
[ -e none.toml ] && complain "a file is left by a command that failed"

# From a folder of records: two that can be read, one that cannot, no vertical component in one.
mkdir records
expect 0 "pulse.csv" "$gurney" records make near_fault_pulse period_s=1 -o records/pulse.csv
cp "$2/groundmotions/records/synthetic_3c.csv" records
expect 0 "written" "$gurney" new study found --from records --item cart.toml
grep -q '^suite = "records"' found.toml || complain "the folder is not named"
grep -q '^use = "x"  # components that every record has' found.toml || complain "components are not stated"
expect 0 "a valid study" "$gurney" check found.toml
# More than half have three components: these are kept. A record that is too weak is left out.
mkdir three
cp "$2/groundmotions/records/synthetic_3c.csv" three/a.csv
cp "$2/groundmotions/records/synthetic_3c.csv" three/b.csv
cp "$2/groundmotions/records/synthetic_3c.csv" three/c.csv
cp records/pulse.csv three
awk 'BEGIN { print "time (s),EW (g),NS (g),UD (g)"; for (i = 0; i < 500; ++i)
  printf "%.2f,%.5f,%.5f,%.5f\n", i / 100, 0.01 * sin(i / 5), 0.01 * cos(i / 6), 0.01 * sin(i / 7) }' > three/weak.csv
expect 0 "excluded: pulse: it has no h2 and vertical" "$gurney" new study kept --from three --item cart.toml
expect 0 "excluded: weak: the highest level needs a factor of 100, more than 20" "$gurney" new study again --from three --item cart.toml
grep -q '^use = ' kept.toml && complain "components are left out that most records have"
grep -q '^  # "three/pulse.csv",' kept.toml || complain "a record that lacks a component is not listed"
expect 0 "a valid study" "$gurney" check kept.toml
sed 's|^suite = .*|suite = ["three/weak.csv",|' kept.toml > weak.toml
expect 0 "weak: scaled by 100, more than 20" "$gurney" check weak.toml
echo "no record" > records/notes.txt
expect 0 "records  2 of 3 records; listed.toml states why the others are excluded (no unit in them: --unit g)" \
  "$gurney" new study listed --from records --item cart.toml
grep -q '"records/pulse.csv",' listed.toml || complain "the files are not listed"
expect 0 "a valid study" "$gurney" check listed.toml
"$gurney" run listed.toml -o listed.h5 --quiet > stdout 2> stderr || complain "the listed records do not run"
[ -s stdout ] && complain "--quiet prints something"
rm records/*.csv
expect 1 "no record can be read" "$gurney" new study none --from records --item cart.toml
[ -e none.toml ] && complain "a file is left by a command that failed"

expect 1 "has no use for --item" "$gurney" new caster another --item icu_ventilator
expect 1 "no such file" "$gurney" new job another --item none.toml
expect 1 "--item icu_ventilatr: unknown item of equipment; did you mean 'icu_ventilator'?" "$gurney" new job another --item icu_ventilatr
expect 1 "no such file" "$gurney" new job another --room "$(printf 'r%.0s' {1..300}).toml"
expect 1 "--from is for a study" "$gurney" new job another --from records
expect 1 'NAME "": must be the name of a file' "$gurney" new job ""
expect 2 "SHELF" "$gurney" new SHELF another

[ "$failures" -eq 0 ] && echo "every new file runs"
exit $((failures > 0))
