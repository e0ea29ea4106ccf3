// Every system on small problems whose results are known.
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>

#include "tests/catch.h"
#include "tests/peers/models.h"
#include "tests/scenes/seeds.h"

namespace {

using namespace cnrg;
using namespace cnrg::peers;
using bench::Answer;
using bench::Refusal;
using bench::System;

const Operation kAll[] = {Operation::unite, Operation::subtract, Operation::intersect};

/// Those that run here; the first test says which do not.
std::vector<System> present() {
  std::vector<System> list = bench::systems();
  std::erase_if(list, [](const System& system) { return !system.absent.empty() || system.if_named; });
  return list;
}

std::optional<System> present(const std::string& name) {
  for (System& system : present())
    if (system.name == name) return std::move(system);
  return std::nullopt;
}

bool takes_all_dimensions(const System& system) {
  return system.name == "ours" || system.name == "nef" || system.name.starts_with("occt");
}

/// Mäntylä's algorithm is expected to fail on some of these problems; its own tests say on which.
bool is_baseline(const System& system) { return system.name.starts_with("mantyla"); }

/// Results of exact systems must be equal; the error of a rounded one follows from points that are as far off as
/// it says, for results about as large as their coordinates.
bool agrees(const System& system, const Rational& value, const Rational& expected) {
  if (system.rounding == 0) return value == expected;
  return std::abs(to_double(value - expected)) <= 100 * system.rounding * (1 + std::abs(to_double(expected)));
}

/// What a refusal says, or `none`.
std::string stage_of_refusal(const System& system, const Problem& problem) {
  try {
    system.evaluate(problem);
  } catch (const Refusal& refusal) {
    CHECK_FALSE(std::string(refusal.what()).empty());
    return refusal.stage();
  }
  return "none";
}

void check_solid(const System& system, const Answer& answer, const Rational& expected) {
  CHECK(closed(answer.model));
  CHECK(answer.model.solid());
  CHECK(agrees(system, volume(answer.model), expected));
  CHECK_FALSE(answer.measures.stages.empty());
}

Rational expected_volume(Operation operation, const Rational& a, const Rational& b, const Rational& common) {
  if (operation == Operation::unite) return a + b - common;
  return operation == Operation::subtract ? Rational(a - common) : common;
}

/// Boxes with corners on a grid, and how many unit cubes their union has.
std::pair<Problem, long> boxes_on_grid(unsigned seed, int count, int side) {
  std::mt19937 random(seed);
  std::set<std::array<int, 3>> cubes;
  Problem problem{"boxes", {}, std::vector<Operation>(std::size_t(count - 1), Operation::unite)};
  for (int i = 0; i < count; ++i) {
    std::array<int, 3> low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] = int(random() % unsigned(side - 3));
      high[k] = low[k] + 1 + int(random() % 3);
    }
    problem.operands.push_back(box({low[0], low[1], low[2]}, {high[0], high[1], high[2]}));
    for (int x = low[0]; x < high[0]; ++x)
      for (int y = low[1]; y < high[1]; ++y)
        for (int z = low[2]; z < high[2]; ++z) cubes.insert({x, y, z});
  }
  return {problem, long(cubes.size())};
}

}  // namespace

TEST_CASE("systems are named, ours first") {
  std::vector<std::string> names;
  for (const System& system : bench::systems()) {
    names.push_back(system.name);
    if (system.absent.empty()) CHECK_FALSE(system.version().empty());
    else WARN("left out: " << system.name << ": " << system.absent);
  }
  CHECK(names == std::vector<std::string>{"ours", "ours-tree", "mantyla-double", "mantyla-exact", "nef",
                                          "corefinement", "occt", "occt-rescaled", "openscad", "openscad-rescaled",
                                          "mantyla-published", "mantyla-published-exact"});
}

