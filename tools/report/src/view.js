// The scene in 3-D with the paths of received rays.
import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshLambertMaterial,
  PerspectiveCamera, Raycaster, Scene, Sphere, Spherical, Vector3, WebGLRenderer
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { byId, bytes, lineSample, make, number, plural } from './text.js';
import { ofSegment } from './palette.js';

const drawnAtFirst = 120;
const turn = 6 * Math.PI / 180;

// Corners of the boxes around the instances, in three's axes.
export function cornersOf(scene) {
  return scene.instances.flatMap(({ mesh, place: p }) => Array.from({ length: 8 }, (unused, i) => {
    const { low, size } = scene.meshes[mesh];
    const [x, y, z] = [0, 1, 2].map(axis => low[axis] + size[axis] * (i >> axis & 1));
    return flip(...[0, 1, 2].map(axis => p[axis] * x + p[3 + axis] * y + p[6 + axis] * z + p[9 + axis]));
  }));
}

/** From Unity's axes to three's. */
export const flip = (x, y, z) => new Vector3(x, y, -z);

/** Opens the 3-D view, or says why there is none. @param {(renderer: WebGLRenderer) => void} open */
export function openView(open) {
  let renderer;
  try {
    renderer = new WebGLRenderer({ canvas: byId('view'), antialias: true, preserveDrawingBuffer: true });
  } catch (problem) {
    byId('view-part').hidden = true;
    byId('scene-text').textContent += ` The 3-D view needs WebGL, which this browser does not provide: ${problem.message}`;
    return;
  }
  open(renderer);
}

