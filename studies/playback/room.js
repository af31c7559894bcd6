// What is drawn of a run: meshes made once, and their places at a time.

const kModes = [
  { name: 'sticks', color: [0.34, 0.6, 0.88] },
  { name: 'rolls', color: [0.1, 0.66, 0.45] },
  { name: 'skids', color: [0.88, 0.27, 0.1], shape: 'ring' },
  { name: 'braked', color: [0.72, 0.42, 0.68], shape: 'square' },
  { name: 'lifted', color: [0.95, 0.68, 0.1] },
];
const kLifted = 4;
const kSlab = 0.12;
const kPalette = [[0, 0.45, 0.7], [0.84, 0.37, 0], [0, 0.62, 0.45], [0.8, 0.47, 0.65], [0.9, 0.62, 0], [0.34, 0.71, 0.91], [0.45, 0.45, 0.5]];

const kGhost = [0.45, 0.45, 0.5];
const kFallen = [0.95, 0.25, 0.2];

const kDark = { background: [0.075, 0.085, 0.105], floor: [0.2, 0.215, 0.24], ground: [0.1, 0.105, 0.12], grid: [0.33, 0.35, 0.39], ambient: 0.5, body: [0.86, 0.86, 0.86], edge: [0.02, 0.02, 0.03, 0.75], wall: [0.55, 0.62, 0.72], wallEdge: [0.6, 0.66, 0.75, 0.45], cord: [0.5, 0.66, 1] };
const kLight = { background: [0.955, 0.962, 0.972], floor: [0.9, 0.905, 0.91], ground: [0.79, 0.8, 0.79], grid: [0.76, 0.78, 0.8], ambient: 0.7, body: [1, 1, 1], edge: [0.12, 0.14, 0.18, 0.7], wall: [0.5, 0.56, 0.64], wallEdge: [0.3, 0.34, 0.4, 0.4], cord: [0.16, 0.2, 0.45] };

class Extent {
  constructor() {
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
  }

  take(p) {
    p.forEach((v, i) => {
      this.low[i] = Math.min(this.low[i], v);
      this.high[i] = Math.max(this.high[i], v);
    });
  }
}

function extentOf(run, ghosts) {
  const extent = new Extent();
  for (const each of [run, ...ghosts])
    for (const item of each.items)
      for (let i = 0; i < each.time.length; i += 10) {
        const pose = itemPose(item, { sample: i, next: i, fraction: 0 });
        for (const box of item.boxes) for (const p of box) extent.take(add(pose.p, rotated(pose.q, p)));
      }
  extent.items = { low: [...extent.low], high: [...extent.high] };
  const near = { low: extent.low.map((v) => v - 4), high: extent.high.map((v) => v + 4) };
  for (const shape of run.room)
    for (const p of shape.points) extent.take(p.map((v, i) => Math.min(Math.max(v, near.low[i]), near.high[i])));
  for (const zone of run.zones) extent.take([...zone.center, 0]);
  return extent;
}

const stillAt = (p) => new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...p, 1]);

/// Axes of a thing that lies on the floor, its x axis along `along`.
function flatMatrix(p, along, length, width) {
  const y = [-along[1], along[0], 0];
  return new Float32Array([...scaled(along, length), 0, ...scaled(y, width), 0, 0, 0, 1, 0, ...p, 1]);
}

class RoomScene {
  /// @param ghosts other runs, drawn translucent in the same room
  constructor(renderer, run, ghosts) {
    this.run = run;
    this.ghosts = ghosts;
    this.renderer = renderer;
    this.extent = extentOf(run, ghosts);
    this.eye = [0, 0, 0];
    this.low = this.extent.low.map((v) => Math.floor(v - 0.3));
    this.high = this.extent.high.map((v) => Math.ceil(v + 0.3));
    this.colors = run.items.map((_, i) => kPalette[i % kPalette.length]);
    this.makeMeshes();
    this.makeRibbons();
    this.makeGhosts();
    const loads = run.items.flatMap((item) => item.wheels.map((wheel) => wheel.normal[0])).filter((n) => n > 0);
    this.usualLoad = loads.length ? loads.reduce((a, b) => a + b) / loads.length : 1;
  }

