// Holds the program in the page against the native one, byte for byte, in headless Chromium: the page is opened once, and
// answers what cnrg.mjs asks at a port of this machine. CNRG_TREES: how many trees, as `run` has them.
import {spawn} from 'node:child_process';
import {existsSync} from 'node:fs';
import {createServer} from 'node:http';
import {resolve} from 'node:path';
import {check, finish, program, watched} from '../view/browser/checks.mjs';

const file = resolve('out/lessons/playground.html');
if (!existsSync(file)) {
  console.error('not run: there is no out/lessons/playground.html; papers/lessons/playground makes it');
  process.exit(77);
}
const page = await watched('playground', {}, 'file|data|blob|about');
await page.goto(`file://${file}`);
await page.locator('html[data-ready]').waitFor({state: 'attached', timeout: 60000});

const answer = (asked) => page.evaluate(async ({words, files, input}) => {
  const bytes = (text) => Uint8Array.from(text, (c) => c.charCodeAt(0)), letters = (all) => Array.from(all, (b) => String.fromCharCode(b)).join('');
  const each = (all, change) => Object.fromEntries(Object.entries(all).map(([path, content]) => [path, change(content)]));
  const done = await window.playground.alone(words, each(files, bytes), bytes(input));
  return {status: done.status, stdout: letters(done.stdout), stderr: letters(done.stderr), files: each(done.files, letters)};
}, asked);
const server = createServer(async (request, response) => {
  response.end(JSON.stringify(await answer(JSON.parse(Buffer.concat(await request.toArray())))));
}).listen(0, '127.0.0.1', () => {
  const env = {...process.env, CNRG_PAGE: String(server.address().port)};
  const compared = spawn('tests/playground/run', [program], {stdio: 'inherit', env});
  compared.on('close', async (status) => {
    check(status === 0, `the page answers as ${program} does: exit status ${status}`);
    await finish();
  });
});
