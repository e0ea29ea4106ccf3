// Compares the instructions, the time and the peak memory of two builds of the program, and their files byte for
// byte.
//
//   bench_guard BASE HEAD --folder FOLDER [--rounds N] [--threads N] [--max-instructions R] [--max-time R]
//               [--max-memory R] [--only CASE,...]
//
// BASE and HEAD are the programs `cnrg`. The cases are generated: meshes and trees are written into FOLDER, the
// same files for both. Each round runs `cnrg eval TREE --quiet -o FILE.json` with both, first one and then the
// other in turns, since a machine warms up. Time is that of the whole process, reading and writing included. Then
// valgrind counts the instructions of one run of each with one thread: counts repeat where times do not, to a
// millionth; it takes 20 times as long. A case is not counted where valgrind, which rounds to the nearest whatever
// a program asks for, gives another file. With --rounds 0 they alone are compared, with --max-instructions 0 they
// are not counted. Exit status 1 if files differ, a run fails, or a ratio of instructions, of least times or of
// peak memory is above its limit.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "bench/cases/case.h"
#include "bench/cases/chain_tree.h"
#include "bench/cases/child.h"
#include "bench/cases/statistics.h"
#include "bench/cases/tree_cases.h"
#include "bench/command.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::array<std::string, 2> programs;  // base, head
  std::string folder;
  std::vector<std::string> only;
  int rounds = 5, threads = 0;
  double max_instructions = 1.03, max_time = 1.15, max_memory = 1.10;
};

struct GuardCase {
  std::string name, tree;  // the tree file
};

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file)
    throw std::runtime_error(path.string() + ": cannot be written; is the folder there and is there room?");
}

GuardCase tree_case(const fs::path& folder, const std::string& name, const std::string& text) {
  const fs::path tree = folder / (name + ".yaml");
  write_text(tree, text);
  return {name, tree.string()};
}

/// One Boolean of mesh files.
GuardCase mesh_case(const fs::path& folder, const std::string& name) {
  const Case c = case_of(name);
  std::string text = "cnrg: 1\nnodes:\n", operands;
  for (std::size_t i = 0; i < c.leaves.size(); ++i) {
    const std::string leaf = "s" + std::to_string(i), file = name + "-" + leaf + ".off";
    write_off((folder / file).string(), c.leaves[i]);
    text += "  " + leaf + ": {mesh: {file: " + file + "}}\n";
    operands += (i == 0 ? "" : ", ") + leaf;
  }
  const char* const op = c.operation == Operation::unite ? "union" : "difference";
  return tree_case(folder, name, text + "  all: {" + op + ": [" + operands + "]}\nresult: all\n");
}

std::string leaf_of(const IntegerBox& box) {
  const auto point = [](const std::array<int, 3>& p) {
    return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
  };
  return "{box: {min: " + point(box.min) + ", max: " + point(box.max) + "}}";
}

/// One union of leaves `box`.
GuardCase box_case(const fs::path& folder, int count) {
  std::string text = "cnrg: 1\nnodes:\n  all:\n    union:\n";
  for (const IntegerBox& box : random_boxes(count, 1)) text += "      - " + leaf_of(box) + "\n";
  return tree_case(folder, "box-leaves" + std::to_string(count), text + "result: all\n");
}

/// Each of these boxes cut to the same one, and their union: as `cut_spheres`, but all points are integers, so
/// that instructions can be counted.
GuardCase cut_boxes(const fs::path& folder, int count) {
  std::string text = "cnrg: 1\nnodes:\n  middle: " + leaf_of({{6, 6, 6}, {14, 14, 14}}) + "\n  all:\n    union:\n";
  for (const IntegerBox& box : random_boxes(count, 1))
    text += "      - {intersection: [" + leaf_of(box) + ", middle]}\n";
  return tree_case(folder, "cut-boxes" + std::to_string(count), text + "result: all\n");
}

std::vector<GuardCase> write_cases(const fs::path& folder) {
  std::vector<GuardCase> cases;
  for (const char* name : {"spheres10k", "spheres100k", "spheres64", "boxes200", "menger2", "identical",
                           "coplanar", "grid", "touching", "mirrored"})
    cases.push_back(mesh_case(folder, name));
  cases.push_back(box_case(folder, 200));
  cases.push_back(tree_case(folder, "scattered-chain", scattered_chain({500, 1})));
  cases.push_back(tree_case(folder, "winding-chain", winding_chain(150, 1)));
  cases.push_back(tree_case(folder, "shared-layers", shared_layers(40, 1)));
  cases.push_back(tree_case(folder, "cut-spheres16", cut_spheres(16, 1)));
  cases.push_back(cut_boxes(folder, 200));
  cases.push_back(tree_case(folder, "shared-boxes10", shared_boxes(10)));
  cases.push_back(tree_case(folder, "plate200", plate_difference(200)));
  cases.push_back(tree_case(folder, "plate-chain200", plate_chain(200)));
  cases.push_back(tree_case(folder, "fractures100", fractures_in_block(100, 1)));
  return cases;
}

