// The page: its state, what shows it, and what changes it. The state is in the address, so that a link restores it.
import {rgb} from './colors.js';
import {Dag} from './dag.js';
import {Page, source} from './data.js';
import {Model, nameOf, WORDS} from './model.js';
import {h, showCell, showNode, swatch} from './panels.js';
import {Scene} from './scene.js';

const DOUBT = '#d6006c', FRONT = [0.55, -0.95, 0.62];
const $ = (id) => document.getElementById(id);
let page = new Page(source.json);
source.json = null;

/** `through`: null until somebody decides; `normal` is the section's, of length 1; `hidden`: keys of the legend. */
const state = {node: page.result, cell: null, row: null, color: null, show: [true, true, true, true], labels: false, ghosts: false, through: null, doubts: true,
  explode: 0, axis: '', normal: null, cut: 0.5, flip: false, hidden: new Set(), pick: 'any', theme: null, view: null};
const AXES = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]};
/** A closed model opens see-through if something is inside of it. */
const through = () => state.through ?? (model.hides && !state.axis);

// --- light and dark

const prefersDark = matchMedia('(prefers-color-scheme: dark)');
let printing = false;
const dark = () => !printing && (state.theme ?? (prefersDark.matches ? 'dark' : 'light')) === 'dark';
const css = (name) => rgb(getComputedStyle(document.documentElement).getPropertyValue(name).trim());
function applyTheme() {
  document.documentElement.dataset.theme = dark() ? 'dark' : 'light';
  $('theme').textContent = dark() ? 'Light' : 'Dark';
}

// --- the scene

let model = null, scene = null, redrawSphere = null, places = [];
const overlay = $('labelled').getContext('2d');
try {
  scene = new Scene($('scene'), onDrawn);
} catch (fault) {
  tell('This browser gives no WebGL: the picture is missing, everything else is here. `cnrg eval TREE -o FILE.svg` makes a still.', true);
}

function extent() {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const reach = (m) => {
    for (let i = 0; i < m.cells.points.length; ++i) m.at(i).forEach((x, k) => {
      low[k] = Math.min(low[k], x);
      high[k] = Math.max(high[k], x);
    });
  };
  reach(Model.of(page, page.result));
  if (!Number.isFinite(low[0])) page.nodes.forEach((_, i) => reach(Model.of(page, i)));
  if (!Number.isFinite(low[0])) return [[-1, -1, -1], [1, 1, 1]];
  return [low, high];
}

const look = () => ({color: state.color, ink: css('--ink'), paper: css('--stage'), dark: dark(), apart: state.explode > 0, show: state.show, ghosts: state.ghosts, through: through(), hidden: state.hidden});

function draw() {
  if (scene) {
    scene.show(model, look());
    mark();
  }
  $('through').checked = through();
  showLegend();
  refreshLabels();
}

/** The picked cell and the cells of the chosen row. */
const mark = () => scene?.pick([...(state.row ? model.ofRow(state.row) : []), ...(state.cell ? [state.cell] : [])], css('--accent'));

let labelTimer = 0;
function refreshLabels() {
  places = [];
  clearTimeout(labelTimer);
  if (scene && (state.labels || state.cell)) {
    labelTimer = setTimeout(() => {
      places = state.labels ? scene.labelPlaces() : [];
      drawLabels();
    }, 260);
  }
  drawLabels();
}

function onDrawn(moving) {
  if (moving && state.labels) refreshLabels();
  else drawLabels();
  redrawSphere?.(scene.axes());
  if (moving) later();
}

