#!/usr/bin/env bash
# compare, measures and sensitivity from outside, on small studies of short motions.
# usage: compare.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

# study FILE PERIOD DRAWS: locked and unlocked under one pulse
study() {
  cat > study.toml << TOML
schema = "gurney-job/1"
[item]
equipment = "icu_ventilator"
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.3, period_s = $2 }
use = "x"
[study]
draws = $3
sampling = "latin-hypercube"
measures = "PGA h1"
[study.intensity]
scales = [0.5, 1]
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
TOML
  "$gurney" run study.toml -o "$1" > stdout 2> stderr || complain "no study $1"
}
study a.h5 0.4 32
study b.h5 0.5 32
study few.h5 0.4 8

expect 0 "item.brakes" "$gurney" compare a.h5
expect 0 "32 draws, each counts once: one record" "$gurney" compare a.h5 --configurations false,true
expect 0 "less in true: icu_ventilator: peak_displacement" "$gurney" compare a.h5 --demand peak_displacement
expect 0 "excitation.record.synthetic.period_s" "$gurney" compare a.h5 b.h5 --configuration false
expect 0 "item.brakes" "$gurney" compare a.h5 b.h5 --configuration false,true
expect 0 "within each of these families" "$gurney" compare a.h5
expect 0 "|residual_yaw| [deg]" "$gurney" compare a.h5
expect 0 '"p_holm"' "$gurney" compare a.h5 --json
expect 2 "two configurations must be named" "$gurney" compare a.h5 --configuration false
expect 2 "names one twice" "$gurney" compare a.h5 --configurations false,false
expect 1 "no configuration 'flase'; did you mean 'false'?" "$gurney" compare a.h5 --configuration flase
expect 1 "no configuration 'flase'; did you mean 'false'?" "$gurney" compare a.h5 --configurations true,flase
expect 1 "a configuration of each file must be named" "$gurney" compare a.h5 b.h5
expect 1 "did you mean 'peak_tilt'?" "$gurney" compare a.h5 --demand peak_tlt
expect 1 "no intensity measure 'PGA h2'" "$gurney" compare a.h5 --measure "PGA h2"
expect 1 "missing.h5" "$gurney" compare missing.h5
for command in "compare a.h5 --demand peak_tilt" "fragility a.h5" \
    "sensitivity a.h5 --configuration false"; do
  # shellcheck disable=SC2086
  expect 2 "c.eps: the name of a figure must end in .svg, .pdf or .png" \
    "$gurney" $command --figure c.eps
done
expect 0 "c.svg" "$gurney" compare a.h5 --demand peak_tilt --figure c.svg
expect 1 "c.svg: exists already" "$gurney" compare a.h5 --demand peak_tilt --figure c.svg
"$gurney" compare a.h5 --json > once
"$gurney" compare a.h5 --json > twice
cmp once twice || complain "two comparisons of the same files differ"

expect 1 "has one record at scale = 1; there is nothing to compare" "$gurney" compare a.h5 --records
expect 1 "ranks the records of one study; b.h5: is a second one" "$gurney" compare a.h5 b.h5 --records
expect 1 "--level 9: the study has 2 levels" "$gurney" compare a.h5 --records --level 9
expect 1 "did you mean 'peak_tilt'?" "$gurney" compare a.h5 --records --demand peak_tlt
expect 2 "--level requires --records" "$gurney" compare a.h5 --level 1

expect 0 "predicts this demand best" "$gurney" measures a.h5 --limit rolled --configuration false
expect 0 '"verdict"' "$gurney" measures a.h5 --json
expect 1 "a cloud needs a demand above a limit" "$gurney" measures a.h5 --limit overturned
expect 1 "no limit state 'roled'; did you mean 'rolled'?" "$gurney" measures a.h5 --limit roled

expect 0 "Correlated, so the index of each" "$gurney" sensitivity a.h5 --configuration false --level 2
expect 0 "scale = 1" "$gurney" sensitivity a.h5 --configuration false --level 2
expect 0 "64 runs share 32 draws" "$gurney" sensitivity a.h5 --configuration false --all-levels
expect 0 "s.svg" "$gurney" sensitivity a.h5 --configuration false --level 2 --figure s.svg
expect 0 '"correlated"' "$gurney" sensitivity a.h5 --json
expect 1 "are too few: at least 20" "$gurney" sensitivity few.h5
expect 1 "has no level 3; it has 1 to 2" "$gurney" sensitivity a.h5 --level 3
expect 1 "--figure draws one configuration" "$gurney" sensitivity a.h5 --figure t.svg
expect 2 "excludes" "$gurney" sensitivity a.h5 --demand peak_tilt --limit rolled

[ "$failures" -eq 0 ] && echo "all commands did as they should"
exit $((failures > 0))
