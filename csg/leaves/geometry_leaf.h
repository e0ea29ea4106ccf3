// A bounded leaf: its geometry is made once, as a soup of one leaf, and copied under each transform.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/leaves/leaf.h"
#include "csg/leaves/leaf_stop.h"
#include "csg/leaves/parameters.h"

namespace cnrg {

class GeometryLeaf final : public PreparedLeaf {
 public:
  /// `geometry` holds one leaf, LeafId(0), and no frame.
  GeometryLeaf(Soup geometry, std::vector<Attributes> regions, std::vector<std::string> notices = {});
  LeafId add_to(Soup& soup, const Transform& transform) const override;
  std::vector<Attributes> regions() const override { return regions_; }
  std::vector<std::string> notices() const override { return notices_; }
  const Soup& geometry() const { return geometry_; }

 private:
  Soup geometry_;
  std::vector<Attributes> regions_;
  std::vector<std::string> notices_;
};

/// A leaf without any cells.
const std::shared_ptr<const PreparedLeaf>& no_geometry();

/// The axes in whose order regions are numbered, once what has the axes `axes` (nullptr: x, y, z) is moved;
/// nothing where that is the order of x, y and z.
std::optional<LeafAxes> moved_axes(const LeafAxes* axes, const Transform& transform);

/// The coordinates of a point, exactly.
RationalPoint exact_value(const Soup& soup, PointId p);

/// The parameters of the four corners of a facet of a grid, u and v of each.
using CornerParameters = std::array<std::array<const Rational*, 2>, 4>;

/// Builds the geometry of one leaf and, into `record`, where it is given, the parameters of its facets;
/// `curved_sides` as Soup::add_leaf has it, of a sheet. Throws
/// Stopped where the making of leaves is stopped (leaf_stop.h).
class LeafBuilder {
 public:
  explicit LeafBuilder(Fill fill, LeafParameters* record = nullptr, bool curved_sides = false)
      : leaf_(soup_.add_leaf(fill, curved_sides && fill == Fill::none)), fill_(fill), record_(record) {}
  Soup& soup() { return soup_; }
  LeafId leaf() const { return leaf_; }
  PointId point(const RationalPoint& p) {
    LeafStop::check();
    return soup_.add_point(p);
  }
  std::vector<PointId> points(const std::vector<RationalPoint>& list) {
    std::vector<PointId> ids;
    for (const RationalPoint& p : list) ids.push_back(point(p));
    return ids;
  }
  /// A face of one loop, front by the right-hand rule.
  void face(const std::vector<PointId>& loop, std::uint32_t leaf_face);
  /// A face with holes.
  void face(const std::vector<std::vector<PointId>>& loops, std::uint32_t leaf_face);
  void triangle(PointId a, PointId b, PointId c, std::uint32_t leaf_face);
  /// The quadrilateral a b c d, or, where it is not planar exactly, the triangles a b c and a c d. Triangles of
  /// zero area (two equal corners) are left out.
  void facet(PointId a, PointId b, PointId c, PointId d, std::uint32_t leaf_face, const CornerParameters& at);
  /// The triangle a b c of a patch.
  void facet(PointId a, PointId b, PointId c, std::uint32_t leaf_face,
             const std::array<std::array<const Rational*, 2>, 3>& at);
  /// Curves end at the ends of a line; not where these are one point, as on a tube or at the top of a cone.
  void end_curves(const std::vector<PointId>& line);
  /// What people call a patch.
  void name_patch(std::uint32_t leaf_face, const char* name) {
    if (record_ != nullptr) record_->name_patch(leaf_face, name);
  }
  RationalPoint value(PointId p) const;
  std::unique_ptr<PreparedLeaf> finish(std::vector<std::string> notices = {});

 private:
  Soup soup_;
  LeafId leaf_;
  Fill fill_;
  LeafParameters* record_;
  std::vector<std::uint32_t> recorded_;  // by point: its number in `record_`; kNone: not yet

  LeafParameters::Corner corner(PointId p, const std::array<const Rational*, 2>& at);
  bool coplanar(PointId a, PointId b, PointId c, PointId d) const;
  void note_flat() {
    if (record_ != nullptr) record_->add_flat_facet();
  }
};

}  // namespace cnrg
