// The page: a tree is typed, and each change is evaluated by the program in a worker, which the next change ends.
import './style.css';
import {makeEditor} from './editor.js';

const $ = (id) => document.getElementById(id);
const FILE = 'tree.yaml', PAUSE = 250;

// --- a tree in the address of the page

const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
const base64Of = (bytes) => btoa(Array.from(bytes, (b) => String.fromCharCode(b)).join(''));
const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream));
async function hashOf(text) {
  const bytes = new Uint8Array(await through(new TextEncoder().encode(text), new CompressionStream('deflate')).arrayBuffer());
  return `#tree=${base64Of(bytes).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}
async function textOfHash(hash) {
  const found = /^#tree=([\w-]+)$/.exec(hash);
  if (!found) return null;
  try {
    return await through(bytesOf(found[1].replaceAll('-', '+').replaceAll('_', '/')), new DecompressionStream('deflate')).text();
  } catch {
    return null;  // an address that was cut short
  }
}

// --- the program

let compiled = null, workerUrl = null, worker = null;

/** Runs commands, `{id, words, files}`; `told` gets each outcome. What was still running is ended. */
function start(commands, told) {
  worker?.terminate();
  worker = new Worker(workerUrl);
  worker.onmessage = ({data}) => (data.ended ? (worker.terminate(), (worker = null), told(null)) : told(data));
  worker.onerror = (fault) => showMessages([{severity: 'error', line: 1, column: 1, message: `the worker failed: ${fault.message}`}]);
  worker.postMessage({compiled, commands});
}

/** What a command gives that is run by itself, beside those of the page. */
function alone(words, files, input) {
  const one = new Worker(workerUrl);
  one.postMessage({compiled, commands: [{words, files, input}]});
  return new Promise((told) => (one.onmessage = ({data}) => (one.terminate(), told(data))));
}

const decode = (bytes) => new TextDecoder().decode(bytes);

/** What the program said, with places; what has none stands at the first line. */
function messagesOf(text) {
  return text.split('\n').filter((line) => line && !/^ *\d* \| /.test(line)).map((line) => {  // the editor shows the line
    const found = /^tree\.yaml:(\d+)(?::(\d+))?: (error|warning|notice): (.*)$/.exec(line) ?? /^(?:\S*: )?()()(error|warning|notice): (.*)$/.exec(line);
    if (!found) return {line: 1, column: 1, severity: 'error', message: line};
    return {line: Number(found[1] || 1), column: Number(found[2] || 1), severity: {notice: 'info'}[found[3]] ?? found[3], message: found[4]};
  });
}

// --- what is shown

let editor = null, models = [], model = null, timer = 0, fresh = true;

function showMessages(messages) {
  editor.tell(messages);
  $('messages').replaceChildren(...messages.map((m) => {
    const button = document.createElement('button');
    button.className = m.severity;
    button.textContent = `${m.line}:${m.column} ${m.message}`;
    button.onclick = () => editor.goTo(m.line, m.column);
    return button;
  }));
}

const files = () => ({...model?.files, [FILE]: editor.text});
const failed = (done) => done.status !== 0;

function evaluate() {
  const begin = performance.now();
  $('state').textContent = 'evaluating';
  start([
    {id: 'eval', words: ['eval', FILE, ...($('trace').checked ? ['--trace'] : [])], files: files()},
    {id: 'view', words: ['view', FILE, '--quiet', '-o', 'page.html'], files: files()},
  ], (done) => {
    if (!done) return;
    if (done.id === 'eval') {
      showMessages(messagesOf(decode(done.stderr)));
      $('rows').textContent = failed(done) ? '' : decode(done.stdout);
      $('state').textContent = failed(done) ? 'not evaluated' : `evaluated in ${done.seconds.toFixed(2)} s`;
      document.documentElement.dataset.evaluated = done.seconds;
    } else if (!failed(done)) {
      const text = decode(done.files['page.html']);
      $('view').contentWindow.cnrgShow(text.slice(text.indexOf('\n') + 1), fresh);
      fresh = false;
      document.documentElement.dataset.shown = (performance.now() - begin) / 1000;
    }
  });
}

function changed() {
  delete document.documentElement.dataset.shown;
  clearTimeout(timer);
  worker?.terminate();
  timer = setTimeout(evaluate, PAUSE);
}

function download(name, bytes) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function save(ending) {
  if (ending === '.yaml') return download(FILE, editor.text);
  const name = `result${ending}`;
  start([{id: 'save', words: ['eval', FILE, '-o', name], files: files()}], (done) => {
    if (!done) return;
    showMessages(messagesOf(decode(done.stderr)));
    if (!failed(done)) download(name, done.files[name]);
  });
}

/** As `papers/lessons/check` does. */
function check() {
  const lines = editor.text.split('\n');
  const holes = lines.flatMap((text, i) => (/^ *#/.test(text) || !text.includes('____') ? [] : [{line: i + 1, column: text.indexOf('____') + 1, severity: 'error', message: 'a hole is left to fill: `____`'}]));
  if (holes.length) return showMessages(holes);
  const answer = model.answer;
  start([{id: 'check', words: ['compare', FILE, 'answer.yaml'], files: {...files(), 'answer.yaml': answer}}], (done) => {
    if (!done) return;
    const told = decode(done.stdout).split('\n').filter(Boolean).map((message) => ({line: 1, column: 1, severity: 'info', message}));
    const said = messagesOf(decode(done.stderr));
    const verdict = {0: {severity: 'right', message: 'right: the exercise is solved'}, 4: {severity: 'warning', message: 'not yet right: A is your tree, B is what is asked for'}}[done.status];
    showMessages([...(verdict ? [{line: 1, column: 1, ...verdict}] : []), ...(done.status ? told : []), ...said]);
  });
}

function choose(index) {
  model = models[index];
  fresh = true;
  $('check').hidden = !model.answer;
  editor.text = model.text;
}

function listModels() {
  const groups = new Map();
  models.forEach((m, i) => {
    const group = groups.get(m.group) ?? groups.set(m.group, Object.assign(document.createElement('optgroup'), {label: m.group})).get(m.group);
    group.append(new Option(m.name, i));
  });
  $('models').replaceChildren(...groups.values());
}

function wire() {
  $('models').onchange = (e) => choose(Number(e.target.value));
  $('trace').onchange = evaluate;
  $('check').onclick = check;
  $('save').onchange = (e) => (save(e.target.value), (e.target.value = ''));
  $('link').onclick = async () => {
    const hash = await hashOf(editor.text), address = location.href.replace(/#.*$/, '') + hash;
    history.replaceState(null, '', hash);
    await navigator.clipboard?.writeText(address).then(() => ($('state').textContent = 'the link is copied'), () => ($('state').textContent = 'the link is in the address'));
  };
  addEventListener('hashchange', async () => {
    const text = await textOfHash(location.hash);
    if (text !== null && text !== editor.text) editor.text = text;
  });
}

async function begin() {
  const {schema, trees, view, worker: ran, program} = window.carried;  // by boot.js
  delete window.carried;
  models = trees;
  editor = makeEditor($('editor'), schema, changed);
  listModels();
  wire();
  workerUrl = URL.createObjectURL(new Blob([ran], {type: 'text/javascript'}));
  const shown = new Promise((done) => ($('view').onload = done));
  $('view').srcdoc = view;
  compiled = await WebAssembly.compile(program);
  await shown;
  const given = await textOfHash(location.hash);
  if (given === null) choose(0);
  else (model = null, editor.text = given);
  window.playground = {editor, models, choose: (i) => (($('models').value = i), choose(i)), hashOf, alone};
  document.documentElement.dataset.ready = 'true';
}
begin();
