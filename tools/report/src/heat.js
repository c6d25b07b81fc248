// Levels as colours over range: what the waterfall and the range-Doppler map share.
import { highestOf, make, number } from './text.js';
import { hotStops, ofHeat, theme } from './palette.js';

/** Decibels below the highest level that are shown. */
export const span = 60;

const margin = { left: 66, right: 10, top: 8, bottom: 42 }, titleHeight = 14;
const font = '12px system-ui, "Segoe UI", "Liberation Sans", sans-serif';
const steps = [1, 2, 5].flatMap(digit => [-3, -2, -1, 0, 1, 2, 3, 4, 5].map(power => digit * 10 ** power)).sort((a, b) => a - b);

export class Heat {
  /** @param {HTMLCanvasElement} canvas @param {HTMLElement} legend @param {object} range start, step and cells. @param {string} label Of the range. */
  constructor(canvas, legend, range, label = 'range, m') {
    [this.canvas, this.legend, this.range, this.label, this.top] = [canvas, legend, range, label, margin.top];
  }

  /** Makes the height of the canvas that of a square picture. */
  makeSquare() {
    const { canvas } = this;
    canvas.style.height = `${canvas.clientWidth - margin.left - margin.right + margin.top + margin.bottom}px`;
  }

  /** False if the canvas is not shown. @param {number[]} values That the axis on the left has to have room for. */
  begin(values = []) {
    const { canvas } = this, [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0) return false;
    [canvas.width, canvas.height] = [width * devicePixelRatio, height * devicePixelRatio].map(Math.round);
    const ctx = this.ctx = canvas.getContext('2d');
    ctx.scale(devicePixelRatio, devicePixelRatio);
    ctx.font = font;
    this.left = Math.max(margin.left, titleHeight + 14 + highestOf(values.map(value => number(value)).map(text => ctx.measureText(text).width)));
    [this.width, this.height] = [width - this.left - margin.right, height - margin.top - margin.bottom];
    return true;
  }

  /** The levels of all pixels of a row, of the cells of a pixel the highest, -Infinity of no echo. @param {(cell: number) => number?} level */
  pixelsOf(level) {
    const pixels = Math.max(1, Math.round(this.width)), { cells } = this.range;
    return Array.from({ length: pixels }, (_, pixel) => {
      const first = Math.floor(pixel * cells / pixels), end = Math.max(first + 1, Math.floor((pixel + 1) * cells / pixels));
      let best = -Infinity;
      for (let cell = first; cell < end; cell++) best = Math.max(best, level(cell) ?? -Infinity);
      return best;
    });
  }

  /** Paints rows, null for none, each from a bottom to a top on the canvas; returns the highest level, -Infinity of no echo. */
  paint(rows, bandOf) {
    const highest = highestOf(rows.map(row => row === null ? -Infinity : highestOf(row)));
    const lines = this.linesOf(rows, bandOf);
    const pixels = Math.max(1, Math.round(this.width)), picture = new OffscreenCanvas(pixels, lines.length), to = picture.getContext('2d'), image = to.createImageData(pixels, lines.length);
    const colours = Array.from({ length: 10 * span + 1 }, (_, i) => ofHeat(i / (10 * span)));
    const colourOf = level => colours[level === -Infinity ? 0 : Math.round(10 * Math.max(0, level - highest + span))];
    lines.forEach((line, y) => line?.forEach((level, pixel) => image.data.set([...colourOf(level), 255], 4 * (y * pixels + pixel))));
    to.putImageData(image, 0, 0);
    this.ctx.imageSmoothingEnabled = false;
    this.ctx.drawImage(picture, this.left, this.top, this.width, lines.length);
    return highest;
  }

  // The levels of all lines of pixels, from above, null for none; of the rows of a line the highest.
  linesOf(rows, bandOf) {
    const lines = Array.from({ length: Math.max(1, Math.round(this.height)) }, () => null);
    rows.forEach((row, index) => {
      if (row === null) return;
      const [low, high] = bandOf(index).map(y => Math.round(y - this.top)), first = Math.min(high, lines.length - 1);
      for (let y = first; y < Math.max(low, first + 1); y++) lines[y] = lines[y]?.map((level, pixel) => Math.max(level, row[pixel])) ?? row;
    });
    return lines;
  }

  /** Frame, range below, and on the left the values, each at its place on the canvas, from below. */
  drawAxes(label, values) {
    const { ctx, range, width, height, left, top } = this, bottom = top + height;
    [ctx.strokeStyle, ctx.fillStyle, ctx.lineWidth] = [theme('--line'), theme('--soft'), 1];
    ctx.strokeRect(left, top, width, height);
    const extent = range.cells * range.step, from = range.start - range.step / 2, step = stepOf(extent, width / 60);
    [ctx.textAlign, ctx.textBaseline] = ['center', 'top'];
    for (let i = Math.ceil(from / step); i * step <= from + extent; i++) {
      const x = left + (i * step - from) / extent * width;
      ctx.fillRect(x, bottom, 1, 4);
      ctx.fillText(number(i * step + 0), x, bottom + 6);
    }
    ctx.fillText(this.label, left + width / 2, bottom + 24);
    [ctx.textAlign, ctx.textBaseline] = ['right', 'middle'];
    let free = Infinity;
    for (const [value, y] of values) {
      if (y > free) continue;
      ctx.fillText(number(value), left - 6, y);
      free = y - 18;
    }
    ctx.save();
    ctx.translate(titleHeight, top + height / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.textAlign = 'center';
    ctx.fillText(label, 0, 0);
    ctx.restore();
  }

  drawLegend(highest, unit) {
    if (highest === -Infinity) {
      this.legend.replaceChildren(make('span', 'no echo'));
      return;
    }
    const ramp = make('span', null, { class: 'ramp', role: 'img', 'aria-label': 'from dark violet over red and orange to light yellow' });
    ramp.style.background = `linear-gradient(to right, ${hotStops.join(', ')})`;
    this.legend.replaceChildren(make('span', `${number(highest - span, 3)} ${unit} and less`), ramp, make('span', `${number(highest, 3)} ${unit}`));
  }

  /** The place of a range on the canvas. */
  xOf(range) {
    return this.left + ((range - this.range.start) / this.range.step + 0.5) / this.range.cells * this.width;
  }

  /** The cell under the mouse, and its place on the canvas from above; null beside the picture. */
  at(event) {
    const box = this.canvas.getBoundingClientRect(), y = event.clientY - box.top;
    const cell = Math.floor((event.clientX - box.left - this.left) / this.width * this.range.cells);
    return cell < 0 || cell >= this.range.cells ? null : { cell, y };
  }
}

/** The finest step of 1, 2 or 5 with so many parts at most. */
export const stepOf = (extent, parts) => steps.find(step => extent / step <= parts);
