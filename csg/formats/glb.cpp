// GLB: glTF 2.0 in one file, for viewers, web pages and presentation programs. A node with a mesh for each region,
// for the sheets, wires and points of each leaf; materials with the colours of pictures (csg/result/palette.h).
//
// glTF has 32-bit numbers for coordinates, and y upwards. In a model with coordinates of a survey (4e6 m) such
// numbers are half a metre apart. So positions are those of the model in a cube of about -1 to 1, and the root
// node puts them back: by its scale, a power of two, its translation, and a quarter turn that makes z the y of
// glTF. All meshes share the one root, so that what adjoins has the same numbers.
//
// A leaf that a tree places several times has its points made anew at each place, exactly, and Booleans cut each
// as they come: the result does not say what is a copy of what. But what is left uncut can be compared: meshes
// that an exact translation makes equal have their numbers in the file once, and of one material they are one mesh
// with several nodes. Turned and scaled copies are not recognized.
//
// Where two regions touch, both have the wall as a part of their skins, turned to each other; it has no mesh of
// its own, since it would hide in the same place.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "csg/formats/formats.h"
#include "csg/formats/glb_normals.h"
#include "csg/mesh/mesh.h"
#include "csg/result/palette.h"
#include "csg/result/solid.h"
#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "kernel/base/counts.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Json = nlohmann::ordered_json;
using Index = FlatComplex::Index;
using Floats = std::array<float, 3>;

// Numbers of glTF.
enum Mode { kPoints = 0, kLines = 1, kTriangles = 4 };
enum ComponentType { kFloat = 5126, kUnsigned = 5125 };
enum Target { kVertices = 34962, kIndices = 34963 };

Floats floats(const DoubleVector& a) { return {float(a[0]), float(a[1]), float(a[2])}; }
Floats negated(const Floats& a) { return {-a[0], -a[1], -a[2]}; }

/// Where a position of the file is in the model: offset + scale * position.
struct Frame {
  DoubleVector offset{0, 0, 0};
  double scale = 1;

  Frame() = default;
  explicit Frame(const std::vector<DoubleVector>& points) {
    if (points.empty()) return;
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                   [&](const auto& a, const auto& b) { return a[k] < b[k]; });
      offset[k] = (*low)[k] / 2 + (*high)[k] / 2;
      most = std::max(most, (*high)[k] / 2 - (*low)[k] / 2);
    }
    int exponent = 0;  // of the power of two that is greater
    std::frexp(most, &exponent);
    scale = most == 0 ? 1 : std::ldexp(1.0, std::clamp(exponent, -1000, 1023));
    // An offset of few digits: simple coordinates stay so, and positions are exact.
    const double step = scale / (1 << 20);
    for (double& x : offset) {
      if (std::abs(x / step) < 0x1p52) x = std::nearbyint(x / step) * step;
    }
  }
  DoubleVector position(const DoubleVector& p) const {
    return {(p[0] - offset[0]) / scale, (p[1] - offset[1]) / scale, (p[2] - offset[2]) / scale};
  }
};

/// A mesh as it is collected: corners of triangles, ends of segments, points, by points of the flattened result.
struct GlbShape {
  Mode mode = kTriangles;
  std::vector<Index> points;    ///< by vertex
  std::vector<Floats> normals;  ///< by vertex, of triangles
  std::vector<Index> indices;   ///< vertices
  std::string name;
  std::size_t material = 0;
  Json extras;
};

/// Collects the vertices of a shape, each pair of a point and a normal once.
class ShapeMaker {
 public:
  explicit ShapeMaker(Mode mode) { shape_.mode = mode; }
  void add_triangle(const std::array<Index, 3>& points, const std::array<Floats, 3>& normals) {
    for (std::size_t k = 0; k < 3; ++k) add(points[k], normals[k]);
  }
  void add_point(Index point) { add(point, {}); }
  GlbShape& shape() { return shape_; }

 private:
  GlbShape shape_;
  std::map<std::pair<Index, Floats>, Index> known_;

  void add(Index point, const Floats& normal) {
    const auto [entry, fresh] = known_.try_emplace({point, normal}, next_number(shape_.points.size(), "points"));
    if (fresh) {
      shape_.points.push_back(point);
      if (shape_.mode == kTriangles) shape_.normals.push_back(normal);
    }
    shape_.indices.push_back(entry->second);
  }
};

