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
#include <string_view>
#include <vector>

#include "csg/app/commands.h"
#include "csg/app/evaluation.h"
#include "csg/app/exit_status.h"
#include "csg/app/line_reader.h"
#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/leaf_numbers.h"
#include "csg/evaluate/places.h"
#include "csg/explain/lives.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/materials/sampler.h"
#include "csg/operators/node_value.h"
#include "csg/operators/sides.h"
#include "csg/text/escape.h"
#include "csg/text/input_file.h"
#include "csg/text/number.h"
#include "kernel/complex/interior.h"

namespace cnrg::app {
namespace {

/// The words of a line and the columns at which they begin, from 1.
struct LineWord {
  std::string_view text;
  int column;
};
std::vector<LineWord> words_of(std::string_view line) {
  std::vector<LineWord> words;
  const char* const kBlank = " \t\r";
  for (std::size_t begin = line.find_first_not_of(kBlank); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
    words.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
    if (words.size() > 3) break;
    begin = line.find_first_not_of(kBlank, end);
  }
  return words;
}

RationalPoint point_of(const std::vector<LineWord>& words, int line, int line_end) {
  RationalPoint point;
  for (std::size_t k = 0; k < 3; ++k) {
    if (k >= words.size()) {
      throw TreeError(
          kStandardInput, {line, line_end},
          "a point has three numbers and this line only " + std::to_string(words.size()) + "; write `x y z`");
    }
    NumberText number = read_number(words[k].text);
    if (!number.value)
      throw TreeError(kStandardInput, {line, words[k].column}, "`" + excerpt(words[k].text) + "`" + number.fault);
    point[k] = std::move(*number.value);
  }
  if (words.size() > 3) {
    throw TreeError(kStandardInput, {line, words[3].column},
                    "a point has three numbers and this line more; write `x y z`");
  }
  return point;
}

std::string cell_words(const SimplifiedComplex& simplified, const SimplifiedComplex::Place& place,
                       const NodeValue& value, const Attributes* said) {
  const Component component = component_of(simplified, place);
  const std::string text = std::to_string(place.dimension) + " " + cell_name(place.dimension, place.index) + " " +
                           std::to_string(component);
  if (component == 0) return text;
  const std::string name =
      shown(said != nullptr && !said->name.empty() ? said->name.text() : value.attributes(component).name.text());
  return name.empty() ? text : text + " " + name;
}

/// The fields of sides that tell a piece from others of its name.
std::string describe_sides(const std::vector<NamedSide>& sides) {
  std::string text;
  for (const NamedSide& side : sides) {
    if (side.tells) text += std::string("\t") + side.key() + ": " + shown(side.surface);
  }
  return text;
}

/// The fields of properties: of a region or a component those that are said of it, of a sheet, a wire or a point
/// its own.
std::string describe_properties(const Attributes* said) {
  std::string text;
  if (said == nullptr) return text;
  for (const auto& [key, property] : said->properties) text += "\t" + shown(key) + ": " + shown(to_text(property));
  return text;
}

/// The fields of parameters, the least where a seam or a pole has many.
std::string describe_parameters(const Evaluation& evaluation, const KeptValue& kept, const Location& cell,
                                const RationalPoint& p) {
  const SurfaceParameters& parameters = *evaluation.parameters;
  const std::vector<LeafId> leaves = origins_in(*evaluation.complex, *kept.value, cell);
  std::string text;
  const auto add = [&](LeafId leaf, const std::string& surface, const std::string& at) {
    text += "\t" + shown(evaluation.leaf_names[leaf.index()]) + ": " + shown(surface) + ": " + at;
  };
  const LeafOrder order = evaluation.leaves->order_below(evaluation.instances, kept.instance);
  const auto in_order = [&](auto points) {
    order.sort(points, [](const auto& q) { return q.leaf; });
    return points;
  };
  for (const PatchPoint& q : in_order(first_of_each(parameters.on_patches(cell, p, leaves)))) {
    add(q.leaf, parameters.patch_name(q.leaf, q.patch), to_string(q.at[0]) + " " + to_string(q.at[1]));
  }
  for (const CurvePoint& q : in_order(first_of_each(parameters.on_curves(cell, p, leaves)))) {
    add(q.leaf, parameters.curve_name(q.leaf, q.curve), to_string(q.at));
  }
  return text;
}

/// The field of the material, exact but for distances.
class Materials {
 public:
  explicit Materials(const NodeValue& value) : value_(value) {}
  /// `said`: of the cell by itself.
  std::string describe(Component component, const Attributes* said, const RationalPoint& p) {
    if (component == 0) return {};
    const bool own = said != nullptr && !said->material.empty();
    const RegionMaterial& material = own ? said->material : value_.attributes(component).material;
    const auto [it, fresh] = samplers_.try_emplace(&material, material);
    const Mixture mixture = it->second.at(p);
    return mixture.empty() ? "" : "\tmaterial: " + shown(to_text(mixture));
  }

