#!/usr/bin/env bash
# Floor motions from another program: tables that our own model writes in place of OpenSees, in
# `gurney records floor`, single runs and a study over floors and records.
# usage: tables.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

mkdir records results
for seed in 1 2; do
  expect 0 "" "$gurney" records make stochastic seed="$seed" -o "records/quake$seed.csv"
  for floor in 1 3 4; do
    expect 0 "PFA" "$gurney" records floor "records/quake$seed.csv" --building concrete_hospital --floor "$floor" \
      -o "floor_${seed}_$floor.csv"
    grep -v '^#\|time' "floor_${seed}_$floor.csv" > "rows_$floor"
  done
  # One row for each sample: time, h1 and h2 of the first floor, then of the others.
  paste -d, rows_1 rows_3 rows_4 | awk -F, 'NF == 9 || NF == 12' > all
  awk -F, -v OFS=' ' '{n = NF / 3; $1 = $1; print $1, $2, $3, $(n + 2), $(n + 3), $(2 * n + 2), $(2 * n + 3)}' all \
    > "results/quake$seed.out"
done
cat > clinic.toml << 'END'
schema = "gurney-building/1"
name = "Clinic"
kind = "tables"
floors = ["1", "3", "roof"]
file = "results/{record}.out"
columns = "time, 1 h1, 1 h2, 3 h1, 3 h2, roof h1, roof h2"
unit = "m/s2"
acceleration = "absolute"
END

floor() { expect "$1" "$2" "$gurney" records floor records/quake1.csv --building ./clinic.toml "${@:3}"; }
floor 0 "Clinic, floor 3 of roof" --floor 3 -o three.csv
grep -v '^#\|time' three.csv | awk -F, 'NR > 1' > found
grep -v '^#\|time' floor_1_3.csv | awk -F, 'NR > 1' > model
paste -d, found model | awk -F, -v n="$(head -1 found | awk -F, '{print NF}')" '
  NF == 2 * n {d = $2 - $(n + 2); e = $3 - $(n + 3); if (d < 0) d = -d; if (e < 0) e = -e
    if (d > 1e-5 || e > 1e-5) {bad++}; rows++}
  END {exit !(rows > 1000 && bad == 0)}' || complain "the floor is not that of the table"
floor 0 '"floor_name": "roof"' --floor roof -o roof.csv --json
floor 1 "--floor (--storey) 2: must be 1, 3 or roof" --floor 2 -o x.csv
expect 1 "no such file" "$gurney" records floor "$2/groundmotions/records/synthetic_3c.csv" --building ./clinic.toml -o x.csv
[ ! -e x.csv ] || complain "x.csv was left"

cat > job.toml << 'END'
schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[excitation.record]
suite = "records"
use = "xy"
[excitation.building]
file = "clinic.toml"
floor = 3
[study]
[[study.factor]]
name = "floor"
[study.factor.level.first]
excitation.building.floor = 1
[study.factor.level.third]
excitation.building.floor = 3
[study.factor.level.roof]
excitation.building.floor = "roof"
END
sed 's/file = "clinic.toml"/file = "concrete_hospital"/; s/"roof"/4/' job.toml > model.toml
expect 0 "6" "$gurney" check job.toml
expect 0 "" "$gurney" run job.toml -o tables.h5 -j 2
expect 0 "" "$gurney" run model.toml -o model.h5 -j 2
for file in tables model; do
  expect 0 "items.csv" "$gurney" export "$file.h5" --to csv -o "csv_$file"
done
# Tables have nine digits behind the point, 5e-10 of an acceleration of 1 m/s2: peaks may differ by 200 times that.
python3 - << 'PY' > stdout 2> stderr || complain "runs under tables are not those under the model's floors"
import csv
a, b = (list(csv.reader(open(f"csv_{name}/items.csv"))) for name in ("tables", "model"))
column = a[0].index("peak_displacement")
pairs = [(float(x[column]), float(y[column])) for x, y in zip(a[2:], b[2:], strict=True)]
assert len(pairs) == 6 and all(abs(x - y) <= 1e-7 * y for x, y in pairs), pairs
PY
refused() {  # TEXT SED...: the job with that change
  sed "${@:2}" job.toml > bad.toml
  expect 1 "$1" "$gurney" check bad.toml
}
refused "only floors that move in proportion" 's/^\[study\]/[study]\nintensity = { scales = [1, 2] }/'
refused "did you mean 'roof'?" 's/"roof"/"rof"/'
refused "must not go with floor motions of another program" \
  's/^use = "xy"/use = "xy"\nprocessing = [{ step = "baseline", kind = "mean" }]/'

exit $((failures > 0))