class GlbWriter {
 public:
  explicit GlbWriter(const ResultView& view)
      : view_(view), flat_(flatten(view)), groups_(mesh_groups(view, flat_)), colors_(view, flat_) {
    require_closed_and_bounded(flat_, "GLB");
    const std::vector<DoubleVector> points = round_points(view, flat_).xyz;
    frame_ = Frame(points);
    for (const DoubleVector& p : points) positions_.push_back(frame_.position(p));
  }

  FileText run() {
    collect_faces();
    collect_wires();
    collect_points();
    for (const GlbShape& shape : shapes_) add_node(shape);
    return {file(), {.notices = notices()}};
  }

 private:
  const ResultView& view_;
  FlatComplex flat_;
  MeshGroups groups_;
  CellColors colors_;
  Frame frame_;
  std::vector<DoubleVector> positions_;  // of the points, in the frame
  std::vector<GlbShape> shapes_;
  std::vector<Json> materials_, meshes_, nodes_, accessors_;
  std::map<std::tuple<std::string, std::string, bool, bool>, std::size_t> material_;
  enum View { kPositions, kCorners, kNormals };
  std::array<std::string, 3> binary_;  // by view of the buffer; kCorners are indices
  /// The numbers of a shape in the file, and its meshes by material.
  struct Written {
    const GlbShape* shape;
    Json attributes;
    std::size_t indices;
    std::map<std::size_t, std::size_t> meshes;
  };
  /// By what copies have in common. Shapes stay where they are.
  std::map<std::tuple<int, std::vector<Index>, std::vector<Floats>>, std::vector<Written>> written_;

