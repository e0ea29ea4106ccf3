// Sweeps systems over problems: each run in a process with limits, judged against the exact result, a row each.
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>

#include "bench/command.h"
#include "bench/peers/program.h"
#include "bench/sweep/json_fields.h"
#include "bench/sweep/keep.h"
#include "bench/sweep/node_unit.h"
#include "bench/sweep/schedule.h"
#include "bench/sweep/store.h"
#include "csg/app/progress_bar.h"
#include "csg/text/escape.h"
#include "kernel/exact/rational.h"

namespace cnrg::bench {
namespace {

struct Options {
  std::vector<std::string> names, given, systems, programs, one;
  std::size_t limit = 0;
  std::string out, keep, commit, command;
  std::optional<double> seconds, gigabytes;
  int jobs = 1;
  bool list = false, dry_run = false, describe = false, quiet = false;
};

/// A message on one line, whatever is in the names of files and in the words of other programs.
void say(const std::string& message) { std::fprintf(stderr, "bench/run: %s\n", shown(message).c_str()); }

/// NAME=PROGRAM or NAME=PROGRAM:ROUNDING.
System program_of(const std::string& text) {
  const NamedProgram program = named_program(text);
  System system = external_system(program.name, {program.path}, program.rounding);
  system.executable = program.path;
  return system;
}

void add_system(Setup& setup, System system) {
  if (system.name == kTruth)
    throw std::runtime_error("'truth' is no name of a system: it says who confirms the exact result");
  for (const System& other : setup.systems)
    if (other.name == system.name) throw std::runtime_error("there is a system '" + other.name + "' already");
  setup.systems.push_back(std::move(system));
}

/// A system that its name says how to make is added. Throws std::runtime_error for one that nobody knows.
void make_known(Setup& setup, const std::string& name) {
  const auto is_named = [&](const System& system) { return system.name == name; };
  if (std::any_of(setup.systems.begin(), setup.systems.end(), is_named)) return;
  if (std::optional<System> system = mantyla_variant(name)) setup.systems.push_back(std::move(*system));
  else setup.system(name);
}

/// Its programs, the systems that it names, and its problems.
void add_experiment(Setup& setup, const std::string& name, Experiment experiment, std::set<std::string>& known) {
  for (const Experiment& other : setup.experiments)
    if (other.name == experiment.name)
      throw std::runtime_error("the experiment " + other.name + " is there twice");
  for (const ProgramSystem& program : experiment.programs) {
    const auto same = [&](const Experiment& other) {
      return std::find(other.programs.begin(), other.programs.end(), program) != other.programs.end();
    };
    if (std::any_of(setup.experiments.begin(), setup.experiments.end(), same)) continue;
    System system = external_system(program.name, program.words, program.rounding);
    add_system(setup, program.rescale ? rescaled(std::move(system), *program.rescale, program.rounding) : system);
  }
  try {
    for (const std::string& system : experiment.systems) make_known(setup, system);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(experiment.path + ": " + error.what());
  }
  std::vector<Experiment::Named> problems = experiment.problems();
  if (problems.empty()) throw std::runtime_error(name + ": holds no OFF, OBJ, STL or PLY file");
  for (Experiment::Named& problem : problems) {
    if (!known.insert(problem.name).second)
      throw std::runtime_error("two experiments have a problem " + problem.name + "; rename one of the files");
    setup.problems.push_back({setup.experiments.size(), std::move(problem)});
  }
  setup.experiments.push_back(std::move(experiment));
}

/// Systems, experiments, and their problems: all, or those whose names are given.
Setup setup_of(const Options& options) {
  Setup setup;
  setup.commit = options.commit;
  setup.seconds = options.seconds;
  setup.gigabytes = options.gigabytes;
  setup.systems = systems();
  setup.asserted = std::filesystem::read_symlink("/proc/self/exe").replace_filename("bench_asserted").string();
  if (!std::filesystem::exists(setup.asserted))
    throw std::runtime_error(setup.asserted + " is missing, which has CGAL's systems with assertions; build it");
  for (const std::string& text : options.programs) add_system(setup, program_of(text));
  std::vector<GivenValues> given;
  for (const std::string& text : options.given) given.push_back(given_values(text));
  std::set<std::string> used, known;
  std::vector<std::string> names;
  for (const std::string& name : options.names) {
    if (name != "all") {
      names.push_back(name);
      continue;
    }
    const std::vector<std::string> all = experiment_names();
    names.insert(names.end(), all.begin(), all.end());
  }
  for (const std::string& name : names)
    for (Experiment& experiment : read_experiments(name, given, used))
      add_experiment(setup, name, std::move(experiment), known);
  for (const std::string& system : options.systems) make_known(setup, system);
  if (options.one.size() == 2 && options.one[1] != kTruth) make_known(setup, options.one[1]);
  for (const GivenValues& values : given)
    if (!used.contains(values.name))
      throw std::runtime_error("-D " + values.name + ": no experiment here has values for this parameter" +
                               "; add it to `values` of a file");
  return setup;
}

/// Those asked for, or of the experiment, and the programs of the command line; otherwise all that can run here.
std::vector<std::string> chosen_systems(const Setup& setup, const Options& options, const Experiment& experiment) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  const auto compares = [&](const System& system) { return can_compare(system, experiment.compared); };
  const std::vector<std::string>& asked = options.systems.empty() ? experiment.systems : options.systems;
  for (const std::string& name : asked) {
    const System& system = setup.system(name);
    if (!system.absent.empty()) throw std::runtime_error(name + ": " + system.absent);
    if (compares(system)) add(name);
  }
  const auto of_a_file = [&](const std::string& name) {
    for (const Experiment& e : setup.experiments)
      for (const ProgramSystem& program : e.programs)
        if (program.name == name) return true;
    return false;
  };
  for (const System& system : setup.systems)
    if (system.absent.empty() && compares(system) &&
        (!system.executable.empty() || (asked.empty() && !system.if_named && !of_a_file(system.name))))
      add(system.name);
  return names;
}

void list_all(const Setup& setup, const std::vector<std::string>& names) {
  std::printf("Experiments:\n");
  std::set<std::string> used;
  for (const std::string& name : names) {
    const Experiment e = read_experiments(name, {}, used).at(0);
    std::printf("  %-14s %s\n", shown(e.name).c_str(), shown(e.title).c_str());
    for (const Parameter& p : e.parameters) {
      constexpr std::size_t kShown = 8;
      std::string values = p.values[0];
      for (std::size_t i = 1; i < std::min(kShown, p.values.size()); ++i) values += ", " + p.values[i];
      if (p.values.size() > kShown) values += (p.values.size() > kShown + 1 ? ", ..., " : ", ") + p.values.back();
      std::printf("  %-14s %s: %s%s\n", "", p.name.c_str(), values.c_str(),
                  p.means.empty() ? "" : (" (" + shown(p.means) + ")").c_str());
    }
  }
  std::printf("Systems:\n");
  for (const System& s : setup.systems)
    std::printf("  %-14s %s, %s: %s\n", s.name.c_str(), s.title.c_str(),
                s.absent.empty() ? shown(s.version()).c_str() : "absent",
                s.absent.empty() ? s.guarantee.c_str() : shown(s.absent).c_str());
}

/// The experiment of this source that has the problem, by the longest name.
std::string own_experiment(const std::string& problem) {
  std::string found;
  for (const std::string& name : experiment_names())
    if (problem.starts_with(name + "-") && name.size() > found.size()) found = name;
  if (found.empty())
    throw std::runtime_error("'" + problem +
                             "' is no problem of an experiment of this source; name its file before --one");
  return found;
}

/// One unit: its record goes to the folder of the sweep, or is shown.
int run_one(Options& options) {
  const std::string &problem = options.one[0], &system = options.one[1];
  const std::pair<bool, const char*> chosen[] = {{options.limit > 0, "--limit"},
                                                 {!options.systems.empty(), "--systems"},
                                                 {options.dry_run, "--dry-run"},
                                                 {options.describe, "--describe"}};
  for (const auto& [given, option] : chosen)  // a workflow repeats the options of its sweep, which has a folder
    if (given && options.out.empty())
      throw std::runtime_error(std::string(option) + " means nothing with --one: leave it out");
  if (options.names.empty()) options.names = {own_experiment(problem)};
  const Setup setup = setup_of(options);
  setup.planned(problem);
  const Compared compared = setup.experiment_of(problem).compared;
  if (!options.keep.empty() && compared != Compared::results)
    throw std::runtime_error(
        "--keep keeps the result of a system, and here a system has none: look at the node itself");
  if (system != kTruth && !can_compare(setup.system(system), compared))
    throw std::runtime_error(system + " cannot compare " + (compared == Compared::sets ? "sets" : "regions"));
  std::optional<Store> store;
  if (!options.out.empty()) {
    store.emplace(options.out);
    store->settle(setup);
  }
  if (system == kTruth) {
    if (!options.keep.empty()) throw std::runtime_error("--keep means nothing for the truth: name a system");
    const Truth truth = establish_truth(setup, problem);
    if (store) store->write_truth(problem, truth);
    else std::cout << to_json(truth) << '\n';
    return 0;
  }
  const std::optional<Truth> known =
      store ? store->truth(problem, setup.experiment_of(problem).path) : std::nullopt;
  std::optional<Model> result;
  const SweepRow row = run_unit(setup, problem, system, known ? *known : establish_truth(setup, problem), &result);
  if (!options.keep.empty()) keep_tree(options.keep, setup.make(problem), result, row);
  if (store) store->write_row(row);
  else std::cout << to_json(row) << '\n';
  return 0;
}

std::string duration(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  char text[40];
  std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
  return text;
}

/// Of each experiment, the systems that get its problems.
std::vector<std::vector<std::string>> systems_of(const Setup& setup, const Options& options) {
  std::vector<std::vector<std::string>> systems;
  for (const Experiment& experiment : setup.experiments)
    systems.push_back(chosen_systems(setup, options, experiment));
  return systems;
}

std::vector<Unit> missing_units(const Store& store, const Setup& setup,
                                const std::vector<std::vector<std::string>>& systems) {
  std::vector<Unit> units;
  for (const auto& [experiment, problem] : setup.problems) {
    if (!store.truth(problem.name, setup.experiments[experiment].path)) units.push_back({problem.name, kTruth});
    for (const std::string& system : systems[experiment])
      if (!store.has_row(problem.name, system)) units.push_back({problem.name, system});
  }
  return units;
}

/// Words of the command that runs a unit, up to its problem.
std::vector<std::string> unit_command(const Options& options) {
  std::vector<std::string> words{std::filesystem::read_symlink("/proc/self/exe").string(), "--out", options.out};
  const auto add_number = [&](const char* option, const std::optional<double>& value) {
    char text[40];
    if (!value) return;
    std::snprintf(text, sizeof text, "%.17g", *value);
    words.insert(words.end(), {option, text});
  };
  add_number("--seconds", options.seconds);
  add_number("--gigabytes", options.gigabytes);
  if (!options.commit.empty()) words.insert(words.end(), {"--commit", options.commit});
  for (const std::string& given : options.given) words.insert(words.end(), {"-D", given});
  for (const std::string& program : options.programs) words.insert(words.end(), {"--system", program});
  words.insert(words.end(), options.names.begin(), options.names.end());
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

/// At most `limit`, spread evenly, so that the first and all kinds stay; 0: all.
void thin_out(std::vector<Setup::Planned>& problems, std::size_t limit) {
  if (limit == 0 || problems.size() <= limit) return;
  std::vector<Setup::Planned> some;
  for (std::size_t i = 0; i < limit; ++i) some.push_back(problems[i * problems.size() / limit]);
  problems = std::move(some);
}

/// Takes problems that cannot be made out of the plan, and says so, unless they were made before. Their processes
/// are not this one.
Store::LeftOut check_problems(Setup& setup, const Store* store) {
  std::map<std::string, std::vector<std::string>> problems;  // by reason
  Store::LeftOut left_out;
  const auto check = [&](std::size_t from, std::size_t to) {
    return [&, from, to] {
      nlohmann::json faults = nlohmann::json::array();
      for (std::size_t i = from; i < to; ++i) {
        const auto& [experiment, problem] = setup.problems[i];
        if (store != nullptr && std::filesystem::exists(store->truth_path(problem.name))) continue;
        try {
          setup.experiments[experiment].check(problem);
        } catch (const std::runtime_error& error) {
          faults.push_back({problem.name, error.what()});
        }
      }
      return json_text(faults);
    };
  };
  // Programs of others may not end: each is a process with the limits of a run.
  for (std::size_t from = 0; from < setup.problems.size();) {
    const auto of = [&](std::size_t i) { return setup.problems[i].experiment; };
    const bool alone = !setup.experiments[of(from)].program.empty();
    std::size_t to = from + 1;
    while (!alone && to < setup.problems.size() && of(to) == of(from)) ++to;
    const std::string& first = setup.problems[from].problem.name;
    const ChildResult child = run_child(check(from, to), alone ? setup.limits(first) : Limits());
    if (child.end == ChildResult::End::done && !child.text.empty()) {
      for (const auto& [problem, reason] : nlohmann::json::parse(child.text).get<Store::LeftOut>())
        left_out.emplace_back(problem, reason);
    } else {
      left_out.emplace_back(first, alone ? setup.experiments[of(from)].program[0] + ": ended without a tree"
                                         : "its check ended without a result");
    }
    from = to;
  }
  if (!left_out.empty() && left_out.size() == setup.problems.size()) throw std::runtime_error(left_out[0].second);
  std::set<std::string> gone;
  for (const auto& [problem, reason] : left_out) {
    problems[reason].push_back(problem);
    gone.insert(problem);
  }
  for (const auto& [reason, names] : problems)
    say("left out: " + names[0] + (names.size() > 1 ? " and " + std::to_string(names.size() - 1) + " more" : "") +
        ": " + reason);
  std::erase_if(setup.problems, [&](const auto& planned) { return gone.contains(planned.problem.name); });
  return left_out;
}

int sweep(const Options& options) {
  if (options.names.empty())
    throw std::runtime_error("name experiments, files or a folder of meshes; `--list` lists experiments");
  if (!options.keep.empty()) throw std::runtime_error("--keep keeps what one run has: it needs --one");
  Setup setup = setup_of(options);
  thin_out(setup.problems, options.limit);
  std::optional<Store> made;
  if (!options.dry_run) made.emplace(options.out);
  const Store::LeftOut left_out = check_problems(setup, made ? &*made : nullptr);
  const std::vector<std::vector<std::string>> systems = systems_of(setup, options);
  std::erase_if(setup.problems, [&](const auto& planned) { return systems[planned.experiment].empty(); });
  if (setup.problems.empty())
    throw std::runtime_error("none of these systems compares what the experiment asks for");
  std::size_t rows = 0;
  for (const Setup::Planned& planned : setup.problems) rows += systems[planned.experiment].size();
  if (options.dry_run) {
    for (const auto& [experiment, problem] : setup.problems)
      for (const std::string& system : systems[experiment])
        std::printf("%s\t%s\n", shown(problem.name).c_str(), shown(system).c_str());
    return 0;
  }
  for (const System& system : setup.systems)
    if (!system.absent.empty()) say("notice: " + system.name + " is left out: " + system.absent);
  Store& store = *made;
  if (!options.describe) store.lock();
  store.settle(setup);
  store.describe(setup, options.command, left_out);
  if (options.describe) return 0;
  const std::vector<Unit> units = missing_units(store, setup, systems);
  const auto missing = std::count_if(units.begin(), units.end(), [](const Unit& u) { return u.system != kTruth; });
  std::printf("%zu problems: %zu of %zu rows are there\n", setup.problems.size(),
              rows - static_cast<std::size_t>(missing), rows);
  std::fflush(stdout);
  app::ProgressBar bar(options.quiet);
  const std::vector<std::string> command = unit_command(options);
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

/// The sweep ends with its children; nothing is lost.
void stop(int) {
  constexpr char kText[] = "\nbench/run: stopped; the same command goes on\n";
  if (write(STDERR_FILENO, kText, sizeof kText - 1) < 0) _exit(1);
  _exit(130);
}

int run(Options& options) {
  if (options.list) {
    const std::vector<std::string> names = std::exchange(options.names, {});
    list_all(setup_of(options), names.empty() ? experiment_names() : names);
    return 0;
  }
  if (!options.one.empty()) return run_one(options);
  if (options.out.empty()) options.out = "out/sweep";
  options.out = std::filesystem::absolute(options.out).string();
  std::signal(SIGINT, stop);
  return sweep(options);
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) try {
  using namespace cnrg::bench;
  Options options;
  CLI::App program{
      "Experiments: systems on problems, and what becomes of each. One that was stopped goes on with the same "
      "command.\nExample: bench/run turned edge -D seed=1..3 --jobs 2",
      "bench/run"};
  program.footer(
      "An experiment is one of this source, a file (bench/README.md, Experiments), or a folder of meshes, which "
      "makes a\n"
      "problem of each two files that belong together by their names (x_left and x_right, src-x and cut-x, xA and "
      "xB),\n"
      "and of each other file with its copy turned about its middle. An open mesh is a surface. A report shows "
      "all\n"
      "rows of its folder: give each experiment its own --out.\n"
      "A program of your own is called as PROGRAM OPERATION A.off B.off OUT.off, with `union`, `intersection` or\n"
      "`difference`, and ends with status 0 when OUT.off is written. ROUNDING (1e-12) is how far its points may "
      "be\n"
      "off, as a part of the largest coordinate.");
  program.add_option("NAMES", options.names, "Experiments, files, a folder of meshes, or `all` of this source");
  program.add_flag("--list", options.list, "List experiments and systems");
  program
      .add_option("-D", options.given, "Values of a parameter in place of those of the experiment: k=exact,0..4")
      ->type_name("NAME=VALUES")
      ->allow_extra_args(false);
  program.add_option("--systems", options.systems, "Systems in place of those of the experiment, or of all")
      ->delimiter(',')
      ->allow_extra_args(false);
  program.add_option("--system", options.programs, "A program as a system of its own; see bench/peers/system.h")
      ->type_name("NAME=PROGRAM[:ROUNDING]")
      ->allow_extra_args(false);
  program.add_option("--limit", options.limit, "At most so many problems, spread evenly")
      ->check(CLI::Range(1, 1000000000));
  program.add_option("--out", options.out, "Folder of the rows (out/sweep)")->type_name("FOLDER");
  program.add_option("--jobs", options.jobs, "Runs at a time (1)")->check(CLI::Range(1, 1024));
  add_limits(program, options.seconds, options.gigabytes, ", in place of the experiment's");
  program.add_option("--commit", options.commit, "Of the sources, for the report");
  for (int i = 1; i < argc; ++i)  // bench/run gives the commit, people do not
    if (std::string(argv[i]) == "--commit") ++i;
    else options.command += " " + quoted(argv[i]);
  options.command = "bench/run" + options.command;
  program.add_flag("--quiet", options.quiet, "No progress bar");
  program.add_flag("--dry-run", options.dry_run, "Print problem and system of each row, and run nothing");
  program.add_flag("--describe", options.describe,
                   "Write what the report says of systems, experiments and this machine, and run nothing");
  program
      .add_option("--one", options.one, "Run one row, and print it, or with --out write it; SYSTEM may be `truth`")
      ->expected(2)
      ->type_name("PROBLEM SYSTEM");
  program
      .add_option(
          "--keep", options.keep,
          "With --one: a folder for a tree of the operands, the exact result, that of the system, and what "
          "differs")
      ->type_name("FOLDER");
  return command(program, argc, argv, [&] { return run(options); });
} catch (const std::bad_alloc&) {  // for the options
  std::fputs("bench/run: error: memory ran out\n", stderr);
  return 2;
}