TEST_CASE("two boxes that overlap, no coordinate of which is a double") {
  const Rational third(1, 3);
  const Model a = box({0, 0, 0}, {third, third, third});
  const Model b = box({third / 2, third / 2, third / 2}, {1, 1, 1});
  const Rational va = third * third * third, vb = Rational(125, 216), common = va / 8;
  for (const System& system : present())
    for (const Operation operation : kAll) {
      INFO(system.name << ' ' << to_string(operation));
      check_solid(system, system.evaluate(pair_of(a, operation, b)), expected_volume(operation, va, vb, common));
    }
}

TEST_CASE("the baseline has the epsilon that its name says") {
  // Boxes that overlap by 1/1000 of their size: one system takes that for a contact.
  const Problem problem =
      pair_of(box({0, 0, 0}, {1, 1, 1}), Operation::intersect, box({Rational(999) / 1000, 0, 0}, {2, 1, 1}));
  CHECK(volume(bench::mantyla_variant("mantyla-double:1e-6")->evaluate(problem).model) > 0);
  CHECK(volume(bench::mantyla_variant("mantyla-double:1e-2")->evaluate(problem).model) == 0);
  CHECK(bench::mantyla_variant("mantyla-double:1e-6")->rounding == 1e-6);
  CHECK(bench::mantyla_variant("mantyla-published:1e-6")->rounding == 1e-6);
  CHECK_FALSE(bench::mantyla_variant("mantyla-exacter"));
  for (const char* none : {"mantyla-double:", "mantyla-double:0", "mantyla-double:1", "mantyla-double:x"})
    CHECK_THROWS_AS(bench::mantyla_variant(none), std::runtime_error);
}

TEST_CASE("the baseline has the departures that its name says") {
  // A box in a box: shells that no curve reaches.
  const Problem problem = pair_of(box({0, 0, 0}, {3, 3, 3}), Operation::subtract, box({1, 1, 1}, {2, 2, 2}));
  for (const std::string name : {"mantyla-published", "mantyla-published-exact", "mantyla-double-shells",
                                 "mantyla-exact-shells", "mantyla-double:1e-8-arcs-shells"}) {
    INFO(name);
    const System without = bench::mantyla_variant(name).value(),
                 with = bench::mantyla_variant("mantyla-published+shells").value();
    CHECK(without.name == name);
    CHECK_THROWS_AS(without.evaluate(problem), Refusal);
    CHECK(volume(with.evaluate(problem).model) == 26);
  }
  const bench::Variation varies = bench::mantyla_variant("mantyla-double:1e-8-arcs")->varies;
  CHECK(varies.of == "mantyla-double:1e-8");
  CHECK(varies.rule == "arcs");
  CHECK_FALSE(varies.on);
  CHECK(bench::mantyla_variant("mantyla-published+arcs")->varies.on);
  CHECK(bench::mantyla_variant("mantyla-published+arcs+checks")->varies.of == "mantyla-published+arcs");
  CHECK(bench::mantyla_variant("mantyla-published")->varies.of.empty());
  CHECK_THROWS_WITH(bench::mantyla_variant("mantyla-double-arc"),
                    Catch::Contains("rules are sides, single, arcs"));
  CHECK_THROWS_WITH(bench::mantyla_variant("mantyla-double+arcs"), Catch::Contains("'arcs' is on already"));
  CHECK_THROWS_WITH(bench::mantyla_variant("mantyla-published-arcs"), Catch::Contains("'arcs' is off already"));
  CHECK_THROWS_WITH(bench::mantyla_variant("mantyla-exact:1e-8"), Catch::Contains("no epsilon"));
}

TEST_CASE("systems take operands as they are, but for those that say so") {
  const Rational unit = from_double(0x1p-30), volume_of_both = 15 * unit * unit * unit;
  const Problem tiny = pair_of(box({0, 0, 0}, {2 * unit, 2 * unit, 2 * unit}), Operation::unite,
                               box({unit, unit, unit}, {3 * unit, 3 * unit, 3 * unit}));
  const auto right = [&](const System& system) {
    try {
      return abs(volume(system.evaluate(tiny).model) / volume_of_both - 1) < Rational(1, 1'000'000);
    } catch (const Refusal&) {
      return false;
    }
  };
  for (const char* name : {"occt", "openscad"}) {
    const auto plain = present(name), rescaled = present(std::string(name) + "-rescaled");
    if (!plain) continue;
    INFO(name);
    CHECK_FALSE(right(*plain));
    CHECK(right(*rescaled));
    CHECK(plain->guarantee.find("multiplied") == std::string::npos);
    CHECK(rescaled->guarantee.find("multiplied by a power of two") != std::string::npos);
  }
}

