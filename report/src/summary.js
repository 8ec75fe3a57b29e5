// The first screen: what was solved, can it be trusted, how large are motions and moments, where.
import { deflection, indexOfLargest, magnitudes, raoMagnitude } from './data.js';
import { element, table } from './dom.js';
import { counted, duration, number, withUnit } from './format.js';

const words = { good: 'good', attention: 'look', bad: 'bad' };

function verdict(data) {
  const { checks, warnings } = data;
  const bad = checks.filter(({ status }) => status === 'bad').length;
  const attention = checks.filter(({ status }) => status === 'attention').length + warnings.length;
  if (data.status !== 'complete') return ['bad', `The run did not finish: ${data.status}.`];
  if (bad > 0) return ['bad', `${counted(bad, 'check')} failed: read them before you use a number.`];
  if (attention > 0) return ['attention', `All checks passed but ${counted(attention, 'warning')} to read.`];
  return ['good', `All ${checks.length} checks passed.`];
}

function solved(data) {
  const { structure, waves } = data;
  const depth = structure.water.depth === null ? 'infinitely deep water' : `water ${number(structure.water.depth)} m deep`;
  const omega = waves.omega;
  const range = omega.length === 1 ? `ω = ${number(omega[0])} rad/s` : `ω from ${number(omega[0])} to ${number(omega.at(-1))} rad/s`;
  const extent = structure.extent.map((value) => number(value, 4)).join(' × ');
  const plates = structure.pieces > 1 ? `${structure.pieces} plates within ` : '';
  const seconds = data.stages.reduce((sum, { seconds: s }) => sum + s, 0);
  return [
    `${plates}${extent} m, ${number(structure.plate.thickness)} m thick, on ${depth}`,
    `${counted(omega.length, 'frequency').replace('frequencys', 'frequencies')}, ${range}; ${counted(waves.heading_deg.length, 'heading')}`,
    `${counted(structure.nodes, 'node')}, ${counted(data.modes.omega.length, 'mode')}, ${data.method} operator, ${duration(seconds)}`,
  ];
}

// Largest value over all waves and points of one quantity
function largestAtPoints(data, quantity) {
  let best = { value: -1 };
  data.waves.omega.forEach((omega, frequency) =>
    data.waves.heading_deg.forEach((heading, h) =>
      data.points.forEach((point, p) => {
        const value = raoMagnitude(data, quantity, frequency, h, p);
        if (value > best.value) best = { value, omega, heading, point: point.name };
      }),
    ),
  );
  return best;
}

function largestDeflection(data) {
  let best = { value: -1 };
  data.waves.omega.forEach((omega, frequency) =>
    data.waves.heading_deg.forEach((heading, h) => {
      const size = magnitudes(deflection(data, frequency, h));
      const node = indexOfLargest(size);
      if (size[node] > best.value)
        best = { value: size[node], omega, heading, x: data.surface.x[node], y: data.surface.y[node] };
    }),
  );
  return best;
}

const wave = ({ omega, heading }) => `ω ${number(omega)} rad/s, ${number(heading)}°`;

function seaRows(data) {
  const rows = [];
  for (const sea of data.seas ?? []) {
    const { mean_heading_deg: means, statistics } = sea;
    data.quantities.forEach((quantity, q) => {
      let best = { std: -1 };
      means.forEach((mean, m) =>
        data.points.forEach((point, p) => {
          const std = statistics.std[(m * data.quantities.length + q) * data.points.length + p];
          if (std !== null && std > best.std) best = { std, mean, point: point.name };
        }),
      );
      if (best.std >= 0)
        rows.push([
          `${quantity.label}, standard deviation in sea “${sea.name}”`,
          withUnit(best.std, quantity.unit),
          best.point,
          `mean heading ${number(best.mean)}°`,
        ]);
    });
  }
  return rows;
}

function largest(data) {
  const rows = [];
  const w = largestDeflection(data);
  rows.push(['deflection, whole plate', withUnit(w.value, 'm/m'), `(${number(w.x)}, ${number(w.y)}) m`, wave(w)]);
  data.quantities.forEach((quantity, q) => {
    if (data.points.length === 0) return;
    const best = largestAtPoints(data, q);
    rows.push([`${quantity.label}, at the points`, withUnit(best.value, quantity.per_metre), best.point, wave(best)]);
  });
  return table('Largest values', ['what', 'how large', 'where', 'in which wave'], [...seaRows(data), ...rows], [1, 2]);
}

export function summary(data) {
  const [status, sentence] = verdict(data);
  return element(
    'section',
    { id: 'summary', 'aria-label': 'Summary' },
    element('p', { class: `verdict ${status}`, role: 'status' }, sentence),
    element('h2', {}, 'What was solved'),
    element('ul', { class: 'plain' }, solved(data).map((line) => element('li', {}, line))),
    element('h2', {}, 'How large, and where'),
    largest(data),
  );
}

export function warnings(data) {
  if (data.warnings.length === 0) return undefined;
  return element(
    'section',
    { id: 'warnings', class: 'warnings', 'aria-label': 'Warnings' },
    element('h2', {}, 'Warnings'),
    element('ul', {}, data.warnings.map((text) => element('li', {}, text))),
  );
}

export function checks(data) {
  return table(
    'Checks that the program made of its own results',
    ['check', 'worst value', 'limit', '', 'what it means'],
    data.checks.map(({ name, value, threshold, status, text }) => [
      name,
      number(value, 2),
      number(threshold, 2),
      element('span', { class: `mark ${status}` }, words[status]),
      text,
    ]),
    [1, 2],
  );
}
