// A direction is tried for the whole ray. Boxes choose the faces that it may hit; signs of determinants with the
// origin, a point ahead on the ray and a point aside tell for each if the ray passes through its interior. If any
// sign is zero the direction is not generic, and the next one is tried. Hits are sorted by enclosures of their
// parameters on the ray, exactly where these overlap.
#include "kernel/complex/ray.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

namespace {

/// Directions with large, unrelated components; the first leans towards x.
std::array<double, 3> direction_of(unsigned attempt) {
  std::uint64_t state = 0x853c49e6748fea9bull + attempt * 0x9e3779b97f4a7c15ull;
  const auto next = [&] {
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return static_cast<double>((state * 0x2545f4914f6cdd1dull) >> 44) - 524287.5;  // 20 bits, never zero
  };
  const double y = next(), z = next(), x = next();
  return {attempt == 0 ? 4194301.0 + std::fabs(x) : 2 * x, y, z};
}

ExactPoint offset(const ExactPoint& p, const std::array<double, 3>& d) {
  const auto twice = [](double v) { return Integer(2 * v); };  // components are halves of integers
  ExactPoint q;
  q.x = 2 * p.x + twice(d[0]) * p.w;
  q.y = 2 * p.y + twice(d[1]) * p.w;
  q.z = 2 * p.z + twice(d[2]) * p.w;
  q.w = 2 * p.w;
  return q;
}

/// False only if the ray certainly misses the box. Each quotient is good to a few roundings; widening by 1e-14 of
/// its size covers them. A NaN (overflow) counts as a hit.
bool may_meet(const Box& box, const PointView& p, const std::array<double, 3>& d) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double to_lo = box.lo[k] - p.hi[k], to_hi = box.hi[k] - p.lo[k];
    double near = (d[k] > 0 ? to_lo : to_hi) / d[k], far = (d[k] > 0 ? to_hi : to_lo) / d[k];
    near -= std::fabs(near) * 1e-14;
    far += std::fabs(far) * 1e-14;
    if (near > enter) enter = near;
    if (far < leave) leave = far;
  }
  return !(enter > leave);
}

/// Where a point certainly lies, in bits: to the left or to the right of the ray's line as seen along z (1, 2) and
/// along y (4, 8); behind the origin in x (16). The ray misses the hull of points that have a bit in common.
///
/// The side is the sign of (v_k - p_k) d_x - (v_x - p_x) d_k for k = y, z. Differences and products are good to a
/// relative 2^-53 each, so the bounds of the terms are off by less than 3 * 2^-53 of their sizes and their
/// difference by less than 4 * 2^-53 of the sum of sizes; 1e-15 is 9 * 2^-53. Components of d are 1/2 or more, so
/// underflow in a product adds less than the least normal number. A NaN or an overflow proves nothing.
unsigned place(const PointView& v, const PointView& p, const std::array<double, 3>& d) {
  struct Range {
    double lo, hi;
    double size() const { return std::max(std::fabs(lo), std::fabs(hi)); }
  };
  const auto term = [&](int axis, double factor) {
    const double lo = (v.lo[axis] - p.hi[axis]) * factor, hi = (v.hi[axis] - p.lo[axis]) * factor;
    return factor > 0 ? Range{lo, hi} : Range{hi, lo};
  };
  unsigned bits = (d[0] > 0 ? v.hi[0] < p.lo[0] : v.lo[0] > p.hi[0]) ? 16 : 0;
  for (int k = 1; k < 3; ++k) {
    const Range across = term(k, d[0]), along = term(0, d[k]);
    const double error = 1e-15 * (across.size() + along.size()) + std::numeric_limits<double>::min();
    if (across.lo - along.hi > error) bits |= k == 1 ? 1 : 4;
    if (along.lo - across.hi > error) bits |= k == 1 ? 2 : 8;
  }
  return bits;
}

/// The parameter of the hit along the ray, exactly.
Rational exact_parameter(const PointTable& t, PlaneId plane, const ExactPoint& origin,
                         const std::array<double, 3>& d) {
  const ExactPlane& e = t.exact_plane(plane);
  const Rational along =
      Rational(e.a) * from_double(d[0]) + Rational(e.b) * from_double(d[1]) + Rational(e.c) * from_double(d[2]);
  Rational height(e.a * origin.x + e.b * origin.y + e.c * origin.z + e.d * origin.w, origin.w);
  height.canonicalize();
  return -height / along;
}

}  // namespace

RayCaster::RayCaster(const Complex& complex, bool with_tree) : c_(complex) {
  if (!with_tree) return;
  std::vector<Box> boxes(c_.face_count());
  for_each_index(boxes.size(), [&](std::size_t f) { boxes[f] = box(FaceId(f)); });
  tree_ = std::make_unique<BoxTree>(std::move(boxes));
}

