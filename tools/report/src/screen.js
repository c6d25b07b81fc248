// The turn of a radar screen, north up: zoom, and level and place under the cursor.
import { byId, bytes, number, plural, seconds } from './text.js';
import { hotStops, ofHeat, rgb, theme } from './palette.js';
import { settingsTable, showFacts } from './settings.js';

const nauticalMile = 1852, shownDecibels = 60, mostZoom = 64, mostSpokes = 512, rings = 6;
const background = '#02081a', detection = '#56b4e9', line = 'rgba(220, 230, 240, 0.45)';

/** @param {object} data The report's data. @returns what draws the picture again. */
export function showScreen({ run, screen }) {
  byId('lead').textContent = `A turn of a radar screen; computed ${run.started_utc?.replace('T', ' ').replace('Z', ' UTC') ?? ''} with Glint ${run.versions?.glint} on ${run.device?.name ?? 'an unknown device'}.`;
  const { settings } = run, unit = (name, scale, of) => `${number(settings[name]?.value / scale, 4)} ${of}`;
  showFacts([
    ['Range scale', `${number(screen.range_scale, 4)} m (${number(screen.range_scale / nauticalMile, 3)} NM)`],
    ['Spokes and cells', `${number(settings.spokes?.value)} x ${number(settings.cells?.value)}`],
    ['Frequency', unit('frequency', 1e9, 'GHz')], ['Power', unit('power', 1e3, 'kW')], ['Pulse', unit('pulse', 1, 'ns')],
    ['Beam', unit('beam_width', 1, 'deg')], ['Noise', `${number(screen.noise_dbw, 4)} dBW`],
    ...screen.detection_count != null ? [['Detections', number(screen.detection_count)]] : [],
    ['Whole run', seconds(run.elapsed_ms ?? NaN)]
  ]);
  settingsTable(run, { varying: [] });
  const picture = new Ppi(screen);
  return () => picture.draw();
}

class Ppi {
  /** @param {object} screen spokes, cells, cell_size, range_scale in metres, heading in degrees; levels, lowest_level and level_step over noise, and video, a byte a cell; detections: cells, 32 bits. */
  constructor(screen) {
    this.screen = screen;
    this.values = { video: bytes(screen.video), levels: bytes(screen.levels) };
    this.detected = new Uint8Array(screen.spokes * screen.cells);
    if (screen.detections) for (const cell of new Int32Array(bytes(screen.detections).buffer)) this.detected[cell] = 1;
    byId('ppi-detections').closest('label').hidden = screen.detection_count == null;
    byId('ppi-text').textContent = `North is up. A pixel has the highest of the cells that it touches${screen.is_reduced ? '; of neighbouring cells the file has the highest' : ''}.${screen.detection_count != null ? ` Blue cells are above the threshold of the detector.` : ''}`;
    this.canvas = byId('ppi');
    this.whole();
    for (const id of ['ppi-show', 'ppi-detections', 'ppi-rings']) byId(id).addEventListener('change', () => this.draw());
    byId('ppi-in').addEventListener('click', () => this.zoom(2));
    byId('ppi-out').addEventListener('click', () => this.zoom(0.5));
    byId('ppi-whole').addEventListener('click', () => { this.whole(); this.draw(); });
    this.listen();
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  listen() {
    const { canvas } = this;
    // The wheel scrolls the page until the picture has the focus, and where there is nothing to zoom.
    canvas.addEventListener('wheel', event => {
      if (document.activeElement === canvas && this.zoom(2 ** (-event.deltaY / 300), this.placeOf(event))) event.preventDefault();
    }, { passive: false });
    canvas.addEventListener('pointerdown', event => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', event => {
      if (event.buttons === 1) this.move(-event.movementX * this.metresAPixel, event.movementY * this.metresAPixel);
      this.read(event);
    });
    canvas.addEventListener('keydown', event => {
      const step = 40 * this.metresAPixel, act = {
        '+': () => this.zoom(2), '=': () => this.zoom(2), '-': () => this.zoom(0.5), Home: () => { this.whole(); this.draw(); },
        ArrowLeft: () => this.move(-step, 0), ArrowRight: () => this.move(step, 0), ArrowUp: () => this.move(0, step), ArrowDown: () => this.move(0, -step)
      }[event.key];
      if (!act) return;
      event.preventDefault();
      act();
    });
  }

  whole() { [this.east, this.north, this.half] = [0, 0, this.screen.range_scale]; }

  // Metres of a pixel of the page.
  get metresAPixel() { return 2 * this.half / Math.max(1, this.canvas.clientWidth); }

