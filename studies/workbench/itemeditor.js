// The item editor: two drawings whose parts are dragged, number fields, and the file of the item in step with
// them. What holds the item up and when it tips is the engine's answer to the text.

const kViews = {
  plan: { axes: [0, 1], name: 'plan' },
  side: { axes: [0, 2], name: 'side' },
};
const kFields = {
  centre: [['mass_kg', 'mass', 'kg', 1], ['center_of_mass_mm', 'centre of mass x, y, z', 'mm', 3], ['inertia_box_mm', 'inertia of a box x, y, z', 'mm', 3]],
  box: [['size_mm', 'size x, y, z', 'mm', 3], ['center_mm', 'middle x, y, z', 'mm', 3]],
  cylinder: [['radius_mm', 'radius', 'mm', 1], ['length_mm', 'length', 'mm', 1], ['center_mm', 'middle x, y, z', 'mm', 3]],
  sphere: [['radius_mm', 'radius', 'mm', 1], ['center_mm', 'middle x, y, z', 'mm', 3]],
  hull: [['position_mm', 'origin x, y, z', 'mm', 3]],
  caster: [['position_mm', 'mount x, y, z', 'mm', 3], ['heading_deg', 'turned', 'deg', 1]],
};
const kPlaces = { centre: 'center_of_mass_mm', box: 'center_mm', cylinder: 'center_mm', sphere: 'center_mm', hull: 'position_mm', caster: 'position_mm' };
const kNewParts = {
  box: '[[shape]]\nsize_mm = [300, 300, 300]\ncenter_mm = [0, 0, 150]\n',
  caster: '[[caster]]\ntype = "R100"\nposition_mm = [0, 0, 0]\n',
};

class ItemEditor {
  /// @param used  (name, text): called with an item that is to stand in the room
  constructor(engines, casters, used) {
    this.engines = engines;
    this.used = used;
    this.chosen = 'centre 0';
    this.pane = new TextPane({ text: element('item-text'), lines: element('item-lines'), errors: element('item-errors'), file: 'item.toml', changed: () => this.read() });
    for (const { name, title, about } of casters) element('item-type').append(made('option', title, { value: name, title: about }));
    for (const name of Object.keys(kViews)) this.connectDrawing(name);
    this.connect();
  }

  connect() {
    const click = (id, act) => element(id).addEventListener('click', act);
    click('item-save', () => download(this.pane.file, this.pane.value));
    click('item-use', async () => (await this.read()) && this.used(this.pane.file, this.pane.value));
    click('item-add-box', () => this.addPart('box'));
    click('item-add-caster', () => this.addPart('caster'));
    click('item-remove', () => this.removePart());
    element('item-open').addEventListener('change', async () => {
      const [file] = element('item-open').files;
      if (file) this.open(file.name, await file.text());
      element('item-open').value = '';
    });
    const flag = (id, key) => element(id).addEventListener('change', () => this.set(this.chosen, key, String(element(id).checked)));
    flag('item-brake', 'brake');
    flag('item-swivels', 'swivels');
    element('item-type').addEventListener('change', () => this.set(this.chosen, 'type', asText(element('item-type').value)));
  }

  open(name, text) {
    this.pane.file = name;
    element('item-name').textContent = name;
    this.answer = this.parts = null;
    for (const view of Object.keys(kViews)) element(`item-${view}`).replaceChildren();
    this.pane.value = text;
    return this.read();
  }

  /// Has the engine read the text, and shows what it found.
  async read() {
    const text = this.pane.value;
    const answer = await this.engines.ask('item', this.pane.file, text);
    if (text !== this.pane.value) return false;
    this.pane.showErrors(answer.error || '');
    element('itempage').classList.toggle('stale', !!answer.error);
    this.failed = !!answer.error;
    if (!answer.tree) return false;
    this.known = text;
    // With errors the drawings stay as they were; the fields are those of the text.
    this.answer = answer.error && this.answer ? { ...this.answer, tree: answer.tree } : answer;
    if (!this.answer.boxes) return false;
    this.parts = this.partsOf(this.answer);
    if (!this.parts[this.chosen]) this.chosen = 'centre 0';
    if (answer.error) this.showFields();
    else this.show();
    return !answer.error;
  }

