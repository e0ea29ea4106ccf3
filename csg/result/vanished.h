// What of a result vanishes when its points are moved, and how that is told.
//
// Snapping (snap.h) and joining (join.h) may leave nothing of a region that is thinner than the moves. No region
// vanishes unsaid: what is told of it is made here, for both, and its component is gone from the result.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "csg/result/flat.h"
#include "csg/result/result.h"

namespace cnrg {

/// Regions that have vanished, by component.
class LostRegions {
 public:
  using Index = FlatComplex::Index;
  /// Region `r` of `flat`, which `view` flattens to, has vanished. `numbered`: people know the numbers of `flat`.
  void add(const ResultView& view, const FlatComplex& flat, Index r, bool numbered);
  /// A line for each component: `dust, r2, at (1, 2, 3)`, its name, or else its leaves, and a point of it; where
  /// several pieces are gone, `dust (all 2 pieces), r2, at (1, 2, 3)`; where it is one of `left` all the same,
  /// `rock (a piece), ...` or `rock (3 pieces), ...`. Number and point are those of the piece that went first.
  std::vector<std::string> lines(const std::set<Component>& left) const;

 private:
  struct Lost {
    std::string name, place;
    std::size_t pieces = 0;
  };
  std::map<Component, Lost> lost_;
};

/// The components with regions.
std::set<Component> components_with_regions(const FlatComplex& flat);

/// `; 4 faces vanished; 1 wire vanished; 1 region vanished`, without those that are none.
std::string vanished_text(std::size_t faces, std::size_t wires, std::size_t regions);
/// What nobody may miss, for each line of LostRegions: `the region dust, r2, at (0, 0, 1), is thinner than 0.001
/// and has vanished`.
std::vector<std::string> vanished_warnings(const std::vector<std::string>& lines, const std::string& distance);

/// What nobody may miss, for each component of which what is left is in more pieces than before: `the region rock
/// is in 3 pieces now and was in one, the smallest at (1, 2, 3)`. `left`: regions of `before` that have not
/// vanished. `view` flattens to `after`.
std::vector<std::string> parted_warnings(const FlatComplex& before, const std::vector<FlatComplex::Index>& left,
                                         const ResultView& view, const FlatComplex& after);

/// A result that has been moved (Relabelled) as any other: without components of which nothing is left, since
/// files list no others; these keep their order. Of a group a group, in which a region that has been parted is
/// two, one after the other; its cells are simplified as those of an operator's value are, so a file that is read
/// back has the same.
std::shared_ptr<const Result::Data> settled(Result::Data data);

}  // namespace cnrg