 private:
  const NodeValue& value_;
  std::map<const RegionMaterial*, MaterialSampler> samplers_;
};

/// A node evaluated once, and once more for a point beyond the frame that stands for infinity.
///
/// All points at once would say how large the frame must be; but then no point could be answered before the last
/// one is read. A frame that is too small is left behind far, so that the next points are inside: each time it
/// grows by a larger factor.
class PlacesOfNodes {
 public:
  PlacesOfNodes(const Tree& tree, const LocateArguments& arguments)
      : tree_(tree), arguments_(arguments), node_(node_of(tree, arguments.node)) {
    evaluate_with(false);
  }

  /// What is printed for the point of a line.
  std::string describe(const RationalPoint& p, int line) {
    Location cell = locator_->locate(p);
    if (beyond_frame(*evaluation_->complex, cell)) {
      evaluate_beyond(p, line);
      cell = locator_->locate(p);
    }
    const KeptValue& value = evaluation_->value(node_);
    const SimplifiedComplex::Place place = value.simplified->place(*evaluation_->complex, cell);
    const Component component = component_of(*value.simplified, place);
    const Attributes* said = said_of(*evaluation_->complex, *value.value, cell);
    std::string text = cell_words(*value.simplified, place, *value.value, said);
    const bool of_component = said == nullptr && component != 0;
    if (of_component) text += describe_sides(sides_[component - 1]);
    text += describe_properties(of_component ? &value.value->attributes(component) : said);
    if (arguments_.parameters) text += describe_parameters(*evaluation_, value, cell, p);
    if (arguments_.material) text += materials_->describe(component, said, p);
    return text;
  }

 private:
  void evaluate_with(bool again) {
    EvaluateOptions options;
    options.threads = arguments_.threads;
    options.rows = Rows::none;
    options.result = node_;
    options.reach = reach_;
    materials_.reset(), locator_.reset();  // they refer to the evaluation
    evaluation_.emplace(again ? evaluate(tree_, options) : evaluate_in_view(tree_, options, false));
    locator_.emplace(*evaluation_->complex);
    const NodeValue& value = *evaluation_->value(node_).value;
    materials_.emplace(value);
    sides_ = named_sides(*evaluation_->complex, value,
                         [&](LeafId leaf) { return evaluation_->leaf_names[leaf.index()]; });
  }

  void evaluate_beyond(const RationalPoint& p, int line) {
    if (const std::string fault = too_far(p); !fault.empty()) throw TreeError(kStandardInput, {line, 1}, fault);
    RationalPoint far = p;
    const Rational factor(Integer(1) << (32 * ++grown_));
    for (Rational& x : far) x *= factor;
    if (!too_far(far).empty()) far = p;
    reach_.insert(reach_.end(), {p, far});
    evaluate_with(true);
  }

  const Tree& tree_;
  const LocateArguments& arguments_;
  NodeId node_;
  std::optional<Evaluation> evaluation_;
  std::optional<Locator> locator_;
  std::optional<Materials> materials_;
  std::vector<std::vector<NamedSide>> sides_;
  std::vector<RationalPoint> reach_;
  unsigned grown_ = 0;
};

}  // namespace

int run_locate(const LocateArguments& arguments) {
  if (arguments.tree == kStandardInputWord) {
    throw InputError("cnrg: error: `cnrg locate` reads points from standard input, so the tree has to be a file");
  }
  const Tree tree = tree_of(arguments);
  PlacesOfNodes places(tree, arguments);
  LineReader lines([] { std::cout << std::flush; });
  std::string_view line;
  while (std::cout && lines.next(line)) {
    const std::vector<LineWord> words = words_of(line);
    const int end = static_cast<int>(line.size()) + 1;
    if (!words.empty()) std::cout << places.describe(point_of(words, lines.number(), end), lines.number());
    std::cout << '\n';
  }
  return kDone;
}

}  // namespace cnrg::app
