// The histogram of phases of the chosen pose.
import { byId, highestOf, number, plural } from './text.js';
import { bars, draw } from './charts.js';
import { theme } from './palette.js';

export function drawPhases(poses) {
  const row = poses.rows[poses.chosen];
  const bins = row?.phase_histogram;
  const element = byId('phase');
  if (!bins || !row.rays_received) {
    byId('phase-text').textContent = row ? `${capital(poses.name(row))}: no ray was received.` : 'There are no poses.';
    element.replaceChildren();
    element.hidden = true;
    return;
  }
  element.hidden = false;
  const width = 360 / bins.length, most = highestOf(bins);
  byId('phase-text').textContent = `${capital(poses.name(row))}: ${plural(row.rays_received, 'ray')} in bins of ${number(width)} degrees. Rays of like phase add up; spread evenly over all phases they cancel.`;
  draw(element, {
    height: 240, x: { label: 'phase in degrees', values: bins.map((bin, i) => (i + 0.5) * width) }, xRange: () => [0, 360],
    series: [{ label: 'rays', values: bins, paths: bars(), fill: theme('--accent'), stroke: theme('--accent'), width: 0, points: { show: false } }],
    yLabel: 'rays', fromZero: true,
    description: `Phases of ${number(row.rays_received)} received rays; most, ${number(most)}, are near ${number((bins.indexOf(most) + 0.5) * width)} degrees.`
  });
}

const capital = text => text[0].toUpperCase() + text.slice(1);
