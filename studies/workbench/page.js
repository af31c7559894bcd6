// The page. The text of the job is what there is; controls change it and show what the engine reads in it.

const element = (id) => document.getElementById(id);

function made(name, text, attributes = {}) {
  const node = document.createElement(name);
  if (text !== undefined) node.textContent = text;
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  return node;
}

const kFirstJob = `schema = "gurney-job/1"
title = "ICU bay"

[[item]]
equipment = "icu_bed"
name = "bed"
position_m = [1.5, 0]
brakes = true

[[item]]
equipment = "icu_ventilator"
name = "ventilator"
position_m = [0.95, 1.2]
brakes = false

[[item]]
equipment = "infusion_pole"
name = "pole"
position_m = [0.7, -1.2]

[room]
file = "icu_bay"

[floor]
covering = "polyflor_mystique"

[excitation.record]
file = "../../groundmotions/records/synthetic_3c.csv"

[output]
history_step_s = 0.02
`;
const kShippedRecord = 'file = "../../groundmotions/records/synthetic_3c.csv"';
const kRuns = 100;
/// Controls of keys of a job, as messages name them.
const kControls = { yaw_deg: 'yaw', brakes: 'brakes', headings_deg: 'headings', 'room.file': 'room', 'floor.covering': 'covering', 'excitation.record': 'motion', 'excitation.record.scale': 'scale', 'excitation.building': 'building', 'excitation.building.floor': 'storey' };

class Workbench {
  constructor(module) {
    this.engines = new Engines(module, Math.max(1, Math.min(8, navigator.hardwareConcurrency || 2)));
    this.chosen = 0;
    this.edits = Promise.resolve();
    const fields = Object.entries(kControls).map(([key, id]) => [key, element(id)]);
    this.pane = new TextPane({ text: element('text'), lines: element('lines'), errors: element('errors'), file: 'job.toml', fields, changed: () => this.read() });
    this.prevented = new Prevented(this.engines, (text) => this.change(text).then(() => this.run()));
    this.plan = new Plan(element('plan'), (...where) => this.place(...where), (i) => this.choose(i));
    this.connect();
    this.given = JSON.parse(element('given').textContent) || { text: kFirstJob, files: [] };
    this.pane.value = this.given.text;
  }

  async start() {
    for (const [name, bytes] of this.given.files) this.engines.add(name, unpacked(bytes).buffer);
    this.catalogue = await this.engines.ask('catalogue');
    const fill = (id, entries) => entries.forEach(({ name, title, about }) => element(id).append(made('option', title, { value: name, title: about })));
    fill('add', this.catalogue.items);
    fill('room', this.catalogue.rooms);
    fill('covering', this.catalogue.floors);
    fill('building', this.catalogue.buildings);
    element('motion').append(made('option', 'none', { value: '', title: 'the floor rests' }), made('option', 'shipped record', { value: kShippedRecord, title: 'synthetic, in three directions' }));
    for (const { name, about } of this.catalogue.synthetic) element('motion').append(made('option', name.replaceAll('_', ' '), { value: `synthetic = { kind = ${asText(name)} }`, title: about }));
    this.editor = new ItemEditor(this.engines, this.catalogue.casters, (name, text) => this.useItem(name, text));
    if ((await this.read()) && this.given.edit) await this.editItem();
    if (this.known === this.text) await this.run();
  }

  get text() {
    return this.pane.value;
  }

  /// Sets a key of the table of this name, which is made where it is missing; null: not stated.
  setKey(name, key, value) {
    return this.edit((text) => {
      const table = within(this.tree, ...name.split('.'));
      if (table) return withKey(text, table, key, value);
      return value === null ? text : withTable(text, name, `${key} = ${value}`);
    });
  }

  setItemKey(index, key, value) {
    return this.edit((text) => withKey(text, itemsOf(this.tree)[index], key, value));
  }

  /// A change at a line, of the text as the engine has read it; one after the other.
  edit(changed) {
    this.edits = this.edits.then(async () => {
      if (this.text === this.known || (await this.read())) return this.change(await changed(this.text));
      element('status').textContent = 'The job text has errors; mend them first.';
      if (this.planned) this.plan.draw(this.planned);
    });
    return this.edits;
  }

