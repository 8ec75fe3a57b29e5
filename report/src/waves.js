// Response to regular waves: curves over the frequency at points, and along lines.
import { chartCard } from './charts.js';
import { raoMagnitude, raoPhase } from './data.js';
import { element } from './dom.js';
import { number } from './format.js';

function overFrequency(data) {
  if (data.points.length === 0) return undefined;
  const state = { quantity: 0, heading: 0, part: 0 };
  const spec = () => {
    const quantity = data.quantities[state.quantity];
    const value = state.part === 0 ? raoMagnitude : raoPhase;
    const curves = data.points.map((_, p) =>
      data.waves.omega.map((_, f) => value(data, state.quantity, f, state.heading, p)),
    );
    return {
      title: `${quantity.label} at the points over the frequency`,
      describe: data.points.map((point, p) => `${point.name}: up to ${number(Math.max(...curves[p]))}`).join(', '),
      x: 'ω [rad/s]',
      y: state.part === 0 ? `|${quantity.label}| [${quantity.per_metre}]` : `phase of ${quantity.label} [°]`,
      series: data.points.map(({ name }) => name),
      values: [data.waves.omega, ...curves],
      range: state.part === 0 ? [0, null] : [-180, 180],
    };
  };
  return chartCard('At points', state, spec, [
    ['Quantity', data.quantities.map(({ label }) => label), 'quantity'],
    ['Show', ['amplitude', 'phase'], 'part'],
    ['Heading', data.waves.heading_deg.map((h) => `${number(h)}°`), 'heading'],
  ]);
}

function alongLines(data) {
  if (data.lines.length === 0) return undefined;
  const state = { line: 0, heading: 0 };
  const spec = () => {
    const line = data.lines[state.line];
    const stations = line.s.length;
    const headings = data.waves.heading_deg.length;
    const curves = data.waves.omega.map((_, f) =>
      line.s.map((_, s) => {
        const i = (f * headings + state.heading) * stations + s;
        return Math.hypot(line.deflection[2 * i], line.deflection[2 * i + 1]);
      }),
    );
    const chosen = curves.length > 8 ? curves.map((_, i) => i).filter((i) => i % Math.ceil(curves.length / 8) === 0) : curves.map((_, i) => i);
    return {
      title: `Deflection along ${line.name}`,
      x: 's [m]',
      y: '|w| [m/m]',
      series: chosen.map((i) => `ω ${number(data.waves.omega[i])}`),
      values: [line.s, ...chosen.map((i) => curves[i])],
      range: [0, null],
    };
  };
  return chartCard('Along lines', state, spec, [
    ['Line', data.lines.map(({ name }) => name), 'line'],
    ['Heading', data.waves.heading_deg.map((h) => `${number(h)}°`), 'heading'],
  ]);
}

export const waves = (data) => element('div', { class: 'cards' }, overFrequency(data), alongLines(data));
