// The program bench_sweep as its users have it: bad input, a kill at any moment, limits, the workflow, the report.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "bench/sweep/row.h"
#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Rows of a folder by problem and system. Fails for files that are none, and for one row twice.
std::map<std::pair<std::string, std::string>, SweepRow> rows_of(const Workshop& w, const std::string& out) {
  std::map<std::pair<std::string, std::string>, SweepRow> rows;
  for (const auto& entry : fs::recursive_directory_iterator(w.path(out + "/rows"))) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = fs::relative(entry.path(), w.path(""));
    if (name.extension() == ".part") continue;                      // of a killed process; never read
    if (entry.path().parent_path().filename() == "rows") continue;  // systems, families, machine
    const SweepRow row = row_of_json(w.read(name.string()));
    CHECK(name.stem() == row.system);
    CHECK(rows.emplace(std::pair{row.problem, row.system}, row).second);
  }
  return rows;
}

TEST_CASE("bad input has one clear line", "[sweep]") {
  const Workshop w;
  w.write("empty/x", "");
  fs::create_directories(w.path("meshes"));
  w.write("meshes/t.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  fs::create_directories(w.path("nothing"));
  const auto fails = [&](const std::string& arguments, const std::string& with) {
    const Outcome o = w.run(arguments);
    INFO(arguments << "\n" << o.err);
    CHECK(o.status == 2);
    CHECK(o.out.empty());
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
    CHECK(o.err.find(with) != std::string::npos);
  };
  fails("trned", "'trned' is no experiment, file or folder; did you mean `turned`?");
  fails("", "--list");
  fails("turned --systems ours,nex", "there is no system 'nex'; did you mean `nef`?");
  fails("turned -D k=17", "0 to 16");
  fails("turned -D operation=fold", "no operation 'fold'");
  // What would be ignored.
  fails("turned -D n=2", "-D n: no experiment here has values for this parameter");
  fails("boxes -D k=2", "-D k: no experiment here has values for this parameter");
  for (const char* option : {"size=2", "k=3", "seed=2"})
    fails("meshes -D " + std::string(option), "no experiment here has values for this parameter");
  for (const char* option : {"--limit 3", "--systems nef", "--dry-run"})
    fails("--one turned-union-s1-k9-r2 ours " + std::string(option), "means nothing with --one: leave it out");
  fails("turned --keep out", "it needs --one");
  fails("all turned --dry-run --limit 1", "is there twice");
  fails("meshes -D operation=fold", "'fold' is no operation");
  for (const char* values : {"seed", "seed=", "seed=1,", "seed=1..x", "seed=3..1", "=3", "seed=1..0.5"})
    fails("turned -D " + std::string(values), values);
  fails("turned --jobs 0", "--jobs");
  fails("turned turned", "twice");
  fails("nothing", "holds no OFF, OBJ, STL or PLY file");
  fails("turned --system me=no/such/program", "there is no such program");
  fails("turned --system me", "NAME=PROGRAM");
  fails("turned --system truth=/bin/true", "no name of a system");
  fails("turned --system ../me=/bin/true", "no name of a system");
  fails("turned --system ours=/bin/true", "there is a system 'ours' already");
  fails("turned --system me=/bin/true:inf", "no rounding");
  fails("turned --seconds nan", "--seconds");
  fails("--systems ours trned", "'trned' is no experiment");
  fails("--one turned-union-s1 ours", "there is no problem 'turned-union-s1'");
  fails("--one trned-union-s1 ours", "name its file before --one");
}

TEST_CASE("a sweep that is killed goes on, and nothing is lost or there twice", "[sweep]") {
  const Workshop w;
  const std::string arguments =
      "edge -D operation=union -D k=exact,3,16 -D seed=1,2 -D size=4 "
      "--systems ours,mantyla-double,mantyla-exact,corefinement --out out --quiet --jobs 2";
  const Outcome units = w.run(arguments + " --dry-run");
  REQUIRE(units.status == 0);
  const auto count = static_cast<std::size_t>(std::count(units.out.begin(), units.out.end(), '\n'));
  REQUIRE(count == 3 * 2 * 4);
  // Killed again and again, each time a little later.
  std::map<std::string, fs::file_time_type> written;
  int kills = 0;
  for (const char* seconds : {"0.05", "0.3", "0.6"}) {
    const Outcome killed =
        w.shell("timeout -s KILL " + std::string(seconds) + " '" CNRG_PROGRAM "' " + arguments + " >.out 2>.err");
    if (killed.status != 0) ++kills;
    for (const auto& [path, time] : written) {
      INFO(path);
      CHECK(fs::last_write_time(path) == time);  // what was there is not done again
    }
    if (!fs::exists(w.path("out/rows"))) continue;
    for (const auto& entry : fs::recursive_directory_iterator(w.path("out/rows")))
      if (entry.path().extension() == ".json" && entry.path().parent_path().filename() != "rows")
        written[entry.path().string()] = entry.last_write_time();
  }
  CHECK(kills >= 1);
  const Outcome last = w.run(arguments);
  INFO(last.err);
  CHECK(last.status == 0);
  CHECK(rows_of(w, "out").size() == count);
  const Outcome again = w.run(arguments);
  CHECK(again.status == 0);
  CHECK(again.out.find(std::to_string(count) + " of " + std::to_string(count) + " rows are there") !=
        std::string::npos);
  // Another limit would mix two experiments.
  const Outcome other = w.run(arguments + " --seconds 7");
  CHECK(other.status == 2);
  CHECK(other.err.find("another folder by --out") != std::string::npos);
}

TEST_CASE("only one sweep has a folder at a time", "[sweep]") {
  const Workshop w;
  w.write("slow", "#!/bin/sh\nsleep 20\n");
  fs::permissions(w.path("slow"), fs::perms::owner_all);
  const std::string arguments =
      "turned -D operation=union -D k=exact -D seed=1 --system slow=slow "
      "--systems slow --out out --quiet";
  const Outcome o = w.shell("('" CNRG_PROGRAM "' " + arguments +
                            " >/dev/null 2>&1 & echo $! > pid); sleep 1; '" CNRG_PROGRAM "' " + arguments +
                            " >.out 2>.err; s=$?; kill -9 $(cat pid); exit $s");
  CHECK(o.status == 2);
  CHECK(o.err.find("another sweep is at work") != std::string::npos);
}

TEST_CASE("programs of the user: slow, greedy, crashing, refusing", "[sweep]") {
  const Workshop w;
  const auto program = [&](const std::string& name, const std::string& text) {
    w.write(name, "#!/bin/sh\n" + text + "\n");
    fs::permissions(w.path(name), fs::perms::owner_all);
    return " --system " + name + "=" + name;
  };
  const std::string programs = program("slow", "sleep 30") + program("crash", "kill -SEGV $$") +
                               program("refuse", "echo I cannot >&2; exit 3") +
                               program("first", "cp \"$2\" \"$4\"");
  const Outcome o = w.run(
      "face -D operation=union -D k=exact -D seed=1 -D size=4 --systems "
      "slow,crash,refuse,first --seconds 2 --out out --quiet" +
      programs);
  INFO(o.err);
  REQUIRE(o.status == 0);
  std::map<std::string, SweepRow> by_system;
  for (const auto& [key, row] : rows_of(w, "out")) by_system[row.system] = row;
  REQUIRE(by_system.size() == 4);
  CHECK(by_system["slow"].verdict == Verdict::timed_out);
  CHECK(by_system["refuse"].verdict == Verdict::refused);
  CHECK(by_system["refuse"].message.find("I cannot") != std::string::npos);
  CHECK(by_system["crash"].verdict == Verdict::crashed);
  CHECK(by_system["first"].verdict == Verdict::wrong);  // the first operand is not the union
  CHECK(by_system["first"].missing > 0);
  CHECK(by_system["first"].truth.confirmed == "Nef");
  CHECK(by_system["first"].command == "bench/run --one face-union-s4-kexact-r1 first --system first=" +
                                          fs::canonical(w.path("first")).string() + ":1e-12 --seconds 2");
}

TEST_CASE("what a program started ends with its run", "[sweep]") {
  const Workshop w;
  w.write("slow", "#!/bin/sh\nsleep 54321.5 &\necho $! >> '" + w.path("pids").string() + "'\nsleep 30\n");
  w.write("left", "#!/bin/sh\nsleep 54321.5 &\necho $! >> '" + w.path("pids").string() + "'\nexit 1\n");
  for (const char* name : {"slow", "left"}) fs::permissions(w.path(name), fs::perms::owner_all);
  REQUIRE(w.run("face -D operation=union -D k=exact -D seed=1 -D size=4 --systems slow,left --system "
                "slow=slow --system left=left --seconds 1 --out out --quiet")
              .status == 0);
  std::istringstream pids(w.read("pids"));
  int count = 0;
  for (int pid; pids >> pid; ++count) {
    bool gone = false;
    for (int wait = 0; wait < 50 && !gone; ++wait) {
      std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");  // `PID (NAME) STATE ...`
      std::string number, name, state;
      gone = !(stat >> number >> name >> state) || state == "Z";
      if (!gone) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    CHECK(gone);
  }
  CHECK(count == 2);
}

TEST_CASE("programs join a sweep that is there, and keep their names", "[sweep]") {
  const Workshop w;
  w.write("mine", "#!/bin/sh\ncp \"$2\" \"$4\"\n");
  w.write("other", "#!/bin/sh\ncp \"$3\" \"$4\"\n");
  for (const char* name : {"mine", "other"}) fs::permissions(w.path(name), fs::perms::owner_all);
  const std::string arguments = "face -D operation=union -D k=exact -D seed=1 -D size=4 --out out --quiet ";
  REQUIRE(w.run(arguments + "--systems ours").status == 0);
  REQUIRE(w.run(arguments + "--systems ours --system mine=mine").status == 0);
  CHECK(rows_of(w, "out").size() == 2);
  const Outcome o = w.run(arguments + "--systems ours --system mine=other");
  CHECK(o.status == 2);
  CHECK(o.err.find("another program mine") != std::string::npos);
  const Json machine = Json::parse(w.read("out/rows/machine.json"));
  CHECK(machine.at("command").get<std::string>().find("--system mine=mine") != std::string::npos);
}

TEST_CASE("a folder of meshes; a broken one is left out", "[sweep]") {
  const Workshop w;
  fs::create_directories(w.path("meshes"));
  const std::string cube =
      "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n"
      "4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  w.write("meshes/cube.off", cube);
  w.write("meshes/broken.off", "OFF\n3 1 0\n0 0 0\n1 0 x\n");
  const Outcome o = w.run("meshes --systems ours,nef --out out --quiet");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK(o.err.find("broken.off:4") != std::string::npos);
  const Json machine = Json::parse(w.read("out/rows/machine.json"));
  CHECK(machine.at("left_out").size() == 1);
  const auto rows = rows_of(w, "out");
  REQUIRE(rows.size() == 2);
  for (const auto& [key, row] : rows) {
    CHECK(row.verdict == Verdict::same);
    CHECK(row.family == "files");
    CHECK(row.truth.confirmed == "Nef");
  }
}

TEST_CASE("the workflow makes the same rows, with several jobs; then the report", "[sweep]") {
  const Workshop w;
  const std::string sweep =
      "vertex -D operation=union,intersection -D k=exact,6 -D seed=1 -D size=4 "
      "--systems ours,mantyla-exact";
  REQUIRE(w.run(sweep + " --out plain --quiet --jobs 2").status == 0);
  fs::create_directories(w.path("flow"));
  std::string words = sweep;
  std::replace(words.begin(), words.end(), ' ', '\n');
  w.write("flow/words", words + "\n");
  const Outcome o = w.shell("snakemake --snakefile '" CNRG_SNAKEFILE
                            "' --cores 2 --quiet --nolock --config program='" CNRG_PROGRAM "' report='" CNRG_REPORT
                            "' out=\"$PWD/flow\" >.out 2>.err");
  INFO(o.err);
  REQUIRE(o.status == 0);
  const auto plain = rows_of(w, "plain"), flow = rows_of(w, "flow");
  REQUIRE(plain.size() == 8);
  REQUIRE(flow.size() == plain.size());
  for (const auto& [key, row] : plain) {
    REQUIRE(flow.count(key) == 1);
    CHECK(flow.at(key).verdict == row.verdict);
    CHECK(flow.at(key).truth.facts.volume == row.truth.facts.volume);
  }
  const std::string page = w.read("flow/report.html");
  CHECK(page.find("</html>") != std::string::npos);
  CHECK(page.find("<svg") != std::string::npos);
  const Json numbers = Json::parse(w.read("flow/report.json"));
  REQUIRE(numbers.at("rows").size() == 8);
  for (Json row : numbers.at("rows")) {  // whole, but that the exact result is there once by problem
    const std::string problem = row.at("problem"), system = row.at("system");
    row["truth"] = numbers.at("truths").at(problem);
    if (row.at("facts") == "exact") row["facts"] = row.at("truth").at("facts");
    CHECK(row == Json::parse(w.read("flow/rows/" + problem + "/" + system + ".json")));
  }
  CHECK(fs::exists(w.path("flow/figures/failures.pdf")));
}

}  // namespace
}  // namespace cnrg::bench
