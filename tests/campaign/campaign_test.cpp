// The campaign itself: what is wrong, declined, crashes, hangs or eats
// memory is found, counted and made smaller, and a run that was killed goes on where it was.
#include "tests/campaign/driver/campaign.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <set>
#include <sstream>
#include <thread>

#include "kernel/base/error.h"
#include "tests/properties/trials.h"

namespace cnrg::campaign {
namespace {

/// A folder that goes afterwards.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("cnrg-test-campaign-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::string& path) {
  std::ostringstream out;
  out << std::ifstream(path).rdbuf();
  return out.str();
}

/// A case is a number and some ballast, which does not matter and goes when it is made smaller.
struct Number {
  std::uint64_t seed = 0;
  int ballast = 2;
};

/// Fails at seeds 3, 5, 7, 9 and 11 of each twenty, each in its way.
Families failing() {
  Recipe<Number> recipe;
  recipe.name = "failing";
  recipe.oracle = "none";
  recipe.make = [](std::uint64_t seed) { return Number{seed, 2}; };
  recipe.compare = [](const Number& n) -> std::string {
    switch (n.seed % 20) {
      case 3: return "two\nlines";
      case 5: std::abort();
      case 7:
        for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
      case 9: throw InputError("no such input");
      case 11: return std::string(new char[std::size_t{1} << 40], 1);
      default: return {};
    }
  };
  recipe.smaller = [](const Number& n) {
    return n.ballast == 0 ? std::vector<Number>() : std::vector<Number>{{n.seed, n.ballast - 1}};
  };
  recipe.text = [](const Number& n) { return "ballast: " + std::to_string(n.ballast) + "\n"; };
  Families families;
  add(families, recipe);
  return families;
}

/// Right, each after some milliseconds.
Families slow() {
  Recipe<Number> recipe;
  recipe.name = "slow";
  recipe.oracle = "none";
  recipe.make = [](std::uint64_t seed) { return Number{seed, 0}; };
  recipe.compare = [](const Number&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return std::string();
  };
  recipe.smaller = [](const Number&) { return std::vector<Number>(); };
  recipe.text = [](const Number&) { return std::string(); };
  Families families;
  add(families, recipe);
  return families;
}

Options options_in(const Folder& folder, std::uint64_t trials) {
  Options options;
  options.trials = trials;
  options.state = folder / "state";
  options.failures = folder / "failures";
  options.limits.seconds = 1;
  options.shrink_seconds = 20;
  return options;
}

void check_failures(const State& state) {
  const Tally& tally = state.tallies.at("failing");
  CHECK(tally.next == 20);
  CHECK(tally.right == 15);
  CHECK(tally.wrong == 3);
  CHECK(tally.declined == 2);
  CHECK_FALSE(state.clean());
  REQUIRE(state.failures.size() == 5);
  CHECK(state.failures[0].seed == 3);
  CHECK(state.failures[1].seed == 5);
  CHECK(state.failures[1].outcome.message.find("signal 6") != std::string::npos);
  CHECK(state.failures[2].outcome.message == "no answer in 1 seconds");
  CHECK(state.failures[3].outcome.message == "no such input");
  CHECK(state.failures[4].outcome.message == "out of memory");
}

}  // namespace

TEST_CASE("A campaign finds what is wrong, declined, crashes, hangs and eats memory", "[campaign]") {
  const Folder folder;
  const Families families = failing();
  Options options = options_in(folder, 20);
  options.jobs = 2;
  State state;
  std::ostringstream log;
  REQUIRE(run(families, options, state, log));
  check_failures(state);
  CHECK(log.str().find("failing 3: wrong: two\\nlines\n") != std::string::npos);
  // What is on the disk is what is in memory.
  const State read = parse_state(text_of(folder / "state"));
  CHECK(to_text(read) == to_text(state));
  check_failures(read);
  // Each was made smaller, the crash and the hang, too.
  for (const int seed : {3, 5, 7, 9, 11}) {
    const std::string text = text_of(options.failures + "/failing-" + std::to_string(seed) + ".yaml");
    INFO(seed);
    CHECK(text.find("# repeat: tests/campaign/run --family failing --seed " + std::to_string(seed) + "\n") !=
          std::string::npos);
    CHECK(text.find("\nballast: 0\n") != std::string::npos);
  }
  const std::string rows = table(state, families);
  CHECK(rows.find("failing") != std::string::npos);
}

TEST_CASE("A campaign goes on where it ended", "[campaign]") {
  const Folder folder;
  const Families families = failing();
  State state;
  std::ostringstream log;
  for (const std::uint64_t trials : {4, 8, 10, 20}) {
    REQUIRE(run(families, options_in(folder, trials), state, log));
    CHECK(state.trials() == trials);
    state = parse_state(text_of(folder / "state"));
  }
  check_failures(state);
}

TEST_CASE("A campaign that is killed loses a few seconds at most", "[campaign]") {
  const Folder folder;
  const Families families = slow();
  const Options options = options_in(folder, 1'000'000);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    State state;
    std::ostringstream log;
    run(families, options, state, log);
    ::_exit(0);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(3500));
  ::kill(child, SIGKILL);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  State state = parse_state(text_of(folder / "state"));
  const std::uint64_t done = state.trials();
  CHECK(done > 50);
  CHECK(state.tallies.at("slow").next == done);
  Options more = options_in(folder, done + 10);
  std::ostringstream log;
  REQUIRE(run(families, more, state, log));
  CHECK(state.tallies.at("slow").right == done + 10);
  CHECK(state.clean());
}

TEST_CASE("A state that is none is refused with its line", "[campaign]") {
  CHECK_THROWS_WITH(parse_state("something else\n"), "a state begins with the line `cnrg campaign 1`");
  CHECK_THROWS_WITH(parse_state("cnrg campaign 1\nfamily cubes next 1 right 1 wrong\n"),
                    Catch::Contains("line 2"));
  CHECK_THROWS_WITH(parse_state("cnrg campaign 1\nfamily cubes next 1 right 1 wrong 0 declined 0 unknown 0 "
                                "seconds 1\nfailures\n"),
                    Catch::Contains("line 3"));
}

TEST_CASE("Every family has a name, an oracle and trials that are tests", "[campaign]") {
  std::set<std::string> names, tested;
  for (const auto& [file, trials] : kTrials)
    for (const auto& [name, count] : trials) tested.insert(name);
  for (const auto& family : every_family()) {
    INFO(family->name());
    CHECK(names.insert(family->name()).second);
    CHECK_FALSE(family->oracle().empty());
    CHECK(family->share() > 0);
    // Cases are told as trees, but for those that are made of cells.
    const std::string text = family->text(1);
    CHECK((text.starts_with("cnrg: 1\n") || text.starts_with("#")));
    CHECK(text == family->text(1));
  }
  CHECK(names.size() >= 20);
  CHECK(names == tested);
}

}  // namespace cnrg::campaign
