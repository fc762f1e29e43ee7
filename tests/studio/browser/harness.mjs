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

const places = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];

export async function openStudio(folder) {
  const playwright = path.join(sources, 'studio/node_modules/playwright-core/index.mjs');
  if (!existsSync(playwright)) skip('playwright-core is missing; run npm ci in studio/');
  const chromium = places.find((place) => existsSync(place));
  if (!chromium) skip('no chromium is installed');
  const { chromium: engine } = await import(playwright);
  mkdirSync(pictures, { recursive: true });
  const flags = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
  const browser = await engine.launch({ executablePath: chromium, args: flags })
    .catch((error) => skip(`chromium does not start here: ${error.message.split('\n')[0]}`));
  const page = await browser.newPage({ viewport: { width: 1120, height: 700 } });
  const begun = Date.now() / 1000;
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
  return { page, address, faults, close, begun };
}

/** @param {boolean} holds @param {string} what */
export function expect(holds, what) {
  if (!holds) throw new Error(`expected: ${what}`);
}
