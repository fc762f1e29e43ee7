// The eye: it looks at a target from a distance, turned in any way.
import * as THREE from '../vendor/three.module.js';

const field = 28; // degrees from the lower to the upper edge

export class Eye {
  constructor() {
    this.camera = new THREE.PerspectiveCamera(field, 1, 0.01, 100);
    this.turn = new THREE.Quaternion();
    this.target = new THREE.Vector3();
    this.distance = 3;
  }

  /**
   * From above, a whole sheet in sight.
   * @param {number} x @param {number} y in the middle of the view @param {number} side
   */
  overlook(x, y, side) {
    this.turn.identity();
    this.target.set(x, y, 0);
    this.distance = 3 * side;
    this.place();
  }

  place() {
    this.camera.quaternion.copy(this.turn);
    this.camera.position.set(0, 0, this.distance).applyQuaternion(this.turn).add(this.target);
    this.camera.updateMatrixWorld();
  }

  /** @param {number} width @param {number} height pixels */
  fit(width, height) {
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.place();
  }

  /** Turns as if the model were in the hand. @param {number} right @param {number} up radians */
  orbit(right, up) {
    const about = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ angle) =>
      new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(x, y, 0), angle);
    this.turn.multiply(about(0, 1, -right)).multiply(about(1, 0, -up)).normalize();
    this.place();
  }

  /** @param {number} right @param {number} up shares of the view */
  slide(right, up) {
    const size = 2 * this.distance * Math.tan((field * Math.PI) / 360);
    const way = new THREE.Vector3(-right * size, -up * size, 0).applyQuaternion(this.turn);
    this.target.add(way);
    this.place();
  }

  /** @param {number} factor */
  zoom(factor) {
    this.distance = Math.min(30, Math.max(0.1, this.distance * factor));
    this.place();
  }

  /**
   * Turns the view about a line on the paper, so that what lies on the line stays under the pointer.
   * @param {Place} from @param {Place} to @param {number} angle
   */
  turnAbout(from, to, angle) {
    const fixed = new THREE.Vector3(...from);
    const line = new THREE.Vector3(...to).sub(fixed).normalize();
    const turn = new THREE.Quaternion().setFromAxisAngle(line, angle);
    this.turn.premultiply(turn);
    this.target.sub(fixed).applyQuaternion(turn).add(fixed);
    this.place();
  }

  /**
   * The line of sight through a place of the view. @param {number} x @param {number} y in -1 to 1
   * @returns {Ray}
   */
  ray(x, y) {
    const eye = this.camera.position;
    const way = new THREE.Vector3(x, y, 0.5).unproject(this.camera).sub(eye).normalize();
    return { eye: eye.toArray(), way: way.toArray() };
  }

  /** @param {number} height of the view, pixels @returns {number} length of a pixel at the target */
  pixel(height) {
    return (2 * this.distance * Math.tan((field * Math.PI) / 360)) / height;
  }
}
