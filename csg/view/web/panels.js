// What is told of a cell and of a node. Everything that comes from a file goes in as text, never as HTML.
import {hex} from './colours.js';
import {fan, sphere} from './diagrams.js';
import {nameOf, WORDS} from './model.js';

/** `h('p', {class: 'x'}, 'text', child)`; nothing is a child that is null. */
export function h(tag, attributes = {}, ...children) {
  const out = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'onclick') out.addEventListener('click', value);
    else if (value !== null && value !== undefined && value !== false) out.setAttribute(key, value === true ? '' : value);
  }
  out.append(...children.filter((c) => c !== null && c !== undefined));
  return out;
}
export const swatch = (tint, sign = '') => h('span', {class: `swatch ${sign}`, style: `--tint: ${hex(tint)}`, 'aria-hidden': 'true'});
const terms = (...rows) => h('dl', {class: 'terms'}, ...rows.filter(Boolean).flatMap(([term, ...what]) => [h('dt', {}, term), h('dd', {}, ...what.flat())]));
const SHOWN = 60;

/** Names of cells as buttons that pick them. */
function cellList(cells, pick) {
  const list = h('span', {class: 'cells'});
  const add = (some) => list.append(...some.map((c) => h('button', {class: 'cellname', onclick: () => pick(c)}, nameOf(c))));
  add(cells.slice(0, SHOWN));
  if (cells.length > SHOWN) {
    const more = h('button', {class: 'more', onclick: () => (more.remove(), add(cells.slice(SHOWN)))}, `${cells.length - SHOWN} more`);
    list.append(more);
  }
  return list;
}

