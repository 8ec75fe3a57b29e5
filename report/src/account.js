// How the solution went: iterations and residuals, time and memory by stage, hydrodynamics.
import { Chart } from './charts.js';
import { element, table } from './dom.js';
import { bytes, duration, number } from './format.js';

export function convergence(data) {
  return table(
    'Solution of every frequency',
    ['ω [rad/s]', 'method', 'iterations', 'residual', 'Green function', 'reciprocity', 'energy', 'time'],
    data.convergence.map((r) => [
      number(r.omega, 4),
      r.method,
      r.iterations === 0 ? 'direct' : String(r.iterations),
      number(r.true_residual, 2),
      number(r.kernel_error, 2),
      number(r.reciprocity_error, 2),
      number(r.energy_error, 2),
      duration(r.seconds),
    ]),
    [0, 2, 3, 4, 5, 6, 7],
  );
}

export function timing(data) {
  return table(
    'Time and memory by stage',
    ['stage', 'time', 'peak memory so far'],
    [
      ...data.stages.map(({ stage, seconds, peak_memory }) => [stage, duration(seconds), bytes(peak_memory)]),
      ...(data.seconds_before > 0 ? [['earlier runs, resumed', duration(data.seconds_before), '']] : []),
    ],
    [1, 2],
  );
}

const names = ['heave', 'roll', 'pitch'];

// Added mass and damping of the three rigid modes of the first plate, mass-normalised
export function hydrodynamics(data) {
  if (!data.hydrodynamics || data.waves.omega.length < 2) return undefined;
  const curves = (values) =>
    names.map((_, mode) => data.waves.omega.map((_, f) => values[3 * f + mode]));
  const chart = (title, y, values) =>
    element(
      'div',
      { class: 'card' },
      element('h3', {}, title),
      new Chart({ title, x: 'ω [rad/s]', y, series: names, values: [data.waves.omega, ...curves(values)] }).box,
    );
  return element(
    'div',
    { class: 'cards' },
    chart('Added mass over mass', 'a [–]', data.hydrodynamics.added_mass),
    chart('Radiation damping over mass', 'b [1/s]', data.hydrodynamics.damping),
  );
}

export const caseFile = (data) =>
  element('pre', { tabindex: 0, 'aria-label': 'Case as solved' }, element('code', {}, data.case_text));
