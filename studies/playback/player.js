// The page: what time it is, how the view looks, and what keys and buttons do.

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4, 10];
const kSun = unit([0.35, -0.62, 1.05]);

class Player {
  constructor(data) {
    this.runs = data.runs.map((raw) => new Recording(raw));
    this.ghosts = data.ghosts ? data.ghosts.runs.map((raw) => new Recording(raw)) : [];
    this.end = Math.max(...this.runs.concat(this.ghosts).map((run) => run.end));
    this.time = 0;
    this.speed = 1;
    this.playing = false;
    this.dirty = true;
    this.frame = 'room';
    this.mode = 'orbit';
    this.shown = { room: true, zones: true, forces: true, tracks: true, paths: true, tethers: true, labels: true };
    if (this.ghosts.length) this.shown.ghosts = true;
    this.describe(data);
    this.startGraphics();
    this.dark = window.matchMedia('(prefers-color-scheme: dark)').matches;
    const colors = this.runs[0].items.map((_, i) => kPalette[i % kPalette.length]);
    this.events = new EventList(this.runs, this.end, (time) => this.go(time));
    this.table = new ItemTable(this.runs, colors);
    this.graph = new Graph(element('graph'), this.runs.reduce((a, b) => (b.end > a.end ? b : a)), this.end, colors);
    this.labels = new Labels();
    makeLegend(this.ghosts.length > 0);
    makeSwitches(this.shown, () => this.redraw());
    this.saving = new Saving(this);
    this.connect();
    this.readLink();
    this.applyTheme();
    this.draw();
    window.requestAnimationFrame((now) => this.tick(now));
  }

  describe(data) {
    element('title').textContent = data.title || 'Playback';
    document.title = `${data.title || 'Playback'} – Gurney`;
    const run = this.runs[0];
    const parts = [this.runs.length === 1 ? run.outcome.replace('_', ' ') : this.runs.map((each) => `${each.name}: ${each.outcome.replace('_', ' ')}`).join(' | ')];
    if (run.record) parts.unshift(`floor motion ${run.record}`);
    parts.push(`${this.end.toFixed(2)} s, ${run.time.length} samples${data.stride > 1 ? `, one of ${data.stride} of the file` : ''}`);
    if (data.ghosts) parts.push(this.ghostText(data.ghosts));
    element('subtitle').textContent = parts.join(' · ');
  }

  ghostText({ stride, position_error, angle_error }) {
    const which = stride > 1 ? `one sample of ${stride}, ` : '';
    const angle = (angle_error * 180) / Math.PI;
    return `${this.ghosts.length} other runs as ghosts (${which}off by at most ${(1000 * position_error).toPrecision(2)} mm, ${angle.toPrecision(2)} deg)`;
  }

  /// Of all runs, ghosts or not.
  overturnedText() {
    const all = this.runs.concat(this.ghosts);
    const until = (time) => all.filter((run) => run.overturned <= time + 1e-9 && Number.isFinite(run.overturned)).length;
    return `Overturned: ${until(this.time)} of ${all.length} runs by now, ${until(Infinity)} in the end`;
  }

  startGraphics() {
    try {
      this.renderer = new Renderer(element('view'));
    } catch (error) {
      this.renderer = null;
      element('trouble').hidden = false;
      element('trouble').textContent = `This browser draws no three-dimensional view (${error.message}). Table, events and time line work without it.`;
    }
    this.camera = new Camera(element('view'), () => this.redraw());
    if (!this.renderer) return;
    this.scenes = this.runs.map((run) => new RoomScene(this.renderer, run, this.ghosts));
    this.camera.home = this.home(this.scenes[0].extent);
    this.camera.reset();
  }

  /// A view of the items and their paths, with as much of the room as lies around them.
  home(room) {
    const size = ({ low, high }) => Math.max(high[0] - low[0], high[1] - low[1], 1.2);
    const middle = ({ low, high }) => scaled(add(low, high), 0.5);
    const target = middle(room.items);
    const whole = 0.75 * size(room) + 0.65 * size(room.items) + 0.4;
    const round = 1.1 * norm(subtract(room.items.high, room.items.low)) / 2 / Math.sin(0.39);  // all of them, below the buttons
    return {
      target: [target[0], target[1], Math.max(0.45, target[2])],
      distance: Math.max(round, Math.min(whole, 1.25 * size(room.items) + 1.2)),
    };
  }

