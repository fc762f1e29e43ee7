// The photographs of the folder, the spheres and lights in them, and the work on them.
import { get } from '../api.js';
import { followJobs, work } from '../jobs.js';
import { mark } from '../listing.js';
import { attempt, make, part, say } from '../parts.js';
import { Circles } from './circles.js';

/** @typedef {{name: string, pictures: string[]}} Capture */

/** What the work has to say in sentences. @param {string[]} lines */
const sentences = (lines) => lines.filter((line) => !line.endsWith('...') && !line.startsWith('wrote ')).map((line) => line.replace(/^note: /, ''));

class CaptureRoom {
  constructor() {
    /** @type {Capture | null} */
    this.capture = null;
    this.picture = '';
    /** @type {Record<string, number[][]>} of each picture, by the lights read last */
    this.highlights = {};
    this.circles = new Circles(part('capture-large'), () => this.touched());
    this.wire();
  }

  wire() {
    part('capture-calibrate').addEventListener('click', () => attempt(() => this.calibrate()));
    part('capture-reconstruct').addEventListener('click', () => attempt(() => this.reconstruct()));
    part('capture-add').addEventListener('click', () => this.circles.add());
    part('capture-forget').addEventListener('click', () => {
      this.circles.show([]);
      this.touched();
    });
    followJobs((job) => {
      const ours = /^(lights of|reconstruct) /.test(job.what);
      if (ours) part('capture-says').replaceChildren(...sentences(job.lines).map((line) => make('li', {}, line)));
      part('room-capture').dataset.state = ours ? job.state : '';
      part('capture-work').disabled = !this.capture || job.state === 'running';
    });
  }

  touched() {
    part('capture-calibrate').textContent = this.circles.circles.length === 0 ? 'Find the spheres and read the lights' : 'Read the lights off these circles';
  }

  /** @param {string} picture @returns {Promise<{url: string, rows: number, cols: number}>} */
  async thumbnail(picture, size = 480) {
    const path = this.capture?.name ? `${this.capture.name}/${picture}` : picture;
    const response = await fetch(`api/capture/picture?name=${encodeURIComponent(path)}&size=${size}`);
    if (!response.ok) throw new Error((await response.json()).error);
    return { url: URL.createObjectURL(await response.blob()), rows: Number(response.headers.get('X-Rows')), cols: Number(response.headers.get('X-Cols')) };
  }

  /** @param {HTMLImageElement} image @param {string} url */
  static put(image, url) {
    image.src = url;
    image.addEventListener('load', () => URL.revokeObjectURL(url), { once: true });
  }

  /** @param {Capture} chosen */
  open(chosen) {
    this.capture = chosen;
    this.highlights = {};
    this.circles.show([]);
    this.touched();
    part('capture-says').replaceChildren();
    part('capture-lights').replaceChildren();
    part('capture-by-lights').checked = false;
    part('capture-by-lights').disabled = true;
    const buttons = chosen.pictures.map((picture) => {
      const image = make('img', { alt: picture });
      const button = make('button', { type: 'button', class: 'thumbnail' }, image, make('small', {}, picture));
      button.addEventListener('click', () => attempt(() => this.enlarge(picture, button)));
      attempt(async () => CaptureRoom.put(image, (await this.thumbnail(picture)).url));
      return button;
    });
    part('capture-pictures').replaceChildren(...buttons);
    part('capture-work').disabled = false;
    part('capture-out').value = `${(chosen.name || 'sheet').split('/').pop()}_surface`;
    attempt(() => this.enlarge(chosen.pictures[0], buttons[0]));
  }

  /** @param {string} picture @param {HTMLElement} button */
  async enlarge(picture, button) {
    mark(part('capture-pictures'), button);
    this.picture = picture;
    const { url, rows, cols } = await this.thumbnail(picture, 1600);
    if (this.picture !== picture) return;
    const image = part('capture-large').querySelector('img');
    image.alt = picture;
    CaptureRoom.put(image, url);
    part('capture-large').style.aspectRatio = `${cols} / ${rows}`;
    part('capture-large').style.setProperty('--aspect', String(cols / rows));
    this.circles.frame(cols, rows);
    this.circles.point(this.highlights[picture] ?? []);
    part('room-capture').dataset.shown = picture;
  }

  async calibrate() {
    const { circles } = this.circles;
    const boxes = this.circles.touched && circles.length > 0 ? { boxes: this.circles.boxes() } : {};
    await work('calibrate', { capture: this.capture?.name ?? '', ...boxes });
    const lights = await get('job/lights');
    this.circles.show(lights.file.spheres.map((/** @type {any} */ s) => ({ x: s.center_px[0], y: s.center_px[1], r: s.radius_px })));
    this.highlights = Object.fromEntries(lights.file.lights.map((/** @type {any} */ light, /** @type {number} */ i) =>
      [light.image, lights.file.highlights_px?.[i] ?? []]));
    this.circles.point(this.highlights[this.picture] ?? []);
    this.touched();
    part('capture-lights').innerHTML = lights.plot; // drawn by the report of the program, of numbers alone
    part('capture-lights').append(make('p', { class: 'quiet' }, `Where the lights stand, from above: overhead in the middle, the horizon at the rim. Discs: `
      + `standard deviation, ${lights.magnified} times as large; ${lights.sigma_deg.toPrecision(2)}° on average.`));
    part('capture-by-lights').disabled = false;
    part('capture-by-lights').checked = true;
    part('room-capture').dataset.lights = String(lights.file.lights.length);
    say('');
  }

  async reconstruct() {
    const out = part('capture-out').value;
    await work('reconstruct', { capture: this.capture?.name ?? '', out, by_lights: part('capture-by-lights').checked });
    say(`${out} is among the surfaces now.`);
    part('surface-again').click();
  }

  async list() {
    /** @type {{captures: Capture[]}} */
    const { captures } = await get('capture/list');
    const buttons = captures.map((found) => {
      const button = make('button', { type: 'button', class: 'step' }, found.name || 'this folder', make('small', {}, ` ${found.pictures.length} pictures`));
      button.addEventListener('click', () => {
        mark(part('capture-list'), button);
        this.open(found);
      });
      return button;
    });
    part('capture-list').replaceChildren(...buttons.map((button) => make('li', {}, button)));
    part('capture-none').hidden = captures.length > 0;
    buttons[0]?.click();
  }
}

export async function openCaptures() {
  await new CaptureRoom().list();
}
