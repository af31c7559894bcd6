// One program for solids, one for lines and ribbons, one for the depth seen from the light.

const kSolidVertex = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
uniform mat4 model, camera, light;
out vec3 local, world, facing, paint;
out vec4 lit;
void main() {
  vec4 p = model * vec4(position, 1.0);
  local = position;
  world = p.xyz;
  facing = mat3(model) * normal;
  paint = color;
  lit = light * p;
  gl_Position = camera * p;
}`;

const kSolidFragment = `#version 300 es
precision highp float;
precision highp sampler2DShadow;
in vec3 local, world, facing, paint;
in vec4 lit;
uniform vec4 tint;
uniform vec3 eye, sun, background, gridColor;
uniform float ambient, radius, width;
uniform int kind;  // 0: plain, 1: wheel, 2: floor with a grid, 3: without light
uniform sampler2DShadow shadows;
out vec4 result;

float shadow(vec3 n) {
  vec3 p = lit.xyz / lit.w * 0.5 + 0.5;
  if (any(lessThan(p.xy, vec2(0.0))) || any(greaterThan(p.xy, vec2(1.0)))) return 1.0;
  float bias = 0.0006 + 0.0012 * (1.0 - max(dot(n, sun), 0.0));
  vec2 texel = 1.0 / vec2(textureSize(shadows, 0));
  float sum = 0.0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      sum += texture(shadows, vec3(p.xy + vec2(i, j) * texel, p.z - bias));
  return sum / 25.0;
}

// Tyre, hub and spokes; one spoke and its place on the tread are marked.
vec3 wheelPaint() {
  float r = length(local.xz) / radius;
  float angle = atan(local.x, local.z);
  if (abs(local.y) < 0.495 * width) return abs(angle) < 0.16 ? vec3(0.95, 0.62, 0.1) : paint;
  if (r > 0.78) return paint;
  if (abs(angle) < 0.2 / max(r, 0.25) * 0.6) return vec3(0.95, 0.62, 0.1);
  float spoke = abs(fract(angle / 1.2566) - 0.5) * 1.2566 * r;
  float hub = 1.0 - smoothstep(0.2, 0.24, r);
  float open = smoothstep(0.0, 0.03, 0.5 * 1.2566 * r - spoke - 0.09);
  return mix(vec3(0.84), vec3(0.36, 0.37, 0.4), open * (1.0 - hub));
}

float gridLine(vec2 p, float spacing, float thickness) {
  vec2 q = p / spacing;
  vec2 w = max(fwidth(q), vec2(1e-6));
  vec2 d = abs(fract(q - 0.5) - 0.5) / w;
  float line = 1.0 - min(min(d.x, d.y) / thickness, 1.0);
  return line * clamp(1.0 - 3.0 * max(w.x, w.y), 0.0, 1.0);
}

void main() {
  vec3 base = paint * tint.rgb;
  vec3 n = normalize(facing);
  if (!gl_FrontFacing) n = -n;
  if (kind == 3) { result = vec4(base, tint.a); return; }
  if (kind == 1) base = wheelPaint() * tint.rgb;
  if (kind == 2) {
    base = mix(base, gridColor, 0.45 * gridLine(local.xy, 0.1, 1.0));
    base = mix(base, gridColor, gridLine(local.xy, 1.0, 1.6));
  }
  float direct = max(dot(n, sun), 0.0);
  float sky = 0.5 + 0.5 * n.z;
  float light = ambient * mix(0.72, 1.0, sky) + (1.0 - ambient) * 1.25 * direct * shadow(n);
  vec3 toEye = normalize(eye - world);
  float glint = kind == 2 ? 0.0 : pow(max(dot(n, normalize(toEye + sun)), 0.0), 40.0) * 0.12;
  result = vec4(base * min(light, 1.08) + glint, tint.a);
}`;

const kDepthVertex = `#version 300 es
layout(location = 0) in vec3 position;
uniform mat4 model, light;
void main() { gl_Position = light * model * vec4(position, 1.0); }`;

const kDepthFragment = `#version 300 es
precision mediump float;
void main() {}`;

// `since` is the time from which on a vertex is there: ribbons grow.
const kLineVertex = `#version 300 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 color;
layout(location = 2) in float since;
uniform mat4 model, camera;
uniform float nearer;
out vec3 paint;
out float from;
void main() {
  paint = color;
  from = since;
  gl_Position = camera * model * vec4(position, 1.0);
  gl_Position.z -= nearer * gl_Position.w;
}`;

const kLineFragment = `#version 300 es
precision highp float;
in vec3 paint;
in float from;
uniform vec4 tint;
uniform float now;
out vec4 result;
void main() {
  if (from > now) discard;
  result = vec4(paint * tint.rgb, tint.a);
}`;
