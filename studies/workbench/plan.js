// The plan: items are dragged, or moved with the arrow keys and turned with Q and E.

const kSvg = 'http://www.w3.org/2000/svg';

function drawn(name, attributes, ...children) {
  const node = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

const rounded = (value, step) => +(Math.round(value / step) * step).toFixed(3);
const degrees = (angle) => (angle * 180) / Math.PI;
const pointsOf = (corners) => corners.map(([x, y]) => `${x},${-y}`).join(' ');

class Plan {
  /// @param moved  (index, [x, y], yaw in degrees): called when an item has another place
  constructor(svg, moved, chosen) {
    this.svg = svg;
    this.moved = moved;
    this.chosen = chosen;
  }

  draw(plan) {
    if (this.grip) return;  // the change that its drag ends with draws it again
    const focused = this.svg.contains(document.activeElement) ? document.activeElement.dataset.item : undefined;
    this.svg.replaceChildren();
    this.frame(plan);
    for (const shape of plan.room) this.svg.append(drawn('polygon', { class: 'wall', points: pointsOf(shape.corners) }, drawn('title', {}, shape.name)));
    plan.items.forEach((item, i) => this.svg.append(this.item(item, i)));
    for (const { name, from, to } of plan.tethers)
      this.svg.append(drawn('line', { class: 'tether', x1: from[0], y1: -from[1], x2: to[0], y2: -to[1] }, drawn('title', {}, name)));
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
    const node = drawn('g', { class: 'item', tabindex: 0, role: 'button', 'data-item': i, 'aria-label': `${item.name}: arrows move it, Q and E turn it` });
    for (const box of item.boxes) node.append(drawn('polygon', { points: pointsOf(box) }));
    for (const wheel of item.wheels) node.append(drawn('circle', { class: wheel.braked ? 'wheel braked' : 'wheel', cx: wheel.at[0], cy: -wheel.at[1], r: 0.035 }));
    const front = Math.max(...item.boxes.flat().map(([x]) => x));
    node.append(drawn('path', { class: 'front', d: `M ${front - 0.12} -0.08 L ${front - 0.02} 0 L ${front - 0.12} 0.08` }));
    const name = drawn('text', { y: 0.05 }, item.name);
    node.append(name);
    const place = () => {
      node.setAttribute('transform', `translate(${item.at[0]} ${-item.at[1]}) rotate(${-degrees(item.yaw)})`);
      name.setAttribute('transform', `rotate(${degrees(item.yaw)})`);
    };
    place();
    this.connectPointer(node, item, i, place);
    this.connectKeys(node, item, i, place);
    return node;
  }

  connectPointer(node, item, i, place) {
    const metres = (event) => {
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      return [p.x, -p.y];
    };
    let from;
    const stop = () => {
      if (this.grip && from !== item.at) this.moved(i, item.at, null);
      this.grip = null;
    };
    node.addEventListener('pointerdown', (event) => {
      node.setPointerCapture(event.pointerId);
      const [x, y] = metres(event);
      from = item.at;
      this.grip = [x - item.at[0], y - item.at[1]];
      this.chosen(i);
    });
    node.addEventListener('pointermove', (event) => {
      if (!this.grip) return;
      const [x, y] = metres(event);
      item.at = [rounded(x - this.grip[0], 0.05), rounded(y - this.grip[1], 0.05)];
      place();
    });
    node.addEventListener('pointerup', stop);
    node.addEventListener('pointercancel', stop);
  }

  connectKeys(node, item, i, place) {
    node.addEventListener('keydown', (event) => {
      const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const turns = { q: 15, e: -15 };
      const size = event.shiftKey ? 0.5 : 0.05;
      const step = steps[event.key];
      const turn = turns[event.key.toLowerCase()];
      if (!step && !turn) return;
      event.preventDefault();
      if (step) item.at = [rounded(item.at[0] + size * step[0], 0.05), rounded(item.at[1] + size * step[1], 0.05)];
      else item.yaw += (turn * Math.PI) / 180;
      place();
      if (step) this.moved(i, item.at, null);
      else this.moved(i, null, rounded(degrees(item.yaw), 1));
    });
    node.addEventListener('focus', () => this.chosen(i));
  }
}
