// The boundary of solid regions, for formats that hold nothing else.
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

/// Throws InputError if an active face or edge reaches the frame: only .json can say so.
void require_off_frame(const FlatComplex& flat, const std::string& format);

/// Throws InputError unless every cell on the boundary of an active one is active and no active region is
/// unbounded, neither by itself nor by reaching the frame. The message names `closure`.
void require_closed_and_bounded(const FlatComplex& flat, const std::string& format);

}  // namespace cnrg
