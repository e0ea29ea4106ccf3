// Where on its patch a facet of a curved leaf lies.
//
// A patch is a surface S(u, v): a Bézier patch, the side of a cylinder, a sphere, what one segment of a profile
// sweeps. A curve is a line C(t). The facets of a patch lie in *cells* of it: triangles and quadrilaterals whose
// corners are points S(u, v) of the patch with their parameters, exact rationals. Between its corners a flat facet
// is not the curved patch, and the parameters of its points are those of the facet:
//   * three corners: the affine map that agrees with them;
//   * four corners a b c d, two opposite sides parallel (one of them may be a point: a pole): the bilinear map of
//     the unit square onto the quadrilateral, s along these sides and t across, has a rational inverse; the
//     parameters are bilinear in s and t;
//   * any other four: affine in the triangles a b c and a c d.
// So they are linear along every side of a cell, cells that meet in a side agree there (but for a seam or a pole),
// and S at the parameters of a point of a facet is as near to that point as the facet is to the patch (chord.h).
//
// Parameters are found when someone asks: a leaf keeps what it was made of and is tessellated once more, to the
// same facets, this time with its parameters, which it keeps. A leaf that nobody asks keeps nothing for them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "csg/geometry/exact_numbers.h"
#include "kernel/exact/rational.h"

namespace cnrg {

using Parameters = std::array<Rational, 2>;  ///< u, v

/// A corner of a cell: S(at) = point.
struct PatchCorner {
  RationalPoint point;
  Parameters at;
  friend bool operator==(const PatchCorner&, const PatchCorner&) = default;
  friend bool operator<(const PatchCorner& a, const PatchCorner& b) {
    return a.point != b.point ? a.point < b.point : a.at < b.at;
  }
};

/// The parameters of a point of the cell (a point of its plane); see above. 3 or 4 corners that are no line; of 4
/// one side may be a point. At that point itself, where the parameter along the side is anything, it is that of
/// the side's middle.
Parameters parameters_in(std::span<const PatchCorner> corners, const RationalPoint& p);
/// True for corners that `parameters_in` takes: three or four, in one plane, not on one line.
bool is_cell(std::span<const PatchCorner> corners);
/// True if the cell, its sides included, holds a point of its plane.
bool holds(std::span<const PatchCorner> corners, const RationalPoint& p);

/// The parameters of one leaf, before its transform. It is made facet by facet in the order of the leaf's faces in
/// its soup, flat faces too, and wire by wire.
class LeafParameters {
 public:
  // --- making
  /// What people call the patch (Soup::Face::patch) or curve (Soup::Wire::leaf_edge): "cylinder side", "patch 3".
  /// Of flat faces too; those are patches without parameters.
  void name_patch(std::uint32_t patch, std::string name) { patches_[patch] = std::move(name); }
  void name_curve(std::uint32_t curve, std::string name) { curves_[curve] = std::move(name); }
  /// The next face lies in one cell of its patch.
  void add_facet(std::span<const PatchCorner> corners);
  /// The next face is the union of parts of cells, none for a face without parameters.
  void add_facet(std::span<const std::vector<PatchCorner>> cells);
  /// The same, by numbers.
  struct Corner {
    std::uint32_t point, u, v;
  };
  std::uint32_t number_of(const RationalPoint& point) { return points_.of(point, "points"); }
  std::uint32_t number_of(const Rational& value) { return values_.of(value, "parameters of points"); }
  void add_facet(std::span<const Corner> corners);
  void add_flat_facet() { add_facet(std::span<const std::vector<PatchCorner>>()); }
  /// A straight piece of a curve, from C(at[0]) to C(at[1]); parameters are linear between.
  struct Wire {
    std::array<RationalPoint, 2> ends;
    std::array<Rational, 2> at;
  };
  /// The next wire.
  void add_wire(const Wire& wire);

  // --- reading
  std::size_t facet_count() const { return facets_.size() - 1; }
  std::size_t wire_count() const { return wires_.size(); }
  /// Empty for a number without a name.
  const std::string& patch_name(std::uint32_t patch) const;
  const std::string& curve_name(std::uint32_t curve) const;
  /// The cells of facet i, counted from the leaf's first face.
  std::vector<std::vector<PatchCorner>> cells(std::size_t facet) const;
  /// The same, by numbers of points() and values().
  std::vector<std::span<const Corner>> cells_by_number(std::size_t facet) const;
  const std::vector<RationalPoint>& points() const { return points_.all(); }
  std::uint32_t find(const RationalPoint& point) const { return points_.find(point); }  ///< kNone if it is none
  const std::vector<Rational>& values() const { return values_.all(); }
  /// Wire i, counted from the leaf's first one; its two parameters are equal if it has none.
  Wire wire(std::size_t i) const;

 private:
  using Index = std::uint32_t;
  void end_cell();

  std::map<std::uint32_t, std::string> patches_, curves_;
  ExactNumbers<Rational> values_;
  ExactNumbers<RationalPoint> points_;
  std::vector<Corner> corners_;
  std::vector<Index> cells_{0};              // where the corners of each cell begin, and their end
  std::vector<Index> facets_{0};             // where the cells of each facet begin, and their end
  std::vector<std::array<Index, 4>> wires_;  // points, then values
};

}  // namespace cnrg
