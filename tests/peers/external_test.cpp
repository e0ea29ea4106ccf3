// Programs behind `external_system`: scripts that are made here.
#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "bench/cases/child.h"
#include "bench/peers/peer.h"
#include "bench/peers/program.h"
#include "tests/catch.h"
#include "tests/peers/models.h"

namespace {

using namespace cnrg;
using namespace cnrg::peers;
using bench::Refusal;
using bench::System;
namespace fs = std::filesystem;

/// A folder that is the place of temporary files as long as it lives.
class Workshop {
 public:
  Workshop() {
    path_ = (fs::temp_directory_path() / "cnrg-test-XXXXXX").string();
    REQUIRE(mkdtemp(path_.data()) != nullptr);
    fs::create_directory(temporary());
    if (const char* before = getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", temporary().c_str(), 1);
  }
  ~Workshop() {
    if (before_.empty()) unsetenv("TMPDIR");
    else setenv("TMPDIR", before_.c_str(), 1);
    fs::remove_all(path_);
  }
  std::string temporary() const { return path_ + "/temporary"; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  bool nothing_left() const { return fs::is_empty(temporary()); }

  std::string executable(const std::string& script) const {
    std::ofstream(file("program")) << "#!/bin/sh\n" << script << '\n';
    chmod(file("program").c_str(), 0700);
    return file("program");
  }
  System program(const std::string& script) const {
    return bench::external_system("script", {executable(script)}, 0x1p-50);
  }

 private:
  std::string path_, before_;
};

const Problem kProblem =
    pair_of(box({0, 0, 0}, {1, 1, 1}), Operation::subtract, box({0, 0, 0}, {2, 2, Rational(1, 2)}));

/// Stage and words.
std::pair<std::string, std::string> refusal_of(const System& system, const Problem& problem) {
  try {
    system.evaluate(problem);
  } catch (const Refusal& refusal) {
    return {refusal.stage(), refusal.what()};
  }
  return {"none", ""};
}

/// Waits for at most five seconds.
template <class Condition>
bool soon(Condition condition) {
  for (int i = 0; i < 250; ++i) {
    if (condition()) return true;
    usleep(20000);
  }
  return false;
}

}  // namespace

TEST_CASE("a program gets operation and files, and its file is the result") {
  const Workshop workshop;
  const std::string log = workshop.file("log");
  const System copy = workshop.program("echo noise; echo \"$1\" >> " + log + "; cp \"$3\" \"$4\"");
  Problem problem = kProblem;
  CHECK(volume(copy.evaluate(problem).model) == 2);
  problem.operands.push_back(box({0, 0, 0}, {3, 3, Rational(1, 2)}));
  problem.steps.push_back(Operation::unite);
  const bench::Answer answer = copy.evaluate(problem);
  CHECK(volume(answer.model) == Rational(9, 2));
  CHECK(closed(answer.model));
  std::ifstream in(log);
  std::string words, word;
  while (in >> word) words += word + ' ';
  CHECK(words == "difference difference union ");
  CHECK(workshop.nothing_left());
}

TEST_CASE("results may have polygons, also some that are not planar, and none at all") {
  const Workshop workshop;
  const std::string result = workshop.file("result.off");
  const System system = workshop.program("cp " + result + " \"$4\"");
  // An L-shaped prism, its upper side not planar: a fan from the first corner would leave it.
  std::ofstream(result) << "OFF\n12 8 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 0\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n"
                           "0 2 1\n0 0 1.0000000000000002\n6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n"
                           "4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n";
  const Model model = system.evaluate(kProblem).model;
  CHECK(closed(model));
  CHECK(std::abs(to_double(volume(model)) - 3) < 1e-14);
  CHECK(model.faces.size() == 4 + 7);
  std::ofstream(result) << "OFF\n0 0 0\n";
  CHECK(system.evaluate(kProblem).model.faces.empty());
  std::ofstream(result) << "OFF\n1 1 0\n0 0 nan\n3 0 0 0\n";
  CHECK(refusal_of(system, kProblem).first == "output");
  CHECK(workshop.nothing_left());
}

TEST_CASE("a program that fails or writes nothing refuses; one that a signal ends has crashed") {
  const Workshop workshop;
  const auto check = [&](const std::string& script, const std::string& words) {
    const auto [stage, what] = refusal_of(workshop.program(script), kProblem);
    INFO(what);
    CHECK(stage == "program");
    CHECK(what.find(words) != std::string::npos);
    CHECK(workshop.nothing_left());
  };
  check("echo first >&2; echo no manifold >&2; echo >&2; exit 3", "no manifold");
  check("exit 3", "status 3");
  CHECK_THROWS_AS(workshop.program("kill -SEGV $$").evaluate(kProblem), bench::Crash);
  check("exit 0", "no result");
  const System script = workshop.program("echo \"terminate: std::bad_alloc\" >&2; exit 134");
  CHECK_THROWS_AS(script.evaluate(kProblem), std::bad_alloc);
  const System none = bench::external_system("none", {workshop.file("none")}, 0);
  CHECK_THROWS_AS(none.evaluate(kProblem), std::runtime_error);
  const Problem with_point = pair_of(box({0, 0, 0}, {1, 1, 1}), Operation::unite, point({2, 2, 2}));
  CHECK(refusal_of(script, with_point).first == "input");
  CHECK(workshop.nothing_left());
}

TEST_CASE("neither processes nor files stay behind when the limit strikes") {
  const Workshop workshop;
  const std::string started = workshop.file("started");
  const System slow = workshop.program("echo $$ > " + started + "; exec sleep 1000");
  const auto work = [&] {
    slow.evaluate(kProblem);
    return std::string();
  };
  const bench::ChildResult result = bench::run_child(work, {.seconds = 1});
  CHECK(result.end == bench::ChildResult::End::timeout);
  pid_t pid = 0;
  std::ifstream(started) >> pid;
  REQUIRE(pid > 0);
  CHECK(soon([&] { return kill(pid, 0) != 0; }));
  CHECK(soon([&] { return workshop.nothing_left(); }));
}

TEST_CASE("a program of a benchmark gets all operands at once and the threads, and says what it measured") {
  const Workshop workshop;
  const std::string log = workshop.file("log");
  const std::string copy = "echo $1 $# $CNRG_THREADS > " + log + "; cp \"$3\" \"$5\"";
  const bench::Case boxes =
      bench::union_of("boxes", {{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {2, 3, 4}}, {{0, 0, 0}, {9, 9, 9}}});
  const bench::Outcome told =
      bench::evaluate_program(workshop.executable(copy + "; echo measured 0.5 100 300 >&2"), boxes, {true}, 2);
  CHECK(told.measures.seconds() == 0.5);
  CHECK(told.measures.own_bytes() == 200);
  CHECK(told.volume == 6);
  CHECK(told.vertices == 8);
  CHECK(told.faces == 12);
  std::string words;
  std::getline(std::ifstream(log), words);
  CHECK(words == "union 5 2");
  const bench::Outcome process = bench::evaluate_program(workshop.executable(copy), boxes, {true}, 1);
  CHECK(process.measures.seconds() > 0);
  CHECK(process.measures.seconds() != 0.5);
  CHECK(process.measures.peak_bytes > 0);
  CHECK_THROWS_WITH(bench::evaluate_program(workshop.executable("echo two only >&2; exit 1"), boxes, {}, 1),
                    "two only");
  CHECK_THROWS_WITH(bench::evaluate_program(workshop.executable("exit 0"), boxes, {}, 1),
                    Catch::Contains("no result"));
  CHECK(workshop.nothing_left());
}

TEST_CASE("a program is named with its path and its rounding") {
  const bench::NamedProgram shell = bench::named_program("my-shell=/bin/../bin/sh:1e-9");
  CHECK(shell.name == "my-shell");
  CHECK(shell.path == fs::canonical("/bin/sh").string());
  CHECK(shell.rounding == 1e-9);
  CHECK(bench::named_program("s=/bin/sh").rounding == 1e-12);
  CHECK_THROWS_WITH(bench::named_program("/bin/sh"), Catch::Contains("NAME=PROGRAM"));
  CHECK_THROWS_WITH(bench::named_program("s=/bin/sh:much"), Catch::Contains("no rounding"));
  CHECK_THROWS_WITH(bench::named_program("a b=/bin/sh"), Catch::Contains("no name"));
  CHECK_THROWS_WITH(bench::named_program("s=/no/such"), Catch::Contains("no such program"));
}