  async change(text) {
    this.pane.value = text;
    await this.read();
  }

  /// Has the engine read the text, and shows what it found.
  async read() {
    const text = this.text;
    const plan = await this.engines.ask('plan', text);
    if (text !== this.text) return false;
    this.pane.showErrors(plan.error || '');
    if (plan.error) return false;
    this.known = text;
    this.planned = plan;
    this.tree = plan.tree;
    this.items = plan.items;
    this.chosen = Math.min(this.chosen, plan.items.length - 1);
    this.plan.draw(plan);
    this.choose(this.chosen);
    this.showControls();
    return true;
  }

  showControls() {
    this.showChoices();
    for (const select of document.querySelectorAll('#setup select')) select.title = select.selectedOptions[0]?.textContent || '';
  }

  showChoices() {
    const stated = (...path) => within(this.tree, ...path)?.value ?? '';
    showChoice(element('room'), stated('room', 'file'));
    showChoice(element('covering'), stated('floor', 'covering'));
    showChoice(element('building'), stated('excitation', 'building', 'file'));
    const { storeys } = this.planned;
    element('on-storey').hidden = storeys === 0;
    element('storey').replaceChildren(made('option', 'roof', { value: '"roof"' }), ...Array.from({ length: storeys }, (_, i) => made('option', i ? `${i} of ${storeys}` : 'base', { value: i })));
    const storey = stated('excitation', 'building', 'floor');
    element('storey').value = storey === storeys ? '"roof"' : asText(storey);
    const scale = stated('excitation', 'record', 'scale') || 1;
    element('scale').value = 20 * Math.log10(scale);
    element('scaled').textContent = `× ${+scale.toPrecision(3)}`;
    const record = within(this.tree, 'excitation', 'record');
    const kind = stated('excitation', 'record', 'synthetic', 'kind');
    const file = stated('excitation', 'record', 'file');
    const motion = element('motion');
    motion.value = !record ? '' : kind ? `synthetic = { kind = ${asText(kind)} }` : `file = ${asText(file)}`;
    if (motion.selectedIndex >= 0 && motion.selectedOptions[0] !== this.own) return;
    // A record that the list does not have, and comes back with all that the job says of it.
    this.own = this.own || motion.appendChild(made('option'));
    this.own.textContent = file || 'as the job says';
    motion.value = this.own.value = bodyOf(this.text, 'excitation.record');
  }

  choose(index) {
    this.chosen = index;
    const item = this.items[index];
    if (!item) return;
    element('plan').querySelectorAll('.item').forEach((node, i) => node.classList.toggle('chosen', i === index));
    element('chosen').querySelector('legend').textContent = item.name;
    const keys = itemsOf(this.tree)[index]?.keys || {};
    element('yaw').value = rounded(degrees(item.yaw), 0.1);
    element('brakes').value = keys.brakes?.value === undefined ? '' : String(keys.brakes.value);
    element('headings').value = keys.headings_deg?.value ?? '';
    const held = this.planned.tethers.filter((tether) => tether.item === item.name);
    element('held').options[0].disabled = !held.length;
    element('held').value = !held.length ? 'none' : held.length === 2 && held.every(({ name }) => name.startsWith(`${item.name}: strap `)) ? 'straps' : 'job';
  }

  place(index, at, yaw) {
    return at ? this.setItemKey(index, 'position_m', `[${at.join(', ')}]`) : this.setItemKey(index, 'yaw_deg', yaw);
  }

