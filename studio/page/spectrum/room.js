// The waves that a surface is made of, and the material that explains them.
import { get, post } from '../api.js';
import { followJobs, work } from '../jobs.js';
import { listSurfaces } from '../listing.js';
import { attempt, make, part, saveAs, say } from '../parts.js';
import { Plot } from './plots.js';
import { Sky } from './sky.js';

/** @param {number} value @returns {string} */
const percent = (value) => `${(100 * value).toPrecision(2)} %`;
const degrees = (/** @type {number} */ angle) => (angle * 180) / Math.PI;

/**
 * The rows of a table: a line for what owns the parameters, then a row for each.
 * @param {{name: string, number: string, unit: string, meaning: string}[]} parameters
 */
function rowsOf(parameters) {
  let group = '';
  return parameters.flatMap(({ name, number, unit, meaning }) => {
    const [, owner, index, field] = name.match(/^(\w+)\[(\d+)\]\.(.*)$/) ?? [];
    const fresh = owner && group !== `${owner} ${index}`;
    group = owner ? `${owner} ${index}` : '';
    const row = make('tr', { title: `${meaning}${unit && `, ${unit}`}` }, make('th', { scope: 'row' }, field ?? name), make('td', {}, number));
    const head = () => make('tr', { class: 'group' }, make('th', { colspan: '2' }, `${owner.replace(/s$/, '')} ${Number(index) + 1}`));
    return fresh ? [head(), row] : [row];
  });
}

class SpectrumRoom {
  constructor() {
    this.sky = new Sky(part('spectrum-view'), (f, a) => this.chooseAt(f, a), (line) => (part('spectrum-under').textContent = line));
    this.ringPlot = new Plot(part('spectrum-rings'), { log: true }, (i) => this.choose(i, this.sector));
    this.sectorPlot = new Plot(part('spectrum-sectors'), { log: false }, (i) => this.choose(this.ring, i));
    this.name = '';
    /** @type {any} */
    this.measure = null;
    /** @type {any} */
    this.model = null;
    /** @type {any} the file of the material */
    this.file = null;
    /** @type {number | null} */
    this.ring = null;
    /** @type {number | null} */
    this.sector = null;
    this.pictures = { measured: '', expected: '' };
    this.wire();
  }

  wire() {
    part('spectrum-again').addEventListener('click', () => attempt(() => this.list()));
    part('spectrum-fit').addEventListener('click', () => attempt(() => this.fit()));
    part('spectrum-forget').addEventListener('click', () => this.explain(null, null));
    part('spectrum-save').addEventListener('click', () => saveAs([JSON.stringify(this.file, null, 1)], `${this.file.material}.json`));
    part('spectrum-open').addEventListener('change', () => attempt(async () => {
      const [file] = part('spectrum-open').files;
      if (!file) return;
      part('spectrum-open').value = '';
      await this.explainBy(JSON.parse(await file.text()));
    }));
    for (const radio of document.querySelectorAll('input[name=spectrum-picture]')) radio.addEventListener('change', () => this.picture());
    part('spectrum-view').addEventListener('keydown', (/** @type {KeyboardEvent} */ event) => {
      const step = { ArrowUp: [1, 0], ArrowDown: [-1, 0], ArrowLeft: [0, 1], ArrowRight: [0, -1] }[event.key];
      if (!step || !this.measure) return;
      event.preventDefault();
      const { rings, sectors } = this.measure;
      const ring = Math.min(rings.power.length - 1, Math.max(0, (this.ring ?? 0) + step[0]));
      const many = sectors.power.length;
      this.choose(ring, ((this.sector ?? 0) + step[1] + many) % many);
    });
    followJobs((job) => {
      part('spectrum-fit').disabled = job.state === 'running';
      if (job.what.startsWith('fit ')) part('spectrum-progress').textContent = job.state === 'running' ? job.lines.at(-1) ?? 'beginning' : '';
    });
  }

  async list() {
    await listSurfaces('spectrum', (name) => this.open(name), this.name);
  }

  /** @param {string} name */
  async open(name) {
    part('spectrum-facts').textContent = `measuring ${name}`;
    const told = await post('spectrum/measure', { name });
    this.name = name;
    this.measure = told.measure;
    this.pictures.measured = told.picture;
    this.reach = told.highest_frequency;
    const { unit, quantity, size_px: size, pitch } = this.measure;
    part('spectrum-facts').textContent = `${quantity} of ${size[0]} x ${size[1]} pixels of ${Number(pitch.toPrecision(4))} ${unit}; `
      + `brightness is the logarithm of the power, ${told.log_power.map((/** @type {number} */ p) => `1e${Math.round(p)}`).join(' to ')} ${unit}\u2074`;
    const { peaks } = this.measure;
    this.sky.show(told.picture, told.highest_frequency, unit);
    this.sky.peaks(peaks.rings.map((/** @type {any} */ p) => p.frequency), peaks.sectors.map((/** @type {any} */ p) => p.angle_rad));
    part('spectrum-work').disabled = false;
    this.explain(null, null);
    this.choose(this.strongest('rings'), this.strongest('sectors'));
    part('room-spectrum').dataset.shown = name;
    say('');
  }