/** Names where the cells are seen, those of few pixels last, none over another. */
function drawLabels(context = overlay, times = Math.min(devicePixelRatio || 1, 2)) {
  if (!scene) return;
  const canvas = context.canvas;
  if (context === overlay) {
    const size = [Math.round(scene.width * times), Math.round(scene.height * times)];
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    context.setTransform(times, 0, 0, times, 0, 0);
    context.clearRect(0, 0, scene.width, scene.height);
  }
  context.setTransform(times, 0, 0, times, 0, 0);
  drawAxes(context);
  drawDoubts(context);
  if (!state.labels) return;
  const taken = [];
  context.font = '600 11px ui-sans-serif, system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const order = {f: 1, e: 2, v: 0, r: 3};
  for (const {cell, x, y} of [...places].sort((a, b) => order[a.cell.kind] - order[b.cell.kind] || b.size - a.size)) {
    if (!(cell.kind in order)) continue;
    const word = nameOf(cell), w = context.measureText(word).width + 8, dy = cell.kind === 'v' ? -12 : 0;
    const box = [x - w / 2, y + dy - 8, x + w / 2, y + dy + 8];
    if (box[0] < 2 || box[2] > scene.width - 2 || taken.some((t) => box[0] < t[2] && t[0] < box[2] && box[1] < t[3] && t[1] < box[3])) continue;
    taken.push(box);
    if (taken.length > 400) break;
    context.globalAlpha = 0.86;
    context.fillStyle = dark() ? '#11161c' : '#ffffff';
    context.beginPath();
    context.roundRect(box[0], box[1], w, 16, 4);
    context.fill();
    context.globalAlpha = 1;
    context.fillStyle = {v: dark() ? '#9fd0ff' : '#00508a', e: dark() ? '#e4e9ee' : '#2b333b', f: dark() ? '#ffc46b' : '#7a4a00', r: '#888'}[cell.kind];
    context.fillText(word, x, y + dy);
  }
}

/** Uncertain places of the node, by their numbers in its panel, and where they are in the picture. */
const doubts = () => (state.doubts && scene ? page.doubts.filter((d) => d.nodes.includes(state.node)).map((d) => ({...d, place: scene.project(scene.place(d.at))})) : []);
function drawDoubts(context) {
  context.strokeStyle = context.fillStyle = DOUBT;
  context.lineWidth = 2.5;
  doubts().forEach(({place: [x, y]}) => {
    context.beginPath();
    context.arc(x, y, 9, 0, 2 * Math.PI);
    context.stroke();
  });
  context.font = '700 12px ui-sans-serif, system-ui, sans-serif';
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  const taken = [];
  doubts().forEach(({place: [x, y]}, k) => {
    if (taken.some(([a, b]) => Math.abs(x - a) < 24 && Math.abs(y - b) < 16)) return;
    taken.push([x, y]);
    context.fillText(`${k + 1}?`, x + 12, y - 9);
  });
}

function drawAxes(context) {
  const [right, up] = scene.axes(), size = 26, x = 40, y = scene.height - 64;
  context.font = '600 11px ui-sans-serif, system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  context.lineWidth = 1.5;
  ['x', 'y', 'z'].forEach((name, k) => {
    const u = right[k] * size, v = -up[k] * size;
    context.strokeStyle = context.fillStyle = dark() ? '#aeb8c2' : '#4a545e';
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x + u, y + v);
    context.stroke();
    context.fillText(name, x + u * 1.38, y + v * 1.38);
  });
}

// --- what is chosen

function chooseNode(index, keep = null) {
  state.node = index;
  model = Model.of(page, index);
  if (!keep || !model.has(keep)) keep = null;
  state.cell = keep;
  if (!model.node.asked?.rows.some(([id]) => id === state.row)) state.row = null;
  dag.mark(index, model.node.operands);
  const [v, e, f, r] = model.node.counts;
  $('caption').replaceChildren(h('strong', {}, model.node.name), ` ${model.node.operator} · ${v} v, ${e} e, ${f} f, ${r} r`);
  $('step').textContent = `${index + 1} of ${page.nodes.length}: ${model.node.name}`;
  $('back').disabled = index === 0;
  $('forth').disabled = index + 1 === page.nodes.length;
  showNode($('node'), model, {pick, choose: (i) => chooseNode(i), chooseRow});
  showRow();
  draw();
  showPicked();
  later();
}

function tintOf(cell) {
  return scene?.geometry ? scene.geometry.tintOf(cell) : [128, 128, 128];
}

