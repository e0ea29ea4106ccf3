// Sweeps systems over problems: each run in a process with limits, judged against the exact result, a row each.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/command.h"
#include "bench/peers/program.h"
#include "bench/sweep/plan.h"
#include "bench/sweep/schedule.h"
#include "bench/sweep/store.h"
#include "csg/app/progress_bar.h"
#include "csg/text/escape.h"
#include "kernel/exact/rational.h"

namespace cnrg::bench {
namespace {

struct Options {
  Choice choice;
  std::vector<std::string> systems, programs, one;
  std::string out, commit, command;
  double seconds = 60, gigabytes = 4;
  int jobs = 1;
  bool list = false, units = false, describe = false, quiet = false;
};

/// A message on one line, whatever is in the names of files and in the words of other programs.
void say(const std::string& message) { std::fprintf(stderr, "bench/run: %s\n", shown(message).c_str()); }

/// NAME=PROGRAM or NAME=PROGRAM:ROUNDING.
System program_of(const std::string& text) {
  const NamedProgram program = named_program(text);
  if (program.name == kTruth)
    throw std::runtime_error("'truth' is no name of a system: it says who confirms the exact result");
  return external_system(program.name, program.path, program.rounding);
}

Setup setup_of(const Options& options) {
  Setup setup;
  setup.commit = options.commit;
  setup.limits = {options.seconds, static_cast<std::size_t>(options.gigabytes * (1 << 30))};
  setup.systems = systems();
  for (const std::string& text : options.programs) {
    const System system = program_of(text);
    for (const System& other : setup.systems)
      if (other.name == system.name) throw std::runtime_error("there is a system '" + other.name + "' already");
    setup.systems.push_back(system);
  }
  return setup;
}

/// Those asked for and the programs of the user, or all that can run here.
std::vector<std::string> chosen_systems(const Setup& setup, const Options& options) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const std::string& name : options.systems) {
    const System& system = setup.system(name);
    if (!system.absent.empty()) throw std::runtime_error(name + ": " + system.absent);
    add(name);
  }
  for (const System& system : setup.systems) {
    if (!options.systems.empty() && system.executable.empty()) continue;
    if (system.absent.empty()) add(system.name);
    else say("notice: " + system.name + " is left out: " + system.absent);
  }
  return names;
}

void list_all(const Setup& setup) {
  std::printf("Families:\n");
  for (const Family& f : families()) {
    std::string sizes, operations;
    for (const long size : f.sizes) sizes += " " + std::to_string(size);
    for (const std::string& operation : f.operations) operations += " " + operation;
    std::printf("  %-14s %s\n  %-14s %s:%s;%s%s; seeds 1 to %d\n", f.name.c_str(), f.title.c_str(), "",
                f.size_means.c_str(), sizes.c_str(), operations.c_str(),
                f.has_distance ? "; distance exact or 10^-k" : "", f.seeds);
  }
  std::printf("Systems:\n");
  for (const System& s : setup.systems)
    std::printf("  %-14s %s, %s: %s\n", s.name.c_str(), s.title.c_str(),
                s.absent.empty() ? shown(s.version()).c_str() : "absent",
                s.absent.empty() ? s.guarantee.c_str() : shown(s.absent).c_str());
}

/// One unit: its record goes to the folder of the sweep, or is shown.
int run_one(const Options& options, Setup& setup) {
  const std::string &problem = options.one[0], &system = options.one[1];
  const Choice& choice = options.choice;
  const std::pair<bool, const char*> chosen[] = {{!choice.sizes.empty(), "--sizes"},
                                                 {!choice.distances.empty(), "--distances"},
                                                 {!choice.operations.empty(), "--operations"},
                                                 {choice.seeds.has_value(), "--seeds"},
                                                 {choice.first_seed.has_value(), "--first-seed"},
                                                 {choice.limit > 0, "--limit"},
                                                 {!options.systems.empty(), "--systems"},
                                                 {options.units, "--units"},
                                                 {options.describe, "--describe"}};
  for (const auto& [given, option] : chosen)  // a workflow repeats the options of its sweep, which has a folder
    if (given && options.out.empty())
      throw std::runtime_error(std::string(option) + " means nothing with --one: leave it out");
  for (const std::string& name : choice.names) {
    const bool folder = std::filesystem::is_directory(name);
    if (folder) setup.folder = std::filesystem::canonical(name).string();
    if (options.out.empty() && (choice.names.size() > 1 || !folder))
      throw std::runtime_error("'" + name +
                               "' means nothing with --one, which takes one folder of meshes at most");
  }
  std::optional<Store> store;
  if (!options.out.empty()) {
    store.emplace(options.out);
    store->settle(setup);
  }
  if (system == kTruth) {
    const Truth truth = establish_truth(setup, problem);
    if (store) store->write_truth(problem, truth);
    else std::cout << shown_json(to_json(truth)) << '\n';
    return 0;
  }
  const std::optional<Truth> known = store ? store->truth(problem) : std::nullopt;
  const SweepRow row = run_unit(setup, problem, system, known ? *known : establish_truth(setup, problem));
  if (store) store->write_row(row);
  else std::cout << shown_json(to_json(row)) << '\n';
  return 0;
}

