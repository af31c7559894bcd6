// Lists and tables beside the view. All texts of the file are set as text, never as HTML.

const element = (id) => document.getElementById(id);

function made(name, text, attributes = {}) {
  const node = document.createElement(name);
  if (text !== undefined) node.textContent = text;
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  return node;
}

const cssColor = (c) => `rgb(${c.map((v) => Math.round(255 * v)).join(' ')})`;

const kEventColors = { 'lift-off': '#E69F00', impact: '#D55E00', taut: '#56B4E9', unplugged: '#c0392b', released: '#0072B2', fell: '#b00020', toppled: '#b00020', zone: '#b8860b', overturned: '#b00020', displacement: '#009E73', tilt: '#CC79A7' };

/// More of them hide what else happened; a click on their button shows them.
const kMaxLiftOffs = 30;

class EventList {
  constructor(runs, end, go) {
    this.events = runs
      .flatMap((run) => run.events.map((event) => ({ ...event, run: run.name })))
      .sort((a, b) => a.time - b.time);
    this.hidden = new Set();
    this.end = end;
    for (const event of this.events) this.add(event, go);
    for (const kind of new Set(this.events.map((event) => event.kind))) this.addKind(kind);
    if (this.events.length === 0) element('events').append(made('li', 'Nothing lifted, hit, unplugged or overturned.'));
  }

  add(event, go) {
    const color = kEventColors[event.kind] || '#888888';
    const who = [event.run, event.item].filter(Boolean).join(', ');
    const text = `${event.time.toFixed(2)} s  ${who ? who + ': ' : ''}${event.text}`;
    event.row = made('li');
    const button = made('button', text, { 'data-kind': event.kind, 'data-time': event.time });
    button.style.borderLeftColor = color;
    button.addEventListener('click', () => go(event.time));
    event.row.append(button);
    element('events').append(event.row);
    event.mark = made('span', undefined, { title: text, class: 'mark' });
    event.mark.style.background = color;
    event.mark.style.left = `calc(${kGraphLeft}px + (100% - ${kGraphLeft + kGraphRight}px) * ${event.time / this.end})`;
    event.mark.addEventListener('click', () => go(event.time));
    element('marks').append(event.mark);
  }

  addKind(kind) {
    const count = this.events.filter((event) => event.kind === kind).length;
    const button = made('button', `${kind} ${count}`);
    button.style.borderBottomColor = kEventColors[kind] || '#888888';
    const show = (shown) => {
      if (shown) this.hidden.delete(kind);
      else this.hidden.add(kind);
      button.setAttribute('aria-pressed', String(shown));
      for (const event of this.events) if (event.kind === kind) event.row.hidden = event.mark.hidden = !shown;
    };
    button.addEventListener('click', () => show(this.hidden.has(kind)));
    show(kind !== 'lift-off' || count <= kMaxLiftOffs);
    element('kinds').append(button);
  }

  shown() {
    return this.events.filter((event) => !this.hidden.has(event.kind));
  }

  next(time) {
    return this.shown().find((event) => event.time > time + 1e-6);
  }

  previous(time) {
    return this.shown().findLast((event) => event.time < time - 1e-6);
  }

  draw(time) {
    let last = null;
    for (const event of this.events) if (event.time <= time + 1e-9 && !event.row.hidden) last = event;
    if (last === this.current) return;
    if (this.current) this.current.row.removeAttribute('aria-current');
    this.current = last;
    if (!last) return;
    last.row.setAttribute('aria-current', 'true');
    const list = element('events');
    list.scrollTop = Math.max(0, last.row.offsetTop - list.offsetTop - list.clientHeight / 2);
  }
}

/// Displacement, yaw and tilt of every item at the time that is shown.
class ItemTable {
  constructor(runs, colors) {
    this.rows = [];
    const body = element('items').tBodies[0];
    for (const run of runs)
      run.items.forEach((item, i) => {
        const name = [run.name, item.name].filter(Boolean).join(', ');
        const row = made('tr', undefined, { 'data-item': item.name });
        const head = made('th', name, { scope: 'row', title: item.model });
        head.style.borderLeftColor = cssColor(colors[i]);
        const cells = ['x', 'y', 'yaw', 'tilt'].map((key) => made('td', '', { 'data-value': key }));
        row.append(head, ...cells);
        body.append(row);
        this.rows.push({ run, item, cells });
      });
  }

  draw(time) {
    for (const { run, item, cells } of this.rows) {
      const motion = motionOf(item, run.at(time));
      const values = [1000 * motion.displacement[0], 1000 * motion.displacement[1], (motion.yaw * 180) / Math.PI, (motion.tilt * 180) / Math.PI];
      cells.forEach((cell, i) => (cell.textContent = values[i].toFixed(1).replace(/^-0\.0$/, '0.0')));
    }
  }
}

function makeLegend(ghosts) {
  for (const mode of kModes.slice(0, kLifted)) {
    const entry = made('li', mode.name, mode.shape ? { class: mode.shape } : {});
    entry.style.setProperty('--swatch', cssColor(mode.color));
    element('legend').append(entry);
  }
  element('legend').append(made('li', 'area: normal force; arrow: horizontal force', { class: 'plain' }));
  if (ghosts) element('legend').append(made('li', 'translucent: other runs; red: overturned', { class: 'plain' }));
}

/// Check boxes for what is drawn; `shown` is changed by them.
function makeSwitches(shown, changed) {
  const texts = { room: 'room', zones: 'zones', forces: 'forces', tracks: 'wheel tracks', paths: 'paths', tethers: 'cords and hoses', labels: 'names and metres', ghosts: 'ghosts' };
  for (const [key, text] of Object.entries(texts)) {
    if (!(key in shown)) continue;
    const box = made('input', undefined, { type: 'checkbox', id: `show-${key}` });
    box.checked = shown[key];
    box.addEventListener('change', () => {
      shown[key] = box.checked;
      changed();
    });
    const label = made('label');
    label.append(box, made('span', text));
    element('shown').append(label);
  }
}

/// Texts over the view, made once and moved.
class Labels {
  constructor() {
    this.nodes = [];
  }

  draw(labels) {
    while (this.nodes.length < labels.length) {
      const node = made('span');
      element('labels').append(node);
      this.nodes.push(node);
    }
    this.nodes.forEach((node, i) => {
      const label = labels[i];
      node.hidden = !label;
      if (!label) return;
      if (node.textContent !== label.text) node.textContent = label.text;
      node.className = label.kind;
      node.style.transform = `translate(${label.left}px, ${label.top}px) translate(-50%, -50%)`;
      node.style.borderColor = label.color ? cssColor(label.color) : '';
    });
  }
}
