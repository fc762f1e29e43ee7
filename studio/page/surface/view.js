// A surface under a light that the mouse holds, or one of its maps in colours; zoomed and moved.
import * as THREE from '../vendor/three.module.js';

const vertex = /* glsl */ `
  out vec2 at;
  uniform vec2 size;   // of the view, pixels of the surface
  uniform vec2 middle; // of the view, from the upper left of the surface, pixels
  void main() {
    at = middle + 0.5 * size * vec2(position.x, -position.y);
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }`;

const fragment = /* glsl */ `
  precision highp float;
  in vec2 at;
  out vec4 colour;
  uniform sampler2D normals, albedo, height;
  uniform vec2 extent;      // pixels
  uniform vec2 range;       // of the height
  uniform vec3 light;       // towards it
  uniform float exaggeration, gloss, roughness, exposure;
  uniform int mode;         // 0 under the light, 1 normals, 2 height, 3 albedo
  uniform bvec3 present;    // normals, albedo, height

  vec3 srgb(vec3 linear) {
    return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
  }
  // Viridis, as a polynomial (M. Zucker, public domain).
  vec3 viridis(float t) {
    const vec3 c0 = vec3(0.2777, 0.0054, 0.3341), c1 = vec3(0.1051, 1.4046, 1.3846), c2 = vec3(-0.3309, 0.2148, 0.0951),
      c3 = vec3(-4.6342, -5.7991, -19.3324), c4 = vec3(6.2283, 14.1799, 56.6906), c5 = vec3(4.7764, -13.7451, -65.3530),
      c6 = vec3(-5.4355, 4.6459, 26.3124);
    return c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * (c5 + t * c6)))));
  }
  void main() {
    vec2 uv = at / extent;
    if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) {
      colour = vec4(0.914, 0.906, 0.882, 1.0);
      return;
    }
    vec4 sampled = present.x ? texture(normals, uv) : vec4(0.0, 0.0, 1.0, 1.0);
    if (sampled.w < 0.5) {
      colour = vec4(0.80, 0.79, 0.76, 1.0);
      return;
    }
    vec3 base = present.y ? exposure * texture(albedo, uv).rgb : vec3(0.75);
    if (mode == 1) {
      colour = vec4(0.5 + 0.5 * normalize(sampled.xyz), 1.0);
    } else if (mode == 2) {
      float h = texture(height, uv).r;
      colour = vec4(viridis(clamp((h - range.x) / max(range.y - range.x, 1e-12), 0.0, 1.0)), 1.0);
    } else if (mode == 3) {
      colour = vec4(srgb(base), 1.0);
    } else {
      vec3 n = normalize(vec3(exaggeration * sampled.xy, max(sampled.z, 0.02)));
      float lit = max(dot(n, light), 0.0);
      // Blinn's highlight, normalised, for a viewer straight above.
      vec3 between = normalize(light + vec3(0.0, 0.0, 1.0));
      float power = 2.0 / (roughness * roughness) - 1.0;
      float shine = gloss * (power + 8.0) / 25.0 * pow(max(dot(n, between), 0.0), power) * lit;
      colour = vec4(srgb(base * lit * 1.25 + vec3(shine) + base * 0.03), 1.0);
    }
  }`;

const none = new THREE.DataTexture(new Uint8Array(4), 1, 1);

export class SurfaceView {
  /**
   * @param {HTMLElement} view with a canvas in it
   * @param {(line: string) => void} tell what lies under the pointer
   */
  constructor(view, tell) {
    this.view = view;
    this.tell = tell;
    this.renderer = new THREE.WebGLRenderer({ canvas: /** @type {HTMLCanvasElement} */ (view.querySelector('canvas')) });
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // the shader encodes
    this.uniforms = {
      normals: { value: /** @type {THREE.Texture} */ (none) }, albedo: { value: /** @type {THREE.Texture} */ (none) },
      height: { value: /** @type {THREE.Texture} */ (none) }, extent: { value: new THREE.Vector2(1, 1) },
      range: { value: new THREE.Vector2(0, 1) }, light: { value: new THREE.Vector3(-0.45, 0.5, 0.74).normalize() },
      exaggeration: { value: 1 }, gloss: { value: 0 }, roughness: { value: 0.3 }, exposure: { value: 1 }, mode: { value: 0 },
      present: { value: new THREE.Vector3() }, size: { value: new THREE.Vector2(1, 1) },
      middle: { value: new THREE.Vector2() },
    };
    const material = new THREE.RawShaderMaterial({ glslVersion: THREE.GLSL3, uniforms: this.uniforms,
      vertexShader: `in vec3 position;${vertex}`, fragmentShader: fragment });
    this.scene = new THREE.Scene();
    const sheet = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    sheet.frustumCulled = false;
    this.scene.add(sheet);
    this.camera = new THREE.Camera();
    /** @type {import('./maps.js').Maps | null} */
    this.maps = null;
    this.scale = 1; // pixels of the view for one of the surface
    this.wanted = false;
    new ResizeObserver(() => this.resize()).observe(view);
    this.listen();
  }

