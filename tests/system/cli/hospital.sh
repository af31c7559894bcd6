#!/usr/bin/env bash
# Loss of a study and answers for a hospital, from outside: numbers of both agree where they mean the
# same, do not depend on threads, an interruption or shards, and errors say where.
# usage: hospital.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

# number FILE PATH: a number of JSON, such as levels.0.loss
number() {
  python3 -c '
import json, sys
at = json.load(open(sys.argv[1]))
for key in sys.argv[2].split("."):
    at = at[int(key)] if key.isdigit() else at[key]
print(at)' "$1" "$2"
}
# near A B FACTOR: both differ by less than this part of B
near() { python3 -c 'import sys; a, b, f = map(float, sys.argv[1:]); sys.exit(abs(a - b) > f * abs(b))' "$@"; }

cat > consequences.toml << TOML
schema = "gurney-consequences/1"
currency = "EUR"
year = 2025
[[price]]
item = "infusion_pole"
price = 1000
[[limit_state]]
name = "moved"
demand = "peak_displacement"
above = 5
unit = "cm"
[[limit_state]]
name = "overturned"
event = "overturned"
[[consequence]]
limit_state = "moved"
cost_ratio = 0.1
days = 1
injury = "none"
service = "lost"
[[consequence]]
limit_state = "overturned"
cost_ratio = 0.5
days = 5
injury = "serious"
service = "lost"
TOML
cat > ward.toml << TOML
schema = "gurney-hospital/1"
title = "Poles"
consequences = "consequences.toml"
[motion]
pgv_m_per_s = [0.25, 0.35]
[[storey]]
name = "ground"
[[room]]
name = "bay"
storey = "ground"
count = 4
beds = 1
[[room.item]]
name = "pole"
equipment = "infusion_pole"
[[service]]
name = "all"
works = "bay"
[[action]]
name = "brakes on"
items = ["bay/pole"]
brakes = "on"
cost = 5
[simulation]
covering = "polyflor_mystique"
synthetic_records = 8
draws = 2
[simulation.record]
synthetic = { kind = "white_noise", duration_s = 4, taper_s = 1, highest_frequency_hz = 10, pga_h2_g = 0.2 }
TOML

# An inventory with an error is the only error, with its place.
sed 's/^\[\[room.item\]\]/items = "bay.csv"/; /^name = "pole"/d; /^equipment = "infusion_pole"/d' ward.toml > listed.toml
printf 'name,equipment,count\npole,infusion_pole,-3\n' > bay.csv
expect 1 "bay.csv:2:1: count = -3: must be a whole number in 1..100000" "$gurney" hospital listed.toml
[ "$(wc -l < stderr)" -eq 1 ] || complain "follow-up errors of an inventory"
printf 'name,equipment\np\xf6le,infusion_pole\n' > bay.csv
expect 1 "bay.csv:2:1: not valid TOML" "$gurney" hospital listed.toml
sed 's/^pgv_m_per_s.*/pgv_m_per_s = []/' ward.toml > empty.toml
expect 1 "empty.toml:5:15: motion.pgv_m_per_s = []: must have 1 or more values" "$gurney" hospital empty.toml

# A job that could not be run is not written.
sed 's/white_noise/white_nois/' ward.toml > typo.toml
expect 1 "did you mean 'white_noise'?" "$gurney" hospital typo.toml --job typo_job.toml
[ -e typo_job.toml ] && complain "a job that is wrong was written"

# The study that the hospital becomes, run at once, in shards, and continued.
expect 0 "beds out" "$gurney" hospital ward.toml --run whole.h5 -j 2
cp stdout whole
[ -e whole.toml ] || complain "no job beside the results"
expect 0 "beds out" "$gurney" hospital ward.toml --run whole.h5
cmp stdout whole || complain "the second call answers otherwise"
expect 0 "" "$gurney" hospital ward.toml --job job.toml
cmp job.toml whole.toml || complain "--job writes another job than --run"
expect 0 "" "$gurney" check job.toml
for shard in 1/2 2/2; do expect 0 "shard" "$gurney" run job.toml -o shards.h5 --shard "$shard"; done
expect 0 "" "$gurney" merge shards.h5.shards
expect 0 "beds out" "$gurney" hospital ward.toml --results shards.h5 -j 1
cmp stdout whole || complain "the answers from shards differ"
expect 0 "" "$gurney" hospital ward.toml --results whole.h5 --json -j 3
cp stdout runs.json
expect 0 "" "$gurney" loss whole.h5 --consequences consequences.toml --json
cp stdout loss.json

