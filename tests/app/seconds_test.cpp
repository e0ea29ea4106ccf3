// Seconds of the rows add up: whoever waits learns for what.
#include <chrono>
#include <regex>
#include <sstream>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

/// The column `seconds` of all rows.
double sum_of_seconds(const std::string& table) {
  static const std::regex seconds("  +([0-9]+\\.[0-9]{3})(  \\S|$)");
  double sum = 0;
  std::istringstream lines(table);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_search(line, match, seconds)) sum += std::stod(match[1]);
  }
  return sum;
}

TEST_CASE("seconds of nodes and stages are all that the program takes", "[app][seconds]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  ball: {sphere: {center: [0, 0, 0], radius: 2, segments: 120}}
  bore: {cylinder: {from: [0, 0, -4], to: [0, 0, 4], radius: 1, segments: 120}}
  wall: {box: {min: [-3, -3, "1/3"], max: [3, 3, 3]}}
  left: {difference: [ball, bore]}
  r:    {intersection: [left, wall]}
result: r
)");
  for (const std::string options : {"", "--node left --topology -o r.json -o r.stl", "--certify --trace"}) {
    bool all = false;  // what is not told is the system's, which starts and ends a process, on a busy machine late
    for (int attempt = 0; attempt < 5 && !all; ++attempt) {
      const auto begin = std::chrono::steady_clock::now();
      const Outcome o = w.run("eval t.yaml " + options);
      const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      INFO(options << "\n" << o.out << o.err);
      REQUIRE(o.status == 0);
      const double told = sum_of_seconds(o.out.substr(0, o.out.find("\n\n")));
      CHECK(told <= wall + 0.02);  // every row is rounded
      all = told >= 0.8 * (wall - 0.2);
    }
    CHECK(all);
  }
}

TEST_CASE("stages are rows without a name", "[app][seconds]") {
  const Workshop w;
  w.write("flat.yaml", "cnrg: 1\nnodes: {leaves: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: leaves\n");
  Outcome o = w.run("eval flat.yaml");
  CHECK_THAT(o.out,
             Contains("\n        leaves ") && Contains("\n        refinement         8     12      6        2 "));
  CHECK_THAT(o.out, Contains("\n        results ") && Contains("\nleaves  box ") && !Contains("crossings"));
  w.write("round.yaml",
          "cnrg: 1\nnodes:\n  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}\n"
          "  b: {sphere: {center: [1, 0, 0], radius: 1, segments: 8}}\n  u: {union: [a, b]}\nresult: u\n");
  CHECK_THAT(w.run("eval round.yaml").out, Contains("      crossings "));
  CHECK(w.run("eval round.yaml --quiet").out.empty());
}

TEST_CASE("what was computed is told, also when a file cannot be written", "[app][seconds][errors]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes: {a: {polyline: [[0, 0, 0], [1, 1, 1]]}}\nresult: a\n");
  const Outcome o = w.run("eval t.yaml -o good.vtu -o t.stl");
  CHECK(o.status == 2);
  CHECK_THAT(o.out, Contains("polyline") && !Contains("results"));
  CHECK_THAT(o.err, Contains("t.yaml:2:9: error: "));
}

}  // namespace
}  // namespace cnrg