function showPicked() {
  redrawSphere = showCell($('cell'), model, state.cell, {pick, tintOf, copied, chooseRow, axes: () => scene?.axes() ?? [[1, 0, 0], [0, 0, 1], [0, -1, 0]]});
  $('p-cell').scrollTop = 0;
  showRow();
  for (const b of document.querySelectorAll('#axis option[value=face]')) b.disabled = state.cell?.kind !== 'f' && state.axis !== 'face';
}

/** The rows that decided on the picked cell, and the one that is chosen, in the panels. */
function showRow() {
  const decided = state.cell ? model.rowsOf(state.cell) : [];
  for (const button of document.querySelectorAll('[data-row]')) {
    const chosen = button.dataset.row === state.row;
    button.setAttribute('aria-pressed', String(chosen));
    button.closest('tr')?.classList.toggle('decided', decided.includes(button.dataset.row));
  }
}

/** The cells of a row, kept and removed, in the picture; once more: no longer. */
function chooseRow(id) {
  state.row = state.row === id ? null : id;
  mark();
  showRow();
  if (state.row) tell(`${id}: ${model.ofRow(id).length || 'no'} cells in the picture`);
  later();
}

function pick(cell) {
  state.cell = cell;
  mark();
  showPicked();
  if (cell) panel('cell');
  later();
}

function panel(name) {
  document.body.dataset.panel = name;
  for (const b of document.querySelectorAll('.tabs button')) b.toggleAttribute('aria-current', b.dataset.panel === name);
}

let noteTimer = 0;
function tell(text, stays = false) {
  $('note').textContent = text;
  $('note').hidden = false;
  clearTimeout(noteTimer);
  if (!stays) noteTimer = setTimeout(() => ($('note').hidden = true), 3500);
}
async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    tell('Copied');
  } catch {
    const area = h('textarea', {});
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    tell(done ? 'Copied' : text);
  }
}

/** What signs and colors stand for; a click hides it. */
function showLegend() {
  const rows = [...(scene?.geometry?.legend ?? [])], most = 14;
  const entry = ([key, row]) => h('li', {}, h('button', {'aria-pressed': String(!state.hidden.has(key)), title: state.hidden.has(key) ? 'Show' : 'Hide', onclick: () => hide(key)}, swatch(row.tint, row.sign), row.label));
  const list = h('ul', {}, ...rows.slice(0, most).map(entry));
  if (rows.length > most) list.append(h('li', {class: 'soft'}, `and ${rows.length - most} more`));
  const open = doubts();
  if (open.length) list.append(h('li', {}, swatch(rgb(DOUBT), 'doubt'), 'uncertain: surfaces may meet otherwise'));
  const says = [];
  if (state.color === 'class' && !model.classes) {
    says.push(h('p', {}, model.node.left_out?.includes('classes') ? 'Too many entities to ask the table about each.' : model.node.operands.length ? 'Nothing to tell apart here.' : 'A leaf has no operands.'));
  }
  $('legend').replaceChildren(...says, list);
  $('legend').hidden = rows.length === 0 && says.length === 0 && open.length === 0;
}

function hide(key) {
  if (!state.hidden.delete(key)) state.hidden.add(key);
  draw();
  [...$('legend').querySelectorAll('button')][[...scene.geometry.legend.keys()].indexOf(key)]?.focus();
  later();
}

// --- the address

function hash() {
  const out = new URLSearchParams();
  out.set('node', page.nodes[state.node].name);
  if (state.cell && state.cell.kind === state.cell.kind.toLowerCase()) out.set('cell', nameOf(state.cell));
  if (state.row) out.set('row', state.row);
  out.set('color', state.color);
  const hidden = state.show.map((s, k) => (s ? '' : k)).join('');
  if (hidden) out.set('hide', hidden);
  for (const key of ['labels', 'ghosts', 'flip']) if (state[key]) out.set(key, '1');
  if (state.through !== null) out.set('through', state.through ? '1' : '0');
  for (const key of state.hidden) out.append('off', key);
  if (!state.doubts) out.set('doubts', '0');
  if (state.explode) out.set('apart', state.explode);
  if (state.axis) (out.set('axis', state.axis), out.set('cut', state.cut));
  if (state.normal) out.set('normal', state.normal.map((x) => +x.toFixed(5)).join());
  if (state.theme) out.set('theme', state.theme);
  if (scene) out.set('view', scene.view.join(','));
  return '#' + out.toString();
}
let laterTimer = 0;
function later() {
  clearTimeout(laterTimer);
  laterTimer = setTimeout(remember, 250);
}
function remember() {
  clearTimeout(laterTimer);
  try {
    history.replaceState(null, '', hash());
  } catch { /* some browsers keep the address of a file as it is */ }
}