  makeMeshes() {
    const { renderer, run } = this;
    const low = this.low;
    const high = this.high;
    const middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, -kSlab / 2 - 0.002];
    const sunk = run.floorMoves ? Math.max(...run.floorDisplacement[2].map(Math.abs)) : 0;
    this.floor = renderer.mesh(planeMesh(low, high, 0));
    this.slab = renderer.mesh(new MeshBuilder().box(middle, [high[0] - low[0], high[1] - low[1], kSlab], [1, 1, 1]));
    this.ground = renderer.mesh(planeMesh(low.map((v) => v - 4), high.map((v) => v + 4), -kSlab - 0.1 - sunk));
    this.room = run.room.map((shape) => ({
      mesh: renderer.mesh(new MeshBuilder().shape(shape.kind, shape.points, [1, 1, 1])),
      tall: Math.max(...shape.points.map((p) => p[2])) > 1.2,
      middle: scaled(shape.points.reduce(add), 1 / shape.points.length),
    }));
    this.items = run.items.map((item, i) => ({
      chassis: renderer.mesh(chassisMesh(item, this.colors[i])),
      wheels: item.wheels.map((wheel) => renderer.mesh(wheelMesh(wheel.radius, wheel.width))),
      forks: item.wheels.map((wheel) => renderer.mesh(forkMesh(wheel))),
      front: Math.max(...item.boxes.flat().map((p) => p[0])),
      top: Math.max(...item.boxes.flat().map((p) => p[2])),
    }));
    this.disc = renderer.mesh(discMesh());
    this.arrow = renderer.mesh(arrowMesh());
    this.stick = renderer.mesh(new MeshBuilder().box([0.5, 0, 0], [1, 1, 1], [1, 1, 1]));
    this.square = renderer.mesh(planeMesh([-0.5, -0.5], [0.5, 0.5], 0));
  }

  makeRibbons() {
    const { run } = this;
    this.tracks = [];
    this.paths = [];
    run.items.forEach((item, i) => {
      const path = new RibbonBuilder(0.016, 0.004);
      const tracks = item.wheels.map(() => new RibbonBuilder(0.012, 0.003));
      for (let s = 0; s < run.time.length; ++s) {
        const at = { sample: s, next: s, fraction: 0 };
        const pose = itemPose(item, at);
        path.take(pose.p, this.colors[i], run.time[s]);
        item.wheels.forEach((wheel, w) => {
          if (wheel.mode[s] === kLifted) tracks[w].lift();
          else tracks[w].take(contactPoint(forkPose(pose, wheel, at), wheel), kModes[wheel.mode[s]].color, run.time[s]);
        });
      }
      this.paths.push(this.renderer.ribbon(path.numbers));
      for (const track of tracks) this.tracks.push(this.renderer.ribbon(track.numbers));
    });
  }

  makeGhosts() {
    this.ghostMeshes = this.ghosts.map((run) => run.items.map((item) => this.renderer.mesh(chassisMesh(item, kGhost))));
    this.ghostPaths = this.ghosts.flatMap((run) =>
      run.items.map((item) => {
        const path = new RibbonBuilder(0.008, 0.0035);
        for (let s = 0; s < run.time.length; ++s) path.take(itemPose(item, { sample: s, next: s, fraction: 0 }).p, kGhost, run.time[s]);
        return this.renderer.ribbon(path.numbers);
      }),
    );
  }

  putGhosts(put, time, offset, theme) {
    this.ghosts.forEach((run, g) => {
      const at = run.at(time);
      const fallen = run.overturned <= time;
      run.items.forEach((item, i) => {
        const { p, q } = itemPose(item, at);
        put(this.ghostMeshes[g][i], poseMatrix(add(p, offset), q), { tint: fallen ? kFallen : theme.body, alpha: fallen ? 0.22 : 0.13, edge: [...theme.edge.slice(0, 3), 0.14] });
      });
    });
  }

  /// Parts at a time; `offset` is where the room stands in the frame of the view.
  /// Of the other items than the followed one (-1: none) one sees through.
  parts(at, offset, theme, shown, followed, time) {
    const parts = [];
    const still = stillAt(offset);
    const put = (mesh, model, more) => parts.push({ mesh, model, kind: 0, tint: [1, 1, 1], alpha: 1, casts: false, edge: null, ...more });
    const pale = (mesh, model, more) => put(mesh, model, { ...more, alpha: 0.25 * (more.alpha || 1), edge: more.edge && [...more.edge.slice(0, 3), 0.3] });
    put(this.floor, still, { kind: 2, tint: theme.floor });
    put(this.slab, still, { tint: theme.floor.map((v) => 0.8 * v), edge: theme.wallEdge });
    if (this.run.floorMoves) put(this.ground, stillAt(subtract(offset, this.run.floorAt(at))), { kind: 2, tint: theme.ground });
    if (shown.room) this.putRoom(put, still, theme);
    if (shown.zones) this.run.zones.forEach((zone) => this.putZone(put, zone, offset));
    this.run.items.forEach((item, i) => this.putItem(followed < 0 || i === followed ? put : pale, item, i, at, offset, theme, shown));
    if (shown.tethers) this.run.tethers.forEach((tether) => this.putTether(put, tether, at, offset, theme));
    if (shown.ghosts) this.putGhosts(put, time, offset, theme);
    return parts;
  }

  putRoom(put, still, theme) {
    const clear = [...theme.wallEdge.slice(0, 3), 0.12];  // walls before the items are no cage of lines
    for (const { mesh, tall, middle } of this.room)
      put(mesh, still, tall ? { tint: theme.wall, alpha: this.isBefore(middle) ? 0.035 : 0.2, edge: this.isBefore(middle) ? clear : theme.wallEdge } : { tint: theme.floor.map((v) => 0.9 * v), edge: theme.wallEdge, casts: true });
  }

  /// Whether a wall is on the side of the eye, where it would hide the items.
  isBefore(middle) {
    const center = scaled(add(this.low, this.high), 0.5);
    const toEye = subtract(this.eye, center);
    const toWall = subtract(middle, center);
    return toEye[0] * toWall[0] + toEye[1] * toWall[1] > 0;
  }

  putZone(put, zone, offset) {
    const along = [Math.cos(zone.angle), Math.sin(zone.angle), 0];
    const model = flatMatrix(add(offset, [...zone.center, 0.0015]), along, zone.length, zone.width);
    put(this.square, model, { kind: 3, tint: [0.95, 0.72, 0.15], alpha: 0.16 });
  }

  putItem(put, item, i, at, offset, theme, shown) {
    const meshes = this.items[i];
    const pose = itemPose(item, at);
    const place = { p: add(pose.p, offset), q: pose.q };
    put(meshes.chassis, poseMatrix(place.p, place.q), { tint: theme.body, edge: theme.edge, casts: true });
    this.putFront(put, place, meshes.front, this.colors[i]);
    item.wheels.forEach((wheel, w) => {
      const fork = forkPose(place, wheel, at);
      const { p, q } = wheelPose(fork, wheel, at);
      put(meshes.forks[w], poseMatrix(fork.p, fork.q), { tint: theme.body, edge: theme.edge, casts: true });
      put(meshes.wheels[w], poseMatrix(p, q), { kind: 1, tint: theme.body, casts: true, radius: wheel.radius, width: wheel.width });
      if (shown.forces) this.putForces(put, wheel, fork, at, offset, theme);
    });
  }

  putFront(put, place, front, color) {
    const x = rotated(place.q, [1, 0, 0]);
    if (Math.hypot(x[0], x[1]) < 0.5) return;
    const along = unit([x[0], x[1], 0]);
    const tip = add(place.p, scaled(x, front + 0.05));
    put(this.arrow, flatMatrix([tip[0], tip[1], place.p[2] + 0.003], along, 0.16, 0.5), { kind: 3, tint: color, alpha: 0.85 });
  }

  /// A patch whose area is the normal force, and the horizontal force of the floor. Braked wheels have a square and
  /// skidding ones a ring, so that states are not distinguished by colour alone.
  putForces(put, wheel, fork, at, offset, theme) {
    const mode = wheel.mode[at.sample];
    const normal = between(wheel.normal, at);
    if (mode === kLifted || !(normal > 0)) return;
    const tint = kModes[mode].color;
    const p = contactPoint(fork, wheel);
    const floor = [p[0], p[1], offset[2] + 0.0025];
    const radius = Math.min(0.3, 0.085 * Math.sqrt(normal / this.usualLoad));
    const shape = kModes[mode].shape;
    const side = Math.sqrt(Math.PI) * radius;  // a square of the area of the disc
    if (shape === 'square') put(this.square, flatMatrix(floor, [1, 0, 0], side, side), { kind: 3, tint, alpha: 0.62 });
    else put(this.disc, flatMatrix(floor, [1, 0, 0], radius, radius), { kind: 3, tint, alpha: shape === 'ring' ? 0.9 : 0.62 });
    if (shape === 'ring') put(this.disc, flatMatrix(add(floor, [0, 0, 0.0005]), [1, 0, 0], 0.6 * radius, 0.6 * radius), { kind: 3, tint: theme.floor, alpha: 1 });
    const heading = rotated(fork.q, [1, 0, 0]);
    const along = unit([heading[0], heading[1], 0]);
    const force = add(scaled(along, between(wheel.longitudinal, at)), scaled([-along[1], along[0], 0], between(wheel.lateral, at)));
    const length = (norm(force) / this.usualLoad) * 0.6;
    if (length > 0.02) put(this.arrow, flatMatrix(add(floor, [0, 0, 0.001]), unit(force), length, 0.5), { kind: 3, tint, alpha: 0.95 });
  }

  putTether(put, tether, at, offset, theme) {
    const place = (name, point) => {
      const item = this.run.items.find((each) => each.name === name);
      if (!item) return null;
      const pose = itemPose(item, at);
      return add(pose.p, rotated(pose.q, point));
    };
    const from = place(tether.item, tether.point);
    const to = tether.anchor_item ? place(tether.anchor_item, tether.anchor) : tether.anchor;
    if (!from || !to) return;
    const now = mix(this.run.time[at.sample], this.run.time[at.next], at.fraction);
    const broken = tether.time_broken >= 0 && now >= tether.time_broken;
    const points = broken ? hangingCord(from, to, tether) : cord(from, to, tether);
    const taut = !broken && norm(subtract(from, to)) >= tether.slack_length;
    const tint = broken || taut ? [0.9, 0.2, 0.12] : theme.cord;
    for (let i = 1; i < points.length; ++i) put(this.stick, stickMatrix(add(points[i - 1], offset), add(points[i], offset), 0.012), { tint, casts: true });
  }

  /// Ribbons on the floor.
  ribbons(offset, shown) {
    const model = stillAt(offset);
    const all = [];
    if (shown.tracks) for (const buffer of this.tracks) all.push({ buffer, model, alpha: 0.75 });
    if (shown.paths && shown.ghosts) for (const buffer of this.ghostPaths) all.push({ buffer, model, alpha: 0.45 });
    if (shown.paths) for (const buffer of this.paths) all.push({ buffer, model, alpha: 0.9 });
    return all;
  }

  /// Texts and where they stand: the names of the items, metres along two edges of the floor.
  labels(at, offset) {
    const labels = this.run.items.map((item, i) => {
      const pose = itemPose(item, at);
      return { kind: 'name', text: item.name, color: this.colors[i], p: add(offset, add(pose.p, rotated(pose.q, [0, 0, this.items[i].top + 0.12]))) };
    });
    const [low, high] = [this.low, this.high];
    for (let x = low[0]; x <= high[0]; ++x) labels.push({ kind: 'scale', text: x === high[0] ? `x ${x} m` : `${x}`, p: add(offset, [x, low[1] - 0.12, 0]) });
    for (let y = low[1]; y <= high[1]; ++y) labels.push({ kind: 'scale', text: y === high[1] ? `y ${y} m` : `${y}`, p: add(offset, [high[0] + 0.12, y, 0]) });
    return labels;
  }
}

