// Style and script of the page. The script's text has no element of HTML in it: cells get their texts as such.
#include "bench/report/page.h"

namespace cnrg::bench {

const char* const kStyle = R"css(
:root {
  --page: #ffffff; --card: #f5f7f9; --ink: #1b2026; --muted: #5a6470; --rule: #d9dee4; --alarm: #c0280c;
  --s0: #0067b1; --s1: #cc4e00; --s2: #9a7000; --s3: #00805b; --s4: #b0528f;
  --s5: #3f97c4; --s6: #7a5c3e; --s7: #6b7280; --s8: #8a1c4a; --s9: #2f8580;
  --same: #00846a; --same-regularized: #6fbfae; --contact-duplicated: #efd470; --contact-lost: #d9ae2b;
  --dangling-lost: #ad8428; --wrong: #d1410c; --refused: #a3abb8; --crashed: #7b4aa0; --timed-out: #626b7a;
  --out-of-memory: #363e4a; --unjudged: #c9ced6;
}
@media (prefers-color-scheme: dark) { :root {
  --page: #14171b; --card: #1d2228; --ink: #e7eaee; --muted: #9ba5b1; --rule: #333b44; --alarm: #ff7a5c;
  --s0: #5db1f0; --s1: #ff8f4a; --s2: #e2b534; --s3: #3fc49a; --s4: #e58cc4;
  --s5: #a3d6f4; --s6: #c4a384; --s7: #a3abb8; --s8: #e0739f; --s9: #74cdc6;
  --same: #1fa88a; --same-regularized: #8fd6c7; --contact-duplicated: #f3dc86; --contact-lost: #dcb443;
  --dangling-lost: #b48d35; --wrong: #f0602c; --refused: #8b94a3; --crashed: #a678cc; --timed-out: #697384;
  --out-of-memory: #4a5361; --unjudged: #6d7683;
} }
* { box-sizing: border-box; }
html { background: var(--page); color: var(--ink); -webkit-print-color-adjust: exact; print-color-adjust: exact; }
body { margin: 0; font: 15px/1.5 system-ui, "Segoe UI", "Noto Sans", "Liberation Sans", Arial, sans-serif; }
main { max-width: 1140px; margin: 0 auto; padding: 32px 20px 64px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 6px; letter-spacing: -0.01em; }
h2 { font-size: 20px; margin: 0 0 6px; }
h3 { font-size: 15px; margin: 22px 0 4px; }
h3 small, th small { display: block; font-weight: normal; color: var(--muted); font-size: 12px; line-height: 1.3; }
h3 small { display: inline; margin-left: 6px; font-size: 13px; }
p { margin: 0 0 10px; max-width: 84ch; }
section { margin-top: 48px; break-inside: auto; }
.lead, .reading { color: var(--muted); }
.lead { max-width: none; margin-bottom: 20px; }
code { font: 12px/1.4 ui-monospace, "Noto Sans Mono", "DejaVu Sans Mono", monospace; overflow-wrap: anywhere; }
.facts { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 16px; }
.facts article { background: var(--card); border-radius: 8px; padding: 18px 18px 14px; break-inside: avoid;
  display: grid; grid-row: span 5; grid-template-rows: subgrid; row-gap: 0; align-content: start; }
.facts h2 { font-size: 15px; color: var(--muted); font-weight: 600; margin: 0; }
.facts .big { font-size: 36px; line-height: 1.25; font-weight: 700; letter-spacing: -0.02em; color: var(--s0);
  margin: 2px 0 2px; font-variant-numeric: tabular-nums; }
.facts .said { margin-bottom: 12px; }
.facts .note { margin: 0; color: var(--muted); font-size: 12px; line-height: 1.4; }
nav { margin-top: 20px; display: flex; flex-wrap: wrap; gap: 4px 18px; font-size: 13px; }
a { color: var(--s0); text-decoration: none; }
a:hover { text-decoration: underline; }
.wide { overflow-x: auto; margin-bottom: 12px; }
table { border-collapse: collapse; width: 100%; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: 5px 8px; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); }
th { font-weight: 600; }
thead th { color: var(--muted); font-size: 12px; vertical-align: bottom; white-space: nowrap; }
thead th span { color: var(--ink); }
td.count, thead th.count, table.numbers td, table.numbers thead th, table.fact td, table.fact thead th {
  text-align: right; }