  /** @param {'rings' | 'sectors'} which @returns {number} */
  strongest(which) {
    const { power } = this.measure[which];
    return power.indexOf(Math.max(...power));
  }

  async fit() {
    const material = part('spectrum-material').value;
    part('room-spectrum').dataset.fitted = '';
    try {
      await work('fit', { material, input: this.name });
    } finally {
      part('spectrum-progress').textContent = '';
    }
    await this.explainBy(await get('job/fit'));
    part('room-spectrum').dataset.fitted = material;
    say('');
  }

  /** @param {any} file of a material */
  async explainBy(file) {
    this.explain(await post('spectrum/model', { name: this.name, file }), file);
  }

  /** @param {any} model what the server says of it, or null @param {any} file */
  explain(model, file) {
    this.model = model;
    this.file = file;
    this.pictures.expected = model?.picture ?? '';
    part('spectrum-model').hidden = !model;
    part('spectrum-pictures').disabled = !this.pictures.expected;
    if (!this.pictures.expected) part('spectrum-measured').checked = true;
    this.sky.components(model?.ellipses ?? []);
    if (model) {
      part('spectrum-told').textContent = model.told[0];
      part('spectrum-parameters').replaceChildren(...rowsOf(model.parameters));
      part('spectrum-remarks').replaceChildren(...model.remarks.map((/** @type {string} */ remark) => make('li', {}, remark)));
    }
    this.picture();
    this.plots();
  }

  picture() {
    const expected = part('spectrum-expected').checked;
    const { unit } = this.measure;
    this.sky.show(expected ? this.pictures.expected : this.pictures.measured, this.reach, unit);
  }

  plots() {
    const { rings, sectors, unit } = this.measure;
    const density = `density, ${unit}\u2074`;
    this.ringPlot.show(rings.frequency, rings.density, rings.sigma, this.model?.rings ?? null, { x: `frequency, cycles/${unit}`, y: density });
    this.sectorPlot.show(sectors.angle_rad.map(degrees), sectors.density, sectors.sigma, this.model?.sectors ?? null, { x: 'direction of variation, degrees', y: density });
  }

  /** The ring and the sector through a place. @param {number} frequency @param {number} angle */
  chooseAt(frequency, angle) {
    if (!this.measure) return;
    const { rings, sectors } = this.measure;
    const ring = Math.floor(frequency / (2 * rings.frequency[0]));
    const sector = Math.floor((((angle % Math.PI) + Math.PI) % Math.PI) / (2 * sectors.angle_rad[0]));
    if (ring < rings.power.length) this.choose(ring, Math.min(sector, sectors.power.length - 1));
  }

  /** @param {number | null} ring @param {number | null} sector */
  choose(ring, sector) {
    Object.assign(this, { ring, sector });
    this.ringPlot.point(ring);
    this.sectorPlot.point(sector);
    const { rings, sectors, unit } = this.measure;
    const half = [rings.frequency[0], sectors.angle_rad[0]];
    /** @param {number[]} middles @param {number | null} i @param {number} wide */
    const band = (middles, i, wide) => (i === null ? null : { from: middles[i] - wide, to: middles[i] + wide });
    const [around, along] = [band(rings.frequency, ring, half[0]), band(sectors.angle_rad, sector, half[1])];
    this.sky.chosen(around, along);
    /** @param {any} all @param {number} i */
    const share = (all, i) => `${percent(all.power[i] / all.power.reduce((/** @type {number} */ a, /** @type {number} */ b) => a + b, 0))} of the variance, density `
      + `${all.density[i].toPrecision(3)} ± ${all.sigma[i].toPrecision(2)} ${unit}\u2074`;
    const lines = [];
    if (around && ring !== null) {
      const shortest = (1 / around.to).toPrecision(3);
      const waves = around.from > 1e-12 ? `waves of ${shortest} to ${(1 / around.from).toPrecision(3)} ${unit}` : `waves longer than ${shortest} ${unit}`;
      lines.push(`Ring ${Number(around.from.toPrecision(2))} to ${around.to.toPrecision(2)} cycles/${unit}, ${waves}: ${share(rings, ring)}.`);
    }
    if (along && sector !== null) lines.push(`Sector ${degrees(along.from).toFixed(0)}° to ${degrees(along.to).toFixed(0)}°: ${share(sectors, sector)}.`);
    part('spectrum-chosen').replaceChildren(...lines.map((line) => make('p', {}, line)));
  }
}

export async function openSpectrum() {
  const room = new SpectrumRoom();
  const { materials } = await get('material/tables');
  part('spectrum-material').replaceChildren(...materials.map((/** @type {{name: string}} */ { name }) => make('option', { value: name }, name)));
  await room.list();
}
