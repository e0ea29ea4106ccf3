// The cells in space: camera, drawing on demand, and what is under a place of the picture.
//
// Nothing is drawn while nothing changes. While the camera moves and a frame takes too long, the picture gets
// coarser, then edges and vertices wait until it rests: a lecture room's projector runs on software rendering.
import * as THREE from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {buffers, Geometry} from './build_geometry.js';
import {material, shared} from './shaders.js';

const SLOW = 45;      // milliseconds of a frame that is not fluent
const CAPS = 80;      // regions whose section is filled
const SMALL = 20000;  // cells that are all drawn, seen or not
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
      ghost: material('FACE', {side: THREE.DoubleSide, transparent: true, depthWrite: false}, {opacity: {value: 0.16}}),
      edge: material('EDGE', {side: THREE.DoubleSide}, {lift: {value: 1e-4}}),
      ghostEdge: material('EDGE', {side: THREE.DoubleSide, transparent: true}, {opacity: {value: 0.8}, lift: {value: 5e-5}}),
      point: material('POINT', {}, {lift: {value: 1.6e-4}}),
      overFace: material('FACE', {side: THREE.DoubleSide, transparent: true, depthTest: false, depthWrite: false}, {opacity: {value: 0.45}, solid: {value: 1}}),
      overEdge: material('EDGE', {side: THREE.DoubleSide, transparent: true, depthTest: false}),
      overPoint: material('POINT', {transparent: true, depthTest: false}),
    };
    const stencil = {colorWrite: false, depthWrite: false, depthTest: false, stencilWrite: true, stencilFunc: THREE.AlwaysStencilFunc};
    const solid = {solid: {value: 1}};
    this.materials.capBack = material('FACE', {...stencil, side: THREE.BackSide, stencilZPass: THREE.IncrementWrapStencilOp}, solid);
    this.materials.capFront = material('FACE', {...stencil, side: THREE.FrontSide, stencilZPass: THREE.DecrementWrapStencilOp}, solid);
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
    return model.size < SMALL || look.apart || look.through || !look.show[3] || Boolean(this.section) || model.open;
  }

  /** Draws the cells of a model. `look` is what Geometry asks for, and {through, paper}. */
  show(model, look) {
    this.model = model;
    this.look = {...look, inner: this.needsInner(model, look)};
    look = this.look;
    this.outline = null;
    this.dispose(this.world);
    const g = (this.geometry = new Geometry(model, look, this.place));
    const add = (columns, kind, instanced = false, order = 0) => {
      const size = instanced ? columns.a.length : columns.position.length;
      if (size === 0) return null;
      const object = new (kind === this.materials.point ? THREE.Points : THREE.Mesh)(buffers(columns, instanced), kind);
      object.frustumCulled = false;
      object.renderOrder = order;
      this.world.add(object);
      return object;
    };
    const {materials} = this;
    for (const m of [materials.skin, materials.sheet, materials.inner]) {
      m.uniforms.opacity.value = look.through ? 0.28 : 1;
      m.transparent = look.through;
      m.depthWrite = !look.through;
    }
    const skin = add(g.skins, materials.skin);
    this.skin = skin;
    this.inner = skin && new THREE.Mesh(skin.geometry, materials.inner);
    if (this.inner) {
      this.inner.frustumCulled = false;
      this.world.add(this.inner);
    }
    this.caps = new THREE.Group();
    this.world.add(this.caps);
    if (skin && g.ranges.length <= CAPS) this.addCaps(skin.geometry, g.ranges);
    add(g.sheets, materials.sheet);
    this.edges = add(g.edges, materials.edge, true, 50);
    this.points = add(g.points, materials.point, false, 60);
    add(g.ghosts, materials.ghost, false, 70);
    add(g.ghostEdges, materials.ghostEdge, true, 71);
    // Where there are many cells, thick lines would cover them.
    [shared.edge.value, shared.points.value] = model.size < SMALL ? [1.3, 6] : [0.8, 2.5];
    shared.paper.value.copy(color(look.paper));
    this.renderer.setClearColor(color(look.paper), 1);
    this.setSection(this.section);
    this.pick(null);
  }

  /** The plane of the section is filled where a region is cut: front faces are counted against back faces. */
  addCaps(geometry, ranges) {
    ranges.forEach(({r, begin, count, tint}, k) => {
      const part = new THREE.BufferGeometry();
      for (const [name, attribute] of Object.entries(geometry.attributes)) part.setAttribute(name, attribute);
      part.setDrawRange(begin, count);
      for (const m of [this.materials.capBack, this.materials.capFront]) {
        const mesh = new THREE.Mesh(part, m);
        mesh.frustumCulled = false;
        mesh.renderOrder = 10 + k * 0.1;
        this.caps.add(mesh);
      }
      const zero = THREE.ZeroStencilOp;
      const [x, y, z, w] = this.geometry.numbering.bytes('r', r).map((b) => b / 255);
      const plane = new THREE.Mesh(new THREE.PlaneGeometry(8, 8), material('CAP', {
        side: THREE.DoubleSide, stencilWrite: true, stencilRef: 0, stencilFunc: THREE.NotEqualStencilFunc, stencilFail: zero,
        stencilZFail: zero, stencilZPass: zero, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
      }, {tint: {value: color(tint).multiplyScalar(0.94)}, ident: {value: new THREE.Vector4(x, y, z, w)}}));
      plane.renderOrder = 10.05 + k * 0.1;
      plane.userData.cap = true;
      this.caps.add(plane);
    });
  }

  /** `{axis: 0..2, at: 0..1, flip}` or null. */
  setSection(section) {
    this.section = section;
    if (this.model && this.needsInner(this.model, this.look) && !this.look.inner) return this.show(this.model, this.look);
    const plane = shared.plane.value;
    if (section) {
      const n = [0, 0, 0], sign = (section.axis === 1) === section.flip ? -1 : 1;  // unflipped, the cut faces the first view
      n[section.axis] = sign;
      const near = this.place(this.low)[section.axis], far = this.place(this.high)[section.axis];
      const at = near + (far - near) * section.at;
      plane.set(...n, -sign * at);
      const quaternion = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(...n));
      for (const object of this.caps?.children ?? []) {
        if (!object.userData.cap) continue;
        object.quaternion.copy(quaternion);
        object.position.set(0, 0, 0).setComponent(section.axis, at);
      }
    } else {
      plane.set(0, 0, 0, 1);
    }
    if (this.caps) this.caps.visible = Boolean(section);
    this.outlineSection();
    this.draw();
  }

  /** The lines of the section, where there are not so many that they could not follow the hand. */
  outlineSection() {
    if (this.outline) {
      this.outline.removeFromParent();
      this.outline.geometry.dispose();
      this.outline = null;
    }
    const g = this.geometry, plane = shared.plane.value;
    if (!this.section || !g || g.skins.kind.length + g.sheets.kind.length > 200000) return;
    const lines = g.cutLines([plane.x, plane.y, plane.z], plane.w, shared.explode.value, this.look.ink);
    if (!lines.a.length) return;
    this.outline = new THREE.Mesh(buffers(lines, true), this.materials.edge);
    this.outline.frustumCulled = false;
    this.outline.renderOrder = 51;
    this.world.add(this.outline);
  }

  setExplode(t) {
    shared.explode.value = t;
    this.outlineSection();
    this.draw();
  }

  /** Marks a cell, over everything; null: none. */
  pick(cell, accent = [0, 0, 0]) {
    this.dispose(this.over);
    if (cell && this.model) {
      const g = this.geometry, columns = {f: g.columns(), e: g.edgeColumns(), v: g.pointColumns()}, none = [0, 0, 0, 0];
      const {model} = this, {cells} = model;
      const face = (f, shift) => {
        g.push(columns.f, g.corners(cells, f), false, accent, none, none, shift, 0);
        for (const loop of cells.faces.loops(f)) g.pushChain(columns.e, cells, loop, true, accent, none, shift, 2, 0);
      };
      const upper = cell.kind === cell.kind.toUpperCase();
      if (upper) {
        const from = model.classes.cells;
        if (cell.kind === 'F') g.push(columns.f, g.corners(from, cell.i), false, accent, none, none, [0, 0, 0], 0);
        if (cell.kind === 'E') g.pushChain(columns.e, from, from.edges.points.of(cell.i), from.edges.flags[cell.i] & 1, accent, none, [0, 0, 0], 4, 0);
      } else if (cell.kind === 'r') {
        for (const shell of cells.regions.shells(cell.i)) for (const side of shell) face(side >> 1, g.shift(cell.i + 1));
      } else {
        for (const shift of g.shiftsOf(cell)) {
          if (cell.kind === 'f') face(cell.i, shift);
          if (cell.kind === 'e') g.pushChain(columns.e, cells, cells.edges.points.of(cell.i), cells.edges.flags[cell.i] & 1, accent, none, shift, 3.6, 0);
          if (cell.kind === 'v') {
            columns.v.position.push(...this.place(model.at(cells.vertices.point[cell.i])));
            columns.v.shift.push(...shift);
            columns.v.tint.push(...accent);
            columns.v.ident.push(...none);
            columns.v.look.push(2.4, 1);
          }
        }
      }
      const add = (object, order) => {
        object.frustumCulled = false;
        object.renderOrder = order;
        this.over.add(object);
      };
      if (columns.f.position.length) add(new THREE.Mesh(buffers(columns.f), this.materials.overFace), 90);
      if (columns.e.a.length) add(new THREE.Mesh(buffers(columns.e, true), this.materials.overEdge), 91);
      if (columns.v.position.length) add(new THREE.Points(buffers(columns.v), this.materials.overPoint), 92);
    }
    this.draw();
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

  draw() {
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
    this.camera.near = Math.max(0.002, far - 4);
    this.camera.far = far + 6;
    this.camera.updateProjectionMatrix();
  }

  render() {
    if (!this.width || !this.model) return;
    const begin = performance.now();
    const coarse = this.moving ? this.quality : 1;
    // Without smoothing the picture at rest is drawn twice as fine, and what moves as fine as the screen.
    const screen = Math.min(window.devicePixelRatio || 1, 2);
    const ratio = this.software && !this.moving ? 2 : screen * (coarse < 1 ? Math.max(coarse, 0.5) : 1);
    if (this.renderer.getPixelRatio() !== ratio || this.drawnWidth !== this.width || this.drawnHeight !== this.height) {
      this.renderer.setPixelRatio(ratio);
      this.renderer.setSize(this.width, this.height, false);
      [this.drawnWidth, this.drawnHeight] = [this.width, this.height];
    }
    const lower = coarse > 0.4 || this.model.size < SMALL;
    if (this.edges) this.edges.visible = lower;
    if (this.points) this.points.visible = lower;
    // Inside of regions something is to be seen only through a missing face or a section.
    if (this.inner) this.inner.visible = !this.look.through && (this.geometry.legend.has('open') || (this.section && this.geometry.ranges.length > CAPS));
    this.prepare(ratio, this.width * ratio, this.height * ratio);
    this.renderer.render(this.root, this.camera);
    if (this.moving) {
      // What the frame took is known when a pixel of it is there.
      const gl = this.renderer.getContext();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      this.frameTime = performance.now() - begin;
      if (this.frameTime > SLOW) this.quality = Math.max(this.quality * 0.6, 0.3);
    }
    this.changed(this.moving);
  }

  /** A picture of numbers of cells: `scale` pixels per CSS pixel, or a window of it about a place. */
  numbers(width, height, about, regions) {
    const target = new THREE.WebGLRenderTarget(width, height, {stencilBuffer: true, depthBuffer: true});
    const hidden = [this.over];
    if (about) this.camera.setViewOffset(this.width, this.height, about[0] - (width >> 1), about[1] - (height >> 1), width, height);
    this.prepare(about ? 1 : width / this.width, width, height);
    shared.ids.value = regions ? 2 : 1;
    for (const object of hidden) object.visible = false;
    if (this.edges) this.edges.visible = true;
    if (this.points) this.points.visible = true;
    if (this.outline) this.outline.visible = false;
    const seen = [];
    for (const m of Object.values(this.materials)) {
      seen.push([m, m.blending, m.transparent, m.depthWrite]);
      m.blending = THREE.NoBlending;
      if (!m.stencilWrite) m.depthWrite = true;
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
    if (this.outline) this.outline.visible = true;
    for (const object of hidden) object.visible = true;
    if (about) this.camera.clearViewOffset();
    target.dispose();
    return bytes;
  }

  /** The cell at a place of the picture, in CSS pixels; vertices before edges before faces. `kinds`: `any` or a letter. */
  at(x, y, kinds) {
    if (!this.model) return null;
    const n = 9, bytes = this.numbers(n, n, [Math.round(x), Math.round(y)], kinds === 'r');
    let best = null, bestRank = Infinity;
    const rank = {v: 0, V: 0, e: 10, E: 10, f: 30, F: 30, r: 31};
    for (let k = 0; k < n * n; ++k) {
      const cell = this.geometry.numbering.cell(bytes[4 * k], bytes[4 * k + 1], bytes[4 * k + 2]);
      if (!cell || (kinds !== 'any' && cell.kind.toLowerCase() !== kinds)) continue;
      const far = Math.hypot((k % n) - 4, Math.floor(k / n) - 4);
      const mine = rank[cell.kind] + (far <= (cell.kind.toLowerCase() === 'f' || cell.kind === 'r' ? 1 : 4.5) ? far : 100);
      if (mine < bestRank) [best, bestRank] = [cell, mine];
    }
    return best;
  }

  /** Where labels may stand: of each cell that is seen a pixel of it near the middle of what is seen of it. */
  labelPlaces() {
    const w = Math.min(Math.round(this.width / 2), 700), h = Math.max(Math.round((w * this.height) / this.width), 1);
    const bytes = this.numbers(w, h, null, false), sums = new Map();
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
    this.drawNow();
    return places;
  }
  drawNow() {
    const ratio = this.renderer.getPixelRatio();
    this.prepare(ratio, this.width * ratio, this.height * ratio);
    this.renderer.render(this.root, this.camera);
  }

  /** The picture as a canvas, `times` as fine as the screen. */
  picture(times) {
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(times);
    this.renderer.setSize(this.width, this.height, false);
    this.prepare(times, this.width * times, this.height * times);
    this.renderer.render(this.root, this.camera);
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [this.canvas.width, this.canvas.height];
    copy.getContext('2d').drawImage(this.canvas, 0, 0);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(this.width, this.height, false);
    this.drawNow();
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
