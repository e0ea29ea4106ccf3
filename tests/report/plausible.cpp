#include "tests/report/plausible.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace cnrg::bench {
namespace {

const std::vector<SystemInfo> kSystems = {
    {"ours", "cnrg", "any cells of dimension 0 to 3, exact, each contact once", "0.1.0", 0, false, ""},
    {"mantyla-double", "Mäntylä, double", "closed 2-manifold solids; one epsilon for all comparisons",
     "as published", 1e-10, true, ""},
    {"mantyla-exact", "Mäntylä, exact", "closed 2-manifold solids; rationals", "as published", 0, true, ""},
    {"nef", "CGAL Nef", "any cells, exact", "CGAL 5.5.1", 0, false, ""},
    {"corefinement", "CGAL corefinement", "closed 2-manifold surfaces; refuses a result that is none",
     "CGAL 5.5.1", 1e-15, true, ""},
    {"occt", "OpenCASCADE", "boundary representations with a tolerance", "7.6.3", 1e-7, true, ""},
    {"openscad", "OpenSCAD", "solids; Nef polyhedra inside, doubles outside", "2021.01", 1e-6, true, ""}};

struct Kind {
  FamilyInfo info;
  bool has_distance = false;
  std::vector<long> sizes;
  std::size_t triangles_per_size = 12;
};
const std::vector<Kind> kKinds = {
    {{"face", "two boxes that share a whole face", "boxes"}, true, {1}, 24},
    {{"part-face", "two boxes that share a part of a face", "boxes"}, true, {1}, 24},
    {{"edge", "two boxes that touch along an edge", "boxes"}, true, {1}, 24},
    {{"vertex", "two boxes that touch at a vertex", "boxes"}, true, {1}, 24},
    {{"wall", "one box inside another, a wall in common", "boxes"}, true, {1}, 24},
    {{"turned", "a cube and its copy, turned by less and less", "cubes"}, true, {1}, 24},
    {{"coplanar", "prisms with coplanar tops", "corners"}, true, {4, 16, 64, 256}, 8},
    {{"menger", "a cube without its prisms", "levels"}, false, {1, 2, 3}, 200},
    {{"boxes", "random boxes on an integer grid", "boxes"}, false, {5, 20, 80, 320}, 12},
    {{"spheres", "spheres on a lattice that overlap", "spheres"}, false, {2, 8, 27, 64}, 1020},
    {{"ground", "layers of ground with faults and tunnels", "layers"}, false, {2, 4, 8, 16}, 400},
    {{"fractures", "fractures in a box with wells", "fractures"}, false, {4, 16, 64}, 14},
    {{"chain", "one union after the other", "unions"}, false, {1, 10, 100, 1000}, 10},
    {{"wires", "a solid and wires through it", "wires"}, false, {1, 4}, 12},
    {{"files", "meshes of people and their turned copies", "meshes"}, false, {1}, 20000}};

/// Seconds per triangle, exponent, bytes per triangle.
struct Cost {
  double seconds, exponent, bytes;
};
constexpr Cost kCosts[] = {{6e-6, 1.03, 420}, {2e-6, 1.9, 300},    {9e-5, 1.95, 900}, {5e-4, 1.12, 16000},
                           {4e-6, 1.08, 700}, {1.5e-4, 1.3, 5000}, {6e-4, 1.1, 18000}};

struct Draw {
  std::mt19937 engine;
  double part() { return engine() / 4294967296.0; }
  bool happens(double chance) { return part() < chance; }
};

/// Verdict, stage and message of a system in a family at a distance.
struct Result {
  Verdict verdict = Verdict::same;
  const char *stage = "", *message = "";
};

Result near_degeneracy(const std::string& system, const std::string& family, const SweepRow& row, Draw& draw) {
  const bool exact = !row.distance;
  const int k = row.distance.value_or(99);
  const bool contact = family == "edge" || family == "vertex" || family == "wall";
  if (system == "mantyla-double") {
    if (exact && contact) return {Verdict::contact_duplicated, "", ""};
    if (k >= 9 && !exact && draw.happens(std::min(0.9, 0.15 * (k - 8)))) {
      if (draw.happens(0.3)) return {Verdict::wrong, "", "volume is 0.83 of the exact one"};
      return {Verdict::refused, draw.happens(0.6) ? "connecting" : "classification", "loose ends are left over"};
    }
    if (exact && draw.happens(0.2)) return {Verdict::refused, "finishing", "a loop has no partner"};
  }
  if (system == "mantyla-exact" && exact && contact) return {Verdict::contact_duplicated, "", ""};
  if (system == "corefinement" && exact && contact) {
    if (draw.happens(0.4)) return {Verdict::refused, "output", "the result is no manifold"};
    return {Verdict::contact_duplicated, "", ""};
  }
  if (system == "occt" && k >= 7 && draw.happens(exact ? 0.1 : k > 12 ? 0.25 : 0.55)) {
    return draw.happens(0.5) ? Result{Verdict::wrong, "", "surface too much"}
                             : Result{Verdict::crashed, "unknown", "signal 11"};
  }
  if (system == "openscad" && k >= 14 && !exact && draw.happens(0.7)) return {Verdict::contact_lost, "", ""};
  return {};
}

Result result_of(const std::string& system, const Kind& kind, const SweepRow& row, Draw& draw) {
  const std::string& family = kind.info.name;
  const bool classic = system.starts_with("mantyla");
  if (family == "wires" && system != "ours" && system != "nef") {
    if (system == "occt") return {Verdict::dangling_lost, "", ""};
    return {Verdict::refused, "input", "an operand is no solid"};
  }
  if (family == "files" && row.seed == 2) return {Verdict::unjudged, "", "the exact result took too long"};
  if (family == "fractures" && system != "ours" && system != "nef") return {Verdict::same_regularized, "", ""};
  if (classic && row.triangles > 20000) return {Verdict::timed_out, "", "60 s"};
  if (system == "nef" && row.triangles > 50000) return {Verdict::out_of_memory, "", ""};
  if (kind.has_distance) return near_degeneracy(system, family, row, draw);
  if (system == "mantyla-double" && draw.happens(0.15))
    return {Verdict::refused, "null edges", "a sector has no side"};
  return {};
}

SweepRow plausible_row(const Kind& kind, std::size_t system, SweepRow row, Draw& draw) {
  const std::string& name = kSystems[system].name;
  const auto triangles = static_cast<double>(row.triangles);
  const Cost& cost = kCosts[system];
  const Result result = result_of(name, kind, row, draw);
  row.system = name;
  row.verdict = result.verdict;
  row.stage = result.stage;
  row.message = result.message;
  const double noise = 0.8 + 0.5 * draw.part();
  row.seconds =
      result.verdict == Verdict::timed_out ? 60 : 2e-4 + cost.seconds * std::pow(triangles, cost.exponent) * noise;
  row.own_bytes = static_cast<std::size_t>(60000 + cost.bytes * triangles * (0.9 + 0.2 * draw.part()));
  row.peak_bytes = row.own_bytes + 18000000;
  row.stages = {{"Boolean", row.seconds}};
  if (name == kOurs) row.exact_share = row.distance || !row.has_distance ? 1e-4 * draw.part() : 0.02 * draw.part();
  row.command = "build/bench/bench/bench_sweep one --problem " + row.problem + " --system " + name;
  return row;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text << '\n';
}

}  // namespace

