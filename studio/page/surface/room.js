// The surfaces and pictures of the folder, seen as maps and under a light.
import { bytes, get } from '../api.js';
import { listSurfaces } from '../listing.js';
import { attempt, make, part, say } from '../parts.js';
import { modes } from './look.js';
import { Maps } from './maps.js';
import { Profile } from './profile.js';
import { SurfaceView } from './view.js';

class SurfaceRoom {
  constructor() {
    const tell = (/** @type {string} */ line) => (part('surface-under').textContent = line);
    this.view = new SurfaceView(part('surface-view'), tell);
    this.look = this.view.look;
    /** What a material makes of it. */
    this.beside = new SurfaceView(part('surface-beside'), tell, this.look);
    this.profile = new Profile(part('surface-profile'), () => [this.view.maps, part('surface-beside').hidden ? null : this.beside.maps]);
    this.name = '';
    /** @type {any} the file of the material that is seen beside */
    this.file = null;
    this.wire();
  }

  wire() {
    const mode = part('surface-look');
    mode.addEventListener('change', () => this.show(Number(mode.value)));
    for (const name of /** @type {const} */ (['exaggeration', 'gloss', 'roughness'])) {
      const slider = part(`surface-${name}`);
      slider.addEventListener('input', () => this.look.set({ [name]: Number(slider.value) }));
    }
    part('surface-space').addEventListener('change', () => this.look.set({ space: part('surface-space').checked }));
    part('surface-whole').addEventListener('click', () => this.view.whole());
    for (const radio of document.querySelectorAll('input[name=surface-tool]')) {
      radio.addEventListener('change', () => {
        const cuts = part('surface-tool-profile').checked;
        this.view.profile = this.beside.profile = cuts ? this.profile : null;
        part('surface-profile').hidden = !cuts;
        if (cuts && !this.profile.ends) this.profile.step(0, 0, false, this.view.maps);
        this.look.changed();
      });
    }
    part('surface-again').addEventListener('click', () => attempt(() => this.list()));
    part('surface-open').addEventListener('change', () => attempt(async () => {
      const [file] = part('surface-open').files;
      if (!file) return;
      part('surface-open').value = '';
      await this.compare(JSON.parse(await file.text()));
    }));
    part('surface-fitted').addEventListener('click', () => attempt(async () => this.compare(await get('job/fit'))));
    part('surface-seed').addEventListener('change', () => attempt(() => this.compare(this.file)));
    part('surface-alone').addEventListener('click', () => this.alone());
  }

  /** @param {number} mode */
  show(mode) {
    this.look.set({ mode });
    const scale = part('surface-scale');
    const ends = this.view.maps?.ends(mode);
    scale.hidden = !ends;
    for (const [k, label] of (ends ?? []).entries()) scale.querySelectorAll('span')[k].textContent = label;
  }

  list() {
    return listSurfaces('surface', (name) => this.open(name), this.name);
  }

  /** @param {string} name */
  async open(name) {
    part('surface-facts').textContent = `opening ${name}`;
    const maps = new Maps(await bytes('surface/maps', { name }));
    this.name = name;
    this.alone();
    // Only what the surface has can be looked at.
    const there = { 0: true, 1: maps.normals, 2: maps.height, 3: maps.albedo, 4: maps.normalSigma, 5: maps.heightSigma };
    const mode = part('surface-look');
    const before = mode.value;
    mode.replaceChildren(...Object.entries(there).filter(([, has]) => has)
      .map(([value]) => make('option', { value }, modes[Number(value)])));
    if ([...mode.options].some((option) => option.value === before)) mode.value = before;
    if (!maps.normals) mode.value = '3';
    part('surface-space').disabled = !maps.height;
    if (!maps.height) part('surface-space').checked = false;
    this.look.set({ space: part('surface-space').checked });
    this.view.show(maps);
    this.show(Number(mode.value));
    this.profile.ends = null;
    if (this.view.profile) this.profile.step(0, 0, false, maps);
    const size = `${(maps.cols * maps.pitch).toPrecision(4)} x ${(maps.rows * maps.pitch).toPrecision(4)} ${maps.unit}`;
    const relief = maps.height ? `, height from ${maps.low.toPrecision(3)} to ${maps.high.toPrecision(3)} ${maps.unit}` : '';
    part('surface-facts').textContent = `${maps.cols} x ${maps.rows} pixels, ${size}${relief}`;
    part('room-surface').dataset.shown = name;
    say('');
  }

  /** Shows what a material makes of this surface, beside it. @param {any} file */
  async compare(file) {
    if (!file) return;
    const maps = new Maps(await bytes('surface/like', { name: this.name, file, seed: Number(part('surface-seed').value) }));
    this.file = file;
    part('surface-beside').hidden = false;
    part('surface-alone').disabled = false;
    this.beside.show(maps);
    part('surface-made').textContent = `made of ${file.material}`;
    if (this.view.profile) this.profile.show();
    part('room-surface').dataset.beside = file.material;
    say('');
  }

  alone() {
    this.file = null;
    part('surface-beside').hidden = true;
    part('surface-alone').disabled = true;
    delete part('room-surface').dataset.beside;
    if (this.view.profile) this.profile.show();
  }
}

export async function openSurfaces() {
  await new SurfaceRoom().list();
}
