// Spheres, cylinders and planes of the leaves, and the distances between them.
#include "csg/carriers/tangency.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "csg/carriers/sectors.h"
#include "csg/geometry/exact_vectors.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/unbounded.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Point3 = std::array<double, 3>;

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point3 times(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What a revolved leaf may touch with.
struct Ball3 {
  RationalPoint center;
  Rational radius;
};
struct Tube {
  RationalPoint foot, axis;
  Rational radius, low, high;  ///< from foot + low axis to foot + high axis
};
/// An arc that a plane across the axis may touch in a circle.
struct Ring {
  MeridianPoint middle;
  Rational radius;
};
/// A part of a plane: a polygon, a ring about the axis of a revolved leaf, or all of it.
struct Flat {
  RationalPoint normal;
  Rational offset;
  std::vector<std::vector<RationalPoint>> loops{};   ///< of a polygon
  RationalPoint center{};                            ///< of a ring
  std::optional<std::array<Rational, 2>> squares{};  ///< of the radii of a ring, inside and outside

  /// True if the segment from p to q, in the plane, has a point in it; p and q may be one.
  bool meets(const RationalPoint& p, const RationalPoint& q) const;
  /// True if a circle in the plane has a point in it.
  bool meets_circle(const RationalPoint& middle, const Rational& radius) const;

 private:
  bool polygon_meets(const RationalPoint& p, const RationalPoint& q) const;
};
struct Exact {
  PlacedForm placed;
  std::vector<Ball3> balls;
  std::vector<Tube> tubes;
  std::vector<Ring> rings;
  std::vector<Flat> flats;  ///< its own planes across the axis
};
/// A leaf in doubles, and exactly as soon as that is asked for: most pairs are far from a contact, and the numbers
/// of nested rotations are long.
struct Round {
  const RevolvedInstance* of = nullptr;
  Point3 along{};                                           ///< of length 1
  std::vector<std::pair<Point3, double>> balls{};           ///< centres and radii; of arcs about the axis, too
  std::vector<std::pair<Point3, double>> tubes{};           ///< points of the axis and radii
  std::vector<std::tuple<Point3, double, double>> rings{};  ///< centres, and radii of circles and of their tubes
  std::vector<double> flats{};                              ///< offsets of its planes across the axis
  std::optional<Exact> exact{};
};

Box around(const Point3& a, const Point3& b) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double margin = 1e-9 * (1e-300 + std::abs(a[k]) + std::abs(b[k]));
    box.lo[k] = std::min(a[k], b[k]) - margin;
    box.hi[k] = std::max(a[k], b[k]) + margin;
  }
  return box;
}

/// On the line through a and b, between them or one of them.
bool between(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
  return is_zero(cross(b - a, p - a)) && cnrg::dot(p - a, p - b) <= 0;
}

bool Flat::meets(const RationalPoint& p, const RationalPoint& q) const {
  if (squares) {
    // The nearest point of the segment, and the farther one of its ends.
    const RationalPoint way = q - p;
    const Rational whole = cnrg::dot(way, way);
    Rational part = whole == 0 ? Rational(0) : Rational(cnrg::dot(center - p, way) / whole);
    part = std::max(Rational(0), std::min(Rational(1), part));
    const RationalPoint nearest = p + part * way - center;
    const Rational low = cnrg::dot(nearest, nearest),
                   high = std::max(cnrg::dot(p - center, p - center), cnrg::dot(q - center, q - center));
    return low <= (*squares)[1] && high >= (*squares)[0];
  }
  return loops.empty() || polygon_meets(p, q);
}

