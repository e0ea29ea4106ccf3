// Spheres, cylinders and planes of the leaves, and the distances between them.
#include "csg/carriers/tangency.h"

#include <algorithm>
#include <cmath>

#include "csg/carriers/contact_marks.h"
#include "csg/curves/surface_math.h"
#include "csg/geometry/circle.h"
#include "csg/leaves/unbounded.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Point3 = std::array<double, 3>;

Box around(const Point3& a, const Point3& b) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double margin = 1e-9 * (1e-300 + std::abs(a[k]) + std::abs(b[k]));
    box.lo[k] = std::min(a[k], b[k]) - margin;
    box.hi[k] = std::max(a[k], b[k]) + margin;
  }
  return box;
}

Point3 point_image(const Transform& transform, const Point3& p) {
  Point3 q;
  for (std::size_t k = 0; k < 3; ++k) {
    q[k] = to_double(transform.offset[k]);
    for (std::size_t j = 0; j < 3; ++j) q[k] += to_double(transform.linear[k][j]) * p[j];
  }
  return q;
}

class Finder : ContactMarks {
 public:
  Finder(const std::vector<LeafInstance>& instances, const Transform& to_space)
      : ContactMarks(instances), to_space_(to_space), in_space_of_tree_(to_space.identity()) {}

  void add(const RevolvedInstance& of) {
    place_.emplace(of.instance, rounds_.size());
    rounds_.emplace_back(of, dynamic_cast<const RevolvedForm&>(*instances_[of.instance].leaf->form()));
  }

  void pairs(const std::vector<std::array<Index, 2>>& list) {
    for (const auto& [i, j] : list) {
      const auto first = place_.find(i), second = place_.find(j);
      if (first == place_.end() || second == place_.end()) continue;
      RoundLeaf &a = rounds_[first->second], &b = rounds_[second->second];
      if (a.may_touch(b) && a.make_exact() && b.make_exact()) pair(a, b);
    }
  }

  void planes(const BesidePlanes& beside) {
    const LeafInstance& instance = instances_[beside.instance];
    const Transform transform = in_space_of_tree_ ? *instance.transform : to_space_ * instance.transform;
    if (const auto* leaf = dynamic_cast<const UnboundedLeaf*>(instance.leaf.get())) {
      const ExactHalfspace plane = leaf->image(transform);
      const Point3 normal = to_doubles(plane.normal);
      const double length = std::sqrt(surface_math::dot(normal, normal));
      for (const Index i : beside.revolved) {
        RoundLeaf& round = rounds_[place_.at(i)];
        if (round.may_touch({normal[0] / length, normal[1] / length, normal[2] / length},
                            to_double(plane.offset) / length) &&
            round.make_exact())
          with_flat(round, {plane.normal, plane.offset});
      }
    } else if (const auto* geometry = dynamic_cast<const GeometryLeaf*>(instance.leaf.get())) {
      faces(*geometry, transform, beside.revolved);
    }
  }

  Contacts take() { return {std::move(marks_), std::move(nested_), std::move(inside_), std::move(circles_)}; }

