// A planar face and the origin span a cone of volume r . N / 3, where r is a point of the face's plane and N its
// area vector, half of the sum of p x q over its directed edges pq: so 6 V = sum of det(r, p, q). No triangle is
// made; holes and slits take themselves off.
//
// Where the corners are doubles, all are multiples of one power of two: the determinants are integers and go into
// one accumulator. Only faces with constructed corners make fractions.
//
// The denominator of a term is the product of the weights w of its points (ExactPoint); of a double it is a power
// of two, the others are the term's *poles*. Terms of the same poles are added first; then sums are joined two and
// two, over the product of the weights of all their poles. So the only common divisor to look for is that of the
// last sum.
#include "kernel/selection/measure.h"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include "kernel/selection/parallel.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

using IntegerPoint = std::array<Integer, 3>;

RationalPoint difference(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The exponent of the lowest bit of a double that is not zero.
int lowest_bit(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  return exponent - 53 + __builtin_ctzll(static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa));
}

// sum + r . (p x q), with two temporaries that the caller keeps.
void add_determinant(Integer& sum, const IntegerPoint& r, const IntegerPoint& p, const IntegerPoint& q,
                     Integer& minor) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    mpz_mul(minor.get_mpz_t(), p[i].get_mpz_t(), q[j].get_mpz_t());
    mpz_submul(minor.get_mpz_t(), p[j].get_mpz_t(), q[i].get_mpz_t());
    mpz_addmul(sum.get_mpz_t(), r[k].get_mpz_t(), minor.get_mpz_t());
  }
}

// A numerator over the weights of its poles, ascending.
struct PoleSum {
  std::vector<VertexId> poles;
  Integer numerator;
};

Integer product_of_weights(const PointTable& points, std::span<const VertexId> poles) {
  if (poles.empty()) return 1;
  if (poles.size() == 1) return points.exact(poles[0]).w;
  const std::size_t half = poles.size() / 2;
  return product_of_weights(points, poles.first(half)) * product_of_weights(points, poles.subspan(half));
}

PoleSum joined(const PointTable& points, const PoleSum& a, const PoleSum& b) {
  std::vector<VertexId> only_a, only_b;
  PoleSum out;
  std::set_difference(a.poles.begin(), a.poles.end(), b.poles.begin(), b.poles.end(), std::back_inserter(only_a));
  std::set_difference(b.poles.begin(), b.poles.end(), a.poles.begin(), a.poles.end(), std::back_inserter(only_b));
  std::set_union(a.poles.begin(), a.poles.end(), b.poles.begin(), b.poles.end(), std::back_inserter(out.poles));
  out.numerator = a.numerator * product_of_weights(points, only_b);
  out.numerator += b.numerator * product_of_weights(points, only_a);
  return out;
}

PoleSum sum_of(const PointTable& points, std::span<const PoleSum> terms) {
  if (terms.size() == 1) return terms[0];
  const std::size_t half = terms.size() / 2;
  PoleSum a, b;
  const auto first = [&] { a = sum_of(points, terms.first(half)); };
  const auto second = [&] { b = sum_of(points, terms.subspan(half)); };
  constexpr std::size_t kFew = 64;  // terms that are not worth a thread
  if (terms.size() <= kFew) first(), second();
  else tbb::parallel_invoke(first, second);
  return joined(points, a, b);
}

class VolumeSum {
 public:
  explicit VolumeSum(const Complex& complex) : complex_(complex), place_(complex.points.size()) {}

  // `outward`: +1 if the front normal points out of the volume.
  void add(FaceId f, int outward) {
    bool doubles = true;
    for (LoopId l : complex_.face_loops[f]) {
      for (HalfEdge h : complex_.loop[l]) doubles = doubles && complex_.points.is_double(complex_.origin(h));
    }
    (doubles ? double_faces_ : other_faces_).emplace_back(f, outward);
    if (!doubles) return;
    for (LoopId l : complex_.face_loops[f]) {
      for (HalfEdge h : complex_.loop[l]) note(complex_.origin(h));
    }
  }

  Rational total() {
    terms_.push_back({{}, sum_of_doubles(), 3 * scale_});
    for (const auto& [f, outward] : other_faces_) add_fractions(f, outward);
    int exponent = terms_[0].exponent;
    for (const Term& term : terms_) exponent = std::min(exponent, term.exponent);
    std::sort(terms_.begin(), terms_.end(), [](const Term& a, const Term& b) { return a.poles < b.poles; });
    std::vector<PoleSum> sums;
    for (Term& term : terms_) {
      term.numerator <<= static_cast<unsigned long>(term.exponent - exponent);
      if (sums.empty() || sums.back().poles != term.poles) sums.push_back({std::move(term.poles), 0});
      sums.back().numerator += term.numerator;
    }
    const PoleSum six = sum_of(complex_.points, sums);
    Rational out(six.numerator, product_of_weights(complex_.points, six.poles));
    out.canonicalize();
    if (exponent >= 0) out <<= static_cast<unsigned long>(exponent);
    else out >>= static_cast<unsigned long>(-exponent);
    return out / 6;
  }

