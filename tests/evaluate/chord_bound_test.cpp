// How far results of curved leaves are from those of the exact solids: the bounds of papers/keyser2004.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Leaf {
  double volume, curved_area;
};

const std::map<std::string, Leaf> kLeaves{{"pipe_x", {3 * kPi, 6 * kPi}},
                                          {"pipe_y", {3 * kPi, 6 * kPi}},
                                          {"ball", {500 * kPi / 3, 100 * kPi}},
                                          {"bore", {108 * kPi, 72 * kPi}},
                                          {"wide", {300 * kPi, 120 * kPi}}};

struct Value {
  std::string name;
  double volume;
  std::vector<std::string> leaves;
};

const std::vector<Value> kValues{{"steinmetz", 16. / 3, {"pipe_x", "pipe_y"}},
                                 {"ring", 256 * kPi / 3, {"ball", "bore"}},
                                 {"touch", 0, {"ball", "wide"}}};

TEST_CASE("volumes of curved solids are within chord times area of the exact ones", "[evaluate][curved]") {
  const Tree tree = read_tree("papers/keyser2004/chords.yaml");
  for (const int chord : {10, 60}) {
    INFO("chord 1/" << chord);
    const auto numbered = [&](const std::string& name) { return name + "_" + std::to_string(chord); };
    EvaluateOptions options;
    for (const Value& result : kValues) options.nodes.push_back(tree.find(numbered(result.name)));
    std::map<std::string, double> volume;
    for (const NodeRow& row : evaluate(tree, options).rows) volume[row.name] = to_double(*row.volume());
    std::map<std::string, double> lost;
    for (const auto& [name, leaf] : kLeaves) {
      INFO(name);
      REQUIRE(volume.contains(numbered(name)));
      lost[name] = leaf.volume - volume[numbered(name)];
      CHECK(lost[name] > 0);  // facets are inside of convex solids
      CHECK(lost[name] <= leaf.curved_area / chord);
    }
    for (const Value& result : kValues) {
      INFO(result.name);
      const double error = volume[numbered(result.name)] - result.volume;
      CHECK((error == 0) == (result.name == "touch"));  // a contact that both leaves know
      CHECK(std::abs(error) <= lost[result.leaves[0]] + lost[result.leaves[1]]);
    }
  }
}

}  // namespace
}  // namespace cnrg
