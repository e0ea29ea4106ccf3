// Opens the playground in a browser, from its file: nothing asks the network or complains; a tree that is typed is evaluated
// and shown, a fault stands at its line, a later change ends an evaluation, exercises are checked, links hold trees, files
// that are saved have the bytes of the native program, keys are completed, the keyboard reaches all.
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {accessible, check, finish, program, watched} from '../view/browser/checks.mjs';

const file = resolve('out/lessons/playground.html');
if (!existsSync(file)) {
  console.error('not run: there is no out/lessons/playground.html; papers/lessons/playground makes it');
  process.exit(77);
}
const work = mkdtempSync(join(tmpdir(), 'cnrg_playground_'));
const pictures = process.env.CNRG_PICTURES;  // a folder for pictures to look at

const page = await watched('playground', {viewport: {width: 1400, height: 850}, acceptDownloads: true}, 'file|data|blob|about');
page.setDefaultTimeout(120000);

const picture = async (name) => pictures && page.screenshot({path: join(pictures, `${name}.png`)});
const root = page.locator('html');
const frame = page.frameLocator('#view');
const shown = () => page.locator('html[data-shown]').waitFor({state: 'attached', timeout: 60000});
const seconds = async () => [Number(await root.getAttribute('data-evaluated')), Number(await root.getAttribute('data-shown'))];
async function type(text) {
  await page.evaluate((t) => (window.playground.editor.text = t), text);
}
async function evaluated(text) {
  await type(text);
  await shown();
}
async function choose(group, name) {
  const index = await page.evaluate(([g, n]) => window.playground.models.findIndex((m) => m.group === g && m.name === n), [group, name]);
  check(index >= 0, `there is a model ${group}: ${name}`);
  await page.evaluate((i) => window.playground.choose(i), index);
}

await page.goto(`file://${file}`);
await page.locator('html[data-ready]').waitFor({state: 'attached', timeout: 60000});
await shown();
await frame.locator('html[data-ready]').waitFor({state: 'attached', timeout: 60000});
check(statSync(file).size <= 3e6, `the page has ${statSync(file).size} bytes`);
check((await page.locator('#rows').innerText()).includes('operator'), 'the first model has rows');
await picture('first');

// Fig. 10 of Pereira et al., and what the page saves of it.
await choose('Papers: pereira2012', 'fig10');
await shown();
const [own, all] = await seconds();
console.log(`Fig. 10: evaluated in ${own.toFixed(2)} s, shown after ${all.toFixed(2)} s`);
check((await frame.locator('#node').innerText()).length > 20, 'the node is told of beside the picture');
await picture('fig10');
const text = readFileSync('papers/pereira2012/fig10.yaml', 'utf8');
/** What the page saves is what the program writes. */
async function saved(tree, ending) {
  const name = `result${ending}`;
  writeFileSync(join(work, 'tree.yaml'), tree);
  execFileSync(program, ['eval', 'tree.yaml', '--quiet', '-o', name], {cwd: work});
  const [download] = await Promise.all([page.waitForEvent('download', {timeout: 60000}), page.locator('#save').selectOption(ending)]);
  check(readFileSync(await download.path()).equals(readFileSync(join(work, name))), `${name} has the bytes of the native program`);
}
for (const ending of ['.json', '.obj']) await saved(text, ending);

// A fault at its line; a change while another evaluation runs.
const box = 'cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nresult: a\n';
await type(text);
await page.waitForTimeout(400);
await evaluated(box);
check((await page.locator('#rows').innerText()).includes('box'), 'the later change is what is shown');
check(!(await page.locator('#rows').innerText()).includes('tunnel'), 'nothing of the ended evaluation is shown');
await saved(box, '.stl');
await type(box.replace('max', 'mox'));
await page.locator('#messages .error').waitFor({timeout: 60000});
check((await page.locator('#messages .error').first().innerText()).startsWith('3:'), 'a fault is told with its line');
check((await page.locator('.cm-lint-marker-error').count()) === 1, 'a fault is marked at its line');
await picture('fault');
await accessible(page, 'playground with a fault', false);

// By keys alone: into the editor by Tab, out of it by Escape and Tab, to the message, which goes back to its place.
const focus = () => page.evaluate(() => document.activeElement.closest('#editor') ? 'editor' : document.activeElement.closest('[id]')?.id ?? '');
await page.locator('#models').focus();
const reached = [];
for (const word of ['', 'Tab', 'Tab', 'Tab', 'Tab', 'Escape', 'Tab', 'Tab', 'Tab']) {
  if (word) await page.keyboard.press(word);
  reached.push(await focus());
}
check(reached.join(' ') === 'models trace link save editor editor messages rows view', `keys reach ${reached.join(' ')}`);
await page.locator('#messages .error').first().focus();
await page.keyboard.press('Enter');
check((await focus()) === 'editor', 'a message leads to its place');

// A link.
await evaluated(box);
const hash = await page.evaluate(() => window.playground.hashOf(window.playground.editor.text));
const second = await page.context().newPage();
await second.goto(`file://${file}${hash}`);
await second.locator('html[data-shown]').waitFor({state: 'attached', timeout: 60000});
check((await second.evaluate(() => window.playground.editor.text)) === box, 'a link holds the tree');
await second.close();

// Completion: leaves in a node, keys of a leaf, names of nodes.
async function completed(before, after) {
  await type(before + after);
  await page.evaluate((at) => {
    const {view} = window.playground.editor;
    view.focus();
    view.dispatch({selection: {anchor: at}});
  }, before.length);
  await page.keyboard.press('Control+Space');
  await page.locator('.cm-tooltip-autocomplete li').first().waitFor({timeout: 5000}).catch(() => {});
  const words = await page.locator('.cm-tooltip-autocomplete li .cm-completionLabel').allInnerTexts();
  await picture(`completion-${before.length}`);
  await page.keyboard.press('Escape');
  return words;
}
const head = 'cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n';
check((await completed(`${head}  b: {sph`, '}\nresult: a\n')).includes('sphere'), 'leaves are completed');
check((await completed(`${head}  b: {cylinder: {rad`, '}}\nresult: a\n')).includes('radius'), 'keys of a leaf are completed');
check((await completed(`${head}  b:\n    cyl`, '\nresult: a\n')).includes('cylinder'), 'leaves on a line of their own are completed');
check((await completed(`${head}  b: {union: [a`, ']}\nresult: a\n')).includes('a'), 'names of nodes are completed');

// Every exercise is open as it is given, and solved by its answer.
const exercises = await page.evaluate(() => window.playground.models.map((m, i) => ({i, ...m})).filter((m) => m.answer));
check(exercises.length === 14, `there are ${exercises.length} exercises`);
for (const {i, name, answer} of exercises) {
  await page.evaluate((k) => window.playground.choose(k), i);
  await page.locator('#check').click();
  await page.locator('#messages .error').first().waitFor({timeout: 60000}).catch(() => check(false, `${name}: holes are told`));
  await evaluated(answer);
  await page.locator('#check').click();
  await page.locator('#messages .right').waitFor({timeout: 60000}).catch(() => check(false, `${name}: the answer is right`));
}
await picture('exercise');

await accessible(page, 'playground', false);

rmSync(work, {recursive: true});
await finish();
