// `tests/campaign/run`: the command line of the campaign.
#include <CLI/CLI.hpp>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "kernel/base/error.h"
#include "tests/campaign/driver/campaign.h"
#include "tests/campaign/families/families.h"
#include "tests/oracles/nef_oracle.h"

namespace cnrg::campaign {
namespace {

constexpr const char* kFolder = "build/campaign";

std::string now() {
  const std::time_t time = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", std::gmtime(&time));
  return text;
}

/// One trial, made smaller if it fails.
int repeat(const Family& family, std::uint64_t seed, const Options& options) {
  std::cout << family.name() << " " << seed << ": " << std::flush;
  const Outcome outcome = judge_isolated(
      [&] {
        const Outcome o = family.trial(seed);
        // The verdict goes through unchanged: a message stands for what was thrown.
        if (o.verdict == Verdict::declined) throw InputError(o.message);
        if (o.verdict == Verdict::unknown) throw properties::OracleFailure(o.message);
        return o.message;
      },
      options.limits);
  std::cout << name(outcome.verdict) << (outcome.message.empty() ? "" : ": ") << outcome.message << std::endl;
  if (outcome.verdict == Verdict::right || outcome.verdict == Verdict::unknown) return 0;
  std::cout << "made smaller: " << write_failure(family, seed, outcome, options, true) << std::endl;
  return 1;
}

int run_program(int argc, char** argv) {
  CLI::App app{
      "Random trials against oracles, for hours; exit status 0 only if none is wrong and none declined.\n"
      "Without --hours and --trials, until it is interrupted."};
  app.name("tests/campaign/run");
  std::vector<std::string> names;
  std::optional<std::uint64_t> seed, first;
  std::string resume;
  bool list = false;
  Options options;
  options.failures = std::string(kFolder) + "/failures";
  app.add_option("--family", names, "only this family (may be given several times)");
  app.add_option("--hours", options.hours, "how long, from now on")->check(CLI::PositiveNumber);
  app.add_option("--trials", options.trials, "how many in all, those of the file of --resume included");
  app.add_option("--jobs", options.jobs, "processes at once")->check(CLI::Range(1, 64))->capture_default_str();
  app.add_option("--resume", resume, "goes on from this file of an earlier run, and writes to it")
      ->check(CLI::ExistingFile);
  app.add_option("--seed", seed, "this one trial of the one family, made smaller if it fails");
  app.add_option("--first", first, "the first seed of a new campaign (0)")->excludes("--resume");
  app.add_flag("--list", list, "lists the families");
  CLI11_PARSE(app, argc, argv);

  Families all = every_family(), families;
  if (list) {
    for (const auto& family : all) std::cout << family->name() << "\t" << family->oracle() << "\n";
    return 0;
  }
  for (auto& family : all)
    if (names.empty() || std::find(names.begin(), names.end(), family->name()) != names.end())
      families.push_back(std::move(family));
  for (const std::string& name : names) {
    if (std::none_of(families.begin(), families.end(), [&](const auto& f) { return f->name() == name; })) {
      std::cerr << "tests/campaign/run: no family `" << name << "`; `--list` lists them\n";
      return 2;
    }
  }
  if (seed) {
    if (families.size() != 1) {
      std::cerr << "tests/campaign/run: --seed needs one --family\n";
      return 2;
    }
    return repeat(*families[0], *seed, options);
  }
  State state;
  std::filesystem::create_directories(kFolder);
  if (resume.empty()) {
    options.state = std::string(kFolder) + "/" + now() + ".state";
    for (const auto& family : families) state.tallies[family->name()].next = first.value_or(0);
  } else {
    options.state = resume;
    std::ostringstream text;
    text << std::ifstream(resume).rdbuf();
    try {
      state = parse_state(text.str());
    } catch (const std::runtime_error& error) {
      std::cerr << resume << ": " << error.what() << "\n";
      return 2;
    }
  }
  std::cout << "state: " << options.state << " (goes on with --resume " << options.state << ")\nseeds from:";
  for (const auto& family : families)
    std::cout << " " << family->name() << " " << state.tallies[family->name()].next;
  std::cout << std::endl;
  const bool whole = run(families, options, state, std::cout);
  std::cout << table(state, families);
  if (!whole) std::cout << "interrupted; go on with --resume " << options.state << "\n";
  return state.clean() ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::campaign

int main(int argc, char** argv) { return cnrg::campaign::run_program(argc, argv); }
