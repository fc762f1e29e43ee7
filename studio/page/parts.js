// Small parts of which the rooms are made.

/**
 * @param {string} id
 * @returns {any} the element with this id
 */
export function part(id) {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no part ${id}`);
  return element;
}

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, string>} attributes
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/**
 * An element of a drawing (SVG).
 * @param {string} tag @param {Record<string, string | number>} attributes
 * @param {(Node | string)[]} children
 */
export function drawn(tag, attributes = {}, ...children) {
  const element = /** @type {SVGGraphicsElement} */ (document.createElementNS('http://www.w3.org/2000/svg', tag));
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/** Lets the browser save something. @param {BlobPart[]} pieces @param {string} name */
export function saveAs(pieces, name) {
  const link = make('a', { href: URL.createObjectURL(new Blob(pieces)), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** @param {string} sentence shown to everyone, read aloud to those who cannot see it */
export function say(sentence) {
  part('said').textContent = sentence;
  part('said').dataset.kind = 'word';
}

/** @param {unknown} error */
export function complain(error) {
  part('said').textContent = error instanceof Error ? error.message : String(error);
  part('said').dataset.kind = 'error';
}

/**
 * Runs what a control asks for; what goes wrong is said in the line at the bottom.
 * @param {() => Promise<void> | void} work
 */
export async function attempt(work) {
  try {
    await work();
  } catch (error) {
    complain(error);
  }
}
