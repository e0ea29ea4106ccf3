// From the cells of a node to arrays for drawing: few draw calls, whatever the number of cells.
//
// A region is drawn by its own skin: each side of a face that looks into an active region is a triangle of that
// region's, turned outward. So a wall has two skins, one per region, and regions can be pulled apart. A face that
// parts no regions is a sheet and is drawn on both sides. A face that bounds a region and is not of the set is
// hatched, an edge then dashed, a vertex hollow.
//
// What lies between regions all around cannot be seen while these are closed, together and whole: in a large model
// it is left out until regions are pulled apart, cut or seen through. That is most of a model of many regions.
import * as THREE from 'three';
import {mix} from './colours.js';

const HATCHED = 1, SHEETS = 2;

/** A growing array of numbers. */
class Column {
  constructor(Kind, width) {
    this.array = new Kind(1024 * width);
    this.Kind = Kind;
    this.width = width;
    this.length = 0;
  }
  push(a, b, c, d) {
    if (this.length + 4 > this.array.length) {
      const larger = new this.Kind(this.array.length * 2);
      larger.set(this.array);
      this.array = larger;
    }
    const {array, length} = this;
    array[length] = a;
    if (b !== undefined) array[length + 1] = b;
    if (c !== undefined) array[length + 2] = c;
    if (d !== undefined) array[length + 3] = d;
    this.length = length + this.width;
  }
  get done() { return this.array.slice(0, this.length); }
}

/** Numbers of cells as colours of a picture: 0 is no cell. */
export class Numbering {
  constructor(counts) {
    this.ranges = [];
    let next = 1;
    for (const [kind, count] of counts) {
      this.ranges.push({kind, first: next, count});
      next += count;
    }
  }
  bytes(kind, i) {
    const n = this.ranges.find((r) => r.kind === kind).first + i;
    return [n & 255, (n >> 8) & 255, (n >> 16) & 255, 255];
  }
  cell(r, g, b) {
    const n = r | (g << 8) | (b << 16);
    const range = this.ranges.find((x) => n >= x.first && n < x.first + x.count);
    return range ? {kind: range.kind, i: n - range.first} : null;
  }
}

export class Geometry {
  /** `look`: {colour, ink, dark, apart, inner, show: [v, e, f, r], ghosts}; `place`: from the model's space to the scene's. */
  constructor(model, look, place) {
    this.model = model;
    this.look = look;
    this.place = place;
    const {counts} = model, classes = model.classes?.cells;
    this.numbering = new Numbering([['v', counts.v], ['e', counts.e], ['f', counts.f], ['r', counts.r],
      ['V', classes?.vertices.point.length ?? 0], ['E', classes?.edges.flags.length ?? 0], ['F', classes?.faces.flags.length ?? 0]]);
    this.legend = new Map();
    this.classes = look.colour === 'class' && model.classes;
    const {colours} = model.page;
    [this.none, this.sheet, this.wire, this.point] = [colours.none, colours.sheet, colours.wire, colours.point];
    this.centres = this.regionCentres();
    this.skins = this.columns();
    this.sheets = this.columns();
    this.ghosts = this.columns();
    this.edges = this.edgeColumns();
    this.points = this.pointColumns();
    this.ghostEdges = this.edgeColumns();
    this.ranges = [];
    if (this.classes) {
      this.addClasses(false);
    } else {
      this.addFaces();
      if (look.show[1]) this.addEdges();
      if (look.show[0]) this.addVertices();
    }
    if (look.ghosts && model.classes) this.addClasses(true);
  }

  columns() {
    return {position: new Column(Float32Array, 3), normal: new Column(Float32Array, 3), tint: new Column(Uint8Array, 3),
      ident: new Column(Uint8Array, 4), owner: new Column(Uint8Array, 4), shift: new Column(Float32Array, 3), kind: new Column(Uint8Array, 1)};
  }
  edgeColumns() {
    return {a: new Column(Float32Array, 3), b: new Column(Float32Array, 3), shift: new Column(Float32Array, 3), tint: new Column(Uint8Array, 3),
      ident: new Column(Uint8Array, 4), look: new Column(Float32Array, 3)};
  }
  pointColumns() {
    return {position: new Column(Float32Array, 3), shift: new Column(Float32Array, 3), tint: new Column(Uint8Array, 3),
      ident: new Column(Uint8Array, 4), look: new Column(Float32Array, 2)};
  }

  // --- colours

