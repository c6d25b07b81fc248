// Texts and numbers.

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

export function seconds(ms) {
  return ms >= 1000 ? `${number(ms / 1000, 3)} s` : `${number(ms, 3)} ms`;
}

/** "rays_received" as "Rays received". */
export function title(name) {
  const words = name.replace(/_(deg|m2|m|ms|db)$/, (whole, unit) => unit === 'db' ? ' in dB' : '').replaceAll('_', ' ');
  return words[0].toUpperCase() + words.slice(1);
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
