// A line across a surface, and what is measured along it.
import { axis, bands, series } from '../plot.js';
import uPlot from '../vendor/uplot.js';

/** @typedef {[number, number]} Pixel column and row, with fractions */

const most = 600; // places along the line

/** What a profile is of: the height, else the albedo. @param {import('./maps.js').Maps} maps */
const label = (maps) => (maps.height ? `height, ${maps.unit}` : 'albedo');

export class Profile {
  /** @param {HTMLElement} box for the plot @param {() => (import('./maps.js').Maps | null)[]} surfaces that are cut */
  constructor(box, surfaces) {
    this.box = box;
    this.surfaces = surfaces;
    /** @type {[Pixel, Pixel] | null} */
    this.ends = null;
    /** @type {uPlot | null} */
    this.plot = null;
    new ResizeObserver(() => this.plot?.setSize({ width: box.clientWidth, height: box.clientHeight })).observe(box);
  }

  /** @param {Pixel} place */
  begin(place) {
    this.ends = [place, place];
  }

  /** @param {Pixel} place */
  end(place) {
    if (!this.ends) return;
    this.ends = [this.ends[0], place];
    this.show();
  }

  /** By keys: the line as a whole, or its second end. @param {number} x @param {number} y @param {boolean} end @param {import('./maps.js').Maps | null} maps */
  step(x, y, end, maps) {
    if (!maps) return;
    const size = Math.max(1, maps.cols / 100);
    this.ends ??= [[maps.cols * 0.1, maps.rows / 2], [maps.cols * 0.9, maps.rows / 2]];
    const [from, to] = this.ends;
    if (!end) this.ends[0] = [from[0] + size * x, from[1] + size * y];
    this.ends[1] = [to[0] + size * x, to[1] + size * y];
    this.show();
  }

  show() {
    const surfaces = this.surfaces().filter((maps) => maps !== null);
    if (!this.ends || surfaces.length === 0) return;
    const [[c0, r0], [c1, r1]] = this.ends;
    const count = Math.max(2, Math.min(most, Math.ceil(Math.hypot(c1 - c0, r1 - r0))));
    const shares = Array.from({ length: count }, (_, i) => i / (count - 1));
    const length = Math.hypot(c1 - c0, r1 - r0) * surfaces[0].pitch;
    const values = surfaces.map((maps) => shares.map((s) => maps.value(Math.floor(c0 + s * (c1 - c0)), Math.floor(r0 + s * (r1 - r0)))));
    const [first, second] = values;
    const sigma = shares.map((s) => surfaces[0].sigma(Math.floor(c0 + s * (c1 - c0)), Math.floor(r0 + s * (r1 - r0))));
    const around = (/** @type {number} */ sign) => first.map((v, i) => (v === null || sigma[i] === null ? null : v + sign * sigma[i]));
    /** @type {any} */
    const options = {
      width: this.box.clientWidth, height: this.box.clientHeight, legend: { show: false }, cursor: { drag: { x: false, y: false } },
      scales: { x: { time: false } },
      axes: [{ ...axis, label: `along the line, ${surfaces[0].unit}`, size: 32 }, { ...axis, label: label(surfaces[0]), size: 62 }],
      bands, series,
    };
    this.plot?.destroy();
    this.plot = new uPlot(options, /** @type {any} */ ([shares.map((s) => s * length), first, around(-1), around(1), second ?? first.map(() => null)]), this.box);
  }
}
