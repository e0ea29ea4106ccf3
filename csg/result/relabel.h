// A drawing of the cells of a result, moved and refined, as a result again.
//
// Snapping (snap.h) and joining (join.h) move points of the flattened result; the triangles, pieces of edges and
// points that are drawn with them are refined exactly, and so form a complex whatever moved. What its cells mean
// is told by the cells of the result that each stems from:
//   * A 3-cell is the region that the sides of its faces name. Where faces have crossed, sides may contradict each
//     other (the cavity is no thicker than the displacement): then the region with the largest area of sides has
//     it. Location in the result would be no better a judge: near a wall every point lies closer to it than the
//     displacement. Where faces have fallen together their regions cancel out but for the first and the last.
//   * A face whose sides are in one region, though it parted two, has lost one of them to the move; it vanishes,
//     and with it edges and vertices that nothing else has. Dangling faces, wires and points stay.
//   * Of several cells on one, the first active component has it.
//   * Components keep their numbers, names and materials; cells know the leaf faces, patches and leaves that they
//     came from. Edges and vertices of the result stay edges and vertices, and a face stays one face: what was
//     flat is a face of several facets now, unless it still is flat.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "csg/result/flat.h"
#include "csg/result/flat_drawing.h"
#include "csg/result/result.h"
#include "kernel/base/progress.h"

namespace cnrg {

/// What is left of a result, and what is not: numbers in the flattened result of regions that were active, faces,
/// and edges that were wires, ascending.
struct Relabelled {
  std::shared_ptr<const Complex> complex;
  NodeValue value;
  SimplifiedComplex simplified;
  std::vector<LeafParts> region_parts;  ///< as in ResultView
  bool of_group = false;                ///< as in ResultView
  SnapReport report;
  std::vector<FlatComplex::Index> lost_regions, lost_faces, lost_wires;

  /// The view with this in place of what it showed; it refers to this.
  ResultView shown(ResultView view) const;
};

/// `drawing` is that of the cells of `flat`, which `view` flattens to. `raw`: the view shows unsimplified cells.
/// Nothing if moving has changed nothing but digits, every region, wire and point staying where it is
/// (MovedDrawing::plain, too): then the result itself will do. Throws Stopped, as the watch asks.
std::optional<Relabelled> relabel(const ResultView& view, const FlatComplex& flat, MovedDrawing drawing, bool raw,
                                  const Watch& watch = {});

/// A result with this in place of what it knew.
Result::Data relabelled(Result::Data data, const std::shared_ptr<const Relabelled>& made);

/// The cells of components of a complex that `relabel` made: facets of one face are one. `features` stay.
SimplifiedComplex simplify_relabelled(const Complex& complex, const Components& components,
                                      const Features& features, SimplifyMode mode);

}  // namespace cnrg
