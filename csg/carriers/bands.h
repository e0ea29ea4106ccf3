// Faces on surfaces of revolution, each between two parallels and two meridians, of a leaf that is no surface of
// revolution as a whole.
//
// A part from a CAD file has a bore here and a fillet there, each about an axis of its own, and planes between.
// Its facets come from a mesher that knows no other leaf. But where the border of every curved face is made of
// parallels (circles about its axis) and meridians (lines or arcs in half-planes through it), such a face is a
// rectangle of half-planes and parallels, as a leaf of revolution is; it takes part in the families of those, and
// the leaf is drawn anew from the rectangles: edges get the points of the faces beside them, planes those of their
// edges. Only the leaf knows its edges, so it draws itself.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csg/curves/revolved.h"
#include "csg/leaves/leaf.h"

namespace cnrg {

struct Band {
  std::uint32_t face = 0;
  RevolvedForm form;         ///< one line of one piece; the whole surface around
  RationalPoint start, end;  ///< directions (unit vectors, nearly): the face is counter-clockwise between them
  bool whole = true;         ///< it goes all around; `start` is a line of it only if it is one of the marks
  std::vector<RationalPoint> marks;          ///< directions of its corners, and of those of faces beside it
  std::vector<std::uint32_t> solids, edges;  ///< ascending: who has the face, and its border
};

/// The points of a band: rows from the beginning of its piece to the end, in each the points from `start` to
/// `end`, of a whole turn the first one again at the end.
struct BandGrid {
  std::vector<std::vector<RationalPoint>> rows;
  std::vector<std::size_t> marks;  ///< columns of the band's marks
  bool mirrored = false;           ///< quadrilaterals that are not planar have the other diagonal
};

class BandedForm : public CurvedForm {
 public:
  std::vector<Band> bands;
  /// Why the leaf cannot be drawn by its bands; empty: it can. `bands` are then more than it has, perhaps.
  std::string obstacle;
  /// How far `bands` may lie from where the leaf has its faces, beyond what doubles round.
  double slack = 0;

  struct Drawn {
    std::unique_ptr<PreparedLeaf> leaf;  ///< null: `obstacle` says why not
    std::string obstacle;
    bool finer = false;  ///< there is none for finer grids, perhaps
  };
  /// The leaf anew, a grid for each band, in its own space; corners may go as far as `slack_of_bands` to be there.
  virtual Drawn draw(const std::vector<BandGrid>& grids, double slack_of_bands) const = 0;
};

}  // namespace cnrg
