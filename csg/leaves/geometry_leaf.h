// A bounded leaf: its geometry as a soup of one leaf, copied under a transform.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "csg/leaves/leaf.h"

namespace cnrg {

class GeometryLeaf final : public PreparedLeaf {
 public:
  /// `geometry` holds one leaf, LeafId(0), and no frame.
  GeometryLeaf(Soup geometry, std::vector<LeafRegion> regions, std::vector<std::string> notices = {});
  LeafId add_to(Soup& soup, const Transform& transform) const override;
  std::vector<LeafRegion> regions() const override { return regions_; }
  std::vector<std::string> notices() const override { return notices_; }

 private:
  Soup geometry_;
  std::vector<LeafRegion> regions_;
  std::vector<std::string> notices_;
};

/// Builds the geometry of one leaf.
class LeafBuilder {
 public:
  explicit LeafBuilder(Fill fill) : leaf_(soup_.add_leaf(fill)), fill_(fill) {}
  Soup& soup() { return soup_; }
  LeafId leaf() const { return leaf_; }
  PointId point(const RationalPoint& p) { return soup_.add_point(p); }
  /// A face of one loop, front by the right-hand rule.
  void face(const std::vector<PointId>& loop, std::uint32_t leaf_face);
  /// A face with holes.
  void face(const std::vector<std::vector<PointId>>& loops, std::uint32_t leaf_face);
  void triangle(PointId a, PointId b, PointId c, std::uint32_t leaf_face);
  /// The quadrilateral a b c d, or, where it is not planar exactly, the triangles a b c and a c d. Triangles of
  /// zero area (two equal corners) are left out.
  void facet(PointId a, PointId b, PointId c, PointId d, std::uint32_t leaf_face);
  RationalPoint value(PointId p) const;
  std::unique_ptr<PreparedLeaf> finish(std::vector<std::string> notices = {});

 private:
  Soup soup_;
  LeafId leaf_;
  Fill fill_;
};

}  // namespace cnrg
