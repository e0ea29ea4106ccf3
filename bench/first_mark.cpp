// The first mark of speed: bunny25k and a turned cow25k united by us, by CGAL's corefinement and by CGAL's Nef.
//
//   bench_first_mark A B [--rounds N] [--nef-rounds N] [--angle RADIANS] [--move X Y Z] [--no-nef]
//
// Every run is a process of its own; the systems take turns, so that a slow minute of the machine meets all of
// them. Medians and least times are of the timed part (peer.h); peak memory is of the whole process, with the
// input.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "bench/cases/child.h"
#include "bench/peers/peer.h"

namespace cnrg::bench {
namespace {

struct Row {
  Peer peer;
  int rounds;
  std::vector<double> seconds;
  std::vector<std::pair<std::string, std::vector<double>>> stages;
  std::size_t peak = 0;
  Outcome checked;
  std::string failure;
};

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

std::string written(const Outcome& o) {
  std::ostringstream out;
  out.precision(17);
  out << o.vertices << " " << o.faces << " " << o.volume << " " << o.stages.size();
  for (const auto& [name, time] : o.stages) out << " " << name << " " << time;
  out << "\n" << o.note;
  return out.str();
}

Outcome parsed(const std::string& text) {
  std::istringstream in(text);
  Outcome o;
  std::size_t stages = 0;
  in >> o.vertices >> o.faces >> o.volume >> stages;
  o.stages.resize(stages);
  for (auto& [name, time] : o.stages) in >> name >> time;
  if (!in) throw std::runtime_error("a run returned nothing");
  in.ignore(1);
  std::getline(in, o.note);
  return o;
}

void run_once(Row& row, const TriangleMesh& a, const TriangleMesh& b) {
  const ChildResult child = run_child([&] {
    try {
      return written(row.peer.unite(a, b, row.seconds.empty()));
    } catch (const std::exception& error) {
      return std::string("!") + error.what();
    }
  });
  if (child.end != ChildResult::End::done || child.text.starts_with("!")) {
    row.failure = child.text.empty() ? "crashed, signal " + std::to_string(child.signal) : child.text.substr(1);
    return;
  }
  const Outcome outcome = parsed(child.text);
  if (row.seconds.empty()) row.checked = outcome;  // the first run was checked; the others must count the same
  if (outcome.vertices != row.checked.vertices || outcome.faces != row.checked.faces) row.failure = "runs differ";
  row.seconds.push_back(outcome.seconds());
  row.peak = std::max(row.peak, child.peak_bytes);
  row.stages.resize(outcome.stages.size());
  for (std::size_t i = 0; i < row.stages.size(); ++i) {
    row.stages[i].first = outcome.stages[i].first;
    row.stages[i].second.push_back(outcome.stages[i].second);
  }
}

int run(int argc, char** argv) {
  std::vector<std::string> files;
  int rounds = 7, nef_rounds = 3;
  double angle = 0.7;
  std::array<double, 3> move{0.05, 0.03, 0.01};
  bool nef = true;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto value = [&] {
      if (++i >= argc) throw std::runtime_error(arg + " needs a number");
      return std::stod(argv[i]);
    };
    if (arg == "--rounds") rounds = static_cast<int>(value());
    else if (arg == "--nef-rounds") nef_rounds = static_cast<int>(value());
    else if (arg == "--angle") angle = value();
    else if (arg == "--move") for (double& m : move) m = value();
    else if (arg == "--no-nef") nef = false;
    else files.push_back(arg);
  }
  if (files.size() != 2)
    throw std::runtime_error("usage: bench_first_mark A B [options]; see the head of first_mark.cpp");
  const TriangleMesh a = read_mesh(files[0]), b = turned(read_mesh(files[1]), angle, move);
  std::printf("%zu + %zu triangles\n", a.triangles.size(), b.triangles.size());

  std::vector<Row> rows;
  rows.push_back({{"cnrg", unite_ours}, rounds, {}, {}, 0, {}, {}});
  rows.push_back({{"cnrg, 1 thread", unite_ours_one_thread}, rounds, {}, {}, 0, {}, {}});
  rows.push_back({{"CGAL corefinement", unite_corefinement}, rounds, {}, {}, 0, {}, {}});
  if (nef) rows.push_back({{"CGAL Nef", unite_nef}, nef_rounds, {}, {}, 0, {}, {}});
  for (int round = 0; round < std::max(rounds, nef_rounds); ++round)
    for (Row& row : rows)
      if (round < row.rounds && row.failure.empty()) run_once(row, a, b);

  const double base = median(rows[0].seconds);
  std::printf("%-20s %9s %9s %9s %10s %9s %9s  %s\n", "", "median s", "least s", "ratio", "peak MB", "vertices",
              "faces", "volume");
  for (const Row& row : rows) {
    if (!row.failure.empty()) {
      std::printf("%-20s failed: %s\n", row.peer.name, row.failure.c_str());
      continue;
    }
    std::printf("%-20s %9.3f %9.3f %9.2f %10.1f %9zu %9zu  %.15g\n", row.peer.name, median(row.seconds),
                *std::min_element(row.seconds.begin(), row.seconds.end()), median(row.seconds) / base,
                static_cast<double>(row.peak) / 1e6, row.checked.vertices, row.checked.faces, row.checked.volume);
  }
  for (const Row& row : rows) {
    if (!row.failure.empty()) continue;
    std::printf("%-20s", row.peer.name);
    for (const auto& [name, times] : row.stages) std::printf(" %s %.3f", name.c_str(), median(times));
    std::printf("; %s\n", row.checked.note.c_str());
  }

  // A time counts only with a right result.
  bool right = rows[0].failure.empty();
  for (const Row& row : rows) {
    if (!row.failure.empty()) continue;
    if (std::abs(row.checked.volume / rows[0].checked.volume - 1) > 1e-9) {
      std::printf("WRONG: the volume of %s differs from ours\n", row.peer.name);
      right = false;
    }
    if (row.checked.note.find("INVALID") != std::string::npos) right = false;
  }
  if (right) std::printf("volumes agree to 1e-9\n");
  return right ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  try {
    return cnrg::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_first_mark: %s\n", error.what());
    return 2;
  }
}