  std::size_t material(const CellColor& color, bool both_sides, bool lit) {
    const std::string name = color.text.empty() ? "none" : shown(color.text);
    const auto [entry, fresh] =
        material_.try_emplace({name, hex(color.color), both_sides, lit}, materials_.size());
    if (!fresh) return entry->second;
    Json factor = Json::array();
    for (const double c : color.color) {  // sRGB to linear
      factor.push_back(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    factor.push_back(1);
    Json& made = materials_.emplace_back();
    made["name"] = name;
    made["pbrMetallicRoughness"] = {{"baseColorFactor", factor}, {"metallicFactor", 0}, {"roughnessFactor", 0.7}};
    if (both_sides) made["doubleSided"] = true;
    if (!lit) made["extensions"]["KHR_materials_unlit"] = Json::object();
    return entry->second;
  }

  /// The shape of a name, a kind and a material, which collects cells; in the order in which they come.
  class Makers {
   public:
    ShapeMaker& of(const std::string& name, Mode mode, std::size_t material) {
      const auto [entry, fresh] = number_.try_emplace({name, material}, all_.size());
      if (fresh) {
        GlbShape& shape = all_.emplace_back(mode).shape();
        shape.name = name;
        shape.material = material;
      }
      return all_[entry->second];
    }
    void give(std::vector<GlbShape>& shapes) {
      for (ShapeMaker& maker : all_) shapes.push_back(std::move(maker.shape()));
    }

   private:
    std::map<std::pair<std::string, std::size_t>, std::size_t> number_;
    std::vector<ShapeMaker> all_;
  };

  std::string group_name(int dimension, Index cell, const std::string& other) const {
    const auto& of = groups_.of[std::size_t(dimension)][cell];
    return of.empty() ? other : groups_.names[std::size_t(dimension)][of[0] - 1];
  }

  /// The skin of each region, then faces that bound none.
  void collect_faces() {
    CornerNormals corners(view_, flat_, positions_);
    std::vector<std::vector<std::array<Floats, 3>>> normals(flat_.faces.size());
    for (Index f = 0; f < flat_.faces.size(); ++f) {
      if (flat_.faces[f].component == 0) continue;
      for (const auto& n : corners.of(f)) normals[f].push_back({floats(n[0]), floats(n[1]), floats(n[2])});
    }
    const ColorBy by = default_colors(view_);
    const std::vector<std::string> names = region_labels(flat_, groups_);
    for (Index r = 0; r < flat_.regions.size(); ++r) {
      if (!flat_.active(r)) continue;
      ShapeMaker maker(kTriangles);
      for (const auto& shell : flat_.regions[r].shells) {
        for (const Index side : shell) add_side(maker, side, normals[side >> 1]);
      }
      GlbShape& shape = shapes_.emplace_back(std::move(maker.shape()));
      shape.name = names[r];
      shape.material = material(colors_.of(by, 3, r), false, true);
      const Component component = Component(flat_.regions[r].component);
      shape.extras = {{"region", r}, {"component", component}};
      const std::string& of = attributes_of(view_, component).material.name();
      if (!of.empty()) shape.extras["material"] = shown(of);
    }
    Makers sheets;
    for (Index f = 0; f < flat_.faces.size(); ++f) {
      const FlatComplex::Face& face = flat_.faces[f];
      if (face.component == 0 || !face.own || flat_.regions_bounded(face) != 0) continue;
      ShapeMaker& maker =
          sheets.of(group_name(2, f, "face"), kTriangles, material(colors_.of(by, 2, f), true, true));
      for (std::size_t t = 0; t < face.triangles.size(); ++t) maker.add_triangle(face.triangles[t], normals[f][t]);
    }
    sheets.give(shapes_);
  }

  /// A side of a face of a region's skin, with normals out of the region; a sheet inside of it is no skin.
  void add_side(ShapeMaker& maker, Index side, const std::vector<std::array<Floats, 3>>& normals) const {
    const FlatComplex::Face& face = flat_.faces[side >> 1];
    if (face.regions[0] == face.regions[1]) return;
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
      auto p = face.triangles[t];
      auto n = normals[t];
      if ((side & 1) == 0) {
        std::swap(p[1], p[2]);
        n = {negated(n[0]), negated(n[2]), negated(n[1])};
      }
      maker.add_triangle(p, n);
    }
  }

  /// Edges that bound no face, or lie in one.
  void collect_wires() {
    Makers wires;
    const ColorBy by = default_colors(view_);
    for (Index e = 0; e < flat_.edges.size(); ++e) {
      const FlatComplex::Edge& edge = flat_.edges[e];
      if (!edge.own || !(edge.wire || edge.slit)) continue;
      ShapeMaker& maker =
          wires.of(group_name(1, e, "edge in a face"), kLines, material(colors_.of(by, 1, e), false, false));
      for_each_segment(edge, [&](Index a, Index b) {
        maker.add_point(a);
        maker.add_point(b);
      });
    }
    wires.give(shapes_);
  }

  void collect_points() {
    Makers points;
    const ColorBy by = default_colors(view_);
    for (Index v = 0; v < flat_.vertices.size(); ++v) {
      const FlatComplex::Vertex& vertex = flat_.vertices[v];
      if (!vertex.own || !vertex.free) continue;
      points.of(group_name(0, v, "point"), kPoints, material(colors_.of(by, 0, v), false, false))
          .add_point(vertex.point);
    }
    points.give(shapes_);
  }

  /// The exact vector from the points of one shape to those of another; none if there is no one such.
  std::optional<RationalPoint> shift(const GlbShape& from, const GlbShape& to) const {
    const auto at = [&](Index p) { return view_.complex->points.rational(flat_.points[p]); };
    const RationalPoint by = at(to.points[0]) - at(from.points[0]);
    for (std::size_t i = 1; i < from.points.size(); ++i) {
      if (at(to.points[i]) - at(from.points[i]) != by) return std::nullopt;
    }
    return by;
  }

  void add_node(const GlbShape& shape) {
    Json node;
    node["name"] = shape.name;
    auto& candidates = written_[{shape.mode, shape.indices, shape.normals}];
    Written* written = nullptr;
    for (Written& other : candidates) {
      const auto by = shift(*other.shape, shape);
      if (!by.has_value()) continue;
      written = &other;
      const DoubleVector d = to_doubles(*by);
      node["translation"] = {d[0] / frame_.scale, d[1] / frame_.scale, d[2] / frame_.scale};
      break;
    }
    if (written == nullptr) written = &candidates.emplace_back(add_numbers(shape));
    const auto [mesh, fresh] = written->meshes.try_emplace(shape.material, meshes_.size());
    if (fresh) {
      Json& made = meshes_.emplace_back();
      made["name"] = shape.name;
      made["primitives"] = Json::array({{{"attributes", written->attributes},
                                         {"indices", written->indices},
                                         {"material", shape.material},
                                         {"mode", int(shape.mode)}}});
    }
    node["mesh"] = mesh->second;
    if (!shape.extras.is_null()) node["extras"] = shape.extras;
    nodes_.push_back(std::move(node));
  }

  /// For numbers that come next in the view.
  std::size_t add_accessor(View view, ComponentType number, std::size_t count, const char* type) {
    Json& made = accessors_.emplace_back();
    made["bufferView"] = int(view);
    made["byteOffset"] = binary_[view].size();
    made["componentType"] = int(number);
    made["count"] = count;
    made["type"] = type;
    return accessors_.size() - 1;
  }

  static void append_bits(std::string& bytes, std::uint32_t bits) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(bits >> (8 * k) & 0xff);
  }
  static void append_floats(std::string& bytes, const Floats& numbers) {
    for (const float x : numbers) append_bits(bytes, std::bit_cast<std::uint32_t>(x));
  }

