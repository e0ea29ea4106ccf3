// Colors are bytes here. Which one a cell has was decided when the page was made (csg/result/palette.h).

export const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));
export const hex = (c) => '#' + c.map((x) => Math.round(x).toString(16).padStart(2, '0')).join('');
export const mix = (a, b, t) => a.map((x, k) => x + (b[k] - x) * t);

/** The colors of a page: those with a fixed meaning by name, and those of cells. */
export class Colors {
  constructor({fixed_colors: fixed, source_colors, colors}, unpack) {
    for (const name of ['sheet', 'wire', 'point', 'none']) this[name] = rgb(fixed[name]);
    /** Where an entity lay with respect to the other operand. */
    this.relations = Object.fromEntries(Object.entries(fixed.relations).map(([name, c]) => [name, rgb(c)]));
    this.all = colors.map(rgb);
    this.sources = unpack(source_colors);
  }
}
