// The row that a report of rows shows: a slider, and a list for each axis that is not that of the charts.
import { byId, make } from './text.js';

/** @param {object} poses @param {string} others Name of the element of the lists. @param {(row: object) => string} figures The figures of a row, in words. */
export function chooseRow(poses, others, figures) {
  const slider = byId('row');
  slider.max = Math.max(0, poses.rows.length - 1);
  slider.addEventListener('input', () => poses.choose(Number(slider.value)));
  const selects = poses.others.map(axis => {
    const label = make('label', axis.label), select = make('select');
    for (const value of axis.values) select.append(make('option', axis.figure(value), { value }));
    select.addEventListener('change', () => poses.choose(poses.nearest(axis.name, Number(select.value))));
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