SweepRow right_row(const std::string& system, const std::string& family, long size, unsigned seed) {
  SweepRow row;
  row.family = family;
  row.operation = "union";
  row.size = size;
  row.seed = seed;
  row.problem = family + "-union-s" + std::to_string(size) + "-r" + std::to_string(seed);
  row.operands = 2;
  row.triangles = static_cast<std::size_t>(24 * size);
  row.system = system;
  row.verdict = Verdict::same;
  row.seconds = 1;
  row.own_bytes = 1000000;
  row.peak_bytes = 3000000;
  row.truth.confirmed = "Nef";
  row.limit_seconds = 60;
  row.limit_bytes = 4000000000;
  row.command = "bench_sweep one " + row.problem + " " + system;
  return row;
}

SweepRow at_distance(SweepRow row, std::optional<int> k, Verdict verdict) {
  row.has_distance = true;
  row.distance = k;
  row.verdict = verdict;
  row.problem = row.family + "-" + row.operation + "-s" + std::to_string(row.size) + "-k" +
                (k ? std::to_string(*k) : "exact") + "-r" + std::to_string(row.seed);
  return row;
}

PlausibleSweep plausible_sweep(std::size_t families, std::size_t systems, unsigned seeds) {
  PlausibleSweep sweep;
  sweep.systems.assign(kSystems.begin(), kSystems.begin() + static_cast<long>(systems));
  sweep.machine = {"Intel Xeon Platinum 8370C at 2.80 GHz",
                   2,
                   8000000000,
                   "Debian GNU/Linux 12, Linux 6.1",
                   "g++ 12.2.0 -O3",
                   "0123abcd",
                   "2026-11-21",
                   60,
                   4000000000,
                   "bench/run sweep --families all"};
  Draw draw{std::mt19937(7)};
  for (std::size_t f = 0; f < families; ++f) {
    const Kind& kind = kKinds[f];
    sweep.families.push_back(kind.info);
    std::vector<std::optional<int>> distances = {std::nullopt};
    if (kind.has_distance)
      for (int k = 0; k <= 16; ++k) distances.emplace_back(k);
    for (const char* operation : {"union", "difference", "intersection"}) {
      for (const long size : kind.sizes)
        for (const auto& k : distances)
          for (unsigned r = 1; r <= seeds; ++r) {
            SweepRow row = right_row("", kind.info.name, size, r);
            row.operation = operation;
            row.problem =
                kind.info.name + "-" + operation + "-s" + std::to_string(size) + "-r" + std::to_string(r);
            if (kind.has_distance) row = at_distance(row, k, Verdict::same);
            row.triangles = kind.triangles_per_size * static_cast<std::size_t>(size) *
                            (kind.info.name == "menger" ? static_cast<std::size_t>(std::pow(20, size - 1)) : 1);
            if (kind.info.name == "files") row.truth.confirmed = "volume";
            for (std::size_t s = 0; s < systems; ++s) sweep.rows.push_back(plausible_row(kind, s, row, draw));
          }
    }
  }
  return sweep;
}

void write_sweep(const std::string& folder, const PlausibleSweep& sweep) {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  write_text(fs::path(folder) / kSystemsFile, to_json(sweep.systems));
  write_text(fs::path(folder) / kFamiliesFile, to_json(sweep.families));
  write_text(fs::path(folder) / kMachineFile, to_json(sweep.machine));
  for (const SweepRow& row : sweep.rows) {
    const fs::path problem = fs::path(folder) / "rows" / row.problem;
    fs::create_directories(problem);
    write_text(problem / (row.system + ".json"), to_json(row));
  }
}

}  // namespace cnrg::bench