table.numbers th:first-child, table.fact th:first-child { text-align: left; }
table.numbers td { white-space: nowrap; }
table.numbers td.text, table.numbers thead th.text { text-align: left; white-space: normal; }
table.ratios { font-size: 12px; }
table.ratios th, table.ratios td { padding: 5px 6px; }
table.ratios td.text { line-height: 1.35; min-width: 170px; font-weight: normal; }
table.narrow { width: auto; min-width: 480px; }
table.fact { font-size: 12.5px; }
table.fact th, table.fact td { padding: 3px 0 3px 8px; white-space: nowrap; }
table.fact th:first-child { padding-left: 0; font-weight: normal; white-space: normal; }
table.fact tr.ours th, table.fact tr.ours td { font-weight: 700; }
table.fact tbody tr:last-child > * { border-bottom: 0; }
tr.group th { color: var(--muted); font-size: 12px; padding-top: 16px; }
tr.total > * { border-top: 1px solid var(--muted); font-weight: 600; }
tr.first-failure > * { border-top: 1px solid var(--muted); }
table.numbers td.defined { text-align: left; font-weight: normal; color: var(--muted); }
table.list td.example { max-width: 420px; }
table.list td small { color: var(--muted); overflow-wrap: anywhere; }
.count { white-space: nowrap; }
.zero, .none { color: var(--muted); }
table.matrix { table-layout: fixed; min-width: 900px; }
.matrix thead th { white-space: normal; }
.matrix thead th:first-child { width: 172px; }
.matrix thead th.count { width: 74px; }
.matrix th, .matrix td { padding: 5px 6px; }
.bar { display: flex; height: 12px; margin: 3px 0 1px; border-radius: 2px; overflow: hidden;
  background: var(--rule); }
.bar i { flex: 0 0 0; min-width: 2px; }
.counts { display: block; font-size: 11.5px; color: var(--muted); }
.counts span { white-space: nowrap; }
.counts .exact, .counts .right { color: var(--ink); }
.counts .failed { color: var(--alarm); font-weight: 600; }
.dot, .box { display: inline-block; width: 10px; height: 10px; border-radius: 50%; margin-right: 6px; flex: none; }
.box { border-radius: 2px; }
.mark { display: inline-flex; align-items: baseline; }
.legend { display: flex; flex-wrap: wrap; gap: 2px 18px; font-size: 12.5px; max-width: none; }
.v-same { background: var(--same); } .v-same-regularized { background: var(--same-regularized); }
.v-contact-duplicated { background: var(--contact-duplicated); }
.v-contact-lost { background: var(--contact-lost); }
.v-dangling-lost { background: var(--dangling-lost); } .v-wrong { background: var(--wrong); }
.v-refused { background: var(--refused); } .v-crashed { background: var(--crashed); }
.v-timed-out { background: var(--timed-out); }
.v-unjudged { background: repeating-linear-gradient(135deg, var(--unjudged) 0 2px, var(--page) 2px 4px); }
.v-out-of-memory { background: var(--out-of-memory); }
figure { margin: 0; break-inside: avoid; min-width: 0; }
svg { display: block; width: 100%; height: auto; font-family: inherit; color: var(--ink); }
.two { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 8px 20px; }
.three { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 8px 16px; }
.keep { break-inside: avoid; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 18px; margin: 0; font-size: 14px; }
dt { color: var(--muted); } dd { margin: 0; overflow-wrap: anywhere; }
.alarm { border: 2px solid var(--alarm); border-radius: 8px; padding: 14px 18px; margin: 0 0 18px; }
.alarm h2, tr.alarming th, tr.alarming td { color: var(--alarm); }
.alarm ul { margin: 0; padding-left: 20px; }
summary { cursor: pointer; font-weight: 600; }
#runs-view .tools { display: flex; flex-wrap: wrap; gap: 8px; align-items: center; margin: 12px 0;
  font-size: 13px; }
#runs-view input, #runs-view select, #runs-view button { font: inherit; color: inherit; background: var(--card);
  border: 1px solid var(--rule); border-radius: 5px; padding: 4px 8px; }
#runs-view input { width: 300px; }
#runs-view thead button { border: 0; background: none; padding: 0; color: var(--muted); font-weight: 600;
  cursor: pointer; }
#runs-view td.number { text-align: right; white-space: nowrap; }
#runs-view td:first-child { min-width: 170px; }
#runs-view td:last-child code { display: block; color: var(--muted); }
@media screen and (max-width: 820px) { .facts, .two, .three { grid-template-columns: minmax(0, 1fr); } }
@page { size: A4 landscape; margin: 12mm; }
@media print {
  nav, #rows-section { display: none; }
  body { font-size: 12px; }
  main { max-width: none; padding: 0; }
  section { margin-top: 28px; }
  h2, h3, .reading { break-after: avoid; }
  tr { break-inside: avoid; }
  .wide { overflow: visible; }
  table, table.fact { font-size: 10.5px; }
  th, td { padding: 3px 6px; }
}
)css";

