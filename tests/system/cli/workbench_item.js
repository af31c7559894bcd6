// Questions of the item editor and of what would have prevented it, in Node. Writes moved.toml and bare.toml.
// usage: workbench_item.js SOURCE_FOLDER MODULE SHOWN.txt, what `gurney equipment show icu_ventilator` prints
'use strict';
const fs = require('fs');
const assert = require('assert');
const [source, wasm, printed] = process.argv.slice(2);
const scripts = ['host', 'jobtext', 'prevented'].map((name) => fs.readFileSync(`${source}/studies/workbench/${name}.js`));
const { Engine, withQuantity, withValue, valueOf, withChange } = new Function(`${scripts.join('\n')}; return { Engine, withQuantity, withValue, valueOf, withChange };`)();
const engine = new Engine(new WebAssembly.Module(fs.readFileSync(wasm)));

const { text, name } = engine.ask('source', 'icu_ventilator');
assert.strictEqual(name, 'icu_ventilator.toml');
assert.strictEqual(text, fs.readFileSync(`${source}/equipment/items/icu_ventilator.toml`, 'utf8'));
const item = engine.ask('item', name, text);
const words = (line) => line.replace(/\s+/g, ' ');
const shown = words(fs.readFileSync(printed, 'utf8'));
assert.strictEqual(item.facts.parts.length, 8);
for (const { label, value } of item.facts.parts) assert(shown.includes(words(`${label} ${value}`)), `${label} ${value} is not printed`);
assert(item.polygon.length === 4 && item.casters.length === 4 && item.boxes.length === 2);

// A number changes where it stands, in any form.
const caster = item.tree.keys.caster.list[0];
assert.deepStrictEqual(valueOf(caster.keys.position_mm), [263, 213, 0]);
const moved = withQuantity(text, caster, 'position_mm', '[250, 213, 0]', false);
assert.strictEqual(moved, text.replace('value = [263, 213, 0]', 'value = [250, 213, 0]'));
assert(engine.ask('item', name, moved).casters[0].at[0] === 0.25);
fs.writeFileSync('moved.toml', moved);
const outside = engine.ask('item', name, withQuantity(text, caster, 'position_mm', '[100, 213, 0]', false));
assert(/^.*icu_ventilator.toml:\d+:\d+: caster\[0\].position_mm/.test(outside.error), outside.error);
const bare = withQuantity(text, caster, 'position_mm', '[100, 213, 0]', true);
assert(engine.ask('item', name, bare).casters[0].at[0] === 0.1);
assert(!bare.includes('high = [290, 240, 0]'));
fs.writeFileSync('bare.toml', bare);
const inline = 'a = { value = -3, source = "x, } y" } # d';
assert.strictEqual(withValue(inline, { line: 1, column: 5 }, '7'), 'a = 7 # d');
assert.strictEqual(withValue('a = [1, [2]] # [', { line: 1, column: 5 }, '7'), 'a = 7 # [');

// Each change is a job that runs, and the job as it was has the demands of its run.
const job = `schema = "gurney-job/1"
[[item]]
equipment = "infusion_pole"
name = "pole"
brakes = false
[excitation.record]
synthetic = { kind = "ricker", pga_g = 0.9, period_s = 0.8 }
use = "x"
`;
const found = engine.ask('alternatives', job);
assert(!found.error, found.error);
assert.strictEqual(found.subject_name, 'pole');
const names = found.alternatives.map((each) => each.name);
for (const each of ['turned by 90 deg', 'with two straps', 'casters turned by 90 deg', 'floor: Linoleum']) assert(names.some((one) => one.startsWith(each)), `${each}: ${names}`);
const { tree } = engine.ask('plan', job);
const peak = engine.ask('outcome', '0', job).peak_displacement[0];
assert.strictEqual(peak, engine.ask('run', job).findings.items[0].demands.peak_displacement);
const peaks = found.alternatives.map((each) => {
  const changed = withChange(job, tree, found.subject, each);
  const outcome = engine.ask('outcome', '0', changed);
  // Not every item has brakes, which the table says.
  assert(!outcome.error || /brake/.test(outcome.error), `${each.name}: ${outcome.error}\n${changed}`);
  return outcome.error ? Infinity : outcome.peak_displacement[0];
});
assert(peaks[names.indexOf('with two straps')] < 0.5 * peak, 'straps do not hold');

// Two straps are tables of the job.
const { tables } = engine.ask('straps', '0', job);
assert.strictEqual(tables.length, 2);
const strapped = [job, ...tables].join('\n');
assert(engine.ask('outcome', '0', strapped).peak_displacement[0] < 0.5 * peak, 'straps do not hold');
assert.deepStrictEqual(engine.ask('plan', strapped).tethers.map(({ item }) => item), ['pole', 'pole']);

// A file that changes is read again.
engine.ask('file', 'cart.toml', text);
const with_cart = job.replace('"infusion_pole"', '"cart.toml"');
assert(!engine.ask('case', '0', with_cart).error);
engine.ask('file', 'cart.toml', moved.replace('mass_kg', 'mass_g'));
assert(engine.ask('case', '0', with_cart).error, 'a changed file is not read again');
console.log('the module says what the program says');
