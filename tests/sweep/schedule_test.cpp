// Units as small shell commands: order, limits of jobs, failures.
#include "bench/sweep/schedule.h"

#include <algorithm>
#include <sstream>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg::bench {
namespace {

/// Runs `command(unit)` in a folder, which gets a line in `log` per unit that ended well.
std::vector<FailedUnit> run_in(const Workshop& w, const std::vector<Unit>& units, int jobs,
                               const std::function<std::string(const Unit&)>& command,
                               std::vector<Progress>* seen = nullptr) {
  return run_units(
      units, jobs,
      [&](const Unit& u) {
        return std::vector<std::string>{"/bin/sh", "-c",
                                        "cd '" + w.path("").string() + "' && { " + command(u) + "; } && echo " +
                                            u.problem + "." + u.system + " >> log"};
      },
      [&](const Progress& p) {
        if (seen) seen->push_back(p);
      });
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

TEST_CASE("units wait for the truth of their problem, and problems are finished in turn") {
  const Workshop w;
  std::vector<Unit> units;
  for (const char* problem : {"p", "q"})
    for (const char* system : {"truth", "a", "b"}) units.push_back({problem, system});
  std::vector<Progress> seen;
  CHECK(run_in(
            w, units, 1, [](const Unit&) { return "true"; }, &seen)
            .empty());
  CHECK(lines(w.read("log")) == std::vector<std::string>{"p.truth", "p.a", "p.b", "q.truth", "q.a", "q.b"});
  REQUIRE(seen.size() == 7);
  CHECK(seen.front().done == 0);
  CHECK(seen.back().done == 6);
  CHECK(seen.back().total == 6);
  CHECK(seen[1].seconds_left > 0);
  CHECK(seen.back().seconds_left == 0);
}

TEST_CASE("what waits for a truth that fails is not run") {
  const Workshop w;
  const std::vector<Unit> units{{"p", "truth"}, {"p", "a"}, {"q", "truth"}, {"q", "a"}, {"q", "b"}};
  const auto failed = run_in(w, units, 2, [](const Unit& u) {
    return u.problem == "p" ? "exit 4" : u.system == "b" ? "kill -9 $$" : "true";
  });
  REQUIRE(failed.size() == 3);
  std::size_t waited = 0;
  for (const FailedUnit& f : failed) {
    waited += f.waited;
    if (f.unit.system == "b") CHECK(f.status == -9);
    else CHECK(f.status == 4);
  }
  CHECK(waited == 1);
  auto done = lines(w.read("log"));
  std::sort(done.begin(), done.end());
  CHECK(done == std::vector<std::string>{"q.a", "q.truth"});
}

TEST_CASE("no more jobs than asked for, and not fewer") {
  const Workshop w;
  std::vector<Unit> units;
  for (int i = 0; i < 12; ++i) units.push_back({"p" + std::to_string(i), "a"});
  // Each says how many run while it does.
  CHECK(run_in(w, units, 3, [](const Unit& u) {
          return "mkdir run." + u.problem + "; sleep 0.1; ls -d run.* 2>/dev/null | wc -l >> count; rmdir run." +
                 u.problem;
        }).empty());
  std::vector<int> counts;
  for (const std::string& line : lines(w.read("count"))) counts.push_back(std::stoi(line));
  REQUIRE(counts.size() == 12);
  CHECK(*std::max_element(counts.begin(), counts.end()) <= 3);
  CHECK(*std::max_element(counts.begin(), counts.end()) >= 2);
}

}  // namespace
}  // namespace cnrg::bench
