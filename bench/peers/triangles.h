// Faces cut into triangles for systems that take nothing else, and doubles at the scale that suits them.
#pragma once

#include "bench/cases/model.h"

namespace cnrg::bench {

/// The face as seen from its front, by its own points; a face of three points is its own triangle. Coordinates may
/// be rounded, so that the face is only about planar. Throws InvariantError if its loops cross or two of its
/// points are at one place.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<RationalPoint>& points,
                                                       const Model::Face& face);

/// A power of two: coordinates multiplied by it have their largest from 2^exponent to below 2^(exponent + 1). 1 if
/// all are zero.
Rational scale_to(const std::vector<Model>& models, int exponent);

/// Solid faces as triangles, coordinates times `scale` rounded to doubles. Throws Refusal with stage `input` for a
/// model that is no solid and for faces that are no polygons.
TriangleMesh rounded_triangles(const Model& model, const Rational& scale = 1);

}  // namespace cnrg::bench
