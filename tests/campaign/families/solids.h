// What the families of volumes and of places are made of: random closed solids, flat and curved, and their echoes.
#pragma once

#include "tests/scenes/scene.h"

namespace cnrg::campaign {

/// A box, a tetrahedron or a prism on a grid, in a quarter of the cases turned; one in four a curved solid as its
/// facets.
scenes::Solid random_solid(scenes::Random& random);
/// 10^-k with k from 1 to 300, or 0; sometimes negative.
Rational random_distance(scenes::Random& random);
/// A vector with such coordinates, not all 0.
RationalPoint random_step(scenes::Random& random);
scenes::Motion translation(const RationalPoint& by);
/// Another size, about a point.
scenes::Motion scaling(const Rational& factor, const RationalPoint& about);
scenes::Solid moved(const scenes::Motion& motion, scenes::Solid solid);

}  // namespace cnrg::campaign
