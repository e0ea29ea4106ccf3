#include "bench/cases/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bench/cases/random.h"
#include "csg/imports/mesh_file.h"

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

TriangleMesh turned_about_middle(const TriangleMesh& mesh) {
  std::array<double, 3> middle{}, back{};
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(mesh.points.begin(), mesh.points.end(),
                                                 [k](const auto& p, const auto& q) { return p[k] < q[k]; });
    middle[k] = ((*low)[k] + (*high)[k]) / 2;
    back[k] = middle[k] + 0.02 * ((*high)[k] - (*low)[k]);
  }
  return turned(moved(mesh, {-middle[0], -middle[1], -middle[2]}), 0.7, back);
}

TriangleMesh turned_at_random(const TriangleMesh& mesh, unsigned seed, const std::array<double, 3>& move) {
  Random random(seed);
  double q[4], length = 0;  // a quaternion
  for (double& x : q) {
    x = random.real(-1, 1);
    length += x * x;
  }
  for (double& x : q) x /= std::sqrt(length);
  const auto [w, i, j, k] = q;
  const double m[3][3] = {{1 - 2 * (j * j + k * k), 2 * (i * j - k * w), 2 * (i * k + j * w)},
                          {2 * (i * j + k * w), 1 - 2 * (i * i + k * k), 2 * (j * k - i * w)},
                          {2 * (i * k - j * w), 2 * (j * k + i * w), 1 - 2 * (i * i + j * j)}};
  TriangleMesh result = mesh;
  for (auto& p : result.points) {
    const auto [x, y, z] = p;
    for (int a = 0; a < 3; ++a) p[a] = m[a][0] * x + m[a][1] * y + m[a][2] * z + move[a];
  }
  return result;
}

TriangleMesh moved(const TriangleMesh& mesh, const std::array<double, 3>& move) {
  TriangleMesh result = mesh;
  for (auto& p : result.points)
    for (int a = 0; a < 3; ++a) p[a] += move[a];
  return result;
}

TriangleMesh mirrored_z(const TriangleMesh& mesh) {
  TriangleMesh result = mesh;
  for (auto& p : result.points) p[2] = p[2] == 0 ? 0 : -p[2];
  for (auto& t : result.triangles) std::swap(t[1], t[2]);
  return result;
}

}  // namespace cnrg::bench
