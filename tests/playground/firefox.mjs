// Opens the playground in headless Firefox, from its file: Fig. 10 is evaluated and shown, what the page says of it is what the
// program says, keys leave the editor, axe-core finds no fault.
import {execFileSync} from 'node:child_process';
import {existsSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {check, folder, program} from '../view/browser/checks.mjs';
import {accessible, ask, finished, key, until, value} from '../view/browser/marionette.mjs';

const ESCAPE = '\uE00C', TAB = '\uE004';
const file = resolve('out/lessons/playground.html');

await finished(async () => {
  if (!existsSync(file)) {
    console.error('not run: there is no out/lessons/playground.html; papers/lessons/playground makes it');
    return 77;
  }
  await ask('WebDriver:Navigate', {url: `file://${file}`});
  await until('document.documentElement.dataset.ready', 'the page comes up');
  await until('document.documentElement.dataset.shown', 'the first model is shown');
  await value("delete document.documentElement.dataset.shown; const {models, choose} = window.playground; return choose(models.findIndex((m) => m.group === 'Papers: pereira2012' && m.name === 'fig10'))");
  await until('document.documentElement.dataset.shown', 'Fig. 10 is shown');
  const {evaluated, shown} = await value('return {...document.documentElement.dataset}');
  console.log(`Fig. 10 in Firefox: evaluated in ${Number(evaluated).toFixed(2)} s, shown after ${Number(shown).toFixed(2)} s`);
  const untimed = (rows) => rows.split('\n').map((row) => row.trim().split(/ +/).slice(0, 7).filter((word) => !/^\d+\.\d{3}$/.test(word)).join(' ')).join('\n').trim();
  const rows = execFileSync(program, ['eval', 'papers/pereira2012/fig10.yaml'], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore']});
  check(untimed(await value("return document.getElementById('rows').textContent")) === untimed(rows), 'Firefox: rows of Fig. 10');
  await value("window.playground.editor.view.focus(); return true");
  await key(ESCAPE);
  await key(TAB);
  check(await value("return !document.activeElement.closest('#editor')"), 'Firefox: keys leave the editor');
  await accessible('playground');
  const {value: picture} = await ask('WebDriver:TakeScreenshot', {full: false});
  writeFileSync(join(folder, 'playground-firefox.png'), Buffer.from(picture, 'base64'));
});
