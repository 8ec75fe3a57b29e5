// The panel around the 3-D view: which wave, what the colours mean, play and pause, the legend.
import { cssGradient } from './colours.js';
import { bendingMoment, deflection, magnitudes } from './data.js';
import { chooser, element } from './dom.js';
import { number, withUnit } from './format.js';
import { Overlay } from './overlay.js';
import { PlateView } from './plate_view.js';

const dark = () => window.matchMedia('(prefers-color-scheme: dark)');

const themes = {
  light: { water: [0.36, 0.56, 0.68], ink: [0.1, 0.13, 0.17] },
  dark: { water: [0.13, 0.26, 0.35], ink: [0.92, 0.94, 0.96] },
};

// What the plate can be coloured by: {label, unit, map, values(motion, state) or null, range}
function colourings(data) {
  const choices = [
    { label: 'deflection, moving', unit: 'm/m', map: 'diverging', values: () => null },
    { label: 'amplitude |w|', unit: 'm/m', map: 'sequential', values: (motion) => magnitudes(motion) },
    {
      label: 'phase of w',
      unit: '°',
      map: 'cyclic',
      values: ({ re, im }) => re.map((value, i) => (Math.atan2(im[i], value) * 180) / Math.PI),
      range: [-180, 180],
    },
  ];
  for (const axis of data.moments ? ['x', 'y'] : [])
    choices.push({
      label: `bending moment M${axis}, amplitude`,
      unit: 'N m/m per m',
      map: 'sequential',
      values: (_, { frequency, heading }) => bendingMoment(data, axis, frequency, heading),
    });
  for (const sea of data.seas ?? [])
    (sea.mean_heading_deg ?? []).forEach((mean, i) => {
      if (!sea.std_map) return;
      const nodes = data.surface.x.length;
      choices.push({
        label: `standard deviation, ${sea.name}, ${number(mean)}°`,
        unit: 'm',
        map: 'sequential',
        values: () => sea.std_map.subarray(i * nodes, (i + 1) * nodes),
      });
    });
  return choices;
}

// The wave to show first: the one that bends the plate most, by the range of |w| over the plate
export function tellingWave(data) {
  let best = { frequency: 0, heading: 0, range: -1 };
  for (let frequency = 0; frequency < data.waves.omega.length; ++frequency)
    for (let heading = 0; heading < data.waves.heading_deg.length; ++heading) {
      const size = magnitudes(deflection(data, frequency, heading));
      const range = Math.max(...size) - Math.min(...size);
      if (range > best.range) best = { frequency, heading, range };
    }
  return best;
}

