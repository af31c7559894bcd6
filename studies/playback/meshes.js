// Solids as triangles with normals and colours, their edges as lines.

class MeshBuilder {
  constructor() {
    this.vertices = [];  // position, normal, colour: 9 numbers each
    this.edges = [];     // positions, two for each line
  }

  /// A flat convex polygon, its corners seen anticlockwise.
  polygon(points, color) {
    const normal = unit(cross(subtract(points[1], points[0]), subtract(points[2], points[0])));
    for (let i = 2; i < points.length; ++i)
      for (const point of [points[0], points[i - 1], points[i]]) this.vertices.push(...point, ...normal, ...color);
    return this;
  }

  outline(points) {
    points.forEach((point, i) => this.edges.push(...point, ...points[(i + 1) % points.length]));
    return this;
  }

  /// Between two rings of as many points, the first seen clockwise from outside.
  prism(ring, other, color, withEdges = true) {
    const n = ring.length;
    for (let i = 0; i < n; ++i) {
      const j = (i + 1) % n;
      this.polygon([ring[i], ring[j], other[j], other[i]], color);
      if (withEdges && n < 9) this.edges.push(...ring[i], ...other[i]);
    }
    this.polygon([...ring].reverse(), color).polygon(other, color);
    if (withEdges) this.outline(ring).outline(other);
    return this;
  }

  box(center, size, color, withEdges = true) {
    const corner = (x, y, z) => [center[0] + (x * size[0]) / 2, center[1] + (y * size[1]) / 2, center[2] + (z * size[2]) / 2];
    const ring = (z) => [corner(-1, -1, z), corner(1, -1, z), corner(1, 1, z), corner(-1, 1, z)];
    return this.prism(ring(-1), ring(1), color, withEdges);
  }

  /// The convex hull of a few points: every triangle with all others on one side.
  hull(points, color) {
    const n = points.length;
    for (let i = 0; i < n; ++i)
      for (let j = i + 1; j < n; ++j)
        for (let k = j + 1; k < n; ++k) this.hullFace(points, [points[i], points[j], points[k]], color);
    return this;
  }

  hullFace(points, [a, b, c], color) {
    const normal = cross(subtract(b, a), subtract(c, a));
    const size = norm(normal);
    if (size < 1e-12) return;
    const heights = points.map((p) => dot(normal, subtract(p, a)) / size);
    const above = Math.max(...heights) > 1e-6;
    const below = Math.min(...heights) < -1e-6;
    if (above && below) return;
    const face = above ? [a, c, b] : [a, b, c];
    this.polygon(face, color).outline(face);
  }

  /// A shape of the results file: see docs/formats/results_file.md, /shapes.
  shape(kind, points, color) {
    const half = points.length / 2;
    if (kind === 'hull') return this.hull(points, color);
    const ring = points.slice(0, half);
    const other = points.slice(half);
    const along = subtract(other[0], ring[0]);
    const normal = cross(subtract(ring[1], ring[0]), subtract(ring[2], ring[0]));
    return dot(along, normal) >= 0 ? this.prism(ring, other, color) : this.prism([...ring].reverse(), [...other].reverse(), color);
  }
}

/// A wheel about the y axis; its marks are drawn by the shader.
function wheelMesh(radius, width) {
  const kSides = 40;
  const mesh = new MeshBuilder();
  const ring = (y) =>
    Array.from({ length: kSides }, (_, i) => {
      const a = (2 * Math.PI * i) / kSides;
      return [radius * Math.sin(a), y, radius * Math.cos(a)];
    });
  return mesh.prism(ring(-width / 2), ring(width / 2), [0.2, 0.2, 0.22], false);
}

/// Crown and two plates from the swivel axis to the axle, in fork axes.
function forkMesh(wheel) {
  const color = [0.62, 0.65, 0.69];
  const mesh = new MeshBuilder();
  const [cx, , cz] = wheel.center;
  const top = cz + wheel.radius * 1.06;
  const width = wheel.width + 0.012;
  const reach = Math.max(0.3 * wheel.radius, 0.014);
  if (top < -0.002) mesh.box([0, 0, top / 2], [2 * reach, width + 0.008, -top], color);
  for (const side of [-1, 1]) {
    const y = (side * width) / 2;
    const plate = (offset) => [
      [cx - 0.5 * reach, y + offset, cz - 0.4 * reach],
      [cx + 0.5 * reach, y + offset, cz - 0.4 * reach],
      [reach, y + offset, top + 0.002],
      [-reach, y + offset, top + 0.002],
    ];
    mesh.prism(plate(0.002), plate(-0.002), color);
  }
  return mesh;
}

/// The shapes of an item, and an arrow to its front on the highest of its boxes.
function chassisMesh(item, color) {
  const mesh = new MeshBuilder();
  const pale = color.map((c) => mix(c, 0.97, 0.66));
  let top = null;
  item.boxes.forEach((points, i) => {
    if (item.kinds[i] !== 'box') return mesh.shape(item.kinds[i], points, pale);
    const low = points[0];
    const high = points[6];
    const flat = high[2] - low[2] < 0.12;
    mesh.shape('box', points, flat ? pale.map((c) => c * 0.82) : pale);
    if (!top || high[2] > top.high[2]) top = { low, high };
  });
  if (!top) return mesh;
  frontArrow(mesh, top, color);
  const front = item.boxes.filter((_, i) => item.kinds[i] === 'box').reduce((a, b) => (b[6][0] > a[6][0] ? b : a));
  frontStripe(mesh, front[0], front[6], color);
  return mesh;
}

function frontArrow(mesh, { low, high }, color) {
  const width = Math.min(0.6 * (high[1] - low[1]), 0.3);
  const length = Math.min(0.5 * (high[0] - low[0]), 0.3);
  const tip = high[0] - 0.12 * (high[0] - low[0]);
  const y = (low[1] + high[1]) / 2;
  const z = high[2] + 0.003;
  mesh.polygon([[tip, y, z], [tip - length, y + width / 2, z], [tip - 0.65 * length, y, z]], color);
  mesh.polygon([[tip, y, z], [tip - 0.65 * length, y, z], [tip - length, y - width / 2, z]], color);
}

function frontStripe(mesh, low, high, color) {
  const height = Math.min(0.25 * (high[2] - low[2]), 0.06);
  const z = high[2] - 1.2 * height;
  const y = 0.06 * (high[1] - low[1]);
  const x = high[0] + 0.002;
  mesh.polygon([[x, low[1] + y, z - height / 2], [x, high[1] - y, z - height / 2], [x, high[1] - y, z + height / 2], [x, low[1] + y, z + height / 2]], color);
}

/// A disc that lies on the floor, of radius 1.
function discMesh() {
  const ring = Array.from({ length: 32 }, (_, i) => [Math.cos((Math.PI * i) / 16), Math.sin((Math.PI * i) / 16), 0]);
  return new MeshBuilder().polygon(ring, [1, 1, 1]);
}

/// An arrow of length 1 along x that lies on the floor.
function arrowMesh() {
  const mesh = new MeshBuilder();
  mesh.polygon([[0, -0.03, 0], [0.78, -0.03, 0], [0.78, 0.03, 0], [0, 0.03, 0]], [1, 1, 1]);
  return mesh.polygon([[0.74, -0.1, 0], [1, 0, 0], [0.74, 0.1, 0]], [1, 1, 1]);
}

const planeMesh = (low, high, z) =>
  new MeshBuilder().polygon([[low[0], low[1], z], [high[0], low[1], z], [high[0], high[1], z], [low[0], high[1], z]], [1, 1, 1]);