std::string duration(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  char text[40];
  std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
  return text;
}

std::vector<Unit> missing_units(const Store& store, const Plan& plan, const std::vector<std::string>& systems) {
  std::vector<Unit> units;
  for (const std::string& problem : plan.problems) {
    if (!store.truth(problem)) units.push_back({problem, kTruth});
    for (const std::string& system : systems)
      if (!store.has_row(problem, system)) units.push_back({problem, system});
  }
  return units;
}

/// Words of the command that runs a unit, up to its problem.
std::vector<std::string> unit_command(const Options& options, const Setup& setup) {
  char seconds[40], gigabytes[40];
  std::snprintf(seconds, sizeof seconds, "%.17g", options.seconds);
  std::snprintf(gigabytes, sizeof gigabytes, "%.17g", options.gigabytes);
  std::vector<std::string> words{std::filesystem::read_symlink("/proc/self/exe").string(),
                                 "--out",
                                 options.out,
                                 "--seconds",
                                 seconds,
                                 "--gigabytes",
                                 gigabytes};
  if (!options.commit.empty()) words.insert(words.end(), {"--commit", options.commit});
  if (!setup.folder.empty()) words.push_back(setup.folder);
  for (const std::string& program : options.programs) words.insert(words.end(), {"--system", program});
  words.push_back("--one");
  return words;
}

/// What has no row. True if there is any.
bool say_failed(const std::vector<FailedUnit>& failed) {
  std::size_t broken = 0;
  for (const FailedUnit& f : failed) {
    if (f.waited) continue;
    ++broken;
    say("error: " + f.unit.system + " of " + f.unit.problem + " ended with status " + std::to_string(f.status) +
        " and has no row; run it again by --one");
  }
  return broken != 0;
}

/// Takes problems of files that cannot be read out of the plan, and says so. Their process is not this one.
Store::LeftOut check_problems(const Setup& setup, Plan& plan) {
  Store::LeftOut left_out;
  if (setup.folder.empty()) return left_out;
  const ChildResult child = run_child([&] {
    nlohmann::json faults = nlohmann::json::array();
    for (const std::string& problem : plan.problems) {
      try {
        setup.make(problem);
      } catch (const std::runtime_error& error) {
        faults.push_back({problem, error.what()});
      }
    }
    return faults.dump();
  });
  if (child.end != ChildResult::End::done || child.text.empty())
    throw std::runtime_error(setup.folder + ": reading its files ended without a result");
  left_out = nlohmann::json::parse(child.text).get<Store::LeftOut>();
  for (const auto& [problem, reason] : left_out) {
    say("left out: " + problem + ": " + reason);
    plan.problems.erase(std::find(plan.problems.begin(), plan.problems.end(), problem));
  }
  if (plan.problems.empty()) throw std::runtime_error(setup.folder + ": has no file that makes a problem");
  return left_out;
}

int sweep(const Options& options, Setup& setup) {
  Plan plan = plan_of(options.choice);
  setup.folder = plan.folder;
  const std::vector<std::string> names = chosen_systems(setup, options);
  const Store::LeftOut left_out = check_problems(setup, plan);
  if (options.units) {
    for (const std::string& problem : plan.problems)
      for (const std::string& system : names)
        std::printf("%s\t%s\n", shown(problem).c_str(), shown(system).c_str());
    return 0;
  }
  Store store(options.out);
  if (!options.describe) store.lock();
  store.settle(setup);
  store.describe(setup, options.command, left_out);
  if (options.describe) return 0;
  const std::vector<Unit> units = missing_units(store, plan, names);
  std::printf("%zu problems, %zu systems: %zu of %zu rows are there\n", plan.problems.size(), names.size(),
              plan.problems.size() * names.size() -
                  static_cast<std::size_t>(
                      std::count_if(units.begin(), units.end(), [](const Unit& u) { return u.system != kTruth; })),
              plan.problems.size() * names.size());
  std::fflush(stdout);
  app::ProgressBar bar(options.quiet);
  const std::vector<std::string> command = unit_command(options, setup);
  const std::vector<FailedUnit> failed = run_units(
      units, options.jobs,
      [&](const Unit& unit) {
        std::vector<std::string> words = command;
        words.insert(words.end(), {unit.problem, unit.system});
        return words;
      },
      [&](const Progress& p) {
        bar.show(p.seconds_left > 0 ? "sweep, " + duration(p.seconds_left) + " to go" : "sweep", p.done, p.total);
      });
  bar.clear();
  std::printf("%zu of %zu runs and confirmations done\n", units.size() - failed.size(), units.size());
  return say_failed(failed) ? 1 : 0;
}