  /** The colour of a cell; what it means is in the legend from then on. */
  tintOf(cell) {
    const {model, look} = this, by = look.colour === 'class' ? 'region' : look.colour, c = model.component(cell);
    const tint = model.colour(by, cell), label = this.meaning(by, cell, c);
    if (label) this.legend.set(label, {label, tint, sign: 'face'});
    return tint;
  }
  meaning(by, cell, c) {
    const {model} = this, {name, material} = model.node.components[c - 1] ?? {};
    if (by === 'source') return [...new Set(model.origin(cell).map((o) => model.page.leaves[o.leaf] || 'frame'))].join(' + ') || 'no leaf';
    if (!c) return '';
    if (by === 'component') return model.componentName(c);
    if (by === 'material' && material) return material;
    if (cell.kind !== 'r') return '';
    if (by === 'region') return `r${cell.i}${name ? ' ' + name : ''}`;
    return model.node.components.some((x) => x.material) ? 'no material' : model.componentName(c);
  }

  // --- geometry

  regionCentres() {
    const {model, place} = this, {faces} = model.cells;
    const boxes = [];
    for (let f = 0; f < model.counts.f; ++f) {
      for (const r of [faces.front[f], faces.back[f]]) {
        if (!model.active(r)) continue;
        const box = (boxes[r - 1] ??= new THREE.Box3());
        for (const p of faces.triangles.of(f)) box.expandByPoint(new THREE.Vector3(...place(model.at(p))));
      }
    }
    const whole = new THREE.Box3();
    boxes.forEach((b) => whole.union(b));
    const middle = whole.getCenter(new THREE.Vector3());
    return boxes.map((b) => b.getCenter(new THREE.Vector3()).sub(middle).toArray());
  }
  /** How far what belongs to region r (from 1; 0: none) moves when regions are pulled apart. */
  shift(r) { return (r && this.centres[r - 1]) || [0, 0, 0]; }

  /** Places and normals at the corners of a face's triangles, front side. */
  corners(cells, f) {
    const {model, place} = this, triangles = cells.faces.triangles.of(f), n = triangles.length;
    const at = new Float64Array(n * 3), normals = new Float32Array(n * 3);
    for (let k = 0; k < n; ++k) at.set(place(model.at(triangles[k], cells)), 3 * k);
    const sum = cells.faces.flags[f] & 2 ? new Map() : null, whole = [0, 0, 0];
    for (let k = 0; k < n; k += 3) {
      const [ax, ay, az, bx, by, bz, cx, cy, cz] = at.subarray(3 * k, 3 * k + 9);
      const x = (by - ay) * (cz - az) - (bz - az) * (cy - ay), y = (bz - az) * (cx - ax) - (bx - ax) * (cz - az),
        z = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
      for (const list of sum ? [0, 1, 2].map((j) => sum.get(triangles[k + j]) ?? sum.set(triangles[k + j], [0, 0, 0]).get(triangles[k + j])) : [whole]) {
        list[0] += x; list[1] += y; list[2] += z;
      }
    }
    for (let k = 0; k < n; ++k) {
      const v = sum ? sum.get(triangles[k]) : whole, size = Math.hypot(...v) || 1;
      normals.set([v[0] / size, v[1] / size, v[2] / size], 3 * k);
    }
    return {at, normals, n};
  }

  push(into, {at, normals, n}, turned, tint, ident, owner, shift, kind) {
    for (let k = 0; k < n; k += 3) {
      for (const j of turned ? [k, k + 2, k + 1] : [k, k + 1, k + 2]) {
        into.position.push(at[3 * j], at[3 * j + 1], at[3 * j + 2]);
        const s = turned ? -1 : 1;
        into.normal.push(s * normals[3 * j], s * normals[3 * j + 1], s * normals[3 * j + 2]);
        into.tint.push(...tint);
        into.ident.push(...ident);
        into.owner.push(...owner);
        into.shift.push(...shift);
        into.kind.push(kind);
      }
    }
  }

  addFaces() {
    const {model, look, numbering} = this, {faces, regions} = model.cells;
    const none = [0, 0, 0, 0];
    if (look.show[3]) {
      for (let r = 0; r < model.counts.r; ++r) {
        if (!regions.component[r]) continue;
        const begin = this.skins.kind.length, tint = this.tintOf({kind: 'r', i: r}), owner = numbering.bytes('r', r);
        for (const shell of regions.shells(r)) {
          for (const code of shell) {
            const f = code >> 1, front = (code & 1) === 0;
            if (faces.front[f] === faces.back[f]) continue;  // hangs in it
            if (!look.inner && model.active(faces.front[f]) && model.active(faces.back[f])) continue;
            const own = faces.component[f];
            const painted = own && ['component', 'source'].includes(look.colour) ? this.tintOf({kind: 'f', i: f}) : tint;
            if (!own) this.legend.set('open', {label: 'missing face', sign: 'hatch', tint});
            this.push(this.skins, this.corners(model.cells, f), front, painted, numbering.bytes('f', f), owner, this.shift(r + 1), own ? 0 : HATCHED);
          }
        }
        this.ranges.push({r, begin, count: this.skins.kind.length - begin, tint});
      }
    }
    if (!look.show[2]) return;
    for (let f = 0; f < model.counts.f; ++f) {
      if (!model.sheet(f)) continue;
      const own = faces.component[f];
      if (!own && !model.active(faces.front[f])) continue;  // bounds nothing that is there
      const tint = own ? this.tintOf({kind: 'f', i: f}) : this.none;
      if (own) this.legend.set('sheet', {label: 'sheet', sign: 'sheet', tint: this.sheet});
      const owner = model.active(faces.front[f]) ? numbering.bytes('r', faces.front[f] - 1) : none;
      this.push(this.sheets, this.corners(model.cells, f), false, tint, numbering.bytes('f', f), owner, this.shift(faces.front[f]), own ? SHEETS : HATCHED);
    }
  }

