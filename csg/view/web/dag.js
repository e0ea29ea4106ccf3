// The tree as a drawing: a layer for each distance from the leaves, operands above their users, nodes as buttons. A
// layer wider than the panel is broken into rows, and a node is as wide as its words: so the drawing always fits, at
// the size in which letters are read.

const HEIGHT = 38, GAP_X = 6, GAP_ROW = 8, GAP_LAYER = 26, LEAST = 40, MOST = 128, BEND = 4;

/**
 * The nodes in layers, ordered so that few lines cross (by the mean place of neighbours, up and down). A line over
 * several layers has a bend in each between: numbers from `nodes.length` on. `ways[i][k]`: the bends from operand k to i.
 */
export function layers(nodes) {
  const layer = nodes.map(() => 0);
  nodes.forEach((node, i) => node.operands.forEach((o) => (layer[i] = Math.max(layer[i], layer[o] + 1))));
  const users = nodes.map(() => []);
  nodes.forEach((node, i) => node.operands.forEach((o) => users[o].push(i)));
  // A leaf stands just above its first user, not at the top of everything.
  nodes.forEach((node, i) => {
    if (!node.operands.length && users[i].length) layer[i] = Math.min(...users[i].map((u) => layer[u])) - 1;
  });
  const above = nodes.map(() => []), below = nodes.map(() => []);
  const join = (o, i) => (above[i].push(o), below[o].push(i));
  const ways = nodes.map((node, i) => node.operands.map((o) => {
    const bends = [];
    for (let l = layer[o] + 1, last = o; l <= layer[i]; ++l) {
      const next = l === layer[i] ? i : layer.push(l) - 1;
      if (next !== i) (bends.push(next), above.push([]), below.push([]));
      join(last, next);
      last = next;
    }
    return bends;
  }));
  const rows = [];
  layer.forEach((l, i) => (rows[l] ??= []).push(i));
  for (let l = 0; l < rows.length; ++l) rows[l] ??= [];
  const place = layer.map(() => 0);
  const settle = (row) => row.forEach((i, k) => (place[i] = k - (row.length - 1) / 2));
  rows.forEach(settle);
  const mean = (list, own) => (list.length ? list.reduce((s, x) => s + place[x], 0) / list.length : own);
  for (let round = 0; round < 12; ++round) {
    const down = round % 2 === 0;
    for (const row of down ? rows : [...rows].reverse()) {
      const key = new Map(row.map((i) => [i, mean((down ? above : below)[i], place[i])]));
      row.sort((a, b) => key.get(a) - key.get(b) || a - b);
      settle(row);
    }
  }
  return {rows: rows.filter((row) => row.length), ways};
}

/** A layer in as few rows as its width needs, of nearly the same width. */
function broken(layer, widths, room) {
  const wide = (row) => row.reduce((s, i) => s + widths[i] + GAP_X, -GAP_X);
  const each = wide(layer) / Math.ceil(wide(layer) / room), rows = [[]];
  for (const i of layer) {
    const last = rows.at(-1), more = wide([...last, i]);
    if (last.length && (more > room || more - widths[i] / 2 > each)) rows.push([i]);
    else last.push(i);
  }
  return rows;
}

/** The middle of the upper border of each node and bend, in a drawing `room` wide, how high that is, and the bends. */
export function layout(nodes, nodeWidths, room) {
  const places = [], {rows, ways} = layers(nodes), widths = [];
  for (const layer of rows) for (const i of layer) widths[i] = nodeWidths[i] ?? BEND;
  let y = 8;
  for (const layer of rows) {
    for (const row of broken(layer, widths, room)) {
      let x = (room - row.reduce((s, i) => s + widths[i] + GAP_X, -GAP_X)) / 2;
      for (const i of row) {
        places[i] = [x + widths[i] / 2, y];
        x += widths[i] + GAP_X;
      }
      y += HEIGHT + GAP_ROW;
    }
    y += GAP_LAYER - GAP_ROW;
  }
  return {places, ways, height: y - GAP_LAYER + 8};
}

