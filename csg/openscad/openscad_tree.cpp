// Exact solids as nodes, operands before users, each once.
#include "csg/openscad/openscad_tree.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "csg/imports/mesh_file.h"
#include "csg/leaves/leaf.h"
#include "csg/openscad/statement.h"
#include "csg/openscad/value.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"

namespace cnrg::openscad {
namespace {

// Statements of a file, evaluated, children before parents: each makes a value (value.h).

/// What was met on the way.
struct Report {
  struct Warning {
    int line, column;
    std::string text;
  };
  std::vector<Warning> warnings;
  std::vector<std::string> inputs;  ///< files that were imported
};

/// What a statement is evaluated in.
struct Context {
  const std::string& path;    ///< of the file
  const std::string& inside;  ///< the folder that imported files must lie in; empty: anywhere
  Report& report;
  Fineness fineness{};  ///< of the statement
};

using Maker = Value (*)(const Statement&, const Context&);

/// What somebody can do about a module that is not read.
std::string remedy() {
  return "let OpenSCAD write the solid that it is part of as part.off, and put `import(file = \"part.off\");` "
         "in "
         "that solid's place";
}

// Modules without children: solids, areas, imported meshes.

Value make_cube(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"size", "center"});
  const std::vector<double> size = a.numbers("size", 3, 1);
  if (*std::min_element(size.begin(), size.end()) <= 0) return {};
  return Solid{cube({size[0], size[1], size[2]}, a.boolean("center")), &s};
}
Value make_sphere(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"r", "center"});  // a sphere is centred anyway
  const double radius = a.number("r", 1);
  if (radius <= 0) return {};
  return Solid{sphere(radius, c.fineness), &s};
}
Value make_cylinder(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"h", "r1", "r2", "center"});
  const double height = a.number("h", 1), bottom = a.number("r1", 1), top = a.number("r2", 1);
  if (height <= 0 || bottom < 0 || top < 0 || bottom + top == 0) return {};
  return Solid{cylinder(height, bottom, top, a.boolean("center"), c.fineness), &s};
}
Value make_polyhedron(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"points", "faces"});
  Polyset out;
  for (const auto& p : a.points("points", 3)) out.points.push_back({p[0], p[1], p[2]});
  out.faces = a.indices("faces", out.points.size());
  for (Face& face : out.faces) std::reverse(face.begin(), face.end());
  std::erase_if(out.faces, [](const Face& face) { return face.size() < 3; });
  return Solid{std::move(out), &s};
}
Value make_import(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"file", "layer", "origin", "scale", "center", "dpi", "id", "timestamp"});
  const std::string name = a.text("file");
  if (!is_mesh_file(name))
    openscad::fail(c.path, s, "reads meshes, and `" + excerpt(name) + "` is none; " + remedy());
  const auto path = std::filesystem::path(c.path).parent_path() / name;
  const MeshData mesh = [&] {
    try {
      return read_mesh(path.string(), false, c.inside);
    } catch (const FileError& e) {
      throw FileError(LeafFileError(c.path, s.line, s.column, e.what()).what());
    }
  }();
  c.report.inputs.push_back(path.string());
  Polyset out;
  for (std::size_t i = 0; i < mesh.point_count(); ++i)
    out.points.push_back({mesh.xyz[3 * i], mesh.xyz[3 * i + 1], mesh.xyz[3 * i + 2]});
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    out.faces.emplace_back(mesh.corners.begin() + mesh.offsets[f], mesh.corners.begin() + mesh.offsets[f + 1]);
  return Solid{std::move(out), &s};
}

Value make_square(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"size", "center"});
  const std::vector<double> size = a.numbers("size", 2, 1);
  if (size[0] <= 0 || size[1] <= 0) return {};
  const double x = a.boolean("center") ? -size[0] / 2 : 0, y = a.boolean("center") ? -size[1] / 2 : 0;
  const double u = a.boolean("center") ? size[0] / 2 : size[0], v = a.boolean("center") ? size[1] / 2 : size[1];
  return Area{{{{x, y}, {u, y}, {u, v}, {x, v}}}, true};
}
Value make_circle(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"r"});
  const double radius = a.number("r", 1);
  if (radius <= 0) return {};
  return Area{{circle(radius, c.fineness.segments(radius))}, true};
}
Value make_polygon(const Statement& s, const Context& c) {
  const Arguments a(c.path, s, {"points", "paths"});
  Loop points;
  for (const auto& p : a.points("points", 2)) points.push_back({p[0], p[1]});
  const std::vector<Face> paths = a.indices("paths", points.size());
  if (paths.empty()) return cleaned({{points}});  // before it is moved
  Area out;
  for (const Face& path : paths) {
    Loop& loop = out.loops.emplace_back();
    for (const std::uint32_t i : path) loop.push_back(points[i]);
  }
  return cleaned(out);
}

