// Opens the page as a reader would, in headless Chromium: no error, everything drawn, controls work.
//   FLOE_REPORT_PAGE  the page; FLOE_SCREENSHOTS  a folder to leave pictures in (optional)
import assert from 'node:assert/strict';
import { existsSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

const page = process.env.FLOE_REPORT_PAGE;
const browserPath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
let browser;

before(async () => {
  assert.ok(page && existsSync(page), `FLOE_REPORT_PAGE names no page: ${page}`);
  assert.ok(browserPath, 'no Chromium: run scripts/setup');
  browser = await puppeteer.launch({
    executablePath: browserPath,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage'],
  });
});

after(() => browser?.close());

async function open({ width = 1280, height = 800, scheme = 'light', file = page } = {}) {
  const tab = await browser.newPage();
  const complaints = [];
  tab.on('pageerror', (error) => complaints.push(error.message));
  tab.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  tab.on('request', (request) => {
    if (!request.url().startsWith('file:')) complaints.push(`asks the network for ${request.url()}`);
  });
  await tab.setViewport({ width, height });
  await tab.emulateMediaFeatures([
    { name: 'prefers-color-scheme', value: scheme },
    { name: 'prefers-reduced-motion', value: 'reduce' },
  ]);
  await tab.goto(pathToFileURL(file).href, { waitUntil: 'load' });
  await tab.waitForFunction(() => document.documentElement.dataset.ready === 'yes', { timeout: 20000 });
  return { tab, complaints };
}

async function shoot(tab, name, options = {}) {
  if (!process.env.FLOE_SCREENSHOTS) return;
  await tab.screenshot({ path: join(process.env.FLOE_SCREENSHOTS, `${name}.png`), ...options });
}

// How many different colours the 3-D view shows, and a sum that changes with the picture
const look = (tab) =>
  tab.evaluate(() => {
    const canvas = document.querySelector('.plate canvas');
    const copy = document.createElement('canvas');
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    const context = copy.getContext('2d');
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    const colours = new Set();
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      sum = (sum * 31 + data[i] + 2 * data[i + 1] + 3 * data[i + 2]) % 1000003;
    }
    return { colours: colours.size, sum };
  });

test('weighs less than five megabytes', () => assert.ok(statSync(page).size < 5e6));

test('loads without an error and draws plate and curves', async () => {
  const { tab, complaints } = await open();
  assert.ok((await look(tab)).colours > 50, 'the plate is not drawn');
  assert.ok((await tab.$$('.chart canvas')).length >= 2, 'curves are missing');
  await shoot(tab, 'light');
  await shoot(tab, 'light-full', { fullPage: true });
  assert.deepEqual(complaints, []);
  await tab.close();
});

test('answers what, whether to trust it, how large and where without scrolling', async () => {
  const { tab } = await open();
  const seen = await tab.evaluate(() => {
    const inside = (node) => node.getBoundingClientRect().bottom <= window.innerHeight;
    const parts = ['.verdict', '#summary .proof', '#summary .plain', '#summary .scroll', '.plate canvas', '.plate .controls'];
    return parts.flatMap((name) => [...document.querySelectorAll(name)].map((node) => [name, inside(node)]));
  });
  assert.deepEqual(seen.filter(([, inside]) => !inside), []);
  assert.equal(seen.length, 7, 'verdict, proof, what was solved, two tables, view, controls');
  const words = await tab.$eval('#summary', (node) => node.textContent);
  for (const part of ['checks passed', '300 × 60 m', 'deflection w', 'bending moment Mx', 'std. deviation', 'P5'])
    assert.ok(words.includes(part), `the summary does not say ${part}`);
  await tab.close();
});

test('the wave, the heading and every colouring can be chosen', async () => {
  const { tab, complaints } = await open();
  const selects = await tab.$$('.plate select');
  assert.equal(selects.length, 3);
  for (const select of selects) {
    const before = await look(tab);
    const other = await select.evaluate((node) => (node.selectedIndex === 0 ? node.options.length - 1 : 0));
    await select.evaluate((node, i) => {
      node.selectedIndex = i;
      node.dispatchEvent(new Event('change'));
    }, other);
    assert.notEqual((await look(tab)).sum, before.sum);
  }
  const colour = selects[2];
  const labels = await colour.evaluate((node) => [...node.options].map(({ text }) => text));
  for (const wanted of ['amplitude |w|', 'phase of w', 'bending moment Mx, amplitude', 'standard deviation, design, 0°'])
    assert.ok(labels.includes(wanted), `no map of ${wanted}`);
  const pictures = new Set();
  for (const label of labels.slice(0, 5)) {
    await colour.select(label);
    pictures.add((await look(tab)).sum);
  }
  assert.equal(pictures.size, 5, 'two maps look the same');
  await shoot(tab, 'chosen');
  assert.deepEqual(complaints, []);
  await tab.close();
});

test('turns by keys and plays over the wave period', async () => {
  const { tab } = await open();
  await tab.focus('.plate canvas');
  const start = await look(tab);
  await tab.keyboard.press('ArrowLeft');
  const turned = await look(tab);
  assert.notEqual(turned.sum, start.sum);
  await tab.keyboard.press(' ');
  await new Promise((resolve) => setTimeout(resolve, 600));
  assert.notEqual((await look(tab)).sum, turned.sum);
  assert.equal(await tab.$eval('.plate button', (node) => node.textContent), 'Pause');
  await tab.keyboard.press(' ');
  const paused = await look(tab);
  await new Promise((resolve) => setTimeout(resolve, 200));
  assert.equal((await look(tab)).sum, paused.sum);
  await tab.focus('#moment');
  await tab.keyboard.press('End');
  await tab.keyboard.press('PageDown');
  assert.notEqual((await look(tab)).sum, paused.sum, 'the time cannot be set by keys');
  await tab.close();
});

