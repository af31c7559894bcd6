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
exit $((failures > 0))
