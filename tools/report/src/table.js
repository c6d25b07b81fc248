// The rows, or the first of a great many, to be sorted by any column.
import { byId, make, number, title } from './text.js';

const most = 5000;

export class PoseTable {
  constructor(poses, units) {
    this.poses = poses;
    // The angle is 0 in every row where nothing was turned.
    const says = name => poses.rows.some(row => row[name] !== null && row[name] !== undefined && (name !== 'angle_deg' || row[name] !== 0));
    this.columns = Object.keys(units).filter(says);
    this.sorted = null;
    const head = make('tr');
    head.append(make('th', 'Pose', { scope: 'col' }));
    for (const name of this.columns) {
      const cell = make('th', null, { scope: 'col' });
      const button = make('button', title(name), { type: 'button' });
      button.append(make('span', units[name] === '1' ? '' : units[name], { class: 'unit' }));
      button.addEventListener('click', () => this.sort(name, cell));
      cell.append(button);
      head.append(cell);
    }
    byId('table').tHead.append(head);
    if (poses.rows.length > most)
      byId('table-note').textContent += ` Of ${number(poses.rows.length)} rows the first ${number(most)} are here; results.csv has all.`;
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
      line.append(make('td', name === 'undersampled' ? (row[name] ? 'yes' : 'no') : number(row[name], 7), { title: row[name] ?? '' }));
    return line;
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
