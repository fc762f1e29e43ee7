// A surface as the graphics card knows it: its maps as textures, and what light does to them.
import * as THREE from '../vendor/three.module.js';

const head = /* glsl */ `
  in vec3 position;
  out vec2 at;      // pixels of the surface, from its upper left
  out vec3 place;   // in space
  uniform vec2 extent;`;

const flat = /* glsl */ `${head}
  uniform vec2 size;   // of the view, pixels of the surface
  uniform vec2 middle; // of the view, from the upper left of the surface, pixels
  void main() {
    at = middle + 0.5 * size * vec2(position.x, -position.y);
    place = vec3(0.0);
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }`;

const raised = /* glsl */ `${head}
  uniform highp sampler2D height;
  uniform mat4 modelViewMatrix, projectionMatrix;
  uniform float exaggeration, pitch;
  void main() {
    vec2 uv = position.xy;
    at = uv * extent;
    float longest = max(extent.x, extent.y);
    float h = textureLod(height, uv, 0.0).r * exaggeration / (pitch * longest);
    place = vec3((uv.x - 0.5) * extent.x / longest, (0.5 - uv.y) * extent.y / longest, h);
    gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
  }`;

const fragment = /* glsl */ `
  precision highp float;
  in vec2 at;
  in vec3 place;
  out vec4 colour;
  uniform sampler2D normals, albedo, height, sigma;
  uniform vec2 extent;      // pixels
  uniform vec2 range;       // of the height, or of the sigma
  uniform vec3 light;       // towards it
  uniform vec3 eye;         // where it is, in space
  uniform float exaggeration, gloss, roughness, exposure;
  uniform int mode;         // as look.js names them
  uniform bvec3 present;    // normals, albedo, height
  uniform bool space, metal;

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
      if (space) discard;
      colour = vec4(0.80, 0.79, 0.76, 1.0);
      return;
    }
    vec3 base = present.y ? exposure * texture(albedo, uv).rgb : vec3(0.75);
    if (mode == 1) {
      colour = vec4(0.5 + 0.5 * normalize(sampled.xyz), 1.0);
    } else if (mode == 2 || mode > 3) {
      float value = mode == 2 ? texture(height, uv).r : texture(sigma, uv).r;
      colour = vec4(viridis(clamp((value - range.x) / max(range.y - range.x, 1e-12), 0.0, 1.0)), 1.0);
    } else if (mode == 3) {
      colour = vec4(srgb(base), 1.0);
    } else {
      vec3 n = normalize(vec3(exaggeration * sampled.xy, max(sampled.z, 0.02)));
      float lit = max(dot(n, light), 0.0);
      // Blinn's highlight, normalised; a flat sheet is seen from straight above.
      vec3 seen = space ? normalize(eye - place) : vec3(0.0, 0.0, 1.0);
      vec3 between = normalize(light + seen);
      float power = 2.0 / (roughness * roughness) - 1.0;
      float shine = gloss * (power + 8.0) / 25.0 * pow(max(dot(n, between), 0.0), power) * lit;
      colour = vec4(srgb(base * (0.03 + 0.97 * lit) + vec3(shine)), 1.0);
    }
  }`;

const none = new THREE.DataTexture(new Uint8Array(4), 1, 1);
const finest = 256; // pieces along the longer side in three dimensions

/** Places of a lattice from (0, 0) to (1, 1). @param {number} across @param {number} down */
function lattice(across, down) {
  const geometry = new THREE.PlaneGeometry(1, 1, across, down);
  geometry.translate(0.5, 0.5, 0);
  return geometry;
}

export class Sheet {
  constructor() {
    const texture = () => ({ value: /** @type {THREE.Texture} */ (none) });
    this.uniforms = {
      normals: texture(), albedo: texture(), height: texture(), sigma: texture(),
      extent: { value: new THREE.Vector2(1, 1) }, range: { value: new THREE.Vector2(0, 1) },
      light: { value: new THREE.Vector3() }, eye: { value: new THREE.Vector3() }, pitch: { value: 1 },
      exaggeration: { value: 1 }, gloss: { value: 0 }, roughness: { value: 0.3 }, exposure: { value: 1 }, mode: { value: 0 },
      present: { value: new THREE.Vector3() }, size: { value: new THREE.Vector2(1, 1) }, middle: { value: new THREE.Vector2() },
      space: { value: false }, metal: { value: false },
    };
    const shader = (/** @type {string} */ vertexShader) => new THREE.RawShaderMaterial({ glslVersion: THREE.GLSL3,
      uniforms: this.uniforms, vertexShader, fragmentShader: fragment, side: THREE.DoubleSide });
    this.flat = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), shader(flat));
    this.raised = new THREE.Mesh(lattice(1, 1), shader(raised));
    this.flat.frustumCulled = this.raised.frustumCulled = false;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(0.914, 0.906, 0.882);
    this.scene.add(this.flat, this.raised);
    /** @type {import('./maps.js').Maps | null} */
    this.maps = null;
  }

  /** @param {import('./maps.js').Maps} maps */
  show(maps) {
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
    for (const old of [u.normals, u.albedo, u.height, u.sigma]) if (old.value !== none) old.value.dispose();
    u.normals.value = texture(maps.normals, THREE.RGBAFormat, THREE.HalfFloatType);
    u.albedo.value = texture(maps.albedo, THREE.RGBAFormat, THREE.HalfFloatType);
    u.height.value = texture(maps.height, THREE.RedFormat, THREE.FloatType);
    this.sigmas = { 4: texture(maps.normalSigma, THREE.RedFormat, THREE.FloatType), 5: texture(maps.heightSigma, THREE.RedFormat, THREE.FloatType) };
    u.present.value.set(maps.normals ? 1 : 0, maps.albedo ? 1 : 0, maps.height ? 1 : 0);
    u.extent.value.set(maps.cols, maps.rows);
    u.pitch.value = maps.pitch;
    u.exposure.value = 0.8 / maps.white; // as a photographer would
    const longest = Math.max(maps.cols, maps.rows);
    const pieces = (/** @type {number} */ side) => Math.max(1, Math.round((Math.min(finest, longest) * side) / longest));
    this.raised.geometry.dispose();
    this.raised.geometry = lattice(pieces(maps.cols), pieces(maps.rows));
  }

  /** @param {import('./look.js').Look} look @param {number} width @param {number} height of the view */
  follow(look, width, height) {
    const u = this.uniforms;
    u.size.value.set(width / look.scale, height / look.scale);
    u.middle.value.copy(look.middle);
    u.light.value.copy(look.light);
    u.eye.value.copy(look.eye.camera.position);
    if (look.space) u.light.value.applyQuaternion(look.eye.turn);
    for (const name of /** @type {const} */ (['exaggeration', 'gloss', 'roughness', 'mode', 'space', 'metal'])) u[name].value = /** @type {never} */ (look[name]);
    const { maps, sigmas } = this;
    if (look.mode === 4 || look.mode === 5) {
      u.sigma.value = sigmas?.[look.mode] ?? none;
      u.range.value.set(0, (look.mode === 4 ? maps?.highNormalSigma : maps?.highHeightSigma) || 1);
    } else {
      u.range.value.set(maps?.low ?? 0, maps?.high ?? 1);
    }
    this.flat.visible = !look.space;
    this.raised.visible = look.space;
  }
}
