// A studio and a browser that runs while a test does.
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import path from 'node:path';

export const skipped = 77; // what ctest takes for "left out"

/** @param {string} why */
export function skip(why) {
  console.log(`left out: ${why}`);
  process.exit(skipped);
}

/** What the test was started with: the program, the sources, where pictures are kept. */
export const [program, sources, pictures] = process.argv.slice(2).map((word) => path.resolve(word));

const places = [process.env.CHROMIUM ?? '', '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
// What the browser does for itself and no test needs: above all the page behind its address bar,
// which costs more than a second of the processor at every start.
const idle = ['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'PreloadTopChromeWebUI', 'Translate', 'MediaRouter', 'OptimizationHints',
  'HttpsUpgrades', 'DestroyProfileOnBrowserClose'];

/** Resolves once the browser has come to rest: its own beginning is no time of the studio's. */
async function atRest(browser) {
  const session = await browser.newBrowserCDPSession();
  const used = async () => (await session.send('SystemInfo.getProcessInfo')).processInfo.reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  let before = await used();
  for (let quiet = 0, tries = 0; quiet < 4 && tries < 60; ++tries) {
    await new Promise((resolve) => setTimeout(resolve, 250));
    const now = await used();
    quiet = now - before < 0.03 ? quiet + 1 : 0;
    before = now;
  }
  await session.detach();
}

/** @param {string} folder @param {boolean} [timed] waits until the browser itself has begun */
export async function openStudio(folder, timed = false) {
  const playwright = path.join(sources, 'studio/node_modules/playwright-core/index.mjs');
  if (!existsSync(playwright)) skip('playwright-core is missing; run npm ci in studio/');
  const chromium = places.find((place) => existsSync(place));
  if (!chromium) skip('no chromium is installed');
  const { chromium: engine } = await import(playwright);
  mkdirSync(pictures, { recursive: true });
  const flags = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    `--disable-features=${idle.join(',')}`];
  const browser = await engine.launch({ executablePath: chromium, args: flags })
    .catch((error) => skip(`chromium does not start here: ${error.message.split('\n')[0]}`));
  const page = await browser.newPage({ viewport: { width: 1120, height: 700 } });
  // When the sheet can be folded: it is there, and a frame was drawn since. By the page's own clock,
  // for a question from outside would take the time of its answer.
  await page.addInitScript(() => {
    const watch = new MutationObserver(() => {
      if (!document.querySelector('#room-fold[data-at]:not([hidden])')) return;
      watch.disconnect();
      requestAnimationFrame(() => (window.foldable = performance.timeOrigin + performance.now()));
    });
    watch.observe(document, { subtree: true, childList: true, attributeFilter: ['data-at'] });
  });
  if (timed) await atRest(browser);
  const begun = Date.now();
  const server = spawn(program, ['studio', '--no-browser', '--json', folder], { stdio: ['ignore', 'pipe', 'inherit'] });
  const address = await new Promise((resolve, reject) => {
    server.stdout.once('data', (text) => resolve(JSON.parse(text).address));
    server.once('exit', (code) => reject(new Error(`hada studio ended with ${code}`)));
  });
  const faults = [];
  page.on('pageerror', (error) => faults.push(error.message));
  page.on('console', (line) => line.type() === 'error' && faults.push(line.text()));
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(address) && !/^(data|blob):/.test(url)) faults.push(`a request left the machine: ${url}`);
  });
  await page.goto(address);
  const close = async () => {
    await browser.close();
    server.kill();
  };
  /** Seconds from the start of the program to a sheet that can be folded. */
  const ready = async () => (await (await page.waitForFunction(() => window.foldable, null, { polling: 100 })).jsonValue() - begun) / 1000;
  return { page, address, faults, close, ready, server };
}

/** @param {boolean} holds @param {string} what */
export function expect(holds, what) {
  if (!holds) throw new Error(`expected: ${what}`);
}

/**
 * Waits inside the page until what an element says of itself (`data-name`) is `value`.
 * @throws Error after half a minute
 */
export function until(page, selector, name, value) {
  return page.evaluate(([what, attribute, wanted]) => new Promise((resolve, reject) => {
    const element = document.querySelector(what);
    const look = () => {
      if (element.dataset[attribute] !== wanted) return;
      watch.disconnect();
      clearTimeout(late);
      resolve();
    };
    const watch = new MutationObserver(look);
    const late = setTimeout(() => reject(new Error(`${what} did not become ${attribute} ${wanted}, but ${element.dataset[attribute]}`)), 30000);
    watch.observe(element, { attributes: true });
    look();
  }), [selector, name, String(value)]);
}

/** Resolves once what was asked for is drawn: its frame, and the one that shows it. */
export function drawn(page) {
  return page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}
