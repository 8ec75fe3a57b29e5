// Everything moves as Re[(re + i im) e^{-iφ}].

export const plateVertex = `#version 300 es
in vec2 position;
in vec2 deflection;
in float colour;
uniform mat4 view;
uniform float phase, lift;
uniform vec2 range;
uniform bool moving;
out float shade;
out vec3 place;
void main() {
  float w = deflection.x * cos(phase) + deflection.y * sin(phase);
  shade = ((moving ? w : colour) - range.x) / (range.y - range.x);
  place = vec3(position, lift * w);
  gl_Position = view * vec4(place, 1.0);
}`;

export const plateFragment = `#version 300 es
precision highp float;
in float shade;
in vec3 place;
uniform sampler2D colours;
out vec4 pixel;
void main() {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  float light = 0.72 + 0.28 * abs(dot(normal, normalize(vec3(0.35, 0.25, 0.9))));
  pixel = vec4(texture(colours, vec2(clamp(shade, 0.002, 0.998), 0.5)).rgb * light, 1.0);
}`;

// A little farther from the eye than the plate, which it touches from below
export const seaVertex = `#version 300 es
in vec2 position;
in vec2 elevation;
uniform mat4 view;
uniform float phase, lift;
out vec3 place;
void main() {
  place = vec3(position, lift * (elevation.x * cos(phase) + elevation.y * sin(phase)));
  gl_Position = view * vec4(place, 1.0);
  gl_Position.z += 2e-3 * gl_Position.w;
}`;

export const seaFragment = `#version 300 es
precision highp float;
in vec3 place;
uniform vec3 water;
uniform float lift;
out vec4 pixel;
void main() {
  vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
  if (normal.z < 0.0) normal = -normal;
  float light = 0.75 + 0.35 * dot(normal, normalize(vec3(0.45, 0.2, 0.6)));
  pixel = vec4(water * light + 0.05 * place.z / max(lift, 1e-9), 1.0);
}`;

export const lineVertex = `#version 300 es
in vec2 position;
in vec2 deflection;
uniform mat4 view;
uniform float phase, lift;
void main() {
  float w = deflection.x * cos(phase) + deflection.y * sin(phase);
  gl_Position = view * vec4(position, lift * w, 1.0);
  gl_Position.z -= 1e-4 * gl_Position.w;
}`;

export const lineFragment = `#version 300 es
precision highp float;
uniform vec3 ink;
out vec4 pixel;
void main() { pixel = vec4(ink, 1.0); }`;
