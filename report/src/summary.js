// The first screen: what was solved, can it be trusted, how large are motions and moments, where.
import { bendingMoment, deflection, indexOfLargest, magnitudes, raoMagnitude } from './data.js';
import { element, table } from './dom.js';
import { counted, duration, inWords, number, withUnit } from './format.js';

const words = { good: 'good', attention: 'look', bad: 'bad' };

function verdict(data) {
  const { checks, warnings } = data;
  const bad = checks.filter(({ status }) => status === 'bad').length;
  const attention = checks.filter(({ status }) => status === 'attention').length;
  if (data.status !== 'complete') return ['bad', `The run did not finish: ${data.status}.`];
  if (bad > 0) return ['bad', `${counted(bad, 'check')} of ${checks.length} failed: read them before you use a number.`];
  if (attention > 0) return ['attention', `${counted(attention, 'check')} of ${checks.length} just outside the limit: read on below.`];
  if (warnings.length > 0) return ['attention', `All ${checks.length} checks passed, but there ${warnings.length === 1 ? 'is a warning' : `are ${warnings.length} warnings`} to read.`];
  return ['good', `Yes: all ${checks.length} checks passed.`];
}

// The checks in one sentence
function proof(data) {
  const value = (name) => data.checks.find((check) => check.name === name)?.value;
  const parts = [
    ['residual', (v) => `the fluid’s equation is solved to ${number(v, 2)}`],
    ['energy', (v) => `energy is conserved to ${number(v, 2)}`],
    ['nodes a wavelength', (v) => `the shortest wave has ${number(v, 2)} nodes`],
  ];
  const known = parts.filter(([name]) => value(name) !== undefined && value(name) !== null);
  const text = known.map(([name, say]) => say(value(name))).join(', ');
  return element('p', { class: 'proof' }, text ? `${text[0].toUpperCase()}${text.slice(1)}. ` : '', element('a', { href: '#checks' }, 'All checks'));
}

function thickness({ thickness: [thinnest, thickest] }) {
  if (thickest === 0) return 'as another program has modelled it';
  return `${number(thinnest)}${thickest > thinnest ? ` to ${number(thickest)}` : ''} m thick`;
}

function solved(data) {
  const { structure, waves } = data;
  const depth = structure.water.depth === null ? 'infinitely deep water' : `water ${number(structure.water.depth)} m deep`;
  const omega = waves.omega;
  const range = omega.length === 1 ? `ω = ${number(omega[0])} rad/s` : `ω from ${number(omega[0])} to ${number(omega.at(-1))} rad/s`;
  const extent = structure.extent.map((value) => number(value, 4)).join(' × ');
  const plates = structure.pieces > 1 ? `${structure.pieces} plates within ` : '';
  const seconds = data.stages.reduce((sum, { seconds: s }) => sum + s, data.seconds_before);
  const seas = (data.seas ?? []).map(
    (sea) => `Sea “${sea.name}”: ${inWords(sea.text ?? '')}; ${counted(sea.mean_heading_deg.length, 'mean heading')}`,
  );
  const shown = omega.length * waves.heading_deg.length;
  const some = shown < waves.computed ? `; shown are ${shown} of ${waves.computed} waves` : '';
  const route = data.route === 'direct' ? 'plate and water in one equation' : counted(data.modes.omega.length, 'mode');
  return [
    `${plates}${extent} m, ${thickness(structure.plate)}, on ${depth}`,
    `Regular waves: ${counted(omega.length, 'frequency').replace('frequencys', 'frequencies')}, ${range}; ${counted(waves.heading_deg.length, 'heading')}${some}`,
    ...(seas.length > 2 ? [`${seas.length} seas, described below`] : seas),
    `${counted(structure.nodes, 'node')}, ${route}, ${data.method} operator, ${duration(seconds)}`,
  ];
}

