// Unpacks LZMA, as `xz --format=lzma` packs it where places do not count (lp=0, pb=0): a third less than by deflate, and unknown to
// browsers.
//
// What is packed is a row of decisions between 0 and 1. Each has a chance of its own, which learns from every answer; a range
// coder makes one long number of them all. They tell bytes, by the byte before, and copies: of how many bytes, from how far
// back, or from as far as one of the last four.

const HEAD = 13, LEARNING = 5, WHOLE = 11, STATES = 12;

class Decisions {
  constructor(packed) {
    this.packed = packed;
    this.at = HEAD + 5;
    this.range = 0xffffffff;
    this.code = new DataView(packed.buffer, packed.byteOffset).getUint32(HEAD + 1);
  }
  more() {
    if (this.range >= 0x1000000) return;
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.packed[this.at++]) >>> 0;
  }
  next(chances, i) {
    const chance = chances[i], bound = (this.range >>> WHOLE) * chance, one = this.code >= bound;
    if (one) {
      this.range -= bound;
      this.code -= bound;
      chances[i] -= chance >> LEARNING;
    } else {
      this.range = bound;
      chances[i] += ((1 << WHOLE) - chance) >> LEARNING;
    }
    this.more();
    return one ? 1 : 0;
  }
  /** A number of so many bits, the highest first, whose chances begin at `from`. */
  number(chances, from, count) {
    let node = 1;
    for (let k = 0; k < count; ++k) node = (node << 1) | this.next(chances, from + node);
    return node - (1 << count);
  }
  /** The same, the lowest first. */
  reversed(chances, from, count) {
    let node = 1, value = 0;
    for (let k = 0; k < count; ++k) {
      const bit = this.next(chances, from + node);
      node = (node << 1) | bit;
      value |= bit << k;
    }
    return value;
  }
  /** The same, the highest first, of even chances. */
  even(count) {
    let value = 0;
    for (let k = 0; k < count; ++k) {
      this.range >>>= 1;
      const one = this.code >= this.range;
      if (one) this.code -= this.range;
      value = (value << 1) | (one ? 1 : 0);
      this.more();
    }
    return value;
  }
}

const even = (count) => new Uint16Array(count).fill(1 << (WHOLE - 1));

/** How many bytes are copied, less 2. */
class Lengths {
  chances = even(2 + 2 * 8 + 256);
  next(decisions) {
    const {chances} = this;
    if (!decisions.next(chances, 0)) return decisions.number(chances, 2, 3);
    if (!decisions.next(chances, 1)) return 8 + decisions.number(chances, 2 + 8, 3);
    return 16 + decisions.number(chances, 2 + 2 * 8, 8);
  }
}

/** How far back a copy begins, less 1. */
class Distances {
  slots = even(4 * 64);
  middle = even(128);
  low = even(16);
  next(decisions, length) {
    const slot = decisions.number(this.slots, 64 * Math.min(length, 3), 6), bits = (slot >> 1) - 1;
    if (slot < 4) return slot;
    const first = (2 | (slot & 1)) << bits;
    if (slot < 14) return first + decisions.reversed(this.middle, first - slot, bits);
    return first + (decisions.even(bits - 4) << 4) + decisions.reversed(this.low, 0, 4);
  }
}

/** The bytes that were packed; the head tells how many, and how many bits of the byte before count. */
export function unpacked(packed) {
  const size = new DataView(packed.buffer, packed.byteOffset).getUint32(5, true), out = new Uint8Array(size), before = packed[0];
  const decisions = new Decisions(packed), bytes = even(0x300 << before), lengths = new Lengths(), again = new Lengths(), distances = new Distances();
  const copies = even(STATES), repeats = even(STATES), others = [even(STATES), even(STATES), even(STATES)], longs = even(STATES);
  const back = [0, 0, 0, 0];  // the last distances, less 1
  let state = 0, at = 0;      // the state tells what the last few were

  function byte() {
    const from = 0x300 * (at > 0 ? out[at - 1] >> (8 - before) : 0);
    let node = 1;
    if (state >= 7) {  // after a copy: beside the byte that would have gone on with it
      let expected = out[at - back[0] - 1], alike = true;
      while (alike && node < 0x100) {
        const bit = (expected >> 7) & 1;
        expected <<= 1;
        node = (node << 1) | decisions.next(bytes, from + ((1 + bit) << 8) + node);
        alike = (node & 1) === bit;
      }
    }
    while (node < 0x100) node = (node << 1) | decisions.next(bytes, from + node);
    out[at++] = node;
    state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
  }
  function copy(length) {
    for (const end = Math.min(size, at + length); at < end; ++at) out[at] = out[at - back[0] - 1];
  }

  while (at < size) {
    if (!decisions.next(copies, state)) {
      byte();
    } else if (!decisions.next(repeats, state)) {
      const length = lengths.next(decisions);
      back.unshift(distances.next(decisions, length));
      back.pop();
      state = state < 7 ? 7 : 10;
      copy(length + 2);
    } else {
      let which = 0;
      while (which < 3 && decisions.next(others[which], state)) ++which;
      if (which === 0 && !decisions.next(longs, state)) {
        state = state < 7 ? 9 : 11;
        copy(1);
        continue;
      }
      back.unshift(...back.splice(which, 1));
      const length = again.next(decisions);
      state = state < 7 ? 8 : 11;
      copy(length + 2);
    }
  }
  return out;
}