export class Dag {
  constructor(holder, nodes, choose) {
    this.holder = holder;
    this.nodes = nodes;
    const inner = (this.inner = document.createElement('div'));
    inner.className = 'graph';
    this.lines = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    this.lines.setAttribute('aria-hidden', 'true');
    inner.append(this.lines);
    const pen = document.createElement('canvas').getContext('2d'), {fontFamily} = getComputedStyle(document.body);
    const wide = (words, font) => ((pen.font = `${font} ${fontFamily}`), pen.measureText(words).width);
    this.widths = [];
    this.buttons = nodes.map((node, i) => {
      const button = document.createElement('button');
      button.className = node.operands.length ? 'node' : 'node leaf';
      const name = document.createElement('b'), op = document.createElement('span');
      name.textContent = node.name;
      const often = node.instances > 1 ? ` × ${node.instances}` : '';
      op.textContent = node.operator + often;
      button.append(name, op);
      button.title = `${node.name}: ${node.operator}${often && `, ${node.instances} instances`}`;
      button.addEventListener('click', () => choose(i));
      inner.append(button);
      this.widths.push(Math.min(Math.max(wide(node.name, '600 12px'), wide(op.textContent, '11px'), LEAST - 16) + 18, MOST));
      return button;
    });
    holder.replaceChildren(inner);
    this.resized = new ResizeObserver(() => this.fit());
    this.resized.observe(holder);
    this.fit();
  }

  /** Nodes and lines at their places, for the width that there is now. */
  fit() {
    const room = Math.max(this.holder.clientWidth - 8, MOST);
    if (room !== this.room) this.draw(room);
    if (this.current !== undefined) this.reveal(this.buttons[this.current]);
  }

  draw(room) {
    this.room = room;
    const {nodes, widths, lines, inner} = this, {places, ways, height} = layout(nodes, widths, room);
    inner.style.width = `${room}px`;
    inner.style.height = `${height}px`;
    lines.setAttribute('width', room);
    lines.setAttribute('height', height);
    this.buttons.forEach((button, i) => Object.assign(button.style, {left: `${places[i][0] - widths[i] / 2}px`, top: `${places[i][1]}px`, width: `${widths[i]}px`}));
    this.paths = nodes.flatMap((node, i) => node.operands.map((o, k) => {
      const s = (k - (node.operands.length - 1) / 2) * Math.min(14, (widths[i] - 16) / node.operands.length);
      const path = document.createElementNS('http://www.w3.org/2000/svg', 'path'), stops = [o, ...ways[i][k], i].map((stop) => places[stop]);
      // Down through the bends: a curve from layer to layer, straight beside the nodes of a layer.
      path.setAttribute('d', stops.slice(1).reduce((d, [u, v], at) => {
        const [x, y] = stops[at], bend = (v - y - HEIGHT) * 0.6, end = u + (at + 2 === stops.length ? s : 0);
        return `${d} L ${x} ${y + HEIGHT} C ${x} ${y + HEIGHT + bend}, ${end} ${v - bend}, ${end} ${v}`;
      }, `M ${stops[0][0]} ${stops[0][1] + HEIGHT}`));
      path.dataset.ends = `${o} ${i}`;
      return path;
    }));
    lines.replaceChildren(...this.paths);
    this.markPaths();
  }

  leave() { this.resized.disconnect(); }

  mark(index, operands) {
    this.buttons.forEach((b, i) => {
      b.toggleAttribute('aria-current', i === index);
      if (i === index) b.setAttribute('aria-current', 'true');
      b.classList.toggle('operand', operands.includes(i));
    });
    this.current = index;
    this.markPaths();
    this.reveal(this.buttons[index]);
  }

  markPaths() { this.paths.forEach((p) => p.classList.toggle('used', p.dataset.ends.endsWith(` ${this.current}`))); }

  reveal(button) {
    const at = button.getBoundingClientRect(), box = this.holder.getBoundingClientRect();
    this.holder.scrollBy({left: (at.left + at.right - box.left - box.right) / 2, top: (at.top + at.bottom - box.top - box.bottom) / 2});
  }
}
