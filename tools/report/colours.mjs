// Distance of the colours of a list: the smallest CIE76 distance in CIELAB between two of them, for full colour vision and for the three kinds of dichromats.
// The matrices, for linear sRGB, are those of Machado, Oliveira and Fernandes (2009), "A Physiologically-based Model for Simulation of Color Vision Deficiency", at severity 1.
const visions = {
  'full colour vision': [1, 0, 0, 0, 1, 0, 0, 0, 1],
  protanopia: [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998],
  deuteranopia: [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881],
  tritanopia: [1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900]
};
const toXyz = [0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505]; // sRGB, D65

const times = (m, [x, y, z]) => [0, 3, 6].map(row => m[row] * x + m[row + 1] * y + m[row + 2] * z);
const linear = part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;

function lab(colour, vision) {
  const seen = times(vision, [1, 3, 5].map(at => linear(parseInt(colour.slice(at, at + 2), 16) / 255))).map(part => Math.min(1, Math.max(0, part)));
  const [x, y, z] = times(toXyz, seen).map((part, i) => part / [0.9505, 1, 1.089][i]).map(t => t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** @returns {{vision: string, distance: number, pair: string}[]} For each kind of vision the two colours that look most alike. */
export function closest(colours) {
  return Object.entries(visions).map(([vision, matrix]) => {
    const seen = colours.map(colour => lab(colour, matrix));
    const pairs = seen.flatMap((a, i) => seen.slice(0, i).map((b, j) => ({ vision, distance: Math.hypot(...a.map((part, k) => part - b[k])), pair: `${colours[j]} and ${colours[i]}` })));
    return pairs.reduce((best, pair) => pair.distance < best.distance ? pair : best);
  });
}
