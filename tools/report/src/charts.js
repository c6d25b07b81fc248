import uPlot from 'uplot';
import { lineSample, number } from './text.js';
import { seriesColours, theme } from './palette.js';

// Series of a sweep over snapshots and angles, distinguished by colour and dash.
const dashes = [[], [8, 4], [3, 3], [10, 3, 2, 3]];

export const stroke = i => {
  const colour = seriesColours[i % seriesColours.length];
  return colour.startsWith('--') ? theme(colour) : colour;
};
export const dash = i => dashes[Math.floor(i / 2) % dashes.length];

/** Decibels below the highest level that a chart shows: nulls have no end. */
export const maxSpan = 70;

/** The level of an amplitude or of nothing. */
export const decibels = amplitude => amplitude > 0 ? 20 * Math.log10(amplitude) : null;

/** The level of an amplitude with its error; a band down to nothing ends far below. */
export const edgeOf = (amplitude, error) => amplitude > 0 ? decibels(amplitude + error) ?? decibels(amplitude) - maxSpan : null;

// Of values without neighbours no line shows anything.
const isAlone = (values, place) => (values[place] ?? null) !== null && (values[place - 1] ?? null) === null && (values[place + 1] ?? null) === null;

/** The points of a curve: all of so many at most, else those that stand alone. */
export const pointsOf = (values, colour, most, size = 5) => ({
  show: values.length <= most, size, fill: colour, filter: (plot, series, isShown) => isShown ? null : [...values.keys()].filter(place => isAlone(values, place))
});

const wholeSteps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 1e4, 1e5, 1e6];

// Of a logarithmic scale the ends, and the values at which lines are labelled.
const logarithmic = (u, low, high) => low === null ? [1, 10] : uPlot.rangeLog(low, high, 10, false);
const isLabelled = value => [1, 2, 5].includes(Number((value / 10 ** Math.floor(Math.log10(value) + 1e-9)).toPrecision(6)));

function axis(label, size, isWhole = false, isLogarithmic = false) {
  const font = '12px system-ui, "Segoe UI", "Liberation Sans", sans-serif';
  return {
    label, size, font, labelFont: font, labelSize: 20, stroke: theme('--soft'),
    grid: { stroke: theme('--grid'), width: 1 }, ticks: { stroke: theme('--line'), width: 1 },
    ...isWhole ? { incrs: wholeSteps } : {},
    ...isLogarithmic ? { filter: (plot, splits) => splits.map(split => isLabelled(split) ? split : null) } : {},
    values: (plot, splits) => splits.map(split => split === null ? '' : number(split, 6))
  };
}

/**
 * A chart that fills its element and follows its width.
 * @param {HTMLElement} element
 * @param {object} what x: {label, values}, series: [{label, values, ...uPlot's}], bands, yLabel, height, maxSpan below the highest value, isLogarithmic and isXLogarithmic scales, marked(): x of the chosen pose, onPick(index, x)
 */
export function draw(element, what) {
  element.replaceChildren();
  const mark = plot => {
    const x = what.marked?.();
    if (x === undefined || x === null) return;
    const at = Math.round(plot.valToPos(x, 'x', true));
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = theme('--text');
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
    ctx.beginPath();
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  };
  const isSingle = what.x.values.length === 1;
  const plot = new uPlot({
    width: element.clientWidth || 600,
    height: what.height ?? 300,
    scales: {
      x: { time: false, distr: what.isXLogarithmic ? 3 : 1, range: what.isXLogarithmic ? logarithmic : what.xRange ?? (isSingle ? () => [what.x.values[0] - 1, what.x.values[0] + 1] : undefined) },
      y: { distr: what.isLogarithmic ? 3 : 1, range: what.isLogarithmic ? logarithmic : (u, low, high) => low === null ? [0, 1] : what.fromZero ? [0, high > 0 ? high * 1.08 : 1] : low === high ? [low - 1, high + 1] : uPlot.rangeNum(Math.max(low, high - (what.maxSpan ?? Infinity)), high, 0.08, true) }
    },
    axes: [axis(what.x.label, 46, what.x.isWhole, what.isXLogarithmic), axis(what.yLabel, 72, false, what.isLogarithmic)],
    series: [{ label: what.x.label, value: (u, value) => number(value) }, ...what.series.map(series => ({
      value: (u, value) => number(value), width: 2, ...series, values: undefined
    }))],
    bands: what.bands,
    cursor: { drag: { x: false, y: false } },
    hooks: { draw: [mark], ready: [u => u.over.addEventListener('click', () => u.cursor.idx !== null && what.onPick?.(u.cursor.idx))] }
  }, [what.x.values, ...what.series.map(series => series.values)], element);
  // Edges of a band have no name.
  plot.root.querySelectorAll('.u-series').forEach((row, i) => {
    row.hidden = row.querySelector('.u-label')?.textContent.trim() === '';
    const series = what.series[i - 1];
    if (series?.dash) row.querySelector('.u-marker').replaceWith(lineSample(series.stroke, series.dash));
  });
  plot.root.querySelectorAll('canvas').forEach(canvas => {
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', what.description);
  });
  const watch = new ResizeObserver(() => {
    if (!element.contains(plot.root)) watch.disconnect();
    else if (element.clientWidth > 0 && element.clientWidth !== plot.width) plot.setSize({ width: element.clientWidth, height: what.height ?? 300 });
  });
  watch.observe(element);
  return plot;
}

export const bars = () => uPlot.paths.bars({ size: [0.94, 60] });

const markers = outline => (plot, series, from, to) => {
  const path = new Path2D(), half = 5 * devicePixelRatio;
  for (let i = from; i <= to; i++) {
    const value = plot.data[series][i];
    if (value === null || value === undefined) continue;
    outline(path, plot.valToPos(plot.data[0][i], 'x', true), plot.valToPos(value, 'y', true), half);
  }
  return { stroke: path, fill: null, clip: null, flags: 3 };
};

/** Marks of single points, for a series' points.paths. */
export const squares = markers((path, x, y, half) => path.rect(x - half, y - half, 2 * half, 2 * half));
export const diamonds = markers((path, x, y, half) => {
  path.moveTo(x, y - 1.3 * half);
  for (const [across, up] of [[1.3, 0], [0, 1.3], [-1.3, 0], [0, -1.3]]) path.lineTo(x + across * half, y + up * half);
});