TEST_CASE("boxes with sides in common planes, and identical ones") {
  const Model a = box({0, 0, 0}, {2, 2, 2});
  for (const System& system : present()) {
    if (is_baseline(system)) continue;
    for (const Operation operation : kAll) {
      INFO(system.name << ' ' << to_string(operation));
      const Model b = box({1, 0, 0}, {3, 2, 1});
      check_solid(system, system.evaluate(pair_of(a, operation, b)), expected_volume(operation, 8, 4, 2));
      const Answer same = system.evaluate(pair_of(a, operation, a));
      check_solid(system, same, expected_volume(operation, 8, 8, 8));
      CHECK(same.model.faces.empty() == (operation == Operation::subtract));
    }
  }
}

TEST_CASE("an empty intersection is an empty model") {
  for (const System& system : present()) {
    INFO(system.name);
    const Answer answer =
        system.evaluate(pair_of(box({0, 0, 0}, {1, 1, 1}), Operation::intersect, box({2, 0, 0}, {3, 1, 1})));
    CHECK(answer.model.faces.empty());
    CHECK(answer.model.solid());
  }
}

TEST_CASE("a fold mixes operations from left to right") {
  const Model a = box({0, 0, 0}, {4, 4, 4}), b = box({3, 1, 1}, {7, 3, 3}), c = box({1, 2, 2}, {6, 6, 6});
  const Problem difference{"fold", {a, b, c}, {Operation::unite, Operation::subtract}};
  const Problem intersection{"fold", {a, b, c}, {Operation::unite, Operation::intersect}};
  const Problem late{"fold", {a, b, c}, {Operation::subtract, Operation::unite}};
  for (const System& system : present()) {
    if (is_baseline(system)) continue;
    INFO(system.name);
    // a and b: 64 + 16 - 4; c has 3 * 2 * 2 of a, 3 * 1 * 1 of b and 1 * 1 * 1 of both: 14.
    check_solid(system, system.evaluate(difference), 76 - 14);
    check_solid(system, system.evaluate(intersection), 14);
    // a without b is 60; of c's 80 there are 12 - 1 in it.
    check_solid(system, system.evaluate(late), 60 + 80 - 11);
  }
}

TEST_CASE("boxes that share an edge have it once where the system says so") {
  const Problem problem = pair_of(box({0, 0, 0}, {1, 1, 1}), Operation::unite, box({1, 1, 0}, {2, 2, 1}));
  for (const System& system : present()) {
    if (is_baseline(system)) continue;
    INFO(system.name);
    if (system.name == "corefinement") {
      CHECK(stage_of_refusal(system, problem) == "output");
      continue;
    }
    const Answer answer = system.evaluate(problem);
    check_solid(system, answer, 2);
    CHECK(answer.model.points.size() == 14);
    CHECK(duplicates(answer.model) == 0);
    if (system.rounding == 0) CHECK(answer.model.faces.size() == 12);
  }
}

TEST_CASE("a face with a hole has two loops") {
  const Problem problem = pair_of(box({0, 0, 0}, {4, 4, 4}), Operation::subtract, box({1, 1, 2}, {3, 3, 5}));
  for (const char* name : {"ours", "nef"}) {
    const Answer answer = present(name)->evaluate(problem);
    check_solid(*present(name), answer, 64 - 8);
    std::size_t holes = 0;
    for (const Model::Face& face : answer.model.faces) holes += face.loops.size() - 1;
    CHECK(holes == 1);
    CHECK(answer.model.faces.size() == 11);
  }
}