# A piece of the hospital has the expected loss of its configuration, which loss has from the runs: four
# pieces, and samples with a standard error of at most 4 x 500 / sqrt(10000) = 20.
for level in 0 1; do
  pieces=$(number runs.json levels.$level.loss)
  each=$(number loss.json losses.0.levels.$level.mean_cost)
  python3 -c 'import sys; a, b = map(float, sys.argv[1:]); sys.exit(abs(a - 4 * b) > 5 * 20)' "$pieces" "$each" ||
    complain "loss $pieces of 4 pieces that lose $each each"
done
grep -q '"interval"' runs.json || complain "no interval"

# A storey of its own building has other floor motions of the same records.
{ sed '/^\[\[service/,$d; s/^pgv_m_per_s.*/pgv_m_per_s = [0.3]/; s/^count = 4/count = 1/' ward.toml
  printf '[[storey]]\nname = "upper"\nbuilding = { file = "concrete_hospital", floor = 3 }\n'
  sed -n '/^\[\[room\]\]/,/^\[\[service/p' ward.toml | sed '$d; s/"bay"/"upper bay"/; s/"ground"/"upper"/; s/^count = 4/count = 1/'
  sed -n '/^\[\[service/,$p' ward.toml | sed "s/^works = .*/works = 'all(bay, \"upper bay\")'/; s/^draws = 2/draws = 1/"
} > two_storeys.toml
expect 0 "records  8" "$gurney" hospital two_storeys.toml --run storeys.h5
grep -q "^upper bay" stdout || complain "no room of the upper storey"

# How likely the loss is above a value, as text, in JSON and drawn, which replaces no file.
expect 0 "loss above" "$gurney" loss whole.h5 --consequences consequences.toml --at 0.4 --figure loss.svg
grep -q "Loss above" loss.svg || complain "no exceedance curve in the figure"
expect 1 "loss.svg" "$gurney" loss whole.h5 --consequences consequences.toml --figure loss.svg
expect 0 "" "$gurney" loss whole.h5 --consequences consequences.toml --at 0.4 --json
cp stdout above.json
above=$(number above.json losses.0.at.0.exceedance.0.probability)
cost=$(number above.json losses.0.steps.0.cost)  # the only one that the study has
near "$(number above.json losses.0.at.0.cost)" "$(python3 -c "print($cost * $above)")" 1e-9 ||
  complain "the loss of $cost is not as likely as any"

# --at is in the unit of the levels whatever is printed; items and prices are in JSON, too.
expect 0 "" "$gurney" loss whole.h5 --consequences consequences.toml --at 0.4 --units cm --json
near "$(number stdout losses.0.at.0.im)" 40 1e-9 || complain "--at is not 40 cm/s"
near "$(number stdout losses.0.at.0.cost)" "$(number above.json losses.0.at.0.cost)" 1e-12 ||
  complain "--units changes what --at means"
near "$(number stdout losses.0.steps.0.theta)" "$(python3 -c "print(100 * $(number above.json losses.0.steps.0.theta))")" \
  1e-12 || complain "the medians are not in the units"
python3 -c '
import json
of = json.load(open("above.json"))["losses"][0]
assert of["units"] == "m/s" and len(of["items"]) >= 1 and all(each["price"] > 0 for each in of["items"]), of' ||
  complain "no prices in JSON"

# From curves; figures.
expect 0 "if independent" "$gurney" hospital "$2/studies/hospitals/ward.toml" --samples 500 --figure ward.svg
grep -q "<svg" ward.svg || complain "no figure"
expect 1 "ward.svg" "$gurney" hospital "$2/studies/hospitals/ward.toml" --samples 500 --figure ward.svg
expect 0 "by chance that wards is lost" "$gurney" hospital "$2/studies/hospitals/ward.toml" --samples 500 --by wards --at 0.8

