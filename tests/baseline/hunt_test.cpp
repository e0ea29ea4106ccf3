// A long search for disagreements; not run by default. CNRG_SEEDS and CNRG_FIRST_SEED choose the pairs.
#include <iostream>
#include <map>
#include <sstream>

#include "bench/baseline/mantyla.h"
#include "bench/baseline/scene.h"
#include "tests/baseline/oracle.h"
#include "tests/baseline/shapes.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg::bench::baseline_test {
namespace {

using Solid = Model (*)(Random&);

void hunt(Solid solid, std::uint64_t usual, bool turned = false) {
  const auto [first, last] = scenes::seeds(usual);
  std::map<std::string, std::pair<int, std::string>> verdicts;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    Model a = solid(random), b = solid(random);
    if (turned) {
      const std::array<Rational, 4> q = {7, 1, 2, random.integer(1, 5)};
      a = placed(std::move(a), q, 1, {0, 0, 0});
      b = placed(std::move(b), q, 1, {0, 0, 0});
    }
    for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
      const std::string name = std::to_string(seed) + " " + to_string(operation);
      const auto note = [&](const std::string& verdict) {
        auto& [count, example] = verdicts[verdict];
        if (count++ < 5) example += ", " + name;
      };
      Model exact;
      bool has_exact = false;
      try {
        exact = mantyla::boolean_exact(a, b, operation);
        has_exact = true;
      } catch (const mantyla::Failure& failure) {
        note(std::string("exact ") + to_string(failure.stage()) + ": " + failure.what());
      }
      try {
        const Truth truth = truth_of(a, b, operation, exact);
        if (has_exact) {
          const Counts counts = counts_of(exact);
          if (!truth.same_set) note("exact WRONG");
          else if (volume_of(exact) != truth.volume) note("exact VOLUME");
          else if (counts.vertices != truth.vertices || counts.faces != truth.faces || counts.edges != truth.edges)
            note("exact same set, other counts");
          else note("exact same");
        }
        const Model rounded_answer = mantyla::boolean_double(a, b, operation);
        const double error = to_double(volume_of(rounded_answer)) - to_double(truth.volume);
        note(std::fabs(error) < 1e-9 ? "double same volume" : "double WRONG volume");
      } catch (const mantyla::Failure& failure) {
        note(std::string("double ") + to_string(failure.stage()) + ": " + failure.what());
      } catch (const std::exception& error) {
        note(std::string("EXCEPTION ") + error.what());
      }
    }
  }
  for (const auto& [verdict, found] : verdicts)
    std::cout << found.first << "  " << verdict << found.second << "\n";
}

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
void hunt_folds(Solid solid, int steps, bool doubles, std::uint64_t usual) {
  const auto [first, last] = scenes::seeds(usual);
  std::map<std::string, std::pair<int, std::string>> verdicts;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    Random random(static_cast<unsigned>(seed));
    Model value = solid(random);
    for (int step = 0; step < steps; ++step) {
      const Model next = solid(random);
      const auto operation = static_cast<Operation>(random.integer(0, 5) < 4 ? random.integer(0, 1) : 2);
      const auto note = [&](const std::string& verdict) {
        auto& [count, example] = verdicts[verdict];
        if (count++ < 5) example += ", " + std::to_string(seed) + "." + std::to_string(step);
      };
      try {
        Model answer = doubles ? mantyla::boolean_double(value, next, operation)
                               : mantyla::boolean_exact(value, next, operation);
        const Truth truth = truth_of(value, next, operation, answer);
        const double error = std::fabs(to_double(Rational(volume_of(answer) - truth.volume)));
        note(truth.same_set ? "same" : doubles && error < 1e-9 ? "same volume" : "WRONG");
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
TEST_CASE("hunt with folds in general position", "[.][hunt]") { hunt_folds(random_solid, 4, false, 100); }
TEST_CASE("hunt with folds of doubles", "[.][hunt]") {
  hunt_folds(random_grid_solid, 4, true, 300);
  hunt_folds(random_solid, 4, true, 100);
}
TEST_CASE("hunt with folds on the grid", "[.][hunt]") { hunt_folds(random_grid_solid, 4, false, 300); }
/// Grid pairs, turned together: coplanar and collinear exactly, hardly ever after rounding.
TEST_CASE("hunt near the grid", "[.][hunt]") { hunt_near(100); }
TEST_CASE("hunt on the turned grid", "[.][hunt]") { hunt(random_grid_solid, 300, true); }
TEST_CASE("hunt in general position", "[.][hunt]") { hunt(random_solid, 300); }
TEST_CASE("hunt on the grid", "[.][hunt]") { hunt(random_grid_solid, 300); }

}  // namespace cnrg::bench::baseline_test
