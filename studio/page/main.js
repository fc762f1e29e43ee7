import { openFold } from './fold/room.js';
import { attempt, part } from './parts.js';

// A room is begun when it is first seen, and fetched then, but for the first one.
/** @type {Record<string, () => Promise<void>>} */
const rooms = {
  fold: openFold,
  material: async () => (await import('./materials/room.js')).openMaterials(),
  capture: async () => (await import('./capture/room.js')).openCaptures(),
  surface: async () => (await import('./surface/room.js')).openSurfaces(),
  spectrum: async () => (await import('./spectrum/room.js')).openSpectrum(),
};
const begun = new Set();

/** @param {string} name */
function show(name) {
  for (const tab of document.querySelectorAll('[role=tab]')) {
    const chosen = tab.id === `tab-${name}`;
    tab.setAttribute('aria-selected', String(chosen));
    tab.setAttribute('tabindex', chosen ? '0' : '-1');
    part(`room-${tab.id.slice(4)}`).hidden = !chosen;
  }
  window.dispatchEvent(new Event('resize'));
  if (begun.has(name)) return;
  begun.add(name);
  attempt(rooms[name]);
}

const tabs = /** @type {HTMLElement[]} */ ([...document.querySelectorAll('[role=tab]')]);
for (const [i, tab] of tabs.entries()) {
  tab.addEventListener('click', () => show(tab.id.slice(4)));
  tab.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const next = tabs[(i + step + tabs.length) % tabs.length];
    next.focus();
    show(next.id.slice(4));
  });
}
show(tabs[0].id.slice(4));
