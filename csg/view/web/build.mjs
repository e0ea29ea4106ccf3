// Bundles the page: HTML, styles and scripts in one file, with places for title, stamp and data.
//
//   node build.mjs MODULES OUTPUT     MODULES: the folder node_modules that npm filled
import {readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {bundler, filled, policyOf} from './bundling.mjs';

const [modules, output] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const bundle = bundler(modules);
const main = await bundle(join(here, 'start.js')), watch = await bundle(join(here, 'watch.js'));
writeFileSync(output, filled(readFileSync(join(here, 'page.html'), 'utf8'), {
  '<!--bundle:policy-->': policyOf('frame-src file:'),  // a watched page may show itself in a frame
  '<!--bundle:watch-->': `<script>${watch.script}</script>`,
  '<!--bundle:style-->': `<style>${main.style}</style>`,
  '<!--bundle:script-->': `<script>${main.script}</script>`,
}));
