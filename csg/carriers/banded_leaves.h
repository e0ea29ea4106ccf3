// Which leaves with bands are drawn anew, and the drawing of them.
//
// What is one face already in a file needs no common lines, so a band that touches a neighbour of its own solid is
// no reason to draw its leaf anew; but once there is a reason, all bands of the leaf go with it.
#pragma once

#include <map>
#include <set>

#include "csg/carriers/axes.h"
#include "csg/carriers/bands.h"
#include "kernel/base/leaf_words.h"

namespace cnrg {

class BandedLeaves {
 public:
  /// A member of a family, a band or anything else, where the family is.
  struct Side {
    std::uint32_t instance = 0;
    const Band* band = nullptr;  ///< null: no band
    const PlacedForm& placed;
    Sector sector;
  };

  /// `notices`: of leaves that stay as they are.
  explicit BandedLeaves(std::vector<LeafWords>& notices) : notices_(notices) {}

  void add(std::uint32_t instance, std::shared_ptr<const BandedForm> form);
  const std::vector<Band>& bands(std::uint32_t instance) const { return forms_.at(instance)->bands; }

  /// Of two members, one of them a band, that touch as far as their meridians go: true if they are in one family.
  bool join(const Side& a, const Side& b);
  /// There is a reason to draw the leaf anew.
  bool is_anew(std::uint32_t instance) const { return anew_.contains(instance); }

  void set_grid(std::uint32_t instance, std::size_t band, BandGrid grid);
  /// Replaces leaves whose grids are set; gives those for which they are too coarse.
  std::set<std::uint32_t> draw(std::vector<LeafInstance>& instances) const;

 private:
  void tell(const Side& side, const Side& other);

  std::vector<LeafWords>& notices_;
  std::map<std::uint32_t, std::shared_ptr<const BandedForm>> forms_;
  std::set<std::uint32_t> anew_, told_;
  std::map<std::uint32_t, std::vector<BandGrid>> grids_;
};

}  // namespace cnrg
