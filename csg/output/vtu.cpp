// VTK's unstructured grid in XML, for ParaView: vertices, polylines, triangles of the faces, and every region
// as the triangles of its boundary, normals outward. Cell data tells them apart:
//
//   dimension     0 to 3; threshold by it to see one kind
//   cell          number of the cell among those of its dimension, as in .json
//   component     of the result, from 1
//   region        dimension 3: the region's component; below: of the region behind, in front or around; or 0
//   region_front, region_back     faces only: on the two sides; 0 outside
//   regions_bounded               faces only: 0 dangling, 1 boundary, 2 wall between two regions; else -1
//   material      of the component, for entities of a group of that region: a row of MaterialNames; 0: none
//   source_leaf, source_face      the first leaf (a row of LeafNames) with a face that the cell came from, and
//                                 that face; of a cell from no face the first leaf and -1 (.json has all)
//
// Field data holds the names: RegionNames (by component; 0 is outside), MaterialNames, LeafNames. Arrays are
// base64 of little-endian numbers, doubles unrounded. Cells that bound the result without being part of it are not
// drawn: an open region has dimension 3 alone, its triangles are where it ends.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "csg/output/formats.h"
#include "csg/output/rounding.h"
#include "csg/output/solid.h"
#include "kernel/base/parallel.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;

void append_base64(std::string& text, const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t start = text.size(), groups = (bytes.size() + 2) / 3;
  text.resize(start + 4 * groups, '=');
  for_each_index(groups, [&](std::size_t g) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - 3 * g);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[3 * g + k]) : 0u);
    }
    for (std::size_t k = 0; k <= n; ++k) text[start + 4 * g + k] = kDigits[group >> (18 - 6 * k) & 63];
  });
}

template <class T>
std::string little_endian(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  if constexpr (std::endian::native == std::endian::big) {
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(T)) {
      std::reverse(bytes.data() + i, bytes.data() + i + sizeof(T));
    }
  }
  return bytes;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

class VtuWriter {
 public:
  explicit VtuWriter(const ResultView& view) : view_(view), flat_(flatten(view)) {
    require_off_frame(flat_, "VTU");
    points_ = round_points(view, flat_);
  }

  FileText run() {
    add_vertices();
    add_edges();
    add_faces();
    add_regions();
    return {file(), report_rounding(points_, drawing_)};
  }

 private:
  const ResultView& view_;
  FlatComplex flat_;
  RoundedPoints points_;
  Drawing drawing_;
  std::string text_;

  // One entry per cell of the grid.
  std::vector<std::int64_t> connectivity_, offsets_;
  std::vector<std::uint8_t> types_;
  std::vector<std::int32_t> dimension_, cell_, component_, region_, front_, back_, bounded_, material_;
  std::vector<std::int32_t> leaf_, face_;

  struct Attributes {
    std::int32_t dimension = 0, cell = 0, component = 0, region = 0, front = 0, back = 0, bounded = -1;
    std::int32_t leaf = -1, face = -1;
  };

  enum : std::uint8_t { kVertex = 1, kPolyline = 4, kTriangle = 5 };

  template <class Range>
  void add(std::uint8_t type, const Range& points, const Attributes& a) {
    connectivity_.insert(connectivity_.end(), std::begin(points), std::end(points));
    offsets_.push_back(std::int64_t(connectivity_.size()));
    types_.push_back(type);
    dimension_.push_back(a.dimension);
    cell_.push_back(a.cell);
    component_.push_back(a.component);
    region_.push_back(a.region);
    front_.push_back(a.front);
    back_.push_back(a.back);
    bounded_.push_back(a.bounded);
    const bool entity = view_.value->is_group() && a.dimension < 3;
    material_.push_back(material_of(entity ? a.region : a.component));
    leaf_.push_back(a.leaf);
    face_.push_back(a.face);
  }

  std::int32_t region_number(Index region) const {
    return flat_.active(region) ? std::int32_t(flat_.regions[region].component) : 0;
  }
  std::int32_t material_of(std::int32_t component) const {
    const std::string& name = attributes_of(view_, Component(component)).material;
    for (std::size_t i = 0; i < view_.materials.size(); ++i) {
      if (view_.materials[i].name == name) return std::int32_t(i + 1);
    }
    return 0;
  }
  static void set_source(Attributes& a, const FlatComplex::Provenance& origin) {
    if (!origin.leaves.empty()) a.leaf = std::int32_t(origin.leaves[0].value());
    if (a.dimension == 3) return;
    for (const LeafCell& cell : origin.cells) {
      if (cell.dimension != 2) continue;
      a.leaf = std::int32_t(cell.leaf.value());
      a.face = std::int32_t(cell.number);
      return;
    }
  }

  void add_vertices() {
    std::vector<char> drawn(flat_.points.size(), 0);
    for (const auto& f : flat_.faces) {
      for (const auto& t : f.triangles) for (const Index p : t) drawn[p] = 1;
    }
    for (const auto& e : flat_.edges) for (const Index p : e.points) drawn[p] = 1;
    for (std::size_t i = 0; i < flat_.vertices.size(); ++i) {
      const auto& v = flat_.vertices[i];
      if (v.component == 0) continue;
      Attributes a;
      a.cell = std::int32_t(i);
      a.component = std::int32_t(v.component);
      a.region = region_number(v.region);
      set_source(a, v.origin);
      add(kVertex, std::array{v.point}, a);
      if (!drawn[v.point]) drawing_.points.push_back(v.point);
    }
  }

