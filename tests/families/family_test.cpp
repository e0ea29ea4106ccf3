// Families of problems: valid operands, contacts that are what they are called, names.
#include "bench/cases/family.h"

#include <set>
#include <stdexcept>

#include "bench/sweep/experiment.h"
#include "tests/catch.h"
#include "tests/families/model_checks.h"

namespace cnrg::bench {
namespace {

using Catch::Contains;

/// Families of this source, as their experiments have them.
struct Family {
  std::string name;
  std::vector<std::string> operations;
  std::vector<long> sizes;
  bool has_distance = false;
  int seeds = 1;
};

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> made;
    std::set<std::string> used;
    for (const std::string& name : experiment_names()) {
      const Experiment e = read_experiments(name, {}, used).at(0);
      if (e.family != name) continue;  // trees, and other sweeps of a family
      CHECK_FALSE(e.title.empty());
      Family& family = made.emplace_back(Family{name, e.parameter("operation")->values, {}});
      for (const std::string& size : e.parameter("size")->values) family.sizes.push_back(std::stol(size));
      family.has_distance = e.parameter("k") != nullptr;
      family.seeds = static_cast<int>(e.parameter("seed")->values.size());
    }
    return made;
  }();
  return all;
}

const Family& family_of(const std::string& name) {
  for (const Family& family : families())
    if (family.name == name) return family;
  throw std::logic_error("no family " + name);
}

ProblemId id_of(const std::string& family, long size, std::optional<int> distance, unsigned seed) {
  return {family, family_of(family).operations[0], size, distance, seed};
}

std::vector<std::optional<int>> some_distances(const Family& family) {
  if (!family.has_distance) return {std::nullopt};
  return {std::nullopt, 0, 1, 7, 16};
}

Meeting meeting_of(const ProblemId& id) {
  const Problem problem = make_problem(id);
  REQUIRE(problem.operands.size() == 2);
  return meeting(problem.operands[0], problem.operands[1]);
}

/// The usual sizes up to the second one.
std::vector<long> small_sizes(const Family& family) {
  return {family.sizes.begin(), family.sizes.begin() + std::min<long>(2, static_cast<long>(family.sizes.size()))};
}

}  // namespace

TEST_CASE("every family makes valid problems, the same each time", "[families]") {
  std::set<std::string> names;
  for (const Family& family : families()) {
    CHECK(names.insert(family.name).second);
    CHECK(std::is_sorted(family.sizes.begin(), family.sizes.end()));
    for (const std::string& operation : family.operations) {
      for (const long size : small_sizes(family)) {
        for (const auto distance : some_distances(family)) {
          // Operands do not depend on the operation but in `fractures`.
          const bool all = operation == family.operations[0] || family.name == "fractures";
          for (unsigned seed = 1; seed <= (all ? 12u : 1u); ++seed) {
            const ProblemId id{family.name, operation, size, distance, seed};
            INFO(id.name());
            const Problem problem = make_problem(id), again = make_problem(id);
            CHECK(problem.name == id.name());
            CHECK(problem.operands == again.operands);
            CHECK(problem.steps == again.steps);
            REQUIRE(problem.operands.size() == problem.steps.size() + 1);
            for (const Model& model : problem.operands) CHECK(fault_of(model) == "");
            for (const Operation step : problem.steps)
              CHECK((operation == "fold" || operation == to_string(step)));
          }
        }
      }
    }
  }
  CHECK(names.size() == 16);
}

TEST_CASE("seeds make different problems", "[families]") {
  for (const Family& family : families()) {
    const auto distance = family.has_distance ? std::optional(3) : std::nullopt;
    for (unsigned seed = 1; seed < static_cast<unsigned>(family.seeds); ++seed) {
      INFO(family.name << ' ' << seed);
      const long size = family.sizes[0];
      CHECK_FALSE(make_problem(id_of(family.name, size, distance, seed)).operands ==
                  make_problem(id_of(family.name, size, distance, seed + 1)).operands);
    }
  }
}

TEST_CASE("generic pairs are in general position and overlap", "[families]") {
  for (const long size : {8l, 12l, 50l}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const ProblemId id = id_of("generic", size, std::nullopt, seed);
      INFO(id.name());
      const Meeting m = meeting_of(id);
      CHECK(m.general());
      CHECK(m.both > 0);
      CHECK(m.both < m.first);
      CHECK(m.both < m.second);
    }
  }
}

