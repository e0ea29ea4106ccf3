// The interpreter: statements to areas, polygons and nodes of a tree, children before parents.
//
// A value is what OpenSCAD has at the same place: nothing, an area, polygons of doubles, or an exact solid, which is a
// node. One operand alone passes through a Boolean unchanged. Of an exact solid that is a union of convex ones the
// corners of these are kept, since hulls and Minkowski sums can do with them.
#include "csg/openscad/openscad_tree.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "csg/imports/mesh_file.h"
#include "csg/leaves/leaf.h"
#include "csg/openscad/arguments.h"
#include "csg/text/escape.h"

namespace cnrg::openscad {
namespace {

using Parts = std::vector<std::vector<Point3>>;

struct Solid {
  Polyset polyset;
  const Statement* from;
};
struct Exact {
  std::string node;
  std::optional<Parts> parts;
};
using Value = std::variant<std::monostate, Area, Solid, Exact>;

bool is_empty(const Value& value) {
  const Area* area = std::get_if<Area>(&value);
  const Solid* solid = std::get_if<Solid>(&value);
  return value.index() == 0 || (area && area->loops.empty()) || (solid && solid->polyset.faces.empty());
}

/// The shortest decimal that is nearest to the double.
std::string decimal(double x) {
  std::array<char, 32> text{};
  return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), x + 0.0).ptr);
}
std::string fraction(double x) { return to_string(from_double(x)); }

template <class Items, class Text>
std::string listed(const Items& items, Text text) {
  std::string out = "[";
  for (const auto& item : items) out += (out.size() > 1 ? ", " : "") + text(item);
  return out + "]";
}

bool is_flat(const std::vector<Point3>& points) { return hull(points).faces.empty(); }

class Interpreter {
 public:
  Interpreter(std::string path, std::string inside) : path_(std::move(path)), inside_(std::move(inside)) {}

  OpenscadTree run(const std::vector<Statement>& statements) {
    add_line("cnrg: 1", {});
    add_line("nodes:", {});
    const Statement all{"union", 1, 1, false, {}, statements};
    const Statement* root = marked(statements);
    Value value = evaluate(root ? *root : all);
    if (is_empty(value))
      throw LeafFileError(path_, 0, 0, "the model is empty: nothing in the file has a volume; add a solid such as `cube`");
    if (std::holds_alternative<Area>(value))
      throw LeafFileError(path_, 0, 0, "the model is an area without a volume; put it into `linear_extrude`");
    const Statement& at = root ? *root : statements.front();
    if (const Solid* solid = std::get_if<Solid>(&value)) {
      add_node("model", leaf(solid->polyset, decimal, ""), *solid->from);
    } else {
      add_node("model", "{simplify: {of: " + std::get<Exact>(value).node + ", mode: points}, regularize: true}", at);
    }
    add_line("result: model", at);
    return std::move(tree_);
  }

 private:
  /// The first statement marked `!`.
  static const Statement* marked(const std::vector<Statement>& statements) {
    for (const Statement& s : statements) {
      if (s.is_root) return &s;
      if (const Statement* below = marked(s.children)) return below;
    }
    return nullptr;
  }

  // ---- the tree ----

  void add_line(const std::string& line, const Statement& at) {
    tree_.yaml += line + "\n";
    tree_.places.push_back({at.line, at.column});
  }
  void add_node(const std::string& name, const std::string& value, const Statement& at) {
    add_line("  " + name + ": " + value, at);
  }
  /// Adds a node that is called after its statement and line.
  std::string add(const Statement& at, const std::string& value) {
    const std::string name = at.name + "-" + std::to_string(at.line);
    std::string free = name;
    for (int n = 2; !names_.insert(free).second; ++n) free = name + "." + std::to_string(n);
    add_node(free, value, at);
    return free;
  }
  /// A leaf; `fill` of one that is not convex.
  static std::string leaf(const Polyset& solid, std::string (*number)(double), const std::string& fill) {
    const std::string points =
        listed(solid.points, [&](const Point3& p) { return listed(p, number); });
    if (is_convex(solid)) return "{hull: " + points + "}";
    const auto corners = [](const Face& f) { return listed(f, [](std::uint32_t i) { return std::to_string(i); }); };
    return "{mesh: {points: " + points + ", faces: " + listed(solid.faces, corners) + fill + "}}";
  }
  /// What a Boolean takes; nothing if there is no volume.
  std::optional<Exact> exact(const Value& value) {
    if (is_empty(value)) return {};
    if (const Exact* known = std::get_if<Exact>(&value)) return *known;
    const Solid& solid = std::get<Solid>(value);
    const Polyset placed = on_grid(solid.polyset);
    const bool convex = is_convex(placed);
    if (placed.faces.empty() || (convex && is_flat(placed.points))) return {};
    Exact out{add(*solid.from, leaf(placed, fraction, ", fill: winding")), {}};
    if (convex) out.parts = Parts{placed.points};
    return out;
  }

