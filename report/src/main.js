// Puts the page together from the data that stands in it.
import 'uplot/dist/uPlot.min.css';
import './report.css';
import { caseFile, convergence, hydrodynamics, timing } from './account.js';
import { paintCharts } from './charts.js';
import { decode } from './data.js';
import { element, section } from './dom.js';
import { platePanel } from './plate_panel.js';
import { seas } from './seas.js';
import { checks, summary, warnings } from './summary.js';
import { waves } from './waves.js';

function build(data) {
  document.title = `${data.title || 'floe'} – floe report`;
  const parts = [
    warnings(data),
    element('div', { class: 'first' }, summary(data), platePanel(data)),
    data.seas?.length ? section('seas', 'In a sea', seas(data)) : undefined,
    section('waves', 'In regular waves', waves(data)),
    section('checks', 'Checks and convergence', checks(data), convergence(data)),
    section('account', 'How it was computed', hydrodynamics(data), timing(data)),
    section('case', 'Case as solved', caseFile(data)),
  ].filter(Boolean);
  const links = parts
    .filter((part) => part.tagName === 'SECTION' && part.querySelector('h2'))
    .map((part) => element('a', { href: `#${part.id}` }, part.querySelector('h2').textContent));
  document.body.append(
    element('a', { class: 'skip', href: '#content' }, 'To the content'),
    element('header', {}, element('h1', {}, data.title || 'floe report'), element('nav', { 'aria-label': 'Sections' }, links)),
    element('main', { id: 'content' }, parts),
    element(
      'footer',
      {},
      `Made by ${data.program.name} ${data.program.version}. SI units; per metre of wave amplitude; time factor exp(−iωt); the heading is where the wave travels to, from +x towards +y. Charts by uPlot (MIT licence, © Leon Sorokin).`,
    ),
  );
  paintCharts();
}

build(decode(JSON.parse(document.getElementById('floe-data').textContent)));
document.documentElement.dataset.ready = 'yes';
