// Folding paper: what the pointer does is asked of the server, which knows what it means.
import * as THREE from '../vendor/three.module.js';
import { get, newestOf, post } from '../api.js';
import { attempt, complain, part, say } from '../parts.js';
import { Eye } from './camera.js';
import { Flat } from './flat.js';
import { Marks } from './marks.js';
import { Paper } from './paper.js';
import { listen } from './pointer.js';
import { Steps } from './steps.js';

const reach = 12; // of a snap, pixels
const turnedView = 0.7; // radians, where an axis lies across the view

class Room {
  constructor() {
    this.view = /** @type {HTMLElement} */ (part('fold-view'));
    this.size = [this.view.clientWidth, this.view.clientHeight]; // to ask each time would lay the page out
    const canvas = /** @type {HTMLCanvasElement} */ (part('fold-canvas'));
    canvas.width = this.size[0] * window.devicePixelRatio; // so that it is made once
    canvas.height = this.size[1] * window.devicePixelRatio;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.eye = new Eye();
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(0xe9e7e1);
    this.paper = new Paper();
    this.scene.add(this.paper.group);
    this.renderer.debug.checkShaderErrors = false; // each question would wait for the graphics card
    this.renderer.compile(this.scene, this.eye.camera); // while the sheet is asked for
    this.marks = new Marks(part('fold-marks'), (place) => this.project(place));
    this.flat = new Flat((state) => this.show(state), (face) => this.light(face));
    this.steps = new Steps((state) => this.show(state), (shape) => this.showShape(shape));
    /** @type {FoldState | null} */
    this.state = null;
    /** @type {{aim: Aim, eye: Place} | null} where the stroke began */
    this.start = null;
    /** @type {[Place, Place] | null} an axis drawn by hand */
    this.axis = null;
    this.moves = newestOf((/** @type {() => Promise<void>} */ work) => attempt(work));
    this.holding = Promise.resolve();
    this.wanted = false;
    new ResizeObserver(() => this.resize()).observe(this.view);
    listen(this.view, {
      press: (x, y) => this.press(x, y),
      move: (x, y) => this.move(x, y),
      release: (x, y) => this.release(x, y),
      cancel: () => this.cancel(),
      orbit: (right, up) => this.look(() => this.eye.orbit(right, up)),
      slide: (right, up) => this.look(() => this.eye.slide(right, up)),
      zoom: (factor) => this.look(() => this.eye.zoom(factor)),
      cross: (at) => this.look(() => (this.marks.cross = at)),
    });
    this.wire();
  }

