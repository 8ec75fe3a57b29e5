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

async function open({ width = 1280, height = 800, scheme = 'light' } = {}) {
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
  await tab.goto(pathToFileURL(page).href, { waitUntil: 'load' });
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
    return ['.verdict', '#summary .plain', '#summary table', '.plate canvas'].map(
      (name) => inside(document.querySelector(name)),
    );
  });
  assert.deepEqual(seen, [true, true, true, true]);
  await tab.close();
});

test('the wave, the heading and the colours can be chosen', async () => {
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
  await tab.close();
});

test('works dark and narrow without sideways scrolling', async () => {
  const { tab, complaints } = await open({ width: 390, height: 800, scheme: 'dark' });
  assert.equal(await tab.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), true);
  await shoot(tab, 'dark-narrow', { fullPage: true });
  assert.deepEqual(complaints, []);
  await tab.close();
  const wide = await open({ scheme: 'dark' });
  await shoot(wide.tab, 'dark');
  await wide.tab.close();
});

test('every control has a name, every section a heading', async () => {
  const { tab } = await open();
  const nameless = await tab.evaluate(() =>
    [...document.querySelectorAll('select, input, button, canvas[role], .chart')]
      .filter((node) => !(node.getAttribute('aria-label') || node.textContent.trim() || node.labels?.length))
      .map((node) => node.outerHTML.slice(0, 80)),
  );
  assert.deepEqual(nameless, []);
  assert.ok(await tab.evaluate(() => [...document.querySelectorAll('main section')].every((s) => s.querySelector('h2'))));
  await tab.close();
});
