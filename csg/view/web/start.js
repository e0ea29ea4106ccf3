// Reads the data of the page, which are compressed, and begins when they are there.
import './style.css';
import {source} from './data.js';

const element = document.getElementById('cnrg-data');
const bytes = Uint8Array.from(atob(element.textContent), (c) => c.charCodeAt(0));
element.remove();
const text = new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')));
text.json().then((json) => {
  source.json = json;
  return import('./main.js');
});
