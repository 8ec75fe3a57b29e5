// Reads what `floe report` wrote into the page. Large arrays come as base64 of little-endian
// numbers, `i16` with a scale; the axes are told in docs/howto/report.md.

const kinds = {
  f32: Float32Array,
  i16: Int16Array,
  u32: Uint32Array,
};

const isPacked = (value) =>
  value !== null && typeof value === 'object' && typeof value.base64 === 'string';

export function unpack(packed) {
  const text = atob(packed.base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const numbers = new kinds[packed.type](bytes.buffer);
  if (packed.type !== 'i16') return numbers;
  const scaled = new Float32Array(numbers.length);
  for (let i = 0; i < numbers.length; ++i) scaled[i] = numbers[i] * packed.scale;
  return scaled;
}

// The same object with every packed array unpacked
export function decode(value) {
  if (isPacked(value)) return unpack(value);
  if (Array.isArray(value)) return value.map(decode);
  if (value === null || typeof value !== 'object') return value;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, decode(item)]));
}

// Deflection of every node in one wave, w = Σ ξ_j c_j: {re, im}, metres per metre of amplitude; on
// the direct route c_j are real and imaginary parts of the motions
export function deflection(data, frequency, heading) {
  const nodes = data.surface.x.length;
  const modes = data.modes.count;
  const headings = data.waves.heading_deg.length;
  const re = new Float32Array(nodes);
  const im = new Float32Array(nodes);
  const first = (frequency * headings + heading) * modes * 2;
  for (let mode = 0; mode < modes; ++mode) {
    const a = data.amplitudes[first + 2 * mode];
    const b = data.amplitudes[first + 2 * mode + 1];
    const shape = data.modes.shape.subarray(mode * nodes, (mode + 1) * nodes);
    for (let i = 0; i < nodes; ++i) {
      re[i] += a * shape[i];
      im[i] += b * shape[i];
    }
  }
  return { re, im };
}

// Amplitude of a bending moment at every node in one wave, [N m/m per m]
export function bendingMoment(data, axis, frequency, heading) {
  const nodes = data.surface.x.length;
  const first = (frequency * data.waves.heading_deg.length + heading) * data.modes.count * 2;
  const re = new Float32Array(nodes);
  const im = new Float32Array(nodes);
  data.moments[axis].forEach((shape, mode) => {
    const a = data.amplitudes[first + 2 * mode];
    const b = data.amplitudes[first + 2 * mode + 1];
    for (let i = 0; i < nodes; ++i) {
      re[i] += a * shape[i];
      im[i] += b * shape[i];
    }
  });
  const stiffer = Math.hypot(1, data.structure.plate.loss_factor ?? 0);
  return re.map((value, i) => stiffer * Math.hypot(value, im[i]));
}

export function magnitudes({ re, im }) {
  return re.map((value, i) => Math.hypot(value, im[i]));
}

// |value| of a quantity at a point in one wave
export function raoMagnitude(data, quantity, frequency, heading, point) {
  const headings = data.waves.heading_deg.length;
  const points = data.points.length;
  const i = (frequency * headings + heading) * points + point;
  return Math.hypot(data.rao[quantity][2 * i], data.rao[quantity][2 * i + 1]);
}

// Phase in degrees, of e^{-iωt} relative to the wave's crest at the origin
export function raoPhase(data, quantity, frequency, heading, point) {
  const i = (frequency * data.waves.heading_deg.length + heading) * data.points.length + point;
  return (Math.atan2(data.rao[quantity][2 * i + 1], data.rao[quantity][2 * i]) * 180) / Math.PI;
}

export function indexOfLargest(values) {
  let best = 0;
  for (let i = 1; i < values.length; ++i) if (values[i] > values[best]) best = i;
  return best;
}
