// The surfaces and pictures of the folder, seen as maps and under a light.
import { bytes } from '../api.js';
import { listSurfaces } from '../listing.js';
import { attempt, make, part, say } from '../parts.js';
import { Maps } from './maps.js';
import { SurfaceView } from './view.js';

/** @type {Record<string, string>} */
const looks = { 0: 'under the light', 1: 'normals', 2: 'height', 3: 'albedo' };

export async function openSurfaces() {
  const view = new SurfaceView(part('surface-view'), (line) => (part('surface-under').textContent = line));
  const look = part('surface-look');
  look.addEventListener('change', () => view.set({ mode: Number(look.value) }));
  for (const name of /** @type {const} */ (['exaggeration', 'gloss', 'roughness'])) {
    const slider = part(`surface-${name}`);
    slider.addEventListener('input', () => view.set({ [name]: Number(slider.value) }));
  }
  part('surface-whole').addEventListener('click', () => view.whole());

  /** @param {string} name */
  const open = async (name) => {
    part('surface-facts').textContent = `opening ${name}`;
    const maps = new Maps(await bytes('surface/maps', { name }));
    // Only what the surface has can be looked at.
    const there = { 0: true, 1: maps.normals, 2: maps.height, 3: maps.albedo };
    look.replaceChildren(...Object.entries(there).filter(([, has]) => has)
      .map(([value]) => make('option', { value }, looks[value])));
    if (!maps.normals) look.value = '3';
    view.set({ mode: Number(look.value) });
    view.show(maps);
    const size = `${(maps.cols * maps.pitch).toPrecision(4)} x ${(maps.rows * maps.pitch).toPrecision(4)} ${maps.unit}`;
    const relief = maps.height ? `, height from ${maps.low.toPrecision(3)} to ${maps.high.toPrecision(3)} ${maps.unit}` : '';
    part('surface-facts').textContent = `${maps.cols} x ${maps.rows} pixels, ${size}${relief}`;
    part('room-surface').dataset.shown = name;
    say('');
  };

  const list = () => listSurfaces('surface', open, part('room-surface').dataset.shown);
  part('surface-again').addEventListener('click', () => attempt(list));
  await list();
}
