// Takes the picture of the moving plate out of a report: node report/picture.js REPORT.html OUT.jpg [WAVE [COLOUR [PHASE [AWAY]]]]
//   WAVE    number of the frequency from 0, or -: the one that the report shows first
//   COLOUR  number of the colouring from 0;  PHASE  share of the period;  AWAY  steps to zoom out
import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

const [report, picture, wave = '-', colour = '0', phase = '0', away = '0'] = process.argv.slice(2);
const browser = await puppeteer.launch({
  executablePath: ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync),
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage'],
});
const tab = await browser.newPage();
await tab.setViewport({ width: 1480, height: 900 });
await tab.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }, { name: 'prefers-color-scheme', value: 'light' }]);
await tab.goto(pathToFileURL(resolve(report)).href, { waitUntil: 'load' });
const selects = await tab.$$('.plate select');
const choose = (select, index) => select.evaluate((node, i) => {
  node.selectedIndex = i;
  node.dispatchEvent(new Event('change'));
}, Number(index));
if (wave !== '-') await choose(selects[0], wave);
await choose(selects[2], colour);
await tab.$eval('#moment', (node, value) => {
  node.value = value;
  node.dispatchEvent(new Event('input'));
}, phase);
await tab.focus('.stage canvas');
for (let step = 0; step < Number(away); ++step) await tab.keyboard.press('-');
const type = picture.endsWith('.png') ? 'png' : 'jpeg';
await (await tab.$('.stage')).screenshot({ path: picture, type, ...(type === 'jpeg' ? { quality: 82 } : {}) });
await browser.close();