  // ---- statements ----

  using Make = Value (Interpreter::*)(const Statement&);
  struct Module {
    std::string_view name;
    Make make;
  };
  static const std::vector<Module>& modules();

  Value evaluate(const Statement& s) {
    for (const Module& module : modules()) {
      if (module.name == s.name) return (this->*module.make)(s);
    }
    fail("is not read; " + remedy(), s);
  }
  [[noreturn]] void fail(const std::string& fault, const Statement& at) const { openscad::fail(path_, at, fault); }
  static std::string remedy() {
    return "let OpenSCAD write the solid that it is part of as part.off, and put `import(file = \"part.off\");` in "
           "that solid's place";
  }
  Arguments arguments(const Statement& s, std::initializer_list<std::string_view> known) const {
    return Arguments(path_, s, known);
  }

  std::vector<Value> children(const Statement& s) {
    std::vector<Value> out;
    for (const Statement& child : s.children) out.push_back(evaluate(child));
    bool areas = false, solids = false;
    for (const Value& value : out) {
      if (is_empty(value)) continue;
      (std::holds_alternative<Area>(value) ? areas : solids) = true;
    }
    if (areas && solids)
      fail("has areas and solids as children, and no Boolean takes both; put the areas into `linear_extrude`", s);
    return out;
  }
  static bool are_areas(const std::vector<Value>& values) {
    return std::any_of(values.begin(), values.end(), [](const Value& v) { return std::holds_alternative<Area>(v); });
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

  /// `Operator: [operands]`, or the only operand, as an exact solid.
  Value boolean(const Statement& at, const std::string& name, const std::vector<Exact>& operands) {
    if (operands.empty()) return {};
    if (operands.size() == 1) return operands.front();
    const auto node = [](const Exact& e) { return e.node; };
    return Exact{add(at, "{" + name + ": " + listed(operands, node) + "}"), {}};
  }

  Value united(const Statement& at, std::vector<Value> values) {
    drop_empty(values);
    if (values.empty()) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) {
      return combine(areas(values), [](const auto& in) { return std::find(in.begin(), in.end(), true) != in.end(); });
    }
    std::vector<Exact> operands;
    std::optional<Parts> parts = Parts();
    for (const Value& value : values) {
      const std::optional<Exact> operand = exact(value);
      if (!operand) continue;
      operands.push_back(*operand);
      if (!operand->parts) parts.reset();
      else if (parts) parts->insert(parts->end(), operand->parts->begin(), operand->parts->end());
    }
    Value out = boolean(at, "union", operands);
    if (Exact* made = std::get_if<Exact>(&out)) made->parts = std::move(parts);
    return out;
  }
  Value make_union(const Statement& s) { return united(s, children(s)); }

