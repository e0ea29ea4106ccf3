// Targets of the project, each beside what was measured.
#include "bench/speed_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "bench/cases/statistics.h"

namespace cnrg::bench {
namespace {

constexpr double kAgreement = 1e-9;  // relative, of rounded volumes
constexpr double kPairToNef = 1.0 / 40, kManyToNef = 1.0 / 70;
constexpr double kBytesPerTriangle = 1024;
constexpr double kExactShare = 0.001;  // in general position
constexpr double kGrowth = 1.5, kDegenerate = 10;

void print_target(const std::string& what, bool met) {
  std::printf("  %s: %s\n", what.c_str(), met ? "met" : "NOT MET");
}

/// A target where `judged`, otherwise only the figure.
void print_figure(const std::string& target, const std::string& figure, bool judged, bool met) {
  if (judged) print_target(target + ": " + figure, met);
  else std::printf("  %s: %s (no target here)\n", target.c_str(), figure.c_str());
}

std::string formatted(const char* format, double a, double b = 0) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

double bytes_per_triangle(const CaseResult& result) {
  return static_cast<double>(result.ours().own_bytes()) / static_cast<double>(result.triangles);
}

std::vector<double> seconds_of(const Row& row) {
  std::vector<double> seconds;
  for (const Measures& run : row.runs) seconds.push_back(run.seconds());
  return seconds;
}

double median_of_stage(const Row& row, std::size_t stage) {
  std::vector<double> times;
  for (const Measures& run : row.runs) times.push_back(run.stages[stage].second);
  return median(times);
}

/// The targets of the group; what has none is told without a judgement.
void print_targets(const CaseResult& result) {
  const Row& ours = result.ours();
  if (!ours.done()) return;
  const bool pair = result.group == "pairs", many = result.group == "nary", growth = result.group == "growth";
  if (const Row* peer = result.find(kCorefinement); peer != nullptr) {
    const double ratio = ours.median_seconds() / peer->median_seconds();
    print_figure("time at most 1 x corefinement", formatted("%.2f x", ratio), pair, ratio <= 1);
  }
  for (const char* nef : {kNef, kNefOneByOne}) {
    const Row* peer = result.find(nef);
    if (peer == nullptr) continue;
    const double ratio = ours.median_seconds() / peer->median_seconds();
    const double limit = pair ? kPairToNef : kManyToNef;
    const std::string what = nef == kNef ? "" : ", one by one";
    print_figure(formatted("time at most 1/%.0f of Nef", 1 / limit) + what, formatted("1/%.1f", 1 / ratio),
                 pair || many, ratio <= limit);
  }
  if (result.of_trees()) return;
  const double own = bytes_per_triangle(result);
  const double all = static_cast<double>(ours.peak_bytes()) / static_cast<double>(result.triangles);
  print_figure(formatted("memory at most %.0f bytes per input triangle", kBytesPerTriangle),
               formatted("%.0f, with program and input %.0f", own, all), pair || growth, own <= kBytesPerTriangle);
  print_figure("exact stage below 0.1 % of predicate calls", formatted("%.4f %%", 100 * ours.checked.exact_share),
               pair || growth, ours.checked.exact_share < kExactShare);
}

bool same_volume(const Row& row, const std::string& exact, double rounded) {
  if (!exact.empty() && !row.checked.exact_volume.empty()) return row.checked.exact_volume == exact;
  return std::abs(row.checked.volume - rounded) <= kAgreement * std::abs(rounded);
}

/// Seconds per cell of some cases, and the largest over the least.
void print_growth(const char* title, const std::vector<const CaseResult*>& cases) {
  if (cases.size() < 2) return;
  std::printf("\n%s\n%-20s %10s %10s %10s %14s %16s\n", title, "", "triangles", "cells", "median s", "ns per cell",
              "bytes/triangle");
  double low = 1e300, high = 0;
  for (const CaseResult* c : cases) {
    const double per_cell = c->seconds_per_cell();
    low = std::min(low, per_cell);
    high = std::max(high, per_cell);
    std::printf("%-20s %10zu %10zu %10.3f %14.1f %16.0f\n", c->name.c_str(), c->triangles,
                c->input_cells + c->ours().checked.cells, c->ours().median_seconds(), 1e9 * per_cell,
                bytes_per_triangle(*c));
  }
  print_target(formatted("largest over least time per cell at most %.1f: %.2f", kGrowth, high / low),
               high <= kGrowth * low);
}

void print_degenerate(const CaseResult& general, const std::vector<const CaseResult*>& cases) {
  if (cases.empty()) return;
  std::printf("\ndegenerate cases beside general position (%s: %.1f ns per cell)\n%-20s %14s %10s %12s\n",
              kGeneralPosition, 1e9 * general.seconds_per_cell(), "", "ns per cell", "ratio", "exact stage");
  double worst = 0;
  for (const CaseResult* c : cases) {
    const double ratio = c->seconds_per_cell() / general.seconds_per_cell();
    worst = std::max(worst, ratio);
    std::printf("%-20s %14.1f %10.2f %10.3f %%\n", c->name.c_str(), 1e9 * c->seconds_per_cell(), ratio,
                100 * c->ours().checked.exact_share);
  }
  print_target(formatted("cost per cell at most %.0f x general position: %.2f x", kDegenerate, worst),
               worst <= kDegenerate);
}

nlohmann::json json_of(const Row& row) {
  nlohmann::json out{{"system", row.system}};
  if (!row.done()) {
    out["failure"] = row.failure;
    return out;
  }
  const Outcome& o = row.checked;
  out["seconds"] = seconds_of(row);
  for (std::size_t i = 0; i < row.runs[0].stages.size(); ++i)
    out["stages"][row.runs[0].stages[i].first] = median_of_stage(row, i);
  out["peak_bytes"] = row.peak_bytes();
  out["own_bytes"] = row.own_bytes();
  out["vertices"] = o.vertices;
  out["faces"] = o.faces;
  out["volume"] = o.volume;
  out["wrong"] = row.wrong;
  out["note"] = o.note;
  if (row.ours) {
    out["cells"] = o.cells;
    out["exact_share"] = o.exact_share;
  }
  return out;
}

}  // namespace

double Row::median_seconds() const { return median(seconds_of(*this)); }
double Row::least_seconds() const { return least(seconds_of(*this)); }

std::size_t Row::peak_bytes() const {
  std::size_t bytes = 0;
  for (const Measures& run : runs) bytes = std::max(bytes, run.peak_bytes);
  return bytes;
}

std::size_t Row::own_bytes() const {
  std::size_t bytes = 0;
  for (const Measures& run : runs) bytes = std::max(bytes, run.own_bytes());
  return bytes;
}

const Row* CaseResult::find(const std::string& system) const {
  for (const Row& row : rows) {
    if (row.system == system && row.done() && !row.wrong) return &row;
  }
  return nullptr;
}

bool CaseResult::right() const {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) {
    return !row.ours || (row.done() && !row.wrong && row.checked.invalid.empty());
  });
}

