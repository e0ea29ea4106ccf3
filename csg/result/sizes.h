// How long edges of a mesh are to be: what was said of the leaves of a result, read off for its cells.
//
// Where several leaves have a say the shortest length counts. A cell is where its leaves are, all of it; only a
// region may lie in a leaf in part, since a union makes one region of two. What is said of a leaf holds in a
// region if all of it lies in leaves that something is said of; then the longest of what is said somewhere in it:
// a small foot at a large plate must not make all of the plate as fine as the foot. The faces of the foot are
// fine, and lengths grow from there.
#pragma once

#include <vector>

#include "csg/result/flat.h"

namespace cnrg {

/// The shortest length that was said of these leaves; 0: none was.
double size_of(const ResultView& view, const FlatComplex::Provenance& origin);

/// What each region is made of; empty if nobody says sizes, or may.
std::vector<LeafParts> region_parts(const ResultView& view, const FlatComplex& flat);

/// Of each region, 0: nothing is said; empty if nothing is said of any.
std::vector<double> region_sizes(const ResultView& view, const FlatComplex& flat);

}  // namespace cnrg
