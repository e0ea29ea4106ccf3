// The rules in which the baseline departs from the published algorithm: all off, each by itself, and what it
// decides.
#include <map>
#include <set>

#include "bench/baseline/mantyla.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::bench::baseline_test {
namespace {

using mantyla::Departures;

Departures with(Departures departures, const std::string& name, bool on) {
  for (const mantyla::Departure& departure : mantyla::kDepartures)
    if (departure.name == name) departures.*departure.rule = on;
  return departures;
}

/// Small solids in which one rule decides.
struct Decided {
  std::string rule;
  Departures others;  ///< the state of all other rules
  Model a, b;
  Operation operation;
  std::string off, on;
};

std::vector<Decided> decided() {
  const Departures all, published_with_shells = with(mantyla::published(), "shells", true);
  const Model u_and_box = mantyla::boolean_exact(at(with_axis(prism(letter_u(), {}, 0, 1), 1), 1, 0, 0),
                                                 box({2, 0, 0}, {5, 2, 3}), Operation::unite);
  return {
      {"sides", all, box({1, 0, 1}, {2, 2, 3}), at(octahedron(), 1, 1, 3), Operation::subtract, "connecting",
       "same"},
      {"single", all, box({1, 0, 1}, {2, 2, 3}), at(octahedron(), 1, 1, 3), Operation::unite, "connecting",
       "same"},
      {"arcs", all, box({0, 2, 1}, {2, 3, 4}), at(tetrahedron(), 1, 1, 2), Operation::unite, "wrong", "same"},
      {"pairs", all, u_and_box, box({1, 1, 1}, {4, 4, 3}), Operation::intersect, "finishing", "same"},
      {"order", all, at(octahedron(), 3, 3, 3), fanned(box({1, 0, 2}, {3, 3, 3})), Operation::subtract,
       "connecting", "same"},
      {"nearest", all, box({0, 0, 0}, {2, 2, 1}), at(with_axis(prism(ell(), {}, 0, 1), 2), -1, 0, -1),
       Operation::unite, "output", "same"},
      {"rings", all, at(with_axis(prism(letter_u(), {}, 0, 2), 1), 0, 1, -1), fanned(box({1, 0, 1}, {3, 4, 3})),
       Operation::unite, "connecting", "same"},
      {"curves", published_with_shells, box({2, 0, 0}, {5, 2, 1}), fanned(box({2, 2, 0}, {3, 3, 3})),
       Operation::unite, "wrong", "same"},
      {"shells", all, box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2}), Operation::subtract, "finishing",
       "same"},
      {"checks", published_with_shells, at(tetrahedron(), 2, 0, 3), box({1, 0, 1}, {3, 2, 3}), Operation::unite,
       "wrong", "connecting"},
  };
}

}  // namespace

TEST_CASE("each departure decides a small case") {
  std::set<std::string> rules;
  for (const Decided& one : decided()) {
    INFO(one.rule);
    rules.insert(one.rule);
    CHECK(outcome(one.a, one.b, one.operation, with(one.others, one.rule, false)) == one.off);
    CHECK(outcome(one.a, one.b, one.operation, with(one.others, one.rule, true)) == one.on);
  }
  CHECK(rules.size() == mantyla::kDepartures.size());
}

// Rings of faces that the curve parts are its only trouble there.
TEST_CASE("the published algorithm is right in general position, up to rings of faces") {
  const auto [first, last] = scenes::seeds(200);
  const Departures published_with_shells = with(mantyla::published(), "shells", true);
  int same = 0, of_rings = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const Model a = random_solid(random), b = random_solid(random);
    for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
      INFO("seed " << seed << ", " << to_string(operation));
      const std::string found = outcome(a, b, operation, mantyla::published());
      if (found == "same") {
        ++same;
        continue;
      }
      if (found == "wrong") ++of_rings;
      else CHECK(outcome(a, b, operation, published_with_shells) == "same");  // no curve
      if (found == "wrong") CHECK(outcome(a, b, operation, with(published_with_shells, "rings", true)) == "same");
    }
  }
  if (last - first < 200) return;
  CHECK(same > 300);
  CHECK(of_rings > 0);
  CHECK(of_rings < same / 50);
}

TEST_CASE("the published algorithm ends on solids that touch everywhere, in doubles, too") {
  const auto [first, last] = scenes::seeds(100);
  std::map<std::string, int> outcomes;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const Model a = random_grid_solid(random), b = random_grid_solid(random);
    for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
      ++outcomes[outcome(a, b, operation, with(mantyla::published(), "shells", true))];
      try {
        mantyla::boolean_double(a, b, operation, 1e-10, mantyla::published());
      } catch (const mantyla::Failure&) {
      }
    }
  }
  if (last - first >= 100) CHECK(outcomes["wrong"] > 0);  // nothing says so: these are the departure `checks`
  CHECK(outcomes["same"] > outcomes["wrong"]);
}

}  // namespace cnrg::bench::baseline_test