double CaseResult::seconds_per_cell() const {
  return ours().median_seconds() / static_cast<double>(input_cells + ours().checked.cells);
}

void judge(CaseResult& result, const std::optional<long long>& volume) {
  std::string exact;
  double rounded = 0;
  if (volume) {
    result.oracle = "counting";
    exact = std::to_string(*volume);
    rounded = static_cast<double>(*volume);
  } else {
    const Row* oracle = result.find(kNef);
    if (oracle == nullptr) oracle = result.find(kCorefinement);
    if (oracle == nullptr) return;
    result.oracle = oracle->system;
    exact = oracle->checked.exact_volume;
    rounded = oracle->checked.volume;
  }
  for (Row& row : result.rows) row.wrong = row.done() && !same_volume(row, exact, rounded);
}

void print_case(const CaseResult& result) {
  std::printf("\n%s: %s of %zu %s", result.name.c_str(), result.operation.c_str(), result.leaves,
              result.of_trees() ? "trees\n" : "meshes");
  if (!result.of_trees()) std::printf(", %zu triangles\n", result.triangles);
  std::printf("%-20s %9s %9s %8s %9s %9s %9s %9s  %s\n", "", "median s", "least s", "ratio", "peak MB", "own MB",
              "vertices", "faces", "volume");
  for (const Row& row : result.rows) {
    if (!row.done()) {
      std::printf("%-20s %s\n", row.system.c_str(), row.failure.c_str());
      continue;
    }
    std::printf("%-20s %9.3f %9.3f %8.2f %9.1f %9.1f %9zu %9zu  %.15g%s\n", row.system.c_str(),
                row.median_seconds(), row.least_seconds(), row.median_seconds() / result.ours().median_seconds(),
                static_cast<double>(row.peak_bytes()) / 1e6, static_cast<double>(row.own_bytes()) / 1e6,
                row.checked.vertices, row.checked.faces, row.checked.volume, row.wrong ? "  WRONG" : "");
  }
  for (const Row& row : result.rows) {
    if (!row.done()) continue;
    std::printf("  %s:", row.system.c_str());
    for (std::size_t i = 0; i < row.runs[0].stages.size(); ++i)
      std::printf(" %s %.3f", row.runs[0].stages[i].first.c_str(), median_of_stage(row, i));
    std::printf("; %s\n", row.checked.note.c_str());
  }
  if (result.oracle.empty()) std::printf("  volume: no oracle ran\n");
  else std::printf("  volume: %s %s\n", result.right() ? "that of" : "WRONG beside", result.oracle.c_str());
  print_targets(result);
  std::fflush(stdout);
}