  Value make_difference(const Statement& s) {
    const std::vector<Value> values = children(s);
    if (values.empty() || is_empty(values.front())) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) {
      return combine(areas(values),
                     [](const auto& in) { return in[0] && std::find(in.begin() + 1, in.end(), true) == in.end(); });
    }
    std::vector<Exact> operands;
    for (const Value& value : values) {
      if (const std::optional<Exact> operand = exact(value)) operands.push_back(*operand);
      else if (operands.empty()) return {};
    }
    return boolean(s, "difference", operands);
  }

  Value make_intersection(const Statement& s) {
    const std::vector<Value> values = children(s);
    if (values.empty() || std::any_of(values.begin(), values.end(), is_empty)) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) {
      return combine(areas(values), [](const auto& in) { return std::find(in.begin(), in.end(), false) == in.end(); });
    }
    std::vector<Exact> operands;
    for (const Value& value : values) {
      const std::optional<Exact> operand = exact(value);
      if (!operand) return {};
      operands.push_back(*operand);
    }
    return boolean(s, "intersection", operands);
  }

  Value make_transform(const Statement& s) {
    const Matrix m = arguments(s, {"m"}).matrix("m");
    Value value = united(s, children(s));
    const double size = determinant(m);
    if (!std::isfinite(size)) return {};  // OpenSCAD leaves it out, too
    if (Area* area = std::get_if<Area>(&value)) {
      if (m[0][0] * m[1][1] - m[0][1] * m[1][0] == 0) return {};
      return transformed(*area, {{{m[0][0], m[0][1], m[0][3]}, {m[1][0], m[1][1], m[1][3]}}});
    }
    if (size == 0) return {};
    if (Solid* solid = std::get_if<Solid>(&value)) return Solid{transformed(solid->polyset, m), solid->from};
    Exact* known = std::get_if<Exact>(&value);
    if (!known) return {};
    Exact out{add(s, "{simplify: " + known->node + ", matrix: " +
                         listed(m, [](const auto& row) { return listed(row, decimal); }) + "}"),
              std::move(known->parts)};
    if (out.parts) {
      for (auto& part : *out.parts) part = transformed(Polyset{part, {}, true}, m).points;
    }
    return out;
  }

  /// Corners whose hull is the hull of a solid, of each of the convex solids that it is made of.
  Parts parts_of(const Value& value, const Statement& at, bool may_be_concave) const {
    const Solid* solid = std::get_if<Solid>(&value);
    if (solid && (may_be_concave || is_convex(solid->polyset))) return {solid->polyset.points};
    const Exact* known = std::get_if<Exact>(&value);
    if (!known || !known->parts) {
      fail("takes convex solids and unions of them, and this has another operand; " + remedy(), at);
    }
    return *known->parts;
  }

  Value make_hull(const Statement& s) {
    std::vector<Value> values = children(s);
    drop_empty(values);
    if (are_areas(values)) return hull(areas(values));
    std::vector<Point3> points;
    for (const Value& value : values) {
      for (const auto& part : parts_of(value, s, true)) points.insert(points.end(), part.begin(), part.end());
    }
    return Solid{hull(std::move(points)), &s};
  }

  Value make_minkowski(const Statement& s) {
    std::vector<Value> values = children(s);
    drop_empty(values);
    if (values.empty()) return {};
    if (values.size() == 1) return values.front();
    if (are_areas(values)) fail("of areas is not read; " + remedy(), s);
    Parts parts = parts_of(values.front(), s, false);
    for (auto value = values.begin() + 1; value != values.end(); ++value) {
      Parts next;
      const Parts others = parts_of(*value, s, false);
      for (const auto& a : parts) {
        for (const auto& b : others) next.push_back(hull(sums(a, b)).points);
      }
      parts = std::move(next);
    }
    std::vector<Value> solids;
    for (auto& part : parts) solids.push_back(Solid{hull(std::move(part)), &s});
    return united(s, std::move(solids));
  }

  Value make_cube(const Statement& s) {
    const Arguments a = arguments(s, {"size", "center"});
    const std::vector<double> size = a.numbers("size", 3, 1);
    if (*std::min_element(size.begin(), size.end()) <= 0) return {};
    return Solid{cube({size[0], size[1], size[2]}, a.boolean("center")), &s};
  }
  Value make_sphere(const Statement& s) {
    const Arguments a = arguments(s, {"r"});
    const double radius = a.number("r", 1);
    if (radius <= 0) return {};
    return Solid{sphere(radius, a.fineness()), &s};
  }
  Value make_cylinder(const Statement& s) {
    const Arguments a = arguments(s, {"h", "r1", "r2", "center"});
    const double height = a.number("h", 1), bottom = a.number("r1", 1), top = a.number("r2", 1);
    if (height <= 0 || bottom < 0 || top < 0 || bottom + top == 0) return {};
    return Solid{cylinder(height, bottom, top, a.boolean("center"), a.fineness()), &s};
  }
  Value make_polyhedron(const Statement& s) {
    const Arguments a = arguments(s, {"points", "faces"});
    Polyset out;
    for (const auto& p : a.points("points", 3)) out.points.push_back({p[0], p[1], p[2]});
    out.faces = a.indices("faces", out.points.size());
    for (Face& face : out.faces) std::reverse(face.begin(), face.end());
    std::erase_if(out.faces, [](const Face& face) { return face.size() < 3; });
    return Solid{std::move(out), &s};
  }
  Value make_import(const Statement& s) {
    const Arguments a = arguments(s, {"file", "layer", "origin", "scale", "center", "dpi", "id", "timestamp"});
    const std::string name = a.text("file");
    if (!is_mesh_file(name)) fail("reads meshes, and `" + excerpt(name) + "` is none; " + remedy(), s);
    const auto path = std::filesystem::path(path_).parent_path() / name;
    const MeshData mesh = read_mesh(path.string(), false, inside_);
    Polyset out;
    for (std::size_t i = 0; i < mesh.point_count(); ++i)
      out.points.push_back({mesh.xyz[3 * i], mesh.xyz[3 * i + 1], mesh.xyz[3 * i + 2]});
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
      out.faces.emplace_back(mesh.corners.begin() + mesh.offsets[f], mesh.corners.begin() + mesh.offsets[f + 1]);
    return Solid{std::move(out), &s};
  }

  Value make_square(const Statement& s) {
    const Arguments a = arguments(s, {"size", "center"});
    const std::vector<double> size = a.numbers("size", 2, 1);
    if (size[0] <= 0 || size[1] <= 0) return {};
    const double x = a.boolean("center") ? -size[0] / 2 : 0, y = a.boolean("center") ? -size[1] / 2 : 0;
    const double u = a.boolean("center") ? size[0] / 2 : size[0], v = a.boolean("center") ? size[1] / 2 : size[1];
    return Area{{{{x, y}, {u, y}, {u, v}, {x, v}}}, true};
  }
  Value make_circle(const Statement& s) {
    const Arguments a = arguments(s, {"r"});
    const double radius = a.number("r", 1);
    if (radius <= 0) return {};
    return Area{{circle(radius, a.fineness().segments(radius))}, true};
  }
  Value make_polygon(const Statement& s) {
    const Arguments a = arguments(s, {"points", "paths"});
    Loop points;
    for (const auto& p : a.points("points", 2)) points.push_back({p[0], p[1]});
    const std::vector<Face> paths = a.indices("paths", points.size());
    if (paths.empty()) return Area{{points}};
    Area out;
    for (const Face& path : paths) {
      Loop& loop = out.loops.emplace_back();
      for (const std::uint32_t i : path) loop.push_back(points[i]);
    }
    return out;
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
    LinearExtrusion how{a.number("height", 100), a.number("twist", 0), {scale[0], scale[1]}, a.boolean("center"), {}};
    if (scale[0] < 0 || scale[1] < 0) fail("needs a `scale` of 0 or more", s);
    if (a.has("slices")) how.slices = static_cast<int>(std::clamp(a.number("slices", 1), 1.0, 1e6));
    const Area area = area_below(s);
    if (area.loops.empty() || how.height <= 0) return {};
    return Solid{extruded(area, how, a.fineness()), &s};
  }
  Value make_rotate(const Statement& s) {
    const Arguments a = arguments(s, {"angle"});
    const double degrees = std::clamp(a.number("angle", 360), -360.0, 360.0);
    const Area area = area_below(s);
    if (area.loops.empty() || degrees == 0) return {};
    auto out = revolved(area, degrees == -360 ? 360 : degrees, a.fineness());
    if (!out) fail("needs an area on one side of the y axis, and this crosses it; move it", s);
    return Solid{std::move(*out), &s};
  }

  std::string path_, inside_;
  OpenscadTree tree_;
  std::set<std::string> names_{"model"};
};

