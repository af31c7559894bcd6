// A camera that looks at a target: dragged with the mouse, one finger or two.

class Camera {
  constructor(canvas, changed) {
    this.changed = changed;
    this.pointers = new Map();
    this.home = { target: [0, 0, 0.5], distance: 6 };
    this.reset();
    canvas.addEventListener('pointerdown', (event) => this.press(canvas, event));
    canvas.addEventListener('pointermove', (event) => this.drag(canvas, event));
    for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(0.0012 * event.deltaY));
    }, { passive: false });
  }

  reset() {
    this.target = [...this.home.target];
    this.distance = this.home.distance;
    this.azimuth = -0.95;
    this.elevation = 0.5;
    this.changed();
  }

  lookFromAbove() {
    this.reset();
    this.azimuth = -Math.PI / 2;
    this.elevation = Math.PI / 2;
    this.changed();
  }

  press(canvas, event) {
    canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  drag(canvas, event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    if (this.pointers.size > 1) this.pinch(canvas, event.pointerId, before, now);
    else if (event.buttons === 1 && !event.shiftKey) this.orbit(now[0] - before[0], now[1] - before[1]);
    else this.pan(canvas, now[0] - before[0], now[1] - before[1]);
    this.pointers.set(event.pointerId, now);
  }

  orbit(dx, dy) {
    this.azimuth -= 0.008 * dx;
    this.elevation = Math.min(Math.PI / 2, Math.max(0.02, this.elevation + 0.008 * dy));
    this.changed();
  }

  pan(canvas, dx, dy) {
    const scale = (0.83 * this.distance) / canvas.clientHeight;
    const right = [-Math.sin(this.azimuth), Math.cos(this.azimuth), 0];
    const away = [-Math.cos(this.azimuth), -Math.sin(this.azimuth), 0];
    this.target = add(this.target, add(scaled(right, -dx * scale), scaled(away, dy * scale)));
    this.changed();
  }

  pinch(canvas, id, before, now) {
    const [other] = [...this.pointers].filter(([key]) => key !== id).map(([, place]) => place);
    const length = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]) || 1;
    this.zoom(length(before) / length(now));
    this.pan(canvas, (now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
  }

  zoom(factor) {
    this.distance = Math.min(200, Math.max(0.3, this.distance * factor));
    this.changed();
  }

  /// Matrix and place of the eye; the target may be moved by an offset.
  view(aspect, offset) {
    const target = add(this.target, offset);
    const flat = Math.cos(this.elevation);
    const toEye = [flat * Math.cos(this.azimuth), flat * Math.sin(this.azimuth), Math.sin(this.elevation)];
    const eye = add(target, scaled(toEye, this.distance));
    const up = this.elevation > 1.55 ? [-Math.cos(this.azimuth), -Math.sin(this.azimuth), 0] : [0, 0, 1];
    const angle = aspect < 1 ? 2 * Math.atan(Math.tan(0.39) / aspect) : 0.78;
    const lens = perspective(angle, aspect, 0.02 * this.distance, 20 * this.distance + 60);
    return { camera: multiplied(lens, lookAt(eye, target, up)), eye };
  }
}
