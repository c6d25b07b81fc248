// The report of cross sections.
import { byId, highestOf, levelText, make, number, plural, seconds } from './text.js';
import { chooseRow } from './rows.js';
import { Contributions } from './contributions.js';
import { Maps } from './doppler.js';
import { IsarImage } from './image.js';
import { HotSpots } from './hotspots.js';
import { Polar } from './polar.js';
import { Poses } from './poses.js';
import { Profiles } from './profiles.js';
import { PoseTable } from './table.js';
import { dash, diamonds, draw, edgeOf, maxSpan, pointsOf, squares, stroke } from './charts.js';
import { settingsTable, showFacts } from './settings.js';
import { theme } from './palette.js';
import { openView } from './view.js';

const polarisations = ['vv', 'hh', 'hv', 'vh'];

// The directions before the frequency: the last one that varies is that of the charts.
const axes = [
  ['frequency_hz', { plural: 'frequencies', text: '{0} {1}', shown_unit: 'GHz', shown_scale: 1e9 }],
  ['elevation_deg', { plural: 'elevations', text: 'elevation {0} {1}', shown_unit: 'deg', shown_scale: 1 }],
  ['azimuth_deg', { plural: 'azimuths', text: 'azimuth {0} {1}', shown_unit: 'deg', shown_scale: 1 }],
  ['receiver_elevation_deg', { plural: 'receivers', text: 'received at elevation {0} {1}', shown_unit: 'deg', shown_scale: 1 }],
  ['receiver_azimuth_deg', { plural: 'receivers', text: 'received at azimuth {0} {1}', shown_unit: 'deg', shown_scale: 1 }]
];

let run, echo, poses, present, charts;

/** @param {object} data The report's data. @returns what draws the charts again. */
export function showCrossSections(data) {
  ({ run, echo } = data);
  const { scene } = data, columns = { ...run.columns };
  axes.forEach(([name, axis], order) => {
    if (run.rows.some(row => typeof row[name] === 'number')) columns[name] = { ...columns[name], axis: { ...axis, order, is_whole: false } };
  });
  poses = new Poses(run.rows, columns, true);
  present = polarisations.filter(name => run.rows.some(row => typeof row[`${name}_re_m`] === 'number'));
  const strongest = strongestRow();
  poses.chosen = Math.max(0, scene?.pose ?? strongest);
  head(strongest);
  new PoseTable(poses, columns, echo ? 'direction' : 'row', echo ? 'profile.csv' : 'rcs.csv');
  settingsTable(run, poses);
  byId('settings-note').hidden = true;
  errors();
  chooseRow(poses, 'others', row => `${present.map(name => `${name.toUpperCase()} ${number(row[`${name}_dbsm`], 4)}`).join(', ')} dBsm, error ${number(row.integration_error_db, 2)} dB`);
  charts = echo ? [new Profiles(echo, poses)] : [];
  if (echo?.doppler) charts.push(new Maps(echo, poses));
  else byId('doppler-section')?.remove();
  if (echo?.image) charts.push(new IsarImage(echo, scene));
  else byId('image-section')?.remove();
  if (echo) nameForEcho();
  if (echo && poses.rows.length === 1) byId('levels-section').remove();
  else charts.push(new Levels());
  if (run.rows.some(row => row.contributions)) charts.push(new Contributions(run, poses, present));
  else byId('parts-section').remove();
  const paint = () => charts.forEach(chart => chart.draw());
  paint();
  poses.onChange(paint);
  showScene(data);
  return paint;
}

function nameForEcho() {
  document.querySelector('label[for=row]').textContent = 'Direction';
  byId('levels-heading').textContent = highestEcho();
  byId('levels-text').textContent = 'The bands of VV and HH are the largest standard error of the integration among the frequencies, not of physical optics.';
}

// Rows of an echo have the peaks of profiles.
const highestEcho = () => echo.doppler ? 'Highest echo of the first pulse' : 'Highest echo';

