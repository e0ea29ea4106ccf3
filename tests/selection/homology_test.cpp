// Betti numbers against elimination on random sets of cells of grids, against Alexander duality on random scenes,
// and against known topology.
#include "kernel/selection/homology.h"

#include "kernel/selection/measure.h"
#include "tests/catch.h"
#include "tests/operators/pieces.h"
#include "tests/oracles/betti.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using namespace pieces;
using namespace elimination;

TEST_CASE("betti numbers of random sets of cells are those of elimination", "[homology]") {
  const auto [begin, end] = scenes::seeds(100);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    scenes::Random random(seed);
    const int n = seed % 4 == 3 ? 5 : 4;
    const auto built_complex = random_grid(random, n);
    const Complex& complex = *built_complex;
    Neighbourhoods neighbourhoods(complex);
    BettiCounter counter(neighbourhoods);
    for (int i = 0; i < 4; ++i) {
      const CellSet set = random_set(complex, random);
      const BettiNumbers ours = counter.of(set);
      Numbers over_q;
      const Numbers over_z2 = eliminate(complex, set, n, over_q);
      CAPTURE(seed, i, n, set.vertices.size(), set.edges.size(), set.faces.size(), set.regions.size());
      REQUIRE(ours.z2 == over_z2);
      REQUIRE(ours.q == over_q);
    }
  }
}

TEST_CASE("betti numbers of sets in random scenes obey duality", "[homology]") {
  const auto [begin, end] = scenes::seeds(40);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    for (const auto position :
         {scenes::Position::general, scenes::Position::degenerate, scenes::Position::tilted}) {
      const auto built_complex = build_complex(scenes::make_soup(scenes::random_leaves(seed, 3, position)));
      const Complex& complex = *built_complex;
      Neighbourhoods neighbourhoods(complex);
      BettiCounter counter(neighbourhoods);
      scenes::Random random(seed + 7);
      for (int i = 0; i < 4; ++i) {
        const CellSet set = random_set(complex, random);
        if (set.empty()) continue;
        CAPTURE(seed, static_cast<int>(position), i);
        const BettiNumbers b = counter.of(set);
        REQUIRE(b.z2[2] == complement_pieces(complex, set) - 1);
        // Loops of a set and of its complement on the sphere are as many; the point at infinity, missing from the
        // complement in space, makes one more sphere there unless it is a piece of its own.
        const CellSet rest = subtract(all_cells(complex), set);
        const bool in = std::binary_search(set.regions.begin(), set.regions.end(), RegionId(0));
        const BettiNumbers c = counter.of(rest);
        REQUIRE(b.z2[1] == c.z2[1]);
        REQUIRE(b.z2[2] == c.z2[0] - (in ? 0 : 1));
        REQUIRE((rest.empty() || c.z2[2] == b.z2[0] - (in ? 1 : 0)));
        // A closed set has no collars to cut: cells count by themselves, as Euler and Poincare do.
        CellSet solid = closure(complex, set);
        std::erase(solid.regions, RegionId(0));
        const BettiNumbers s = counter.of(solid);
        const EulerTerms t = euler_terms(complex, solid);
        REQUIRE(s.z2 == Numbers{t.pieces, t.holes, t.cavities});
        REQUIRE(t.left() == t.right());
      }
    }
  }
}

Numbers numbers(const Complex& complex, const CellSet& set) {
  const BettiNumbers b = betti_numbers(complex, set);
  CHECK(b.q == b.z2);
  return b.z2;
}
std::vector<RegionId> labelled(const Complex& complex, std::size_t labels) {
  std::vector<RegionId> out;
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    if (r != RegionId(0) && complex.labels(r).size() == labels) out.push_back(r);
  }
  return out;
}
/// A square ring of width 1 and height 1 around a hole of 1 x 1, as a box and one to take away.
std::vector<Piece> ring(Point low) {
  return {box(low, {low[0] + 3, low[1] + 3, low[2] + 1}),
          box({low[0] + 1, low[1] + 1, low[2]}, {low[0] + 2, low[1] + 2, low[2] + 1})};
}

TEST_CASE("betti numbers of the empty set and of all space", "[homology]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {1, 1, 1}) + point({5, 5, 5})});
  const Complex& complex = *built_complex;
  CHECK(numbers(complex, {}) == Numbers{0, 0, 0});
  CHECK(numbers(complex, all_cells(complex)) == Numbers{1, 0, 0});
  CellSet outside;
  outside.regions = {RegionId(0)};
  CHECK(numbers(complex, outside) == Numbers{1, 0, 2});
}

TEST_CASE("the surface inside of a ring has the Euler characteristic 0", "[homology]") {
  const auto torus = complex_of(ring({0, 0, 0}));
  Neighbourhoods neighbourhoods(*torus);
  CHECK(inner_surfaces(*torus, labelled(*torus, 1), neighbourhoods) == std::vector<long>{0});
}

