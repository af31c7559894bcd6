#!/usr/bin/env bash
# The pages of a calibration and of a verification in a browser: no errors, tables that sort, failed
# cases first, numbers that are those of the JSON, hostile names as text.
# usage: report_json.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
. "$2/tests/system/cli/expect.sh"
. "$2/tests/system/browser/chromium.sh"

mkdir trials
cp "$2"/studies/calibration/example/{pull,locked,impact}_*.csv trials
sed -i "s|^# against = .*|# against = <img src=x onerror=console.error(1)>'\"|" trials/impact_*.csv
expect 0 "calibrated" "$gurney" calibrate trials -o calibrated
expect 0 "calibration.html" "$gurney" report calibrated/calibration.json -o calibration.html
"$gurney" verify skid_to_roll alignment --json > passed.json 2> stderr || complain "verify failed"
# A check far beyond its tolerance, one without a number, and a hostile name.
python3 - << 'PYTHON' || complain "the JSON is not as it should be"
import json
all = json.load(open("passed.json"))
all["passed"] = False
late, other = all["cases"][3], all["cases"][-1]
late["checks"][0].update(error=20 * late["checks"][0]["tolerance"], passed=False)
other["checks"][0].update(computed=None, error=None, passed=False)
late["passed"] = other["passed"] = False
other["title"] = "</script><img src=x onerror=console.error(1)>"
json.dump(all, open("failed.json", "w"))
PYTHON
expect 0 "passed.html" "$gurney" report passed.json -o passed.html
expect 0 "failed.html" "$gurney" report failed.json -o failed.html
for page in calibration passed failed; do
  dom $page.html > shown.html || complain "$page.html does not open"
  quiet $page.html
  grep -q '<img' shown.html && complain "a name became HTML in $page.html"
done

# ask PAGE SCRIPT EXPECTED: in a copy of the page
ask() {
  printf '%s\n' "$2" > script.js
  with_script "$1" script.js copy.html
  dom copy.html "${@:4}" | found > stdout
  quiet copy.html
  [ "$(cat stdout)" = "$3" ] || complain "expected $3 of $1: $2"
}

read -r -d '' shared << 'JS'
const table = (caption) => [...document.querySelectorAll("table")].find((each) => each.caption.textContent === caption);
const titles = (of) => [...of.tHead.rows[0].cells];
const column = (of, title) => titles(of).findIndex((th) => th.textContent === title);
const click = (of, title) => titles(of)[column(of, title)].querySelector("button").click();
const cells = (of, title) => [...of.tBodies[0].rows].map((row) => row.cells[column(of, title)]);
const numbers = (of, title) => cells(of, title).map((cell) => Number(cell.dataset.value));
const texts = (of, title) => cells(of, title).map((cell) => cell.textContent);
const rises = (of) => of.every((value, i) => i === 0 || of[i - 1] <= value);
JS

names=$(python3 -c '
import json
cases = json.load(open("failed.json"))["cases"]
print(json.dumps([each["name"] for each in sorted(cases, key=lambda each: each["passed"])], separators=(",", ":")))')
ask failed.html "$shared return texts(table('Cases of casters'), 'case');" "$names"
ask failed.html "$shared return texts(table('Cases of casters'), 'passed').slice(0, 3);" \
  '["no","no","yes"]'
ask failed.html "$shared return texts(table('Checks that failed'), 'error')[1];" '"–"'
ask failed.html "$shared const cases = table('Cases of casters'); click(cases, 'used (%)'); const
  used = numbers(cases, 'used (%)').filter((x) => !isNaN(x)); return [rises(used), used.at(-1)];" '[true,2000]'
# Every check has the numbers of the file.
errors=$(python3 -c '
import json
print(sum(check["error"] for case in json.load(open("passed.json"))["cases"] for check in case["checks"]))')
ask passed.html "$shared return numbers(table('Every check of every case'), 'error').reduce((a, b) => a + b) === $errors;" 'true'
ask passed.html "$shared return [document.querySelectorAll('.cautions').length, document.querySelectorAll('#tolerances-figure svg').length];" '[0,1]'

constant=$(python3 -c '
import json
print(json.load(open("calibrated/calibration.json"))["constants"][0]["value"])')
ask calibration.html "$shared return numbers(table('Constants'), 'value')[0] === $constant;" 'true'
ask calibration.html "const excluded = [...document.querySelectorAll('h3')].find((each) => each.textContent === 'Excluded').nextElementSibling;
  return [...excluded.children].map((each) => each.textContent.split(': ')[0]);" '["trials/pull_6.csv"]'
ask calibration.html "$shared const of = table('Values of the trials, and residuals'); click(of, 'residual (%)');
  return rises(numbers(of, 'residual (%)'));" 'true'
ask calibration.html "$shared const link = document.querySelector('#residuals-figure a.save');
  link.addEventListener('click', (event) => event.preventDefault()); link.click();
  return [link.href.startsWith('blob:'), link.download];" '[true,"residuals.svg"]'
for page in calibration failed; do
  ask $page.html 'return document.documentElement.scrollWidth <= innerWidth;' 'true' --window-size=500,900
done

exit $((failures > 0))
