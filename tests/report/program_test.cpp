// The folder of rows and the program bench_report.
#include "tests/app/program.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/report/markup.h"
#include "tests/report/plausible.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

/// A folder with a small sweep in `rows`.
struct Sweep {
  Workshop workshop;
  Sweep() { write_sweep(workshop.path("rows").string(), plausible_sweep(2, 3, 1)); }
  Outcome run(const std::string& arguments) const { return workshop.run(arguments); }
  /// What is there besides the rows and the files of `Workshop`.
  std::size_t written() const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(workshop.path("."))) {
      const std::string name = entry.path().filename().string();
      count += name != "rows" && name[0] != '.';
    }
    return count;
  }
};

const char* const kRow = "rows/rows/face-union-s1-k0-r1/ours.json";

}  // namespace

TEST_CASE("a sweep becomes a page and a JSON") {
  const Sweep sweep;
  fs::create_directories(sweep.workshop.path("rows/.hidden"));
  sweep.workshop.write("rows/.hidden/x.json", "no row");
  sweep.workshop.write("rows/.x.json", "no row");
  sweep.workshop.write("rows/notes.txt", "no row");
  const Outcome outcome = sweep.run("rows -o page.html --json page.json --title 'A title'");
  CHECK(outcome.err == "");
  REQUIRE(outcome.status == 0);
  const std::string page = sweep.workshop.read("page.html");
  CHECK(markup_fault(page) == "");
  CHECK(page.find("<h1>A title</h1>") != std::string::npos);
  CHECK(page.find("Mäntylä, exact") != std::string::npos);
  CHECK(page.find("two boxes that share a whole face") != std::string::npos);
  const nlohmann::json json = nlohmann::json::parse(sweep.workshop.read("page.json"));
  CHECK(json.at("rows").size() == 2 * 3 * 18 * 3);
  CHECK(json.at("machine").at("date") == "2026-11-21");
  CHECK(sweep.written() == 2);
}

TEST_CASE("the machine of another file") {
  const Sweep sweep;
  MachineInfo machine;
  machine.cpu = "Another processor";
  sweep.workshop.write("other.json", to_json(machine));
  REQUIRE(sweep.run("rows -o page.html --machine other.json").status == 0);
  CHECK(sweep.workshop.read("page.html").find("Another processor") != std::string::npos);
  CHECK(sweep.run("rows -o page.html --machine missing.json").err ==
        "bench_report: error: missing.json: can not be read\n");
}

TEST_CASE("a broken file is named and nothing is written") {
  const Sweep sweep;
  const std::string good = sweep.workshop.read(kRow);
  const std::string remedy = "; remove the file and let the sweep make it again\n";
  sweep.workshop.write(kRow, good.substr(0, good.size() / 2));
  Outcome outcome = sweep.run("rows -o page.html --json page.json");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find(std::string("bench_report: error: ") + kRow + ": no JSON: parse error") == 0);
  CHECK(outcome.err.find(remedy) != std::string::npos);
  sweep.workshop.write(kRow, "{}");
  outcome = sweep.run("rows -o page.html --json page.json");
  CHECK(outcome.status == 2);
  CHECK(outcome.err == std::string("bench_report: error: ") + kRow + ": the row has no member `problem`" + remedy);
  sweep.workshop.write(kRow, good);
  sweep.workshop.write("rows/copy.json", good);
  outcome = sweep.run("rows -o page.html --json page.json");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("two rows of ours on face-union-s1-k0-r1; remove one") != std::string::npos);
  fs::remove(sweep.workshop.path("rows/copy.json"));
  sweep.workshop.write("rows/systems.json", "[{\"name\": 1}]");
  outcome = sweep.run("rows -o page.html --json page.json");
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "bench_report: error: rows/systems.json: member `name` of a system is not a text; correct or remove it\n");
  CHECK(sweep.written() == 0);
}

TEST_CASE("a folder without rows, and none") {
  const Sweep sweep;
  fs::create_directories(sweep.workshop.path("rows/empty"));
  Outcome outcome = sweep.run("rows/empty -o page.html");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("bench_report: error: rows/empty: there are no rows (*.json); give the folder") == 0);
  outcome = sweep.run("missing -o page.html");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("bench_report: error: missing: is no folder; give the one") == 0);
  outcome = sweep.run("rows -o page.html --json rows/page.json");
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("write the report's JSON outside of it") != std::string::npos);
  CHECK(sweep.run("rows").status == 2);
  CHECK(sweep.run("rows -o missing/page.html").status == 2);
  CHECK(sweep.written() == 0);
}

TEST_CASE("without gnuplot the package is named") {
  const Sweep sweep;
  const Outcome outcome =
      sweep.workshop.shell("PATH=/nowhere '" CNRG_PROGRAM "' rows -o page.html --json page.json >.out 2>.err");
  CHECK(outcome.status == 2);
  CHECK(outcome.err == "bench_report: error: gnuplot was not found; install the package gnuplot-nox\n");
  CHECK(sweep.written() == 0);
}

TEST_CASE("descriptions come back as they were") {
  const PlausibleSweep sweep = plausible_sweep(15, 7, 1);
  CHECK(to_json(systems_of_json(to_json(sweep.systems))) == to_json(sweep.systems));
  CHECK(to_json(families_of_json(to_json(sweep.families))) == to_json(sweep.families));
  CHECK(to_json(machine_of_json(to_json(sweep.machine))) == to_json(sweep.machine));
  const SystemInfo back = systems_of_json(to_json(sweep.systems)).at(1);
  CHECK(back.title == "Mäntylä, double");
  CHECK(back.rounding == 1e-10);
  CHECK(back.regularized);
  CHECK_THROWS_WITH(make_experiment(sweep.rows, {sweep.systems[0], sweep.systems[0]}, {}, std::nullopt),
                    "`ours` is described twice; remove one of the two");
  CHECK_THROWS_WITH(make_experiment({}, sweep.systems, {}, std::nullopt), "there are no rows; run a sweep first");
}

TEST_CASE("ours comes first, then the order of the description, then names") {
  const Experiment experiment = make_experiment(
      {right_row("b10", "f10"), right_row("b9", "f9"), right_row("ours", "f9"), right_row("z", "g")},
      {{"z", "Z", "", "", 0, true, ""}, {"ours", "O", "", "", 0, true, ""}}, {{"g", "G", ""}}, std::nullopt);
  std::vector<std::string> systems, families;
  for (const SystemInfo& info : experiment.systems) systems.push_back(info.name);
  for (const FamilyInfo& info : experiment.families) families.push_back(info.name);
  CHECK(systems == std::vector<std::string>{"ours", "z", "b9", "b10"});
  CHECK(families == std::vector<std::string>{"g", "f9", "f10"});
  CHECK(experiment.rows[0].system == "z");
}

}  // namespace cnrg::bench
