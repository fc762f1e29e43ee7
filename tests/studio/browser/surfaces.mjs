// Sliders change what a material looks like, the light changes what a surface looks like.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { drawn, expect, openStudio, pictures, program, sources } from './harness.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'hada-browser-'));
const material = path.join(sources, 'data_synthetic/papers/recycled_55.json');
execFileSync(program, ['synth', material, '--size', '400x400', '-o', path.join(folder, 'paper'), '--quiet']);
symlinkSync('/etc', path.join(folder, 'elsewhere'));
const studio = await openStudio(folder);
const { page } = studio;
const shot = (name) => page.screenshot({ path: path.join(pictures, `${name}.png`) });
const seen = async (room) => {
  await drawn(page);
  return (await page.locator(`#${room}-view canvas`).screenshot()).toString('base64');
};

async function made(change) {
  const count = async () => Number((await page.getAttribute('#room-material', 'data-made')) ?? 0);
  const before = await count();
  await change();
  await page.waitForFunction((n) => Number(document.getElementById('room-material').dataset.made ?? 0) > n, before,
    { polling: 20, timeout: 30000 });
  return seen('material');
}

async function materials() {
  const first = await made(() => page.click('#tab-material'));
  const table = await page.evaluate(async () => (await fetch('api/material/tables')).json());
  expect(table.materials.length >= 4, 'all materials are offered');
  const again = await seen('material');
  expect(first === again, 'what is not touched stays as it is');
  const slider = page.locator('#material-fields input[type=range]').nth(1);
  await slider.focus();
  const changed = await made(() => page.keyboard.press('PageUp'));
  expect(changed !== first, 'a slider, moved by a key, changes the preview');
  for (const { name } of table.materials.slice(1)) {
    await made(() => page.selectOption('#material-name', name));
    // Every field of the table has a control of that name.
    const fields = table.materials.find((m) => m.name === name).fields.map((field) => field.name);
    for (const field of fields) {
      expect((await page.locator(`#material-fields [data-field="${field}"]`).count()) > 0, `${name} has ${field}`);
    }
    await shot(`material_${name}`);
    await solid(name);
  }
  await page.selectOption('#material-name', 'forged');
  const sequence = page.locator('#material-fields [data-field=sequence]');
  await sequence.fill('nonsense');
  await sequence.press('Enter');
  await page.waitForFunction(() => document.getElementById('said').dataset.kind === 'error');
}

// Steel as a blade, wood as a block whose cut is dragged, a knit on a leg.
async function solid(name) {
  if (!['forged', 'wood', 'knit'].includes(name)) return;
  const count = async () => Number((await page.getAttribute('#room-material', 'data-solid')) ?? 0);
  const shown = async (change) => {
    const before = await count();
    await change();
    await page.waitForFunction((n) => Number(document.getElementById('room-material').dataset.solid ?? 0) > n, before, { polling: 20, timeout: 60000 });
    await drawn(page);
    return (await page.locator('#material-solid canvas').screenshot()).toString('base64');
  };
  const first = await shown(() => page.selectOption('#material-body', name));
  await shot(`solid_${name}`);
  if (name === 'wood') {
    const depth = await page.inputValue('#block-depth');
    const box = await page.locator('#material-solid').boundingBox();
    const dragged = await shown(async () => {
      await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.45 * box.height);
      await page.mouse.down();
      await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.35 * box.height);
      await page.mouse.up();
    });
    expect(dragged !== first && depth !== (await page.inputValue('#block-depth')), 'the cut follows the hand');
  }
  await made(() => page.selectOption('#material-body', ''));
}

async function surfaces() {
  await page.click('#tab-surface');
  await page.waitForSelector('#surface-list button');
  const names = await page.locator('#surface-list button').allTextContents();
  expect(names.some((name) => name.startsWith('paper')), `the surface is listed: ${names}`);
  expect(!names.some((name) => name.includes('elsewhere')), 'nothing behind a link is listed');
  await page.waitForSelector('#room-surface[data-shown]'); // the first is opened by itself
  await page.fill('#surface-exaggeration', '8');
  const box = await page.locator('#surface-view').boundingBox();
  const lit = async (x, y) => {
    await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + x * box.width + 2, box.y + y * box.height);
    await page.mouse.up();
    return seen('surface');
  };
  const left = await lit(0.3, 0.4);
  const right = await lit(0.7, 0.6);
  expect(left !== right, 'the light in the hand changes the picture');
  expect(left === (await lit(0.3, 0.4)), 'the same light gives the same picture');
  expect((await page.textContent('#surface-under')).includes('height'), 'the value under the pointer is told');
  await shot('surface');
  await page.selectOption('#surface-look', '2');
  await seen('surface');
  await shot('surface_height');
  await page.selectOption('#surface-look', '0');
}

// A profile across it, a material beside it, and both in space.
async function compared() {
  await page.check('#surface-tool-profile');
  const box = await page.locator('#surface-view').boundingBox();
  const plot = async () => (await page.locator('#surface-profile').screenshot()).toString('base64');
  const first = await plot();
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.3 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.7 * box.height);
  await page.mouse.up();
  const drawn = await plot();
  expect(first !== drawn, 'a profile follows the pointer');
  await page.focus('#surface-view');
  await page.keyboard.press('ArrowLeft');
  expect(drawn !== (await plot()), 'keys move the profile');
  await page.setInputFiles('#surface-open', material);
  await page.waitForSelector('#room-surface[data-beside=wrinkle]');
  await seen('surface');
  await shot('surface_beside');
  await page.check('#surface-space');
  const before = await seen('surface');
  await page.keyboard.press('Tab');
  await page.focus('#surface-view');
  await page.keyboard.press('Alt+ArrowLeft');
  expect(before !== (await seen('surface')), 'keys turn it in space');
  await shot('surface_space');
  await page.click('#surface-alone');
  await page.uncheck('#surface-space');
}

try {
  await page.waitForSelector('#room-fold[data-at]');
  await materials();
  await surfaces();
  await compared();
  const faults = studio.faults.filter((fault) => !fault.includes('422')); // the nonsense, as it should be
  expect(faults.length === 0, `no fault in the page: ${faults.join('; ')}`);
  console.log('materials and surfaces as they should be');
} catch (error) {
  await shot('failed_surfaces');
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await studio.close();
  rmSync(folder, { recursive: true });
}
