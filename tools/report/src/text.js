// Texts and numbers.

// Among levels of 16 bits: EchoReport.
const noEcho = -32768;

export const byId = id => document.getElementById(id);

export function make(tag, text, attributes = {}) {
  const element = document.createElement(tag);
  if (text !== undefined && text !== null) element.textContent = text;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

/** At most so many digits that matter; whole numbers with groups. */
export function number(value, digits = 5) {
  if (value === null || value === undefined) return '-';
  if (Number.isInteger(value)) return value.toLocaleString('en');
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-4) return value.toExponential(digits - 1).replace(/\.?0+e/, 'e').replace('e+', 'e');
  return String(Number(value.toPrecision(digits)));
}

/** Of no values -Infinity. Math.max(...values) overflows the stack with very many. */
export const highestOf = values => values.reduce((a, b) => Math.max(a, b), -Infinity);

/** Of no values Infinity. */
export const lowestOf = values => values.reduce((a, b) => Math.min(a, b), Infinity);

/** A level with its unit; null or -Infinity is no echo. */
export const levelText = (level, unit) => Number.isFinite(level) ? `${number(level, 4)} ${unit}` : 'no echo';

export function seconds(ms) {
  return ms >= 1000 ? `${number(ms / 1000, 3)} s` : `${number(ms, 3)} ms`;
}

/** "rays_received" as "Rays received". */
export function title(name) {
  const words = name.replace(/_(deg|m2|m|ms|db)$/, (whole, unit) => unit === 'db' ? ' in dB' : '').replaceAll('_', ' ');
  return words[0].toUpperCase() + words.slice(1);
}

/** Levels of an echo from base64 of 16 bits; the function gives that at a place in its unit, null where there is no echo. */
export function levelsFrom(base64) {
  const hundredths = new Int16Array(bytes(base64).buffer);
  return place => hundredths[place] === noEcho ? null : hundredths[place] / 100;
}

/** Bytes of a base64 text. */
export function bytes(base64) {
  const text = atob(base64);
  const all = new Uint8Array(text.length);
  for (let i = 0; i < all.length; i++) all[i] = text.charCodeAt(i);
  return all;
}

export function plural(count, noun) {
  return `${number(count)} ${noun}${count === 1 ? '' : 's'}`;
}

/** A piece of a line for a legend. @param {number[]} dash Drawn and left out, in pixels; empty: solid. */
export function lineSample(colour, dash) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('width', 44);
  svg.setAttribute('height', 14);
  svg.setAttribute('aria-hidden', 'true');
  svg.innerHTML = `<path d="M3 7H41" stroke="${colour}" stroke-width="2.5" stroke-dasharray="${dash.join(' ')}"/>`;
  return svg;
}
