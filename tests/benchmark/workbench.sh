#!/usr/bin/env bash
# Numbers of docs/workbench.md: what the page weighs and how fast it is, in Chromium on this machine.
# usage: workbench.sh SOURCE_FOLDER
set -euo pipefail
page=$(realpath "$1")/build/workbench/workbench.html
folder=$(mktemp -d)
trap 'kill "$browser" 2> /dev/null; wait; rm -r "$folder"' EXIT

cat > "$folder/measure.js" << 'JS'
(async () => {
  const wait = (ms) => new Promise((next) => setTimeout(next, ms));
  while (!window.lastRun) await wait(50);
  const { engines, text } = window.workbench;
  await wait(5000);
  const frames = await new Promise((done) => {
    const inside = element('player').contentWindow;
    const start = inside.performance.now();
    let count = 0;
    const frame = (now) => (now - start < 5000 ? (++count, inside.requestAnimationFrame(frame)) : done(count / 5));
    inside.requestAnimationFrame(frame);
  });
  const runs = [];
  for (let i = 0; i < 5; ++i) runs.push((await engines.ask('run', text)).seconds);
  const series = async (from, to) => {
    const start = performance.now();
    const answers = await Promise.all(Array.from({ length: to - from }, (_, i) => engines.ask('case', String(from + i), text)));
    const failed = answers.find((answer) => answer.error);
    if (failed) throw new Error(failed.error);
    return [(performance.now() - start) / 1000, Math.max(...answers.map((answer) => answer.memory)) / 1e6];
  };
  const [seconds, memory] = await series(0, 200);
  const [, later] = await series(200, 500);
  const rows = [
    ['the first job with its repetitions, median of 5', `${runs.sort((a, b) => a - b)[2].toFixed(2)} s`],
    [`200 runs of it under growing motions, ${engines.workers.length} workers`, `${seconds.toFixed(1)} s`],
    ['memory of an engine after these', `${memory.toFixed(1)} MB`],
    ['after 500', `${later.toFixed(1)} MB`],
    ['frames of the player, drawn without a graphics card', `${frames.toFixed(0)} per s`],
  ];
  console.log(`measured${rows.map((row) => `| ${row.join(' | ')} |`).join('@')}@`);
})().catch((error) => console.log(`measured the page fails: ${error.message}@`));
JS
awk -v script="$folder/measure.js" '
  /<\/body>/ {print "<script>"; while ((getline line < script) > 0) print line; print "</script>"} {print}' \
  "$page" > "$folder/measured.html"
chromium --headless --no-sandbox --no-first-run --disable-gpu --enable-unsafe-swiftshader --user-data-dir="$folder/profile" \
  --enable-logging=stderr --window-size=1400,900 "file://$folder/measured.html" 2> "$folder/log" &
browser=$!
for _ in $(seq 900); do
  ! grep -aq '"measured' "$folder/log" || break
  sleep 1
done
printf '| the file | %s MB |\n' "$(stat -c %s "$page" | awk '{printf "%.1f", $1 / 1e6}')"
grep -a '"measured' "$folder/log" | sed 's/.*"measured//; s/@".*//; s/@/\n/g'
