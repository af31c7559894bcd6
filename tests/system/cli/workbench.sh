#!/usr/bin/env bash
# The engine as a WebAssembly module, in Node: shipped jobs have the demands of the program, errors of a job
# their line and column, and the engine answers after them. Skipped (77) without Node or the module.
# usage: workbench.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
source=$2
module=$source/build/workbench/gurney.wasm
command -v node > /dev/null || { echo "skipped: node is not installed"; exit 77; }
[ -e "$module" ] || { echo "skipped: ./dev workbench has not built $module"; exit 77; }
. "$source/tests/system/cli/expect.sh"

for job in icu_ventilator_shake trolley_meets_wall icu_bay; do
  "$gurney" run "$source/studies/jobs/$job.toml" -o "$job.h5" --no-figure --json > "$job.json" || exit 1
  expect 0 "the same" node "$source/tests/system/cli/workbench.js" "$source" "$module" \
    "$source/studies/jobs/$job.toml" "$job.json"
done
sed 's/brakes = false/brakes = maybe/' "$source/studies/jobs/icu_ventilator_shake.toml" > bad.toml
expect 1 "job.toml:7:10: not valid TOML" node "$source/tests/system/cli/workbench.js" "$source" "$module" bad.toml
sed 's/^covering.*/covering = "polyflor_mystik"\nslipe = 1/' "$source/studies/jobs/icu_ventilator_shake.toml" > bad.toml
expect 1 "job.toml:11:1: floor.slipe: unknown key" node "$source/tests/system/cli/workbench.js" "$source" \
  "$module" bad.toml
expect 1 "polyflor_mystique" node "$source/tests/system/cli/workbench.js" "$source" "$module" bad.toml

# The page is filled with a job of another folder, and has what that names: an item with a caster of its own
# beside it, a room, a record.
page=$source/build/workbench/workbench.html
mkdir -p mine/carts
cp "$source/studies/templates/item.toml" mine/carts/cart.toml
sed -i '0,/type = "R100"/s//type = "wheel.toml"/' mine/carts/cart.toml
cp "$source/equipment/casters/R100.toml" mine/carts/wheel.toml
cp "$source/equipment/rooms/icu_bay.toml" mine/ward.toml
cp "$source/groundmotions/records/synthetic_3c.csv" record.csv
cat > mine/job.toml << 'TOML'
schema = "gurney-job/1"
[[item]]
equipment = "carts/cart.toml"
position_m = [3, 0]
[[item]]
equipment = "infusion_pole"
position_m = [3, 1]
[room]
file = "ward.toml"
[excitation.record]
file = "../record.csv"
TOML
expect 0 "mine.html" "$gurney" workbench mine/job.toml -o mine.html
"$gurney" run mine/job.toml -o mine.h5 --no-figure --json > mine.json || complain "the job does not run"
expect 0 "the same" node "$source/tests/system/cli/workbench.js" "$source" "$module" mine.html mine.json
grep -q "$folder" mine.html && complain "the page names a folder of this machine"
expect 1 "mine.html: exists" "$gurney" workbench mine/job.toml -o mine.html
expect 0 "out/job_workbench.html" "$gurney" workbench mine/job.toml
expect 0 "mine.html" "$gurney" workbench -o mine.html --overwrite
cmp mine.html "$page" || complain "the page without a job is not that which was built"
for file in mine/ward.toml mine/carts/cart.toml icu_bed; do
  expect 0 "with.html" "$gurney" workbench "$file" -o with.html --overwrite
  expect 1 "ENOENT" node "$source/tests/system/cli/workbench.js" "$source" "$module" with.html none.json
done
sed 's/brakes/brake/; s/"carts/"cart/' mine/job.toml > mine/bad.toml
expect 1 "mine/bad.toml:3:13: item[0].equipment = \"cart/cart.toml\": no such file" "$gurney" workbench mine/bad.toml -o bad.html
expect 1 "many runs" "$gurney" workbench "$source/studies/jobs/icu_ventilator_fragility.toml" -o bad.html
expect 1 "unknown item of equipment" "$gurney" workbench icu_bet -o bad.html
expect 2 "must end in .html" "$gurney" workbench -o bad.htm
expect 1 "neither a job nor a room nor an item" "$gurney" workbench mine/carts/wheel.toml -o bad.html
GURNEY_DATA=$folder/mine expect 1 "./dev workbench" "$gurney" workbench -o bad.html
[ -e bad.html ] && complain "a page is written in spite of an error"

# Items and alternatives: the module says what the program says.
"$gurney" equipment show icu_ventilator > shown.txt
expect 0 "what the program says" node "$source/tests/system/cli/workbench_item.js" "$source" "$module" shown.txt
expect 0 "moved.toml: item 'ICU ventilator on cart' is valid" "$gurney" equipment check moved.toml
expect 0 "bare.toml: item 'ICU ventilator on cart' is valid" "$gurney" equipment check bare.toml
grep -q "# base" bare.toml || complain "comments of an edited item are lost"
exit $((failures > 0))
