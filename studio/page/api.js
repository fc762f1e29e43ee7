// The door to the server. Everything is asked for beneath the address of this page, which holds the
// token.

/**
 * @param {Response} response
 * @returns {Promise<any>}
 */
async function answer(response) {
  const said = await response.json();
  if (!response.ok) throw new Error(said.error);
  return said;
}

/**
 * @param {string} what such as "fold/state"
 * @returns {Promise<any>}
 */
export async function get(what) {
  return answer(await fetch(`api/${what}`));
}

/**
 * @param {string} what
 * @param {object} body
 * @returns {Promise<any>}
 */
export async function post(what, body = {}) {
  const headers = { 'Content-Type': 'application/json' };
  return answer(await fetch(`api/${what}`, { method: 'POST', headers, body: JSON.stringify(body) }));
}

/**
 * The same for an answer that is no JSON.
 * @param {string} what
 * @param {object} body
 * @returns {Promise<ArrayBuffer>}
 */
export async function bytes(what, body) {
  const headers = { 'Content-Type': 'application/json' };
  const response = await fetch(`api/${what}`, { method: 'POST', headers, body: JSON.stringify(body) });
  if (!response.ok) throw new Error((await response.json()).error);
  return response.arrayBuffer();
}

/**
 * Calls `work` with the newest of what it is given, one call at a time: a pointer moves faster than
 * any server answers.
 * @template T
 * @param {(value: T) => Promise<void>} work
 */
export function newestOf(work) {
  /** @type {{value: T} | null} */
  let waiting = null;
  /** @type {Promise<void> | null} */
  let busy = null;
  const run = async () => {
    while (waiting) {
      const { value } = waiting;
      waiting = null;
      await work(value);
    }
    busy = null;
  };
  return {
    /** @param {T} value */
    give(value) {
      waiting = { value };
      busy ??= run();
    },
    /** Resolves once everything given has been worked on. */
    async settled() {
      while (busy) await busy;
    },
  };
}
