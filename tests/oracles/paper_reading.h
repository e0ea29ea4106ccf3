// The tables in the paper's own terms (pereira2012 3), taken by the letter, beside the rows of
// csg/operators/tables.h.
//
// The rows keep "what bounds something kept" and ask of the rest whether it is free; both look at all that is
// around a cell. The paper's boundary of a face (2.3) leaves out what hangs or lies loose in the face's interior,
// and its terms follow that: numFaceA counts the faces that an edge is a boundary of, dangOrLoose and loose are
// what lies in the interior of a removed face. Here these are counted one by one, with classes by point location,
// and nothing of tables.h is used. Faces, edges and vertices are decided in this order, each against what is left
// of the dimension above; what is a boundary of something left, in the sense of 2.3, stays.
//
// The letter removes all that the rows remove, and more in two places only: (1) a cell in the interior of a kept
// face, when all that it bounded is gone; (2) in an intersection with A > B, a feature of B (a wire, a border of
// leaf faces, their ends) on a wall between two regions of B. Proof:
//
// What the rows remove, the letter removes. Let no kept face be around an edge; then it bounds none. If the row
// for equals removes it, it is not free in A: some face of A is around it, and is gone. Either the edge bounds
// that face (numFaceA > 0), or it lies in its interior (dangOrLoose). If the row for B in A of an intersection
// removes it, then one region of B is around it (insideB), or it is a mere cut of a wall: in the wall's interior
// (dangOrLoose) or between two pieces of it (numFaceB > 0). Vertices go likewise, with numEdgeA and loose; no edge
// that the letter keeps ends in one, since the rows keep all edges that the letter keeps.
//
// What the letter removes and the rows keep. Let the letter remove an edge. If a kept face is around it, the edge
// does not bound the face, so it lies in its interior: place 1. If none is, the rows' condition fails and the
// letter's holds. For equals both say the same then: something of A is around the edge, and is gone. So it is the
// intersection, and some face of B is around the edge. All these faces are gone, so each has regions of B on both
// sides (numRegB = 2, or 0 and insideB), and all around the edge are regions of B: more than one, or it were
// insideB; and it is no mere cut: place 2. A vertex lies likewise, or it is an end of such an edge.
#pragma once

#include <vector>

#include "csg/operators/group.h"
#include "csg/operators/tables.h"

namespace cnrg {

/// What the letter leaves, and how often a term alone decided.
struct PaperReading {
  std::vector<FaceId> faces;
  std::vector<EdgeId> edges;
  std::vector<VertexId> vertices;
  std::size_t dang_or_loose = 0;  ///< edges removed for nothing but that
  std::size_t loose = 0;          ///< vertices removed for nothing but that
};

PaperReading paper_reading(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                           const Group& right);

/// How many cells the letter removes more than the rows, by why they stay there.
struct ReadingDifference {
  std::size_t faces_kept_around = 0;  ///< they lie in the interior of a kept face
  std::size_t features_of_walls = 0;  ///< features of B in a removed wall between two of its regions
};

/// Compares what is left by both. Empty if the letter removes all that the rows remove and, more than that, only
/// cells of the two kinds above, whose points are all in the kept face or in regions of the result; else what is
/// wrong. `result` is that of the rows.
std::string compare_readings(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                             const Group& right, const Group& result, const PaperReading& letter,
                             ReadingDifference& difference);

}  // namespace cnrg