  connect() {
    const changed = (id, act) => element(id).addEventListener('change', () => act(element(id).value));
    const orNone = (value) => (value === '' ? null : value);
    changed('yaw', (value) => this.setItemKey(this.chosen, 'yaw_deg', orNone(value)));
    changed('brakes', (value) => this.setItemKey(this.chosen, 'brakes', orNone(value)));
    changed('headings', (value) => this.setItemKey(this.chosen, 'headings_deg', orNone(value)));
    changed('add', (value) => this.add(value));
    changed('held', (value) => this.hold(value));
    changed('storey', (value) => this.setKey('excitation.building', 'floor', value));
    changed('room', (value) => (value ? this.setKey('room', 'file', asText(value)) : this.change(withoutTable(this.text, 'room'))));
    changed('covering', (value) => (value ? this.setKey('floor', 'covering', asText(value)) : this.change(withoutTable(this.text, 'floor'))));
    changed('building', (value) => this.change(value ? withTable(this.text, 'excitation.building', `file = ${asText(value)}\nfloor = "roof"`) : withoutTable(this.text, 'excitation.building')));
    changed('motion', (value) => this.change(value ? withTable(this.text, 'excitation.record', value) : withoutTable(withoutTable(this.text, 'excitation.building'), 'excitation.record')));
    element('scale').addEventListener('input', () => (element('scaled').textContent = `× ${this.scale()}`));
    changed('scale', () => this.setKey('excitation.record', 'scale', this.scale()));
    element('remove').addEventListener('click', () => this.edit((text) => withoutItem(text, this.chosen)));
    element('setup').addEventListener('submit', (event) => {
      event.preventDefault();
      this.run();
    });
    element('keep').addEventListener('click', () => this.keep());
    element('many').addEventListener('click', () => this.many());
    element('download').addEventListener('click', () => download('job.toml', this.text));
    element('edit').addEventListener('click', () => this.editItem());
    for (const id of ['item-back', 'overview-back']) element(id).addEventListener('click', () => this.turnTo('roompage'));
    element('advise').addEventListener('click', () => this.advise());
    element('prevent').addEventListener('click', () => this.prevented.ask(this.ran, this.ranTree));
    this.connectFiles();
  }

  /// Two straps on the chosen item, or nothing, in place of its tethers.
  hold(by) {
    const index = this.chosen;
    return this.edit(async (text) => {
      const without = withoutTethers(text, this.tree, this.items[index].name);
      if (by !== 'straps') return without;
      const { tables, error } = await this.engines.ask('straps', String(index), without);
      if (error) element('status').textContent = error;
      return [without.trimEnd(), ...(tables || [])].join('\n\n');
    });
  }

  turnTo(page) {
    for (const id of ['roompage', 'itempage', 'overviewpage']) element(id).hidden = id !== page;
    window.scrollTo(0, 0);
  }

  /// The overview of the fragility catalogue: what to brake, by floor, place and velocity.
  async advise() {
    this.turnTo('overviewpage');
    const frame = element('overview');
    if (!frame.srcdoc) frame.srcdoc = new TextDecoder().decode(await inflated(element('overview-text').textContent));
  }

  /// Opens the file of the chosen item. A shipped one gets another name.
  async editItem() {
    const equipment = itemsOf(this.tree)[this.chosen]?.keys.equipment?.value;
    const source = equipment ? await this.engines.ask('source', equipment) : { error: 'The job itself describes this item: change it in the job text.' };
    if (source.error) {
      element('status').textContent = source.error;
      return;
    }
    this.edited = this.chosen;
    this.turnTo('itempage');
    await this.editor.open(this.catalogue.items.some(({ name }) => name === equipment) ? `my_${source.name}` : source.name, source.text);
  }

  async useItem(name, text) {
    this.engines.add(name, new TextEncoder().encode(text).buffer);
    this.known = null;
    await this.setItemKey(this.edited, 'equipment', asText(name));
    this.turnTo('roompage');
    if (this.text === this.known) await this.run();
  }

  connectFiles() {
    element('record').addEventListener('change', () => this.addRecords([...element('record').files]));
    element('open').addEventListener('change', async () => this.change(await element('open').files[0].text()));
    const dragged = (on) => (event) => {
      event.preventDefault();
      document.body.classList.toggle('dropping', on);
    };
    document.addEventListener('dragover', dragged(true));
    document.addEventListener('dragleave', dragged(false));
    document.addEventListener('drop', (event) => {
      dragged(false)(event);
      this.addRecords([...event.dataTransfer.files]);
    });
  }

  scale() {
    return +(10 ** (element('scale').value / 20)).toPrecision(2);
  }

