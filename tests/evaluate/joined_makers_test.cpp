// What joined nodes do not hide: which leaves below them made a cell, and how long edges are to be there.
#include <cmath>
#include <random>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/result/part_text.h"
#include "csg/result/result_data.h"
#include "csg/result/sizes.h"
#include "csg/result/snap.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

Result result_of(const std::string& nodes, const std::string& result, Refining refining = Refining::chosen) {
  EvaluateOptions options;
  options.refining = refining;
  return evaluate(parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: " + result + "\n", "t.yaml"), options)
      .result();
}

struct Told {
  struct Cell {
    std::set<std::string> leaves;  // that made it
    std::set<std::string> cells;   // faces, wires and points of them that hold it
    double size = 0;
  };
  std::vector<Cell> cells[4];  // by dimension
};

Told told(const Result& result) {
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  Told out;
  const auto tell = [&](int dimension, const FlatComplex::Provenance& origin, double size) {
    Told::Cell& cell = out.cells[dimension].emplace_back();
    cell.size = size == 0 ? std::numeric_limits<double>::infinity() : size;
    for (const LeafId leaf : origin.leaves) cell.leaves.insert(view.leaves->at(leaf.index()).name);
    for (const LeafCell& on : origin.cells) {
      if (on.dimension == 3) continue;
      cell.cells.insert(view.leaves->at(on.leaf.index()).name + " " + std::to_string(on.dimension) + " " +
                        std::to_string(on.number));
    }
  };
  for (const auto& v : flat.vertices) tell(0, v.origin, size_of(view, v.origin));
  for (const auto& e : flat.edges) tell(1, e.origin, size_of(view, e.origin));
  for (const auto& f : flat.faces) tell(2, f.origin, size_of(view, f.origin));
  const std::vector<double> sizes = region_sizes(view, flat);
  for (std::size_t i = 0; i < flat.regions.size(); ++i)
    tell(3, flat.regions[i].origin, sizes.empty() ? 0 : sizes[i]);
  return out;
}

/// A random tree over a lattice, where nothing is nearer than 1 that does not touch; `joined`: some of its nodes
/// are joined within 1/1000.
struct RandomTree {
  std::string nodes, result;

  RandomTree(std::uint64_t seed, bool joined) {
    std::mt19937_64 random(seed);
    const auto below = [&](int n) { return int(random() % std::uint64_t(n)); };
    const auto size = [&](int one_in) {
      return below(one_in) == 0 ? ", size: " + std::to_string(1 + below(9)) : "";
    };
    std::vector<std::string> names;
    const auto add = [&](const std::string& text) {
      const std::string name = "n" + std::to_string(names.size());
      std::string said = size(3);
      nodes += "  " + name + ": {" + text + said + "}\n";
      names.push_back(name);
      // The same choices whether it is joined or not.
      const bool join = below(4) == 0;
      said = size(4);
      if (!join) return;
      const std::string within = joined ? "simplify: {of: " + name + ", within: 1/1000}" : "simplify: " + name;
      nodes += "  " + name + "j: {" + within + said + "}\n";
      names.back() = name + "j";
    };
    const auto corner = [&](int x, int y, int z) {
      return "[" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + "]";
    };
    for (int i = 0; i < 5; ++i) {
      const int x = below(3), y = below(3), z = below(3), a = 1 + below(2), b = 1 + below(2), c = 1 + below(2);
      switch (below(5)) {
        case 0:
          add("polygon: [" + corner(x, y, z) + ", " + corner(x + a, y, z) + ", " + corner(x + a, y + b, z) + ", " +
              corner(x, y + b, z) + "]");
          break;
        case 1: add("polyline: [" + corner(x, y, z) + ", " + corner(x, y, z + c) + "]"); break;
        default: add("box: {min: " + corner(x, y, z) + ", max: " + corner(x + a, y + b, z + c) + "}");
      }
    }
    constexpr const char* kOperators[] = {"union", "union", "union", "intersection", "difference"};
    constexpr const char* kWho[] = {"left", "right", "equal"};
    // Each is used once: of a leaf that two ways lead to the shorter size counts in all of its run, and a joined
    // node has a run of its own.
    std::vector<std::string> left = names;
    const auto take = [&] {
      const auto at = left.begin() + below(int(left.size()));
      const std::string name = *at;
      left.erase(at);
      return name;
    };
    while (left.size() > 1) {
      const std::string a = take(), b = take();
      add(std::string(kOperators[below(5)]) + ": [" + a + ", " + b + "], dominance: " + kWho[below(3)]);
      left.push_back(names.back());
    }
    result = names.back();
  }
};

}  // namespace

