// The facets of one Bézier patch, between given numbers of steps on its sides.
//
// A grid of equal steps, a power of two in each direction, so fine that the bound of chord.h holds in most cells.
// Sides may have fewer steps than the grid, for they are sampled by their own data. The outermost ring of cells
// joins both, as triangles. Each triangle that is in no cell with a good bound is bounded on its own, and while
// its bound is above the chord, its worst edge inside of the patch is bisected, which splits both triangles at it
// and leaves no hanging vertex. That ends: edges on a side are never cut, and as a triangle at a side gets
// thinner, its bound becomes that of the side's own segment, at most half of the chord.
//
// A part of a cylinder, of any section, is cut along rulings alone, between the steps of its rims: seen along
// them, a facet is the segment of a rim. So it has the facets of an extrusion.
//
// The facets depend on the patch alone, not on the way its net is written: of the eight ways the smallest is
// taken. A patch that is in two leaves has the same facets in both.
#pragma once

#include <cstdint>
#include <vector>

#include "csg/curves/boundary_curves.h"
#include "csg/leaves/parameters.h"

namespace cnrg {

struct PatchMesh {
  std::vector<RationalPoint> points;  ///< exactly on the patch
  /// Counter-clockwise as seen from the front of the given patch; no two corners of one are equal.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The parameters of the given patch at the corners of each triangle, by number in `parameters`. A point that is
  /// one side of the patch has many.
  std::vector<std::array<std::uint32_t, 3>> places;
  std::vector<Parameters> parameters;
};

/// The cell of triangle t (parameters.h). If one corner is a pole, a side of the patch that has shrunk to a point,
/// it is two corners of the cell, each with the parameter along that side of its neighbour: so triangles around a
/// pole agree on the edges between them.
std::vector<PatchCorner> cell_of(const PatchMesh& mesh, std::size_t t, const BezierPatch& patch);

/// Further lines of the grid, by their parameters u and v.
using PatchLines = std::array<std::vector<Rational>, 2>;

/// Throws InputError where the chord asks for too many facets.
PatchMesh mesh_patch(const BezierPatch& patch, const Fineness& fineness, BoundaryCurves& boundary,
                     const PatchLines& lines = {});

}  // namespace cnrg