Box RayCaster::box(FaceId f) const {
  Box box;
  for (const HalfEdge h : c_.loop[c_.face_loops[f].front()]) {
    const PointView p = c_.points.view(c_.origin(h));
    box.extend(p.lo, p.hi);
  }
  return box;
}

/// Calls look(f) for all faces that the ray may hit.
template <class Look>
void RayCaster::look_along(const PointView& p, const std::array<double, 3>& d, const Look& look) const {
  if (tree_ != nullptr) {
    return tree_->query([&](const Box& box) { return may_meet(box, p, d); },
                        [&](std::uint32_t i) { look(FaceId(i)); });
  }
  std::vector<std::uint8_t> places(c_.points.size());
  for_each_index(places.size(), [&](std::size_t v) {
    places[v] = static_cast<std::uint8_t>(place(c_.points.view(VertexId(v)), p, d));
  });
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    unsigned common = 31;
    for (const HalfEdge h : c_.loop[c_.face_loops[f].front()]) common &= places[c_.origin(h).index()];
    if (common == 0 && may_meet(box(f), p, d)) look(f);
  }
}

HalfFace RayCaster::leaving(FaceId f, const Ray& ray) const {
  const int s = normal_dot_sign(c_.points, c_.plane(f), ray.direction);
  require(s != 0, "a ray runs along its own face");
  return HalfFace(f, s > 0 ? 0 : 1);
}

RayCaster::Ray RayCaster::cast(const ExactPoint& origin, FaceId own, const std::vector<char>& accept) const {
  const PointView p = view_of(origin);
  for (unsigned attempt = 0; attempt < 1000; ++attempt) {
    Ray ray;
    ray.direction = direction_of(attempt);
    if (try_cast(p, ray.direction, attempt, own, accept, ray.hits)) return ray;
  }
  throw InvariantError("no direction of a thousand misses all edges");
}

bool RayCaster::try_cast(const PointView& p, const std::array<double, 3>& d, unsigned attempt, FaceId own,
                         const std::vector<char>& accept, std::vector<HalfFace>& hits) const {
  const PointTable& t = c_.points;
  const ExactPoint end = offset(p.exact(), d), aside = offset(p.exact(), direction_of(attempt + 5000));
  const PointView q = view_of(end), r = view_of(aside);
  struct Hit {
    HalfFace half_face;
    double lo, hi;
  };
  std::vector<Hit> found;
  bool degenerate = false;
  if (own.valid() && normal_dot_sign(t, c_.plane(own), d) == 0) return false;

  const auto look = [&](FaceId f) {
    if (degenerate || f == own || (!accept.empty() && accept[f.index()] == 0)) return;
    const PlaneId plane = c_.plane(f);
    const int towards = normal_dot_sign(t, plane, d), side = side_of_plane(t, plane, p);
    if (towards == 0) {
      degenerate = degenerate || side == 0;
      return;
    }
    if (side * towards > 0) return;  // behind the origin
    // The face as seen along the line: does it hold the point to which the line projects? The half plane through
    // the line and r is the axis across which sides of loops are counted.
    bool inside = false;
    for (const LoopId loop : c_.face_loops[f]) {
      const auto walk = c_.loop[loop];
      int last_level = orient3d(p, q, r, t.view(c_.origin(walk.front())));
      for (const HalfEdge h : walk) {
        const VertexId v = c_.target(h);
        const int level = orient3d(p, q, r, t.view(v));
        if (level == 0) {
          degenerate = true;
          return;
        }
        const VertexId from = c_.origin(h);
        const int from_level = last_level;
        last_level = level;
        if (from_level == level) continue;
        const int turn = orient3d(p, q, t.view(from), t.view(v));
        if (turn == 0) {
          degenerate = true;
          return;
        }
        if (turn == level) inside = !inside;
      }
    }
    for (const VertexId v : c_.face_vertices[f]) {
      if (orient3d(p, q, r, t.view(v)) == 0) {
        degenerate = true;
        return;
      }
    }
    if (!inside) return;
    if (side == 0) {
      degenerate = true;  // the origin lies in this face: not asked for
      return;
    }
    const Rational at = exact_parameter(t, plane, p.exact(), d);
    const double approximate = to_double(at);
    found.push_back({HalfFace(f, towards > 0 ? 1 : 0), std::nextafter(approximate, -INFINITY),
                     std::nextafter(approximate, INFINITY)});
  };
  look_along(p, d, look);
  if (degenerate) return false;
  std::sort(found.begin(), found.end(), [&](const Hit& a, const Hit& b) {
    if (a.hi < b.lo) return true;
    if (b.hi < a.lo) return false;
    if (a.half_face == b.half_face) return false;
    return exact_parameter(t, c_.plane(a.half_face.face()), p.exact(), d) <
           exact_parameter(t, c_.plane(b.half_face.face()), p.exact(), d);
  });
  hits.clear();
  for (const Hit& h : found) hits.push_back(h.half_face);
  return true;
}

}  // namespace cnrg
