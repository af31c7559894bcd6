#!/usr/bin/env bash
# The pages of gurney report in a browser: no errors, tables that sort and turn their pages, numbers
# that are those of the file, hostile names as text.
# usage: report.sh GURNEY SOURCE_FOLDER WRITE_LARGE_STUDY
set -uo pipefail
gurney=$1
write_large_study=$3
. "$2/tests/system/cli/expect.sh"
. "$2/tests/system/browser/chromium.sh"

cat > study.toml << 'TOML'
schema = "gurney-job/1"
title = "</script><img src=x onerror=console.error(1)>"
[item]
equipment = "icu_ventilator"
[excitation.record]
synthetic = { kind = "clough_penzien" }
[study]
synthetic_records = 10
measures = "PGA h1"
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.2, 0.4]
TOML
expect 0 "study.h5" "$gurney" run study.toml -o study.h5
expect 0 "study.html" "$gurney" report study.h5 -o study.html
expect 0 "csv" "$gurney" export study.h5 --to csv -o csv

dom study.html > shown.html || complain "the page does not open"
quiet study.html
grep -q '<img' shown.html && complain "a title became HTML"
grep -q 'runs 1 to 25 of 30' shown.html || complain "the table of runs is not there"

# ask SCRIPT EXPECTED: in a copy of the page
ask() {
  printf '%s\n' "$1" > script.js
  with_script study.html script.js copy.html
  dom copy.html | found > stdout
  quiet copy.html
  [ "$(cat stdout)" = "$2" ] || complain "expected $2 of: $1"
}

read -r -d '' shared << 'JS'
const titles = (table) => [...table.tHead.rows[0].cells];
const column = (table, title) => titles(table).findIndex((th) => th.textContent === title);
const click = (table, title) => titles(table)[column(table, title)].querySelector("button").click();
const numbers = (table, title) =>
  [...table.tBodies[0].rows].map((row) => Number(row.cells[column(table, title)].dataset.value));
const all = document.getElementById("cases-all");
const rises = (of) => of.every((value, i) => i === 0 || of[i - 1] <= value);
const falls = (of) => rises([...of].reverse());
const peak = "Peak displacement (m)";
JS

ask "$shared click(all, peak); const up = numbers(all, peak); click(all, peak);
  const down = numbers(all, peak); return [rises(up), falls(down), up.length, down[0] > up[24]];" \
  '[true,true,25,true]'
ask "$shared click(all, peak); const th = titles(all)[column(all, peak)];
  return [th.getAttribute('aria-sort'), th.querySelector('button').tabIndex];" '["ascending",0]'
ask "$shared document.getElementById('cases-on').click();
  return [all.tBodies[0].rows.length, document.getElementById('cases-page').textContent];" \
  '[5,"runs 26 to 30 of 30"]'
ask "$shared const field = document.getElementById('cases-filter'); field.value = '7';
  field.dispatchEvent(new Event('input')); all.tBodies[0].querySelector('button').click();
  return document.getElementById('cases-command').textContent;" '"gurney replay study.h5 7"'
ask "$shared const table = document.querySelector('#outcomes table'); click(table, 'moved (%)');
  return rises(numbers(table, 'moved (%)'));" 'true'
# The file's largest peak displacement, by way of another program's format.
largest=$(awk -F, 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == "peak_displacement") c = i; next}
  $c + 0 > most {most = $c + 0; text = $c} END {print text}' csv/items.csv)
ask "$shared click(all, peak); click(all, peak); return numbers(all, peak)[0] === $largest;" 'true'
ask "$shared const link = document.querySelector('a.save'); link.href = '#';
  link.addEventListener('click', (event) => event.preventDefault()); link.click();
  return [link.href.startsWith('blob:'), link.download.endsWith('.svg')];" '[true,true]'