test('turns by the mouse, tells the value under it and comes back', async () => {
  const { tab, complaints } = await open();
  const box = await (await tab.$('.plate canvas')).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await tab.mouse.move(x, y);
  assert.match(await tab.$eval('.readout', (node) => node.textContent), /x .* m, y .* m: /);
  const start = await look(tab);
  await tab.mouse.down();
  await tab.mouse.move(x + 80, y + 30, { steps: 4 });
  await tab.mouse.up();
  assert.notEqual((await look(tab)).sum, start.sum);
  await tab.evaluate(() => [...document.querySelectorAll('button')].find((node) => node.textContent === 'Reset view').click());
  assert.equal((await look(tab)).sum, start.sum);
  assert.deepEqual(await tab.$$eval('.overlay text', (nodes) => nodes.map((node) => node.textContent)), ['wave', 'P1', 'P2', 'P3', 'P4', 'P5']);
  assert.deepEqual(complaints, []);
  await tab.close();
});

test('curves can be changed: quantity, phase, mean heading', async () => {
  const { tab, complaints } = await open();
  const labels = await tab.$$eval('#waves .chart, #seas .chart', (nodes) => nodes.map((node) => node.getAttribute('aria-label')));
  assert.ok(labels.some((label) => /Spectra/.test(label)) && labels.some((label) => /over the frequency/.test(label)));
  for (const select of await tab.$$('#waves select, #seas select')) {
    const last = await select.evaluate((node) => node.options[node.options.length - 1].text);
    await select.select(last);
  }
  const axis = await tab.$eval('#waves', (node) => node.querySelector('select:nth-of-type(1)').value);
  assert.ok(axis);
  assert.match(await tab.$eval('#seas caption', (node) => node.textContent), /mean heading 90°/);
  assert.deepEqual(complaints, []);
  await tab.close();
});

test('text of the user stays text', async () => {
  const { tab, complaints } = await open({ file: `${page}.hostile.html` });
  assert.match(await tab.$eval('h1', (node) => node.textContent), /^<\/script><script>window\.owned = 1/);
  assert.equal(await tab.evaluate(() => window.owned), undefined);
  assert.equal(await tab.$$eval('main img, main b', (nodes) => nodes.length), 0);
  const first = await tab.$eval('main', (node) => node.firstElementChild.id);
  assert.equal(first, 'warnings', 'warnings come first');
  assert.deepEqual(complaints, []);
  await shoot(tab, 'hostile');
  await tab.close();
});

test('shows a run of the direct route by its stored waves', async () => {
  const { tab, complaints } = await open({ file: `${page}.direct.html` });
  const words = await tab.$eval('#summary', (node) => node.textContent);
  for (const part of ['plate and water in one equation', 'shown are 4 of 9 waves', 'bending moment Mx'])
    assert.ok(words.includes(part), `the summary does not say ${part}`);
  const colour = (await tab.$$('.plate select'))[2];
  const labels = await colour.evaluate((node) => [...node.options].map(({ text }) => text));
  const pictures = new Set();
  for (const label of labels) {
    await colour.select(label);
    pictures.add((await look(tab)).sum);
  }
  assert.equal(pictures.size, labels.length, 'two maps look the same');
  assert.deepEqual(complaints, []);
  await shoot(tab, 'direct');
  await tab.close();
});

test('works dark and narrow without sideways scrolling', async () => {
  const { tab, complaints } = await open({ width: 360, height: 800, scheme: 'dark' });
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), true);
  assert.ok((await look(tab)).colours > 50, 'the plate is not drawn');
  await shoot(tab, 'dark-narrow', { fullPage: true });
  assert.deepEqual(complaints, []);
  await tab.close();
  for (const [name, options] of [['dark', { scheme: 'dark' }], ['wide', { width: 1920, height: 1080 }]]) {
    const wide = await open(options);
    assert.equal(await wide.tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), true);
    await shoot(wide.tab, name);
    await wide.tab.close();
  }
});

test('every control has a name, every section a heading', async () => {
  const { tab } = await open();
  const nameless = await tab.evaluate(() =>
    [...document.querySelectorAll('select, input, button, canvas[role], .chart')]
      .filter((node) => !(node.getAttribute('aria-label') || node.textContent.trim() || node.labels?.length))
      .map((node) => node.outerHTML.slice(0, 80)),
  );
  assert.deepEqual(nameless, []);
  const spoken = [];
  const collect = (node) => {
    if (['button', 'combobox', 'slider', 'image', 'region'].includes(node.role)) spoken.push([node.role, node.name ?? '']);
    (node.children ?? []).forEach(collect);
  };
  collect(await tab.accessibility.snapshot({ interestingOnly: false }));
  assert.ok(spoken.length > 15, `only ${spoken.length} things are told to a screen reader`);
  assert.deepEqual(spoken.filter(([, name]) => name.trim() === ''), []);
  assert.ok(await tab.evaluate(() => [...document.querySelectorAll('main section')].every((s) => s.querySelector('h2'))));
  await tab.close();
});