  wire() {
    const ask = (/** @type {string} */ id, /** @type {() => object} */ step) =>
      part(id).addEventListener('click', () => attempt(async () => this.show(await post('fold/do', step()))));
    ask('fold-flatten', () => ({ do: 'flatten' }));
    ask('fold-squash', () => ({ do: 'squash', share: Number(part('fold-share').value) }));
    ask('fold-over', () => ({ do: 'over', x: (this.state?.side ?? 1) / 2 }));
    part('fold-new').addEventListener('click', () => attempt(async () => {
      this.show(await post('fold/new'));
      this.overlook();
    }));
    part('fold-top').addEventListener('click', () => this.overlook());
    part('fold-behind').addEventListener('click', () => this.look(() => this.eye.orbit(Math.PI, 0)));
    part('fold-open').addEventListener('change', () => attempt(async () => {
      const [file] = part('fold-open').files;
      if (!file) return;
      this.show(await post('fold/log', JSON.parse(await file.text())));
      this.overlook();
      part('fold-open').value = '';
    }));
    part('fold-colours').addEventListener('change', () => {
      this.paper.by = part('fold-colours').value;
      part('fold-scale').hidden = !this.paper.by;
      if (this.state) this.show(this.state);
    });
    for (const radio of document.querySelectorAll('input[name=fold-tool], input[name=fold-line]')) {
      radio.addEventListener('change', () => this.toolChosen());
    }
    window.addEventListener('keydown', (event) => {
      if (part('room-fold').hidden || !(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z') return;
      event.preventDefault();
      part(event.shiftKey ? 'fold-redo' : 'fold-undo').click();
    });
    this.toolChosen();
  }

  /** @param {string} name @returns {string} what is chosen */
  choice(name) {
    const chosen = /** @type {HTMLInputElement | null} */ (document.querySelector(`input[name=fold-${name}]:checked`));
    return chosen?.value ?? '';
  }

  toolChosen() {
    const line = this.choice('line');
    part('fold-lines').disabled = this.choice('tool') !== 'draw';
    part('fold-letters').hidden = line !== 'fold';
    part('fold-sides').hidden = line !== 'through';
    if (line !== 'axis') this.look(() => (this.marks.axis = this.axis = null));
  }

  /** @param {FoldState} state */
  show(state) {
    this.state = this.marks.state = state;
    this.steps.list(state);
    this.flat.tell(state);
    this.marks.grip = this.marks.stroke = this.marks.degrees = null;
    const faces = `${state.faces.length} face${state.faces.length === 1 ? '' : 's'}`;
    const [strain, planarity] = [state.strain, state.planarity].map(({ most }) => (most < 1e-15 ? '0' : most.toExponential(0)));
    const crossing = state.crossing_pairs > 0 ? `, ${state.crossing_pairs} pairs of faces pass through each other` : '';
    part('fold-facts').textContent = `${faces}, ${state.flat ? 'flat' : 'in space'}, strain ${strain}, planarity ${planarity}${crossing}`;
    part('fold-export').hidden = state.log.length === 0;
    this.showShape(state);
    part('room-fold').dataset.at = String(state.at);
  }

  /** Outlines a face through all that lies on it. @param {number} face -1 for none */
  light(face) {
    const { vertices = [], faces = [] } = this.state ?? {};
    const at = (/** @type {number} */ v) => /** @type {Place} */ (vertices.slice(3 * v, 3 * v + 3));
    this.look(() => (this.marks.lit = (faces[face] ?? []).map(at)));
  }

  /** @param {Shape} shape */
  showShape(shape) {
    if (this.state) this.paper.show(shape, this.state);
    this.draw();
  }

  /** From above, with the middle of the sheet as it lies in the middle of the view. */
  overlook() {
    const places = this.state?.vertices ?? [0, 0, 0];
    const middle = [0, 1].map((k) => {
      const along = places.filter((_, i) => i % 3 === k);
      return (Math.min(...along) + Math.max(...along)) / 2;
    });
    this.look(() => this.eye.overlook(middle[0], middle[1], this.state?.side ?? 1));
  }

  /** @param {() => void} change */
  look(change) {
    change();
    this.draw();
  }

  resize() {
    const [width, height] = [this.view.clientWidth, this.view.clientHeight];
    if (width === 0 || height === 0) return;
    this.size = [width, height];
    const scale = window.devicePixelRatio;
    this.renderer.setPixelRatio(scale);
    this.renderer.setSize(width, height, false);
    this.marks.canvas.width = width * scale;
    this.marks.canvas.height = height * scale;
    this.eye.fit(width, height);
    this.draw();
  }

  draw() {
    if (this.wanted || !this.state) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      this.renderer.render(this.scene, this.eye.camera);
      this.marks.draw();
    });
  }

  /** @param {Place} place @returns {[number, number]} */
  project(place) {
    const p = new THREE.Vector3(...place).project(this.eye.camera);
    return [((p.x + 1) * this.size[0]) / 2, ((1 - p.y) * this.size[1]) / 2];
  }

  /** @param {number} x @param {number} y pixels @returns {Ray} */
  ray(x, y) {
    return this.eye.ray((2 * x) / this.view.clientWidth - 1, 1 - (2 * y) / this.view.clientHeight);
  }

  /** @param {Ray} ray @returns {Promise<Aim | null>} */
  aim(ray) {
    return post('fold/aim', {
      ...ray,
      edge_parts: Number(part('fold-edge-parts').value),
      corner_parts: Number(part('fold-corner-parts').value),
      reach: reach * this.eye.pixel(this.view.clientHeight),
      chosen: this.choice('layers') === 'chosen' && ['through', 'score'].includes(this.choice('line')),
      ...(this.start ? { start: this.start.aim.place } : {}),
    });
  }

  /** @param {number} x @param {number} y */
  press(x, y) {
    const ray = this.ray(x, y);
    const tool = this.choice('tool');
    if (tool === 'draw') {
      this.holding = attempt(async () => {
        this.start = null;
        const aim = await this.aim(ray);
        if (aim) this.start = { aim, eye: ray.eye };
      });
    } else if (tool === 'turn') {
      this.holding = attempt(() => this.hold(ray));
    } else {
      this.holding = attempt(async () => this.show(await post(`fold/${tool}`, ray)));
    }
  }

