// Random trees of curved, flat and unbounded leaves: each node's identities, both classifications, and what a
// simplified value promises to its readers (csg/SEMANTICS.md#identities).
#pragma once

#include <cstdint>
#include <string>

#include "csg/evaluate/evaluate.h"

namespace cnrg::properties {

/// The text of a random tree file. `swept`: half of the leaves are extrusions, revolutions and patches.
std::string random_curved_tree(std::uint64_t seed, bool swept);

/// The text of a leaf that is a closed solid without holes in its facets, on a small grid: `sphere: {...}`.
std::string random_curved_solid(std::uint64_t seed);

/// The first thing that is wrong at a node of the tree, in words; empty when nothing is.
std::string check_curved_tree(const std::string& text);

}  // namespace cnrg::properties