# Figures: values where one points, the command of the run behind a mark, parts enlarged, and all by keys.
read -r -d '' pointing << 'JS'
const paper = document.querySelector("#stripes-peak-displacement-figure .paper"), svg = paper.querySelector("svg");
const tip = document.getElementById("value");
const key = (name) => paper.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));
const point = (type, x, y) => svg.dispatchEvent(new PointerEvent(type, { clientX: x, clientY: y, bubbles: true, button: 0 }));
const middle = (mark) => { const box = mark.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; };
const marks = svg.querySelector("g.marks"), runs = marks.dataset.runs.split(" ");
const labels = () => [...svg.querySelectorAll("g.ticks-x text")].map((each) => each.textContent);
JS
# The last run has the largest intensity: its demand in the table is that at its mark.
ask "$shared $pointing const mark = marks.children[runs.indexOf('29')]; point('pointermove', ...middle(mark));
  const said = Number(/Peak displacement \\(m\\): ([0-9.e-]+)/.exec(tip.innerText)[1]);
  const row = [...document.querySelectorAll('#cases table:not(#cases-all) tbody tr')].find((each) => each.cells[0].textContent === '29');
  const known = row ? Number(row.cells[column(row.closest('table'), peak)].dataset.value) : said;
  return [runs.length, tip.hidden, tip.innerText.includes('run 29'), Math.abs(said - known) <= 2e-3 * known];" '[30,false,true,true]'
ask "$shared $pointing const [x, y] = middle(marks.children[runs.indexOf('12')]);
  point('pointerdown', x, y); point('pointerup', x, y);
  return [tip.querySelector('code').textContent, tip.querySelector('button').textContent];" '["gurney replay study.h5 12","Copy"]'
ask "$shared $pointing const frame = svg.querySelector('g.axes > rect').getBoundingClientRect(), before = labels();
  const at = (part) => [frame.x + part * frame.width, frame.y + part * frame.height];
  point('pointerdown', ...at(0.5)); point('pointermove', ...at(0.6)); point('pointerup', ...at(0.75));
  const button = svg.closest('figure').querySelector('button.whole'), zoomed = labels(), shown = !button.hidden;
  button.click();
  return [Number(zoomed[0]) > Number(before[0]), Number(zoomed.at(-1)) < Number(before.at(-1)), zoomed.length > 2, shown,
    button.hidden, String(labels()) === String(before)];" '[true,true,true,true,true,true]'
ask "$shared $pointing key('ArrowRight'); const first = tip.innerText; key('ArrowRight'); const second = tip.innerText;
  key('Enter'); const command = tip.querySelector('code').textContent; key('+'); const zoomed = labels().length;
  const away = svg.querySelector('g.zoomed') !== null; key('0');
  return [paper.tabIndex, first !== second, /^gurney replay study.h5 [0-9]+\$/.test(command), away, svg.querySelector('g.zoomed') === null];" '[0,true,true,true,true]'
# Nothing is wider than a telephone but what scrolls by itself.
printf 'return document.documentElement.scrollWidth <= innerWidth;\n' > script.js
with_script study.html script.js copy.html
[ "$(dom copy.html --window-size=500,900 | found)" = true ] ||
  complain "the page is wider than its window"
# Panels stand beside each other where there is room, else below.
printf 'return new Set([...document.querySelectorAll("#demands .figures figure")].map((each) => each.offsetTop)).size;\n' > script.js
with_script study.html script.js copy.html
[ "$(dom copy.html --window-size=1400,900 | found)" = 1 ] || complain "panels are not side by side"
[ "$(dom copy.html --window-size=500,900 | found)" = 2 ] || complain "panels are not stacked"

# 100,000 runs open in less than 3 s, measured by the browser; a busy machine has three tries.
"$write_large_study" large.h5
expect 0 "large.html" "$gurney" report large.h5 -o large.html
printf 'return Math.round(performance.now());\n' > script.js
with_script large.html script.js copy.html
for _ in 1 2 3; do
  milliseconds=$(dom copy.html | found)
  [ "${milliseconds:-9999}" -lt 3000 ] && break
done
[ "${milliseconds:-9999}" -lt 3000 ] || complain "100,000 runs open in $milliseconds ms"
quiet large.html
[ "$(stat -c %s large.html)" -lt 20000000 ] || complain "100,000 runs take more than 20 MB"

exit $((failures > 0))
