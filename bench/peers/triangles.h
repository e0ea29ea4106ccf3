// Faces cut into triangles for systems that take nothing else.
#pragma once

#include "bench/cases/model.h"

namespace cnrg::bench {

/// Solid faces as triangles, coordinates rounded to doubles. Throws Refusal with stage `input` for a
/// model that is no solid and for faces that are no polygons.
TriangleMesh rounded_triangles(const Model& model);

}  // namespace cnrg::bench