  /** The place under the mouse in metres from the radar. */
  placeOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [this.east + (event.clientX - box.left) * this.metresAPixel - this.half, this.north + this.half - (event.clientY - box.top) * this.metresAPixel];
  }

  // The place under the mouse stays where it is. Returns whether there was anything to zoom.
  zoom(factor, [east, north] = [this.east, this.north]) {
    const { range_scale: scale } = this.screen, half = Math.min(scale, Math.max(scale / mostZoom, this.half / factor)), part = half / this.half;
    if (part === 1) return false;
    [this.east, this.north, this.half] = [east + part * (this.east - east), north + part * (this.north - north), half];
    this.move(0, 0);
    return true;
  }

  // The middle stays where there are cells.
  move(east, north) {
    const limit = this.screen.range_scale - this.half;
    [this.east, this.north] = [this.east + east, this.north + north].map(value => Math.min(limit, Math.max(-limit, value)));
    this.draw();
  }

  draw() {
    const { canvas } = this, side = Math.round(canvas.clientWidth * devicePixelRatio);
    if (side === 0) return;
    [canvas.width, canvas.height] = [side, side];
    const context = canvas.getContext('2d'), image = context.createImageData(side, side), pixels = new Uint32Array(image.data.buffer);
    const name = byId('ppi-show').value, colours = this.coloursOf(name), values = this.values[name];
    const shown = this.screen.detections && byId('ppi-detections').checked, marked = packed(rgb(detection)), outside = packed(rgb(theme('--back')));
    const metres = 2 * this.half / side;
    for (let y = 0; y < side; y++)
      for (let x = 0; x < side; x++) {
        const east = this.east - this.half + (x + 0.5) * metres, north = this.north + this.half - (y + 0.5) * metres, range = Math.hypot(east, north);
        if (range >= this.screen.range_scale) { pixels[y * side + x] = outside; continue; }
        const { highest, isDetected } = this.highest(values, Math.atan2(east, north), range, metres, shown);
        pixels[y * side + x] = isDetected ? marked : colours[highest];
      }
    context.putImageData(image, 0, 0);
    if (byId('ppi-rings').checked) this.drawLines(context, side / (2 * this.half));
    this.drawLegend(name);
    canvas.setAttribute('aria-label', `Picture of the radar, ${number(this.half, 3)} m to each side of a place ${number(this.east, 3)} m east and ${number(this.north, 3)} m north of the radar${this.screen.detection_count != null ? `; ${plural(this.screen.detection_count, 'detection')}` : ''}.`);
  }

  // Of the cells that a pixel touches.
  highest(values, bearing, range, metres, shown) {
    const { spokes, cells, cell_size: size } = this.screen, turn = bearing / (2 * Math.PI) * spokes;
    const reach = Math.min(mostSpokes, metres / (2 * range) * spokes / (2 * Math.PI));
    const firstSpoke = Math.round(turn - reach), lastSpoke = Math.max(firstSpoke, Math.round(turn + reach));
    const first = Math.max(0, Math.floor((range - metres / 2) / size)), last = Math.min(cells - 1, Math.max(first, Math.ceil((range + metres / 2) / size) - 1));
    let highest = 0, isDetected = false;
    for (let spoke = firstSpoke; spoke <= lastSpoke; spoke++) {
      const row = (spoke % spokes + spokes) % spokes * cells;
      for (let cell = first; cell <= last; cell++) {
        if (values[row + cell] > highest) highest = values[row + cell];
        if (shown && this.detected[row + cell] === 1) isDetected = true;
      }
    }
    return { highest, isDetected };
  }

  // Of a byte. Levels are shown from the noise on.
  coloursOf(name) {
    const { lowest_level: lowest, level_step: step } = this.screen, dark = rgb(background);
    return Uint32Array.from({ length: 256 }, (_, value) => {
      const part = name === 'video' ? value / 255 : (lowest + step * value) / shownDecibels;
      const shade = Math.min(1, Math.max(0, part) * 8);
      return packed(ofHeat(part).map((colour, i) => Math.round(dark[i] + shade * (colour - dark[i]))));
    });
  }

  drawLines(context, scale) {
    const { range_scale: range, heading } = this.screen, [x, y] = [(this.half - this.east) * scale, (this.half + this.north) * scale];
    [context.strokeStyle, context.lineWidth] = [line, devicePixelRatio];
    for (let ring = 1; ring <= rings; ring++) {
      context.beginPath();
      context.arc(x, y, range * ring / rings * scale, 0, 2 * Math.PI);
      context.stroke();
    }
    const angle = heading * Math.PI / 180;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + range * Math.sin(angle) * scale, y - range * Math.cos(angle) * scale);
    context.stroke();
  }

  drawLegend(name) {
    byId('ppi-ramp').style.background = `linear-gradient(to right, ${background}, ${hotStops.join(', ')})`;
    [byId('ppi-least').textContent, byId('ppi-most').textContent] = name === 'video' ? ['0', '1'] : ['0 dB over noise', `${shownDecibels} dB`];
  }

  read(event) {
    const [east, north] = this.placeOf(event), { screen } = this, range = Math.hypot(east, north), cell = Math.floor(range / screen.cell_size);
    const readout = byId('ppi-readout');
    if (cell >= screen.cells) { readout.textContent = '\u00a0'; return; }
    const bearing = (Math.atan2(east, north) * 180 / Math.PI + 360) % 360, spoke = Math.round(bearing / 360 * screen.spokes) % screen.spokes, at = spoke * screen.cells + cell;
    const level = screen.lowest_level + screen.level_step * this.values.levels[at];
    readout.textContent = `bearing ${bearing.toFixed(1)} deg, range ${number(Math.round(range))} m (${(range / nauticalMile).toFixed(2)} NM): ${number(level, 4)} dB over noise (${number(level + screen.noise_dbw, 4)} dBW), video ${(this.values.video[at] / 255).toFixed(2)}${this.detected[at] === 1 ? ', detected' : ''}`;
  }
}

// A pixel of ImageData as a number of 32 bits.
const packed = ([red, green, blue]) => (0xff000000 | blue << 16 | green << 8 | red) >>> 0;
