// The target in 3-D with the triangles that return most, and the directions of radar and receiver.
import { ArrowHelper, BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial, Sphere } from 'three';
import { View, cornersOf, flip } from './view.js';
import { byId, bytes, make, number, plural } from './text.js';
import { hotStops, ofHeat, ofObject, ofSegment } from './palette.js';

const range = 40, mostListed = 10;
const radarColour = ofObject(4), receiverColour = ofSegment(2).colour;

// Unit vector to a radar, in Unity's axes.
function towards(azimuth, elevation) {
  const [a, e] = [azimuth, elevation].map(degrees => degrees * Math.PI / 180);
  return [-Math.sin(a) * Math.cos(e), Math.sin(e), -Math.cos(a) * Math.cos(e)];
}

export class HotSpots extends View {
  constructor(run, scene, poses, present, renderer) {
    const row = poses.rows[poses.chosen], around = new Sphere().setFromPoints(cornersOf(scene));
    const away = towards(row.azimuth_deg, row.elevation_deg).map(part => 2 * around.radius * part);
    super({ ...scene, radar: { place: away }, paths: { points: '', counts: [] } }, renderer);
    [this.run, this.poses, this.around] = [run, poses, around];
    this.surface.color.set('#66717c');
    this.readSpots();
    for (const name of present) byId('hot-polarisation').append(make('option', name.toUpperCase(), { value: name }));
    byId('hot-polarisation').addEventListener('change', () => this.show());
    document.querySelectorAll('[data-of=hot]').forEach(part => { part.hidden = this.corners.length === 0; });
    this.drawLegend();
    poses.onChange(() => this.show());
    this.show();
  }

  // The directions are drawn for each row.
  addRadar() {}

  readSpots() {
    const { names, corners } = this.scene.hot_spots;
    this.corners = new Float32Array(bytes(corners).buffer);
    this.places = new Map(names.map(([object, triangle], i) => [`${object} ${triangle}`, i]));
    this.spots = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ vertexColors: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 }));
    this.spots.frustumCulled = false;
    this.root.add(this.spots);
  }

  drawLegend() {
    const legend = byId('hot-legend');
    legend.append(make('span', `-${range} dB`), make('span', null, { class: 'ramp', role: 'img', 'aria-label': 'from dark violet over red and orange to light yellow' }), make('span', '0 dB, the strongest triangle'));
    legend.querySelector('.ramp').style.background = `linear-gradient(to right, ${hotStops.join(', ')})`;
  }

  show() {
    const row = this.poses.rows[this.poses.chosen], name = byId('hot-polarisation').value;
    const column = 2 + ['vv', 'hv', 'vh', 'hh'].indexOf(name);
    const spots = (row.contributions?.hot_spots ?? []).filter(spot => typeof spot[column] === 'number' && this.places.has(`${spot[0]} ${spot[1]}`)).sort((a, b) => b[column] - a[column]);
    const strongest = spots[0]?.[column];
    const positions = new Float32Array(9 * spots.length), colours = new Float32Array(9 * spots.length);
    spots.forEach((spot, i) => {
      const at = 9 * this.places.get(`${spot[0]} ${spot[1]}`);
      positions.set(this.corners.subarray(at, at + 9), 9 * i);
      const colour = this.spots.material.color.clone().setRGB(...ofHeat(1 + (spot[column] - strongest) / range).map(part => part / 255), 'srgb');
      for (let corner = 0; corner < 3; corner++) colours.set([colour.r, colour.g, colour.b], 9 * i + 3 * corner);
    });
    this.spots.geometry.dispose();
    this.spots.geometry = new BufferGeometry();
    this.spots.geometry.setAttribute('position', new BufferAttribute(positions, 3));
    this.spots.geometry.setAttribute('color', new BufferAttribute(colours, 3));
    this.showDirections(row);
    this.list(row, name, column, spots);
    this.render();
  }

  showDirections(row) {
    for (const arrow of this.arrows ?? []) {
      this.space.remove(arrow);
      arrow.dispose();
    }
    const { center, radius } = this.around;
    const arrow = (azimuth, elevation, isSent, colour) => {
      const out = flip(...towards(azimuth, elevation)), start = out.clone().multiplyScalar(radius * (isSent ? 1.6 : 1.05)).add(center);
      const shown = new ArrowHelper(isSent ? out.clone().negate() : out, start, 0.55 * radius, colour, 0.14 * radius, 0.08 * radius);
      this.space.add(shown);
      return shown;
    };
    this.radarPlace = flip(...towards(row.azimuth_deg, row.elevation_deg)).multiplyScalar(2 * radius).add(center);
    this.arrows = [arrow(row.azimuth_deg, row.elevation_deg, true, radarColour)];
    if (typeof row.receiver_azimuth_deg === 'number') this.arrows.push(arrow(row.receiver_azimuth_deg, row.receiver_elevation_deg, false, receiverColour));
  }

  list(row, name, column, spots) {
    const { scene, run } = this, isBistatic = typeof row.receiver_azimuth_deg === 'number';
    const coarse = scene.drawn < scene.triangles ? ` Of ${number(scene.triangles)} triangles the view has ${number(scene.drawn)}: surfaces are drawn coarser than traced, and may hide parts of hot spots.` : '';
    const hot = scene.is_changed ? ` The scene has changed since the run${run.table === 'echo' ? '' : ': hot spots are not shown'}.`
      : this.corners.length === 0 ? run.table === 'echo' ? '' : ' The run has no hot spots: glint rcs --contributions finds them.'
        : spots.length === 0 ? ` No triangle returns anything in ${name.toUpperCase()}.`
        : ` Coloured are the ${plural(spots.length, 'triangle')} that return most in ${name.toUpperCase()}: the coherent sums over their currents, without edges.`;
    byId('scene-text').textContent = `${this.poses.name(row)[0].toUpperCase()}${this.poses.name(row).slice(1)}: the purple arrow is the wave from the radar${isBistatic ? ', the green one points to the receiver' : ''}.${hot}${coarse}`;
    this.canvas.setAttribute('aria-label', `The target in 3-D with ${plural(spots.length, 'hot spot')}.`);
    byId('hot-table').parentNode.hidden = spots.length === 0;
    byId('hot-table').tBodies[0].replaceChildren(...spots.slice(0, mostListed).map(spot => {
      const line = make('tr');
      line.append(make('td', run.scene.object_names?.[spot[0]] ?? 'others'), make('td', number(spot[1])), make('td', spot[column].toFixed(1)));
      return line;
    }));
  }
}
