// Chains of Boolean nodes against the same nodes evaluated one by one (csg/evaluate/chains.h): rows, files and
// what is said must be the same. Leaves are flat and round, solid and thin, and meet in points, lines and faces.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "tests/catch.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using scenes::Random;

std::string at(Random& random) {
  const auto x = [&] { return std::to_string(random.between(0, 5)); };
  return "[" + x() + ", " + x() + ", " + x() + "]";
}

std::string leaf(Random& random) {
  const int x = random.between(0, 3), y = random.between(0, 3), z = random.between(0, 3);
  const int a = random.between(1, 3), b = random.between(1, 3), c = random.between(1, 3);
  const auto p = [](int i, int j, int k) {
    return "[" + std::to_string(i) + ", " + std::to_string(j) + ", " + std::to_string(k) + "]";
  };
  switch (random.below(9)) {
    case 0: return "{polygon: [" + p(x, y, z) + ", " + p(x + a, y, z) + ", " + p(x + a, y + b, z) + "]}";
    case 1: return "{polyline: [" + p(x, y, z) + ", " + p(x + a, y, z) + ", " + p(x + a, y + b, z + c) + "]}";
    case 2: return "{points: [" + at(random) + ", " + p(x, y, z) + "]}";
    case 3:
      return "{cylinder: {from: " + p(x, y, z) + ", to: " + p(x, y, z + 2 * c) +
             ", radius: 1, segments: " + std::to_string(4 + a) + "}}";
    case 4: return "{sphere: {center: " + p(x, y, z) + ", radius: " + std::to_string(a) + ", segments: 6}}";
    default: return "{box: {min: " + p(x, y, z) + ", max: " + p(x + a, y + b, z + c) + "}}";
  }
}

/// A chain or two, and leaves below them.
std::string random_chains(std::uint64_t seed) {
  Random random(seed);
  const std::string operators[] = {"union", "union", "difference", "difference", "intersection"};
  const std::string dominances[] = {"", "", "", ", dominance: equal", ", dominance: left", ", dominance: right"};
  std::string nodes = "  n0: {union: [{box: {min: [0, 0, 0], max: [6, 6, 4]}}, " + leaf(random) + "]}\n";
  std::string op = operators[static_cast<std::size_t>(random.below(5))];
  const int count = random.between(3, 9);
  for (int i = 1; i <= count; ++i) {
    if (random.one_in(5)) op = operators[static_cast<std::size_t>(random.below(5))];
    std::string others;
    for (int k = random.one_in(4) ? 2 : 1; k > 0; --k) {
      others += ", ";
      others += random.one_in(12) ? "n0" : leaf(random);
    }
    nodes += "  n" + std::to_string(i) + ": {" + op + ": [n" + std::to_string(i - 1) + others + "]" +
             dominances[static_cast<std::size_t>(random.below(6))] + "}\n";
  }
  return "cnrg: 1\nnodes:\n" + nodes + "result: n" + std::to_string(count) + "\n";
}

/// With the volumes of all regions each node is evaluated by itself.
std::string file_of_chain(const Tree& tree, bool one_by_one) {
  EvaluateOptions options;
  options.refining = Refining::together;
  options.region_volumes = one_by_one;
  const Evaluation evaluation = evaluate(tree, options);
  const std::string path = (std::filesystem::temp_directory_path() / "chains_test.json").string();
  write(path, evaluation.result());
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  for (const NodeRow& row : evaluation.rows) {
    text << row.name << ' ' << row.operator_name << ' ' << row.is_group << ' ' << row.regions << ' '
         << (row.total ? to_string(*row.total) : "unbounded") << " cells";
    for (const std::size_t count : row.cells) text << ' ' << count;
    text << " raw";
    for (const std::size_t count : row.raw_cells) text << ' ' << count;
    text << " removed";
    for (const auto& [step, count] : row.removals) text << ' ' << step << ':' << count;
    text << '\n';
  }
  for (const Diagnostic& diagnostic : evaluation.diagnostics) text << diagnostic.message << '\n';
  return text.str();
}

TEST_CASE("Chains of nodes are their nodes one by one", "[chains]") {
  const auto [first, last] = scenes::seeds(200);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const std::string text = random_chains(seed);
    INFO("seed " << seed << "\n" << text);
    const Tree tree = parse_tree(text, "t.yaml");
    CHECK(file_of_chain(tree, false) == file_of_chain(tree, true));
  }
}

}  // namespace
}  // namespace cnrg::properties
