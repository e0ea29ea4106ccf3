// Tables of numbers that grow row by row, and what the drawing makes of them. Rows are written straight into the
// columns: a list of small arrays would cost more than everything else when a page of many cells opens.
import * as THREE from 'three';

const F = Float32Array, B = Uint8Array;

/** `{position: [Float32Array, 3], ...}`: columns with their widths. */
export class Table {
  constructor(columns) {
    this.columns = columns;
    this.length = 0;
    this.room = 64;
    for (const [name, [Kind, width]] of Object.entries(columns)) this[name] = new Kind(this.room * width);
  }
  /** The number of the first of `count` new rows. Columns may be other arrays afterwards. */
  add(count = 1) {
    const at = this.length;
    this.length += count;
    if (this.length > this.room) {
      this.room = Math.max(this.room * 2, this.length);
      for (const [name, [Kind, width]] of Object.entries(this.columns)) {
        const larger = new Kind(this.room * width);
        larger.set(this[name]);
        this[name] = larger;
      }
    }
    return at;
  }
  done(name) { return this[name].slice(0, this.length * this.columns[name][1]); }
}

export function put3(array, row, v) {
  array[3 * row] = v[0];
  array[3 * row + 1] = v[1];
  array[3 * row + 2] = v[2];
}
export function put4(array, row, v, last = v[3]) {
  array[4 * row] = v[0];
  array[4 * row + 1] = v[1];
  array[4 * row + 2] = v[2];
  array[4 * row + 3] = last;
}

/** Corners of triangles; the fourth byte of `tint` is the kind of face. */
export const CORNERS = {position: [F, 3], normal: [F, 3], shift: [F, 3], tint: [B, 4], ident: [B, 4], owner: [B, 4]};
export const TRIANGLES = {corner: [Uint32Array, 3]};
/** Edges from a to b; `look` is width, dashed, and how far along the chain a is. */
export const EDGES = {a: [F, 3], b: [F, 3], shift: [F, 3], tint: [B, 4], ident: [B, 4], look: [F, 3]};
/** Points; `look` is size, and 1 for hollow, 2 for a ring. */
export const POINTS = {position: [F, 3], shift: [F, 3], tint: [B, 4], ident: [B, 4], look: [F, 2]};

export class Faces {
  constructor() {
    this.corners = new Table(CORNERS);
    this.triangles = new Table(TRIANGLES);
  }
}

const NORMALIZED = new Set(['tint', 'ident', 'owner']);

export function pointBuffers(table) {
  const geometry = new THREE.BufferGeometry();
  for (const [name, [, width]] of Object.entries(table.columns)) geometry.setAttribute(name, new THREE.BufferAttribute(table.done(name), width, NORMALIZED.has(name)));
  return geometry;
}
export function faceBuffers(faces, index = faces.triangles.done('corner')) {
  const geometry = pointBuffers(faces.corners);
  geometry.setIndex(new THREE.BufferAttribute(index, 1));
  return geometry;
}
/** Each row `times` times over. */
function repeated(table, name, times) {
  const [Kind, width] = table.columns[name], from = table[name], out = new Kind(table.length * width * times);
  for (let i = 0, to = 0; i < table.length; ++i) {
    for (let k = 0; k < times; ++k) for (let j = 0; j < width; ++j) out[to++] = from[width * i + j];
  }
  return new THREE.BufferAttribute(out, width, NORMALIZED.has(name));
}
/** A ribbon per edge, as four corners. Instances of one ribbon take a processor that draws ten times as long. */
export function ribbonBuffers(table) {
  const n = table.length, geometry = new THREE.BufferGeometry(), position = new F(12 * n), index = new Uint32Array(6 * n);
  for (let i = 0; i < n; ++i) {
    position.set([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0], 12 * i);
    index.set([4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 2, 4 * i + 1, 4 * i + 3], 6 * i);
  }
  geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
  for (const name of Object.keys(table.columns)) geometry.setAttribute(name, repeated(table, name, 4));
  return geometry.setIndex(new THREE.BufferAttribute(index, 1));
}
/** A line of one pixel per edge, where ribbons would be too many. */
export function lineBuffers(table) {
  const geometry = new THREE.BufferGeometry(), position = new F(6 * table.length);
  for (let i = 0; i < table.length; ++i) {
    for (let k = 0; k < 3; ++k) {
      position[6 * i + k] = table.a[3 * i + k];
      position[6 * i + 3 + k] = table.b[3 * i + k];
    }
  }
  geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
  for (const name of ['shift', 'tint', 'ident']) geometry.setAttribute(name, repeated(table, name, 2));
  return geometry;
}
