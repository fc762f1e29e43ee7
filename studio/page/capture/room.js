// The photographs of the folder, the spheres and lights in them, and the work on them.
import { get } from '../api.js';
import { followJobs, work } from '../jobs.js';
import { mark } from '../listing.js';
import { attempt, drawn, make, part, say } from '../parts.js';

/** @typedef {{name: string, pictures: string[]}} Capture */

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
    mark(part('capture-list'), button);
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

  followJobs((job) => {
    if (job.what.startsWith('fit ')) return;
    part('capture-state').textContent = job.job ? `${job.what}: ${job.state}` : '';
    part('capture-lines').textContent = job.lines.join('\n');
    part('capture-lines').scrollTop = part('capture-lines').scrollHeight;
  });
  part('capture-calibrate').addEventListener('click', () => attempt(async () => {
    await work('calibrate', { capture: capture?.name ?? '' });
    showLights(await get('job/lights'));
  }));
  part('capture-reconstruct').addEventListener('click', () => attempt(async () => {
    await work('reconstruct', { capture: capture?.name ?? '', out: part('capture-out').value });
    say(`${part('capture-out').value} is among the surfaces now.`);
    part('surface-again').click();
  }));

  /** @type {{captures: Capture[]}} */
  const { captures } = await get('capture/list');
  part('capture-list').replaceChildren(...captures.map((found) => {
    const button = make('button', { type: 'button', class: 'step' }, found.name || 'this folder', make('small', {}, ` ${found.pictures.length} pictures`));
    button.addEventListener('click', () => open(found, button));
    return make('li', {}, button);
  }));
  part('capture-none').hidden = captures.length > 0;
  part('capture-list').querySelector('button')?.click();
}
