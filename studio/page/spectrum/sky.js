// The spectrum as a picture with frequency 0 in the middle, and what is marked in it.
import { drawn } from '../parts.js';

const side = 1000; // of the picture, units of the drawing
const margin = { left: 96, bottom: 78, top: 14, right: 14 };

/** @typedef {{angle_rad: number, axes: number[], between?: number[][]}} Ellipse */

/** Round numbers from -reach to reach. @param {number} reach */
function ticks(reach) {
  const decade = 10 ** Math.floor(Math.log10(reach));
  const step = decade * ([0.2, 0.5, 1].find((s) => (s * decade * 4) >= reach) ?? 2);
  const most = Math.floor(reach / step);
  return Array.from({ length: 2 * most + 1 }, (_, i) => (i - most) * step);
}

export class Sky {
  /**
   * @param {HTMLElement} view
   * @param {(frequency: number, angle: number) => void} choose
   * @param {(line: string) => void} tell
   */
  constructor(view, choose, tell) {
    this.view = view;
    this.reach = 1;
    this.unit = 'mm';
    const [w, h] = [side + margin.left + margin.right, side + margin.top + margin.bottom];
    this.svg = drawn('svg', { viewBox: `${-margin.left} ${-margin.top} ${w} ${h}`, class: 'sky', 'aria-hidden': 'true' });
    this.picture = drawn('image', { width: side, height: side, preserveAspectRatio: 'none' });
    this.axes = drawn('g', { class: 'axes' });
    const clip = drawn('clipPath', { id: 'sky-clip' }, drawn('rect', { width: side, height: side }));
    this.marks = drawn('g', { 'clip-path': 'url(#sky-clip)' });
    this.svg.append(clip, this.picture, this.marks, this.axes);
    this.layers = { peaks: drawn('g', { class: 'peaks' }), ellipses: drawn('g', { class: 'ellipses' }), chosen: drawn('g', { class: 'chosen' }) };
    this.marks.append(...Object.values(this.layers));
    view.prepend(this.svg);
    /** @param {MouseEvent} event */
    const at = (event) => {
      const matrix = /** @type {DOMMatrix} */ (this.svg.getScreenCTM()).inverse();
      const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
      const [fx, fy] = [(2 * p.x / side - 1) * this.reach, (1 - 2 * p.y / side) * this.reach];
      return { frequency: Math.hypot(fx, fy), angle: Math.atan2(fy, fx), fx, fy };
    };
    view.addEventListener('click', (event) => {
      const { frequency, angle } = at(event);
      choose(frequency, angle);
    });
    view.addEventListener('pointermove', (event) => {
      const { frequency, angle, fx, fy } = at(event);
      if (Math.max(Math.abs(fx), Math.abs(fy)) > this.reach) return tell('');
      const degrees = (((angle * 180) / Math.PI) + 360) % 180;
      tell(`${frequency.toPrecision(3)} cycles/${this.unit}, waves of ${(1 / frequency).toPrecision(3)} ${this.unit}, varying along ${degrees.toFixed(0)}°`);
    });
  }

  /** @param {string} picture @param {number} reach highest frequency @param {string} unit */
  show(picture, reach, unit) {
    Object.assign(this, { reach, unit });
    this.picture.setAttribute('href', picture);
    const texts = ticks(reach).flatMap((tick) => {
      const along = this.along(tick);
      const text = String(Number(tick.toPrecision(6))).replace('-', '\u2212');
      return [
        drawn('text', { x: along, y: side + 30, 'text-anchor': 'middle' }, text),
        drawn('text', { x: -14, y: side - along + 9, 'text-anchor': 'end' }, text),
        drawn('path', { d: `M${along} ${side}v8M0 ${side - along}h-8` }),
      ];
    });
    this.axes.replaceChildren(...texts,
      drawn('text', { x: side / 2, y: side + 66, 'text-anchor': 'middle' }, `fx, cycles/${unit}`),
      drawn('text', { transform: `translate(-74 ${side / 2}) rotate(-90)`, 'text-anchor': 'middle' }, `fy, cycles/${unit}`));
  }

  /** @param {number} frequency along x @returns {number} units of the drawing */
  along(frequency) {
    return (side / 2) * (1 + frequency / this.reach);
  }

  /** @param {number} frequency @returns {number} units of the drawing */
  length(frequency) {
    return (side / 2) * (frequency / this.reach);
  }

  /** @param {number[]} rings frequencies @param {number[]} sectors angles */
  peaks(rings, sectors) {
    const far = 2 * side;
    const middle = side / 2;
    this.layers.peaks.replaceChildren(
      ...rings.map((f) => drawn('circle', { cx: middle, cy: middle, r: this.length(f) })),
      ...sectors.map((a) => drawn('path', {
        d: `M${middle - far * Math.cos(a)} ${middle + far * Math.sin(a)}L${middle + far * Math.cos(a)} ${middle - far * Math.sin(a)}` })));
  }

  /** @param {Ellipse[]} ellipses */
  components(ellipses) {
    const middle = side / 2;
    /** @param {number[]} axes @param {number} angle @param {string} kind */
    const one = ([a, b], angle, kind) => drawn('ellipse', { rx: this.length(a), ry: this.length(b), class: kind,
      transform: `translate(${middle} ${middle}) rotate(${(-angle * 180) / Math.PI})` });
    this.layers.ellipses.replaceChildren(...ellipses.flatMap(({ angle_rad: angle, axes, between }, k) => [
      ...(between ?? []).map((bound) => one(bound, angle, 'bound')),
      one(axes, angle, 'best'),
      drawn('text', { x: middle + this.length(axes[0]) * Math.cos(angle) + 8, y: middle - this.length(axes[0]) * Math.sin(angle) - 8 }, String(k + 1)),
    ]));
  }

  /**
   * @param {{from: number, to: number} | null} ring frequencies
   * @param {{from: number, to: number} | null} sector angles
   */
  chosen(ring, sector) {
    const middle = side / 2;
    const shapes = [];
    if (ring) {
      const width = this.length(ring.to - ring.from);
      shapes.push(drawn('circle', { cx: middle, cy: middle, r: this.length((ring.from + ring.to) / 2), 'stroke-width': Math.max(width, 3), class: 'ring-chosen' }));
    }
    if (sector) {
      const far = 2 * side;
      /** @param {number} a @param {number} sign */
      const corner = (a, sign) => `${middle + sign * far * Math.cos(a)} ${middle - sign * far * Math.sin(a)}`;
      for (const sign of [1, -1]) {
        shapes.push(drawn('path', { d: `M${middle} ${middle}L${corner(sector.from, sign)}L${corner(sector.to, sign)}z`, class: 'sector-chosen' }));
      }
    }
    this.layers.chosen.replaceChildren(...shapes);
  }
}
