#include "bench/cases/triangle_mesh.h"

#include <cmath>
#include <stdexcept>

#include "csg/leaves/mesh_file.h"

namespace cnrg::bench {

TriangleMesh read_mesh(const std::string& path) {
  const MeshData file = cnrg::read_mesh(path, false);
  TriangleMesh mesh;
  for (std::size_t i = 0; i < file.point_count(); ++i)
    mesh.points.push_back({file.xyz[3 * i], file.xyz[3 * i + 1], file.xyz[3 * i + 2]});
  for (std::size_t f = 0; f < file.face_count(); ++f)
    for (std::size_t k = file.offsets[f] + 2; k < file.offsets[f + 1]; ++k)
      mesh.triangles.push_back({file.corners[file.offsets[f]], file.corners[k - 1], file.corners[k]});
  if (mesh.triangles.empty()) throw std::runtime_error(path + ": has no faces");
  return mesh;
}

TriangleMesh turned(const TriangleMesh& mesh, double angle, const std::array<double, 3>& move) {
  const double c = std::cos(angle), s = std::sin(angle);
  TriangleMesh result = mesh;
  for (auto& [x, y, z] : result.points) {
    const double u = c * x + s * z, v = c * z - s * x;
    x = u + move[0];
    y += move[1];
    z = v + move[2];
  }
  return result;
}

}  // namespace cnrg::bench
