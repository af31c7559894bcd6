#!/usr/bin/env bash
# Slips of a newcomer in a job: what is said names the place, the value and what is allowed.
# usage: slips.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

cat > good.toml << TOML
schema = "gurney-job/1"
[item]
equipment = "icu_ventilator"
[excitation.record]
file = "$2/groundmotions/records/synthetic_3c.csv"
[settings]
duration_s = 1
TOML
expect 0 "a valid single run" "$gurney" check good.toml

# slip TEXT SED: the job with this change is refused with TEXT
slip() {
  sed "$2" good.toml > bad.toml
  expect 1 "$1" "$gurney" run bad.toml -o bad.h5
  [ -e bad.h5 ] && complain "results of a job that was refused"
}
slip "bad.toml:2:1: item.equipment: missing; must name an item of the catalogue or its file" 's/^equipment/equpment/'
slip "bad.toml:3:1: item.equpment: unknown key; did you mean 'equipment'?" 's/^equipment/equpment/'
slip "unknown item of equipment; did you mean 'icu_ventilator'?" 's/icu_ventilator/ventilator/'
slip "unknown item of equipment; 'R100' is the name of another kind: caster" 's/icu_ventilator/R100/'
slip "bad.toml:5:8: excitation.file: unknown key; did you mean 'record.file'?" 's/excitation.record/excitation/'
slip "begins with [[name]]" '$a [[item]]\nequipment = "icu_bed"'
slip 'bad.toml:10:9: excitation.building.floor = "third": must be "roof" or a whole number in 0..4' \
  '$a [excitation.building]\nfile = "concrete_hospital"\nfloor = "third"'
slip "the motion of the floor has a peak of 400 g after scaling; at most 100 g are allowed" 's/^file.*/&\nscale = 1000/'

# One cause, one error: what depends on it is not complained of as well.
# only TEXT SED: the job with this change is refused with TEXT, and nothing else
only() {
  sed "$2" good.toml > bad.toml
  expect 1 "$1" "$gurney" check bad.toml
  [ "$(wc -l < stderr)" -eq 1 ] || complain "more than one line: $1"
}
study='$a [study]\ndraws = 2\n[study.intensity]\n'
only "bad.toml:13:16: study.intensity.levels[1] = nan: must be a finite number > 0" \
  "${study}measure = \"PGA\"\nunit = \"g\"\nlevels = [0.1, nan]"
only "study.intensity.measure: missing; needed for levels, unit" "${study}unit = \"g\"\nlevels = [0.1, 0.2]"
only "study.limit_state[0].demand = \"peak_tild\": must be a known name; did you mean 'peak_tilt'?" \
  '$a [study]\n[[study.limit_state]]\nname = "a"\ndemand = "peak_tild"\nabove = 2\nunit = "deg"'
only 'study.performance: "moved" comes twice' '$a [study]\nperformance = ["moved", "moved"]\n[[study.limit_state]]\nname = "moved"\nevent = "overturned"'
only "bad.toml:13:18: excitation.building.period_s[1] = 0: must be a finite number > 0" \
  '$a [excitation.building]\nkind = "shear"\nstoreys = 2\nfloor = 1\ndamping_ratio = 0.05\nperiod_s = [0.6, 0]\n[excitation.building.yield]\ndrift = 0.01'

# A record of one component.
expect 0 "one.csv" "$gurney" records make near_fault_pulse period_s=1 -o one.csv
sed 's/^file.*/file = "one.csv"/' good.toml > one.toml
expect 1 "has no y (h2), z (vertical) component; state with use = \"x\" that the others act" "$gurney" check one.toml
sed -i 's/^file.*/&\nuse = "y"/' one.toml
expect 1 "use: none of these components is in record 'one', which has x" "$gurney" check one.toml

# A warning stands before the results.
sed 's/^file.*/&\nscale = 30/' good.toml > strong.toml
expect 0 "warning: scaled by 30, more than 20" "$gurney" run strong.toml -o strong.h5
[ "$(grep -n "^warning: scaled by 30" stdout | cut -d: -f1)" -lt "$(grep -n "^demands" stdout | cut -d: -f1)" ] ||
  complain "the warning stands behind the results"

# Of many names only the nearest is printed.
cat > small.toml << TOML
schema = "gurney-job/1"
[item]
equipment = "icu_ventilator"
[excitation.record]
synthetic = { kind = "clough_penzien" }
[study]
synthetic_records = 1
[study.intensity]
measure = "PGV"
component = "geomean"
unit = "m/s"
levels = [0.1]
[settings]
duration_s = 1
TOML
expect 0 "results" "$gurney" run small.toml -o small.h5
expect 1 "must be a known name; did you mean 'peak_displacement'?" "$gurney" fragility small.h5 \
  --limit-state "peak displacement > 0.2 m"
grep -q "time_of_fall" stderr && complain "lists all names beside the nearest one"
expect 1 "no intensity measure 'PGV'; did you mean 'PGV geomean'?" "$gurney" fragility small.h5 --measure PGV

[ "$failures" -eq 0 ] && echo "every slip is named"
exit $((failures > 0))