  connect() {
    const click = (id, act) => element(id).addEventListener('click', act);
    click('play', () => this.toggle());
    click('next', () => this.step(this.events.next(this.time)));
    click('previous', () => this.step(this.events.previous(this.time)));
    click('orbit', () => this.setMode('orbit'));
    click('top', () => this.setMode('top'));
    click('follow', () => this.setMode('follow'));
    click('ground', () => this.setFrame(this.frame === 'room' ? 'ground' : 'room'));
    click('full', () => this.fullScreen());
    element('full').hidden = !document.fullscreenEnabled;
    click('theme', () => { this.dark = !this.dark; this.applyTheme(); });
    for (const speed of kSpeeds) element('speed').append(made('option', `${speed}x`, { value: speed }));
    element('speed').addEventListener('change', () => { this.speed = Number(element('speed').value); });
    this.runs[0].items.forEach((item, i) => element('followed').append(made('option', item.name, { value: i })));
    element('followed').addEventListener('change', () => this.setMode('follow'));
    element('ground').hidden = !this.runs.some((run) => run.floorMoves);
    element('scrub').max = this.end;
    element('scrub').addEventListener('input', () => this.go(Number(element('scrub').value)));
    this.connectGraph();
    document.addEventListener('keydown', (event) => this.key(event));
    window.addEventListener('resize', () => this.applyTheme());
    window.addEventListener('hashchange', () => this.readLink());
  }

