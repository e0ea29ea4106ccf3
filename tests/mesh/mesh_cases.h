// Results for meshers: regions with walls, holes and cavities, and what hangs in them.
#pragma once

#include "tests/formats/cases.h"

namespace cnrg::test {

/// Two boxes with a wall between them; a sheet and a point in the first, a wire of two pieces in the second.
inline Case two_regions() {
  Soup soup;
  add_box(soup, {0, 0, 0}, {2, 2, 2});
  add_box(soup, {2, 0, 0}, {4, 2, 2});
  add_sheet(soup, {{Rational(1, 2), Rational(1, 2), 1},
                   {Rational(3, 2), Rational(1, 2), 1},
                   {Rational(3, 2), Rational(3, 2), 1},
                   {Rational(1, 2), Rational(3, 2), 1}});
  add_wire(soup, {3, 1, Rational(1, 2)}, {3, 1, Rational(3, 2)});
  add_point(soup, {1, 1, Rational(3, 2)});
  Case c(soup, {{{"rock", "granite", {}}}, {{"seam", "ore", {}}}});
  c.materials = {{"granite", ""}, {"ore", ""}};
  c.show(c.unite(Dominance::right));
  return c;
}

/// Leaf 0 without leaf 1.
inline void subtract(Case& c) {
  c.show(boolean_operation(*c.complex, BooleanOp::subtract, Dominance::equal, c.leaves[0], c.leaves[1]).group);
}

/// A box with a bore through it.
inline Case ring() {
  Soup soup;
  add_box(soup, {0, 0, 0}, {3, 3, 3});
  add_box(soup, {1, 1, -1}, {2, 2, 4});
  Case c(soup);
  subtract(c);
  return c;
}

/// A shell around a cavity with a block in it.
inline Case nested() {
  Soup soup;
  add_box(soup, {0, 0, 0}, {9, 9, 9});
  add_box(soup, {1, 1, 1}, {8, 8, 8});
  add_box(soup, {3, 3, 3}, {5, 5, 5});
  Case c(soup, {{{"shell", "", {}}}, {}, {{"block", "", {}}}});
  const Group shell =
      boolean_operation(*c.complex, BooleanOp::subtract, Dominance::equal, c.leaves[0], c.leaves[1]).group;
  c.show(boolean_operation(*c.complex, BooleanOp::unite, Dominance::equal, shell, c.leaves[2]).group);
  return c;
}

/// Two cubes with a common edge.
inline Case hinge() {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {1, 1, 0}, {2, 2, 1});
  Case c(soup);
  c.show(c.unite());
  return c;
}

/// A box that a sheet and a wire go through and beyond; a point away from it; a wire on its side.
inline Case pierced() {
  Soup soup;
  add_box(soup, {0, 0, 0}, {3, 3, 3});
  add_sheet(soup, {{-1, 1, 1}, {5, 1, 1}, {5, 2, 1}, {-1, 2, 1}});
  add_wire(soup, {Rational(3, 2), Rational(3, 2), -2}, {2, 2, 5});
  add_point(soup, {7, 7, 7});
  add_wire(soup, {3, 1, Rational(5, 2)}, {3, 2, Rational(5, 2)});
  Case c(soup);
  c.show(c.unite(Dominance::right));
  return c;
}

/// A drum with 12 sides cut by an oblique plane through a block: corners that no double holds.
inline Case oblique() {
  Soup soup;
  add_drum(soup, 12, 0, 10);
  const LeafId block = soup.add_leaf(Fill::winding);
  const RationalPoint corners[] = {{-20, -20, 3}, {20, -20, 4}, {-20, 20, 5}, {0, 0, 40}};
  std::vector<PointId> p;
  for (const auto& corner : corners) p.push_back(soup.add_point(corner));
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::uint32_t number = 0;
  for (const auto& f : faces) {
    soup.add_triangle(block, p[std::size_t(f[0])], p[std::size_t(f[1])], p[std::size_t(f[2])], number, number);
    ++number;
  }
  Case c(soup, {{{"low", "", {}}}, {{"high", "", {}}}});
  c.show(c.unite(Dominance::left));
  return c;
}

}  // namespace cnrg::test