void print_summary(const std::vector<CaseResult>& results) {
  std::vector<const CaseResult*> sizes, leaves, degenerate;
  const CaseResult* general = nullptr;
  for (const CaseResult& result : results) {
    if (!result.ours().done()) continue;
    if (result.group == "growth") sizes.push_back(&result);
    if (result.name.starts_with("boxes")) leaves.push_back(&result);
    if (result.group == "degenerate") degenerate.push_back(&result);
    if (result.name == kGeneralPosition) general = &result;
  }
  print_growth("growth with size: cells are those of the input and of the refinement", sizes);
  print_growth("growth with the number of leaves", leaves);
  if (general != nullptr) print_degenerate(*general, degenerate);
  std::size_t wrong = 0;
  for (const CaseResult& result : results) wrong += result.right() ? 0 : 1;
  std::printf("\n%zu cases, %zu not right\n", results.size(), wrong);
}

void print_table(const std::vector<CaseResult>& results) {
  std::vector<std::string> systems;
  for (const CaseResult& result : results)
    for (const Row& row : result.rows)
      if (std::find(systems.begin(), systems.end(), row.system) == systems.end()) systems.push_back(row.system);
  std::printf("\nmedian seconds\n%-20s", "");
  for (const std::string& system : systems) std::printf("  %s", system.c_str());
  std::printf("\n");
  for (const CaseResult& result : results) {
    std::printf("%-20s", result.name.c_str());
    for (const std::string& system : systems) {
      const Row* row = result.find(system);
      const std::string figure = row == nullptr ? "" : formatted("%.3f", row->median_seconds());
      std::printf("  %*s", static_cast<int>(system.size()), figure.c_str());
    }
    std::printf("\n");
  }
}

void write_json(const std::string& path, const std::string& commit, const std::vector<CaseResult>& results) {
  nlohmann::json out = nlohmann::json::array();
  if (std::ifstream before(path); before && before.peek() != std::ifstream::traits_type::eof()) {
    out = nlohmann::json::parse(before, nullptr, false);
    const auto is_case = [](const nlohmann::json& one) { return one.is_object() && one.contains("name"); };
    if (!out.is_array() || !std::all_of(out.begin(), out.end(), is_case))
      throw std::runtime_error(path + ": has no rows of this benchmark; name another file");
  }
  for (const CaseResult& result : results) {
    nlohmann::json one{{"name", result.name},
                       {"group", result.group},
                       {"operation", result.operation},
                       {"leaves", result.leaves},
                       {"triangles", result.triangles},
                       {"input_cells", result.input_cells},
                       {"oracle", result.oracle},
                       {"right", result.right()},
                       {"commit", commit},
                       {"cores", std::thread::hardware_concurrency()}};
    for (const Row& row : result.rows) one["rows"].push_back(json_of(row));
    const auto same =
        std::find_if(out.begin(), out.end(), [&](const auto& o) { return o["name"] == result.name; });
    if (same != out.end()) *same = std::move(one);
    else out.push_back(std::move(one));
  }
  std::ofstream file(path);
  file << out.dump(1) << "\n";
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written; is the folder there and is there room?");
}

}  // namespace cnrg::bench
