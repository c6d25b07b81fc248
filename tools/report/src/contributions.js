// What objects and bounces contribute: levels over the axis of the charts, and those of the chosen row.
import { byId, make, number } from './text.js';
import { dash, decibels, draw, maxSpan, pointsOf, stroke } from './charts.js';
import { theme } from './palette.js';

const mostLines = 6;

export class Contributions {
  constructor(run, poses, present) {
    [this.names, this.poses] = [run.scene.object_names ?? [], poses];
    for (const name of present) byId('parts-polarisation').append(make('option', name.toUpperCase(), { value: name }));
    for (const id of ['parts-by', 'parts-polarisation']) byId(id).addEventListener('change', () => this.draw());
  }

  nameOf(by, part) {
    if (by === 'objects') return part < 0 ? 'others' : this.names[part] ?? `object ${part}`;
    return part === 0 ? 'edges' : part === 1 ? '1 bounce' : `${part} bounces`;
  }

  draw() {
    const by = byId('parts-by').value, name = byId('parts-polarisation').value;
    const { poses } = this, { line, x } = poses, chosen = poses.rows[poses.chosen];
    const first = 1 + 2 * ['vv', 'hv', 'vh', 'hh'].indexOf(name);
    // Parts of a row by number: real and imaginary part.
    const partsOf = row => new Map((row?.contributions?.[by] ?? []).map(list => [list[0], [list[first], list[first + 1]]]));
    const level = amplitude => amplitude ? decibels(Math.hypot(...amplitude)) : null;
    const all = line.map(partsOf), strength = new Map();
    for (const parts of all) for (const [part, amplitude] of parts) strength.set(part, Math.max(strength.get(part) ?? -Infinity, level(amplitude) ?? -Infinity));
    const shown = [...strength.keys()].sort((a, b) => strength.get(b) - strength.get(a)).slice(0, mostLines);
    const curve = (label, values, colour, dashes) => ({ label, values, stroke: colour, dash: dashes, points: pointsOf(values, colour, 60, 4) });
    draw(byId('parts'), {
      x, yLabel: `${name.toUpperCase()}, dBsm`, maxSpan, height: 340,
      series: [
        { ...curve('whole', line.map(row => row?.[`${name}_dbsm`] ?? null), theme('--text'), []), width: 3 },
        ...shown.map((part, i) => curve(this.nameOf(by, part), all.map(parts => level(parts.get(part))), stroke(i), dash(i)))
      ],
      description: `Contributions by ${by === 'objects' ? 'object' : 'number of bounces'} over ${x.label}; the strongest is that of ${shown.length > 0 ? this.nameOf(by, shown[0]) : 'none'}. The table below has those of the chosen row.`,
      marked: () => poses.xOf(poses.chosen), onPick: index => poses.choose(poses.at(index))
    });
    byId('parts-text').textContent = `Amplitudes add up with their phases: parts may cancel, and one may exceed the whole. ${by === 'bounces' ? 'Edges are the fringe fields.' : 'An object has the currents on its surface and its edges.'}${strength.size > shown.length ? ` The chart has the strongest ${shown.length} of ${number(strength.size)} parts.` : ''} The table has ${poses.name(chosen)}.`;
    this.fill(by, partsOf(chosen), level, [chosen[`${name}_re_m`], chosen[`${name}_im_m`]]);
  }

  fill(by, parts, level, whole) {
    const line = (name, amplitude) => {
      const row = make('tr'), above = level(amplitude) === null || level(whole) === null ? null : level(amplitude) - level(whole);
      row.append(make('td', name), ...[level(amplitude), above, level(amplitude) === null ? null : Math.atan2(amplitude[1], amplitude[0]) * 180 / Math.PI].map(value => make('td', value === null ? '-' : value.toFixed(1))));
      return row;
    };
    const sorted = [...parts].sort(([, a], [, b]) => (level(b) ?? -Infinity) - (level(a) ?? -Infinity));
    byId('parts-table').tBodies[0].replaceChildren(line('whole', whole), ...sorted.map(([part, amplitude]) => line(this.nameOf(by, part), amplitude)));
  }
}
