// Range profiles: that of the chosen direction, and those of its line as a waterfall.
import { byId, bytes, make, number } from './text.js';
import { dash, draw, stroke } from './charts.js';
import { hotStops, ofHeat, theme } from './palette.js';

// Decibels below the highest level.
const span = 60;
const margin = { left: 66, right: 10, top: 8, bottom: 42 };

export class Profiles {
  /** @param {object} echo start, step and cells of the range; polarisations; quantities: unit and levels, hundredths of a decibel by row, polarisation and cell. */
  constructor(echo, poses, maxSpan) {
    [this.echo, this.poses, this.maxSpan] = [echo, poses, maxSpan];
    this.levels = echo.quantities.map(({ levels }) => new Int16Array(bytes(levels).buffer));
    this.ranges = Array.from({ length: echo.cells }, (_, cell) => echo.start + cell * echo.step);
    echo.quantities.forEach(({ unit }, i) => byId('profile-unit').append(make('option', unit, { value: i })));
    echo.polarisations.forEach((name, i) => byId('waterfall-polarisation').append(make('option', name.toUpperCase(), { value: i })));
    for (const id of ['profile-unit', 'waterfall-polarisation']) byId(id).addEventListener('change', () => this.draw());
    byId('profile-text').textContent = `Range is half of the path out and back: 0 at the phase centre, positive away from the radar. Echoes outside the unambiguous range of ${number(echo.unambiguous, 4)} m are folded into it. The window is ${echo.window}: the peak of a point is its ${echo.quantities.length > 1 ? 'cross section or received power' : 'cross section'}.${echo.group > 1 ? ` Of ${number(echo.group)} neighbouring cells the highest is shown.` : ''}`;
    this.canvas = byId('waterfall');
    if (poses.rows.length < 2) {
      byId('waterfall-part').remove();
      return;
    }
    this.canvas.addEventListener('click', event => this.at(event) && poses.choose(poses.at(this.at(event).index)));
    this.canvas.addEventListener('mousemove', event => this.read(event));
    new ResizeObserver(() => this.drawWaterfall()).observe(this.canvas);
  }

  get unit() { return this.echo.quantities[Number(byId('profile-unit').value)].unit; }

  level(row, polarisation, cell) {
    const { polarisations, cells } = this.echo;
    return this.levels[Number(byId('profile-unit').value)][(row * polarisations.length + polarisation) * cells + cell] / 100;
  }

  draw() {
    const { echo, poses } = this, row = poses.chosen, x = { label: 'range, m', values: this.ranges };
    const series = echo.polarisations.map((name, i) => ({ label: name.toUpperCase(), values: this.ranges.map((_, cell) => this.level(row, i, cell)), stroke: stroke(i), dash: dash(2 * i), points: { show: false } }));
    const [highest, cell] = series[0].values.reduce((best, level, place) => level > best[0] ? [level, place] : best, [-Infinity, 0]);
    draw(byId('profile'), {
      x, series, yLabel: `echo, ${this.unit}`, maxSpan: this.maxSpan, height: 360,
      description: `Range profile of ${poses.name(poses.rows[row])} in ${this.unit}; the highest echo in ${series[0].label} is ${number(highest, 4)} ${this.unit} at ${number(this.ranges[cell], 4)} m.`
    });
    if (this.canvas.isConnected) this.drawWaterfall();
  }

