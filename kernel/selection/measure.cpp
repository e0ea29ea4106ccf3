#include "kernel/selection/measure.h"

#include <algorithm>
#include <cmath>

#include "kernel/base/sorted.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/selection/scratch.h"
#include "kernel/selection/volume_sum.h"

namespace cnrg {

Rational squared_length(const Complex& complex, EdgeId e) {
  const auto& [a, b] = complex.edge_ends[e];
  const RationalPoint d = complex.points.rational(b) - complex.points.rational(a);
  return dot(d, d);
}

RationalPoint area_vector(const Complex& complex, FaceId f) {
  std::array<std::vector<Rational>, 3> terms;
  for (LoopId l : complex.face_loops[f]) {
    const auto loop = complex.loop[l];
    const RationalPoint origin = complex.points.rational(complex.origin(loop[0]));
    for (HalfEdge h : loop) {
      const RationalPoint p = complex.points.rational(complex.origin(h)) - origin;
      const RationalPoint q = complex.points.rational(complex.target(h)) - origin;
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        terms[k].push_back(p[i] * q[j] - p[j] * q[i]);
      }
    }
  }
  RationalPoint out;
  for (int k = 0; k < 3; ++k) out[k] = sum(std::move(terms[k])) / 2;
  return out;
}

Rational squared_area(const Complex& complex, FaceId f) {
  const RationalPoint n = area_vector(complex, f);
  return dot(n, n);
}

Rational square_root(const Rational& square, int digits) {
  if (sgn(square) <= 0) return 0;
  // sqrt(n / d) = sqrt(n d 4^k) / (d 2^k), with enough bits below the root that its floor is close.
  const Integer product = square.get_num() * square.get_den();
  const auto have = static_cast<std::int64_t>(mpz_sizeinbase(product.get_mpz_t(), 2) / 2);
  const auto need = static_cast<std::int64_t>(std::ceil((digits + 1) * 3.33)) + 2;
  const auto k = static_cast<mp_bitcnt_t>(std::max<std::int64_t>(0, need - have));
  Integer root = product << (2 * k);
  mpz_sqrt(root.get_mpz_t(), root.get_mpz_t());
  Rational out(root, square.get_den() << k);
  out.canonicalize();
  return out;
}

std::optional<Rational> volume(const Complex& complex, std::span<const RegionId> cells) {
  Marks<RegionId> inside(complex.region_count);
  for (RegionId r : cells) {
    if (complex.unbounded(r)) return std::nullopt;
    inside[r] = 1;
  }
  VolumeSum total(complex);
  for (RegionId r : cells) {
    for (HalfFace h : complex.region_faces[r]) {
      if (!inside[complex.region(h.opposite())]) total.add(h.face(), h.side() == 0 ? -1 : 1);
    }
  }
  return total.total();
}

std::optional<Rational> volume(const Complex& complex, RegionId cell) {
  return volume(complex, std::span<const RegionId>(&cell, 1));
}

}  // namespace cnrg
