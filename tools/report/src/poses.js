// The poses of a run and the chosen pose.
import { number } from './text.js';

// The fewest digits with which no two values look alike.
const digitsOf = values => [5, 6, 7, 8].find(digits => new Set(values.map(value => value.toPrecision(digits))).size === values.length) ?? 9;

const distinct = (rows, name) => [...new Set(rows.map(row => row[name]).filter(value => value !== null && value !== undefined))].sort((a, b) => a - b);

// The axes of a sweep, the fastest-changing first, with their distinct values and the unit of a chart's scale.
const axesOf = (columns, rows) => Object.entries(columns).filter(([, { axis }]) => axis).sort(([, a], [, b]) => b.axis.order - a.axis.order).map(([name, { title, axis }]) => {
  const values = distinct(rows, name), digits = digitsOf(values), figure = value => number(value / axis.shown_scale, digits);
  return {
    name, values, figure, label: axis.shown_unit === '1' ? title : `${title}, ${axis.shown_unit}`, unit: axis.shown_scale, isWhole: axis.is_whole, plural: axis.plural,
    words: value => axis.text.replace('{0}', figure(value)).replace('{1}', axis.shown_unit)
  };
});

const mostGroups = 8;

export class Poses {
  /** @param {object[]} rows @param {object} columns by name. @param {boolean} isOneLine Whether charts show the line of the chosen pose only. */
  constructor(rows, columns, isOneLine = false) {
    this.rows = rows;
    this.isOneLine = isOneLine;
    this.axes = axesOf(columns, rows);
    this.chosen = 0;
    this.listeners = [];
    this.varying = this.axes.filter(axis => axis.values.length > 1);
    const leader = this.leader();
    this.isTrack = leader !== undefined;
    const along = leader ?? this.gridAxis();
    this.x = { ...along, values: along.values.map(value => value / along.unit) };
    this.others = this.isTrack ? [] : this.varying.filter(axis => axis !== along);
    this.places = new Map(along.values.map((value, i) => [value, i]));
    this.numbers = new Map(rows.map((row, pose) => [row, pose]));
    // One list for each combination of the other axes, with a row or nothing for each x.
    this.all = new Map();
    for (const row of rows) {
      const key = this.groupOf(row);
      if (!this.all.has(key)) this.all.set(key, this.x.values.map(() => null));
      this.all.get(key)[this.places.get(row[this.x.name])] = row;
    }
  }

  // Of axes that change together, as on a track, the first that alone tells the rows apart.
  leader() {
    if (this.varying.length < 2) return undefined;
    const combinations = new Set(this.rows.map(row => this.varying.map(axis => row[axis.name]).join(' '))).size;
    return this.varying.find(axis => axis.values.length === combinations);
  }

  // The fastest-changing axis, or one with which the charts can show all poses.
  gridAxis() {
    const [first] = this.varying.length > 0 ? this.varying : this.axes;
    const lines = axis => this.varying.reduce((product, other) => other === axis ? product : product * other.values.length, 1);
    return this.isOneLine || lines(first) <= mostGroups ? first : this.varying.find(axis => lines(axis) <= mostGroups) ?? first;
  }

  groupOf(row) {
    return this.others.map(axis => axis.words(row[axis.name])).reverse().join(', ');
  }

  /** "12 angles, 2 frequencies" of a sweep over more than one axis. */
  get plan() {
    return this.others.length === 0 ? '' : this.varying.map(axis => `${number(axis.values.length)} ${axis.plural}`).join(', ');
  }

  /** Of an axis that the sweep steps through, "9 GHz to 10 GHz"; null of another. */
  span(name) {
    const axis = this.varying.find(axis => axis.name === name);
    return axis ? `${axis.words(axis.values[0])} to ${axis.words(axis.values.at(-1))}` : null;
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

  /** The place of the chosen pose on the x axis. */
  get place() {
    return this.places.get(this.rows[this.chosen][this.x.name]);
  }

  /** The number of a row; -1 of nothing. */
  numberOf(row) {
    return this.numbers.get(row) ?? -1;
  }

  /** The pose at a place of the x axis, of the chosen pose's group. */
  at(index) {
    return this.numberOf(this.line[index]);
  }

  /** Of the poses with a value of an axis, that with most of the chosen pose's other values, and of those the nearest along x. */
  nearest(name, value) {
    const chosen = this.rows[this.chosen];
    const changes = row => this.others.filter(axis => row[axis.name] !== chosen[axis.name]).length, away = row => Math.abs(row[this.x.name] - chosen[this.x.name]);
    const isNearer = (row, best) => changes(row) < changes(best) || changes(row) === changes(best) && away(row) < away(best);
    return this.numberOf(this.rows.filter(row => row[name] === value).reduce((best, row) => isNearer(row, best) ? row : best));
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
