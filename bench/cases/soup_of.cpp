#include "bench/cases/soup_of.h"

#include <array>

namespace cnrg::bench {
namespace {

void add_leaf(Soup& soup, const TriangleMesh& mesh) {
  const LeafId leaf = soup.add_leaf(Fill::winding);
  std::vector<PointId> ids;
  ids.reserve(mesh.points.size());
  for (const auto& p : mesh.points) ids.push_back(soup.add_point(p[0], p[1], p[2]));
  for (std::uint32_t i = 0; i < mesh.polygons.size(); ++i) {
    std::vector<PointId> loop;
    for (const std::uint32_t p : mesh.polygons[i]) loop.push_back(ids[p]);
    soup.add_face(leaf, std::array{loop}, i, i);
  }
  if (!mesh.polygons.empty()) return;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const std::uint32_t face = mesh.faces.empty() ? static_cast<std::uint32_t>(i) : mesh.faces[i];
    soup.add_triangle(leaf, ids[a], ids[b], ids[c], face, face);
  }
}

}  // namespace

Soup soup_of(const Case& c) {
  Soup soup;
  for (const TriangleMesh& mesh : c.leaves) add_leaf(soup, mesh);
  return soup;
}

}  // namespace cnrg::bench
