// Whole jobs by us, by CGAL's corefinement and Nef polyhedra and by programs of others, side by side in one run.
//
//   bench_speed [GROUP|CASE...] [options]      `--help` lists the options, `--list` the cases
//
// Without names, or with `table`: the cases of `kTable`, without Nef.
// Every run is a process of its own, which makes its case first; the systems take turns, so that a slow minute of
// the machine meets all of them. Times are of the measured part (peer.h). `peak MB` is what was resident at most
// during that part, `own MB` the same without what was resident before it: program and input. The first run of
// each system is checked after its measurement. What takes more than `kLongRun` runs once. Trees are for us alone.
// A file keeps the rows of each case as they were measured last. Exit status 1 if a result of ours is missing,
// wrong or invalid; targets that are not met are told and change nothing.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/cases/child.h"
#include "bench/command.h"
#include "bench/peers/program.h"
#include "bench/speed_report.h"

namespace cnrg::bench {
namespace {

/// `validate` costs several times what is measured.
constexpr std::size_t kValidatedTriangles = 650000;

constexpr double kLongRun = 10;  // seconds

constexpr const char* kTable[] = {"bunny100k+cow100k",  "armadillo",           "spheres1M",
                                  "triangle-boxes-200", "triangle-boxes-2000", "plate1000",
                                  "chain-2000",         "cut-spheres64",       "cut-spheres64-apart"};

struct Options {
  std::vector<std::string> names, programs;
  std::string meshes, json = "out/speed.json", commit;
  int rounds = 5, nef_rounds = 1, threads = 2;
  double nef_limit = 300;
  bool no_nef = false, list = false;
};

std::string written(const Outcome& o) {
  return nlohmann::json{{"stages", o.measures.stages},
                        {"base", o.measures.base_bytes},
                        {"peak", o.measures.peak_bytes},
                        {"vertices", o.vertices},
                        {"faces", o.faces},
                        {"volume", o.volume},
                        {"exact_volume", o.exact_volume},
                        {"cells", o.cells},
                        {"exact_share", o.exact_share},
                        {"invalid", o.invalid},
                        {"note", o.note}}
      .dump();
}

Outcome parsed(const nlohmann::json& in) {
  Outcome o;
  in.at("stages").get_to(o.measures.stages);
  in.at("base").get_to(o.measures.base_bytes);
  in.at("peak").get_to(o.measures.peak_bytes);
  in.at("vertices").get_to(o.vertices);
  in.at("faces").get_to(o.faces);
  in.at("volume").get_to(o.volume);
  in.at("exact_volume").get_to(o.exact_volume);
  in.at("cells").get_to(o.cells);
  in.at("exact_share").get_to(o.exact_share);
  in.at("invalid").get_to(o.invalid);
  in.at("note").get_to(o.note);
  return o;
}

/// A system in turn.
struct Contestant {
  Row row;
  std::function<Outcome(const Case& c, const Checks& checks, int threads)> evaluate;
  int threads = 1, rounds = 1;
  double limit = 0;  // seconds of the whole process; 0: none
  bool goes_on(int round) const {
    return round < rounds && row.failure.empty() && (row.runs.empty() || row.runs[0].seconds() < kLongRun);
  }
};

std::string with_threads(const std::string& name, int threads) {
  return name + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

std::vector<Contestant> contestants(const Options& options, const CaseResult& result) {
  const auto one = [](const std::string& name, bool ours, auto evaluate, int threads, int rounds, double limit) {
    Contestant c;
    c.row.system = name;
    c.row.ours = ours;
    c.evaluate = evaluate;
    c.threads = threads;
    c.rounds = rounds;
    c.limit = limit;
    return c;
  };
  std::vector<Contestant> all;
  const std::vector<int> threads = options.threads > 1 ? std::vector{options.threads, 1} : std::vector{1};
  for (const int n : threads)
    all.push_back(one(with_threads("cnrg", n), true, evaluate_ours, n, options.rounds, 0));
  if (result.of_trees()) return all;
  for (const std::string& text : options.programs) {
    const NamedProgram program = named_program(text);
    const auto evaluate = [path = program.path](const Case& c, const Checks& checks, int n) {
      return evaluate_program(path, c, checks, n);
    };
    for (const int n : threads)
      all.push_back(one(with_threads(program.name, n), false, evaluate, n, options.rounds, options.nef_limit));
  }
  all.push_back(one(kCorefinement, false, evaluate_corefinement, 1, options.rounds, options.nef_limit));
  // Growth is about our own sizes; there and in long cases Nef would take hours.
  if (!options.no_nef && result.group != "growth" && result.group != "long")
    all.push_back(one(kNef, false, evaluate_nef, 1, options.nef_rounds, options.nef_limit));
  if (!options.no_nef && result.group == "nary")
    all.push_back(one(kNefOneByOne, false, evaluate_nef_one_by_one, 1, options.nef_rounds, options.nef_limit));
  return all;
}

std::string failure_of(const ChildResult& child, double limit) {
  switch (child.end) {
    case ChildResult::End::timeout: return "no result in " + std::to_string(static_cast<int>(limit)) + " s";
    case ChildResult::End::out_of_memory: return "memory ran out";
    case ChildResult::End::crash: return "crashed, signal " + std::to_string(child.signal);
    case ChildResult::End::done: break;
  }
  if (child.text.empty()) return "ended without a result";
  return child.text[0] == '!' ? child.text.substr(1, child.text.find('\n') - 1) : "";
}

void run_once(Contestant& contestant, const Recipe& recipe) {
  Row& row = contestant.row;
  const bool first = row.runs.empty();
  const ChildResult child = run_child(
      [&] {
        try {
          const Case c = recipe.make();
          const Checks checks{first, first && c.triangles() <= kValidatedTriangles};
          return written(contestant.evaluate(c, checks, contestant.threads));
        } catch (const std::bad_alloc&) {
          throw;
        } catch (const std::exception& error) {
          return std::string("!") + error.what();
        }
      },
      {contestant.limit, 0});
  row.failure = failure_of(child, contestant.limit);
  if (!row.failure.empty()) return;
  const Outcome outcome = parsed(nlohmann::json::parse(child.text));
  if (first) row.checked = outcome;
  if (outcome.vertices != row.checked.vertices || outcome.faces != row.checked.faces) row.failure = "runs differ";
  row.runs.push_back(outcome.measures);
}

/// Vertices, edges and faces of the leaves as they are given.
std::size_t input_cells(const Case& c) {
  std::size_t cells = 0;
  for (const TriangleMesh& leaf : c.leaves) cells += leaf.points.size() + leaf.triangles.size() * 5 / 2;
  return cells;
}

/// The head of a result, by a process of its own: this one stays small.
CaseResult described(const Recipe& recipe, std::optional<long long>& volume) {
  const ChildResult child = run_child([&] {
    try {
      const Case c = recipe.make();
      nlohmann::json out{{"operation", c.trees.empty() ? to_string(c.operation) : kEvaluation},
                         {"leaves", std::max(c.leaves.size(), c.trees.size())},
                         {"triangles", c.triangles()},
                         {"input_cells", input_cells(c)}};
      if (c.volume) out["volume"] = *c.volume;
      return out.dump();
    } catch (const std::exception& error) {
      return std::string("!") + error.what();
    }
  });
  if (const std::string failure = failure_of(child, 0); !failure.empty())
    throw std::runtime_error(recipe.name + " could not be made: " + failure);
  const nlohmann::json in = nlohmann::json::parse(child.text);
  CaseResult result;
  result.name = recipe.name;
  result.group = recipe.group;
  in.at("operation").get_to(result.operation);
  in.at("leaves").get_to(result.leaves);
  in.at("triangles").get_to(result.triangles);
  in.at("input_cells").get_to(result.input_cells);
  if (in.contains("volume")) volume = in.at("volume").get<long long>();
  return result;
}

CaseResult run_case(const Recipe& recipe, const Options& options) {
  std::optional<long long> volume;
  CaseResult result = described(recipe, volume);
  std::vector<Contestant> all = contestants(options, result);
  for (int round = 0; round < std::max(options.rounds, options.nef_rounds); ++round) {
    for (Contestant& c : all) {
      if (c.goes_on(round)) run_once(c, recipe);
    }
  }
  for (Contestant& c : all) result.rows.push_back(std::move(c.row));
  judge(result, volume);
  return result;
}

/// The cases that the names mean, in the order of the list.
std::vector<Recipe> chosen(const std::vector<Recipe>& all, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const Recipe& r) { return r.name == name || r.group == name; });
    if (!known) throw std::runtime_error("'" + name + "' is no group and no case; `--list` lists them");
  }
  std::vector<Recipe> some;
  for (const Recipe& recipe : all) {
    if (std::any_of(names.begin(), names.end(),
                    [&](const std::string& n) { return n == recipe.name || n == recipe.group; }))
      some.push_back(recipe);
  }
  return some;
}

