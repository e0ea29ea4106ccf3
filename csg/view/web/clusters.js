// Triangles of skins in clusters of like direction and like depth, so that whole clusters need not be drawn.
//
// A skin is seen from outside of its region only. Of what is turned away from the viewer a graphics processor finds
// out triangle by triangle; where the main processor draws, each costs as much as if it were seen. Half of a model
// is turned away. And while the camera moves, a slow machine draws the regions nearest to the outside only: those
// deep inside are hardly seen between the others, however far these are pulled apart.

const LAYERED = 20000;  // triangles

/** How many regions are between each region and the outside. */
function depths(model) {
  const {faces, regions} = model.cells, n = model.counts.r, depth = new Int32Array(n).fill(-1);
  let front = [];
  const open = (r, d) => {
    if (r <= 0 || !model.active(r) || depth[r - 1] >= 0) return;
    depth[r - 1] = d;
    front.push(r - 1);
  };
  for (let f = 0; f < model.counts.f; ++f) {
    if (!model.active(faces.front[f]) || !model.active(faces.back[f])) (open(faces.front[f], 0), open(faces.back[f], 0));
  }
  for (let d = 1; front.length; ++d) {
    const last = front;
    front = [];
    for (const r of last) for (const shell of regions.shells(r)) for (const side of shell) (open(faces.front[side >> 1], d), open(faces.back[side >> 1], d));
  }
  return depth;
}

/** The triangles of `geometry.skins` in another order, and where clusters are in it, those at the outside first. */
export function clusters(geometry) {
  const {skins: {corners, triangles: {corner, length}}, ranges, model} = geometry, {position, shift} = corners;
  const depth = length > LAYERED ? depths(model) : null;
  const key = new Uint32Array(length), normal = new Float32Array(3 * length);
  const found = new Map();
  for (const {r, begin, end} of ranges) {
    const layer = depth ? Math.max(depth[r], 0) : 0;
    for (let t = begin; t < end; ++t) {
      const a = 3 * corner[3 * t], b = 3 * corner[3 * t + 1], c = 3 * corner[3 * t + 2];
      const ux = position[b] - position[a], uy = position[b + 1] - position[a + 1], uz = position[b + 2] - position[a + 2];
      const vx = position[c] - position[a], vy = position[c + 1] - position[a + 1], vz = position[c + 2] - position[a + 2];
      const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx, size = Math.hypot(x, y, z) || 1;
      const nx = x / size, ny = y / size, nz = z / size;
      normal[3 * t] = nx;
      normal[3 * t + 1] = ny;
      normal[3 * t + 2] = nz;
      key[t] = layer * 27 + (Math.round(nx) + 1) * 9 + (Math.round(ny) + 1) * 3 + Math.round(nz) + 1;
      let k = found.get(key[t]);
      if (!k) found.set(key[t], (k = {layer, count: 0, axis: [0, 0, 0], spread: 0, at: Infinity, moves: Infinity}));
      ++k.count;
      k.axis[0] += nx;
      k.axis[1] += ny;
      k.axis[2] += nz;
      // The least of n·p over the triangles' planes, in place and per unit of pulling apart.
      k.at = Math.min(k.at, nx * position[a] + ny * position[a + 1] + nz * position[a + 2]);
      k.moves = Math.min(k.moves, nx * shift[a] + ny * shift[a + 1] + nz * shift[a + 2]);
    }
  }
  const list = [...found.entries()].sort((a, b) => a[0] - b[0]).map(([, k]) => k);
  let start = 0;
  for (const k of list) {
    const size = Math.hypot(...k.axis) || 1;
    k.axis = k.axis.map((x) => x / size);
    k.start = k.next = start;
    start += k.count;
  }
  const index = new Uint32Array(3 * length);
  for (let t = 0; t < length; ++t) {
    const k = found.get(key[t]), to = 3 * k.next++;
    index[to] = corner[3 * t];
    index[to + 1] = corner[3 * t + 1];
    index[to + 2] = corner[3 * t + 2];
    const cosine = k.axis[0] * normal[3 * t] + k.axis[1] * normal[3 * t + 1] + k.axis[2] * normal[3 * t + 2];
    k.spread = Math.max(k.spread, Math.acos(Math.min(Math.max(cosine, -1), 1)));
  }
  return {index, list};
}

/** Those that may be turned towards an eye, of `most` triangles as far as layers are whole: `{start, count}` in triangles. */
export function facing(list, eye, explode, most = Infinity) {
  const out = [], far = Math.hypot(...eye);
  let total = 0, layer = -1;
  for (const k of list) {
    if (k.layer !== layer && total > most) break;
    layer = k.layer;
    const cosine = (k.axis[0] * eye[0] + k.axis[1] * eye[1] + k.axis[2] * eye[2]) / (far || 1);
    const angle = Math.max(Math.acos(Math.min(Math.max(cosine, -1), 1)) - k.spread, 0);
    // The largest n·eye of all normals n is below the plane of every triangle: all are turned away.
    if (far * Math.cos(angle) < k.at + explode * k.moves - 1e-4) continue;
    const last = out.at(-1);
    if (last && last.start + last.count === k.start) last.count += k.count;
    else out.push({start: k.start, count: k.count});
    total += k.count;
  }
  return out;
}