 private:
  /// The faces of a leaf near the leaves `met`.
  void faces(const GeometryLeaf& leaf, const Transform& transform, const std::vector<Index>& met) {
    const Soup& soup = leaf.geometry();
    std::vector<Point3> points;
    for (const PointId p : IdRange<PointId>(soup.point_count())) {
      const double* x = soup.xyz(p);
      points.push_back(point_image(transform, {x[0], x[1], x[2]}));
    }
    std::vector<Box> boxes;
    for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
      Box box;
      for (const PointId p : soup.corners(f)) {
        if (p.valid()) box.extend(around(points[p.index()], points[p.index()]));
      }
      boxes.push_back(box);
    }
    const BoxTree tree(boxes);
    for (const Index r : met) {
      RoundLeaf& round = rounds_[place_.at(r)];
      tree.query([&](const Box& box) { return box.meets(round.box()); },
                 [&](Index f) { face(round, soup, transform, points, SourceId(f)); });
    }
  }

  void face(RoundLeaf& round, const Soup& soup, const Transform& transform, const std::vector<Point3>& points,
            SourceId f) {
    const std::span<const PointId> corners = soup.corners(f);
    // Three corners that span the plane best, in doubles.
    Point3 normal{0, 0, 0};
    std::size_t second = 0, third = 0;
    double most = 0;
    const Point3& first = points[corners[0].index()];
    for (std::size_t i = 1; i + 1 < corners.size() && corners[i + 1].valid(); ++i) {
      const Point3 n = surface_math::cross(surface_math::difference(points[corners[i].index()], first),
                                           surface_math::difference(points[corners[i + 1].index()], first));
      if (!(surface_math::dot(n, n) > most)) continue;
      most = surface_math::dot(n, n);
      normal = n;
      second = i;
      third = i + 1;
    }
    if (most == 0) return;
    const double length = std::sqrt(most), offset = surface_math::dot(normal, first) / length;
    if (!round.may_touch({normal[0] / length, normal[1] / length, normal[2] / length}, offset) ||
        !round.make_exact())
      return;
    const auto exact = [&](std::size_t i) { return transform.apply(exact_value(soup, corners[i])); };
    const RationalPoint a = exact(0), n = cross(exact(second) - a, exact(third) - a);
    if (is_zero(n)) return;
    Flat flat{n, dot(n, a), {{}}};
    for (const PointId p : corners) {
      if (p.valid()) flat.loops.back().push_back(transform.apply(exact_value(soup, p)));
      else flat.loops.emplace_back();
    }
    with_flat(round, flat);
  }

  /// `owner`: the revolved leaf that the plane is of, if it is of one.
  void with_flat(const RoundLeaf& round, const Flat& flat, const RoundLeaf* owner = nullptr) {
    const Rational square = dot(flat.normal, flat.normal);
    for (const Ball3& ball : round.exact().balls) {
      const Rational gap = dot(flat.normal, ball.center) - flat.offset;
      if (gap * gap != ball.radius * ball.radius * square) continue;
      const RationalPoint at = ball.center - Rational(gap / square) * flat.normal;
      if (!flat.meets(at, at)) continue;
      mark_point(round, at);
      if (owner != nullptr) mark_rim(*owner, at);
    }
    for (const Tube& tube : round.exact().tubes) {
      if (dot(flat.normal, tube.axis) != 0) continue;
      const Rational gap = dot(flat.normal, tube.foot) - flat.offset;
      if (gap * gap != tube.radius * tube.radius * square) continue;
      const RationalPoint direction = Rational(-gap / (square * tube.radius)) * flat.normal;
      const RationalPoint on = tube.foot + tube.radius * direction;
      if (!flat.meets(on + tube.low * tube.axis, on + tube.high * tube.axis)) continue;
      mark_direction(round, direction, tube);
      if (owner == nullptr) continue;
      for (const Rational& end : {tube.low, tube.high}) mark_rim(*owner, on + end * tube.axis);
    }
    const AxisLine& axis = round.exact().placed.axis;
    const RationalPoint across =
        flat.normal - Rational(dot(flat.normal, axis.direction) / round.exact().placed.square()) * axis.direction;
    if (is_zero(across)) {
      flat_on_rings(round, flat);
    } else if (const auto out = rational_root(dot(across, across))) {
      // Where they touch and this root is not rational, numbers would be equal of which one is not rational
      // either, but for a plane through the middle of a ring: its two contacts are no points that could be
      // vertices.
      for (const int side : {1, -1}) steep_flat(round, flat, Rational(side / *out) * across, owner);
    }
  }
  /// A plane across the axis, which touches rings in circles.
  void flat_on_rings(const RoundLeaf& round, const Flat& flat) {
    const AxisLine& axis = round.exact().placed.axis;
    const Rational t = (flat.offset - dot(flat.normal, axis.foot)) / dot(flat.normal, axis.direction);
    for (const Ring& ring : round.exact().rings) {
      const Rational up = t - ring.middle.t;
      if (ring.middle.r == 0 || up * up * round.exact().placed.square() != ring.radius * ring.radius) continue;
      if (!flat.meets_circle(axis.foot + t * axis.direction, ring.middle.r)) continue;
      mark_circle(round, {ring.middle.r, t});
    }
  }
  /// Any other plane, which touches rings in points and cones along lines, in the half-plane of the direction.
  void steep_flat(const RoundLeaf& round, const Flat& flat, const RationalPoint& direction,
                  const RoundLeaf* owner) {
    const AxisLine& axis = round.exact().placed.axis;
    const auto place = [&](const MeridianPoint& p) { return axis.foot + p.t * axis.direction + p.r * direction; };
    const auto gap = [&](const MeridianPoint& p) -> Rational { return flat.offset - dot(flat.normal, place(p)); };
    const std::optional<Rational> length = rational_root(dot(flat.normal, flat.normal));
    for (const Ring& ring : round.exact().rings) {
      if (ring.middle.r == 0 || !length) continue;
      const Rational way = gap(ring.middle);
      if (abs(way) != ring.radius * *length) continue;
      const RationalPoint at = place(ring.middle) + Rational(way / (*length * *length)) * flat.normal;
      if (!flat.meets(at, at) || !mark_ring(round, at)) continue;
      if (owner != nullptr) mark_rim(*owner, at);
    }
    for (const Slant& slant : round.exact().slants) {
      if (gap(slant.from) != 0 || gap(slant.to) != 0 || !round.covers(direction)) continue;
      if (!flat.meets(place(slant.from), place(slant.to))) continue;
      mark_line(round, direction, place(slant.from), place(slant.to));
      if (owner == nullptr) continue;
      for (const MeridianPoint& end : {slant.from, slant.to}) mark_rim(*owner, place(end));
    }
  }

  void pair(const RoundLeaf& a, const RoundLeaf& b) {
    common_circles(a, b);
    common_circles(b, a);
    for (const Flat& flat : b.exact().flats) with_flat(a, flat, &b);
    for (const Flat& flat : a.exact().flats) with_flat(b, flat, &a);
    for (const Ball3& p : a.exact().balls) {
      for (const Ball3& q : b.exact().balls) two_balls(a, p, b, q);
      for (const Tube& q : b.exact().tubes) ball_and_tube(a, p, b, q);
    }
    for (const Tube& p : a.exact().tubes) {
      for (const Ball3& q : b.exact().balls) ball_and_tube(b, q, a, p);
      for (const Tube& q : b.exact().tubes) two_tubes(a, p, b, q);
    }
    for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      for (const Ring& ring : p->exact().rings) {
        if (ring.middle.r == 0) continue;
        for (const Ball3& ball : q->exact().balls) ring_and_ball(*p, ring, *q, ball);
        for (const Tube& tube : q->exact().tubes) ring_and_tube(*p, ring, *q, tube);
      }
      for (const Slant& slant : p->exact().slants) {
        for (const Ball3& ball : q->exact().balls) slant_and_ball(*p, slant, *q, ball);
      }
    }
    for (const Ring& p : a.exact().rings) {
      for (const Ring& q : b.exact().rings) two_rings(a, p, b, q);
    }
  }

  /// Meridians of a that b has, too, or a little larger or smaller.
  void common_circles(const RoundLeaf& a, const RoundLeaf& b) {
    const AxisLine& axis = a.exact().placed.axis;
    for (const Ring& ring : a.exact().rings) {
      if (ring.middle.r == 0) continue;
      const RationalPoint center = axis.foot + ring.middle.t * axis.direction;
      // One about b's axis: this is a tangent of the circle of centres.
      const AxisLine& other = b.exact().placed.axis;
      if (dot(axis.direction, other.direction) == 0) {
        const Rational t = other.place_of(center);
        const RationalPoint at = other.foot + t * other.direction;
        if (const auto radius = b.radius_near({ring.radius, t}))
          has_circle(a, ring, at - center, other.direction, {b.instance(), *radius, std::nullopt});
      }
      if (b.is_sphere()) {
        const Ball3& ball = b.exact().balls[0];
        if (ball.radius == ring.radius)
          has_circle(a, ring, ball.center - center, cross(axis.direction, ball.center - center),
                     {b.instance(), ball.radius, std::nullopt});
      }
      for (const Ring& second : b.exact().rings) {
        if (second.middle.r == 0 || !is_near(second.radius, ring.radius)) continue;
        const RationalPoint mate = other.foot + second.middle.t * other.direction, apart = mate - center;
        const RationalPoint turn = cross(axis.direction, other.direction);
        if (!is_zero(turn)) {
          // From both centres at right angles to the line in which the planes of the two cross.
          if (dot(apart, turn) != 0) continue;
          const RationalPoint way = cross(turn, axis.direction);
          const RationalPoint out = Rational(dot(apart, other.direction) / dot(way, other.direction)) * way;
          meet_rings(a, ring, out, b, second, out - apart, turn);
        } else if (const auto sum = gauge(apart, ring.middle.r, second.middle.r);
                   sum && dot(apart, axis.direction) == 0) {
          const RationalPoint out = Rational(ring.middle.r / *sum) * apart;
          meet_rings(a, ring, out, b, second, out - apart, cross(axis.direction, out));
        }
      }
    }
  }
  void meet_rings(const RoundLeaf& a, const Ring& ring, const RationalPoint& out, const RoundLeaf& b,
                  const Ring& second, const RationalPoint& other, const RationalPoint& along) {
    if (dot(other, other) != second.middle.r * second.middle.r || dot(other, b.exact().placed.axis.direction) != 0)
      return;
    const RationalPoint direction = Rational(1 / second.middle.r) * other;
    if (b.covers(direction)) has_circle(a, ring, out, along, {b.instance(), second.radius, direction});
  }
  /// `out`: from the centre of the ring's circle to that of its meridian.
  void has_circle(const RoundLeaf& a, const Ring& ring, const RationalPoint& out, const RationalPoint& along,
                  const HasCircle& other) {
    const AxisLine& axis = a.exact().placed.axis;
    if (dot(out, out) != ring.middle.r * ring.middle.r || dot(out, axis.direction) != 0) return;
    const RationalPoint own = Rational(1 / ring.middle.r) * out;
    if (!a.covers(own)) return;
    const RationalPoint center = axis.foot + ring.middle.t * axis.direction + out;
    auto& all = circles_[{center, axis_line(center, along).direction, ring.radius}];
    all.insert({a.instance(), ring.radius, own});
    all.insert(other);
  }
  /// How two radii make a distance: r + s, or r - s where one is inside of the other; nothing where they do not.
  static std::optional<Rational> gauge(const RationalPoint& apart, const Rational& r, const Rational& s) {
    if (is_zero(apart) || !may_be(apart, r, s)) return std::nullopt;
    const Rational square = dot(apart, apart);
    if (square == (r + s) * (r + s)) return Rational(r + s);
    if (square == (r - s) * (r - s)) return Rational(r - s);
    return std::nullopt;
  }
  static bool may_be(const RationalPoint& apart, const Rational& r, const Rational& s) {
    const Point3 x = to_doubles(apart);
    const double length = std::sqrt(surface_math::dot(x, x)), p = to_double(r), q = to_double(s);
    return nearly(length, p + q, p + q) || nearly(length, std::abs(p - q), p + q);
  }

  void two_balls(const RoundLeaf& a, const Ball3& p, const RoundLeaf& b, const Ball3& q) {
    const RationalPoint apart = q.center - p.center;
    const auto sum = gauge(apart, p.radius, q.radius);
    if (!sum) return;
    if (*sum != p.radius + q.radius && a.is_sphere() && b.is_sphere()) {
      nested_.push_back({a.instance(), b.instance()});
      return;
    }
    const RationalPoint at = p.center + Rational(p.radius / *sum) * apart;
    mark_point(a, at);
    mark_point(b, at);
  }

  void ball_and_tube(const RoundLeaf& a, const Ball3& ball, const RoundLeaf& b, const Tube& tube) {
    const Rational t = dot(ball.center - tube.foot, tube.axis) / dot(tube.axis, tube.axis);
    if (t < tube.low || t > tube.high) return;
    const RationalPoint foot = tube.foot + t * tube.axis, apart = ball.center - foot;
    const auto sum = gauge(apart, tube.radius, ball.radius);
    if (!sum) return;
    const RationalPoint direction = Rational(1 / *sum) * apart;
    // A tube that touches a larger ball from inside leaves it on both sides: there the surfaces cross. In the
    // plane across the tube it is inside.
    if (*sum != tube.radius + ball.radius) {
      if (!a.is_sphere() && a.exact().placed.axis.direction != tube.axis) return;
      const bool in_tube = *sum > 0;
      inside_.push_back({(in_tube ? a : b).instance(), (in_tube ? b : a).instance(), direction});
    }
    mark_point(a, foot + tube.radius * direction);
    mark_direction(b, direction, tube);
  }

  void two_tubes(const RoundLeaf& a, const Tube& p, const RoundLeaf& b, const Tube& q) {
    if (p.axis != q.axis) {
      crossed_tubes(a, p, b, q);
      return;
    }
    const Rational square = dot(p.axis, p.axis);
    // Places along either axis count from its own foot; both feet lie in the plane through the origin across it.
    if (std::max(p.low, q.low) > std::min(p.high, q.high) || square == 0) return;
    const RationalPoint apart = q.foot - p.foot;
    const auto sum = gauge(apart, p.radius, q.radius);
    if (!sum) return;
    const RationalPoint direction = Rational(1 / *sum) * apart;
    const bool beside = *sum == p.radius + q.radius, first = *sum > 0;
    if (!beside) inside_.push_back({(first ? b : a).instance(), (first ? a : b).instance(), direction});
    mark_direction(a, direction, p);
    mark_direction(b, Rational(beside ? -1 : 1) * direction, q);
  }

  /// Tubes whose axes are not parallel. Side by side they touch in a point, where a ruling of one crosses one of
  /// the other. Where their axes are as far apart as their radii differ, the curve in which they cross passes
  /// through itself in such a point; if radii are equal and axes meet, in two.
  void crossed_tubes(const RoundLeaf& a, const Tube& p, const RoundLeaf& b, const Tube& q) {
    const RationalPoint apart = q.foot - p.foot, turn = cross(p.axis, q.axis);
    const Rational across = dot(apart, turn), square = dot(turn, turn), sum = p.radius + q.radius,
                   difference = p.radius - q.radius;
    const bool beside = across * across == sum * sum * square;
    if (!beside && across * across != difference * difference * square) return;
    // p.foot + s p.axis and q.foot + t q.axis are next to each other.
    const Rational s = dot(cross(apart, q.axis), turn) / square, t = dot(cross(apart, p.axis), turn) / square;
    if (s < p.low || s > p.high || t < q.low || t > q.high) return;
    if (across == 0) {
      const RationalPoint direction = scaled_cosine(0, 1 / square) * turn;
      for (const int side : {1, -1}) {
        mark_direction(a, Rational(side) * direction, p);
        mark_direction(b, Rational(side) * direction, q);
      }
      return;
    }
    const RationalPoint direction = Rational(across / ((beside ? sum : difference) * square)) * turn;
    mark_direction(a, direction, p);
    mark_direction(b, Rational(beside ? -1 : 1) * direction, q);
  }

  // --- rings and cones beside others

  /// From outside. On the inner half of a ring, where the plane that touches both would cut the ring, the ball is
  /// inside of the cone that touches both; so it is inside of a cone that it touches from there.
  void ring_and_ball(const RoundLeaf& a, const Ring& ring, const RoundLeaf& b, const Ball3& ball) {
    const PlacedForm& placed = a.exact().placed;
    const auto [center, direction] = about_axis(placed.axis, ball.center);
    if (!direction) return;
    const MeridianPoint way = center - ring.middle;
    const Rational sum = ring.radius + ball.radius;
    if (way.r * way.r + placed.square() * way.t * way.t != sum * sum) return;
    const RationalPoint at =
        ball.center - Rational(ball.radius / sum) * (way.r * *direction + way.t * placed.axis.direction);
    if (!mark_ring(a, at)) return;
    mark_point(b, at);
    if (way.r < 0 && b.is_sphere()) inside_.push_back({b.instance(), a.instance(), *direction});
  }

  void slant_and_ball(const RoundLeaf& a, const Slant& slant, const RoundLeaf& b, const Ball3& ball) {
    const PlacedForm& placed = a.exact().placed;
    const auto [center, direction] = about_axis(placed.axis, ball.center);
    if (!direction || !a.covers(*direction)) return;
    const MeridianPoint way = slant.to - slant.from, off = center - slant.from;
    const auto product = [square = placed.square()](const MeridianPoint& p, const MeridianPoint& q) -> Rational {
      return p.r * q.r + square * p.t * q.t;
    };
    const Rational part = product(way, off) / product(way, way);
    const MeridianPoint foot = slant.from + part * way, apart = off - part * way;
    if (part < 0 || part > 1 || foot.r <= 0 || product(apart, apart) != ball.radius * ball.radius) return;
    const auto place = [&placed, &across = *direction](const MeridianPoint& p) {
      return placed.axis.foot + p.t * placed.axis.direction + p.r * across;
    };
    mark_line(a, *direction, place(slant.from), place(slant.to));
    mark_point(b, place(foot));
    if (apart.r < 0 && b.is_sphere()) inside_.push_back({b.instance(), a.instance(), *direction});
  }

  /// About parallel axes, the outermost or the innermost circle of the ring; else where a normal of the ring's
  /// circle of centres that meets the axis of the tube is at right angles to both axes, or parallel to its own.
  void ring_and_tube(const RoundLeaf& a, const Ring& ring, const RoundLeaf& b, const Tube& tube) {
    const PlacedForm& placed = a.exact().placed;
    const AxisLine& axis = placed.axis;
    const RationalPoint center = axis.foot + ring.middle.t * axis.direction;
    if (axis.direction == tube.axis) {
      for (const Rational& r : {Rational(ring.middle.r + ring.radius), Rational(ring.middle.r - ring.radius)}) {
        if (r > 0 && a.holds({r, ring.middle.t}, placed.start))
          two_tubes(a, {axis.foot, axis.direction, r, ring.middle.t, ring.middle.t}, b, tube);
      }
      return;
    }
    const RationalPoint turn = cross(axis.direction, tube.axis);
    if (const auto sine = rational_root(dot(turn, turn))) {
      for (const int side : {1, -1})
        bead_and_tube(a, ring, Rational(side * ring.middle.r / *sine) * turn, b, tube);
    }
    if (dot(axis.direction, tube.axis) != 0) return;
    const RationalPoint off = tube.foot - center,
                        out = off - Rational(dot(off, axis.direction) / placed.square()) * axis.direction;
    const Rational square = dot(tube.axis, tube.axis);
    const RationalPoint nearest = out - Rational(dot(out, tube.axis) / square) * tube.axis;
    if (const auto reach =
            rational_root(Rational((ring.middle.r * ring.middle.r - dot(nearest, nearest)) / square))) {
      for (const int side : {1, -1})
        bead_and_tube(a, ring, nearest + Rational(side * *reach) * tube.axis, b, tube);
    }
  }
  /// `out`: from the centre of the ring's circle to a point of it.
  void bead_and_tube(const RoundLeaf& a, const Ring& ring, const RationalPoint& out, const RoundLeaf& b,
                     const Tube& tube) {
    const AxisLine& axis = a.exact().placed.axis;
    const RationalPoint middle = axis.foot + ring.middle.t * axis.direction + out;
    const Rational t = dot(middle - tube.foot, tube.axis) / dot(tube.axis, tube.axis),
                   sum = ring.radius + tube.radius;
    const RationalPoint apart = tube.foot + t * tube.axis - middle;
    if (t < tube.low || t > tube.high || dot(apart, apart) != sum * sum) return;
    if (dot(apart, cross(axis.direction, out)) != 0) return;
    if (mark_ring(a, middle + Rational(ring.radius / sum) * apart))
      mark_direction(b, Rational(-1 / sum) * apart, tube);
  }

  /// Beside each other, their outermost circles.
  void two_rings(const RoundLeaf& a, const Ring& p, const RoundLeaf& b, const Ring& q) {
    const AxisLine &first = a.exact().placed.axis, &second = b.exact().placed.axis;
    const RationalPoint center = first.foot + p.middle.t * first.direction,
                        apart = second.foot + q.middle.t * second.direction - center;
    const Rational own = p.middle.r + p.radius, sum = own + q.middle.r + q.radius;
    if (p.middle.r == 0 || q.middle.r == 0 || dot(apart, apart) != sum * sum) return;
    if (dot(apart, first.direction) != 0 || dot(apart, second.direction) != 0) return;
    const RationalPoint at = center + Rational(own / sum) * apart;
    if (mark_ring(a, at)) mark_ring(b, at);
  }

  const Transform& to_space_;
  bool in_space_of_tree_;
  std::vector<RoundLeaf> rounds_;
  std::map<Index, std::size_t> place_;
  std::vector<std::array<Index, 2>> nested_;
  std::vector<Inside> inside_;
  std::map<CircleInSpace, std::set<HasCircle>> circles_;
};

}  // namespace

