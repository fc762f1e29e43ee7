// The field table of a material as controls: no name, bound or unit is written here.
import { make } from '../parts.js';

/**
 * @typedef {{name: string, low: number, high: number, scale: string, unit: string, meaning: string}} Field
 * @typedef {{name: string, fewest: number, most: number, fields: Field[], part?: any}} List
 * @typedef {{name: string, rule: string, meaning: string}} Word
 * @typedef {{name: string, summary: string, fields: Field[], lists: List[], words: Word[], defaults: any}} Table
 */

const steps = 1000; // of a slider
const decades = 5; // of a log slider without a near lower bound

let numbered = 0; // for ids

/** A name that may go on in the next line after an underscore. @param {string} name */
const broken = (name) => name.split(/(?<=_)/).flatMap((piece, i) => (i > 0 ? [make('wbr'), piece] : [piece]));

/**
 * A value between bounds: a slider about it and the number itself. Where the bounds lie far from what is
 * usual the slider spans the neighbourhood of the value; the number may go to the bounds.
 * @param {Field} field @param {number} value @param {(value: number) => void} changed
 */
function slider(field, value, changed) {
  const logarithmic = field.scale === 'log' && value > 0;
  let [low, high] = [field.low, field.high];
  if (logarithmic) {
    low = Math.max(low, value * 10 ** (-decades / 2));
    high = Math.min(high, value * 10 ** (decades / 2));
  } else if (high - low > 400 * Math.max(Math.abs(value), 1e-3)) {
    const reach = 10 * Math.max(Math.abs(value), 1);
    [low, high] = [Math.max(low, value - reach), Math.min(high, value + reach)];
  }
  const toShare = (/** @type {number} */ v) =>
    logarithmic ? Math.log(Math.max(v, low) / low) / Math.log(high / low) : (v - low) / (high - low);
  const toValue = (/** @type {number} */ share) => (logarithmic ? low * (high / low) ** share : low + share * (high - low));
  const id = `field-${(numbered += 1)}`;
  const range = make('input', { type: 'range', min: '0', max: String(steps), id, 'aria-label': `${field.name}, slider` });
  const number = make('input', { type: 'number', step: 'any', min: String(field.low), max: String(field.high),
    'aria-label': `${field.name}, ${field.unit || 'number'}`, 'data-field': field.name });
  const show = (/** @type {number} */ v) => {
    range.value = String(Math.round(steps * Math.min(1, Math.max(0, toShare(v)))));
    number.value = String(Number(v.toPrecision(5)));
  };
  show(value);
  range.addEventListener('input', () => {
    const chosen = Math.min(field.high, Math.max(field.low, toValue(Number(range.value) / steps)));
    number.value = String(Number(chosen.toPrecision(5)));
    changed(chosen);
  });
  number.addEventListener('change', () => {
    const chosen = Math.min(field.high, Math.max(field.low, Number(number.value)));
    show(chosen);
    changed(chosen);
  });
  const unit = field.unit ? ` ${field.unit}` : '';
  const title = `${field.meaning}. ${field.low} to ${field.high}${unit}`;
  return make('div', { class: 'field', title },
    make('label', { for: id }, make('span', {}, ...broken(field.name)), make('small', {}, unit)), number, range);
}

/**
 * All controls of a material. `parameters` is changed in place.
 * @param {Table} table @param {any} parameters @param {() => void} changed
 * @returns {HTMLElement}
 */
export function controls(table, parameters, changed) {
  const box = make('div', { class: 'fields' });
  const fill = () => {
    box.replaceChildren();
    for (const word of table.words) box.append(wordControl(word, parameters, changed));
    for (const list of table.lists) box.append(listControls(list, parameters, changed, fill));
    for (const field of table.fields) {
      box.append(slider(field, parameters[field.name] ?? 0, (value) => {
        parameters[field.name] = value;
        changed();
      }));
    }
  };
  fill();
  return box;
}

/** @param {Word} word @param {any} parameters @param {() => void} changed */
function wordControl(word, parameters, changed) {
  const id = `field-${(numbered += 1)}`;
  const input = make('input', { type: 'text', id, value: parameters[word.name], 'data-field': word.name });
  input.addEventListener('change', () => {
    parameters[word.name] = input.value.trim();
    changed();
  });
  return make('div', { class: 'field', title: `${word.meaning}; ${word.rule}` }, make('label', { for: id }, word.name), input);
}

/** @param {List} list @param {any} parameters @param {() => void} changed @param {() => void} refill */
function listControls(list, parameters, changed, refill) {
  const values = (parameters[list.name] ??= []); // a file leaves out what there is none of
  const numbers = list.fields.length === 1 && list.fields[0].name === list.name;
  const group = make('fieldset', { class: 'list' }, make('legend', {}, list.name));
  if (numbers && list.most > 3) {
    // Many numbers are written, not slid.
    const text = make('textarea', { rows: '2', 'aria-label': `${list.name}: ${list.fields[0].meaning}`, 'data-field': list.name });
    text.value = values.join(' ');
    text.addEventListener('change', () => {
      parameters[list.name] = text.value.split(/[\s,;]+/).filter(Boolean).map(Number);
      changed();
    });
    group.append(text);
    return group;
  }
  values.forEach((/** @type {any} */ value, /** @type {number} */ i) => {
    const part = make('div', { class: 'part' });
    for (const field of list.fields) {
      part.append(slider(field, numbers ? value : value[field.name], (chosen) => {
        if (numbers) values[i] = chosen;
        else value[field.name] = chosen;
        changed();
      }));
    }
    if (values.length > list.fewest) {
      const remove = make('button', { type: 'button', class: 'small' }, 'Take away');
      remove.addEventListener('click', () => {
        values.splice(i, 1);
        refill();
        changed();
      });
      part.append(remove);
    }
    group.append(part);
  });
  if (values.length < list.most && !numbers) {
    const add = make('button', { type: 'button', class: 'small' }, 'Add another');
    add.addEventListener('click', () => {
      const last = values[values.length - 1];
      values.push(structuredClone(last ?? list.part));
      refill();
      changed();
    });
    group.append(add);
  }
  return group;
}
