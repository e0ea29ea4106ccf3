// Makes playground.html: page, scripts, the program, the page of `cnrg view` and the models in one file.
//
//   node build.mjs MODULES OUTPUT PROGRAM VIEW     MODULES: the folder node_modules that npm filled; PROGRAM: the folder of
//                                                  cnrg.mjs and cnrg.wasm; VIEW: the template view.html
import {execFileSync} from 'node:child_process';
import {existsSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {basename, dirname, join, resolve} from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {bundler, filled, policyOf} from '../../../../csg/view/web/bundling.mjs';
import {lettersOf} from './letters.js';
import {run} from './program.mjs';

const [modules, output, program, view] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url)), papers = join(here, '../../..');
const READ = /[\w./-]+\.(?:off|obj|stl|ply|vtk|json|csv|asc|xyz|txt|step|stp|brep|vtp|csg)\b/g;

/** The schema, as the program itself prints it. */
async function schemaOf() {
  const {default: create} = await import(pathToFileURL(join(program, 'cnrg.mjs')));
  const compiled = new WebAssembly.Module(readFileSync(join(program, 'cnrg.wasm')));
  const {stdout} = await run(create, compiled, ['schema']);
  return JSON.parse(new TextDecoder().decode(stdout));
}

/** A tree with the files that it reads beside it; null where one of them is made by another tree. */
function modelOf(folder, file, group) {
  const text = readFileSync(join(folder, file), 'utf8'), files = {};
  for (const path of text.replace(/#.*$/gm, '').match(READ) ?? []) {
    if (path.startsWith('..') || !existsSync(join(folder, path))) return null;
    files[path] = readFileSync(join(folder, path), 'utf8');
  }
  return {group, name: basename(file, '.yaml'), text, files};
}

function models() {
  const lessons = [], exercises = [], others = [];
  const treesIn = (folder) => readdirSync(folder).filter((f) => f.endsWith('.yaml')).sort();
  for (const name of readdirSync(join(papers, 'lessons')).filter((n) => /^\d\d-/.test(n)).sort()) {
    const folder = join(papers, 'lessons', name), answer = readFileSync(join(folder, 'answer.yaml'), 'utf8');
    for (const file of treesIn(folder).filter((f) => f !== 'answer.yaml')) {
      const of = file === 'exercise.yaml' ? exercises : lessons, model = modelOf(folder, file, of === exercises ? 'Exercises' : 'Lessons');
      if (model) of.push({...model, name: of === exercises ? name : `${name}: ${model.name}`, ...(of === exercises && {answer})});
    }
  }
  for (const paper of readdirSync(papers).filter((n) => /\d{4}$/.test(n)).sort()) {
    for (const file of treesIn(join(papers, paper))) others.push(modelOf(join(papers, paper), file, `Papers: ${paper}`));
  }
  return [...lessons, ...exercises, ...others.filter(Boolean)];
}

/** What boot.js unpacks: texts by name, and the program, in which zeros may be. */
function packed(texts, program) {
  const content = Buffer.concat([Buffer.from(JSON.stringify(texts)), Buffer.of(0), program]);
  const bytes = execFileSync('xz', ['--format=lzma', '--lzma1=preset=9e,dict=64MiB,lc=4,lp=0,pb=0,nice=273', '--stdout'], {input: content, maxBuffer: 2 ** 30});
  bytes.writeBigUInt64LE(BigInt(content.length), 5);  // `xz` leaves the size open
  return bytes;
}
const places = {'<!--cnrg:title-->': '', '<!--cnrg:stamp-->': '', '<!--cnrg:data-->': ''};
const bundled = (file, more) => bundler(modules, more)(join(here, file));
const boot = await bundled('boot.js'), page = await bundled('playground.js');
const worker = await bundled('worker.js', {alias: {'cnrg-module': join(program, 'cnrg.mjs'), module: join(here, 'no_node.js')}, define: {'import.meta.url': '""'}});
const texts = {script: page.script, worker: worker.script, view: filled(readFileSync(view, 'utf8'), places), schema: await schemaOf(), trees: models()};
const text = filled(readFileSync(join(here, 'page.html'), 'utf8'), {
  '<!--bundle:policy-->': policyOf("worker-src blob:; frame-src 'self'").replace("script-src 'unsafe-inline'", "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:"),
  '<!--bundle:style-->': `<style>${page.style}</style>`,
  '<!--bundle:data-->': `<script type="text/plain" id="packed">${lettersOf(packed(texts, readFileSync(join(program, 'cnrg.wasm'))))}</script>`,
  '<!--bundle:script-->': `<script>${boot.script}</script>`,
});
writeFileSync(output, `\ufeff${text}`, 'utf16le');  // with the mark by which browsers know it
