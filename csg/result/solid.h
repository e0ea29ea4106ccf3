// The boundary of solid regions, for formats that hold nothing else: of all together, or of each by itself.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "csg/result/flat.h"

namespace cnrg {

struct SolidBoundary {
  std::vector<FlatComplex::Index> points;               ///< used ones, ascending
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< places in `points`; normals point out of the solid
};

/// Throws InputError if `format` (such as `OFF`) cannot hold the result: an unbounded region, cells that are
/// missing from the boundary, walls between regions, and faces, wires or points that bound no region. The
/// message counts them and names formats and operators that help.
SolidBoundary solid_boundary(const FlatComplex& flat, const std::string& format);

/// The closed surface around one region, in which each side of a triangle has exactly one neighbour.
struct RegionBoundary {
  FlatComplex::Index region = 0;
  /// By vertex: a point of the flattened result. Where the region touches itself in an edge or a point, the
  /// surface only seems to: each of its sheets there has vertices of its own.
  std::vector<FlatComplex::Index> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertices; normals point out of the region
};

/// Of a closed and bounded result one per active region, in their order. A face between two regions has the same
/// triangles in both, turned; faces inside of a region are left out. Throws InputError, for `format`, where a
/// region touches itself so that no cut helps.
std::vector<RegionBoundary> region_boundaries(const FlatComplex& flat, const std::string& format);

/// Throws InputError for faces, wires and points that bound no region; walls are allowed.
void require_regions_only(const FlatComplex& flat, const std::string& format);

/// Throws InputError if an active face or edge reaches the frame: only .json can say so.
void require_off_frame(const FlatComplex& flat, const std::string& format);

/// Throws InputError unless every cell on the boundary of an active one is active. The message names `closure`.
void require_closed(const FlatComplex& flat, const std::string& format);

/// The same, and unless no active region is unbounded, neither by itself nor by reaching the frame.
void require_closed_and_bounded(const FlatComplex& flat, const std::string& format);

}  // namespace cnrg
