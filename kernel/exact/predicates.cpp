// The stages of each predicate. A filter decides when |approximation| exceeds a bound that is proven here.
//
// Bounds. Let u = 2^-53. A difference of two doubles is rounded once: d' = d (1 + e), |e| <= u.
//   orient3d: the 3x3 determinant of differences, expanded as six products of three. Each product carries three
//   roundings from differences, two from products and at most three from sums (one inside its 2x2 minor, at most
//   two outside): relative error at most (1 + u)^8 - 1 < 8.1 u.
//   With M = mx my mz, the product of the largest absolute (rounded) differences per axis, each of the six terms
//   is at most M (1 + u)^3, so the error is below 6 * 8.1 u * 1.0001 M < 48.7 u M < 5.41e-15 M. We use 6e-15 M,
//   which also covers the two roundings of computing the bound itself.
//   orient2d: see cross_filter.h.
//   Points that are not doubles: let each coordinate lie within w above the lower bound that the filter takes.
//   Each of the exact differences is then off by at most w: the product of two by w (|x| + |y|) + w^2, the product
//   of three by w (|xy| + |yz| + |zx|) + w^2 (|x| + |y| + |z|) + w^3. With two (six) such products the errors of
//   the determinants are at most 2 w (mx + my + w) and 6 w (mx my + my mz + mz mx + w (mx + my + mz + w)); we
//   use 2.1 and 6.1 for the roundings of these. Underflow: a product that underflows adds an absolute error of at
//   most 2^-1074 per operation, which the guard on the smallest maximum (each at least 1e-90) makes negligible
//   against the slack of the constants. Overflow: the guard on the largest maximum (at most 1e100) excludes it.
#include "kernel/exact/predicates.h"

#include "kernel/base/error.h"
#include "kernel/base/per_thread.h"
#include "kernel/exact/cross_filter.h"
#include "kernel/exact/determinant_sum.h"
#include "kernel/exact/enclosure.h"
#include "kernel/exact/plane_filter.h"

namespace cnrg {

using namespace enclosure;

namespace {

constexpr double kOrient3dBound = 6e-15;
constexpr double kSmallest = kSmallestFiltered;
constexpr double kLargest = kLargestFiltered;

StageCounts& counts() { return PerThread<StageCounts>::own(); }

/// A sign by the first stage that decides it: a filter's, or else that of intervals, or else the exact one.
template <class Enclosed, class Exact>
int in_stages(int filtered, const Enclosed& enclosed, const Exact& exact) {
  if (filtered != kUndecided) {
    ++counts().filter;
    return filtered;
  }
  {
    RoundOutward round;
    if (const int s = enclosed(); s != kUndecided) {
      ++counts().interval;
      return s;
    }
  }
  ++counts().exact;
  return exact();
}

inline double max_abs(double a, double b, double c) {
  return std::max(std::fabs(a), std::max(std::fabs(b), std::fabs(c)));
}

/// The sign by the filter, or kUndecided. Each exact coordinate lies between the one given and `width` above it.
int filtered_orient3d(const double* a, const double* b, const double* c, const double* d, double width) {
  const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  const double mx = max_abs(bx, cx, dx), my = max_abs(by, cy, dy), mz = max_abs(bz, cz, dz);
  // A maximum of zero is exact: all differences vanish (a double difference is zero only if it is exactly).
  if (width == 0 && (mx == 0 || my == 0 || mz == 0)) return 0;
  const double smallest = std::min(mx, std::min(my, mz)), largest = std::max(mx, std::max(my, mz));
  if (!(smallest > kSmallest && largest < kLargest)) return kUndecided;
  const double determinant = dx * (by * cz - bz * cy) + dy * (bz * cx - bx * cz) + dz * (bx * cy - by * cx);
  const double bound =
      kOrient3dBound * mx * my * mz + 6.1 * width * (mx * my + my * mz + mz * mx + width * (mx + my + mz + width));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return kUndecided;
}

double width(const PointView& p) {
  return std::max(p.hi[0] - p.lo[0], std::max(p.hi[1] - p.lo[1], p.hi[2] - p.lo[2]));
}
double width(const PointView& p, int u, int v) { return std::max(p.hi[u] - p.lo[u], p.hi[v] - p.lo[v]); }

/// x[k] of a point in homogeneous form.
const Integer& coordinate(const ExactPoint& p, int k) { return k == 0 ? p.x : (k == 1 ? p.y : p.z); }

/// The integers of one exact sign. They keep their memory from call to call: of most signs, which are of numbers
/// of two words or three, making and freeing integers is the dearest part.
struct Workspace {
  std::array<std::array<Integer, 3>, 3> differences;
  Integer minor, product, sum;
  static Workspace& of_thread() { return PerThread<Workspace>::own(); }
};

/// A positive multiple of b - a in coordinate k; the factor does not depend on k.
void difference(Integer& out, const ExactPoint& a, const ExactPoint& b, int k) {
  if (a.w == b.w) {
    mpz_sub(out.get_mpz_t(), coordinate(b, k).get_mpz_t(), coordinate(a, k).get_mpz_t());
    return;
  }
  mpz_mul(out.get_mpz_t(), coordinate(b, k).get_mpz_t(), a.w.get_mpz_t());
  mpz_submul(out.get_mpz_t(), coordinate(a, k).get_mpz_t(), b.w.get_mpz_t());
}

int exact_orient3d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d) {
  Workspace& x = Workspace::of_thread();
  const std::array<const ExactPoint*, 3> ends{&b, &c, &d};
  for (std::size_t i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) difference(x.differences[i][static_cast<std::size_t>(k)], a, *ends[i], k);
  }
  const auto& [u, v, w] = x.differences;
  x.sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    mpz_mul(x.minor.get_mpz_t(), u[i].get_mpz_t(), v[j].get_mpz_t());
    mpz_submul(x.minor.get_mpz_t(), u[j].get_mpz_t(), v[i].get_mpz_t());
    mpz_addmul(x.sum.get_mpz_t(), w[k].get_mpz_t(), x.minor.get_mpz_t());
  }
  return sgn(x.sum);
}

