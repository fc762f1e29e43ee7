// What only a browser knows of the studio, written as JSON for the page of results:
//   node figures.mjs HADA SOURCES FOLDER && cp FOLDER/studio_figures.json BUILD
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { openStudio, pictures, program, sources } from './harness.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'hada-browser-'));
execFileSync(program, ['synth', path.join(sources, 'data_synthetic/papers/recycled_55.json'), '--size', '2048x2048', '-o', path.join(folder, 'sheet'), '--quiet']);
const model = path.join(sources, 'data_synthetic/folds/snail.json');

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
await studio.ready();

// What the processor does for a frame that is not drawing: the page's own thread (events, script,
// layout, what is handed to the graphics card) by its clock of used time, and the server.
const session = await page.context().newCDPSession(page);
await session.send('Performance.enable', { timeDomain: 'threadTicks' });
const pageSeconds = async () => (await session.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'TaskDuration').value;
const ticks = Number(execFileSync('getconf', ['CLK_TCK']));
const serverSeconds = () => {
  const words = readFileSync(`/proc/${studio.server.pid}/stat`, 'utf8').split(') ')[1].split(' ');
  return (Number(words[11]) + Number(words[12])) / ticks;
};
/** Runs `frames` again and again. @returns {Promise<{shown: number[], page: number, server: number}>} ms of each frame; of the processor, a frame */
async function watched(frames, again) {
  const shown = [], spent = [];
  const before = serverSeconds();
  for (let i = 0; i < again; ++i) {
    const from = await pageSeconds();
    const times = await frames(i);
    spent.push((1000 * (await pageSeconds() - from)) / times.length);
    shown.push(...times);
  }
  return { shown, page: median(spent), server: (1000 * (serverSeconds() - before)) / shown.length };
}

// A face is turned: from the pointer's move to the frame in which the answer is drawn.
await page.setInputFiles('#fold-open', model);
await page.waitForFunction(() => Number(document.getElementById('room-fold').dataset.at) > 10);
await page.check('#fold-tool-turn');
const box = await page.locator('#fold-view').boundingBox();
const place = [box.x + 0.5 * box.width, box.y + 0.5 * box.height];
await page.mouse.move(...place);
await page.mouse.down();
const drag = await watched((batch) => page.evaluate(async ([x, y, turn]) => {
  const view = document.getElementById('fold-view');
  const times = [];
  for (let i = 0; i < 15; ++i) {
    const from = performance.now();
    const seen = new Promise((resolve) => {
      const watch = new MutationObserver(() => watch.disconnect() ?? resolve());
      watch.observe(view, { attributeFilter: ['data-seen'] });
    });
    view.dispatchEvent(new PointerEvent('pointermove', { pointerId: 1, clientX: x + 40 + 15 * turn + i, clientY: y + 10, bubbles: true }));
    await seen;
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    times.push(performance.now() - from);
  }
  return times;
}, [...place, batch]), 6);
const faces = await page.evaluate(async () => (await (await fetch('api/fold/state')).json()).faces.length);
if (!/turned by/.test(await page.textContent('#fold-facts'))) throw new Error('no face was turned');
await page.mouse.up();

await page.click('#tab-surface');
await page.waitForSelector('#room-surface[data-shown]', { timeout: 60000 });
await page.evaluate(() => { document.getElementById('surface-view').setPointerCapture = () => {}; });
const relight = await watched((batch) => page.evaluate(async (turn) => {
  const view = document.getElementById('surface-view');
  const box = view.getBoundingClientRect();
  const send = (type, i) => view.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, bubbles: true,
    clientX: box.left + box.width * (0.5 + 0.3 * Math.cos(i / 5)), clientY: box.top + box.height * (0.5 + 0.3 * Math.sin(i / 5)) }));
  send('pointerdown', turn);
  const times = [];
  for (let i = 0; i < 10; ++i) {
    const from = performance.now();
    send('pointermove', 10 * turn + i);
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    view.querySelector('canvas').getContext('webgl2').finish();
    times.push(performance.now() - from);
  }
  send('pointerup', turn);
  return times;
}, batch), 6);
const renderer = await page.evaluate(() => {
  const gl = document.createElement('canvas').getContext('webgl2');
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
});
await studio.close();
rmSync(folder, { recursive: true });
const figures = {
  ready_s: median(started), drag_faces: faces, drag_frame_ms: median(drag.shown), drag_page_ms: drag.page, drag_server_ms: drag.server,
  relight_fps: 1000 / median(relight.shown), relight_page_ms: relight.page + relight.server,
  renderer: /swiftshader/i.test(renderer) ? 'SwiftShader, no graphics card' : renderer,
};
writeFileSync(path.join(pictures, 'studio_figures.json'), JSON.stringify(figures, null, 1));
console.log(figures);
