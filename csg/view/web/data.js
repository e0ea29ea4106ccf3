// The data of the page as arrays. csg/view/packed.h says how lists of numbers are written.
import {Colors} from './colors.js';

const KINDS = {1: Uint8Array, 2: Uint16Array, 4: Uint32Array, f: Float32Array, d: Float64Array};

/** What the page was made with, until it is read. */
export const source = {json: null};

export function unpack(text) {
  const kind = text[0], letters = atob(text.slice(2)), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  const read = new KINDS[kind](bytes.buffer);
  if (kind === 'f' || kind === 'd') return read;
  const out = new Uint32Array(read.length);
  for (let i = 0, number = 0; i < out.length; ++i) out[i] = number = (number + ((read[i] >>> 1) ^ -(read[i] & 1))) >>> 0;
  return out;
}

/** Lists of lists: `lists.of(i)` is the i-th one. */
export class Lists {
  constructor(counts, all) {
    this.all = all;
    this.starts = new Uint32Array(counts.length + 1);
    for (let i = 0; i < counts.length; ++i) this.starts[i + 1] = this.starts[i] + counts[i];
  }
  get length() { return this.starts.length - 1; }
  of(i) { return this.all.subarray(this.starts[i], this.starts[i + 1]); }
}

/** Pairs of numbers as lists: `of(i)` is what stands beside each i, in the order of the pairs. */
export function pairsAsLists(count, keys, values) {
  const counts = new Uint32Array(count), next = new Uint32Array(count), all = new Uint32Array(keys.length);
  for (const i of keys) ++counts[i];
  for (let i = 1; i < count; ++i) next[i] = next[i - 1] + counts[i - 1];
  for (let k = 0; k < keys.length; ++k) all[next[keys[k]]++] = values[k];
  return new Lists(counts, all);
}

export const readLists = (json, name) => new Lists(unpack(json[`${name}_counts`]), unpack(json[name]));

/** Columns of `names`, each unpacked. */
function columns(json, names) {
  const out = {};
  for (const name of names) if (json[name] !== undefined) out[name] = unpack(json[name]);
  return out;
}

/** The cells of a node, or of what became of its operands' entities. */
export function readCells(json) {
  const cells = {
    points: unpack(json.points),
    vertices: columns(json.vertices, ['point', 'flags', 'region', 'component', 'origin', 'said']),
    edges: columns(json.edges, ['flags', 'region', 'component', 'origin', 'said']),
    faces: columns(json.faces, ['flags', 'component', 'origin', 'said', 'front', 'back', 'patch']),
    regions: {component: [], shells: null},
  };
  cells.edges.points = readLists(json.edges, 'points');
  const {faces} = cells;
  const lengths = readLists(json.faces, 'loops');
  const walks = new Lists(lengths.all, unpack(json.faces.walks));
  faces.loops = (f) => {
    const out = [];
    for (let l = lengths.starts[f]; l < lengths.starts[f + 1]; ++l) out.push(walks.of(l));
    return out;
  };
  /** The corners of all loops. */
  faces.corners = (f) => walks.all.subarray(walks.starts[lengths.starts[f]], walks.starts[lengths.starts[f + 1]]);
  faces.isolated = readLists(json.faces, 'isolated');
  faces.triangles = readLists(json.faces, 'triangles');
  if (json.regions) {
    cells.regions = columns(json.regions, ['bounded', 'component', 'origin']);
    cells.regions.volume = json.regions.volume;
    const shells = readLists(json.regions, 'shells');
    const sides = new Lists(shells.all, unpack(json.regions.sides));
    cells.regions.shells = (r) => {
      const out = [];
      for (let s = shells.starts[r]; s < shells.starts[r + 1]; ++s) out.push(sides.of(s));
      return out;
    };
  }
  return cells;
}

/** The whole page: what is text at once, what is long when it is first asked for. */
export class Page {
  constructor(json) {
    Object.assign(this, {
      tree: json.tree, result: json.result, several: json.several, color_by: json.color_by, leaves: json.leaves, nodes: json.nodes, doubts: json.doubts,
      origins: json.origins, words: json.words, lines: json.lines,
    });
    this.colors = new Colors(json, unpack);
    this.points = unpack(json.points);
    this.exact = new Map(json.exact.map(([i, ...xyz]) => [i, xyz]));
    this.models = new Map();
  }
}