# Errors.
expect 1 "--by 'bets': must be beds, loss or a service; did you mean 'beds'?" "$gurney" hospital ward.toml --results whole.h5 --by bets
expect 1 "--at 0.3: ward.toml has the levels 0.25, 0.35 m/s" "$gurney" hospital ward.toml --results whole.h5 --at 0.3
expect 2 "--run" "$gurney" hospital ward.toml --results whole.h5 --run other.h5
sed '/^\[simulation\]/,$d' ward.toml > no_study.toml
expect 1 "no_study.toml: simulation: must be given" "$gurney" hospital no_study.toml --run none.h5
[ ! -e none.toml ] || complain "half written"
sed 's/name = "ground"/name = "first"/; s/storey = "ground"/storey = "first"/' ward.toml > other.toml
expect 1 "has no configuration 'infusion_pole open, first, off'; did you mean 'infusion_pole open, ground, off'?" \
  "$gurney" hospital other.toml --results whole.h5
sed 's/^draws = 2/draws = 3/' ward.toml > drawn.toml
expect 1 "whole.h5: is not of the study that drawn.toml becomes: study.draws: there '2', here '3'" \
  "$gurney" hospital drawn.toml --results whole.h5
expect 2 "requires --figure" "$gurney" hospital ward.toml --results whole.h5 --width 5cm
expect 2 "requires --figure" "$gurney" loss whole.h5 --consequences consequences.toml --overwrite
expect 2 "nan: must be a finite number" "$gurney" loss whole.h5 --consequences consequences.toml --at nan
expect 2 "0: must be a number > 0" "$gurney" loss whole.h5 --consequences consequences.toml --at 0
expect 0 "9 m/s lies beyond the runs" "$gurney" loss whole.h5 --consequences consequences.toml --at 9
expect 1 "the file is a hospital, not a job" "$gurney" run ward.toml
expect 1 "the file is a list of consequences, not a hospital" "$gurney" hospital consequences.toml
sed 's/infusion_pole/infusion_pol/' consequences.toml > unpriced.toml
expect 1 "none of its items has a price in unpriced.toml" "$gurney" loss whole.h5 --consequences unpriced.toml
expect 1 "ward.toml" "$gurney" loss ward.toml

# For pelicun: costs of the ordered damage states of one component.
expect 0 "consequence_repair.csv" "$gurney" export whole.h5 --to pelicun --consequences consequences.toml \
  --limit-state "moved = peak_displacement > 5 cm" --configuration "infusion_pole open, ground, off" -o pelicun
grep -q '^ID,Incomplete,Quantity-Unit,DV-Unit,DS1-Family,DS1-Theta_0' pelicun/consequence_repair.csv ||
  complain "no header of DLML"
grep -q -- '-Cost,0,1 EA,EUR,,100,,0,' pelicun/consequence_repair.csv || complain "no cost"
grep -q -- '-Time,0,1 EA,day,,1,,0,' pelicun/consequence_repair.csv || complain "no time"
expect 1 "no consequence of 'far'" "$gurney" export whole.h5 --to pelicun --consequences consequences.toml \
  --limit-state "far = peak_displacement > 6 cm" -o far
[ ! -e far ] || complain "half written"
# A name that stands for another condition there has no consequence; a stricter state costs no less.
expect 1 "'moved' is peak_displacement > 5 cm there, but peak_displacement > 0.06 m in" "$gurney" export whole.h5 \
  --to pelicun --consequences consequences.toml --limit-state "moved = peak_displacement > 0.06 m" -o far
[ ! -e far ] || complain "half written"
cp consequences.toml further.toml
cat >> further.toml << TOML
[[limit_state]]
name = "further"
demand = "peak_displacement"
above = 6
unit = "cm"
[[consequence]]
limit_state = "further"
cost_ratio = 0.05
days = 0.5
injury = "none"
service = "lost"
TOML
expect 0 "consequence_repair.csv" "$gurney" export whole.h5 --to pelicun --consequences further.toml \
  --limit-state "moved = peak_displacement > 5 cm" --limit-state "further = peak_displacement > 6 cm" \
  --configuration "infusion_pole open, ground, off" -o further
grep -q -- '-Cost,0,1 EA,EUR,,100,,0,,100,,0,' further/consequence_repair.csv || complain "a stricter state costs less"
grep -q -- '-Time,0,1 EA,day,,1,,0,,1,,0,' further/consequence_repair.csv || complain "a stricter state takes less time"
grep -q 'further: its cost is that of a milder state, 100, which is more than its own, 50' \
  further/fragility_cautions.csv || complain "no note of the milder state"

exit $((failures > 0))
