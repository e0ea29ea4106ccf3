// The removed entities of each operand become a group of their own, and are counted in the refinement of the two
// operands alone.
#include "csg/operators/removed_entities.h"

#include <algorithm>

namespace cnrg {
namespace {

void clear_entities(Group& group) {
  group.faces.clear(), group.edges.clear(), group.vertices.clear();
  group.origins.faces.clear(), group.origins.edges.clear(), group.origins.vertices.clear();
  group.features.edges.clear(), group.features.vertices.clear();
}

template <class List>
void sort(List& list) {
  if (!std::is_sorted(list.begin(), list.end())) std::sort(list.begin(), list.end());
}

template <class IdT>
void take_flagged(const EntityMarks<IdT>& marks, std::uint8_t flag, const std::vector<IdT>& cells,
                  std::vector<IdT>& out) {
  for (const IdT cell : cells) {
    if (marks.has(cell, flag)) out.push_back(cell);
  }
}

}  // namespace

void RemovedEntities::count(std::span<const Group* const> next, std::map<std::size_t, std::size_t>& rows) {
  if (removed_faces_.empty() && removed_edges_.empty() && removed_vertices_.empty()) return;
  if (!pair_) pair_.emplace(complex_);
  take_held(), take_next(next);
  pair_->refine(held_, next_);
  const auto count = [&](auto& removed) {
    for (const auto& [cell, row] : removed) {
      if (pair_->is_first(cell)) ++rows[row];
    }
    removed.clear();
  };
  count(removed_faces_), count(removed_edges_), count(removed_vertices_);
}

void RemovedEntities::take_held() {
  clear_entities(held_);
  const auto take = [&](const auto& removed, const auto& marks, auto& cells, auto& origins) {
    for (const auto& [cell, row] : removed) {
      if (marks.has(cell, kHeld)) cells.push_back(cell);
    }
    sort(cells);
    for (const auto cell : cells) origins.push_back(sets_(marks.origin.get(cell)));
  };
  take(removed_faces_, faces_, held_.faces, held_.origins.faces);
  take(removed_edges_, edges_, held_.edges, held_.origins.edges);
  take(removed_vertices_, vertices_, held_.vertices, held_.origins.vertices);
  take_features(kHeldFeature, held_);
}

void RemovedEntities::take_next(std::span<const Group* const> next) {
  clear_entities(next_);
  std::vector<std::pair<FaceId, LeafSetId>> faces;
  std::vector<std::pair<EdgeId, LeafSetId>> edges;
  std::vector<std::pair<VertexId, LeafSetId>> vertices;
  for (const Group* part : next) {
    LeafSetMap sets(part->origins.sets, next_.origins.sets);
    const auto take = [&](const auto& marks, const auto& cells, const auto& origins, auto& out) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (marks.has(cells[i], kRemoved)) out.emplace_back(cells[i], sets(origins[i]));
      }
    };
    take(faces_, part->faces, part->origins.faces, faces);
    take(edges_, part->edges, part->origins.edges, edges);
    take(vertices_, part->vertices, part->origins.vertices, vertices);
  }
  const auto put = [](auto& taken, auto& cells, auto& origins) {
    sort(taken);
    for (const auto& [cell, origin] : taken) cells.push_back(cell), origins.push_back(origin);
  };
  put(faces, next_.faces, next_.origins.faces);
  put(edges, next_.edges, next_.origins.edges);
  put(vertices, next_.vertices, next_.origins.vertices);
  take_features(kNextFeature, next_);
}

void RemovedEntities::take_features(std::uint8_t flag, Group& of) const {
  take_flagged(edges_, flag, of.edges, of.features.edges);
  take_flagged(vertices_, flag, of.vertices, of.features.vertices);
}

}  // namespace cnrg
