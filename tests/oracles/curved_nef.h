// Booleans of curved leaves against Nef polyhedra made from the leaves' own facets (coarse: Nef is slow).
#pragma once

#include <string>

#include "csg/leaves/leaf.h"
#include "tests/oracles/nef_oracle.h"

namespace cnrg::properties {

/// The facets of a leaf of a soup: without holes, outward.
scenes::Solid facets_of(const Soup& soup, LeafId leaf);

/// Volumes and canonical forms of both leaves and of their three Booleans are Nef's: the first difference in
/// words, or an empty string. The leaves are closed solids. Throws OracleFailure when Nef itself fails.
std::string compare_with_nef(const LeafInstance& a, const LeafInstance& b);

}  // namespace cnrg::properties
