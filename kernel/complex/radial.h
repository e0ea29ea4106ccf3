// How faces about an edge turn. Private to this room.
#pragma once

#include "kernel/base/error.h"
#include "kernel/complex/complex.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

class RadialOrder {
 public:
  RadialOrder(const Complex& complex, EdgeId e) : c_(complex) {
    const PointTable& t = c_.points;
    const auto [a, b] = c_.edge_ends[e];
    const PointView va = t.view(a), vb = t.view(b);
    double best = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double up = vb.lo[axis] - va.hi[axis], down = va.lo[axis] - vb.hi[axis];
      if (std::max(up, down) > best) {
        best = std::max(up, down);
        axis_ = axis;
        direction_ = up > 0 ? 1 : -1;
      }
    }
    for (int axis = 0; axis < 3 && axis_ < 0; ++axis) {
      direction_ = compare(t, axis, b, a);
      if (direction_ != 0) axis_ = axis;
    }
  }
  /// The sign of the sine of the angle from one face to the other, counter-clockwise as seen with the edge
  /// pointing towards the viewer.
  int sine(const FaceUse& x, const FaceUse& y) const {
    const SheetId sx = c_.face_sheet[x.face], sy = c_.face_sheet[y.face];
    if (sx == sy) return 0;
    const int s = cross_normal_sign(c_.points, c_.sheet_plane[sx], c_.sheet_plane[sy], axis_) * direction_;
    require(s != 0, "coplanar faces at one edge are in two sheets");
    return x.half_edge.direction() == y.half_edge.direction() ? s : -s;
  }

 private:
  const Complex& c_;
  int axis_ = -1, direction_ = 0;
};

}  // namespace cnrg
