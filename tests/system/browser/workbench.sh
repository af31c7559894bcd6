#!/usr/bin/env bash
# The workbench in a real browser, with a person's hands: an item is dragged, moved and turned with keys; an
# error of the job is shown at its line and goes; damaged records are refused, a good one is run; a run is kept
# beside the next; a hundred runs give curves; demands are those of the program; an item is edited with pointer,
# keys and as text, and stands in the room then; what would have prevented it is run, and taken over; the
# overview of the catalogue opens and closes.
# Skipped (77) without Chromium or the page.
# usage: workbench.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
source=$2
page=$source/build/workbench/workbench.html
[ -e "$page" ] || { echo "skipped: ./dev workbench has not built $page"; exit 77; }
. "$source/tests/system/cli/expect.sh"
. "$source/tests/system/browser/chromium.sh"

# found_by PAGE.html: what its script logs behind "found"; time passes as it does for people, since workers do
# not hear of virtual time.
found_by() {
  "$browser" --headless --no-sandbox --no-first-run --disable-gpu --enable-unsafe-swiftshader --disable-dev-shm-usage \
    --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir="$profile" --window-size=1400,900 \
    --enable-logging=stderr "file://$PWD/$1" 2> log &
  local process=$!
  for _ in $(seq 1800); do
    grep -aq 'CONSOLE.*"found' log && break
    kill -0 "$process" 2> /dev/null || break
    sleep 0.5
  done
  kill "$process" 2> /dev/null
  wait "$process" 2> /dev/null
  grep -a ':CONSOLE' log | grep -v '"found\|GL Driver Message' > console
  grep -a 'CONSOLE.*"found' log | head -1 | sed 's/.*"found//; s/@end".*//'
}

# with PAGE.html SCRIPT.js: the page with a script at its end
with() { awk -v script="$2" '/<\/body>/ {print "<script>"; while ((getline line < script) > 0) print line; print "</script>"} {print}' "$1"; }