  pushChain(into, cells, chain, closed, tint, ident, shift, width, dashed) {
    let along = 0;
    for (let k = 0; k + 1 < chain.length + (closed ? 1 : 0); ++k) {
      const a = this.place(this.model.at(chain[k], cells)), b = this.place(this.model.at(chain[(k + 1) % chain.length], cells));
      into.a.push(...a);
      into.b.push(...b);
      into.shift.push(...shift);
      into.tint.push(...tint);
      into.ident.push(...ident);
      into.look.push(width, dashed, along);
      along += Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    }
  }

  /** Shifts at which a cell of lower dimension is drawn: at each region that it bounds, when they are apart. */
  shiftsOf(cell) {
    if (!this.look.apart) return [[0, 0, 0]];
    const regions = this.model.regionsAt(cell).filter((r) => this.model.active(r + 1));
    return regions.length ? regions.map((r) => this.shift(r + 1)) : [[0, 0, 0]];
  }

  /** True if every sector about an edge is of an active region. */
  enclosed(e) {
    const {uses, regions} = this.model.radial;
    for (let k = uses.starts[e]; k < uses.starts[e + 1]; ++k) if (!this.model.active(regions[k])) return false;
    return uses.starts[e] < uses.starts[e + 1];
  }

  addEdges() {
    const {model, look, numbering} = this, {edges} = model.cells;
    const painted = ['component', 'source', 'material'].includes(look.colour);
    const faceless = new Uint8Array(model.counts.e), border = new Uint8Array(model.counts.e);
    for (let e = 0; e < model.counts.e; ++e) {
      faceless[e] = edges.flags[e] & 8 ? 1 : 0;
      border[e] = !faceless[e] && model.radial.uses.of(e).length === 1 ? 1 : 0;
    }
    for (let e = 0; e < model.counts.e; ++e) {
      const cell = {kind: 'e', i: e}, own = edges.component[e], wire = faceless[e] && own;
      if (!look.inner && !wire && this.enclosed(e)) continue;
      if (!own && !model.radial.uses.of(e).some((f) => model.cells.faces.component[f] || model.active(model.cells.faces.front[f]) || model.active(model.cells.faces.back[f]))) continue;
      if (wire) this.legend.set('wire', {label: 'wire', sign: 'wire', tint: this.wire});
      if (!own) this.legend.set('dashed', {label: 'missing edge', sign: 'dash', tint: look.ink});
      const plain = look.colour === 'region' || (look.colour === 'material' && !model.node.components[own - 1]?.material);
      const tint = wire && plain ? (look.dark ? mix(this.wire, [255, 255, 255], 0.35) : this.wire)
        : painted && own && (wire || look.colour !== 'material') ? mix(this.tintOf(cell), look.ink, 0.4) : look.ink;
      const width = wire ? 3.2 : border[e] ? 2.0 : 1;
      for (const shift of this.shiftsOf(cell)) {
        this.pushChain(this.edges, model.cells, edges.points.of(e), edges.flags[e] & 1, tint, numbering.bytes('e', e), shift, width, own ? 0 : 1);
      }
    }
  }

  addVertices() {
    const {model, look, numbering} = this, {vertices, edges} = model.cells;
    const ends = new Uint8Array(model.cells.points.length);  // 1: of edges between regions only, 2: of others
    for (let e = 0; e < model.counts.e; ++e) {
      const chain = edges.points.of(e), kind = !look.inner && this.enclosed(e) ? 1 : 2;
      if (edges.flags[e] & 1) continue;
      for (const p of [chain[0], chain[chain.length - 1]]) ends[p] = Math.max(ends[p], kind);
    }
    for (let v = 0; v < model.counts.v; ++v) {
      const cell = {kind: 'v', i: v}, p = vertices.point[v], own = vertices.component[v], alone = !ends[p] && own;
      if (ends[p] === 1) continue;
      if (alone) this.legend.set('point', {label: 'isolated point', sign: 'point', tint: this.point});
      if (!own) this.legend.set('hollow', {label: 'missing vertex', sign: 'hollow', tint: look.ink});
      const tint = alone ? (look.dark ? mix(this.point, [255, 255, 255], 0.35) : this.point) : look.ink;
      for (const shift of this.shiftsOf(cell)) {
        this.points.position.push(...this.place(model.at(p)));
        this.points.shift.push(...shift);
        this.points.tint.push(...tint);
        this.points.ident.push(...numbering.bytes('v', v));
        this.points.look.push(alone ? 2 : 1, alone ? 2 : own ? 0 : 1);
      }
    }
  }

