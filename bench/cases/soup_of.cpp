#include "bench/cases/soup_of.h"

#include <algorithm>
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

void add_faces(Soup& soup, LeafId leaf, const Model& model, const std::vector<PointId>& ids, bool solid) {
  std::vector<std::vector<PointId>> loops;
  for (std::uint32_t f = 0; f < model.faces.size(); ++f) {
    const Model::Face& face = model.faces[f];
    if (face.solid != solid) continue;
    loops.clear();
    for (const auto& loop : face.loops) {
      loops.emplace_back();
      for (const std::uint32_t p : loop) loops.back().push_back(ids[p]);
    }
    soup.add_face(leaf, loops, f, f);
  }
}

}  // namespace

Soup soup_of(const Case& c) {
  Soup soup;
  for (const TriangleMesh& mesh : c.leaves) add_leaf(soup, mesh);
  return soup;
}

std::vector<LeafId> add_model(Soup& soup, const Model& model) {
  std::vector<PointId> ids;
  ids.reserve(model.points.size());
  for (const RationalPoint& p : model.points) ids.push_back(soup.add_point(p));
  const bool all_solid = model.solid();
  const bool some_solid =
      std::any_of(model.faces.begin(), model.faces.end(), [](const auto& f) { return f.solid; });
  std::vector<LeafId> leaves;
  if (some_solid || all_solid) {
    leaves.push_back(soup.add_leaf(Fill::winding));
    add_faces(soup, leaves.back(), model, ids, true);
  }
  if (all_solid) return leaves;
  const LeafId loose = soup.add_leaf(Fill::none);
  leaves.push_back(loose);
  add_faces(soup, loose, model, ids, false);
  for (std::uint32_t i = 0; i < model.wires.size(); ++i)
    soup.add_wire(loose, ids[model.wires[i][0]], ids[model.wires[i][1]], i);
  for (const std::uint32_t p : model.isolated) soup.add_isolated(loose, ids[p]);
  return leaves;
}

}  // namespace cnrg::bench
