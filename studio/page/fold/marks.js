// What is drawn over the sheet while the pointer works: snaps, guides, the stroke, the axis and its
// disc. Lines of any width, so on a plain canvas.

const ink = { guide: '#2f6f4f', stroke: '#b3261e', axis: '#174ea6', disc: '#174ea6', pin: '#5b2c83' };
const names = {
  vertex: 'corner', crossing: 'guides cross', division: 'division', direction: 'direction', paper: '', ground: '',
};

export class Marks {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {(place: Place) => [number, number]} project to pixels
   */
  constructor(canvas, project) {
    this.canvas = canvas;
    this.pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    this.project = project;
    /** @type {Aim | null} */
    this.aim = null;
    /** @type {{from: Place, to: Place, side: number} | null} */
    this.stroke = null;
    /** @type {Grip | null} */
    this.grip = null;
    /** @type {[Place, Place] | null} */
    this.axis = null;
    /** @type {number | null} */
    this.degrees = null;
    /** @type {[number, number] | null} */
    this.cross = null;
    /** @type {Place[]} corners of a face that is pointed out */
    this.lit = [];
    /** @type {FoldState | null} */
    this.state = null;
  }

  /** @param {Place[]} places @param {string} colour @param {number} width @param {number[]} dash */
  line(places, colour, width, dash = []) {
    const pen = this.pen;
    pen.beginPath();
    places.forEach((place, i) => {
      const [x, y] = this.project(place);
      if (i === 0) pen.moveTo(x, y);
      else pen.lineTo(x, y);
    });
    pen.setLineDash(dash);
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.stroke();
  }

  /** @param {Place} place @param {string} colour @param {number} radius @param {boolean} full */
  dot(place, colour, radius, full = true) {
    const pen = this.pen;
    const [x, y] = this.project(place);
    pen.beginPath();
    pen.setLineDash([]);
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.lineWidth = 1.5;
    pen.fillStyle = pen.strokeStyle = colour;
    if (full) pen.fill();
    else pen.stroke();
  }

  /** @param {string} text @param {[number, number]} at @param {string} colour */
  label(text, at, colour) {
    const pen = this.pen;
    pen.font = '13px system-ui, sans-serif';
    const width = pen.measureText(text).width;
    const x = Math.min(at[0] + 14, this.canvas.clientWidth - width - 8);
    const y = Math.max(20, at[1] - 14);
    pen.fillStyle = 'rgba(255, 255, 255, 0.88)';
    pen.fillRect(x - 4, y - 14, width + 8, 19);
    pen.fillStyle = colour;
    pen.fillText(text, x, y);
  }

  draw() {
    const pen = this.pen;
    const scale = window.devicePixelRatio;
    pen.setTransform(scale, 0, 0, scale, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.drawWaiting();
    for (const pin of this.state?.pins ?? []) {
      this.dot(pin, '#ffffff', 7);
      this.dot(pin, ink.pin, 5);
    }
    if (this.lit.length > 0) this.line([...this.lit, this.lit[0]], ink.stroke, 2.5);
    if (this.axis) this.line(this.axis, ink.axis, 3, [10, 5]);
    if (this.aim) this.drawAim(this.aim);
    if (this.stroke) this.drawStroke(this.stroke);
    if (this.grip) this.drawGrip(this.grip);
    if (this.cross) {
      const [x, y] = this.cross;
      pen.setLineDash([]);
      pen.strokeStyle = '#000000';
      pen.lineWidth = 1;
      pen.strokeRect(x - 6, y - 6, 12, 12);
    }
  }

  drawWaiting() {
    const colours = /** @type {Record<string, string>} */ ({ M: '#b3261e', V: '#174ea6', U: '#5b2c83', F: '#77716a' });
    for (const line of this.state?.waiting ?? []) {
      const dash = line.crease === 'F' ? [3, 4] : line.crease === 'M' ? [8, 3, 2, 3] : line.crease === 'V' ? [6, 4] : [];
      this.line([[...line.from, 0], [...line.to, 0]], colours[line.crease], 2, dash);
    }
  }

  /** @param {Aim} aim */
  drawAim(aim) {
    for (const guide of aim.guides) this.line(guide, ink.guide, 1.5, [4, 4]);
    for (const point of aim.points) this.dot(point, ink.guide, 3.5, false);
    if (aim.by === 'ground') return;
    this.dot(aim.place, aim.by === 'paper' ? '#55504a' : ink.guide, aim.by === 'paper' ? 2.5 : 5);
    if (names[aim.by]) this.label(names[aim.by], this.project(aim.place), ink.guide);
  }

  /** @param {{from: Place, to: Place, side: number}} stroke */
  drawStroke({ from, to, side }) {
    this.line([from, to], ink.stroke, 2.5);
    this.dot(from, ink.stroke, 4);
    if (side === 0) return;
    // An arrow to the side that will move.
    const [a, b] = [this.project(from), this.project(to)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 20) return;
    const across = [(b[1] - a[1]) / length * side, -(b[0] - a[0]) / length * side];
    const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const end = [middle[0] + 26 * across[0], middle[1] + 26 * across[1]];
    const pen = this.pen;
    pen.beginPath();
    pen.moveTo(middle[0], middle[1]);
    pen.lineTo(end[0], end[1]);
    for (const turn of [2.6, -2.6]) {
      const [c, s] = [Math.cos(turn), Math.sin(turn)];
      pen.moveTo(end[0], end[1]);
      pen.lineTo(end[0] + 9 * (c * across[0] - s * across[1]), end[1] + 9 * (s * across[0] + c * across[1]));
    }
    pen.setLineDash([]);
    pen.stroke();
  }

  /** The axis, and the disc across it through the place that is held. @param {Grip} grip */
  drawGrip(grip) {
    this.line(grip.axis, ink.axis, 4);
    const [a, b] = grip.axis;
    const minus = (/** @type {Place} */ p, /** @type {Place} */ q) => /** @type {Place} */ (p.map((x, k) => x - q[k]));
    const times = (/** @type {Place} */ p, /** @type {number} */ s) => /** @type {Place} */ (p.map((x) => s * x));
    const plus = (/** @type {Place} */ p, /** @type {Place} */ q) => /** @type {Place} */ (p.map((x, k) => x + q[k]));
    const dot = (/** @type {Place} */ p, /** @type {Place} */ q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    const along = times(minus(b, a), 1 / Math.sqrt(dot(minus(b, a), minus(b, a))));
    const middle = plus(a, times(along, dot(minus(grip.click, a), along)));
    const arm = minus(grip.click, middle);
    const up = /** @type {Place} */ ([along[1] * arm[2] - along[2] * arm[1], along[2] * arm[0] - along[0] * arm[2],
      along[0] * arm[1] - along[1] * arm[0]]);
    const around = (/** @type {number} */ degrees) => {
      const angle = (degrees * Math.PI) / 180;
      return plus(middle, plus(times(arm, Math.cos(angle)), times(up, Math.sin(angle))));
    };
    const circle = Array.from({ length: 73 }, (_, k) => around(5 * k));
    this.line(circle, ink.disc, 1.5, [3, 3]);
    this.line([middle, grip.click], ink.disc, 1.5, [3, 3]);
    this.dot(grip.click, ink.disc, 5);
    if (this.degrees === null) return;
    const now = around(this.degrees);
    this.line([middle, now], ink.disc, 2);
    this.dot(now, ink.disc, 5);
    this.label(`${this.degrees.toFixed(Number.isInteger(this.degrees) ? 0 : 1)}°`, this.project(now), ink.disc);
  }
}
