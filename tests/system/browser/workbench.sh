#!/usr/bin/env bash
# The workbench in a real browser: the file runs its job, shows a demand of the program, reports an error of a
# job at its line and goes on, takes records that are dropped, refuses damaged ones. Skipped (77) without
# Chromium or the page.
# usage: workbench.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
source=$2
page=$source/build/workbench/workbench.html
[ -e "$page" ] || { echo "skipped: ./dev workbench has not built $page"; exit 77; }
. "$source/tests/system/cli/expect.sh"
. "$source/tests/system/browser/chromium.sh"

cat > try.js << 'JS'
(async () => {
  const out = (name, value) => document.body.append(made('output', typeof value === 'string' ? value : JSON.stringify(value), { id: `found-${name}` }));
  const until = async (what) => { while (!what()) await new Promise((next) => setTimeout(next, 20)); };
  await until(() => window.lastRun);
  const bench = window.workbench;
  out('job', bench.text);
  out('demands', window.lastRun.findings.items.map((item) => item.demands.peak_displacement));
  await bench.change(bench.text.replace('brakes = true', 'brakes = maybe'));
  out('error', element('errors').textContent);
  await bench.change(bench.text.replace('maybe', 'true'));
  out('mended', element('errors').textContent);
  await bench.addRecords([new File(['no record at all'], 'damaged.AT2')]);
  out('damaged', element('errors').textContent);
  const rows = Array.from({ length: 400 }, (_, i) => `${(0.01 * i).toFixed(2)},${(2 * Math.sin(0.06 * i) * Math.sin(Math.PI * i / 399) ** 2).toFixed(6)}`);
  await bench.addRecords([new File([`t_s,x_m_per_s2\n${rows.join('\n')}\n`], 'mine.csv')]);
  await bench.change(bench.text.replace('file = "mine.csv"', 'file = "mine.csv"\nuse = "x"'));
  await bench.run();
  out('record', element('errors').textContent || window.lastRun.findings.record.name);
  bench.place(1, [0.9, 1.25], null);
  await until(() => bench.text.includes('[0.9, 1.25]'));
  await bench.many();
  out('curves', window.lastCurves.curves.map((curve) => curve.runs));
})();
JS
awk '/<\/body>/ {print "<script>"; while ((getline line < "try.js") > 0) print line; print "</script>"} {print}' \
  "$page" > tried.html
browser_waits=(--virtual-time-budget=600000 --enable-unsafe-swiftshader)
dom tried.html "${browser_waits[@]}" > stdout
cp stdout dom.html
value() { sed -n "/id=\"found-$1\"/,/<\/output>/p" dom.html | sed 's/.*id="found-'"$1"'">//; s/<\/output>.*//; s/&quot;/"/g'; }
value job > job.toml
mkdir -p data
[ -s job.toml ] || complain "the page does not run its job"
sed -i "s|../../groundmotions|$source/groundmotions|" job.toml
"$gurney" run job.toml -o job.h5 --no-figure --json > program.json || complain "the program does not run the job"
node -e '
const [ours, program] = [JSON.parse(process.argv[1]), JSON.parse(require("fs").readFileSync("program.json"))];
program.items.forEach((item, i) => { if (!(Math.abs(item.demands.peak_displacement - ours[i]) <= 1e-9)) throw new Error(`${item.name}: ${ours[i]}`); });
' "$(value demands)" 2> stderr || complain "the page has other demands than the program"
value error | grep -q "line 7: not valid TOML" || complain "an error of the job has no line: $(value error)"
[ -z "$(value mended)" ] || complain "an error stays when it is mended: $(value mended)"
value damaged | grep -q "damaged.AT2" || complain "a damaged record gives no message: $(value damaged)"
value record | grep -q "mine" || complain "a dropped record is not run: $(value record)"
value curves | grep -q "100" || complain "a hundred runs are not made: $(value curves)"
grep -v "GL Driver Message" console > others
[ -s others ] && { cp others stdout; complain "the page logs"; }

# A file that lost its end says so.
head -c 200000 "$page" > damaged.html
printf '</script><script>document.body.append("still here")</script></body></html>' >> damaged.html
dom damaged.html --virtual-time-budget=5000 | grep -q "still here" || complain "a damaged file is not opened"
awk '/id="engine"/ {sub(/H4sI/, "H4sX")} {print}' "$page" > broken.html
dom broken.html "${browser_waits[@]}" | grep -q "This file is damaged" || complain "a damaged engine is not reported"
exit $((failures > 0))