function parseCell(word) {
  const found = /^([vefr])(\d+)$/.exec(word ?? '');
  return found && {kind: found[1], i: Number(found[2])};
}

function restore() {
  const from = new URLSearchParams(location.hash.slice(1));
  const index = page.nodes.findIndex((n) => n.name === from.get('node'));
  if (index >= 0) state.node = index;
  const colors = [...$('color').options].map((o) => o.value);
  if (colors.includes(from.get('color'))) state.color = from.get('color');
  const hidden = from.get('hide') ?? '';
  state.show = [0, 1, 2, 3].map((k) => !hidden.includes(String(k)));
  for (const key of ['labels', 'ghosts', 'flip']) state[key] = from.get(key) === '1';
  state.through = from.has('through') ? from.get('through') === '1' : null;
  state.row = from.get('row');
  state.hidden = new Set(from.getAll('off'));
  state.doubts = from.get('doubts') !== '0';
  const within = (key, most, or) => (from.has(key) && Number.isFinite(+from.get(key)) ? Math.min(Math.max(+from.get(key), 0), most) : or);
  state.explode = within('apart', 1.5, 0);
  const normal = (from.get('normal') ?? '').split(',').map(Number), size = Math.hypot(...normal);
  state.normal = normal.length === 3 && size > 0 && Number.isFinite(size) ? normal.map((x) => x / size) : null;
  const axis = from.get('axis');
  state.axis = axis in AXES || (['view', 'face'].includes(axis) && state.normal) ? axis : '';
  if (!['view', 'face'].includes(state.axis)) state.normal = null;
  state.cut = within('cut', 1, 0.5);
  if (['light', 'dark'].includes(from.get('theme'))) state.theme = from.get('theme');
  const view = (from.get('view') ?? '').split(',').map(Number);
  state.view = view.length === 6 && view.every(Number.isFinite) ? view : null;
  return parseCell(from.get('cell'));
}

function showControls() {
  [0, 1, 2, 3].forEach((k) => ($(`show${k}`).checked = state.show[k]));
  for (const key of ['labels', 'ghosts', 'doubts']) $(key).checked = state[key];
  $('doubtful').hidden = page.doubts.length === 0;
  $('color').value = state.color;
  $('explode').value = state.explode;
  $('axis').value = state.axis;
  $('cut').value = state.cut;
  $('cut').disabled = $('place').disabled = $('flip').disabled = !state.axis;
  showPlace();
  $('flip').setAttribute('aria-pressed', state.flip);
}

const normal = () => state.normal ?? AXES[state.axis];
/** Where the section is along its normal: along an axis a coordinate. */
function showPlace() {
  const [near, far] = state.axis && scene ? scene.reachAlong(normal()) : [0, 0];
  $('place').value = state.axis ? +(near + (far - near) * state.cut).toPrecision(6) : '';
}

function section() {
  const flip = state.flip !== ['x', 'z'].includes(state.axis);  // unflipped, a cut faces the first view
  scene?.setSection(state.axis ? {normal: normal(), at: state.cut, flip} : null);
  showPlace();
  mark();
}

/** Another direction of the section: an axis, across the view, or along the picked face. */
function turnSection(axis) {
  const was = through();
  state.axis = axis;
  state.normal = null;
  if (axis === 'view') state.normal = scene.axes()[2].map((x) => -x);
  if (axis === 'face') {
    const [a, b, c] = Array.from(model.cells.faces.triangles.of(state.cell.i).subarray(0, 3), (p) => model.at(p)), u = b.map((x, k) => x - a[k]), v = c.map((x, k) => x - a[k]);
    const n = [0, 1, 2].map((k) => u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3]), size = Math.hypot(...n);
    state.normal = n.map((x) => x / size);
    const [near, far] = scene.reachAlong(state.normal);
    state.cut = (a.reduce((sum, x, k) => sum + x * state.normal[k], 0) - near) / (far - near || 1);
  }
  showControls();
  if (was !== through()) draw();
  section();
  refreshLabels();
  later();
}

