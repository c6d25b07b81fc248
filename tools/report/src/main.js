import 'uplot/dist/uPlot.min.css';
import { byId } from './text.js';
import { showClutter } from './clutter.js';
import { showCrossSections } from './rcs.js';
import { showRun } from './run.js';
import { showScreen } from './screen.js';

const data = JSON.parse(byId('data').textContent);
const { run } = data;
const name = (run.scene?.path || 'Untitled').split(/[\\/]/).pop().replace(/\.(unity|obj|stl)$/i, '');
// The parts of the page of each table of results; without a table it is a run or sweep.
const { parts, show } = {
  run: { parts: ['run'], show: showRun }, rcs: { parts: ['rcs'], show: showCrossSections },
  echo: { parts: ['rcs', 'echo'], show: showCrossSections }, clutter: { parts: ['clutter'], show: showClutter },
  ppi: { parts: ['screen'], show: showScreen }
}[run.table ?? 'run'];
document.title = `${name} - Glint report`;
byId('title').textContent = name;
document.querySelectorAll('[data-for]').forEach(part => { if (!part.dataset.for.split(' ').some(name => parts.includes(name))) part.remove(); });
const paint = show(data);
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
// On paper charts have the width of a page and light colours, and the table is small enough to be whole.
const print = isPrinted => {
  document.documentElement.classList.toggle('print', isPrinted);
  const table = byId('table');
  if (table) {
    table.style.zoom = 1;
    if (isPrinted) table.style.zoom = Math.min(1, table.parentNode.clientWidth / table.scrollWidth);
  }
  paint();
};
addEventListener('beforeprint', () => print(true));
addEventListener('afterprint', () => print(false));
// The frame after the one in which everything is drawn.
requestAnimationFrame(() => requestAnimationFrame(() => { document.documentElement.dataset.ready = Math.round(performance.now()); }));
