// Trees that are welded: what is meant to touch does, whatever the order and the place of the leaves. Counts are
// those of the same tree without noise, which needs no weld.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Cells = std::array<std::size_t, 4>;

Evaluation run(const std::string& text, const std::string& file = "t.yaml") {
  EvaluateOptions options;
  options.validate = true;
  return evaluate(parse_tree("cnrg: 1\n" + text, file), options);
}

std::string failure(const std::string& text) {
  try {
    run(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

/// What stays the same when leaves change their order and place.
struct Counts {
  Cells cells, raw;
  std::size_t regions;
  friend bool operator==(const Counts&, const Counts&) = default;
};
std::ostream& operator<<(std::ostream& out, const Counts& c) {
  for (const std::size_t n : c.cells) out << n << ' ';
  out << "raw ";
  for (const std::size_t n : c.raw) out << n << ' ';
  return out << "regions " << c.regions;
}
Counts counts(const std::string& text) {
  const Evaluation evaluation = run(text);
  const NodeRow& row = evaluation.rows.back();
  return {row.cells, row.raw_cells, row.regions};
}

std::string point(const std::array<double, 3>& p) {
  char text[100];
  std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g]", p[0], p[1], p[2]);
  return text;
}

/// Boxes between planes of a grid, some left out, some two or three cells long; `noise`: each of their six numbers
/// is off by that much at most.
std::string grid(std::uint64_t seed, double noise, const std::string& attributes) {
  std::mt19937_64 random(seed);
  std::mt19937_64 errors(seed + 1);
  std::uniform_real_distribution<double> error(-noise, noise);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  std::array<std::vector<double>, 3> planes;
  for (auto& list : planes) {
    double at = below(7) * 0.1;
    for (int i = 0; i < 5; ++i) list.push_back(at), at += 0.3 + below(9) * 0.1;
  }
  std::vector<std::string> boxes;
  const std::size_t count = 3 + static_cast<std::size_t>(below(8));
  while (boxes.size() < count) {
    std::array<double, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = below(4), j = i + 1 + below(std::min(3, 4 - i));
      low[k] = planes[k][static_cast<std::size_t>(i)] + error(errors);
      high[k] = planes[k][static_cast<std::size_t>(j)] + error(errors);
    }
    boxes.push_back("{box: {min: " + point(low) + ", max: " + point(high) + "}" + attributes + "}");
  }
  std::shuffle(boxes.begin(), boxes.end(), errors);
  std::string text = "nodes:\n  all: {union: [";
  for (const std::string& box : boxes) text += box + ", ";
  return text + "]}\nresult: all\n";
}

TEST_CASE("boxes of a grid that are off by a quarter of the length make the grid", "[weld][random]") {
  const char* const seeds = std::getenv("CNRG_SEEDS");
  const std::uint64_t count = seeds != nullptr ? std::strtoull(seeds, nullptr, 10) : 30;
  const char* const from = std::getenv("CNRG_FIRST_SEED");
  const std::uint64_t first = from != nullptr ? std::strtoull(from, nullptr, 10) : 1;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    for (const std::string turn : {"", ", rotate: {axis: [1, 2, 3], degrees: 33}"}) {
      CAPTURE(seed, turn);
      const Counts exact = counts(grid(seed, 0, turn));
      CHECK(counts("weld: 1e-6\n" + grid(seed, 0.24e-6, turn)) == exact);
      CHECK(counts("weld: 1e-3\n" + grid(seed, 1e-14, turn)) == exact);
      CHECK(counts("weld: 1e-6\n" + grid(seed, 0, turn)) == exact);
    }
  }
}

}  // namespace
}  // namespace cnrg
