// One pointer out of many: mouse, pen, fingers, and a crosshair that keys move. It draws with the
// first button, and turns, slides and zooms the view with the others.

/**
 * @typedef {object} Handlers
 * @property {(x: number, y: number) => void} press
 * @property {(x: number, y: number) => void} move
 * @property {(x: number, y: number) => void} release
 * @property {() => void} cancel
 * @property {(right: number, up: number) => void} orbit radians
 * @property {(right: number, up: number) => void} slide shares of the view
 * @property {(factor: number) => void} zoom
 * @property {(at: [number, number] | null) => void} cross where the crosshair is
 */

/**
 * @param {HTMLElement} view
 * @param {Handlers} to
 */
export function listen(view, to) {
  /** @type {Map<number, PointerEvent>} */
  const down = new Map();
  let draws = -1; // the pointer that draws
  /** @type {[number, number] | null} */
  let cross = null;
  let pressed = false; // the crosshair

  const at = (/** @type {PointerEvent} */ event) => {
    const box = view.getBoundingClientRect();
    return /** @type {[number, number]} */ ([event.clientX - box.left, event.clientY - box.top]);
  };

  view.addEventListener('contextmenu', (event) => event.preventDefault());
  view.addEventListener('pointerdown', (event) => {
    if (event.target instanceof Element && event.target.closest('button, label')) return;
    view.focus({ preventScroll: true });
    if (cross) to.cross((cross = null));
    view.setPointerCapture(event.pointerId);
    down.set(event.pointerId, event);
    if (down.size > 1 && draws >= 0) {
      // A second finger: it was the view that was meant.
      draws = -1;
      to.cancel();
    } else if (event.button === 0 && !event.altKey) {
      draws = event.pointerId;
      to.press(...at(event));
    }
  });
  view.addEventListener('pointermove', (event) => {
    const before = down.get(event.pointerId);
    if (draws === event.pointerId || down.size === 0) return to.move(...at(event));
    if (!before) return;
    const [dx, dy] = [event.clientX - before.clientX, event.clientY - before.clientY];
    if (down.size === 2) {
      const other = /** @type {PointerEvent} */ ([...down.values()].find((p) => p.pointerId !== event.pointerId));
      const gap = (/** @type {PointerEvent} */ p) => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY);
      to.zoom(Math.max(1, gap(before)) / Math.max(1, gap(event)));
      to.orbit(dx * 0.004, -dy * 0.004);
    } else if (before.button === 1 || event.shiftKey) {
      to.slide(dx / view.clientHeight, -dy / view.clientHeight);
    } else {
      to.orbit(dx * 0.008, -dy * 0.008);
    }
    down.set(event.pointerId, Object.assign(event, {}));
  });
  const up = (/** @type {PointerEvent} */ event) => {
    down.delete(event.pointerId);
    if (draws !== event.pointerId) return;
    draws = -1;
    if (event.type === 'pointerup') to.release(...at(event));
    else to.cancel();
  };
  view.addEventListener('pointerup', up);
  view.addEventListener('pointercancel', up);
  view.addEventListener('wheel', (event) => {
    event.preventDefault();
    to.zoom(Math.exp(event.deltaY * 0.001));
  }, { passive: false });

  view.addEventListener('keydown', (event) => {
    const ways = /** @type {Record<string, [number, number]>} */ ({
      ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1],
    });
    const way = ways[event.key];
    if (way && event.altKey) to.orbit(way[0] * 0.1, -way[1] * 0.1);
    else if (way) {
      const step = event.shiftKey ? 20 : 2;
      cross ??= [view.clientWidth / 2, view.clientHeight / 2];
      cross = [
        Math.min(view.clientWidth, Math.max(0, cross[0] + step * way[0])),
        Math.min(view.clientHeight, Math.max(0, cross[1] + step * way[1])),
      ];
      to.cross(cross);
      to.move(...cross);
    } else if (event.key === 'Enter' && cross) {
      pressed = !pressed;
      if (pressed) to.press(...cross);
      else to.release(...cross);
    } else if (event.key === 'Escape') {
      pressed = false;
      draws = -1;
      to.cancel();
    } else if (event.key === '+' || event.key === '-') to.zoom(event.key === '+' ? 0.9 : 1.1);
    else return;
    event.preventDefault();
  });
}
