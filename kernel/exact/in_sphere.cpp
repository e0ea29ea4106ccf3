// A determinant of four rows (x, y, z, x^2 + y^2 + z^2), each the difference of a point from e.
//
// Bound of the filter. Let u = 2^-53. Of the four minors of three rows each is a sum of six products of three
// differences: three roundings from these, one of the product in its 2x2 minor, one of the minor's sum, one of the
// product with z, two of sums. A square sum has two roundings per difference, one per square, two of sums. With
// the product of both and two sums that is 3 + 5 + 5 + 1 + 2 = 16 in each of 24 products of five numbers: relative
// error (1 + u)^16 - 1 < 16.1 u. With M the product of the largest absolute differences per axis and L the largest
// square sum the error is below 24 * 16.1 u * 1.0001 M L < 4.3e-14 M L; we use 4.5e-14, which also covers the
// roundings of the bound. The guards keep products of five from under- and overflow.
#include "kernel/exact/in_sphere.h"

#include <algorithm>

#include "kernel/exact/enclosure.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

using namespace enclosure;

namespace {

/// The determinant of rows (x, y, z, lift); positive where e is outside.
template <class Number>
Number determinant(const std::array<std::array<Number, 3>, 4>& row, const std::array<Number, 4>& lift) {
  const auto& [a, b, c, d] = row;
  const auto minor = [](const auto& p, const auto& q) -> Number { return p[0] * q[1] - q[0] * p[1]; };
  const Number ab = minor(a, b), bc = minor(b, c), cd = minor(c, d), da = minor(d, a), ac = minor(a, c),
               bd = minor(b, d);
  const Number abc = a[2] * bc - b[2] * ac + c[2] * ab;
  const Number bcd = b[2] * cd - c[2] * bd + d[2] * bc;
  const Number cda = c[2] * da + d[2] * ac + a[2] * cd;
  const Number dab = d[2] * ab + a[2] * bd + b[2] * da;
  return (lift[3] * abc - lift[2] * dab) + (lift[1] * cda - lift[0] * bcd);
}

int filtered(const std::array<const double*, 4>& points, const double* e) {
  std::array<std::array<double, 3>, 4> row;
  std::array<double, 4> lift;
  std::array<double, 3> most{};
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      row[i][k] = points[i][k] - e[k];
      most[k] = std::max(most[k], std::fabs(row[i][k]));
    }
    lift[i] = row[i][0] * row[i][0] + row[i][1] * row[i][1] + row[i][2] * row[i][2];
    longest = std::max(longest, lift[i]);
  }
  const auto [smallest, largest] = std::minmax({most[0], most[1], most[2]});
  if (!(smallest > 1e-50 && largest < 1e50)) return kUndecided;
  const double value = determinant(row, lift), bound = 4.5e-14 * most[0] * most[1] * most[2] * longest;
  if (value > bound) return -1;
  if (value < -bound) return 1;
  return kUndecided;
}

int exact_sign(const std::array<const ExactPoint*, 4>& points, const ExactPoint& e) {
  std::array<std::array<Integer, 3>, 4> row;
  std::array<Integer, 4> lift;
  for (std::size_t i = 0; i < 4; ++i) {
    const ExactPoint& p = *points[i];
    const Integer common = p.w * e.w;
    row[i] = {p.x * e.w - e.x * p.w, p.y * e.w - e.y * p.w, p.z * e.w - e.z * p.w};
    lift[i] = row[i][0] * row[i][0] + row[i][1] * row[i][1] + row[i][2] * row[i][2];
    for (Integer& x : row[i]) x *= common;
  }
  return -sgn(determinant(row, lift));
}

}  // namespace

int in_sphere(const PointTable& t, VertexId a, VertexId b, VertexId c, VertexId d, VertexId e) {
  const double *pa = t.doubles(a), *pb = t.doubles(b), *pc = t.doubles(c), *pd = t.doubles(d), *pe = t.doubles(e);
  if (pa != nullptr && pb != nullptr && pc != nullptr && pd != nullptr && pe != nullptr) {
    const int s = filtered({pa, pb, pc, pd}, pe);
    if (s != kUndecided) {
      count_filtered(1);
      return s;
    }
  }
  {
    RoundOutward round;
    const Interval3 o = of(t.view(e));
    const std::array<Interval3, 4> row{of(t.view(a)) - o, of(t.view(b)) - o, of(t.view(c)) - o, of(t.view(d)) - o};
    std::array<Interval, 4> lift;
    for (std::size_t i = 0; i < 4; ++i)
      lift[i] = CGAL::square(row[i][0]) + CGAL::square(row[i][1]) + CGAL::square(row[i][2]);
    const int s = sign_of(determinant(row, lift));
    if (s != kUndecided) return -s;
  }
  return exact_sign({&t.exact(a), &t.exact(b), &t.exact(c), &t.exact(d)}, t.exact(e));
}

int in_sphere_perturbed(const PointTable& t, VertexId a, VertexId b, VertexId c, VertexId d, VertexId e) {
  if (const int s = in_sphere(t, a, b, c, d, e)) return s;
  // The determinant is linear in what a point is lifted by; the factor of e is -orient3d(a, b, c, d), and
  // exchanging two points turns the sign.
  std::array<VertexId, 5> order{a, b, c, d, e};
  std::sort(order.begin(), order.end());
  for (std::size_t i = 5; i-- > 0;) {
    const VertexId p = order[i];
    const auto without = [&](VertexId q) { return q == p ? e : q; };
    const int s = orient3d(t, without(a), without(b), without(c), without(d));
    if (s != 0) return p == e ? -s : s;
  }
  return 0;
}

}  // namespace cnrg