  /** @param {Ray} ray */
  async hold(ray) {
    const line = this.axis && { line: [...this.axis[0].slice(0, 2), ...this.axis[1].slice(0, 2)] };
    const grip = /** @type {Grip} */ (await post('fold/hold', { ...ray, layers: this.choice('layers'), ...line }));
    if (grip.turn_view) {
      this.eye.turnAbout(grip.centre, grip.click, turnedView);
      say('The view was turned: the axis lay across it.');
    }
    this.marks.grip = grip;
    this.marks.aim = null;
    this.draw();
  }

  /** @param {number} x @param {number} y */
  move(x, y) {
    this.moves.give(async () => {
      await this.holding;
      const ray = this.ray(x, y);
      if (this.choice('tool') === 'draw') {
        const aim = await this.aim(ray);
        this.marks.aim = aim;
        if (this.start && aim) {
          const folds = this.choice('line') === 'through';
          const side = this.choice('side') === 'left' ? 1 : -1;
          this.marks.stroke = { from: this.start.aim.place, to: aim.place, side: folds ? side : 0 };
        }
        this.draw();
      } else if (this.marks.grip) {
        const whole = Number(part('fold-whole').value);
        const drag = /** @type {Drag} */ (await post('fold/drag', { ...ray, whole }));
        if (!this.marks.grip) return;
        this.marks.degrees = drag.degrees;
        part('fold-facts').textContent = `turned by ${Number(drag.degrees.toFixed(1))}°${drag.met ? ', where faces meet' : ''}`;
        this.showShape(drag);
      }
    });
    this.moves.settled().then(() => (this.view.dataset.seen = `${Math.round(x)} ${Math.round(y)}`));
  }

  /** @param {number} x @param {number} y */
  async release(x, y) {
    this.move(x, y);
    await this.moves.settled();
    await this.holding;
    await attempt(async () => {
      if (this.marks.grip) {
        this.show(await post('fold/drop'));
        return say('');
      }
      const { start } = this;
      const stroke = this.marks.stroke;
      this.start = this.marks.stroke = null;
      if (!start || !stroke) return this.draw();
      await this.drawn(stroke.from, stroke.to, start.eye);
    });
  }

  /** @param {Place} from @param {Place} to @param {Place} eye */
  async drawn(from, to, eye) {
    const does = this.choice('line');
    if (does === 'axis') {
      this.marks.axis = this.axis = [from, to];
      part('fold-tool-turn').checked = true;
      part('fold-lines').disabled = true;
      say('Now press on the side that turns, and drag.');
      return this.draw();
    }
    const layers = this.choice('layers');
    this.show(does === 'through' ? await this.foldThrough(from, to, layers === 'chosen') : await post('fold/stroke', {
      does, eye, from, to, crease: this.choice('letter'), layers: layers === 'chosen' ? layers : 'all',
    }));
    say('');
  }

  /**
   * Folds the layers under a stroke: all, or the chosen faces alone.
   * @param {Place} from @param {Place} to @param {boolean} chosen
   * @returns {Promise<FoldState>}
   */
  async foldThrough(from, to, chosen) {
    const faces = chosen ? this.state?.chosen_places ?? [] : [];
    if (chosen && faces.length === 0) throw new Error('No face is chosen: click on some on the flat sheet, or let the line fold all layers.');
    const far = part('fold-endless').checked ? 2 * (this.state?.side ?? 1) / Math.hypot(to[0] - from[0], to[1] - from[1]) : 0;
    const ends = [from, to].map((end, i) => [0, 1].map((k) => end[k] + (i === 0 ? far : -far) * (from[k] - to[k])));
    if (this.choice('side') === 'right') ends.reverse();
    const state = await post('fold/do', {
      do: 'through', from: ends[0], to: ends[1], stiff: part('fold-stiff').checked, faces,
      mountains: this.flat.wished('M'), valleys: this.flat.wished('V'),
    });
    this.flat.forget();
    return state;
  }

  cancel() {
    this.start = null;
    const held = this.marks.grip !== null;
    this.marks.grip = this.marks.stroke = this.marks.degrees = this.marks.aim = null;
    this.axis = this.marks.axis = null;
    if (held) attempt(async () => this.show(await get('fold/state')));
    this.draw();
  }
}

export async function openFold() {
  const state = get('fold/state'); // on its way while the view is built
  const room = new Room();
  room.show(await state);
  room.overlook();
  window.addEventListener('error', (event) => complain(event.message));
}
