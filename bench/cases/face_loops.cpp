#include "bench/cases/face_loops.h"

#include <algorithm>
#include <unordered_map>

#include "kernel/exact/predicates.h"
#include "kernel/exact/triangulate.h"

namespace cnrg::bench {
namespace {

/// Cuts a walk at each point that it comes back to; what is no polygon is a slit.
void cut_walk(const PointLoop& walk, std::vector<PointLoop>& loops) {
  PointLoop path;
  std::unordered_map<std::uint32_t, std::size_t> place;  // of the points of the path
  for (const std::uint32_t p : walk) {
    const auto seen = place.find(p);
    if (seen != place.end()) {
      const auto first = path.begin() + std::ptrdiff_t(seen->second);
      if (path.end() - first > 2) loops.emplace_back(first, path.end());
      for (auto q = first; q != path.end(); ++q) place.erase(*q);
      path.erase(first, path.end());
    }
    place[p] = path.size();
    path.push_back(p);
  }
  if (path.size() > 2) loops.push_back(std::move(path));
}

/// Along the axis in which the face is largest.
Projection face_projection(const std::vector<RationalPoint>& points, const Model::Face& face) {
  RationalPoint area{0, 0, 0};
  for (const PointLoop& loop : face.loops) {
    const RationalPoint part = doubled_area(points, loop);
    for (std::size_t k = 0; k < 3; ++k) area[k] += part[k];
  }
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (abs(area[k]) > abs(area[axis])) axis = k;
  Projection axes{static_cast<std::uint8_t>((axis + 1) % 3), static_cast<std::uint8_t>((axis + 2) % 3)};
  if (area[axis] < 0) std::swap(axes.u, axes.v);
  return axes;
}

}  // namespace

RationalPoint doubled_area(const std::vector<RationalPoint>& points, const PointLoop& loop) {
  RationalPoint area{0, 0, 0};
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const RationalPoint &p = points[loop[i]], &q = points[loop[(i + 1) % loop.size()]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      area[k] += p[l] * q[m] - p[m] * q[l];
    }
  }
  return area;
}

std::vector<PointLoop> simple_loops(const std::vector<RationalPoint>& points,
                                    const std::vector<PointLoop>& walks) {
  std::vector<PointLoop> loops;
  for (const PointLoop& walk : walks) cut_walk(walk, loops);
  if (loops.size() < 2) return loops;
  std::vector<RationalPoint> areas;
  RationalPoint whole{0, 0, 0};
  for (const PointLoop& loop : loops) {
    areas.push_back(doubled_area(points, loop));
    for (std::size_t k = 0; k < 3; ++k) whole[k] += areas.back()[k];
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (dot(areas[i], whole) > 0) std::swap(loops[0], loops[i]);
  }
  return loops;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<RationalPoint>& points,
                                                       const Model::Face& face) {
  if (face.loops.size() == 1 && face.loops[0].size() == 3)
    return {{face.loops[0][0], face.loops[0][1], face.loops[0][2]}};
  PointTable table;
  std::vector<std::uint32_t> place;  // in `points`, of each point of the table
  std::unordered_map<std::uint32_t, VertexId> vertex;
  std::vector<std::vector<VertexId>> loops;
  for (const PointLoop& loop : face.loops) {
    loops.emplace_back();
    for (const std::uint32_t p : loop) {
      const auto [it, is_new] = vertex.try_emplace(p);
      if (is_new) {
        it->second = table.add(points[p]);
        place.push_back(p);
      }
      loops.back().push_back(it->second);
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& [a, b, c] : triangulate(table, face_projection(points, face), loops))
    triangles.push_back({place[a.index()], place[b.index()], place[c.index()]});
  return triangles;
}

void cut_holes(Model& model) {
  std::vector<Model::Face> faces;
  for (Model::Face& face : model.faces) {
    if (face.loops.size() == 1) {
      faces.push_back(std::move(face));
      continue;
    }
    for (const auto& [a, b, c] : triangles_of(model.points, face)) faces.push_back({{{a, b, c}}, face.solid});
  }
  model.faces = std::move(faces);
}

}  // namespace cnrg::bench
