// How surfaces are looked at: views that share a look move together.
import * as THREE from '../vendor/three.module.js';
import { Eye } from '../fold/camera.js';

/** What a surface is shown as; the numbers are those of the shader. @type {Record<number, string>} */
export const modes = { 0: 'under the light', 1: 'normals', 2: 'height', 3: 'albedo', 4: 'sigma of the normals', 5: 'sigma of the height' };

export class Look {
  constructor() {
    this.light = new THREE.Vector3(-0.45, 0.5, 0.74).normalize();
    this.middle = new THREE.Vector2(); // of the view, from the upper left of the surface, pixels
    this.scale = 1; // pixels of the view for one of the surface
    this.mode = 0;
    this.exaggeration = 1;
    this.gloss = 0;
    this.roughness = 0.3;
    this.metal = false;
    this.space = false; // in three dimensions
    this.eye = new Eye();
    /** @type {Set<() => void>} */
    this.viewers = new Set();
  }

  /** @param {Partial<Pick<Look, 'mode' | 'exaggeration' | 'gloss' | 'roughness' | 'metal' | 'space'>>} values */
  set(values) {
    Object.assign(this, values);
    this.changed();
  }

  changed() {
    for (const draw of this.viewers) draw();
  }
}
