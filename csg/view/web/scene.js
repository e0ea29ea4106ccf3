// The cells in space: camera, drawing on demand, and what is under a place of the picture.
//
// Nothing is drawn while nothing changes. While the camera moves and a frame takes too long, the picture gets
// coarser, then edges and vertices wait until it rests, then regions deep inside: a lecture room's projector runs on
// software rendering. The picture at rest of many cells is made bit by bit, so that the page answers meanwhile, and
// kept: a picked cell is drawn over it (still.js).
import * as THREE from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {Geometry} from './build_geometry.js';
import {clusters, facing} from './clusters.js';
import {SMALL} from './model.js';
import {Pointer, targets, under} from './pick.js';
import {cutBy} from './section.js';
import {material, shared} from './shaders.js';
import {Still} from './still.js';
import {EDGES, faceBuffers, Faces, lineBuffers, pointBuffers, POINTS, ribbonBuffers, Table} from './tables.js';

const SLOW = 45;      // milliseconds of a frame that is not fluent
const HEAVY = 60000;  // triangles, edges and points of a picture that is made bit by bit
const color = (c) => new THREE.Color(c[0] / 255, c[1] / 255, c[2] / 255);

/** True where the processor draws: there smoothing costs more than everything else. */
function drawnBySoftware() {
  const gl = document.createElement('canvas').getContext('webgl2'), info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class Scene {
  constructor(canvas, changed) {
    this.software = drawnBySoftware();
    this.canvas = canvas;
    this.changed = changed;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: !this.software, stencil: true, preserveDrawingBuffer: false, powerPreference: 'high-performance'});
    this.renderer.setClearColor(0xffffff, 1);
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.moved());
    this.world = new THREE.Group();
    this.over = new THREE.Group();
    this.root = new THREE.Scene();
    this.root.add(this.world, this.over);
    this.quality = 1;
    this.frameTime = 0;
    this.materials = {
      skin: material('FACE', {side: THREE.FrontSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}),
      inner: material('FACE', {side: THREE.BackSide, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2}),
      sheet: material('FACE', {side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}),
      cut: material('FACE', {side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}),
      ghost: material('FACE', {side: THREE.DoubleSide, transparent: true, depthWrite: false}, {opacity: {value: 0.16}}),
      edge: material('EDGE', {side: THREE.DoubleSide}, {lift: {value: 1.5e-3}}),
      line: material('LINE', {}, {lift: {value: 1.5e-3}}),
      ghostEdge: material('EDGE', {side: THREE.DoubleSide, transparent: true}, {opacity: {value: 0.8}, lift: {value: 1e-3}}),
      point: material('POINT', {}, {lift: {value: 6e-3}}),
      ...Object.fromEntries([['FACE', 0.14, 0.45, 0], ['EDGE', 0.75, 1, 3e-3], ['POINT', 0.5, 1, 8e-3]].flatMap(([kind, faint, full, lift]) => {
        const name = kind[0] + kind.slice(1).toLowerCase(), options = {side: THREE.DoubleSide, transparent: true, depthWrite: false};
        const of = (opacity, hidden) => ({opacity: {value: opacity}, solid: {value: 1}, hidden: {value: hidden}, lift: {value: lift}});
        return [[`hidden${name}`, material(kind, {...options, depthFunc: THREE.GreaterDepth}, of(faint, 1))], [`over${name}`, material(kind, options, of(full, 0))]];
      })),
    };
    this.still = new Still(this);
    this.budget = this.software ? 60000 : Infinity;  // triangles of skins while the camera moves
    this.centre = [0, 0, 0];
    this.radius = 1;
    this.section = null;
  }

  /** From the model's coordinates to those of the scene, in which the result has radius 1. */
  place = (p) => p.map((x, k) => (x - this.centre[k]) / this.radius);

  setExtent(low, high) {
    this.centre = low.map((x, k) => (x + high[k]) / 2);
    this.radius = Math.hypot(...low.map((x, k) => high[k] - x)) / 2 || 1;
    this.low = low;
    this.high = high;
  }

  resize(width, height) {
    this.width = Math.max(width, 1);
    this.height = Math.max(height, 1);
    this.camera.aspect = this.width / this.height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  dispose(group) {
    group.traverse((object) => object.geometry?.dispose());
    group.clear();
  }

  /** Whether what lies between regions can be seen; small models always have it, and so need no second drawing. */
  needsInner(model, look) {
    return model.size < SMALL || look.apart || look.through || look.hidden.size > 0 || !look.show[3] || model.open;
  }

  /** Draws the cells of a model. `look` is what Geometry asks for, and {through, paper}. */
  show(model, look) {
    this.model = model;
    this.look = {...look, inner: this.needsInner(model, look)};
    look = this.look;
    this.cut = null;
    this.dispose(this.world);
    const g = (this.geometry = new Geometry(model, look, this.place));
    const {materials} = this;
    for (const m of [materials.skin, materials.sheet, materials.inner]) {
      m.uniforms.opacity.value = look.through ? 0.28 : 1;
      m.transparent = look.through;
      m.depthWrite = !look.through;
    }
    this.clusters = [];
    this.skin = this.inner = null;
    if (g.skins.triangles.length) {
      const {index, list} = clusters(g);
      this.clusters = list;
      this.skin = this.add(faceBuffers(g.skins, index), [materials.skin]);
      const whole = new THREE.BufferGeometry();
      for (const [name, attribute] of Object.entries(this.skin.geometry.attributes)) whole.setAttribute(name, attribute);
      this.inner = this.add(whole.setIndex(this.skin.geometry.index), materials.inner);
    }
    this.targets = targets(g);
    if (g.sheets.triangles.length) this.add(faceBuffers(g.sheets), materials.sheet);
    const plain = g.plainAsLines ? this.add(lineBuffers(g.plain), materials.line, 50, THREE.LineSegments) : this.add(ribbonBuffers(g.plain), materials.edge, 50);
    this.edges = [plain, this.add(ribbonBuffers(g.edges), materials.edge, 50)];
    this.points = this.add(pointBuffers(g.points), materials.point, 60, THREE.Points);
    if (g.ghosts.triangles.length) this.add(faceBuffers(g.ghosts), materials.ghost, 70);
    this.add(ribbonBuffers(g.ghostEdges), materials.ghostEdge, 71);
    this.heavy = g.triangles + g.plain.length + g.edges.length + g.points.length > HEAVY;
    // Where there are many cells, thick lines would cover them.
    [shared.edge.value, shared.points.value] = model.size < SMALL ? [1.3, 6] : [0.8, 2.5];
    shared.paper.value.copy(color(look.paper));
    this.renderer.setClearColor(color(look.paper), 1);
    this.setSection(this.section);
    this.pick([]);
  }

  add(geometry, kind, order = 0, Kind = THREE.Mesh) {
    const object = new Kind(geometry, kind);
    object.frustumCulled = false;
    object.renderOrder = order;
    object.visible = geometry.attributes.position.count > 0;
    this.world.add(object);
    return object;
  }

  /** How far the box of the result reaches along a normal, in coordinates of the model. */
  reachAlong(normal) {
    const end = (s) => normal.reduce((sum, n, k) => sum + n * (n * s > 0 ? this.high[k] : this.low[k]), 0);
    return [end(-1), end(1)];
  }

  /** `{normal, at: 0..1 along it, flip}` or null. What is kept is where the normal points. */
  setSection(section) {
    this.section = section;
    const plane = shared.plane.value;
    if (section) {
      const {normal, at, flip} = section, sign = flip ? -1 : 1, [near, far] = this.reachAlong(normal);
      const middle = normal.reduce((sum, n, k) => sum + n * this.centre[k], 0);
      plane.set(...normal.map((n) => sign * n), (-sign * (near + (far - near) * at - middle)) / this.radius);
    } else {
      plane.set(0, 0, 0, 1);
    }
    this.fillSection();
    this.draw();
  }

  /** Fills what the section cuts, and outlines it. */
  fillSection() {
    for (const object of this.cut?.objects ?? []) {
      object.removeFromParent();
      object.geometry.dispose();
    }
    this.cut = null;
    if (!this.section || !this.geometry) return;
    const {x, y, z, w} = shared.plane.value;
    this.cut = cutBy(this.geometry, [x, y, z], w, shared.explode.value, this.look.ink);
    const {filled, lines} = this.cut;
    this.cut.objects = [this.add(faceBuffers(filled), this.materials.cut), this.add(ribbonBuffers(lines), this.materials.edge, 51)];
  }

  setExplode(t) {
    shared.explode.value = t;
    this.fillSection();
    this.draw();
  }

  /** Marks cells; what of them other cells hide is drawn faintly, edges dashed. */
  pick(picked, accent = [0, 0, 0]) {
    this.dispose(this.over);
    if (picked.length && this.model) {
      const g = this.geometry, faces = new Faces(), edges = new Table(EDGES), points = new Table(POINTS), none = [0, 0, 0, 0];
      const {model} = this, {cells} = model, lone = picked.length === 1;
      const face = (from, f, shift) => {
        g.pushFace(faces, from, f, false, accent, none, none, shift, 0);
        for (const loop of from.faces.loops(f)) g.pushChain(edges, from, loop, true, accent, none, shift, 2, 0);
      };
      const edge = (from, i, shift) => g.pushChain(edges, from, from.edges.points.of(i), from.edges.flags[i] & 1, accent, none, shift, lone ? 3.6 : 2.4, 0);
      const point = (from, i, shift) => g.pushPoint(points, from, from.vertices.point[i], accent, none, shift, lone ? 2.4 : 1.5, lone ? 1 : 0);
      for (const cell of picked) {
        const entity = cell.kind === cell.kind.toUpperCase(), from = entity ? model.classes.cells : cells;
        if (cell.kind === 'r') {
          for (const shell of cells.regions.shells(cell.i)) for (const side of shell) face(cells, side >> 1, g.shift(cell.i + 1));
        } else {
          for (const shift of entity ? g.classShifts(cell.kind, cell.i) : g.shiftsOf(cell)) ({f: face, e: edge, v: point})[cell.kind.toLowerCase()](from, cell.i, shift);
        }
      }
      const {materials} = this;
      const add = (kind, buffers, hidden, seen, order) => [hidden, seen].forEach((m) => {
        const object = new kind(buffers, materials[m]);
        object.frustumCulled = false;
        object.renderOrder = order;
        this.over.add(object);
      });
      if (faces.triangles.length) add(THREE.Mesh, faceBuffers(faces), 'hiddenFace', 'overFace', 90);
      if (edges.length) add(THREE.Mesh, ribbonBuffers(edges), 'hiddenEdge', 'overEdge', 91);
      if (points.length) add(THREE.Points, pointBuffers(points), 'hiddenPoint', 'overPoint', 92);
    }
    this.draw(false);
  }

  // --- camera

  fit(direction) {
    const d = direction ?? this.camera.position.clone().sub(this.controls.target).normalize();
    const reach = 1.06 / Math.sin(THREE.MathUtils.degToRad(this.camera.fov / 2)) / Math.min(1, this.camera.aspect);
    this.controls.target.set(0, 0, 0);
    this.camera.position.copy(d).multiplyScalar(reach * (1 + 0.55 * shared.explode.value));
    this.controls.update();
    this.moved();
  }
  lookFrom(x, y, z) { this.fit(new THREE.Vector3(x, y, z).normalize()); }
  turn(right, up) {
    const offset = this.camera.position.clone().sub(this.controls.target), s = new THREE.Spherical();
    const toY = new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0));
    s.setFromVector3(offset.applyQuaternion(toY));
    s.theta += right;
    s.phi = Math.min(Math.max(s.phi - up, 0.01), Math.PI - 0.01);
    this.camera.position.setFromSpherical(s).applyQuaternion(toY.invert()).add(this.controls.target);
    this.controls.update();
  }
  zoom(by) {
    this.camera.position.sub(this.controls.target).multiplyScalar(by).add(this.controls.target);
    this.controls.update();
  }
  get view() { return [...this.camera.position.toArray(), ...this.controls.target.toArray()].map((x) => +x.toFixed(3)); }
  set view(v) {
    this.camera.position.fromArray(v);
    this.controls.target.fromArray(v, 3);
    this.controls.update();
  }

  moved() {
    this.moving = true;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.moving = false;
      this.quality = Math.min(this.quality * 1.5, 1);  // what was slow may have been another program
      this.draw();
    }, 220);
    this.draw();
  }

  // --- drawing

  /** `anew`: something else has changed than what is picked. */
  draw(anew = true) {
    if (anew) this.still.stop();
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.render();
    });
  }

  prepare(ratio, width, height) {
    shared.ratio.value = ratio;
    shared.size.value.set(width / 2, height / 2);
    const far = this.camera.position.distanceTo(this.controls.target);
    shared.dash.value = far * 0.012;
    const reach = (this.geometry?.reach ?? 1) + shared.explode.value * (this.geometry?.reachApart ?? 0), middle = this.camera.position.length();
    this.camera.near = Math.max(0.005, 0.95 * (middle - reach));
    this.camera.far = 1.05 * (middle + reach);
    this.camera.updateProjectionMatrix();
  }

  /** Pixels of the canvas per pixel of the page: without smoothing the picture at rest is drawn twice as fine. */
  ratioOf(moving) {
    const screen = Math.min(window.devicePixelRatio || 1, 2), coarse = moving ? this.quality : 1;
    return this.software && !moving ? 2 : screen * (coarse < 1 ? Math.max(coarse, 0.5) : 1);
  }
  setRatio(ratio) {
    if (this.renderer.getPixelRatio() === ratio && this.drawnWidth === this.width && this.drawnHeight === this.height) return;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
    [this.drawnWidth, this.drawnHeight] = [this.width, this.height];
  }

  /** What of the scene is drawn: skins that may be seen, `most` triangles of them, the outer regions first. */
  choose(lower, most) {
    for (const object of this.edges) object.visible = lower;
    this.points.visible = lower;
    // Inside of regions something is to be seen only through a missing face.
    if (this.inner) this.inner.visible = !this.look.through && this.geometry.legend.has('open');
    if (!this.skin) return;
    this.facing = facing(this.clusters, this.camera.position.toArray(), shared.explode.value, most);
    const {geometry} = this.skin;
    geometry.clearGroups();
    for (const {start, count} of this.facing) geometry.addGroup(3 * start, 3 * count, 0);
  }

  render() {
    if (!this.width || !this.model) return;
    const {moving} = this, rests = this.heavy && !moving;
    if (rests && this.still.done) return this.still.show();
    const begin = performance.now(), coarse = moving || rests ? this.quality : 1, ratio = this.ratioOf(moving || rests);
    // A heavy picture at rest is on its way; where there is none yet, or another size, it begins as if it moved.
    if (!rests || !this.shown || this.drawnWidth !== this.width || this.drawnHeight !== this.height) {
      this.setRatio(ratio);
      this.choose(this.heavy ? !rests && coarse > 0.4 && !this.software : coarse > 0.4 || this.model.size < SMALL, moving || rests ? this.budget : Infinity);
      this.prepare(ratio, this.width * ratio, this.height * ratio);
      this.renderer.render(this.root, this.camera);
      this.shown = true;
    }
    if (moving) {
      // What the frame took is known when a pixel of it is there.
      const gl = this.renderer.getContext();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      this.frameTime = performance.now() - begin;
      if (this.frameTime > SLOW) {
        this.quality = Math.max(this.quality * 0.6, 0.3);
        this.budget = Math.max(Math.min(this.budget, this.geometry.triangles) * 0.8, 5000);
      }
    } else if (rests) {
      this.still.begin();
    }
    this.changed(moving);
  }

  /** A picture of numbers of cells. */
  numbers(width, height) {
    const target = new THREE.WebGLRenderTarget(width, height);
    this.choose(true, Infinity);
    this.prepare(width / this.width, width, height);
    shared.ids.value = 1;
    this.over.visible = false;
    const seen = [];
    for (const m of Object.values(this.materials)) {
      seen.push([m, m.blending, m.transparent, m.depthWrite]);
      m.blending = THREE.NoBlending;
      m.depthWrite = true;
    }
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.setRenderTarget(target);
    this.renderer.clear();
    this.renderer.render(this.root, this.camera);
    const bytes = new Uint8Array(width * height * 4);
    this.renderer.readRenderTargetPixels(target, 0, 0, width, height, bytes);
    this.renderer.setRenderTarget(null);
    this.renderer.setClearColor(color(this.look.paper), 1);
    for (const [m, blending, transparent, depthWrite] of seen) Object.assign(m, {blending, transparent, depthWrite});
    shared.ids.value = 0;
    this.over.visible = true;
    target.dispose();
    return bytes;
  }

  /** The cell at a place of the picture, in CSS pixels; vertices before edges before faces. `kinds`: `any` or a letter. */
  at(x, y, kinds) {
    if (!this.model) return null;
    const {camera, geometry, section, look} = this, eye = camera.position.toArray();
    const v = new THREE.Vector3((2 * x) / this.width - 1, 1 - (2 * y) / this.height, 0.5);
    this.prepare(1, this.width, this.height);
    camera.updateMatrixWorld();
    const ray = v.unproject(camera).sub(camera.position).normalize().toArray();
    const stripe = (((x + this.height - y) % 9) + 9) % 9;
    const pointer = new Pointer({eye, ray, near: camera.near, explode: shared.explode.value, hatch: stripe < 3 || stripe > 8,
      pixel: (2 * Math.tan(THREE.MathUtils.degToRad(camera.fov / 2))) / this.height, plane: section && shared.plane.value.toArray()});
    const found = under(pointer, {geometry, targets: this.targets, cut: this.cut, inner: !look.through && geometry.legend.has('open')}, kinds);
    this.looked = pointer.looked;
    return found;
  }

  /** Where labels may stand: of each cell that is seen a pixel of it near the middle of what is seen of it. */
  labelPlaces() {
    const w = Math.min(Math.round(this.width / 2), 700), h = Math.max(Math.round((w * this.height) / this.width), 1);
    const bytes = this.numbers(w, h), sums = new Map();
    const each = (f) => {
      for (let k = 0; k < w * h; ++k) {
        const n = bytes[4 * k] | (bytes[4 * k + 1] << 8) | (bytes[4 * k + 2] << 16);
        if (n) f(n, k % w, h - 1 - Math.floor(k / w));
      }
    };
    each((n, x, y) => {
      let s = sums.get(n);
      if (!s) sums.set(n, (s = [0, 0, 0, Infinity, 0, 0]));
      s[0] += x; s[1] += y; ++s[2];
    });
    each((n, x, y) => {
      const s = sums.get(n), far = (x - s[0] / s[2]) ** 2 + (y - s[1] / s[2]) ** 2;
      if (far < s[3]) [s[3], s[4], s[5]] = [far, x, y];
    });
    const places = [];
    for (const [n, s] of sums) {
      const cell = this.geometry.numbering.cell(n & 255, (n >> 8) & 255, n >> 16);
      if (cell) places.push({cell, x: ((s[4] + 0.5) / w) * this.width, y: ((s[5] + 0.5) / h) * this.height, size: s[2]});
    }
    return places;
  }

  /** The picture as a canvas, `times` as fine as the screen. */
  picture(times) {
    this.setRatio(times);
    this.choose(true, Infinity);
    this.prepare(times, this.width * times, this.height * times);
    this.renderer.render(this.root, this.camera);
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [this.canvas.width, this.canvas.height];
    copy.getContext('2d').drawImage(this.canvas, 0, 0);
    this.shown = false;
    this.render();
    return copy;
  }

  /** Where a place of the scene is in the picture. */
  project(p) {
    const v = new THREE.Vector3(...p).project(this.camera);
    return [((v.x + 1) / 2) * this.width, ((1 - v.y) / 2) * this.height, v.z];
  }
  /** Right, up and towards the viewer, as directions of the model. */
  axes() {
    const m = this.camera.matrixWorld.elements;
    return [m.slice(0, 3), m.slice(4, 7), m.slice(8, 11)];
  }
}
