// Distances between meridian lines about axes that are equal or nearly equal.
#include "csg/carriers/near_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "csg/carriers/meridians.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

constexpr double kNear = 1e-6;

double rounded_length(const RationalPoint& v) {
  double square = 0;
  for (const Rational& x : v) square += to_double(x) * to_double(x);
  return std::sqrt(square);
}

/// The radius of a straight piece where its axis has gone by t; t is between its ends, which differ.
Rational radius_at(const MeridianPiece& line, const Rational& t) {
  return line.from.r + (t - line.from.t) / (line.to.t - line.from.t) * (line.to.r - line.from.r);
}

struct Gap {
  const char* what;
  double apart, radius;
};

std::optional<Gap> between_lines(const MeridianPiece& p, const MeridianPiece& q, double axes, double near) {
  const auto far = [near](const Rational& x, const Rational& y) {
    const double a = to_double(x), b = to_double(y);
    return std::abs(a - b) > 2 * near * (a + b);
  };
  if (p.from.r == p.to.r && q.from.r == q.to.r && far(p.from.r, q.from.r)) return std::nullopt;
  const Rational low = std::max(std::min(p.from.t, p.to.t), std::min(q.from.t, q.to.t));
  const Rational high = std::min(std::max(p.from.t, p.to.t), std::max(q.from.t, q.to.t));
  if (low >= high) return std::nullopt;
  double apart = 0, radius = 0;
  for (const Rational& t : {low, high}) {
    const Rational a = radius_at(p, t), b = radius_at(q, t);
    apart = std::max(apart, std::abs(to_double(a - b)));
    radius = std::max({radius, to_double(a), to_double(b)});
  }
  const bool cylinders = p.from.r == p.to.r && q.from.r == q.to.r;
  return Gap{cylinders ? "cylinders" : "cones", apart + axes, radius};
}

/// Spheres of one axis or nearly so; `step` is the length of the axis' direction.
std::optional<Gap> between_balls(const PlacedForm& a, const MeridianPiece& p, const PlacedForm& b,
                                 const MeridianPiece& q) {
  if (p.middle.r != 0 || q.middle.r != 0) return std::nullopt;
  const RationalPoint first = a.axis.foot + p.middle.t * a.axis.direction,
                      second = b.axis.foot + q.middle.t * b.axis.direction;
  const double apart = rounded_length(first - second) + std::abs(to_double(p.radius - q.radius));
  return Gap{"spheres", apart, to_double(std::max(p.radius, q.radius))};
}

/// How far two axes are apart where the leaves are, at most.
double axes_apart(const PlacedForm& a, const PlacedForm& b) {
  if (a.axis == b.axis) return 0;
  double far = 0;
  const double first = rounded_length(a.axis.direction), second = rounded_length(b.axis.direction);
  for (const auto& line : a.lines) {
    for (const MeridianPiece& piece : line) {
      for (const Rational& t : {piece.from.t, piece.to.t}) {
        const RationalPoint off = a.axis.foot + t * a.axis.direction - b.axis.foot;
        far = std::max(far, rounded_length(cross(off, b.axis.direction)) / second);
      }
    }
  }
  return far + rounded_length(cross(a.axis.direction, b.axis.direction)) / first / second * far;
}

/// True if `holds` is true of a piece of one and a piece of the other; no more are asked then.
template <class Holds>
bool any_two(const PlacedForm& a, const PlacedForm& b, const Holds& holds) {
  for (const auto& line : a.lines) {
    for (const MeridianPiece& p : line) {
      for (const auto& other : b.lines) {
        for (const MeridianPiece& q : other) {
          if (holds(p, q)) return true;
        }
      }
    }
  }
  return false;
}

bool slanted(const MeridianPiece& piece) { return piece.kind == MeridianPiece::Kind::line && !piece.flat(); }

}  // namespace

bool touch(const PlacedForm& a, const PlacedForm& b) {
  return any_two(a, b, [square = a.square()](const MeridianPiece& p, const MeridianPiece& q) {
    const MeridianContact found = contact(p, q, square);
    return found.joins || !found.points.empty();
  });
}

bool sides_near(const PlacedForm& a, const PlacedForm& b, double near) {
  return any_two(a, b, [near](const MeridianPiece& p, const MeridianPiece& q) {
    if (!slanted(p) || !slanted(q)) return false;
    const auto is_near = [&](double apart, double radius) { return apart <= near * radius; };
    for (const MeridianPoint& end : {p.from, p.to}) {
      for (const MeridianPoint& other : {q.from, q.to}) {
        if (end.t == other.t && is_near(std::abs(to_double(end.r - other.r)), to_double(std::max(end.r, other.r))))
          return true;
      }
    }
    const auto gap = between_lines(p, q, 0, near);
    return gap && is_near(gap->apart, gap->radius);
  });
}

std::vector<NearSurfaces> near_surfaces(const std::vector<LeafInstance>& instances,
                                        const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  std::map<std::uint32_t, std::optional<PlacedForm>> placed;
  const auto placed_of = [&](std::uint32_t i) -> const std::optional<PlacedForm>& {
    const auto [it, fresh] = placed.try_emplace(i);
    const auto* form = dynamic_cast<const RevolvedForm*>(instances[i].leaf->form().get());
    if (!fresh || form == nullptr) return it->second;
    if (const auto scale = stretch(instances[i].transform))
      it->second = place(*form, instances[i].transform, *scale);
    return it->second;
  };
  std::vector<NearSurfaces> result;
  for (const auto& [i, j] : pairs) {
    const auto &a = placed_of(i), &b = placed_of(j);
    if (!a || !b) continue;
    const double axes = axes_apart(*a, *b);
    // Places along two axes compare only if these have one direction; where they have not, spheres still do.
    const bool parallel = a->axis.direction == b->axis.direction;
    NearSurfaces found{std::min(i, j), std::max(i, j), "", 0};
    any_two(*a, *b, [&](const MeridianPiece& p, const MeridianPiece& q) {
      std::optional<Gap> gap;
      using Kind = MeridianPiece::Kind;
      if (slanted(p) && slanted(q) && parallel) gap = between_lines(p, q, axes, kNear);
      if (p.kind == Kind::arc && q.kind == Kind::arc) gap = between_balls(*a, p, *b, q);
      if (gap && gap->apart != 0 && gap->apart <= kNear * gap->radius && gap->apart >= found.apart) {
        found.what = gap->what;
        found.apart = gap->apart;
      }
      return false;
    });
    if (found.apart > 0) result.push_back(found);
  }
  return result;
}

}  // namespace cnrg