/// The function of a module; nullptr if it is none of these.
Maker primitive(std::string_view name) {
  static constexpr std::pair<std::string_view, Maker> kPrimitives[]{
      {"cube", make_cube},         {"sphere", make_sphere},
      {"cylinder", make_cylinder}, {"polyhedron", make_polyhedron},
      {"import", make_import},     {"square", make_square},
      {"circle", make_circle},     {"polygon", make_polygon},
  };
  for (const auto& [known, make] : kPrimitives) {
    if (known == name) return make;
  }
  return nullptr;
}

class Interpreter {
 public:
  Interpreter(const std::string& path, const std::string& inside, Report& report)
      : context_{path, inside, report} {}

  Value evaluate(const Statement& s) {
    for (const Module& module : modules()) {
      if (module.name == s.name) return made(s, [&] { return (this->*module.make)(s); });
    }
    if (const Maker make = primitive(s.name)) return made(s, [&] { return make(s, context_); });
    fail("is not read; " + remedy(), s);
  }

 private:
  using Method = Value (Interpreter::*)(const Statement&);
  struct Module {
    std::string_view name;
    Method make;
  };
  static const std::vector<Module>& modules();

  template <class Make>
  Value made(const Statement& s, Make make) {
    try {
      const Fineness parent = std::exchange(context_.fineness, fineness_of(context_.path, s, context_.fineness));
      Value out = make();
      context_.fineness = parent;
      if (const Area* area = std::get_if<Area>(&out)) {
        for (const Loop& loop : area->loops) require_near(loop);
      } else if (const Solid* solid = std::get_if<Solid>(&out)) {
        require_near(solid->polyset.points);
      } else if (const Exact* known = std::get_if<Exact>(&out); known && known->parts) {
        for (const auto& part : *known->parts) require_near(part);
      }
      return out;
    } catch (const LeafFileError&) {
      throw;
    } catch (const InputError& e) {
      fail(e.what(), s);
    }
  }
  /// So that places on OpenSCAD's grids are machine numbers.
  template <class Points>
  static void require_near(const Points& points) {
    for (const auto& p : points) {
      for (const double x : p) {
        if (!(std::abs(x) <= 1e12))
          throw InputError("has a corner farther than 10^12 from the origin; make it smaller");
      }
    }
  }

  [[noreturn]] void fail(const std::string& fault, const Statement& at) const {
    openscad::fail(context_.path, at, fault);
  }
  void warn(const std::string& text, const Statement& at) {
    context_.report.warnings.push_back({at.line, at.column, "`" + excerpt(at.name) + "` " + text});
  }
  Arguments arguments(const Statement& s, std::initializer_list<std::string_view> known) const {
    return Arguments(context_.path, s, known);
  }

  /// Of areas and solids those that come first; OpenSCAD leaves out the others.
  std::vector<Value> children(const Statement& s) {
    std::vector<Value> out;
    for (const Statement& child : s.children) out.push_back(evaluate(child));
    const auto first = std::find_if_not(out.begin(), out.end(), is_empty);
    for (Value& value : out) {
      if (is_empty(value) || std::holds_alternative<Area>(value) == std::holds_alternative<Area>(*first)) continue;
      warn("has areas and solids as children; as in OpenSCAD only the " +
               std::string(std::holds_alternative<Area>(value) ? "solids" : "areas") + " count",
           s);
      value = {};
    }
    return out;
  }
  static bool are_areas(const std::vector<Value>& values) {
    return std::any_of(values.begin(), values.end(),
                       [](const Value& v) { return std::holds_alternative<Area>(v); });
  }
  static std::vector<Area> areas(const std::vector<Value>& values) {
    std::vector<Area> out;
    for (const Value& value : values) {
      const Area* area = std::get_if<Area>(&value);
      out.push_back(area ? *area : Area{});
    }
    return out;
  }
  static void drop_empty(std::vector<Value>& values) {
    values.erase(std::remove_if(values.begin(), values.end(), is_empty), values.end());
  }

