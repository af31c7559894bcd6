#!/usr/bin/env bash
# Limit states, performance levels and hazards given after the runs, from outside: the same curves,
# to the digit, as those of a study that was run with them in its job.
# usage: assessment.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

cat > states.toml << 'TOML'
[[limit_state]]
name = "rolled"
demand = "peak_displacement"
above = 4
unit = "cm"
[[limit_state]]
name = "screen"
item = "icu_ventilator"
point = "ventilator"
demand = "peak_absolute_acceleration"
above = 0.25
unit = "g"
[[limit_state]]
name = "either"
any_of = ["rolled", "screen"]
TOML
cat > hazard_values.toml << 'TOML'
im = [0.1, 0.4, 2]
rate_per_year = [1e-2, 2e-3, 1e-4]
TOML

# study FILE INTENSITY: with what follows in the job
study() {
  cat > job.toml << TOML
schema = "gurney-job/1"
[item]
equipment = "icu_ventilator"
[excitation.record]
synthetic = { kind = "ac156" }
[settings]
duration_s = 6
[study]
synthetic_records = ${records:-6}
draws = 2
$(cat performance.toml)
[study.intensity]
measure = "PGA"
unit = "g"
$2
[[study.factor]]
name = "brakes"
key = "item.brakes"
values = [false, true]
$(cat more.toml)
TOML
  "$gurney" run job.toml -o "$1" > stdout 2> stderr || complain "no study $1"
}
# same A B: what two commands print
same() { cmp "$1" "$2" > stdout 2> stderr || complain "$1 and $2 differ"; }

: > performance.toml
: > more.toml
study plain.h5 "levels = [0.1, 0.25, 0.5]"
echo 'performance = ["rolled", "either"]' > performance.toml
{ sed 's/^\[\[limit_state/[[study.limit_state/' states.toml
  echo '[study.hazard]'
  cat hazard_values.toml; } > more.toml
study stated.h5 "levels = [0.1, 0.25, 0.5]"

{ echo 'schema = "gurney-limit-states/1"'
  cat performance.toml states.toml; } > limits.toml
{ printf 'schema = "gurney-hazard/1"\nmeasure = "PGA"\nunit = "g"\n'
  cat hazard_values.toml; } > hazard.toml

"$gurney" fragility stated.h5 > stated.txt || complain "no curves of stated.h5"
"$gurney" fragility stated.h5 --json > stated.json || complain "no JSON of stated.h5"
"$gurney" fragility plain.h5 --limit-states limits.toml --hazard hazard.toml > given.txt
"$gurney" fragility plain.h5 --limit-states limits.toml --hazard hazard.toml --json > given.json
same stated.txt given.txt
same stated.json given.json
grep -q "times a year" given.txt || complain "no rate"
grep -q "P(worst level reached)" given.txt || complain "no performance levels"
grep -q '"theta"' given.json || complain "no curve to compare"

# Of named records: as a study without the others.
records=3 study few.h5 "levels = [0.1, 0.25, 0.5]"
mapfile -t names < <("$gurney" show few.h5 --json |
  python3 -c 'import json, sys; [print(r["name"]) for r in json.load(sys.stdin)["records"]]')
[ "${#names[@]}" -eq 3 ] || complain "few.h5 does not have three records"
"$gurney" fragility plain.h5 --limit-states limits.toml --record "${names[@]}" > given.txt
"$gurney" fragility few.h5 --limit-states limits.toml > stated.txt
same stated.txt given.txt
expect 1 "no record 'nowhere'" "$gurney" fragility plain.h5 --record nowhere

# One line instead of a file, and the other commands.
"$gurney" fragility stated.h5 --limit rolled --json | grep -v '"per_year\|"in_50_years' > stated.json
"$gurney" fragility plain.h5 --hazard hazard.toml --json \
  --limit-state 'rolled = peak_displacement > 4 cm' | grep -v '"per_year\|"in_50_years' > given.json
same stated.json given.json
for command in measures "sensitivity --limit rolled" "compare --json" "compare" \
    "fragility --and pfa --measure pfv"; do
  # shellcheck disable=SC2086
  "$gurney" ${command%% *} stated.h5 $(printf '%s' "$command" | cut -s -d' ' -f2-) > stated.txt 2>&1
  # shellcheck disable=SC2086
  "$gurney" ${command%% *} plain.h5 $(printf '%s' "$command" | cut -s -d' ' -f2-) \
    --limit-states limits.toml > given.txt 2>&1
  sed -i 's/stated.h5/plain.h5/' stated.txt
  same stated.txt given.txt
