// The motion of the floor over time, with the time shown as a line.

const kGraphLeft = 62;
const kGraphRight = 14;
const kAxisColors = [['x', '#0072B2', '#5cb3e8'], ['y', '#D55E00', '#ff8b3d'], ['z', '#7a7a7a', '#9a9a9a']];

class Graph {
  constructor(canvas, run, end) {
    this.canvas = canvas;
    this.run = run;
    this.end = end;
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
    const half = (this.height - 18) / 2;
    if (this.run.floorMoves) {
      this.panel(pen, 2, half - 6, this.run.floorAcceleration, 'm/s²', this.named('floor acceleration'));
      this.panel(pen, half + 4, half - 6, this.run.floorDisplacement.map((v) => v.map((d) => 1000 * d)), 'mm', this.named('floor displacement'));
    } else {
      pen.fillStyle = this.ink;
      pen.fillText('The floor is at rest, or the file does not hold its motion.', kGraphLeft + 6, half);
    }
    this.timeAxis(pen);
  }

  /// Of several runs the graph has the motion of one.
  named(text) {
    return this.run.name ? `${text}, ${this.run.name}` : text;
  }

  panel(pen, top, height, curves, units, name) {
    const largest = Math.max(1e-9, ...curves.map((values) => values.reduce((m, v) => Math.max(m, Math.abs(v)), 0)));
    const y = (v) => top + height / 2 - (v / largest) * (height / 2 - 2);
    pen.strokeStyle = this.dark ? '#3a414d' : '#d4d8de';
    pen.lineWidth = 1;
    pen.strokeRect(kGraphLeft, top, this.width - kGraphLeft - kGraphRight, height);
    pen.beginPath();
    pen.moveTo(kGraphLeft, y(0));
    pen.lineTo(this.width - kGraphRight, y(0));
    pen.stroke();
    curves.forEach((values, axis) => this.curve(pen, values, y, kAxisColors[axis][this.dark ? 2 : 1]));
    pen.fillStyle = this.ink;
    const tick = roundBelow(largest);
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    for (const v of [tick, 0, -tick]) pen.fillText(`${v === 0 ? '0 ' + units : v}`, kGraphLeft - 5, y(v));
    pen.textAlign = 'left';
    // The words have a plate of their own, or the curves would run through them.
    pen.globalAlpha = 0.85;
    pen.fillStyle = this.dark ? '#1c2027' : '#ffffff';
    pen.fillRect(kGraphLeft + 2, top + 2, pen.measureText(name).width + 14 * kAxisColors.length + 10, 15);
    pen.globalAlpha = 1;
    pen.fillStyle = this.ink;
    pen.fillText(name, kGraphLeft + 6, top + 9);
    let x = kGraphLeft + 14 + pen.measureText(name).width;
    for (const [letter, light, dark] of kAxisColors) {
      pen.fillStyle = this.dark ? dark : light;
      pen.fillText(letter, x, top + 9);
      x += 14;
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
