// Faces cut into triangles for systems that take nothing else, and doubles at the scale that suits them.
#pragma once

#include "bench/cases/model.h"

namespace cnrg::bench {

/// The face as seen from its front, by its own points; a face of three points is its own triangle. Coordinates may
/// be rounded, so that the face is only about planar. Throws InvariantError if its loops cross or two of its
/// points are at one place.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<RationalPoint>& points,
                                                       const Model::Face& face);

/// Solid faces as triangles, coordinates rounded to doubles. Throws Refusal with stage `input` for a
/// model that is no solid and for faces that are no polygons.
TriangleMesh rounded_triangles(const Model& model);

}  // namespace cnrg::bench
