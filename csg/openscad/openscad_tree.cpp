// Exact solids as nodes, operands before users, each once.
#include "csg/openscad/openscad_tree.h"

#include <map>
#include <set>

#include "csg/leaves/leaf.h"
#include "csg/openscad/interpreter.h"
#include "csg/text/file.h"

namespace cnrg::openscad {
namespace {

std::string rational_text(const Rational& x) { return to_string(x); }
std::string exact_text(double x) { return to_string(from_double(x)); }

template <class Items, class Text>
std::string listed(const Items& items, Text text) {
  std::string out = "[";
  for (const auto& item : items) out += (out.size() > 1 ? ", " : "") + text(item);
  return out + "]";
}

std::string leaf(const Polyset& solid, std::string (*number)(double), const std::string& fill) {
  const std::string points = listed(solid.points, [&](const Point3& p) { return listed(p, number); });
  if (solid.convex == true) return "{hull: " + points + "}";
  const auto corners = [](const Face& f) { return listed(f, [](std::uint32_t i) { return std::to_string(i); }); };
  return "{mesh: {points: " + points + ", faces: " + listed(solid.faces, corners) + fill + "}}";
}

class TreeWriter {
 public:
  explicit TreeWriter(const Report& report) {
    for (const auto& w : report.warnings)
      tree_.warnings.emplace_back(OpenscadTree::Place{w.line, w.column}, w.text);
    tree_.inputs = report.inputs;
    add_line("cnrg: 1", {});
    add_line("nodes:", {});
  }

  OpenscadTree write(const Value& value, const Statement& at) && {
    if (const Solid* solid = std::get_if<Solid>(&value)) {
      add_node("model", leaf(solid->polyset, decimal, ""), *solid->from);
    } else {
      const std::string of = add(std::get<Exact>(value).solid);
      add_node("model", "{simplify: {of: " + of + ", mode: points}, regularize: true}", at);
    }
    add_line("result: model", at);
    return std::move(tree_);
  }

 private:
  void add_line(const std::string& line, const Statement& at) {
    tree_.yaml += line + "\n";
    tree_.places.push_back({at.line, at.column});
  }
  void add_node(const std::string& name, const std::string& value, const Statement& at) {
    add_line("  " + name + ": " + value, at);
  }
  /// The name of the node of a solid, after its statement and line.
  std::string add(const ExactSolidRef& solid) {
    const auto known = known_.find(solid.get());
    if (known != known_.end()) return known->second;
    const std::string value = text_of(*solid);
    const std::string name = solid->from->name + "-" + std::to_string(solid->from->line);
    std::string free = name;
    for (int n = 2; !names_.insert(free).second; ++n) free = name + "." + std::to_string(n);
    add_node(free, value, *solid->from);
    return known_[solid.get()] = free;
  }
  std::string text_of(const ExactSolid& solid) {
    const auto operands = [&] {
      return listed(solid.operands, [this](const ExactSolidRef& s) { return add(s); });
    };
    const auto points = [](const std::vector<RationalPoint>& list) {
      return listed(list, [](const RationalPoint& p) { return listed(p, rational_text); });
    };
    switch (solid.kind) {
      case ExactSolid::Kind::polyset: return leaf(solid.polyset, exact_text, ", fill: winding");
      case ExactSolid::Kind::sum: return "{minkowski: " + listed(solid.sum.summands, points) + "}";
      case ExactSolid::Kind::unite: return "{union: " + operands() + "}";
      case ExactSolid::Kind::subtract: return "{difference: " + operands() + "}";
      case ExactSolid::Kind::intersect: return "{intersection: " + operands() + "}";
      case ExactSolid::Kind::moved: break;
    }
    const auto row = [](const std::array<double, 4>& numbers) { return listed(numbers, decimal); };
    return "{simplify: " + add(solid.operands.front()) + ", matrix: " + listed(solid.matrix, row) + "}";
  }

  OpenscadTree tree_;
  std::set<std::string> names_{"model"};
  std::map<const ExactSolid*, std::string> known_;
};

/// The first statement marked `!`.
const Statement* marked(const std::vector<Statement>& statements) {
  for (const Statement& s : statements) {
    if (s.is_root) return &s;
    if (const Statement* below = marked(s.children)) return below;
  }
  return nullptr;
}

}  // namespace
}  // namespace cnrg::openscad

namespace cnrg {

bool is_openscad_file(const std::string& path) { return extension_of(path) == ".csg"; }

OpenscadTree openscad_tree(const std::string& text, const std::string& path, const std::string& inside) {
  using namespace openscad;
  const Statement all{"union", 1, 1, false, {}, parse_statements(path, text)};
  const Statement* const root = marked(all.children);
  Report report;
  const Value value = evaluate(root ? *root : all, path, inside, report);
  if (is_empty(value))
    throw LeafFileError(path, 0, 0, "the model is empty: nothing in it has a volume; add a solid such as `cube`");
  if (std::holds_alternative<Area>(value))
    throw LeafFileError(path, 0, 0, "the model is an area without a volume; put it into `linear_extrude`");
  return TreeWriter(report).write(value, root ? *root : all.children.front());
}

}  // namespace cnrg
