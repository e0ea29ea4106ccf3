// Bundles the page: HTML, styles and scripts in one file, with places for title, stamp and data.
//
//   node build.mjs MODULES OUTPUT     MODULES: the folder node_modules that npm filled
import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const [modules, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const {build} = createRequire(join(modules, 'x.js'))('esbuild');

async function bundle(entry) {
  const {outputFiles} = await build({
    entryPoints: [join(here, entry)], bundle: true, minify: true, write: false, outdir: '/', format: 'iife', target: 'es2022', charset: 'utf8',
    nodePaths: [modules], legalComments: 'inline', logLevel: 'warning',
  });
  const of = (extension) => outputFiles.find((f) => f.path.endsWith(extension))?.text.trim() ?? '';
  return {script: of('.js').replaceAll('</script', '<\\/script'), style: of('.css').replaceAll('</style', '<\\/style')};
}

const main = await bundle('start.js'), watch = await bundle('watch.js');
// Nothing is loaded from anywhere; a watched page may show itself in a frame.
const policy = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; frame-src file:; base-uri 'none'; form-action 'none'";
const parts = {
  '<!--bundle:policy-->': `<meta http-equiv="Content-Security-Policy" content="${policy}">`,
  '<!--bundle:watch-->': `<script>${watch.script}</script>`,
  '<!--bundle:style-->': `<style>${main.style}</style>`,
  '<!--bundle:script-->': `<script>${main.script}</script>`,
};
let text = readFileSync(join(here, 'page.html'), 'utf8');
for (const [place, part] of Object.entries(parts)) {
  if (!text.includes(place)) throw new Error(`page.html has no place ${place}`);
  text = text.split(place).join(part);
}
writeFileSync(output, text);
