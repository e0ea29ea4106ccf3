// What the scripts that open pages share: a browser, checks that are counted and told, a page that is watched, axe-core.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';

const executablePath = process.argv[4];
export const [program, folder] = process.argv.slice(2);
const require = createRequire(join(folder, 'node_modules', 'x.js'));
const {chromium} = require('playwright-core');
export const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');

let checks = 0, faults = 0;
export function check(holds, what) {
  ++checks;
  if (!holds) {
    ++faults;
    console.log(`FAULT: ${what}`);
  }
}

let browser;
/** A page that complains of nothing, and asks only for what these schemes have. */
export async function watched(name, options, schemes = 'file|data|blob') {
  browser ??= await chromium.launch({executablePath, args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});
  const page = await (await browser.newContext(options)).newPage();
  page.setDefaultTimeout(120000);  // a machine may have other things to do
  page.on('console', (m) => ['error', 'warning'].includes(m.type()) && !m.text().includes('GPU stall') && check(false, `${name}: console: ${m.text()}`));
  page.on('pageerror', (e) => check(false, `${name}: ${e}`));
  page.on('request', (r) => check(new RegExp(`^(${schemes}):`).test(r.url()), `${name}: asks the network for ${r.url()}`));
  return page;
}

/** axe-core finds no fault, also not in frames, where these are asked. */
export async function accessible(page, what, iframes = true) {
  await page.evaluate(axe);
  const {violations} = await page.evaluate((frames) => window.axe.run(document, {resultTypes: ['violations'], iframes: frames}), iframes);
  for (const v of violations) check(false, `${what}: axe: ${v.id}: ${v.nodes.slice(0, 3).map((n) => `${n.html.slice(0, 120)} ${n.any[0]?.message ?? ''}`).join(' | ')}`);
  ++checks;
}

/** Says what was found; the exit status for it. */
export function told() {
  console.log(faults ? `${faults} of ${checks} checks failed` : `${checks} checks`);
  return faults ? 1 : 0;
}

/** Ends the script, with what was found. */
export async function finish() {
  await browser.close();
  process.exit(told());
}
