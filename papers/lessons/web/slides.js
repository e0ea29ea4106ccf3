// Slides: which one is shown is in the address (#3), so that a reload and a link stay where they are.
// Arrows, Page Up and Down, space, Home and End turn; `a` opens and folds all answers; a tap on the right or left
// edge turns, too. What does not fit at the full size of type is set smaller, in steps, until it does; below FOLD pixels
// long blocks of code stand in two columns, if they are read better then.
'use strict';
const FOLD = 28;
const slides = [...document.querySelectorAll('.slide')];
const place = document.getElementById('place');

function fit(slide) {
  const inner = slide.querySelector('.fit'), room = 900 - 140, width = 1600 - 180;
  const shown = slide.classList.contains('here');
  slide.classList.add('here');
  const largest = (folded) => {
    inner.classList.toggle('folded', folded);
    for (let size = 40; size >= 13; --size) {
      inner.style.fontSize = size + 'px';
      const wide = [...inner.querySelectorAll('pre, table')].some((e) => e.scrollWidth > e.clientWidth + 1);
      if (inner.scrollHeight <= room && inner.scrollWidth <= width && !wide) return size;
    }
    return 0;
  };
  const plain = largest(false);
  if (plain < FOLD && largest(true) <= plain) largest(false);
  slide.classList.toggle('here', shown);
}

function at() {
  const wanted = Number(location.hash.slice(1)) || 1;
  return Math.min(Math.max(Math.trunc(wanted), 1), slides.length) - 1;
}

function show() {
  slides.forEach((slide, i) => slide.classList.toggle('here', i === at()));
  fit(slides[at()]);
  place.textContent = `${at() + 1} / ${slides.length}`;
}

function turn(steps) {
  const next = Math.min(Math.max(at() + steps, 0), slides.length - 1);
  if (next !== at()) location.hash = String(next + 1);
}

function scale() {
  document.documentElement.style.setProperty('--scale', Math.min(innerWidth / 1600, innerHeight / 900));
}

addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches('summary, a') && event.key === ' ') return;
  const steps = {ArrowRight: 1, ArrowDown: 1, PageDown: 1, ' ': 1, ArrowLeft: -1, ArrowUp: -1, PageUp: -1, Home: -slides.length, End: slides.length};
  if (event.key in steps) turn(steps[event.key]);
  else if (event.key === 'a') {
    const all = [...document.querySelectorAll('details')], open = all.some((d) => !d.open);
    all.forEach((d) => (d.open = open));
  } else return;
  event.preventDefault();
});
addEventListener('click', (event) => {
  if (event.target.closest('a, summary, pre, iframe')) return;
  if (event.clientX > innerWidth * 0.9) turn(1);
  else if (event.clientX < innerWidth * 0.1) turn(-1);
});
document.querySelectorAll('details').forEach((d) => d.addEventListener('toggle', () => fit(d.closest('.slide'))));
addEventListener('hashchange', show);
addEventListener('resize', scale);
addEventListener('beforeprint', () => slides.forEach(fit));
scale();
slides.forEach(fit);
show();