  drawWaterfall() {
    const { canvas, poses } = this, [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (width === 0) return;
    [canvas.width, canvas.height] = [width * devicePixelRatio, height * devicePixelRatio].map(Math.round);
    const ctx = this.ctx = canvas.getContext('2d');
    ctx.scale(devicePixelRatio, devicePixelRatio);
    [this.width, this.height] = [width - margin.left - margin.right, height - margin.top - margin.bottom];
    this.top = this.paint(Number(byId('waterfall-polarisation').value));
    this.drawAxes();
    this.drawLegend();
    canvas.setAttribute('aria-label', `Range profiles over ${poses.x.label}, as colours over ${span} dB. The table below has the highest echo of each direction.`);
  }

  // A band of colours for each direction of the line. Returns the highest level.
  paint(polarisation) {
    const { ctx, poses, echo, width } = this, { line } = poses;
    const rows = line.map(row => row === null ? -1 : poses.rows.indexOf(row));
    const pixels = Math.max(1, Math.round(width)), levels = rows.map(row => {
      if (row < 0) return null;
      // Of the cells of a pixel the highest.
      return Array.from({ length: pixels }, (_, pixel) => {
        const first = Math.floor(pixel * echo.cells / pixels), end = Math.max(first + 1, Math.floor((pixel + 1) * echo.cells / pixels));
        let best = -Infinity;
        for (let cell = first; cell < end; cell++) best = Math.max(best, this.level(row, polarisation, cell));
        return best;
      });
    });
    const top = levels.reduce((best, row) => row === null ? best : row.reduce((a, b) => Math.max(a, b), best), -Infinity);
    const strip = new OffscreenCanvas(pixels, 1), to = strip.getContext('2d'), image = to.createImageData(pixels, 1);
    const colours = Array.from({ length: 10 * span + 1 }, (_, i) => ofHeat(i / (10 * span)));
    ctx.imageSmoothingEnabled = false;
    levels.forEach((row, index) => {
      if (row === null) return;
      row.forEach((level, pixel) => image.data.set([...colours[Math.round(10 * Math.max(0, level - top + span))], 255], 4 * pixel));
      to.putImageData(image, 0, 0);
      const [low, high] = this.band(index).map(Math.round);
      ctx.drawImage(strip, margin.left, high, width, low - high);
    });
    return top;
  }

  // Bottom and top of a direction's band, half way to its neighbours, on the canvas.
  band(index) {
    const { values } = this.poses.x, last = values.length - 1;
    const edge = place => place <= 0 ? values[0] - (values[1] - values[0]) / 2 : place > last ? values[last] + (values[last] - values[last - 1]) / 2 : (values[place - 1] + values[place]) / 2;
    const y = value => margin.top + this.height * (1 - (value - edge(0)) / (edge(last + 1) - edge(0)));
    return [y(edge(index)), y(edge(index + 1))];
  }

  drawAxes() {
    const { ctx, poses, ranges, echo, width, height } = this, bottom = margin.top + height;
    [ctx.strokeStyle, ctx.fillStyle, ctx.lineWidth] = [theme('--line'), theme('--soft'), 1];
    ctx.font = '12px system-ui, "Segoe UI", "Liberation Sans", sans-serif';
    ctx.strokeRect(margin.left, margin.top, width, height);
    const extent = echo.cells * echo.step, from = ranges[0] - echo.step / 2;
    const step = [1, 2, 5].flatMap(digit => [-3, -2, -1, 0, 1, 2, 3, 4, 5].map(power => digit * 10 ** power)).sort((a, b) => a - b).find(each => extent / each <= width / 60);
    [ctx.textAlign, ctx.textBaseline] = ['center', 'top'];
    for (let i = Math.ceil(from / step); i * step <= from + extent; i++) {
      const x = margin.left + (i * step - from) / extent * width;
      ctx.fillRect(x, bottom, 1, 4);
      ctx.fillText(number(i * step + 0), x, bottom + 6);
    }
    ctx.fillText('range, m', margin.left + width / 2, bottom + 24);
    [ctx.textAlign, ctx.textBaseline] = ['right', 'middle'];
    let free = Infinity;
    poses.x.values.forEach((value, index) => {
      const [low, high] = this.band(index), y = (low + high) / 2;
      if (y > free) return;
      ctx.fillText(number(value), margin.left - 6, y);
      free = y - 18;
    });
    ctx.save();
    ctx.translate(14, margin.top + height / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.textAlign = 'center';
    ctx.fillText(poses.x.label, 0, 0);
    ctx.restore();
    this.drawChosen();
  }

  drawChosen() {
    const { ctx, poses, width } = this, index = poses.line.indexOf(poses.rows[poses.chosen]);
    const [low, high] = this.band(index), y = (low + high) / 2;
    ctx.fillStyle = theme('--text');
    for (const [x, side] of [[margin.left, 1], [margin.left + width, -1]]) {
      ctx.beginPath();
      ctx.moveTo(x + 9 * side, y);
      ctx.lineTo(x - 2 * side, y - 5);
      ctx.lineTo(x - 2 * side, y + 5);
      ctx.fill();
      ctx.strokeStyle = theme('--back');
      ctx.stroke();
    }
  }

  drawLegend() {
    const ramp = make('span', null, { class: 'ramp', role: 'img', 'aria-label': 'from dark violet over red and orange to light yellow' });
    ramp.style.background = `linear-gradient(to right, ${hotStops.join(', ')})`;
    byId('waterfall-legend').replaceChildren(make('span', `${number(this.top - span, 3)} ${this.unit} and less`), ramp, make('span', `${number(this.top, 3)} ${this.unit}`));
  }

  // The place of the line and the cell under the mouse; null beside the picture.
  at(event) {
    const box = this.canvas.getBoundingClientRect(), [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const cell = Math.floor((x - margin.left) / this.width * this.echo.cells);
    const index = this.poses.line.findIndex((row, place) => row !== null && y <= this.band(place)[0] && y >= this.band(place)[1]);
    return index < 0 || cell < 0 || cell >= this.echo.cells ? null : { index, cell };
  }

  read(event) {
    const at = this.at(event), { poses } = this;
    byId('waterfall-readout').textContent = at === null ? '\u00a0' : `${poses.name(poses.line[at.index])}, range ${number(this.ranges[at.cell], 4)} m: ${number(this.level(poses.at(at.index), Number(byId('waterfall-polarisation').value), at.cell), 4)} ${this.unit}`;
  }
}
