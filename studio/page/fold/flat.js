// The flat sheet as a map: every face can be chosen on it, however deep it lies in the pile, and the
// direction of a fold that is still to come be wished for.
import { post } from '../api.js';
import { attempt, drawn, part } from '../parts.js';

const sameWish = 0.02; // of the side: a second click so near takes a wish back
const margin = 0.03; // around the sheet, of its side

export class Flat {
  /**
   * @param {(state: FoldState) => void} show
   * @param {(face: number) => void} light the face under the pointer, -1 for none
   */
  constructor(show, light) {
    this.show = show;
    this.light = light;
    this.view = /** @type {SVGSVGElement} */ (part('fold-flat'));
    /** @type {FoldState | null} */
    this.state = null;
    /** @type {{place: FlatPlace, letter: string}[]} */
    this.wishes = [];
    this.active = 0;
    this.view.addEventListener('click', (event) => attempt(() => this.click(this.place(event))));
    this.view.addEventListener('pointermove', (event) => this.light(this.faceOf(event.target)));
    this.view.addEventListener('pointerleave', () => this.light(-1));
    this.view.addEventListener('blur', () => this.light(-1));
    this.view.addEventListener('keydown', (event) => this.key(event));
    part('fold-none').addEventListener('click', () => attempt(async () => this.show(await post('fold/choose', { none: true }))));
  }

  /** @param {MouseEvent} event @returns {FlatPlace} */
  place(event) {
    const map = /** @type {SVGGraphicsElement} */ (this.view.firstChild);
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(map.getScreenCTM()?.inverse());
    return [p.x, p.y];
  }

  /** @param {EventTarget | null} target @returns {number} */
  faceOf(target) {
    return Number(/** @type {SVGElement} */ (target)?.dataset?.face ?? -1);
  }

  /** @param {FlatPlace} place */
  async click(place) {
    const does = /** @type {HTMLInputElement} */ (document.querySelector('input[name=fold-click]:checked')).value;
    if (does === 'face') return this.show(await post('fold/choose', { place }));
    const near = sameWish * (this.state?.side ?? 1);
    const others = this.wishes.filter((wish) => Math.hypot(wish.place[0] - place[0], wish.place[1] - place[1]) > near);
    this.wishes = others.length < this.wishes.length ? others : [...others, { place, letter: does }];
    this.draw();
  }

  /** @param {string} letter @returns {FlatPlace[]} */
  wished(letter) {
    return this.wishes.filter((wish) => wish.letter === letter).map((wish) => wish.place);
  }

  forget() {
    this.wishes = [];
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const faces = this.state?.faces.length ?? 1;
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step && event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    if (!step) return void attempt(() => this.click(this.middle(this.active)));
    this.active = (this.active + step + faces) % faces;
    this.light(this.active);
    this.draw();
  }

  /** @param {number} face @returns {FlatPlace} */
  middle(face) {
    const corners = (this.state?.faces[face] ?? []).map((v) => this.state?.flat_vertices[v] ?? [0, 0]);
    const mean = (/** @type {0 | 1} */ k) => corners.reduce((sum, corner) => sum + corner[k], 0) / corners.length;
    return [mean(0), mean(1)];
  }

  /** @param {FoldState} state */
  tell(state) {
    this.state = state;
    this.active = Math.min(this.active, state.faces.length - 1);
    this.draw();
  }

  draw() {
    const { state } = this;
    if (!state) return;
    const chosen = new Set(state.chosen);
    const at = (/** @type {number} */ v) => state.flat_vertices[v];
    const map = drawn('g', { transform: `matrix(1 0 0 -1 0 ${state.side})` });
    state.faces.forEach((corners, f) => {
      const picked = chosen.has(f);
      map.append(drawn('polygon', {
        id: `fold-flat-${f}`, 'data-face': f, role: 'option', points: corners.map((v) => at(v).join(',')).join(' '),
        class: `${picked ? 'chosen' : ''} ${f === this.active ? 'active' : ''}`, 'aria-selected': String(picked),
        'aria-label': `face ${f + 1} of ${state.faces.length}, layer ${state.piles.level[f] + 1} from below`,
      }));
    });
    for (const { from, to, crease } of state.edges) {
      const [a, b] = [at(from), at(to)];
      map.append(drawn('line', { x1: a[0], y1: a[1], x2: b[0], y2: b[1], class: `crease-${crease}` }));
    }
    this.view.replaceChildren(map);
    for (const { place, letter } of this.wishes) {
      this.view.append(drawn('text', { x: place[0], y: state.side - place[1], 'font-size': 0.07 * state.side,
        class: `crease-${letter}` }, letter));
    }
    const space = margin * state.side;
    this.view.setAttribute('viewBox', [-space, -space, state.side + 2 * space, state.side + 2 * space].join(' '));
    this.view.setAttribute('aria-activedescendant', `fold-flat-${this.active}`);
  }
}
