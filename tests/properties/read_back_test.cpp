// Every node of a random dag, written as .json and read back as a leaf, is what was written: the same cells with
// the same numbers, the same components, features and volumes. It is read in a tree of its own, and beside a box
// that cuts its cells, since a leaf is refined together with all others.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "csg/formats/result_file.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"
#include "tests/oracles/dag_values.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using Json = nlohmann::json;

/// Without what says where things came from. Which diagonal halves a rectangle may depend on the roundings of its
/// corners, so of triangles their number.
Json said(const std::string& file) {
  Json json = Json::parse(test::text_of(file));
  json.erase("node"), json.erase("leaves");
  for (auto& component : json["components"]) component.erase("leaves");
  for (const char* kind : {"vertices", "edges", "faces", "regions"}) {
    for (auto& cell : json[kind]) cell.erase("origin");
  }
  for (auto& face : json["faces"]) face["triangles"] = face["triangles"].size();
  return json;
}

std::string json_changes(const Json& a, const Json& b) {
  const Json changes = Json::diff(a, b);
  return changes.empty() ? ""
                         : changes[0].dump() + " in place of " +
                               a.value(Json::json_pointer(changes[0]["path"].get<std::string>()), Json()).dump();
}

/// A tree whose nodes are a result read back and, if `cut`, a box in its middle.
std::string tree_around(const std::string& file, bool cut) {
  return "cnrg: 1\nnodes:\n  r: {cnrg: " + file + "}\n" +
         (cut ? "  box: {box: {min: [1/2, 1/3, 1/2], max: [5/2, 9/4, 7/2]}}\n  all: {sum: [box, r]}\nresult: all\n"
              : "result: r\n");
}

std::string read_back_failure(const RandomDag& dag) {
  const test::ScratchFolder dir;
  try {
    const Tree tree = parse_tree(tree_file(dag), dir / "dag.yaml");
    for (const bool raw : {false, true}) {
      EvaluateOptions options;
      options.raw = raw;
      for (std::size_t i = 0; i < dag.nodes.size(); ++i) options.nodes.push_back(tree.find(name_of(dag, i)));
      const Evaluation made = evaluate(tree, options);
      for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
        const std::string what = name_of(dag, i) + (raw ? " raw" : "");
        write(dir / "a.json", made.result(name_of(dag, i)));
        const Json wanted = said(dir / "a.json");
        for (const bool cut : {false, true}) {
          if (raw && cut) continue;  // then it has the box's cells, too
          EvaluateOptions again;
          again.raw = raw;
          again.validate = true;
          const Tree around = parse_tree(tree_around("a.json", cut), dir / "t.yaml");
          again.nodes = {around.find("r")};
          write(dir / "b.json", evaluate(around, again).result("r"));
          const Json got = said(dir / "b.json");
          if (got != wanted) return what + (cut ? " beside a box: " : ": ") + json_changes(wanted, got);
        }
      }
    }
    return {};
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

}  // namespace

TEST_CASE("Every node of a dag is read back as it was written", "[dag]") {
  const auto [first, last] = scenes::seeds(25);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomDag dag = random_dag(seed + 6'000'000, position_of(seed));
    const std::string failure = read_back_failure(dag);
    if (failure.empty()) {
      SUCCEED();
      continue;
    }
    const auto [least, why] = shrink(dag, failure, read_back_failure);
    FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << why << "\n" << tree_file(least));
  }
}

}  // namespace cnrg::properties
