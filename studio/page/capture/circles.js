// Circles over a photograph that can be dragged: where its spheres are.
import { drawn } from '../parts.js';

/** @typedef {{x: number, y: number, r: number}} Circle pixels of the photograph */

const smallest = 4; // radius, pixels

export class Circles {
  /** @param {HTMLElement} figure over whose picture they lie @param {() => void} changed by a hand */
  constructor(figure, changed) {
    this.changed = changed;
    this.svg = drawn('svg', { class: 'over' });
    figure.append(this.svg);
    /** @type {Circle[]} */
    this.circles = [];
    /** @type {number[][]} where the spheres show the light of this picture */
    this.highlights = [];
    this.size = [1, 1];
    this.touched = false;
  }

  /** @param {number} cols @param {number} rows of the photograph */
  frame(cols, rows) {
    this.size = [cols, rows];
    this.svg.setAttribute('viewBox', `0 0 ${cols} ${rows}`);
    this.draw();
  }

  /** @param {number[][]} highlights places in the photograph */
  point(highlights) {
    this.highlights = highlights;
    this.draw();
  }

  /** @param {Circle[]} circles as they were found */
  show(circles) {
    this.circles = circles;
    this.touched = false;
    this.draw();
  }

  /** Another one, in the middle. */
  add() {
    const [cols, rows] = this.size;
    this.circles.push({ x: cols / 2, y: rows / 2, r: Math.min(cols, rows) / 12 });
    this.moved();
    /** @type {SVGElement | null} */ (this.svg.querySelector('g:last-of-type'))?.focus();
  }

  /** Boxes around them with some air: left, top, right, bottom. @returns {number[][]} */
  boxes() {
    const [cols, rows] = this.size;
    return this.circles.map(({ x, y, r }) => [Math.max(0, x - 1.15 * r), Math.max(0, y - 1.15 * r),
      Math.min(cols, x + 1.15 * r), Math.min(rows, y + 1.15 * r)]);
  }

  moved() {
    this.touched = true;
    this.draw();
    this.changed();
  }

  draw() {
    const thin = this.size[0] / 400;
    const held = document.activeElement instanceof SVGElement ? [...this.svg.children].indexOf(document.activeElement) : -1;
    this.svg.replaceChildren(...this.circles.map((circle, i) => {
      const { x, y, r } = circle;
      const group = drawn('g', { tabindex: 0, role: 'button', class: 'sphere-mark',
        'aria-label': `sphere ${i + 1}: arrows move it, plus and minus resize it, Delete takes it away` },
      drawn('circle', { cx: x, cy: y, r, class: 'disc' }),
      drawn('circle', { cx: x, cy: y, r, class: 'sphere', 'stroke-width': 2 * thin }),
      drawn('circle', { cx: x, cy: y, r, class: 'rim', 'stroke-width': 10 * thin }),
      drawn('path', { d: `M${x - 4 * thin} ${y}h${8 * thin}M${x} ${y - 4 * thin}v${8 * thin}`, class: 'sphere', 'stroke-width': thin }));
      this.listen(group, circle);
      return group;
    }), ...this.highlights.map(([x, y]) => drawn('circle', { cx: x, cy: y, r: 4 * thin, class: 'highlight', 'stroke-width': 1.5 * thin })));
    if (held >= 0) /** @type {SVGElement | undefined} */ (this.svg.children[held])?.focus();
  }

  /** @param {SVGGraphicsElement} group @param {Circle} circle */
  listen(group, circle) {
    const at = (/** @type {PointerEvent} */ event) =>
      new DOMPoint(event.clientX, event.clientY).matrixTransform(/** @type {DOMMatrix} */ (this.svg.getScreenCTM()).inverse());
    group.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      const start = at(event);
      const before = { ...circle };
      const resizes = event.target instanceof Element && event.target.classList.contains('rim');
      const move = (/** @type {PointerEvent} */ now) => {
        const p = at(now);
        if (resizes) circle.r = Math.max(smallest, Math.hypot(p.x - circle.x, p.y - circle.y));
        else Object.assign(circle, { x: before.x + p.x - start.x, y: before.y + p.y - start.y });
        this.moved();
      };
      const stop = () => {
        window.removeEventListener('pointermove', move);
        window.removeEventListener('pointerup', stop);
      };
      window.addEventListener('pointermove', move);
      window.addEventListener('pointerup', stop);
    });
    group.addEventListener('keydown', (event) => {
      const step = this.size[0] / (event.shiftKey ? 40 : 400);
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (way) Object.assign(circle, { x: circle.x + step * way[0], y: circle.y + step * way[1] });
      else if (event.key === '+' || event.key === '-') circle.r = Math.max(smallest, circle.r + (event.key === '+' ? step : -step));
      else if (event.key === 'Delete') this.circles.splice(this.circles.indexOf(circle), 1);
      else return;
      event.preventDefault();
      this.moved();
    });
  }
}
