// The plan: items are dragged, or moved with the arrow keys and turned with Q and E.

const kSvg = 'http://www.w3.org/2000/svg';

function drawn(name, attributes, ...children) {
  const node = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

const rounded = (value, step) => +(Math.round(value / step) * step).toFixed(3);
const pointsOf = (corners) => corners.map(([x, y]) => `${x},${-y}`).join(' ');

class Plan {
  /// @param moved  (index, [x, y], yaw in degrees): called when an item has another place
  constructor(svg, moved, chosen) {
    this.svg = svg;
    this.moved = moved;
    this.chosen = chosen;
  }

  draw(plan) {
    const focused = this.svg.contains(document.activeElement) ? document.activeElement.dataset.item : undefined;
    this.svg.replaceChildren();
    this.frame(plan);
    for (const shape of plan.room) this.svg.append(drawn('polygon', { class: 'wall', points: pointsOf(shape.corners) }, drawn('title', {}, shape.name)));
    plan.items.forEach((item, i) => this.svg.append(this.item(item, i)));
    if (focused !== undefined) this.svg.querySelector(`[data-item="${focused}"]`)?.focus();
  }

  frame({ items, room }) {
    const xs = [];
    const ys = [];
    for (const shape of room) for (const [x, y] of shape.corners) { xs.push(x); ys.push(y); }
    for (const item of items) { xs.push(item.at[0] - 0.8, item.at[0] + 0.8); ys.push(item.at[1] - 0.8, item.at[1] + 0.8); }
    const [left, right] = [Math.min(...xs) - 0.2, Math.max(...xs) + 0.2];
    const [low, high] = [Math.min(...ys) - 0.2, Math.max(...ys) + 0.2];
    this.svg.setAttribute('viewBox', `${left} ${-high} ${right - left} ${high - low}`);
    for (let x = Math.ceil(left); x < right; ++x) this.svg.append(drawn('line', { class: 'grid', x1: x, x2: x, y1: -low, y2: -high }));
    for (let y = Math.ceil(low); y < high; ++y) this.svg.append(drawn('line', { class: 'grid', y1: -y, y2: -y, x1: left, x2: right }));
  }

  item(item, i) {
    const turn = (-item.yaw * 180) / Math.PI;
    const node = drawn('g', { class: 'item', tabindex: 0, role: 'button', 'data-item': i, 'aria-label': `${item.name}: arrows move it, Q and E turn it` });
    const place = (at, angle) => node.setAttribute('transform', `translate(${at[0]} ${-at[1]}) rotate(${angle})`);
    place(item.at, turn);
    for (const box of item.boxes) node.append(drawn('polygon', { points: pointsOf(box) }));
    for (const wheel of item.wheels) node.append(drawn('circle', { class: wheel.braked ? 'wheel braked' : 'wheel', cx: wheel.at[0], cy: -wheel.at[1], r: 0.035 }));
    const front = Math.max(...item.boxes.flat().map(([x]) => x));
    node.append(drawn('path', { class: 'front', d: `M ${front - 0.12} -0.08 L ${front - 0.02} 0 L ${front - 0.12} 0.08` }));
    node.append(drawn('text', { transform: `rotate(${-turn})`, y: 0.05 }, item.name));
    this.connect(node, item, i, (at) => place(at, turn));
    return node;
  }

  connect(node, item, i, place) {
    const metres = (event) => {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      return [p.x, -p.y];
    };
    let grip = null;
    let at = item.at;
    node.addEventListener('pointerdown', (event) => {
      node.setPointerCapture(event.pointerId);
      const [x, y] = metres(event);
      grip = [x - item.at[0], y - item.at[1]];
      this.chosen(i);
    });
    node.addEventListener('pointermove', (event) => {
      if (!grip) return;
      const [x, y] = metres(event);
      at = [rounded(x - grip[0], 0.05), rounded(y - grip[1], 0.05)];
      place(at);
    });
    node.addEventListener('pointerup', () => {
      if (grip && at !== item.at) this.moved(i, at, null);
      grip = null;
    });
    node.addEventListener('keydown', (event) => {
      const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const turns = { q: 15, e: -15 };
      const size = event.shiftKey ? 0.5 : 0.05;
      const step = steps[event.key];
      const turn = turns[event.key.toLowerCase()];
      if (!step && !turn) return;
      event.preventDefault();
      if (step) this.moved(i, [rounded(item.at[0] + size * step[0], 0.05), rounded(item.at[1] + size * step[1], 0.05)], null);
      else this.moved(i, null, rounded((item.yaw * 180) / Math.PI + turn, 1));
    });
    node.addEventListener('focus', () => this.chosen(i));
  }
}
