#!/usr/bin/env bash
# The command line from outside: exit codes, messages, and the files that are left.
# usage: commands.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
job=$2/studies/jobs/icu_ventilator_shake.toml
. "$2/tests/system/cli/expect.sh"

# files NAME...: these are in the folder out/ and no other
files() {
  local want got
  want=$(printf '%s\n' "$@" | sort)
  got=$(find out -mindepth 1 -printf '%f\n' 2> /dev/null | sort)
  [ "$got" = "$want" ] || complain "out/ holds '$got' instead of '$want'"
}

expect 0 "CPU class" "$gurney" --version
expect 0 "Exit codes" "$gurney" --help
expect 0 "Exit codes" "$gurney" help
expect 0 "--overwrite" "$gurney" run --help
expect 2 "a command is needed" "$gurney"
expect 2 "nonsense" "$gurney" nonsense
expect 2 "unknown option --jsn; did you mean '--json'?" "$gurney" run "$job" --jsn
expect 2 "unknown option --ouput; did you mean '--output'?" "$gurney" run "$job" --ouput x.h5
grep -q "x.h5" stderr && complain "the value of an unknown option is called an argument"
expect 2 "--overwrite: options of a command stand after it: gurney run ... --overwrite" "$gurney" --overwrite run "$job"
expect 2 "--threads: two: must be a whole number, 1 to 4096" "$gurney" run "$job" -j two
expect 2 "unexpected argument 'more.toml'" "$gurney" run "$job" more.toml
expect 2 "did you mean 'gurney run my.toml'?" "$gurney" my.toml
expect 2 "did you mean 'gurney show my.h5'?" "$gurney" my.h5
expect 2 "JOB is required" "$gurney" run
expect 1 "missing.toml" "$gurney" run missing.toml
files ""

# A name that no file can have is that of no file.
long=$(printf 'n%.0s' {1..300}).AT2
printf 'name, h1\na, %s\n' "$long" > list.csv
for arguments in "run $long" "check $long" "show $long" "status $long" "merge $long" "calibrate $long" "replay $long 1" \
  "fragility $long" "records info $long" "records ls $long" "records ls list.csv"; do
  # shellcheck disable=SC2086
  expect 1 "$long" "$gurney" $arguments
  ! grep -q "filesystem error" stderr || complain "an error of the library: $arguments"
done
rm list.csv

# Files that are often named in the place of a job.
cat > record.AT2 << 'AT2'
PEER NGA STRONG MOTION DATABASE RECORD
Made for this test, 1/1/2000, Station A, 090
ACCELERATION TIME SERIES IN UNITS OF G
NPTS=   4, DT=   .0100 SEC,
  .1000000E-01  .2000000E-01 -.1000000E-01  .0000000E+00
AT2
printf '\211HDF\r\n\032\nrest' > fake.h5
for command in run check converge; do
  expect 1 "is the file of a record; gurney $command takes a job" "$gurney" "$command" record.AT2
  expect 1 "is a results file; gurney $command takes a job" "$gurney" "$command" fake.h5
done
rm record.AT2 fake.h5
files ""

# An item file is no job, and errors are JSON where JSON is asked for.
item=$2/equipment/items/icu_ventilator.toml
expect 1 "the file is an item, not a job" "$gurney" run "$item"
expect 1 "the command for it is: gurney equipment check $item" "$gurney" run "$item"
expect 0 "is valid" "$gurney" check "$item"
expect 1 '"errors": [' "$gurney" show missing.h5 --json
printf 'schema = "gurney-job/1"\n[item]\nequipment = "icu_ventilator"\nbrake = true\n' > bad.toml
for command in run check; do
  expect 1 '"errors": [' "$gurney" "$command" bad.toml --json
  python3 - stdout << 'PYTHON' || complain "gurney $command: the errors are not a list"
import json, sys
(error,) = json.load(open(sys.argv[1]))["errors"]
assert error == {"file": "bad.toml", "line": 4, "column": 1, "key": "item.brake",
                 "message": "item.brake: unknown key; did you mean 'brakes'?"}, error