  add(equipment) {
    element('add').value = '';
    if (!equipment) return;
    const names = this.items.map((item) => item.name);
    const base = equipment.replaceAll('_', ' ');
    let name = base;
    for (let i = 2; names.includes(name); ++i) name = `${base} ${i}`;
    const right = Math.max(...this.items.map((item) => item.at[0]));
    this.chosen = this.items.length;
    this.change(withItem(this.text, equipment, name, [rounded(right + 1.5, 0.05), 0]));
  }

  async addRecords(files) {
    if (!files.length) return;
    for (const file of files) this.engines.add(file.name, await file.arrayBuffer());
    const names = files.map((file) => asText(file.name));
    await this.change(withTable(this.text, 'excitation.record', `file = ${names.length === 1 ? names[0] : `[${names.join(', ')}]`}`));
    await this.run();
  }

  async run() {
    this.endSeries();
    element('status').textContent = 'Running…';
    const text = this.text;
    const tree = this.tree;
    const answer = await this.engines.ask('run', text);
    this.pane.showErrors(answer.error || '');
    element('status').textContent = answer.error ? 'Not run.' : `${answer.simulated.toFixed(1)} s of shaking and three repetitions that judge it, in ${answer.seconds.toFixed(2)} s.`;
    if (answer.error) return;
    this.ran = text;
    this.ranTree = tree;
    this.show(answer);
  }

  show(answer) {
    this.last = answer;
    window.lastRun = answer;
    element('result').hidden = false;
    element('headline').textContent = answer.headline;
    element('limits').replaceChildren(...answer.limit_states.map(({ name, words, exceeded }) => made('li', `${exceeded ? '' : 'not '}${name}`, { title: words, class: exceeded ? 'exceeded' : 'not' })));
    element('ask').hidden = !answer.limit_states.some(({ exceeded }) => exceeded);
    this.play([answer, this.before].filter((run) => run?.recording));
    this.tell();
    element('numbers').replaceChildren(...shownSection(answer.shown));
    element('curves').replaceChildren();
    element('progress').textContent = '';
  }

  /// The runs side by side in the player.
  play(runs) {
    element('player').hidden = runs.length === 0;
    if (!runs.length) return;
    const names = runs.length > 1 ? ['now', 'before'] : [''];
    const data = { ...runs[0].recording, runs: runs.map((run, i) => ({ ...run.recording.runs[0], name: names[i] })) };
    const playback = new TextDecoder().decode(unpacked(element('playback').textContent));
    const json = JSON.stringify(data).replaceAll('<', '\\u003c');
    element('player').srcdoc = playback.split('/*DATA*/').join(json);
    element('player').onload = () => element('player').contentWindow.player?.toggle(true);
  }

  tell() {
    const runs = [['Now', this.last], ['Before', this.before]].filter(([, run]) => run);
    element('kept').replaceChildren(
      ...runs.map(([title, run]) => {
        const column = made('div');
        if (runs.length > 1) column.append(made('h2', title));
        column.append(...run.narrative.map((line) => made('p', line, line.startsWith(' ') ? { class: 'detail' } : {})));
        for (const warning of run.warnings) column.append(made('p', `Warning: ${warning}`));
        return column;
      }),
    );
  }

  keep() {
    this.before = this.last;
    element('progress').textContent = 'Kept: the next run is shown beside it.';
  }

  /// Ends a series of runs that goes on. @returns the number of the next one
  endSeries() {
    this.engines.dropSeries();
    this.prevented.clear();
    return (this.series = (this.series || 0) + 1);
  }

  /// Runs of one job under growing motions; the curves grow with them.
  async many() {
    const series = this.endSeries();
    const cases = [];
    const text = this.text;
    const problems = new Set();
    let finished = 0;
    const one = async (index) => {
      const answer = await this.engines.ask('case', String(index), text);
      if (series !== this.series) return;
      ++finished;
      if (answer.error) problems.add(answer.error);
      else cases.push(answer);
      element('progress').textContent = `${finished} of ${kRuns} runs${problems.size ? `; ${[...problems][0]}` : ''}`;
      if (finished % 10 === 0 && cases.length) this.showCurves(await this.engines.ask('fragility', JSON.stringify(cases)), series);
    };
    await Promise.all(Array.from({ length: kRuns }, (_, i) => one(i)));
  }

