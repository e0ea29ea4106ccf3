// A run of the program `cnrg` in WebAssembly: an instance of its own, with its files in memory.

const HOME = '/tree', BESIDE = '/bin';
/** A template of `cnrg view` that is its title and its data alone. */
const TEMPLATE = '<!--cnrg:stamp--><!--cnrg:title-->\n<!--cnrg:data-->';

function writeAll(FS, files) {
  for (const [path, content] of Object.entries(files)) {
    const full = path.startsWith('/') ? path : `${HOME}/${path}`;
    FS.mkdirTree(full.replace(/\/[^/]*$/, ''));
    if (!path.endsWith('/')) FS.writeFile(full, content);
  }
}

/** What `bytes` took, as one array. */
const joined = (bytes) => Uint8Array.from(bytes);

/** The files after each `-o` that are there. */
function written(FS, words) {
  const out = {};
  words.forEach((word, i) => {
    if (words[i - 1] === '-o' && FS.analyzePath(word).exists) out[word] = FS.readFile(word);
  });
  return out;
}

/**
 * Runs `cnrg WORDS...` in a folder with `files` (texts or bytes by path; a path that ends with / is a folder). `create` is what the module `cnrg.mjs` exports,
 * `compiled` its WebAssembly.Module. Gives the exit status, both streams, and the files after `-o`, as bytes.
 */
export async function run(create, compiled, words, files = {}, input = new Uint8Array()) {
  const out = [], err = [];
  let read = 0;
  const program = await create({
    noInitialRun: true,
    thisProgram: 'cnrg',
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(compiled, imports).then((instance) => done(instance, compiled));
      return {};
    },
    preRun(module) {
      const {FS} = module;
      FS.init(() => (read < input.length ? input[read++] : null), (byte) => out.push(byte & 255), (byte) => err.push(byte & 255));
      writeAll(FS, {[`${BESIDE}/view.html`]: TEMPLATE, ...files});
      FS.symlink(`${BESIDE}/cnrg`, '/proc/self/exe');  // where the program looks for the template
      // Emscripten has links of open files, and opens nothing by them: the mounted folder and the one below it go.
      FS.rmdir('/proc/self/fd');
      FS.unmount('/proc/self/fd');
      FS.rmdir('/proc/self/fd');
      FS.mkdirTree(HOME);
      FS.chdir(HOME);
    },
  });
  let status;
  try {
    status = program.callMain(words);
  } catch (fault) {  // what the machine ends: no memory, too deep a recursion
    err.push(...new TextEncoder().encode(`cnrg: error: the run was ended: ${fault.message}\n`));
    status = 3;
  }
  return {status, stdout: joined(out), stderr: joined(err), files: written(program.FS, words)};
}
