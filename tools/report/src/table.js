// The rows, sortable by any column; of very many as many as are wanted.
import { byId, make, number } from './text.js';

const step = 300;

export class PoseTable {
  /** @param {string} noun What a row is. @param {string} file The file with all rows. */
  constructor(poses, columns, noun, file) {
    [this.poses, this.described, this.noun, this.file] = [poses, columns, noun, file];
    // The angle is 0 in every row of a sweep without a turning target.
    const says = name => poses.rows.some(row => row[name] !== null && row[name] !== undefined && (name !== 'angle_deg' || row[name] !== 0) || columns[name].missing);
    this.columns = Object.keys(columns).filter(says);
    const head = make('tr');
    head.append(this.heading(noun[0].toUpperCase() + noun.slice(1), '', (row, pose) => pose));
    for (const name of this.columns) head.append(this.heading(columns[name].title, columns[name].unit === '1' ? '' : columns[name].unit, row => row[name] ?? -Infinity));
    byId('table').tHead.append(head);
    byId('table-more').addEventListener('click', () => this.show(this.lines.size + step));
    poses.onChange(() => this.mark());
    this.order = poses.rows.map((row, pose) => pose);
    this.show(step);
  }

  heading(title, unit, valueOf) {
    const cell = make('th', null, { scope: 'col' }), button = make('button', title, { type: 'button' });
    button.append(make('span', unit, { class: 'unit' }));
    button.addEventListener('click', () => this.sort(cell, valueOf));
    cell.append(button);
    return cell;
  }

  sort(cell, valueOf) {
    const isDown = cell.getAttribute('aria-sort') === 'ascending';
    for (const other of cell.parentNode.children) other.removeAttribute('aria-sort');
    cell.setAttribute('aria-sort', isDown ? 'descending' : 'ascending');
    const values = this.poses.rows.map(valueOf);
    this.order.sort((a, b) => (values[a] === values[b] ? 0 : (values[a] < values[b]) === isDown ? 1 : -1) || a - b);
    this.show(step);
  }

  /** Shows the first rows of the order. */
  show(most) {
    const { rows } = this.poses, shown = this.order.slice(0, most);
    this.lines = new Map(shown.map(pose => [pose, this.make(rows[pose], pose)]));
    byId('table').tBodies[0].replaceChildren(...this.lines.values());
    byId('table-more').hidden = shown.length === rows.length;
    byId('table-shown').textContent = shown.length === rows.length ? '' : `${number(shown.length)} of ${number(rows.length)} rows are shown; headings sort all. ${this.file} has all.`;
    this.mark();
  }

  make(row, pose) {
    const line = make('tr');
    const button = make('button', pose + 1, { type: 'button', 'aria-label': `Choose ${this.noun} ${pose + 1}, ${this.poses.name(row)}` });
    button.addEventListener('click', () => this.poses.choose(pose));
    const first = make('td');
    first.append(button);
    line.append(first, ...this.columns.map(name => make('td', this.cell(name, row[name]))));
    return line;
  }

  cell(name, value) {
    const { is_flag: isFlag, missing } = this.described[name];
    if (value === null || value === undefined) return missing ?? '-';
    return isFlag ? (value ? 'yes' : 'no') : number(value, 7);
  }

  mark() {
    this.marked?.removeAttribute('aria-current');
    this.marked = this.lines.get(this.poses.chosen);
    this.marked?.setAttribute('aria-current', 'true');
  }
}
