// How much leaves hold of places where pieces meet (relevance.h).
#pragma once

#include <map>
#include <memory>
#include <span>

#include "csg/certify/piece_parts.h"
#include "csg/certify/relevance.h"

namespace cnrg {

class PieceFilling {
 public:
  /// What is given must outlive this.
  PieceFilling(const Pieces& pieces, const std::vector<LeafInstance>& leaves) : pieces_(pieces), leaves_(leaves) {}
  /// Of what the parts have in common, which is in the box `common`, for all t: a part where a piece of the leaf
  /// may be there. Of a value read back, and of unknown surfaces, nothing is known.
  /// `beyond`: on one side of this sheet, a plane, alone.
  Filling of(LeafId leaf, std::span<const PiecePart> parts, const Interval3& common, Between between,
             std::uint32_t beyond = kNone, int on_side = 0);

 private:
  struct Space;
  const Space& space_of(LeafId leaf);
  const Pieces& pieces_;
  const std::vector<LeafInstance>& leaves_;
  std::map<LeafId, std::shared_ptr<const Space>> spaces_;
};

}  // namespace cnrg
