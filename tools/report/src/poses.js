// The poses of a run, and which of them is chosen.
import { number } from './text.js';

// The axes of a sweep, that which changes from pose to pose first.
const axes = [
  { name: 'angle_deg', label: 'angle in degrees', words: value => `${number(value)} deg` },
  { name: 'grazing_deg', label: 'grazing angle in degrees', words: value => `grazing ${number(value)} deg` },
  { name: 'range_m', label: 'range in metres', words: value => `range ${number(value)} m` },
  { name: 'frequency_hz', label: 'frequency in Hz', words: value => `${number(value / 1e9, 9)} GHz` },
  { name: 'snapshot', label: 'snapshot', words: value => `snapshot ${value}` }
];

const mostGroups = 8;

export class Poses {
  constructor(rows) {
    this.rows = rows;
    this.chosen = 0;
    this.listeners = [];
    const distinct = name => [...new Set(rows.map(row => row[name]).filter(value => value !== null && value !== undefined))];
    this.varying = axes.filter(axis => distinct(axis.name).length > 1);
    const [first] = this.varying.length > 0 ? this.varying : axes;
    this.x = { ...first, values: distinct(first.name).sort((a, b) => a - b) };
    this.others = this.varying.slice(1);
    const place = new Map(this.x.values.map((value, i) => [value, i]));
    // One list for each combination of the other axes, with a row or nothing for each x.
    const groups = new Map();
    for (const row of rows) {
      const key = this.groupOf(row);
      if (!groups.has(key)) groups.set(key, this.x.values.map(() => null));
      groups.get(key)[place.get(row[this.x.name])] = row;
    }
    this.all = groups;
  }

  groupOf(row) {
    return this.others.map(axis => axis.words(row[axis.name])).reverse().join(', ');
  }

  /** The groups to draw, by name: all, or where they are too many that of the chosen pose. */
  get groups() {
    const own = this.groupOf(this.rows[this.chosen]);
    return this.all.size <= mostGroups ? [...this.all] : [[own, this.all.get(own)]];
  }

  /** "15 deg", "snapshot 3, 15 deg". */
  name(row) {
    const shown = this.varying.length > 0 ? this.varying : axes.filter(axis => axis.name !== 'angle_deg' && typeof row[axis.name] === 'number');
    return shown.length === 0 ? row.angle_deg !== 0 ? axes[0].words(row.angle_deg) : 'the pose' : shown.map(axis => axis.words(row[axis.name])).reverse().join(', ');
  }

  xOf(pose) {
    return this.rows[pose]?.[this.x.name];
  }

  /** The pose at a place of the x axis, of the chosen pose's group. */
  at(index) {
    return this.rows.indexOf(this.all.get(this.groupOf(this.rows[this.chosen]))[index]);
  }

  choose(pose) {
    if (pose < 0 || pose === this.chosen) return;
    this.chosen = pose;
    for (const listener of this.listeners) listener(pose);
  }

  onChange(listener) {
    this.listeners.push(listener);
  }
}
