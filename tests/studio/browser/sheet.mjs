// Lines are drawn by a finger, faces pinned by pointer and by keys, the sheet is squashed, a folding is saved as files and as a film.
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { Hand } from './hand.mjs';
import { drawn, expect, openStudio, pictures, sources } from './harness.mjs';

const studio = await openStudio(sources);
const { page } = studio;
const hand = new Hand(page);
const shot = (name) => page.screenshot({ path: path.join(pictures, `${name}.png`) });
const heightOf = ({ vertices }) => {
  const z = vertices.filter((_, i) => i % 3 === 2);
  return Math.max(...z) - Math.min(...z);
};
const pins = async (count) => page.waitForFunction(async (n) =>
  (await (await fetch('api/fold/state')).json()).pins.length === n, count, { timeout: 10000, polling: 100 })
  .catch(() => expect(false, `there are ${count} pins`));

/** One finger draws a crease; two turn the view and draw nothing. */
async function fingers() {
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await touch('touchStart', await hand.at([0.5, 0.004]));
  for (const y of [0.3, 0.7, 0.996]) await touch('touchMove', await hand.at([0.5, y]));
  await touch('touchEnd');
  await hand.reached(1);
  const look = async () => (await page.locator('#fold-canvas').screenshot()).toString('base64');
  const before = await look();
  const [a, b] = [await hand.at([0.3, 0.3]), await hand.at([0.7, 0.7])];
  await touch('touchStart', a);
  await touch('touchStart', a, b);
  await touch('touchMove', [a[0] + 20, a[1]], [b[0] + 60, b[1] + 30]);
  await touch('touchEnd');
  await drawn(page);
  expect((await look()) !== before, 'two fingers turn the view');
  expect((await hand.done()) === 1, 'and draw nothing');
  await hand.look(false);
}

try {
  await page.waitForSelector('#room-fold[data-at]');
  await hand.look(false);
  await hand.choose('line', 'score');
  await fingers();
  await page.check('#fold-tool-turn');
  await hand.turn([0.8, 0.5], 60);
  expect(heightOf(await hand.state()) > 0.3, 'a face stands up');

  await page.check('#fold-tool-pin');
  const [x, y] = await hand.at([0.25, 0.5]);
  await page.mouse.click(x, y);
  await pins(1);
  await shot('pinned');
  // The crosshair begins in the middle of the view: to the left half of the sheet, by keys alone.
  await page.focus('#fold-view');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await pins(0);

  const before = await hand.state();
  await page.fill('#fold-share', '0.3');
  await page.focus('#fold-squash');
  await page.keyboard.press('Enter');
  await hand.reached(before.at + 1);
  const after = await hand.state();
  expect(heightOf(after) < 0.8 * heightOf(before), `it is pressed down: ${heightOf(before)} to ${heightOf(after)}`);
  expect(after.strain.most < 1e-3, `and hardly stretched: ${after.strain.most}`);
  await shot('squashed');
  // Strain and planarity as colours.
  const picture = async (by) => {
    await page.selectOption('#fold-colours', by);
    await drawn(page);
    return (await page.locator('#fold-canvas').screenshot()).toString('base64');
  };
  const paper = await picture('');
  for (const by of ['strain', 'planarity']) {
    expect((await picture(by)) !== paper, `faces are coloured by their ${by}`);
    expect(await page.locator('#fold-scale').isVisible(), 'and the scale is told');
  }
  await shot('planarity');
  await picture('');

  for (const link of await page.locator('#fold-export a').all()) {
    const [file] = await Promise.all([page.waitForEvent('download'), link.click()]);
    expect(readFileSync(await file.path()).length > 80, `${await link.textContent()} is saved`);
  }
  const frames = await page.evaluate(async () => (await fetch('api/fold/export?as=frames')).json());
  expect(frames.file_frames.length >= after.at, 'every step has its frame');
  const [film] = await Promise.all([page.waitForEvent('download', { timeout: 60000 }), page.click('#fold-film')]);
  const bytes = readFileSync(await film.path());
  expect(bytes.length > 2000 && bytes.readUInt32BE(0) === 0x1a45dfa3, `the film is a WebM: ${bytes.length} bytes`);
  expect(studio.faults.length === 0, `no fault in the page: ${studio.faults.join('; ')}`);
  console.log('pins, squash, files and film as they should be');
} catch (error) {
  await shot('failed_sheet');
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await studio.close();
}
