// One function per leaf, named in a table. What a shape means is checked by `prepare`; here only its form.
#include "csg/tree/read_leaf.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include "csg/curves/boundary_curves.h"
#include "csg/imports/mesh_file.h"
#include "csg/leaves/mesh_data.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"
#include "csg/text/number.h"
#include "csg/tree/read_curved.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

int segments(const Fields& fields, const char* key, int otherwise) {
  const Value* value = fields.find(key);
  return value ? static_cast<int>(value->integer(fields.name(key), 3, Fineness::kMostSegments)) : otherwise;
}

Rational number(const Fields& fields, const char* key) {
  return fields.at(key, "number").number(fields.name(key));
}

RationalPoint point(const Fields& fields, const char* key) {
  return fields.at(key, kPoint).point(fields.name(key));
}

}  // namespace

Rational read_weld(const Value& value, const std::string& what) {
  Rational d = value.number(what);
  if (d <= 0) value.fail(what + " must be above 0: give the length below which things are meant to coincide");
  return d;
}

namespace {

Shape read_box(const Value& value, const LeafContext&) {
  const Fields f(value, "box", {"min", "max"});
  return BoxShape{point(f, "min"), point(f, "max")};
}

Shape read_prism(const Value& value, const LeafContext&) {
  const Fields f(value, "prism", {"base", "holes", "vector"});
  PrismShape shape;
  shape.base = f.at("base", kPoints).points(f.name("base"));
  if (const Value* holes = f.find("holes")) shape.holes = holes->loops(f.name("holes"));
  shape.vector = point(f, "vector");
  return shape;
}

Shape read_pyramid(const Value& value, const LeafContext&) {
  const Fields f(value, "pyramid", {"base", "apex"});
  return PyramidShape{f.at("base", kPoints).points(f.name("base")), point(f, "apex")};
}

Shape read_tetrahedron(const Value& value, const LeafContext&) {
  const std::vector<RationalPoint> points = value.points("tetrahedron");
  if (points.size() != 4) value.fail_type("tetrahedron", "a list of four points");
  return TetrahedronShape{{points[0], points[1], points[2], points[3]}};
}

Shape read_polygon(const Value& value, const LeafContext&) {
  PolygonShape shape;
  if (!value.is_map()) {
    shape.outer = value.points("polygon");
    return shape;
  }
  const Fields f(value, "polygon", {"outer", "holes"});
  shape.outer = f.at("outer", kPoints).points(f.name("outer"));
  if (const Value* holes = f.find("holes")) shape.holes = holes->loops(f.name("holes"));
  return shape;
}

Shape read_polyline(const Value& value, const LeafContext&) {
  PolylineShape shape;
  if (!value.is_map()) {
    shape.points = value.points("polyline");
    return shape;
  }
  const Fields f(value, "polyline", {"points", "closed"});
  shape.points = f.at("points", kPoints).points(f.name("points"));
  if (const Value* closed = f.find("closed")) shape.closed = closed->boolean(f.name("closed"));
  return shape;
}

Shape read_points(const Value& value, const LeafContext&) { return PointsShape{value.points("points")}; }

Shape read_plane(const Value& value, const LeafContext&) {
  const Fields f(value, "plane", {"point", "normal"});
  return PlaneShape{point(f, "point"), point(f, "normal")};
}

Shape read_halfspace(const Value& value, const LeafContext&) {
  const Fields f(value, "halfspace", {"point", "normal"});
  return HalfspaceShape{point(f, "point"), point(f, "normal")};
}

Shape read_sphere(const Value& value, const LeafContext&) {
  const Fields f(value, "sphere", {"center", "radius", "segments", "rings"});
  SphereShape shape{point(f, "center"), number(f, "radius")};
  shape.segments = segments(f, "segments", shape.segments);
  if (const Value* rings = f.find("rings")) {
    shape.rings = static_cast<int>(rings->integer(f.name("rings"), 2, Fineness::kMostSegments));
  }
  return shape;
}

Shape read_cylinder(const Value& value, const LeafContext&) {
  const Fields f(value, "cylinder", {"from", "to", "radius", "segments"});
  CylinderShape shape{point(f, "from"), point(f, "to"), number(f, "radius")};
  shape.segments = segments(f, "segments", shape.segments);
  return shape;
}

Shape read_cone(const Value& value, const LeafContext&) {
  const Fields f(value, "cone", {"from", "to", "radius", "top", "segments"});
  ConeShape shape{point(f, "from"), point(f, "to"), number(f, "radius")};
  if (f.has("top")) shape.top = number(f, "top");
  shape.segments = segments(f, "segments", shape.segments);
  return shape;
}

Shape read_torus(const Value& value, const LeafContext&) {
  const Fields f(value, "torus", {"center", "axis", "radius", "tube", "segments", "rings"});
  TorusShape shape{point(f, "center"), point(f, "axis"), number(f, "radius"), number(f, "tube")};
  shape.segments = segments(f, "segments", shape.segments);
  shape.rings = segments(f, "rings", shape.rings);
  return shape;
}

Shape read_heightfield(const Value& value, const LeafContext& context) {
  const Fields f(value, "heightfield", {"origin", "spacing", "heights", "file", "base"});
  HeightfieldShape shape;
  if (f.has("base")) shape.base = number(f, "base");
  if (const Value* file = f.find("file")) {
    for (const char* key : {"origin", "spacing", "heights"}) {
      if (const Value::Entry* e = f.entry(key)) {
        value.document().fail(e->key_at,
                              "heightfield has `file` and `" + std::string(key) + "`; remove one of them");
      }
    }
    shape.file = path_in_folder(file->text(f.name("file")), context);
    shape.inside = context.inside;
    return shape;
  }
  if (const Value* origin = f.find("origin")) {
    const auto xy = origin->pair(f.name("origin"));
    shape.origin_x = xy[0];
    shape.origin_y = xy[1];
  }
  if (const Value* spacing = f.find("spacing")) {
    const auto xy = spacing->pair(f.name("spacing"));
    shape.spacing_x = xy[0];
    shape.spacing_y = xy[1];
  }
  const std::string what = f.name("heights");
  for (const Value& row : f.at("heights", "[[z, ...], ...]").list(what, "a list of rows [[z, ...], ...]")) {
    auto& heights = shape.heights.emplace_back();
    for (const Value& z : row.list("each row of " + what, "a list of numbers")) heights.push_back(z.number(what));
    if (heights.size() != shape.heights.front().size()) {
      row.fail("this row of `heights` has " + std::to_string(heights.size()) + " numbers and the first has " +
               std::to_string(shape.heights.front().size()) + "; all rows must be equally long");
    }
  }
  return shape;
}

/// A number of a point in the list `of`, which has `count`.
std::uint32_t read_vertex(const Value& value, const std::string& what, std::size_t count,
                          const char* of = "vertices") {
  if (count == 0) value.fail(what + " names a point, but `" + of + "` is empty");
  return static_cast<std::uint32_t>(value.integer(what, 0, static_cast<std::int64_t>(count) - 1));
}

/// A mesh that stands in the tree itself. A point that no double is goes to the exact ones.
std::shared_ptr<const MeshData> read_mesh_data(const Fields& f) {
  auto data = std::make_shared<MeshData>();
  const std::vector<RationalPoint> points = f.at("points", kPoints).points(f.name("points"));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Rational& x : points[i]) data->xyz.push_back(to_double(x));
    if (!std::all_of(points[i].begin(), points[i].end(), is_double))
      data->exact.emplace_back(static_cast<std::uint32_t>(i), points[i]);
  }
  const std::string what = f.name("faces");
  for (const Value& face : f.at("faces", "[[0, 1, 2], ...]").list(what, "a list of faces [[0, 1, 2], ...]")) {
    const std::vector<Value> corners = face.list("each of " + what, "a list of numbers of points [0, 1, 2]");
    if (corners.size() < 3) face.fail_type("each of " + what, "a list of three or more numbers of points");
    for (const Value& corner : corners)
      data->corners.push_back(read_vertex(corner, "a corner of a face", points.size(), "points"));
    data->end_face();
  }
  return data;
}