  void add_edges() {
    for (std::size_t i = 0; i < flat_.edges.size(); ++i) {
      const auto& e = flat_.edges[i];
      if (e.component == 0) continue;
      Attributes a;
      a.dimension = 1;
      a.cell = std::int32_t(i);
      a.component = std::int32_t(e.component);
      a.region = region_number(e.region);
      set_source(a, e.origin);
      FlatComplex::Loop points = e.points;
      if (e.closed) points.push_back(points[0]);
      add(kPolyline, points, a);
      if (!e.wire) continue;
      for (std::size_t k = 1; k < points.size(); ++k) drawing_.segments.push_back({points[k - 1], points[k]});
    }
  }

  void add_faces() {
    for (std::size_t i = 0; i < flat_.faces.size(); ++i) {
      const auto& f = flat_.faces[i];
      drawing_.triangles.insert(drawing_.triangles.end(), f.triangles.begin(), f.triangles.end());
      if (f.component == 0) continue;
      Attributes a;
      a.dimension = 2;
      a.cell = std::int32_t(i);
      a.component = std::int32_t(f.component);
      a.front = region_number(f.regions[0]);
      a.back = region_number(f.regions[1]);
      a.region = a.back != 0 ? a.back : a.front;
      a.bounded = flat_.regions_bounded(f);
      set_source(a, f.origin);
      for (const auto& t : f.triangles) add(kTriangle, t, a);
    }
  }

  void add_regions() {
    for (std::size_t i = 0; i < flat_.regions.size(); ++i) {
      const auto& r = flat_.regions[i];
      if (r.component == 0) continue;
      Attributes a;
      a.dimension = 3;
      a.cell = std::int32_t(i);
      a.component = a.region = std::int32_t(r.component);
      set_source(a, r.origin);
      for (const auto& shell : r.shells) {
        for (const Index side : shell) {
          for (auto t : flat_.faces[side >> 1].triangles) {
            if ((side & 1) == 0) std::swap(t[1], t[2]);
            add(kTriangle, t, a);
          }
        }
      }
    }
  }

  template <class T>
  void array(const char* name, const char* type, const std::vector<T>& values, int components = 1) {
    text_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
             std::to_string(components) + "\" format=\"binary\">\n";
    const std::string bytes = little_endian(values);
    append_base64(text_, little_endian(std::vector<std::uint64_t>{bytes.size()}) + bytes);
    text_ += "\n</DataArray>\n";
  }

  /// Strings are lists of character codes, each ended by a zero.
  void names(const char* name, const std::vector<std::string>& values) {
    text_ += "<DataArray type=\"String\" Name=\"" + std::string(name) + "\" NumberOfTuples=\"" +
             std::to_string(values.size()) + "\" format=\"ascii\">\n";
    for (const std::string& value : values) {
      for (const char c : value) text_ += std::to_string(static_cast<unsigned char>(c)) + " ";
      text_ += "0\n";
    }
    text_ += "</DataArray>\n";
  }

  std::string file() {
    std::vector<std::string> regions{"outside"}, materials{"none"}, leaves;
    for (const RegionAttributes& a : view_.value->attributes()) regions.push_back(a.name);
    for (const auto& m : view_.materials) materials.push_back(m.name);
    if (view_.leaves != nullptr) for (const auto& leaf : *view_.leaves) leaves.push_back(leaf.name);
    std::vector<double> coordinates;
    for (const auto& p : points_.xyz) coordinates.insert(coordinates.end(), p.begin(), p.end());

    text_ = "<?xml version=\"1.0\"?>\n<!-- " + comment() + " -->\n"
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
    names("RegionNames", regions);
    names("MaterialNames", materials);
    names("LeafNames", leaves);
    text_ += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(points_.xyz.size()) +
             "\" NumberOfCells=\"" + std::to_string(types_.size()) + "\">\n<Points>\n";
    array("Points", "Float64", coordinates, 3);
    text_ += "</Points>\n<Cells>\n";
    array("connectivity", "Int64", connectivity_);
    array("offsets", "Int64", offsets_);
    array("types", "UInt8", types_);
    text_ += "</Cells>\n<CellData Scalars=\"region\">\n";
    array("dimension", "Int32", dimension_);
    array("cell", "Int32", cell_);
    array("component", "Int32", component_);
    array("region", "Int32", region_);
    array("region_front", "Int32", front_);
    array("region_back", "Int32", back_);
    array("regions_bounded", "Int32", bounded_);
    array("material", "Int32", material_);
    array("source_leaf", "Int32", leaf_);
    array("source_face", "Int32", face_);
    text_ += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return std::move(text_);
  }

  std::string comment() const {
    std::string name = escaped(view_.node);
    for (std::size_t at; (at = name.find("--")) != std::string::npos;) name.replace(at, 2, "- -");
    return "node " + name + ", written by cnrg";
  }
};

}  // namespace

FileText vtu_text(const ResultView& view) { return VtuWriter(view).run(); }

}  // namespace cnrg