TEST_CASE("a joined node in which nothing is near tells what its operand tells", "[joined][size][random]") {
  const auto [first, last] = scenes::seeds(300);
  std::size_t sized = 0, several = 0, all = 0, other = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomTree plain(seed, false), joined(seed, true);
    INFO("seed " << seed << "\n" << joined.nodes << "result: " << joined.result);
    const Told wanted = told(result_of(plain.nodes, plain.result)),
               found = told(result_of(joined.nodes, joined.result));
    for (int dimension = 0; dimension < 4; ++dimension) {
      const auto &of_wanted = wanted.cells[dimension], &of_found = found.cells[dimension];
      REQUIRE(of_found.size() == of_wanted.size());
      for (std::size_t i = 0; i < of_found.size(); ++i) {
        const Told::Cell &x = of_found[i], &y = of_wanted[i];
        INFO("cell " << i << " of dimension " << dimension);
        ++all, sized += std::isfinite(y.size), several += y.leaves.size() > 1;
        if (dimension >= 2) {
          CHECK(x.leaves == y.leaves);
          CHECK(x.cells == y.cells);
          CHECK(x.size == y.size);
          continue;
        }
        // An edge is one in the joined node, and from all of its leaves, though some that it was cut from touched
        // only a part of it, and users may part it.
        CHECK(std::includes(x.leaves.begin(), x.leaves.end(), y.leaves.begin(), y.leaves.end()));
        CHECK(x.size <= y.size);
        other += x.leaves != y.leaves || x.cells != y.cells || x.size != y.size;
      }
    }
  }
  CHECK(sized > all / 3);
  CHECK(several > all / 10);
  CHECK(other * 500 < all);
}

