// Questions of incidence that people ask: the link of cells, the radial order about an edge.
#pragma once

#include <vector>

#include "kernel/selection/selection.h"

namespace cnrg {

/// The cells of the closure of the star of a set whose closure does not meet the closure of the set: what a walk
/// around the set passes. Cells on the frame are left out.
CellSet link(const Complex& complex, const CellSet& set);

/// A step about an edge: a face that is met, by the side that is seen first when turning counter-clockwise (as
/// seen with the edge pointing towards the viewer), and the region behind it (weiler1986, the radial cycle).
struct RadialStep {
  HalfFace face;
  RegionId region;
  friend bool operator==(const RadialStep&, const RadialStep&) = default;
};

/// The faces about an edge in radial order, a slit twice; empty for a wire.
std::vector<RadialStep> radial_order(const Complex& complex, EdgeId e);

}  // namespace cnrg
