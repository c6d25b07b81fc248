// The charts over the poses of a sweep.
import { byId, highestOf, lowestOf, make, number } from './text.js';
import { dash, decibels, draw, edgeOf, pointsOf, squares, stroke } from './charts.js';
import { theme } from './palette.js';

const curve = (label, values, i) => ({ label, values, stroke: stroke(i), dash: dash(i), points: pointsOf(values, stroke(i), 120) });

export class SweepCharts {
  /** @param {object} poses Poses. @param {object} columns by name. @param {string} doubt What the marks of undersampled poses say. */
  constructor(poses, columns, doubt) {
    [this.poses, this.columns, this.doubt] = [poses, columns, doubt];
    this.plots = [];
    const select = byId('quantity');
    // Amplitudes are in the first chart.
    const others = Object.keys(columns).filter(name => !columns[name].axis && !columns[name].is_amplitude && !columns[name].is_flag);
    for (const name of others.filter(name => poses.rows.some(row => typeof row[name] === 'number')))
      select.append(make('option', columns[name].title, { value: name }));
    select.value = 'rays_received';
    select.addEventListener('change', () => this.draw());
    byId('decibels').addEventListener('change', () => this.draw());
  }

  draw() {
    if (this.poses.rows.length === 0)
      return;
    this.group = this.poses.groupOf(this.poses.rows[this.poses.chosen]);
    this.plots = [this.drawAmplitude(), this.drawOther(byId('quantity').value)];
  }

  redraw() {
    if (this.group !== this.poses.groupOf(this.poses.rows[this.poses.chosen])) this.draw();
    else for (const plot of this.plots) plot.redraw(false);
  }

  drawAmplitude() {
    const inDecibels = byId('decibels').checked;
    const level = value => inDecibels ? decibels(value) : value;
    const series = [], bands = [];
    const { groups, x } = this.poses;
    const { error } = this.columns.amplitude_normalised;
    if (groups.length === 1 && this.poses.rows.some(row => typeof row[error] === 'number')) {
      const edgeIn = inDecibels ? edgeOf : (amplitude, error) => Math.max(0, amplitude + error);
      const edge = sign => groups[0][1].map(row => row ? edgeIn(row.amplitude_normalised, sign * row[error]) : null);
      series.push({ label: ' ', values: edge(1), width: 0.5, stroke: theme('--accent'), points: { show: false } });
      // The scale need not hold a band down to nothing.
      series.push({ label: ' ', values: edge(-1), width: 0.5, stroke: theme('--accent'), points: { show: false }, auto: false });
      bands.push({ series: [1, 2], fill: theme('--band') });
    }
    groups.forEach(([name, rows], i) => series.push(curve(name || 'amplitude', rows.map(row => row ? level(row.amplitude_normalised) : null), i)));
    if (this.poses.rows.some(row => row.undersampled === 1))
      groups.forEach(([, rows], i) => series.push({
        label: i === 0 ? this.doubt : ' ', values: rows.map(row => row?.undersampled === 1 ? level(row.amplitude_normalised) : null), stroke: theme('--mark'), paths: () => null,
        points: { show: true, paths: squares, width: 2, stroke: theme('--mark'), fill: 'transparent' }
      }));
    const strongest = this.poses.rows.reduce((best, row) => row.amplitude_normalised > best.amplitude_normalised ? row : best);
    return this.chart('amplitude', series, inDecibels ? 'dB' : 'amplitude', bands,
      `Amplitude over ${x.label}; the largest is ${number(strongest.amplitude_normalised)} at ${this.poses.name(strongest)}. The table below has the figures.`, !inDecibels);
  }

  drawOther(name) {
    const { title, unit } = this.columns[name];
    const series = this.poses.groups.map(([group, rows], i) => curve(group || title, rows.map(row => row?.[name] ?? null), i));
    const values = this.poses.rows.map(row => row[name]).filter(value => typeof value === 'number');
    return this.chart('other', series, title + (unit === '1' ? '' : `, ${unit}`), [],
      `${title} over ${this.poses.x.label}, from ${number(lowestOf(values))} to ${number(highestOf(values))}. The table below has the figures.`, values.every(value => value >= 0));
  }

  chart(id, series, yLabel, bands, description, fromZero) {
    return draw(byId(id), {
      x: this.poses.x, series, yLabel, bands, description, fromZero,
      marked: () => this.poses.xOf(this.poses.chosen), onPick: index => this.poses.choose(this.poses.at(index))
    });
  }
}