bool Flat::meets_circle(const RationalPoint& middle, const Rational& radius) const {
  if (squares) {
    // Circles of radii r and s that are d apart have a point in common for |r - s| <= d <= r + s; of a ring all
    // radii count from the inner to the outer one.
    const RationalPoint off = middle - center;
    const double apart = std::sqrt(to_double(cnrg::dot(off, off))), r = to_double(radius),
                 low = std::sqrt(to_double((*squares)[0])), high = std::sqrt(to_double((*squares)[1]));
    const double margin = 1e-9 * (apart + r + high);
    return apart <= r + high + margin && r <= apart + high + margin && low <= apart + r + margin;
  }
  if (loops.empty()) return true;
  const Rational square = radius * radius;
  bool inside = polygon_meets(middle, middle), outside = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()], way = b - a;
      outside = outside || cnrg::dot(a - middle, a - middle) >= square;
      Rational part = cnrg::dot(middle - a, way) / cnrg::dot(way, way);
      part = std::max(Rational(0), std::min(Rational(1), part));
      const RationalPoint nearest = a + part * way - middle;
      inside = inside || cnrg::dot(nearest, nearest) <= square;
    }
  }
  return inside && outside;
}

bool Flat::polygon_meets(const RationalPoint& p, const RationalPoint& q) const {
  // The side of c as seen from a to b.
  const auto side = [&](const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
    return sgn(cnrg::dot(cross(b - a, c - a), normal));
  };
  // A ray from p along the plane, across a direction that no corner lies in, would do; here it is counted how
  // often the loops wind around p, along the largest two axes of the plane.
  std::size_t x = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(normal[k]) > abs(normal[x])) x = k;
  }
  const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
  bool odd = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if (between(a, b, p) || between(a, b, q)) return true;
      if (p != q && side(a, b, p) * side(a, b, q) <= 0 && side(p, q, a) * side(p, q, b) <= 0 &&
          !(is_zero(cross(b - a, q - p)) && side(a, b, p) != 0))
        return true;
      if ((a[z] > p[z]) == (b[z] > p[z])) continue;
      const Rational at = a[y] + (p[z] - a[z]) / (b[z] - a[z]) * (b[y] - a[y]);
      if (at > p[y]) odd = !odd;
    }
  }
  return odd;
}

/// Nearly equal lengths, in doubles: what is not certainly is not exactly either.
bool near(double a, double b, double size) {
  return !(std::abs(a - b) > 1e-6 * (size + std::abs(a) + std::abs(b)));
}

Point3 image(const Transform& transform, const Point3& p) {
  Point3 q;
  for (std::size_t k = 0; k < 3; ++k) {
    q[k] = to_double(transform.offset[k]);
    for (std::size_t j = 0; j < 3; ++j) q[k] += to_double(transform.linear[k][j]) * p[j];
  }
  return q;
}

/// Of the corners of a leaf's own box.
Box box_of(const GeometryLeaf& leaf, const Transform& transform) {
  Box own, box;
  for (const PointId p : IdRange<PointId>(leaf.geometry().point_count())) {
    const double* x = leaf.geometry().xyz(p);
    own.extend({x[0], x[1], x[2]}, {x[0], x[1], x[2]});
  }
  for (int i = 0; i < 8; ++i) {
    const Point3 corner = image(
        transform, {(i & 1 ? own.hi : own.lo)[0], (i & 2 ? own.hi : own.lo)[1], (i & 4 ? own.hi : own.lo)[2]});
    box.extend(around(corner, corner));
  }
  return box;
}

class Finder {
 public:
  Finder(const std::vector<LeafInstance>& instances, const Transform& to_space)
      : instances_(instances), to_space_(to_space), in_space_of_tree_(to_space.identity()) {}

  void add(const RevolvedInstance& of) {
    const Transform& transform = of.transform;
    const RevolvedForm& form = form_of(of.instance);
    Round round{&of};
    const Point3 center = to_doubles(transform.apply(form.center)),
                 step = minus(to_doubles(transform.apply(form.center + form.axis)), center);
    double scale = 0;
    for (const Rational& x : transform.linear[0]) scale += to_double(x) * to_double(x);
    scale = std::sqrt(scale);
    const double length = std::sqrt(dot(step, step));
    for (std::size_t k = 0; k < 3; ++k) round.along[k] = step[k] / length;
    const auto at = [&](const Rational& t) {
      Point3 p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = center[k] + to_double(t) * step[k];
      return p;
    };
    const auto flat = [&](const Rational& t) { round.flats.push_back(dot(at(t), round.along)); };
    for (const auto& line : form.lines) {
      for (const MeridianPiece& piece : line) {
        if (piece.flat()) flat(piece.from.t);
        if (piece.kind == MeridianPiece::Kind::arc) {
          round.balls.emplace_back(at(piece.middle.t), scale * to_double(piece.radius));
          if (piece.middle.r > 0) {
            round.rings.emplace_back(at(piece.middle.t), scale * to_double(piece.middle.r),
                                     scale * to_double(piece.radius));
          }
        } else if (piece.kind == MeridianPiece::Kind::line && piece.from.r == piece.to.r && piece.from.r > 0) {
          round.tubes.emplace_back(center, scale * to_double(piece.from.r));
        }
      }
      if (form.discs) {
        flat(line.front().from.t);
        flat(line.back().to.t);
      }
    }
    place_.emplace(of.instance, rounds_.size());
    rounds_.push_back(std::move(round));
  }

