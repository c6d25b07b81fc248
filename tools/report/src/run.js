// The report of a run or sweep.
import { byId, number, plural, seconds } from './text.js';
import { Picture } from './picture.js';
import { Poses } from './poses.js';
import { PoseTable } from './table.js';
import { SweepCharts } from './sweep.js';
import { View, openView } from './view.js';
import { drawPhases } from './phase.js';
import { fillTable, settingsTable, showFacts } from './settings.js';

let data, run, scene, columns, poses, strongest, charts;
// In decibels, of a run by ray tubes, which keeps no single rays and no phases; else undefined.
let tolerance;

/** @param {object} report The report's data. @returns what draws the charts again. */
export function showRun(report) {
  data = report;
  ({ run, scene } = data);
  ({ columns } = run);
  tolerance = run.settings.tolerance?.value;
  poses = new Poses(run.rows, columns);
  strongest = poses.rows.length === 0 ? -1 : poses.rows.reduce((best, row, i) => row.amplitude > poses.rows[best].amplitude ? i : best, 0);
  poses.chosen = Math.max(0, scene?.pose ?? strongest);
  head();
  charts = new SweepCharts(poses, columns, tolerance === undefined ? 'not to be trusted' : 'tolerance not met');
  new PoseTable(poses, columns, 'pose', 'results.csv');
  if (tolerance !== undefined) {
    byId('phase-section').remove();
    byId('squares-text').textContent = 'Squares mark poses that did not meet the tolerance.';
  }
  settingsTable(run, poses);
  timings();
  errors();
  choosePose();
  paint();
  showScene();
  return paint;
}

function head() {
  const plan = poses.plan === '' ? '' : ` (${poses.plan})`, turned = poses.span('angle_deg') !== null && run.scene?.target ? `, ${run.scene.target} turned` : '';
  byId('lead').textContent = `${plural(poses.rows.length, 'pose')}${plan}${turned}; traced ${run.started_utc?.replace('T', ' ').replace('Z', ' UTC') ?? ''} with Glint ${run.versions?.glint} on ${run.device?.name ?? 'an unknown device'}.`;
  const doubtful = poses.rows.filter(row => row.undersampled === 1).length;
  byId('warning').hidden = doubtful === 0;
  const where = poses.rows.length === 1 ? 'The' : `In ${number(doubtful)} of ${plural(poses.rows.length, 'pose')} the`;
  byId('warning').textContent = tolerance !== undefined ? `${where} tolerance of ${number(tolerance)} dB is not met: ask for a larger tolerance.`
    : `${where} rays are too far apart, or too few return, for amplitude and error to be trusted: trace more rays or a narrower view.`;
  const best = poses.rows[strongest];
  const facts = [
    ...poses.rows.length === 1 ? [
      ['Amplitude', `${number(best.amplitude)}${typeof best.amplitude_db === 'number' ? ` (${number(best.amplitude_db, 4)} dB)` : ''}`],
      ['As if 2,073,600 rays', `${number(best.amplitude_normalised)}${isEstimated(best) ? ` ± ${number(best.sampling_error, 3)}` : `, error ${columns.sampling_error.missing}`}`],
      ['Rays received', number(best.rays_received)], ['Rays hit', number(best.rays_hit)], ['Rays', number(best.rays_emitted)]
    ] : [
      ['Poses', number(poses.rows.length)],
      [best ? `Largest amplitude, ${poses.name(best)}` : 'Amplitude', best ? number(best.amplitude) : '-'],
      ['Rays a pose', number(best?.rays_emitted)]
    ],
    ['Frequency', poses.span('frequency_hz') ?? `${number((run.settings.frequency?.value ?? NaN) / 1e9)} GHz`],
    ['Triangles', number(run.scene?.triangles)],
    ['Whole run', seconds(run.elapsed_ms ?? NaN)]
  ];
  showFacts(facts);
}

function choosePose() {
  const slider = byId('pose');
  slider.max = Math.max(0, poses.rows.length - 1);
  // A chart of one point is useless.
  byId('sweep').hidden = poses.rows.length < 2;
  byId('left-out').textContent = poses.leftOut;
  slider.addEventListener('input', () => poses.choose(Number(slider.value)));
  const show = () => {
    const row = poses.rows[poses.chosen];
    if (!row) return;
    const words = `${poses.name(row)}: amplitude ${number(row.amplitude)}, ${plural(row.rays_received, 'ray')} received`;
    slider.value = poses.chosen;
    slider.setAttribute('aria-valuetext', words);
    byId('pose-text').textContent = words;
  };
  show();
  poses.onChange(() => {
    show();
    charts.redraw();
    paintPhases();
  });
}

