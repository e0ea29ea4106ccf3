// One node of the page: its cells, who bounds whom, and what is told of each. Cells are called as files call them;
// here a cell is a letter and a number, `{kind: 'f', i: 12}`.
import {Lists, pairsAsLists, readCells, readLists, unpack} from './data.js';

export const LETTERS = ['v', 'e', 'f', 'r'];
export const WORDS = {v: 'vertex', e: 'edge', f: 'face', r: 'region'};
/** Cells of a model of which everything is drawn, seen or not. */
export const SMALL = 20000;
export const nameOf = (cell) => cell.kind + cell.i;
export const minus = (a, b) => a.map((x, k) => x - b[k]);

/** A double as the fraction that it is exactly, as exact files write it. */
export function fraction(x) {
  let denominator = 1n;
  while (!Number.isInteger(x)) {
    x *= 2;
    denominator *= 2n;
  }
  return denominator === 1n ? BigInt(x).toString() : `${BigInt(x)}/${denominator}`;
}

export class Model {
  constructor(page, index) {
    this.page = page;
    this.index = index;
    this.node = page.nodes[index];
    this.cells = readCells(this.node.cells);
    const {vertices, edges, faces, regions} = this.cells;
    this.counts = {v: vertices.point.length, e: edges.flags.length, f: faces.flags.length, r: regions.component.length};
    const {radial, stories, shapes, classes, colors} = this.node;
    this.radial = {from: unpack(radial.from), to: unpack(radial.to), uses: new Lists(unpack(radial.counts), unpack(radial.faces)),
      regions: unpack(radial.regions), angles: unpack(radial.angles)};
    this.stories = stories && new Lists(unpack(stories.lines_counts), unpack(stories.lines));
    this.shapes = shapes && {v: unpack(shapes.vertices), e: unpack(shapes.edges)};
    this.colors = {material: {}, component: unpack(colors.component), region: unpack(colors.region)};
    for (const kind of LETTERS) this.colors.material[kind] = unpack(colors.material[kind]);
    this.classes = classes && {cells: readCells(classes), fates: classes.fates, told_at: classes.told_at,
      of: {v: readLists(classes.of, 'v'), e: readLists(classes.of, 'e'), f: readLists(classes.of, 'f')},
      stories: classes.told_at && new Lists(unpack(classes.lines_counts), unpack(classes.lines))};
  }

  static of(page, index) {
    if (!page.models.has(index)) page.models.set(index, new Model(page, index));
    return page.models.get(index);
  }

  column(kind) { return {v: this.cells.vertices, e: this.cells.edges, f: this.cells.faces, r: this.cells.regions}[kind]; }
  has(cell) { return cell && cell.i < this.counts[cell.kind]; }
  component(cell) { return this.column(cell.kind).component[cell.i]; }
  /** Number of a component as text, with what people call it. */
  componentName(c) {
    if (c === 0) return 'outside';
    const {name} = this.node.components[c - 1] ?? {};
    return name ? `${c} ${name}` : `component ${c}`;
  }
  /** What is said of a cell: of a sheet, a wire or a point by itself, of a region, or a cell of a component without
   *  regions, what is said of the component; null: nothing. */
  said(cell) {
    const number = this.column(cell.kind).said?.[cell.i], own = number ? this.node.said[number - 1] : null;
    if (own || (this.node.group && cell.kind !== 'r')) return own;
    return this.node.components[this.component(cell) - 1] ?? null;
  }
  /** The color of a cell by `region`, `material`, `component` or `source`. */
  color(by, cell) {
    const {page: {colors}, colors: mine} = this;
    if (by === 'region' && cell.kind !== 'r') return {v: colors.point, e: colors.wire, f: colors.sheet}[cell.kind];
    const own = by === 'material' ? this.said(cell)?.color : undefined;
    const number = own !== undefined ? own : by === 'region' ? mine.region[cell.i]
      : by === 'material' ? mine.material[cell.kind][this.component(cell)]
      : by === 'source' ? colors.sources[this.column(cell.kind).origin[cell.i]]
      : mine.component[this.component(cell)];
    return colors.all[number];
  }
  active(region) { return region > 0 && this.cells.regions.component[region - 1] !== 0; }

