// From groups to components and back.
//
// Entities of a group are the cells that are not in the interior of one component: if a face is one, some cell of
// its star has another component (or none), and that cell is in the star of the face's edges and vertices too.
// So the entities of a closed value are closed under boundary, and every wall between different components is one.
#include "csg/operators/components.h"

#include <algorithm>

#include "csg/operators/component_lists.h"
#include "csg/operators/detect_regions.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

// The origins of a group's entities, and those of the cells inside of its regions.
template <class IdT>
void add_origins(const std::vector<std::pair<IdT, Component>>& list, Component entities,
                 const std::vector<LeafSetId>& of_entities, const std::vector<LeafSetId>& of_regions,
                 std::vector<LeafSetId>& out) {
  out.reserve(list.size());
  std::size_t k = 0;
  for (const auto& entry : list) {
    out.push_back(entry.second == entities ? of_entities[k++] : of_regions[entry.second - 1]);
  }
}

class Entities {
 public:
  Entities(const Complex& complex, const Components& x, Group& out) : complex_(complex), x_(x), out_(out) {}

  // A cell is inside of a component when all 3-cells around are of it and so are the cells between them.
  void run() {
    for_each_entity([&](auto&... of) { find(of...); }, x_.selection, x_.origins, out_, out_.origins);
  }

 private:
  template <class IdT>
  void find(const std::vector<std::pair<IdT, Component>>& list, const std::vector<LeafSetId>& origins,
            std::vector<IdT>& cells, std::vector<LeafSetId>& cell_origins) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (inside(list[k].first, list[k].second)) continue;
      cells.push_back(list[k].first);
      cell_origins.push_back(origins[k]);
    }
  }
  template <class IdT>
  bool inside(IdT cell, Component c) {
    const auto all = [&](const auto& cells) {
      return std::ranges::all_of(cells,
                                 [&](auto of) { return component_in(list_for(x_.selection, of), of) == c; });
    };
    complex_.star_regions(cell, regions_);
    if (!all(regions_)) return false;
    if constexpr (std::is_same_v<IdT, FaceId>) return true;
    else complex_.star_faces(cell, faces_);
    if constexpr (std::is_same_v<IdT, VertexId>) {
      if (!all(complex_.vertex_edges[cell])) return false;
    }
    return all(faces_);
  }

  const Complex& complex_;
  const Components& x_;
  Group& out_;
  std::vector<FaceId> faces_;
  std::vector<RegionId> regions_;
};

}  // namespace

Components components_of(const Complex& complex, const Group& group) {
  Components out;
  out.selection = selection_of(complex, group);
  out.features = group.features;
  for (const RegionAttributes& region : group.regions) out.attributes.push_back({region, group.dominance});
  const auto entities = static_cast<Component>(group.regions.size() + 1);
  if (group.has_entities()) {
    out.attributes.push_back({{{.name = Name::of_entities()}, {}}, group.dominance});
    std::vector<char> used(group.origins.sets.size(), 0);
    for (const auto* origins : {&group.origins.vertices, &group.origins.edges, &group.origins.faces}) {
      for (const LeafSetId set : *origins) used[set.index()] = 1;
    }
    std::vector<LeafId>& leaves = out.attributes.back().leaves;
    for (std::size_t s = 0; s < used.size(); ++s) {
      const auto set = group.origins.sets[LeafSetId(s)];
      if (used[s]) leaves.insert(leaves.end(), set.begin(), set.end());
    }
    sort_unique(leaves);
  }
  out.origins.sets = group.origins.sets;
  std::vector<LeafSetId> of_regions;
  for (const RegionAttributes& region : group.regions) {
    of_regions.push_back(out.origins.sets.intern(region.leaves));
  }
  const Selection& s = out.selection;
  add_origins(s.vertices, entities, group.origins.vertices, of_regions, out.origins.vertices);
  add_origins(s.edges, entities, group.origins.edges, of_regions, out.origins.edges);
  add_origins(s.faces, entities, group.origins.faces, of_regions, out.origins.faces);
  add_origins(s.regions, entities, {}, of_regions, out.origins.regions);
  return out;
}

CellSet missing_boundary(const Complex& complex, const Components& components) {
  const CellSet have = support(components.selection);
  return subtract(closure(complex, have), have);
}

Group group_of(const Complex& complex, const Components& x) {
  require(missing_boundary(complex, x).empty(), "group_of: the components are not closed");
  Group out;
  out.origins.sets = x.origins.sets;
  Entities(complex, x, out).run();
  std::vector<RegionId> inside;
  for (const auto& [cell, component] : x.selection.regions) inside.push_back(cell);
  out.cells = detect_regions(complex, inside, out.faces);
  for (std::size_t i = 0; i < out.cells.size(); ++i) {
    if (out.cells[i].second <= out.regions.size()) continue;
    out.regions.push_back(x.attributes[x.selection.regions[i].second - 1]);
  }
  for (RegionAttributes& region : out.regions) region.leaves.clear();
  for (std::size_t i = 0; i < out.cells.size(); ++i) {
    std::vector<LeafId>& leaves = out.regions[out.cells[i].second - 1].leaves;
    const auto set = x.origins.sets[x.origins.regions[i]];
    leaves.insert(leaves.end(), set.begin(), set.end());
  }
  for (RegionAttributes& region : out.regions) sort_unique(region.leaves);
  out.features = among_entities(out, x.features);
  out.dominance = largest_dominance(x);
  return out;
}

}  // namespace cnrg
