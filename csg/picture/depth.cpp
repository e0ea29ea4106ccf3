// Bounds are intervals, rounded outward.
#include "csg/picture/depth.h"

#include <cmath>

#include "kernel/base/limits.h"
#include "kernel/exact/enclosure.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using enclosure::Interval;
using enclosure::Interval3;

/// What surely holds the number.
Interval around(const Rational& x) {
  const double near = to_double(x);
  if (is_double(x)) return Interval(near);
  return Interval(std::nextafter(near, -kInfinity), std::nextafter(near, kInfinity));
}
Interval3 around(const RationalPoint& p) { return {around(p[0]), around(p[1]), around(p[2])}; }

/// The sum over the loop's corners; it points to where the loop is seen counter-clockwise.
RationalPoint normal_of(const Scene& scene, const Scene::Loop& loop) {
  const RationalPoint& o = scene.points[loop.front()];
  RationalPoint out{0, 0, 0};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const RationalPoint c = cross(scene.points[loop[i]] - o, scene.points[loop[i + 1]] - o);
    for (std::size_t k = 0; k < 3; ++k) out[k] += c[k];
  }
  return out;
}
Interval3 bounds_of_normal(const Scene& scene, const Scene::Loop& loop) {
  std::vector<Interval3> corners;
  for (const Scene::Index p : loop) corners.push_back(around(scene.points[p]));
  const enclosure::RoundOutward protect;
  const Interval3& o = corners.front();
  Interval3 out{Interval(0), Interval(0), Interval(0)};
  Interval3 before = enclosure::operator-(corners[1], o);
  for (std::size_t i = 2; i < loop.size(); ++i) {
    const Interval3 next = enclosure::operator-(corners[i], o);
    const Interval3 c = enclosure::cross(before, next);
    for (std::size_t k = 0; k < 3; ++k) out[k] += c[k];
    before = next;
  }
  return out;
}

}  // namespace

std::optional<Depth> Depth::of_facet(const Scene& scene, const Scene::Facet& facet, Facing& facing) {
  Depth out(scene, facet.loops.front().front());
  out.facet_ = &facet;
  const Interval3 n = bounds_of_normal(scene, facet.loops.front());
  int sign = enclosure::sign_of(n[2]);
  if (sign == 1 || sign == -1) {
    const enclosure::RoundOutward protect;
    for (std::size_t k = 0; k < 2; ++k) {
      const Interval slope = -n[k] / n[2];
      out.slope_[k] = {slope.inf(), slope.sup()};
    }
  } else {
    sign = sgn(normal_of(scene, facet.loops.front())[2]);
    out.slope_ = {Bounds{-kInfinity, kInfinity}, Bounds{-kInfinity, kInfinity}};
  }
  facing = sign > 0 ? Facing::front : sign < 0 ? Facing::back : Facing::edge_on;
  if (sign == 0) return std::nullopt;
  return out;
}

std::optional<Depth> Depth::of_segment(const Scene& scene, const Scene::Segment& segment) {
  const RationalPoint &p = scene.points[segment.ends[0]], &q = scene.points[segment.ends[1]];
  if (p[0] == q[0] && p[1] == q[1]) return std::nullopt;
  Depth out(scene, segment.ends[0]);
  out.segment_ = &segment;
  const std::size_t k = p[0] != q[0] ? 0 : 1;
  const Interval3 a = around(p), b = around(q);
  const enclosure::RoundOutward protect;
  const Interval slope = (b[2] - a[2]) / (b[k] - a[k]);
  out.slope_[k] = {slope.inf(), slope.sup()};
  return out;
}

Depth::Depth(const Scene& scene, Scene::Index origin) : scene_(&scene), origin_(origin) {
  const Interval3 o = around(scene.points[origin]);
  for (std::size_t k = 0; k < 3; ++k) start_[k] = {o[k].inf(), o[k].sup()};
}

Depth::Exact Depth::exact() const {
  const RationalPoint& p = scene_->points[origin_];
  Rational a = 0, b = 0;
  if (facet_ != nullptr) {
    const RationalPoint n = normal_of(*scene_, facet_->loops.front());
    a = -n[0] / n[2];
    b = -n[1] / n[2];
  } else if (segment_ != nullptr) {
    const RationalPoint& q = scene_->points[segment_->ends[1]];
    const std::size_t k = p[0] != q[0] ? 0 : 1;
    (k == 0 ? a : b) = (q[2] - p[2]) / (q[k] - p[k]);
  }
  Rational c = p[2] - a * p[0] - b * p[1];
  return {std::move(a), std::move(b), std::move(c)};
}

int Depth::compare(const Depth& other, const std::array<Bounds, 2>& place) const {
  const enclosure::RoundOutward protect;
  const auto z = [&](const Depth& d) {
    Interval out(d.start_[2].low, d.start_[2].high);
    for (std::size_t k = 0; k < 2; ++k) {
      const Interval slope(d.slope_[k].low, d.slope_[k].high);
      out += slope * (Interval(place[k].low, place[k].high) - Interval(d.start_[k].low, d.start_[k].high));
    }
    return out;
  };
  const int sign = enclosure::sign_of(z(*this) - z(other));
  return sign == kUndecided ? 0 : sign;
}

int Depth::compare(const Depth& other, const ExactPoint& place) const {
  const Exact a = exact(), b = other.exact();
  return sgn((a.a - b.a) * place.x + (a.b - b.b) * place.y + (a.c - b.c) * place.w);
}

}  // namespace cnrg