TEST_CASE("surfaces, wires and points meet a box") {
  const Model solid = box({0, 0, 0}, {2, 2, 2}), plate = sheet({1, 1, 1}, {2, 0, 0}, {0, 0, Rational(1, 2)});
  const Model rod = wire({1, 1, 1}, {1, 1, 4}), inner = point({1, 1, 1}), outer = point({3, 3, 3});
  for (const System& system : present()) {
    INFO(system.name);
    const auto evaluated = [&](const Model& a, Operation operation, const Model& b) {
      return system.evaluate(pair_of(a, operation, b)).model;
    };
    if (!takes_all_dimensions(system)) {
      CHECK(stage_of_refusal(system, pair_of(solid, Operation::unite, plate)) == "input");
      CHECK(stage_of_refusal(system, pair_of(solid, Operation::unite, rod)) == "input");
      CHECK(stage_of_refusal(system, pair_of(solid, Operation::unite, inner)) == "input");
      continue;
    }
    const Model both = evaluated(solid, Operation::unite, plate);
    CHECK(agrees(system, volume(both), 8));
    CHECK(agrees(system, sheet_area(both), Rational(1, 2)));
    CHECK(agrees(system, sheet_area(evaluated(solid, Operation::intersect, plate)), Rational(1, 2)));
    CHECK(agrees(system, sheet_area(evaluated(plate, Operation::subtract, solid)), Rational(1, 2)));
    const Model uncut = evaluated(solid, Operation::subtract, plate);
    CHECK(agrees(system, volume(uncut), 8));
    CHECK(uncut.solid());

    const Model with_rod = evaluated(solid, Operation::unite, rod);
    CHECK(agrees(system, volume(with_rod), 8));
    CHECK(agrees(system, wire_length(with_rod), 2));
    CHECK(agrees(system, wire_length(evaluated(solid, Operation::intersect, rod)), 1));
    CHECK(agrees(system, wire_length(evaluated(rod, Operation::subtract, solid)), 2));

    CHECK(evaluated(solid, Operation::unite, inner).isolated.empty());
    CHECK(evaluated(solid, Operation::unite, outer).isolated.size() == 1);
    CHECK(evaluated(inner, Operation::intersect, solid).isolated.size() == 1);
    CHECK(evaluated(outer, Operation::intersect, solid).isolated.empty());
    CHECK(evaluated(outer, Operation::subtract, solid).isolated.size() == 1);
  }
}

TEST_CASE("an operand of several dimensions, and what touches in a face") {
  Model flagged = box({0, 0, 0}, {2, 2, 2});
  flagged.points.push_back({2, 2, 5});
  flagged.wires.push_back({7, 8});
  const Model neighbour = box({2, 0, 0}, {3, 2, 2});
  for (const char* name : {"ours", "nef"}) {
    const System system = *present(name);
    INFO(name);
    const Answer joined = system.evaluate(pair_of(flagged, Operation::unite, neighbour));
    CHECK(volume(joined.model) == 12);
    CHECK(wire_length(joined.model) == 3);
    CHECK(joined.model.faces.size() == 6);
    CHECK(joined.model.points.size() == 10);
    const Answer common = system.evaluate(pair_of(flagged, Operation::intersect, neighbour));
    CHECK(volume(common.model) == 0);
    CHECK(sheet_area(common.model) == 4);
    CHECK(common.model.faces.size() == 1);
    CHECK(common.model.wires.empty());
  }
}

