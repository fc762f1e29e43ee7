// A surface under a light that the pointer holds, or one of its maps in colours; zoomed, moved and turned.
import * as THREE from '../vendor/three.module.js';
import { drawn } from '../parts.js';
import { Look } from './look.js';
import { Sheet } from './sheet.js';

const flatCamera = new THREE.Camera();

export class SurfaceView {
  /**
   * @param {HTMLElement} view with a canvas in it
   * @param {(line: string) => void} tell what lies under the pointer
   * @param {Look} look shared by views that move together
   */
  constructor(view, tell, look = new Look()) {
    this.view = view;
    this.tell = tell;
    this.look = look;
    this.renderer = new THREE.WebGLRenderer({ canvas: /** @type {HTMLCanvasElement} */ (view.querySelector('canvas')) });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // the shader encodes
    this.sheet = new Sheet();
    /** @type {import('./maps.js').Maps | null} */
    this.maps = null;
    this.wanted = false;
    /** A line on the surface that the pointer draws, if it does not hold the light. @type {import('./profile.js').Profile | null} */
    this.profile = null;
    this.line = drawn('line', { class: 'profile' });
    this.over = drawn('svg', { class: 'lines' }, this.line);
    view.append(this.over);
    look.viewers.add(() => this.draw());
    new ResizeObserver(() => this.resize()).observe(view);
    this.listen();
  }

  /** @param {import('./maps.js').Maps} maps */
  show(maps) {
    const fresh = !this.maps || this.maps.cols !== maps.cols || this.maps.rows !== maps.rows;
    this.maps = maps;
    this.sheet.show(maps);
    if (fresh) this.whole();
    this.draw();
  }

  /** The whole surface in sight. */
  whole() {
    if (!this.maps) return;
    const { look, maps, view } = this;
    look.scale = 0.96 * Math.min(view.clientWidth / maps.cols, view.clientHeight / maps.rows);
    look.middle.set(maps.cols / 2, maps.rows / 2);
    look.eye.overlook(0, 0, 0.8 * Math.max(1, view.clientHeight / view.clientWidth));
    look.eye.orbit(0, -0.75);
    look.changed();
  }

  resize() {
    const [width, height] = [this.view.clientWidth, this.view.clientHeight];
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.look.eye.fit(width, height);
    this.whole();
  }

  draw() {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      if (!this.maps) return;
      const { look } = this;
      this.sheet.follow(look, this.view.clientWidth, this.view.clientHeight);
      this.renderer.render(this.sheet.scene, look.space ? look.eye.camera : flatCamera);
      const ends = look.space ? null : this.profile?.ends;
      this.line.style.display = ends ? '' : 'none';
      for (const [k, end] of (ends ?? []).entries()) {
        const [x, y] = this.onView(...end);
        this.line.setAttribute(`x${k + 1}`, String(x));
        this.line.setAttribute(`y${k + 1}`, String(y));
      }
    });
  }

  /** The light stands where a hand would hold it: over the pointer. @param {number} x @param {number} y pixels */
  hold(x, y) {
    const radius = 0.5 * Math.min(this.view.clientWidth, this.view.clientHeight);
    let [lx, ly] = [(x - this.view.clientWidth / 2) / radius, (this.view.clientHeight / 2 - y) / radius];
    const far = Math.hypot(lx, ly);
    if (far > 0.98) [lx, ly] = [(0.98 * lx) / far, (0.98 * ly) / far];
    this.look.light.set(lx, ly, Math.sqrt(1 - lx * lx - ly * ly));
    this.look.changed();
  }

  /** @param {number} x @param {number} y @returns {[number, number]} column and row, with fractions */
  pixel(x, y) {
    const { middle, scale } = this.look;
    return [middle.x + (x - this.view.clientWidth / 2) / scale, middle.y + (y - this.view.clientHeight / 2) / scale];
  }

  /** The inverse of `pixel`. @param {number} col @param {number} row @returns {[number, number]} */
  onView(col, row) {
    const { middle, scale } = this.look;
    return [(col - middle.x) * scale + this.view.clientWidth / 2, (row - middle.y) * scale + this.view.clientHeight / 2];
  }

  listen() {
    const { view, look } = this;
    let button = -1;
    const at = (/** @type {PointerEvent | WheelEvent} */ event) => {
      const box = view.getBoundingClientRect();
      return /** @type {[number, number]} */ ([event.clientX - box.left, event.clientY - box.top]);
    };
    const first = (/** @type {PointerEvent} */ event, /** @type {boolean} */ begins) => {
      if (!this.profile || look.space) return this.hold(...at(event));
      if (begins) this.profile.begin(this.pixel(...at(event)));
      else this.profile.end(this.pixel(...at(event)));
      this.draw();
    };
    view.addEventListener('contextmenu', (event) => event.preventDefault());
    view.addEventListener('pointerdown', (event) => {
      if (event.target instanceof Element && event.target.closest('button, label')) return;
      view.focus({ preventScroll: true });
      view.setPointerCapture(event.pointerId);
      button = event.button;
      if (button === 0) first(event, true);
    });
    view.addEventListener('pointerup', () => (button = -1));
    view.addEventListener('pointercancel', () => (button = -1));
    view.addEventListener('pointermove', (event) => {
      if (button === 0) first(event, false);
      if (button > 0) this.move(event.movementX, event.movementY);
      const [col, row] = this.pixel(...at(event));
      this.tell(look.space ? '' : this.maps?.at(Math.floor(col), Math.floor(row)) ?? '');
    });
    view.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * 0.0015), ...at(event));
    }, { passive: false });
    view.addEventListener('keydown', (event) => {
      const ways = /** @type {Record<string, [number, number]>} */ ({
        ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
      });
      const way = ways[event.key];
      if (way && event.altKey) this.move(-20 * way[0], 20 * way[1]);
      else if (way && this.profile && !look.space) this.profile.step(way[0], -way[1], event.shiftKey, this.maps);
      else if (way) {
        const radius = 0.5 * Math.min(view.clientWidth, view.clientHeight);
        this.hold(view.clientWidth / 2 + radius * (look.light.x + 0.05 * way[0]), view.clientHeight / 2 - radius * (look.light.y + 0.05 * way[1]));
      } else if (event.key === '+' || event.key === '-') {
        this.zoom(event.key === '+' ? 1.25 : 0.8, view.clientWidth / 2, view.clientHeight / 2);
      } else if (event.key === '0') this.whole();
      else return;
      event.preventDefault();
      this.draw();
    });
  }

  /** Slides a flat surface, turns one in space. @param {number} x @param {number} y pixels */
  move(x, y) {
    const { look } = this;
    if (look.space) look.eye.orbit(x * 0.008, -y * 0.008);
    else look.middle.set(look.middle.x - x / look.scale, look.middle.y - y / look.scale);
    look.changed();
  }

  /** Around a place of the view, which stays where it is. @param {number} factor @param {number} x @param {number} y */
  zoom(factor, x, y) {
    const { look } = this;
    if (look.space) look.eye.zoom(1 / factor);
    const [col, row] = this.pixel(x, y);
    if (!look.space) look.scale = Math.min(64, Math.max(0.05, look.scale * factor));
    const [newCol, newRow] = this.pixel(x, y);
    look.middle.set(look.middle.x + col - newCol, look.middle.y + row - newRow);
    look.changed();
  }
}
