// The row that a report of rows shows: a slider, and a list for each axis that is not that of the charts.
import { byId, make, number } from './text.js';

/** @param {object} poses @param {string} others Name of the element of the lists. @param {(row: object) => string} figures The figures of a row, in words. */
export function chooseRow(poses, others, figures) {
  const slider = byId('row');
  slider.max = Math.max(0, poses.rows.length - 1);
  slider.addEventListener('input', () => poses.choose(Number(slider.value)));
  const selects = poses.others.map(axis => {
    const label = make('label', axis.label), select = make('select');
    for (const value of [...new Set(poses.rows.map(row => row[axis.name]))].sort((a, b) => a - b)) select.append(make('option', number(value / axis.unit, 9), { value }));
    select.addEventListener('change', () => {
      const wanted = { ...poses.rows[poses.chosen], [axis.name]: Number(select.value) };
      poses.choose(poses.rows.findIndex(row => [poses.x, ...poses.others].every(({ name }) => row[name] === wanted[name])));
    });
    label.append(select);
    byId(others).append(label);
    return [axis, select];
  });
  const show = () => {
    const row = poses.rows[poses.chosen];
    if (!row) return;
    const words = `${poses.name(row)}: ${figures(row)}`;
    slider.value = poses.chosen;
    slider.setAttribute('aria-valuetext', words);
    byId('row-text').textContent = words;
    for (const [axis, select] of selects) select.value = row[axis.name];
  };
  show();
  poses.onChange(show);
}