TEST_CASE("Nef polyhedra say by themselves whether a result is the exact one") {
  const System ours = *present("ours"), nef = *present("nef");
  int same = 0, other = 0, refused = 0;
  const auto [first, last] = scenes::seeds(60);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    std::mt19937_64 random(seed);
    const auto corner = [&] {
      RationalPoint p;
      for (Rational& x : p) x = static_cast<int>(random() % 4);
      return p;
    };
    const auto drawn = [&](bool solid) {
      const RationalPoint a = corner();
      const auto side = [&] { return Rational(1 + static_cast<int>(random() % 2)); };
      switch (solid ? 0 : random() % 4) {
        case 0: return box(a, {a[0] + side(), a[1] + side(), a[2] + side()});
        case 1: return sheet(a, {side(), 0, 0}, {0, side(), 0});
        case 2: return wire(a, {a[0], a[1], a[2] + side()});
        default: return point(a);
      }
    };
    const Model a = drawn(true), b = drawn(false);
    std::vector<Model> results;
    for (const Operation operation : kAll) results.push_back(ours.evaluate(pair_of(a, operation, b)).model);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        INFO("seed " << seed << ", the result of " << j << " for " << i);
        const Model &right = results[i], &given = results[j];
        const bool differs = volume(right) != volume(given) || sheet_area(right) != sheet_area(given) ||
                             wire_length(right) != wire_length(given) ||
                             right.isolated.size() != given.isolated.size();
        if (i != j && !differs) continue;
        try {
          CHECK(nef.agrees(pair_of(a, kAll[i], b), given) == (i == j));
          ++(i == j ? same : other);
        } catch (const Refusal&) {
          ++refused;
        }
      }
  }
  CHECK(same > 150);
  CHECK(other > 50);
  CHECK(refused < 10);
}

TEST_CASE("what is no closed solid is refused at the input") {
  Model open = box({0, 0, 0}, {1, 1, 1});
  open.faces.pop_back();
  Model pierced = box({0, 0, 0}, {2, 2, 2});
  const Model other = box({1, 1, 1}, {3, 3, 3});
  for (const RationalPoint& p : other.points) pierced.points.push_back(p);
  for (Model::Face face : other.faces) {
    for (std::uint32_t& p : face.loops[0]) p += 8;
    pierced.faces.push_back(face);
  }
  const Model far = box({5, 5, 5}, {6, 6, 6});
  for (const char* name : {"ours", "nef", "corefinement", "occt"}) {
    const auto system = present(name);
    if (!system) continue;
    INFO(name);
    CHECK(stage_of_refusal(*system, pair_of(open, Operation::unite, far)) == "input");
  }
  if (const auto openscad = present("openscad"))
    CHECK(stage_of_refusal(*openscad, pair_of(open, Operation::unite, far)) == "program");
  CHECK(stage_of_refusal(*present("corefinement"), pair_of(pierced, Operation::unite, far)) == "input");
  // Shells that cross each other are a solid by winding number, and the union of two for Nef polyhedra.
  for (const char* name : {"ours", "nef"})
    CHECK(volume(present(name)->evaluate(pair_of(pierced, Operation::unite, far)).model) == 16);
}

TEST_CASE("a cavity") {
  Model hollow = box({0, 0, 0}, {6, 6, 6});
  const Model inside = box({1, 1, 1}, {5, 5, 5});
  for (const RationalPoint& p : inside.points) hollow.points.push_back(p);
  for (Model::Face face : inside.faces) {
    for (std::uint32_t& p : face.loops[0]) p += 8;
    std::reverse(face.loops[0].begin(), face.loops[0].end());
    hollow.faces.push_back(face);
  }
  const Problem problem = pair_of(hollow, Operation::unite, box({4, 4, 4}, {8, 8, 8}));
  for (const System& system : present()) {
    if (is_baseline(system)) continue;
    INFO(system.name);
    check_solid(system, system.evaluate(problem), 216 - 64 + 64 - 8 + 1);
  }
}

TEST_CASE("unions of boxes on a grid, exactly") {
  const auto [first, end] = scenes::seeds(4);
  for (auto seed = first; seed < end; ++seed) {
    const auto [problem, cubes] = boxes_on_grid(unsigned(seed), 12, 8);
    for (const System& system : present()) {
      if (system.name != "ours" && system.name != "nef" && system.name != "openscad") continue;
      INFO(system.name << ", seed " << seed);
      CHECK(agrees(system, volume(system.evaluate(problem).model), cubes));
    }
  }
}
