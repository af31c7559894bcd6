// The runs of the page: their channels decoded, and where everything is at a time.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/// Values of a channel: offset + step x whole number; without data all are the offset.
function valuesOf(channel, count) {
  const values = new Float64Array(count).fill(channel.offset);
  if (!channel.data) return values;
  const bytes = bytesOf(channel.data);
  const whole = channel.bits === 8 ? bytes : new Uint16Array(bytes.buffer);
  for (let i = 0; i < count; ++i) values[i] += channel.step * whole[i];
  return values;
}

class Recording {
  constructor(raw) {
    this.name = raw.name;
    this.outcome = raw.outcome;
    this.record = raw.record;
    this.room = raw.room;
    this.zones = raw.zones;
    this.tethers = raw.tethers;
    this.events = raw.events;
    this.overturned = Math.min(...raw.events.filter((event) => event.kind === 'overturned').map((event) => event.time));
    this.time = new Float32Array(bytesOf(raw.time).buffer);
    this.end = this.time[this.time.length - 1];
    const decode = (channel) => valuesOf(channel, this.time.length);
    this.items = raw.items.map((item) => ({
      ...item,
      position: item.position.map(decode),
      orientation: item.orientation.map(decode),
      wheels: item.wheels.map((wheel) => ({
        ...wheel,
        swivel: decode(wheel.swivel),
        roll: decode(wheel.roll),
        normal: decode(wheel.normal),
        longitudinal: decode(wheel.longitudinal),
        lateral: decode(wheel.lateral),
        mode: bytesOf(wheel.mode),
      })),
    }));
    this.floorMoves = raw.floor !== null;
    if (!raw.floor) return;
    this.floorAcceleration = raw.floor.acceleration.map(decode);
    this.floorDisplacement = raw.floor.displacement.map(decode);
  }

  /// The sample before a time and the fraction of the way to the next.
  at(time) {
    let low = 0;
    let high = this.time.length - 1;
    if (time <= this.time[0] || high === 0) return { sample: 0, next: 0, fraction: 0 };
    if (time >= this.time[high]) return { sample: high, next: high, fraction: 0 };
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time[middle] <= time) low = middle;
      else high = middle;
    }
    const fraction = (time - this.time[low]) / (this.time[high] - this.time[low]);
    return { sample: low, next: high, fraction };
  }

  floorAt(at) {
    return this.floorMoves ? this.floorDisplacement.map((v) => between(v, at)) : [0, 0, 0];
  }
}

const between = (values, at) => mix(values[at.sample], values[at.next], at.fraction);

function itemPose(item, at) {
  const p = item.position.map((v) => between(v, at));
  const q0 = item.orientation.map((v) => v[at.sample]);
  const q1 = item.orientation.map((v) => v[at.next]);
  const same = q0[0] * q1[0] + q0[1] * q1[1] + q0[2] * q1[2] + q0[3] * q1[3] >= 0 ? 1 : -1;
  const q = q0.map((v, i) => mix(v, same * q1[i], at.fraction));
  const length = Math.hypot(...q);
  return { p, q: q.map((v) => v / length) };
}

function forkPose(pose, wheel, at) {
  const q = product(pose.q, turnAbout([0, 0, 1], between(wheel.swivel, at)));
  return { p: add(pose.p, rotated(pose.q, wheel.pivot)), q };
}

/// Rolling forward is a turn about the fork's y axis.
function wheelPose(fork, wheel, at) {
  const q = product(fork.q, turnAbout([0, 1, 0], between(wheel.roll, at)));
  return { p: add(fork.p, rotated(fork.q, wheel.center)), q };
}

/// The lowest point of a wheel.
function contactPoint(fork, wheel) {
  const center = add(fork.p, rotated(fork.q, wheel.center));
  const axle = rotated(fork.q, [0, 1, 0]);
  const down = unit(subtract(scaled(axle, axle[2]), [0, 0, 1]));
  return add(center, scaled(down, wheel.radius));
}

/// Over all samples: how far the item is from where it began, and its tilt [m, rad].
const distanceOf = ({ position: [x, y] }) => x.map((v, i) => Math.hypot(v - x[0], y[i] - y[0]));
const tiltOf = ({ orientation: [w, x, y, z] }) =>
  w.map((_, i) => Math.acos(Math.max(-1, Math.min(1, 1 - (2 * (x[i] ** 2 + y[i] ** 2)) / (w[i] ** 2 + x[i] ** 2 + y[i] ** 2 + z[i] ** 2)))));

/// What the table shows of an item: displacement since the start, yaw and tilt [m, rad].
function motionOf(item, at) {
  const pose = itemPose(item, at);
  const first = itemPose(item, { sample: 0, next: 0, fraction: 0 });
  const heading = (q) => Math.atan2(2 * (q[0] * q[3] + q[1] * q[2]), 1 - 2 * (q[2] * q[2] + q[3] * q[3]));
  const turn = heading(pose.q) - heading(first.q);
  return {
    displacement: subtract(pose.p, first.p),
    yaw: Math.atan2(Math.sin(turn), Math.cos(turn)),
    tilt: Math.acos(Math.min(1, rotated(pose.q, [0, 0, 1])[2])),
  };
}
