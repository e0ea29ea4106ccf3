// The rows of the tables at a node against `cnrg eval --trace` and `cnrg explain`; what is moved, hidden, cut and measured.
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

export async function testRows({cnrg, check, equal, open, close, click, work}) {
  const tree = 'papers/lessons/05-tables/boxes.yaml', file = join(work, 'boxes.html');
  cnrg('view', tree, '-o', file, '--quiet');
  const page = await open(file, {hash: '#node=equal&color=class&apart=0.4&ghosts=1&through=1'});

  // Each row once, with what the command counts as removed.
  for (const [node, standing] of [['a_first', 'dominant'], ['equal', 'equal']]) {
    await page.locator('.node', {has: page.getByText(node, {exact: true})}).click();
    const rows = await page.locator('#rows tr:has([data-row])').evaluateAll((all) => all.map((r) => [r.querySelector('button').dataset.row, ...[...r.querySelectorAll('td')].map((d) => d.textContent)]));
    equal(rows.length, 15, `${node}: rows`);
    const trace = cnrg('eval', tree, '--node', node, '--trace').split(`\n${node} `)[1];
    for (const [id, , kept, removed] of rows) {
      check(id.startsWith('union.') && id.endsWith(standing), `${node}: ${id} is one of its rows`);
      equal(removed, new RegExp(`^    ${id}: (\\d+)$`, 'm').exec(trace.split(/^\S/m)[0])?.[1] ?? '0', `${node}: removed by ${id}`);
      check(/^\d+$/.test(kept), `${node}: kept by ${id}: ${kept}`);
    }
    const [faces, edges, vertices] = ['face', 'edge', 'vertex'].map((kind) => rows.filter(([id]) => id.includes(`.${kind}.`)).reduce((sum, [, , kept, removed]) => sum + +kept + +removed, 0));
    equal([vertices, edges, faces].join(), '20,32,17', `${node}: all entities of both boxes, cut by each other`);
  }

  // A row shows its cells, a cell its row.
  const over = () => page.evaluate(() => window.cnrg.scene.over.children.length);
  await page.click('[data-row="union.face.BinA.equal"]');
  check((await over()) > 0 && (await page.getAttribute('[data-row="union.face.BinA.equal"]', 'aria-pressed')) === 'true', 'a chosen row marks its cells');
  equal(await page.evaluate(() => window.cnrg.model.ofRow('union.face.BinA.equal').length), 5, 'cells of a row');
  await page.click('[data-row="union.face.BinA.equal"]');
  equal(await over(), 0, 'a row chosen again marks nothing');
  await page.fill('#search', 'e1');
  await page.keyboard.press('Enter');
  const row = await page.locator('#cell .rowname').textContent();
  check(cnrg('explain', tree, '--node', 'equal', '--cell', 'e1').includes(row), `e1: its row is ${row}`);
  equal(await page.locator('.decided [data-row]').getAttribute('data-row'), row, 'the row of a cell stands out');

  // By classes, too, regions are pulled apart, and what is picked is where it is seen.
  await page.locator('.node', {has: page.getByText('a_first', {exact: true})}).click();
  await page.waitForTimeout(400);
  const moved = () => page.evaluate(() => [...window.cnrg.scene.geometry.sheets.corners.done('shift')].some((x) => x !== 0));
  check(await moved(), 'classes: faces move with their regions');
  await page.check('[name=pick][value=f]');
  check((await click(page, 'F')) !== null, 'classes: a face is picked');
  const places = await page.evaluate(() => {
    const {scene, state} = window.cnrg, number = scene.geometry.numbering.bytes('F', state.cell.i).join(), {ident, shift} = scene.geometry.sheets.corners;
    const drawn = new Set();
    for (let k = 0; k < scene.geometry.sheets.corners.length; ++k) if (ident.subarray(4 * k, 4 * k + 4).join() === number) drawn.add(shift.subarray(3 * k, 3 * k + 3).join());
    const marked = scene.over.children[0].geometry.attributes.shift.array, found = new Set();
    for (let k = 0; k < marked.length; k += 3) found.add(marked.subarray(k, k + 3).join());
    return [[...drawn].sort().join(' '), [...found].sort().join(' ')];
  });
  equal(places[0], places[1], 'classes: the mark lies on the face');
  await page.keyboard.press('Escape');

  // A region is hidden by its entry in the legend.
  await page.selectOption('#color', 'region');
  const skins = () => page.evaluate(() => window.cnrg.scene.geometry.skins.triangles.length);
  const all = await skins();
  await page.locator('#legend button').first().click();
  const fewer = await skins();
  check(fewer < all && fewer > 0, `legend: ${fewer} of ${all} triangles are left`);
  equal(await page.locator('#legend button').first().getAttribute('aria-pressed'), 'false', 'legend: pressed');
  check(await page.evaluate(() => document.activeElement.closest('#legend') !== null), 'legend: the focus stays');
  await page.waitForTimeout(400);
  check((await page.evaluate(() => location.hash)).includes('off='), 'legend: the address knows');
  await page.locator('#legend button').first().click();
  equal(await skins(), all, 'legend: shown again');

  // A section at a coordinate, along a face, across the view.
  await page.selectOption('#axis', 'x');
  await page.fill('#place', '2.5');
  await page.keyboard.press('Tab');
  const cut = () => page.evaluate(() => {
    const {position} = window.cnrg.scene.cut.filled.corners, {radius, centre} = window.cnrg.scene;
    return [...new Set([...position.subarray(0, 3 * window.cnrg.scene.cut.filled.corners.length)].filter((_, i) => i % 3 === 0).map((x) => +(x * radius + centre[0]).toFixed(4)))].join();
  });
  await page.locator('#explode').fill('0');
  equal(await cut(), '2.5', 'section: at a coordinate');
  check(await page.locator('#axis option[value=face]').evaluate((o) => o.disabled), 'section: without a face none along it');
  await page.selectOption('#axis', 'view');
  check((await page.evaluate(() => window.cnrg.scene.cut.filled.triangles.length)) > 0, 'section: across the view');
  await page.selectOption('#axis', '');

  // Measures of an edge and a face are those of their exact places.
  const exact = join(work, 'boxes.json');
  cnrg('eval', tree, '--quiet', '--node', 'a_first', '-o', exact);
  const result = JSON.parse(readFileSync(exact, 'utf8')), at = (p) => result.points[p].map((word) => word.split('/').reduce((a, b) => a / b));
  for (const e of [0, 7, 15]) {
    await page.fill('#search', `e${e}`);
    await page.keyboard.press('Enter');
    const [a, b] = [result.edges[e].points[0], result.edges[e].points.at(-1)].map(at);
    equal(await page.locator('#length').textContent(), `≈ ${Math.hypot(...a.map((x, k) => x - b[k]))}`, `e${e}: length`);
    const angles = [...(await page.locator('#wedges').textContent()).matchAll(/([\d.]+)°/g)].map((m) => +m[1]);
    equal(angles.reduce((x, y) => x + y, 0), 360, `e${e}: angles ${angles}`);
    check(angles.every((x) => x % 90 === 0), `e${e}: right angles ${angles}`);
  }
  await close(page);

  // What hides something opens see-through, but not where it is cut; a choice in the address stays.
  const slope = join(work, 'slope.yaml'), seen = join(work, 'slope.html');
  writeFileSync(slope, /^cnrg: 1$[\s\S]*?(?=^```)/m.exec(readFileSync('README.md', 'utf8'))[0]);
  cnrg('view', slope, '-o', seen, '--quiet');
  for (const [hash, wanted] of [['', true], ['#through=0', false], ['#axis=y', false], ['#node=ground', false]]) {
    const other = await open(seen, {hash});
    equal(await other.isChecked('#through'), wanted, `${hash || 'the example'}: see through`);
    check(!hash || (await other.evaluate(() => window.cnrg.scene.look.through)) === wanted, `${hash}: drawn so`);
    if (!hash) {
      const volume = await other.locator('#node dd').first().textContent();
      check(/^588722\.536992 \d/.test(volume), `volumes are decimal first: ${volume.slice(0, 40)}`);
    }
    await close(other);
  }
}
