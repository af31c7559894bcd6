#!/usr/bin/env bash
# A page of gurney play in a real browser: no error on its console, the poses it shows are those of the file, it
# moves, and it says so where there is no WebGL. Skipped (77) without Chromium or h5py.
# usage: play.sh GURNEY SOURCE_FOLDER
set -uo pipefail
gurney=$1
source=$2
chromium=$(command -v chromium) || { echo "skipped: chromium is not installed"; exit 77; }
/usr/bin/python3 -c "import h5py, numpy" 2> /dev/null || { echo "skipped: python3-h5py is not installed"; exit 77; }
. "$source/tests/system/cli/expect.sh"

cat > run.toml << 'TOML'
schema = "gurney-job/1"
title = "</script><b onclick=alert(1)>'title' & \"more\"</b> 床"
[[item]]
equipment = "icu_ventilator"
name = "<i>first"
position_m = [0, 0]
[[item]]
equipment = "infusion_pole"
name = "pole"
position_m = [0, 0.9]
brakes = true
[[tether]]
name = "cord"
item = "pole"
point_m = { value = [0, 0, 1.0], assumption = "for this test", low = [-0.01, -0.01, 0.9], high = [0.01, 0.01, 1.1] }
anchor_m = { value = [0.5, 0.9, 0.3], assumption = "for this test", low = [0.4, 0.8, 0.2], high = [0.6, 1.0, 0.4] }
slack_length_m = { value = 1.0, assumption = "for this test", range = [0.9, 1.1] }
kind = "power_cord"
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.9, period_s = 1.2 }
use = "x"
TOML

# browse OPTIONS... ADDRESS: the document after `budget` ms of the page's own time
budget=3000
browse() {
  local profile
  profile=$(mktemp -d)
  timeout 300 "$chromium" --headless --no-sandbox --disable-quic --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --use-angle=swiftshader --enable-unsafe-swiftshader \
    --user-data-dir="$profile" --enable-logging=stderr --virtual-time-budget=$budget --window-size=1200,800 \
    --dump-dom "$@" > stdout 2> log
  rm -rf "$profile"
  grep "CONSOLE" log | grep -v "GL Driver Message" > stderr && complain "the console has errors: $*"
}

expect 0 "run.h5" "$gurney" run run.toml -o run.h5 --no-figure
expect 0 "play.html" "$gurney" play run.h5 -o play.html
[ "$failures" -eq 0 ] || exit 1
page=file://$PWD/play.html

for t in 0 1.2 2.5 1000; do
  browse "$page#t=$t"
  /usr/bin/python3 "$source/tests/system/browser/read_playback.py" run.h5 stdout "$t" ||
    complain "the page does not show the poses or events of the file at $t s"
done
# Virtual time passes at once where a busy machine draws no frames, unless each is awaited: then again, for longer.
moved() {
  /usr/bin/python3 - << 'PYTHON'
import re, sys
time = float(re.search(r'<output id="time"[^>]*>([0-9.]+) s', open("stdout").read()).group(1))
sys.exit(not time > 1)
PYTHON
}
for budget in 20000 40000 80000 160000 320000; do
  browse --run-all-compositor-stages-before-draw "$page#t=1&view=follow&frame=ground&theme=dark&play"
  moved && break
done
moved || complain "the playback does not move"
budget=3000
grep -q 'id="trouble" role="alert" hidden' stdout || complain "WebGL2 does not work in this browser"
browse --disable-3d-apis "$page#t=2.5"
grep -q "draws no three-dimensional view" stdout || complain "a browser without WebGL is not told so"
/usr/bin/python3 "$source/tests/system/browser/read_playback.py" run.h5 stdout 2.5 ||
  complain "without WebGL the table is not that of the file"
# Ghosts: the poses of the other runs are those of their own files, and as many have overturned.
cat > study.toml << 'TOML'
schema = "gurney-job/1"
[[item]]
equipment = "infusion_pole"
name = "<i>pole"
brakes = true
[[item]]
equipment = "icu_ventilator"
name = "ventilator"
position_m = [0, 0.8]
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.9, period_s = 1.2 }
use = "x"
[study]
angles_deg = [0, 20, 90]
[study.intensity]
measure = "PGA"
component = "h1"
unit = "g"
levels = [0.1, 0.9]
TOML
expect 0 "study.h5" "$gurney" run study.toml -o study.h5
for run in 1 3 5; do expect 0 "run_$run.h5" "$gurney" replay study.h5 $run -o run_$run.h5; done
expect 0 "ghosts.html" "$gurney" play study.h5 --run 1 --ghosts -o ghosts.html
cat > ghosts.js << 'JS'
const of = window.player;
const poses = (run, time) => run.items.map((item) => itemPose(item, run.at(time)));
return of.runs.concat(of.ghosts).map((run) => ({
  name: run.name, samples: run.time.length, time: [...run.time],
  poses: [...run.time].filter((_, i) => i % 7 === 0).map((time) => poses(run, time)) })).concat([
  [0, 1.5, 2.5, 1000].map((time) => { of.go(time); of.draw(); return element("overturned").textContent; })]);
JS
awk -v script=ghosts.js '
  /<\/body>/ {
    print "<script>const out = document.createElement(\"output\"); out.id = \"found\"; out.textContent = JSON.stringify((() => {"
    while ((getline line < script) > 0) print line
    print "})()); document.body.append(out);</script>"
  } {print}' ghosts.html > asked.html
browse "file://$PWD/asked.html"
grep -q 'id="trouble" role="alert" hidden' stdout || complain "WebGL2 does not draw ghosts"
/usr/bin/python3 "$source/tests/system/browser/read_ghosts.py" stdout asked.html run_1.h5 run_3.h5 run_5.h5 ||
  complain "the ghosts are not where their files say"
[ "$(stat -c %s ghosts.html)" -lt 5000000 ] || complain "a page with ghosts has more than 5 MB"

exit $((failures > 0))
