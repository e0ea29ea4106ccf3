// How short edges get between features that nearly touch, where nobody asks for short ones.
//
// TetGen halves an edge of the model while a point lies in the ball around it, and a facet likewise. So a point
// that is near to an edge or a facet on which it does not lie makes edges there about as long as that distance,
// and they grow from it. Points are the ends of edges and what halves them: an edge that passes a facet or another
// edge is halved until its points are a quarter of a piece away, and where two cross at an angle that is soon.
// What is nearer than a thousandth of the model does not count: TetGen mostly does not come to an end there, and
// those who are asked then do not refine for it.
#pragma once

#include "csg/mesh/mesh_sizes.h"

namespace cnrg {

/// Growth of the lengths between features. With 13 tetrahedra per h^3: measured on a wire 0.0008 to 0.1 away from
/// a face (18 to 21 for each of its distances in its length), and on points beside a point and a face (120 and 75
/// more where the distance is divided by e).
inline constexpr double kGrowthOfNear = 1.05;

/// These lengths, as a field without an overall size, empty where no features are as near to each other as less
/// than kNear times the sizes there. `sizes` are not empty. Points are those of `flat`, rounded. Throws Stopped.
SizeField sizes_of_near(const FlatComplex& flat, const RoundedPoints& points, const MeshSizes& sizes,
                        const Watch& watch);

}  // namespace cnrg
