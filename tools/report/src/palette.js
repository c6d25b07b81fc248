// Colours of segments and bounces: red, green, blue, yellow, as in the published experiment, in Okabe and Ito's shades for the colour-blind.
// The dashes (drawn, left out, in pixels) give the same information without colour.
const segments = [
  { colour: '#ee6a24', name: 'red', dash: null, pattern: 'solid' },
  { colour: '#00b083', name: 'green', dash: [14, 5], pattern: 'long dashes' },
  { colour: '#56b4e9', name: 'blue', dash: [6, 5], pattern: 'short dashes' },
  { colour: '#f0e442', name: 'yellow', dash: [2, 4], pattern: 'dots' }
];

/** n counts from 1; the colours repeat after four. */
export const ofSegment = n => segments[(n - 1) % segments.length];

// The palette of Okabe and Ito, with mint in place of black, which is invisible in the dark view. It repeats after eight
// objects.
const objects = ['#e69f00', '#56b4e9', '#009e73', '#cc79a7', '#0072b2', '#d55e00', '#f0e442', '#00eeaa'];

// Colours of the charts; names that begin with -- are variables of the style sheet, set for each theme.
export const seriesColours = ['--accent', '--mark', '#009e73', '#cc79a7', '#666677', '#7a5af8'];

// Hot spots from weak to strong, on the dark background of the view: ever lighter, so that greys tell them too.
export const hotStops = ['#4a2a7a', '#9c2e6a', '#dd513a', '#fca50a', '#fcffa4'];

/** A colour between the stops, 0 to 1. */
export function ofHeat(part) {
  const place = Math.min(1, Math.max(0, part)) * (hotStops.length - 1), first = Math.min(hotStops.length - 2, Math.floor(place));
  const [from, to] = [rgb(hotStops[first]), rgb(hotStops[first + 1])];
  return from.map((value, i) => value + (place - first) * (to[i] - value));
}

/** From 1. */
export const ofObject = n => objects[(n - 1) % objects.length];

export function rgb(colour) {
  return [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16));
}

/** A css variable of the theme. */
export const theme = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