cat > try.js << 'JS'
(async () => {
  const found = {};
  const until = async (what) => {
    for (const start = performance.now(); !what(); await new Promise((next) => setTimeout(next, 20)))
      if (performance.now() - start > 200e3) throw new Error(`waits in vain for ${what}`);
  };
  const errors = () => element('errors').textContent;
  const item = (i) => document.querySelector(`[data-item="${i}"]`);
  try {
    await until(() => window.lastRun);
    const bench = window.workbench;
    found.job = bench.text;
    found.demands = window.lastRun.findings.items.map((each) => each.demands.peak_displacement);
    found.headline = element('headline').textContent;

    const box = item(1).getBoundingClientRect();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const pointer = (type, dx) => item(1).dispatchEvent(new PointerEvent(type, { clientX: x + dx, clientY: y, pointerId: 1, bubbles: true }));
    item(1).setPointerCapture = () => {};  // no pointer of a real hand is there
    for (const [type, dx] of [['pointerdown', 0], ['pointermove', 12], ['pointermove', 30], ['pointerup', 30]]) pointer(type, dx);
    await until(() => !bench.text.includes('[0.95, 1.2]'));
    found.dragged = bench.text.match(/name = "ventilator"\nposition_m = \[(.*)\]/)[1];
    item(1).dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowUp' }));
    await until(() => bench.text.includes('1.25]'));
    item(1).dispatchEvent(new KeyboardEvent('keydown', { key: 'q' }));
    await until(() => bench.text.includes('yaw_deg = 15'));
    element('brakes').value = 'true';
    element('brakes').dispatchEvent(new Event('change'));
    await until(() => !bench.text.includes('brakes = false'));
    found.errors_of_hands = errors();

    const good = bench.text;
    const choose = (id, value, then) => {
      element(id).value = value;
      element(id).dispatchEvent(new Event('change'));
      return until(() => then() && bench.text === bench.known);
    };
    await choose('held', 'straps', () => bench.text.includes('[[tether]]'));
    found.straps = [bench.text.match(/\[\[tether\]\]/g).length, document.querySelectorAll('#plan .tether').length, element('held').value].join();
    await choose('held', 'none', () => !bench.text.includes('[[tether]]'));
    found.freed = bench.text === good || bench.text;
    await choose('building', element('building').options[1].value, () => bench.text.includes('"roof"'));
    await choose('storey', '1', () => /floor = 1$/m.test(bench.text));
    found.storey = errors() || element('storey').value;
    await bench.change(good.replace('brakes = true', 'brakes = 3'));
    found.field = [element('brakes').getAttribute('aria-invalid'), element('brakes').title, element('yaw').getAttribute('aria-invalid')].join();
    await bench.change(good.replace('brakes = true', 'brakes = maybe'));
    found.error = errors();
    await bench.change(good);
    found.mended = errors();
    await bench.addRecords([new File(['no record at all'], 'damaged.AT2')]);
    found.damaged = errors();
    const rows = Array.from({ length: 400 }, (_, i) => `${(0.01 * i).toFixed(2)},${(2 * Math.sin(0.06 * i) * Math.sin((Math.PI * i) / 399) ** 2).toFixed(6)}`);
    await bench.addRecords([new File([`time_s,x_m_per_s2\n${rows.join('\n')}\n`], 'mine.csv')]);
    await bench.change(bench.text.replace('file = "mine.csv"', 'file = "mine.csv"\nuse = "x"'));
    await bench.run();
    found.record = errors() || window.lastRun.findings.record.name;
    bench.keep();
    await bench.run();
    found.compared = [...document.querySelectorAll('#kept h2')].map((each) => each.textContent).join();
    bench.play = () => {};  // without a graphics card it takes the time of the engines
    element('player').onload = null;
    element('player').removeAttribute('srcdoc');
    await bench.many();
    found.curves = window.lastCurves.curves.map((curve) => curve.runs);
    found.drawn = document.querySelectorAll('#curves svg').length;

    bench.chosen = 1;
    await bench.editItem();
    const editor = bench.editor;
    const part = (name) => document.querySelector(`#item-plan [data-part="${name}"]`);
    const file = element('item-text');
    found.item_facts = element('item-facts').textContent;
    for (let i = 0; i < 3; ++i) part('caster 0').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft', bubbles: true }));
    await until(() => file.value.includes('value = [248, 213, 0]'));
    await editor.steps;
    found.item_kept = file.value.includes('# base');
    const svg = element('item-plan');
    svg.setPointerCapture = () => {};
    const scale = svg.getScreenCTM().a;
    const at = part('caster 0').getBoundingClientRect();
    const hand = (node, type, dx) => node.dispatchEvent(new PointerEvent(type, { clientX: at.x + dx, clientY: at.y, pointerId: 1, bubbles: true }));
    hand(part('caster 0'), 'pointerdown', 0);
    for (const share of [0.3, 0.6, 1]) hand(svg, 'pointermove', -0.1 * share * scale);
    hand(svg, 'pointerup', -0.1 * scale);
    await until(() => file.value.includes('position_mm = [148, 213, 0]'));
    await editor.granting;
    found.item_moved = element('item-facts').textContent;
    const good_item = file.value;
    file.value = good_item.replace('name = "front left"', 'nam = "front left"');
    await editor.read();
    found.item_error = element('item-errors').textContent;
    file.value = good_item;
    await editor.read();
    found.item_mended = element('item-errors').textContent;
    const before = window.lastRun;
    element('item-use').click();
    await until(() => window.lastRun !== before);
    found.used = bench.text.includes('equipment = "my_icu_ventilator.toml"') && !element('roompage').hidden;
    found.item = good_item;
    found.errors_of_item = errors();

    element('advise').click();
    const advised = () => element('overview').contentDocument?.querySelectorAll('#items tr').length;
    await until(advised);
    found.advised = advised();
    element('overview-back').click();
    found.back = !element('roompage').hidden && element('overviewpage').hidden;

    element('prevent').click();
    await until(() => window.lastPrevented);
    found.prevented = window.lastPrevented.filter((row) => !row.error).length;
    const ran = window.lastRun;
    const take = document.querySelector('#prevented button');
    found.taken = take.getAttribute('aria-label');
    take.click();
    await until(() => window.lastRun !== ran);
    found.errors_of_taking = errors();
  } catch (error) {
    found.thrown = `${error} ${error.stack}`;
  }
  console.log(`found${JSON.stringify(found)}@end`);
})();
JS
with "$page" try.js > tried.html
found_by tried.html > found.json
value() { node -e 'const of = JSON.parse(require("fs").readFileSync("found.json"))[process.argv[1]]; console.log(typeof of === "string" ? of : JSON.stringify(of) ?? "")' "$1"; }
value job > job.toml
grep -q gurney-job job.toml || { complain "the page does not run its job: $(head -c 300 found.json)"; exit 1; }
[ -z "$(value thrown)" ] || complain "the page throws: $(value thrown)"
sed -i "s|../../groundmotions|$source/groundmotions|" job.toml
"$gurney" run job.toml -o job.h5 --no-figure --json > program.json || complain "the program does not run the job"
node -e '
const [ours, program] = [JSON.parse(process.argv[1]), JSON.parse(require("fs").readFileSync("program.json"))];
program.items.forEach((item, i) => { if (!(Math.abs(item.demands.peak_displacement - ours[i]) <= 1e-9)) throw new Error(`${item.name}: ${ours[i]}`); });
' "$(value demands)" 2> stderr || complain "the page has other demands than the program"
value headline | grep -qx "Nothing overturned; .* went farthest from its start, [0-9]* mm." || complain "the headline is $(value headline)"
value dragged | grep -q "^1[.0-9]*, 1.2$" || complain "the dragged item is at $(value dragged)"
[ -z "$(value errors_of_hands)" ] || complain "hands make errors: $(value errors_of_hands)"
[ "$(value straps)" = 2,2,straps ] || complain "straps do not hold: $(value straps)"
[ "$(value freed)" = true ] || complain "taking straps away leaves: $(value freed)"
[ "$(value storey)" = 1 ] || complain "a storey cannot be chosen: $(value storey)"
value field | grep -q "^true,.*brakes.*,false$" || complain "an error is not at its field: $(value field)"
value error | grep -q "line 8: not valid TOML" || complain "an error of the job has no line: $(value error)"
[ -z "$(value mended)" ] || complain "an error stays when it is mended: $(value mended)"
value damaged | grep -q "damaged.AT2" || complain "a damaged record gives no message: $(value damaged)"
value record | grep -q "mine" || complain "a dropped record is not run: $(value record)"
[ "$(value compared)" = Now,Before ] || complain "runs do not stand beside each other: $(value compared)"
value curves | grep -q "100" || complain "a hundred runs are not made: $(value curves)"
[ "$(value drawn)" -gt 0 ] || complain "no curve is drawn"
value item_facts | grep -q "mass.*32.0 kg.*tips from.*rolls from\|mass.*32.0 kg.*rolls from.*tips from" ||
  complain "the editor says of the item: $(value item_facts)"
