// What is opposite is found by coordinates, which are equal to the last bit.
#include "csg/mesh/periodic.h"

#include <algorithm>
#include <map>

#include "csg/mesh/reach.h"
#include "csg/text/digits.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = DoubleVector;

/// The corners of a thing on a side, moved to the near one, ascending. Nothing else of its kind has the same.
using Outline = std::vector<Vector>;

[[noreturn]] void refuse(const Outline& corners, std::size_t axis, double at) {
  static constexpr const char* kWhat[] = {"", "a vertex", "a piece of an edge", "a face with a corner"};
  Vector place = corners[0];
  place[axis] = at;
  std::string text = std::string("--periodic: ") + kWhat[std::min<std::size_t>(corners.size(), 3)] + " at (";
  Line(text) << place;
  throw InputError(text + ") has none opposite along " + char('x' + axis) +
                   "; both sides have to be alike: let what crosses one cross the other, too, by a copy that is "
                   "moved as far");
}

}  // namespace

PeriodicSides::PeriodicSides(const PeriodicAxes& along, const std::vector<Vector>& points) : axes(along) {
  if (!any()) return;
  const Box box = Reach(points).box;
  near = box.lo, far = box.hi;
  for (std::size_t k = 0; k < 3; ++k) {
    if (axes[k] && near[k] == far[k])
      throw InputError("--periodic: the model has no extent along " + std::string(1, char('x' + k)));
  }
}

std::vector<Vector> PeriodicSides::aligned(std::vector<Vector> points) const {
  if (!any()) return points;
  const double doubt = 0x1p-40 * Reach(points).largest;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!axes[axis]) continue;
    const std::size_t k = (axis + 1) % 3;
    std::multimap<double, Index> opposite;
    for (Index p = 0; p < points.size(); ++p)
      if (points[p][axis] == near[axis]) opposite.emplace(points[p][k], p);
    for (Vector& p : points) {
      if (p[axis] != far[axis]) continue;
      double least = doubt;
      Vector to = p;
      for (auto it = opposite.lower_bound(p[k] - doubt); it != opposite.end() && it->first <= p[k] + doubt; ++it) {
        Vector place = points[it->second];
        place[axis] = far[axis];
        if (distance(place, p) <= least) least = distance(place, p), to = place;
      }
      p = to;
    }
  }
  return points;
}

Vector PeriodicSides::folded(Vector p, const PeriodicAxes& along) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (along[k]) p[k] = near[k];
  return p;
}

SizeAt PeriodicSides::least(const SizeAt& size) const {
  if (!size || !any()) return size;
  return [*this, size](Vector p) {
    double least = size(p);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!axes[k] || (p[k] != near[k] && p[k] != far[k])) continue;
      p[k] = p[k] == near[k] ? far[k] : near[k];
      least = std::min(least, size(p));
    }
    return least;
  };
}

std::vector<PeriodicFaces> matched_faces(const FlatComplex& flat, const std::vector<Vector>& xyz,
                                         const PeriodicSides& sides) {
  std::vector<PeriodicFaces> faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!sides.axes[axis]) continue;
    std::map<Outline, std::array<Index, 2>> found;  // near and far
    for (std::size_t side = 0; side < 2; ++side) {
      const auto lies = [&](Index p) { return xyz[p][axis] == (side == 0 ? sides.near : sides.far)[axis]; };
      const auto add = [&](const auto& points, Index of) {
        Outline corners;
        for (const Index p : points) {
          if (!lies(p)) return;
          corners.push_back(xyz[p]);
          corners.back()[axis] = sides.near[axis];
        }
        sort_unique(corners);
        found.try_emplace(corners, std::array{kNone, kNone}).first->second[side] = of;
      };
      for (Index v = 0; v < flat.vertices.size(); ++v) add(std::array{flat.vertices[v].point}, v);
      for (Index e = 0; e < flat.edges.size(); ++e)
        for_each_segment(flat.edges[e], [&](Index a, Index b) { add(std::array{a, b}, e); });
      for (Index f = 0; f < flat.faces.size(); ++f) {
        const auto& face = flat.faces[f];
        if (!std::ranges::all_of(face.triangles, [&](const auto& t) { return std::ranges::all_of(t, lies); }))
          continue;
        std::vector<Index> points(face.isolated.begin(), face.isolated.end());
        for (const auto& loop : face.loops) points.insert(points.end(), loop.begin(), loop.end());
        add(points, f);
      }
    }
    for (const auto& [corners, of] : found) {
      if (of[0] == kNone || of[1] == kNone) refuse(corners, axis, (of[0] == kNone ? sides.far : sides.near)[axis]);
      if (corners.size() > 2) faces.push_back({of[0], of[1], axis});
    }
  }
  return faces;
}

