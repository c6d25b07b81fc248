// The poses of a run and the chosen pose.
import { number } from './text.js';

// The axes of a sweep, the fastest-changing first, with the unit of a chart's scale.
const axesOf = columns => Object.entries(columns).filter(([, { axis }]) => axis).sort(([, a], [, b]) => b.axis.order - a.axis.order).map(([name, { title, axis }]) => ({
  name, label: axis.shown_unit === '1' ? title : `${title}, ${axis.shown_unit}`, unit: axis.shown_scale, isWhole: axis.is_whole, plural: axis.plural,
  words: value => axis.text.replace('{0}', number(value / axis.shown_scale, 9)).replace('{1}', axis.shown_unit)
}));

const mostGroups = 8;

export class Poses {
  /** @param {object[]} rows @param {object} columns by name. @param {boolean} isOneLine Whether charts show the line of the chosen pose only. */
  constructor(rows, columns, isOneLine = false) {
    this.rows = rows;
    this.isOneLine = isOneLine;
    this.axes = axesOf(columns);
    this.chosen = 0;
    this.listeners = [];
    const distinct = name => [...new Set(rows.map(row => row[name]).filter(value => value !== null && value !== undefined))];
    this.varying = this.axes.filter(axis => distinct(axis.name).length > 1);
    this.counts = this.varying.map(axis => [distinct(axis.name).length, axis]);
    const [first] = this.varying.length > 0 ? this.varying : this.axes;
    // The fastest-changing axis, or one with which the charts can show all poses.
    const lines = axis => this.counts.reduce((product, [count, other]) => other === axis ? product : product * count, 1);
    const along = isOneLine || lines(first) <= mostGroups ? first : this.varying.find(axis => lines(axis) <= mostGroups) ?? first;
    const steps = distinct(along.name).sort((a, b) => a - b);
    this.x = { ...along, values: steps.map(value => value / along.unit) };
    this.others = this.varying.filter(axis => axis !== along);
    const place = new Map(steps.map((value, i) => [value, i]));
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

  /** "12 angles, 2 frequencies" of a sweep over more than one axis. */
  get plan() {
    return this.counts.length < 2 ? '' : this.counts.map(([count, axis]) => `${number(count)} ${axis.plural}`).join(', ');
  }

  /** Of an axis that the sweep steps through, "9 GHz to 10 GHz"; null of another. */
  span(name) {
    const axis = this.varying.find(axis => axis.name === name);
    const values = this.rows.map(row => row[name]);
    return axis ? `${axis.words(values.reduce((a, b) => Math.min(a, b)))} to ${axis.words(values.reduce((a, b) => Math.max(a, b)))}` : null;
  }

  /** Why the charts leave poses out; empty when they have all. */
  get leftOut() {
    return this.all.size <= mostGroups ? '' : `Of ${number(this.all.size)} lines the charts show that of the chosen pose.`;
  }

  /** The groups to draw, by name: all, or where they are too many that of the chosen pose. */
  get groups() {
    const own = this.groupOf(this.rows[this.chosen]);
    return !this.isOneLine && this.all.size <= mostGroups ? [...this.all] : [[own, this.all.get(own)]];
  }

  /** "15 deg", "snapshot 3, 15 deg". */
  name(row) {
    const shown = this.varying.length > 0 ? this.varying : this.axes.filter(axis => axis.name !== 'angle_deg' && typeof row[axis.name] === 'number');
    return shown.length === 0 ? row.angle_deg !== 0 ? this.axes[0].words(row.angle_deg) : 'the pose' : shown.map(axis => axis.words(row[axis.name])).reverse().join(', ');
  }

  xOf(pose) {
    const value = this.rows[pose]?.[this.x.name];
    return typeof value === 'number' ? value / this.x.unit : value;
  }

  /** The rows of the chosen pose's line, by place of the x axis. */
  get line() {
    return this.all.get(this.groupOf(this.rows[this.chosen]));
  }

  /** The pose at a place of the x axis, of the chosen pose's group. */
  at(index) {
    return this.rows.indexOf(this.line[index]);
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
