// Compares the time and the peak memory of two builds of the program, and their files byte for byte.
//
//   bench_guard BASE HEAD --folder FOLDER [--rounds N] [--threads N] [--max-time R] [--max-memory R]
//
// BASE and HEAD are the programs `cnrg`. The cases are generated: meshes and trees are written into FOLDER, the
// same files for both. Each round runs `cnrg eval TREE --quiet -o FILE.json` with both, first one and then the
// other in turns, since a machine warms up. Time is that of the whole process, reading and writing included. Exit
// status 1 if files differ, a run fails, or a ratio of least times or of peak memory is above its limit.
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
#include <sstream>
#include <stdexcept>

#include "bench/cases/case.h"
#include "bench/cases/chain_tree.h"
#include "bench/cases/child.h"
#include "bench/cases/statistics.h"
#include "bench/command.h"

namespace cnrg::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::array<std::string, 2> programs;  // base, head
  std::string folder;
  int rounds = 5, threads = 0;
  double max_time = 1.15, max_memory = 1.10;
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

/// One union of leaves `box`.
GuardCase box_case(const fs::path& folder, int count) {
  std::string text = "cnrg: 1\nnodes:\n  all:\n    union:\n";
  const auto point = [](const std::array<int, 3>& p) {
    return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
  };
  for (const IntegerBox& box : random_boxes(count, 1))
    text += "      - {box: {min: " + point(box.min) + ", max: " + point(box.max) + "}}\n";
  return tree_case(folder, "box-leaves" + std::to_string(count), text + "result: all\n");
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

/// Throws if the program fails.
Run run_program(const Options& options, int which, const GuardCase& c, const std::string& out) {
  const std::string& program = options.programs[which];
  const std::string threads = std::to_string(options.threads), log = out + ".log";
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("the system gives no process");
  if (pid == 0) {
    const int fd = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(fd, STDOUT_FILENO);
    dup2(fd, STDERR_FILENO);
    execl(program.c_str(), program.c_str(), "eval", c.tree.c_str(), "--quiet", "--threads", threads.c_str(), "-o",
          out.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(pid, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    std::ifstream file(log);
    std::string first;
    std::getline(file, first);
    throw std::runtime_error(c.name + ": " + (which == 0 ? "base" : "head") +
                             " failed: " + (first.empty() ? "crashed or could not be started" : first));
  }
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
          static_cast<double>(usage.ru_maxrss) * 1024};
}

bool same_bytes(const std::string& a, const std::string& b) {
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return first && second && std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

struct Comparison {
  double least = 0, middle = 0, memory = 0;  // ratios, head : base
  double base_seconds = 0, base_bytes = 0;
  bool same = true;
};

Comparison compare(const Options& options, const GuardCase& c) {
  std::array<std::vector<double>, 2> seconds, bytes;
  std::array<std::string, 2> files;
  for (int which = 0; which < 2; ++which) files[which] = c.tree + (which == 0 ? ".base.json" : ".head.json");
  Comparison result;
  for (int round = 0; round < options.rounds; ++round) {
    for (int turn = 0; turn < 2; ++turn) {
      const int which = (round + turn) % 2;
      const Run run = run_program(options, which, c, files[which]);
      seconds[which].push_back(run.seconds);
      bytes[which].push_back(run.bytes);
    }
    result.same = result.same && same_bytes(files[0], files[1]);
  }
  result.base_seconds = least(seconds[0]);
  result.base_bytes = least(bytes[0]);
  result.least = least(seconds[1]) / least(seconds[0]);
  result.middle = median(seconds[1]) / median(seconds[0]);
  result.memory = least(bytes[1]) / least(bytes[0]);
  return result;
}

int run(const Options& options) {
  for (const std::string& program : options.programs) {
    if (access(program.c_str(), X_OK) != 0)
      throw std::runtime_error("'" + program + "' is no program; build the target cnrg first");
  }
  if (!fs::is_directory(options.folder))
    throw std::runtime_error("'" + options.folder + "' is no folder; make it first");
  const std::vector<GuardCase> cases = cases_in(options.folder);
  std::printf("head : base; whole processes with files, %d rounds\n", options.rounds);
  std::printf("%-18s %9s %9s %9s %9s %9s  %s\n", "", "base s", "base MB", "least", "median", "memory", "bytes");
  std::array<std::vector<double>, 3> ratios;
  int faults = 0;
  for (const GuardCase& c : cases) {
    const Comparison r = compare(options, c);
    const bool slow = r.least > options.max_time, large = r.memory > options.max_memory;
    std::printf("%-18s %9.3f %9.1f %9.3f %9.3f %9.3f  %s%s%s\n", c.name.c_str(), r.base_seconds,
                r.base_bytes / 1e6, r.least, r.middle, r.memory, r.same ? "same" : "DIFFERENT",
                slow ? ", SLOWER" : "", large ? ", LARGER" : "");
    std::fflush(stdout);
    ratios[0].push_back(r.least);
    ratios[1].push_back(r.middle);
    ratios[2].push_back(r.memory);
    faults += !r.same + slow + large;
  }
  std::printf("%-18s %9s %9s %9.3f %9.3f %9.3f  %s\n", "geometric mean", "", "", geometric_mean(ratios[0]),
              geometric_mean(ratios[1]), geometric_mean(ratios[2]),
              faults == 0 ? "all within the limits" : (std::to_string(faults) + " faults").c_str());
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  cnrg::bench::Options options;
  CLI::App program{"Compares the time, peak memory and files of two builds of cnrg.", "bench_guard"};
  program.add_option("BASE", options.programs[0], "The program cnrg to compare with")->required();
  program.add_option("HEAD", options.programs[1], "The program cnrg to judge")->required();
  program.add_option("--folder", options.folder, "Where generated meshes, trees and results go")->required();
  program.add_option("--rounds", options.rounds, "Runs of each")->check(CLI::Range(1, 1000));
  program.add_option("--threads", options.threads, "Threads; 0 is one per core")->check(CLI::Range(0, 4096));
  program.add_option("--max-time", options.max_time, "Largest ratio of least times")->check(CLI::PositiveNumber);
  program.add_option("--max-memory", options.max_memory, "Largest ratio of peak memory")
      ->check(CLI::PositiveNumber);
  return cnrg::bench::command(program, argc, argv, [&] { return cnrg::bench::run(options); });
}
