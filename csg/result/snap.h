// A result on doubles: the complex that `--snap` writes (snap_drawing.h has the rounding).
//
// The drawing of the flattened result is snapped; the refinement that this ends with is the complex of the snapped
// result. Where rounding each vertex by itself leaves the drawing as it is, and each region, wire and point where
// it is, the result stays the exact one: its writers round it.
//
// What its cells are is told by those of the exact result that each stems from (relabel.h).
#pragma once

#include <memory>

#include "csg/result/relabel.h"

namespace cnrg {

class SnappedResult {
 public:
  /// `raw`: the view shows unsimplified cells. Throws InputError for a result with faces or lines that reach the
  /// frame of unbounded leaves, for one that does not become stable, and beyond the range of doubles; Stopped.
  SnappedResult(const ResultView& view, bool raw, const Watch& watch = {});

  /// The view with the snapped result in place of the exact one, all of its vertices doubles; the view itself
  /// where nothing had to be snapped. Components keep their numbers, those of which nothing is left too. It refers
  /// to this object.
  ResultView shown(ResultView view) const;
  const SnapReport& report() const { return report_; }
  /// Nothing when nothing had to be snapped.
  const std::shared_ptr<const Relabelled>& relabelled() const { return made_; }

 private:
  SnapReport report_;
  std::shared_ptr<const Relabelled> made_;
};

}  // namespace cnrg
