// One node of the page: its cells, who bounds whom, and what is told of each. Cells are called as files call them;
// here a cell is a letter and a number, `{kind: 'f', i: 12}`.
import {Lists, readCells, unpack} from './data.js';

export const LETTERS = ['v', 'e', 'f', 'r'];
export const WORDS = {v: 'vertex', e: 'edge', f: 'face', r: 'region'};
export const nameOf = (cell) => cell.kind + cell.i;

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
    this.colours = {material: {}, component: unpack(colors.component), region: unpack(colors.region)};
    for (const kind of LETTERS) this.colours.material[kind] = unpack(colors.material[kind]);
    this.classes = classes && {cells: readCells(classes), fates: classes.fates};
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
  /** The colour of a cell by `region`, `material`, `component` or `source`. */
  colour(by, cell) {
    const {page: {colours}, colours: mine} = this;
    if (by === 'region' && cell.kind !== 'r') return {v: colours.point, e: colours.wire, f: colours.sheet}[cell.kind];
    const number = by === 'region' ? mine.region[cell.i]
      : by === 'material' ? mine.material[cell.kind][this.component(cell)]
      : by === 'source' ? colours.sources[this.column(cell.kind).origin[cell.i]]
      : mine.component[this.component(cell)];
    return colours.all[number];
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

  story(cell) {
    if (!this.stories) return null;
    const before = {v: 0, e: this.counts.v, f: this.counts.v + this.counts.e, r: this.counts.v + this.counts.e + this.counts.f};
    return Array.from(this.stories.of(before[cell.kind] + cell.i), (line) => this.page.lines[line]);
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

  /** Who bounds whom, made when it is first asked for. */
  get incidence() {
    if (this._incidence) return this._incidence;
    const {vertices, edges, faces} = this.cells;
    const vertexAt = new Map();
    vertices.point.forEach((p, i) => vertexAt.set(p, i));
    const segment = new Map();
    const key = (a, b) => (a < b ? a * 0x2000000 + b : b * 0x2000000 + a);
    const edgeEnds = [], vertexEdges = Array.from({length: this.counts.v}, () => []);
    for (let e = 0; e < this.counts.e; ++e) {
      const chain = edges.points.of(e), closed = edges.flags[e] & 1;
      for (let k = 0; k + 1 < chain.length + closed; ++k) segment.set(key(chain[k], chain[(k + 1) % chain.length]), e);
      const ends = closed ? [] : [chain[0], chain[chain.length - 1]].map((p) => vertexAt.get(p)).filter((v) => v !== undefined);
      edgeEnds.push(ends);
      for (const v of new Set(ends)) vertexEdges[v].push(e);
    }
    const faceEdges = [], faceVertices = [];
    const edgeFaces = Array.from({length: this.counts.e}, () => []), vertexFaces = Array.from({length: this.counts.v}, () => []);
    for (let f = 0; f < this.counts.f; ++f) {
      const found = new Set(), corners = new Set();
      for (const loop of faces.loops(f)) {
        for (let k = 0; k < loop.length; ++k) {
          const e = segment.get(key(loop[k], loop[(k + 1) % loop.length]));
          if (e !== undefined) found.add(e);
          const v = vertexAt.get(loop[k]);
          if (v !== undefined) corners.add(v);
        }
      }
      for (const p of faces.isolated.of(f)) if (vertexAt.has(p)) corners.add(vertexAt.get(p));
      faceEdges.push([...found]);
      faceVertices.push([...corners]);
      for (const e of found) edgeFaces[e].push(f);
      for (const v of corners) vertexFaces[v].push(f);
    }
    this._incidence = {edgeEnds, vertexEdges, faceEdges, faceVertices, edgeFaces, vertexFaces};
    return this._incidence;
  }

  /** Regions (from 0) that a cell bounds or hangs in. */
  regionsAt(cell) {
    const {vertices, edges, faces} = this.cells, {edgeFaces, vertexFaces, vertexEdges} = this.incidence;
    const out = new Set();
    const add = (r) => r > 0 && out.add(r - 1);
    const addFaces = (list) => list.forEach((f) => (add(faces.front[f]), add(faces.back[f])));
    if (cell.kind === 'f') addFaces([cell.i]);
    if (cell.kind === 'e') (addFaces(edgeFaces[cell.i]), add(edges.region[cell.i]));
    if (cell.kind === 'v') {
      addFaces(vertexFaces[cell.i]);
      add(vertices.region[cell.i]);
      for (const e of vertexEdges[cell.i]) (addFaces(edgeFaces[e]), add(edges.region[e]));
    }
    return [...out].sort((a, b) => a - b);
  }

  /** Lists of cells around one, with what they are to it. */
  around({kind, i}) {
    const n = this.incidence, as = (k) => (list) => [...list].sort((a, b) => a - b).map((x) => ({kind: k, i: x}));
    const regions = as('r')(this.regionsAt({kind, i}));
    switch (kind) {
      case 'v': return [['ends edges', as('e')(n.vertexEdges[i])], ['on faces', as('f')(n.vertexFaces[i])], ['touches regions', regions]];
      case 'e': return [['ends', as('v')(n.edgeEnds[i])], ['bounds faces', as('f')(n.edgeFaces[i])], ['touches regions', regions]];
      case 'f': {
        const {front, back} = this.cells.faces;
        const side = (r) => (r > 0 ? [{kind: 'r', i: r - 1}] : []);
        return [['edges', as('e')(n.faceEdges[i])], ['vertices', as('v')(n.faceVertices[i])], ['in front', side(front[i])], ['behind', side(back[i])]];
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