  /// Whether it is known what stands where in the text.
  async isRead() {
    if (this.pane.value !== this.known) await this.read();
    return this.pane.value === this.known && !!this.parts;
  }

  /// By the names of their nodes: where each part is, and what table of the file has it.
  partsOf({ tree, boxes, casters, chassis }) {
    const list = (key) => tree.keys[key]?.list || [];
    const parts = { 'centre 0': { kind: 'centre', title: 'centre of mass of the chassis', at: chassis, table: tree.keys.chassis } };
    boxes.forEach((box, i) => (parts[`box ${i}`] = { ...box, kind: 'box', title: `${box.form} ${i + 1}`, table: list('shape')[i], array: 'shape' }));
    casters.forEach((caster, i) => (parts[`caster ${i}`] = { ...caster, kind: 'caster', title: caster.name, table: list('caster')[i], array: 'caster' }));
    for (const id of Object.keys(parts)) if (!parts[id].table) delete parts[id];
    return parts;
  }

  /// Sets a quantity of a part; what the file says of the number goes only where it forbids it.
  async set(id, key, value) {
    if (!(await this.isRead()) || !this.parts[id]) return;
    const [text, table, failed] = [this.known, this.parts[id].table, this.failed];
    const stated = withQuantity(text, table, key, value, false);
    this.pane.value = stated;
    if ((await this.read()) || failed || !table.keys[key]?.keys) return;
    this.pane.value = withQuantity(text, table, key, value, true);
    if (await this.read()) return;
    this.pane.value = stated;
    await this.read();
  }

  /// The last of the wishes that come while the engine is asked.
  wish(...what) {
    this.wished = what;
    this.granting = this.granting || (async () => {
      while (this.wished) {
        const next = this.wished;
        this.wished = null;
        await this.set(...next);
      }
      this.granting = null;
    })();
    return this.granting;
  }

  move(id, at) {
    const { kind, form = kind } = this.parts[id];
    return this.wish(id, kPlaces[form], `[${at.map((value) => +value.toFixed(1)).join(', ')}]`);
  }

  async addPart(kind) {
    if (!(await this.isRead())) return;
    this.pane.value = `${this.known.trimEnd()}\n\n${kNewParts[kind]}`;
    const count = Object.values(this.parts).filter((part) => part.kind === kind).length;
    await this.read();
    this.choose(`${kind} ${count}`);
  }

  async removePart() {
    if (!(await this.isRead())) return;
    const { table, array } = this.parts[this.chosen];
    if (!array) return;
    this.pane.value = withoutElement(this.known, table, array);
    this.chosen = 'centre 0';
    await this.read();
  }

  choose(id) {
    if (!this.parts?.[id]) return;
    if (id !== this.chosen) this.pane.scrollTo(this.parts[id].table.line);
    this.chosen = id;
    document.querySelectorAll('[data-part]').forEach((node) => node.classList.toggle('chosen', node.dataset.part === id));
    this.showFields();
  }

  show() {
    for (const view of Object.keys(kViews)) this.draw(view);
    element('item-facts').replaceChildren(...shownSection(this.answer.facts), ...this.answer.warnings.map((line) => made('p', `Warning: ${line}`)));
    element('item-all').replaceChildren(...shownSection(this.answer.shown));
    this.choose(this.chosen);
  }

