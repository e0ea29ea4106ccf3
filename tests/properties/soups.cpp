// Random soups of mixed dimension on tiny grids, where everything touches everything, against Nef polyhedra.
//
// No leaf is a solid here: triangles, polygons, wires and points in any position, in any number of leaves. The
// union of all cells of dimension up to 2 must be the union of the parts, and the cavities must be as many.
#include <catch2/catch.hpp>

#include "tests/properties/evaluation.h"
#include "tests/properties/nef_oracle.h"
#include "tests/scenes/measure.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using scenes::Leaf;
using scenes::Random;

RationalPoint grid_point(Random& random, int size) {
  return {random.between(0, size), random.between(0, size), random.between(0, size)};
}

bool collinear(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    if ((b[k] - a[k]) * (c[i] - a[i]) != (b[i] - a[i]) * (c[k] - a[k])) return false;
  }
  return true;
}

std::vector<Leaf> random_soup(std::uint64_t seed, int parts, int size) {
  Random random(seed);
  std::vector<Leaf> leaves(1 + static_cast<std::size_t>(random.below(3)));
  for (Leaf& leaf : leaves) leaf.fill = random.one_in(2) ? Fill::none : Fill::cells;
  for (int i = 0; i < parts; ++i) {
    Leaf& leaf = leaves[static_cast<std::size_t>(random.below(static_cast<int>(leaves.size())))];
    const RationalPoint a = grid_point(random, size), b = grid_point(random, size), c = grid_point(random, size);
    switch (random.below(8)) {
      case 0: leaf.points.push_back(a); break;
      case 1:
      case 2:
        if (a != b) leaf.wires.push_back({a, b});
        break;
      case 3: {  // a parallelogram, which may stick out of the grid
        if (collinear(a, b, c)) break;
        RationalPoint d;
        for (int k = 0; k < 3; ++k) d[k] = a[k] + c[k] - b[k];
        scenes::add_sheet(leaf, {{a, b, c, d}});
        break;
      }
      default:
        if (!collinear(a, b, c)) scenes::add_sheet(leaf, {{a, b, c}});
        break;
    }
  }
  if (random.one_in(2)) {
    const scenes::Motion turn = scenes::Motion::rotation(3, random.between(1, 3), random.between(-2, 2), -1);
    for (Leaf& leaf : leaves) apply(turn, leaf);
  }
  return leaves;
}

/// All cells up to dimension 2, as a group without regions.
Group walls(const Complex& c) {
  Group g;
  for (const FaceId f : IdRange<FaceId>(c.face_count())) g.faces.push_back(f);
  for (const EdgeId e : IdRange<EdgeId>(c.edge_count())) g.edges.push_back(e);
  g.vertices = c.vertices;
  return g;
}

/// Soups on which Nef itself failed.
std::uint64_t oracle_failures = 0;

std::string failure_of(const std::vector<Leaf>& leaves) try {
  const auto built_c = build_complex(scenes::make_soup(leaves));
  const Complex& c = *built_c;
  if (std::string f = cnrg::validate(c); !f.empty()) return "the complex is not valid: " + f;
  std::vector<NefSet> sets;
  for (const Leaf& leaf : leaves) sets.push_back(NefSet::leaf(leaf));
  const NefSet all = NefSet::unite_all(std::move(sets));
  const Skeleton ours = skeleton(c, walls(c)), theirs = all.skeleton();
  if (std::string f = difference(ours, theirs); !f.empty()) return "ours first, then Nef's:\n" + f;
  // Filled, cavity by cavity: all bounded regions of ours and of Nef.
  std::vector<RationalPoint> inside;
  Rational volume = 0;
  for (const RegionId r : IdRange<RegionId>(c.region_count)) {
    if (c.unbounded(r)) continue;
    inside.push_back(scenes::point_in(c, r));
    volume += scenes::volume(c, r);
  }
  if (!inside.empty() && all.fill(inside).volume() != volume) return "the cavities have another volume";
  return {};
} catch (const OracleFailure&) {
  ++oracle_failures;
  return {};
} catch (const std::exception& error) {
  return std::string("thrown: ") + error.what();
}

/// Drops parts while it still fails.
std::vector<Leaf> shrink(std::vector<Leaf> leaves) {
  const auto try_without = [&](auto&& part_of) {
    for (std::size_t l = 0; l < leaves.size(); ++l)
      for (std::size_t i = part_of(leaves[l]).size(); i > 0; --i) {
        std::vector<Leaf> less = leaves;
        auto& list = part_of(less[l]);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i - 1));
        if (!failure_of(less).empty()) leaves = std::move(less);
      }
  };
  for (int round = 0; round < 2; ++round) {
    try_without([](Leaf & leaf) -> auto& { return leaf.faces; });
    try_without([](Leaf & leaf) -> auto& { return leaf.wires; });
    try_without([](Leaf & leaf) -> auto& { return leaf.points; });
  }
  return leaves;
}

void run(int parts, int size, std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  oracle_failures = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const std::vector<Leaf> leaves = random_soup(seed, parts, size);
    const std::string failure = failure_of(leaves);
    if (failure.empty()) {
      SUCCEED();
      continue;
    }
    scenes::Scene least{shrink(leaves), scenes::leaf_expression(0)};
    FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << failure_of(least.leaves) << "\n"
                       << scenes::tree_file(least));
  }
  INFO(oracle_failures << " soups on which Nef itself failed");
  CHECK(oracle_failures <= 1 + (last - first) / 100);
}

}  // namespace

TEST_CASE("A few parts on a tiny grid", "[soups]") { run(6, 2, 60); }
TEST_CASE("Parts on a small grid", "[soups]") { run(10, 3, 40); }
TEST_CASE("Many parts on a grid", "[soups]") { run(16, 6, 8); }

}  // namespace cnrg::properties
