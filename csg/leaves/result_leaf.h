// A result file (`.json`) as a leaf: `{cnrg: file.json}`.
#pragma once

#include <memory>

#include "csg/leaves/leaf.h"

namespace cnrg {

/// Reads a result that `cnrg eval -o file.json` wrote, of a group or of components: open, closed or neither, of
/// any dimension. The leaf has the same complex and (PreparedLeaf::cells) the same value: components with their
/// names, materials and dominance, and features. Its soup has the faces by their loops (by their facets where they
/// are not flat) with the regions on both sides (Fill::sides), the edges that bound no face as wires, and isolated
/// points, active or not. Faces, edges and regions are numbered as in the file (regions from 1); patches are kept.
///
/// A region may be unbounded; a face or line without bounds is refused: read the operands back and apply the
/// operator in the tree, or cut the node with a box before it is written.
///
/// Throws LeafFileError `file:line:column: error: ...` where the file is no JSON and `file: error: /faces/3/loops:
/// ...` with the JSON path of any other fault, each with what to do; InputError if there is no such file,
/// FileError if it can not be read.
std::unique_ptr<PreparedLeaf> prepare_result(const ResultShape& shape);

}  // namespace cnrg
