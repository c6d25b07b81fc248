// The ISAR image, with the target's outline from above at the same scale.
import { byId, bytes, levelText, levelsFrom, make, number } from './text.js';
import { Heat, span, stepOf } from './heat.js';

export class IsarImage {
  /** @param {object} echo image: pixels, start and step in metres, azimuth of the radar in degrees, centre in the world, levels in hundredths of a dBsm by polarisation, row down range and column cross range. @param {object} scene The target, or nothing. */
  constructor(echo, scene) {
    [this.echo, this.image, this.scene] = [echo, echo.image, scene];
    const { image } = this;
    this.levels = levelsFrom(image.levels);
    this.heat = new Heat(byId('image'), byId('image-legend'), { start: image.start, step: image.step, cells: image.pixels }, 'cross range, m');
    echo.polarisations.forEach((name, i) => byId('image-polarisation').append(make('option', name.toUpperCase(), { value: i })));
    for (const id of ['image-polarisation', 'image-outline']) byId(id).addEventListener('change', () => this.draw());
    if (!scene || scene.is_changed) byId('image-outline').closest('label').remove();
    byId('image-text').textContent = `The radar is below, at azimuth ${number(image.azimuth)} deg in the middle of the sweep; cross range is to its right. A point on the horizontal plane through the phase centre keeps its cross section; what is above it is moved towards the radar by its height times the tangent of the elevation.${image.group > 1 ? ` Of ${number(image.group)} x ${number(image.group)} pixels the highest is shown.` : ''}`;
    this.heat.canvas.addEventListener('mousemove', event => this.read(event));
    new ResizeObserver(() => this.draw()).observe(this.heat.canvas.parentElement);
  }

  get polarisation() { return Number(byId('image-polarisation').value); }
  level(row, column) { return this.levels((this.polarisation * this.image.pixels + row) * this.image.pixels + column); }
  placeOf(index) { return this.image.start + index * this.image.step; }

  draw() {
    const { heat, image } = this, { pixels } = image;
    heat.makeSquare();
    if (!heat.begin()) return;
    const yOf = row => heat.top + heat.height * (1 - row / pixels);
    const top = heat.paint(Array.from({ length: pixels }, (_, row) => heat.pixelsOf(column => this.level(row, column))), row => [yOf(row), yOf(row + 1)]);
    if (byId('image-outline')?.checked) this.drawOutline();
    const side = pixels * image.step, step = stepOf(side, heat.height / 40), ticks = [];
    for (let i = Math.ceil((image.start - image.step / 2) / step); i * step <= image.start - image.step / 2 + side; i++) ticks.push([i * step + 0, this.yOf(i * step)]);
    heat.drawAxes('down range, m', ticks);
    heat.drawLegend(top, 'dBsm');
    heat.canvas.setAttribute('aria-label', `ISAR image of ${number(side, 4)} m a side, as colours over ${span} dB: the highest pixel has ${levelText(top, 'dBsm')}.`);
  }

  yOf(down) { return this.heat.top + this.heat.height * (1 - ((down - this.image.start) / this.image.step + 0.5) / this.image.pixels); }

  // All triangles are filled on a picture of their own; what lies one pixel around them is the outline.
  drawOutline() {
    const { heat, image, scene } = this, { width, height } = heat.canvas, mask = new OffscreenCanvas(width, height), to = mask.getContext('2d');
    const angle = image.azimuth * Math.PI / 180, [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
    to.scale(devicePixelRatio, devicePixelRatio);
    to.beginPath();
    for (const { mesh, place: p } of scene.instances) {
      const { low, size, positions, indices } = scene.meshes[mesh], steps = new Uint16Array(bytes(positions).buffer), corners = new Uint32Array(bytes(indices).buffer);
      const points = Array.from({ length: steps.length / 3 }, (_, i) => {
        const local = [0, 1, 2].map(axis => low[axis] + size[axis] * steps[3 * i + axis] / 65535);
        const [x, , z] = [0, 1, 2].map(axis => p[axis] * local[0] + p[3 + axis] * local[1] + p[6 + axis] * local[2] + p[9 + axis] + scene.centre[axis] - image.centre[axis]);
        // Down range is away from the radar, cross range to its right: IsarTransform.
        return [heat.xOf(cosine * x - sine * z), this.yOf(sine * x + cosine * z)];
      });
      for (let i = 0; i < corners.length; i += 3) {
        // All the same way round, so that none cuts a hole into another.
        const [a, b, c] = [0, 1, 2].map(corner => points[corners[i + corner]]), isClockwise = (b[0] - a[0]) * (c[1] - a[1]) < (b[1] - a[1]) * (c[0] - a[0]);
        to.moveTo(...a);
        to.lineTo(...(isClockwise ? c : b));
        to.lineTo(...(isClockwise ? b : c));
        to.closePath();
      }
    }
    [to.fillStyle, to.strokeStyle, to.lineWidth] = ['#fff', '#fff', 0.5];
    to.fill();
    to.stroke();
    const line = new OffscreenCanvas(width, height), on = line.getContext('2d');
    const by = Math.ceil(1.2 * devicePixelRatio);
    for (const x of [-by, 0, by]) for (const y of [-by, 0, by]) on.drawImage(mask, x, y);
    on.globalCompositeOperation = 'destination-out';
    on.drawImage(mask, 0, 0);
    const { ctx } = heat;
    ctx.save();
    ctx.beginPath();
    ctx.rect(heat.left, heat.top, heat.width, heat.height);
    ctx.clip();
    ctx.drawImage(line, 0, 0, width / devicePixelRatio, height / devicePixelRatio);
    ctx.restore();
  }

  read(event) {
    const at = this.heat.at(event), row = at && Math.floor((1 - (at.y - this.heat.top) / this.heat.height) * this.image.pixels);
    byId('image-readout').textContent = at === null || row < 0 || row >= this.image.pixels ? '\u00a0' : `down range ${number(this.placeOf(row), 4)} m, cross range ${number(this.placeOf(at.cell), 4)} m: ${levelText(this.level(row, at.cell), 'dBsm')}`;
  }
}
