// A union whose operands blend where they overlap (qian2003; csg/SEMANTICS.md#blending).
//
// What a region of each operand has in common becomes regions of its own, made of a mixture: at a point at the
// distances d1 and d2 from the boundaries of the two regions the fraction of the second material is d2 / (d1 +
// d2). So there is no jump: on the boundary of the second region all is of the first, and the other way round.
//
// The regions come of operators that are there: the union with equal dominance has all of the point set, the
// intersection with equal dominance has every wall of both in what they have in common, and dominates it. So
// nothing of either operand is removed, and every region of the result is in one region of each, or in one region
// of one. What these are made of cannot come of operators that melt regions: it is looked up, region by region.
//
// Two regions of one material, and one without a material, have nothing to blend: the common part has the material
// that there is. Names are joined as those of components are.
#pragma once

#include "csg/operators/fold.h"

namespace cnrg {

/// Mixtures are given in coordinates that `placement` brings to those of the complex. Nothing is removed, and of
/// regions that blend no materials conflict, only properties. Throws InputError where the boundary of a region
/// that is to blend is unbounded or empty.
FoldResult blended_union(const Complex& complex, const Transform& placement, PartedGroup left, PartedGroup right,
                         const LeafOrder& order = {});

}  // namespace cnrg
