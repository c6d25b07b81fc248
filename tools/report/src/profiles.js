// Range profiles: that of the chosen direction, and those of its line as a waterfall.
import { byId, highestOf, levelText, levelsFrom, make, number } from './text.js';
import { dash, draw, maxSpan, pointsOf, stroke } from './charts.js';
import { Heat, span } from './heat.js';
import { theme } from './palette.js';

export class Profiles {
  /** @param {object} echo start, step and cells of the range; polarisations; quantities: unit and levels, hundredths of a decibel by row, polarisation and cell. */
  constructor(echo, poses) {
    [this.echo, this.poses] = [echo, poses];
    this.levels = echo.quantities.map(({ levels }) => levelsFrom(levels));
    this.ranges = Array.from({ length: echo.cells }, (_, cell) => echo.start + cell * echo.step);
    echo.quantities.forEach(({ unit }, i) => byId('profile-unit').append(make('option', unit, { value: i })));
    echo.polarisations.forEach((name, i) => byId('waterfall-polarisation').append(make('option', name.toUpperCase(), { value: i })));
    // Detections are those of the last.
    if (echo.detections && !echo.doppler) byId('profile-unit').value = echo.quantities.length - 1;
    for (const id of ['profile-unit', 'waterfall-polarisation']) byId(id).addEventListener('change', () => this.draw());
    byId('profile-text').textContent = `${echo.doppler ? 'Profiles are those of the first pulse. ' : ''}Range is half of the path out and back: 0 at the phase centre, positive away from the radar. Echoes outside the unambiguous range of ${number(echo.unambiguous, 4)} m are folded into it. The window is ${echo.window}: the peak of a point is its ${echo.quantities.length > 1 ? 'cross section or received power' : 'cross section'}.${echo.group > 1 ? ` Of ${number(echo.group)} neighbouring cells the highest is shown.` : ''}`;
    this.canvas = byId('waterfall');
    this.heat = new Heat(this.canvas, byId('waterfall-legend'), echo);
    if (poses.x.values.length < 2) {
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
    return this.levels[Number(byId('profile-unit').value)]((row * polarisations.length + polarisation) * cells + cell);
  }

  // Of profiles, in their unit.
  detected(row) {
    const { echo } = this;
    return echo.doppler || echo.quantities.at(-1).unit !== this.unit ? [] : echo.detections?.[row] ?? [];
  }

  draw() {
    const { echo, poses } = this, row = poses.chosen, x = { label: 'range, m', values: this.ranges };
    const series = echo.polarisations.map((name, i) => {
      const values = this.ranges.map((_, cell) => this.level(row, i, cell));
      return { label: name.toUpperCase(), values, stroke: stroke(i), dash: dash(2 * i), points: pointsOf(values, stroke(i), 0) };
    });
    const detected = this.detected(row);
    if (detected.length > 0) series.push({ label: 'detected', values: this.ranges.map((_, cell) => highestOf(detected.filter(({ range }) => Math.round((range - echo.start) / echo.step) === cell).map(({ level }) => level))).map(level => level === -Infinity ? null : level), stroke: theme('--text'), width: 0, points: { show: true, size: 9, width: 1.5, fill: 'transparent' } });
    const levels = series[0].values, highest = highestOf(levels.filter(level => level !== null)), place = highest === -Infinity ? '' : ` at ${number(this.ranges[levels.indexOf(highest)], 4)} m`;
    draw(byId('profile'), {
      x, series, yLabel: `echo, ${this.unit}`, maxSpan, height: 360,
      description: `Range profile of ${poses.name(poses.rows[row])} in ${this.unit}; the highest echo in ${series[0].label}: ${levelText(highest, this.unit)}${place}.`
    });
    if (this.canvas.isConnected) this.drawWaterfall();
  }

  drawWaterfall() {
    const { heat, poses, canvas } = this, polarisation = Number(byId('waterfall-polarisation').value);
    if (!heat.begin(poses.x.values)) return;
    // A band of colours for each direction of the line.
    const rows = poses.line.map(row => {
      const direction = poses.numberOf(row);
      return direction < 0 ? null : heat.pixelsOf(cell => this.level(direction, polarisation, cell));
    });
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
    const { poses, heat: { ctx, left, width } } = this;
    const [low, high] = this.band(poses.place), y = (low + high) / 2;
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
    byId('waterfall-readout').textContent = at === null ? '\u00a0' : `${poses.name(poses.line[at.index])}, range ${number(this.ranges[at.cell], 4)} m: ${levelText(this.level(poses.at(at.index), Number(byId('waterfall-polarisation').value), at.cell), this.unit)}`;
  }
}
