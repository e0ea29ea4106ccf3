// What must not change the answer: order of input, exact rigid motion, number of threads; and the laws of set
// algebra as far as groups have them (csg/SEMANTICS.md#identities).
#include <algorithm>
#include <numeric>

#include "tests/catch.h"
#include "tests/oracles/evaluation.h"
#include "tests/scenes/measure.h"
#include "tests/scenes/same_arrays.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using scenes::Position;
using scenes::Scene;

constexpr std::array kPositions{Position::general, Position::degenerate, Position::tilted};

/// Cell counts by dimension, volumes of all regions, and the result of the tree: all that order may not change.
struct Summary {
  std::array<std::size_t, 4> cells{};
  std::vector<Rational> volumes;
  Rational result_volume;
  std::size_t result_regions = 0, result_faces = 0, result_edges = 0, result_vertices = 0;
  std::array<std::size_t, 4> simplified{};
  friend bool operator==(const Summary&, const Summary&) = default;
};

std::shared_ptr<const Complex> build(const std::vector<scenes::Leaf>& leaves,
                                     const scenes::SoupOptions& options = {}, int threads = 0) {
  const auto c = build_complex(scenes::make_soup(leaves, options), {.threads = threads});
  REQUIRE(cnrg::validate(*c) == "");
  return c;
}

Summary summary(const Scene& scene, const scenes::SoupOptions& options = {}) {
  const auto built_c = build(scene.leaves, options);
  const Complex& c = *built_c;
  const std::vector<Group> by_id = leaf_groups(c);
  std::vector<Group> groups = by_id;  // by the scene's own numbers
  for (std::size_t i = 0; i < options.order.size(); ++i) groups[options.order[i]] = by_id[i];
  const Group g = evaluate(c, groups, *scene.root);
  const SimplifiedComplex s = simplify(c, selection_of(c, g), g.features);
  return {{c.vertex_count(), c.edge_count(), c.face_count(), c.region_count},
          scenes::volumes(c),
          volume(c, g),
          g.regions.size(),
          g.faces.size(),
          g.edges.size(),
          g.vertices.size(),
          active_counts(s)};
}