  /** @param {import('./maps.js').Maps} maps */
  show(maps) {
    const fresh = !this.maps || this.maps.cols !== maps.cols || this.maps.rows !== maps.rows;
    this.maps = maps;
    const texture = (/** @type {Uint16Array | Float32Array | null} */ values, /** @type {any} */ format, /** @type {any} */ type) => {
      if (!values) return none;
      const made = new THREE.DataTexture(values, maps.cols, maps.rows, format, type);
      const smooth = type === THREE.HalfFloatType;
      made.minFilter = smooth ? THREE.LinearMipmapLinearFilter : THREE.NearestFilter;
      made.magFilter = THREE.NearestFilter;
      made.generateMipmaps = smooth;
      made.needsUpdate = true;
      return made;
    };
    const u = this.uniforms;
    for (const old of [u.normals.value, u.albedo.value, u.height.value]) if (old !== none) old.dispose();
    u.normals.value = texture(maps.normals, THREE.RGBAFormat, THREE.HalfFloatType);
    u.albedo.value = texture(maps.albedo, THREE.RGBAFormat, THREE.HalfFloatType);
    u.height.value = texture(maps.height, THREE.RedFormat, THREE.FloatType);
    u.present.value.set(maps.normals ? 1 : 0, maps.albedo ? 1 : 0, maps.height ? 1 : 0);
    u.extent.value.set(maps.cols, maps.rows);
    u.range.value.set(maps.low, maps.high);
    u.exposure.value = 0.8 / maps.white; // as a photographer would
    if (fresh) this.whole();
    this.draw();
  }

  /** The whole surface in sight. */
  whole() {
    if (!this.maps) return;
    this.scale = 0.96 * Math.min(this.view.clientWidth / this.maps.cols, this.view.clientHeight / this.maps.rows);
    this.uniforms.middle.value.set(this.maps.cols / 2, this.maps.rows / 2);
    this.draw();
  }

  /** @param {Partial<Record<'exaggeration' | 'gloss' | 'roughness' | 'mode', number>>} values */
  set(values) {
    for (const [name, value] of Object.entries(values)) {
      /** @type {Record<string, {value: any}>} */ (this.uniforms)[name].value = value;
    }
    this.draw();
  }

  resize() {
    const [width, height] = [this.view.clientWidth, this.view.clientHeight];
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.whole();
  }

  draw() {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      this.uniforms.size.value.set(this.view.clientWidth / this.scale, this.view.clientHeight / this.scale);
      if (this.maps) this.renderer.render(this.scene, this.camera);
    });
  }

  /** The light stands where a hand would hold it: over the pointer. @param {number} x @param {number} y pixels */
  hold(x, y) {
    const radius = 0.5 * Math.min(this.view.clientWidth, this.view.clientHeight);
    let [lx, ly] = [(x - this.view.clientWidth / 2) / radius, (this.view.clientHeight / 2 - y) / radius];
    const far = Math.hypot(lx, ly);
    if (far > 0.98) [lx, ly] = [(0.98 * lx) / far, (0.98 * ly) / far];
    this.uniforms.light.value.set(lx, ly, Math.sqrt(1 - lx * lx - ly * ly));
    this.draw();
  }

  /** @param {number} x @param {number} y @returns {[number, number]} column and row, with fractions */
  pixel(x, y) {
    const middle = this.uniforms.middle.value;
    return [middle.x + (x - this.view.clientWidth / 2) / this.scale, middle.y + (y - this.view.clientHeight / 2) / this.scale];
  }

  listen() {
    const { view } = this;
    let button = -1;
    const at = (/** @type {PointerEvent | WheelEvent} */ event) => {
      const box = view.getBoundingClientRect();
      return /** @type {[number, number]} */ ([event.clientX - box.left, event.clientY - box.top]);
    };
    view.addEventListener('contextmenu', (event) => event.preventDefault());
    view.addEventListener('pointerdown', (event) => {
      view.focus({ preventScroll: true });
      view.setPointerCapture(event.pointerId);
      button = event.button;
      if (button === 0) this.hold(...at(event));
    });
    view.addEventListener('pointerup', () => (button = -1));
    view.addEventListener('pointercancel', () => (button = -1));
    view.addEventListener('pointermove', (event) => {
      if (button === 0) this.hold(...at(event));
      if (button > 0) {
        this.uniforms.middle.value.x -= event.movementX / this.scale;
        this.uniforms.middle.value.y -= event.movementY / this.scale;
        this.draw();
      }
      const [col, row] = this.pixel(...at(event));
      this.tell(this.maps?.at(Math.floor(col), Math.floor(row)) ?? '');
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
      const light = this.uniforms.light.value;
      if (way) {
        const radius = 0.5 * Math.min(view.clientWidth, view.clientHeight);
        this.hold(view.clientWidth / 2 + radius * (light.x + 0.05 * way[0]), view.clientHeight / 2 - radius * (light.y + 0.05 * way[1]));
      } else if (event.key === '+' || event.key === '-') {
        this.zoom(event.key === '+' ? 1.25 : 0.8, view.clientWidth / 2, view.clientHeight / 2);
      } else if (event.key === '0') this.whole();
      else return;
      event.preventDefault();
    });
  }

  /** Around a place of the view, which stays where it is. @param {number} factor @param {number} x @param {number} y */
  zoom(factor, x, y) {
    const [col, row] = this.pixel(x, y);
    this.scale = Math.min(64, Math.max(0.05, this.scale * factor));
    const [newCol, newRow] = this.pixel(x, y);
    this.uniforms.middle.value.x += col - newCol;
    this.uniforms.middle.value.y += row - newRow;
    this.draw();
  }
}
