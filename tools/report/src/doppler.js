// The range-Doppler map of the chosen direction, its cut at a speed, and what was detected.
import { byId, levelText, levelsFrom, make, number, plural } from './text.js';
import { draw, maxSpan, pointsOf, stroke } from './charts.js';
import { Heat, span, stepOf } from './heat.js';
import { theme } from './palette.js';

// Of the list of speeds.
const strongest = 'strongest';

export class Maps {
  /** @param {object} echo doppler: start, step and cells of the range, speed_start, speed_step and rows, blind_speed, quantities: unit and levels, hundredths of a decibel by direction, polarisation, speed and range; detections by direction. */
  constructor(echo, poses) {
    [this.echo, this.map, this.poses] = [echo, echo.doppler, poses];
    const { map } = this;
    this.levels = map.quantities.map(({ levels }) => levelsFrom(levels));
    this.heat = new Heat(byId('doppler'), byId('doppler-legend'), map);
    map.quantities.forEach(({ unit }, i) => byId('doppler-unit').append(make('option', unit, { value: i })));
    echo.polarisations.forEach((name, i) => byId('doppler-polarisation').append(make('option', name.toUpperCase(), { value: i })));
    for (let row = 0; row < map.rows; row++) byId('doppler-speed').append(make('option', `${number(this.speed(row), 4)} m/s`, { value: row }));
    for (const id of ['doppler-unit', 'doppler-polarisation', 'doppler-speed']) byId(id).addEventListener('change', () => this.draw());
    byId('doppler-text').textContent = `Speed is positive towards the radar. Speeds outside half of the blind speed of ${number(map.blind_speed, 4)} m/s are folded into it. A click or the list chooses the speed of the cut below${echo.detections ? '; rings mark detections' : ''}.`;
    const { canvas } = this.heat;
    canvas.addEventListener('click', event => { if (this.at(event)) { byId('doppler-speed').value = this.at(event).row; this.draw(); } });
    canvas.addEventListener('mousemove', event => this.read(event));
    new ResizeObserver(() => this.drawMap()).observe(canvas);
  }

  get unit() { return this.map.quantities[Number(byId('doppler-unit').value)].unit; }
  get polarisation() { return Number(byId('doppler-polarisation').value); }

  level(row, cell) {
    const { map, echo, poses } = this;
    return this.levels[Number(byId('doppler-unit').value)](((poses.chosen * echo.polarisations.length + this.polarisation) * map.rows + row) * map.cells + cell);
  }

  speed(row) { return this.map.speed_start + row * this.map.speed_step; }

  // Of all cells: level, speed and range.
  highest() {
    const { rows, cells } = this.map;
    let best = [null, 0, 0];
    for (let row = 0; row < rows; row++)
      for (let cell = 0; cell < cells; cell++) if ((this.level(row, cell) ?? -Infinity) > (best[0] ?? -Infinity)) best = [this.level(row, cell), row, cell];
    return best;
  }

  draw() {
    this.drawMap();
    const { map, echo } = this, { value: speed } = byId('doppler-speed'), row = speed === strongest ? this.highest()[1] : Number(speed), values = Array.from({ length: map.cells }, (_, cell) => this.level(row, cell));
    draw(byId('doppler-cut'), {
      x: { label: 'range, m', values: values.map((_, cell) => this.rangeOf(cell)) },
      series: [{ label: `${echo.polarisations[this.polarisation].toUpperCase()} at ${number(this.speed(row), 4)} m/s`, values, stroke: stroke(0), dash: [], points: pointsOf(values, stroke(0), 0) }],
      yLabel: `echo, ${this.unit}`, maxSpan, height: 240, description: `Cut of the map at ${number(this.speed(row), 4)} m/s in ${this.unit}.`
    });
  }

  rangeOf(cell) { return this.map.start + cell * this.map.step; }

  drawMap() {
    const { heat, map, poses } = this;
    if (!heat.begin()) return;
    const band = row => [row, row + 1].map(edge => heat.top + heat.height * (1 - edge / map.rows));
    const top = heat.paint(Array.from({ length: map.rows }, (_, row) => heat.pixelsOf(cell => this.level(row, cell))), band);
    const extent = map.rows * map.speed_step, step = stepOf(extent, heat.height / 40), from = map.speed_start - map.speed_step / 2;
    const ticks = [];
    for (let i = Math.ceil(from / step); i * step <= from + extent; i++) ticks.push([i * step + 0, this.yOf(i * step)]);
    heat.drawAxes('speed, m/s', ticks);
    heat.drawLegend(top, this.unit);
    for (const { range, speed } of this.detected()) this.ring(heat.xOf(range), this.yOf(speed));
    const [level, row, cell] = this.highest();
    heat.canvas.setAttribute('aria-label', `Range-Doppler map of ${poses.name(poses.rows[poses.chosen])}, as colours over ${span} dB: the highest echo is ${levelText(level, this.unit)} at ${number(this.rangeOf(cell), 4)} m and ${number(this.speed(row), 4)} m/s${this.echo.detections ? `; ${plural(this.detected().length, 'detection')}` : ''}.`);
  }

  detected() {
    return (this.echo.detections?.[this.poses.chosen] ?? []).filter(each => each.polarisation === this.echo.polarisations[this.polarisation]);
  }

  ring(x, y) {
    const { ctx } = this.heat;
    for (const [colour, width] of [[theme('--back'), 4], [theme('--text'), 1.5]]) {
      [ctx.strokeStyle, ctx.lineWidth] = [colour, width];
      ctx.beginPath();
      ctx.arc(x, y, 6, 0, 2 * Math.PI);
      ctx.stroke();
    }
  }

  yOf(speed) { return this.heat.top + this.heat.height * (1 - ((speed - this.map.speed_start) / this.map.speed_step + 0.5) / this.map.rows); }

  at(event) {
    const at = this.heat.at(event), row = at && Math.floor((1 - (at.y - this.heat.top) / this.heat.height) * this.map.rows);
    return at === null || row < 0 || row >= this.map.rows ? null : { row, cell: at.cell };
  }

  read(event) {
    const at = this.at(event);
    byId('doppler-readout').textContent = at === null ? '\u00a0' : `range ${number(this.rangeOf(at.cell), 4)} m, speed ${number(this.speed(at.row), 4)} m/s: ${levelText(this.level(at.row, at.cell), this.unit)}`;
  }
}