/// The sign of (b - a) x (d - c) along the axes.
int exact_cross(Projection axes, const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                const ExactPoint& d) {
  Workspace& x = Workspace::of_thread();
  auto& [u, v, unused] = x.differences;
  difference(u[0], a, b, axes.u);
  difference(u[1], a, b, axes.v);
  difference(v[0], c, d, axes.u);
  difference(v[1], c, d, axes.v);
  mpz_mul(x.sum.get_mpz_t(), u[0].get_mpz_t(), v[1].get_mpz_t());
  mpz_mul(x.product.get_mpz_t(), u[1].get_mpz_t(), v[0].get_mpz_t());
  return cmp(x.sum, x.product);
}

}  // namespace

int orient3d(const PointView& a, const PointView& b, const PointView& c, const PointView& d) {
  const double w = std::max(std::max(width(a), width(b)), std::max(width(c), width(d)));
  const auto enclosed = [&] {
    const Interval3 o = of(a);
    return sign_of(dot(of(d) - o, cross(of(b) - o, of(c) - o)));
  };
  return in_stages(filtered_orient3d(a.lo.data(), b.lo.data(), c.lo.data(), d.lo.data(), w), enclosed,
                   [&] { return exact_orient3d(a.exact(), b.exact(), c.exact(), d.exact()); });
}

int orient3d(const PointTable& t, VertexId a, VertexId b, VertexId c, VertexId d) {
  const double *pa = t.doubles(a), *pb = t.doubles(b), *pc = t.doubles(c), *pd = t.doubles(d);
  if (pa != nullptr && pb != nullptr && pc != nullptr && pd != nullptr) {
    const int s = filtered_orient3d(pa, pb, pc, pd, 0);
    if (s != kUndecided) {
      ++counts().filter;
      return s;
    }
  }
  return orient3d(t.view(a), t.view(b), t.view(c), t.view(d));
}

int orient3d(const double* a, const double* b, const double* c, const double* d) {
  if (const int s = filtered_orient3d(a, b, c, d, 0); s != kUndecided) {
    ++counts().filter;
    return s;
  }
  ++counts().exact;
  ScaledPoints points;
  for (const double* const p : {a, b, c, d}) points.add(p);
  points.scale();
  DeterminantSum sum(points);
  sum.add(1, 2, 3, true);
  sum.add(0, 2, 3, false);
  sum.add(0, 1, 3, true);
  sum.add(0, 1, 2, false);
  return sgn(sum.value());
}

int side_of_plane(const PointTable& t, PlaneId plane, const PointView& p) {
  const auto [a, b, c] = t.plane_points(plane);
  return orient3d(t.view(a), t.view(b), t.view(c), p);
}

int side_of_plane(const PointTable& t, PlaneId plane, VertexId p) { return side_of_plane(t, plane, t.view(p)); }