const char* const kScript = R"js(
// The table of all runs is made when it is opened: filtered and sorted whole, shown some hundreds at a time.
(function () {
  'use strict';
  const STEP = 200;
  const COLUMNS = [['problem', false], ['system', false], ['verdict', false], ['stage', false], ['seconds', true],
    ['own MB', true], ['peak MB', true], ['message and command', false]];
  const details = document.getElementById('runs');
  const view = document.getElementById('runs-view');
  let store = null, shown = STEP, sorted = -1, down = false;

  function make(name, text, parent, className) {
    const node = document.createElement(name);
    if (text !== null) { node.textContent = text; }
    if (className) { node.className = className; }
    if (parent) { parent.appendChild(node); }
    return node;
  }
  function number(text) {
    const value = parseFloat(text.replace(/,/g, ''));
    return isNaN(value) ? -1 : value;
  }
  function choice(parent, label, names) {
    const select = make('select', null, parent);
    select.setAttribute('aria-label', label);
    make('option', label, select).value = '';
    names.forEach(function (name, i) { make('option', name, select).value = String(i); });
    return select;
  }
  function compare(a, b) {
    let order;
    if (COLUMNS[sorted][1]) { order = number(a[sorted]) - number(b[sorted]); }
    else if (sorted === 1 || sorted === 2) { order = a[sorted] - b[sorted]; }
    else { order = a[sorted].localeCompare(b[sorted], 'en', { numeric: true }); }
    return down ? -order : order;
  }
  function open() {
    store = JSON.parse(document.getElementById('runs-data').textContent);
    const tools = make('div', null, view, 'tools');
    const text = make('input', null, tools);
    text.type = 'search';
    text.placeholder = 'problem, stage, message or command';
    text.setAttribute('aria-label', 'Filter');
    const system = choice(tools, 'all systems', store.systems);
    const verdict = choice(tools, 'all verdicts', store.verdicts);
    const count = make('span', '', tools);
    const wide = make('div', null, view, 'wide');
    const table = make('table', null, wide);
    const head = make('tr', null, make('thead', null, table));
    const body = make('tbody', null, table);
    const more = make('button', 'Show more', view);

    function render() {
      const wanted = text.value.toLowerCase();
      let rows = store.rows.filter(function (row) {
        if (system.value !== '') { if (row[1] !== Number(system.value)) { return false; } }
        if (verdict.value !== '') { if (row[2] !== Number(verdict.value)) { return false; } }
        if (wanted === '') { return true; }
        return [row[0], row[3], row[7], row[8]].join(' ').toLowerCase().includes(wanted);
      });
      if (sorted >= 0) { rows.sort(compare); }
      count.textContent = rows.length.toLocaleString('en') + ' of ' + store.rows.length.toLocaleString('en');
      body.textContent = '';
      rows.slice(0, shown).forEach(function (row) {
        const line = make('tr', null, body);
        make('code', row[0], make('td', null, line));
        make('td', store.systems[row[1]], line);
        const cell = make('td', null, line);
        make('i', null, cell, 'box v-' + store.verdicts[row[2]]);
        cell.appendChild(document.createTextNode(store.verdicts[row[2]].replace(/-/g, ' ')));
        make('td', row[3], line);
        make('td', row[4], line, 'number');
        make('td', row[5], line, 'number');
        make('td', row[6], line, 'number');
        const last = make('td', row[7], line);
        make('code', row[8], last);
      });
      more.hidden = !(rows.length > shown);
    }
    function again() { shown = STEP; render(); }
    COLUMNS.forEach(function (column, i) {
      const cell = make('th', null, head);
      cell.scope = 'col';
      if (column[1]) { cell.className = 'count'; }
      make('button', column[0], cell).addEventListener('click', function () {
        down = sorted === i ? !down : false;
        sorted = i;
        head.querySelectorAll('th').forEach(function (other) { other.removeAttribute('aria-sort'); });
        cell.setAttribute('aria-sort', down ? 'descending' : 'ascending');
        again();
      });
    });
    text.addEventListener('input', again);
    system.addEventListener('change', again);
    verdict.addEventListener('change', again);
    more.addEventListener('click', function () { shown += STEP; render(); });
    render();
  }
  function opened() { if (details.open) { if (store === null) { open(); } } }
  details.addEventListener('toggle', opened);
  if (location.hash === '#runs') { details.open = true; }
  opened();
})();
)js";

}  // namespace cnrg::bench
