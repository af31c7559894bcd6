#!/usr/bin/env bash
# gurney pulling and gurney export --to trials from outside: exit codes, messages, files.
# usage: pulling.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

"$gurney" run "$2/studies/jobs/pulling_tests.toml" -o tests.h5 > stdout 2> stderr ||
  complain "the study does not run"
expect 0 "50 trials of tests.h5" "$gurney" pulling tests.h5
expect 0 '"alignment": "reversed"' "$gurney" pulling tests.h5 --json
expect 0 "wrote    figures/figure_11.svg" "$gurney" pulling tests.h5 -o figures --run 36
for figure in 4 6 7 11; do
  grep -q "</svg>" "figures/figure_$figure.svg" || complain "figure $figure is not there"
done
grep -q "Run 36: R100, polyflor_mystique, 0, 8 kg, crosswise" figures/figure_4.svg ||
  complain "figure 4 does not show run 36"
expect 1 "figures/figure_4.svg: exists already" "$gurney" pulling tests.h5 -o figures
expect 1 "tests.h5: has no run 50 that did not fail; its last is 49" "$gurney" pulling tests.h5 \
  --run 50
expect 2 "FILE is required" "$gurney" pulling
expect 1 "nothing.h5: no such file" "$gurney" pulling nothing.h5

# Written as trials, they are read as what a user measured.
expect 0 "wrote    tests_trials/trial_49.csv" "$gurney" export tests.h5 --to trials
[ "$(grep -l '# note = SYNTHETIC' tests_trials/*.csv | wc -l)" -eq 50 ] ||
  complain "not every trial says that it is synthetic"
expect 0 "trial_07" "$gurney" pulling tests.h5 --measured tests_trials --run 7
sed -i 's/^time_s/time_q/' tests_trials/trial_07.csv
expect 1 "trial_07.csv:" "$gurney" pulling tests.h5 --measured tests_trials
expect 2 "--limit cannot be combined with --to trials" "$gurney" export tests.h5 --to trials --limit moved

# The trials again under their own force, for their duration.
rm tests_trials/trial_07.csv
mkdir few
cp tests_trials/trial_00.csv tests_trials/trial_42.csv few
sed '/^# item/d' few/trial_00.csv > few/nameless.csv
expect 0 'omitted nameless: no `item` is stated' "$gurney" export few --to job -o driven
expect 0 "results  driven.h5" "$gurney" run driven/few.toml -o driven.h5
expect 0 "trial_42" "$gurney" pulling driven.h5 --measured few
expect 0 '"driven_by": {' "$gurney" pulling driven.h5 --measured few --json
expect 1 "no pull that can be repeated under its force" "$gurney" export few/nameless.csv --to job -o no

# Noise is said to be synthetic wherever it is.
expect 0 "synthetic noise of 0.1 mm and 0.5 N (standard deviations), seed 7" \
  "$gurney" pulling tests.h5 --noise 7 -o noisy
grep -q "synthetic noise of 0.1 mm" noisy/figure_4.svg || complain "figure 4 does not state its noise"
expect 0 "wrote" "$gurney" export tests.h5 --to trials -o noisy_trials --noise 7
grep -q "synthetic noise of 0.1 mm and 0.5 N, seed 7" noisy_trials/trial_00.csv ||
  complain "a noisy trial does not state its noise"
expect 2 "--noise is for --to trials" "$gurney" export tests.h5 --to csv --noise 7

# A study that is no pulling test.
"$gurney" run "$2/studies/jobs/brakes_study.toml" -o brakes.h5 > stdout 2> stderr ||
  complain "the study of brakes does not run"
expect 1 "brakes.h5: keeps no histories" "$gurney" pulling brakes.h5

[ "$failures" -eq 0 ] && echo "all commands did as they should"
exit $((failures > 0))