TEST_CASE("betti numbers of components and of all together", "[homology]") {
  const auto built_complex =
      complex_of({box({0, 0, 0}, {6, 6, 6}), box({2, 2, 2}, {4, 4, 4}), sheet({6, 2, 2}, {9, 4, 2})});
  const Complex& complex = *built_complex;
  Selection selection;
  selection.regions.emplace_back(labelled(complex, 1)[0], 1u);
  selection.regions.emplace_back(labelled(complex, 2)[0], 2u);
  std::sort(selection.regions.begin(), selection.regions.end());
  for (VertexId v : complex.vertices) selection.vertices.emplace_back(v, 3u);
  Neighbourhoods neighbourhoods(complex);
  BettiCounter counter(neighbourhoods);
  const auto each = betti_numbers(selection, {1, 2, 3}, counter);
  REQUIRE(each.size() == 4);
  CHECK(each[1].z2 == Numbers{1, 0, 1});
  CHECK(each[2].z2 == Numbers{1, 0, 0});
  CHECK(each[3].z2 == Numbers{static_cast<long>(complex.vertex_count()), 0, 0});
  // Both open regions have the inner corners in their closures; the outer corners of the sheet are alone.
  CHECK(each[0].z2[0] == 3);
}

/// Planes z = 0 and x = 0 and a box across both, in a frame.
std::shared_ptr<const Complex> framed() {
  Soup soup;
  const auto quad = [&](LeafId leaf, std::uint32_t number, std::array<std::array<int, 3>, 4> corners) {
    std::vector<std::vector<PointId>> loops(1);
    for (const auto& p : corners) loops[0].push_back(soup.add_point(p[0], p[1], p[2]));
    soup.add_face(leaf, loops, number, number, 0, 0);
  };
  const auto walls = [&](LeafId leaf, int low, int high) {
    const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (std::uint32_t f = 0; f < 6; ++f) {
      std::array<std::array<int, 3>, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) {
        const int code = faces[f][i];
        corners[i] = {code & 1 ? high : low, code & 2 ? high : low, code & 4 ? high : low};
      }
      quad(leaf, f, corners);
    }
  };
  quad(soup.add_leaf(Fill::none), 0, {{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}}});
  quad(soup.add_leaf(Fill::none), 0, {{{0, -8, -8}, {0, 8, -8}, {0, 8, 8}, {0, -8, 8}}});
  walls(soup.add_leaf(Fill::none), -1, 1);
  const LeafId frame = soup.add_leaf(Fill::none);
  walls(frame, -8, 8);
  soup.set_frame(frame, soup.add_point(-8, -8, -8), {});
  return build_complex(soup);
}

TEST_CASE("betti numbers of sets that reach the frame", "[homology]") {
  const auto built_complex = framed();
  const Complex& complex = *built_complex;
  REQUIRE(complex.region_count == 1 + 8);
  const CellSet all = all_cells(complex);
  CHECK(numbers(complex, all) == Numbers{1, 0, 0});
  CellSet inside, outside, planes;
  for (RegionId r : all.regions) (complex.unbounded(r) ? outside : inside).regions.push_back(r);
  REQUIRE(inside.regions.size() == 4);
  CHECK(numbers(complex, outside) == Numbers{4, 0, 0});
  CHECK(numbers(complex, closure(complex, outside)) == Numbers{1, 0, 1});
  CHECK(numbers(complex, subtract(all, closure(complex, inside))) == Numbers{1, 0, 1});
  // The planes as far as they bound two unbounded regions: around a hole, and with the line of both off.
  for (FaceId f : all.faces) {
    const auto [p, q] = complex.face_regions[f];
    if (complex.unbounded(p) && complex.unbounded(q)) planes.faces.push_back(f);
  }
  CHECK(numbers(complex, planes) == Numbers{4, 0, 0});
  CHECK(numbers(complex, closure(complex, planes)) == Numbers{1, 3, 0});
  CellSet line;
  for (EdgeId e : all.edges) {
    const auto [a, b] = complex.edge_ends[e];
    if (complex.on_frame(a) || complex.on_frame(b)) line.edges.push_back(e);
  }
  CHECK(numbers(complex, line) == Numbers{2, 0, 0});
  Neighbourhoods neighbourhoods(complex);
  BettiCounter counter(neighbourhoods);
  const auto [begin, end] = scenes::seeds(200);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    scenes::Random random(seed);
    const CellSet set = random_set(complex, random);
    CAPTURE(seed);
    if (!set.empty()) {
      REQUIRE(counter.of(set).z2[2] == complement_pieces(complex, set) - 1);
    }
  }
}

}  // namespace
}  // namespace cnrg
