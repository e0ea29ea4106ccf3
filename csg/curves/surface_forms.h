// The surfaces of curved leaves by name: what a CAD file calls them (csg/geometry/cad_surfaces.h).
//
// A shape says which surface it is, so nothing is recognized here but what a profile hides: a straight segment
// sweeps a cylinder or a cone, an arc a sphere or a torus. Numbers are the doubles nearest to those of the shape.
#pragma once

#include <optional>

#include "csg/curves/surface.h"
#include "csg/leaves/shapes.h"

namespace cnrg {

SurfaceForm cone_form(const ConeShape& shape);  ///< with equal radii a cylinder
SurfaceForm sphere_form(const RationalPoint& center, const Rational& radius, const RationalPoint& axis);
SurfaceForm torus_form(const TorusShape& shape);
/// Of a segment of a profile that is not flat.
SurfaceForm revolved_form(const RevolveShape& shape, const CurveNet& segment);
/// Nothing for an extrusion that is twisted, whose walls have no name. `center`: what it shrinks to.
std::optional<SurfaceForm> extruded_form(const ExtrudeShape& shape, const RationalPoint& center,
                                         const CurveNet& segment);
SurfaceForm net_form(const PatchNet& net);
CurveForm curve_form(const CurveNet& net);

}  // namespace cnrg