  connectGraph() {
    const graph = element('graph');
    const seek = (event) => {
      if (event.buttons !== 1) return;
      const width = graph.clientWidth - kGraphLeft - kGraphRight;
      this.go(((event.offsetX - kGraphLeft) / width) * this.end);
    };
    graph.addEventListener('pointerdown', seek);
    graph.addEventListener('pointermove', seek);
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === 'SELECT') return;
    if (event.key === ' ' && event.target.tagName === 'BUTTON') return;
    const small = event.shiftKey ? 1 : 0.1;
    const speed = (by) => this.setSpeed(kSpeeds[Math.min(kSpeeds.length - 1, Math.max(0, kSpeeds.indexOf(this.speed) + by))]);
    const acts = {
      ' ': () => this.toggle(),
      ArrowLeft: () => this.go(this.time - small),
      ArrowRight: () => this.go(this.time + small),
      ArrowUp: () => speed(1),
      ArrowDown: () => speed(-1),
      Home: () => this.go(0),
      End: () => this.go(this.end),
      n: () => this.step(this.events.next(this.time)),
      p: () => this.step(this.events.previous(this.time)),
      1: () => this.setMode('orbit'),
      2: () => this.setMode('top'),
      3: () => this.setMode('follow'),
      g: () => this.setFrame(this.frame === 'room' ? 'ground' : 'room'),
      f: () => this.fullScreen(),
    };
    const act = acts[event.key] || acts[event.key.toLowerCase()];
    if (!act) return;
    event.preventDefault();
    act();
  }

  fullScreen() {
    if (document.fullscreenElement) document.exitFullscreen();
    else if (document.fullscreenEnabled) document.documentElement.requestFullscreen();
  }

  redraw() {
    this.dirty = true;
  }

  go(time) {
    this.time = Math.min(this.end, Math.max(0, time));
    this.redraw();
    if (!this.playing) this.writeLink();
  }

  step(event) {
    if (event) this.go(event.time);
  }

  toggle(play = !this.playing) {
    if (play && this.time >= this.end) this.time = 0;
    this.playing = play;
    this.before = undefined;
    element('play').textContent = play ? '\u275A\u275A' : '\u25B6';
    element('play').setAttribute('aria-label', play ? 'Pause' : 'Play');
    if (!play) this.writeLink();
    this.redraw();
  }

  setSpeed(speed) {
    this.speed = speed;
    element('speed').value = speed;
  }

  setMode(mode) {
    this.mode = mode;
    if (mode === 'top') this.camera.lookFromAbove();
    else this.camera.reset();
    if (mode === 'follow') this.camera.distance = 3.2;
    for (const id of ['orbit', 'top', 'follow']) element(id).setAttribute('aria-pressed', String(id === mode));
    this.redraw();
  }

  setFrame(frame) {
    this.frame = frame;
    element('ground').setAttribute('aria-pressed', String(frame === 'ground'));
    this.redraw();
  }

  applyTheme() {
    document.documentElement.dataset.theme = this.dark ? 'dark' : 'light';
    this.graph.lay(this.dark);
    this.redraw();
  }

  /// #t=12.4&view=top&frame=ground&speed=0.5&theme=dark&play
  readLink() {
    const link = new URLSearchParams(window.location.hash.slice(1));
    const number = (key, otherwise) => (Number.isFinite(parseFloat(link.get(key))) ? parseFloat(link.get(key)) : otherwise);
    this.time = Math.min(this.end, Math.max(0, number('t', this.time)));
    const speed = number('speed', this.speed);
    this.setSpeed(kSpeeds.reduce((a, b) => (Math.abs(b - speed) < Math.abs(a - speed) ? b : a)));
    const named = this.runs[0].items.findIndex((item) => item.name === link.get('item'));
    if (named >= 0) element('followed').value = named;
    const view = link.get('view');
    if (!this.linked || view) this.setMode(['top', 'follow'].includes(view) ? view : 'orbit');
    this.linked = true;
    if (link.get('frame') === 'ground') this.setFrame('ground');
    if (link.has('theme')) this.dark = link.get('theme') === 'dark';
    if (link.has('play')) this.toggle(true);
    this.redraw();
  }

  writeLink() {
    clearTimeout(this.linkLater);
    this.linkLater = setTimeout(() => {
      const view = this.mode === 'orbit' ? '' : `&view=${this.mode}`;
      const frame = this.frame === 'room' ? '' : '&frame=ground';
      try {
        window.history.replaceState(null, '', `#t=${+this.time.toFixed(3)}${view}${frame}`);
      } catch (error) {
        // A page that is opened within another may have no history; the link is a convenience.
      }
    }, 150);
  }

  tick(now) {
    if (this.playing) {
      if (this.before !== undefined) this.time += ((now - this.before) / 1000) * this.speed;
      this.before = now;
      if (this.time >= this.end) {
        this.time = this.end;
        this.toggle(false);
      }
      this.redraw();
    }
    if (this.dirty) this.draw();
    window.requestAnimationFrame((later) => this.tick(later));
  }

  draw() {
    this.dirty = false;
    element('time').textContent = `${this.time.toFixed(2)} s`;
    element('scrub').value = this.time;
    element('scrub').setAttribute('aria-valuetext', `${this.time.toFixed(2)} seconds of ${this.end.toFixed(2)}`);
    this.table.draw(this.time);
    this.events.draw(this.time);
    this.graph.draw(this.time);
    element('floor').textContent = this.floorText();
    element('overturned').hidden = !this.ghosts.length;
    element('overturned').textContent = this.overturnedText();
    if (this.renderer) this.drawRooms();
    this.saving.drawn();
  }

  floorText() {
    const run = this.graph.run;
    if (!run.floorMoves) return '';
    const at = run.at(this.time);
    const a = run.floorAcceleration.map((v) => between(v, at));
    const d = run.floorDisplacement.map((v) => 1000 * between(v, at));
    return `floor ${Math.hypot(a[0], a[1]).toFixed(2)} m/s², ${Math.hypot(d[0], d[1]).toFixed(0)} mm from its start`;
  }

  drawRooms() {
    this.renderer.resize();
    const { width, height } = this.renderer.canvas;
    const theme = this.dark ? kDark : kLight;
    const share = Math.floor(width / this.scenes.length);
    const labels = [];
    this.scenes.forEach((scene, i) => {
      const at = scene.run.at(this.time);
      const offset = this.frame === 'ground' ? scene.run.floorAt(at) : [0, 0, 0];
      const { camera, eye } = this.camera.view(share / height, this.lookedAt(scene, at, offset));
      scene.eye = eye;
      const view = { x: i * share, y: 0, width: share, height, camera, eye, sun: kSun, theme, now: this.time, light: this.lightOf(scene, offset) };
      this.renderer.drawView(view, scene.parts(at, offset, theme, this.shown, this.followed(), this.time), scene.ribbons(offset, this.shown));
      if (this.shown.labels) labels.push(...this.placed(scene.labels(at, offset), camera, i));
      if (scene.run.name) labels.push({ kind: 'run', text: scene.run.name, left: ((i + 0.5) * element('view').clientWidth) / this.scenes.length, top: 52 });
    });
    this.placedLabels = labels;
    this.labels.draw(labels);
  }

  followed() {
    return this.mode === 'follow' ? Number(element('followed').value) : -1;
  }

  /// Of the follow view, how far the item is from the middle of the room.
  lookedAt(scene, at, offset) {
    const item = scene.run.items[this.followed()];
    if (!item) return [0, 0, 0];
    const p = add(itemPose(item, at).p, offset);
    return [p[0] - this.camera.home.target[0], p[1] - this.camera.home.target[1], 0.1];
  }

  lightOf(scene, offset) {
    const { low, high } = scene.extent;
    const middle = add(offset, scaled(add(low, high), 0.5));
    const reach = norm(subtract(high, low)) / 2 + 0.3;
    return multiplied(orthographic(reach, reach, 0.1, 4 * reach), lookAt(add(middle, scaled(kSun, 2 * reach)), middle, [0, 1, 0]));
  }

  placed(labels, camera, i) {
    const width = element('view').clientWidth / this.scenes.length;
    const height = element('view').clientHeight;
    return labels.flatMap((label) => {
      const place = projected(camera, label.p);
      if (!place || place[0] < 0 || place[0] > 1 || place[1] < 0 || place[1] > 1) return [];
      return [{ ...label, left: (i + place[0]) * width, top: place[1] * height }];
    });
  }
}

window.player = new Player(JSON.parse(element('data').textContent));
