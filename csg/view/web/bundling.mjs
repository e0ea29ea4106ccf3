// Scripts and styles of a page as texts that stand in it, and the page made of them.
import {createRequire} from 'node:module';
import {join, resolve} from 'node:path';

/** The bundler of esbuild in `modules`, the folder node_modules that npm filled; `more` are options of esbuild. */
export function bundler(modules, more = {}) {
  const folder = resolve(modules), {build} = createRequire(join(folder, 'x.js'))('esbuild');
  return async (entry) => {
    const {outputFiles} = await build({
      entryPoints: [entry], bundle: true, minify: true, write: false, outdir: '/', format: 'iife', target: 'es2022', charset: 'utf8',
      nodePaths: [folder], legalComments: 'inline', logLevel: 'warning', ...more,
    });
    const of = (extension) => outputFiles.find((f) => f.path.endsWith(extension))?.text.trim() ?? '';
    return {script: of('.js').replaceAll('</script', '<\\/script'), style: of('.css').replaceAll('</style', '<\\/style')};
  };
}

/** The page with each part in its place. */
export function filled(page, parts) {
  for (const [place, part] of Object.entries(parts)) {
    if (!page.includes(place)) throw new Error(`the page has no place ${place}`);
    page = page.split(place).join(part);
  }
  return page;
}

/** A policy for a page of one file, which loads nothing from anywhere. */
export const policyOf = (text) => `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'; ${text}">`;
