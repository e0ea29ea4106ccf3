// Firefox, as Debian has it, driven by its own protocol, Marionette: messages of JSON with their length before them. A script
// that imports this is run as `node SCRIPT PROGRAM FOLDER FIREFOX`.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import net from 'node:net';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';
import {axe, check, told} from './checks.mjs';

const freePort = () => new Promise((found) => {
  const server = net.createServer().listen(0, '127.0.0.1', () => {
    const {port} = server.address();
    server.close(() => found(port));
  });
});

/** A screen that nobody sees: WebGL of a headless Firefox needs a graphics card. */
async function screen() {
  const child = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1280x900x24', '-nolisten', 'tcp'], {stdio: ['ignore', 'ignore', 'ignore', 'pipe']});
  const number = await new Promise((found) => child.stdio[3].once('data', (words) => found(String(words).trim())));
  return {child, DISPLAY: `:${number}`};
}

/** Firefox with a profile of its own; `ask(command, parameters)` is a command of the protocol. */
async function started(path) {
  const profile = mkdtempSync(join(tmpdir(), 'cnrg-firefox-')), port = await freePort(), {child: xvfb, DISPLAY} = await screen();
  writeFileSync(join(profile, 'user.js'), `user_pref("marionette.port", ${port});\nuser_pref("webgl.force-enabled", true);\nuser_pref("app.update.enabled", false);\n`);
  const child = spawn(path, ['--marionette', '--no-remote', '--profile', profile, '--width', '1280', '--height', '860'], {stdio: 'ignore', env: {...process.env, DISPLAY, LIBGL_ALWAYS_SOFTWARE: '1'}});
  let socket = null;
  for (let i = 0; i < 600 && !socket; ++i) {
    socket = await new Promise((found) => {
      const s = net.connect(port, '127.0.0.1', () => found(s)).on('error', () => found(null));
    });
    if (!socket) await sleep(200);
  }
  const end = () => {
    child.kill();
    xvfb.kill();
    rmSync(profile, {recursive: true, force: true, maxRetries: 10, retryDelay: 200});
  };
  if (!socket) {
    end();
    throw new Error('Firefox does not answer');
  }
  const waiting = new Map();
  let bytes = Buffer.alloc(0), last = 0;
  socket.on('data', (more) => {
    bytes = Buffer.concat([bytes, more]);
    for (let colon; (colon = bytes.indexOf(':')) > 0; ) {
      const size = Number(bytes.subarray(0, colon)), stop = colon + 1 + size;
      if (bytes.length < stop) return;
      const message = JSON.parse(bytes.subarray(colon + 1, stop));
      bytes = bytes.subarray(stop);
      if (Array.isArray(message)) waiting.get(message[1])?.(message);
    }
  });
  const ask = (command, parameters = {}) => new Promise((done, failed) => {
    const text = JSON.stringify([0, ++last, command, parameters]);
    waiting.set(last, ([, , error, result]) => (error ? failed(new Error(`${command}: ${error.message}`)) : done(result)));
    socket.write(`${Buffer.byteLength(text)}:${text}`);
  });
  await ask('WebDriver:NewSession', {capabilities: {alwaysMatch: {timeouts: {pageLoad: 180000, script: 180000}}}});
  return {ask, end};
}

const {ask, end} = await started(process.argv[4]);
export {ask};
/** What a script of the page's own world gives. */
const run = async (script) => (await ask('WebDriver:ExecuteScript', {script: `const window = this.window.wrappedJSObject ?? this.window; return JSON.stringify((() => { ${script} })() ?? null);`, args: []})).value;
export const value = async (script) => JSON.parse(await run(script));
export const key = (word) => ask('WebDriver:PerformActions', {actions: [{type: 'key', id: 'keys', actions: [{type: 'keyDown', value: word}, {type: 'keyUp', value: word}]}]});
export const type = async (words) => {
  for (const letter of words) await key(letter);
  await key('\uE007');
};
export async function until(script, what) {
  for (let i = 0; i < 300; ++i) {
    if (await value(`return Boolean(${script})`)) return;
    await sleep(200);
  }
  check(false, `Firefox: ${what}`);
}
export async function accessible(what) {
  const found = await ask('WebDriver:ExecuteAsyncScript', {script: `const done = arguments[arguments.length - 1]; ${axe}; axe.run(document, {resultTypes: ['violations'], iframes: false}).then((r) => done(r.violations.map((v) => v.id + ' ' + v.nodes[0].html.slice(0, 120))));`, args: []});
  check(found.value.length === 0, `Firefox, ${what}: axe: ${found.value.join(' | ')}`);
}

/** Runs `checks`, ends Firefox, and says what was found, unless `checks` gives an exit status of its own. */
export async function finished(checks) {
  let status;
  try {
    status = await checks();
    await ask('Marionette:Quit', {flags: ['eForceQuit']}).catch(() => {});
  } finally {
    end();
  }
  process.exit(status ?? told());
}
