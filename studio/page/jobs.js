// The work in the background, one at a time for the whole page: what it says and how it ends.
import { post } from './api.js';
import { attempt, part } from './parts.js';

/** @typedef {{job: number, changes: number, what: string, state: string, lines: string[]}} Job */

/** What was heard last. @type {Job} */
let newest = { job: 0, changes: -1, what: '', state: 'none', lines: [] };
/** @type {{number: number, ended: (job: Job) => void} | null} */
let awaited = null;
/** @type {Set<(job: Job) => void>} */
const listeners = new Set();

/** Events and answers come on different ways: one may overtake the other. @param {Job} said */
function heard(said) {
  if (said.changes > newest.changes) newest = said;
  const job = newest;
  const running = job.state === 'running';
  part('job').hidden = !running;
  part('job-says').textContent = `${job.what}: ${job.lines.at(-1) ?? 'beginning'}`;
  document.body.dataset.job = job.state;
  for (const listener of listeners) listener(job);
  if (running || job.job !== awaited?.number) return;
  const { ended } = awaited;
  awaited = null;
  ended(job);
}

/** Calls `listener` whenever the work says something. @param {(job: Job) => void} listener */
export function followJobs(listener) {
  listeners.add(listener);
}

/**
 * Starts work and waits for its end.
 * @param {string} verb such as "fit" @param {object} body
 * @returns {Promise<Job>} once it is done @throws Error if it fails or is cancelled
 */
export async function work(verb, body) {
  const begun = /** @type {Job} */ (await post(`job/${verb}`, body));
  const ended = await new Promise((resolve) => {
    awaited = { number: begun.job, ended: resolve };
    heard(begun);
  });
  if (ended.state === 'done') return ended;
  throw new Error(ended.state === 'cancelled' ? `${ended.what}: cancelled, nothing was written`
    : ended.lines.at(-1) ?? `${ended.what}: it failed`);
}

const events = new EventSource('api/job/events');
// A server that was started anew counts from the beginning, and says first where it stands.
events.addEventListener('open', () => { newest = { ...newest, changes: -1 }; });
events.addEventListener('message', (event) => heard(JSON.parse(event.data)));
part('job-cancel').addEventListener('click', () => attempt(async () => heard(await post('job/cancel'))));
