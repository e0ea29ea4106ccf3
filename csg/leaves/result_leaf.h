// A result file (`.json`) as a leaf: `{cnrg: file.json}`.
#pragma once

#include <memory>

#include "csg/leaves/leaf.h"

namespace cnrg {

/// Reads a result that `cnrg eval -o file.json` wrote. The leaf has the same complex: faces by their loops (by
/// their facets where they are not flat) with the regions on both sides (Fill::sides), wires, isolated points
/// and features; patches and leaf faces keep their identity, regions their names and materials.
///
/// A leaf is a group: closed, and empty far away. A result that is not closed or that has a region, face or
/// line without bounds is refused: read the operands back and apply the operator (`complement`, `interior`,
/// ...) in the tree.
///
/// Throws LeafFileError `file:line:column: error: ...` where the file is no JSON and `file: error: /faces/3/loops:
/// ...` with the JSON path of any other fault, each with what to do; InputError if there is no such file,
/// FileError if it can not be read.
std::unique_ptr<PreparedLeaf> prepare_result(const ResultShape& shape);

}  // namespace cnrg
