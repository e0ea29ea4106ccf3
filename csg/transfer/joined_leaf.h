// A result at hand as a leaf: the same leaf as `prepare_result` makes of its file, without the file.
#pragma once

#include <memory>

#include "csg/leaves/leaf.h"
#include "csg/result/flat.h"

namespace cnrg {

/// `flat` is the flattened view, all of which must have bounds. Faces, edges, points and regions have its numbers,
/// regions as labels from 1, but for the unbounded one, which is 0. Cells know what made them
/// (CellTable::makers).
std::unique_ptr<PreparedLeaf> joined_leaf(const ResultView& view, const FlatComplex& flat);

}  // namespace cnrg
