// The sums over the value of a fold, kept up to date from step to step.
//
// Rows say of each node how many cells its value has once it is simplified, how many regions, and which volume. To
// count that anew at each node of a chain ((a - b) - c) - ... would cost the square of its length. What one step
// changes is small: a cell is decided about by what lies around it (kernel/selection/merging.h), so only cells at
// those that came or went are decided again; a volume changes by that of the 3-cells that did. How many pieces
// coplanar faces and regions form is no local matter: changing_links.h counts these.
#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "csg/operators/entity_marks.h"
#include "csg/operators/group.h"
#include "csg/operators/held_regions.h"
#include "csg/operators/parts.h"
#include "kernel/selection/changing_links.h"
#include "kernel/selection/merging.h"

namespace cnrg {

class Tally {
 public:
  /// Of what is held now. References are kept. No cell has attributes of its own (origins.h), now or in later
  /// steps, and the complex has no frame.
  Tally(const Complex& complex, const OfEntities<EntityMarks>& marks, const LeafUnions& sets,
        const HeldRegions& regions, std::span<const Group* const> held);

  /// After a step: `changed` lists the entities and 3-cells that came or went, in any order; others may be among
  /// them. Adds the change of the sums to `out`.
  void update(const CellSet& changed, TotalsChange& out);
  /// False once a region has no bounds or a merged face would be one-sided; changes are not known then.
  bool known() const { return known_ && !face_links_.one_sided(); }

 private:
  using Fate = Merging::Fate;
  /// The leaves of entities.
  class Sources : public CellSources {
   public:
    Sources(const OfEntities<EntityMarks>& marks, const LeafUnions& sets) : marks_(marks), sets_(sets) {}
    void leaves_of(FaceId f, std::vector<LeafId>& out) const override { out = sets_[marks_.faces.origin.get(f)]; }
    void leaves_of(EdgeId e, std::vector<LeafId>& out) const override { out = sets_[marks_.edges.origin.get(e)]; }

   private:
    const OfEntities<EntityMarks>& marks_;
    const LeafUnions& sets_;
  };
  /// A link that one step adds or takes away, each as often as `times` says.
  template <class IdT>
  struct Link {
    IdT a, b;
    bool flip;
    int times;
    auto key() const { return std::tuple(a, b, flip); }
  };

  void load(std::span<const Group* const> held);
  void count(const CellSet& cells, int sign, TotalsChange& out);
  void count_closed_chains(std::span<const VertexId> vertices, int sign, TotalsChange& out) const;
  void link_faces(std::span<const EdgeId> edges, int sign, std::vector<Link<FaceId>>& links) const;
  void link_regions(std::span<const FaceId> faces, int sign, std::vector<Link<RegionId>>& links) const;
  void decide(const CellSet& cells);
  bool is_open(EdgeId e) const { return merging_.fate(e) == Fate::kept; }

  const Complex& complex_;
  const OfEntities<EntityMarks>& marks_;
  const HeldRegions& regions_;
  Sources sources_;
  Merging merging_;
  Marks<RegionId> inside_;  // 3-cells that were held before the step
  ChangingLinks<FaceId> face_links_;
  ChangingLinks<RegionId> region_links_;
  bool known_ = true;
};

}  // namespace cnrg