const levelsOf = row => present.map(name => row[`${name}_dbsm`]).filter(level => typeof level === 'number');

function strongestRow() {
  const level = row => highestOf(levelsOf(row));
  return run.rows.reduce((best, row, i) => best < 0 || level(row) > level(run.rows[best]) ? i : best, -1);
}

function head(strongest) {
  const plan = poses.plan === '' ? '' : ` (${poses.plan})`;
  byId('lead').textContent = `${echo?.image ? `An ISAR image of ${plural(poses.rows.length, poses.isTrack ? 'direction' : 'azimuth')}` : echo ? `Range profiles in ${plural(poses.rows.length, 'direction')}` : `Cross sections in ${plural(poses.rows.length, 'row')}`}${plan}; traced ${run.started_utc?.replace('T', ' ').replace('Z', ' UTC') ?? ''} with Glint ${run.versions?.glint} on ${run.device?.name ?? 'an unknown device'}.`;
  const unmet = run.rows.filter(row => row.tolerance_met === 0).length, outside = run.rows.filter(row => row.outside_physical_optics === 1).length;
  byId('warning').hidden = unmet + outside === 0;
  byId('warning').textContent = [
    unmet > 0 ? `${number(unmet)} of ${plural(run.rows.length, 'row')} did not meet the tolerance of ${number(run.settings.tolerance?.value)} dB (squares).` : '',
    outside > 0 ? `${number(outside)} of ${plural(run.rows.length, 'row')} lie outside physical optics: radar and receiver are too far apart (diamonds).` : ''
  ].filter(text => text).join(' ');
  const best = run.rows[strongest], levels = best ? levelsOf(best) : [];
  showFacts([
    [echo ? 'Directions' : 'Rows', number(run.rows.length)],
    [`${echo ? highestEcho() : 'Largest cross section'}${levels.length > 0 ? `, ${poses.name(best)}` : ''}`, levelText(highestOf(levels), 'dBsm')],
    ['Tolerance', `${number(run.settings.tolerance?.value)} dB`],
    ...echo ? [['Bandwidth', `${number(run.settings.bandwidth?.value / 1e6)} MHz`], ['Range bin', `${number(run.settings.range_resolution?.value, 4)} m`]] : [],
    [echo ? 'Middle of the band' : 'Frequency', poses.span('frequency_hz') ?? (best ? `${number(best.frequency_hz / 1e9)} GHz` : '-')],
    ['Triangles', number(run.scene?.triangles)],
    ['Whole run', seconds(run.elapsed_ms ?? NaN)]
  ]);
}

// Cross sections over the axis of the charts, around a centre too if it is a direction.
class Levels {
  constructor() {
    this.ticks = present.map(name => {
      const label = make('label'), tick = make('input', null, { type: 'checkbox' });
      tick.checked = ['vv', 'hh'].includes(name) || !present.some(other => ['vv', 'hh'].includes(other));
      tick.addEventListener('change', () => this.draw());
      label.append(tick, name.toUpperCase());
      byId('polarisations').append(label);
      return tick;
    });
    this.isAngle = poses.x.name !== 'frequency_hz';
    const isElevation = poses.x.name.endsWith('elevation_deg');
    if (this.isAngle) this.polar = new Polar(isElevation, index => poses.choose(poses.at(index)));
    else byId('polar').remove();
    byId('polar-text').textContent = !this.isAngle ? '' : isElevation ? 'Elevation grows upwards from the right.'
      : 'The polar chart is seen from above: azimuth 0, on the -Z side, is at the top, and azimuths grow clockwise.';
    const has = (column, value) => run.rows.some(row => row[column] === value);
    byId('marks-text').textContent = `${has('tolerance_met', 0) ? 'Squares mark rows that did not meet the tolerance.' : ''} ${has('outside_physical_optics', 1) ? 'Diamonds mark rows outside physical optics.' : ''}`;
  }

