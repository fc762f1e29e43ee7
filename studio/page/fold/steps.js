// The log of folds as a list, and its player.
import { post } from '../api.js';
import { attempt, make, part, saveAs, say } from '../parts.js';

/** @type {Record<string, string>} */
const words = {
  crease: 'a line, not folded', fold: 'a line to fold', flatten: 'fold all flat', through: 'fold all layers',
  turn: 'turn about a line', squash: 'squash', over: 'turn over', score: 'a crease on the folded sheet',
  swing: 'turn a face',
};
/** @param {FoldStep} step */
const wordsOf = (step) => (step.do === 'through' && step.faces ? 'fold the chosen layers' : words[step.do] ?? step.do);
const frames = 14; // between two steps
const pause = 250; // ms after each

export class Steps {
  /**
   * @param {(state: FoldState) => void} show
   * @param {(shape: Drag) => void} showBetween
   */
  constructor(show, showBetween) {
    this.show = show;
    this.showBetween = showBetween;
    this.playing = false;
    /** @type {FoldState | null} */
    this.state = null;
    this.slider = /** @type {HTMLInputElement} */ (part('fold-time'));
    this.slider.addEventListener('input', () => attempt(() => this.go(Number(this.slider.value))));
    part('fold-play').addEventListener('click', () => attempt(() => this.play()));
    part('fold-film').addEventListener('click', () => attempt(() => this.film()));
    part('fold-undo').addEventListener('click', () => attempt(() => this.go(this.at() - 1)));
    part('fold-redo').addEventListener('click', () => attempt(() => this.go(this.at() + 1)));
  }

  at() {
    return this.state?.at ?? 0;
  }

  /** @param {number} at */
  async go(at) {
    this.show(await post('fold/go', { at }));
  }

  async play() {
    const button = part('fold-play');
    if (this.playing) {
      this.playing = false;
      return;
    }
    this.playing = true;
    button.textContent = 'Pause';
    const last = this.state?.log.length ?? 0;
    try {
      if (this.at() === last) await this.go(0);
      while (this.playing && this.at() < last) {
        const at = this.at() + 1;
        const turns = ['turn', 'through', 'swing', 'over'].includes(this.state?.log[at - 1].do ?? '');
        for (let k = 1; turns && this.playing && k < frames; ++k) {
          this.showBetween(await post('fold/between', { at, share: k / frames }));
          await new Promise((resolve) => requestAnimationFrame(resolve));
        }
        await this.go(at);
        await new Promise((resolve) => setTimeout(resolve, turns ? pause : pause / 3));
      }
    } finally {
      this.playing = false;
      button.textContent = 'Play';
    }
  }

  /** Plays the whole log and saves what is seen as a film. */
  async film() {
    const canvas = /** @type {HTMLCanvasElement} */ (part('fold-canvas'));
    const recorder = new MediaRecorder(canvas.captureStream(), { mimeType: 'video/webm', videoBitsPerSecond: 6e6 });
    /** @type {Blob[]} */
    const pieces = [];
    recorder.addEventListener('dataavailable', ({ data }) => pieces.push(data));
    const over = new Promise((resolve) => recorder.addEventListener('stop', resolve));
    await this.go(0);
    recorder.start();
    say('The folding is played and filmed.');
    await this.play();
    await new Promise((resolve) => setTimeout(resolve, 2 * pause));
    recorder.stop();
    await over;
    saveAs(pieces, `${this.state?.title || 'folding'}.webm`);
    say('');
  }

  /** @param {FoldState} state */
  list(state) {
    this.state = state;
    this.slider.max = String(state.log.length);
    this.slider.value = String(state.at);
    part('fold-undo').disabled = state.at === 0;
    part('fold-redo').disabled = state.at === state.log.length;
    part('fold-play').disabled = state.log.length === 0;
    const rows = state.log.map((step, i) => {
      const degrees = step.degrees === undefined ? '' : ` ${Number(step.degrees.toFixed(1))}°`;
      const button = make('button', { type: 'button', class: 'step' }, (step.note || wordsOf(step)) + degrees);
      if (i + 1 === state.at) button.setAttribute('aria-current', 'step');
      button.addEventListener('click', () => attempt(() => this.go(i + 1)));
      const row = make('li', i < state.at ? {} : { class: 'undone' }, button);
      return row;
    });
    part('fold-steps').replaceChildren(...rows);
    rows[state.at - 1]?.scrollIntoView({ block: 'nearest' });
    part('fold-steps').querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest' });
  }
}
