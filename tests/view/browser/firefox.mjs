// Opens a page of `cnrg view` and slides of a lesson in headless Firefox, as Debian has it, and holds what they say
// against the program: the picture is drawn, cells are found, rows and stories told, keys work, axe-core finds no fault.
import {execFileSync} from 'node:child_process';
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';
import {check, folder, program} from './checks.mjs';
import {accessible, ask, finished, key, type, until, value} from './marionette.mjs';

await finished(async () => {
  const work = join(folder, 'firefox');
  mkdirSync(work, {recursive: true});
  const cnrg = (...words) => execFileSync(program, words, {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'], maxBuffer: 1 << 28});
  const tree = 'papers/lessons/05-tables/boxes.yaml', file = join(work, 'boxes.html');
  cnrg('view', tree, '-o', file, '--quiet');
  await ask('WebDriver:Navigate', {url: `file://${file}#node=a_first&row=union.edge.BinA.dominant`});
  await until("document.documentElement.dataset.ready", 'the page comes up');
  await sleep(500);
  check(await value('return window.cnrg.scene !== null'), `Firefox: there is WebGL: ${await value("let m = ''; const c = document.createElement('canvas'); c.addEventListener('webglcontextcreationerror', (e) => (m = e.statusMessage)); c.getContext('webgl2'); return m")}`);
  check(await value("return document.querySelector('#rows [aria-pressed=true]')?.dataset.row === 'union.edge.BinA.dominant'"), 'Firefox: a link restores a row');
  const seen = await value("return window.cnrg.scene ? window.cnrg.scene.labelPlaces().map((p) => p.cell.kind) : []");
  for (const kind of ['v', 'e', 'f']) check(seen.includes(kind), `Firefox: a ${kind} is drawn`);
  check(await value("const d = document.getElementById('dag'); return d.scrollWidth <= d.clientWidth"), 'Firefox: the tree fits');
  await key('/');
  await type('f3');
  const story = await value("return document.querySelector('.story')?.textContent");
  check(`${story}\n` === cnrg('explain', tree, '--node', 'a_first', '--cell', 'f3').replace(/\n+$/, '\n'), `Firefox: the story of f3: ${story}`);
  await accessible('a page');
  await key(']');
  check((await value("return document.getElementById('step').textContent")) === '4 of 5: b_first', 'Firefox: keys step through the tree');
  const {value: picture} = await ask('WebDriver:TakeScreenshot', {full: false});
  writeFileSync(join(work, 'boxes.png'), Buffer.from(picture, 'base64'));

  execFileSync('papers/lessons/make', ['5', '--out', work], {env: {...process.env, PATH: `${join(program, '..')}:${process.env.PATH}`}, stdio: 'ignore'});
  await ask('WebDriver:Navigate', {url: `file://${join(work, '05-tables', 'slides.html')}`});
  await until("document.getElementById('place')?.textContent.startsWith('1 /')", 'slides come up');
  await key('\uE014');
  check((await value("return document.getElementById('place').textContent")).startsWith('2 /'), 'Firefox: an arrow turns slides');
  await accessible('slides');
});
