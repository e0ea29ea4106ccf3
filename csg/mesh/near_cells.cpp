#include "csg/mesh/near_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "csg/mesh/size_field.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = DoubleVector;

/// The lowest that a simplex is in.
template <class Entries, class Points>
auto found(const Entries& entries, const Points& points)
    -> std::optional<typename Entries::value_type::second_type> {
  const auto at = std::ranges::lower_bound(entries, points, {}, [](const auto& entry) { return entry.first; });
  if (at == entries.end() || at->first != points) return {};
  return at->second;
}

/// Between two segments whose nearest points are inside of both; infinity elsewhere, where an end is nearest.
double between_lines(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Vector u = minus(b, a), v = minus(d, c), w = minus(c, a), n = cross(u, v);
  const double square = dot(n, n);
  if (!(square > 0)) return HUGE_VAL;
  const double s = dot(cross(w, v), n) / square, t = dot(cross(w, u), n) / square;
  return s > 0 && s < 1 && t > 0 && t < 1 ? std::fabs(dot(w, n)) / std::sqrt(square) : HUGE_VAL;
}

}  // namespace

NearCells::NearCells(const Mesh& mesh) : mesh_(mesh), cell_of_point_(mesh.points.size()) {
  const auto take = [&](const auto& simplices, int dimension) {
    for (const auto& s : simplices) {
      for (const Index p : s.points) {
        cell_of_point_[p] = {dimension, s.entity};
        closures_.emplace_back(MeshCell{dimension, s.entity}, p);
      }
    }
  };
  take(mesh.triangles, 2), take(mesh.segments, 1), take(mesh.vertices, 0);
  sort_unique(closures_);
  for (const auto& t : mesh.triangles) faces_.emplace_back(sorted(t.points), t.entity);
  std::sort(faces_.begin(), faces_.end());
  for (const auto& s : mesh.segments) edges_.emplace_back(sorted(s.points), MeshCell{1, s.entity});
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      edges_.emplace_back(sorted(std::array{t.points[k], t.points[(k + 1) % 3]}), MeshCell{2, t.entity});
  }
  sort_unique(edges_);
}

Index NearCells::point_of(MeshCell cell) const {
  return std::lower_bound(closures_.begin(), closures_.end(), std::pair(cell, Index{0}))->second;
}

std::optional<Index> NearCells::face(const Mesh::Simplex<4>& t, std::size_t opposite) const {
  return found(faces_, sorted(std::array{t.points[(opposite + 1) % 4], t.points[(opposite + 2) % 4],
                                         t.points[(opposite + 3) % 4]}));
}

bool NearCells::touch(MeshCell a, MeshCell b) const {
  const auto [known, fresh] = touching_.try_emplace(std::minmax(a, b), false);
  if (!fresh) return known->second;
  const auto points_of = [&](MeshCell cell) {
    const auto begin = std::lower_bound(closures_.begin(), closures_.end(), std::pair(cell, Index{0}));
    const auto end = std::upper_bound(begin, closures_.end(), std::pair(cell, std::numeric_limits<Index>::max()));
    return std::span(begin, end);
  };
  std::span few = points_of(a), many = points_of(b);
  if (few.size() > many.size()) std::swap(few, many);
  return known->second = std::any_of(few.begin(), few.end(), [&](const auto& point) {
           return std::binary_search(many.begin(), many.end(), std::pair(many.front().first, point.second));
         });
}

/// Of a place to a cell; infinity if it is `most` or more.
double NearCells::distance(const Vector& p, MeshCell cell, double most) const {
  const std::size_t triangles = mesh_.triangles.size();
  const auto corners_of = [&](std::size_t item) {
    std::array<Vector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = mesh_.points[item < triangles ? mesh_.triangles[item].points[k]
                                                 : mesh_.segments[item - triangles].points[k == 0 ? 0 : 1]];
    return corners;
  };
  if (cell.dimension == 0) {
    const double far = cnrg::distance(mesh_.points[point_of(cell)], p);
    return far < most ? far : HUGE_VAL;
  }
  if (tree_ == nullptr) {
    std::vector<Box> boxes(triangles + mesh_.segments.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (const Vector& x : corners_of(i)) boxes[i].extend(x, x);
    tree_ = std::make_unique<BoxTree>(std::move(boxes));
  }
  double least = most;
  const auto is_near = [&](const Box& box) {
    for (std::size_t k = 0; k < 3; ++k)
      if (box.lo[k] > p[k] + least || box.hi[k] < p[k] - least) return false;
    return true;
  };
  tree_->query(is_near, [&](std::uint32_t item) {
    const bool is_face = item < triangles;
    const Index entity = is_face ? mesh_.triangles[item].entity : mesh_.segments[item - triangles].entity;
    if (cell != MeshCell{is_face ? 2 : 1, entity}) return;
    least = std::min(least, std::sqrt(squared_distance(p, corners_of(item))));
  });
  return least < most ? least : HUGE_VAL;
}

std::optional<NearCells::Gap> NearCells::narrowest(const Mesh::Simplex<4>& t, double most) const {
  constexpr double kSame = 1 - 1e-6;  // of widths that rounding alone may tell apart: the first one stays
  std::optional<Gap> out;
  const auto width = [&] { return out ? out->width * kSame : most; };
  const auto are_apart = [&](MeshCell a, MeshCell b) {
    return a.dimension < 3 && b.dimension < 3 && a != b && !touch(a, b);
  };
  const auto offer = [&](MeshCell a, MeshCell b, double far) {
    if (far < width()) out = Gap{std::min(a, b), std::max(a, b), far};
  };
  std::array<Vector, 4> p;
  std::array<MeshCell, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) p[k] = mesh_.points[t.points[k]], corners[k] = cell_of_point_[t.points[k]];
  std::array<std::optional<MeshCell>, 6> edges;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [i, j] = kEdges[e];
    edges[e] = found(edges_, sorted(std::array{t.points[i], t.points[j]}));
  }
  for (const auto& [i, j] : kEdges) {
    if (!are_apart(corners[i], corners[j])) continue;
    offer(corners[i], corners[j], distance(p[i], corners[j], width()));
    offer(corners[i], corners[j], distance(p[j], corners[i], width()));
  }
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t e = 0; e < 6; ++e)
      if (edges[e] && are_apart(corners[k], *edges[e]))
        offer(corners[k], *edges[e], distance(p[k], *edges[e], width()));
    if (const auto f = face(t, k); f && are_apart(corners[k], {2, *f}))
      offer(corners[k], {2, *f}, distance(p[k], {2, *f}, width()));
  }
  for (std::size_t e = 0; e < 3; ++e) {  // the opposite one of an edge is as far from the end
    const auto& [i, j] = kEdges[e];
    const auto& [k, l] = kEdges[5 - e];
    if (edges[e] && edges[5 - e] && are_apart(*edges[e], *edges[5 - e]))
      offer(*edges[e], *edges[5 - e], between_lines(p[i], p[j], p[k], p[l]));
  }
  return out;
}

}  // namespace cnrg
