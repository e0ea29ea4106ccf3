#include "csg/carriers/boxes.h"

#include <algorithm>
#include <cmath>

namespace cnrg {

Box box_of(const RevolvedForm& form, const Transform& transform) {
  double reach = 0, low = 0, high = 0;
  bool first = true;
  for (const auto& line : form.lines) {
    for (const MeridianPiece& piece : line) {
      const bool arc = piece.kind == MeridianPiece::Kind::arc;
      const Rational square =
          form.axis[0] * form.axis[0] + form.axis[1] * form.axis[1] + form.axis[2] * form.axis[2];
      const double along = arc ? to_double(piece.radius) / std::sqrt(to_double(square)) : 0;
      std::vector<MeridianPoint> points{piece.from, piece.to};
      if (arc) points = {{piece.middle.r + piece.radius, piece.middle.t}};
      for (const Homogeneous& h : piece.net.net) points.push_back({h[0] / h[3], h[2] / h[3]});
      for (const MeridianPoint& p : points) {
        reach = std::max(reach, to_double(p.r));
        low = first ? to_double(p.t) - along : std::min(low, to_double(p.t) - along);
        high = first ? to_double(p.t) + along : std::max(high, to_double(p.t) + along);
        first = false;
      }
    }
  }
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    double center = to_double(transform.offset[k]), step = 0, square = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = to_double(transform.linear[k][j]);
      center += entry * to_double(form.center[j]);
      step += entry * to_double(form.axis[j]);
      square += entry * entry;
    }
    const double out = reach * std::sqrt(square);
    box.lo[k] = center + std::min(low * step, high * step) - out;
    box.hi[k] = center + std::max(low * step, high * step) + out;
    const double margin = 1e-9 * (std::abs(box.lo[k]) + std::abs(box.hi[k]) + out);
    box.lo[k] -= margin;
    box.hi[k] += margin;
  }
  return box;
}

Box box_of(const ExtrudeForm& form, const Transform& transform) {
  Box box;
  const auto add = [&](const RationalPoint& p) {
    const RationalPoint q = transform.apply(p);
    std::array<double, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = to_double(q[k]), margin = 1e-9 * std::abs(x);
      low[k] = x - margin;
      high[k] = x + margin;
    }
    box.extend(low, high);
  };
  for (const ProfileLine& line : form.shape.profile.lines) {
    for (const CurveNet& net : line.segments) {
      for (const RationalPoint& p : net.points) {
        add(p);
        add({p[0] + form.shape.vector[0], p[1] + form.shape.vector[1], p[2] + form.shape.vector[2]});
      }
    }
  }
  return box;
}

}  // namespace cnrg
