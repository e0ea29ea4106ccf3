// Points, directions and circles that contacts add to the tessellations of their leaves.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "csg/carriers/round_leaf.h"

namespace cnrg {

/// A point as an axis has it; `direction`, the unit vector to it, only off the axis and where r is rational, else
/// r is 0.
struct AboutAxis {
  MeridianPoint at;
  std::optional<RationalPoint> direction;
};
AboutAxis about_axis(const AxisLine& axis, const RationalPoint& p);

class ContactMarks {
 public:
  explicit ContactMarks(const std::vector<LeafInstance>& instances) : instances_(instances) {}

  void mark_point(const RoundLeaf& round, const RationalPoint& at);
  /// A point of a ring; false if the ring ends before it.
  bool mark_ring(const RoundLeaf& round, const RationalPoint& at);
  /// Of a tube; one without a length is a circle of a ring.
  void mark_direction(const RoundLeaf& round, const RationalPoint& direction, const Tube& tube);
  /// A line of a tube or cone from p to q, in the half-plane of the direction.
  void mark_line(const RoundLeaf& round, const RationalPoint& direction, const RationalPoint& p,
                 const RationalPoint& q);
  /// A point on a plane of the leaf that lies on its rim, too.
  void mark_rim(const RoundLeaf& round, const RationalPoint& at);
  /// A circle about its axis.
  void mark_circle(const RoundLeaf& round, const MeridianPoint& at);

 protected:
  const std::vector<LeafInstance>& instances_;
  std::map<std::uint32_t, TangencyMarks> marks_;

 private:
  /// True if the leaf has a vertex there as it is.
  bool has_vertex(const RoundLeaf& round, const RationalPoint& p) const;
};

}  // namespace cnrg
