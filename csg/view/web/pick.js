// What is under a place of the picture: found by a ray through the drawing's tables.
//
// Reading it off a picture of numbers of cells costs what a frame costs, and waits for the frame before it: seconds
// where the processor draws many cells. Here everything far from the ray is passed over by a sphere about it, of a
// region or of some dozen rows of a table at once; some hundred triangles, edges and points are left to look at.
import {CUT} from './section.js';
import {HATCHED} from './build_geometry.js';

const ROWS = 32;  // under one sphere
const VERTEX = 9, EDGE = 7;  // pixels from the pointer at which these are still meant

/** `eye`, `ray` (of length 1) and `pixel`: the width of a pixel at distance 1; `plane`: n, d of the section, or none. */
export class Pointer {
  constructor({eye, ray, pixel, near, plane, explode, hatch}) {
    Object.assign(this, {eye, ray, pixel, near, plane, explode, hatch});
    this.looked = 0;  // how much was looked at closely
  }

  /** How far along the ray a place is, and how far beside it. */
  along(x, y, z) {
    const {eye, ray} = this, u = x - eye[0], v = y - eye[1], w = z - eye[2], t = u * ray[0] + v * ray[1] + w * ray[2];
    return [t, Math.sqrt(Math.max(u * u + v * v + w * w - t * t, 0))];
  }
  /** May a sphere be within the pixels that matter? */
  meets(x, y, z, radius) {
    const {eye, ray} = this, u = x - eye[0], v = y - eye[1], w = z - eye[2], t = u * ray[0] + v * ray[1] + w * ray[2];
    if (t < -radius) return false;
    const reach = radius + VERTEX * this.pixel * (t + radius);
    return u * u + v * v + w * w - t * t <= reach * reach;
  }
  cutAway(x, y, z) {
    const {plane} = this;
    return plane && plane[0] * x + plane[1] * y + plane[2] * z + plane[3] < 0;
  }

  /** Triangles near the ray, as places of corners: `{at, far, ident, owner, kind, sides}`. */
  gather(faces, begin, end, sides, out) {
    const {corners: {position, shift, tint, ident, owner}, triangles: {corner}} = faces, {explode} = this;
    for (let t = begin; t < end; ++t) {
      const c = corner[3 * t], at = new Array(9);
      for (let k = 0; k < 3; ++k) {
        const i = 3 * corner[3 * t + k];
        for (let j = 0; j < 3; ++j) at[3 * k + j] = position[i + j] + explode * shift[i + j];
      }
      const x = (at[0] + at[3] + at[6]) / 3, y = (at[1] + at[4] + at[7]) / 3, z = (at[2] + at[5] + at[8]) / 3;
      let radius = 0;
      for (let k = 0; k < 9; k += 3) radius = Math.max(radius, Math.hypot(at[k] - x, at[k + 1] - y, at[k + 2] - z));
      if (this.meets(x, y, z, radius)) out.push({at, far: this.along(x, y, z)[0], sides, kind: tint[4 * c + 3], ident: ident.subarray(4 * c, 4 * c + 4), owner: owner.subarray(4 * c, 4 * c + 4)});
    }
  }

  /** Where a ray from the eye meets a triangle: its distance, or infinity. */
  hit({at, sides, kind}, ray) {
    const {eye} = this;
    const e = [at[3] - at[0], at[4] - at[1], at[5] - at[2]], f = [at[6] - at[0], at[7] - at[1], at[8] - at[2]];
    const px = ray[1] * f[2] - ray[2] * f[1], py = ray[2] * f[0] - ray[0] * f[2], pz = ray[0] * f[1] - ray[1] * f[0];
    const det = e[0] * px + e[1] * py + e[2] * pz;  // positive: turned towards the eye
    if (det === 0 || det * sides < 0) return Infinity;
    const sx = eye[0] - at[0], sy = eye[1] - at[1], sz = eye[2] - at[2], u = (sx * px + sy * py + sz * pz) / det;
    if (u < 0 || u > 1) return Infinity;
    const qx = sy * e[2] - sz * e[1], qy = sz * e[0] - sx * e[2], qz = sx * e[1] - sy * e[0];
    const v = (ray[0] * qx + ray[1] * qy + ray[2] * qz) / det;
    if (v < 0 || u + v > 1) return Infinity;
    const t = (f[0] * qx + f[1] * qy + f[2] * qz) / det;
    if (t < this.near || (kind !== CUT && this.cutAway(...eye.map((x, k) => x + t * ray[k])))) return Infinity;
    return t;
  }