  Value united(const Statement& at, std::vector<Value> values) {
    drop_empty(values);
    if (values.empty()) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) {
      return combine(areas(values),
                     [](const auto& in) { return std::find(in.begin(), in.end(), true) != in.end(); });
    }
    std::vector<Exact> operands;
    std::optional<Parts> parts = Parts();
    for (const Value& value : values) {
      const std::optional<Exact> operand = exact_of(value);
      if (!operand) continue;
      operands.push_back(*operand);
      if (!operand->parts) parts.reset();
      else if (parts) parts->insert(parts->end(), operand->parts->begin(), operand->parts->end());
    }
    Value out = boolean(at, ExactSolid::Kind::unite, operands);
    if (auto* made = std::get_if<Exact>(&out)) made->parts = std::move(parts);
    return out;
  }
  Value make_union(const Statement& s) { return united(s, children(s)); }

  Value make_difference(const Statement& s) {
    const std::vector<Value> values = children(s);
    if (values.empty() || is_empty(values.front())) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) {
      return combine(areas(values), [](const auto& in) {
        return in[0] && std::find(in.begin() + 1, in.end(), true) == in.end();
      });
    }
    std::vector<Exact> operands;
    for (const Value& value : values) {
      if (const std::optional<Exact> operand = exact_of(value)) operands.push_back(*operand);
      else if (operands.empty()) return {};
    }
    return boolean(s, ExactSolid::Kind::subtract, operands);
  }

  Value make_intersection(const Statement& s) {
    const std::vector<Value> values = children(s);
    if (values.empty() || std::any_of(values.begin(), values.end(), is_empty)) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) {
      return combine(areas(values),
                     [](const auto& in) { return std::find(in.begin(), in.end(), false) == in.end(); });
    }
    std::vector<Exact> operands;
    for (const Value& value : values) {
      const std::optional<Exact> operand = exact_of(value);
      if (!operand) return {};
      operands.push_back(*operand);
    }
    return boolean(s, ExactSolid::Kind::intersect, operands);
  }

  Value make_transform(const Statement& s) {
    const Matrix m = arguments(s, {"m"}).matrix("m");
    Value value = united(s, children(s));
    if (is_empty(value)) return {};
    const double size = determinant(m);
    Area* area = std::get_if<Area>(&value);
    const auto is_finite = [](const auto& row) {
      return std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
    };
    if (!std::all_of(m.begin(), m.end(), is_finite) || !std::isfinite(size) ||
        (area ? m[0][0] * m[1][1] - m[0][1] * m[1][0] : size) == 0) {
      warn("has a matrix that makes its children flat or endless; as in OpenSCAD they are left out", s);
      return {};
    }
    if (area) return transformed(*area, {{{m[0][0], m[0][1], m[0][3]}, {m[1][0], m[1][1], m[1][3]}}});
    if (Solid* solid = std::get_if<Solid>(&value)) return Solid{transformed(solid->polyset, m), solid->from};
    return moved(std::get<Exact>(value), m, s);
  }

  Value make_hull(const Statement& s) {
    std::vector<Value> values = children(s);
    drop_empty(values);
    return are_areas(values) ? Value(hull(areas(values))) : Value(Solid{hull(corners_of(values)), &s});
  }
  Value make_minkowski(const Statement& s) {
    std::vector<Value> values = children(s);
    drop_empty(values);
    if (values.empty()) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) fail("of areas is not read; " + remedy(), s);
    std::optional<std::vector<Value>> sum = minkowski_sum(values, s);
    if (!sum) fail("takes one solid that is not convex, and this has two; " + remedy(), s);
    return united(s, std::move(*sum));
  }

  /// The area below an extrusion, clean.
  Area area_below(const Statement& s) {
    const Value value = united(s, children(s));
    if (is_empty(value)) return {};
    if (!std::holds_alternative<Area>(value)) fail("takes areas, and has a solid as child; remove it", s);
    return cleaned(std::get<Area>(value));
  }
  Value make_linear(const Statement& s) {
    const Arguments a = arguments(s, {"height", "center", "twist", "slices", "scale"});
    const std::vector<double> scale = a.numbers("scale", 2, 1);
    LinearExtrusion how{
        a.number("height", 100), a.number("twist", 0), {scale[0], scale[1]}, a.boolean("center"), {}};
    if (scale[0] < 0 || scale[1] < 0) fail("needs a `scale` of 0 or more", s);
    if (a.has("slices")) how.slices = static_cast<int>(std::clamp(a.number("slices", 1), 1.0, 1e6));
    const Area area = area_below(s);
    if (area.loops.empty() || how.height <= 0) return {};
    return Solid{extruded(area, how, context_.fineness), &s};
  }
  Value make_rotate(const Statement& s) {
    const Arguments a = arguments(s, {"angle"});
    const double degrees = std::clamp(a.number("angle", 360), -360.0, 360.0);
    const Area area = area_below(s);
    if (area.loops.empty() || degrees == 0) return {};
    auto out = revolved(area, degrees == -360 ? 360 : degrees, context_.fineness);
    if (!out) fail("needs an area on one side of the y axis, and this crosses it; move it", s);
    return Solid{std::move(*out), &s};
  }

  Context context_;
};

const std::vector<Interpreter::Module>& Interpreter::modules() {
  static const std::vector<Module> kModules{
      {"group", &Interpreter::make_union},           {"union", &Interpreter::make_union},
      {"color", &Interpreter::make_union},           {"render", &Interpreter::make_union},
      {"difference", &Interpreter::make_difference}, {"intersection", &Interpreter::make_intersection},
      {"multmatrix", &Interpreter::make_transform},  {"hull", &Interpreter::make_hull},
      {"minkowski", &Interpreter::make_minkowski},   {"linear_extrude", &Interpreter::make_linear},
      {"rotate_extrude", &Interpreter::make_rotate},
  };
  return kModules;
}

/// The statement must live as long as the value. `path`: of the file, for messages, and to find files that it
/// names; `inside`: the folder that these must lie in. Throws LeafFileError, and for a file
/// that is imported as `read_mesh`.
Value evaluate(const Statement& statement, const std::string& path, const std::string& inside, Report& report) {
  return Interpreter(path, inside, report).evaluate(statement);
}

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
