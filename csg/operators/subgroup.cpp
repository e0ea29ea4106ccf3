// Marks on the cells of the complex, then one pass over the lists of the group.
#include "csg/operators/subgroup.h"

namespace cnrg {

Group WantedEntities::of(const Group& g) const {
  Group out;
  LeafSetMap map(g.origins.sets, out.origins.sets);
  const auto pick = [&](const auto& from, const auto& from_origins, const auto& marks, auto& to, auto& origins) {
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (!marks[from[k]]) continue;
      to.push_back(from[k]);
      origins.push_back(map(from_origins[k]));
    }
  };
  pick(g.edges, g.origins.edges, wanted_.edges, out.edges, out.origins.edges);
  pick(g.vertices, g.origins.vertices, wanted_.vertices, out.vertices, out.origins.vertices);
  pick(g.faces, g.origins.faces, wanted_.faces, out.faces, out.origins.faces);
  const auto still = [](const auto& from, const auto& marks, auto& to) {
    for (const auto id : from) {
      if (marks[id]) to.push_back(id);
    }
  };
  still(g.features.edges, wanted_.edges, out.features.edges);
  still(g.features.vertices, wanted_.vertices, out.features.vertices);
  out.dominance = g.dominance;
  return out;
}

}  // namespace cnrg
