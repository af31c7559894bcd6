// The motion of the floor and of the items over time, with the time shown as a line.

const kGraphLeft = 62;
const kGraphRight = 14;
const kAxisColors = [['x', '#0072B2', '#5cb3e8'], ['y', '#D55E00', '#ff8b3d'], ['z', '#7a7a7a', '#9a9a9a']];

class Graph {
  /// @param colors  of the items
  constructor(canvas, run, end, colors) {
    this.canvas = canvas;
    this.run = run;
    this.end = end;
    this.colors = colors.map(cssColor);
    this.still = document.createElement('canvas');
  }

  x(time) {
    return kGraphLeft + (this.width - kGraphLeft - kGraphRight) * (time / this.end);
  }

  /// Draws everything but the line of the time; to be called again for another size or theme.
  lay(dark) {
    const scale = window.devicePixelRatio || 1;
    this.width = this.canvas.clientWidth;
    this.height = this.canvas.clientHeight;
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = this.width * scale;
      canvas.height = this.height * scale;
    }
    this.dark = dark;
    this.ink = dark ? '#c9ced6' : '#333b47';
    const pen = this.still.getContext('2d');
    pen.scale(scale, scale);
    pen.font = '11px system-ui, sans-serif';
    const panels = this.panels();
    const height = (this.height - 18) / panels.length;
    panels.forEach((panel, i) => this.panel(pen, 2 + i * height, height - 5, panel));
    this.timeAxis(pen);
  }

  /// Of several runs the graph has the motion of one.
  named(text) {
    return this.run.name ? `${text}, ${this.run.name}` : text;
  }

  panels() {
    const axes = (vector, factor) => vector.map((values, axis) => ({
      values: values.map((v) => factor * v), name: kAxisColors[axis][0], color: kAxisColors[axis][this.dark ? 2 : 1] }));
    const items = (of) => this.run.items.map((item, i) => ({ values: of(item), name: item.name, color: this.colors[i] }));
    const floor = !this.run.floorMoves ? [] : [
      { name: 'floor acceleration', units: 'm/s²', curves: axes(this.run.floorAcceleration, 1) },
      { name: 'floor displacement', units: 'mm', curves: axes(this.run.floorDisplacement, 1000) }];
    return floor.concat([
      { name: 'distance from the start', units: 'mm', positive: true, curves: items((item) => distanceOf(item).map((d) => 1000 * d)) },
      { name: 'tilt', units: 'deg', positive: true, curves: items((item) => tiltOf(item).map((a) => (a * 180) / Math.PI)) }]);
  }

  /// The names are above the curves, where there is room for both.
  panel(pen, above, whole, { name, units, curves, positive }) {
    const strip = whole < 40 ? 0 : 15;
    const top = above + strip, height = whole - strip;
    const largest = Math.max(1e-9, ...curves.map(({ values }) => values.reduce((m, v) => Math.max(m, Math.abs(v)), 0)));
    const zero = positive ? top + height - 2 : top + height / 2;
    const y = (v) => zero - (v / largest) * (positive ? height - 4 : height / 2 - 2);
    pen.strokeStyle = this.dark ? '#3a414d' : '#d4d8de';
    pen.lineWidth = 1;
    pen.strokeRect(kGraphLeft, top, this.width - kGraphLeft - kGraphRight, height);
    pen.beginPath();
    pen.moveTo(kGraphLeft, y(0));
    pen.lineTo(this.width - kGraphRight, y(0));
    pen.stroke();
    for (const { values, color } of curves) this.curve(pen, values, y, color);
    pen.fillStyle = this.ink;
    const tick = roundBelow(largest);
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    const apart = (y(0) - y(tick)) / 12;  // in lines of text
    const signs = positive || apart < 0.5 ? [1] : [1, -1];
    const shown = largest <= 1e-6 ? [0] : signs.map((sign) => sign * tick).concat(apart < 1 ? [] : [0]);
    for (const v of shown) pen.fillText(`${v}${v === 0 || (v > 0 && apart < 1) ? ' ' + units : ''}`, kGraphLeft - 5, y(v));
    this.words(pen, above - (strip > 0 ? 2 : 0), this.named(name), curves);
  }

  /// The words have a plate of their own, or the curves would run through them. Names that do not fit are
  /// left out; the table beside has their colours.
  words(pen, top, name, curves) {
    pen.textAlign = 'left';
    const words = [{ text: name, color: this.ink }];
    let width = pen.measureText(name).width + 10;
    for (const curve of this.width < 500 && curves.length > 3 ? [] : curves) {
      width += pen.measureText(curve.name).width + 8;
      if (width > this.width - kGraphLeft - kGraphRight - 10) break;
      words.push({ text: curve.name, color: curve.color });
    }
    let x = kGraphLeft + 6;
    pen.globalAlpha = 0.85;
    pen.fillStyle = this.dark ? '#1c2027' : '#ffffff';
    pen.fillRect(x - 4, top + 2, words.reduce((sum, { text }) => sum + pen.measureText(text).width + 8, 2), 15);
    pen.globalAlpha = 1;
    for (const { text, color } of words) {
      pen.fillStyle = color;
      pen.fillText(text, x, top + 9);
      x += pen.measureText(text).width + 8;
    }
  }

  curve(pen, values, y, color) {
    pen.strokeStyle = color;
    pen.lineWidth = 1;
    pen.beginPath();
    values.forEach((v, i) => {
      const x = this.x(this.run.time[i]);
      if (i === 0) pen.moveTo(x, y(v));
      else pen.lineTo(x, y(v));
    });
    pen.stroke();
  }

  timeAxis(pen) {
    const step = roundBelow(this.end / 6);
    pen.fillStyle = this.ink;
    pen.textAlign = 'center';
    pen.textBaseline = 'alphabetic';
    for (let t = 0; t <= this.end * 0.97; t += step) pen.fillText(`${+t.toFixed(3)}${t === 0 ? ' s' : ''}`, this.x(t), this.height - 3);
  }

  draw(time) {
    if (!this.width) return;  // in a frame that is hidden
    const pen = this.canvas.getContext('2d');
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.drawImage(this.still, 0, 0);
    const scale = this.canvas.width / this.width;
    pen.fillStyle = this.dark ? '#ffd24a' : '#c02020';
    pen.fillRect(this.x(time) * scale - 0.75 * scale, 0, 1.5 * scale, (this.height - 14) * scale);
  }
}

/// 1, 2 or 5 times a power of ten, not above v.
function roundBelow(v) {
  const power = 10 ** Math.floor(Math.log10(v));
  const digit = [5, 2, 1].find((d) => d * power <= v * (1 + 1e-9)) || 1;
  return +(digit * power).toPrecision(1);
}
