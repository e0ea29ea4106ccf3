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

/** What is inside of closed lines, as strips from height to height, each `[left, right]` below and above; in u and v. */
function strips(lines, u, v) {
  const rising = lines.map(([a, b]) => (a[v] <= b[v] ? [a, b] : [b, a])).filter(([a, b]) => a[v] < b[v]).sort((x, y) => x[0][v] - y[0][v]);
  const heights = [...new Set(rising.flatMap(([a, b]) => [a[v], b[v]]))].sort((a, b) => a - b), out = [];
  const across = ([a, b], y) => a[u] + (b[u] - a[u]) * Math.min(Math.max((y - a[v]) / (b[v] - a[v]), 0), 1);
  let active = [], next = 0;
  for (let k = 0; k + 1 < heights.length; ++k) {
    const low = heights[k], high = heights[k + 1], middle = (low + high) / 2;
    while (next < rising.length && rising[next][0][v] <= low) active.push(rising[next++]);
    active = active.filter(([, b]) => b[v] >= high);
    if (high - low < HAIR / 100) continue;
    const sorted = active.map((line) => [across(line, middle), line]).sort((a, b) => a[0] - b[0]);
    for (let i = 0; i + 1 < sorted.length; i += 2) {
      const [left, right] = [sorted[i][1], sorted[i + 1][1]];
      out.push([[across(left, low), low - HAIR], [across(right, low), low - HAIR], [across(right, high), high + HAIR], [across(left, high), high + HAIR]]);
    }
  }
  return out;
}

/**
 * What the plane n·p + d = 0 across an axis cuts of a drawing whose regions are moved by `explode`: faces and edges.
 * What is kept is where n points.
 */
export function cutBy(geometry, axis, n, d, explode, ink) {
  const {model, numbering, low, high, centres} = geometry, {cells} = model, at = geometry.placed(cells);
  const filled = new Faces(), lines = new Table(EDGES), sign = n[axis], u = (axis + 1) % 3, v = (axis + 2) % 3;
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
  const height = -d / sign;
  const fill = (strip, tint, ident) => {
    const {corners, triangles} = filled, first = corners.add(4);
    strip.forEach(([x, y], k) => {
      corners.position[3 * (first + k) + axis] = height;
      corners.position[3 * (first + k) + u] = x;
      corners.position[3 * (first + k) + v] = y;
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
    const shift = [0, 1, 2].map((k) => centres[3 * r + k] * explode), off = d + sign * shift[axis];
    const ends = [sign * low[3 * r + axis] + off, sign * high[3 * r + axis] + off];
    if (Math.max(...ends) <= 0 || Math.min(...ends) > 0) continue;
    const outline = pieces(cells, r, at, n, off, shift);
    for (const ends of outline) line(...ends);
    for (const strip of strips(outline, u, v)) fill(strip, tint.map((x) => x * 0.94), numbering.bytes('r', r));
  }
  // Sheets are cut to lines.
  const {corners, triangles: {corner, length}} = geometry.sheets, where = (c, k) => corners.position[3 * c + k] + corners.shift[3 * c + k] * explode;
  for (let t = 0; t < length; ++t) {
    const three = [corner[3 * t], corner[3 * t + 1], corner[3 * t + 2]], fars = three.map((c) => sign * where(c, axis) + d), ends = [];
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