TEST_CASE("exact contacts are what their families say", "[families]") {
  for (const long size : {4l, 7l, 16l}) {
    std::set<std::size_t> part_edges, edge_edges, wall_edges;  // how much of a face or an edge is shared
    std::set<std::size_t> part_crossings, vertex_crossings;
    for (unsigned seed = 1; seed <= 24; ++seed) {
      INFO("size " << size << " seed " << seed);
      const Meeting face = meeting_of(id_of("face", size, std::nullopt, seed));
      CHECK(face.faces == 1);
      CHECK(face.edges == static_cast<std::size_t>(size));
      CHECK(face.both == 0);

      const Meeting part = meeting_of(id_of("part-of-face", size, std::nullopt, seed));
      CHECK(part.faces == 1);
      CHECK(part.both == 0);
      part_edges.insert(part.edges);
      part_crossings.insert(part.crossings);

      const Meeting edge = meeting_of(id_of("edge", size, std::nullopt, seed));
      CHECK(edge.faces == 0);
      edge_edges.insert(edge.edges);
      CHECK(edge.vertices == 2);
      CHECK(edge.both == 0);

      const Meeting vertex = meeting_of(id_of("vertex", size, std::nullopt, seed));
      CHECK(vertex.faces == 0);
      CHECK(vertex.edges == 0);
      CHECK(vertex.vertices == 1);
      CHECK(vertex.both == 0);
      vertex_crossings.insert(vertex.crossings);

      const Meeting wall = meeting_of(id_of("wall", size, std::nullopt, seed));
      CHECK(wall.faces == 1);
      CHECK(wall.both == wall.second);
      CHECK(wall.both < wall.first);
      wall_edges.insert(wall.edges);

      const Meeting same = meeting_of(id_of("turned", 1, std::nullopt, seed));
      CHECK(same.faces == 6);
      CHECK(same.both == 1);
    }
    CHECK(part_edges == std::set<std::size_t>{0, 1});
    CHECK(part_crossings == std::set<std::size_t>{0, 2});
    CHECK(vertex_crossings == std::set<std::size_t>{0, 1});
    CHECK(edge_edges == std::set<std::size_t>{0, 1});
    CHECK(wall_edges == std::set<std::size_t>{0, 1, static_cast<std::size_t>(size)});
  }
}

TEST_CASE("a distance ends the degeneracy, however small", "[families]") {
  for (const std::string name : {"face", "part-of-face", "edge", "vertex", "wall"}) {
    for (const long size : {4l, 16l}) {
      for (const int k : {0, 1, 2, 5, 16}) {
        for (unsigned seed = 1; seed <= 24; ++seed) {
          const ProblemId id = id_of(name, size, k, seed);
          INFO(id.name());
          const Meeting m = meeting_of(id);
          CHECK(m.general());
          const bool up = seed % 4 == 1, down = seed % 4 == 3;
          if (name == "wall") {
            if (up && k > 0) CHECK((m.both > 0 && m.both < m.second));
            if (down && k > 0) CHECK(m.both == m.second);
          } else {
            if (up) CHECK(m.both == 0);
            if (down) CHECK(m.both > 0);
          }
        }
      }
    }
  }
}

TEST_CASE("the second operand leaves by the distance, the first one stays", "[families]") {
  for (const Family& family : families()) {
    if (!family.has_distance || family.name.starts_with("turned")) continue;
    for (unsigned seed = 1; seed <= 8; ++seed) {
      for (const int k : {0, 2, 16}) {
        const ProblemId id = id_of(family.name, 4, k, seed);
        INFO(id.name());
        const Problem exact = make_problem(id_of(family.name, 4, std::nullopt, seed)), near = make_problem(id);
        CHECK(exact.operands[0] == near.operands[0]);
        Rational distance = 1;
        for (int i = 0; i < k; ++i) distance /= 10;
        REQUIRE(exact.operands[1].points.size() == near.operands[1].points.size());
        Rational largest = 0;
        for (std::size_t i = 0; i < near.operands[1].points.size(); ++i) {
          Rational square = 0;
          for (int axis = 0; axis < 3; ++axis) {
            const Rational x = near.operands[1].points[i][axis] - exact.operands[1].points[i][axis];
            square += x * x;
          }
          if (seed % 2 == 1) CHECK(square == distance * distance);
          else CHECK(square > 0);
          largest = std::max(largest, square);
        }
        // A turn moves what is 1 away from the axis by about the distance; operands are a few units wide.
        CHECK((largest >= distance * distance / 4 && largest < 16 * distance * distance));
      }
    }
  }
}

