// A blade of forged steel under lamps, on black ground: metallic, roughness 0.03, as in the paper's figure 2.
import * as THREE from '../vendor/three.module.js';
import { bytes, get } from '../api.js';
import { Maps } from '../surface/maps.js';
import { colourTexture, geometryOf, normalTexture } from './stage.js';

/** What the steel mirrors: a wide sky that fades to the ground, and lamps. */
const sky = { vertexShader: 'varying vec3 way; void main() { way = position; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
  fragmentShader: `varying vec3 way;
    void main() {
      vec3 w = normalize(way);
      float lamp = smoothstep(0.04, 0.0, abs(w.y - 0.42 - 0.1 * w.x)) * smoothstep(-0.2, 0.3, w.z);
      float side = smoothstep(0.10, 0.0, abs(w.x - 0.75)) * smoothstep(-0.5, 0.5, w.y);
      gl_FragColor = vec4(vec3(0.10 + 0.9 * smoothstep(-0.7, 0.5, w.y + 0.25 * w.x) + 5.0 * lamp + 3.0 * side) * vec3(0.97, 1.0, 1.06), 1.0);
    }` };

function room() {
  const scene = new THREE.Scene();
  scene.add(new THREE.Mesh(new THREE.SphereGeometry(10, 48, 32), new THREE.ShaderMaterial({ ...sky, side: THREE.BackSide })));
  return scene;
}

export class Blade {
  /** @param {import('./stage.js').Stage} stage */
  constructor(stage) {
    this.stage = stage;
    this.hamon = 0; // how high the edge is hardened, a share of the blade
    this.exaggeration = 10; // of the slopes of the grain: etching is microns deep
    /** @type {THREE.Mesh | null} */
    this.mesh = null;
    this.material = new THREE.MeshStandardMaterial({ metalness: 1, roughness: 0.03 });
  }

  async enter() {
    const { stage } = this;
    stage.clear(0x000000);
    const mesh = this.mesh ?? new THREE.Mesh(geometryOf(await get('solid/blade')), this.material);
    if (!this.mesh) {
      const box = new THREE.Box3().setFromObject(mesh);
      const scale = 1.7 / box.getSize(new THREE.Vector3()).x;
      mesh.scale.setScalar(scale);
      mesh.position.copy(box.getCenter(new THREE.Vector3()).multiplyScalar(-scale));
      this.mesh = mesh;
    }
    const maker = new THREE.PMREMGenerator(stage.renderer);
    stage.scene.environment = maker.fromScene(room(), 0.01).texture;
    maker.dispose();
    stage.scene.add(mesh);
    stage.eye.overlook(0.55, 0, 0.29);
    stage.eye.orbit(0.2, 0.3);
    stage.eye.turnAbout([0.55, 0, 0], [0, 0, 1], -0.5);
  }

  /** @param {any} wanted what the sliders say */
  async show({ file, seed }) {
    const maps = new Maps(await bytes('solid/steel', { file, seed, hamon: this.hamon }));
    const { material } = this;
    material.map?.dispose();
    material.normalMap?.dispose();
    material.map = colourTexture(maps);
    material.normalMap = normalTexture(maps, this.exaggeration);
    material.needsUpdate = true;
    this.stage.draw();
  }
}
