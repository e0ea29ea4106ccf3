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
