// Many cells: what is drawn and looked at, as shares of everything that there is. Times depend on the machine, shares
// do not. A block of 14 x 14 x 14 cubes has 24,389 cells and 32,928 triangles of skins.
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';

const N = 14, ALL = N ** 3 * 12;

function cubes() {
  const nodes = {block: {box: {min: [0, 0, 0], max: [N, N, N]}}}, walls = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (let k = 1; k < N; ++k) {
      const corner = (u, v) => [...[u, v].slice(0, axis), k, ...[u, v].slice(axis)];
      nodes[`w${axis}_${k}`] = {polygon: [corner(0, 0), corner(N, 0), corner(N, N), corner(0, N)]};
      walls.push(`w${axis}_${k}`);
    }
  }
  nodes.walls = {union: walls};
  nodes.cubes = {union: ['walls', 'block'], dominance: 'left'};
  return JSON.stringify({cnrg: 1, nodes, result: 'cubes'});
}

export async function testScale({cnrg, check, open, close, work}) {
  const tree = join(work, 'cubes.yaml'), file = join(work, 'cubes.html');
  writeFileSync(tree, cubes());
  cnrg('view', tree, '-o', file, '--quiet');
  const still = (page) => page.waitForFunction(() => !window.cnrg.scene.heavy || window.cnrg.scene.still.done, null, {timeout: 60000});
  /** Triangles of skins that are there, that are drawn at rest, that are drawn while the camera moves; of the cut. */
  const measure = (page) => page.evaluate(() => {
    const {scene} = window.cnrg, {geometry} = scene;
    const drawn = (most) => (scene.choose(true, most), scene.facing.reduce((n, k) => n + k.count, 0));
    const a = scene.cut ? scene.cut.filled : null, area = [];
    for (let t = 0; a && t < a.triangles.length; ++t) {
      const [p, q, r] = [0, 1, 2].map((k) => a.corners.position.subarray(3 * a.triangles.corner[3 * t + k], 3 * a.triangles.corner[3 * t + k] + 3));
      const u = [0, 1, 2].map((k) => q[k] - p[k]), v = [0, 1, 2].map((k) => r[k] - p[k]);
      area.push(Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2);
    }
    return {there: geometry.skins.triangles.length, moving: drawn(3000), rest: drawn(Infinity), cut: a?.triangles.length ?? 0, area: area.reduce((x, y) => x + y, 0) * scene.radius ** 2,
      rows: geometry.triangles + geometry.plain.length + geometry.edges.length + geometry.points.length};
  });
  const pick = (page) => page.evaluate(() => {
    const {scene} = window.cnrg, cell = scene.at(scene.width / 2 + 3, scene.height / 2 + 2, 'any');
    return {cell, looked: scene.looked};
  });

  const closed = await open(file);
  const whole = await measure(closed);
  check(whole.there === 12 * N * N, `closed: only the outside is there: ${whole.there}`);
  check(whole.rest <= whole.there / 2, `closed: half of it is turned away: ${whole.rest}`);
  await close(closed);

  const cut = await open(file, {hash: '#axis=y&cut=0.5&view=0,-4.5,0,0,0,0'});
  const section = await measure(cut);
  check(section.there + section.cut < 0.2 * ALL, `cut: ${section.there} and ${section.cut} triangles of ${ALL}`);
  check(Math.abs(section.area / N ** 2 - 1) < 0.02, `cut: all of the section is filled: ${section.area}`);
  const region = await cut.evaluate(() => {
    const {scene, model} = window.cnrg, cell = scene.at(scene.width / 2 + 3, scene.height / 2 + 2, 'r');
    const faces = new Set(model.cells.regions.shells(cell.i).flatMap((s) => Array.from(s, (side) => side >> 1)));
    return [...new Set([...faces].flatMap((f) => Array.from(model.cells.faces.corners(f), (p) => model.at(p)[1])))].sort((a, b) => a - b).join();
  });
  check(region === `${N / 2},${N / 2 + 1}`, `cut through walls: what is kept behind the plane is picked: y ${region}`);
  await close(cut);

  const oblique = await open(file, {hash: '#axis=view&normal=1,1,0&cut=0.5'});
  const across = await measure(oblique);
  check(Math.abs(across.area / (N ** 2 * Math.SQRT2) - 1) < 0.02, `cut along a diagonal: all of it is filled: ${across.area}`);
  await close(oblique);

  const apart = await open(file, {hash: '#apart=0.5'});
  await still(apart);
  const pieces = await measure(apart);
  check(pieces.there === ALL, `apart: all is there: ${pieces.there}`);
  check(pieces.rest <= 0.51 * ALL, `apart: half is turned away: ${pieces.rest}`);
  check(pieces.moving <= 0.25 * ALL, `apart: while the camera moves, only regions near the outside: ${pieces.moving}`);
  const {cell, looked} = await pick(apart);
  check(cell !== null && looked < 0.1 * pieces.rows, `apart: a pick looks at ${looked} of ${pieces.rows}`);
  // What is picked is drawn over the picture that is there.
  const box = await apart.locator('#scene').boundingBox();
  await apart.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await apart.waitForSelector('#picked');
  check(await apart.evaluate(() => window.cnrg.scene.still.done), 'apart: a pick keeps the picture');
  check((await apart.evaluate(() => window.cnrg.pickTime)) < 300, 'apart: a pick is answered at once');
  await apart.evaluate(() => window.cnrg.scene.turn(0.3, 0));
  check(!(await apart.evaluate(() => window.cnrg.scene.still.done)), 'apart: turning makes another');
  await still(apart);
  await close(apart);
}