PYTHON
done
expect 1 "has no use for --resume;" "$gurney" run "$job" --resume
"$gurney" help > /dev/full 2> stderr && complain "help on a full disk ends with 0"
for command in run check replay show play report fragility export compare pulling measures sensitivity loss \
    hospital converge "records floor" "equipment check" calibrate verify; do
  # shellcheck disable=SC2086
  expect 0 "Examples:" "$gurney" $command --help
done
rm -f bad.toml
files ""

expect 0 "residual velocity" "$gurney" run "$job"
files icu_ventilator_shake.{h5,log,svg}
expect 1 "out/icu_ventilator_shake.h5: exists already" "$gurney" run "$job"
expect 0 "peak displacement" "$gurney" run "$job" --overwrite
expect 0 '"demands"' "$gurney" run "$job" -o out/second.h5 --json --no-figure
write_ventilator_job "never replaced by its output"
for ending in h5 svg log; do
  cp run.toml "q.$ending"
  expect 1 "q.$ending: is read by this command and cannot be its output too" "$gurney" run "q.$ending" -o q.h5 --overwrite
  cmp run.toml "q.$ending" || complain "q.$ending was replaced"
  rm "q.$ending"
done
cp out/second.h5 page.html
expect 1 "page.html: is read by this command" "$gurney" report page.html -o page.html --overwrite
cmp out/second.h5 page.html || complain "a page took the place of its results"
rm page.html
expect 1 "$(printf 'a%.0s' $(seq 100))" "$gurney" show "$(printf 'a%.0s' $(seq 60000))" --json
rm run.toml
files icu_ventilator_shake.{h5,log,svg} second.{h5,log}
cmp out/icu_ventilator_shake.h5 out/second.h5 || complain "two runs of one job differ"

expect 2 "must end in .h5" "$gurney" run "$job" -o out/third.txt
expect 1 "none does not exist" "$gurney" run "$job" -o none/third.h5
mkdir -p out/folder.h5
expect 1 "is a folder" "$gurney" run "$job" -o out/folder.h5
rmdir out/folder.h5
expect 1 "cannot be written" "$gurney" run "$job" -o /proc/third.h5
# shellcheck disable=SC2317
full_disk() { (ulimit -f 8; "$gurney" run "$job" -o out/full.h5); }  # 8 kB, less than the file
expect 1 "out/full.h5: cannot be written, nothing was kept: File too large" full_disk
files icu_ventilator_shake.{h5,log,svg} second.{h5,log}

# A run long enough to be interrupted; nothing of it may stay.
sed -e 's/^\[settings\]/[settings]\nduration_s = 7200/' -e 's/^time_step_s = .*/time_step_s = 0.0005/' "$job" > long.toml
sed -i "s|file = \"../../|file = \"$2/|" long.toml
for pair in INT:130 TERM:143; do
  "$gurney" run long.toml -o out/long.h5 > stdout 2> stderr &
  process=$!
  sleep 1
  kill -s "${pair%:*}" "$process"
  wait "$process"
  got=$?
  [ "$got" -eq "${pair#*:}" ] || complain "exit code $got after SIG${pair%:*}"
  grep -q interrupted stderr || complain "does not say that it was interrupted"
done
files icu_ventilator_shake.{h5,log,svg} second.{h5,log}

# A real record that falls faster than gravity, where there are any: Kaikoura 2016 at Waiau.
if [ -n "${GURNEY_RECORDS:-}" ]; then
  cat > waiau.toml << TOML
schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[excitation.record]
file = "$GURNEY_RECORDS/geonet_v1a_v2a/20161113_110259_WTMC_20.V1A"
processing = [
  { step = "baseline", kind = "mean" },
  { step = "high_pass", corner_hz = 0.1 },
  { step = "window", from_s = 95, to_s = 115, taper_s = 1 },
]
TOML
  expect 0 "most wheels lifted         4" "$gurney" run waiau.toml -o out/waiau.h5 --no-figure
fi

[ "$failures" -eq 0 ] && echo "all commands did as they should"
exit $((failures > 0))