  showFields() {
    if (!this.parts[this.chosen]) return;
    const { kind, form = kind, title, table } = this.parts[this.chosen];
    element('item-part').querySelector('legend').textContent = title;
    element('item-numbers').replaceChildren(
      ...kFields[form].filter(([key]) => kind !== 'centre' || table.keys[key]).map(([key, words, unit, count]) => this.field(key, words, unit, count, valueOf(table.keys[key]))),
    );
    element('item-of-caster').hidden = kind !== 'caster';
    element('item-remove').hidden = kind === 'centre';
    if (kind !== 'caster') return;
    showChoice(element('item-type'), valueOf(table.keys.type) || '');
    element('item-brake').checked = !!valueOf(table.keys.brake);
    element('item-swivels').checked = valueOf(table.keys.swivels) !== false;
  }

  field(key, words, unit, count, value) {
    const label = made('div', words, { class: 'field' });
    const numbers = made('span');
    const inputs = Array.from({ length: count }, (_, i) => made('input', undefined, { type: 'number', step: 'any', 'aria-label': `${words.split(' x, y, z')[0]}${count > 1 ? ` ${'xyz'[i]}` : ''}, ${unit}`, value: (count > 1 ? value?.[i] : value) ?? '' }));
    const id = this.chosen;
    for (const input of inputs)
      input.addEventListener('change', () => {
        const all = inputs.map((each) => Number(each.value));
        this.wish(id, key, count > 1 ? `[${all.join(', ')}]` : String(all[0]));
      });
    numbers.append(...inputs, ` ${unit}`);
    label.append(numbers);
    return label;
  }

  draw(view) {
    const svg = element(`item-${view}`);
    const focused = svg.contains(document.activeElement) ? document.activeElement.dataset.part : undefined;
    const [u, v] = kViews[view].axes;
    if (!this.grip) this.frame(svg, u, v);
    const polygon = this.answer.polygon.map((p) => [p[0], v === 1 ? p[1] : 0]);
    const nodes = v === 2 ? [drawn('line', { class: 'floor', x1: -9, x2: 9, y1: 0, y2: 0 })] : [];
    for (const [id, part] of Object.entries(this.parts)) if (part.kind === 'box') nodes.push(this.boxNode(id, part, view, u, v));
    for (const [id, part] of Object.entries(this.parts)) if (part.kind === 'caster') nodes.push(this.casterNode(id, part, view, u, v));
    nodes.push(drawn('polygon', { class: 'support', points: pointsOf(polygon) }), this.centreNode(view, u, v));
    svg.replaceChildren(...nodes);
    if (focused !== undefined) svg.querySelector(`[data-part="${focused}"]`)?.focus({ preventScroll: true });
  }

  frame(svg, u, v) {
    const points = Object.values(this.parts).flatMap(({ at, size = [0, 0, 0] }) => [at.map((value, i) => value - size[i] / 2), at.map((value, i) => value + size[i] / 2)]);
    if (v === 2) points.push([0, 0, 0]);
    const [left, right] = [Math.min(...points.map((p) => p[u])) - 0.15, Math.max(...points.map((p) => p[u])) + 0.15];
    const [low, high] = [Math.min(...points.map((p) => p[v])) - 0.12, Math.max(...points.map((p) => p[v])) + 0.12];
    svg.setAttribute('viewBox', `${left} ${-high} ${right - left} ${high - low}`);
    this.scale = Math.max(right - left, high - low);
  }

  node(id, part, view, ...children) {
    const keys = view === 'plan' ? 'arrows move it' : part.kind === 'caster' ? 'left and right move it' : 'arrows move it forward, back, up and down';
    const node = drawn('g', { class: `part ${part.kind}${id === this.chosen ? ' chosen' : ''}`, tabindex: 0, role: 'button', 'data-part': id, 'aria-label': `${part.title}, ${kViews[view].name}: ${keys}` }, ...children);
    node.append(drawn('title', {}, part.title));
    return node;
  }

  boxNode(id, part, view, u, v) {
    const { at, size } = part;
    return this.node(id, part, view, drawn('rect', { x: at[u] - size[u] / 2, y: -at[v] - size[v] / 2, width: size[u], height: size[v] }));
  }

