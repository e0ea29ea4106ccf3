// Bytes as letters of a page in UTF-16, 15 bits in each 16; base64 has 12. Letters from U+3000 to U+AFFF mean nothing to HTML,
// and a file that begins with a byte order mark is read as UTF-16, whatever a server says of it.
const FIRST = 0x3000, BITS = 15;

/** Fills `out` with numbers of `to` bits, which are the `count` numbers of `from` bits that `of` gives; the rest is zeros. */
function regroup(out, to, count, from, of) {
  let held = 0, bits = 0, next = 0;
  for (let i = 0; i < out.length; ++i) {
    for (; bits < to; bits += from) held = (held << from) | (next < count ? of(next++) : 0);
    out[i] = held >> (bits -= to);
    held &= (1 << bits) - 1;
  }
  return out;
}
export const lettersOf = (bytes) => Array.from(regroup(new Uint16Array(Math.ceil(8 * bytes.length / BITS)), BITS, bytes.length, 8, (i) => bytes[i]), (n) => String.fromCharCode(n + FIRST)).join('');
export const bytesOf = (letters) => regroup(new Uint8Array(Math.floor(BITS * letters.length / 8)), 8, letters.length, BITS, (i) => letters.charCodeAt(i) - FIRST);
