// What only a browser knows of the studio, written as JSON for the page of results:
//   node figures.mjs HADA SOURCES FOLDER && cp FOLDER/studio_figures.json BUILD
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { openStudio, pictures, program, sources } from './harness.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'hada-browser-'));
execFileSync(program, ['synth', path.join(sources, 'data_synthetic/papers/recycled_55.json'), '--size', '2048x2048', '-o', path.join(folder, 'sheet'), '--quiet']);
const crane = path.join(sources, 'data_synthetic/folds/crane.json');

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

const started = [];
for (let i = 0; i < 5; ++i) {
  const studio = await openStudio(folder, true);
  started.push(await studio.ready());
  await studio.close();
}
console.log('ready', started.map((s) => s.toFixed(2)).join(' '));
const studio = await openStudio(folder);
const { page } = studio;
await page.waitForSelector('#room-fold[data-at]');

// A wing of the crane is turned: from the pointer's move to the frame in which the answer is drawn.
await page.setInputFiles('#fold-open', crane);
await page.waitForFunction(() => Number(document.getElementById('room-fold').dataset.at) > 10);
await page.check('#fold-tool-turn');
const box = await page.locator('#fold-view').boundingBox();
const frames = await page.evaluate(async ([x, y]) => {
  const view = document.getElementById('fold-view');
  const send = (type, dx, dy) => view.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX: x + dx, clientY: y + dy, button: 0, bubbles: true }));
  view.setPointerCapture = () => {};
  send('pointerdown', 0, 0);
  await new Promise((resolve) => setTimeout(resolve, 500));
  const times = [];
  for (let i = 0; i < 60; ++i) {
    const from = performance.now();
    delete view.dataset.seen;
    send('pointermove', 40 + i, 10);
    while (!view.dataset.seen) await new Promise((resolve) => setTimeout(resolve));
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    times.push(performance.now() - from);
  }
  send('pointerup', 100, 10);
  return times;
}, [box.x + 0.5 * box.width, box.y + 0.5 * box.height]);

await page.click('#tab-surface');
await page.waitForSelector('#room-surface[data-shown]', { timeout: 60000 });
await page.waitForTimeout(1000);
const relight = await page.evaluate(async () => {
  const view = document.getElementById('surface-view');
  view.setPointerCapture = () => {};
  const box = view.getBoundingClientRect();
  const send = (type, i) => view.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, bubbles: true,
    clientX: box.left + box.width * (0.5 + 0.3 * Math.cos(i / 5)), clientY: box.top + box.height * (0.5 + 0.3 * Math.sin(i / 5)) }));
  send('pointerdown', 0);
  const from = performance.now();
  let count = 0;
  while (performance.now() - from < 3000) {
    send('pointermove', count);
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    view.querySelector('canvas').getContext('webgl2').finish();
    count += 1;
  }
  const gl = document.createElement('canvas').getContext('webgl2');
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return { fps: (1000 * count) / (performance.now() - from), renderer: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER) };
});
await studio.close();
rmSync(folder, { recursive: true });
const figures = {
  ready_s: median(started), drag_frame_ms: median(frames), relight_fps: relight.fps,
  renderer: /swiftshader/i.test(relight.renderer) ? 'SwiftShader, no graphics card' : relight.renderer,
};
writeFileSync(path.join(pictures, 'studio_figures.json'), JSON.stringify(figures, null, 1));
console.log(figures);