  casterNode(id, part, view, u, v) {
    const { at, heading, trail, radius, width } = part;
    const turned = [Math.cos(heading), Math.sin(heading)];
    const wheel = [at[0] - trail * turned[0], at[1] - trail * turned[1], radius];
    const shape = v === 2
      ? drawn('circle', { class: 'wheel', cx: wheel[0], cy: -radius, r: radius })
      : drawn('rect', { class: 'wheel', x: -radius, y: -width / 2, width: 2 * radius, height: width, transform: `translate(${wheel[0]} ${-wheel[1]}) rotate(${-degrees(heading)})` });
    if (part.braked) shape.classList.add('braked');
    return this.node(id, part, view, shape, drawn('line', { class: 'fork', x1: at[u], y1: -at[v], x2: wheel[u], y2: -wheel[v] }), drawn('circle', { class: 'mount', cx: at[u], cy: -at[v], r: 0.018 * this.scale }));
  }

  /// The chassis' centre of mass, which is dragged, and that of all, which decides when it tips.
  centreNode(view, u, v) {
    const part = this.parts['centre 0'];
    const [x, y] = [part.at[u], -part.at[v]];
    const r = 0.022 * this.scale;
    const { whole } = this.answer;
    const all = drawn('circle', { class: 'whole', cx: whole[u], cy: -whole[v], r: r / 2.5 }, drawn('title', {}, 'centre of mass of all'));
    const down = drawn('line', { class: 'down', x1: whole[u], x2: whole[u], y1: -whole[v], y2: v === 2 ? 0 : -whole[v] });
    return this.node('centre 0', part, view, down, drawn('circle', { class: 'target', cx: x, cy: y, r }), drawn('path', { class: 'cross', d: `M ${x - r} ${y} H ${x + r} M ${x} ${y - r} V ${y + r}` }), all);
  }

  connectDrawing(view) {
    const svg = element(`item-${view}`);
    const { axes } = kViews[view];
    const here = (event) => {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      return [p.x, -p.y];
    };
    /// Casters all meet the base plate at its height.
    const moved = (id, from, by) => {
      const at = [...from];
      axes.forEach((axis, i) => {
        if (axis !== 2 || this.parts[id].kind !== 'caster') at[axis] += by[i];
      });
      return at;
    };
    const placeOf = (id) => valueOf(this.parts[id].table.keys[kPlaces[this.parts[id].form || this.parts[id].kind]]) || [0, 0, 0];
    svg.addEventListener('pointerdown', (event) => {
      const id = event.target.closest('[data-part]')?.dataset.part;
      if (!id) return;
      svg.setPointerCapture(event.pointerId);
      this.choose(id);
      this.grip = { id, from: placeOf(id), start: here(event) };
    });
    svg.addEventListener('pointermove', (event) => {
      if (!this.grip) return;
      const { id, from, start } = this.grip;
      const by = here(event).map((value, i) => rounded(1000 * (value - start[i]), 5));
      const at = moved(id, from, by);
      if (String(at) !== String(this.grip.at)) this.move(id, (this.grip.at = at));
    });
    const stop = async () => {
      if (!this.grip) return;
      await this.granting;
      this.grip = null;
      if (this.answer) this.show();
    };
    svg.addEventListener('pointerup', stop);
    svg.addEventListener('pointercancel', stop);
    svg.addEventListener('focusin', (event) => event.target.dataset.part && this.choose(event.target.dataset.part));
    svg.addEventListener('keydown', (event) => {
      const id = event.target.dataset.part;
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!id || !step) return;
      event.preventDefault();
      this.keyed(id, (from) => moved(id, from, step.map((value) => value * (event.shiftKey ? 50 : 5))), placeOf);
    });
  }

  /// Steps with keys add up while the engine answers.
  async keyed(id, next, placeOf) {
    this.steps = (this.steps || Promise.resolve()).then(() => this.move(id, next(placeOf(id))));
    return this.steps;
  }
}
