// The tree as a drawing: a layer for each distance from the leaves, operands above their users, nodes as buttons.

const WIDTH = 112, HEIGHT = 40, GAP_X = 12, GAP_Y = 30;

/** Places of the nodes: in layers, ordered so that few lines cross (by the mean place of neighbours, up and down). */
export function layout(nodes) {
  const layer = nodes.map(() => 0);
  nodes.forEach((node, i) => node.operands.forEach((o) => (layer[i] = Math.max(layer[i], layer[o] + 1))));
  const users = nodes.map(() => []);
  nodes.forEach((node, i) => node.operands.forEach((o) => users[o].push(i)));
  // A leaf stands just above its first user, not at the top of everything.
  nodes.forEach((node, i) => {
    if (!node.operands.length && users[i].length) layer[i] = Math.min(...users[i].map((u) => layer[u])) - 1;
  });
  const rows = [];
  layer.forEach((l, i) => (rows[l] ??= []).push(i));
  for (let l = 0; l < rows.length; ++l) rows[l] ??= [];
  const place = nodes.map(() => 0);
  const settle = () => rows.forEach((row) => row.forEach((i, k) => (place[i] = k - (row.length - 1) / 2)));
  settle();
  const mean = (list, own) => (list.length ? list.reduce((s, x) => s + place[x], 0) / list.length : own);
  for (let round = 0; round < 12; ++round) {
    const down = round % 2 === 0;
    for (const row of down ? rows : [...rows].reverse()) {
      const key = new Map(row.map((i) => [i, mean(down ? nodes[i].operands : users[i], place[i])]));
      row.sort((a, b) => key.get(a) - key.get(b) || a - b);
      row.forEach((i, k) => (place[i] = k - (row.length - 1) / 2));
    }
  }
  return {layer, place, layers: rows.length, most: Math.max(...rows.map((r) => r.length))};
}

export class Dag {
  constructor(holder, nodes, choose) {
    this.holder = holder;
    const {layer, place, layers, most} = layout(nodes);
    const width = most * (WIDTH + GAP_X) + GAP_X, height = layers * (HEIGHT + GAP_Y);
    const inner = document.createElement('div');
    inner.className = 'graph';
    inner.style.width = `${width}px`;
    inner.style.height = `${height}px`;
    const at = (i) => [width / 2 + place[i] * (WIDTH + GAP_X), layer[i] * (HEIGHT + GAP_Y) + 8];
    const lines = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    lines.setAttribute('width', width);
    lines.setAttribute('height', height);
    lines.setAttribute('aria-hidden', 'true');
    nodes.forEach((node, i) => node.operands.forEach((o, k) => {
      const [x, y] = at(o), [u, v] = at(i), s = (k - (node.operands.length - 1) / 2) * Math.min(14, (WIDTH - 24) / node.operands.length);
      const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
      path.setAttribute('d', `M ${x} ${y + HEIGHT} C ${x} ${y + HEIGHT + GAP_Y * 0.6}, ${u + s} ${v - GAP_Y * 0.6}, ${u + s} ${v}`);
      path.dataset.ends = `${o} ${i}`;
      lines.append(path);
    }));
    inner.append(lines);
    this.paths = [...lines.children];
    this.buttons = nodes.map((node, i) => {
      const button = document.createElement('button');
      button.className = node.operands.length ? 'node' : 'node leaf';
      const [x, y] = at(i);
      button.style.left = `${x - WIDTH / 2}px`;
      button.style.top = `${y}px`;
      const name = document.createElement('b'), op = document.createElement('span');
      name.textContent = node.name;
      const often = node.instances > 1 ? ` × ${node.instances}` : '';
      op.textContent = node.operator + often;
      button.append(name, op);
      button.title = `${node.name}: ${node.operator}${often && `, ${node.instances} instances`}`;
      button.addEventListener('click', () => choose(i));
      inner.append(button);
      return button;
    });
    holder.replaceChildren(inner);
    // Somewhat smaller if that shows all of it; never too small to read.
    this.fit = () => {
      inner.style.zoom = Math.min(Math.max((holder.clientWidth - 4) / width, 0.8), 1);
      if (this.current !== undefined) this.reveal(this.buttons[this.current]);
    };
    this.resized = new ResizeObserver(() => this.fit());
    this.resized.observe(holder);
    this.fit();
  }

  leave() { this.resized.disconnect(); }

  mark(index, operands) {
    this.buttons.forEach((b, i) => {
      b.toggleAttribute('aria-current', i === index);
      if (i === index) b.setAttribute('aria-current', 'true');
      b.classList.toggle('operand', operands.includes(i));
    });
    this.paths.forEach((p) => p.classList.toggle('used', p.dataset.ends.endsWith(` ${index}`)));
    this.current = index;
    this.reveal(this.buttons[index]);
  }

  reveal(button) {
    const at = button.getBoundingClientRect(), box = this.holder.getBoundingClientRect();
    this.holder.scrollBy({left: (at.left + at.right - box.left - box.right) / 2, top: (at.top + at.bottom - box.top - box.bottom) / 2});
  }
}
