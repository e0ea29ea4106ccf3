// The rows of the tables against the paper's terms taken by the letter (tests/oracles/paper_reading.h), over
// random groups of every kind: what they remove is the same but for two kinds of cells, which are counted.
//
// Wires and points in the interior of faces are what this is about. Cubical groups of maximal rectangles have
// them, with many loose parts; scenes of several leaves have them where leaves cut into each other's faces.
#include "tests/oracles/paper_reading.h"

#include <random>

#include "csg/operators/boolean.h"
#include "tests/catch.h"
#include "tests/oracles/cubical_pair.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

struct ReadingTally {
  std::size_t operations = 0, different = 0, dang_or_loose = 0, loose = 0;
  ReadingDifference difference;
};

constexpr BooleanOp kOps[] = {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract};
constexpr Dominance kDominances[] = {Dominance::left, Dominance::right, Dominance::equal};

/// Every operator and dominance on two groups; the first difference of another kind in words.
std::string compare_all(const Complex& complex, const Group& left, const Group& right, ReadingTally& tally) {
  for (const BooleanOp op : kOps) {
    for (const Dominance dominance : kDominances) {
      if (op == BooleanOp::subtract && dominance != Dominance::left) continue;
      const Group result = boolean_operation(complex, op, dominance, left, right).group;
      const PaperReading letter = paper_reading(complex, op, dominance, left, right);
      const std::size_t before = tally.difference.faces_kept_around + tally.difference.features_of_walls;
      const std::string wrong =
          compare_readings(complex, op, dominance, left, right, result, letter, tally.difference);
      if (!wrong.empty())
        return std::string(name(op)) + ", dominance " + std::to_string(static_cast<int>(dominance)) + ": " + wrong;
      ++tally.operations;
      tally.different += tally.difference.faces_kept_around + tally.difference.features_of_walls != before;
      tally.dang_or_loose += letter.dang_or_loose;
      tally.loose += letter.loose;
    }
  }
  return "";
}

/// The leaves in pairs, and what an operator makes of the first two against the third.
std::string compare_leaves(const std::vector<scenes::Leaf>& leaves, std::uint64_t seed, ReadingTally& tally) {
  const auto complex = build_complex(scenes::make_soup(leaves), {.threads = 1});
  const std::vector<Group> groups = leaf_groups(*complex);
  std::string wrong = compare_all(*complex, groups[0], groups[1], tally);
  if (!wrong.empty()) return "the first two: " + wrong;
  const Group both =
      boolean_operation(*complex, kOps[seed % 3], kDominances[seed / 3 % 3], groups[0], groups[1]).group;
  wrong = compare_all(*complex, both, groups[2], tally);
  return wrong.empty() ? "" : "their result and the third: " + wrong;
}

/// Adds wires and points in the interior of faces: from the border, between borders, or loose.
void mark_faces(scenes::Leaf& leaf, std::mt19937_64& random) {
  const auto among = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  const std::vector<scenes::Face> faces = leaf.faces;
  for (const scenes::Face& face : faces) {
    const scenes::Polygon& corners = face.loops[0];
    const auto inside = [&](int u, int v) {
      RationalPoint p = corners[0];
      for (std::size_t k = 0; k < 3; ++k)
        p[k] += (corners[1][k] - corners[0][k]) * u / 4 + (corners[3][k] - corners[0][k]) * v / 4;
      return p;
    };
    if (among(4) == 0) {
      const int u = among(5), v = among(5), width = 1 + among(4);
      if (u != width || v != 2) leaf.wires.push_back({inside(u, v), inside(width, 2)});
    }
    if (among(6) == 0) leaf.points.push_back(inside(1 + among(3), 1 + among(3)));
  }
}

void show(const char* of, const ReadingTally& t) {
  // Asked for by -s; the page has these figures.
  SUCCEED(of << ": " << t.operations << " operations, " << t.different
             << " with a difference: " << t.difference.faces_kept_around << " cells in a kept face, "
             << t.difference.features_of_walls << " features of walls; dangOrLoose alone removed "
             << t.dang_or_loose << " edges, loose alone " << t.loose << " vertices");
}

TEST_CASE("the paper's terms by the letter: cubical groups with marked faces", "[paper-reading]") {
  const cubical::Grid grid(5);
  ReadingTally tally;
  const auto [first, last] = scenes::seeds(150);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    std::mt19937_64 random(seed);
    std::vector<scenes::Leaf> leaves;
    for (int i = 0; i < 3; ++i) {
      const cubical::Group group = cubical::random_group(grid, random, random() % 4 == 0, 4);
      leaves.push_back(cubical::leaf_of(grid, group, random() % 4 != 0));
      mark_faces(leaves.back(), random);
    }
    INFO("seed " << seed);
    REQUIRE(compare_leaves(leaves, seed, tally) == "");
  }
  show("cubical", tally);
  if (last - first < 100) return;
  // Each kind is met, so that a test that agrees says something.
  CHECK(tally.difference.faces_kept_around > 0);
  CHECK(tally.difference.features_of_walls > 0);
  CHECK(tally.dang_or_loose > 0);
  CHECK(tally.loose > 0);
}

TEST_CASE("the paper's terms by the letter: scenes of mixed leaves", "[paper-reading]") {
  ReadingTally tally;
  const auto [first, last] = scenes::seeds(60);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    for (const auto position : {scenes::Position::degenerate, scenes::Position::general}) {
      const std::vector<scenes::Leaf> leaves = scenes::random_leaves(seed + 70000, 3, position);
      INFO("seed " << seed << "\n" << scenes::tree_file(leaves));
      REQUIRE(compare_leaves(leaves, seed, tally) == "");
    }
  }
  show("scenes", tally);
}

}  // namespace
}  // namespace cnrg::properties
