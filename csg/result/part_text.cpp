#include "csg/result/part_text.h"

#include "csg/text/digits.h"
#include "csg/text/escape.h"
#include "kernel/exact/distance.h"

namespace cnrg {
namespace {

std::string coordinate(const Rational& x) {
  constexpr std::size_t kLongest = 17;
  std::string decimal = to_decimal(x, 12);
  if (decimal.size() <= kLongest && parse_rational(decimal) == x) return decimal;
  if (const std::string fraction = to_string(x); fraction.size() <= kLongest) return fraction;
  return "~" + decimal;
}

}  // namespace

std::string names_of_leaves(const ResultView& view, const FlatComplex::Provenance& origin) {
  std::string text;
  for (const LeafId leaf : origin.leaves) {
    text += text.empty() ? "" : ", ";
    text += leaf.index() < view.leaves->size() ? (*view.leaves)[leaf.index()].name : std::string("?");
  }
  return text.empty() ? "nothing active" : shown(text);
}

std::string name_of(const Parts::Cell& cell) { return "vef"[cell.dimension] + std::to_string(cell.number); }

const FlatComplex::Provenance& origin_of(const FlatComplex& flat, const Parts::Cell& cell) {
  return cell.dimension == 0   ? flat.vertices[cell.number].origin
         : cell.dimension == 1 ? flat.edges[cell.number].origin
                               : flat.faces[cell.number].origin;
}

std::array<Parts::Cell, 2> cells_of(const Parts& parts, Near kind, Parts::Index a, Parts::Index b) {
  switch (kind) {
    case Near::points: return {parts.cell_of_point(a), parts.cell_of_point(b)};
    case Near::point_segment: return {parts.cell_of_point(a), parts.cell_of_segment(b)};
    case Near::point_facet: return {parts.cell_of_point(a), parts.cell_of_facet(b)};
    default: return {parts.cell_of_segment(a), parts.cell_of_segment(b)};
  }
}

std::string text_of(const ResultView& view, const Parts& parts, Near kind, Parts::Index a, Parts::Index b,
                    bool numbered) {
  const auto cells = cells_of(parts, kind, a, b);
  constexpr std::array<std::array<const char*, 2>, 4> kWords{
      {{"point", "point"}, {"point", "edge"}, {"point", "face"}, {"edge", "edge"}}};
  std::string text;
  for (std::size_t i = 0; i < 2; ++i) {
    text += (i == 0 ? "" : " and ") + std::string(kWords[std::size_t(kind)][i]);
    if (numbered) text += " " + name_of(cells[i]);
    text += " of " + names_of_leaves(view, origin_of(parts.flat(), cells[i]));
  }
  return text;
}

std::string coordinates(const RationalPoint& p) {
  return "(" + coordinate(p[0]) + ", " + coordinate(p[1]) + ", " + coordinate(p[2]) + ")";
}

std::string distance_text(const Rational& squared) { return double_text(nearest_root(squared)); }

}  // namespace cnrg
