// Two boxes are parted by a plane across one of their six axes, or across both first axes, which parts long ones
// that pass each other. The other eight products of axes (Gottschalk, Lin, Manocha 1996) part little that matters.
#include "kernel/refine/oriented_box.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"

namespace cnrg {

namespace {

using Vector = DoubleVector;

double size(const Vector& a) { return std::fabs(a[0]) + std::fabs(a[1]) + std::fabs(a[2]); }
double sum_of(const Vector& a) { return a[0] + a[1] + a[2]; }

/// At unit length; false if that cannot be said.
bool normalize(Vector& a) {
  const double largest = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
  if (!(largest > 1e-290 && largest < 1e290)) return false;
  for (double& x : a) x /= largest;
  const double length = std::sqrt(dot(a, a));
  for (double& x : a) x /= length;
  return true;
}
void make_orthogonal(Vector& a, const Vector& unit) {
  const double along = dot(a, unit);
  for (std::size_t k = 0; k < 3; ++k) a[k] -= along * unit[k];
}
/// A unit vector across a unit vector.
Vector across(const Vector& unit) {
  Vector a{};
  a[static_cast<std::size_t>(
      std::min_element(unit.begin(), unit.end(), [](double x, double y) { return std::fabs(x) < std::fabs(y); }) -
      unit.begin())] = 1;
  for (int round = 0; round < 2; ++round) {
    make_orthogonal(a, unit);
    normalize(a);
  }
  return a;
}

Axes axes_of(const std::vector<Box>& points) {
  const auto farthest = [&](const Vector& from) {
    return std::max_element(points.begin(), points.end(),
                            [&](const Box& p, const Box& q) {
                              const Vector a = minus(p.lo, from), b = minus(q.lo, from);
                              return dot(a, a) < dot(b, b);
                            })
        ->lo;
  };
  const Vector begin = farthest(points.front().lo);
  Vector first = minus(farthest(begin), begin);
  if (!normalize(first)) return OrientedBox().axes;
  Vector second{};
  double widest = 0;
  for (const Box& p : points) {
    Vector a = minus(p.lo, begin);
    make_orthogonal(a, first);
    const double width = dot(a, a);
    if (width > widest) {
      widest = width;
      second = a;
    }
  }
  if (!normalize(second)) second = across(first);
  make_orthogonal(second, first);
  if (!normalize(second) || std::fabs(dot(second, first)) > 1e-15) second = across(first);
  return {first, second, cross(first, second)};
}

/// How far the box extends along a direction to each side of its centre.
double extent(const OrientedBox& box, const Vector& direction) {
  return std::fabs(dot(direction, box.axes[0])) * box.half[0] +
         std::fabs(dot(direction, box.axes[1])) * box.half[1] +
         std::fabs(dot(direction, box.axes[2])) * box.half[2];
}

/// An upper bound, infinite if it is none.
double at_least(double bound) { return bound <= std::numeric_limits<double>::max() ? bound : kInfinity; }

}  // namespace

OrientedBox upright(const Box& box) {
  OrientedBox out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.center[k] = box.lo[k] / 2 + box.hi[k] / 2;
    const double half = std::max(box.hi[k] - out.center[k], out.center[k] - box.lo[k]);
    out.half[k] = at_least(half + 1e-14 * half);
  }
  return out;
}

OrientedBox oriented_around(const std::vector<Box>& points) {
  OrientedBox out;
  out.axes = axes_of(points);
  out.center = points.front().lo;
  Vector low{}, high{};
  for (const Box& p : points) {
    const Vector d = minus(p.lo, out.center);
    for (std::size_t j = 0; j < 3; ++j) {
      const double s = dot(out.axes[j], d);
      low[j] = std::min(low[j], s);
      high[j] = std::max(high[j], s);
    }
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const double middle = low[j] / 2 + high[j] / 2;
    for (std::size_t k = 0; k < 3; ++k) out.center[k] += middle * out.axes[j][k];
  }
  for (const Box& p : points) {
    const Vector d = minus(p.lo, out.center), width = minus(p.hi, p.lo);
    for (std::size_t j = 0; j < 3; ++j) {
      const double far = std::fabs(dot(out.axes[j], d)) + 1e-14 * size(d) + (1 + 1e-14) * size(width);
      out.half[j] = std::max(out.half[j], at_least(far));
    }
  }
  return out;
}

OrientedBox around(const OrientedBox& a, const OrientedBox& b) {
  OrientedBox out;
  out.axes = a.half[0] >= b.half[0] ? a.axes : b.axes;
  const Vector t = minus(b.center, a.center);
  out.center = a.center;
  for (std::size_t j = 0; j < 3; ++j) {
    const double s = dot(out.axes[j], t), ea = extent(a, out.axes[j]), eb = extent(b, out.axes[j]);
    const double middle = std::min(-ea, s - eb) / 2 + std::max(ea, s + eb) / 2;
    for (std::size_t k = 0; k < 3; ++k) out.center[k] += middle * out.axes[j][k];
  }
  for (const OrientedBox* part : {&a, &b}) {
    const Vector d = minus(part->center, out.center);
    for (std::size_t j = 0; j < 3; ++j) {
      const double far =
          std::fabs(dot(out.axes[j], d)) + extent(*part, out.axes[j]) + 1e-14 * (size(d) + sum_of(part->half));
      out.half[j] = std::max(out.half[j], at_least(far));
    }
  }
  return out;
}

bool apart(const OrientedBox& a, const OrientedBox& b) {
  const Vector t = minus(b.center, a.center);
  const double slack = 1e-12 * (size(t) + sum_of(a.half) + sum_of(b.half)) + 1e-300;
  for (std::size_t j = 0; j < 3; ++j) {
    if (std::fabs(dot(a.axes[j], t)) > a.half[j] + extent(b, a.axes[j]) + slack) return true;
    if (std::fabs(dot(b.axes[j], t)) > b.half[j] + extent(a, b.axes[j]) + slack) return true;
  }
  const Vector both = cross(a.axes[0], b.axes[0]);
  return std::fabs(dot(both, t)) > extent(a, both) + extent(b, both) + slack;
}

}  // namespace cnrg
