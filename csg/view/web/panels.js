// What is told of a cell and of a node. Everything that comes from a file goes in as text, never as HTML.
import {hex} from './colors.js';
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
const volumeText = ([exact, decimal]) => (exact.includes('/') ? [h('span', {class: 'number'}, decimal), h('span', {class: 'soft'}, ' ', exactText(exact))] : [h('span', {class: 'number'}, exact)]);
/** Measures come from rounded places: they are for reading. */
const measure = (x) => String(+x.toPrecision(6));
const degrees = (angle) => `${+((angle * 180) / Math.PI).toFixed(2)}°`;
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
    const shown = h('span'), last = k + 1 === lines.length;
    let rest = line;
    for (let found; (found = /\b(union|intersection|difference)\.(face|edge|vertex)\.\w+(\.\w+)?/.exec(rest)); ) {
      shown.append(rest.slice(0, found.index), h('mark', {}, found[0]));
      rest = rest.slice(found.index + found[0].length);
    }
    shown.append(rest, last ? '' : '\n');
    pre.append(shown);
  });
  return pre;
}

/** The panel of a picked cell; returns what redraws its sphere when the camera turns. */
export function showCell(holder, model, cell, {pick, tintOf, copied, axes, chooseRow}) {
  if (!cell) {
    holder.replaceChildren(h('p', {class: 'hint'}, 'Pick a cell in the picture, or find one by its name: v3, e0, f12, r1.'));
    return null;
  }
  if (cell.kind === cell.kind.toUpperCase()) return showEntity(holder, model, cell, copied, chooseRow);
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
  const drawing = diagram(model, cell, tintOf);
  const rows = model.fates(cell).map((f) => [f, f.rows?.['vef'.indexOf(kind)]?.[0]]).filter(([, id]) => id);
  const parts = [
    h('p', {class: 'title'}, h('strong', {id: 'picked'}, nameOf(cell)), ` ${WORDS[kind]}`, ...says.map((s) => h('span', {class: 'tag'}, s))),
    ...drawing.parts,
    terms(
      c ? ['component', swatch(tintOf(cell)), ' ', model.componentName(c)] : null,
      said?.name && said !== component ? ['name', said.name] : null,
      said?.material || component?.material ? ['material', said?.material || component.material] : null,
      ...(said?.attributes ?? []).map(([key, value]) => [key, value]),
      volume ? ['volume', ...volumeText(volume)] : null,
      kind === 'e' ? ['length', h('span', {id: 'length', class: 'number'}, `≈ ${measure(model.length(i))}`)] : null,
      kind === 'f' ? ['area', h('span', {id: 'area', class: 'number'}, `≈ ${measure(model.area(i))}`)] : null,
      ...rows.map(([f, id]) => [f.relation, rowButton(id, chooseRow)]),
      shape ? ['around it', shape] : null,
      origin.length ? ['from', h('ul', {class: 'plain'}, ...origin.map((o) => h('li', {}, model.page.leaves[o.leaf] || 'frame', ': ', o.text)))] : null,
    ),
  ];
  const around = model.around(cell).filter(([, list]) => list.length);
  if (around.length) parts.push(h('h3', {}, 'Incidence'), terms(...around.map(([word, list]) => [word, cellList(list, pick)])));
  if (kind === 'v') parts.push(h('h3', {}, 'Where'), coordinates(model, cells.vertices.point[i]));
  if (kind === 'e' && !(flags & 1)) {
    const ends = [...new Set([cells.edges.points.of(i)[0], cells.edges.points.of(i).at(-1)])];
    parts.push(h('details', {}, h('summary', {}, 'Ends, exactly'), ...ends.map((p) => coordinates(model, p))));
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
  drawing.redraw?.(axes());
  return drawing.redraw;
}

/** What is around a cell as a drawing, with its words, and what redraws it when the camera turns. */
function diagram(model, {kind, i}, tintOf) {
  if (kind === 'e') {
    const {picture, words, wedges} = fan(model, i, tintOf);
    if (!words) return {parts: [h('p', {class: 'soft'}, 'A wire: no face is around it.')], redraw: null};
    return {redraw: null, parts: [picture, h('p', {class: 'soft'}, `Radial order, counter-clockwise with the edge pointing at you: ${words}`),
      wedges.length > 1 ? h('p', {class: 'soft', id: 'wedges'}, `Angles: ${wedges.map(({from, to, angle}) => `f${from} to f${to} ${degrees(angle)}`).join(', ')}`) : null]};
  }
  if (kind !== 'v' || !(model.incidence.vertexEdges.of(i).length || model.incidence.vertexFaces.of(i).length)) return {parts: [], redraw: null};
  const {picture, redraw} = sphere(model, i, tintOf);
  return {redraw, parts: [picture, h('p', {class: 'soft'}, 'A small sphere about the vertex, turned as the picture is: edges leave nodes on it, faces leave arcs, regions the pieces between them.')]};
}

const rowButton = (id, chooseRow) => h('button', {class: 'rowname', 'data-row': id, 'aria-pressed': 'false', title: 'Show the cells of this row', onclick: () => chooseRow(id)}, id);

/** An entity of the operands, in what became of it. */
function showEntity(holder, model, cell, copied, chooseRow) {
  const from = model.classes.cells, dimension = {V: 0, E: 1, F: 2}[cell.kind];
  const column = [from.vertices, from.edges, from.faces][dimension];
  const fate = model.classes.fates[column.component[cell.i]], row = fate.rows?.[dimension];
  const lost = model.lost(cell);
  holder.replaceChildren(
    h('p', {class: 'title'}, h('strong', {id: 'picked'}, ['vertex', 'edge', 'face'][dimension]), ' of the operands', h('span', {class: 'tag'}, fate.removed ? 'removed' : 'kept')),
    terms(fate.relation ? ['lies', fate.relation] : null, row ? ['row', rowButton(row[0], chooseRow)] : null, row ? ['removes', row[1]] : null),
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

const WHERE = {AinB: 'of A, in a region of B', BinA: 'of B, in a region of A', INTERS: 'of both', AoutB: 'of A, outside of all regions of B', BoutA: 'of B, outside of all regions of A'};
const KINDS = ['vertices', 'edges', 'faces'];

/** Which operand is A in the rows, step by step. */
function roles({node, page}) {
  const names = node.operands.map((o) => page.nodes[o].name), {steps} = node.asked, shown = steps.slice(0, 6);
  const line = ([operand, swapped, dominant, rule]) => {
    const before = operand > 1 ? 'what is there' : names[0], [a, b] = swapped ? [names[operand], before] : [before, names[operand]];
    const who = {materials: 'materials decide', blend: 'all stay'}[rule] ?? (node.operator === 'difference' ? 'A − B' : dominant ? 'A > B: A dominates' : 'A = B: equals');
    return h('li', {}, `A is ${a}, B is ${b}; ${who}`);
  };
  if (names.length < 2 || shown.some(([operand]) => operand >= names.length)) return null;
  return h('ul', {class: 'plain', id: 'roles'}, ...shown.map(line), steps.length > shown.length ? h('li', {}, `and ${steps.length - shown.length} more steps`) : null);
}

/** All rows that the node asked, with what each kept and removed. */
function rowsTable(model, chooseRow) {
  const {rows} = model.node.asked, {relations, none} = model.page.colors;
  const groups = new Map();
  for (const row of rows) {
    const standing = row[0].split('.')[3], key = `${KINDS[row[1]]}${standing ? (standing === 'dominant' ? ', A > B' : ', A = B') : ''}`;
    (groups.get(key) ?? groups.set(key, []).get(key)).push(row);
  }
  const line = ([id, , relation, when, kept, removed]) => h('tr', {class: kept + removed ? '' : 'idle'},
    h('th', {scope: 'row'}, h('button', {class: 'rowname', 'data-row': id, 'aria-pressed': 'false', title: `${id}: show its cells`, onclick: () => chooseRow(id)}, swatch(relations[relation] ?? none), ' ', relation)),
    h('td', {}, when), h('td', {class: 'number'}, String(kept)), h('td', {class: 'number'}, String(removed)));
  return h('table', {id: 'rows'}, h('thead', {}, h('tr', {}, ...['row', 'removes when', 'kept', 'removed'].map((word, k) => h('th', {scope: 'col', class: k > 1 ? 'number' : ''}, word)))), ...[...groups].map(([key, list]) =>
    h('tbody', {}, h('tr', {}, h('th', {scope: 'colgroup', colspan: '4', class: 'group'}, key)), ...list.map(line))));
}

/** The panel of a node. */
export function showNode(holder, model, {pick, choose, chooseRow}) {
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
  if (node.asked) {
    parts.push(h('h3', {}, 'Rows of the tables'), roles(model), rowsTable(model, chooseRow),
      h('p', {class: 'soft'}, 'Cells to which the operands cut each other; a row that is chosen shows its cells. What bounds a kept cell is kept, and its row is not asked. Our reading of Fig. 3 of Pereira et al. (2012).'),
      terms(...Object.entries(WHERE)));
  } else if (node.removed.length) {
    parts.push(h('h3', {}, 'Removed, by row of the tables'), h('table', {}, h('tbody', {}, ...node.removed.map(([id, words, count]) =>
      h('tr', {}, h('th', {scope: 'row'}, h('mark', {}, id)), h('td', {}, words), h('td', {class: 'number'}, String(count)))))),
      h('p', {class: 'soft'}, 'Too many entities to ask the tables about each on a page.'));
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
  holder.replaceChildren(...parts.filter(Boolean));
}
