// A small stage for solid things: a camera that the pointer turns, and frames on demand.
import * as THREE from '../vendor/three.module.js';
import { Eye } from '../fold/camera.js';
import { listen } from '../fold/pointer.js';

export class Stage {
  /** @param {HTMLElement} view with a canvas in it */
  constructor(view) {
    this.view = view;
    this.renderer = new THREE.WebGLRenderer({ canvas: /** @type {HTMLCanvasElement} */ (view.querySelector('canvas')), antialias: true });
    this.renderer.localClippingEnabled = true;
    this.scene = new THREE.Scene();
    this.eye = new Eye();
    /** What is done with a drag instead of turning: by how many pixels. @type {((x: number, y: number) => void) | null} */
    this.dragged = null;
    /** Whether something at a place of the view is to be dragged. @param {number} x @param {number} y in -1 to 1 */
    this.grips = (x, y) => x < y && x > y;
    this.wanted = false;
    let last = [0, 0];
    let held = false;
    /** @param {number} x @param {number} y */
    const press = (x, y) => {
      last = [x, y];
      held = this.grips((2 * x) / view.clientWidth - 1, 1 - (2 * y) / view.clientHeight);
    };
    const look = (/** @type {() => void} */ change) => {
      change();
      this.draw();
    };
    let down = false;
    listen(view, {
      press: (x, y) => {
        down = true;
        press(x, y);
      },
      move: (x, y) => {
        if (!down) return;
        const [dx, dy] = [x - last[0], y - last[1]];
        last = [x, y];
        if (held) this.dragged?.(dx, dy);
        else look(() => this.eye.orbit(dx * 0.008, -dy * 0.008));
      },
      release: () => (down = false),
      cancel: () => (down = false),
      orbit: (right, up) => look(() => this.eye.orbit(right, up)),
      slide: (right, up) => look(() => this.eye.slide(right, up)),
      zoom: (factor) => look(() => this.eye.zoom(factor)),
      cross: () => {},
    });
    new ResizeObserver(() => this.resize()).observe(view);
  }

  resize() {
    const [width, height] = [this.view.clientWidth, this.view.clientHeight];
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.eye.fit(width, height);
    this.draw();
  }

  draw() {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      this.renderer.render(this.scene, this.eye.camera);
    });
  }

  /** Nothing on it. @param {number} ground its colour */
  clear(ground) {
    this.scene.clear();
    this.scene.environment = null;
    this.scene.background = new THREE.Color(ground);
    this.dragged = null;
    this.grips = () => false;
  }
}

/** A texture of colours. @param {import('../surface/maps.js').Maps} maps */
export function colourTexture(maps) {
  return texture(/** @type {Uint16Array} */ (maps.albedo), maps, THREE.HalfFloatType);
}

/** Normals as a texture of bytes. @param {import('../surface/maps.js').Maps} maps @param {number} exaggeration of their slopes */
export function normalTexture(maps, exaggeration) {
  const half = THREE.DataUtils.fromHalfFloat;
  const from = /** @type {Uint16Array} */ (maps.normals);
  const to = new Uint8Array(from.length);
  for (let i = 0; i < from.length; i += 4) {
    const n = [exaggeration * half(from[i]), exaggeration * half(from[i + 1]), half(from[i + 2])];
    const length = Math.hypot(...n);
    for (let k = 0; k < 3; ++k) to[i + k] = Math.round(127.5 + (127.5 * n[k]) / length);
    to[i + 3] = 255;
  }
  return texture(to, maps, THREE.UnsignedByteType);
}

/** @param {Uint16Array | Uint8Array} values @param {import('../surface/maps.js').Maps} maps @param {any} type */
function texture(values, maps, type) {
  const made = new THREE.DataTexture(values, maps.cols, maps.rows, THREE.RGBAFormat, type);
  made.flipY = false;
  made.minFilter = THREE.LinearMipmapLinearFilter;
  made.magFilter = THREE.LinearFilter;
  made.generateMipmaps = true;
  made.anisotropy = 8;
  made.needsUpdate = true;
  return made;
}

/** @param {{vertices: number[], uv?: number[], triangles: number[]}} mesh */
export function geometryOf(mesh) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(mesh.vertices, 3));
  // Row 0 of our maps is the top.
  if (mesh.uv?.length) geometry.setAttribute('uv', new THREE.Float32BufferAttribute(mesh.uv.map((t, i) => (i % 2 ? 1 - t : t)), 2));
  geometry.setIndex(mesh.triangles);
  geometry.computeVertexNormals();
  return geometry;
}
