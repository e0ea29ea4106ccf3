// Pictures of five models against those in kept/, at one size, in the browser's software rendering.
//
// A pixel differs if some channel is more than 40 of 256 levels off: what smoothing at a border may make of it in
// another version of the browser is mostly less. Of the pixels 3 of 1000 may differ. Of the same program none does;
// a camera that is off by half a degree changes more than that, and a missing face, a wrong color, an edge
// that is dashed or not make more than that differ, too (the test tries some of these itself).
//
//   CNRG_WRITE_PICTURES=1 tests/view/browser/run ...     writes them anew: look at each before it is kept
import {existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const KEPT = join(dirname(fileURLToPath(import.meta.url)), 'kept'), LEVELS = 40, SHARE = 0.003;

const PICTURES = [
  ['fig10', 'pereira2012/fig10', 'model', 'light', 'axis=y&cut=0.5'],
  ['edge', 'weiler1986/edge', 'around', 'dark', 'apart=0.4'],
  ['operators', 'rossignac1991/operators', 'rock', 'light', 'color=component'],
  ['fig07', 'pereira2012/fig07', 'difference', 'dark', 'color=class&ghosts=1'],
  ['fig04', 'pereira2012/fig04', 'union_G1', 'light', 'through=1&cell=r1'],
];

/** The share of pixels of two PNGs that differ; 1 if their sizes do. */
const difference = (page, a, b) => page.evaluate(async ([one, other, levels]) => {
  const read = async (url) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height}), context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height);
  };
  const [p, q] = [await read(one), await read(other)];
  if (p.width !== q.width || p.height !== q.height) return 1;
  let count = 0;
  for (let i = 0; i < p.data.length; i += 4) count += [0, 1, 2].some((k) => Math.abs(p.data[i + k] - q.data[i + k]) > levels);
  return count / (p.data.length / 4);
}, [...[a, b].map((x) => `data:image/png;base64,${x.toString('base64')}`), LEVELS]);

export async function testPictures({cnrg, check, open, close, work}) {
  mkdirSync(KEPT, {recursive: true});
  for (const [name, path, node, scheme, hash] of PICTURES) {
    const tree = `papers/${path}.yaml`, file = join(work, `picture-${name}.html`), kept = join(KEPT, `${name}.png`);
    cnrg('view', tree, '--node', node, '-o', file, '--quiet');
    const page = await open(file, {hash: `#node=${node}&${hash}`, scheme, width: 1010, height: 390});
    // Letters depend on the machine's fonts: the picture is the scene alone.
    await page.addStyleTag({content: '#stage > :not(#scene) { visibility: hidden !important; }'});
    const take = async () => {
      await page.waitForTimeout(400);  // the camera rests
      return page.locator('#scene').screenshot();
    };
    const now = await take();
    if (process.env.CNRG_WRITE_PICTURES === '1') writeFileSync(kept, now);
    writeFileSync(join(work, `${name}.png`), now);
    if (!existsSync(kept)) {
      check(false, `${name}: no picture is kept; CNRG_WRITE_PICTURES=1 writes it`);
    } else {
      const share = await difference(page, now, readFileSync(kept));
      check(share <= SHARE, `${name}: ${(100 * share).toFixed(2)} % of the pixels differ from ${kept}; now ${join(work, `${name}.png`)}`);
      // What must not pass, does not.
      for (const [what, change] of [['a turned camera', (scene) => scene.turn(0.008, 0)], ['no edges', () => document.getElementById('show1').click()]]) {
        await page.evaluate(`(${change})(window.cnrg.scene)`);
        const changed = await difference(page, await take(), readFileSync(kept));
        check(changed > SHARE, `${name}: ${what} would pass: ${(100 * changed).toFixed(2)} %`);
        if (process.env.CNRG_WRITE_PICTURES === '1') console.log(`${name}: ${what}: ${(100 * changed).toFixed(2)} % differ`);
      }
    }
    await close(page);
  }
}