const std::vector<Interpreter::Module>& Interpreter::modules() {
  static const std::vector<Module> kModules{
      {"group", &Interpreter::make_union},
      {"union", &Interpreter::make_union},
      {"color", &Interpreter::make_union},
      {"render", &Interpreter::make_union},
      {"difference", &Interpreter::make_difference},
      {"intersection", &Interpreter::make_intersection},
      {"multmatrix", &Interpreter::make_transform},
      {"hull", &Interpreter::make_hull},
      {"minkowski", &Interpreter::make_minkowski},
      {"cube", &Interpreter::make_cube},
      {"sphere", &Interpreter::make_sphere},
      {"cylinder", &Interpreter::make_cylinder},
      {"polyhedron", &Interpreter::make_polyhedron},
      {"import", &Interpreter::make_import},
      {"square", &Interpreter::make_square},
      {"circle", &Interpreter::make_circle},
      {"polygon", &Interpreter::make_polygon},
      {"linear_extrude", &Interpreter::make_linear},
      {"rotate_extrude", &Interpreter::make_rotate},
  };
  return kModules;
}

}  // namespace
}  // namespace cnrg::openscad

namespace cnrg {

bool is_openscad_file(const std::string& path) { return std::filesystem::path(path).extension() == ".csg"; }

OpenscadTree openscad_tree(const std::string& text, const std::string& path, const std::string& inside) {
  return openscad::Interpreter(path, inside).run(openscad::parse_statements(path, text));
}

}  // namespace cnrg
