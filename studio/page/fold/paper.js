// The sheet as it is seen: faces with a printed and a white side, piled up so that none hides what
// lies on it, and their edges.
import * as THREE from '../vendor/three.module.js';

const print = new THREE.Color(0xdd5b3f);
const back = new THREE.Color(0xf6f3ea);
const gap = 0.0006; // between layers, share of the side: for the eye alone
/** @type {Record<string, THREE.Color>} */
const edgeColours = {
  B: new THREE.Color(0x20242c),
  M: new THREE.Color(0x7c1420),
  V: new THREE.Color(0x123f8c),
  U: new THREE.Color(0x4a3b78),
  F: new THREE.Color(0x9a948a),
};

const vertex = /* glsl */ `
  attribute vec3 printed, white;
  varying vec3 front, reverse, seen;
  void main() {
    front = printed;
    reverse = white;
    seen = (modelViewMatrix * vec4(position, 1.0)).xyz;
    gl_Position = projectionMatrix * vec4(seen, 1.0);
  }`;
// Matt paper under a light that goes with the eye.
const fragment = /* glsl */ `
  varying vec3 front, reverse, seen;
  void main() {
    vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
    float light = 0.40 + 0.67 * max(0.0, dot(normal, normalize(vec3(-0.5, 0.6, 1.2))));
    gl_FragColor = vec4((gl_FrontFacing ? front : reverse) * light, 1.0);
    #include <colorspace_fragment>
  }`;

// Viridis at five places: 1e-12 and below to 1e-3 and above.
const scale = [0x440154, 0x3b528b, 0x21918c, 0x5ec962, 0xfde725].map((c) => new THREE.Color(c));

/** @param {number} value of strain or planarity @returns {THREE.Color} */
function onScale(value) {
  const share = Math.min(1, Math.max(0, (Math.log10(Math.max(value, 1e-15)) + 12) / 9));
  const place = share * (scale.length - 1);
  const low = Math.min(scale.length - 2, Math.floor(place));
  return scale[low].clone().lerp(scale[low + 1], place - low);
}

/**
 * Makes room for so many points, in the buffers that are there if they fit: a sheet in the hand keeps its faces.
 * @param {THREE.BufferGeometry} geometry @param {string[]} names of attributes of three numbers @param {number} count
 * @returns {(...values: number[][]) => void} puts in the next point
 */
function filled(geometry, names, count) {
  if (geometry.getAttribute(names[0])?.count !== count) {
    geometry.dispose();
    for (const name of names) geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * count), 3).setUsage(THREE.DynamicDrawUsage));
  }
  const into = names.map((name) => /** @type {THREE.BufferAttribute} */ (geometry.getAttribute(name)));
  for (const attribute of into) attribute.needsUpdate = true;
  let next = 0;
  return (...values) => {
    into.forEach((attribute, i) => attribute.array.set(values[i], next));
    next += 3;
  };
}

export class Paper {
  constructor() {
    this.group = new THREE.Group();
    this.faces = new THREE.BufferGeometry();
    this.lines = new THREE.BufferGeometry();
    const paper = new THREE.ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    const outline = new THREE.LineSegments(this.lines, new THREE.LineBasicMaterial({ vertexColors: true }));
    this.group.add(new THREE.Mesh(this.faces, paper), outline);
    /** What the faces are coloured by: 'strain', 'planarity', or '' for the paper itself. */
    this.by = '';
  }

  /**
   * @param {Shape} shape
   * @param {FoldState} state whose creases colour the edges
   */
  show(shape, state) {
    const creases = new Map(state.edges.map((edge) => [`${edge.from} ${edge.to}`, edge.crease]));
    const chosen = new Set(state.chosen);
    const values = this.by === 'strain' || this.by === 'planarity' ? shape[this.by].faces : null;
    const corners = shape.faces.reduce((sum, face) => sum + face.length, 0);
    const triangles = filled(this.faces, ['position', 'printed', 'white'], 3 * (corners - 2 * shape.faces.length));
    const ends = filled(this.lines, ['position', 'color'], 2 * corners);
    shape.faces.forEach((face, f) => {
      const lift = shape.piles.level[f] * gap * state.side;
      const at = face.map((v) => [0, 1, 2].map((k) => shape.vertices[3 * v + k] + lift * shape.piles.up[3 * f + k]));
      const colour = values ? onScale(values[f]) : null;
      const tint = chosen.has(f) ? 0.55 : 1;
      const front = (colour ?? print).clone().multiplyScalar(tint).toArray();
      const reverse = (colour ?? back).clone().multiplyScalar(tint).toArray();
      for (let i = 1; i + 1 < face.length; ++i) for (const k of [0, i, i + 1]) triangles(at[k], front, reverse);
      face.forEach((v, i) => {
        const next = (i + 1) % face.length, w = face[next];
        const crease = creases.get(`${v} ${w}`) ?? creases.get(`${w} ${v}`) ?? 'F';
        const ink = (edgeColours[crease] ?? edgeColours.F).toArray();
        ends(at[i], ink);
        ends(at[next], ink);
      });
    });
    this.faces.computeBoundingSphere();
    this.lines.computeBoundingSphere();
  }
}