/// In a process of its own: what is resident when a program is started counts for that program's peak.
std::vector<GuardCase> cases_in(const std::string& folder) {
  const ChildResult child = run_child([&] {
    try {
      std::string list;
      for (const GuardCase& c : write_cases(folder)) list += c.name + "\n" + c.tree + "\n";
      return list;
    } catch (const std::exception& e) {
      return std::string("\n") + e.what();
    }
  });
  if (child.text.starts_with("\n")) throw std::runtime_error(child.text.substr(1));
  std::vector<GuardCase> cases;
  std::istringstream list(child.text);
  for (GuardCase c; std::getline(list, c.name) && std::getline(list, c.tree);) cases.push_back(c);
  if (child.end != ChildResult::End::done || cases.empty())
    throw std::runtime_error("the cases could not be made");
  return cases;
}

struct Run {
  double seconds = 0, bytes = 0;
};

/// The program itself ended badly.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// The program with its file `out`, its words in `out`.log; `before` stands before it in the command. Throws if it
/// fails.
Run run_program(const Options& options, int which, const GuardCase& c, const std::string& out, int threads,
                const std::vector<std::string>& before = {}) {
  const std::string log = out + ".log";
  std::vector<std::string> words = before;
  words.insert(words.end(), {options.programs[which], "eval", c.tree, "--quiet", "--threads",
                             std::to_string(threads), "-o", out});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("the system gives no process");
  if (pid == 0) {
    const int fd = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(fd, STDOUT_FILENO);
    dup2(fd, STDERR_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(pid, &status, 0, &usage);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw std::runtime_error(words[0] + " could not be started; is it installed?");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    const std::string first = first_line(log);
    throw Failure(c.name + ": " + (which == 0 ? "base" : "head") +
                  " failed: " + (first.empty() ? "crashed" : first));
  }
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
          static_cast<double>(usage.ru_maxrss) * 1024};
}

