// From the cells of a node to arrays for drawing: few draw calls, whatever the number of cells.
//
// A region is drawn by its own skin: each side of a face that looks into an active region is a triangle of that
// region's, turned outward. So a wall has two skins, one per region, and regions can be pulled apart. A face that
// parts no regions is a sheet and is drawn on both sides. A face that bounds a region and is not of the set is
// hatched, an edge then dashed, a vertex hollow.
//
// What lies between regions all around cannot be seen while these are closed, together and whole: in a large model
// it is left out until regions are pulled apart, cut or seen through. That is most of a model of many regions.
import {mix} from './colors.js';
import {EDGES, Faces, POINTS, put3, put4, Table} from './tables.js';

export const HATCHED = 1, SHEETS = 2;
const NOTHING = [0, 0, 0, 0], STILL = [0, 0, 0];
const MANY = 20000;  // plain edges that are drawn as ribbons; more are lines of one pixel

/** Numbers of cells as colors of a picture: 0 is no cell. */
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
  /** `look`: {color, ink, dark, apart, inner, show: [v, e, f, r], ghosts, hidden: keys of the legend}; `place`: from the model's space to the scene's. */
  constructor(model, look, place) {
    this.model = model;
    this.look = look;
    this.place = place;
    const {counts} = model, classes = model.classes?.cells;
    this.numbering = new Numbering([['v', counts.v], ['e', counts.e], ['f', counts.f], ['r', counts.r],
      ['V', classes?.vertices.point.length ?? 0], ['E', classes?.edges.flags.length ?? 0], ['F', classes?.faces.flags.length ?? 0]]);
    this.legend = new Map();
    this.gone = new Set();  // regions that are hidden
    this.classes = look.color === 'class' && model.classes;
    const {colors} = model.page;
    [this.none, this.sheet, this.wire, this.point] = [colors.none, colors.sheet, colors.wire, colors.point];
    this.centres = this.regionCentres();
    this.skins = new Faces();
    this.sheets = new Faces();
    this.ghosts = new Faces();
    this.edges = new Table(EDGES);  // those of a width of their own, or dashed
    this.plain = new Table(EDGES);
    this.points = new Table(POINTS);
    this.ghostEdges = new Table(EDGES);
    /** `{r, begin, end, tint}`: the triangles of `skins` that are region r's. */
    this.ranges = [];
    if (this.classes) {
      this.addClasses(false);
    } else {
      this.addFaces();
      if (look.show[1]) this.addEdges();
      if (look.show[0]) this.addVertices();
    }
    if (look.ghosts && model.classes) this.addClasses(true);
    /** How far from the middle of the scene anything is, and how much farther when regions are pulled apart by 1. */
    this.reach = Math.max(model.cells.reach, classes?.reach ?? 0);
    this.reachApart = this.centres.reduce((most, _, i, all) => (i % 3 ? most : Math.max(most, Math.hypot(all[i], all[i + 1], all[i + 2]))), 0);
  }
  get plainAsLines() { return this.plain.length > MANY; }
  get triangles() { return this.skins.triangles.length + this.sheets.triangles.length; }

  // --- colors

  /** The color of a cell; what it means is in the legend from then on. */
  tintOf(cell) {
    const {model, look} = this, by = look.color === 'class' ? 'region' : look.color, c = model.component(cell);
    const tint = model.color(by, cell), label = this.meaning(by, cell, c);
    if (label) this.legend.set(label, {label, tint, sign: 'face'});
    return tint;
  }
  /** A sign in the legend; true if what it stands for is hidden. */
  sign(key, label, tint, sign = key) {
    this.legend.set(key, {label, tint, sign});
    return this.look.hidden.has(key);
  }
  /** True for a cell whose entry of the legend is hidden. */
  hides(cell) {
    const {look: {color, hidden}, model} = this;
    return hidden.size > 0 && hidden.has(this.meaning(color === 'class' ? 'region' : color, cell, model.component(cell)));
  }
  meaning(by, cell, c) {
    const {model} = this, {name, material} = model.node.components[c - 1] ?? {};
    if (by === 'source') return [...new Set(model.origin(cell).map((o) => model.page.leaves[o.leaf] || 'frame'))].join(' + ') || 'no leaf';
    if (!c) return '';
    if (by === 'component') return model.componentName(c);
    const own = model.said(cell)?.material;
    if (by === 'material' && (own || material)) return own || material;
    if (cell.kind !== 'r') return '';
    if (by === 'region') return `r${cell.i}${name ? ' ' + name : ''}`;
    return model.node.components.some((x) => x.material) ? 'no material' : model.componentName(c);
  }

  /** True where a sheet, a wire or a point is shown in the color of its own material, not in that of its kind. */
  ownMaterial(cell) { return this.look.color === 'material' && Boolean(this.model.said(cell)?.material); }

  // --- geometry

  /** Where the points of the cells are in the scene. */
  placed(cells) {
    if (cells.placed) return cells.placed;
    const out = (cells.placed = new Float64Array(3 * cells.points.length));
    cells.reach = 0;
    for (let p = 0; p < cells.points.length; ++p) {
      const at = this.place(this.model.at(p, cells));
      put3(out, p, at);
      cells.reach = Math.max(cells.reach, Math.hypot(...at));
    }
    return out;
  }

  /** The middle of each region's box, from the middle of them all. */
  regionCentres() {
    const {model} = this, {faces} = model.cells, at = this.placed(model.cells), n = model.counts.r;
    const low = new Float64Array(3 * n).fill(Infinity), high = new Float64Array(3 * n).fill(-Infinity);
    for (let f = 0; f < model.counts.f; ++f) {
      for (const r of [faces.front[f], faces.back[f]]) {
        if (!model.active(r)) continue;
        for (const p of faces.triangles.of(f)) {
          for (let k = 0; k < 3; ++k) {
            const x = at[3 * p + k], b = 3 * (r - 1) + k;
            if (x < low[b]) low[b] = x;
            if (x > high[b]) high[b] = x;
          }
        }
      }
    }
    const middle = [0, 1, 2].map((k) => {
      let a = Infinity, b = -Infinity;
      for (let i = k; i < 3 * n; i += 3) (a = Math.min(a, low[i])), (b = Math.max(b, high[i]));
      return (a + b) / 2;
    });
    [this.low, this.high] = [low, high];
    return low.map((x, i) => (x <= high[i] ? (x + high[i]) / 2 - middle[i % 3] : 0));
  }
  /** How far what belongs to region r (from 1; 0: none) moves when regions are pulled apart. */
  shift(r) { return r ? this.centres.subarray(3 * r - 3, 3 * r) : STILL; }

  /** A face as triangles; `turned`: its back. A corner is shared by the triangles of a face. */
  pushFace(into, cells, f, turned, tint, ident, owner, shift, kind) {
    const at = this.placed(cells), triangles = cells.faces.triangles.of(f), {corners} = into, n = triangles.length;
    const local = (cells.local ??= new Int32Array(cells.points.length).fill(-1)), first = corners.length;
    for (let k = 0; k < n; ++k) {
      const p = triangles[k];
      if (local[p] >= 0) continue;
      const row = (local[p] = corners.add());
      for (let j = 0; j < 3; ++j) corners.position[3 * row + j] = at[3 * p + j];
      put3(corners.shift, row, shift);
      put4(corners.tint, row, tint, kind);
      put4(corners.ident, row, ident);
      put4(corners.owner, row, owner);
    }
    const {normal} = corners, last = corners.length, smooth = cells.faces.flags[f] & 2, s = turned ? -1 : 1;
    for (let k = 0; k < n; k += 3) {
      const a = triangles[k], b = triangles[k + 1], c = triangles[k + 2], row = into.triangles.add();
      put3(into.triangles.corner, row, turned ? [local[a], local[c], local[b]] : [local[a], local[b], local[c]]);
      const ux = at[3 * b] - at[3 * a], uy = at[3 * b + 1] - at[3 * a + 1], uz = at[3 * b + 2] - at[3 * a + 2];
      const vx = at[3 * c] - at[3 * a], vy = at[3 * c + 1] - at[3 * a + 1], vz = at[3 * c + 2] - at[3 * a + 2];
      const x = s * (uy * vz - uz * vy), y = s * (uz * vx - ux * vz), z = s * (ux * vy - uy * vx);
      // Of a flat face all triangles have one normal; the first corner gathers it.
      for (const i of smooth ? [local[a], local[b], local[c]] : [first]) {
        normal[3 * i] += x;
        normal[3 * i + 1] += y;
        normal[3 * i + 2] += z;
      }
    }
    for (let i = first; i < last; ++i) {
      const from = smooth ? i : first, x = normal[3 * from], y = normal[3 * from + 1], z = normal[3 * from + 2];
      const size = i === first || smooth ? Math.hypot(x, y, z) || 1 : 1;
      put3(normal, i, [x / size, y / size, z / size]);
    }
    for (let k = 0; k < n; ++k) local[triangles[k]] = -1;
  }

  addFaces() {
    const {model, look, numbering} = this, {faces, regions} = model.cells;
    if (look.show[3]) {
      for (let r = 0; r < model.counts.r; ++r) {
        if (!regions.component[r]) continue;
        const begin = this.skins.triangles.length, tint = this.tintOf({kind: 'r', i: r}), owner = numbering.bytes('r', r);
        if (this.hides({kind: 'r', i: r})) {
          this.gone.add(r);
          continue;
        }
        for (const shell of regions.shells(r)) {
          for (const code of shell) {
            const f = code >> 1, front = (code & 1) === 0;
            if (faces.front[f] === faces.back[f]) continue;  // hangs in it
            if (!look.inner && model.active(faces.front[f]) && model.active(faces.back[f])) continue;
            const own = faces.component[f];
            const painted = own && (['component', 'source'].includes(look.color) || this.ownMaterial({kind: 'f', i: f})) ? this.tintOf({kind: 'f', i: f}) : tint;
            if (!own && this.sign('open', 'missing face', tint, 'hatch')) continue;
            this.pushFace(this.skins, model.cells, f, front, painted, numbering.bytes('f', f), owner, this.shift(r + 1), own ? 0 : HATCHED);
          }
        }
        this.ranges.push({r, begin, end: this.skins.triangles.length, tint});
      }
    }
    if (!look.show[2]) return;
    for (let f = 0; f < model.counts.f; ++f) {
      if (!model.sheet(f)) continue;
      const own = faces.component[f];
      if (!own && !model.active(faces.front[f])) continue;  // bounds nothing that is there
      const tint = own ? this.tintOf({kind: 'f', i: f}) : this.none;
      const named = own && this.ownMaterial({kind: 'f', i: f});
      if (own && (named ? this.hides({kind: 'f', i: f}) : this.sign('sheet', 'sheet', this.sheet))) continue;
      const owner = model.active(faces.front[f]) ? numbering.bytes('r', faces.front[f] - 1) : NOTHING;
      this.pushFace(this.sheets, model.cells, f, false, tint, numbering.bytes('f', f), owner, this.shift(faces.front[f]), own ? SHEETS : HATCHED);
    }
  }

  pushChain(into, cells, chain, closed, tint, ident, shift, width, dashed) {
    const at = this.placed(cells), n = chain.length + (closed ? 1 : 0);
    let along = 0;
    for (let k = 0; k + 1 < n; ++k) {
      const p = 3 * chain[k], q = 3 * chain[(k + 1) % chain.length], row = into.add();
      for (let j = 0; j < 3; ++j) {
        into.a[3 * row + j] = at[p + j];
        into.b[3 * row + j] = at[q + j];
      }
      put3(into.shift, row, shift);
      put4(into.tint, row, tint, 255);
      put4(into.ident, row, ident);
      put3(into.look, row, [width, dashed, along]);
      along += Math.hypot(at[q] - at[p], at[q + 1] - at[p + 1], at[q + 2] - at[p + 2]);
    }
  }
  pushPoint(into, cells, p, tint, ident, shift, size, hollow) {
    const at = this.placed(cells), row = into.add();
    for (let j = 0; j < 3; ++j) into.position[3 * row + j] = at[3 * p + j];
    put3(into.shift, row, shift);
    put4(into.tint, row, tint, 255);
    put4(into.ident, row, ident);
    into.look[2 * row] = size;
    into.look[2 * row + 1] = hollow;
  }

  /** True if a cell lies at hidden regions only, and at no sheet. */
  goesWith(cell, faces) {
    if (!this.gone.size) return false;
    const around = this.model.regionsAt(cell).filter((r) => this.model.active(r + 1));
    return around.length > 0 && around.every((r) => this.gone.has(r)) && !faces.some((f) => this.model.sheet(f));
  }

  /** Shifts at which a cell of lower dimension is drawn: at each region that it bounds, when they are apart. */
  shiftsOf(cell) {
    if (!this.look.apart) return [STILL];
    const regions = this.model.regionsAt(cell).filter((r) => this.model.active(r + 1));
    return regions.length ? regions.map((r) => this.shift(r + 1)) : [STILL];
  }

  /** True if every sector about an edge is of an active region. */
  enclosed(e) {
    const {uses, regions} = this.model.radial;
    for (let k = uses.starts[e]; k < uses.starts[e + 1]; ++k) if (!this.model.active(regions[k])) return false;
    return uses.starts[e] < uses.starts[e + 1];
  }

  addEdges() {
    const {model, look, numbering} = this, {edges} = model.cells;
    const painted = ['component', 'source', 'material'].includes(look.color);
    const faceless = new Uint8Array(model.counts.e), border = new Uint8Array(model.counts.e);
    for (let e = 0; e < model.counts.e; ++e) {
      faceless[e] = edges.flags[e] & 8 ? 1 : 0;
      border[e] = !faceless[e] && model.radial.uses.of(e).length === 1 ? 1 : 0;
    }
    for (let e = 0; e < model.counts.e; ++e) {
      const cell = {kind: 'e', i: e}, own = edges.component[e], wire = faceless[e] && own;
      if (!look.inner && !wire && this.enclosed(e)) continue;
      if (!own && !model.radial.uses.of(e).some((f) => model.cells.faces.component[f] || model.active(model.cells.faces.front[f]) || model.active(model.cells.faces.back[f]))) continue;
      if (wire ? (this.ownMaterial(cell) ? this.hides(cell) : this.sign('wire', 'wire', this.wire)) : this.goesWith(cell, model.radial.uses.of(e))) continue;
      if (!own && this.sign('dashed', 'missing edge', look.ink, 'dash')) continue;
      const plain = look.color === 'region' || (look.color === 'material' && !model.node.components[own - 1]?.material && !this.ownMaterial(cell));
      const tint = wire && plain ? (look.dark ? mix(this.wire, [255, 255, 255], 0.35) : this.wire)
        : painted && own && (wire || look.color !== 'material') ? mix(this.tintOf(cell), look.ink, 0.4) : look.ink;
      const width = wire ? 3.2 : border[e] ? 2.0 : 1;
      for (const shift of this.shiftsOf(cell)) {
        this.pushChain(width === 1 && own ? this.plain : this.edges, model.cells, edges.points.of(e), edges.flags[e] & 1, tint, numbering.bytes('e', e), shift, width, own ? 0 : 1);
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
      if (alone ? (this.ownMaterial(cell) ? this.hides(cell) : this.sign('point', 'isolated point', this.point))
        : this.gone.size && this.goesWith(cell, model.incidence.vertexFaces.of(v)) && !model.incidence.vertexEdges.of(v).some((e) => edges.flags[e] & 8)) continue;
      if (!own && this.sign('hollow', 'missing vertex', look.ink)) continue;
      const tint = alone && this.ownMaterial(cell) ? this.tintOf(cell) : alone ? (look.dark ? mix(this.point, [255, 255, 255], 0.35) : this.point) : look.ink;
      for (const shift of this.shiftsOf(cell)) {
        this.pushPoint(this.points, model.cells, p, tint, numbering.bytes('v', v), shift, alone ? 2 : 1, alone ? 2 : own ? 0 : 1);
      }
    }
  }

  /** Where an entity of the operands is drawn: with the regions of the result that it touches. */
  classShifts(kind, i) {
    const {model} = this;
    if (!this.look.apart) return [STILL];
    const regions = [...model.classRegions(kind, i)].filter((r) => model.active(r));
    return regions.length ? regions.map((r) => this.shift(r)) : [STILL];
  }

  /** What became of the operands' entities: those that were kept, or those that were removed, as ghosts. */
  addClasses(removed) {
    const {model, look, numbering} = this, {cells, fates} = model.classes;
    const fate = (component) => {
      const found = fates[component];
      return found && found.removed === removed ? found : null;
    };
    const tint = (f) => model.page.colors.relations[f.relation] ?? this.none;
    const shown = this.classes || look.color === 'class' ? tint : () => this.none;
    const hidden = (f) => (removed && this.sign('ghost', 'removed', this.none)) || (this.classes && this.sign(f.relation ?? '', f.relation ?? 'no table', tint(f), 'face'));
    const of = (column, kind, push) => {
      for (let i = 0; i < column.length; ++i) {
        const f = fate(column[i]);
        if (f && !hidden(f)) for (const shift of this.classShifts(kind, i)) push(i, f, shift);
      }
    };
    if (look.show[2] || look.show[3]) {
      of(cells.faces.component, 'F', (i, f, shift) => this.pushFace(removed ? this.ghosts : this.sheets, cells, i, false, shown(f), numbering.bytes('F', i), NOTHING, shift, 0));
    }
    if (look.show[1]) {
      of(cells.edges.component, 'E', (i, f, shift) => this.pushChain(removed ? this.ghostEdges : this.edges, cells, cells.edges.points.of(i), cells.edges.flags[i] & 1,
        this.classes ? mix(tint(f), look.ink, 0.35) : mix(look.ink, this.none, 0.6), numbering.bytes('E', i), shift, removed ? 1 : 1.4, removed ? 1 : 0));
    }
    if (!look.show[0] || removed) return;
    of(cells.vertices.component, 'V', (i, f, shift) => this.pushPoint(this.points, cells, cells.vertices.point[i], mix(shown(f), look.ink, 0.35), numbering.bytes('V', i), shift, 1, 0));
  }
}
