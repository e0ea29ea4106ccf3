// Extrusions that other leaves can share lines with: those without twist and scale, S(u, t) = p(u) + t v.
//
// A wall lies on the surface that its segment sweeps along the whole line of v; walls of two leaves that lie on
// one such surface need the same rulings there (csg/carriers). Then facets between two rulings are in one plane,
// however far each wall goes along v.
#pragma once

#include <memory>
#include <set>
#include <utility>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/profile.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/parameters.h"
#include "csg/leaves/shapes.h"

namespace cnrg {

class ExtrudeForm final : public CurvedForm {
 public:
  explicit ExtrudeForm(ExtrudeShape given) : shape(std::move(given)), fineness("extrude", shape.tessellation) {}
  ExtrudeShape shape;
  Fineness fineness;
  // Of a leaf that has been tessellated together with others already; as of a CommonSweep.
  bool mirrored = false;
  std::shared_ptr<const AgreedSteps> steps;
  std::set<Rational> heights;
};

/// How an extrusion is tessellated together with other leaves.
struct CommonSweep {
  ExtrudeShape shape;     ///< transformed, its curves cut: segments are B-splines with a knot at each cut
  bool mirrored = false;  ///< the front of a surface is then its back
  std::shared_ptr<const AgreedSteps> steps;
  std::set<Rational> heights{};  ///< further sections, between 0 and 1
  FixedSamples fixed{};          ///< of pieces of its profile that are arcs of cylinders which other leaves share
};
/// With its parameters, which are made when they are asked for.
std::unique_ptr<PreparedLeaf> tessellate(const std::shared_ptr<const CommonSweep>& sweep);

}  // namespace cnrg