Box leaf_box(const GeometryLeaf& leaf, const Transform& transform) {
  Box own, box;
  for (const PointId p : IdRange<PointId>(leaf.geometry().point_count())) {
    const double* x = leaf.geometry().xyz(p);
    own.extend({x[0], x[1], x[2]}, {x[0], x[1], x[2]});
  }
  for (int i = 0; i < 8; ++i) {
    const Point3 corner = point_image(
        transform, {(i & 1 ? own.hi : own.lo)[0], (i & 2 ? own.hi : own.lo)[1], (i & 4 ? own.hi : own.lo)[2]});
    box.extend(around(corner, corner));
  }
  return box;
}

std::vector<BesidePlanes> beside_planes(const std::vector<LeafInstance>& instances,
                                        const std::vector<RevolvedInstance>& revolved,
                                        const std::set<Index>& alone) {
  std::vector<BesidePlanes> result;
  if (revolved.empty()) return result;
  std::vector<Box> boxes;
  for (const RevolvedInstance& of : revolved) boxes.push_back(of.box);
  const BoxTree tree(boxes);
  for (Index i = 0; i < instances.size(); ++i) {
    if (alone.contains(i)) continue;
    BesidePlanes beside{i, {}};
    const LeafInstance& instance = instances[i];
    if (dynamic_cast<const UnboundedLeaf*>(instance.leaf.get()) != nullptr) {
      for (const RevolvedInstance& of : revolved) beside.revolved.push_back(of.instance);
    } else if (const auto* geometry = dynamic_cast<const GeometryLeaf*>(instance.leaf.get())) {
      const Box reach = leaf_box(*geometry, instance.transform);
      tree.query([&](const Box& box) { return box.meets(reach); },
                 [&](Index r) { beside.revolved.push_back(revolved[r].instance); });
    }
    if (!beside.revolved.empty()) result.push_back(std::move(beside));
  }
  return result;
}

Contacts contacts(const std::vector<LeafInstance>& instances, const Transform& to_space,
                  const std::vector<RevolvedInstance>& revolved, const std::vector<std::array<Index, 2>>& pairs,
                  const std::vector<BesidePlanes>& planes) {
  Finder finder(instances, to_space);
  for (const RevolvedInstance& of : revolved) finder.add(of);
  finder.pairs(pairs);
  for (const BesidePlanes& beside : planes) finder.planes(beside);
  return finder.take();
}

}  // namespace cnrg
