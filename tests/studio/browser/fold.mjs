// The boat, the crane and the snail are folded by a hand, and end as their recorded logs do.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { difference } from './fold_file.mjs';
import { Hand } from './hand.mjs';
import { expect, openStudio, pictures, program, sources } from './harness.mjs';

const scratch = mkdtempSync(path.join(tmpdir(), 'hada-browser-'));
const studio = await openStudio(sources);
const { page } = studio;
const hand = new Hand(page);
const shot = (name) => page.screenshot({ path: path.join(pictures, `${name}.png`) });

const fileOf = (name) => path.join(sources, 'data_synthetic/folds', `${name}.json`);

/** The published snail reverses its horns along a line that no guide shows; a hand takes the guide at 22.5 degrees. */
function hornsAlongGuides(log) {
  const [x, y, way] = [0.5 + 0.75 * Math.SQRT1_2, 0.5, Math.PI / 8];
  const place = (along, up) => [x + 0.1 * along * Math.cos(way), y + 0.1 * up * Math.sin(way)];
  Object.assign(log.steps[26], { from: place(1, 1), to: place(-1, -1) });
  Object.assign(log.steps[29], { from: place(-1, 1), to: place(1, -1) });
}

function recorded(name, change = () => {}) {
  const log = JSON.parse(readFileSync(fileOf(name), 'utf8'));
  change(log);
  const [file, folder] = [path.join(scratch, `${name}.json`), path.join(scratch, name)];
  writeFileSync(file, JSON.stringify(log));
  execFileSync(program, ['fold', 'replay', file, '-o', folder, '--quiet']);
  return { model: JSON.parse(readFileSync(path.join(folder, 'model.fold'), 'utf8')), steps: log.steps };
}

async function endsAs(name, change) {
  const model = await page.evaluate(async () => (await fetch('api/fold/export?as=fold')).json());
  const differs = difference(model, recorded(name, change).model);
  expect(differs === '', `the ${name} folded by hand is the recorded one: ${differs}`);
  console.log(`${name}: ${model.faces_vertices.length} faces, as recorded`);
}

async function boat() {
  await page.click('#fold-new');
  await hand.look(false);
  await hand.choose('line', 'through');
  await hand.choose('side', 'left');
  await hand.step([1, 0], [0, 1]);
  await hand.parts(10, 4);
  await hand.step([0.3, 1], [1, 0.3]);
  await endsAs('boat');
  await shot('boat');
}

async function crane() {
  const { steps } = recorded('crane');
  await page.click('#fold-new');
  await hand.look(false);
  await hand.parts(2, 4);
  await hand.choose('line', 'fold');
  for (const step of steps.slice(0, 14)) await hand.step(step.from, step.to);
  await hand.move(...(await hand.at([0.2071, 0.5])));
  await shot('pattern');
  await page.click('#fold-flatten');
  await hand.reached(15);
  // The legs are narrowed along the directions that halve their tips.
  await hand.choose('line', 'through');
  await hand.parts(2, 2);
  await hand.choose('side', 'right');
  await hand.step([0, 0], [0.9, 0.9 * Math.tan((33.75 * Math.PI) / 180)], [9, -6]);
  await hand.choose('side', 'left');
  await hand.step([0, 0], [0.9 * Math.tan((33.75 * Math.PI) / 180), 0.9], [6, -9]);
  await shot('bird');
  // Neck, tail and head from division to division.
  await hand.parts(7, 2);
  for (const step of steps.slice(17, 19)) await hand.step(step.from, step.to);
  await hand.parts(4, 2);
  await hand.step(steps[19].from, steps[19].to);
  // The wings turn about one axis, the second seen from behind.
  await hand.parts(8, 2);
  await hand.choose('line', 'axis');
  await hand.stroke(steps[20].from, steps[20].to);
  await hand.choose('layers', 'top');
  await hand.turn([0.66, 0.66], 78);
  await shot('wing');
  await hand.look(true);
  await hand.turn([0.66, 0.66], -78);
  await endsAs('crane');
}