Shape read_mesh_leaf(const Value& value, const LeafContext& context) {
  const Fields f(value, "mesh", {"file", "points", "faces", "fill", "coordinates", "weld"});
  MeshShape shape;
  if (f.has("points") || f.has("faces")) {
    for (const char* key : {"file", "coordinates"}) {
      if (const Value::Entry* e = f.entry(key)) {
        value.document().fail(e->key_at, "mesh has `" + std::string(key) +
                                             "`, which is for a mesh from a file, and "
                                             "`points` or `faces`, which are a mesh; remove one of them");
      }
    }
    shape.data = read_mesh_data(f);
  } else {
    shape.file = path_in_folder(f.at("file", "part.off").text(f.name("file")), context);
    shape.inside = context.inside;
  }
  if (const Value* fill = f.find("fill")) shape.fill = read_fill(*fill, f.name("fill"));
  if (const Value* coordinates = f.find("coordinates")) {
    const std::string name = coordinates->text(f.name("coordinates"));
    if (name != "decimal" && name != "double")
      coordinates->fail_type(f.name("coordinates"), "one of double, decimal");
    shape.decimal = name == "decimal";
  }
  if (const Value* weld = f.find("weld")) shape.weld = read_weld(*weld, f.name("weld"));
  return shape;
}

/// What STEP and BREP files have in common; `f` are the fields of either.
CadShape read_cad(const Fields& f, CadShape::Format format, const LeafContext& context) {
  CadShape shape;
  shape.format = format;
  shape.file = path_in_folder(f.at("file", "part.step").text(f.name("file")), context);
  shape.inside = context.inside;
  shape.tessellation = read_tessellation(f);
  if (const Value* fill = f.find("fill")) {
    const std::string name = fill->text(f.name("fill"));
    if (name == "solids") shape.fill = Fill::solids;
    else if (name == "winding") shape.fill = Fill::winding;
    else if (name == "cells") shape.fill = Fill::cells;
    else if (name == "none") shape.fill = Fill::none;
    else fill->fail_type(f.name("fill"), "one of solids, winding, cells, none");
  }
  if (const Value* solids = f.find("solids")) {
    for (const Value& solid : solids->list(f.name("solids"), "a list of numbers or names of solids")) {
      shape.solids.push_back(solid.text("each of " + f.name("solids")));
    }
    if (shape.solids.empty()) solids->fail(f.name("solids") + " is empty; name a solid, or leave it out for all");
  }
  if (const Value* seams = f.find("seams")) shape.seams = seams->boolean(f.name("seams"));
  if (const Value* weld = f.find("weld")) shape.weld = read_weld(*weld, f.name("weld"));
  return shape;
}

