// What the page has as it stands: unpacks all else, texts and then the program, and begins.
import {bytesOf} from './letters.js';
import {unpacked} from './unpack.js';

const packed = document.getElementById('packed'), bytes = unpacked(bytesOf(packed.textContent)), end = bytes.indexOf(0);
packed.remove();
window.carried = {...JSON.parse(new TextDecoder().decode(bytes.subarray(0, end))), program: bytes.subarray(end + 1)};
document.body.append(Object.assign(document.createElement('script'), {textContent: window.carried.script}));
