// Every material with its parameters as sliders, and what it looks like at once.
import { bytes, get, newestOf, post } from '../api.js';
import { attempt, make, part, saveAs, say } from '../parts.js';
import { Maps } from '../surface/maps.js';
import { SurfaceView } from '../surface/view.js';
import { controls } from './sliders.js';
import { Solids } from './solids.js';

/** Which size of a pixel shows what a material is about, mm. @type {Record<string, number>} */
const pitches = { wrinkle: 0.1, wood: 0.15, forged: 0.05, knit: 0.05 };

export async function openMaterials() {
  /** @type {{materials: import('./sliders.js').Table[]}} */
  const { materials: tables } = await get('material/tables');
  const view = new SurfaceView(part('material-view'), (line) => (part('material-under').textContent = line));
  const names = part('material-name');
  names.replaceChildren(...tables.map((table) => make('option', { value: table.name }, table.name)));
  let table = tables[0];
  /** @type {any} */
  let parameters = {};
  let unit = 'mm';
  /** Of a sheet that is painted, fitted to a picture. @type {number[] | undefined} */
  let colour;

  const wanted = () => ({
    file: { hada: 'material/1', material: table.name, parameters, unit, mean_albedo: colour },
    size_px: Number(part('material-size').value),
    pitch: Number(part('material-pitch').value),
    seed: Number(part('material-seed').value),
  });
  const previews = newestOf(() => attempt(async () => {
    const start = performance.now();
    if (solids.body) {
      await solids.body.show(wanted());
      part('material-facts').textContent = '';
      part('room-material').dataset.solid = String(Number(part('room-material').dataset.solid ?? 0) + 1);
      return say('');
    }
    const maps = new Maps(await bytes('material/preview', wanted()));
    view.show(maps);
    say('');
    part('material-facts').textContent =
      `${maps.cols} x ${maps.rows} pixels in ${Math.round(performance.now() - start)} ms`;
    part('room-material').dataset.made = String(Number(part('room-material').dataset.made ?? 0) + 1);
  }));
  const make_ = () => {
    part('material-facts').textContent = 'making it';
    previews.give(undefined);
  };

  const solids = new Solids(make_);

  /** @param {any} values */
  const choose = (values) => {
    parameters = structuredClone(values);
    part('material-summary').textContent = table.summary;
    part('material-fields').replaceChildren(controls(table, parameters, make_));
    make_();
  };
  names.addEventListener('change', () => {
    table = tables.find((t) => t.name === names.value) ?? tables[0];
    unit = 'mm';
    colour = undefined;
    part('material-pitch').value = String(pitches[table.name] ?? 0.1);
    solids.offer(table.name);
    choose(table.defaults);
  });
  for (const id of ['material-size', 'material-pitch', 'material-seed']) part(id).addEventListener('change', make_);
  part('material-look').addEventListener('change', () => view.look.set({ mode: Number(part('material-look').value) }));
  for (const name of /** @type {const} */ (['exaggeration', 'gloss', 'roughness'])) {
    const slider = part(`material-${name}`);
    slider.addEventListener('input', () => view.look.set({ [name]: Number(slider.value) }));
  }
  part('material-defaults').addEventListener('click', () => choose(table.defaults));
  part('material-open').addEventListener('change', () => attempt(async () => {
    const [file] = part('material-open').files;
    if (!file) return;
    const read = JSON.parse(await file.text());
    const found = tables.find((t) => t.name === read.material);
    if (!found) throw new Error(`${file.name}: is no material file that hada knows`);
    table = found;
    names.value = found.name;
    unit = read.unit ?? 'mm';
    colour = read.mean_albedo;
    solids.offer(table.name);
    if (read.input?.pitch) part('material-pitch').value = String(read.input.pitch);
    choose(read.parameters);
    part('material-open').value = '';
  }));

  part('material-save').addEventListener('click', () => attempt(async () => {
    const { text } = await post('material/file', { file: wanted().file });
    saveAs([text], `${table.name}.json`);
  }));
  for (const map of ['height', 'normal', 'albedo']) {
    part(`material-${map}`).addEventListener('click', () => attempt(async () => {
      saveAs([await bytes('material/map', { ...wanted(), map })], `${table.name}_${map}.exr`);
    }));
  }
  solids.offer(table.name);
  choose(table.defaults);
}
