// The rows, or the first of very many, sortable by any column.
import { byId, make, number } from './text.js';

const most = 5000;

export class PoseTable {
  constructor(poses, columns, file) {
    this.poses = poses;
    this.described = columns;
    // The angle is 0 in every row of a sweep without a turning target.
    const says = name => poses.rows.some(row => row[name] !== null && row[name] !== undefined && (name !== 'angle_deg' || row[name] !== 0) || columns[name].missing);
    this.columns = Object.keys(columns).filter(says);
    this.sorted = null;
    const head = make('tr');
    head.append(make('th', 'Pose', { scope: 'col' }));
    for (const name of this.columns) {
      const cell = make('th', null, { scope: 'col' });
      const button = make('button', columns[name].title, { type: 'button' });
      button.append(make('span', columns[name].unit === '1' ? '' : columns[name].unit, { class: 'unit' }));
      button.addEventListener('click', () => this.sort(name, cell));
      cell.append(button);
      head.append(cell);
    }
    byId('table').tHead.append(head);
    if (poses.rows.length > most)
      byId('table-note').textContent += ` Of ${number(poses.rows.length)} rows the first ${number(most)} are here; ${file} has all.`;
    this.rows = poses.rows.slice(0, most).map((row, pose) => this.make(row, pose));
    byId('table').tBodies[0].append(...this.rows);
    poses.onChange(() => this.mark());
    this.mark();
  }

  make(row, pose) {
    const line = make('tr');
    const button = make('button', pose + 1, { type: 'button', 'aria-label': `Choose pose ${pose + 1}, ${this.poses.name(row)}` });
    button.addEventListener('click', () => this.poses.choose(pose));
    const first = make('td');
    first.append(button);
    line.append(first);
    for (const name of this.columns)
      line.append(make('td', this.cell(name, row[name]), { title: row[name] ?? '' }));
    return line;
  }

  cell(name, value) {
    const { is_flag: isFlag, missing } = this.described[name];
    if (value === null || value === undefined) return missing ?? '-';
    return isFlag ? (value ? 'yes' : 'no') : number(value, 7);
  }

  sort(name, cell) {
    const down = this.sorted === name && cell.getAttribute('aria-sort') === 'ascending';
    this.sorted = name;
    for (const other of cell.parentNode.children) other.removeAttribute('aria-sort');
    cell.setAttribute('aria-sort', down ? 'descending' : 'ascending');
    const order = this.rows.map((row, pose) => pose).sort((a, b) => {
      const difference = (this.poses.rows[a][name] ?? -Infinity) - (this.poses.rows[b][name] ?? -Infinity);
      return (Number.isNaN(difference) ? 0 : down ? -difference : difference) || a - b;
    });
    byId('table').tBodies[0].append(...order.map(pose => this.rows[pose]));
  }

  mark() {
    this.rows.forEach((row, pose) => pose === this.poses.chosen ? row.setAttribute('aria-current', 'true') : row.removeAttribute('aria-current'));
  }
}