  /** Faces that hang in one region or in none. */
  sheet(f) {
    const {front, back} = this.cells.faces;
    return front[f] === back[f] || (!this.active(front[f]) && !this.active(back[f]));
  }

  /** True if a region can be looked into: one of its faces is not of the set. */
  get open() {
    const {component, front, back} = this.cells.faces;
    return (this._open ??= component.some((c, f) => !c && front[f] !== back[f] && (this.active(front[f]) || this.active(back[f]))));
  }
  get size() { return this.counts.v + this.counts.e + this.counts.f + this.counts.r; }

  /** Where point `p` of the node is, exactly, as three texts. */
  exact(p) {
    const global = this.cells.points[p];
    return this.page.exact.get(global) ?? [0, 1, 2].map((k) => fraction(this.page.points[3 * global + k]));
  }
  at(p, cells = this.cells) {
    const g = 3 * cells.points[p];
    return [this.page.points[g], this.page.points[g + 1], this.page.points[g + 2]];
  }

  /** Of an edge, and of a face, from rounded places; of curved ones along their facets. */
  length(e) {
    const chain = this.cells.edges.points.of(e), closed = this.cells.edges.flags[e] & 1;
    return Array.from(chain, (p, k) => (k + 1 < chain.length || closed ? Math.hypot(...minus(this.at(chain[(k + 1) % chain.length]), this.at(p))) : 0)).reduce((a, b) => a + b, 0);
  }
  area(f) {
    const t = this.cells.faces.triangles.of(f);
    let sum = 0;
    for (let k = 0; k < t.length; k += 3) {
      const a = this.at(t[k]), u = minus(this.at(t[k + 1]), a), v = minus(this.at(t[k + 2]), a);
      sum += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
    }
    return sum;
  }

  story(cell) {
    if (!this.stories) return null;
    const before = {v: 0, e: this.counts.v, f: this.counts.v + this.counts.e, r: this.counts.v + this.counts.e + this.counts.f};
    return Array.from(this.stories.of(before[cell.kind] + cell.i), (line) => this.page.lines[line]);
  }
  /** A cell that came from the leaves of a name, of the highest dimension that there is. */
  fromLeaf(name) {
    const {leaves, origins} = this.page, numbers = new Set();
    origins.forEach((lists, i) => lists.some(([leaf]) => leaves[leaf] === name) && numbers.add(i + 1));
    for (const kind of ['r', 'f', 'e', 'v']) {
      const i = this.column(kind).origin.findIndex((n) => numbers.has(n));
      if (i >= 0) return {kind, i};
    }
    return null;
  }
  /** Of an entity of the operands that went (`{kind: 'F', i}`): what is told of a point in it, and that point. */
  lost(cell) {
    const {cells, stories, told_at} = this.classes, v = cells.vertices.point.length, e = cells.edges.flags.length;
    const i = {V: 0, E: v, F: v + e}[cell.kind] + cell.i;
    return stories && told_at[i] ? {point: told_at[i], lines: Array.from(stories.of(i), (line) => this.page.lines[line])} : null;
  }
  /** Fates of the operands' entities of which a cell of the result is made, or of one of those entities. */
  fates(cell) {
    if (!this.classes || cell.kind === 'r') return [];
    const {cells, fates, of} = this.classes, of_class = {V: cells.vertices, E: cells.edges, F: cells.faces}[cell.kind];
    return Array.from(of_class ? [of_class.component[cell.i]] : of[cell.kind].of(cell.i), (c) => fates[c]).filter(Boolean);
  }
  /** The rows of the tables that decided on a cell. */
  rowsOf(cell) {
    const dimension = 'vef'.indexOf(cell.kind.toLowerCase());
    return this.fates(cell).map((f) => f.rows?.[dimension]?.[0]).filter(Boolean);
  }
  /** The entities of the operands about which a row was asked: `[{kind: 'F', i}]`. */
  ofRow(id) {
    if (!this.classes) return [];
    const {cells, fates} = this.classes, out = [];
    [['V', cells.vertices], ['E', cells.edges], ['F', cells.faces]].forEach(([kind, {component}], dimension) => {
      const asked = new Set(Object.entries(fates).filter(([, f]) => f.rows?.[dimension]?.[0] === id).map(([c]) => Number(c)));
      if (asked.size) component.forEach((c, i) => asked.has(c) && out.push({kind, i}));
    });
    return out;
  }