// --- search

function find(word) {
  const text = word.trim().toLowerCase(), out = [];
  if (!text) return out;
  const cell = parseCell(text);
  if (cell && model.has(cell)) out.push({label: nameOf(cell), kind: WORDS[cell.kind], go: () => pick(cell)});
  const has = (name) => name.toLowerCase().includes(text);
  page.nodes.forEach((n, i) => has(n.name) && out.push({label: n.name, kind: 'node', go: () => chooseNode(i)}));
  const {component} = model.cells.regions;
  model.node.components.forEach((c, k) => {
    if (!has(c.name) && !has(c.material)) return;
    const region = component.indexOf(k + 1), kind = c.material ? `component, ${c.material}` : 'component';
    const first = region >= 0 ? {kind: 'r', i: region} : ['f', 'e', 'v'].map((x) => ({kind: x, i: model.column(x).component.indexOf(k + 1)})).find((x) => x.i >= 0);
    if (first) out.push({label: model.componentName(k + 1), kind, go: () => pick(first)});
  });
  for (const name of new Set(page.leaves.filter(has))) {
    const from = out.length < 12 && model.fromLeaf(name);
    if (from) out.push({label: `${nameOf(from)} from ${name}`, kind: 'leaf', go: () => pick(from)});
  }
  return out.slice(0, 12);
}

let hits = [], chosen = 0;
function showHits() {
  const input = $('search');
  hits = find(input.value);
  chosen = Math.min(chosen, Math.max(hits.length - 1, 0));
  const list = hits.map((hit, k) => h('li', {role: 'option', id: `hit${k}`, 'aria-selected': k === chosen ? 'true' : 'false', onclick: () => take(k)}, h('span', {}, hit.label), h('small', {}, hit.kind)));
  $('found').replaceChildren(...(list.length ? list : [h('li', {role: 'option', 'aria-disabled': 'true', 'aria-selected': 'false'}, 'nothing of that name here')]));
  $('found').hidden = !input.value.trim();
  input.setAttribute('aria-expanded', String(!$('found').hidden));
  if (hits.length) input.setAttribute('aria-activedescendant', `hit${chosen}`);
  else input.removeAttribute('aria-activedescendant');
}
function take(k) {
  if (!hits[k]) return;
  hits[k].go();
  $('search').value = '';
  chosen = 0;
  showHits();
  $('search').blur();
}

// --- picture and print

function picture(times) {
  const canvas = scene.picture(times), context = canvas.getContext('2d');
  drawLabels(context, times);
  context.font = '600 13px ui-sans-serif, system-ui, sans-serif';
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.fillStyle = dark() ? '#e4e9ee' : '#1c242c';
  context.fillText($('caption').textContent, 14, scene.height - 14);
  return canvas;
}

// --- everything together