  void pairs(const std::vector<std::array<Index, 2>>& list) {
    for (const auto& [i, j] : list) {
      const auto first = place_.find(i), second = place_.find(j);
      if (first == place_.end() || second == place_.end()) continue;
      Round &a = rounds_[first->second], &b = rounds_[second->second];
      if (may_touch(a, b) && is_exact(a) && is_exact(b)) pair(a, b);
    }
  }

  void planes(const BesidePlanes& beside) {
    const LeafInstance& instance = instances_[beside.instance];
    const Transform transform = in_space_of_tree_ ? instance.transform : to_space_ * instance.transform;
    if (const auto* leaf = dynamic_cast<const UnboundedLeaf*>(instance.leaf.get())) {
      const ExactHalfspace plane = leaf->image(transform);
      const Point3 normal = to_doubles(plane.normal);
      const double length = std::sqrt(dot(normal, normal));
      for (const Index i : beside.revolved) {
        Round& round = rounds_[place_.at(i)];
        if (may_touch(round, {normal[0] / length, normal[1] / length, normal[2] / length},
                      to_double(plane.offset) / length) &&
            is_exact(round))
          with_flat(round, {plane.normal, plane.offset});
      }
    } else if (const auto* geometry = dynamic_cast<const GeometryLeaf*>(instance.leaf.get())) {
      faces(*geometry, transform, beside.revolved);
    }
  }

  Contacts take() { return {std::move(marks_), std::move(nested_), std::move(inside_), std::move(circles_)}; }

 private:
  const RevolvedForm& form_of(Index i) const {
    return dynamic_cast<const RevolvedForm&>(*instances_[i].leaf->form());
  }

  /// The faces of a leaf near the leaves `met`.
  void faces(const GeometryLeaf& leaf, const Transform& transform, const std::vector<Index>& met) {
    const Soup& soup = leaf.geometry();
    std::vector<Point3> points;
    for (const PointId p : IdRange<PointId>(soup.point_count())) {
      const double* x = soup.xyz(p);
      points.push_back(image(transform, {x[0], x[1], x[2]}));
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
      Round& round = rounds_[place_.at(r)];
      tree.query([&](const Box& box) { return box.meets(round.of->box); },
                 [&](Index f) { face(round, soup, transform, points, SourceId(f)); });
    }
  }

  void face(Round& round, const Soup& soup, const Transform& transform, const std::vector<Point3>& points,
            SourceId f) {
    const std::span<const PointId> corners = soup.corners(f);
    // Three corners that span the plane best, in doubles.
    Point3 normal{0, 0, 0};
    std::size_t second = 0, third = 0;
    double most = 0;
    const Point3& first = points[corners[0].index()];
    for (std::size_t i = 1; i + 1 < corners.size() && corners[i + 1].valid(); ++i) {
      const Point3 n =
          times(minus(points[corners[i].index()], first), minus(points[corners[i + 1].index()], first));
      if (!(dot(n, n) > most)) continue;
      most = dot(n, n);
      normal = n;
      second = i;
      third = i + 1;
    }
    if (most == 0) return;
    const double length = std::sqrt(most), offset = dot(normal, first) / length;
    if (!may_touch(round, {normal[0] / length, normal[1] / length, normal[2] / length}, offset) ||
        !is_exact(round))
      return;
    const auto exact = [&](std::size_t i) { return transform.apply(exact_value(soup, corners[i])); };
    const RationalPoint a = exact(0), n = cross(exact(second) - a, exact(third) - a);
    if (is_zero(n)) return;
    Flat flat{n, cnrg::dot(n, a), {{}}};
    for (const PointId p : corners) {
      if (p.valid()) flat.loops.back().push_back(transform.apply(exact_value(soup, p)));
      else flat.loops.emplace_back();
    }
    with_flat(round, flat);
  }