  /** Regions of the result (from 1) that an entity of the operands touches: a face by its sides, an edge or a vertex by
   *  the faces at its points, a wire by the wire of the result. */
  classRegions(kind, i) {
    const {cells} = this.classes, {faces} = cells;
    if (kind === 'F') return new Set([faces.front[i], faces.back[i]].filter((r) => r));
    const key = (from, p, q) => (q === undefined ? String(from.points[p]) : [from.points[p], from.points[q]].sort((a, b) => a - b).join());
    if (!this._classRegions) {
      const found = (this._classRegions = new Map());
      const add = (k, regions) => regions.forEach((r) => r && (found.get(k) ?? found.set(k, new Set()).get(k)).add(r));
      const walk = (from, points, closed, regions) => points.forEach((p, k) => {
        add(key(from, p), regions);
        if (closed || k + 1 < points.length) add(key(from, p, points[(k + 1) % points.length]), regions);
      });
      for (let f = 0; f < faces.flags.length; ++f) for (const loop of faces.loops(f)) walk(cells, loop, true, [faces.front[f], faces.back[f]]);
      const {edges, vertices} = this.cells;
      for (let e = 0; e < this.counts.e; ++e) walk(this.cells, edges.points.of(e), edges.flags[e] & 1, [edges.region[e]]);
      vertices.region.forEach((r, v) => add(key(this.cells, vertices.point[v]), [r]));
    }
    const at = kind === 'V' ? key(cells, cells.vertices.point[i]) : key(cells, ...cells.edges.points.of(i).subarray(0, 2));
    return this._classRegions.get(at) ?? new Set();
  }

  /** True if a small closed model hides something: a cell without thickness in a region, a cavity, or a region among others. */
  get hides() {
    const {faces, edges, vertices, regions} = this.cells, within = (r) => r > 0 && this.active(r);
    return (this._hides ??= this.size < SMALL && (edges.region.some(within) || vertices.region.some(within)
      || faces.front.some((r, f) => within(r) && r === faces.back[f])
      || regions.component.some((c, r) => !c && regions.bounded[r] && regions.shells(r).some((shell) => shell.some((side) => within(faces.front[side >> 1]) || within(faces.back[side >> 1]))))
      || regions.component.some((c, r) => c && regions.shells(r).every((shell) => shell.every((side) => within(faces.front[side >> 1]) && within(faces.back[side >> 1]))))));
  }

  shape(cell) {
    const word = this.shapes?.[cell.kind]?.[cell.i];
    return word ? this.page.words[word - 1] : null;
  }
  /** Of the leaves' cells that a cell came from: `[{leaf, text}]`. */
  origin(cell) {
    const number = this.column(cell.kind).origin[cell.i];
    if (!number) return [];
    const words = [['an isolated point', ''], ['wire ', 'wires '], ['face ', 'faces '], ['region ', 'regions ']];
    return this.page.origins[number - 1].map(([leaf, dimension, ...numbers]) => ({
      leaf, text: dimension === 0 ? words[0][0] : words[dimension][numbers.length > 1 ? 1 : 0] + numbers.join(', '),
    }));
  }

  /** The vertex at each point of the node, from 1; 0: none. */
  get vertexAt() {
    if (this._vertexAt) return this._vertexAt;
    const at = (this._vertexAt = new Uint32Array(this.cells.points.length)), {point} = this.cells.vertices;
    for (let v = 0; v < point.length; ++v) at[point[v]] = v + 1;
    return at;
  }
  /** The vertices at which an edge ends, each once (from 1). */
  ends(e) {
    const {edges} = this.cells, {starts, all} = edges.points, {vertexAt} = this;
    if (edges.flags[e] & 1) return [];
    const a = vertexAt[all[starts[e]]], b = vertexAt[all[starts[e + 1] - 1]];
    return [a, a === b ? 0 : b].filter((v) => v);
  }