export function platePanel(data) {
  const { frequency, heading } = tellingWave(data);
  const state = { frequency, heading, colouring: 0, exaggeration: 1, playing: false };
  const choices = colourings(data);
  const canvas = element('canvas', {
    tabindex: 0,
    role: 'img',
    'aria-label': 'The plate in the wave, in three dimensions. Arrow keys turn it, plus and minus zoom, space plays, Home turns back.',
  });
  const readout = element('output', { class: 'readout', 'aria-live': 'off' });
  const legend = element('div', { class: 'legend' });
  let view;
  try {
    view = new PlateView(canvas, data.surface);
  } catch (error) {
    return element('p', { class: 'note' }, `The plate cannot be drawn in 3-D here: ${error.message}.`);
  }

  const overlay = new Overlay(view, data.surface, data.points);
  const moment = element('input', {
    type: 'range', min: 0, max: 1, step: 0.01, value: 0, id: 'moment',
    oninput: (event) => {
      toggle(false);
      view.phase = 2 * Math.PI * Number(event.target.value);
      view.draw();
    },
  });
  view.onframe = () => {
    overlay.update();
    if (state.playing) moment.value = view.phase / (2 * Math.PI);
  };

  let motion, shown;
  const showLegend = (range, { unit, map, label }) => {
    legend.replaceChildren(
      element('span', {}, /^N/.test(unit) ? withUnit(range[0], 'N').replace(/[A-Za-z ]+$/, '') : number(range[0])),
      element('span', { class: 'bar', style: `background: ${cssGradient(map)}`, role: 'img',
        'aria-label': `${label} from ${number(range[0])} to ${number(range[1])} ${unit}` }),
      element('span', {}, withUnit(range[1], unit)),
    );
  };

  const refresh = () => {
    motion = deflection(data, state.frequency, state.heading);
    const k = data.waves.wavenumber[state.frequency];
    const beta = (data.waves.heading_deg[state.heading] * Math.PI) / 180;
    const largest = Math.max(1, ...magnitudes(motion));
    view.setMotion(motion, [k * Math.cos(beta), k * Math.sin(beta)], (0.035 * view.size * state.exaggeration) / largest);
    const choice = choices[state.colouring];
    const values = choice.values(motion, state);
    shown = values;
    overlay.setHeading(beta);
    const size = Math.max(...magnitudes(motion));
    const top = values ? Math.max(...values) : size;
    const range = choice.range ?? (values ? [Math.min(0, ...values), top || 1] : [-size, size]);
    view.setColours(values, choice.map, range);
    showLegend(range, choice);
    view.draw();
  };

  view.onpoint = (node) => {
    if (node < 0) {
      readout.textContent = '';
      return;
    }
    const choice = choices[state.colouring];
    const value = shown?.[node] ?? Math.hypot(motion.re[node], motion.im[node]);
    const where = `x ${number(data.surface.x[node])} m, y ${number(data.surface.y[node])} m`;
    readout.textContent = `${where}: ${shown ? choice.label : '|w|'} ${withUnit(value, choice.unit)}`;
  };

  const play = element('button', { type: 'button', 'aria-pressed': 'false', onclick: () => toggle() }, 'Play');
  let last = 0;
  const step = (now) => {
    if (!state.playing) return;
    view.phase = (view.phase + (Math.min(100, now - last) / 1000) * 2 * Math.PI * 0.35) % (2 * Math.PI);
    last = now;
    view.draw();
    requestAnimationFrame(step);
  };
  const toggle = (on = !state.playing) => {
    state.playing = on;
    play.textContent = on ? 'Pause' : 'Play';
    play.setAttribute('aria-pressed', String(on));
    if (!on) return;
    last = performance.now();
    requestAnimationFrame(step);
  };
  canvas.addEventListener('keydown', (event) => {
    if (event.key !== ' ') return;
    event.preventDefault();
    toggle();
  });

  const set = (name) => (index) => {
    state[name] = index;
    refresh();
  };
  const factor = element('input', {
    type: 'range', min: -1, max: 1, step: 0.05, value: 0, id: 'exaggeration',
    oninput: (event) => {
      state.exaggeration = 10 ** Number(event.target.value);
      refresh();
    },
  });
  const waves = data.waves.omega.map(
    (omega, i) => `${number(omega)} rad/s (${number((2 * Math.PI) / omega)} s, λ ${number((2 * Math.PI) / data.waves.wavenumber[i])} m)`,
  );
  const controls = element(
    'div',
    { class: 'controls' },
    play,
    chooser('Wave', waves, set('frequency'), state.frequency),
    chooser('Heading', data.waves.heading_deg.map((h) => `${number(h)}°`), set('heading'), state.heading),
    chooser('Colour', choices.map(({ label }) => label), set('colouring')),
    element('span', { class: 'choice' }, element('label', { for: 'moment' }, 'Time'), moment),
    element('span', { class: 'choice' }, element('label', { for: 'exaggeration' }, 'Height'), factor),
    element('button', { type: 'button', onclick: () => view.reset() }, 'Reset view'),
  );

  const applyTheme = () => {
    view.setTheme(dark().matches ? themes.dark : themes.light);
    view.draw();
  };
  dark().addEventListener('change', applyTheme);
  view.setTheme(dark().matches ? themes.dark : themes.light);
  refresh();
  if (!window.matchMedia('(prefers-reduced-motion: reduce)').matches) toggle(true);
  return element(
    'figure',
    { class: 'plate' },
    element('div', { class: 'stage' }, canvas, overlay.box, readout),
    element('figcaption', {}, legend, controls,
      element('p', { class: 'note' }, 'Heights are exaggerated. The water shows the incident wave, joined to the plate at its edge. Drag or arrow keys turn, wheel on the focused view or + and - zoom, space plays.')),
  );
}
