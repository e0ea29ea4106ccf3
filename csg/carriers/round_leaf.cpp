// The parts of a leaf that may touch other leaves, and bounds in doubles for where they cannot.
#include "csg/carriers/round_leaf.h"

#include <algorithm>
#include <cmath>

#include "csg/carriers/axes.h"
#include "csg/carriers/meridians.h"
#include "csg/curves/surface_math.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

// Whether a point, a segment or a circle of a plane is in a part of it.

/// On the line through a and b, between them or one of them.
bool on_segment(const RationalPoint& a, const RationalPoint& b, const RationalPoint& p) {
  return is_zero(cross(b - a, p - a)) && cnrg::dot(p - a, p - b) <= 0;
}

using Point3 = RoundLeaf::Point3;
using surface_math::difference;

double size_of(const Point3& p) { return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]); }

}  // namespace

bool Flat::meets(const RationalPoint& p, const RationalPoint& q) const {
  if (squares) {
    // The nearest point of the segment, and the farther one of its ends.
    const RationalPoint way = q - p;
    const Rational whole = dot(way, way);
    Rational part = whole == 0 ? Rational(0) : Rational(dot(center - p, way) / whole);
    part = std::max(Rational(0), std::min(Rational(1), part));
    const RationalPoint nearest = p + part * way - center;
    const Rational low = dot(nearest, nearest),
                   high = std::max(dot(p - center, p - center), dot(q - center, q - center));
    return low <= (*squares)[1] && high >= (*squares)[0];
  }
  return loops.empty() || polygon_meets(p, q);
}

bool Flat::meets_circle(const RationalPoint& middle, const Rational& radius) const {
  if (squares) {
    // Circles of radii r and s that are d apart have a point in common for |r - s| <= d <= r + s; of a ring all
    // radii count from the inner to the outer one.
    const RationalPoint off = middle - center;
    const double apart = std::sqrt(to_double(dot(off, off))), r = to_double(radius),
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
      outside = outside || dot(a - middle, a - middle) >= square;
      Rational part = dot(middle - a, way) / dot(way, way);
      part = std::max(Rational(0), std::min(Rational(1), part));
      const RationalPoint nearest = a + part * way - middle;
      inside = inside || dot(nearest, nearest) <= square;
    }
  }
  return inside && outside;
}

