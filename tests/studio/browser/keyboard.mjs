// Every control of every room has a name, and Tab reaches it.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { drawn, expect, openStudio, program, sources } from './harness.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'hada-browser-'));
execFileSync(program, ['synth', path.join(sources, 'data_synthetic/papers/recycled_55.json'), '--size', '64x64', '-o', path.join(folder, 'paper'), '--quiet']);
execFileSync(program, ['photograph', path.join(sources, 'data_synthetic/sheet_and_spheres.json'), '-o', path.join(folder, 'photos'), '--quiet']);
const studio = await openStudio(folder);
const { page } = studio;

const controls = 'button, input, select, textarea, a[href], [tabindex="0"]';

/** What can be used of the page now, as a list of marks; each element carries its own. */
const usable = () => page.evaluate((which) => {
  let next = 0;
  return [...document.querySelectorAll(which)].filter((e) => e.checkVisibility() && !e.matches(':disabled')).map((e) => {
    // Of radios, and of the tabs of the rooms, one is reached; arrow keys go on from there.
    const group = e.type === 'radio' ? `radio ${e.name}` : e.getAttribute('role') === 'tab' ? 'tabs' : null;
    e.dataset.reach = group ?? `${(next += 1)}`;
    const name = e.getAttribute('aria-label') || e.labels?.[0]?.textContent.trim() || e.textContent.trim() || e.title || e.querySelector('img')?.alt;
    return { mark: e.dataset.reach, name, html: e.outerHTML.slice(0, 120) };
  });
}, controls);

async function room(name, ready) {
  await page.click(`#tab-${name}`);
  await page.waitForSelector(ready, { timeout: 60000 });
  await drawn(page);
  const there = await usable();
  const nameless = there.filter((control) => !control.name);
  expect(nameless.length === 0, `every control has a name: ${nameless.map((c) => c.html).join('\n')}`);
  await page.focus(`#tab-${name}`);
  await page.evaluate(() => {
    window.reached = [document.activeElement?.dataset?.reach];
    document.addEventListener('focusin', ({ target }) => window.reached.push(target.dataset.reach));
  });
  for (let i = 0; i < there.length + 5; ++i) await page.keyboard.press('Tab');
  const reached = new Set(await page.evaluate(() => window.reached));
  const missed = there.filter((control) => !reached.has(control.mark));
  expect(missed.length === 0, `Tab reaches every control of ${name}: ${missed.map((c) => c.html).join('\n')}`);
  console.log(`${name}: ${there.length} controls, all named and reached`);
}

try {
  await room('fold', '#room-fold[data-at]');
  await room('material', '#room-material[data-made]');
  await room('capture', '#room-capture[data-shown]');
  await room('surface', '#room-surface[data-shown]');
  await room('spectrum', '#room-spectrum[data-shown]');
  // The tabs themselves, by arrows.
  await page.focus('#tab-fold');
  await page.keyboard.press('ArrowRight');
  expect((await page.getAttribute('#tab-material', 'aria-selected')) === 'true', 'an arrow goes to the next room');
} catch (error) {
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await studio.close();
  rmSync(folder, { recursive: true });
}