/// Degenerate cases are told beside one in general position.
void add_general_position(const std::vector<Recipe>& all, std::vector<Recipe>& some) {
  const auto has = [&](const std::string& name) {
    return std::any_of(some.begin(), some.end(),
                       [&](const Recipe& r) { return r.name == name || r.group == name; });
  };
  if (!has("degenerate") || has(kGeneralPosition)) return;
  some.push_back(
      *std::find_if(all.begin(), all.end(), [](const Recipe& r) { return r.name == kGeneralPosition; }));
}

/// `table`, which is also meant without names, is its cases.
Options completed(Options options) {
  for (const std::string& text : options.programs) named_program(text);  // before the work, not after it
  if (options.names.empty()) options.names = {"table"};
  const auto table = std::find(options.names.begin(), options.names.end(), "table");
  if (table == options.names.end()) return options;
  options.names.erase(table);
  options.names.insert(options.names.end(), std::begin(kTable), std::end(kTable));
  options.no_nef = true;
  return options;
}

/// Before the work, not after it: that the file can have rows.
void open_rows(const Options& options) {
  if (const auto folder = std::filesystem::path(options.json).parent_path(); !folder.empty()) {
    std::error_code ignored;  // the file tells
    std::filesystem::create_directories(folder, ignored);
  }
  write_json(options.json, options.commit, {});
}