// Largest value over all waves and points of one quantity
function largestAtPoints(data, quantity) {
  let best = { value: -1 };
  data.waves.omega.forEach((omega, frequency) =>
    data.waves.heading_deg.forEach((heading, h) =>
      data.points.forEach((point, p) => {
        const value = raoMagnitude(data, quantity, frequency, h, p);
        if (value > best.value) best = { value, omega, heading, point };
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

function largestMoment(data, axis) {
  let best = { value: -1 };
  data.waves.omega.forEach((omega, frequency) =>
    data.waves.heading_deg.forEach((heading, h) => {
      const size = bendingMoment(data, axis, frequency, h);
      const node = indexOfLargest(size);
      if (size[node] > best.value)
        best = { value: size[node], omega, heading, x: data.surface.x[node], y: data.surface.y[node] };
    }),
  );
  return best;
}

// The map is a sum over the modes alone, the values at points are corrected: the larger one counts
function largestOfBoth(data, axis) {
  const best = largestMoment(data, axis);
  const q = data.quantities.findIndex(({ name }) => name === `bending_moment_${axis}`);
  if (q < 0 || data.points.length === 0) return best;
  const at = largestAtPoints(data, q);
  return at.value > best.value ? { ...at, ...at.point } : best;
}

const wave = ({ omega, heading }) => `ω ${number(omega)}, ${number(heading)}°`;
const place = ({ x, y }) => `(${number(x)}, ${number(y)})`;

// Largest standard deviation of a quantity of a sea over its mean headings and the points
function largestInSea(data, sea, q) {
  const { std, most_probable_maximum: maximum } = sea.statistics;
  let best = { std: -1 };
  sea.mean_heading_deg.forEach((mean, m) =>
    data.points.forEach((point, p) => {
      const i = (m * data.quantities.length + q) * data.points.length + p;
      if (std[i] !== null && std[i] > best.std) best = { std: std[i], maximum: maximum?.[i], mean, point };
    }),
  );
  return best;
}

function inSeas(data) {
  return (data.seas ?? []).slice(0, 2).map((sea) => {
    const rows = [];
    data.quantities.forEach((quantity, q) => {
      const best = largestInSea(data, sea, q);
      if (best.std < 0) return;
      rows.push([
        quantity.label,
        withUnit(best.std, quantity.unit),
        best.maximum ? withUnit(best.maximum, quantity.unit) : '–',
        `${best.point.name} ${place(best.point)}`,
        `${number(best.mean)}°`,
      ]);
    });
    const head = ['at the points', 'std. deviation', 'maximum', 'where', 'heading'];
    return rows.length ? table(`In sea “${sea.name}”, most probable maximum of the storm`, head, rows, [1, 2, 4]) : undefined;
  });
}

// Values over the whole plate where the page knows them, else over the points
function inRegularWaves(data) {
  const rows = [];
  const plate = (label, best, unit) => rows.push([label, withUnit(best.value, unit), place(best), wave(best)]);
  plate('deflection w', largestDeflection(data), 'm/m');
  if (data.moments)
    for (const axis of ['x', 'y']) plate(`bending moment M${axis}`, largestOfBoth(data, axis), 'N m/m per m');
  data.quantities.forEach((quantity, q) => {
    const known = quantity.name === 'deflection' || (data.moments && /^bending_moment/.test(quantity.name));
    if (data.points.length === 0 || known) return;
    const best = largestAtPoints(data, q);
    rows.push([`${quantity.label}, at the points`, withUnit(best.value, quantity.per_metre), `${best.point.name} ${place(best.point)}`, wave(best)]);
  });
  return table('In regular waves, per metre of wave amplitude (ω in rad/s; x, y in m)', ['largest', 'how large', 'where', 'in which wave'], rows, [1]);
}

export function summary(data) {
  const [status, sentence] = verdict(data);
  return element(
    'section',
    { id: 'summary', 'aria-label': 'Summary' },
    element('h2', {}, 'Can it be trusted'),
    element('p', { class: `verdict ${status}`, role: 'status' }, sentence),
    proof(data),
    element('h2', {}, 'What was solved'),
    element('ul', { class: 'plain' }, solved(data).map((line) => element('li', {}, line))),
    element('h2', {}, 'How large, and where'),
    inSeas(data),
    inRegularWaves(data),
  );
}

export function warnings(data) {
  if (data.warnings.length === 0) return undefined;
  return element(
    'section',
    { id: 'warnings', class: 'warnings', 'aria-label': 'Warnings' },
    element('h2', {}, 'Warnings'),
    element('ul', { tabindex: 0, 'aria-label': 'List of warnings' }, data.warnings.map((text) => element('li', {}, text))),
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
    'words',
  );
}