export class View {
  /** @param {object} scene of the report's data. */
  constructor(scene, renderer) {
    this.scene = scene;
    this.renderer = renderer;
    this.canvas = renderer.domElement;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.camera = new PerspectiveCamera(45, 1, 0.1, 1000);
    this.space = new Scene();
    this.space.background = new Color('#10161c');
    this.space.add(new AmbientLight('#ffffff', 1.1));
    this.sun = new DirectionalLight('#ffffff', 2);
    this.space.add(this.sun, this.sun.target);
    // Unity's axes are left-handed, three's right-handed.
    this.root = new Group();
    this.root.scale.z = -1;
    this.space.add(this.root);
    this.surface = new MeshLambertMaterial({ color: '#8794a0', side: DoubleSide, flatShading: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.addMeshes();
    this.addRadar();
    this.readPaths();
    this.addSegments();
    this.measure();
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener('change', () => this.render());
    // The wheel scrolls the page until the view has the focus.
    this.controls.enableZoom = false;
    this.canvas.addEventListener('focus', () => { this.controls.enableZoom = true; });
    this.canvas.addEventListener('blur', () => { this.controls.enableZoom = false; });
    this.canvas.addEventListener('pointerdown', () => this.canvas.focus({ preventScroll: true }));
    this.canvas.addEventListener('keydown', event => this.press(event));
    document.querySelectorAll('[data-fit]').forEach(button => button.addEventListener('click', () => this.fit(button.dataset.fit)));
    byId('see-through').addEventListener('change', event => {
      Object.assign(this.surface, event.target.checked ? { transparent: true, opacity: 0.3, depthWrite: false } : { transparent: false, opacity: 1, depthWrite: true });
      this.surface.needsUpdate = true;
      this.render();
    });
    new ResizeObserver(() => this.resize()).observe(this.canvas);
    this.resize();
    this.side = this.openSide();
    this.fit(this.first);
  }

  addMeshes() {
    const geometries = this.scene.meshes.map(mesh => {
      const steps = new Uint16Array(bytes(mesh.positions).buffer), places = new Float32Array(steps.length);
      for (let i = 0; i < steps.length; i++) places[i] = mesh.low[i % 3] + mesh.size[i % 3] * steps[i] / 65535;
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(places, 3));
      geometry.setIndex(new BufferAttribute(new Uint32Array(bytes(mesh.indices).buffer), 1));
      return geometry;
    });
    this.meshes = new Group();
    for (const { mesh, place: p } of this.scene.instances) {
      const shown = new Mesh(geometries[mesh], this.surface);
      shown.matrixAutoUpdate = false;
      shown.matrix = new Matrix4().set(p[0], p[3], p[6], p[9], p[1], p[4], p[7], p[10], p[2], p[5], p[8], p[11], 0, 0, 0, 1);
      this.meshes.add(shown);
    }
    this.root.add(this.meshes);
  }

  // The receiver's rectangle, and the edges of the radar's view up to the scene's centre.
  addRadar() {
    const { place, right, up, forward, half, parallel, receiver, receiver_right: across, receiver_up: high } = this.scene.radar;
    const at = (base, ...steps) => base.map((part, i) => part + steps.reduce((sum, [vector, length]) => sum + vector[i] * length, 0));
    const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
    const points = [];
    const rectangle = ends => ends.forEach((end, i) => points.push(...end, ...ends[(i + 1) % 4]));
    rectangle(corners.map(([x, y]) => at(receiver, [across, x], [high, y])));
    const reach = 0.15 * Math.hypot(...place);
    const near = corners.map(([x, y]) => parallel ? at(place, [right, x * half[0]], [up, y * half[1]]) : place);
    const far = corners.map(([x, y], i) => parallel ? at(near[i], [forward, reach]) : at(place, [right, x * half[0] * reach], [up, y * half[1] * reach], [forward, reach]));
    if (parallel) rectangle(near);
    rectangle(far);
    near.forEach((end, i) => points.push(...end, ...far[i]));
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
    this.root.add(new LineSegments(geometry, new LineBasicMaterial({ color: '#cc79a7' })));
  }

  readPaths() {
    const points = new Float32Array(bytes(this.scene.paths.points).buffer);
    let at = 0;
    this.paths = this.scene.paths.counts.map(count => points.subarray(at, at += 3 * count));
    const bounces = path => path.length / 3 - 2;
    const kinds = [...new Set(this.paths.map(bounces))].sort((a, b) => a - b);
    const select = byId('path-bounces');
    select.append(make('option', 'any number of bounces', { value: 'all' }));
    for (const kind of kinds) select.append(make('option', plural(kind, 'bounce'), { value: kind }));
    select.addEventListener('change', () => this.update());
    const count = byId('path-count');
    count.max = Math.max(1, this.paths.length);
    count.value = Math.min(this.paths.length, drawnAtFirst);
    count.addEventListener('input', () => this.update());
    document.querySelectorAll('[data-of=rays]').forEach(control => { control.hidden = this.paths.length === 0; });
    this.segmentCount = Math.max(0, ...kinds) + (kinds.length > 0 ? 1 : 0);
    this.chosenPaths = () => {
      const fitting = this.paths.filter(path => select.value === 'all' || bounces(path) === Number(select.value));
      const wanted = Math.max(1, Math.round(fitting.length * count.value / count.max));
      byId('path-count-text').textContent = `${number(Math.min(wanted, fitting.length))} of ${number(fitting.length)}`;
      return fitting.filter((path, i) => Math.floor((i + 1) * wanted / fitting.length) > Math.floor(i * wanted / fitting.length));
    };
  }

  addSegments() {
    this.lines = [];
    const box = byId('segments');
    for (let n = 1; n <= this.segmentCount; n++) {
      const { colour, name, dash, pattern } = ofSegment(n);
      // Lines are laid out in screen space, where the mirrored axes do not flip them.
      const material = new LineMaterial({ side: DoubleSide, color: colour, linewidth: 1.8, dashed: dash !== null, dashSize: dash?.[0] ?? 1, gapSize: dash?.[1] ?? 0, transparent: true, opacity: 0.85 });
      const line = new LineSegments2(new LineSegmentsGeometry(), material);
      line.frustumCulled = false;
      this.lines.push(line);
      this.root.add(line);
      const label = make('label');
      const tick = make('input', null, { type: 'checkbox', checked: '' });
      tick.addEventListener('change', () => { line.userData.off = !tick.checked; this.update(); });
      label.append(tick, lineSample(colour, dash ?? []), `${n}: ${n === 1 ? 'from the radar' : `after bounce ${n - 1}`} (${name}, ${pattern})`);
      box.append(label);
    }
    box.hidden = this.segmentCount === 0;
    this.fill();
  }

  fill() {
    const chosen = this.chosenPaths();
    this.lines.forEach((line, n) => {
      const ends = chosen.filter(path => path.length >= 3 * (n + 2)).flatMap(path => [...path.subarray(3 * n, 3 * n + 6)]);
      line.visible = !line.userData.off && ends.length > 0;
      if (!line.visible) return;
      line.geometry.dispose();
      line.geometry = new LineSegmentsGeometry();
      line.geometry.setPositions(ends);
      if (line.material.dashed) line.computeLineDistances();
    });
  }

  update() {
    this.fill();
    this.render();
  }

  // Bounding spheres for the fit.
  measure() {
    const around = points => points.length > 0 ? new Sphere().setFromPoints(points) : null;
    const corners = cornersOf(this.scene);
    const hits = this.paths.flatMap(path => Array.from({ length: path.length / 3 - 2 }, (unused, i) => flip(...path.subarray(3 * i + 3, 3 * i + 6))));
    this.radarPlace = flip(...this.scene.radar.place);
    const scene = around(corners) ?? new Sphere(new Vector3(), 1);
    const rays = around(hits);
    // Includes enough around the rays to show what they hit.
    if (rays) rays.radius = Math.max(3 * rays.radius, 0.02 * scene.radius);
    this.hits = hits;
    this.first = rays && scene.radius > 6 * rays.radius ? 'rays' : 'scene';
    this.spheres = { scene, rays: rays ?? scene, radar: around([...corners, this.radarPlace]) };
  }

  // View direction: from the radar's side, rotated and raised.
  direction(sphere, side) {
    const back = this.radarPlace.clone().sub(sphere.center);
    const direction = new Spherical().setFromVector3(back.lengthSq() > 0 ? back : new Vector3(0, 0, 1));
    direction.theta += side;
    direction.phi = Math.min(Math.max(0.3, direction.phi), 1.15);
    return direction;
  }

  // The azimuth, in radians, from which most of a few reflection points are visible.
  openSide() {
    this.root.updateMatrixWorld(true);
    const few = this.hits.filter((hit, i) => i % Math.ceil(this.hits.length / 6) === 0);
    const caster = new Raycaster();
    let [best, most] = [0.5, -1];
    for (const side of [0.5, -0.5, 0.2, -0.2]) {
      const towards = new Vector3().setFromSpherical(this.direction(this.spheres.rays, side)).normalize();
      const free = few.filter(hit => {
        caster.set(hit.clone().addScaledVector(towards, 1e-3 * this.spheres.scene.radius), towards);
        return caster.intersectObject(this.meshes, true).length === 0;
      }).length;
      if (free > most) [best, most] = [side, free];
      if (most === few.length) break;
    }
    return best;
  }

  fit(what) {
    const sphere = this.spheres[what];
    const direction = this.direction(sphere, this.side);
    direction.radius = Math.max(1e-6, sphere.radius) / Math.sin(this.camera.fov * Math.PI / 360) / Math.min(1, this.camera.aspect) * 1.02;
    this.controls.target.copy(sphere.center);
    this.camera.position.setFromSpherical(direction).add(sphere.center);
    this.controls.update();
    this.render();
  }

  press(event) {
    const offset = new Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    switch (event.key) {
      case 'ArrowLeft': offset.theta -= turn; break;
      case 'ArrowRight': offset.theta += turn; break;
      case 'ArrowUp': offset.phi -= turn; break;
      case 'ArrowDown': offset.phi += turn; break;
      case '+': case '=': offset.radius /= 1.15; break;
      case '-': offset.radius *= 1.15; break;
      case 'Home': this.fit(this.first); event.preventDefault(); return;
      default: return;
    }
    event.preventDefault();
    offset.makeSafe();
    this.camera.position.setFromSpherical(offset).add(this.controls.target);
    this.controls.update();
    this.render();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    for (const line of this.lines) line.material.resolution.set(width, height);
    this.render();
  }

  // Drawn once for all changes before the next frame.
  render() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = undefined;
      this.renderNow();
    });
  }

  renderNow() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const reach = this.spheres.radar.center.distanceTo(this.camera.position) + 1.2 * this.spheres.radar.radius + this.spheres.scene.radius;
    [this.camera.near, this.camera.far] = [distance / 200, Math.max(reach, 2 * distance)];
    this.camera.updateProjectionMatrix();
    this.sun.position.copy(this.camera.position).add(new Vector3(0, distance, 0));
    this.sun.target.position.copy(this.controls.target);
    // Dashes keep their length in pixels where the view is centred.
    const pixel = 2 * distance * Math.tan(this.camera.fov * Math.PI / 360) / Math.max(1, this.canvas.clientHeight);
    for (const line of this.lines) line.material.dashScale = 1 / pixel;
    this.renderer.render(this.space, this.camera);
  }
}
