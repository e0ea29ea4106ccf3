#include "bench/sweep/keep.h"

#include <filesystem>
#include <functional>
#include <set>
#include <sstream>

#include "bench/cases/face_loops.h"
#include "bench/sweep/store.h"
#include "csg/text/escape.h"

namespace cnrg::bench {
namespace {

template <class List, class Text>
std::string list_text(const List& list, Text text) {
  std::string out;
  for (const auto& item : list) out += (out.empty() ? "" : ", ") + text(item);
  return "[" + out + "]";
}

std::string point_text(const RationalPoint& p) {
  return list_text(p, [](const Rational& x) {
    const std::string text = cnrg::to_string(x);
    return text.find('/') == std::string::npos ? text : '"' + text + '"';
  });
}

/// The points of some places, and the numbers of all places among them.
struct Numbered {
  std::vector<RationalPoint> points;
  std::map<std::uint32_t, std::size_t> number;
  void use(const Model& model, std::uint32_t p) {
    if (number.emplace(p, points.size()).second) points.push_back(model.points[p]);
  }
};

void add_faces(const Model& model, bool solid, std::vector<std::string>& leaves) {
  Numbered used;
  std::vector<std::vector<std::uint32_t>> loops;
  for (const Model::Face& face : model.faces)
    if (face.solid == solid)
      for (const auto& loop : face.loops) {
        loops.push_back(loop);
        for (const std::uint32_t p : loop) used.use(model, p);
      }
  if (loops.empty()) return;
  leaves.push_back("{mesh: {points: " + list_text(used.points, point_text) + ", faces: " +
                   list_text(loops,
                             [&](const auto& loop) {
                               return list_text(
                                   loop, [&](std::uint32_t p) { return std::to_string(used.number.at(p)); });
                             }) +
                   ", fill: " + (solid ? "winding" : "none") + "}}");
}

/// Leaves, or their union. Faces have one loop.
std::string node_text(const Model& model) {
  std::vector<std::string> leaves;
  add_faces(model, true, leaves);
  add_faces(model, false, leaves);
  for (const auto& [a, b] : model.wires)
    leaves.push_back("{polyline: " + list_text(std::vector{model.points[a], model.points[b]}, point_text) + "}");
  std::vector<RationalPoint> isolated;
  for (const std::uint32_t p : model.isolated) isolated.push_back(model.points[p]);
  if (!isolated.empty()) leaves.push_back("{points: " + list_text(isolated, point_text) + "}");
  if (leaves.empty()) return "{intersection: [{points: [[0, 0, 0]]}, {points: [[1, 0, 0]]}]}";
  return leaves.size() == 1 ? leaves[0]
                            : "{union: " + list_text(leaves, [](const auto& leaf) { return leaf; }) + "}";
}

bool empty(const Model& model) { return model.faces.empty() && model.wires.empty() && model.isolated.empty(); }

}  // namespace

void keep_tree(const std::string& folder, const Problem& problem, const std::optional<Model>& result,
               const SweepRow& row) {
  std::filesystem::create_directories(folder);
  std::ostringstream out;
  out << "# " << shown(row.command) << "\n# " << row.system << ": " << to_string(row.verdict)
      << "\ncnrg: 1\nnodes:\n";
  std::string before;
  for (std::size_t i = 0; i < problem.operands.size(); ++i) {
    const std::string name = "operand " + std::to_string(i + 1);
    out << "  " << name << ": " << node_text(problem.operands[i]) << '\n';
    if (i == 0) {
      before = name;
      continue;
    }
    const std::string step = i + 1 == problem.operands.size() ? "exact" : "step " + std::to_string(i);
    out << "  " << step << ": {" << to_string(problem.steps[i - 1]) << ": [" << before << ", " << name << "]}\n";
    before = step;
  }
  const bool given = result && !empty(*result) && row.facts;  // else it bounds nothing that a tree could say
  if (given) {
    Model model = *result;
    cut_holes(model);
    out << "  given: " << node_text(model) << "\n  missing: {difference: [exact, given]}\n"
        << "  excess: {difference: [given, exact]}\n  differs: {union: [missing, excess]}\n";
  }
  out << "result: " << (given ? "differs" : "exact") << '\n';
  write_whole(folder + "/problem.yaml", out.str());
  write_whole(folder + "/row.json", to_json(row));
}

}  // namespace cnrg::bench
