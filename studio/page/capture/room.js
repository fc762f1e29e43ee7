// The photographs of the folder, the spheres and lights in them, and the work on them.
import { get, post } from '../api.js';
import { attempt, make, part } from '../parts.js';

/**
 * @typedef {{job: number, what: string, state: string, lines: string[]}} Job
 * @typedef {{name: string, pictures: string[]}} Capture
 */

const svg = 'http://www.w3.org/2000/svg';

/** @param {string} tag @param {Record<string, string | number>} attributes */
function drawn(tag, attributes) {
  const element = document.createElementNS(svg, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

/**
 * The lights on a hemisphere seen from above: the middle is straight overhead, the rim is level.
 * @param {any} lights of a file of kind lights/1
 */
function hemisphere(lights) {
  const box = drawn('svg', { viewBox: '-1.15 -1.15 2.3 2.3', class: 'hemisphere', role: 'img', 'aria-label': 'directions of the lights, seen from above' });
  for (const slant of [30, 60, 90]) box.append(drawn('circle', { r: Math.sin((slant * Math.PI) / 180), class: 'ring' }));
  for (const [i, light] of (lights.lights ?? []).entries()) {
    const way = light.direction;
    if (!way) continue;
    box.append(drawn('circle', { cx: way[0], cy: -way[1], r: 0.045, class: 'light' }));
    const label = drawn('text', { x: way[0] + 0.06, y: -way[1] - 0.05, class: 'name' });
    label.textContent = String(i + 1);
    box.append(label);
  }
  return box;
}

export async function openCaptures() {
  /** @type {Capture | null} */
  let capture = null;
  let finished = () => {};

  /** @param {any} lights */
  const showLights = (lights) => {
    part('capture-lights').replaceChildren(hemisphere(lights));
    // The spheres over every picture, in its own pixels.
    for (const figure of /** @type {NodeListOf<HTMLElement>} */ (part('capture-pictures').querySelectorAll('figure'))) {
      figure.querySelector('svg')?.remove();
      const [cols, rows] = [Number(figure.dataset.cols), Number(figure.dataset.rows)];
      if (!cols || !lights.spheres) continue;
      const over = drawn('svg', { viewBox: `0 0 ${cols} ${rows}`, class: 'over' });
      for (const sphere of lights.spheres) {
        const [x, y] = sphere.center_px ?? sphere.centre_px ?? [0, 0];
        over.append(drawn('circle', { cx: x, cy: y, r: sphere.radius_px ?? 0, class: 'sphere', 'stroke-width': cols / 120 }));
      }
      figure.append(over);
    }
  };

  /** @param {Capture} chosen @param {HTMLElement} button */
  const open = (chosen, button) => {
    capture = chosen;
    for (const other of part('capture-list').querySelectorAll('[aria-current]')) other.removeAttribute('aria-current');
    button.setAttribute('aria-current', 'true');
    part('capture-lights').replaceChildren();
    const figures = chosen.pictures.map((picture) => {
      const image = make('img', { alt: picture, loading: 'lazy' });
      const figure = make('figure', {}, image, make('figcaption', {}, picture));
      const path = chosen.name ? `${chosen.name}/${picture}` : picture;
      attempt(async () => {
        const response = await fetch(`api/capture/picture?name=${encodeURIComponent(path)}`);
        if (!response.ok) throw new Error((await response.json()).error);
        figure.dataset.rows = response.headers.get('X-Rows') ?? '';
        figure.dataset.cols = response.headers.get('X-Cols') ?? '';
        image.src = URL.createObjectURL(await response.blob());
        image.onload = () => URL.revokeObjectURL(image.src);
      });
      return figure;
    });
    part('capture-pictures').replaceChildren(...figures);
    part('capture-work').disabled = false;
    part('capture-out').value = `${(chosen.name || 'sheet').split('/').pop()}_surface`;
  };

  /** @param {Job} job */
  const follow = (job) => {
    const running = job.state === 'running';
    part('capture-cancel').disabled = !running;
    part('capture-state').textContent = job.job ? `${job.what}: ${job.state}` : '';
    part('capture-lines').textContent = job.lines.join('\n');
    part('capture-lines').scrollTop = part('capture-lines').scrollHeight;
    part('room-capture').dataset.state = job.state;
    if (running) return;
    if (job.state === 'done') finished();
    finished = () => {};
  };
  const events = new EventSource('api/job/events');
  events.addEventListener('message', (event) => follow(JSON.parse(event.data)));

  part('capture-calibrate').addEventListener('click', () => attempt(async () => {
    follow(await post('job/calibrate', { capture: capture?.name ?? '' }));
    finished = () => attempt(async () => showLights(await get('capture/lights')));
  }));
  part('capture-reconstruct').addEventListener('click', () => attempt(async () => {
    follow(await post('job/reconstruct', { capture: capture?.name ?? '', out: part('capture-out').value }));
    finished = () => part('surface-again').click();
  }));
  part('capture-cancel').addEventListener('click', () => attempt(async () => follow(await post('job/cancel'))));

  /** @type {{captures: Capture[]}} */
  const { captures } = await get('capture/list');
  part('capture-list').replaceChildren(...captures.map((found) => {
    const button = make('button', { type: 'button', class: 'step' }, found.name || 'this folder', make('small', {}, ` ${found.pictures.length} pictures`));
    button.addEventListener('click', () => open(found, button));
    return make('li', {}, button);
  }));
  part('capture-none').hidden = captures.length > 0;
}