  /** Who bounds whom, made when it is first asked for. */
  get incidence() {
    if (this._incidence) return this._incidence;
    const {faces} = this.cells, {counts, vertexAt} = this, {uses} = this.radial;
    const lists = (n, m, each) => {
      const keys = [], values = [];
      each((a, b) => (keys.push(a), values.push(b)));
      return [pairsAsLists(n, keys, values), pairsAsLists(m, values, keys)];
    };
    const [edgeEnds, vertexEdges] = lists(counts.e, counts.v, (pair) => {
      for (let e = 0; e < counts.e; ++e) for (const v of this.ends(e)) pair(e, v - 1);
    });
    const [edgeFaces, faceEdges] = lists(counts.e, counts.f, (pair) => {
      const last = new Int32Array(counts.f).fill(-1);  // a slit has a face twice
      for (let e = 0; e < counts.e; ++e) for (const f of uses.of(e)) if (last[f] !== e) (last[f] = e), pair(e, f);
    });
    const [faceVertices, vertexFaces] = lists(counts.f, counts.v, (pair) => {
      const last = new Int32Array(counts.v).fill(-1);
      const see = (f, p) => {
        const v = vertexAt[p] - 1;
        if (v >= 0 && last[v] !== f) (last[v] = f), pair(f, v);
      };
      for (let f = 0; f < counts.f; ++f) {
        for (const p of faces.corners(f)) see(f, p);
        for (const p of faces.isolated.of(f)) see(f, p);
      }
    });
    this._incidence = {edgeEnds, vertexEdges, faceEdges, faceVertices, edgeFaces, vertexFaces};
    return this._incidence;
  }

  /** Regions (from 0) that a cell bounds or hangs in. */
  regionsAt(cell) {
    const {vertices, edges, faces} = this.cells, out = new Set();
    const add = (r) => r > 0 && out.add(r - 1);
    const ofEdge = (e) => {
      const {uses, regions} = this.radial;
      for (let k = uses.starts[e]; k < uses.starts[e + 1]; ++k) add(regions[k]);
      add(edges.region[e]);
    };
    if (cell.kind === 'f') (add(faces.front[cell.i]), add(faces.back[cell.i]));
    if (cell.kind === 'e') ofEdge(cell.i);
    if (cell.kind === 'v') {
      const {vertexFaces, vertexEdges} = this.incidence;
      for (const f of vertexFaces.of(cell.i)) (add(faces.front[f]), add(faces.back[f]));
      add(vertices.region[cell.i]);
      for (const e of vertexEdges.of(cell.i)) ofEdge(e);
    }
    return [...out].sort((a, b) => a - b);
  }

  /** Lists of cells around one, with what they are to it. */
  around({kind, i}) {
    const n = this.incidence, as = (k) => (list) => [...list].sort((a, b) => a - b).map((x) => ({kind: k, i: x}));
    const regions = as('r')(this.regionsAt({kind, i}));
    switch (kind) {
      case 'v': return [['ends edges', as('e')(n.vertexEdges.of(i))], ['on faces', as('f')(n.vertexFaces.of(i))], ['touches regions', regions]];
      case 'e': return [['ends', as('v')(n.edgeEnds.of(i))], ['bounds faces', as('f')(n.edgeFaces.of(i))], ['touches regions', regions]];
      case 'f': {
        const {front, back} = this.cells.faces;
        const side = (r) => (r > 0 ? [{kind: 'r', i: r - 1}] : []);
        return [['edges', as('e')(n.faceEdges.of(i))], ['vertices', as('v')(n.faceVertices.of(i))], ['in front', side(front[i])], ['behind', side(back[i])]];
      }
      default: {
        const shells = this.cells.regions.shells(i).map((s, k, all) =>
          [all.length === 1 ? 'shell' : `shell ${k + 1}`, as('f')(new Set(Array.from(s, (side) => side >> 1)))]);
        const within = (column, k) => as(k)(Array.from(column.region, (r, x) => (r === i + 1 ? x : -1)).filter((x) => x >= 0));
        return [...shells, ['wires in it', within(this.cells.edges, 'e')], ['points in it', within(this.cells.vertices, 'v')]];
      }
    }
  }
}
