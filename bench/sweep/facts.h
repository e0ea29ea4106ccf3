// What is counted in a closed point set on a complex.
#pragma once

#include "bench/sweep/row.h"
#include "kernel/complex/complex.h"
#include "kernel/selection/selection.h"

namespace cnrg::bench {

/// The boundary of a union of 3-cells as a closed surface, pulled apart where solid touches solid: around an edge
/// each sector of solid is a piece by itself, around a vertex each cone of it.
struct BoundarySurface {
  std::size_t shells = 0;  ///< connected pieces
  long genus = 0;          ///< handles of all of them
};
/// `solid`: ascending, all bounded.
BoundarySurface boundary_surface(const Complex& complex, const std::vector<RegionId>& solid);

/// Of a closed set of bounded cells.
Facts facts_of(const Complex& complex, const CellSet& set);

/// The cells of a closed set that bound no solid of it.
CellSet dangling(const Complex& complex, const CellSet& set);

/// Sums over faces and edges, rounded: square and plain units.
double area(const Complex& complex, const std::vector<FaceId>& faces);
double length(const Complex& complex, const std::vector<EdgeId>& edges);

}  // namespace cnrg::bench
