// A hand on the sheet: real pointer events at places of the sheet, a few pixels off as hands are.
import { expect, until } from './harness.mjs';

const field = (28 * Math.PI) / 180;
const distance = 3;

export class Hand {
  constructor(page) {
    this.page = page;
    this.behind = false;
    this.moved = 0;
    this.middle = [0.5, 0.5];
    this.chosen = new Map(); // what was chosen last, by name
  }

  /** Where the view lies in the window. */
  async box() {
    this.place ??= await this.page.locator('#fold-view').boundingBox();
    return this.place;
  }

  /** Looks from above or from behind, with this place in the middle of the view. */
  async look(behind) {
    await this.page.click('#fold-top');
    if (behind) await this.page.click('#fold-behind');
    this.behind = behind;
    this.middle = await this.page.evaluate(async () => {
      const { vertices } = await (await fetch('api/fold/state')).json();
      return [0, 1].map((k) => {
        const along = vertices.filter((_, i) => i % 3 === k);
        return (Math.min(...along) + Math.max(...along)) / 2;
      });
    });
  }

  state() {
    return this.page.evaluate(async () => (await fetch('api/fold/state')).json());
  }

  /** How many steps are done. */
  async done() {
    return Number(await this.page.getAttribute('#room-fold', 'data-at'));
  }

  async at([x, y]) {
    const box = await this.box();
    const scale = box.height / (2 * distance * Math.tan(field / 2));
    const side = this.behind ? -1 : 1;
    this.moved += 1; // never twice the same pixels off
    const off = [Math.cos(this.moved), Math.sin(2 * this.moved)];
    return [
      box.x + box.width / 2 + side * scale * (x - this.middle[0]) + off[0],
      box.y + box.height / 2 - scale * (y - this.middle[1]) + off[1],
    ];
  }

  /** Moves there and waits until the page has understood it. */
  async move(x, y) {
    const box = await this.box();
    await this.page.mouse.move(x, y);
    await until(this.page, '#fold-view', 'seen', `${Math.round(x - box.x)} ${Math.round(y - box.y)}`);
  }

  /** Draws from one place to the other. `inward`: pixels added to the start. */
  async stroke(from, to, inward = [0, 0]) {
    const [a, b] = [await this.at(from), await this.at(to)];
    await this.move(a[0] + inward[0], a[1] + inward[1]);
    await this.page.mouse.down();
    await this.move((a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    await this.move(...b);
    await this.page.mouse.up();
  }

  /** A stroke that becomes a step of the log. */
  async step(from, to, inward) {
    const at = await this.done();
    await this.stroke(from, to, inward);
    await this.reached(at + 1);
  }

  async reached(at) {
    await until(this.page, '#room-fold', 'at', at).catch(async () =>
      expect(false, `step ${at} is reached; the page says "${await this.page.textContent('#said')}"`));
  }

  /** Takes the sheet at a place and drags round the axis until it is turned by this angle. */
  async turn(place, degrees) {
    const at = await this.done();
    const from = await this.at(place);
    await this.move(...from);
    await this.page.mouse.down(); // moves wait until the axis is found, the view turned
    const angle = async () => parseFloat((await this.page.textContent('#fold-facts')).replace('turned by', ''));
    const tries = [];
    for (let radius = 30; radius <= 190; radius += 40) {
      for (let k = 0; k < 24; ++k) tries.push([from[0] + radius * Math.cos(k * 0.2618), from[1] + radius * Math.sin(k * 0.2618)]);
    }
    let best = { off: 1e9, place: from };
    const look = async (x, y) => {
      await this.move(Math.round(x), Math.round(y));
      const off = Math.abs((await angle()) - degrees);
      if (off < best.off) best = { off, place: [x, y] };
      return off;
    };
    for (const [x, y] of tries) if (best.off > 8) await look(x, y);
    for (let step = 16; step >= 1 && best.off > 0; step = step > 1 ? step / 2 : best.last === best.off ? 0 : 1) {
      best.last = best.off;
      const [x, y] = best.place;
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [-1, -1], [1, -1], [-1, 1]]) {
        if (best.off > 0) await look(x + step * dx, y + step * dy);
      }
    }
    await look(...best.place);
    expect(best.off === 0, `a turn of ${degrees} degrees can be reached by hand (${best.off} off)`);
    await this.page.mouse.up();
    await this.reached(at + 1);
  }

  /** Clicks on places of the flat sheet. `does`: face, M or V. */
  async pick(does, places) {
    if (places.length === 0) return;
    await this.choose('click', does);
    for (const [i, [x, y]] of places.entries()) {
      const map = await this.page.locator('#fold-flat').evaluate((view, place) => {
        const p = new DOMPoint(...place).matrixTransform(view.firstChild.getScreenCTM());
        return [p.x, p.y];
      }, [x, y]);
      await this.page.mouse.click(...map);
      const marked = does === 'face' ? 'polygon[aria-selected=true]' : `text.crease-${does}`;
      await this.page.waitForFunction(([what, n]) => document.querySelectorAll(`#fold-flat ${what}`).length === n,
        [marked, i + 1], { polling: 10, timeout: 10000 })
        .catch(() => expect(false, `a click on the flat sheet at ${x}, ${y} marks it`));
    }
  }

  async choose(name, value) {
    if (this.chosen.get(name) === value) return;
    await this.page.check(`input[name=fold-${name}][value=${value}]`);
    this.chosen.set(name, value);
  }

  async tick(name, wanted) {
    if ((this.chosen.get(name) ?? false) === wanted) return;
    await this.page.setChecked(`#fold-${name}`, wanted);
    this.chosen.set(name, wanted);
  }

  async parts(edges, corners) {
    for (const [name, count] of [['edge', edges], ['corner', corners]]) {
      if (this.chosen.get(name) !== count) await this.page.fill(`#fold-${name}-parts`, String(count));
      this.chosen.set(name, count);
    }
  }
}
