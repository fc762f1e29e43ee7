// The maps of a surface as the server sends them (docs/studio.md).
import * as THREE from '../vendor/three.module.js';

const half = THREE.DataUtils.fromHalfFloat;

export class Maps {
  /** @param {ArrayBuffer} bytes */
  constructor(bytes) {
    const words = new Uint32Array(bytes, 0, 10);
    const numbers = new Float32Array(bytes, 0, 10);
    this.cols = words[1];
    this.rows = words[2];
    const flags = words[3];
    this.unit = flags & 8 ? 'mm' : 'px';
    this.pitch = numbers[4];
    this.low = numbers[5];
    this.high = numbers[6];
    this.white = numbers[7] || 0.8;
    this.highNormalSigma = numbers[8];
    this.highHeightSigma = numbers[9];
    const pixels = this.cols * this.rows;
    let place = 40;
    /** @param {boolean} there @param {number} size bytes of a pixel */
    const take = (there, size) => {
      const start = place;
      place += there ? size * pixels : 0;
      return start;
    };
    /** @param {number} flag of four bytes for each pixel */
    const floats = (flag) => {
      const start = take((flags & flag) > 0, 4);
      return flags & flag ? new Float32Array(bytes, start, pixels) : null;
    };
    const [n, a] = [take((flags & 1) > 0, 8), take((flags & 2) > 0, 8)];
    this.normals = flags & 1 ? new Uint16Array(bytes, n, 4 * pixels) : null;
    this.albedo = flags & 2 ? new Uint16Array(bytes, a, 4 * pixels) : null;
    this.height = floats(4);
    this.normalSigma = floats(16);
    this.heightSigma = floats(32);
  }

  /** The index of a pixel; -1 where nothing is known. @param {number} col @param {number} row */
  index(col, row) {
    if (col < 0 || row < 0 || col >= this.cols || row >= this.rows) return -1;
    const i = row * this.cols + col;
    return this.normals && half(this.normals[4 * i + 3]) === 0 ? -1 : i;
  }

  /** The height of a pixel, or the mean of its albedo where there is no height. @param {number} col @param {number} row @returns {number | null} */
  value(col, row) {
    const i = this.index(col, row);
    if (i < 0) return null;
    if (this.height) return this.height[i];
    const { albedo } = this;
    return albedo ? [0, 1, 2].reduce((sum, k) => sum + half(albedo[4 * i + k]) / 3, 0) : null;
  }

  /** The sigma of the height of a pixel. @param {number} col @param {number} row @returns {number | null} */
  sigma(col, row) {
    const i = this.index(col, row);
    return i < 0 || !this.heightSigma ? null : this.heightSigma[i];
  }

  /** What the colours of a mode (look.js) go from and to. @param {number} mode @returns {[string, string] | null} */
  ends(mode) {
    if (mode === 2) return [this.low.toPrecision(3), `${this.high.toPrecision(3)} ${this.unit}`];
    if (mode === 4) return ['0', `${((this.highNormalSigma * 180) / Math.PI).toPrecision(2)}°`];
    return mode === 5 ? ['0', `${this.highHeightSigma.toPrecision(2)} ${this.unit}`] : null;
  }

  /** What is known of a pixel, as a line of text. @param {number} col @param {number} row */
  at(col, row) {
    if (col < 0 || row < 0 || col >= this.cols || row >= this.rows) return '';
    const i = this.index(col, row);
    if (i < 0) return 'not measured here';
    const x = (col + 0.5 - this.cols / 2) * this.pitch;
    const y = (this.rows / 2 - row - 0.5) * this.pitch;
    const parts = [`x ${x.toPrecision(4)}, y ${y.toPrecision(4)} ${this.unit}`];
    if (this.height) parts.push(`height ${this.height[i].toPrecision(4)}${this.heightSigma ? ` ± ${this.heightSigma[i].toPrecision(2)}` : ''} ${this.unit}`);
    if (this.normals) {
      const [nx, ny, nz] = [0, 1, 2].map((k) => half(/** @type {Uint16Array} */ (this.normals)[4 * i + k]));
      parts.push(`slant ${((Math.acos(Math.min(1, nz)) * 180) / Math.PI).toFixed(1)}° towards ${((Math.atan2(ny, nx) * 180) / Math.PI).toFixed(0)}°${this.normalSigma ? ` (± ${((this.normalSigma[i] * 180) / Math.PI).toFixed(2)}°)` : ''}`);
    }
    if (this.albedo) {
      const rgb = [0, 1, 2].map((k) => half(/** @type {Uint16Array} */ (this.albedo)[4 * i + k]).toFixed(3));
      parts.push(rgb[0] === rgb[1] && rgb[1] === rgb[2] ? `albedo ${rgb[0]}` : `albedo ${rgb.join(' ')}`);
    }
    return parts.join(',  ');
  }
}
