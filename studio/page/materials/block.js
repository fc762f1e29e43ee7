// A block of wood and the plane that it is cut by: the cut is dragged through it.
import * as THREE from '../vendor/three.module.js';
import { bytes } from '../api.js';
import { Maps } from '../surface/maps.js';
import { colourTexture } from './stage.js';

const pixels = 192; // of a face

/** The faces of the block: right and up on the picture, and outward. @type {[number, number, number][][]} */
const faces = [
  [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
  [[1, 0, 0], [0, 0, 1], [0, -1, 0]], [[-1, 0, 0], [0, 0, 1], [0, 1, 0]],
  [[0, 1, 0], [0, 0, 1], [1, 0, 0]], [[0, -1, 0], [0, 0, 1], [-1, 0, 0]],
];

const vector = (/** @type {number[]} */ v) => new THREE.Vector3(...v);

/** A square with a picture, in the frame of its cut. @param {THREE.Vector3} right @param {THREE.Vector3} up @param {THREE.Vector3} middle @param {number} side */
function place(/** @type {THREE.Mesh} */ mesh, right, up, middle, side) {
  const turn = new THREE.Matrix4().makeBasis(right, up, right.clone().cross(up));
  mesh.matrix.copy(turn.scale(new THREE.Vector3(side, side, 1)).setPosition(middle));
  mesh.matrixAutoUpdate = false;
}

function square() {
  const geometry = new THREE.PlaneGeometry(1, 1);
  const uv = geometry.getAttribute('uv');
  for (let i = 0; i < uv.count; ++i) uv.setY(i, 1 - uv.getY(i)); // row 0 is the top
  return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
}

export class Block {
  /**
   * @param {import('./stage.js').Stage} stage
   * @param {() => void} changed the cut was moved
   */
  constructor(stage, changed) {
    this.stage = stage;
    this.changed = changed;
    this.tilt = 35; // of the cut, degrees
    this.turn = 30; // about the stem
    this.depth = 0.1; // of the cut from the middle, over the side
    this.side = 60; // mm
    this.shown = '';
    this.plane = new THREE.Plane();
    this.sides = faces.map(square);
    this.cut = square();
    this.group = new THREE.Group();
    this.group.add(...this.sides, this.cut);
  }

  async enter() {
    const { stage } = this;
    stage.clear(0xe9e7e1);
    stage.scene.add(this.group);
    stage.eye.overlook(0, 0, 1.15);
    // The stem stands upright.
    stage.eye.orbit(0, -1.15);
    stage.eye.turnAbout([0, 0, 0], [0, 0, 1], 0.6);
    stage.grips = (x, y) => {
      const ray = new THREE.Raycaster();
      ray.setFromCamera(new THREE.Vector2(x, y), stage.eye.camera);
      return ray.intersectObject(this.cut).some(({ point }) => point.toArray().every((p) => Math.abs(p) <= 0.5001));
    };
    stage.dragged = (dx, dy) => {
      // Along its normal, as that is seen.
      const tip = this.plane.normal.clone().project(stage.eye.camera).sub(new THREE.Vector3().project(stage.eye.camera));
      const [sx, sy] = [(tip.x * stage.view.clientWidth) / 2, (-tip.y * stage.view.clientHeight) / 2];
      const along = (dx * sx + dy * sy) / Math.max(sx * sx + sy * sy, 1e-6);
      this.depth = Math.min(0.8, Math.max(-0.8, this.depth + along));
      this.changed();
    };
    this.shown = '';
  }

  /** The frame of the cut: right, up, and outward. */
  frame() {
    const [tilt, turn] = [(this.tilt * Math.PI) / 180, (this.turn * Math.PI) / 180];
    const right = new THREE.Vector3(-Math.sin(turn), Math.cos(turn), 0);
    const outward = new THREE.Vector3(Math.sin(tilt) * Math.cos(turn), Math.sin(tilt) * Math.sin(turn), Math.cos(tilt));
    return { right, up: outward.clone().cross(right), outward };
  }

  /** The picture of a cut through the stem. @param {any} wanted @param {THREE.Vector3} right @param {THREE.Vector3} up @param {THREE.Vector3} middle @param {number} side in sides */
  async picture({ file, seed }, right, up, middle, side) {
    const centre = file.parameters.cut_origin_mm;
    const parameters = { ...file.parameters, cut_right: right.toArray(), cut_up: up.toArray(),
      cut_origin_mm: middle.toArray().map((p, k) => p * this.side + centre[k]) };
    const size_px = Math.round(pixels * side);
    const pitch = (this.side * side) / size_px;
    return new Maps(await bytes('material/preview', { file: { ...file, parameters }, seed, size_px, pitch }));
  }

  /** @param {THREE.Mesh} mesh @param {Maps} maps @param {number} bright */
  static paint(mesh, maps, bright) {
    const material = /** @type {THREE.MeshBasicMaterial} */ (mesh.material);
    material.map?.dispose();
    material.map = colourTexture(maps);
    const lit = (bright * 0.55) / maps.white;
    material.color = new THREE.Color(lit, lit, lit);
    material.needsUpdate = true;
  }

  /** @param {any} wanted what the sliders say */
  async show(wanted) {
    this.side = (wanted.size_px * wanted.pitch) / 2.4;
    const { right, up, outward } = this.frame();
    const middle = outward.clone().multiplyScalar(this.depth);
    const wide = Math.sqrt(3);
    this.plane.set(outward.clone().negate(), this.depth);
    // What is beyond the cut is taken away; of the cut, what lies outside the block.
    for (const side of this.sides) /** @type {THREE.Material} */ (side.material).clippingPlanes = [this.plane];
    /** @type {THREE.Material} */ (this.cut.material).clippingPlanes = faces.map((f) => new THREE.Plane(vector(f[2]).negate(), 0.5));
    const cutMaps = await this.picture(wanted, right, up, middle, wide);
    place(this.cut, right, up, middle, wide);
    Block.paint(this.cut, cutMaps, 1.12);
    this.stage.draw();
    const key = JSON.stringify([wanted.file, wanted.seed, this.side]);
    if (key === this.shown) return;
    for (const [i, [r, u, out]] of faces.entries()) {
      const at = vector(out).multiplyScalar(0.5);
      Block.paint(this.sides[i], await this.picture(wanted, vector(r), vector(u), at, 1), 1 - 0.08 * (i % 3));
      place(this.sides[i], vector(r), vector(u), at, 1);
      this.stage.draw();
    }
    this.shown = key;
  }
}