Shape read_step(const Value& value, const LeafContext& context) {
  const Fields f(value, "step", {"file", "chord", "segments", "unit", "fill", "solids", "seams", "weld"});
  CadShape shape = read_cad(f, CadShape::Format::step, context);
  if (const Value* unit = f.find("unit")) {
    shape.unit = unit->text(f.name("unit"));
    constexpr std::string_view kUnits[] = {"um", "mm", "cm", "m", "km", "in", "ft"};
    if (std::find(std::begin(kUnits), std::end(kUnits), shape.unit) == std::end(kUnits))
      unit->fail_type(f.name("unit"), "one of um, mm, cm, m, km, in, ft");
  }
  return shape;
}

Shape read_brep(const Value& value, const LeafContext& context) {
  const Fields f(value, "brep", {"file", "chord", "segments", "fill", "solids", "seams", "weld"});
  return read_cad(f, CadShape::Format::brep, context);
}

GroupShape::Face read_group_face(const Value& value, std::size_t vertex_count, bool filled) {
  const Fields f(value, "a face of group", {"loops", "sides"});
  GroupShape::Face face;
  face.line = value.at().line;
  face.column = value.at().column;
  for (const Value& loop :
       f.at("loops", "[[0, 1, 2]]").list(f.name("loops"), "a list of loops [[0, 1, 2], ...]")) {
    auto& numbers = face.loops.emplace_back();
    for (const Value& v : loop.list("each loop of a face", "a list of vertex numbers [0, 1, 2]")) {
      numbers.push_back(read_vertex(v, "a vertex of a loop", vertex_count));
    }
    if (numbers.size() < 3) loop.fail("a loop needs three vertices or more; use `edges` for a wire");
  }
  if (face.loops.empty()) value.fail("a face needs a loop; write `loops: [[0, 1, 2]]`");
  if (const Value::Entry* sides = f.entry("sides")) {
    if (filled)
      value.document().fail(sides->key_at,
                            "this group has `fill`, which decides the sides; remove `sides` or `fill`");
    const std::vector<Value> pair = sides->value.list(f.name("sides"), "a list of two region numbers");
    if (pair.size() != 2) sides->value.fail_type(f.name("sides"), "a list of two region numbers");
    for (int k = 0; k < 2; ++k) {
      face.sides[k] = static_cast<std::uint32_t>(pair[k].integer(f.name("sides"), 0, 1'000'000'000));
    }
  }
  return face;
}

Shape read_group(const Value& value, const LeafContext& context) {
  const Fields f(value, "group", {"vertices", "faces", "edges", "points", "regions", "fill"});
  GroupShape shape;
  if (const Value* fill = f.find("fill")) shape.fill = read_fill(*fill, f.name("fill"));
  shape.vertices = f.at("vertices", kPoints).points(f.name("vertices"));
  const std::size_t n = shape.vertices.size();
  if (const Value* faces = f.find("faces")) {
    for (const Value& face : faces->list(f.name("faces"), "a list of faces [{loops: [[0, 1, 2]]}, ...]")) {
      shape.faces.push_back(read_group_face(face, n, shape.fill.has_value()));
    }
  }
  if (const Value* edges = f.find("edges")) {
    for (const Value& edge : edges->list(f.name("edges"), "a list of pairs [[0, 1], ...]")) {
      const std::vector<Value> ends = edge.list("each edge of group", "a pair of vertex numbers [0, 1]");
      if (ends.size() != 2) edge.fail_type("each edge of group", "a pair of vertex numbers [0, 1]");
      shape.edges.push_back(
          {read_vertex(ends[0], "an end of an edge", n), read_vertex(ends[1], "an end of an edge", n)});
    }
  }
  if (const Value* points = f.find("points")) {
    for (const Value& p : points->list(f.name("points"), "a list of vertex numbers")) {
      shape.points.push_back(read_vertex(p, f.name("points"), n));
    }
  }
  if (const Value* regions = f.find("regions")) {
    for (const Value::Entry& e : regions->entries(f.name("regions"))) {
      const std::optional<Rational> number = read_number(e.key).value;
      if (!number || number->get_den() != 1 || *number < 1 || *number > 1'000'000'000) {
        value.document().fail(
            e.key_at, "a key of `regions` must be the number of a region, from 1, not `" + excerpt(e.key) + "`");
      }
      const Fields attributes(e.value, "a region of group", {"material", "name"});
      GroupShape::Region& region = shape.regions[to_machine<std::uint32_t>(number->get_num())];
      if (const Value* name = attributes.find("name")) region.name = name->text(attributes.name("name"));
      if (const Value* material = attributes.find("material")) {
        region.material = material->text(attributes.name("material"));
        context.check_material(*material);
      }
    }
  }
  return shape;
}

/// Files of results that hold doubles; any other name may be that of an exact one.
constexpr std::array<std::string_view, 13> kRoundedFiles{
    ".vtu", ".msh", ".mesh", ".inp", ".bdf", ".h5m", ".med", ".poly", ".smesh", ".xdmf", ".glb", ".3mf", ".svg"};

Shape read_result(const Value& value, const LeafContext& context) {
  const std::string name = value.text("`cnrg`, the file of a result,"), extension = extension_of(name);
  const bool cad = extension == ".step" || extension == ".stp" || extension == ".brep";
  if (cad || is_mesh_file(name)) {
    const std::string leaf = cad ? extension == ".brep" ? "brep" : "step" : "mesh";
    value.fail("`cnrg` reads exact results, .json; write {" + leaf + ": {file: " + excerpt(name) + "}}");
  }
  if (std::find(kRoundedFiles.begin(), kRoundedFiles.end(), extension) != kRoundedFiles.end()) {
    value.fail("`cnrg` reads exact results, and `" + excerpt(name) +
               "` is none; write the result by `cnrg eval -o` as .json");
  }
  return ResultShape{path_in_folder(name, context), context.inside};
}

Shape read_hull(const Value& value, const LeafContext&) { return HullShape{{value.points("hull")}}; }

Shape read_minkowski(const Value& value, const LeafContext&) {
  HullShape shape{value.loops("minkowski")};
  if (shape.summands.size() < 2)
    value.fail_type("minkowski", "two or more lists of points [[[x, y, z], ...], ...]");
  return shape;
}

struct Reader {
  std::string_view name;
  Shape (*read)(const Value&, const LeafContext&);
};

constexpr std::array<Reader, 26> kReaders{{
    {"box", read_box},
    {"prism", read_prism},
    {"pyramid", read_pyramid},
    {"tetrahedron", read_tetrahedron},
    {"hull", read_hull},
    {"minkowski", read_minkowski},
    {"polygon", read_polygon},
    {"polyline", read_polyline},
    {"points", read_points},
    {"halfspace", read_halfspace},
    {"plane", read_plane},
    {"sphere", read_sphere},
    {"cylinder", read_cylinder},
    {"cone", read_cone},
    {"torus", read_torus},
    {"extrude", read_extrude},
    {"revolve", read_revolve},
    {"bezier", read_bezier},
    {"bspline", read_bspline},
    {"coons", read_coons},
    {"heightfield", read_heightfield},
    {"mesh", read_mesh_leaf},
    {"step", read_step},
    {"brep", read_brep},
    {"group", read_group},
    {"cnrg", read_result},
}};

}  // namespace

std::string path_in_folder(const std::string& path, const LeafContext& context) {
  return (std::filesystem::path(context.folder) / path).lexically_normal().string();
}

std::span<const std::string_view> leaf_names() {
  static const auto names = [] {
    std::array<std::string_view, kReaders.size()> result;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = kReaders[i].name;
    return result;
  }();
  return names;
}

Shape read_leaf(std::string_view name, const Value& value, const LeafContext& context) {
  for (const Reader& reader : kReaders) {
    if (reader.name == name) return reader.read(value, context);
  }
  throw InvariantError("read_leaf: no leaf is called " + std::string(name));
}

}  // namespace cnrg
