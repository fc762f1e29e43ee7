// Rings and sectors answer to the pointer; a fit runs, is drawn with its intervals, and is cancelled.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { drawn, expect, openStudio, pictures, program, sources } from './harness.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'hada-browser-'));
const material = path.join(sources, 'data_synthetic/papers/recycled_55.json');
for (const [name, size] of [['paper', 400], ['wide', 900]]) {
  execFileSync(program, ['synth', material, '--size', `${size}x${size}`, '-o', path.join(folder, name), '--quiet']);
}
const studio = await openStudio(folder);
const { page } = studio;
const shot = (name) => page.screenshot({ path: path.join(pictures, `${name}.png`) });

/**
 * Holds the answer to a request back until the page has heard of it by events: either may come first.
 * @returns a function that resolves once the answer is there as well
 */
async function overtaken(verb, state) {
  let give = () => {};
  const given = new Promise((resolve) => (give = resolve));
  await page.route(`**/api/job/${verb}`, async (route) => {
    const answer = await route.fetch();
    await page.waitForFunction((ends) => document.body.dataset.job === ends, state, { polling: 50, timeout: 120000 });
    await route.fulfill({ response: answer });
    give();
  }, { times: 1 });
  return () => given;
}

const choose = async (name) => {
  await page.locator('#spectrum-list button', { hasText: name }).click();
  await page.waitForSelector(`#room-spectrum[data-shown=${name}]`, { timeout: 60000 });
};

async function look() {
  await page.click('#tab-spectrum');
  await page.waitForSelector('#room-spectrum[data-shown]', { timeout: 60000 });
  await choose('paper');
  const strongest = await page.textContent('#spectrum-chosen');
  const box = await page.locator('#spectrum-view image').boundingBox();
  await page.mouse.click(box.x + 0.8 * box.width, box.y + 0.5 * box.height);
  const clicked = await page.textContent('#spectrum-chosen');
  expect(clicked !== strongest && /Sector 0° to|Sector 175° to/.test(clicked), `the sector at the right is told: ${clicked}`);
  await page.focus('#spectrum-view');
  await page.keyboard.press('ArrowUp');
  const stepped = await page.textContent('#spectrum-chosen');
  expect(stepped !== clicked, 'a key chooses the next ring');
}

async function fit() {
  await overtaken('fit', 'done');
  await page.click('#spectrum-fit');
  await page.waitForSelector('#room-spectrum[data-fitted=wrinkle]', { timeout: 120000 });
  const numbers = await page.locator('#spectrum-parameters td').allTextContents();
  expect(numbers.some((text) => text.includes('±')), `the fit says how sure it is: ${numbers}`);
  expect((await page.locator('.ellipses .best').count()) > 0, 'the components are drawn');
  expect((await page.locator('.ellipses .bound').count()) > 0, 'and how far they are open');
  await page.check('#spectrum-expected');
  await shot('spectrum');
}

/** Pressed inside the page as its first line shows: a quick fit would be over before a pointer got there. */
const cancelAsSoonAsItSpeaks = () => page.evaluate(() => new Promise((resolve) => {
  const says = /** @type {HTMLElement} */ (document.getElementById('job-says'));
  const button = /** @type {HTMLElement} */ (document.getElementById('job-cancel'));
  const watch = new MutationObserver(() => {
    if (!says.textContent?.includes('...')) return;
    watch.disconnect();
    button.click();
    resolve(button.offsetParent !== null);
  });
  watch.observe(says, { childList: true });
}));

async function cancel() {
  await choose('wide');
  expect(await page.locator('#spectrum-model').isHidden(), 'another surface has no fit yet');
  const answered = await overtaken('cancel', 'cancelled');
  const cancelled = cancelAsSoonAsItSpeaks();
  await page.click('#spectrum-fit');
  expect(await cancelled, 'the button is there to be pressed');
  await shot('spectrum_fitting');
  await answered();
  await drawn(page);
  expect((await page.textContent('#said')).includes('cancelled'), 'it is said that the fit was cancelled');
  expect(await page.locator('#job').isHidden(), 'an answer that comes late does not bring the work back');
  expect(await page.locator('#spectrum-model').isHidden(), 'and nothing is shown of it');
}

try {
  await page.waitForSelector('#room-fold[data-at]');
  await look();
  await fit();
  await cancel();
  expect(studio.faults.length === 0, `no fault in the page: ${studio.faults.join('; ')}`);
  console.log('the spectrum, its fit and the end of a fit as they should be');
} catch (error) {
  await shot('failed_spectrum');
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await studio.close();
  rmSync(folder, { recursive: true });
}
