// Runs a job in the module and compares all its findings with those of the program.
// usage: workbench.js SOURCE_FOLDER MODULE JOB [FINDINGS.json]; 1: an error of the job, or a difference
// JOB: a job, or a page that `gurney workbench` has filled with one and its files
'use strict';
const fs = require('fs');
const [source, wasm, job, expected] = process.argv.slice(2);
const Engine = new Function(`${fs.readFileSync(`${source}/studies/workbench/host.js`)}; return Engine;`)();
const engine = new Engine(new WebAssembly.Module(fs.readFileSync(wasm)));

// The module's libm and the order of vector sums differ from the program's in the last digits, which a
// trolley that follows from its inputs keeps: 1e-9 is what nobody can measure (the twin of
// engine/response/predictability.h). What is chaotic, or a sum of rounding errors, may differ.
const kTolerance = 1e-9;
let compared = 0;
const differences = [];

function compare(path, ours, theirs) {
  if (typeof theirs === 'number' && typeof ours === 'number') {
    ++compared;
    const scale = Math.max(1, Math.abs(theirs));
    if (!(Math.abs(ours - theirs) <= kTolerance * scale)) differences.push(`${path}: ${ours}, the program has ${theirs}`);
  } else if (theirs !== null && typeof theirs === 'object') {
    for (const key of Object.keys(theirs)) compare(`${path}.${key}`, (ours || {})[key], theirs[key]);
  } else if (ours !== theirs) {
    differences.push(`${path}: ${ours}, the program has ${theirs}`);
  }
}

let text = fs.readFileSync(job, 'utf8');
if (job.endsWith('.html')) {
  const given = JSON.parse(text.match(/id="given">(.*)<\/script>/)[1]);
  for (const [name, bytes] of given.files) engine.ask('file', name, Buffer.from(bytes, 'base64'));
  text = given.text;
}
const answer = engine.ask('run', text);
if (answer.error) {
  console.log(answer.error);
  // The engine goes on after an error.
  process.exit(engine.ask('catalogue').items.length > 0 ? 1 : 2);
}
const program = JSON.parse(fs.readFileSync(expected));
program.items.forEach((item, i) => {
  for (const part of ['demands', 'wheels', 'points']) compare(`${item.name}.${part}`, answer.findings.items[i][part], item[part]);
});
if (compared < 20) differences.push(`only ${compared} numbers compared`);
console.log(differences.length ? differences.join('\n') : `${compared} numbers are the same`);
process.exit(differences.length ? 1 : 0);
