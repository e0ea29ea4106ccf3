// The entities that a step of a fold removes, counted by row in cells of the refinement of its two operands.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "csg/operators/entity_marks.h"
#include "csg/operators/group.h"
#include "csg/operators/pair_refinement.h"

namespace cnrg {

class RemovedEntities {
 public:
  /// References are kept: `sets` has the origins of held.
  RemovedEntities(const Complex& complex, const EntityMarks<FaceId>& faces, const EntityMarks<EdgeId>& edges,
                  const EntityMarks<VertexId>& vertices, const LeafUnions& sets)
      : complex_(complex), faces_(faces), edges_(edges), vertices_(vertices), sets_(sets, held_.origins.sets) {}

  void add(FaceId f, std::size_t row) { removed_faces_.emplace_back(f, row); }
  void add(EdgeId e, std::size_t row) { removed_edges_.emplace_back(e, row); }
  void add(VertexId v, std::size_t row) { removed_vertices_.emplace_back(v, row); }

  /// Adds to the counts of rows what was added since the last time. Marks are those of held and next, with what is
  /// removed, which is open in them: with a cell all entities in its star went.
  void count(std::span<const Group* const> next, std::map<std::size_t, std::size_t>& rows);

 private:
  template <class IdT>
  using Rows = std::vector<std::pair<IdT, std::size_t>>;

  void take_held();
  void take_next(std::span<const Group* const> next);
  void take_features(std::uint8_t flag, Group& of) const;

  const Complex& complex_;
  const EntityMarks<FaceId>& faces_;
  const EntityMarks<EdgeId>& edges_;
  const EntityMarks<VertexId>& vertices_;
  Rows<FaceId> removed_faces_;
  Rows<EdgeId> removed_edges_;
  Rows<VertexId> removed_vertices_;
  Group held_, next_;  // what of them is removed; their sets of leaves stay from step to step
  LeafSetMap<LeafUnions, LeafSets> sets_;
  std::optional<PairRefinement> pair_;
};

}  // namespace cnrg