function paint() {
  if (poses.rows.length > 1) charts.draw();
  paintPhases();
}

function paintPhases() {
  if (tolerance === undefined) drawPhases(poses);
}

function showScene() {
  if (!scene) {
    byId('scene-text').textContent = `There is no 3-D view: ${data.no_scene}`;
    byId('view-part').hidden = true;
    byId('picture-section').hidden = true;
    return;
  }
  const row = poses.rows[scene.pose], what = capital(poses.name(row));
  const { received, counts } = scene.paths;
  const found = tolerance === undefined ? received === 0 ? 'no ray' : plural(received, 'ray') : `of one ray a pixel ${received === 0 ? 'none is' : received === 1 ? '1 is' : `${number(received)} are`}`;
  const rays = `${found} received${counts.length < received ? `, of which ${number(counts.length)}, evenly selected, can be drawn` : ''}`;
  const hits = tolerance === undefined ? `, of ${number(row.rays_hit)} that hit` : '; the ray tubes of the amplitude are not drawn';
  const coarse = scene.drawn < scene.triangles ? ` Of ${number(scene.triangles)} triangles the view has ${number(scene.drawn)}: surfaces are drawn coarser than traced, and rays may end beside them.` : '';
  const changed = scene.received !== row.rays_received || Math.abs(scene.amplitude - row.amplitude) > 1e-3 * Math.max(1, row.amplitude)
    ? ` The scene has changed since the run, which received ${plural(row.rays_received, 'ray')} with amplitude ${number(row.amplitude)}.` : '';
  byId('scene-text').textContent = `${what}: ${rays}${hits}. The purple lines are the receiver and the edges of the radar's view.${coarse}${changed}`;
  if (scene.picture) new Picture(scene.picture, what);
  else byId('picture-section').hidden = true;
  byId('view').setAttribute('aria-label', `The scene in 3-D with ${plural(scene.paths.counts.length, 'ray')}.`);
  openView(renderer => new View(scene, renderer));
}

function timings() {
  const sum = run.timings ?? {}, count = Math.max(1, poses.rows.length);
  const traces = poses.rows.map(row => row.trace_ms).sort((a, b) => a - b);
  fillTable('timings', [
    ['Whole run', seconds(run.elapsed_ms ?? NaN)],
    ...[['gather_ms', 'Gathering the scene'], ['build_ms', 'Building trees'], ['upload_ms', 'Upload'], ['trace_ms', 'Tracing'], ['read_back_ms', 'Reading back single rays']].map(([key, what]) =>
      [what, `${seconds(sum[key] ?? 0)} in all, ${seconds((sum[key] ?? 0) / count)} a pose`]),
    ['Tracing, median of the poses', traces.length > 0 ? seconds(traces[traces.length >> 1]) : null]
  ]);
}

function errors() {
  const rows = poses.rows.filter(row => row.rays_received > 0);
  if (rows.length === 0) {
    byId('error-text').textContent = 'No rays were received, so the error cannot be estimated.';
    return;
  }
  const estimated = rows.filter(isEstimated);
  if (estimated.length === 0) {
    byId('error-text').textContent = `The sampling error was ${columns.sampling_error.missing}: the run left it out.`;
    return;
  }
  const worst = estimated.reduce((a, b) => b.sampling_error > a.sampling_error ? b : a);
  const most = `${number(worst.sampling_error, 3)} at most (${poses.name(worst)}, amplitude ${number(worst.amplitude_normalised)})`;
  if (tolerance !== undefined) {
    const met = estimated.filter(row => row.undersampled === 0).length;
    byId('error-text').textContent = `The standard error of the integration over ray tubes is ${most}; ${number(met)} of ${plural(estimated.length, 'pose')} met the tolerance of ${number(tolerance)} dB. The error covers the integration alone: surfaces are perfect mirrors, and diffraction is not included.`;
    return;
  }
  const step = estimated.reduce((a, b) => b.largest_path_step_wavelengths > a.largest_path_step_wavelengths ? b : a);
  byId('error-text').textContent = `The sampling error, the difference from infinitely many rays, is estimated to be ${most}. `
    + `Neighbouring received rays differ in length by ${number(step.largest_path_step_wavelengths, 3)} wavelengths at most (${poses.name(step)}). The estimate covers only the rays' spacing: surfaces are perfect mirrors, and diffraction is not included.`;
}

function isEstimated(row) {
  return typeof row.sampling_error === 'number';
}

function capital(text) {
  return text[0].toUpperCase() + text.slice(1);
}
