// Response to seas: spectra at points, standard deviations and design values.
import { Chart } from './charts.js';
import { chooser, element, table } from './dom.js';
import { number, withUnit } from './format.js';

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
  const chart = new Chart(spec());
  const set = (name) => (index) => {
    state[name] = index;
    chart.update(spec());
  };
  return element(
    'div',
    { class: 'card' },
    element('h3', {}, `Spectra, sea “${sea.name}”`),
    element(
      'div',
      { class: 'controls' },
      chooser('Quantity', quantities.map((q) => data.quantities[q].label), set('quantity')),
      chooser('Mean heading', sea.mean_heading_deg.map((h) => `${number(h)}°`), set('mean')),
    ),
    chart.box,
  );
}

function statistics(data, sea) {
  const rows = [];
  sea.mean_heading_deg.forEach((mean, m) =>
    observed(data, sea).forEach((q) =>
      data.points.forEach((point, p) => {
        const quantity = data.quantities[q];
        const i = (m * data.quantities.length + q) * data.points.length + p;
        const { std, zero_crossing_period: period, significant, most_probable_maximum: maximum } = sea.statistics;
        rows.push([
          `${number(mean)}°`,
          quantity.label,
          point.name,
          withUnit(std[i], quantity.unit),
          period ? `${number(period[i])} s` : '–',
          significant ? withUnit(significant[i], quantity.unit) : '–',
          maximum ? withUnit(maximum[i], quantity.unit) : '–',
        ]);
      }),
    ),
  );
  return element(
    'div',
    { class: 'card wide' },
    element('h3', {}, `Statistics, sea “${sea.name}”`),
    element('p', { class: 'note' }, sea.text ?? ''),
    table(
      `Standard deviations and design values in sea ${sea.name}`,
      ['mean heading', 'quantity', 'point', 'standard deviation', 'zero-crossing period', 'significant', 'most probable maximum'],
      rows,
      [3, 4, 5, 6],
    ),
  );
}

export const seas = (data) =>
  element('div', { class: 'cards' }, data.seas.map((sea) => [spectra(data, sea), statistics(data, sea)]).flat());