  /** Where an edge from a place along u, v, w comes nearest to the ray, and how many pixels beside it. */
  beside(x, y, z, u, v, w) {
    const at = (s) => {
      const [t, far] = this.along(x + s * u, y + s * v, z + s * w);
      return t > this.near && !this.cutAway(x + s * u, y + s * v, z + s * w) ? far / (t * this.pixel) : 1e9 + Math.abs(s - 0.5);
    };
    // By thirds, for the eye sees the edge in perspective.
    let low = 0, high = 1;
    for (let k = 0; k < 40; ++k) {
      const p = low + (high - low) / 3, q = high - (high - low) / 3;
      if (at(p) < at(q)) high = q;
      else low = p;
    }
    const s = (low + high) / 2;
    return {s, far: at(s)};
  }

  /** The nearest triangle on a ray; through a missing face one sees, but where its hatch is drawn. */
  nearest(triangles, ray, hatch) {
    let best = null, least = Infinity, missing = null, first = Infinity;
    for (const triangle of triangles) {
      const t = this.hit(triangle, ray);
      if (triangle.kind === HATCHED && !hatch) {
        if (t < first) [first, missing] = [t, triangle];
      } else if (t < least) [least, best] = [t, triangle];
    }
    return {triangle: best ?? missing, distance: least};
  }

  /** Is a place hidden by a triangle, not by a missing one? The nearest to the eye come first, and mostly it is they. */
  hidden(triangles, x, y, z) {
    const d = [x - this.eye[0], y - this.eye[1], z - this.eye[2]], far = Math.hypot(...d), ray = d.map((c) => c / far);
    return triangles.some((t) => t.kind !== HATCHED && this.hit(t, ray) < far * (1 - 1e-4) - 1e-4);
  }
}

