// The words of section 3 of pereira2012 where a row decides about an edge or a vertex.
//
// The engine asks one question, "is it free?" (does it bound anything of the operand?). The paper has several
// terms instead, since its boundary of a face (section 2.3) leaves out what lies in the face's interior:
//   numFaceA     how many faces of A an edge bounds: those that lie on one side of it only
//   dangOrLoose  an edge in the interior of a removed face, which lies on both sides of it: a wire that hangs in
//                the face from its border, or from nothing
//   numEdgeA     how many edges of A end at a vertex
//   loose        a vertex in the interior of a removed face, where no edge of that face ends
// What bounds a kept cell stays, so that of the others "not free in A" says: numFaceA > 0 or dangOrLoose (of
// a vertex: numEdgeA > 0 or loose). tests/oracles/paper_reading.h has the proof, and where the
// terms taken by the letter remove more.
#pragma once

#include <string>

#include "csg/operators/tables.h"

namespace cnrg {

/// When a row removes, in the paper's terms beside ours: `not free in A: numFaceA > 0 or dangOrLoose`.
std::string condition_words(const TableRow& row);

}  // namespace cnrg