  showCurves(answer, series) {
    if (series !== this.series || answer.error) return;
    window.lastCurves = answer;
    element('curves').replaceChildren(...answer.curves.map(curveFigure));
  }
}

function download(name, text) {
  const link = made('a', '', { download: name, href: URL.createObjectURL(new Blob([text], { type: 'application/toml' })) });
  link.click();
  URL.revokeObjectURL(link.href);
}

/// A file that the list does not have is added to it.
function showChoice(select, value) {
  if (![...select.options].some((option) => option.value === value)) select.append(made('option', value, { value }));
  select.value = value;
}

function shownSection(section) {
  if (!section) return [];
  const nodes = section.title ? [made('h2', section.title)] : [];
  let facts = null;
  for (const part of section.parts) {
    if (part.label === undefined) facts = null;
    else {
      if (!facts) nodes.push((facts = made('table')));
      const row = made('tr');
      row.append(made('th', part.label, { scope: 'row' }), made('td', part.value), made('td', part.note));
      facts.append(row);
    }
    if (part.tables) nodes.push(...part.tables.flatMap(shownTable));
    if (part.say) nodes.push(made('p', part.say));
    if (part.lines) nodes.push(...(part.title ? [made('h2', part.title)] : []), ...part.lines.map((line) => made('p', line)));
    if (part.parts) nodes.push(...shownSection(part));
  }
  return nodes;
}

function shownTable({ title, columns, rows }) {
  const table = made('table');
  const head = table.createTHead().insertRow();
  for (const { label, meaning } of columns) head.append(made('th', label, { scope: 'col', title: meaning }));
  const body = table.createTBody();
  for (const cells of rows) body.insertRow().append(...cells.map((cell) => made('td', cell)));
  return title ? [made('h2', title), table] : [table];
}

function curveFigure({ name, words, status, runs, exceeded, im, curve, low, high, theta }) {
  const [width, height, left, bottom] = [280, 150, 30, 26];
  const x = (v) => left + ((width - left - 8) * v) / im[im.length - 1];
  const y = (p) => 8 + (height - bottom - 8) * (1 - p);
  const line = (values) => values.map((p, i) => `${x(im[i]).toFixed(1)},${y(p).toFixed(1)}`);
  const svg = drawn('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `${name}: probability over the peak acceleration of the floor` });
  svg.append(drawn('path', { class: 'axis', fill: 'none', d: `M ${left} 8 V ${y(0)} H ${width - 8}` }));
  if (low.length) svg.append(drawn('polygon', { class: 'band', points: [...line(low), ...line(high).reverse()].join(' ') }));
  if (curve) svg.append(drawn('polyline', { class: 'curve', points: line(curve).join(' ') }));
  for (const p of [0, 0.5, 1]) svg.append(drawn('text', { x: left - 4, y: y(p) + 4, 'text-anchor': 'end' }, String(p)));
  svg.append(drawn('text', { x: width - 8, y: height - 6, 'text-anchor': 'end' }, `peak floor acceleration, to ${im[im.length - 1].toFixed(1)} m/s²`));
  const figure = made('figure');
  const median = curve ? `median ${theta.toPrecision(3)} m/s²` : status;
  figure.append(svg, made('figcaption', `${name} (${words}): ${median}; ${exceeded} of ${runs} runs`));
  return figure;
}

const unpacked = (base64) => Uint8Array.from(atob(base64.replace(/\s/g, '')), (c) => c.charCodeAt(0));

async function inflated(base64) {
  const stream = new Blob([unpacked(base64)]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

async function begin() {
  try {
    const bytes = await inflated(element('engine').textContent);
    window.workbench = new Workbench(await WebAssembly.compile(bytes));
    await window.workbench.start();
  } catch (error) {
    element('errors').replaceChildren(made('li', `This file is damaged or the browser too old: ${error.message}`));
  }
}

const kWorkerSource = element('worker').textContent;
begin();
