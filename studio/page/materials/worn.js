// A knit on a leg, its yarns in the colours of how dense it is.
import * as THREE from '../vendor/three.module.js';
import { post } from '../api.js';
import { geometryOf } from './stage.js';

const rings = { courses: 80, wales: 48 };
const lift = 0.4; // of the yarns off the skin, mm

/** Viridis at five places. */
const colours = [0x440154, 0x3b528b, 0x21918c, 0x5ec962, 0xfde725].map((c) => new THREE.Color(c));

/** @param {number} share @returns {THREE.Color} */
function colourOf(share) {
  const at = Math.min(1, Math.max(0, share)) * (colours.length - 1);
  const k = Math.min(colours.length - 2, Math.floor(at));
  return colours[k].clone().lerp(colours[k + 1], at - k);
}

export class Worn {
  /** @param {import('./stage.js').Stage} stage @param {(low: string, high: string) => void} tell what the colours mean */
  constructor(stage, tell) {
    this.stage = stage;
    this.tell = tell;
    this.group = new THREE.Group();
    this.group.rotation.y = 0.6;
  }

  async enter() {
    const { stage } = this;
    stage.clear(0xe9e7e1);
    const sun = new THREE.DirectionalLight(0xffffff, 2.2);
    sun.position.set(-0.6, 0.5, 1);
    stage.scene.add(this.group, sun, new THREE.AmbientLight(0xffffff, 1.1));
    stage.eye.overlook(0, 0, 0.9);
  }

  /** @param {any} wanted what the sliders say */
  async show({ file }) {
    const found = await post('solid/knit', { file, ...rings });
    const { courses, wales, stitches, normals, density, low, high } = found;
    const at = (/** @type {number} */ c, /** @type {number} */ w) => c * wales + (w % wales);
    const places = new Float32Array(stitches.length);
    const shades = new Float32Array(stitches.length);
    for (let i = 0; i < density.length; ++i) {
      for (let k = 0; k < 3; ++k) places[3 * i + k] = stitches[3 * i + k] + lift * normals[3 * i + k];
      colourOf((density[i] - low) / (high - low)).toArray(shades, 3 * i);
    }
    /** @type {number[]} */
    const lines = [];
    for (let c = 0; c < courses; ++c) {
      for (let w = 0; w < wales; ++w) {
        lines.push(at(c, w), at(c, w + 1));
        if (c + 1 < courses) lines.push(at(c, w), at(c + 1, w));
      }
    }
    const net = new THREE.BufferGeometry();
    net.setAttribute('position', new THREE.BufferAttribute(places, 3));
    net.setAttribute('color', new THREE.BufferAttribute(shades, 3));
    net.setIndex(lines);
    const leg = geometryOf(found.leg);
    leg.computeBoundingBox();
    const box = /** @type {THREE.Box3} */ (leg.boundingBox);
    const scale = 1.25 / box.getSize(new THREE.Vector3()).y;
    this.group.clear();
    this.group.add(new THREE.Mesh(leg, new THREE.MeshStandardMaterial({ color: 0xd9b8a0, roughness: 0.8, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 })),
      new THREE.LineSegments(net, new THREE.LineBasicMaterial({ vertexColors: true })));
    this.group.scale.setScalar(scale);
    const middle = box.getCenter(new THREE.Vector3()).multiplyScalar(scale).applyEuler(this.group.rotation);
    this.group.position.copy(middle.negate());
    this.tell(low.toPrecision(2), `${high.toPrecision(2)} ${found.unit}`);
    this.stage.draw();
  }
}