TEST_CASE("seeds from 3 are in general position to the axes", "[families]") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Problem problem = make_problem(id_of("turned", 1, std::nullopt, seed));
    std::set<Rational> heights;
    for (const RationalPoint& p : problem.operands[0].points) heights.insert(p[2]);
    CHECK((heights.size() == 2) == (seed <= 2));
  }
}

TEST_CASE("cubes turn about an axis by less and less", "[families]") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Rational last = 0;
    for (const int k : {0, 1, 4, 16}) {
      const ProblemId id = id_of("turned", 1, k, seed);
      INFO(id.name());
      const Meeting m = meeting_of(id);
      CHECK(m.first == 1);
      CHECK(m.second == 1);
      CHECK(m.both > last);  // the smaller the angle the more they have in common
      CHECK(m.both < 1);
      last = m.both;
      if (seed > 1) CHECK(m.general());
      else CHECK(m.faces == 2);  // top and bottom stay in their planes

      // The rounded one differs in its last digits.
      const Problem mesh = make_problem(id_of("turned-mesh", 1, k, seed));
      for (const Model& model : mesh.operands) {
        CHECK(model.faces.size() == 12);
        for (const RationalPoint& p : model.points)
          for (const Rational& x : p) CHECK(is_double(x));
        CHECK(abs(volume_of(model) - 1) < Rational(1, 1000000000));
      }
    }
    CHECK(1 - last < Rational(1, 1000000000));
  }
}

TEST_CASE("surfaces and wires touch the solid at no distance and are in general position else", "[families]") {
  for (const std::string name : {"sheet", "bolt"}) {
    for (const long size : {4l, 9l}) {
      for (unsigned seed = 1; seed <= 12; ++seed) {
        INFO(name << ' ' << size << ' ' << seed);
        const Problem problem = make_problem(id_of(name, size, std::nullopt, seed));
        CHECK_FALSE(problem.solids());
        CHECK_FALSE(meeting_of(id_of(name, size, std::nullopt, seed)).general());
        for (const int k : {0, 3, 16}) CHECK(meeting_of(id_of(name, size, k, seed)).general());
      }
    }
  }
}

TEST_CASE("families that are no pairs are as they say", "[families]") {
  const Problem menger = make_problem(id_of("menger", 2, std::nullopt, 1));
  CHECK(menger.operands.size() == 28);
  CHECK(make_problem(id_of("boxes", 30, std::nullopt, 1)).operands.size() == 30);
  CHECK(make_problem(id_of("spheres", 3, std::nullopt, 1)).operands.size() == 27);
  const Problem deep = make_problem(id_of("iterated", 1000, std::nullopt, 2));
  CHECK(deep.steps.size() == 1000);
  CHECK(std::set(deep.steps.begin(), deep.steps.end()).size() == 3);
  CHECK(deep.solids());
  const Problem ground = make_problem(id_of("ground", 4, std::nullopt, 1));
  CHECK(ground.operands.size() == 8);
  CHECK_FALSE(ground.solids());
  const Meeting layers = meeting(ground.operands[1], ground.operands[2]);
  CHECK(layers.faces == 32);
  CHECK(layers.both == 0);
  const Problem fractures = make_problem(id_of("fractures", 30, std::nullopt, 1));
  CHECK(fractures.operands.size() == 35);
  CHECK(fractures.steps.back() == Operation::intersect);
}

TEST_CASE("problems that a family does not have", "[families]") {
  const auto make = [](const std::string& family, const std::string& operation, long size, std::optional<int> k) {
    return make_problem({family, operation, size, k, 1});
  };
  CHECK_THROWS_WITH(make("cone", "union", 4, 7), Contains("'cone'") && Contains("part-of-face"));
  CHECK_THROWS_WITH(make("edge", "fold", 4, 7), Contains("'fold'") && Contains("difference"));
  CHECK_THROWS_WITH(make("boxes", "difference", 10, {}), Contains("'difference'") && Contains("union"));
  for (const long size : {0l, -1l, 3l, 1001l})
    CHECK_THROWS_WITH(make("edge", "union", size, 7), Contains(std::to_string(size)) && Contains("4 to 1000"));
  for (const int k : {-1, 17})
    CHECK_THROWS_WITH(make("edge", "union", 4, k), Contains(std::to_string(k)) && Contains("0 to 16"));
  CHECK_THROWS_WITH(make("boxes", "union", 10, 3), Contains("no distance"));
  CHECK_THROWS_AS(make("boxes", "union", 10, 3), std::runtime_error);
  for (const Family& family : families())
    for (const long size : {0l, -7l})
      CHECK_THROWS_AS(make(family.name, family.operations[0], size, {}), std::runtime_error);
}

}  // namespace cnrg::bench
