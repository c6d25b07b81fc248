// The radar's view: colours give the number of bounces, or the first object hit; received rays are striped white.
import { byId, bytes, make, number } from './text.js';
import { ofObject, ofSegment, rgb } from './palette.js';

const received = 128, mostShown = 12;
const nothing = '#10161c';

export class Picture {
  constructor(picture, poseName) {
    this.picture = picture;
    this.bounces = bytes(picture.bounces);
    this.facing = bytes(picture.facing);
    this.objects = bytes(picture.objects);
    this.canvas = byId('picture');
    [this.canvas.width, this.canvas.height] = [picture.width, picture.height];
    this.counts = countsOf([...this.bounces].map(pixel => pixel % received));
    this.seen = countsOf(this.objects);
    const kinds = [...this.counts.keys()].sort((a, b) => a - b);
    this.received = this.bounces.filter(pixel => pixel >= received).length;
    const part = picture.width < picture.across || picture.height < picture.down ? `the part of the picture with hits, ${number(100 * picture.width / picture.across, 3)} % of its width and ${number(100 * picture.height / picture.down, 3)} % of its height, ` : '';
    byId('picture-text').textContent = `${poseName}: ${part}${picture.width} x ${picture.height} pixels with a ray each. Colour shows the number of reflections or the first object hit, brightness the angle of incidence on it; white stripes mark rays that reach the receiver.`;
    this.canvas.setAttribute('aria-label', `The radar's view. ${kinds.map(kind => `${words(kind)}: ${number(100 * this.counts.get(kind) / this.bounces.length, 3)} %`).join(', ')} of the pixels; ${this.received} are received.`);

    const filter = byId('picture-filter');
    filter.append(make('option', 'all rays', { value: 'all' }), make('option', 'received rays', { value: 'received' }));
    for (const kind of kinds.filter(kind => kind > 0)) filter.append(make('option', `rays with ${words(kind)}`, { value: `bounces ${kind}` }));
    for (const object of this.largest()) filter.append(make('option', `rays that meet ${this.nameOf(object)} first`, { value: `object ${object}` }));
    for (const id of ['picture-filter', 'picture-colours']) byId(id).addEventListener('change', () => this.draw());
    this.canvas.addEventListener('pointermove', event => this.tell(event));
    this.draw();
  }

  nameOf(object) { return object === 0 ? 'nothing' : this.picture.names[object - 1]; }

  // Objects by their number of pixels.
  largest() { return [...this.seen.keys()].filter(object => object > 0).sort((a, b) => this.seen.get(b) - this.seen.get(a)).slice(0, mostShown); }

  colourOf(place, byObject) {
    const kind = this.bounces[place] % received;
    return kind === 0 ? nothing : byObject ? ofObject(this.objects[place] || 1) : ofSegment(kind).colour;
  }

  isShown(place, filter) {
    if (filter === 'all') return true;
    if (filter === 'received') return this.bounces[place] >= received;
    const [what, number] = filter.split(' ');
    return Number(number) === (what === 'object' ? this.objects[place] : this.bounces[place] % received);
  }

  draw() {
    const { width, height } = this.picture;
    const context = this.canvas.getContext('2d');
    const image = context.createImageData(width, height);
    const filter = byId('picture-filter').value, byObject = byId('picture-colours').value === 'objects';
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++) {
        const from = (height - 1 - y) * width + x, to = 4 * (y * width + x);
        const meets = this.bounces[from] % received > 0;
        let colour = rgb(this.colourOf(from, byObject)).map(part => meets ? part * (0.3 + 0.7 * this.facing[from] / 255) : part);
        if (meets && !this.isShown(from, filter)) colour = [0, 1, 2].map(() => 40 + 40 * this.facing[from] / 255);
        else if (this.bounces[from] >= received && (x + y) % 6 < 2) colour = [255, 255, 255];
        [image.data[to], image.data[to + 1], image.data[to + 2], image.data[to + 3]] = [...colour, 255];
      }
    context.putImageData(image, 0, 0);
    this.drawLegend(byObject);
  }

  drawLegend(byObject) {
    const legend = byId('picture-legend');
    legend.replaceChildren();
    const add = (text, colour, striped = false) => {
      const item = make('li', text);
      item.prepend(swatch(colour, striped));
      legend.append(item);
    };
    if (this.counts.has(0)) add(`nothing met (${number(this.counts.get(0))})`, nothing);
    if (byObject) {
      const shown = this.largest();
      for (const object of shown) add(`${this.nameOf(object)} (${number(this.seen.get(object))})`, ofObject(object));
      const left = [...this.seen.keys()].filter(object => object > 0).length - shown.length;
      if (left > 0) legend.append(make('li', `and ${left} more`));
    } else for (const kind of [...this.counts.keys()].filter(kind => kind > 0).sort((a, b) => a - b)) add(`${words(kind)} (${number(this.counts.get(kind))})`, ofSegment(kind).colour);
    add(`received (${number(this.received)})`, ofSegment(3).colour, true);
  }

  tell(event) {
    const { width, height } = this.picture;
    const box = this.canvas.getBoundingClientRect();
    const scale = Math.min(box.width / width, box.height / height);
    const x = Math.floor((event.clientX - box.left - (box.width - width * scale) / 2) / scale), y = height - 1 - Math.floor((event.clientY - box.top - (box.height - height * scale) / 2) / scale);
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    const pixel = this.bounces[y * width + x];
    byId('picture-readout').textContent = `Column ${x + 1}, row ${y + 1} from the bottom: ${words(pixel % received)}${pixel % received > 0 ? `, first ${this.nameOf(this.objects[y * width + x])}` : ''}${pixel >= received ? ', received' : ''}.`;
  }
}

function countsOf(numbers) {
  const counts = new Map();
  for (const each of numbers) counts.set(each, (counts.get(each) ?? 0) + 1);
  return counts;
}

const words = kind => kind === 0 ? 'nothing met' : kind === 1 ? '1 bounce' : `${kind} bounces`;

function swatch(colour, striped) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('width', 22);
  svg.setAttribute('height', 14);
  svg.setAttribute('aria-hidden', 'true');
  svg.innerHTML = `<rect width="22" height="14" fill="${colour}" stroke="#888"/>${striped ? '<path d="M2 14 14 2M8 16 22 2M-4 14 10 0" stroke="#fff" stroke-width="2"/>' : ''}`;
  return svg;
}
