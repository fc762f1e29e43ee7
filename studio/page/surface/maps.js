// The maps of a surface as the server sends them (docs/studio.md).
import * as THREE from '../vendor/three.module.js';

const half = THREE.DataUtils.fromHalfFloat;

export class Maps {
  /** @param {ArrayBuffer} bytes */
  constructor(bytes) {
    const words = new Uint32Array(bytes, 0, 8);
    const numbers = new Float32Array(bytes, 0, 8);
    this.cols = words[1];
    this.rows = words[2];
    const flags = words[3];
    this.unit = flags & 8 ? 'mm' : 'px';
    this.pitch = numbers[4];
    this.low = numbers[5];
    this.high = numbers[6];
    this.white = numbers[7] || 0.8;
    const pixels = this.cols * this.rows;
    let place = 32;
    /** @param {boolean} there @param {number} size bytes of a pixel */
    const take = (there, size) => {
      const start = place;
      place += there ? size * pixels : 0;
      return start;
    };
    const [n, a, h] = [take((flags & 1) > 0, 8), take((flags & 2) > 0, 8), take((flags & 4) > 0, 4)];
    this.normals = flags & 1 ? new Uint16Array(bytes, n, 4 * pixels) : null;
    this.albedo = flags & 2 ? new Uint16Array(bytes, a, 4 * pixels) : null;
    this.height = flags & 4 ? new Float32Array(bytes, h, pixels) : null;
  }

  /** What is known of a pixel, as a line of text. @param {number} col @param {number} row */
  at(col, row) {
    if (col < 0 || row < 0 || col >= this.cols || row >= this.rows) return '';
    const i = row * this.cols + col;
    if (this.normals && half(this.normals[4 * i + 3]) === 0) return 'not measured here';
    const x = (col + 0.5 - this.cols / 2) * this.pitch;
    const y = (this.rows / 2 - row - 0.5) * this.pitch;
    const parts = [`x ${x.toPrecision(4)}, y ${y.toPrecision(4)} ${this.unit}`];
    if (this.height) parts.push(`height ${this.height[i].toPrecision(4)} ${this.unit}`);
    if (this.normals) {
      const [nx, ny, nz] = [0, 1, 2].map((k) => half(/** @type {Uint16Array} */ (this.normals)[4 * i + k]));
      parts.push(`slant ${((Math.acos(Math.min(1, nz)) * 180) / Math.PI).toFixed(1)}° towards ${((Math.atan2(ny, nx) * 180) / Math.PI).toFixed(0)}°`);
    }
    if (this.albedo) {
      const rgb = [0, 1, 2].map((k) => half(/** @type {Uint16Array} */ (this.albedo)[4 * i + k]).toFixed(3));
      parts.push(rgb[0] === rgb[1] && rgb[1] === rgb[2] ? `albedo ${rgb[0]}` : `albedo ${rgb.join(' ')}`);
    }
    return parts.join(',  ');
  }
}
