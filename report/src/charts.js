// Line charts by uPlot, in the page's colours; they follow the page's width and theme.
import uPlot from 'uplot';
import { chooser, element } from './dom.js';
import { number } from './format.js';

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const charts = new Set();

function axis(label, more = {}) {
  return {
    label,
    stroke: style('--text'),
    grid: { stroke: style('--grid'), width: 1 },
    ticks: { stroke: style('--grid'), width: 1 },
    font: '12px system-ui, sans-serif',
    labelFont: '12px system-ui, sans-serif',
    size: 56,
    values: (_, ticks) => ticks.map((tick) => (tick === null ? '' : number(tick))),
    ...more,
  };
}

function options(spec, width) {
  return {
    width,
    height: spec.height ?? 280,
    cursor: { points: { size: 6 } },
    scales: { x: { time: false }, y: { distr: spec.logarithmic ? 3 : 1, range: spec.range } },
    axes: [axis(spec.x), axis(spec.y, { size: 64 })],
    series: [
      { label: spec.x, value: (_, value) => number(value, 4) },
      ...spec.series.map((name, i) => ({
        label: name,
        stroke: style(`--line-${1 + (i % 8)}`),
        dash: [undefined, [9, 4], [3, 3], [9, 3, 3, 3]][i % 4],
        width: 2,
        points: { show: spec.values[0].length < 40, size: 5 },
        value: (_, value) => number(value),
      })),
    ],
  };
}

// {title, x, y, series: names, values: [x, y1, y2, …], range, logarithmic}; `describe` in words for
// those who do not see it
export class Chart {
  constructor(spec) {
    this.box = element('div', { class: 'chart', role: 'img' });
    this.update(spec);
    charts.add(this);
    new ResizeObserver(() => this.plot?.setSize({ width: this.width(), height: this.spec.height ?? 280 })).observe(this.box);
  }

  width() {
    return Math.max(260, this.box.clientWidth);
  }

  update(spec) {
    this.spec = spec;
    this.box.setAttribute('aria-label', `${spec.title}. ${spec.describe ?? ''}`);
    this.plot?.destroy();
    this.plot = null;
    if (this.box.isConnected) this.paint();
  }

  paint() {
    this.plot?.destroy();
    this.plot = new uPlot(options(this.spec, this.width()), this.spec.values, this.box);
  }
}

// A card with a chart of `spec()`, which reads `state`, and choosers [label, options, key of state]
export function chartCard(title, state, spec, choosers) {
  const chart = new Chart(spec());
  const controls = choosers.map(([label, options, key]) =>
    chooser(label, options, (index) => {
      state[key] = index;
      chart.update(spec());
    }),
  );
  return element('div', { class: 'card' }, element('h3', {}, title), element('div', { class: 'controls' }, ...controls), chart.box);
}

export function paintCharts() {
  for (const chart of charts) chart.paint();
}

window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paintCharts);
