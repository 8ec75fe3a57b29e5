// Colour maps as look-up tables of 256 RGB triples, interpolated between a few stops.

// Perceptually even, dark to light: amplitudes and standard deviations
const sequential = [
  [0.0, 68, 1, 84],
  [0.25, 59, 82, 139],
  [0.5, 33, 145, 140],
  [0.75, 94, 201, 98],
  [1.0, 253, 231, 37],
];

// Blue below, light at rest, red above: the moving plate
const diverging = [
  [0.0, 33, 102, 172],
  [0.25, 146, 197, 222],
  [0.5, 247, 247, 247],
  [0.75, 244, 165, 130],
  [1.0, 178, 24, 43],
];

// Comes back to where it began: phases
const cyclic = [
  [0.0, 226, 217, 226],
  [0.25, 104, 134, 190],
  [0.5, 48, 18, 53],
  [0.75, 178, 92, 74],
  [1.0, 226, 217, 226],
];

function lookup(stops) {
  const colours = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; ++i) {
    const x = i / 255;
    const upper = Math.max(1, stops.findIndex(([at]) => at >= x));
    const [x0, ...from] = stops[upper - 1];
    const [x1, ...to] = stops[upper];
    const share = (x - x0) / (x1 - x0);
    for (let c = 0; c < 3; ++c) colours[4 * i + c] = Math.round(from[c] + share * (to[c] - from[c]));
    colours[4 * i + 3] = 255;
  }
  return colours;
}

export const maps = {
  sequential: lookup(sequential),
  diverging: lookup(diverging),
  cyclic: lookup(cyclic),
};

export function cssGradient(name) {
  const map = maps[name];
  const stops = [];
  for (let i = 0; i <= 8; ++i) {
    const at = 4 * Math.round((i / 8) * 255);
    stops.push(`rgb(${map[at]} ${map[at + 1]} ${map[at + 2]})`);
  }
  return `linear-gradient(to right, ${stops.join(', ')})`;
}
