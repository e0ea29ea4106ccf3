// Long searches whose counts papers/mantyla1986 publishes; not run by default. CNRG_SEEDS and CNRG_FIRST_SEED
// choose the pairs.
#include <iostream>
#include <map>

#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::bench::baseline_test {
namespace {

/// Grid pairs, one of them moved and turned by about 10^-k: how doubles fail near degeneracy.
void hunt_near(std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  for (int k = 2; k <= 16; ++k) {
    Rational distance = 1;
    for (int i = 0; i < k; ++i) distance /= 10;
    std::map<std::string, std::map<std::string, int>> verdicts;
    for (std::uint64_t seed = first; seed < last; ++seed) {
      Random random(static_cast<unsigned>(seed));
      const Model a = random_grid_solid(random);
      RationalPoint move;
      std::array<Rational, 4> q = {1, 0, 0, 0};
      for (int c = 0; c < 3; ++c) {
        move[c] = distance * random.integer(-9, 9) / 10;
        q[c + 1] = distance * random.integer(-9, 9) / 10;
      }
      const Model b = placed(random_grid_solid(random), q, 1, move);
      const auto operation = static_cast<Operation>(random.integer(0, 2));
      Rational volume = 0;
      try {
        const Model answer = mantyla::boolean_exact(a, b, operation);
        volume = volume_of(answer);
        ++verdicts["exact"][truth_of(a, b, operation, answer).same_set ? "same" : "WRONG"];
      } catch (const mantyla::Failure& failure) {
        ++verdicts["exact"][to_string(failure.stage())];
      }
      for (const bool checks : {true, false}) {
        mantyla::Departures departures;
        departures.checks = checks;
        auto& found = verdicts[checks ? "double" : "double, no checks"];
        try {
          const Model answer = mantyla::boolean_double(a, b, operation, 1e-10, departures);
          const double error = to_double(Rational(volume_of(answer) - volume));
          ++found[std::fabs(error) < 1e-9 ? "right" : std::fabs(error) < 1e-6 ? "within 1e-6" : "wrong"];
        } catch (const mantyla::Failure& failure) {
          ++found[to_string(failure.stage())];
        }
      }
    }
    std::cout << "k " << k << ':';
    for (const auto& [system, counts] : verdicts) {
      std::cout << "  " << system;
      for (const auto& [verdict, count] : counts) std::cout << ", " << verdict << ' ' << count;
    }
    std::cout << '\n';
  }
}

/// Folds of several solids: results are operands again.
void hunt_folds(int steps, std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  std::map<std::string, std::pair<int, std::string>> verdicts;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    Model value = random_grid_solid(random);
    for (int step = 0; step < steps; ++step) {
      const Model next = random_grid_solid(random);
      const auto operation = static_cast<Operation>(random.integer(0, 5) < 4 ? random.integer(0, 1) : 2);
      const auto note = [&](const std::string& verdict) {
        auto& [count, example] = verdicts[verdict];
        if (count++ < 5) example += ", " + std::to_string(seed) + "." + std::to_string(step);
      };
      try {
        Model answer = mantyla::boolean_exact(value, next, operation);
        note(truth_of(value, next, operation, answer).same_set ? "same" : "WRONG");
        value = std::move(answer);
      } catch (const mantyla::Failure& failure) {
        note(std::string(to_string(failure.stage())) + ": " + failure.what());
        break;
      } catch (const std::exception& error) {
        note(std::string("EXCEPTION ") + error.what());
        break;
      }
    }
  }
  for (const auto& [verdict, found] : verdicts)
    std::cout << found.first << "  " << verdict << found.second << "\n";
}

/// What each rule does on pairs of the grid whose boundaries cross, exactly: switched off in the baseline, and on
/// in the published algorithm with shells.
void hunt_departures(std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  mantyla::Departures published = mantyla::published(), no_shells;
  published.shells = true;
  no_shells.shells = false;
  std::map<std::string, std::map<std::string, int>> effects;  // by rule, which changes one outcome to another
  std::map<std::string, int> totals;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    const Model a = random_grid_solid(random), b = random_grid_solid(random);
    for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
      try {
        mantyla::boolean_exact(a, b, operation, no_shells);
      } catch (const mantyla::Failure&) {
        continue;  // no curve
      }
      const auto found = [&](const mantyla::Departures& departures) {
        const std::string text = outcome(a, b, operation, departures);
        return text == "same" || text == "wrong" ? text : "refused";
      };
      const std::string ours = found({}), theirs = found(published);
      ++totals["baseline " + ours];
      ++totals["published " + theirs];
      for (const mantyla::Departure& departure : mantyla::kDepartures) {
        mantyla::Departures without, with = published;
        without.*departure.rule = false;
        with.*departure.rule = true;
        ++effects[std::string("baseline -") + departure.name][found(without) + " to " + ours];
        ++effects[std::string("published +") + departure.name][theirs + " to " + found(with)];
      }
    }
  }
  for (const auto& [total, count] : totals) std::cout << total << ' ' << count << '\n';
  for (const auto& [rule, changes] : effects) {
    std::cout << rule << ':';
    for (const auto& [change, count] : changes) std::cout << "  " << change << ' ' << count;
    std::cout << '\n';
  }
}

}  // namespace

TEST_CASE("hunt for departures", "[.][hunt]") { hunt_departures(300); }
TEST_CASE("hunt with folds on the grid", "[.][hunt]") { hunt_folds(4, 300); }
TEST_CASE("hunt near the grid", "[.][hunt]") { hunt_near(100); }

}  // namespace cnrg::bench::baseline_test