/// CLI11's own range lets what is no number through.
CLI::Validator number_between(double low, double high) {
  std::ostringstream range;
  range << "a number from " << low << " to " << high;
  return CLI::Validator(
      [=, text = range.str()](const std::string& word) {
        const std::optional<Rational> value = parse_rational(word);
        return value && *value >= from_double(low) && *value <= from_double(high)
                   ? std::string()
                   : "'" + word + "' is not " + text;
      },
      "NUMBER");
}

/// The sweep ends with its children; nothing is lost.
void stop(int) {
  constexpr char kText[] = "\nbench/run: stopped; the same command goes on\n";
  if (write(STDERR_FILENO, kText, sizeof kText - 1) < 0) _exit(1);
  _exit(130);
}

int run(Options& options) {
  Setup setup = setup_of(options);
  if (options.list) {
    list_all(setup);
    return 0;
  }
  if (!options.one.empty()) return run_one(options, setup);
  if (options.out.empty()) options.out = "out/sweep";
  options.out = std::filesystem::absolute(options.out).string();
  std::signal(SIGINT, stop);
  return sweep(options, setup);
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) try {
  using namespace cnrg::bench;
  Options options;
  Choice& choice = options.choice;
  CLI::App program{
      "Systems over families of problems or a folder of meshes: what becomes of each. A sweep that was "
      "stopped goes on with the same command.\nExample: bench/run turned edge --seeds 3 --jobs 2",
      "bench/run"};
  program.footer(
      "A folder of meshes makes a problem of each two files that belong together by their names (x_left and "
      "x_right,\n"
      "src-x and cut-x, xA and xB), and of each other file with its copy turned about its middle. An open mesh is "
      "a\n"
      "surface. A report shows all rows of its folder: give each experiment its own --out.\n"
      "A program of your own is called as PROGRAM OPERATION A.off B.off OUT.off, with `union`, `intersection` or\n"
      "`difference`, and ends with status 0 when OUT.off is written. ROUNDING (1e-12) is how far its points may "
      "be\n"
      "off, as a part of the largest coordinate.");
  program.add_option("NAMES", choice.names, "Families, problems, `all`, or one folder of meshes");
  program.add_flag("--list", options.list, "List families and systems");
  program.add_option("--systems", options.systems, "Systems, all that can run otherwise")
      ->delimiter(',')
      ->allow_extra_args(false);
  program.add_option("--system", options.programs, "A program as a system of its own; see bench/peers/system.h")
      ->type_name("NAME=PROGRAM[:ROUNDING]")
      ->allow_extra_args(false);
  program.add_option("--sizes", choice.sizes, "Sizes instead of the usual ones")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::PositiveNumber);
  program.add_option("--distances", choice.distances, "`exact` and k from 0 to 16, instead of all")
      ->delimiter(',')
      ->allow_extra_args(false);
  program
      .add_option("--operations", choice.operations,
                  "Of union, difference, intersection, fold; of a folder union by default")
      ->delimiter(',')
      ->allow_extra_args(false);
  program.add_option("--seeds", choice.seeds, "Seeds of each, instead of the usual number")
      ->check(CLI::Range(1, 1000000));
  program.add_option("--first-seed", choice.first_seed, "The first seed (1)")->check(CLI::Range(1, 1000000000));
  program.add_option("--limit", choice.limit, "At most so many problems, spread evenly")
      ->check(CLI::Range(1, 1000000000));
  program.add_option("--out", options.out, "Folder of the rows (out/sweep)")->type_name("FOLDER");
  program.add_option("--jobs", options.jobs, "Runs at a time (1)")->check(CLI::Range(1, 1024));
  program.add_option("--seconds", options.seconds, "Time limit of a run (60)")->check(number_between(0.01, 1e5));
  program.add_option("--gigabytes", options.gigabytes, "Memory limit of a run (4)")
      ->check(number_between(0.01, 1e4));
  program.add_option("--commit", options.commit, "Of the sources, for the report");
  for (int i = 1; i < argc; ++i)  // bench/run gives the commit, people do not
    if (std::string(argv[i]) == "--commit") ++i;
    else options.command += " " + quoted(argv[i]);
  options.command = "bench/run" + options.command;
  program.add_flag("--quiet", options.quiet, "No progress bar");
  program.add_flag("--units", options.units, "Print problem and system of each row, and run nothing");
  program.add_flag("--describe", options.describe,
                   "Write what the report says of systems, families and this machine, and run nothing");
  program
      .add_option("--one", options.one, "Run one row, and print it, or with --out write it; SYSTEM may be `truth`")
      ->expected(2)
      ->type_name("PROBLEM SYSTEM");
  return command(program, argc, argv, [&] { return run(options); });
} catch (const std::bad_alloc&) {  // for the options
  std::fputs("bench/run: error: memory ran out\n", stderr);
  return 2;
}
