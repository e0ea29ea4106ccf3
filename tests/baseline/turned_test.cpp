// A cube and its copy turned by 10^-k about an axis of both: the distance to degeneracy. Exact arithmetic never
// fails; doubles fail where the turn is near their epsilon, and say in which stage.
#include <cmath>
#include <iostream>
#include <map>

#include "bench/baseline/mantyla.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"

namespace cnrg::bench::baseline_test {
namespace {

/// The quaternion (w, axis) that turns by 2 atan(10^-k |axis| / 2), about 10^-k |axis|.
std::array<Rational, 4> turn(int k, const RationalPoint& axis) {
  Rational power = 1;
  for (int i = 0; i < k; ++i) power *= 10;
  return {power * 2, axis[0], axis[1], axis[2]};
}

struct Turn {
  const char* name;
  RationalPoint axis, through;
};

}  // namespace

TEST_CASE("a cube against itself turned by 10^-k") {
  const Model a = box({-1, -1, -1}, {1, 1, 1});
  std::map<std::string, int> outcomes;
  int failures = 0;
  const Turn turns[] = {{"its axis", {0, 0, 1}, {0, 0, 0}},
                        {"its edge", {0, 0, 1}, {-1, -1, 0}},
                        {"a skew axis", {Rational(1, 3), Rational(2, 3), Rational(2, 3)}, {0, 0, 0}}};
  for (int k = 0; k <= 16; ++k) {
    for (const auto& [name, axis, through] : turns) {
      const RationalPoint back = {-through[0], -through[1], -through[2]};
      const Model b = placed(placed(a, {1, 0, 0, 0}, 1, back), turn(k, axis), 1, through);
      for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
        INFO("k " << k << ", " << name << ", " << to_string(operation));
        const Model exact = mantyla::boolean_exact(a, b, operation);
        const Truth truth = truth_of(a, b, operation, exact);
        CHECK(truth.same_set);
        CHECK(volume_of(exact) == truth.volume);
        const double size = to_double(truth.volume);
        std::string outcome = "right";
        try {
          const Model answer = mantyla::boolean_double(rounded(a), rounded(b), operation);
          // A slice of 10^-k is the smallest result.
          if (std::fabs(to_double(volume_of(answer)) - size) > 1e-3 * size) outcome = "wrong";
        } catch (const mantyla::Failure& failure) {
          outcome = to_string(failure.stage());
        }
        ++outcomes[outcome];
        if (outcome != "right") ++failures;
        if (k <= 6) CHECK(outcome == "right");
      }
    }
  }
  CHECK(failures > 0);
  CHECK(outcomes.size() > 2);  // wrong ones and refused ones
  for (const auto& [outcome, count] : outcomes)
    std::cout << "turned cubes, double: " << count << ' ' << outcome << '\n';
}

}  // namespace cnrg::bench::baseline_test
