// Figures on pages are what bench/publish makes of bench/measured.json; those of whole jobs are computed here,
// too.
#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
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
        if (table.head[i] == "commit") {
          CHECK(row[i] == "`" + cases.at(name)["commit"].get<std::string>() + "`");
          continue;
        }
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

const std::string kPublish = "/usr/bin/python3 -B '" CNRG_SOURCES "/bench/publish/publish' ";

TEST_CASE("figures on pages are those that were measured", "[pages]") {
  const Outcome outcome = Workshop().shell(kPublish + "--check >.out 2>.err");
  CHECK(outcome.out == "");
  CHECK(outcome.err == "");
  CHECK(outcome.status == 0);
}

TEST_CASE("a page with another figure than the measured one is named", "[pages]") {
  const Workshop w;
  const auto check = [&](const Json& measured) {
    w.write("measured.json", measured.dump());
    return w.shell(kPublish + "--check --measured measured.json >.out 2>.err");
  };
  const Json measured = Json::parse(text_of(root() / "bench" / "measured.json"));
  std::size_t seen = 0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const std::string name = measured[i]["name"];
    CAPTURE(name);
    Json other = measured;
    other[i]["commit"] = "0123456";
    const Outcome outcome = check(other);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.find(".md: figures are not those of bench/measured.json") != std::string::npos);
    other.erase(i);
    // Without a case of whole jobs its row goes, of all else nothing is left to make a block of.
    CHECK(check(other).status == (measured[i].contains("rows") ? 1 : 2));
    ++seen;
  }
  CHECK(seen > 25);
}

TEST_CASE("files of a set that are missing or others are named with their source", "[pages]") {
  const Workshop w;
  std::filesystem::copy(root() / "bench" / "sets" / "check", w.path("check"));
  w.write("mine.yaml",
          "part:\n  from: somebody/models@0123 data\n  files: {a.off: 5891b5b522d5, b.off: 5891b5b522d5}\n");
  std::filesystem::create_directories(w.path("models/part"));
  const auto check = [&](const std::string& words) {
    return w.shell("/usr/bin/python3 -B check models " + words + " >.out 2>.err");
  };
  w.write("models/part/a.off", "hello\n");
  Outcome outcome = check("mine");
  const std::string end = "mine: 2 files in 1 folders looked at\n";
  CHECK(outcome.out == "mine: part lacks b.off; from somebody/models@0123 data\n" + end);
  CHECK(outcome.status == 1);
  w.write("models/part/b.off", "hello");
  outcome = check("");
  CHECK(outcome.out == "mine: part has other files than the list: b.off; from somebody/models@0123 data\n" + end);
  CHECK(outcome.status == 1);
  w.write("models/part/b.off", "hello\n");
  outcome = check("mine");
  CHECK(outcome.out == end);
  CHECK(outcome.status == 0);
  CHECK(check("yours").err.find("no set is called yours") != std::string::npos);
}

TEST_CASE("the lists of the sets are read", "[pages]") {
  const Outcome outcome =
      Workshop().shell("/usr/bin/python3 -B '" CNRG_SOURCES "/bench/sets/check' . >.out 2>.err");
  CHECK(outcome.err == "");
  CHECK(outcome.status == 1);
  CHECK(outcome.out.find("pairs: perf_pairs/irmb lacks bunny25k.obj") != std::string::npos);
}

}  // namespace
}  // namespace cnrg