  Written add_numbers(const GlbShape& shape) {
    Json attributes;
    Floats low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const Index p : shape.points) {
      const Floats at = floats(positions_[p]);
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
    }
    attributes["POSITION"] = add_accessor(kPositions, kFloat, shape.points.size(), "VEC3");
    accessors_.back()["min"] = low;
    accessors_.back()["max"] = high;
    for (const Index p : shape.points) append_floats(binary_[kPositions], floats(positions_[p]));
    if (shape.mode == kTriangles) {
      attributes["NORMAL"] = add_accessor(kNormals, kFloat, shape.normals.size(), "VEC3");
      for (const Floats& n : shape.normals) append_floats(binary_[kNormals], n);
    }
    const std::size_t indices = add_accessor(kCorners, kUnsigned, shape.indices.size(), "SCALAR");
    for (const Index i : shape.indices) append_bits(binary_[kCorners], i);
    return {&shape, attributes, indices, {}};
  }

  std::vector<std::string> notices() const {
    double most = 0;
    for (const GlbShape& shape : shapes_) {
      for (const Index p : shape.points) {
        const Floats at = floats(positions_[p]);
        for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(at[k] - positions_[p][k]));
      }
    }
    if (most == 0) return {};
    const std::string by = decimal(most * frame_.scale, "%.2g");
    return {"coordinates of this format have 32 bits: they are off by " + by + " at most"};
  }

  Json document(std::size_t binary) {
    Json root;
    root["name"] = shown(view_.node);
    // The turn makes (x, y, z) to (x, z, -y).
    root["translation"] = {frame_.offset[0], frame_.offset[2], 0.0 - frame_.offset[1]};
    root["rotation"] = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
    root["scale"] = {frame_.scale, frame_.scale, frame_.scale};
    for (std::size_t i = 0; i < nodes_.size(); ++i) root["children"].push_back(i + 1);
    nodes_.insert(nodes_.begin(), std::move(root));
    Json all;
    all["asset"] = {{"version", "2.0"}, {"generator", "cnrg"}};
    for (const GlbShape& shape : shapes_) {
      if (shape.mode != kTriangles) all["extensionsUsed"] = {"KHR_materials_unlit"};
    }
    all["scene"] = 0;
    all["scenes"] = Json::array({{{"name", shown(view_.node)}, {"nodes", {0}}}});
    all["nodes"] = nodes_;
    if (shapes_.empty()) return all;
    all["meshes"] = meshes_;
    all["materials"] = materials_;
    all["accessors"] = accessors_;
    std::size_t begin = 0;
    for (const View view : {kPositions, kCorners, kNormals}) {
      const std::size_t size = binary_[view].size();
      if (size == 0) break;  // no triangles, no normals
      Json part{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", size}};
      if (view != kCorners) part["byteStride"] = sizeof(Floats);
      part["target"] = int(view == kCorners ? kIndices : kVertices);
      all["bufferViews"].push_back(std::move(part));
      begin += size;
    }
    all["buffers"] = Json::array({{{"byteLength", binary}}});
    return all;
  }

  /// The header and two chunks: the document, padded by spaces to a multiple of 4, and the numbers.
  std::string file() {
    const std::size_t binary = binary_[0].size() + binary_[1].size() + binary_[2].size();
    std::string json = document(binary).dump();
    json.append((4 - json.size() % 4) % 4, ' ');
    const std::size_t size = 12 + 8 + json.size() + (binary == 0 ? 0 : 8 + binary);
    if (size > std::numeric_limits<std::uint32_t>::max()) {
      throw InputError("the file would be larger than the 4 GB that a GLB holds");
    }
    std::string bytes = "glTF";
    append_bits(bytes, 2);
    append_bits(bytes, std::uint32_t(size));
    append_bits(bytes, std::uint32_t(json.size()));
    bytes += "JSON" + json;
    if (binary == 0) return bytes;
    append_bits(bytes, std::uint32_t(binary));
    bytes += std::string("BIN\0", 4);
    for (const std::string& part : binary_) bytes += part;
    return bytes;
  }
};

}  // namespace

FileText glb_text(const ResultView& view) { return GlbWriter(view).run(); }

}  // namespace cnrg
