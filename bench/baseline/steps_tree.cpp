// Each drawing is a leaf with a material of its name; materials have colors that are told apart with any colour
// vision.
#include "bench/baseline/steps_tree.h"

#include <map>
#include <utility>

#include "bench/cases/face_loops.h"
#include "bench/cases/model_text.h"
#include "csg/text/escape.h"

namespace cnrg::bench::mantyla {
namespace {

constexpr const char *kOrange = "#e69f00", *kSky = "#56b4e9", *kGreen = "#009e73", *kYellow = "#f0e442",
                     *kBlue = "#0072b2", *kRed = "#d55e00", *kPurple = "#cc79a7", *kGrey = "#999999",
                     *kBlack = "#222222";

/// By the beginning of a drawing's name; the longest one counts.
constexpr std::pair<const char*, const char*> kColors[] = {
    {"A", "#9db4cf"},
    {"B", "#d9c39a"},
    {"edge of A in a face of B", kRed},
    {"edge of B in a face of A", kBlue},
    {"edge of A at edge of B", kPurple},
    {"edge of A at vertex of B", kSky},
    {"vertex of A at edge of B", kOrange},
    {"vertex of A at vertex of B", kBlack},
    {"vertex of A in a face of B", kYellow},
    {"vertex of B in a face of A", kGreen},
    {"in ", kRed},
    {"out of ", kBlue},
    {"on B, counted as in", kOrange},
    {"on B, counted as out", kSky},
    {"on B, no crossing here", kPurple},
    {"on A, counted as in", kOrange},
    {"on A, counted as out", kSky},
    {"on A, no crossing here", kPurple},
    {"no crossing here", kGrey},
    {"pair of null edges", kGreen},
    {"end ahead", kRed},
    {"end behind", kBlue},
    {"open chain", kRed},
    {"loose null edge", kRed},
    {"A, kept", kBlue},
    {"B, kept", kOrange},
    {"A, dropped", "#c8d6e5"},
    {"B, dropped", "#f2e6cc"},
    {"result", kGreen},
    {"exact", kBlue},
    {"failed", "#d4005a"},
};

/// Loops, and null edges of several pairs, take turns.
std::string color_of(const std::string& name, std::size_t number) {
  constexpr const char* turns[] = {kGreen, kRed, kBlue, kOrange, kPurple, kSky};
  std::string color = turns[number % std::size(turns)];
  std::size_t longest = 0;
  for (const auto& [begin, value] : kColors)
    if (name.starts_with(begin) && std::string(begin).size() >= longest) {
      longest = std::string(begin).size();
      color = value;
    }
  return color;
}

class TreeWriter {
 public:
  TreeWriter(const Steps& steps) : steps_(steps) {}

  void node(const std::string& name, const std::string& text) { nodes_ += "  " + name + ": " + text + "\n"; }

  std::string material(const std::string& name) {
    if (materials_.emplace(name, materials_.size()).second) order_.push_back(name);
    return "material: " + quoted_text(name);
  }

  /// Pictures are numbered.
  std::string step_name(const std::string& name) { return std::to_string(++number_) + " " + name; }

  void edges() {
    for (const Drawing& edges : steps_.edges)
      if (!edges.model.wires.empty()) node(edges_of(edges), node_text(edges.model, material(edges.name)));
  }

  void step(const std::string& name, const std::vector<Drawing>& drawings, bool with_edges,
            const std::string& attributes = "") {
    std::vector<std::string> parts;
    for (const Drawing& drawing : drawings)
      parts.push_back(
          node_text(drawing.model, "name: " + quoted_text(drawing.name) + ", " + material(drawing.name)));
    for (const Drawing& edges : steps_.edges)
      if (with_edges && !edges.model.wires.empty()) parts.push_back(edges_of(edges));
    if (parts.empty()) parts.push_back(node_text({}));
    std::string text = parts[0];
    for (std::size_t k = 1; k < parts.size(); ++k) text += ", " + parts[k];
    if (parts.size() > 1) text = "{union: [" + text + "], dominance: left" + attributes + "}";
    node(step_name(name), text);
  }

  std::string text(const std::string& head, const std::string& result) const {
    std::string text = head + "cnrg: 1\nmaterials:\n";
    for (std::size_t k = 0; k < order_.size(); ++k)
      text += "  " + quoted_text(order_[k]) + ": {color: " + quoted_text(color_of(order_[k], k)) + "}\n";
    return text + "nodes:\n" + nodes_ + "result: " + result + "\n";
  }

 private:
  static std::string edges_of(const Drawing& edges) { return "edges of " + edges.name; }

  const Steps& steps_;
  std::string nodes_;
  std::map<std::string, std::size_t> materials_;
  std::vector<std::string> order_;
  std::size_t number_ = 0;
};

}  // namespace

std::string steps_tree(const Model& a, const Model& b, Operation operation, const Steps& steps,
                       const StepsTitle& title) {
  TreeWriter out(steps);
  out.node("A", node_text(a));
  out.node("B", node_text(b));
  const std::string first = out.step_name("operands");
  const std::string of_a = out.material("A"), of_b = out.material("B");  // the exact result is of no material
  out.node(first, "{union: [{closure: A, " + of_a + "}, {closure: B, " + of_b + "}], dominance: left}");
  out.edges();
  for (const Step& step : steps.steps) out.step(step.name, step.drawings, step.with_edges);
  std::string given;
  if (steps.failure) {
    const std::string where = std::string("failed in ") + to_string(steps.failure->stage());
    Drawing places{where + ": " + steps.failure->what(), {}};
    places.model.points = steps.failure->places();
    for (std::uint32_t p = 0; p < places.model.points.size(); ++p) places.model.isolated.push_back(p);
    out.step(where, places.model.points.empty() ? std::vector<Drawing>() : std::vector{places}, true);
  } else if (steps.result.empty() || title.solid) {
    Model model = steps.result;
    cut_holes(model);
    given = out.step_name("result");
    out.node(given, node_text(model, model.empty() ? "" : out.material("result")));
  } else {
    Model faces = steps.result;
    try {
      faces = triangulated(faces);
    } catch (const Failure&) {
      faces.faces.clear();
    }
    for (Model::Face& face : faces.faces) face.solid = false;
    out.step("result", {{"result, no solid", std::move(faces)}}, false);
  }
  const std::string exact = out.step_name("exact");
  out.node(exact, std::string("{") + to_string(operation) + ": [A, B], " + out.material("exact") + "}");
  if (!given.empty() && title.differs) {
    out.node(out.step_name("missing"), "{difference: [" + exact + ", " + given + "]}");
    out.node(out.step_name("excess"), "{difference: [" + given + ", " + exact + "]}");
  }
  return out.text("# " + shown(title.system) + ": " + shown(title.verdict) + "\n", first);
}

}  // namespace cnrg::bench::mantyla