  /// Makes the leaf exact; false if it is stretched so that it has no radii, or none that are rational.
  bool is_exact(Round& round) const {
    if (round.exact) return true;
    const Transform& transform = round.of->transform;
    const std::optional<Rational> scale = stretch(transform);
    if (!scale) return false;
    const RevolvedForm& form = form_of(round.of->instance);
    Exact& exact = round.exact.emplace();
    exact.placed = place(form, transform, *scale);
    const AxisLine& axis = exact.placed.axis;
    const auto flat = [&](const Rational& t, const Rational& r, const Rational& s) {
      const RationalPoint at = axis.foot + t * axis.direction;
      const auto [low, high] = std::minmax(r, s);
      exact.flats.push_back({axis.direction,
                             cnrg::dot(axis.direction, at),
                             {},
                             at,
                             std::array<Rational, 2>{low * low, high * high}});
    };
    for (const auto& line : exact.placed.lines) {
      for (const MeridianPiece& piece : line) {
        if (piece.flat()) flat(piece.from.t, piece.from.r, piece.to.r);
        if (piece.kind == MeridianPiece::Kind::arc) {
          exact.rings.push_back({piece.middle, piece.radius});
          if (piece.middle.r == 0)
            exact.balls.push_back({axis.foot + piece.middle.t * axis.direction, piece.radius});
        } else if (piece.kind == MeridianPiece::Kind::line && piece.from.r == piece.to.r && piece.from.r > 0) {
          exact.tubes.push_back({axis.foot, axis.direction, piece.from.r, std::min(piece.from.t, piece.to.t),
                                 std::max(piece.from.t, piece.to.t)});
        }
      }
      if (form.discs) {
        flat(line.front().from.t, 0, line.front().from.r);
        flat(line.back().to.t, 0, line.back().to.r);
      }
    }
    return true;
  }

