// The surfaces and pictures of the folder as a list to choose from.
import { get } from './api.js';
import { attempt, make, part, say } from './parts.js';

/** Marks one of a list as the one that is shown. @param {HTMLElement} list @param {HTMLElement} button */
export function mark(list, button) {
  for (const other of list.querySelectorAll('[aria-current]')) other.removeAttribute('aria-current');
  button.setAttribute('aria-current', 'true');
}

/**
 * Fills the list of a room and opens the first entry.
 * @param {string} room its parts are `<room>-list` and `<room>-none`
 * @param {(name: string) => Promise<void>} open
 * @param {string} [wanted] which entry to open instead of the first
 */
export async function listSurfaces(room, open, wanted) {
  /** @type {{entries: {name: string, kind: string}[], all: boolean}} */
  const { entries, all } = await get('surface/list');
  const list = part(`${room}-list`);
  const buttons = entries.map(({ name, kind }) => {
    const button = make('button', { type: 'button', class: 'step' }, name, make('small', {}, kind === 'surface' ? ' surface' : ''));
    button.addEventListener('click', () => attempt(async () => {
      await open(name);
      mark(list, button);
    }));
    return button;
  });
  list.replaceChildren(...buttons.map((button) => make('li', {}, button)));
  part(`${room}-none`).hidden = buttons.length > 0;
  if (!all) say('The folder holds more; only the first are listed.');
  const surface = entries.findIndex(({ kind }) => kind === 'surface');
  const chosen = entries.findIndex(({ name }) => name === wanted);
  buttons[chosen >= 0 ? chosen : Math.max(0, surface)]?.click();
}
