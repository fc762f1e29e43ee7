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

// Viridis at five places: 1e-12 and below to 1e-3 and above.
const strainColours = [0x440154, 0x3b528b, 0x21918c, 0x5ec962, 0xfde725].map((c) => new THREE.Color(c));

/** @param {number} strain @returns {THREE.Color} */
function colourOfStrain(strain) {
  const share = Math.min(1, Math.max(0, (Math.log10(Math.max(strain, 1e-15)) + 12) / 9));
  const place = share * (strainColours.length - 1);
  const low = Math.min(strainColours.length - 2, Math.floor(place));
  return strainColours[low].clone().lerp(strainColours[low + 1], place - low);
}

export class Paper {
  constructor() {
    this.group = new THREE.Group();
    this.faces = new THREE.BufferGeometry();
    const common = { vertexColors: true, flatShading: true, polygonOffset: true, polygonOffsetFactor: 1,
      polygonOffsetUnits: 1 };
    this.front = new THREE.Mesh(this.faces, new THREE.MeshLambertMaterial({ ...common, side: THREE.FrontSide }));
    this.backs = new THREE.BufferGeometry();
    this.back = new THREE.Mesh(this.backs, new THREE.MeshLambertMaterial({ ...common, side: THREE.BackSide }));
    this.lines = new THREE.BufferGeometry();
    const outline = new THREE.LineSegments(this.lines, new THREE.LineBasicMaterial({ vertexColors: true }));
    this.group.add(this.front, this.back, outline);
    this.strains = false;
  }

  /**
   * @param {Shape} shape
   * @param {FoldState} state whose creases colour the edges
   */
  show(shape, state) {
    /** @type {number[]} */
    const places = [];
    /** @type {number[]} */
    const printed = [];
    /** @type {number[]} */
    const white = [];
    /** @type {number[]} */
    const ends = [];
    /** @type {number[]} */
    const ink = [];
    const creases = new Map(state.edges.map((edge) => [`${edge.from} ${edge.to}`, edge.crease]));
    const chosen = new Set(state.chosen);
    shape.faces.forEach((corners, f) => {
      const lift = shape.piles.level[f] * gap * state.side;
      const at = (/** @type {number} */ v) =>
        [0, 1, 2].map((k) => shape.vertices[3 * v + k] + lift * shape.piles.up[3 * f + k]);
      const strain = colourOfStrain(shape.strain.faces[f]);
      const tint = chosen.has(f) ? 0.55 : 1;
      const front = (this.strains ? strain : print).clone().multiplyScalar(tint);
      const reverse = (this.strains ? strain : back).clone().multiplyScalar(tint);
      for (let i = 1; i + 1 < corners.length; ++i) {
        for (const v of [corners[0], corners[i], corners[i + 1]]) {
          places.push(...at(v));
          printed.push(front.r, front.g, front.b);
          white.push(reverse.r, reverse.g, reverse.b);
        }
      }
      corners.forEach((v, i) => {
        const w = corners[(i + 1) % corners.length];
        ends.push(...at(v), ...at(w));
        const crease = creases.get(`${v} ${w}`) ?? creases.get(`${w} ${v}`) ?? 'F';
        const colour = edgeColours[crease] ?? edgeColours.F;
        ink.push(colour.r, colour.g, colour.b, colour.r, colour.g, colour.b);
      });
    });
    const fill = (/** @type {THREE.BufferGeometry} */ geometry, /** @type {number[]} */ position,
      /** @type {number[]} */ colour) => {
      geometry.setAttribute('position', new THREE.Float32BufferAttribute(position, 3));
      geometry.setAttribute('color', new THREE.Float32BufferAttribute(colour, 3));
      geometry.computeBoundingSphere();
    };
    fill(this.faces, places, printed);
    fill(this.backs, places, white);
    fill(this.lines, ends, ink);
  }
}