done
"$gurney" show stated.h5 --json > stated.json
"$gurney" show plain.h5 --json --limit-states limits.toml > given.json
python3 - stated.json given.json << 'PYTHON' || complain "show counts other exceedances"
import json, sys
stated, given = (json.load(open(name)) for name in sys.argv[1:])
for key in ("limit_states", "counts"):
    assert stated[key] == given[key], key
PYTHON
for format in pelicun nrml; do
  expect 0 "wrote" "$gurney" export stated.h5 --to $format -o stated_$format
  expect 0 "wrote" "$gurney" export plain.h5 --to $format -o given_$format --limit-states limits.toml
done
cut -d, -f1 --complement stated_pelicun/fragility.csv > stated.csv
cut -d, -f1 --complement given_pelicun/fragility.csv > given.csv
same stated.csv given.csv

# Cautions go with the curves, whoever prints them.
expect 0 "true, moved: caution: fewer than 8 effective records" "$gurney" compare plain.h5
expect 0 '"fewer than 8 effective records' "$gurney" compare plain.h5 --json
expect 0 "false, rolled: caution: fewer than 8 effective records (6 of 6)" \
  "$gurney" fragility plain.h5 --and pfa --measure "PGA geomean" --limit-states limits.toml
expect 0 '"fewer than 8 effective records (6 of 6)' "$gurney" fragility plain.h5 --limit-states limits.toml \
  --and pfa --measure "PGA geomean" --json
expect 0 '"cautions": [' "$gurney" fragility plain.h5 --and pfa --measure pfv --json

# After an IDA the state that ended it has capacities, under whatever name.
: > performance.toml
ida='ida = { first = 0.1, increment = 0.1, until = "rolled" }'
printf '[[study.limit_state]]\nname = "rolled"\ndemand = "peak_displacement"\nabove = 4\nunit = "cm"\n' \
  > more.toml
study ida.h5 "$ida"
"$gurney" fragility ida.h5 --json > stated.json
grep -q '"method": "capacities"' stated.json || complain "no capacities"
"$gurney" fragility ida.h5 --json --limit-state overturned \
  --limit-state 'rolled = peak_displacement > 0.04 m' --limit rolled | sed 's/0.04 m/4 cm/' > given.json
same stated.json given.json
# With a second measure they are capacities as well, not outcomes of runs that the response chose.
"$gurney" fragility ida.h5 --limit rolled --and pfv --json > both.json
grep -q '"of_capacities": true' both.json || complain "no capacities of two measures"
grep -q 'chosen by their response' both.json && complain "outcomes of an IDA"

# What cannot be answered.
expect 1 "did you mean 'peak_displacement'?" "$gurney" fragility plain.h5 --limit-state 'peak_dsplacement > 1 m'
expect 1 "known: icu_ventilator" "$gurney" show plain.h5 --limit-state 'door: entered'
expect 1 "missing.toml" "$gurney" compare plain.h5 --limit-states missing.toml
expect 1 "the hazard is over PGA geomean, the curves are over pfa" \
  "$gurney" fragility plain.h5 --hazard hazard.toml --measure pfa

# The points of hazard.toml as an answer of the USGS (synthetic): levels in g, rates as they are.
cat > usgs.json << 'JSON'
{"response": {"hazardCurves": [{"imt": {"value": "PGA"}, "data": [{"component": "Total",
  "values": {"xs": [0.1, 0.4, 2], "ys": [1e-2, 2e-3, 1e-4]}}]}]}}
JSON
printf 'schema = "gurney-hazard/1"\nusgs = "usgs.json"\ncomponent = "geomean"\n' > usgs.toml
"$gurney" fragility plain.h5 --limit-states limits.toml --hazard usgs.toml --json > usgs.txt
"$gurney" fragility plain.h5 --limit-states limits.toml --hazard hazard.toml --json > points.txt
same usgs.txt points.txt
[ -s usgs.txt ] || complain "no curves under a hazard of the USGS"
expect 1 "the file is a hazard curve, not a list of limit states" \
  "$gurney" measures plain.h5 --limit-states hazard.toml
expect 1 "several limit states are given" "$gurney" sensitivity plain.h5 --limit-states limits.toml
expect 2 "cannot be combined with --to csv" "$gurney" export plain.h5 --to csv --limit-state overturned
expect 2 "--and excludes --hazard" "$gurney" fragility plain.h5 --and pfa --hazard hazard.toml

[ "$failures" -eq 0 ] && echo "given afterwards is as stated before"
exit $((failures > 0))
