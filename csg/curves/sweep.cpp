// A profile along a path, as a skin (skin.h). Every section is an exact image of the profile.
//
// Along a straight piece, of direction d, points move by multiples of d: to the plane where the next bend begins,
// to the mitre, or to the end of the path. A mitre halves the angle, so what comes out of it is the profile turned
// by the bend, and not about the path: the frame with the least rotation.
//
// A round bend from d to e turns about the axis n = d x e by the rotation of the quaternion 1 + a, with
// a = n / (|d| |e| + d . e), whose vector is the axis times the tangent of half the angle. It is rational, and
// exactly orthogonal. The quaternions 1 + v a, v from 0 to 1, turn a point p = c + w along its arc: a quadratic in
// v over their square, so the wall of a Bézier segment is a Bézier patch, exactly. Its rows are, homogeneous,
//   (p, 1),  (c + w + a x w, 1),  (1 + a . a) (c + R w, 1).
// Roots are exact where they are rational, else a is rounded to doubles. What follows a bend goes on in the
// direction R d, exactly at right angles to its section; so an end may be off the path by 1e-15 of its length, and
// no section is deformed.

#include "csg/curves/skin.h"
#include "csg/geometry/circle.h"
#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

struct Plane {
  RationalPoint normal, point;
};

class Sweeper {
 public:
  explicit Sweeper(const SweepShape& shape) : shape_(shape), skin_("sweep", shape.tessellation) {
    if (shape.path.size() < 2)
      throw LeafKeyError("path", "sweep: the path has fewer than two points: give two or more");
    for (std::size_t i = 1; i < shape.path.size(); ++i) {
      if (shape.path[i] == shape.path[i - 1])
        throw LeafKeyError(
            "path", "sweep: two points of the path are both " + describe(shape.path[i]) + ": leave one out");
    }
    if (shape.radius && *shape.radius <= 0)
      throw LeafKeyError("radius",
                         "sweep: the radius is " + to_decimal(*shape.radius) + ": give a positive length");
  }

  std::shared_ptr<const NetForm> run() {
    RationalPoint normal;
    section_ = section_of(shape_.profile, "sweep", &normal);
    direction_ = shape_.path[1] - shape_.path[0];
    if (!is_zero(cross(normal, direction_)) || dot(direction_, project(section_[0][0][0]) - shape_.path[0]) != 0) {
      throw InputError(
          "sweep: the profile does not lie at right angles to the path's first piece, in a plane through"
          " its beginning " +
          describe(shape_.path[0]) + ": move the profile or the path");
    }
    for (corner_ = 1; corner_ + 1 < shape_.path.size(); ++corner_) {
      const RationalPoint way = shape_.path[corner_ + 1] - shape_.path[corner_];
      if (is_zero(cross(direction_, way)) && dot(direction_, way) < 0)
        throw LeafKeyError("path", "sweep: the path turns back at " + at_corner() + ": give it two bends");
      if (is_zero(cross(direction_, way))) continue;
      if (shape_.radius) bend(way);
      else mitre(way);
    }
    go_to({direction_, shape_.path.back()});
    return skin_.finish();
  }

 private:
  std::string at_corner() const { return describe(shape_.path[corner_]); }

  /// Each control point along the direction into a plane.
  void go_to(const Plane& plane) {
    const Rational speed = dot(plane.normal, direction_);
    Section there = mapped(section_, [&](const Homogeneous& h) {
      const RationalPoint p = project(h);
      const Rational way = dot(plane.normal, plane.point - p) / speed;
      if (way <= 0) {
        throw LeafKeyError("path", "sweep: a piece of the path before " + at_corner() +
                                       " is too short for its bends: give a longer one, a smaller profile" +
                                       (shape_.radius ? ", or a smaller radius" : ", or a `radius`"));
      }
      return homogeneous(p + way * direction_, h[3]);
    });
    skin_.add_band({section_, there});
    section_ = std::move(there);
  }

  void mitre(const RationalPoint& way) {
    const RationalPoint normal = root(dot(way, way)) * direction_ + root(dot(direction_, direction_)) * way;
    go_to({normal, shape_.path[corner_]});
    direction_ = way;
  }

  void bend(const RationalPoint& way) {
    const RationalPoint axis = cross(direction_, way), inward = cross(axis, direction_);
    const Rational lengths = dot(direction_, direction_) * dot(way, way);
    RationalPoint a = Rational(1 / (root(lengths) + dot(direction_, way))) * axis;
    if (!rational_root(lengths)) a = from_doubles(to_doubles(a));  // as good, and shorter
    const Rational tangent = *shape_.radius * root(dot(a, a) / dot(direction_, direction_));
    const RationalPoint begin = shape_.path[corner_] - tangent * direction_;
    const RationalPoint center = begin + *shape_.radius * root(1 / dot(inward, inward)) * inward;
    const RationalPoint middle = center - begin;
    go_to({direction_, begin});
    const auto from_axis = [&](const Homogeneous& h) {
      const RationalPoint w = project(h) - center;
      if (dot(w, middle) < 0) return w;
      throw InputError("sweep: the profile reaches the axis of the bend at " + at_corner() +
                       ": give a larger radius or a smaller profile");
    };
    const Section half = mapped(section_, [&](const Homogeneous& h) {
      const RationalPoint w = from_axis(h);
      return homogeneous(center + w + cross(a, w), h[3]);
    });
    const Rational square = 1 + dot(a, a);
    const auto turned = [&](const RationalPoint& w) {
      const RationalPoint across = cross(a, w);
      return w + Rational(2 / square) * (across + cross(a, across));
    };
    Section there = mapped(section_, [&](const Homogeneous& h) {
      return homogeneous(center + turned(project(h) - center), square * h[3]);
    });
    skin_.add_band({section_, half, there});
    section_ = mapped(std::move(there), [&](const Homogeneous& h) { return Rational(1 / square) * h; });
    direction_ = turned(direction_);
  }

  const SweepShape& shape_;
  Skin skin_;
  Section section_;
  RationalPoint direction_{0, 0, 0};
  std::size_t corner_ = 0;
};

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const SweepShape& shape, LeafParameters* record) {
  return prepare_skin(Sweeper(shape).run(), record);
}

std::shared_ptr<const LeafSurfaces> true_surfaces(const SweepShape& shape) {
  return skin_surfaces(*Sweeper(shape).run());
}

}  // namespace cnrg
