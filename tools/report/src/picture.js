// The radar's view: how often each ray is reflected, by colour; received rays are striped white.
import { byId, bytes, make, number } from './text.js';
import { ofSegment, rgb } from './palette.js';

const received = 128;

export class Picture {
  constructor(picture, poseName) {
    this.picture = picture;
    this.bounces = bytes(picture.bounces);
    this.facing = bytes(picture.facing);
    this.canvas = byId('picture');
    [this.canvas.width, this.canvas.height] = [picture.width, picture.height];
    const counts = new Map();
    let receivedCount = 0;
    for (const pixel of this.bounces) {
      counts.set(pixel % received, (counts.get(pixel % received) ?? 0) + 1);
      receivedCount += pixel >= received ? 1 : 0;
    }
    const kinds = [...counts.keys()].sort((a, b) => a - b);
    const part = picture.width < picture.across || picture.height < picture.down ? `the part of the picture that meets anything, ${number(100 * picture.width / picture.across, 3)} % of its width and ${number(100 * picture.height / picture.down, 3)} % of its height, ` : '';
    byId('picture-text').textContent = `${poseName}: ${part}${picture.width} x ${picture.height} pixels with a ray each. Colour tells how often the ray is reflected, brightness how squarely it meets the first surface; white stripes mark rays that reach the receiver.`;
    this.canvas.setAttribute('aria-label', `The radar's view. ${kinds.map(kind => `${words(kind)}: ${number(100 * counts.get(kind) / this.bounces.length, 3)} %`).join(', ')} of the pixels; ${receivedCount} are received.`);

    const filter = byId('picture-filter');
    filter.append(make('option', 'all rays', { value: 'all' }), make('option', 'received rays', { value: 'received' }));
    for (const kind of kinds.filter(kind => kind > 0)) filter.append(make('option', `rays with ${words(kind)}`, { value: kind }));
    filter.addEventListener('change', () => this.draw());
    for (const kind of kinds) {
      const item = make('li', `${words(kind)} (${number(counts.get(kind))})`);
      item.prepend(swatch(kind === 0 ? '#10161c' : ofSegment(kind).colour, false));
      byId('picture-legend').append(item);
    }
    const item = make('li', `received (${number(receivedCount)})`);
    item.prepend(swatch(ofSegment(3).colour, true));
    byId('picture-legend').append(item);
    this.canvas.addEventListener('pointermove', event => this.tell(event));
    this.draw();
  }

  draw() {
    const { width, height } = this.picture;
    const context = this.canvas.getContext('2d');
    const image = context.createImageData(width, height);
    const filter = byId('picture-filter').value;
    const sea = rgb('#10161c');
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++) {
        const from = (height - 1 - y) * width + x, to = 4 * (y * width + x);
        const kind = this.bounces[from] % received, isReceived = this.bounces[from] >= received;
        const shown = filter === 'all' || (filter === 'received' ? isReceived : kind === Number(filter));
        let colour = kind === 0 ? sea : rgb(ofSegment(kind).colour).map(part => part * (0.3 + 0.7 * this.facing[from] / 255));
        if (kind > 0 && !shown) colour = [0, 1, 2].map(() => 40 + 40 * this.facing[from] / 255);
        else if (isReceived && (x + y) % 6 < 2) colour = [255, 255, 255];
        [image.data[to], image.data[to + 1], image.data[to + 2], image.data[to + 3]] = [...colour, 255];
      }
    context.putImageData(image, 0, 0);
  }

  tell(event) {
    const { width, height } = this.picture;
    const box = this.canvas.getBoundingClientRect();
    const scale = Math.min(box.width / width, box.height / height);
    const x = Math.floor((event.clientX - box.left - (box.width - width * scale) / 2) / scale), y = height - 1 - Math.floor((event.clientY - box.top - (box.height - height * scale) / 2) / scale);
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    const pixel = this.bounces[y * width + x];
    byId('picture-readout').textContent = `Column ${x + 1}, row ${y + 1} from the bottom: ${words(pixel % received)}${pixel >= received ? ', received' : ''}.`;
  }
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
