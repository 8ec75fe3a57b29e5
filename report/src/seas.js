// Response to seas: spectra at points, standard deviations and design values.
import { chartCard } from './charts.js';
import { chooser, element, table } from './dom.js';
import { inWords, number, withUnit } from './format.js';

// Statistics leave out the quantities of pressure: those have no numbers
const observed = (data, sea) =>
  data.quantities.map((_, q) => q).filter((q) => sea.statistics.std[q * data.points.length] !== null);

function spectra(data, sea) {
  const quantities = observed(data, sea);
  if (!sea.spectra || quantities.length === 0) return undefined;
  const state = { quantity: 0, mean: 0 };
  const count = sea.spectra.omega.length;
  const spec = () => {
    const quantity = data.quantities[quantities[state.quantity]];
    const curves = data.points.map((_, p) => {
      const first = ((state.mean * data.quantities.length + quantities[state.quantity]) * data.points.length + p) * count;
      return sea.spectra.values.subarray(first, first + count);
    });
    return {
      title: `Spectra of ${quantity.label} in sea ${sea.name}`,
      describe: data.points.map(({ name }, p) => `${name}: peak ${number(Math.max(...curves[p]))}`).join(', '),
      x: 'ω [rad/s]',
      y: `S [(${quantity.unit})²s/rad]`,
      series: data.points.map(({ name }) => name),
      values: [Array.from(sea.spectra.omega), ...curves.map((curve) => Array.from(curve))],
      range: [0, null],
    };
  };
  return chartCard(`Spectra, sea “${sea.name}”`, state, spec, [
    ['Quantity', quantities.map((q) => data.quantities[q].label), 'quantity'],
    ['Mean heading', sea.mean_heading_deg.map((h) => `${number(h)}°`), 'mean'],
  ]);
}

function statistics(data, sea) {
  const { std, zero_crossing_period: period, significant, most_probable_maximum: maximum } = sea.statistics;
  const rows = (m) =>
    observed(data, sea).flatMap((q) =>
      data.points.map((point, p) => {
        const { label, unit } = data.quantities[q];
        const i = (m * data.quantities.length + q) * data.points.length + p;
        return [
          label,
          point.name,
          withUnit(std[i], unit),
          period ? `${number(period[i])} s` : '–',
          significant ? withUnit(significant[i], unit) : '–',
          maximum ? withUnit(maximum[i], unit) : '–',
        ];
      }),
    );
  const head = ['quantity', 'point', 'std. deviation', 'period', 'significant', 'maximum'];
  const shown = (m) => table(`Sea ${sea.name}, mean heading ${number(sea.mean_heading_deg[m])}°`, head, rows(m), [2, 3, 4, 5]);
  const box = element('div', {}, shown(0));
  return element(
    'div',
    { class: 'card' },
    element('h3', {}, `Statistics, sea “${sea.name}”`),
    element('p', { class: 'note' }, `${inWords(sea.text ?? '')}. Period: of zero crossings. Significant, and the most probable maximum of the storm: single amplitudes.`),
    element(
      'div',
      { class: 'controls' },
      chooser('Mean heading', sea.mean_heading_deg.map((h) => `${number(h)}°`), (m) => box.replaceChildren(shown(m))),
    ),
    box,
  );
}

export const seas = (data) =>
  element('div', { class: 'cards' }, data.seas.map((sea) => [spectra(data, sea), statistics(data, sea)]).flat());