  /** The lines in which a plane n·p + d = 0 cuts what is drawn, as edges a little on the side where n points. */
  cutLines(n, d, explode, ink) {
    const out = this.edgeColumns(), zero = [0, 0, 0], none = [0, 0, 0, 0];
    for (const {position, shift} of [this.skins, this.sheets]) {
      const p = position.array, s = shift.array, at = (i) => p[i] + s[i] * explode;
      for (let t = 0; t < position.length; t += 9) {
        const corners = [0, 3, 6].map((k) => [at(t + k), at(t + k + 1), at(t + k + 2)]);
        const far = corners.map((c) => n[0] * c[0] + n[1] * c[1] + n[2] * c[2] + d);
        const ends = [];
        for (let k = 0; k < 3; ++k) {
          const j = (k + 1) % 3;
          if (far[k] < 0 === far[j] < 0) continue;
          const w = far[k] / (far[k] - far[j]);
          ends.push(corners[k].map((x, i) => x + (corners[j][i] - x) * w + n[i] * 2e-4));
        }
        if (ends.length !== 2) continue;
        out.a.push(...ends[0]);
        out.b.push(...ends[1]);
        out.shift.push(...zero);
        out.tint.push(...ink);
        out.ident.push(...none);
        out.look.push(1, 0, 0);
      }
    }
    return out;
  }

  /** What became of the operands' entities: those that were kept, or those that were removed, as ghosts. */
  addClasses(removed) {
    const {model, look, numbering} = this, {cells, fates} = model.classes;
    const fate = (component) => {
      const found = fates[component];
      return found && found.removed === removed ? found : null;
    };
    const tint = (f) => {
      const t = model.page.colours.relations[f.relation] ?? this.none;
      if (this.classes) this.legend.set(f.relation ?? '', {label: f.relation ?? 'no table', tint: t, sign: 'face'});
      return this.classes || look.colour === 'class' ? t : this.none;
    };
    if (removed) this.legend.set('ghost', {label: 'removed', sign: 'ghost', tint: this.none});
    const zero = [0, 0, 0], none = [0, 0, 0, 0];
    for (let i = 0; i < cells.faces.flags.length; ++i) {
      const f = fate(cells.faces.component[i]);
      if (!f || !(look.show[2] || look.show[3])) continue;
      this.push(removed ? this.ghosts : this.sheets, this.corners(cells, i), false, tint(f), numbering.bytes('F', i), none, zero, 0);
    }
    if (look.show[1]) {
      for (let i = 0; i < cells.edges.flags.length; ++i) {
        const f = fate(cells.edges.component[i]);
        if (f) this.pushChain(removed ? this.ghostEdges : this.edges, cells, cells.edges.points.of(i), cells.edges.flags[i] & 1,
          this.classes ? mix(tint(f), look.ink, 0.35) : mix(look.ink, this.none, 0.6), numbering.bytes('E', i), zero, removed ? 1 : 1.4, removed ? 1 : 0);
      }
    }
    if (!look.show[0] || removed) return;
    for (let i = 0; i < cells.vertices.point.length; ++i) {
      const f = fate(cells.vertices.component[i]);
      if (!f) continue;
      this.points.position.push(...this.place(model.at(cells.vertices.point[i], cells)));
      this.points.shift.push(...zero);
      this.points.tint.push(...mix(tint(f), look.ink, 0.35));
      this.points.ident.push(...numbering.bytes('V', i));
      this.points.look.push(1, 0);
    }
  }
}

const NORMALIZED = new Set(['tint', 'ident', 'owner']);
export function buffers(columns, instanced = false) {
  const geometry = instanced ? new THREE.InstancedBufferGeometry() : new THREE.BufferGeometry();
  const Attribute = instanced ? THREE.InstancedBufferAttribute : THREE.BufferAttribute;
  for (const [name, column] of Object.entries(columns)) {
    geometry.setAttribute(name, new Attribute(column.done, column.width, NORMALIZED.has(name)));
  }
  if (instanced) {
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    geometry.instanceCount = columns.a.length / 3;
  }
  return geometry;
}
