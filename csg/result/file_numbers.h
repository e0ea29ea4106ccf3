// Numbers that stand in files and are nowhere else: of the leaves that a result names, and of patches.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "csg/result/flat.h"

namespace cnrg {

/// The leaves that a result names, numbered by their places, without gaps; those leaves by their numbers; and the
/// numbers of some, ascending.
std::map<LeafId, std::size_t> leaf_numbers(const ResultView& view, const FlatComplex& flat);
std::vector<LeafId> in_order(const std::map<LeafId, std::size_t>& numbers);
std::vector<std::size_t> numbers_of(const std::vector<LeafId>& leaves,
                                    const std::map<LeafId, std::size_t>& numbers);
/// All leaves below the node by their places (LeafInfo::place), and their names.
std::vector<LeafId> in_order_of_place(const std::vector<LeafInfo>& leaves);
std::vector<std::string> leaf_names(const std::vector<LeafInfo>& leaves);
/// The name of a leaf; empty if it has none.
std::string leaf_name(const ResultView& view, LeafId leaf);

/// The patch of each face, numbered as they come; a face of no one patch is a patch of its own.
std::vector<std::size_t> patch_numbers(const FlatComplex& flat);

}  // namespace cnrg
