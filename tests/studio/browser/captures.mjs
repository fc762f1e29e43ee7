// Spheres are found and shown, a circle that is off is corrected by a hand, a surface is reconstructed.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { drawn, expect, openStudio, pictures, program } from './harness.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'hada-browser-'));
const light = (slant_deg, azimuth_deg) => ({ slant_deg, azimuth_deg, strength: 1 });
const recipe = {
  hada: 'recipe/1', name: 'small',
  material: { material: 'wrinkle', parameters: { components: [{ amplitude_mm: 0.3, long_mm: 6, short_mm: 3, angle_rad: 0.4 }], floor_mm4: 0 } },
  sheet: { width_mm: 80, height_mm: 80, seed: 3 },
  rig: { pitch_mm: 0.4, rows: 220, cols: 360, oversampling: 2, sheet_place_mm: [-25, 0],
    lights: [light(30, 0), light(40, 90), light(35, 180), light(45, 270)], light_diameter_deg: 2,
    spheres: [{ kind: 'matte', place_mm: [45, 0], diameter_mm: 36, albedo: 0.7 }],
    table_albedo: 0.02, ambient: 0, exposure: 0.8, read_noise: 0.0005, shot_noise: 0.002, bits: 16, seed: 7 },
};
writeFileSync(path.join(folder, 'small.json'), JSON.stringify(recipe));
execFileSync(program, ['photograph', path.join(folder, 'small.json'), '-o', path.join(folder, 'photos'), '--quiet']);
const studio = await openStudio(folder);
const { page } = studio;
const shot = (name) => page.screenshot({ path: path.join(pictures, `${name}.png`) });

const done = async () => {
  await page.waitForFunction(() => ['done', 'failed'].includes(document.getElementById('room-capture').dataset.state), null, { timeout: 60000 });
  expect((await page.getAttribute('#room-capture', 'data-state')) === 'done', `the work is done: ${await page.textContent('#capture-says')}`);
};
const circle = () => page.evaluate(() => {
  const found = document.querySelector('#capture-large .sphere');
  return ['cx', 'cy', 'r'].map((name) => Number(found.getAttribute(name)));
});
const off = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

async function read() {
  await page.click('#capture-calibrate');
  await page.waitForFunction(() => document.getElementById('room-capture').dataset.state === 'running');
  await done();
  await page.waitForSelector('#capture-large .sphere-mark');
  await drawn(page);
  return circle();
}

try {
  await page.waitForSelector('#room-fold[data-at]');
  await page.click('#tab-capture');
  await page.waitForSelector('#room-capture[data-shown]'); // the first folder is opened by itself
  const found = await read();
  // The middle of the sphere lies 45 mm right of the middle of 360 pixels of 0.4 mm, its radius is 18 mm.
  expect(off(found, [180 + 45 / 0.4, 110, 18 / 0.4]) < 1, `the sphere is where it was put: ${found}`);
  expect((await page.locator('#capture-lights svg circle').count()) > 4, 'the lights are drawn');
  expect((await page.locator('#capture-large .highlight').count()) === 1, 'the sphere shows the light of this picture');
  const box = await page.locator('#capture-large .disc').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 12, y + 8);
  await page.mouse.up();
  await page.locator('#capture-large .sphere-mark').focus();
  await page.keyboard.press('+');
  const moved = await circle();
  expect(off(moved, found) > 2, `the circle follows the hand and the keys: ${moved}`);
  await shot('capture');
  const again = await read();
  expect(off(again, found) < 0.5, `it is found again from there: ${again}`);
  await page.click('#capture-reconstruct');
  await page.waitForFunction(() => document.getElementById('said').textContent.includes('among the surfaces'), null, { timeout: 60000 });
  await page.click('#tab-surface');
  await page.waitForSelector('#room-surface[data-shown]');
  const names = await page.locator('#surface-list button').allTextContents();
  expect(names.some((name) => name.startsWith('photos_surface')), `the surface is listed: ${names}`);
  expect(studio.faults.length === 0, `no fault in the page: ${studio.faults.join('; ')}`);
  console.log('captures as they should be');
} catch (error) {
  await shot('failed_captures');
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await studio.close();
  rmSync(folder, { recursive: true });
}
