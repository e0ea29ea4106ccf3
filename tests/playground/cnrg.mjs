#!/usr/bin/env node
// `cnrg` in WebAssembly as a command, by what the playground runs: for comparisons with the native program. It sees the
// files of the current folder. CNRG_WASM names the folder of cnrg.mjs and cnrg.wasm; CNRG_PAGE the port of a page that runs it
// instead (chromium.mjs).
import {readdirSync, readFileSync, statSync, writeFileSync, writeSync} from 'node:fs';
import {join, relative, resolve} from 'node:path';

import {run} from '../../papers/lessons/web/playground/program.mjs';

const built = process.env.CNRG_WASM ?? new URL('../../build/wasm/csg', import.meta.url).pathname;

function filesBelow(folder, files = {}) {
  for (const name of readdirSync(folder)) {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) {
      files[relative('.', path) + '/'] = '';
      filesBelow(path, files);
    } else files[relative('.', path)] = readFileSync(path);
  }
  return files;
}

/** Writes all of it, also to a pipe that is slow. */
function print(stream, bytes) {
  for (let at = 0; at < bytes.length;) {
    try {
      at += writeSync(stream, bytes, at);
    } catch (fault) {
      if (fault.code !== 'EAGAIN') throw fault;
    }
  }
}

async function runHere(words, files, input) {
  const {default: create} = await import(resolve(built, 'cnrg.mjs'));
  return run(create, new WebAssembly.Module(readFileSync(resolve(built, 'cnrg.wasm'))), words, files, input);
}

/** Bytes go to the page and back as letters, one for each. */
async function runInPage(words, files, input) {
  const letters = (bytes) => Buffer.from(bytes).toString('latin1'), bytes = (text) => Buffer.from(text, 'latin1');
  const each = (all, change) => Object.fromEntries(Object.entries(all).map(([path, content]) => [path, change(content)]));
  const body = JSON.stringify({words, files: each(files, letters), input: letters(input)});
  const done = await (await fetch(`http://127.0.0.1:${process.env.CNRG_PAGE}`, {method: 'POST', body})).json();
  return {status: done.status, stdout: bytes(done.stdout), stderr: bytes(done.stderr), files: each(done.files, bytes)};
}

const words = process.argv.slice(2);
const input = words[0] === 'locate' || words.includes('-') ? readFileSync(0) : new Uint8Array();
const done = await (process.env.CNRG_PAGE ? runInPage : runHere)(words, filesBelow('.'), input);
for (const [path, content] of Object.entries(done.files)) writeFileSync(path, content);
print(1, done.stdout);
print(2, done.stderr);
process.exitCode = done.status;
