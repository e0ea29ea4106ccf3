#include "bench/peers/triangles.h"

#include <unordered_map>

#include "bench/peers/face_loops.h"
#include "bench/peers/system.h"
#include "kernel/base/error.h"
#include "kernel/exact/predicates.h"
#include "kernel/exact/triangulate.h"

namespace cnrg::bench {
namespace {

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

TriangleMesh rounded_triangles(const Model& model) {
  if (!model.solid()) throw Refusal("input", "an operand is no solid");
  TriangleMesh mesh;
  for (const auto& [x, y, z] : model.points) mesh.points.push_back({to_double(x), to_double(y), to_double(z)});
  try {
    for (const Model::Face& face : model.faces) {
      const auto triangles = triangles_of(model.points, face);
      mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    }
  } catch (const InvariantError&) {
    throw Refusal("input", "a face of an operand crosses or touches itself");
  }
  return mesh;
}

}  // namespace cnrg::bench