/** The cell under a pointer, of a kind or `any`. `drawing`: its geometry, targets, cut, and whether skins are seen from inside. */
export function under(pointer, {geometry, targets: {skins: spheres, edges, points}, cut, inner}, kinds) {
  const {explode} = pointer, {skins, sheets, ghosts, ranges, numbering} = geometry, triangles = [];
  const near = (s, k) => pointer.meets(s[8 * k] + explode * s[8 * k + 4], s[8 * k + 1] + explode * s[8 * k + 5], s[8 * k + 2] + explode * s[8 * k + 6], s[8 * k + 3] + explode * s[8 * k + 7]);
  for (let k = 0; k < ranges.length; ++k) if (near(spheres, k)) pointer.gather(skins, ranges[k].begin, ranges[k].end, inner ? 0 : 1, triangles);
  for (const faces of [sheets, ghosts]) pointer.gather(faces, 0, faces.triangles.length, 0, triangles);
  if (cut) pointer.gather(cut.filled, 0, cut.filled.triangles.length, 0, triangles);
  triangles.sort((a, b) => a.far - b.far);
  pointer.looked = triangles.length;

  let best = null, least = Infinity;
  const offer = (rank, number) => {
    const cell = rank < least ? numbering.cell(number[0], number[1], number[2]) : null;
    if (cell && (kinds === 'any' || cell.kind.toLowerCase() === kinds)) [best, least] = [cell, rank];
  };
  const {triangle} = pointer.nearest(triangles, pointer.ray, pointer.hatch);
  if (triangle) offer(30, kinds === 'r' ? triangle.owner : triangle.ident);
  if (kinds !== 'any' && !'ev'.includes(kinds)) return best;

  for (const {table: {a, b, shift, ident, length}, spheres: of} of edges) {
    for (let i = 0; i < length; ++i) {
      if (i % ROWS === 0 && !near(of, i / ROWS)) {
        i += ROWS - 1;
        continue;
      }
      const k = 3 * i, x = a[k] + explode * shift[k], y = a[k + 1] + explode * shift[k + 1], z = a[k + 2] + explode * shift[k + 2];
      const u = b[k] - a[k], v = b[k + 1] - a[k + 1], w = b[k + 2] - a[k + 2];
      if (!pointer.meets(x + u / 2, y + v / 2, z + w / 2, Math.sqrt(u * u + v * v + w * w) / 2)) continue;
      ++pointer.looked;
      const {s, far} = pointer.beside(x, y, z, u, v, w);
      if (far <= EDGE && 10 + far < least && !pointer.hidden(triangles, x + s * u, y + s * v, z + s * w)) offer(10 + far, ident.subarray(4 * i, 4 * i + 4));
    }
  }
  const {table: {position, shift, ident, length}, spheres: of} = points;
  for (let i = 0; i < length; ++i) {
    if (i % ROWS === 0 && !near(of, i / ROWS)) {
      i += ROWS - 1;
      continue;
    }
    const k = 3 * i, x = position[k] + explode * shift[k], y = position[k + 1] + explode * shift[k + 1], z = position[k + 2] + explode * shift[k + 2];
    const [t, beside] = pointer.along(x, y, z), far = beside / (t * pointer.pixel);
    if (t <= pointer.near || far > VERTEX || far >= least || pointer.cutAway(x, y, z)) continue;
    ++pointer.looked;
    if (!pointer.hidden(triangles, x, y, z)) offer(far, ident.subarray(4 * i, 4 * i + 4));
  }
  return best;
}

/** A sphere about each so many places that have shifts: middle and radius, and how both move. */
function spheresAbout(count, each) {
  const out = new Float64Array(8 * count), low = new Float64Array(6), high = new Float64Array(6);
  for (let i = 0; i < count; ++i) {
    low.fill(Infinity);
    high.fill(-Infinity);
    each(i, (place, shift, row) => {
      for (let j = 0; j < 3; ++j) {
        const x = place[3 * row + j], s = shift[3 * row + j];
        if (x < low[j]) low[j] = x;
        if (x > high[j]) high[j] = x;
        if (s < low[3 + j]) low[3 + j] = s;
        if (s > high[3 + j]) high[3 + j] = s;
      }
    });
    for (let part = 0; part < 2; ++part) {
      let square = 0;
      for (let j = 0; j < 3; ++j) {
        out[8 * i + 4 * part + j] = (low[3 * part + j] + high[3 * part + j]) / 2;
        square += (high[3 * part + j] - low[3 * part + j]) ** 2;
      }
      out[8 * i + 4 * part + 3] = Math.sqrt(square) / 2;
    }
  }
  return out;
}

/** What a pointer looks at: the tables of a geometry with spheres about their rows. */
export function targets(geometry) {
  const {skins: {corners, triangles: {corner}}, ranges} = geometry;
  const ofTable = (table, columns) => ({table, spheres: spheresAbout(Math.ceil(table.length / ROWS), (i, see) => {
    for (let row = i * ROWS; row < Math.min(i * ROWS + ROWS, table.length); ++row) for (const column of columns) see(column, table.shift, row);
  })});
  return {
    skins: spheresAbout(ranges.length, (i, see) => {
      for (let k = 3 * ranges[i].begin; k < 3 * ranges[i].end; ++k) see(corners.position, corners.shift, corner[k]);
    }),
    edges: [geometry.plain, geometry.edges, geometry.ghostEdges].map((t) => ofTable(t, [t.a, t.b])),
    points: ofTable(geometry.points, [geometry.points.position]),
  };
}
