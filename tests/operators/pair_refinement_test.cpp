// The cells that two operands make of each other: as many as they have when nothing else is there.
#include "csg/operators/pair_refinement.h"

#include <algorithm>
#include <random>

#include "kernel/base/sorted.h"
#include "tests/catch.h"
#include "tests/operators/pieces.h"

namespace cnrg {
namespace {

using namespace pieces;
using PairCounts = std::array<std::size_t, 3>;

template <class IdT>
std::vector<IdT> of_both(std::vector<IdT> a, const std::vector<IdT>& b) {
  a.insert(a.end(), b.begin(), b.end());
  sort_unique(a);
  return a;
}

/// How many cells by dimension the first two leaves make of each other.
PairCounts cells_of_pair(const Complex& complex) {
  const std::vector<Group> leaves = leaf_groups(complex);
  PairRefinement pair(complex);
  pair.refine(leaves[0], leaves[1]);
  const auto count = [&](const auto& a, const auto& b) {
    const auto both = of_both(a, b);
    return static_cast<std::size_t>(
        std::count_if(both.begin(), both.end(), [&](auto cell) { return pair.is_first(cell); }));
  };
  return {count(leaves[0].vertices, leaves[1].vertices), count(leaves[0].edges, leaves[1].edges),
          count(leaves[0].faces, leaves[1].faces)};
}

/// How many entities the two have as pieces of the complex.
PairCounts pieces_of_pair(const Complex& complex) {
  const std::vector<Group> leaves = leaf_groups(complex);
  return {of_both(leaves[0].vertices, leaves[1].vertices).size(), of_both(leaves[0].edges, leaves[1].edges).size(),
          of_both(leaves[0].faces, leaves[1].faces).size()};
}

/// The last vertex at a point.
VertexId vertex_at(const Complex& complex, const Point& at) {
  for (const VertexId v : IdRange<VertexId>(complex.points.size())) {
    if (complex.points.rational(v) == RationalPoint{at[0], at[1], at[2]}) return v;
  }
  return VertexId::none();
}

TEST_CASE("sheets that overlap: cuts of a third one are in their faces and edges", "[pair]") {
  const Piece a = sheet({0, 0, 0}, {4, 4, 0}), b = sheet({2, 0, 0}, {6, 4, 0}),
              knife = sheet({3, -1, -1}, {3, 9, 1});
  const auto alone = complex_of({a, b}), cut = complex_of({a, b, knife, wire({5, 1, 0}, {5, 1, 3})});
  CHECK(cells_of_pair(*alone) == PairCounts{8, 10, 3});
  CHECK(cells_of_pair(*cut) == PairCounts{8, 10, 3});
  const std::vector<Group> leaves = leaf_groups(*cut);
  PairRefinement pair(*cut);
  pair.refine(leaves[0], leaves[1]);
  CHECK(pair.place(vertex_at(*cut, {0, 0, 0})).dimension == 0);
  CHECK(pair.place(vertex_at(*cut, {3, 0, 0})).dimension == 1);
  CHECK(pair.place(vertex_at(*cut, {5, 1, 0})).dimension == 2);
  CHECK(pair.place(vertex_at(*cut, {5, 1, 0})).face != pair.place(leaves[0].faces.front()).face);
}

TEST_CASE("where a wire ends in a face, passes through it, or lies in it, they meet", "[pair]") {
  const Piece floor = sheet({0, 0, 0}, {4, 4, 0});
  const Piece knives = sheet({-1, 2, -1}, {9, 2, 1}) + sheet({2, -1, -1}, {2, 9, 1});
  const auto counts = [&](const Piece& wires) { return cells_of_pair(*complex_of({floor, wires, knives})); };
  CHECK(counts(wire({2, 2, 0}, {2, 2, 3})) == PairCounts{6, 5, 1});   // ends where the knives cross
  CHECK(counts(wire({2, 2, -3}, {2, 2, 3})) == PairCounts{7, 6, 1});  // passes through there
  CHECK(counts(wire({1, 2, 0}, {3, 2, 0})) == PairCounts{6, 5, 1});   // lies in one of the cuts
  CHECK(counts(wire({1, 2, 1}, {3, 2, 1})) == PairCounts{6, 5, 1});   // lies above
  CHECK(counts(wire({-1, 2, 0}, {5, 2, 0})) == PairCounts{8, 9, 2});  // parts the floor
}

TEST_CASE("random leaves make as many cells of each other beside others as alone", "[pair]") {
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
    const auto leaf = [&] {
      const Point low{number(0, 3), number(0, 3), number(0, 3)};
      Point high = low;
      for (int& x : high) x += number(1, 3);
      const int axis = number(0, 2), along = (axis + 1) % 3;
      if (number(0, 2) == 0) return box(low, high);
      if (number(0, 3) == 0) {
        high[0] = low[0] + 2;
        return parted_box(low, high, low[0] + 1, 1) + point({number(0, 6), number(0, 6), number(0, 6)});
      }
      if (number(0, 3) == 0) high[static_cast<std::size_t>(along)] = low[static_cast<std::size_t>(along)];
      high[static_cast<std::size_t>(axis)] = low[static_cast<std::size_t>(axis)];
      return low[static_cast<std::size_t>(along)] == high[static_cast<std::size_t>(along)]
                 ? wire(low, high) + point({number(0, 5), number(0, 5), number(0, 5)})
                 : sheet(low, high);
    };
    std::vector<Piece> leaves{leaf(), leaf()};
    const auto alone = complex_of(leaves);
    for (int i = number(1, 4); i > 0; --i) leaves.push_back(leaf());
    INFO("seed " << seed);
    CHECK(cells_of_pair(*alone) == pieces_of_pair(*alone));
    CHECK(cells_of_pair(*complex_of(leaves)) == pieces_of_pair(*alone));
  }
}

}  // namespace
}  // namespace cnrg