// How a hand draws the folds of the snail: edges and corners in parts, from and to, what
// moves, and whether the line goes on both ways.
const snailStrokes = [
  [2, 4, [0.5, 0], [0.5, 1.12], 'left'],
  [2, 8, [0.5, 0.5], [1.214, 0.796], 'left'],
  [2, 3, [0.5, 0.5], [1.214, 0.204], 'right'],
  [2, 3, [0.5, 0.5], [1.214, 0.204], 'right'],
  [2, 3, [0.5, 0.5], [1.214, 0.796], 'left'],
  [2, 4, [1.2071, 0.5], [0.493, 0.204], 'left'],
  [2, 8, [1.2071, 0.5], [0.409, 0.341], 'left'],
  [2, 3, [1.2071, 0.5], [0.431, 0.292], 'left'],
  [2, 3, [1.2071, 0.5], [0.431, 0.292], 'left'],
  [2, 8, [1.2071, 0.5], [0.619, 0.893], 'right'],
  [2, 8, [1.2071, 0.5], [0.409, 0.659], 'right'],
  [2, 8, [1.2071, 0.5], [0.409, 0.341], 'left'],
  [2, 8, [1.2071, 0.5], [0.493, 0.796], 'right'],
  [2, 8, [1.2071, 0.5], [0.409, 0.659], 'right'],
  [2, 8, [1.2071, 0.5], [0.409, 0.659], 'right'],
  [2, 4, [1.2071, 0.5], [0.431, 0.708], 'right'],
  [2, 4, [1.2071, 0.5], [0.431, 0.708], 'right'],
  [2, 8, [0.8536, 0.4297], [0.8536, 0.4652], 'left', true],
  [4, 2, [0.9445, 0.5], [0.942, 0.265], 'left', true],
  [2, 4, [1.2071, 0.5], [0.557, 0.5], 'right'],
  [2, 4, [0.6768, 0.5], [1.327, 0.5], 'left'],
  [2, 4, [1.2071, 0.5], [0.557, 0.5], 'left'],
  [2, 4, [0.6768, 0.5], [1.327, 0.5], 'right'],
  [4, 2, [1.1187, 0.5], [1.119, 0.265], 'left', true],
  [2, 4, [1.2071, 0.5], [0.557, 0.5], 'left'],
  [2, 4, [1.2071, 0.5], [0.557, 0.5], 'left'],
  [2, 8, [1.0303, 0.5], [0.618, 0.329], 'left', true],
  [2, 4, [1.2071, 0.5], [0.557, 0.5], 'right'],
  [2, 4, [1.2071, 0.5], [0.557, 0.5], 'right'],
  [2, 8, [1.0303, 0.5], [1.292, 0.392], 'left', true],
];

async function snail() {
  const { steps } = recorded('snail', hornsAlongGuides);
  await page.click('#fold-new');
  await hand.choose('line', 'through');
  for (const [i, [edges, corners, from, to, side, bothWays = false]] of snailStrokes.entries()) {
    const { faces = [], mountains = [], valleys = [], stiff = false } = steps[i];
    await hand.look(false);
    await hand.parts(edges, corners);
    await hand.choose('side', side);
    await hand.tick('stiff', stiff);
    await hand.tick('endless', bothWays);
    await hand.choose('layers', faces.length > 0 ? 'chosen' : 'all');
    await hand.pick('face', faces);
    await hand.pick('M', mountains);
    await hand.pick('V', valleys);
    if (i === 18) await shot('chosen');
    await hand.step(from, to);
  }
  await endsAs('snail', hornsAlongGuides);
  await shot('snail');
  await hand.choose('layers', 'all');
  await hand.tick('stiff', false);
  await hand.tick('endless', false);
}

try {
  await page.waitForSelector('#room-fold[data-at]');
  await boat();
  await snail();
  await crane();
  await page.click('#fold-top');
  await page.mouse.move(560, 350);
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(480, 250, { steps: 4 });
  await page.mouse.up({ button: 'right' });
  await shot('crane');
  // Every step can be undone and played again.
  await page.keyboard.press('Control+z');
  await hand.reached(21);
  await page.click('#fold-redo');
  await hand.reached(22);
  await endsAs('crane');
  expect(studio.faults.length === 0, `no fault in the page: ${studio.faults.join('; ')}`);
} catch (error) {
  await shot('failed');
  console.error(error.message);
  process.exitCode = 1;
} finally {
  await studio.close();
  rmSync(scratch, { recursive: true });
}
