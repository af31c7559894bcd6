#!/usr/bin/env bash
# gurney verify from outside: names, draws, JSON, figures, exit codes.
# usage: verify.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"

expect 0 "1 cases with 9 checks: all passed" "$gurney" verify skid_to_roll/hoop
expect 0 "time at which it rolls" "$gurney" verify skid_to_roll/hoop
expect 0 "tolerance: one step to change, one to report it: 2 dt" "$gurney" verify skid_to_roll/hoop
expect 0 "12 cases" "$gurney" verify alignment -j 2
expect 0 "skid_to_roll/draw_8 " "$gurney" verify skid_to_roll --draw 7 --count 2
expect 2 "no case, family or group is named 'alignmnt'; did you mean 'alignment'?" "$gurney" verify alignmnt
expect 2 "gurney verify --list lists them" "$gurney" verify nosuchcase
[ "$(wc -c < stderr)" -lt 200 ] || complain "all names on one line"
expect 0 "skid_to_roll (" "$gurney" verify --list
expect 2 "--draw" "$gurney" verify --count 3
# pulling is a group of closed forms and a command.
expect 0 "checks: all passed" "$gurney" verify pulling
expect 2 "--count" "$gurney" verify --draw 1 --count 0

expect 0 '"passed": true' "$gurney" verify alignment/crosswise --json --figures figures
python3 - stdout << 'PYTHON' || complain "the JSON is not as it should be"
import json, sys
answer = json.load(open(sys.argv[1]))
(case,) = answer["cases"]
assert case["name"] == "alignment/crosswise" and case["group"] == "casters" and case["source"], case
assert case["parameters"]["heading"] == {"value": 90, "unit": "deg", "lowest": -179, "highest": 179}
for check in case["checks"]:
    assert abs(check["computed"] - check["reference"]) <= check["tolerance"] and check["passed"]
    assert abs(check["error"] - (check["computed"] - check["reference"])) < 1e-15
    assert check["derivation"]
PYTHON
grep -q "computed less reference" figures/alignment_crosswise.svg || complain "no figure"
expect 1 "exists already" "$gurney" verify alignment/crosswise --figures figures
expect 0 "all passed" "$gurney" verify alignment/crosswise --figures figures --overwrite

# The same numbers whatever the threads.
numbers() { grep -v '"seconds"' stdout; }
"$gurney" verify alignment --json -j 1 > stdout 2> stderr; numbers > one.json
"$gurney" verify alignment --json -j 3 > stdout 2> stderr; numbers > three.json
cmp one.json three.json || complain "the numbers depend on the threads"

[ "$failures" -eq 0 ] && echo "gurney verify did as it should"
exit $((failures > 0))
