// Opens the lessons in a browser, from files: nothing asks the network or complains, the interactive view of each comes
// up in its frame with the node and cell that the lesson names, slides turn by keys and hold all that they show, with
// answers folded and open, and axe-core finds no fault in pages and slides, light and dark.
import {execFileSync} from 'node:child_process';
import {readdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {accessible, check, finish, folder, program, watched} from '../view/browser/checks.mjs';

const work = join(folder, 'lessons');
execFileSync('papers/lessons/make', ['--out', work], {env: {...process.env, PATH: `${dirname(program)}:${process.env.PATH}`}});

async function open(file, colorScheme) {
  const page = await watched(file, {viewport: {width: 1280, height: 720}, colorScheme});
  await page.goto(`file://${file}`);
  return page;
}

/** The view in the frame of a page: it is up, and shows what its address asks for. */
async function viewed(page, what) {
  const frame = page.frameLocator('.view iframe');
  await page.locator('.view iframe').scrollIntoViewIfNeeded();
  await frame.locator('html[data-ready]').waitFor({state: 'attached', timeout: 20000}).catch(() => check(false, `${what}: the view does not come up`));
  const wanted = new URLSearchParams((await page.locator('.view iframe').getAttribute('src')).split('#')[1]);
  const node = await frame.locator('#node').innerText();
  check(node.includes(wanted.get('node')), `${what}: the view shows ${wanted.get('node')}, not ${node.slice(0, 40)}`);
  if (wanted.has('cell')) check((await frame.locator('#picked').textContent()) === wanted.get('cell'), `${what}: ${wanted.get('cell')} is picked`);
}

const SMALLEST = 22;  // pixels of type on a slide of 1600 by 900

/** What does not fit on the slide that is shown, or is too small to read; empty if all does. */
const overflow = (page) => page.evaluate((smallest) => {
  const slide = document.querySelector('.slide.here'), inner = slide.querySelector('.fit');
  const over = [];
  if (parseInt(inner.style.fontSize) < smallest) over.push(`letters of ${inner.style.fontSize}`);
  if (inner.scrollHeight > 900 - 140) over.push(`${inner.scrollHeight} high at ${inner.style.fontSize}`);
  if (inner.scrollWidth > 1600 - 180) over.push(`${inner.scrollWidth} wide`);
  for (const e of inner.querySelectorAll('pre')) if (e.scrollWidth > e.clientWidth + 1) over.push(`cut off: ${e.textContent.slice(0, 40)}`);
  return over.join(', ');
}, SMALLEST);

for (const lesson of readdirSync(work).filter((name) => /^\d\d-/.test(name))) {
  for (const scheme of lesson.startsWith('01') ? ['light', 'dark'] : ['light']) {
    const page = await open(join(work, lesson, 'index.html'), scheme);
    await viewed(page, lesson);
    await accessible(page, `${lesson} ${scheme}`, false);
    await page.context().close();
  }
  const page = await open(join(work, lesson, 'slides.html'), 'light');
  const count = await page.locator('.slide').count();
  check(count >= 6, `${lesson}: ${count} slides`);
  for (let i = 1; i <= count; ++i) {
    await page.locator('#place', {hasText: `${i} / ${count}`}).waitFor({timeout: 5000}).catch(() => check(false, `${lesson}: slide ${i} is not shown`));
    check((await overflow(page)) === '', `${lesson}, slide ${i}: ${await overflow(page)}`);
    if (await page.locator('.slide.here iframe').count()) await viewed(page, `${lesson}, slide ${i}`);
    if (await page.locator('.slide.here details').count()) {
      await page.keyboard.press('a');
      await page.waitForTimeout(50);
      check((await page.locator('.slide.here details[open]').count()) === 1, `${lesson}: answers are open`);
      check((await overflow(page)) === '', `${lesson}, answers: ${await overflow(page)}`);
    }
    if (i === 1) await accessible(page, `${lesson}, slides`, false);
    await page.keyboard.press(i % 2 ? 'ArrowRight' : ' ');
  }
  await page.keyboard.press('Home');
  await page.locator('#place', {hasText: `1 / ${count}`}).waitFor({timeout: 5000}).catch(() => check(false, `${lesson}: Home`));
  await page.context().close();
}

await finish();
