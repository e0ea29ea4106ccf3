// Numbers that stand in files and are nowhere else: of the leaves that a result names, and of patches.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "csg/result/flat.h"

namespace cnrg {

/// The leaves that a result names, numbered in their order, without gaps.
std::map<LeafId, std::size_t> leaf_numbers(const ResultView& view, const FlatComplex& flat);
/// The name of a leaf; empty if it has none.
std::string leaf_name(const ResultView& view, LeafId leaf);

/// The patch of each face, numbered as they come; a face of no one patch is a patch of its own.
std::vector<std::size_t> patch_numbers(const FlatComplex& flat);

}  // namespace cnrg
