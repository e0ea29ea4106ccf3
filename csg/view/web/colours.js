// Colours that people with any colour vision tell apart (Okabe and Ito 2008), then the same lighter and darker.

const BASE = ['#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#f0e442', '#0072b2', '#d55e00'];

export const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));
export const hex = (c) => '#' + c.map((x) => Math.round(x).toString(16).padStart(2, '0')).join('');
export const mix = (a, b, t) => a.map((x, k) => x + (b[k] - x) * t);

/** The i-th colour of solids: soft, so that edges and what is picked stand out. */
export function colour(i) {
  const base = rgb(BASE[i % BASE.length]), round = Math.floor(i / BASE.length) % 3;
  return mix(base, round === 2 ? [40, 40, 50] : [255, 255, 255], [0.22, 0.55, 0.32][round]);
}

export const SHEET = rgb('#d55e00');
export const WIRE = rgb('#a5460a');
export const POINT = rgb('#a5460a');
export const NONE = [176, 180, 186];

/** Where an entity lay with respect to the other operand. */
export const RELATIONS = {
  AinB: rgb('#0072b2'), BinA: rgb('#56b4e9'), INTERS: rgb('#e69f00'), AoutB: rgb('#009e73'), BoutA: rgb('#cc79a7'), '': NONE,
};
