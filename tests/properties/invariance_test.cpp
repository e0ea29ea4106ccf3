// What must not change the answer: order of input, exact motion and scale, number of threads; and of the laws of
// set algebra those that groups have cell by cell. As point sets groups have the others, too: each evaluated
// Boolean is held against its definition (csg/operators/identities.h).
#include <algorithm>
#include <numeric>

#include "tests/catch.h"
#include "tests/oracles/evaluation.h"
#include "tests/scenes/measure.h"
#include "tests/scenes/same_arrays.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using scenes::Leaf;
using scenes::Position;

constexpr std::array kPositions{Position::general, Position::degenerate, Position::tilted};

std::shared_ptr<const Complex> build(const std::vector<Leaf>& leaves, const scenes::SoupOptions& options = {},
                                     int threads = 0) {
  const auto c = build_complex(scenes::make_soup(leaves, options), {.threads = threads});
  REQUIRE(cnrg::validate(*c) == "");
  return c;
}

template <class Check>
void for_each_scene(std::uint64_t usual, int leaf_count, Check check) {
  const auto [first, last] = scenes::seeds(usual);
  for (std::uint64_t seed = first; seed < last; ++seed)
    for (const Position position : kPositions) {
      const std::vector<Leaf> leaves = scenes::random_leaves(seed + 10000, leaf_count, position);
      INFO("seed " << seed << ", position " << static_cast<int>(position) << "\n" << scenes::tree_file(leaves));
      check(leaves, seed);
    }
}

/// The cells of a group, without what is said of its regions; regions as sets of cells.
struct Cells {
  std::vector<std::vector<RegionId>> regions;
  std::vector<FaceId> faces;
  std::vector<EdgeId> edges;
  std::vector<VertexId> vertices;
  friend bool operator==(const Cells&, const Cells&) = default;
};

Cells cells(const Group& g) {
  Cells result{std::vector<std::vector<RegionId>>(g.regions.size()), g.faces, g.edges, g.vertices};
  for (const auto& [cell, region] : g.cells) result.regions.at(region - 1).push_back(cell);
  std::sort(result.regions.begin(), result.regions.end());
  return result;
}

}  // namespace

TEST_CASE("Order of input, exact motions and scales change no count and no volume", "[invariance]") {
  for_each_scene(25, 4, [](const std::vector<Leaf>& leaves, std::uint64_t seed) {
    const auto plain = build(leaves);
    const auto same = [&](const std::vector<Leaf>& others, const scenes::SoupOptions& options,
                          const Rational& volume_factor) {
      const auto other = build(others, options);
      CHECK(other->vertex_count() == plain->vertex_count());
      CHECK(other->edge_count() == plain->edge_count());
      CHECK(other->face_count() == plain->face_count());
      CHECK(other->region_count == plain->region_count);
      std::vector<Rational> volumes = scenes::volumes(*plain);
      for (Rational& v : volumes) v *= volume_factor;
      CHECK((scenes::volumes(*other) == volumes));
      return other;
    };
    scenes::Random random(seed);
    scenes::SoupOptions options;
    options.share_points = false;
    options.reverse_faces = true;
    options.order.resize(leaves.size());
    std::iota(options.order.begin(), options.order.end(), std::size_t{0});
    for (std::size_t i = options.order.size(); i > 1; --i)
      std::swap(options.order[i - 1], options.order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    same(leaves, options, 1);
    scenes::Motion motion = scenes::Motion::rotation(2, 1, static_cast<int>(seed % 3), -1);
    motion.offset = {Rational(1, 3), Rational(-5, 7), 1000};
    std::vector<Leaf> moved = leaves;
    apply_to_all(motion, moved);
    same(moved, {}, 1);
    for (const int exponent : {900, -900}) {  // a power of two changes no decision
      Rational factor = 1;
      if (exponent > 0) mpq_mul_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<unsigned>(exponent));
      else mpq_div_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<unsigned>(-exponent));
      std::vector<Leaf> scaled = leaves;
      apply_to_all(scenes::Motion::scaling(factor), scaled);
      CHECK(same(scaled, {}, factor * factor * factor)->loop.values() == plain->loop.values());
    }
  });
}

TEST_CASE("The number of threads changes no byte", "[invariance]") {
  for_each_scene(25, 6, [](const std::vector<Leaf>& leaves, std::uint64_t) {
    const auto built_one = build(leaves, {}, 1);
    const Complex& one = *built_one;
    CHECK(scenes::same_arrays(one, *build(leaves, {}, 2)));
    CHECK(scenes::same_arrays(one, *build(leaves, {}, 0)));
  });
  // Large enough that threads share the work.
  std::vector<Leaf> many;
  scenes::Random random(7);
  for (int i = 0; i < 150; ++i) {
    const RationalPoint low{random.below(12), random.below(12), random.below(12)};
    many.push_back(
        scenes::solid_leaf(scenes::box_solid(low, {low[0] + 3, low[1] + 3, low[2] + 3}), Fill::winding));
  }
  const auto built_one = build(many, {}, 1);
  const Complex& one = *built_one;
  for (const int threads : {2, 3, 8}) CHECK(scenes::same_arrays(one, *build(many, {}, threads)));
}

TEST_CASE("Idempotence", "[invariance]") {
  for_each_scene(20, 2, [](const std::vector<Leaf>& leaves, std::uint64_t) {
    const auto built_c = build(leaves);
    const Complex& c = *built_c;
    for (const Group& g : leaf_groups(c)) {
      for (const Dominance d : {Dominance::left, Dominance::right, Dominance::equal}) {
        CHECK((cells(boolean_operation(c, BooleanOp::unite, d, g, g).group) == cells(g)));
        CHECK((cells(boolean_operation(c, BooleanOp::intersect, d, g, g).group) == cells(g)));
      }
      const Group nothing = boolean_operation(c, BooleanOp::subtract, Dominance::equal, g, g).group;
      CHECK(nothing.cells.empty());
      CHECK(nothing.faces.empty());
      CHECK(nothing.edges.empty());
      CHECK(nothing.vertices.empty());
    }
  });
}

TEST_CASE("Union and intersection are commutative", "[invariance]") {
  for_each_scene(25, 2, [](const std::vector<Leaf>& leaves, std::uint64_t) {
    const auto built_c = build(leaves);
    const Complex& c = *built_c;
    const std::vector<Group> g = leaf_groups(c);
    for (const BooleanOp op : {BooleanOp::unite, BooleanOp::intersect}) {
      CHECK((cells(boolean_operation(c, op, Dominance::equal, g[0], g[1]).group) ==
             cells(boolean_operation(c, op, Dominance::equal, g[1], g[0]).group)));
      CHECK((cells(boolean_operation(c, op, Dominance::left, g[0], g[1]).group) ==
             cells(boolean_operation(c, op, Dominance::right, g[1], g[0]).group)));
    }
  });
}

}  // namespace cnrg::properties
