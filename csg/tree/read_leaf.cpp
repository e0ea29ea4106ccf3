// One function per leaf, named in a table. What a shape means is checked by `prepare`; here only its form.
#include "csg/tree/read_leaf.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include "csg/curves/boundary_curves.h"
#include "csg/geometry/circle.h"
#include "csg/geometry/transform.h"
#include "csg/imports/mesh_file.h"
#include "csg/leaves/mesh_data.h"
#include "csg/text/escape.h"
#include "csg/text/file.h"
#include "csg/text/number.h"
#include "csg/tree/read_curved.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"

namespace cnrg {
void check_weld(const Fields& f) {
  Rational d = 1;
  f.read("weld", d);
  if (d <= 0)
    f.at("weld").fail(f.name("weld") +
                      " must be above 0: give the length below which things are meant to coincide");
}

namespace {

/// The points that the first key of a leaf has, where the leaf is a list of them.
std::vector<RationalPoint> points_alone(const Value& value, const char* leaf) {
  return value.points(leaf, form(leaf).keys[0].type->least);
}

Shape read_box(const Value& value, const LeafContext&) {
  BoxShape box;
  Fields(value, form("box")).read("min", box.min, "max", box.max);
  return box;
}

void read_fit(const Fields& f, std::optional<Rational>& fit) {
  f.read("fit", fit);
  if (fit && *fit <= 0) f.at("fit").fail(f.name("fit") + " must be a positive length");
}

Shape read_prism(const Value& value, const LeafContext&) {
  const Fields f(value, form("prism"));
  PrismShape prism;
  f.read("base", prism.base, "holes", prism.holes, "vector", prism.vector);
  read_fit(f, prism.fit);
  return prism;
}

Shape read_pyramid(const Value& value, const LeafContext&) {
  const Fields f(value, form("pyramid"));
  PyramidShape pyramid;
  f.read("base", pyramid.base, "apex", pyramid.apex);
  read_fit(f, pyramid.fit);
  return pyramid;
}

Shape read_tetrahedron(const Value& value, const LeafContext&) {
  const std::vector<RationalPoint> points = value.points("tetrahedron");
  if (points.size() != 4) value.fail_type("tetrahedron", "a list of four points");
  return TetrahedronShape{{points[0], points[1], points[2], points[3]}};
}

Shape read_polygon(const Value& value, const LeafContext&) {
  if (!value.is_map()) return PolygonShape{points_alone(value, "polygon"), {}};
  const Fields f(value, form("polygon"));
  PolygonShape polygon;
  f.read("outer", polygon.outer, "holes", polygon.holes);
  read_fit(f, polygon.fit);
  return polygon;
}

/// Strike is the azimuth of the horizontal line, from y to x; the plane goes down by `dip` to the right of it.
Shape read_disk(const Value& value, const LeafContext&) {
  const Fields f(value, form("disk"));
  DiskShape disk;
  f.read("center", disk.center, "segments", disk.segments);
  disk.radii = f.at("radii").pair(f.name("radii"));
  if (disk.radii[0] <= 0 || disk.radii[1] <= 0)
    f.at("radii").fail(f.name("radii") + ": each must be a positive length");
  if (f.has("normal")) {
    f.read("normal", disk.normal);
    disk.along = CircleFrame(is_zero(disk.normal) ? RationalPoint{0, 0, 1} : disk.normal).first();
    f.read("along", disk.along);
    return disk;
  }
  Rational dip, strike;
  f.read("dip", dip, "strike", strike);
  const Transform turn = Transform::rotation({0, 0, 1}, -strike, {0, 0, 0});
  disk.along = turn.apply_to_vector({0, 1, 0});
  disk.normal = (turn * Transform::rotation({0, 1, 0}, dip, {0, 0, 0})).apply_to_vector({0, 0, 1});
  return disk;
}

Shape read_polyline(const Value& value, const LeafContext&) {
  if (!value.is_map()) return PolylineShape{points_alone(value, "polyline")};
  PolylineShape polyline;
  Fields(value, form("polyline")).read("points", polyline.points, "closed", polyline.closed);
  return polyline;
}

Shape read_points(const Value& value, const LeafContext&) { return PointsShape{points_alone(value, "points")}; }

Shape read_plane(const Value& value, const LeafContext&) {
  PlaneShape plane;
  Fields(value, form("plane")).read("point", plane.point, "normal", plane.normal);
  return plane;
}

Shape read_halfspace(const Value& value, const LeafContext&) {
  HalfspaceShape halfspace;
  Fields(value, form("halfspace")).read("point", halfspace.point, "normal", halfspace.normal);
  return halfspace;
}

Shape read_sphere(const Value& value, const LeafContext&) {
  SphereShape s;
  Fields(value, form("sphere"))
      .read("center", s.center, "radius", s.radius, "segments", s.segments, "rings", s.rings);
  return s;
}

Shape read_cylinder(const Value& value, const LeafContext&) {
  CylinderShape c;
  Fields(value, form("cylinder")).read("from", c.from, "to", c.to, "radius", c.radius, "segments", c.segments);
  return c;
}

Shape read_cone(const Value& value, const LeafContext&) {
  ConeShape c;
  Fields(value, form("cone"))
      .read("from", c.from, "to", c.to, "radius", c.radius, "top", c.top, "segments", c.segments);
  return c;
}

Shape read_torus(const Value& value, const LeafContext&) {
  TorusShape t;
  Fields(value, form("torus"))
      .read("center", t.center, "axis", t.axis, "radius", t.radius, "tube", t.tube, "segments", t.segments,
            "rings", t.rings);
  return t;
}

Shape read_heightfield(const Value& value, const LeafContext& context) {
  const Fields f(value, form("heightfield"));
  HeightfieldShape shape;
  f.read("base", shape.base, "file", shape.file, "within", shape.within);
  if (shape.within && *shape.within <= 0) f.at("within").fail(f.name("within") + " must be a positive length");
  if (!shape.file.empty()) {
    shape.file = path_in_folder(shape.file, context);
    shape.inside = context.inside;
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
  f.each("heights", [&](const Value& row) {
    auto& heights = shape.heights.emplace_back();
    for (const Value& z : row.list("each row of " + what, "a list of numbers")) heights.push_back(z.number(what));
    if (heights.size() != shape.heights.front().size()) {
      row.fail("this row of `heights` has " + std::to_string(heights.size()) + " numbers and the first has " +
               std::to_string(shape.heights.front().size()) + "; all rows must be equally long");
    }
  });
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
  std::vector<RationalPoint> points;
  f.read("points", points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Rational& x : points[i]) data->xyz.push_back(to_double(x));
    if (!std::all_of(points[i].begin(), points[i].end(), is_double))
      data->exact.emplace_back(static_cast<std::uint32_t>(i), points[i]);
  }
  const std::string what = f.name("faces");
  f.each("faces", [&](const Value& face) {
    const std::vector<Value> corners = face.list("each of " + what, "a list of numbers of points [0, 1, 2]");
    if (corners.size() < 3) face.fail_type("each of " + what, "a list of three or more numbers of points");
    for (const Value& corner : corners)
      data->corners.push_back(read_vertex(corner, "a corner of a face", points.size(), "points"));
    data->end_face();
  });
  return data;
}

Shape read_mesh_leaf(const Value& value, const LeafContext& context) {
  const Fields f(value, form("mesh"));
  MeshShape shape;
  std::string coordinates;
  f.read("file", shape.file, "coordinates", coordinates, "weld", shape.weld);
  if (shape.file.empty()) {
    shape.data = read_mesh_data(f);
  } else {
    shape.file = path_in_folder(shape.file, context);
    shape.inside = context.inside;
  }
  if (f.has("fill")) shape.fill = read_fill(f);
  shape.decimal = coordinates == "decimal";
  check_weld(f);
  read_fit(f, shape.fit);
  return shape;
}

/// What STEP and BREP files have in common; `f` are the fields of either.
CadShape read_cad(const Fields& f, CadShape::Format format, const LeafContext& context) {
  CadShape shape;
  shape.format = format;
  f.read("file", shape.file, "seams", shape.seams, "weld", shape.weld);
  shape.file = path_in_folder(shape.file, context);
  shape.inside = context.inside;
  shape.tessellation = read_tessellation(f);
  if (f.has("fill")) shape.fill = read_fill(f);
  f.each("solids", [&](const Value& solid) { shape.solids.push_back(solid.text("each of " + f.name("solids"))); });
  if (f.has("solids") && shape.solids.empty())
    f.at("solids").fail(f.name("solids") + " is empty; name a solid, or leave it out for all");
  check_weld(f);
  return shape;
}

Shape read_step(const Value& value, const LeafContext& context) {
  const Fields f(value, form("step"));
  CadShape shape = read_cad(f, CadShape::Format::step, context);
  f.read("unit", shape.unit);
  return shape;
}

Shape read_brep(const Value& value, const LeafContext& context) {
  return read_cad(Fields(value, form("brep")), CadShape::Format::brep, context);
}

GroupShape::Face read_group_face(const Value& value, std::size_t vertex_count, bool filled) {
  const Fields f(value, form("face of a group"));
  GroupShape::Face face;
  face.line = value.at().line;
  face.column = value.at().column;
  f.each("loops", [&](const Value& loop) {
    auto& numbers = face.loops.emplace_back();
    for (const Value& v : loop.list("each loop of a face", "a list of vertex numbers [0, 1, 2]")) {
      numbers.push_back(read_vertex(v, "a vertex of a loop", vertex_count));
    }
    if (numbers.size() < 3) loop.fail("a loop needs three vertices or more; use `edges` for a wire");
  });
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
  const Fields f(value, form("group"));
  GroupShape shape;
  if (f.has("fill")) shape.fill = read_fill(f);
  f.read("vertices", shape.vertices);
  const std::size_t n = shape.vertices.size();
  f.each("faces",
         [&](const Value& face) { shape.faces.push_back(read_group_face(face, n, shape.fill.has_value())); });
  f.each("edges", [&](const Value& edge) {
    const std::vector<Value> ends = edge.list("each edge of group", "a pair of vertex numbers [0, 1]");
    if (ends.size() != 2) edge.fail_type("each edge of group", "a pair of vertex numbers [0, 1]");
    shape.edges.push_back(
        {read_vertex(ends[0], "an end of an edge", n), read_vertex(ends[1], "an end of an edge", n)});
  });
  f.each("points", [&](const Value& p) { shape.points.push_back(read_vertex(p, f.name("points"), n)); });
  if (const Value* regions = f.find("regions")) {
    for (const Value::Entry& e : regions->entries(f.name("regions"))) {
      const std::optional<Rational> number = read_number(e.key).value;
      if (!number || number->get_den() != 1 || *number < 1 || *number > 1'000'000'000) {
        value.document().fail(
            e.key_at, "a key of `regions` must be the number of a region, from 1, not `" + excerpt(e.key) + "`");
      }
      const Fields attributes(e.value, form("region of a group"));
      GroupShape::Region& region = shape.regions[to_machine<std::uint32_t>(number->get_num())];
      attributes.read("name", region.name, "material", region.material);
      if (attributes.has("material")) context.check_material(attributes.at("material"));
    }
  }
  return shape;
}

/// Files of results that hold doubles; any other name may be that of an exact one.
constexpr std::array<std::string_view, 14> kRoundedFiles{".msh",  ".msh2",   ".mesh", ".inp",  ".bdf",
                                                         ".h5m",  ".f3grid", ".med",  ".poly", ".smesh",
                                                         ".xdmf", ".glb",    ".3mf",  ".svg"};

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

Shape read_hull(const Value& value, const LeafContext&) { return HullShape{{points_alone(value, "hull")}}; }

Shape read_minkowski(const Value& value, const LeafContext&) {
  HullShape shape{value.loops("minkowski", form("minkowski").keys[0].type->least)};
  if (shape.summands.size() < 2)
    value.fail_type("minkowski", "two or more lists of points [[[x, y, z], ...], ...]");
  return shape;
}

struct Reader {
  std::string_view name;
  Shape (*read)(const Value&, const LeafContext&);
};

constexpr std::array<Reader, 29> kReaders{{
    {"box", read_box},
    {"prism", read_prism},
    {"pyramid", read_pyramid},
    {"tetrahedron", read_tetrahedron},
    {"hull", read_hull},
    {"minkowski", read_minkowski},
    {"polygon", read_polygon},
    {"disk", read_disk},
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
    {"sweep", read_sweep},
    {"loft", read_loft},
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
