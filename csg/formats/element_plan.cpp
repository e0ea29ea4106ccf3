#include "csg/formats/element_plan.h"

#include <algorithm>
#include <map>

#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Corners = std::array<Index, 3>;

/// Something is said of the wall that is not said of the region.
bool says_more(const Attributes& wall, const Attributes& region) {
  if (!wall.name.empty() && !wall.name.is_of_entities() && wall.name != region.name) return true;
  if (!wall.material.empty() && !(wall.material == region.material)) return true;
  return std::any_of(wall.properties.begin(), wall.properties.end(), [&](const auto& property) {
    const auto it = region.properties.find(property.first);
    return it == region.properties.end() || !(it->second == property.second);
  });
}

/// By entity of faces: its triangles are elements.
std::vector<char> find_shells(const Mesh& mesh) {
  static const Attributes kNothing;
  std::map<std::int32_t, const Attributes*> regions;  // by component
  for (const auto& region : mesh.entities[3])
    if (region.tags.dimension == 3) regions[region.tags.region] = region.tags.said;
  std::vector<char> shells;
  for (const auto& face : mesh.entities[2]) {
    const CellTags& tags = face.tags;
    const auto says_more_than = [&](std::int32_t component) {
      const auto it = regions.find(component);
      return it == regions.end() || says_more(*tags.said, it->second == nullptr ? kNothing : *it->second);
    };
    shells.push_back(!face.side &&
                     (mesh.tetrahedra.empty() || tags.bounded == 0 ||
                      (tags.said != nullptr && says_more_than(tags.front) && says_more_than(tags.back))));
  }
  return shells;
}

}  // namespace

ElementPlan::ElementPlan(const Mesh& mesh) : mesh_(mesh) {
  const std::vector<char> shells = find_shells(mesh);
  for (const auto& t : mesh.triangles) {
    if (shells[t.entity]) shells_.push_back(t);
  }
  for (const auto& s : mesh.segments) {
    if (mesh.entities[1][s.entity].wire) bars_.push_back(s);
  }
}

std::vector<std::vector<ElementPlan::Side>> ElementPlan::sides() const {
  static constexpr int kNumbers[]{3, 4, 2, 1};  // by the corner opposite
  std::vector<std::vector<Side>> result(mesh_.groups[2].size());
  std::map<Corners, std::pair<Index, Side>> found;  // by corners: the triangle, and the side at it
  for (Index i = 0; i < mesh_.triangles.size(); ++i) found[sorted(mesh_.triangles[i].points)] = {i, {0, 0}};
  for (std::size_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
    for (std::size_t k = 0; k < 4; ++k) {
      Corners side;
      for (std::size_t c = 0; c < 3; ++c) side[c] = mesh_.tetrahedra[t].points[kOutsides[k][c]];
      const auto it = found.find(sorted(side));
      if (it == found.end()) continue;
      // Seen from outside it runs as the triangle where the tetrahedron is behind that.
      const bool behind = is_odd(mesh_.triangles[it->second.first].points) == is_odd(side);
      if (behind || it->second.second.second == 0) it->second.second = {t, kNumbers[k]};
    }
  }
  std::vector<Side> at(mesh_.triangles.size(), {0, 0});
  for (const auto& [corners, entry] : found) at[entry.first] = entry.second;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i].second == 0) continue;
    for (const Index group : mesh_.entities[2][mesh_.triangles[i].entity].groups)
      result[group - 1].push_back(at[i]);
  }
  return result;
}

std::vector<std::vector<std::size_t>> group_nodes(const Mesh& mesh, std::size_t dimension) {
  std::vector<std::vector<std::size_t>> nodes(mesh.groups[dimension].size());
  mesh.for_each_kind([&](std::size_t, std::size_t of, const auto& simplices, const auto& edges) {
    for (std::size_t i = 0; of == dimension && i < simplices.size(); ++i) {
      for (const Index group : mesh.entities[dimension][simplices[i].entity].groups)
        mesh.for_each_node(simplices[i], edges, [&](Index p) { nodes[group - 1].push_back(p + 1); });
    }
  });
  for (auto& of : nodes) sort_unique(of);
  return nodes;
}

}  // namespace cnrg