TEST_CASE("what is merged came from all that it was, and is as fine as the finest", "[joined][size]") {
  const std::string parts = R"(
  bolt:   {polyline: [[60, 50, 30], [60, 50, 47.9999]], size: 2}
  fault:  {polygon: [[20, 0, 0], [70, 0, 60], [70, 100, 60], [20, 100, 0]], size: 5}
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}}
  cover:  {box: {min: [0, 0, 60.0002], max: [100, 100, 80]}, size: 9}
  tunnel: {box: {min: [30, -1, 5], max: [34, 101, 8]}, size: 1}
)";
  const std::string model = "  model: {union: [bolt, fault, ground, cover], dominance: left}\n";
  const std::string join = "  joined: {simplify: {of: model, within: 0.001}, size: 12}\n";
  const auto faces_of = [](const Result& result, const std::string& name) {
    std::size_t n = 0;
    for (const Told::Cell& face : told(result).cells[2]) n += face.cells.count(name);
    return n;
  };
  // By a node, by a node below others, by a node below another one that joins, and snapped.
  for (const std::string& above :
       {std::string("  all: {simplify: joined}\n"), std::string("  all: {difference: [joined, tunnel]}\n"),
        std::string("  again: {simplify: {of: joined, within: 0.002}, translate: [1, 0, 0]}\n"
                    "  all: {difference: [again, {simplify: tunnel, translate: [1, 0, 0]}]}\n")}) {
    INFO(above);
    const Result exact = result_of(parts + model + join + above, "all");
    for (const Result& result : {exact, snap(exact)}) {
      const ResultView view = result.data().view();
      const FlatComplex flat = flatten(view);
      // The end of the bolt is a vertex in the fault, and came from both.
      std::size_t ends = 0;
      for (const FlatComplex::Vertex& v : flat.vertices) {
        if (names_of_leaves(view, v.origin) != "bolt, fault") continue;
        ++ends;
        CHECK(size_of(view, v.origin) == 2);
      }
      CHECK(ends == 1);
      // The wall between ground and cover, which was a gap, is of both; the cover says more than what is above.
      std::size_t walls = 0;
      for (const FlatComplex::Face& f : flat.faces) {
        const std::string names = names_of_leaves(view, f.origin);
        if (names == "fault") CHECK(size_of(view, f.origin) == 5);
        if (names == "ground") CHECK(size_of(view, f.origin) == 12);
        if (names == "tunnel") CHECK(size_of(view, f.origin) == 1);
        if (names == "ground, cover") {
          ++walls;
          CHECK(size_of(view, f.origin) == 9);
        }
        CHECK(names.find("joined") == std::string::npos);
      }
      CHECK(walls > 0);
      const std::vector<double> sizes = region_sizes(view, flat);
      std::multiset<double> said;
      for (std::size_t i = 0; i < flat.regions.size(); ++i) {
        if (flat.active(FlatComplex::Index(i))) said.insert(sizes.at(i));
      }
      CHECK(said.count(9) == 1);
      CHECK(said.count(12) + said.count(9) == said.size());
    }
    CHECK(faces_of(exact, "fault 2 0") > 0);
    CHECK(faces_of(exact, "ground 2 5") > 0);
  }
}

TEST_CASE("select picks from what is below a joined node", "[joined][select]") {
  const std::string nodes = R"(
  bolt:   {polyline: [[60, 50, 30], [60, 50, 47.9999]]}
  fault:  {polygon: [[20, 0, 0], [70, 0, 60], [70, 100, 60], [20, 100, 0]]}
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}}
  both:   {union: [bolt, fault]}
  model:  {union: [both, ground], dominance: left}
  joined: {simplify: {of: model, within: 0.001}}
  moved:  {simplify: joined, translate: [0, 0, 7]}
)";
  const auto count = [&](const std::string& criteria, int dimension) {
    const Result result = result_of(
        nodes + "  r: {select: {of: moved, dimension: " + std::to_string(dimension) + ", " + criteria + "}}\n",
        "r");
    const FlatComplex flat = flatten(result.data().view());
    return dimension == 2 ? flat.faces.size() : flat.edges.size();
  };
  CHECK(count("from: bolt", 1) == 1);
  CHECK(count("from: fault", 2) == 1);
  CHECK(count("from: both", 2) == 1);
  CHECK(count("from: joined", 2) == count("from: model", 2));
  CHECK(count("from: ground, source face: 4", 2) == 2);  // the floor, which the fault parts
}

TEST_CASE("near features of a joined node are named by its leaves", "[joined]") {
  const Result result = result_of(R"(
  low:    {box: {min: [0, 0, 0], max: [4, 4, 1]}}
  high:   {box: {min: [0, 0, 1.0001], max: [4, 4, 2]}}
  spot:   {points: [[2, 2, 2.01]]}
  model:  {union: [low, high, spot]}
  joined: {simplify: {of: model, within: 0.001}}
  all:    {union: [joined, {points: [[3, 3, 2.02]]}]}
)",
                                  "all");
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  std::set<std::string> names;
  for (const FlatComplex::Vertex& v : flat.vertices) names.insert(names_of_leaves(view, v.origin));
  for (const FlatComplex::Face& f : flat.faces) names.insert(names_of_leaves(view, f.origin));
  CHECK(names == std::set<std::string>{"low", "high", "low, high", "spot", "all/2"});
}
