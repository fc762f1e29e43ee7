// Rings and sectors as plots: measured with their standard errors, and what a material explains.
import { axis, bands, colours, series } from '../plot.js';
import uPlot from '../vendor/uplot.js';

const least = 1e-9; // of the highest density that is shown

/** Ticks that are powers of ten. @param {unknown} _ @param {number[]} ticks */
const decades = (_, ticks) => ticks.map((t) => (Math.abs(Math.log10(t) - Math.round(Math.log10(t))) < 1e-6 ? t : null));

/** Only what a logarithm is made of. @param {(number | null)[]} values */
const positive = (values) => values.map((v) => (v !== null && v > 0 ? v : null));

export class Plot {
  /**
   * @param {HTMLElement} box
   * @param {{log: boolean}} axis along x @param {(index: number) => void} choose
   */
  constructor(box, axis, choose) {
    this.box = box;
    this.log = axis.log;
    this.choose = choose;
    /** @type {uPlot | null} */
    this.plot = null;
    /** @type {number | null} */
    this.index = null;
    new ResizeObserver(() => this.plot?.setSize(this.size())).observe(box);
  }

  size() {
    return { width: Math.max(120, this.box.clientWidth), height: Math.max(100, this.box.clientHeight) };
  }

  /**
   * @param {number[]} x @param {number[]} density @param {number[]} sigma
   * @param {number[] | null} expected by a material
   * @param {{x: string, y: string}} labels
   */
  show(x, density, sigma, expected, labels) {
    this.plot?.destroy();
    const seen = density.filter((d) => d > 0);
    const high = 2 * Math.max(...seen, 1e-30);
    const low = Math.max(Math.min(...seen, high) / 2, high * least);
    /** @type {any} */
    const options = {
      ...this.size(),
      legend: { show: false },
      cursor: { drag: { x: false, y: false }, points: { size: 7 } },
      scales: { x: { time: false, distr: this.log ? 3 : 1 }, y: { distr: 3, range: () => [low, high] } },
      axes: [{ ...axis, label: labels.x, size: 32, ...(this.log ? { grid: { ...axis.grid, filter: decades }, ticks: { ...axis.ticks, filter: decades } } : {}) },
        { ...axis, label: labels.y, size: 54, values: (/** @type {uPlot} */ _, /** @type {(number | null)[]} */ v) => v.map((t) => (t === null ? '' : `1e${Math.round(Math.log10(t))}`)),
          filter: decades, grid: { ...axis.grid, filter: decades }, ticks: { ...axis.ticks, filter: decades } }],
      bands,
      series: series.map((one, i) => (i === 1 ? { ...one, points: { show: true, size: 4, fill: colours.measured } } : one)),
      hooks: { draw: [(/** @type {uPlot} */ plot) => this.line(plot)] },
    };
    const data = [x, positive(density), positive(density.map((d, i) => d - sigma[i])), positive(density.map((d, i) => d + sigma[i])),
      positive(expected ?? x.map(() => null))];
    this.plot = new uPlot(options, /** @type {any} */ (data), this.box);
    this.plot.over.addEventListener('click', () => {
      const { idx } = /** @type {uPlot} */ (this.plot).cursor;
      if (idx !== null && idx !== undefined) this.choose(idx);
    });
  }

  /** @param {number | null} index of what is chosen */
  point(index) {
    this.index = index;
    this.plot?.redraw(false);
  }

  /** @param {uPlot} plot */
  line(plot) {
    if (this.index === null) return;
    const x = plot.valToPos(plot.data[0][this.index], 'x', true);
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = colours.ink;
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }
}
