// Two drawings of what is around a cell: the faces about an edge as a fan, in their radial order, and the
// neighbourhood of a vertex as a graph on a small sphere about it.
import {hex} from './colors.js';
import {minus} from './model.js';

const svg = (tag, attributes = {}, ...children) => {
  const out = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [key, value] of Object.entries(attributes)) out.setAttribute(key, value);
  out.append(...children);
  return out;
};
const picture = (label) => svg('svg', {viewBox: '-110 -110 220 220', class: 'diagram', role: 'img', 'aria-label': label});
const text = (x, y, content, extra = {}) => svg('text', {x, y, 'text-anchor': 'middle', 'dominant-baseline': 'central', ...extra}, content);

/** The radial order about edge `e`: spokes are faces, sectors the regions between them; the edge points at you. */
export function fan(model, e, tintOf) {
  const {uses, regions, angles} = model.radial, faces = uses.of(e), begin = uses.starts[e], n = faces.length;
  const steps = Array.from(faces, (f, k) => ({f, r: regions[begin + k], angle: angles[begin + k]}));
  const words = steps.map((s) => `f${s.f}, ${s.r ? 'r' + (s.r - 1) : 'outside'}`).join(', ');
  const out = picture(n ? `radial order about e${e}: ${words}` : `e${e} is a wire`);
  const at = (angle, radius) => [radius * Math.cos(angle), -radius * Math.sin(angle)];
  steps.forEach((s, k) => {
    const next = k + 1 < n ? steps[k + 1].angle : steps[0].angle + 2 * Math.PI;
    const [x, y] = at(s.angle, 78), [u, v] = at(next, 78), active = model.active(s.r);
    const whole = next - s.angle > 2 * Math.PI - 1e-6;
    out.append(svg('path', {
      d: whole ? 'M -78 0 A 78 78 0 1 0 78 0 A 78 78 0 1 0 -78 0' : `M 0 0 L ${x} ${y} A 78 78 0 ${next - s.angle > Math.PI ? 1 : 0} 0 ${u} ${v} Z`,
      fill: active ? hex(tintOf({kind: 'r', i: s.r - 1})) : 'none', 'fill-opacity': active ? 0.75 : 0,
    }));
  });
  steps.forEach((s, k) => {
    const next = k + 1 < n ? steps[k + 1].angle : steps[0].angle + 2 * Math.PI, own = model.cells.faces.component[s.f];
    const [x, y] = at(s.angle, 84), [u, v] = at(s.angle, 98);
    out.append(svg('line', {x1: 0, y1: 0, x2: x, y2: y, class: own ? 'spoke' : 'spoke open'}), text(u, v, `f${s.f}`));
    if (next - s.angle > 0.2) {
      const [a, b] = at((s.angle + next) / 2, next - s.angle > 0.5 ? 50 : 66);
      out.append(text(a, b, s.r ? `r${s.r - 1}` : 'outside', {class: model.active(s.r) ? 'on' : 'off'}));
    }
  });
  out.append(svg('circle', {r: 5.5, class: 'hub'}), svg('circle', {r: 1.6, class: 'hubdot'}));
  const wedges = steps.map((s, k) => ({from: s.f, to: steps[(k + 1) % n].f, angle: (k + 1 < n ? steps[k + 1].angle : steps[0].angle + 2 * Math.PI) - s.angle}));
  return {picture: out, words, wedges};
}

const unit = (v) => {
  const size = Math.hypot(...v) || 1;
  return v.map((x) => x / size);
};

/** What the cells around vertex `v` leave on a small sphere: a node per end of an edge, an arc per corner of a face. */
export function sphere(model, v, tintOf) {
  const {cells, incidence} = model, p = cells.vertices.point[v], centre = model.at(p);
  const nodes = [], arcs = [];
  for (const e of incidence.vertexEdges.of(v)) {
    const chain = cells.edges.points.of(e);
    const add = (other) => nodes.push({e, at: unit(minus(model.at(other), centre))});
    if (chain[0] === p) add(chain[1]);
    if (chain[chain.length - 1] === p && chain.length > 1) add(chain[chain.length - 2]);
  }
  for (const f of incidence.vertexFaces.of(v)) {
    const t = cells.faces.triangles.of(f);
    for (let k = 0; k < t.length; k += 3) {
      const j = [0, 1, 2].find((x) => t[k + x] === p);
      if (j === undefined) continue;
      arcs.push({f, from: unit(minus(model.at(t[k + ((j + 1) % 3)]), centre)), to: unit(minus(model.at(t[k + ((j + 2) % 3)]), centre))});
    }
  }
  // Connected parts of the graph, by faces and edges that meet at nodes.
  const faces = new Set(arcs.map((a) => a.f));
  const label = `neighbourhood of v${v}: ${nodes.length} nodes (ends of edges), arcs of ${faces.size} faces`;
  const out = picture(label);
  const redraw = ([right, up, near]) => {
    out.replaceChildren(svg('circle', {r: 84, class: 'ball'}));
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const flat = (d) => [84 * dot(d, right), -84 * dot(d, up), dot(d, near)];
    const behind = [], front = [];
    for (const arc of arcs) {
      const own = cells.faces.component[arc.f], steps = 12, angle = Math.acos(Math.min(1, Math.max(-1, dot(arc.from, arc.to))));
      let run = [], side = null;
      const flush = () => {
        if (run.length > 1) (side ? front : behind).push(svg('polyline', {points: run.map((q) => q.slice(0, 2).map((x) => x.toFixed(1)).join(',')).join(' '), class: `arc${own ? '' : ' open'}${side ? '' : ' far'}`, stroke: hex(model.sheet(arc.f) ? tintOf({kind: 'f', i: arc.f}) : [110, 118, 128])}));
      };
      for (let k = 0; k <= steps; ++k) {
        const t = k / steps, s = Math.sin(angle) || 1;
        const d = angle < 1e-6 ? arc.from : arc.from.map((x, i) => (Math.sin((1 - t) * angle) * x + Math.sin(t * angle) * arc.to[i]) / s);
        const q = flat(d), now = q[2] >= 0;
        if (side !== null && now !== side) {
          run.push(q);
          flush();
          run = [];
        }
        side = now;
        run.push(q);
      }
      flush();
    }
    const marks = [];
    const named = new Map();
    for (const arc of arcs) {
      const [x, y, z] = named.get(arc.f)?.sum ?? [0, 0, 0];
      const m = unit(arc.from.map((c, i) => c + arc.to[i]));
      named.set(arc.f, {sum: [x + m[0], y + m[1], z + m[2]]});
    }
    for (const [f, {sum}] of named) {
      const [x, y, z] = flat(unit(sum));
      marks.push(text(x * 0.86, y * 0.86, `f${f}`, {class: z >= 0 ? '' : 'far'}));
    }
    for (const node of nodes) {
      const [x, y, z] = flat(node.at), far = z >= 0 ? '' : ' far';
      (z >= 0 ? front : behind).push(svg('circle', {cx: x, cy: y, r: 4.5, class: `knot${far}${cells.edges.component[node.e] ? '' : ' open'}`}));
      const s = 1 + 13 / Math.max(Math.hypot(x, y), 13);
      marks.push(text(x * s, y * s, `e${node.e}`, {class: 'knotname' + far}));
    }
    out.append(...behind, ...front, ...marks);
  };
  return {picture: out, redraw, words: label};
}

