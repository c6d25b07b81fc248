// Levels over an angle, around a centre.
import { byId, highestOf, number } from './text.js';
import { theme } from './palette.js';

// Decibels; labels nearer to the centre, in pixels, would hide it.
const span = 50, ring = 10, nearestLabel = 28;

// Whether the last angle is as near to the first as some others are to each other.
const isWholeTurn = angles => angles.length > 2 && 360 - (angles.at(-1) - angles[0]) <= (1 + 1e-9) * highestOf(angles.slice(1).map((angle, i) => angle - angles[i]));

export class Polar {
  /** @param {boolean} isElevation Whether the angle grows upwards from the right; azimuth grows clockwise from the top. @param {function} onPick takes an index. */
  constructor(isElevation, onPick) {
    this.isElevation = isElevation;
    this.canvas = byId('polar');
    this.canvas.addEventListener('click', event => {
      const index = this.nearest(event);
      if (index !== null) onPick(index);
    });
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
  }

  /** @param {object} what angles in degrees, series: [{label, values in dB, stroke, dash, marks: (index) => bool}], marked() an angle, description */
  draw(what) {
    this.what = what;
    this.canvas.setAttribute('aria-label', what.description);
    this.redraw();
  }

  redraw() {
    const size = this.canvas.clientWidth;
    if (!this.what || size === 0) return;
    this.canvas.width = this.canvas.height = Math.round(size * devicePixelRatio);
    const ctx = this.ctx = this.canvas.getContext('2d');
    ctx.scale(devicePixelRatio, devicePixelRatio);
    [this.middle, this.radius] = [size / 2, size / 2 - 32];
    const levels = this.what.series.flatMap(series => series.values.filter(value => value !== null));
    this.top = levels.length === 0 ? 0 : ring * Math.ceil(highestOf(levels) / ring);
    ctx.font = '12px system-ui, "Segoe UI", "Liberation Sans", sans-serif';
    this.drawGrid();
    this.drawRingLabels();
    for (const series of this.what.series) this.drawSeries(series);
    this.drawMarked();
  }

  // Radians on the canvas, where y points down.
  turn(angle) { return (this.isElevation ? -angle : angle - 90) * Math.PI / 180; }

  at(angle, level) {
    const reach = this.radius * Math.max(0, 1 - (this.top - level) / span);
    return [this.middle + reach * Math.cos(this.turn(angle)), this.middle + reach * Math.sin(this.turn(angle))];
  }

  drawGrid() {
    const { ctx, middle, radius } = this;
    ctx.lineWidth = 1;
    ctx.strokeStyle = theme('--grid');
    for (let level = 0; level < span; level += ring) {
      ctx.beginPath();
      ctx.arc(middle, middle, radius * (1 - level / span), 0, 2 * Math.PI);
      ctx.stroke();
    }
    ctx.fillStyle = theme('--soft');
    [ctx.textAlign, ctx.textBaseline] = ['center', 'middle'];
    for (let angle = 0; angle < 360; angle += 30) {
      const [x, y] = this.at(angle, this.top);
      ctx.beginPath();
      ctx.moveTo(middle, middle);
      ctx.lineTo(x, y);
      ctx.stroke();
      const shown = angle > 180 ? angle - 360 : angle;
      ctx.fillText(`${shown}\u00b0`, middle + (x - middle) * (1 + 14 / radius), middle + (y - middle) * (1 + 14 / radius));
    }
  }

  drawRingLabels() {
    const { ctx } = this;
    [ctx.textAlign, ctx.textBaseline] = ['left', 'middle'];
    for (let level = 0; level < span && this.radius * (1 - level / span) > nearestLabel; level += ring) {
      const [x, y] = this.at(45, this.top - level), text = `${number(this.top - level)}${level === 0 ? ' dBsm' : ''}`;
      ctx.fillStyle = theme('--back');
      ctx.fillRect(x - 1, y - 7, ctx.measureText(text).width + 3, 14);
      ctx.fillStyle = theme('--soft');
      ctx.fillText(text, x, y);
    }
  }

  drawSeries({ values, stroke, dash, marks }) {
    const { ctx } = this, { angles } = this.what;
    ctx.save();
    [ctx.strokeStyle, ctx.fillStyle, ctx.lineWidth] = [stroke, stroke, 1.8];
    ctx.setLineDash(dash);
    ctx.beginPath();
    const isTurn = isWholeTurn(angles), count = angles.length, level = place => values[isTurn ? (place + count) % count : place] ?? null;
    for (let i = 0; i < count + (isTurn ? 1 : 0); i++)
      if (level(i) !== null) ctx[i > 0 && level(i - 1) !== null ? 'lineTo' : 'moveTo'](...this.at(angles[i % count], level(i)));
    ctx.stroke();
    angles.forEach((angle, i) => {
      if (level(i) === null || level(i - 1) !== null || level(i + 1) !== null) return;
      ctx.beginPath();
      ctx.arc(...this.at(angle, level(i)), 2.5, 0, 2 * Math.PI);
      ctx.fill();
    });
    ctx.setLineDash([]);
    this.drawMarks(values, marks);
    ctx.restore();
  }

  drawMarks(values, marks) {
    const { ctx } = this, { angles } = this.what;
    for (const mark of marks)
      angles.forEach((angle, i) => {
        if (values[i] === null || !mark.holds(i)) return;
        const [x, y] = this.at(angle, values[i]);
        ctx.strokeStyle = mark.stroke;
        ctx.beginPath();
        if (mark.isDiamond) {
          ctx.moveTo(x, y - 6);
          for (const [across, up] of [[6, 0], [0, 6], [-6, 0], [0, -6]]) ctx.lineTo(x + across, y + up);
        } else ctx.rect(x - 4, y - 4, 8, 8);
        ctx.stroke();
      });
  }

  drawMarked() {
    const angle = this.what.marked(), { ctx } = this;
    if (angle === null) return;
    ctx.save();
    ctx.strokeStyle = theme('--text');
    ctx.setLineDash([4, 3]);
    ctx.beginPath();
    ctx.moveTo(this.middle, this.middle);
    ctx.lineTo(...this.at(angle, this.top));
    ctx.stroke();
    ctx.restore();
  }

  nearest(event) {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left - this.middle, event.clientY - box.top - this.middle];
    if (Math.hypot(x, y) < 8) return null;
    const away = angle => Math.abs(Math.atan2(Math.sin(this.turn(angle) - Math.atan2(y, x)), Math.cos(this.turn(angle) - Math.atan2(y, x))));
    return this.what.angles.reduce((best, angle, i, all) => away(angle) < away(all[best]) ? i : best, 0);
  }
}