/// A ribbon on the floor along the places it takes.
class RibbonBuilder {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.numbers = [];
    this.last = null;
  }

  lift() {
    this.last = null;
  }

  take(p, color, time) {
    const here = [p[0], p[1], this.height];
    if (!this.last) this.last = here;
    const step = subtract(here, this.last);
    if (norm(step) < 0.004) return;
    const side = scaled(unit([-step[1], step[0], 0]), this.width / 2);
    const [a, b, c, d] = [add(this.last, side), subtract(this.last, side), subtract(here, side), add(here, side)];
    for (const corner of [a, b, c, a, c, d]) this.numbers.push(...corner, ...color, time);
    this.last = here;
  }
}

/// A slack cord sags as a parabola of its length: sag^2 = 3/8 d (L - d).
function cord(from, to, tether) {
  const span = norm(subtract(to, from));
  const sag = Math.sqrt(Math.max(0, (3 / 8) * span * (tether.slack_length - span)));
  return Array.from({ length: 15 }, (_, i) => {
    const f = i / 14;
    const p = from.map((v, k) => mix(v, to[k], f));
    return [p[0], p[1], Math.max(0.012, p[2] - 4 * sag * f * (1 - f))];
  });
}

/// From the item down, and what is left of it on the floor towards the anchor.
function hangingCord(from, to, tether) {
  const foot = [from[0], from[1], 0.012];
  const flat = subtract([to[0], to[1], 0.012], foot);
  const left = Math.min(Math.max(0, tether.slack_length - from[2]), norm(flat));
  return [from, foot, add(foot, scaled(unit(flat), left))];
}

function stickMatrix(a, b, thickness) {
  const along = subtract(b, a);
  const x = unit(along);
  const y = unit(cross(Math.abs(x[2]) > 0.9 ? [1, 0, 0] : [0, 0, 1], x));
  const z = cross(x, y);
  return new Float32Array([...along, 0, ...scaled(y, thickness), 0, ...scaled(z, thickness), 0, ...a, 1]);
}
