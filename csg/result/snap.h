// A result on doubles: the complex that `--snap` writes (snap_drawing.h has the rounding).
//
// The drawing of the flattened result is snapped; the refinement that this ends with is the complex of the snapped
// result. Where rounding each vertex by itself leaves the drawing as it is, and each region, wire and point where
// it is, the result stays the exact one: its writers round it.
//
// Every cell is told what it is by the cells of the exact result that it stems from:
//   * A 3-cell is the region that the sides of its faces name. Where faces have crossed, sides may contradict each
//     other (the cavity is no thicker than the displacement): then the region with the largest area of sides has
//     it. Location in the exact result would be no better a judge: near a wall every point lies closer to it than
//     the displacement. Where faces have fallen together their regions cancel out but for the first and the last.
//   * A face whose sides are in one region, though it parted two, has lost one of them to the rounding; it
//     vanishes, and with it edges and vertices that nothing else has. Dangling faces, wires and points stay.
//   * Of several exact cells on one snapped cell, the first active component has it.
//   * Components keep their numbers, names and materials; cells know the leaf faces, patches and leaves that they
//     came from. Edges and vertices of the result stay edges and vertices, and a face stays one face: what was
//     flat is a face of several facets now, unless it still is flat.
#pragma once

#include <memory>
#include <string>

#include "csg/result/result_view.h"

namespace cnrg {

class SnappedResult {
 public:
  /// `raw`: the view shows unsimplified cells. Throws InputError for a result with faces or lines that reach the
  /// frame of unbounded leaves, for one that does not become stable, and beyond the range of doubles.
  SnappedResult(const ResultView& view, bool raw);
  ~SnappedResult();
  SnappedResult(SnappedResult&&) noexcept;

  /// The view with the snapped result in place of the exact one, all of its vertices doubles; the view itself
  /// where nothing had to be snapped. It refers to this object.
  ResultView shown(ResultView view) const;
  const SnapReport& report() const { return report_; }

 private:
  struct Data;
  SnapReport report_;
  std::unique_ptr<Data> data_;  // nothing when nothing had to be snapped
};

}  // namespace cnrg
