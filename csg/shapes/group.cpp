// The general leaf: regions, faces, wires and points given one by one.
//
// Checked here is what a face, a wire or a number can be blamed for alone. Whether the sides of all faces agree
// in every cavity shows only when the group is refined.
#include <algorithm>
#include <map>

#include "csg/geometry/mesh_boundary.h"
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

constexpr std::uint32_t kMostRegions = 1000000;

class GroupReader {
 public:
  explicit GroupReader(const GroupShape& shape) : shape_(shape), fill_(shape.fill.value_or(Fill::sides)) {}

  std::unique_ptr<PreparedLeaf> prepare() {
    if (shape_.faces.empty() && shape_.edges.empty() && shape_.points.empty()) {
      throw InputError("group: it has no faces, edges or points: give at least one");
    }
    leaf_ = soup_.add_leaf(fill_);
    for (const RationalPoint& p : shape_.vertices) soup_.add_point(p);
    for (std::size_t f = 0; f < shape_.faces.size(); ++f) {
      try {
        add_face(f);
      } catch (const InputError& error) {
        throw LeafFaceError(f, error.what());
      }
    }
    add_wires();
    for (std::size_t i = 0; i < shape_.points.size(); ++i) {
      soup_.add_isolated(leaf_, vertex(shape_.points[i], "points: entry " + std::to_string(i)));
    }
    if (fill_ == Fill::winding || fill_ == Fill::parity) check_closed();
    return std::make_unique<GeometryLeaf>(std::move(soup_), regions());
  }

 private:
  std::string face_name(std::size_t f) const {
    const GroupShape::Face& face = shape_.faces[f];
    std::string name = "face " + std::to_string(f);
    if (face.line > 0)
      name += " (line " + std::to_string(face.line) + ", column " + std::to_string(face.column) + ")";
    return name;
  }

  PointId vertex(std::uint32_t index, const std::string& where) const {
    if (index < shape_.vertices.size()) return PointId(index);
    throw InputError("group: " + where + " has the vertex " + std::to_string(index) + ", but there are " +
                     std::to_string(shape_.vertices.size()) + " vertices, numbered from 0: correct the number");
  }

  void check_region(std::uint32_t region, const std::string& where) const {
    if (region <= kMostRegions) return;
    throw InputError("group: " + where + " has the region number " + std::to_string(region) +
                     ": number regions from 1, at most " + std::to_string(kMostRegions));
  }

  void add_face(std::size_t f) {
    const GroupShape::Face& face = shape_.faces[f];
    if (face.loops.empty()) throw InputError("group: " + face_name(f) + " has no loops: give the outer one");
    std::vector<std::vector<PointId>> ids;
    std::vector<std::vector<RationalPoint>> loops;
    for (const auto& loop : face.loops) {
      ids.emplace_back();
      loops.emplace_back();
      for (std::uint32_t v : loop) {
        ids.back().push_back(vertex(v, face_name(f)));
        loops.back().push_back(shape_.vertices[v]);
      }
    }
    const auto point_name = [&](std::size_t l, std::size_t i) {
      return "vertex " + std::to_string(face.loops[l][i]);
    };
    try {
      check_polygon(loops, {face_name(f), point_name});
    } catch (const InputError& error) {
      throw InputError("group: " + std::string(error.what()));
    }
    const bool sides = fill_ == Fill::sides;
    for (std::uint32_t region : face.sides) check_region(region, face_name(f));
    const std::uint32_t number = static_cast<std::uint32_t>(f);
    soup_.add_face(leaf_, ids, number, number, sides ? face.sides[0] : 0, sides ? face.sides[1] : 0);
  }

  void add_wires() {
    for (std::size_t i = 0; i < shape_.edges.size(); ++i) {
      const std::string name = "edge " + std::to_string(i);
      const auto [a, b] = shape_.edges[i];
      const PointId p = vertex(a, name), q = vertex(b, name);
      if (shape_.vertices[a] == shape_.vertices[b]) {
        throw InputError("group: " + name + " has equal ends, " + describe(shape_.vertices[a]) +
                         ": leave it out, or give the vertex in `points`");
      }
      soup_.add_wire(leaf_, p, q, static_cast<std::uint32_t>(i));
    }
  }

  void check_closed() const {
    std::map<RationalPoint, std::uint32_t> first;
    std::vector<std::uint32_t> number;
    for (std::size_t v = 0; v < shape_.vertices.size(); ++v) {
      number.push_back(first.try_emplace(shape_.vertices[v], static_cast<std::uint32_t>(v)).first->second);
    }
    std::vector<PolygonSide> sides;
    for (std::size_t f = 0; f < shape_.faces.size(); ++f) {
      const auto& loops = shape_.faces[f].loops;
      // Holes may run either way in the file; in the chain they run against the outer loop.
      RationalPoint outer{0, 0, 0};
      for (std::size_t l = 0; l < loops.size(); ++l) {
        std::vector<RationalPoint> points;
        for (std::uint32_t v : loops[l]) points.push_back(shape_.vertices[v]);
        const RationalPoint area = area_vector(points);
        if (l == 0) outer = area;
        const bool reverse = l > 0 && dot(area, outer) > 0;
        for (std::size_t i = 0; i < loops[l].size(); ++i) {
          const std::uint32_t p = number[loops[l][i]], q = number[loops[l][(i + 1) % loops[l].size()]];
          sides.push_back({std::min(p, q), std::max(p, q), static_cast<std::uint32_t>(f), (p < q) != reverse});
        }
      }
    }
    const SideTable table(sides, shape_.vertices.size());
    const bool parity = fill_ == Fill::parity;
    const std::vector<ChainEdge> chain = boundary(table, parity);
    const auto value = [&](std::uint32_t v) { return shape_.vertices[v]; };
    ChainEdge example{};
    if (vanishes(chain, parity, value, &example)) return;
    const bool only_oriented = !parity && vanishes(boundary(table, true), true, value);
    throw InputError("group: fill is " + std::string(parity ? "parity" : "winding") + ", but the faces are " +
                     (only_oriented ? "not oriented alike along " : "not closed along ") +
                     std::to_string(chain.size()) + (chain.size() == 1 ? " edge" : " edges") +
                     ", such as vertex " + std::to_string(example.from) + " " + describe(value(example.from)) +
                     " to vertex " + std::to_string(example.to) + " " + describe(value(example.to)) + ": " +
                     (only_oriented ? "turn faces round, or give `fill: parity` or `fill: cells`"
                                    : "add faces, or give `fill: cells` or `fill: none`"));
  }

  std::vector<Attributes> regions() const {
    if (fill_ == Fill::none) return {};
    std::uint32_t count = fill_ == Fill::winding || fill_ == Fill::parity ? 1 : 0;
    for (const auto& [number, region] : shape_.regions) {
      check_region(number, "regions");
      if (number == 0)
        throw InputError("group: regions has the number 0, which means none: number regions from 1");
      count = std::max(count, number);
    }
    if (fill_ == Fill::sides) {
      for (const GroupShape::Face& face : shape_.faces) count = std::max({count, face.sides[0], face.sides[1]});
    }
    std::vector<Attributes> result(count);
    for (const auto& [number, region] : shape_.regions) result[number - 1] = {region.name, region.material};
    return result;
  }

  const GroupShape& shape_;
  Fill fill_;
  Soup soup_;
  LeafId leaf_;
};

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const GroupShape& shape) { return GroupReader(shape).prepare(); }

}  // namespace cnrg