int orient2d(Projection axes, const PointView& a, const PointView& b, const PointView& c) {
  const int u = axes.u, v = axes.v;
  const double w = std::max(width(a, u, v), std::max(width(b, u, v), width(c, u, v)));
  const int filtered =
      filtered_cross(b.lo[u] - a.lo[u], b.lo[v] - a.lo[v], c.lo[u] - a.lo[u], c.lo[v] - a.lo[v], w);
  const auto enclosed = [&] {
    const Interval ax(a.lo[u], a.hi[u]), ay(a.lo[v], a.hi[v]);
    const Interval bx(b.lo[u], b.hi[u]), by(b.lo[v], b.hi[v]);
    const Interval cx(c.lo[u], c.hi[u]), cy(c.lo[v], c.hi[v]);
    return sign_of((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
  };
  return in_stages(filtered, enclosed,
                   [&] { return exact_cross(axes, a.exact(), b.exact(), a.exact(), c.exact()); });
}

int orient2d(const PointTable& t, Projection axes, VertexId a, VertexId b, VertexId c) {
  const double *pa = t.lower(a), *pb = t.lower(b), *pc = t.lower(c);
  const int u = axes.u, v = axes.v;
  double w = 0;
  for (const VertexId p : {a, b, c}) {
    if (!t.is_double(p)) w = std::max(w, std::max(t.upper(p, u) - t.lower(p)[u], t.upper(p, v) - t.lower(p)[v]));
  }
  if (const int s = filtered_cross(pb[u] - pa[u], pb[v] - pa[v], pc[u] - pa[u], pc[v] - pa[v], w);
      s != kUndecided) {
    ++counts().filter;
    return s;
  }
  return orient2d(axes, t.view(a), t.view(b), t.view(c));
}

int orient2d_vectors(const PointTable& t, Projection axes, VertexId a, VertexId b, VertexId c, VertexId d) {
  if (a == c) return orient2d(t, axes, a, b, d);
  const int u = axes.u, v = axes.v;
  const PointView pa = t.view(a), pb = t.view(b), pc = t.view(c), pd = t.view(d);
  // The bound of orient2d: it does not use that the two differences share a point.
  const double w =
      std::max(std::max(width(pa, u, v), width(pb, u, v)), std::max(width(pc, u, v), width(pd, u, v)));
  const int filtered =
      filtered_cross(pb.lo[u] - pa.lo[u], pb.lo[v] - pa.lo[v], pd.lo[u] - pc.lo[u], pd.lo[v] - pc.lo[v], w);
  const auto enclosed = [&] {
    const auto at = [](const PointView& p, int k) { return Interval(p.lo[k], p.hi[k]); };
    return sign_of((at(pb, u) - at(pa, u)) * (at(pd, v) - at(pc, v)) -
                   (at(pb, v) - at(pa, v)) * (at(pd, u) - at(pc, u)));
  };
  return in_stages(filtered, enclosed,
                   [&] { return exact_cross(axes, pa.exact(), pb.exact(), pc.exact(), pd.exact()); });
}

int compare(int axis, const PointView& a, const PointView& b) {
  if (a.lo[axis] > b.hi[axis]) {
    ++counts().filter;
    return 1;
  }
  if (a.hi[axis] < b.lo[axis]) {
    ++counts().filter;
    return -1;
  }
  if (a.lo[axis] == a.hi[axis] && b.lo[axis] == b.hi[axis]) {
    ++counts().filter;
    return 0;
  }
  if (a.table != nullptr && a.table == b.table && a.id == b.id) return 0;
  ++counts().exact;
  const ExactPoint &ea = a.exact(), &eb = b.exact();
  Integer& d = Workspace::of_thread().sum;
  difference(d, eb, ea, axis);
  return sgn(d);
}

int compare(const PointTable& t, int axis, VertexId a, VertexId b) {
  if (a == b) return 0;
  const double lo_a = t.lower(a)[axis], lo_b = t.lower(b)[axis], hi_a = t.upper(a, axis), hi_b = t.upper(b, axis);
  if (lo_a > hi_b || hi_a < lo_b || (lo_a == hi_a && lo_b == hi_b)) {
    ++counts().filter;
    return lo_a > hi_b ? 1 : (hi_a < lo_b ? -1 : 0);
  }
  return compare(axis, t.view(a), t.view(b));
}

int compare_lex(const PointView& a, const PointView& b) {
  for (int k = 0; k < 3; ++k) {
    const int s = compare(k, a, b);
    if (s != 0) return s;
  }
  return 0;
}

int compare_lex(const PointTable& t, VertexId a, VertexId b) {
  if (a == b) return 0;
  for (int k = 0; k < 3; ++k) {
    if (const int s = compare(t, k, a, b)) return s;
  }
  return 0;
}

bool collinear(const PointTable& t, VertexId a, VertexId b, VertexId c) {
  return orient2d(t, {0, 1}, a, b, c) == 0 && orient2d(t, {1, 2}, a, b, c) == 0 &&
         orient2d(t, {2, 0}, a, b, c) == 0;
}

int cross_normal_sign(const PointTable& t, PlaneId p, PlaneId q, int k) {
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const auto enclosed = [&] {
    const auto [pa, pb, pc] = t.plane_points(p);
    const auto [qa, qb, qc] = t.plane_points(q);
    const Interval3 m = enclosure::normal(t.view(pa), t.view(pb), t.view(pc));
    const Interval3 n = enclosure::normal(t.view(qa), t.view(qb), t.view(qc));
    return sign_of(m[i] * n[j] - m[j] * n[i]);
  };
  return in_stages(kUndecided, enclosed, [&] {
    const ExactPlane &m = t.exact_plane(p), &n = t.exact_plane(q);
    const Integer* mm[3] = {&m.a, &m.b, &m.c};
    const Integer* nn[3] = {&n.a, &n.b, &n.c};
    const Integer component = *mm[i] * *nn[j] - *mm[j] * *nn[i];
    return sgn(component);
  });
}

int normal_dot_sign(const PointTable& t, PlaneId p, const std::array<double, 3>& direction) {
  const auto enclosed = [&] {
    const auto [a, b, c] = t.plane_points(p);
    const Interval3 n = enclosure::normal(t.view(a), t.view(b), t.view(c));
    return sign_of(dot(n, Interval3{Interval(direction[0]), Interval(direction[1]), Interval(direction[2])}));
  };
  return in_stages(kUndecided, enclosed, [&] {
    const ExactPlane& e = t.exact_plane(p);
    const Rational value = Rational(e.a) * from_double(direction[0]) + Rational(e.b) * from_double(direction[1]) +
                           Rational(e.c) * from_double(direction[2]);
    return sgn(value);
  });
}

int normal_sign(const PointTable& t, PlaneId p, int k) {
  const auto [a, b, c] = t.plane_points(p);
  return orient2d(t, {static_cast<std::uint8_t>((k + 1) % 3), static_cast<std::uint8_t>((k + 2) % 3)}, a, b, c);
}

Projection projection_of(const PointTable& t, PlaneId plane) {
  std::array<double, 3> lo, hi;
  t.normal(plane, lo, hi);
  int order[3] = {0, 1, 2};
  const auto size = [&](int k) { return std::max(std::fabs(lo[k]), std::fabs(hi[k])); };
  for (int i = 0; i < 2; ++i) {
    for (int j = i + 1; j < 3; ++j) {
      if (size(order[j]) > size(order[i])) std::swap(order[i], order[j]);
    }
  }
  for (const int k : order) {
    const int s = lo[k] > 0 ? 1 : (hi[k] < 0 ? -1 : normal_sign(t, plane, k));
    const auto u = static_cast<std::uint8_t>((k + 1) % 3), v = static_cast<std::uint8_t>((k + 2) % 3);
    if (s > 0) return {u, v};
    if (s < 0) return {v, u};
  }
  throw InvariantError("the three points of a plane are collinear");
}

Projection projection_of(const ExactPlane& plane) {
  const Integer* const n[3] = {&plane.a, &plane.b, &plane.c};
  std::size_t axis = 2;
  for (const std::size_t k : {1, 0}) {
    if (mpz_cmpabs(n[k]->get_mpz_t(), n[axis]->get_mpz_t()) > 0) axis = k;
  }
  const auto u = static_cast<std::uint8_t>((axis + 1) % 3), v = static_cast<std::uint8_t>((axis + 2) % 3);
  return sgn(*n[axis]) > 0 ? Projection{u, v} : Projection{v, u};
}

Projection projection_of(const PointTable& t, PlaneId plane, const PlaneFilter& filter) {
  const auto& n = filter.normal();
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::fabs(n[static_cast<std::size_t>(i)]) > std::fabs(n[static_cast<std::size_t>(k)])) k = i;
  }
  const int s = filter.normal_sign(k);
  if (s == 0) return projection_of(t, plane);
  const auto u = static_cast<std::uint8_t>((k + 1) % 3), v = static_cast<std::uint8_t>((k + 2) % 3);
  return s > 0 ? Projection{u, v} : Projection{v, u};
}

void count_filtered(std::uint64_t n) { counts().filter += n; }

StageCounts stage_counts() {
  StageCounts total;
  PerThread<StageCounts>::each([&](const StageCounts& c) {
    total.filter += c.filter;
    total.interval += c.interval;
    total.exact += c.exact;
  });
  return total;
}

void reset_stage_counts() {
  PerThread<StageCounts>::each([](StageCounts& c) { c = {}; });
}

}  // namespace cnrg