  draw() {
    const { line, x } = poses, curves = [], bands = [], around = [];
    const isUnmet = row => row?.tolerance_met === 0, isOutside = row => row?.outside_physical_optics === 1;
    const marks = [[isUnmet, 'tolerance not met', squares], [isOutside, 'outside physical optics', diamonds]].filter(([holds]) => line.some(holds));
    present.forEach((name, i) => {
      if (!this.ticks[i].checked) return;
      const values = line.map(row => row?.[`${name}_dbsm`] ?? null), label = name.toUpperCase();
      const error = row => row[['hv', 'vh'].includes(name) ? 'cross_integration_error_m' : 'integration_error_m'];
      const edge = sign => values.map((value, place) => typeof value === 'number' && typeof error(line[place]) === 'number' ? edgeOf(10 ** (value / 20), sign * error(line[place])) : null);
      for (const sign of [1, -1]) curves.push({ label: ' ', values: edge(sign), width: 0, stroke: stroke(i), points: { show: false } });
      bands.push({ series: [curves.length - 1, curves.length], fill: theme('--band') });
      curves.push({ label, values, stroke: stroke(i), dash: dash(2 * i), points: pointsOf(values, stroke(i), 60) });
      for (const [holds, words, paths] of marks)
        curves.push({
          label: curves.some(curve => curve.label === words) ? ' ' : words, values: values.map((value, place) => holds(line[place]) ? value : null), stroke: theme('--mark'), paths: () => null,
          points: { show: true, paths, width: 2, stroke: theme('--mark'), fill: 'transparent' }
        });
      around.push({ values, stroke: stroke(i), dash: dash(2 * i), marks: [{ holds: place => isUnmet(line[place]), stroke: theme('--mark') }, { holds: place => isOutside(line[place]), stroke: theme('--mark'), isDiamond: true }] });
    });
    const highest = around.flatMap(series => series.values.map((value, place) => [value, place])).filter(([value]) => value !== null).reduce((a, b) => b[0] > a[0] ? b : a, [-Infinity, 0]);
    const description = `${echo ? highestEcho() : 'Cross section'} in dBsm over ${x.label}${highest[0] > -Infinity ? `; the largest is ${number(highest[0], 4)} dBsm at ${poses.name(line[highest[1]])}` : ''}. The table below has the figures.`;
    draw(byId('levels'), {
      x, series: curves, bands, yLabel: `${echo ? 'highest echo' : 'cross section'}, dBsm`, maxSpan, description, height: 400,
      marked: () => poses.xOf(poses.chosen), onPick: index => poses.choose(poses.at(index))
    });
    this.polar?.draw({ angles: x.values, series: around, description, marked: () => poses.xOf(poses.chosen) });
  }
}

function showScene({ scene, no_scene: problem }) {
  byId('view-heading').textContent = echo ? 'The target' : 'Hot spots on the model';
  if (!scene) {
    byId('scene-text').textContent = `There is no 3-D view: ${problem}`;
    byId('view-part').hidden = true;
    return;
  }
  openView(renderer => new HotSpots(run, scene, poses, present, renderer));
}

function errors() {
  const rows = run.rows.filter(row => typeof row.integration_error_db === 'number');
  if (rows.length === 0) return;
  const worst = rows.reduce((a, b) => b.integration_error_db > a.integration_error_db ? b : a), coarse = highestOf(rows.map(row => row.coarse_area_share ?? 0));
  byId('error-text').textContent = `The standard error of the integration is ${number(worst.integration_error_db, 3)} dB at most, of the polarisation with the largest (${poses.name(worst)}); ${number(rows.filter(row => row.tolerance_met === 1).length)} of ${plural(rows.length, 'row')} met the tolerance of ${number(run.settings.tolerance?.value)} dB. `
    + `It is not the error of physical optics, which knows no creeping waves, no double diffraction and no tips.${coarse > 0 ? ` On ${number(100 * coarse, 3)} % of the area the facets are too coarse for the highest frequency.` : ''}`;
}