const quoted = (word) => (/^[\w.,/#-]+$/.test(word) ? word : `'${word.replaceAll("'", `'\\''`)}'`);
function command(words, copied) {
  const line = words.map(quoted).join(' ');
  return h('div', {class: 'command'}, h('code', {}, line), h('button', {onclick: () => copied(line), title: 'Copy this command'}, 'copy'));
}

/** Exact fractions may have hundreds of digits. */
function exactText(word) {
  if (word.length <= 36) return document.createTextNode(word);
  const short = h('button', {class: 'long', title: 'Show all digits', onclick: () => short.replaceWith(document.createTextNode(word))},
    `${word.slice(0, 22)}… (${word.length} characters)`);
  return short;
}
const volumeText = ([exact, decimal]) => [h('span', {class: 'number'}, exactText(exact)), exact.includes('/') ? h('span', {class: 'soft'}, ` ≈ ${decimal}`) : ''];
function coordinates(model, p) {
  const exact = model.exact(p), out = h('dl', {class: 'terms point'});
  exact.forEach((word, k) => {
    const decimal = word.includes('/') ? h('span', {class: 'soft'}, ` ≈ ${model.at(p)[k]}`) : null;
    out.append(h('dt', {}, 'xyz'[k]), h('dd', {class: 'number'}, exactText(word), decimal));
  });
  return out;
}

/** A story with the rows of the tables marked in it. */
function storyText(lines) {
  const pre = h('pre', {class: 'story', tabindex: '0', 'aria-label': 'What cnrg explain says'});
  lines.forEach((line, k) => {
    let rest = line;
    for (let found; (found = /\b(union|intersection|difference)\.(face|edge|vertex)\.\w+(\.\w+)?/.exec(rest)); ) {
      pre.append(rest.slice(0, found.index), h('mark', {}, found[0]));
      rest = rest.slice(found.index + found[0].length);
    }
    pre.append(rest, k + 1 < lines.length ? '\n' : '');
  });
  return pre;
}

/** The panel of a picked cell; returns what redraws its sphere when the camera turns. */
export function showCell(holder, model, cell, {pick, tintOf, copied, axes}) {
  if (!cell) {
    holder.replaceChildren(h('p', {class: 'hint'}, 'Pick a cell in the picture, or find one by its name: v3, e0, f12, r1.'));
    return null;
  }
  if (cell.kind === cell.kind.toUpperCase()) return showEntity(holder, model, cell, copied);
  const {kind, i} = cell, {cells} = model, c = model.component(cell), component = model.node.components[c - 1], said = model.said(cell);
  const flags = model.column(kind).flags?.[i] ?? 0;
  const entity = kind === 'e' ? flags & 2 : kind === 'r' ? 0 : flags & 1;
  const says = [];
  if (!c) says.push(kind === 'r' ? 'outside' : 'not of the set: it bounds what is');
  else if (entity && model.node.group) says.push('entity');
  if (c && kind === 'f' && model.sheet(i)) says.push('sheet');
  if (c && kind === 'e' && flags & 8) says.push('wire');
  if (c && kind === 'v' && !model.incidence.vertexEdges.of(i).length) says.push('isolated point');
  if (kind === 'r' && !cells.regions.bounded[i]) says.push('unbounded');
  if (kind === 'e' && flags & 1) says.push('closes without a vertex');
  if (kind === 'f' && flags & 2) says.push('curved: of several facets');
  const shape = model.shape(cell), volume = kind === 'r' ? cells.regions.volume[i] : null;
  const origin = model.origin(cell);
  const parts = [
    h('p', {class: 'title'}, h('strong', {id: 'picked'}, nameOf(cell)), ` ${WORDS[kind]}`, ...says.map((s) => h('span', {class: 'tag'}, s))),
    terms(
      c ? ['component', swatch(tintOf(cell)), ' ', model.componentName(c)] : null,
      said?.name && said !== component ? ['name', said.name] : null,
      said?.material || component?.material ? ['material', said?.material || component.material] : null,
      ...(said?.attributes ?? []).map(([key, value]) => [key, value]),
      volume ? ['volume', ...volumeText(volume)] : null,
      shape ? ['around it', shape] : null,
      origin.length ? ['from', h('ul', {class: 'plain'}, ...origin.map((o) => h('li', {}, model.page.leaves[o.leaf] || 'frame', ': ', o.text)))] : null,
    ),
  ];
  const around = model.around(cell).filter(([, list]) => list.length);
  if (around.length) parts.push(h('h3', {}, 'Incidence'), terms(...around.map(([word, list]) => [word, cellList(list, pick)])));
  let redraw = null;
  if (kind === 'v') parts.push(h('h3', {}, 'Where'), coordinates(model, cells.vertices.point[i]));
  if (kind === 'e') {
    const drawn = fan(model, i, tintOf);
    parts.push(h('h3', {}, 'Radial order'), drawn.words ? drawn.picture : null, h('p', {class: 'soft'}, drawn.words ? `Counter-clockwise with the edge pointing at you: ${drawn.words}` : 'A wire: no face is around it.'));
    const ends = [...new Set([cells.edges.points.of(i)[0], cells.edges.points.of(i).at(-1)])];
    if (!(flags & 1)) parts.push(h('details', {}, h('summary', {}, 'Ends, exactly'), ...ends.map((p) => coordinates(model, p))));
  }
  if (kind === 'v' && (model.incidence.vertexEdges.of(i).length || model.incidence.vertexFaces.of(i).length)) {
    const drawn = sphere(model, i, tintOf);
    redraw = drawn.redraw;
    parts.push(h('h3', {}, 'Neighbourhood'), drawn.picture, h('p', {class: 'soft'},
      'A small sphere about the vertex, turned as the picture is: edges leave nodes on it, faces leave arcs, regions the pieces between them.'));
  }
  if (kind === 'f') {
    const corners = model.incidence.faceVertices.of(i);
    parts.push(h('details', {}, h('summary', {}, 'Corners, exactly'), ...Array.from(corners.slice(0, SHOWN), (v) =>
      h('div', {}, cellList([{kind: 'v', i: v}], pick), coordinates(model, cells.vertices.point[v])))));
  }
  const told = model.story(cell);
  parts.push(h('h3', {}, 'Story'));
  if (told) parts.push(storyText(told));
  else parts.push(h('p', {class: 'soft'}, 'All stories of all nodes would be too many for a page, and this node’s are left out. This tells the one:'));
  parts.push(command(['cnrg', 'explain', model.page.tree, '--node', model.node.name, '--cell', nameOf(cell)], copied));
  if (told && model.page.several) parts.push(h('p', {class: 'soft'}, 'The page refines all of its nodes together, the command this node alone: it may count fewer cells of the refinement.'));
  holder.replaceChildren(...parts.filter(Boolean));
  redraw?.(axes());
  return redraw;
}

/** An entity of the operands, in what became of it. */
function showEntity(holder, model, cell, copied) {
  const from = model.classes.cells, dimension = {V: 0, E: 1, F: 2}[cell.kind];
  const column = [from.vertices, from.edges, from.faces][dimension];
  const fate = model.classes.fates[column.component[cell.i]], row = fate.rows?.[dimension];
  const lost = model.lost(cell);
  holder.replaceChildren(
    h('p', {class: 'title'}, h('strong', {id: 'picked'}, ['vertex', 'edge', 'face'][dimension]), ' of the operands', h('span', {class: 'tag'}, fate.removed ? 'removed' : 'kept')),
    terms(fate.relation ? ['lies', fate.relation] : null, row ? ['row', h('mark', {}, row[0])] : null, row ? ['removes', row[1]] : null),
    h('p', {class: 'soft'}, fate.relation
      ? 'What the node’s table was asked of it, in the step that did not merely find it outside. A kept face or edge keeps its boundary, whatever the row says of that.'
      : 'This operator has no table: the entity is of an operand and not of the result.'),
    ...(lost ? [h('h3', {}, 'Story of a point in it'), storyText(lost.lines)] : [h('p', {class: 'soft'}, 'For one point:')]),
    command(['cnrg', 'explain', model.page.tree, '--node', model.node.name, '--point', lost?.point ?? 'X,Y,Z'], copied));
  return null;
}

const EULER = [
  ['v', 'vertices'], ['e', 'edges'], ['eh', 'edges that close without a vertex'], ['f', 'faces'], ['r', 'rings of faces'],
  ['fc', 'faces without boundary'], ['V', 'volumes'], ['Vh', 'handles of volumes'], ['Vc', 'cavities of volumes'],
  ['C', 'pieces'], ['Ch', 'holes through the whole'], ['Cc', 'cavities of the whole'],
];

function euler(t) {
  const patches = t.eh || t.fc;
  const side = (words) => words.map((w) => (/^[a-zA-Z]/.test(w) ? h('var', {}, w) : w));
  const formula = patches ? ['v', ' − (', 'e', ' − ', 'eh', ') + (', 'f', ' − ', 'r', ' + ', 'fc', ') − (', 'V', ' − ', 'Vh', ' + ', 'Vc', ') = ', 'C', ' − ', 'Ch', ' + ', 'Cc']
    : ['v', ' − ', 'e', ' + (', 'f', ' − ', 'r', ') − (', 'V', ' − ', 'Vh', ' + ', 'Vc', ') = ', 'C', ' − ', 'Ch', ' + ', 'Cc'];
  const filled = formula.map((w) => (/^[a-zA-Z]/.test(w) ? String(t[w]) : w)).join('');
  const left = t.v - (t.e - t.eh) + (t.f - t.r + t.fc) - (t.V - t.Vh + t.Vc), right = t.C - t.Ch + t.Cc;
  return h('div', {class: 'euler'}, h('p', {}, ...side(formula)), h('p', {class: 'number', id: 'euler'}, filled), h('p', {class: 'number'}, `${left} = ${right}`),
    h('table', {}, h('tbody', {}, ...EULER.filter(([k]) => patches || (k !== 'eh' && k !== 'fc')).map(([k, words]) => h('tr', {}, h('th', {scope: 'row'}, h('var', {}, k)), h('td', {}, words), h('td', {class: 'number'}, String(t[k])))))),
    t.closed ? null : h('p', {class: 'soft'}, 'Of the closure: the set misses some of its boundary.'));
}

const head = (...names) => h('thead', {}, h('tr', {}, ...names.map((n, k) => h('th', {scope: 'col', class: k ? 'number' : ''}, n))));

/** The panel of a node. */
export function showNode(holder, model, {pick, choose, legend}) {
  const {node, page} = model, parts = [];
  parts.push(h('p', {class: 'title'}, h('strong', {}, node.name), ` ${node.operator}`, h('span', {class: 'tag'}, node.group ? 'group' : 'components'),
    node.instances > 1 ? h('span', {class: 'tag'}, `${node.instances} instances`) : null));
  if (node.instances > 1) parts.push(h('p', {class: 'soft'}, 'It is used with different transforms; shown is the last of its instances.'));
  if (node.operands.length) {
    parts.push(h('p', {}, 'of ', ...node.operands.flatMap((o, k) => [k ? ', ' : '', h('button', {class: 'cellname', onclick: () => choose(o)}, page.nodes[o].name)])));
  }
  parts.push(h('table', {id: 'counts'}, head('cells', 'vertices', 'edges', 'faces', 'regions'), h('tbody', {},
    h('tr', {}, h('th', {scope: 'row'}, 'of the set'), ...node.counts.map((n) => h('td', {class: 'number'}, String(n)))),
    h('tr', {}, h('th', {scope: 'row'}, 'in the refinement'), ...node.raw.map((n) => h('td', {class: 'number'}, String(n)))))));
  if (node.volume) {
    parts.push(terms(['volume', ...volumeText(node.volume)],
      node.within ? ['of the true surfaces', node.within === 'unknown' ? 'unknown: of CAD faces only facets are known' : ['within ', h('span', {class: 'number'}, node.within), ' of it, as of each region']] : null));
  }
  const doubts = page.doubts.filter((d) => d.nodes.includes(model.index));
  if (doubts.length) {
    parts.push(h('h3', {}, 'Uncertain places'), h('p', {class: 'soft'}, 'It is not proven that surfaces meet there as their facets do:'),
      h('ol', {id: 'doubtlist'}, ...doubts.slice(0, 200).map((d) => h('li', {}, d.text))));
  }
  if (node.components.length) {
    parts.push(h('h3', {}, node.group ? 'Regions' : 'Components'), h('table', {}, h('tbody', {}, ...node.components.slice(0, 200).map((c, k) =>
      h('tr', {}, h('td', {}, model.componentName(k + 1)), h('td', {}, c.material), h('td', {class: 'soft'}, c.leaves.map((l) => page.leaves[l]).join(', ')))))));
  }
  if (node.removed.length) {
    parts.push(h('h3', {}, 'Removed, by row of the tables'), h('table', {}, h('tbody', {}, ...node.removed.map(([id, words, count]) =>
      h('tr', {}, h('th', {scope: 'row'}, h('mark', {}, id)), h('td', {}, words), h('td', {class: 'number'}, String(count)))))),
      h('p', {class: 'soft'}, 'Cells to which the operands cut each other; “removed cells” shows them as ghosts.'));
  }
  if (node.euler) parts.push(h('h3', {}, 'Euler–Poincaré'), euler(node.euler));
  if (node.betti) {
    parts.push(h('h3', {}, 'Betti numbers'), h('table', {id: 'betti'}, head('of', 'b0', 'b1', 'b2'), h('tbody', {}, ...node.betti.slice(0, 200).map(([c, ...b]) =>
      h('tr', {}, h('th', {scope: 'row'}, c ? model.componentName(c) : 'point set'), ...b.slice(0, 3).map((x, k) => h('td', {class: 'number'}, x === b[k + 3] ? String(x) : `${x} (Q: ${b[k + 3]})`)))))),
      h('p', {class: 'soft'}, 'b0 pieces, b1 independent loops, b2 enclosed cavities; the same over Z/2 and Q.'));
    if (!node.euler) parts.push(h('p', {class: 'soft'}, 'Euler–Poincaré is not stated: the set is unbounded.'));
  }
  if (node.left_out?.includes('topology')) parts.push(h('p', {class: 'soft'}, 'Its topology is left out, for the nodes have too many cells; `cnrg eval --topology` tells it.'));
  const odd = new Map();
  for (const kind of ['v', 'e']) model.shapes?.[kind].forEach((w, i) => {
    const word = w && page.words[w - 1];
    if (word && word.startsWith('non-manifold')) (odd.get(word) ?? odd.set(word, []).get(word)).push({kind, i});
  });
  if (odd.size) parts.push(h('h3', {}, 'Where it is no manifold'), terms(...[...odd].map(([word, list]) => [word.replace(/^non-manifold: /, ''), cellList(list, pick)])));
  holder.replaceChildren(...parts);
}
