// Figures of benchmarks on their page are those of the rows that were measured.
#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/catch.h"
#include "tests/pages/tables.h"

namespace cnrg {
namespace {

using Json = nlohmann::json;

/// Two digits that count, seconds.
std::string figure(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, seconds < 99.5 ? "%.2g" : "%.0f", seconds);
  return text;
}

/// The median of the runs of a system, as it is written; empty if it has no row or no result.
std::string figure_of(const Json& measured, const std::string& system) {
  for (const Json& row : measured["rows"]) {
    if (row["system"] != system || !row.contains("seconds")) continue;
    auto seconds = row["seconds"].get<std::vector<double>>();
    if (seconds.empty()) return {};
    std::ranges::sort(seconds);
    const std::size_t half = seconds.size() / 2;
    return figure(seconds.size() % 2 == 1 ? seconds[half] : (seconds[half - 1] + seconds[half]) / 2);
  }
  return {};
}

TEST_CASE("the figures of whole jobs are the rows that were measured", "[pages]") {
  std::map<std::string, Json> cases;
  for (const Json& measured : Json::parse(text_of(root() / "bench" / "measured.json")))
    cases[measured["name"].get<std::string>()] = measured;
  const std::map<std::string, std::string> systems{
      {"ours", "cnrg"}, {"Manifold", "manifold"}, {"trueform", "trueform"}, {"corefinement", "CGAL corefinement"}};
  std::size_t compared = 0;
  for (const PageTable& table : tables_of(read_page(root() / "bench" / "README.md"))) {
    if (table.anchor != "what-was-measured" || table.head[0] != "case") continue;
    for (const std::vector<std::string>& row : table.rows) {
      const std::string name = quoted_words(row[0]).at(0);
      CAPTURE(name);
      REQUIRE(cases.contains(name));
      for (std::size_t i = 1; i < row.size(); ++i) {
        CAPTURE(table.head[i]);
        const std::string system = systems.at(table.head[i]);
        const std::string two = figure_of(cases.at(name), system + ", 2 threads"),
                          one = figure_of(cases.at(name), system + ", 1 thread");
        CHECK(row[i] == (two.empty() ? figure_of(cases.at(name), system) : two + " / " + one));
        ++compared;
      }
    }
  }
  CHECK(compared > 20);
}

}  // namespace
}  // namespace cnrg
