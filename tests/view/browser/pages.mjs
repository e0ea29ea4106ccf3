// Opens pages as people do, from files, clicks at cells, and holds what the page says against `cnrg explain`, `cnrg
// eval --topology` and the exact .json. Nothing is asked of the page's own code but where on the screen a cell is.
import {execFileSync, spawn} from 'node:child_process';
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';
import {accessible, check, finish, folder, program, watched} from './checks.mjs';
import {testPictures} from './pictures.mjs';
import {testRows} from './rows.mjs';
import {testScale} from './scale.mjs';

const work = join(folder, 'pages');
mkdirSync(work, {recursive: true});

const equal = (a, b, what) => check(a === b, `${what}: page\n${a}\nprogram\n${b}`);
const cnrg = (...words) => execFileSync(program, words, {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'], maxBuffer: 1 << 28});

async function open(file, options = {}) {
  const {hash = '', scheme = 'light', width = 1120, height = 600} = options;
  const page = await watched(file, {viewport: {width, height}, colorScheme: scheme});
  await page.goto(`file://${file}${hash}`);
  await page.waitForSelector('html[data-ready]');
  await page.waitForTimeout(350);
  return page;
}
const close = (page) => page.context().close();

/** Clicks at the first seen cell of a kind of which `keep` holds; its name, or null where none is seen. */
async function click(page, kind, modifiers = []) {
  const places = await page.evaluate((k) => window.cnrg.scene.labelPlaces().filter((p) => p.cell.kind === k && p.size > (k === 'f' ? 60 : 3)), kind === 'r' ? 'f' : kind);
  const box = await page.locator('#scene').boundingBox();
  for (const {cell, x, y} of places.sort((a, b) => b.size - a.size)) {
    const over = await page.evaluate(([u, v]) => document.elementFromPoint(u, v)?.id, [box.x + x, box.y + y]);
    if (over !== 'scene') continue;
    for (const m of modifiers) await page.keyboard.down(m);
    await page.mouse.click(box.x + x, box.y + y);
    for (const m of modifiers) await page.keyboard.up(m);
    return kind + cell.i;
  }
  return null;
}

/** What the panel of the picked cell says, against the program. */
async function compare(page, tree, node, result, expected) {
  const name = await page.locator('#picked').textContent();
  if (expected) equal(name, expected, `${tree} ${node}: the cell under the pointer`);
  equal((await page.locator('.story').textContent()) + '\n', cnrg('explain', tree, '--node', node, '--cell', name).replace(/\n+$/, '\n'), `${tree} ${node} ${name}: story`);
  check(await page.locator('.story').evaluate((s) => s.scrollWidth <= s.clientWidth && s.scrollHeight <= s.clientHeight), `${tree} ${node} ${name}: the story wraps`);
  const i = Number(name.slice(1)), text = await page.locator('#cell').innerText();
  if (name[0] === 'v') {
    const shown = await page.locator('#cell > dl.point dd').evaluateAll((all) => all.map((d) => d.firstChild.textContent));
    const exact = result.points[result.vertices[i].point];
    shown.forEach((word, k) => word.includes('…') || equal(word, exact[k], `${tree} ${node} ${name}: coordinate`));
  }
  if (name[0] === 'f') {
    for (const [side, r] of [['in front', result.faces[i].regions[0]], ['behind', result.faces[i].regions[1]]]) {
      if (r !== null) check(text.replace(/\s+/g, ' ').includes(`${side} r${r}`), `${tree} ${node} ${name}: ${side} of it is r${r}`);
    }
  }
  if (name[0] === 'r') {
    const {volume} = result.regions[i];
    if (volume && volume.length < 30) check(text.includes(volume), `${tree} ${node} ${name}: volume ${volume}`);
    const faces = await page.locator('#cell .cellname').allTextContents();
    for (const f of new Set(result.regions[i].shells.flat().map((s) => `f${s.face}`))) if (faces.length < 60) check(faces.includes(f), `${tree} ${node} ${name}: ${f} is in its shell`);
  }
  return name;
}

let removed = 0;
const MODELS = [['pereira2012/fig10', 'model'], ['weiler1986/edge', 'around'], ['rossignac1991/operators', 'rock'], ['pereira2012/fig07', 'difference'], ['pereira2012/fig04', 'union_G1']];

for (const [k, [path, wanted]] of MODELS.entries()) {
  const tree = `papers/${path}.yaml`, file = join(work, `${path.replace('/', '-')}.html`);
  // Only these nodes, for the stories count cells of the refinement, as those of `cnrg explain --node` do.
  cnrg('view', tree, '--node', wanted, '-o', file, '--quiet');
  const bytes = readFileSync(file).length;
  check(bytes < 3e6, `${file} has ${bytes} bytes`);
  const page = await open(file, {scheme: k % 2 ? 'dark' : 'light'});
  await accessible(page, tree);

  check(await page.evaluate(() => ['dag', 'node'].every((id) => document.getElementById(id).scrollWidth <= document.getElementById(id).clientWidth)), `${tree}: tree and panel fit`);

  // Through the evaluation, forward and back.
  const nodes = await page.locator('.node b').allTextContents();
  for (let i = 0; i < nodes.length; ++i) await page.locator('#back').evaluate((b) => b.click());
  check(await page.locator('#back').isDisabled(), `${tree}: the first node is reached`);
  await page.locator('body').press('Escape');
  for (let i = 0; i < nodes.length; ++i) {
    const said = await page.locator('#step').textContent();
    equal(said, `${i + 1} of ${nodes.length}: ${nodes[i]}`, `${tree}: step`);
    if (i + 1 < nodes.length) await page.keyboard.press(']');
  }

  const node = wanted;
  await page.locator('.node', {has: page.getByText(node, {exact: true})}).first().click();
  const exact = join(work, 'exact.json');
  cnrg('eval', tree, '--quiet', '--node', node, '-o', exact);
  const result = JSON.parse(readFileSync(exact, 'utf8'));
  await page.waitForTimeout(150);
  const counts = (await page.locator('#counts tbody tr').first().locator('td').allTextContents()).map(Number);
  const active = (list) => list.filter((c) => c.component !== 0).length;
  equal(counts.join(), [result.vertices, result.edges, result.faces, result.regions].map(active).join(), `${tree} ${node}: counts`);
  const topology = cnrg('eval', tree, '--topology', '--node', node);
  if (await page.locator('#euler').count()) {
    const formula = (await page.locator('#euler').textContent()).replaceAll('−', '-');
    check(topology.includes(`  ${formula}   (`), `${tree} ${node}: Euler-Poincaré ${formula}`);
    const betti = (await page.locator('#betti tbody tr').first().locator('td').allTextContents()).join(' +');
    check(new RegExp(`point set +${betti} `).test(topology), `${tree} ${node}: Betti numbers ${betti}`);
  }
  for (const kind of ['f', 'e', 'v', 'r']) {
    // A face that is a few pixels wide is hard to hit beside its edges: so only faces are picked.
    await page.check(`[name=pick][value=${kind === 'f' ? 'f' : 'any'}]`);
    const expected = await click(page, kind, kind === 'r' ? ['Shift'] : []);
    check(expected !== null, `${tree} ${node}: a ${kind} is seen`);
    await compare(page, tree, node, result, kind === 'r' ? null : expected);
  }
  check((await page.evaluate(() => window.cnrg.pickTime)) < 300, `${tree}: a pick takes ${await page.evaluate(() => window.cnrg.pickTime)} ms`);
  if (k === 0) await accessible(page, `${tree} with a cell`);

  // The radial order of the page is that of --topology.
  for (const [, e, order] of [...topology.matchAll(/^ {2}(e\d+): (f.*)$/gm)].slice(0, 2)) {
    await page.fill('#search', e);
    await page.keyboard.press('Enter');
    const drawn = await page.locator('.diagram').getAttribute('aria-label');
    const faces = (text) => [...text.matchAll(/\bf\d+/g)].map((m) => m[0]).join();
    equal(faces(drawn), faces(order), `${tree} ${node} ${e}: radial order`);
  }

  // What the node has removed says why.
  await page.check('#ghosts');
  await page.uncheck('#show3');
  await page.check('[name=pick][value=f]');
  if (await click(page, 'F')) {
    const line = await page.locator('#cell .command code').textContent(), point = /--point (\S+)/.exec(line)?.[1];
    equal((await page.locator('.story').textContent()) + '\n', cnrg('explain', tree, '--node', node, '--point', point), `${tree} ${node}: story of what went at ${point}`);
    ++removed;
  }
  await page.check('#show3');
  await page.check('[name=pick][value=any]');

  // A leaf is found by its name, in a cell that came from it.
  const leaf = await page.evaluate(() => window.cnrg.page.leaves.find((name) => window.cnrg.model.fromLeaf(name)));
  await page.fill('#search', leaf);
  const entry = page.locator('#found li', {has: page.locator('small', {hasText: /^leaf$/})}).first(), found = (await entry.locator('span').textContent()).split(' ')[0];
  await entry.click();
  equal(await page.locator('#picked').textContent(), found, `${tree}: a cell of the leaf ${leaf}`);
  check((await page.locator('#cell').innerText()).includes(`${leaf}: `), `${tree}: ${found} came from ${leaf}`);

  // A link restores the view.
  await page.selectOption('#color', 'class');
  await page.check('#ghosts');
  await page.check('#labels');
  await page.locator('#explode').fill('0.4');
  await page.waitForTimeout(450);
  const hash = await page.evaluate(() => location.hash);
  const again = await open(file, {hash, scheme: k % 2 ? 'dark' : 'light'});
  equal(await again.evaluate(() => location.hash || window.location.hash), hash, `${tree}: the address`);
  check(await again.isChecked('#ghosts') && (await again.inputValue('#color')) === 'class', `${tree}: the view comes back`);
  equal(await again.locator('#picked').textContent(), await page.locator('#picked').textContent(), `${tree}: the picked cell comes back`);
  await close(again);
  await close(page);
}

check(removed >= 3, `of ${removed} models removed cells were picked`);

// On a telephone, and by keyboard alone.
{
  const file = join(work, 'pereira2012-fig10.html');
  const page = await open(file, {width: 390, height: 844, scheme: 'dark'});
  for (const panel of ['show', 'node', 'cell', 'tree']) {
    await page.click(`.tabs [data-panel=${panel}]`);
    check(await page.locator(`#p-${panel}`).isVisible(), `telephone: the panel ${panel} is seen`);
  }
  check(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'telephone: nothing is wider than the screen');
  await accessible(page, 'telephone');
  await close(page);
  const wide = await open(file);
  const reached = new Set();
  for (let i = 0; i < 90; ++i) {
    await wide.keyboard.press('Tab');
    reached.add(await wide.evaluate(() => document.activeElement.id || document.activeElement.className));
  }
  for (const id of ['search', 'link', 'png', 'print', 'theme', 'help', 'back', 'dag', 'color', 'labels', 'explode', 'axis', 'scene', 'fit']) check(reached.has(id), `keyboard: Tab reaches ${id}`);
  await wide.focus('#scene');
  const before = await wide.evaluate(() => window.cnrg.scene.view.join());
  await wide.keyboard.press('ArrowLeft');
  check(before !== (await wide.evaluate(() => window.cnrg.scene.view.join())), 'keyboard: arrows turn');
  const [download] = await Promise.all([wide.waitForEvent('download'), wide.click('#png')]);
  check(readFileSync(await download.path()).subarray(1, 4).toString() === 'PNG', 'PNG: a picture');
  await close(wide);
}

await testRows({cnrg, check, equal, open, close, click, work});
await testPictures({cnrg, check, open, close, work});
await testScale({cnrg, check, open, close, work});

// No text of a file becomes HTML.
{
  const tree = join(work, `hostile.yaml`), file = join(work, 'hostile.html');
  const evil = '</script><b id=evil>', image = '<img src=x onerror=document.title=1>';
  writeFileSync(tree, JSON.stringify({cnrg: 1, materials: {[image]: {color: '#336699'}},
    nodes: {[evil]: {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: image, name: '<!--<script>'}, two: {box: {min: [0, 0, 0], max: [1, 1, 2]}}, both: {union: [evil, 'two']}}, result: 'both'}));
  cnrg('view', tree, '-o', file, '--quiet');
  check(!readFileSync(file, 'utf8').includes(evil), 'hostile: the name is not in the page as it is');
  const page = await open(file);
  equal(await page.title(), 'hostile.yaml', 'hostile: title');
  check((await page.locator('#evil, img[src=x]').count()) === 0, 'hostile: no element came from a name');
  check((await page.locator('.node b').allTextContents()).includes(evil), 'hostile: the name is shown as it is');
  let shown = '';
  for (const r of ['r0', 'r1', 'r2']) {
    await page.fill('#search', r);
    await page.keyboard.press('Enter');
    shown += await page.locator('#cell').innerText();
  }
  check(shown.includes(image) && shown.includes('<!--<script>'), 'hostile: material and name are shown as they are');
  await close(page);
}

// Uncertain places are marked, told, and switched off.
{
  const tree = join(work, 'near.yaml'), file = join(work, 'near.html');
  writeFileSync(tree, `cnrg: 1
nodes:
  a: {cylinder: {from: [1, 0, -3], to: [1, 0, 3], radius: 1}}
  b: {sphere: {center: [0, 0, 0], radius: 2}}
  both: {union: [a, b]}
result: both
`);
  cnrg('view', tree, '-o', file, '--quiet');
  const page = await open(file);
  await accessible(page, 'Viviani');
  const told = await page.locator('#doubtlist li').allTextContents();
  check(told.length > 0 && told[0].startsWith('`a` (cylinder side) and `b` (sphere) near ['), `Viviani: told in the panel: ${told[0]}`);
  const legend = page.locator('#legend', {hasText: 'uncertain'});
  equal(await legend.count(), 1, 'Viviani: the legend has the mark');
  const box = await page.locator('#scene').boundingBox();
  const [x, y] = await page.evaluate(() => window.cnrg.scene.project(window.cnrg.scene.place(window.cnrg.page.doubts[0].at)));
  await page.mouse.click(box.x + x, box.y + y);
  check((await page.locator('#note').textContent()).endsWith(told[0]), 'Viviani: a click at the mark tells of it');
  await page.uncheck('#doubts');
  equal(await legend.count(), 0, 'Viviani: the mark is switched off');
  await close(page);
  const plain = await open(join(work, 'hostile.html'));
  check(await plain.locator('#doubtful').isHidden(), 'without uncertain places there is no switch');
  await close(plain);
}

// A watched page follows its file.
{
  const tree = join(work, 'watched.yaml'), file = join(work, 'watched.html');
  const write = (size) => writeFileSync(tree, `cnrg: 1\nnodes: {cube${size}: {box: {min: [0, 0, 0], max: [1, 1, ${size}]}}}\nresult: cube${size}\n`);
  write(1);
  const child = spawn(program, ['view', tree, '-o', file, '--watch', '--quiet'], {stdio: 'ignore'});
  for (let i = 0; i < 50 && !(await import('node:fs')).existsSync(file); ++i) await sleep(100);
  await sleep(300);
  const page = await open(file);
  equal(await page.locator('.node b').textContent(), 'cube1', 'watch: before');
  await sleep(1100);
  write(2);
  await page.locator('.node b', {hasText: 'cube2'}).waitFor().catch(() => {});
  equal(await page.locator('.node b').textContent(), 'cube2', 'watch: after');
  child.kill();
  await close(page);
}

await finish();