  static double size_of(const Point3& p) { return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]); }

  /// False if a plane, with a normal of length 1, certainly touches nothing of the leaf.
  static bool may_touch(const Round& round, const Point3& normal, double offset) {
    const auto is_near = [&](const std::pair<Point3, double>& of) {
      return near(std::abs(dot(normal, of.first) - offset), of.second, size_of(of.first));
    };
    return std::any_of(round.balls.begin(), round.balls.end(), is_near) ||
           std::any_of(round.tubes.begin(), round.tubes.end(), is_near);
  }
  /// A meridian of a; all around the axis of b, in a ball of it, or a meridian of it, too.
  static bool may_share_circle(const Round& a, const Round& b) {
    const double turn = dot(a.along, b.along);
    for (const auto& [p, r, tube] : a.rings) {
      for (const auto& [q, s] : b.balls) {
        const Point3 apart = minus(q, p);
        if (near(std::sqrt(dot(apart, apart)), r, size_of(p))) return true;
      }
      for (const auto& [q, s] : b.tubes) {
        const Point3 out = times(minus(p, q), b.along);
        if (std::abs(turn) < 1e-6 && near(std::sqrt(dot(out, out)), r, size_of(p))) return true;
      }
      for (const auto& [q, s, other] : b.rings) {
        const Point3 across = times(a.along, b.along), apart = minus(q, p);
        const double distance = std::sqrt(dot(apart, apart));
        if (!near(tube, other, tube)) continue;
        if (dot(across, across) > 1e-6
                ? near(dot(apart, across), 0, size_of(p) + size_of(q))
                : near(distance, r + s, size_of(p)) || near(distance, std::abs(r - s), size_of(p)))
          return true;
      }
    }
    return false;
  }
  static bool may_touch(const Round& a, const Round& b) {
    for (const double offset : b.flats) {
      if (may_touch(a, b.along, offset)) return true;
    }
    for (const double offset : a.flats) {
      if (may_touch(b, a.along, offset)) return true;
    }
    const auto may_be = [](double distance, double r, double s, double size) {
      return near(distance, r + s, size) || near(distance, std::abs(r - s), size);
    };
    const auto across = [](const Point3& p, const Point3& foot, const Point3& along) {
      const Point3 off = minus(p, foot), out = times(off, along);
      return std::sqrt(dot(out, out));
    };
    if (may_share_circle(a, b) || may_share_circle(b, a)) return true;
    for (const auto& [p, r] : a.balls) {
      for (const auto& [q, s] : b.balls) {
        const Point3 apart = minus(p, q);
        if (may_be(std::sqrt(dot(apart, apart)), r, s, size_of(p))) return true;
      }
      for (const auto& [q, s] : b.tubes) {
        if (may_be(across(p, q, b.along), r, s, size_of(p))) return true;
      }
    }
    for (const auto& [p, r] : a.tubes) {
      for (const auto& [q, s] : b.balls) {
        if (may_be(across(q, p, a.along), r, s, size_of(p))) return true;
      }
      for (const auto& [q, s] : b.tubes) {
        const Point3 turn = times(a.along, b.along), apart = minus(q, p);
        const double sine = std::sqrt(dot(turn, turn));
        if (sine < 1e-3 ? may_be(across(q, p, a.along), r, s, size_of(p))
                        : near(std::abs(dot(apart, turn)) / sine, r + s, size_of(p) + size_of(q)))
          return true;
      }
    }
    return false;
  }

  /// `owner`: the revolved leaf that the plane is of, if it is of one.
  void with_flat(const Round& round, const Flat& flat, const Round* owner = nullptr) {
    const Rational square = cnrg::dot(flat.normal, flat.normal);
    for (const Ball3& ball : round.exact->balls) {
      const Rational gap = cnrg::dot(flat.normal, ball.center) - flat.offset;
      if (gap * gap != ball.radius * ball.radius * square) continue;
      const RationalPoint at = ball.center - Rational(gap / square) * flat.normal;
      if (!flat.meets(at, at)) continue;
      mark_point(round, at);
      if (owner != nullptr) mark_rim(*owner, at);
    }
    for (const Tube& tube : round.exact->tubes) {
      if (cnrg::dot(flat.normal, tube.axis) != 0) continue;
      const Rational gap = cnrg::dot(flat.normal, tube.foot) - flat.offset;
      if (gap * gap != tube.radius * tube.radius * square) continue;
      const RationalPoint direction = Rational(-gap / (square * tube.radius)) * flat.normal;
      const RationalPoint on = tube.foot + tube.radius * direction;
      if (!flat.meets(on + tube.low * tube.axis, on + tube.high * tube.axis)) continue;
      mark_direction(round, direction, tube);
      if (owner == nullptr) continue;
      for (const Rational& end : {tube.low, tube.high}) mark_rim(*owner, on + end * tube.axis);
    }
    const AxisLine& axis = round.exact->placed.axis;
    if (round.exact->rings.empty() || !is_zero(cross(flat.normal, axis.direction))) return;
    const Rational t = (flat.offset - cnrg::dot(flat.normal, axis.foot)) / cnrg::dot(flat.normal, axis.direction);
    for (const Ring& ring : round.exact->rings) {
      const Rational up = t - ring.middle.t;
      if (ring.middle.r == 0 || up * up * round.exact->placed.square() != ring.radius * ring.radius) continue;
      const RationalPoint center = axis.foot + t * axis.direction;
      if (!flat.meets_circle(center, ring.middle.r)) continue;
      Marks& marks = marks_[round.of->instance];
      marks.circles.push_back({ring.middle.r, t});
      marks.needed = marks.needed || !has_vertex(round, center + ring.middle.r * round.exact->placed.start);
    }
  }

  void pair(const Round& a, const Round& b) {
    common_circles(a, b);
    common_circles(b, a);
    for (const Flat& flat : b.exact->flats) with_flat(a, flat, &b);
    for (const Flat& flat : a.exact->flats) with_flat(b, flat, &a);
    for (const Ball3& p : a.exact->balls) {
      for (const Ball3& q : b.exact->balls) two_balls(a, p, b, q);
      for (const Tube& q : b.exact->tubes) ball_and_tube(a, p, b, q);
    }
    for (const Tube& p : a.exact->tubes) {
      for (const Ball3& q : b.exact->balls) ball_and_tube(b, q, a, p);
      for (const Tube& q : b.exact->tubes) two_tubes(a, p, b, q);
    }
  }

  /// Meridians of a that b has, too.
  void common_circles(const Round& a, const Round& b) {
    const AxisLine& axis = a.exact->placed.axis;
    for (const Ring& ring : a.exact->rings) {
      if (ring.middle.r == 0) continue;
      const RationalPoint center = axis.foot + ring.middle.t * axis.direction;
      // One about b's axis: this is a tangent of the circle of centres.
      const AxisLine& other = b.exact->placed.axis;
      if (cnrg::dot(axis.direction, other.direction) == 0) {
        const Rational t = other.place_of(center);
        const RationalPoint at = other.foot + t * other.direction;
        if (goes_around(b, {ring.radius, t})) has_circle(a, ring, at - center, b, other.direction, std::nullopt);
      }
      if (is_sphere(b)) {
        const Ball3& ball = b.exact->balls[0];
        if (ball.radius == ring.radius)
          has_circle(a, ring, ball.center - center, b, cross(axis.direction, ball.center - center), std::nullopt);
      }
      for (const Ring& second : b.exact->rings) {
        if (second.middle.r == 0 || second.radius != ring.radius) continue;
        const RationalPoint mate = other.foot + second.middle.t * other.direction, apart = mate - center;
        const RationalPoint turn = cross(axis.direction, other.direction);
        if (!is_zero(turn)) {
          // From both centres at right angles to the line in which the planes of the two cross.
          if (cnrg::dot(apart, turn) != 0) continue;
          const RationalPoint way = cross(turn, axis.direction);
          const RationalPoint out =
              Rational(cnrg::dot(apart, other.direction) / cnrg::dot(way, other.direction)) * way;
          meet_rings(a, ring, out, b, second, out - apart, turn);
        } else if (const auto sum = gauge(cnrg::dot(apart, apart), ring.middle.r, second.middle.r);
                   sum && cnrg::dot(apart, axis.direction) == 0) {
          const RationalPoint out = Rational(ring.middle.r / *sum) * apart;
          meet_rings(a, ring, out, b, second, out - apart, cross(axis.direction, out));
        }
      }
    }
  }
  void meet_rings(const Round& a, const Ring& ring, const RationalPoint& out, const Round& b, const Ring& second,
                  const RationalPoint& other, const RationalPoint& along) {
    if (cnrg::dot(other, other) != second.middle.r * second.middle.r ||
        cnrg::dot(other, b.exact->placed.axis.direction) != 0)
      return;
    const RationalPoint direction = Rational(1 / second.middle.r) * other;
    if (covers(b, direction)) has_circle(a, ring, out, b, along, direction);
  }
  /// `out`: from the centre of the ring's circle to that of its meridian.
  void has_circle(const Round& a, const Ring& ring, const RationalPoint& out, const Round& b,
                  const RationalPoint& along, const std::optional<RationalPoint>& direction) {
    const AxisLine& axis = a.exact->placed.axis;
    if (cnrg::dot(out, out) != ring.middle.r * ring.middle.r || cnrg::dot(out, axis.direction) != 0) return;
    const RationalPoint own = Rational(1 / ring.middle.r) * out;
    if (!covers(a, own)) return;
    const RationalPoint center = axis.foot + ring.middle.t * axis.direction + out;
    auto& all = circles_[{center, axis_line(center, along).direction, ring.radius}];
    all.insert({a.of->instance, own});
    all.insert({b.of->instance, direction});
  }
  /// True if the leaf's turn has the direction.
  bool covers(const Round& round, const RationalPoint& direction) const {
    const PlacedForm& placed = round.exact->placed;
    const bool with = placed.along != placed.mirrored;
    const Sector turn{with ? placed.start : placed.end, with ? placed.end : placed.start,
                      form_of(round.of->instance).around()};
    return overlap(turn, {direction, direction, false}, placed.axis.direction);
  }
  /// True if the leaf has the circle about its axis.
  static bool goes_around(const Round& round, const MeridianPoint& p) {
    const Rational square = round.exact->placed.square();
    for (const auto& line : round.exact->placed.lines) {
      for (const MeridianPiece& piece : line) {
        if (p == piece.from || p == piece.to) return true;
        const Rational r = p.r - piece.middle.r, t = p.t - piece.middle.t;
        if (piece.kind == MeridianPiece::Kind::arc && r * r + square * t * t == piece.radius * piece.radius)
          return true;
        if (piece.kind == MeridianPiece::Kind::line && piece.from.r == p.r && piece.to.r == p.r &&
            (p.t - piece.from.t) * (p.t - piece.to.t) <= 0)
          return true;
      }
    }
    return false;
  }

  /// A point on a plane of the leaf that lies on its rim, too.
  void mark_rim(const Round& round, const RationalPoint& at) {
    for (const Tube& tube : round.exact->tubes) {
      const Rational t = cnrg::dot(at - tube.foot, tube.axis) / cnrg::dot(tube.axis, tube.axis);
      const RationalPoint off = at - (tube.foot + t * tube.axis);
      if (t < tube.low || t > tube.high || cnrg::dot(off, off) != tube.radius * tube.radius) continue;
      mark_direction(round, Rational(1 / tube.radius) * off, tube);
    }
  }

  /// How two radii make a distance: r + s, or r - s where one is inside of the other; nothing where they do not.
  static std::optional<Rational> gauge(const Rational& square, const Rational& r, const Rational& s) {
    if (square == 0) return std::nullopt;
    if (square == (r + s) * (r + s)) return Rational(r + s);
    if (square == (r - s) * (r - s)) return Rational(r - s);
    return std::nullopt;
  }
  static bool may_be(const RationalPoint& apart, const Rational& r, const Rational& s) {
    const Point3 x = to_doubles(apart);
    const double length = std::sqrt(dot(x, x)), p = to_double(r), q = to_double(s);
    return near(length, p + q, p + q) || near(length, std::abs(p - q), p + q);
  }

  void two_balls(const Round& a, const Ball3& p, const Round& b, const Ball3& q) {
    const RationalPoint apart = q.center - p.center;
    if (!may_be(apart, p.radius, q.radius)) return;
    const auto sum = gauge(cnrg::dot(apart, apart), p.radius, q.radius);
    if (!sum) return;
    if (*sum != p.radius + q.radius && is_sphere(a) && is_sphere(b)) {
      nested_.push_back({a.of->instance, b.of->instance});
      return;
    }
    const RationalPoint at = p.center + Rational(p.radius / *sum) * apart;
    mark_point(a, at);
    mark_point(b, at);
  }

  bool is_sphere(const Round& round) const { return form_of(round.of->instance).is_sphere(); }

  void ball_and_tube(const Round& a, const Ball3& ball, const Round& b, const Tube& tube) {
    const Rational t = cnrg::dot(ball.center - tube.foot, tube.axis) / cnrg::dot(tube.axis, tube.axis);
    if (t < tube.low || t > tube.high) return;
    const RationalPoint foot = tube.foot + t * tube.axis, apart = ball.center - foot;
    if (!may_be(apart, tube.radius, ball.radius)) return;
    const auto sum = gauge(cnrg::dot(apart, apart), tube.radius, ball.radius);
    // A tube that touches a larger ball from inside leaves it on both sides: there the surfaces cross.
    if (!sum || *sum < 0) return;
    const RationalPoint direction = Rational(1 / *sum) * apart;
    if (*sum != tube.radius + ball.radius) {
      if (!is_sphere(a) && a.exact->placed.axis.direction != tube.axis) return;
      inside_.push_back({a.of->instance, b.of->instance, direction});
    }
    mark_point(a, foot + tube.radius * direction);
    mark_direction(b, direction, tube);
  }

  void two_tubes(const Round& a, const Tube& p, const Round& b, const Tube& q) {
    if (p.axis != q.axis) {
      crossed_tubes(a, p, b, q);
      return;
    }
    const Rational square = cnrg::dot(p.axis, p.axis);
    // Places along either axis count from its own foot; both feet lie in the plane through the origin across it.
    if (std::max(p.low, q.low) > std::min(p.high, q.high) || square == 0) return;
    const RationalPoint apart = q.foot - p.foot;
    if (!may_be(apart, p.radius, q.radius)) return;
    const auto sum = gauge(cnrg::dot(apart, apart), p.radius, q.radius);
    if (!sum) return;
    const RationalPoint direction = Rational(1 / *sum) * apart;
    const bool beside = *sum == p.radius + q.radius, first = *sum > 0;
    if (!beside) inside_.push_back({(first ? b : a).of->instance, (first ? a : b).of->instance, direction});
    mark_direction(a, direction, p);
    mark_direction(b, Rational(beside ? -1 : 1) * direction, q);
  }

  /// Tubes side by side whose axes are not parallel: the point of contact is where a ruling of one crosses one of
  /// the other. From inside they would cross.
  void crossed_tubes(const Round& a, const Tube& p, const Round& b, const Tube& q) {
    const RationalPoint apart = q.foot - p.foot, turn = cross(p.axis, q.axis);
    const Rational across = cnrg::dot(apart, turn), square = cnrg::dot(turn, turn), sum = p.radius + q.radius;
    if (across * across != sum * sum * square) return;
    const RationalPoint direction = Rational(across / (sum * square)) * turn;
    // p.foot + s p.axis + sum direction = q.foot + t q.axis.
    const Rational s = cnrg::dot(cross(apart, q.axis), turn) / square,
                   t = cnrg::dot(cross(apart, p.axis), turn) / square;
    if (s < p.low || s > p.high || t < q.low || t > q.high) return;
    mark_direction(a, direction, p);
    mark_direction(b, Rational(-1) * direction, q);
  }

  // --- marks

  /// True if the leaf has a vertex there as it is.
  bool has_vertex(const Round& round, const RationalPoint& p) const {
    const auto* leaf = dynamic_cast<const GeometryLeaf*>(instances_[round.of->instance].leaf.get());
    if (leaf == nullptr) return false;
    const RationalPoint own = round.of->transform.inverse().apply(p);
    const Point3 rough = to_doubles(own);
    const Soup& soup = leaf->geometry();
    for (const PointId v : IdRange<PointId>(soup.point_count())) {
      const double* x = soup.xyz(v);
      if (std::abs(x[0] - rough[0]) + std::abs(x[1] - rough[1]) + std::abs(x[2] - rough[2]) >
          1e-9 * (std::abs(rough[0]) + std::abs(rough[1]) + std::abs(rough[2])))
        continue;
      if (exact_value(soup, v) == own) return true;
    }
    return false;
  }

  void mark_point(const Round& round, const RationalPoint& at) {
    Marks& marks = marks_[round.of->instance];
    if (std::find(marks.points.begin(), marks.points.end(), at) != marks.points.end()) return;
    marks.points.push_back(at);
    marks.needed = marks.needed || !has_vertex(round, at);
  }

  void mark_direction(const Round& round, const RationalPoint& direction, const Tube& tube) {
    Marks& marks = marks_[round.of->instance];
    if (std::find(marks.directions.begin(), marks.directions.end(), direction) != marks.directions.end()) return;
    marks.directions.push_back(direction);
    marks.needed = marks.needed ||
                   !has_vertex(round, tube.foot + tube.low * tube.axis + tube.radius * direction) ||
                   !has_vertex(round, tube.foot + tube.high * tube.axis + tube.radius * direction);
  }

  const std::vector<LeafInstance>& instances_;
  const Transform& to_space_;
  bool in_space_of_tree_;
  std::vector<Round> rounds_;
  std::map<Index, std::size_t> place_;
  std::map<Index, Marks> marks_;
  std::vector<std::array<Index, 2>> nested_;
  std::vector<Inside> inside_;
  std::map<CircleInSpace, std::set<HasCircle>> circles_;
};

}  // namespace

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
      const Box reach = box_of(*geometry, instance.transform);
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