int run(const Options& given) {
  const Options options = completed(given);
  const std::vector<Recipe> all = recipes(options.meshes);
  if (options.list) {
    for (const Recipe& recipe : all) {
      std::printf("%-12s %s%s\n", recipe.group.c_str(), recipe.name.c_str(),
                  recipe.missing.empty() ? "" : (" (" + recipe.missing + " below --meshes)").c_str());
    }
    return 0;
  }
  open_rows(options);
  std::vector<Recipe> some = chosen(all, options.names);
  add_general_position(all, some);
  std::vector<CaseResult> results;
  for (const Recipe& recipe : some) {
    if (!recipe.missing.empty()) {
      std::printf(
          "\n%s: left out: there is no %s below %s; the set `pairs` (bench/run sets) says where it is from\n",
          recipe.name.c_str(), recipe.missing.c_str(),
          options.meshes.empty() ? "the folder of --meshes, which is not given" : options.meshes.c_str());
      continue;
    }
    results.push_back(run_case(recipe, options));
    print_case(results.back());
    write_json(options.json, options.commit, {results.back()});
  }
  if (results.empty())
    throw std::runtime_error(
        "no case ran; give the folder of the meshes of bench/sets/pairs.yaml: --meshes FOLDER");
  print_summary(results);
  print_table(results);
  std::printf("\nrows: %s\n", options.json.c_str());
  return std::all_of(results.begin(), results.end(), [](const CaseResult& r) { return r.right(); }) ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  cnrg::bench::Options options;
  CLI::App program{"Whole jobs by cnrg, CGAL's corefinement and CGAL's Nef polyhedra, side by side.",
                   "bench_speed"};
  program.footer(
      "Without names, or with `table`: one table of all kinds of cases but the group `long`, without Nef.\n"
      "A program of another system is called as PROGRAM OPERATION A.off B.off... OUT.off, with `union` or "
      "`difference`\n"
      "(the first operand without all others); its threads are in the environment as CNRG_THREADS. What it "
      "measures\n"
      "itself it writes to standard error as a line `measured SECONDS BASE_BYTES PEAK_BYTES`; see\n"
      "bench/peers/external.");
  program.add_option("NAMES", options.names, "Groups (table pairs nary growth degenerate trees long) or cases");
  program.add_flag("--list", options.list, "List the cases");
  program.add_option("--meshes", options.meshes, "Folder of the meshes of `pairs`, searched through")
      ->type_name("FOLDER");
  program.add_option("--rounds", options.rounds, "Runs of each system (5)")->check(CLI::Range(1, 1000));
  program.add_option("--threads", options.threads, "Threads of the first row of who has them (2)")
      ->check(CLI::Range(1, 4096));
  program.add_option("--nef-rounds", options.nef_rounds, "Runs of Nef (1)")->check(CLI::Range(1, 1000));
  program.add_option("--nef-limit", options.nef_limit, "Longest run of a peer in seconds (300)")
      ->check(CLI::PositiveNumber);
  program.add_flag("--no-nef", options.no_nef, "Without Nef");
  program.add_option("--system", options.programs, "A program as one more system; ROUNDING is of sweeps alone")
      ->type_name("NAME=PROGRAM[:ROUNDING]")
      ->allow_extra_args(false);
  program.add_option("--json", options.json, "The file of the rows (out/speed.json)")->type_name("FILE");
  program.add_option("--commit", options.commit, "Of the sources, for the rows");
  return cnrg::bench::command(program, argc, argv, [&] { return cnrg::bench::run(options); });
}
