// What a person at a terminal sees while the program works, and that Ctrl-C ends it at once.
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
namespace fs = std::filesystem;

const char* const kShaft = R"(cnrg: 1
nodes:
  block: {box: {min: [-3, -3, -3], max: [3, 3, 3]}}
  bore:  {cylinder: {from: [0, 0, -4], to: [0, 0, 4], radius: 1, segments: 32}}
  split: {union: [bore, block], dominance: left}
result: split
)";

/// The program, started in the folder, in a terminal of its own.
class Process {
 public:
  Process(const Workshop& w, std::vector<std::string> arguments, unsigned short columns) {
    winsize size{};
    size.ws_row = 24;
    size.ws_col = columns;
    arguments.insert(arguments.begin(), "cnrg");
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    pid_ = forkpty(&terminal_, nullptr, nullptr, &size);
    REQUIRE(pid_ >= 0);
    if (pid_ != 0) return;
    setenv("TERM", "xterm", 1);
    if (chdir(w.path(".").c_str()) == 0) execv(CNRG_PROGRAM, words.data());
    _exit(127);
  }
  ~Process() {
    if (pid_ > 0) kill(pid_, SIGKILL), wait();
    close(terminal_);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }
  /// Everything that it shows until its end.
  std::string shown() {
    std::string text;
    char block[4096];
    for (ssize_t n; (n = read(terminal_, block, sizeof block)) > 0;) text.append(block, std::size_t(n));
    return text;
  }
  /// How it ended.
  int wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = 0;
    return status;
  }
  void press_ctrl_c() { CHECK(write(terminal_, "\x03", 1) == 1); }

 private:
  pid_t pid_ = 0;
  int terminal_ = -1;
};

/// What follows each erased line up to the next one.
std::vector<std::string> bars_in(const std::string& text) {
  const std::string erase = "\r\x1b[K";
  std::vector<std::string> out;
  for (std::size_t at = text.find(erase); at != std::string::npos;) {
    const std::size_t begin = at + erase.size();
    at = text.find(erase, begin);
    if (at == text.find('\r', begin)) out.push_back(text.substr(begin, at - begin));  // else no bar, but a table
  }
  return out;
}

bool has(const std::vector<std::string>& bars, const std::string& begin) {
  return std::any_of(bars.begin(), bars.end(), [&](const std::string& bar) { return bar.starts_with(begin); });
}

TEST_CASE("a terminal shows the stage, how much of it is done, and the time", "[app][terminal]") {
  const Workshop w;
  w.write("t.yaml", kShaft);
  Process program(w, {"mesh", "t.yaml", "-o", "m.msh", "--curved"}, 70);
  const std::string text = program.shown();
  CHECK(program.wait() == 0);
  const std::vector<std::string> bars = bars_in(text);
  for (const char* stage : {"leaves ...  0:", "refine: contacts", "refine: faces [", "nodes [", "mesh: TetGen",
                            "mesh: proof", "bend: edges", "write m.msh"}) {
    INFO(stage << "\n" << text);
    CHECK(has(bars, stage));
  }
  CHECK(std::any_of(bars.begin(), bars.end(), [](const std::string& bar) {
    return bar.find("] ") != std::string::npos && bar.find(" %  0:0") != std::string::npos;
  }));
  for (const std::string& bar : bars) CHECK(bar.size() < 70);
  CHECK(text.find("\r\x1b[Kregion ") != std::string::npos);  // nothing of it stays
}

TEST_CASE("a bar is never wider than the terminal", "[app][terminal]") {
  const Workshop w;
  w.write("t.yaml", kShaft);
  const std::string name = std::string(60, 'x') + ".vtu";
  Process program(w, {"eval", "t.yaml", "-o", name, "--node", "split"}, 20);
  const std::vector<std::string> bars = bars_in(program.shown());
  CHECK(program.wait() == 0);
  CHECK(has(bars, "write xxx"));
  for (const std::string& bar : bars) CHECK(bar.size() < 20);
}

TEST_CASE("no terminal, or a quiet one, has a bar", "[app][terminal]") {
  const Workshop w;
  w.write("t.yaml", kShaft);
  CHECK(w.run("mesh t.yaml -o m.msh --curved").err.find('\x1b') == std::string::npos);
  Process program(w, {"mesh", "t.yaml", "-o", "m.msh", "--quiet"}, 70);
  CHECK(program.shown().find('\x1b') == std::string::npos);
  CHECK(program.wait() == 0);
}

/// A process whose parent this is; 0 if there is none.
pid_t child_of(pid_t parent) {
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream stat(entry.path() / "stat");
    std::string text;
    std::getline(stat, text);
    const std::size_t end = text.rfind(')');  // of the name of the program
    if (end == std::string::npos) continue;
    std::istringstream rest(text.substr(end + 1));
    char state = 0;
    pid_t found = 0;
    if (rest >> state >> found && found == parent) return pid_t(std::stol(name));
  }
  return 0;
}

/// True if it came within some seconds.
template <class Condition>
bool soon(Condition condition) {
  for (int i = 0; i < 1000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST_CASE("Ctrl-C ends a mesh at once, and TetGen with it", "[app][terminal]") {
  const bool at_terminal = GENERATE(true, false);  // or the signal for the program alone
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: a\n");
  Process program(w, {"mesh", "t.yaml", "-o", "m.msh", "--max-volume", "1e-7"}, 70);
  pid_t tetgen = 0;
  REQUIRE(soon([&] { return (tetgen = child_of(program.pid())) != 0; }));
  if (at_terminal) program.press_ctrl_c();
  else kill(program.pid(), SIGINT);
  const int status = program.wait();
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGINT);
  CHECK(soon([&] { return kill(tetgen, 0) != 0 || !fs::exists("/proc/" + std::to_string(tetgen) + "/exe"); }));
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(w.path("."))) {
    files.push_back(entry.path().filename());
  }
  CHECK(files == std::vector<std::string>{"t.yaml"});
}

TEST_CASE("Ctrl-C leaves no file that is half written", "[app][terminal]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  ball: {sphere: {center: [0, 0, 0], radius: 2, segments: 60}}
  wall: {box: {min: [-3, -3, "1/3"], max: [3, 3, 3]}}
  r:    {intersection: [ball, wall]}
result: r
)");
  const std::vector<std::string> names{"r.json", "r.vtu", "r.stl"};
  const auto arguments = [&](const std::string& folder) {
    std::vector<std::string> words{"eval", "t.yaml"};
    for (const std::string& name : names) words.insert(words.end(), {"-o", folder + "/" + name});
    return words;
  };
  fs::create_directory(w.path("whole"));
  const auto begin = std::chrono::steady_clock::now();
  Process whole(w, arguments("whole"), 70);
  whole.shown();
  REQUIRE(whole.wait() == 0);
  const auto time = std::chrono::steady_clock::now() - begin;
  constexpr int kTimes = 12;
  for (int i = 0; i < kTimes; ++i) {
    const std::string folder = "cut" + std::to_string(i);
    fs::create_directory(w.path(folder));
    Process program(w, arguments(folder), 70);
    std::this_thread::sleep_for(time * (i + 1) / kTimes);
    kill(program.pid(), SIGINT);
    const int status = program.wait();
    CHECK((status == 0 || (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT)));
    for (const fs::directory_entry& entry : fs::directory_iterator(w.path(folder))) {
      const std::string name = entry.path().filename();
      INFO(folder << "/" << name);
      REQUIRE(std::find(names.begin(), names.end(), name) != names.end());
      CHECK((w.read(folder + "/" + name) == w.read("whole/" + name)));
    }
  }
}

}  // namespace
}  // namespace cnrg
