import 'uplot/dist/uPlot.min.css';
import { byId } from './text.js';
import { showCrossSections } from './rcs.js';
import { showRun } from './run.js';

const data = JSON.parse(byId('data').textContent);
const { run } = data;
const name = (run.scene?.path ?? 'Built-in scene').split(/[\\/]/).pop().replace(/\.(unity|obj|stl)$/i, '');
const isOfRun = run.table === undefined, parts = isOfRun ? ['run'] : run.table === 'echo' ? ['rcs', 'echo'] : ['rcs'];
document.title = `${name} - Glint report`;
byId('title').textContent = name;
document.querySelectorAll('[data-for]').forEach(part => { if (!parts.includes(part.dataset.for)) part.remove(); });
const paint = isOfRun ? showRun(data) : showCrossSections(data);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
// The frame after the one in which everything is drawn.
requestAnimationFrame(() => requestAnimationFrame(() => { document.documentElement.dataset.ready = Math.round(performance.now()); }));