 private:
  // numerator 2^exponent over the weights of the poles (ascending).
  struct Term {
    std::vector<VertexId> poles;
    Integer numerator;
    int exponent = 0;
  };

  void note(VertexId v) {
    if (place_.get(v) != 0) return;
    corners_.push_back(v);
    place_[v] = static_cast<std::uint32_t>(corners_.size());
    const double* x = complex_.points.doubles(v);
    for (int k = 0; k < 3; ++k) {
      if (x[k] == 0) continue;
      const int bit = lowest_bit(x[k]);
      scale_ = scale_known_ ? std::min(scale_, bit) : bit;
      scale_known_ = true;
    }
  }

  Integer multiple(double x) const {
    if (x == 0) return 0;
    const int bit = lowest_bit(x);
    Integer out = static_cast<long>(std::ldexp(x, -bit));
    return out <<= static_cast<unsigned long>(bit - scale_);
  }

  // Of the faces whose corners are doubles, in units of 2^(3 scale).
  Integer sum_of_doubles() const {
    std::vector<IntegerPoint> scaled(corners_.size());
    for_each_index(corners_.size(), [&](std::size_t i) {
      const double* x = complex_.points.doubles(corners_[i]);
      for (int k = 0; k < 3; ++k) scaled[i][k] = multiple(x[k]);
    });
    using Range = tbb::blocked_range<std::size_t>;
    return tbb::parallel_reduce(
        Range(0, double_faces_.size(), 1024), Integer(0),
        [&](const Range& range, Integer sum) {
          Integer face, minor;
          for (std::size_t i = range.begin(); i < range.end(); ++i) {
            face = 0;
            add_face(double_faces_[i].first, scaled, face, minor);
            if (double_faces_[i].second > 0) sum += face;
            else sum -= face;
          }
          return sum;
        },
        [](const Integer& a, const Integer& b) { return Integer(a + b); });
  }

  void add_face(FaceId f, const std::vector<IntegerPoint>& scaled, Integer& sum, Integer& minor) const {
    const LoopId outer = complex_.face_loops[f][0];
    const VertexId r = complex_.origin(complex_.loop[outer][0]);
    for (LoopId l : complex_.face_loops[f]) {
      for (HalfEdge h : complex_.loop[l]) {
        const VertexId p = complex_.origin(h), q = complex_.target(h);
        if (p == r || q == r) continue;
        add_determinant(sum, scaled[place_[r] - 1], scaled[place_[p] - 1], scaled[place_[q] - 1], minor);
      }
    }
  }

  void add_fractions(FaceId f, int outward) {
    // Any point of the plane serves as r; an input point is the shortest.
    const VertexId r = complex_.points.plane_points(complex_.plane(f))[0];
    Integer minor;
    for (LoopId l : complex_.face_loops[f]) {
      for (HalfEdge h : complex_.loop[l]) {
        const VertexId p = complex_.origin(h), q = complex_.target(h);
        Term term;
        add_determinant(term.numerator, numerators(r), numerators(p), numerators(q), minor);
        if (term.numerator == 0) continue;
        if (outward < 0) term.numerator = -term.numerator;
        for (VertexId v : {r, p, q}) {
          if (!complex_.points.is_double(v)) term.poles.push_back(v);
          else term.exponent -= static_cast<int>(mpz_scan1(complex_.points.exact(v).w.get_mpz_t(), 0));
        }
        std::sort(term.poles.begin(), term.poles.end());
        terms_.push_back(std::move(term));
      }
    }
  }
  IntegerPoint numerators(VertexId v) const {
    const ExactPoint& p = complex_.points.exact(v);
    return {p.x, p.y, p.z};
  }

  const Complex& complex_;
  Scratch<VertexId, std::uint32_t> place_;  // 1 + index into corners_
  std::vector<VertexId> corners_;
  std::vector<std::pair<FaceId, int>> double_faces_, other_faces_;
  std::vector<Term> terms_;
  int scale_ = 0;  // all corners of double_faces_ are multiples of 2^scale_
  bool scale_known_ = false;
};

}  // namespace

Rational squared_length(const Complex& complex, EdgeId e) {
  const auto& [a, b] = complex.edge_ends[e];
  const RationalPoint d = difference(complex.points.rational(b), complex.points.rational(a));
  return dot(d, d);
}

RationalPoint area_vector(const Complex& complex, FaceId f) {
  std::array<std::vector<Rational>, 3> terms;
  for (LoopId l : complex.face_loops[f]) {
    const auto loop = complex.loop[l];
    const RationalPoint origin = complex.points.rational(complex.origin(loop[0]));
    for (HalfEdge h : loop) {
      const RationalPoint p = difference(complex.points.rational(complex.origin(h)), origin);
      const RationalPoint q = difference(complex.points.rational(complex.target(h)), origin);
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
  const auto have = static_cast<long>(mpz_sizeinbase(product.get_mpz_t(), 2) / 2);
  const long need = static_cast<long>(std::ceil((digits + 1) * 3.33)) + 2;
  const auto k = static_cast<unsigned long>(std::max(0L, need - have));
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
