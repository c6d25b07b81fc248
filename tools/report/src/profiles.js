// Range profiles: that of the chosen direction, and those of its line as a waterfall.
import { byId, bytes, make, number } from './text.js';
import { dash, draw, stroke } from './charts.js';
import { Heat, span } from './heat.js';
import { theme } from './palette.js';

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
    this.heat = new Heat(this.canvas, byId('waterfall-legend'), echo);
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

  // Of profiles, in their unit.
  detected(row) {
    const { echo } = this;
    return echo.doppler || echo.quantities.at(-1).unit !== this.unit ? [] : echo.detections?.[row] ?? [];
  }

  draw() {
    const { echo, poses } = this, row = poses.chosen, x = { label: 'range, m', values: this.ranges };
    const series = echo.polarisations.map((name, i) => ({ label: name.toUpperCase(), values: this.ranges.map((_, cell) => this.level(row, i, cell)), stroke: stroke(i), dash: dash(2 * i), points: { show: false } }));
    const detected = this.detected(row);
    if (detected.length > 0) series.push({ label: 'detected', values: this.ranges.map((_, cell) => Math.max(...detected.filter(({ range }) => Math.round((range - echo.start) / echo.step) === cell).map(({ level }) => level))).map(level => level === -Infinity ? null : level), stroke: theme('--text'), width: 0, points: { show: true, size: 9, width: 1.5, fill: 'transparent' } });
    const [highest, cell] = series[0].values.reduce((best, level, place) => level > best[0] ? [level, place] : best, [-Infinity, 0]);
    draw(byId('profile'), {
      x, series, yLabel: `echo, ${this.unit}`, maxSpan: this.maxSpan, height: 360,
      description: `Range profile of ${poses.name(poses.rows[row])} in ${this.unit}; the highest echo in ${series[0].label} is ${number(highest, 4)} ${this.unit} at ${number(this.ranges[cell], 4)} m.`
    });
    if (this.canvas.isConnected) this.drawWaterfall();
  }

  drawWaterfall() {
    const { heat, poses, canvas } = this, polarisation = Number(byId('waterfall-polarisation').value);
    if (!heat.begin()) return;
    // A band of colours for each direction of the line.
    const rows = poses.line.map(row => row === null ? null : heat.pixelsOf(cell => this.level(poses.rows.indexOf(row), polarisation, cell)));
    this.top = heat.paint(rows, index => this.band(index));
    heat.drawAxes(poses.x.label, poses.x.values.map((value, index) => [value, this.band(index).reduce((low, high) => (low + high) / 2)]));
    this.drawChosen();
    heat.drawLegend(this.top, this.unit);
    canvas.setAttribute('aria-label', `Range profiles over ${poses.x.label}, as colours over ${span} dB. The table below has the highest echo of each direction.`);
  }

  // Bottom and top of a direction's band, half way to its neighbours, on the canvas.
  band(index) {
    const { values } = this.poses.x, last = values.length - 1;
    const edge = place => place <= 0 ? values[0] - (values[1] - values[0]) / 2 : place > last ? values[last] + (values[last] - values[last - 1]) / 2 : (values[place - 1] + values[place]) / 2;
    const y = value => this.heat.top + this.heat.height * (1 - (value - edge(0)) / (edge(last + 1) - edge(0)));
    return [y(edge(index)), y(edge(index + 1))];
  }

  drawChosen() {
    const { poses, heat: { ctx, left, width } } = this, index = poses.line.indexOf(poses.rows[poses.chosen]);
    const [low, high] = this.band(index), y = (low + high) / 2;
    ctx.fillStyle = theme('--text');
    for (const [x, side] of [[left, 1], [left + width, -1]]) {
      ctx.beginPath();
      ctx.moveTo(x + 9 * side, y);
      ctx.lineTo(x - 2 * side, y - 5);
      ctx.lineTo(x - 2 * side, y + 5);
      ctx.fill();
      ctx.strokeStyle = theme('--back');
      ctx.stroke();
    }
  }

  // The place of the line and the cell under the mouse; null beside the picture.
  at(event) {
    const at = this.heat.at(event);
    const index = at === null ? -1 : this.poses.line.findIndex((row, place) => row !== null && at.y <= this.band(place)[0] && at.y >= this.band(place)[1]);
    return index < 0 ? null : { index, cell: at.cell };
  }

  read(event) {
    const at = this.at(event), { poses } = this;
    byId('waterfall-readout').textContent = at === null ? '\u00a0' : `${poses.name(poses.line[at.index])}, range ${number(this.ranges[at.cell], 4)} m: ${number(this.level(poses.at(at.index), Number(byId('waterfall-polarisation').value), at.cell), 4)} ${this.unit}`;
  }
}
