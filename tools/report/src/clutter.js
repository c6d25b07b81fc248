// The report of sea clutter: sigma0 and shapes of the texture beside published models.
import { byId, number, plural, seconds } from './text.js';
import { Poses } from './poses.js';
import { PoseTable } from './table.js';
import { chooseRow } from './rows.js';
import { dash, draw, pointsOf, stroke } from './charts.js';
import { settingsTable, showFacts } from './settings.js';

// The last one that varies is that of the charts.
const axes = [
  ['time_s', { plural: 'times', text: 'time {0} {1}', shown_unit: 's', shown_scale: 1 }],
  ['frequency_hz', { plural: 'frequencies', text: '{0} {1}', shown_unit: 'GHz', shown_scale: 1e9 }],
  ['azimuth_deg', { plural: 'azimuths', text: 'azimuth {0} {1}', shown_unit: 'deg', shown_scale: 1 }],
  ['grazing_deg', { plural: 'grazing angles', text: 'grazing {0} {1}', shown_unit: 'deg', shown_scale: 1 }]
];
const polarisations = ['vv', 'hh'];

let run, columns, poses;

/** @param {object} data The report's data. @returns what draws the charts again. */
export function showClutter(data) {
  ({ run } = data);
  columns = { ...run.columns };
  axes.forEach(([name, axis], order) => { columns[name] = { ...columns[name], axis: { ...axis, order, is_whole: false } }; });
  poses = new Poses(run.rows, columns, true);
  head();
  new PoseTable(poses, columns, 'row', 'clutter.csv');
  settingsTable(run, poses);
  byId('settings-note').hidden = true;
  chooseRow(poses, 'sigma0-others', row => `VV ${number(row.sigma0_vv_db, 4)}, HH ${number(row.sigma0_hh_db, 4)}, HV ${number(row.sigma0_hv_db, 4)} dB, ${number(100 * row.lit_fraction, 3)} % lit`);
  const paint = () => {
    for (const polarisation of polarisations) levels(polarisation);
    shapes();
  };
  paint();
  poses.onChange(paint);
  return paint;
}

function head() {
  const plan = poses.plan === '' ? '' : ` (${poses.plan})`, { settings } = run;
  byId('lead').textContent = `Sea clutter in ${plural(run.rows.length, 'row')}${plan}; traced ${run.started_utc?.replace('T', ' ').replace('Z', ' UTC') ?? ''} with Glint ${run.versions?.glint} on ${run.device?.name ?? 'an unknown device'}.`;
  byId('level-text').textContent = settings.level === 'physics' ? 'The level is that of the waves: no model scales it.'
    : `The level is scaled to the model ${settings.level}: the mean echo is the model's, only texture and lit fraction are those of the waves.`;
  showFacts([
    ['Rows', number(run.rows.length)],
    ['Level', settings.level],
    ['Sea state', number(settings.sea_state?.value, 2)],
    ['Clutter wind', `${number(settings.clutter_wind?.value, 3)} m/s`],
    ['Tile', `${number(settings.tile?.value)} m in facets of ${number(settings.facet?.value, 3)} m`],
    ['Cells', `${number(settings.cell_range?.value)} x ${number(settings.cell_across?.value)} m`],
    ['Frequency', poses.span('frequency_hz') ?? `${number(run.rows[0]?.frequency_hz / 1e9)} GHz`],
    ['Whole run', seconds(run.elapsed_ms ?? NaN)]
  ]);
}

const valuesOf = column => poses.line.map(row => row?.[column] ?? null);

// A curve with points, thin and broken for what is published.
function curve(column, label, colour, isOwn) {
  const values = valuesOf(column);
  return { label, values, stroke: stroke(colour), dash: isOwn ? [] : dash(2 * colour), width: isOwn ? 3 : 1.5, points: pointsOf(values, stroke(colour), isOwn ? 60 : 0, 6) };
}

function chart(id, series, yLabel, description, isLogarithmic) {
  const isGrazing = poses.x.name === 'grazing_deg';
  draw(byId(id), {
    x: poses.x, series: series.filter(({ values }) => values.some(value => value !== null)), yLabel, height: 380, description, isLogarithmic, isXLogarithmic: isGrazing && poses.x.values.length > 1,
    marked: () => poses.xOf(poses.chosen), onPick: index => poses.choose(poses.at(index))
  });
}

function levels(polarisation) {
  const name = polarisation.toUpperCase(), own = `sigma0_${polarisation}_db`;
  const models = Object.keys(columns).filter(column => column.endsWith(`_${polarisation}_db`) && column !== own);
  const series = [curve(own, 'Glint', 0, true), ...models.map((column, i) => curve(column, columns[column].title.replace(`, ${name}`, ''), i + 1, false))];
  chart(`sigma0-${polarisation}`, series, `sigma0 ${name}, dB`, `Sigma0 in decibels, ${name}, over ${poses.x.label}, with published models. The table below has the figures.`, false);
}

function shapes() {
  const series = polarisations.flatMap((polarisation, i) => [
    curve(`shape_${polarisation}`, polarisation.toUpperCase(), i, true), curve(`measured_shape_${polarisation}`, `${polarisation.toUpperCase()}, measured`, i + 2, false)
  ]);
  const has = series.some(({ values }) => values.some(value => value !== null));
  byId('shapes').hidden = !has;
  byId('shapes-text').textContent = has ? '' : 'There are too few cells in the tile for a shape.';
  if (has) chart('shapes', series, 'shape', `Shape of the texture over ${poses.x.label}, with the measured one. The table below has the figures.`, true);
}