bool Flat::polygon_meets(const RationalPoint& p, const RationalPoint& q) const {
  // The side of c as seen from a to b.
  const auto side = [&](const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
    return sgn(dot(cross(b - a, c - a), normal));
  };
  // A ray from p along the plane, across a direction that no corner lies in, would do; here it is counted how
  // often the loops wind around p, along the largest two axes of the plane.
  const std::size_t x = steepest_axis(normal), y = (x + 1) % 3, z = (x + 2) % 3;
  bool odd = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const RationalPoint &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if (on_segment(a, b, p) || on_segment(a, b, q)) return true;
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

bool nearly(double a, double b, double size) {
  return !(std::abs(a - b) > 1e-6 * (size + std::abs(a) + std::abs(b)));
}

template <class Flats, class Arcs, class Tubes, class Slants>
void RoundLeaf::each_piece(const std::vector<std::vector<MeridianPiece>>& lines, const Flats& flat,
                           const Arcs& arc, const Tubes& tube, const Slants& slant) const {
  for (const auto& line : lines) {
    for (const MeridianPiece& piece : line) {
      if (piece.flat()) flat(piece.from.t, piece.from.r, piece.to.r);
      if (piece.kind == MeridianPiece::Kind::arc) arc(piece);
      if (piece.kind != MeridianPiece::Kind::line || piece.flat()) continue;
      if (piece.from.r != piece.to.r) slant(piece);
      else if (piece.from.r > 0) tube(piece);
    }
    if (!form_->discs) continue;
    flat(line.front().from.t, 0, line.front().from.r);
    flat(line.back().to.t, 0, line.back().to.r);
  }
}

RoundLeaf::RoundLeaf(const RevolvedInstance& of, const RevolvedForm& form) : of_(&of), form_(&form) {
  const Transform& transform = of.transform;
  const Point3 center = to_doubles(transform.apply(form.center)),
               step = to_doubles(transform.apply_to_vector(form.axis));
  double scale = 0;
  for (const Rational& x : transform.linear[0]) scale += to_double(x) * to_double(x);
  scale = std::sqrt(scale);
  along_ = surface_math::scaled(1 / length(step), step);
  const auto at = [&](const Rational& t) {
    return surface_math::sum(center, surface_math::scaled(to_double(t), step));
  };
  each_piece(
      form.lines,
      [&](const Rational& t, const Rational&, const Rational&) {
        flats_.push_back(surface_math::dot(at(t), along_));
      },
      [&](const MeridianPiece& arc) {
        const Point3 middle = at(arc.middle.t);
        const double radius = scale * to_double(arc.radius);
        balls_.emplace_back(middle, radius);
        if (arc.middle.r > 0) rings_.emplace_back(middle, scale * to_double(arc.middle.r), radius);
      },
      [&](const MeridianPiece& tube) { tubes_.emplace_back(center, scale * to_double(tube.from.r)); },
      [&](const MeridianPiece& slant) {
        slants_.push_back({std::pair(at(slant.from.t), scale * to_double(slant.from.r)),
                           std::pair(at(slant.to.t), scale * to_double(slant.to.r))});
      });
}

bool RoundLeaf::make_exact() {
  if (exact_) return true;
  const std::optional<Rational> scale = stretch(transform());
  if (!scale) return false;
  Exact& exact = exact_.emplace();
  exact.placed = place(*form_, transform(), *scale);
  const AxisLine& axis = exact.placed.axis;
  each_piece(
      exact.placed.lines,
      [&](const Rational& t, const Rational& r, const Rational& s) {
        const RationalPoint at = axis.foot + t * axis.direction;
        const auto [low, high] = std::minmax(r, s);
        const std::array<Rational, 2> squares{low * low, high * high};
        exact.flats.push_back({axis.direction, dot(axis.direction, at), {}, at, squares});
      },
      [&](const MeridianPiece& arc) {
        exact.rings.push_back({arc.middle, arc.radius});
        if (arc.middle.r == 0) exact.balls.push_back({axis.foot + arc.middle.t * axis.direction, arc.radius});
      },
      [&](const MeridianPiece& tube) {
        exact.tubes.push_back({axis.foot, axis.direction, tube.from.r, std::min(tube.from.t, tube.to.t),
                               std::max(tube.from.t, tube.to.t)});
      },
      [&](const MeridianPiece& slant) {
        exact.slants.push_back({slant.from, slant.to});
      });
  return true;
}

bool RoundLeaf::may_touch(const Point3& normal, double offset) const {
  const auto is_near = [&](const std::pair<Point3, double>& of) {
    return nearly(std::abs(surface_math::dot(normal, of.first) - offset), of.second, size_of(of.first));
  };
  if (std::any_of(balls_.begin(), balls_.end(), is_near) || std::any_of(tubes_.begin(), tubes_.end(), is_near))
    return true;
  const double sine = length(surface_math::cross(normal, along_));
  const auto gap = [&](const Point3& p) { return std::abs(surface_math::dot(normal, p) - offset); };
  for (const auto& [p, r, tube] : rings_) {
    const double size = size_of(p) + r + tube;  // a gap may be nothing but rounding
    if (nearly(gap(p), r * sine + tube, size) || nearly(gap(p), std::abs(r * sine - tube), size)) return true;
  }
  return std::any_of(slants_.begin(), slants_.end(), [&](const auto& ends) {
    const auto& [from, to] = ends;
    const double size = size_of(from.first) + size_of(to.first) + from.second + to.second;
    return nearly(gap(from.first), from.second * sine, size) && nearly(gap(to.first), to.second * sine, size);
  });
}

bool RoundLeaf::may_touch_beside(const RoundLeaf& b) const {
  const auto apart = [&](double distance, double sum, const Point3& p) {
    return nearly(distance, sum, size_of(p));
  };
  for (const auto& [p, r, tube] : rings_) {
    for (const auto& [q, s] : b.balls_) {
      const Point3 off = difference(q, p);
      const double up = surface_math::dot(off, along_), out = length(surface_math::cross(off, along_));
      if (apart(hypotenuse(out - r, up), tube + s, p)) return true;
    }
    for (const auto& [q, s] : b.tubes_) {
      const Point3 off = difference(q, p), turn = surface_math::cross(along_, b.along_);
      const double sine = length(turn), out = length(surface_math::cross(off, b.along_));
      if (sine < 1e-3) {
        for (const double of : {r + tube, std::abs(r - tube)}) {
          if (apart(out, of + s, p) || apart(out, std::abs(of - s), p)) return true;
        }
        continue;
      }
      if (std::abs(surface_math::dot(along_, b.along_)) < 1e-6 &&
          apart(std::abs(surface_math::dot(off, along_)), tube + s, p))
        return true;
      for (const int side : {1, -1}) {
        const Point3 middle = surface_math::sum(p, surface_math::scaled(side * r / sine, turn));
        if (apart(length(surface_math::cross(difference(q, middle), b.along_)), tube + s, p)) return true;
      }
    }
    for (const auto& [q, s, other] : b.rings_) {
      if (apart(length(difference(q, p)), r + tube + s + other, p)) return true;
    }
  }
  for (const auto& [from, to] : slants_) {
    const double rise = surface_math::dot(difference(to.first, from.first), along_),
                 wide = to.second - from.second;
    for (const auto& [q, s] : b.balls_) {
      const Point3 off = difference(q, from.first);
      const double up = surface_math::dot(off, along_),
                   out = length(surface_math::cross(off, along_)) - from.second;
      if (apart(std::abs(out * rise - up * wide) / hypotenuse(rise, wide), s, q)) return true;
    }
  }
  return false;
}

/// A meridian of this leaf; all around the axis of b, in a ball of it, or a meridian of it, too.
bool RoundLeaf::may_share_circle(const RoundLeaf& b) const {
  const double turn = surface_math::dot(along_, b.along_);
  for (const auto& [p, r, tube] : rings_) {
    for (const auto& [q, s] : b.balls_) {
      const Point3 apart = difference(q, p);
      if (nearly(length(apart), r, size_of(p))) return true;
    }
    for (const auto& [q, s] : b.tubes_) {
      const Point3 out = surface_math::cross(difference(p, q), b.along_);
      if (std::abs(turn) < 1e-6 && nearly(length(out), r, size_of(p))) return true;
    }
    for (const auto& [q, s, other] : b.rings_) {
      const Point3 across = surface_math::cross(along_, b.along_), apart = difference(q, p);
      const double distance = length(apart);
      if (!is_near(from_double(tube), from_double(other))) continue;
      if (surface_math::dot(across, across) > 1e-6
              ? nearly(surface_math::dot(apart, across), 0, size_of(p) + size_of(q))
              : nearly(distance, r + s, size_of(p)) || nearly(distance, std::abs(r - s), size_of(p)))
        return true;
    }
  }
  return false;
}
bool RoundLeaf::may_touch(const RoundLeaf& b) const {
  for (const double offset : b.flats_) {
    if (may_touch(b.along_, offset)) return true;
  }
  for (const double offset : flats_) {
    if (b.may_touch(along_, offset)) return true;
  }
  const auto may_be = [](double distance, double r, double s, double size) {
    return nearly(distance, r + s, size) || nearly(distance, std::abs(r - s), size);
  };
  const auto across = [](const Point3& p, const Point3& foot, const Point3& along) {
    const Point3 off = difference(p, foot), out = surface_math::cross(off, along);
    return length(out);
  };
  if (may_share_circle(b) || b.may_share_circle(*this) || may_touch_beside(b) || b.may_touch_beside(*this))
    return true;
  for (const auto& [p, r] : balls_) {
    for (const auto& [q, s] : b.balls_) {
      const Point3 apart = difference(p, q);
      if (may_be(length(apart), r, s, size_of(p))) return true;
    }
    for (const auto& [q, s] : b.tubes_) {
      if (may_be(across(p, q, b.along_), r, s, size_of(p))) return true;
    }
  }
  for (const auto& [p, r] : tubes_) {
    for (const auto& [q, s] : b.balls_) {
      if (may_be(across(q, p, along_), r, s, size_of(p))) return true;
    }
    for (const auto& [q, s] : b.tubes_) {
      const Point3 turn = surface_math::cross(along_, b.along_), apart = difference(q, p);
      const double sine = length(turn);
      const double between = std::abs(surface_math::dot(apart, turn)) / sine, size = size_of(p) + size_of(q);
      if (sine < 1e-3 ? may_be(across(q, p, along_), r, s, size_of(p))
                      : nearly(between, r + s, size) || nearly(between, std::abs(r - s), size))
        return true;
    }
  }
  return false;
}

bool RoundLeaf::covers(const RationalPoint& direction) const {
  const PlacedForm& placed = exact_->placed;
  const bool with = placed.along != placed.mirrored;
  const Sector turn{with ? placed.start : placed.end, with ? placed.end : placed.start, form_->around()};
  return overlap(turn, {direction, direction, false}, placed.axis.direction);
}

bool RoundLeaf::holds(const MeridianPoint& p, const RationalPoint& direction) const {
  const PlacedForm& placed = exact_->placed;
  const auto has = [&](const MeridianPiece& piece) { return on_piece(piece, p, placed.square()); };
  return p.r > 0 && covers(direction) &&
         std::any_of(placed.lines.begin(), placed.lines.end(),
                     [&](const auto& line) { return std::any_of(line.begin(), line.end(), has); });
}

std::optional<Rational> RoundLeaf::radius_near(const MeridianPoint& p) const {
  const Rational square = exact_->placed.square();
  std::optional<Rational> near;
  for (const auto& line : exact_->placed.lines) {
    for (const MeridianPiece& piece : line) {
      const Rational r = p.r - piece.middle.r, t = p.t - piece.middle.t;
      if (piece.kind == MeridianPiece::Kind::arc && r * r + square * t * t == piece.radius * piece.radius)
        return p.r;
      const bool along = piece.kind == MeridianPiece::Kind::line && piece.from.r == piece.to.r &&
                         (p.t - piece.from.t) * (p.t - piece.to.t) <= 0;
      for (const MeridianPoint& end : {piece.from, piece.to}) {
        if ((along || end.t == p.t) && is_near(end.r, p.r) && (!near || abs(end.r - p.r) < abs(*near - p.r)))
          near = end.r;
      }
    }
  }
  return near;
}

}  // namespace cnrg