let dag = null;
function showTree() {
  dag?.leave();
  dag = new Dag($('dag'), page.nodes, (i) => chooseNode(i));
  $('title').textContent = page.tree.replace(/^.*\//, '');
}

function wire() {
  $('back').onclick = () => state.node > 0 && chooseNode(state.node - 1);
  $('forth').onclick = () => state.node + 1 < page.nodes.length && chooseNode(state.node + 1);
  [0, 1, 2, 3].forEach((k) => ($(`show${k}`).onchange = (e) => ((state.show[k] = e.target.checked), draw(), later())));
  for (const key of ['labels', 'ghosts', 'through', 'doubts']) $(key).onchange = (e) => ((state[key] = e.target.checked), draw(), later());
  $('color').onchange = (e) => ((state.color = e.target.value), draw(), state.cell && showPicked(), later());
  $('explode').oninput = (e) => {
    const apart = state.explode > 0;
    state.explode = +e.target.value;
    scene?.setExplode(state.explode);
    if (apart !== state.explode > 0) draw();
    refreshLabels();
    later();
  };
  $('axis').onchange = (e) => turnSection(e.target.value);
  $('place').onchange = (e) => {
    const [near, far] = scene.reachAlong(normal());
    state.cut = Math.min(Math.max((e.target.value - near) / (far - near || 1), 0), 1);
    $('cut').value = state.cut;
    section();
    refreshLabels();
    later();
  };
  $('cut').oninput = (e) => ((state.cut = +e.target.value), section(), refreshLabels(), later());
  $('flip').onclick = () => ((state.flip = !state.flip), showControls(), section(), refreshLabels(), later());
  document.querySelectorAll('[name=pick]').forEach((r) => (r.onchange = () => (state.pick = r.value)));
  document.querySelectorAll('.tabs button').forEach((b) => (b.onclick = () => panel(b.dataset.panel)));
  $('fit').onclick = () => scene?.fit();
  document.querySelectorAll('[data-view]').forEach((b) => (b.onclick = () => scene?.lookFrom(...{x: [1, 0, 0], y: [0, -1, 0], z: [0, -0.0001, 1]}[b.dataset.view])));
  $('theme').onclick = () => {
    state.theme = dark() ? 'light' : 'dark';
    applyTheme();
    draw();
    later();
  };
  prefersDark.addEventListener('change', () => (applyTheme(), draw()));
  $('link').onclick = () => {
    remember();
    copied(location.href.replace(/#.*$/, '') + hash());
  };
  $('png').onclick = () => picture(2).toBlob((blob) => {
    const a = h('a', {href: URL.createObjectURL(blob), download: `${page.tree.replace(/^.*\//, '').replace(/\.\w+$/, '')}-${model.node.name.replace(/[^\w-]+/g, '_')}.png`});
    a.click();
    setTimeout(() => URL.revokeObjectURL(a.href), 1000);
  });
  $('print').onclick = () => window.print();
  addEventListener('beforeprint', () => {
    if (!scene) return;
    printing = true;  // on paper it is light
    applyTheme();
    draw();
    $('printed').src = picture(2).toDataURL();
    $('printed').hidden = false;
  });
  addEventListener('afterprint', () => {
    printing = false;
    $('printed').hidden = true;
    applyTheme();
    draw();
  });
  $('help').onclick = () => $('keys').showModal();

  const search = $('search');
  search.oninput = () => ((chosen = 0), showHits());
  search.onkeydown = (e) => {
    if (e.key === 'Enter') take(chosen);
    else if (e.key === 'ArrowDown' || e.key === 'ArrowUp') {
      chosen = (chosen + (e.key === 'ArrowDown' ? 1 : hits.length - 1)) % Math.max(hits.length, 1);
      showHits();
    } else if (e.key === 'Escape') {
      search.value = '';
      showHits();
      search.blur();
    } else return;
    e.preventDefault();
  };
  search.onblur = () => setTimeout(() => ($('found').hidden = true, search.setAttribute('aria-expanded', 'false')), 150);

  addEventListener('keydown', (e) => {
    if (e.target.matches('input, select, textarea') || e.ctrlKey || e.metaKey || e.altKey || $('keys').open) return;
    const on = (id) => ($(id).click(), true);
    const camera = document.activeElement === $('scene') && scene;
    const keys = {
      '[': () => on('back'), ']': () => on('forth'), '/': () => ($('search').focus(), true), '?': () => on('help'), l: () => on('labels'), g: () => on('ghosts'), t: () => on('through'),
      1: () => on('show0'), 2: () => on('show1'), 3: () => on('show2'), 4: () => on('show3'), d: () => on('theme'), 0: () => on('fit'), Escape: () => (pick(null), true),
      c: () => {
        const all = $('color');
        all.selectedIndex = (all.selectedIndex + 1) % all.options.length;
        all.dispatchEvent(new Event('change'));
        return true;
      },
      ...(camera && {ArrowLeft: () => (scene.turn(-0.12, 0), true), ArrowRight: () => (scene.turn(0.12, 0), true), ArrowUp: () => (scene.turn(0, 0.12), true),
        ArrowDown: () => (scene.turn(0, -0.12), true), '+': () => (scene.zoom(0.87), true), '-': () => (scene.zoom(1.15), true)}),
    };
    if (keys[e.key]?.()) e.preventDefault();
  });

  if (scene) {
    let down = null;
    const canvas = $('scene');
    canvas.addEventListener('pointerdown', (e) => (down = [e.clientX, e.clientY, performance.now()]));
    canvas.addEventListener('pointerup', (e) => {
      if (!down || Math.hypot(e.clientX - down[0], e.clientY - down[1]) > (e.pointerType === 'touch' ? 12 : 4) || e.button !== 0) return;
      const box = canvas.getBoundingClientRect(), begin = performance.now();
      const near = doubts().findIndex(({place: [x, y]}) => Math.hypot(x + box.left - e.clientX, y + box.top - e.clientY) < 11);
      if (near >= 0) return tell(`${near + 1}? ${doubts()[near].text}`, true);
      const cell = scene.at(e.clientX - box.left, e.clientY - box.top, e.shiftKey ? 'r' : state.pick);
      window.cnrg.pickTime = performance.now() - begin;
      pick(cell);
    });
    canvas.addEventListener('dblclick', () => scene.fit());
    new ResizeObserver(() => {
      scene.resize($('stage').clientWidth, $('stage').clientHeight);
      refreshLabels();
    }).observe($('stage'));
    scene.resize($('stage').clientWidth, $('stage').clientHeight);
  }
  addEventListener('hashchange', () => {
    if (location.hash !== hash()) begin();
  });
}

function signs() {
  const keys = [['[  ]', 'step through the nodes'], ['/', 'find'], ['c', 'color by the next'], ['l  g  t', 'labels, removed cells, see through'], ['1 2 3 4', 'vertices, edges, sheets, regions'], ['click in the legend', 'hide or show'],
    ['arrows  + −  0', 'turn, zoom, fit'], ['Shift + click', 'pick the region'], ['Esc', 'pick nothing'], ['d', 'light or dark']];
  $('keylist').replaceChildren(...keys.flatMap(([k, words]) => [h('dt', {}, h('kbd', {}, k)), h('dd', {}, words)]));
  const ink = css('--ink');
  const list = [['face', 'skin of a region', [120, 180, 220]], ['hatch', 'missing face: the region is open there', [120, 180, 220]], ['sheet', 'sheet: a face without a region of its own', page.colors.sheet], ['line', 'edge; thicker where a sheet ends', ink],
    ['dash', 'missing edge', ink], ['wire', 'wire', page.colors.wire], ['dot', 'vertex', ink], ['hollow', 'missing vertex', ink], ['point', 'isolated point', page.colors.wire], ['ghost', 'removed by the node', [150, 150, 150]]];
  $('signs').replaceChildren(...list.flatMap(([sign, words, tint]) => [h('dt', {}, swatch(tint, sign)), h('dd', {}, words)]));
}

/** Other data in the page. The camera stays, unless `fresh`, and so does what is chosen, as far as it is there. */
function load(json, fresh) {
  const before = page, {node} = state, view = fresh ? null : scene?.view;
  page = new Page(json);
  const same = node === before.result ? -1 : page.nodes.findIndex((n) => n.name === before.nodes[node].name);
  state.node = same < 0 ? page.result : same;
  if (state.color === before.color_by) state.color = page.color_by;
  scene?.setExtent(...extent());
  showTree();
  showControls();
  chooseNode(state.node, state.cell);
  section();
  if (view) scene.view = view;
  else scene?.lookFrom(...FRONT);
}

function begin() {
  const cell = restore();
  state.color ??= page.color_by;
  applyTheme();
  showControls();
  if (scene) scene.setExplode(state.explode);
  chooseNode(state.node, cell);
  section();
  if (scene) {
    if (state.view) scene.view = state.view;
    else scene.lookFrom(...FRONT);
  }
}

window.cnrg = {state, load, get page() { return page; }, get scene() { return scene; }, get model() { return model; }};
scene?.setExtent(...extent());
signs();
showTree();
wire();
panel('tree');
begin();
document.documentElement.dataset.ready = 'true';
