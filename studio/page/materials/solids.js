// What a material looks like in space: steel as a blade, wood as a block, a knit on a leg.
import { attempt, make, part } from '../parts.js';
import { Blade } from './blade.js';
import { Block } from './block.js';
import { Stage } from './stage.js';
import { Worn } from './worn.js';

/** Which things are made of a material, beside a flat surface. @type {Record<string, string>} */
const bodies = { forged: 'a blade', wood: 'a block with a cut', knit: 'worn on a leg' };

export class Solids {
  /** @param {() => void} again something has changed that the server must be asked about */
  constructor(again) {
    this.again = again;
    /** @type {Blade | Block | Worn | null} */
    this.body = null;
    part('material-body').addEventListener('change', () => attempt(() => this.enter()));
  }

  /** The stage is set up when it is first needed. */
  prepared() {
    if (this.stage) return this.stage;
    this.stage = new Stage(part('material-solid'));
    const scale = part('material-scale');
    this.blade = new Blade(this.stage);
    this.block = new Block(this.stage, () => {
      part('block-depth').value = String(/** @type {Block} */ (this.block).depth);
      this.again();
    });
    this.worn = new Worn(this.stage, (low, high) => {
      scale.hidden = false;
      for (const [k, text] of [low, high].entries()) scale.querySelectorAll('span')[k].textContent = text;
    });
    part('blade-hamon').addEventListener('input', () => {
      /** @type {Blade} */ (this.blade).hamon = Number(part('blade-hamon').value);
      this.again();
    });
    part('material-exaggeration').addEventListener('input', () => {
      /** @type {Blade} */ (this.blade).exaggeration = Number(part('material-exaggeration').value);
      if (this.body === this.blade) this.again();
    });
    for (const name of /** @type {const} */ (['tilt', 'turn', 'depth'])) {
      part(`block-${name}`).addEventListener('input', () => {
        /** @type {Block} */ (this.block)[name] = Number(part(`block-${name}`).value);
        this.again();
      });
    }
    return this.stage;
  }

  /** @param {string} name of the material that is chosen */
  offer(name) {
    const select = part('material-body');
    select.replaceChildren(make('option', { value: '' }, 'a surface'), ...(bodies[name] ? [make('option', { value: name }, bodies[name])] : []));
    select.disabled = !bodies[name];
    this.body = null;
    this.reveal('');
  }

  /** @param {string} name of the material whose body is seen; none: the flat surface */
  reveal(name) {
    part('material-solid').hidden = name === '';
    part('material-view').hidden = name !== '';
    part('blade-tools').hidden = name !== 'forged';
    part('block-tools').hidden = name !== 'wood';
    part('material-flat').disabled = name !== '' && name !== 'forged';
    for (const what of ['look', 'gloss', 'roughness']) part(`material-${what}`).disabled = name !== ''; // a blade has slopes alone
    if (name !== 'knit') part('material-scale').hidden = true;
  }

  async enter() {
    const name = part('material-body').value;
    this.reveal(name);
    const stage = name ? this.prepared() : null;
    const all = { forged: this.blade, wood: this.block, knit: this.worn };
    this.body = all[/** @type {keyof typeof all} */ (name)] ?? null;
    if (this.blade && this.body === this.blade) part('material-exaggeration').value = String(this.blade.exaggeration);
    await this.body?.enter();
    stage?.resize();
    this.again();
  }
}
