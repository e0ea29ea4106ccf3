// Whether a tree is refined in one or each of its Boolean nodes by itself, its results are the same, byte for byte
// (csg/evaluate/sections.h).
#include <filesystem>
#include <fstream>
#include <sstream>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "tests/catch.h"
#include "tests/oracles/dag.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

/// The exact file of the result, and the rows without times, of removals and of raw cells.
std::string told(const Tree& tree, Refining refining) {
  EvaluateOptions options;
  options.refining = refining;
  const Evaluation evaluation = evaluate(tree, options);
  const std::string path = (std::filesystem::temp_directory_path() / "sections_test.json").string();
  write(path, evaluation.result());
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  std::filesystem::remove(path);
  for (const NodeRow& row : evaluation.rows) {
    text << row.name << ' ' << row.operator_name << ' ' << row.components << ' ' << row.regions << ' '
         << (row.total ? to_string(*row.total) : "unbounded");
    for (const std::size_t count : row.cells) text << ' ' << count;
    text << '\n';
  }
  for (const Diagnostic& diagnostic : evaluation.diagnostics) text << diagnostic.message << '\n';
  return text.str();
}

TEST_CASE("Results do not tell what was refined together", "[dag]") {
  const auto [first, last] = scenes::seeds(150);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomDag dag = random_dag(seed + 7'000'000, position_of(seed));
    const std::string text = tree_file(dag);
    INFO("seed " << seed << "\n" << text);
    const Tree tree = parse_tree(text, "t.yaml");
    CHECK(told(tree, Refining::apart) == told(tree, Refining::together));
  }
}

}  // namespace
}  // namespace cnrg::properties