template <class Check>
void for_each_scene(std::uint64_t usual, int leaf_count, Check check) {
  const auto [first, last] = scenes::seeds(usual);
  for (std::uint64_t seed = first; seed < last; ++seed)
    for (const Position position : kPositions) {
      const Scene scene = scenes::random_scene(seed + 10000, leaf_count, position);
      INFO("seed " << seed << ", position " << static_cast<int>(position) << "\n" << scenes::tree_file(scene));
      check(scene, seed);
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

TEST_CASE("The order of leaves, faces and points does not matter", "[invariance]") {
  for_each_scene(25, 4, [](const Scene& scene, std::uint64_t seed) {
    const Summary plain = summary(scene);
    scenes::Random random(seed);
    scenes::SoupOptions options;
    options.share_points = false;
    options.reverse_faces = true;
    options.order.resize(scene.leaves.size());
    std::iota(options.order.begin(), options.order.end(), std::size_t{0});
    for (std::size_t i = options.order.size(); i > 1; --i)
      std::swap(options.order[i - 1], options.order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    CHECK((summary(scene, options) == plain));
  });
}

TEST_CASE("An exact rigid motion changes neither counts nor volumes", "[invariance]") {
  for_each_scene(25, 4, [](const Scene& scene, std::uint64_t seed) {
    const Summary plain = summary(scene);
    scenes::Motion motion = scenes::Motion::rotation(2, 1, static_cast<int>(seed % 3), -1);
    motion.offset = {Rational(1, 3), Rational(-5, 7), 1000};
    Scene moved = scene;
    apply(motion, moved);
    CHECK((summary(moved) == plain));
  });
}

TEST_CASE("A power of two as factor changes no decision", "[invariance]") {
  for_each_scene(15, 3, [](const Scene& scene, std::uint64_t) {
    const auto built_plain = build(scene.leaves);
    const Complex& plain = *built_plain;
    for (const int exponent : {900, -900}) {
      Rational factor = 1;
      if (exponent > 0) mpq_mul_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<unsigned>(exponent));
      else mpq_div_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<unsigned>(-exponent));
      Scene scaled = scene;
      apply(scenes::Motion::scaling(factor), scaled);
      const auto built_c = build(scaled.leaves);
      const Complex& c = *built_c;
      CHECK(c.vertex_count() == plain.vertex_count());
      CHECK(c.edge_count() == plain.edge_count());
      CHECK(c.face_count() == plain.face_count());
      CHECK(c.region_count == plain.region_count);
      CHECK(c.loop.values() == plain.loop.values());
    }
  });
}

TEST_CASE("The number of threads changes no byte", "[invariance]") {
  for_each_scene(25, 6, [](const Scene& scene, std::uint64_t) {
    const auto built_one = build(scene.leaves, {}, 1);
    const Complex& one = *built_one;
    CHECK(scenes::same_arrays(one, *build(scene.leaves, {}, 2)));
    CHECK(scenes::same_arrays(one, *build(scene.leaves, {}, 0)));
  });
  // Large enough that threads share the work.
  std::vector<scenes::Leaf> many;
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
  for_each_scene(20, 2, [](const Scene& scene, std::uint64_t) {
    const auto built_c = build(scene.leaves);
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
  for_each_scene(25, 2, [](const Scene& scene, std::uint64_t) {
    const auto built_c = build(scene.leaves);
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

TEST_CASE("Union and intersection are associative as point sets", "[invariance]") {
  for_each_scene(25, 3, [](const Scene& scene, std::uint64_t) {
    const auto built_c = build(scene.leaves);
    const Complex& c = *built_c;
    const std::vector<Group> g = leaf_groups(c);
    for (const BooleanOp op : {BooleanOp::unite, BooleanOp::intersect}) {
      const auto two = [&](const Group& a, const Group& b) {
        return boolean_operation(c, op, Dominance::equal, a, b).group;
      };
      CHECK((point_set(c, two(two(g[0], g[1]), g[2])) == point_set(c, two(g[0], two(g[1], g[2])))));
    }
  });
}

TEST_CASE("De Morgan's laws hold for solids", "[invariance]") {
  // cl(A - (B + C)) = cl((A - B) - C), and cl(A - B C) is the union of both differences; for solids also
  // A B = cl(complement(complement A + complement B)).
  for_each_scene(25, 3, [](const Scene& scene, std::uint64_t) {
    const auto built_c = build(scene.leaves);
    const Complex& c = *built_c;
    std::vector<Group> g = leaf_groups(c);
    for (Group& group : g) group = regularize(c, group);
    const auto set = [&](const Group& group) { return point_set(c, regularize(c, group)); };
    const auto apply_equal = [&](BooleanOp op, const Group& x, const Group& y) {
      return boolean_operation(c, op, Dominance::equal, x, y).group;
    };
    const auto unite = [&](const Group& x, const Group& y) { return apply_equal(BooleanOp::unite, x, y); };
    const auto intersect = [&](const Group& x, const Group& y) { return apply_equal(BooleanOp::intersect, x, y); };
    const auto subtract = [&](const Group& x, const Group& y) { return apply_equal(BooleanOp::subtract, x, y); };
    CHECK((set(subtract(g[0], unite(g[1], g[2]))) == set(subtract(subtract(g[0], g[1]), g[2]))));
    CHECK((set(subtract(g[0], intersect(g[1], g[2]))) == set(unite(subtract(g[0], g[1]), subtract(g[0], g[2])))));
    const Group both = complement(c, unite(complement(c, g[1]), complement(c, g[2])));
    CHECK((set(both) == set(intersect(g[1], g[2]))));
    CHECK((set(subtract(g[0], g[1])) == set(intersect(g[0], complement(c, g[1])))));
  });
}

TEST_CASE("Volumes of union and intersection add up", "[invariance]") {
  for_each_scene(25, 2, [](const Scene& scene, std::uint64_t) {
    const auto built_c = build(scene.leaves);
    const Complex& c = *built_c;
    const std::vector<Group> g = leaf_groups(c);
    const Rational operands = volume(c, g[0]) + volume(c, g[1]);
    for (const Dominance d : {Dominance::left, Dominance::right, Dominance::equal}) {
      const Rational both = volume(c, boolean_operation(c, BooleanOp::intersect, d, g[0], g[1]).group);
      CHECK(volume(c, boolean_operation(c, BooleanOp::unite, d, g[0], g[1]).group) + both == operands);
      CHECK(volume(c, boolean_operation(c, BooleanOp::subtract, d, g[0], g[1]).group) + both == volume(c, g[0]));
    }
  });
}

}  // namespace cnrg::properties