namespace {

/// What of a mesh is opposite to what.
class Repeats {
 public:
  explicit Repeats(const Mesh& mesh) : mesh_(mesh), sides_(mesh.periodic, mesh.points) {
    for (Index p = 0; p < mesh.points.size(); ++p) {
      const PeriodicAxes at_near = sides_.at(sides_.near, mesh.points, std::array{p});
      if (at_near != PeriodicAxes{}) near_.emplace(mesh.points[p], p);
    }
  }

  PeriodicAxes far_axes(const auto& points) const { return sides_.at(sides_.far, mesh_.points, points); }
  Index opposite(Index p, const PeriodicAxes& along) const {
    const auto it = near_.find(sides_.folded(mesh_.points[p], along));
    require(it != near_.end(), "periodic: a node on a side has none opposite");
    return it->second;
  }
  Vector shift(const PeriodicAxes& along) const {
    Vector by{};
    for (std::size_t k = 0; k < 3; ++k)
      if (along[k]) by[k] = sides_.far[k] - sides_.near[k];
    return by;
  }

  /// Of simplices of one dimension those at far sides, and the entities opposite.
  template <class Simplices, class Edges>
  void add_links(std::size_t dimension, const Simplices& simplices, const Edges& edges,
                 std::vector<PeriodicLink>& links) const {
    std::map<decltype(Simplices::value_type::points), Index> entities;  // of simplices at near sides, by corners
    for (const auto& s : simplices) {
      if (sides_.at(sides_.near, mesh_.points, s.points) != PeriodicAxes{})
        entities.emplace(sorted(s.points), s.entity);
    }
    std::map<Index, PeriodicLink> found;
    for (const auto& s : simplices) {
      const PeriodicAxes along = far_axes(s.points);
      if (along == PeriodicAxes{}) continue;
      auto corners = s.points;
      for (Index& p : corners) p = opposite(p, along);
      const auto at = entities.find(sorted(corners));
      require(at != entities.end(), "periodic: an element on a side has none opposite");
      PeriodicLink& link =
          found.try_emplace(s.entity, PeriodicLink{dimension, s.entity, at->second, shift(along), {}})
              .first->second;
      require(link.near == at->second, "periodic: a cell on a side is opposite to two");
      mesh_.for_each_node(s, edges, [&](Index p) { link.nodes.push_back({p, opposite(p, along)}); });
    }
    for (auto& [entity, link] : found) {
      sort_unique(link.nodes);
      links.push_back(std::move(link));
    }
  }

 private:
  const Mesh& mesh_;
  const PeriodicSides sides_;
  std::map<Vector, Index> near_;
};

}  // namespace

std::vector<PeriodicLink> periodic_links(const Mesh& mesh) {
  std::vector<PeriodicLink> links;
  if (mesh.periodic == PeriodicAxes{}) return links;
  const Repeats repeats(mesh);
  mesh.for_each_kind([&](std::size_t, std::size_t dimension, const auto& simplices, const auto& edges) {
    if (dimension < 3) repeats.add_links(dimension, simplices, edges, links);
  });
  return links;
}

std::vector<PeriodicNode> periodic_nodes(const Mesh& mesh) {
  std::vector<PeriodicNode> nodes;
  if (mesh.periodic == PeriodicAxes{}) return nodes;
  const Repeats repeats(mesh);
  for (Index p = 0; p < mesh.points.size(); ++p) {
    const PeriodicAxes along = repeats.far_axes(std::array{p});
    if (along != PeriodicAxes{}) nodes.push_back({p, repeats.opposite(p, along), along});
  }
  return nodes;
}

}  // namespace cnrg