[ "$(value item_kept)" = true ] || complain "a comment of the item is lost"
[ "$(value item_facts)" != "$(value item_moved)" ] || complain "the facts do not follow a drag: $(value item_moved)"
value item_error | grep -q "^line [0-9]*: .*nam" || complain "an error of the item has no line: $(value item_error)"
[ -z "$(value item_mended)" ] || complain "an error of the item stays: $(value item_mended)"
[ "$(value used)" = true ] || complain "the edited item does not stand in the room"
[ -z "$(value errors_of_item)$(value errors_of_taking)" ] || complain "$(value errors_of_item) $(value errors_of_taking)"
value item > edited.toml
expect 0 "edited.toml: item 'ICU ventilator on cart' is valid" "$gurney" equipment check edited.toml
[ "$(value advised)" -eq "$(($(wc -l < "$source/studies/catalogue/items.csv") - 1))" ] || complain "$(value advised) items in the overview"
[ "$(value back)" = true ] || complain "the overview stays"
[ "$(value prevented)" -gt 5 ] || complain "only $(value prevented) changes are run"
value taken | grep -q "^Take over: " || complain "no change can be taken over"
[ -s console ] && { cp console stdout; complain "the page logs"; }

# A file that lost its end still opens; one whose engine is damaged says so.
head -c 200000 "$page" > damaged.html
printf '</script><script>console.log("foundstill here@end")</script></body></html>' >> damaged.html
found_by damaged.html | grep -q "still here" || complain "a damaged file is not opened"
cat > wait.js << 'JS'
const wait = setInterval(() => {
  if (!element('errors').textContent) return;
  clearInterval(wait);
  console.log(`found${element('errors').textContent}@end`);
}, 50);
JS
awk '/id="engine"/ {sub(/H4sI/, "H4sX")} {print}' "$page" > broken.html
with broken.html wait.js > broken_waits.html
found_by broken_waits.html | grep -q "This file is damaged" || complain "a damaged engine is not reported"
exit $((failures > 0))