bool same_bytes(const std::string& a, const std::string& b) {
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return first && second && std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

/// Of one run with one thread, as valgrind says: `==PID== I   refs:      3,863,506,832`. Nothing if that run does
/// not write what the program writes without valgrind, which rounds to the nearest only: intervals need more.
std::optional<double> instructions(const Options& options, int which, const GuardCase& c, const std::string& out) {
  const std::string counted = c.tree + ".counted.json";
  fs::remove(counted);
  try {
    run_program(options, which, c, counted, 1,
                {"valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"});
  } catch (const Failure&) {
    return {};
  }
  if (!same_bytes(out, counted)) return {};
  std::ifstream log(counted + ".log");
  for (std::string line; std::getline(log, line);) {
    const std::size_t at = line.find("refs:");
    if (at == std::string::npos) continue;
    line.erase(0, at + 5);
    line.erase(std::remove(line.begin(), line.end(), ','), line.end());
    return std::stod(line);
  }
  throw std::runtime_error("valgrind counted no instructions of " + c.name);
}

struct Comparison {
  std::optional<double> instructions;
  double least = 1, middle = 1, memory = 1;  // ratios, head : base; 1 if not measured
  double base_instructions = 0, base_seconds = 0, base_bytes = 0;
  bool same = true;
};

Comparison compare(const Options& options, const GuardCase& c) {
  std::array<std::vector<double>, 2> seconds, bytes;
  std::array<std::string, 2> files;
  for (int which = 0; which < 2; ++which) files[which] = c.tree + (which == 0 ? ".base.json" : ".head.json");
  Comparison result;
  for (int round = 0; round < std::max(1, options.rounds); ++round) {
    for (int turn = 0; turn < 2; ++turn) {
      const int which = (round + turn) % 2;
      const Run run = run_program(options, which, c, files[which], options.threads);
      seconds[which].push_back(run.seconds);
      bytes[which].push_back(run.bytes);
    }
    result.same = result.same && same_bytes(files[0], files[1]);
  }
  if (options.max_instructions > 0) {
    const auto base = instructions(options, 0, c, files[0]), head = instructions(options, 1, c, files[1]);
    if (base && head) {
      result.base_instructions = *base;
      result.instructions = *head / *base;
    }
  }
  if (options.rounds == 0) return result;
  result.base_seconds = least(seconds[0]);
  result.base_bytes = least(bytes[0]);
  result.least = least(seconds[1]) / least(seconds[0]);
  result.middle = median(seconds[1]) / median(seconds[0]);
  result.memory = least(bytes[1]) / least(bytes[0]);
  return result;
}

/// Those that `only` names; all if it is empty.
std::vector<GuardCase> chosen(std::vector<GuardCase> cases, const std::vector<std::string>& only) {
  std::string names;
  for (const GuardCase& c : cases) names += (names.empty() ? "" : " ") + c.name;
  for (const std::string& name : only) {
    if (std::none_of(cases.begin(), cases.end(), [&](const GuardCase& c) { return c.name == name; }))
      throw std::runtime_error("'" + name + "' is no case; there are " + names);
  }
  std::erase_if(cases, [&](const GuardCase& c) {
    return !only.empty() && std::find(only.begin(), only.end(), c.name) == only.end();
  });
  return cases;
}

std::string ratio_text(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", ratio);
  return text;
}

int run(const Options& options) {
  for (const std::string& program : options.programs) {
    if (access(program.c_str(), X_OK) != 0)
      throw std::runtime_error("'" + program + "' is no program; build the target cnrg first");
  }
  if (!fs::is_directory(options.folder))
    throw std::runtime_error("'" + options.folder + "' is no folder; make it first");
  const std::vector<GuardCase> cases = chosen(cases_in(options.folder), options.only);
  std::printf("head : base; whole processes with files, %d rounds\n", options.rounds);
  std::printf("%-18s %9s %9s %9s %12s %9s %9s %9s  %s\n", "", "base 1e6", "base s", "base MB", "instructions",
              "least", "median", "memory", "bytes");
  std::array<std::vector<double>, 4> ratios;
  int faults = 0;
  for (const GuardCase& c : cases) {
    const Comparison r = compare(options, c);
    const bool more = r.instructions && *r.instructions > options.max_instructions;
    const bool slow = r.least > options.max_time, large = r.memory > options.max_memory;
    const std::string counted = r.instructions ? ratio_text(*r.instructions) : "-";
    std::printf("%-18s %9.0f %9.3f %9.1f %12s %9.3f %9.3f %9.3f  %s%s%s%s\n", c.name.c_str(),
                r.base_instructions / 1e6, r.base_seconds, r.base_bytes / 1e6, counted.c_str(), r.least, r.middle,
                r.memory, r.same ? "same" : "DIFFERENT", more ? ", MORE INSTRUCTIONS" : "", slow ? ", SLOWER" : "",
                large ? ", LARGER" : "");
    std::fflush(stdout);
    if (r.instructions) ratios[0].push_back(*r.instructions);
    ratios[1].push_back(r.least);
    ratios[2].push_back(r.middle);
    ratios[3].push_back(r.memory);
    faults += !r.same + more + slow + large;
  }
  const std::string counted = ratios[0].empty() ? "-" : ratio_text(geometric_mean(ratios[0]));
  std::printf("%-18s %9s %9s %9s %12s %9.3f %9.3f %9.3f  %s\n", "geometric mean", "", "", "", counted.c_str(),
              geometric_mean(ratios[1]), geometric_mean(ratios[2]), geometric_mean(ratios[3]),
              faults == 0 ? "all within the limits" : (std::to_string(faults) + " faults").c_str());
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  cnrg::bench::Options options;
  CLI::App program{"Compares the instructions, time, peak memory and files of two builds of cnrg.", "bench_guard"};
  program.add_option("BASE", options.programs[0], "The program cnrg to compare with")->required();
  program.add_option("HEAD", options.programs[1], "The program cnrg to judge")->required();
  program.add_option("--folder", options.folder, "Where generated meshes, trees and results go")->required();
  program.add_option("--only", options.only, "These cases")->delimiter(',')->allow_extra_args(false);
  program.add_option("--rounds", options.rounds, "Runs of each; 0: instructions alone")
      ->check(CLI::Range(0, 1000));
  program.add_option("--threads", options.threads, "Threads; 0 is one per core")->check(CLI::Range(0, 4096));
  program
      .add_option("--max-instructions", options.max_instructions,
                  "Largest ratio of instructions; 0: they are not counted")
      ->check(CLI::NonNegativeNumber);
  program.add_option("--max-time", options.max_time, "Largest ratio of least times")->check(CLI::PositiveNumber);
  program.add_option("--max-memory", options.max_memory, "Largest ratio of peak memory")
      ->check(CLI::PositiveNumber);
  return cnrg::bench::command(program, argc, argv, [&] { return cnrg::bench::run(options); });
}
