// `cnrg locate`: `dim cell component name` per input line.
//
// A cell is named by its letter (v, e, f, r) and its number in the simplified node, `-` where an inactive region
// touches nothing of the node. Component 0 is inactive and has no name; the entities of a group (walls, wires,
// points) are one component after its regions.
//
// With parameters, a point on a patch or curve of a leaf that its cell came from has more fields, each behind a
// tabulator (a name has none): `leaf: patch: u v`, `leaf: curve: t`, exactly; one for each patch and curve.
#include <algorithm>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/evaluate/evaluate.h"
#include "csg/explain/lives.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "csg/text/escape.h"

namespace cnrg::app {
namespace {

/// The words of a line and the columns at which they begin, from 1.
struct Word {
  std::string text;
  int column;
};
std::vector<Word> words_of(const std::string& line) {
  std::vector<Word> words;
  const char* const kBlank = " \t\r";
  for (std::size_t begin = line.find_first_not_of(kBlank); begin != std::string::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
    words.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
    begin = line.find_first_not_of(kBlank, end);
  }
  return words;
}

RationalPoint point_of(const std::vector<Word>& words, int line, int line_end) {
  RationalPoint point;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k >= words.size()) {
      throw TreeError(
          "<stdin>", {line, line_end},
          "a point has three numbers and this line only " + std::to_string(words.size()) + "; write `x y z`");
    }
    const std::optional<Rational> value = parse_rational(words[k].text);
    if (!value) {
      throw TreeError(
          "<stdin>", {line, words[k].column},
          "`" + words[k].text + "` is no number; write a decimal such as 0.1 or a fraction such as 1/3");
    }
    point[k] = *value;
  }
  if (words.size() > 3) {
    throw TreeError("<stdin>", {line, words[3].column},
                    "a point has three numbers and this line more; write `x y z`");
  }
  return point;
}

/// The point of each line of standard input; nothing for an empty line.
std::vector<std::optional<RationalPoint>> read_points() {
  std::vector<std::optional<RationalPoint>> points;
  std::string line;
  for (int number = 1; std::getline(std::cin, line); ++number) {
    const std::vector<Word> words = words_of(line);
    points.emplace_back();
    if (!words.empty()) points.back() = point_of(words, number, static_cast<int>(line.size()) + 1);
  }
  return points;
}

std::string describe(const SimplifiedComplex& simplified, const SimplifiedComplex::Place& place,
                     const NodeValue& value) {
  const Component component = component_of(simplified, place);
  const std::string text = std::to_string(place.dimension) + " " + cell_name(place.dimension, place.index) + " " +
                           std::to_string(component);
  if (component == 0) return text;
  const std::string name = shown(value.attributes(component).name);
  return name.empty() ? text : text + " " + name;
}

/// The fields of parameters, the least where a seam or a pole has many.
std::string describe_parameters(const Evaluation& evaluation, const NodeValue& value, const Location& cell,
                                const RationalPoint& p) {
  const SurfaceParameters& parameters = *evaluation.parameters;
  const std::vector<LeafId> leaves = origins_in(*evaluation.complex, value, cell);
  std::string text;
  const auto add = [&](LeafId leaf, const std::string& surface, const std::string& at) {
    text += "\t" + shown(evaluation.leaf_names[leaf.index()]) + ": " + shown(surface) + ": " + at;
  };
  for (const PatchPoint& q : first_of_each(parameters.on_patches(cell, p, leaves))) {
    add(q.leaf, parameters.patch_name(q.leaf, q.patch), to_string(q.at[0]) + " " + to_string(q.at[1]));
  }
  for (const CurvePoint& q : first_of_each(parameters.on_curves(cell, p, leaves))) {
    add(q.leaf, parameters.curve_name(q.leaf, q.curve), to_string(q.at));
  }
  return text;
}

/// The field of the material, exact but for distances.
class Materials {
 public:
  explicit Materials(const NodeValue& value) : value_(value) {}
  std::string describe(Component component, const RationalPoint& p) {
    if (component == 0) return {};
    const auto [it, fresh] = samplers_.try_emplace(component, value_.attributes(component).material);
    const Mixture mixture = it->second.at(p);
    return mixture.empty() ? "" : "\tmaterial: " + shown(to_text(mixture));
  }

 private:
  const NodeValue& value_;
  std::map<Component, MaterialSampler> samplers_;
};

}  // namespace

int run_locate(const LocateArguments& arguments) {
  const Tree tree = read_tree(arguments.tree, arguments.finer);
  const NodeId node = arguments.node.empty() ? tree.result : tree.find(arguments.node);
  const std::vector<std::optional<RationalPoint>> points = read_points();
  EvaluateOptions options;
  options.threads = arguments.threads;
  options.rows = false;
  options.nodes = {node};
  for (const auto& point : points) {
    if (point) options.reach.push_back(*point);
  }
  const Evaluation evaluation = evaluate_in_view(tree, options, false);
  const KeptValue& value = evaluation.value(node);
  const Locator locator(*evaluation.complex);
  Materials materials(*value.value);
  for (const auto& point : points) {
    if (!point) {
      std::cout << "\n";
      continue;
    }
    const Location cell = locator.locate(*point);
    const SimplifiedComplex::Place place = value.simplified->place(*evaluation.complex, cell);
    std::cout << describe(*value.simplified, place, *value.value);
    if (arguments.parameters) std::cout << describe_parameters(evaluation, *value.value, cell, *point);
    if (arguments.material) std::cout << materials.describe(component_of(*value.simplified, place), *point);
    std::cout << "\n";
  }
  return kDone;
}

}  // namespace cnrg::app
