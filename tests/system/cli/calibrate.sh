#!/usr/bin/env bash
# `gurney calibrate` from outside: exit codes, messages, and the files that are left.
# usage: calibrate.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

# calibrate CODE TEXT ARGUMENTS...: what `gurney calibrate` does
calibrate() { expect "$1" "$2" "$gurney" calibrate "${@:3}"; }

mkdir trials
cp "$2"/studies/calibration/example/{pull,locked,impact}_*.csv trials
calibrate 2 "TRIALS is required"
calibrate 0 "Cr/R of R100 on polyflor_mystique" trials
grep -q "EXCLUDED, with the reason below: 1 of 12 trials (pull_6.csv)" stdout ||
  complain "does not say at the top that a trial is left out"
grep -q "SIMULATED: 12 of 12 trials" stdout || complain "does not say that trials are simulated"
grep -q "^ *trials/pull_6.csv: .* units: is the displacement a thousandth" stdout ||
  complain "does not name the trial with swapped units"
calibrate 0 '"name": "static_friction"' trials --json
calibrate 0 "calibrated/R100_on_polyflor_mystique.toml" trials -o calibrated
grep -q "</svg>" calibrated/calibration.svg || complain "no figure"
expect 0 "is valid" "$gurney" equipment check calibrated/R100_on_polyflor_mystique.toml
calibrate 1 "calibration.txt: exists already" trials -o calibrated
[ -s stdout ] && complain "it computes before it refuses to overwrite"
calibrate 0 "calibrated/calibration.json" trials -o calibrated --overwrite
calibrate 1 "the folder nodir does not exist" trials -o nodir/calibrated
[ -e nodir ] && complain "the folder above that of the files was made"
calibrate 1 "'R200': unknown caster; did you mean" trials --base R200 -o other

sed 's/^# caster = R100/# caster = mine/; s/force_n/force/' trials/pull_1.csv > trials/bad.csv
calibrate 1 "force: unknown column; did you mean 'force_n'?" trials
mkdir one
sed 's/^# caster = R100/# caster = mine/' trials/pull_1.csv > one/mine.csv
calibrate 0 "mine: the catalogue has no caster 'mine'" one
calibrate 1 "mine: the catalogue has no caster 'mine'" one -o mine
[ -e mine ] && complain "calibrate writes files although no caster file is possible"
calibrate 0 "mine_on_polyflor_mystique.toml" one --base R100 -o mine
expect 0 "is valid" "$gurney" equipment check mine/mine_on_polyflor_mystique.toml
mkdir empty
calibrate 1 "empty: has no .csv file of a trial" empty
calibrate 1 "none.csv: no such file" none.csv

exit $((failures > 0))
