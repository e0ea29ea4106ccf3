// Reads the data of the page, which are compressed, and begins when they are there. A page without any is told them by
// who shows it in a frame: `cnrgShow`, again and again.
import './style.css';
import {source} from './data.js';

const element = document.getElementById('cnrg-data');

/** `fresh`: it is another tree, to be looked at from the front. */
window.cnrgShow = async (base64, fresh) => {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const json = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'))).json();
  if (window.cnrg) return window.cnrg.load(json, fresh);
  source.json = json;
  return import('./main.js');
};
if (element.textContent) window.cnrgShow(element.textContent);
element.remove();
