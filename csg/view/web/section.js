// The plane of a section filled where regions are cut, and the lines in which it cuts faces.
//
// The usual way counts front faces against back faces in the stencil, a drawing per region: it ends at some hundred
// regions, and needs every wall between regions drawn though none is seen. Here the cut is computed: of a region
// that the plane meets, each triangle of the skin gives a piece of a line, and what lies between an odd piece and the
// next even one is filled, strip by strip. A filled cut hides what is behind it, so walls between regions stay out of
// the drawing. A point on the plane counts as cut away, everywhere alike: so pieces close to loops whatever the plane
// runs through.
import {EDGES, Faces, put3, put4, Table} from './tables.js';

export const CUT = 3;  // the kind of these faces: not clipped by the plane that they lie in
const HAIR = 5e-5;  // strips overlap by so much, a small part of a pixel, or one might see through between them
const NOTHING = [0, 0, 0, 0], STILL = [0, 0, 0];

/** The pieces of lines in which a plane cuts a region's skin, as ends in the scene. */
function pieces(cells, r, at, n, off, shift) {
  const out = [];
  const far = (p) => n[0] * at[3 * p] + n[1] * at[3 * p + 1] + n[2] * at[3 * p + 2] + off;
  const cross = (a, b, u, v) => {
    if (a > b) [a, b, u, v] = [b, a, v, u];  // of both triangles at an edge, and of both regions, the same
    const t = u / (u - v);
    return [0, 1, 2].map((k) => at[3 * a + k] * (1 - t) + at[3 * b + k] * t + shift[k]);
  };
  for (const shell of cells.regions.shells(r)) {
    for (const side of shell) {
      const f = side >> 1, triangles = cells.faces.triangles.of(f);
      if (cells.faces.front[f] === cells.faces.back[f]) continue;  // hangs in the region
      for (let t = 0; t < triangles.length; t += 3) {
        const corners = triangles.subarray(t, t + 3), fars = [far(corners[0]), far(corners[1]), far(corners[2])], ends = [];
        for (let k = 0; k < 3; ++k) {
          const j = (k + 1) % 3;
          if (fars[k] > 0 !== fars[j] > 0) ends.push(cross(corners[k], corners[j], fars[k], fars[j]));
        }
        if (ends.length) out.push(ends);
      }
    }
  }
  return out;
}

/** Two directions across a unit normal; of an axis the two that come after it. */
function across(n) {
  const k = n.findIndex((x) => Math.abs(x) === Math.max(...n.map(Math.abs))), axis = (j) => [0, 1, 2].map((i) => (i === j % 3 ? 1 : 0));
  const cross = (a, b) => [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
  const first = axis(k + 1), along = n[(k + 1) % 3], flat = first.map((x, i) => x - along * n[i]), size = Math.hypot(...flat), u = flat.map((x) => x / size);
  return [u, cross(n, u)];
}

/** What is inside of closed lines, as strips from height to height, each `[left, right]` below and above. */
function strips(lines) {
  const rising = lines.map(([a, b]) => (a[1] <= b[1] ? [a, b] : [b, a])).filter(([a, b]) => a[1] < b[1]).sort((x, y) => x[0][1] - y[0][1]);
  const heights = [...new Set(rising.flatMap(([a, b]) => [a[1], b[1]]))].sort((a, b) => a - b), out = [];
  const at = ([a, b], y) => a[0] + (b[0] - a[0]) * Math.min(Math.max((y - a[1]) / (b[1] - a[1]), 0), 1);
  let active = [], next = 0;
  for (let k = 0; k + 1 < heights.length; ++k) {
    const low = heights[k], high = heights[k + 1], middle = (low + high) / 2;
    while (next < rising.length && rising[next][0][1] <= low) active.push(rising[next++]);
    active = active.filter(([, b]) => b[1] >= high);
    if (high - low < HAIR / 100) continue;
    const sorted = active.map((line) => [at(line, middle), line]).sort((a, b) => a[0] - b[0]);
    for (let i = 0; i + 1 < sorted.length; i += 2) {
      const [left, right] = [sorted[i][1], sorted[i + 1][1]];
      out.push([[at(left, low), low - HAIR], [at(right, low), low - HAIR], [at(right, high), high + HAIR], [at(left, high), high + HAIR]]);
    }
  }
  return out;
}

/**
 * What the plane n·p + d = 0 cuts of a drawing whose regions are moved by `explode`: faces and edges. What is kept is
 * where n, of length 1, points.
 */
export function cutBy(geometry, n, d, explode, ink) {
  const {model, numbering, low, high, centres} = geometry, {cells} = model, at = geometry.placed(cells);
  const filled = new Faces(), lines = new Table(EDGES), [u, v] = across(n);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const line = (a, b) => {
    const row = lines.add();
    for (let k = 0; k < 3; ++k) {
      lines.a[3 * row + k] = a[k] + n[k] * 2e-4;
      lines.b[3 * row + k] = b[k] + n[k] * 2e-4;
    }
    put3(lines.shift, row, STILL);
    put4(lines.tint, row, ink, 255);
    put4(lines.ident, row, NOTHING);
    put3(lines.look, row, [1, 0, 0]);
  };
  const fill = (strip, tint, ident) => {
    const {corners, triangles} = filled, first = corners.add(4);
    strip.forEach(([x, y], k) => {
      put3(corners.position, first + k, n.map((c, j) => -d * c + x * u[j] + y * v[j]));
      put3(corners.normal, first + k, n.map((c) => -c));
      put4(corners.tint, first + k, tint, CUT);
      put4(corners.ident, first + k, ident);
      put4(corners.owner, first + k, ident);
    });
    const row = triangles.add(2);
    put3(triangles.corner, row, [first, first + 1, first + 2]);
    put3(triangles.corner, row + 1, [first, first + 2, first + 3]);
  };
  for (const {r, tint} of geometry.ranges) {
    const shift = [0, 1, 2].map((k) => centres[3 * r + k] * explode), off = d + dot(n, shift);
    const end = (s) => n.reduce((sum, c, k) => sum + c * (c * s > 0 ? high : low)[3 * r + k], off);
    if (end(1) <= 0 || end(-1) > 0) continue;
    const outline = pieces(cells, r, at, n, off, shift);
    for (const ends of outline) line(...ends);
    for (const strip of strips(outline.map((ends) => ends.map((p) => [dot(p, u), dot(p, v)])))) fill(strip, tint.map((x) => x * 0.94), numbering.bytes('r', r));
  }
  // Sheets are cut to lines.
  const {corners, triangles: {corner, length}} = geometry.sheets, where = (c, k) => corners.position[3 * c + k] + corners.shift[3 * c + k] * explode, far = (c) => dot(n, [where(c, 0), where(c, 1), where(c, 2)]) + d;
  for (let t = 0; t < length; ++t) {
    const three = [corner[3 * t], corner[3 * t + 1], corner[3 * t + 2]], fars = three.map(far), ends = [];
    for (let k = 0; k < 3; ++k) {
      const j = (k + 1) % 3;
      if (fars[k] > 0 === fars[j] > 0) continue;
      const w = fars[k] / (fars[k] - fars[j]);
      ends.push([0, 1, 2].map((i) => where(three[k], i) + (where(three[j], i) - where(three[k], i)) * w));
    }
    if (ends.length === 2) line(...ends);
  }
  return {filled, lines};
}
