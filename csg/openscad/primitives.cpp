// Modules without children, one function each.
#include "csg/openscad/primitives.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "csg/imports/mesh_file.h"
#include "csg/leaves/leaf.h"
#include "csg/openscad/arguments.h"
#include "csg/text/escape.h"

namespace cnrg::openscad {
namespace {

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

}  // namespace

std::string remedy() {
  return "let OpenSCAD write the solid that it is part of as part.off, and put `import(file = \"part.off\");` "
         "in "
         "that solid's place";
}

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

}  // namespace cnrg::openscad
