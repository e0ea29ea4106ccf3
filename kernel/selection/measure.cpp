// A planar face and the origin span a cone of volume r . N / 3, where r is a point of the face's plane and N its
// area vector, half of the sum of p x q over its directed edges pq: so 6 V = sum of det(r, p, q). No triangle is
// made; holes and slits take themselves off.
//
// Where the corners are doubles, all are multiples of one power of two: the determinants are integers and go into
// one accumulator. Only faces with constructed corners make fractions.
//
// The denominator of a term is the product of the weights w of its points (ExactPoint). Powers of two are kept
// apart; what is odd in a weight, and not 1, is a *pole* of the term, as often as it is there. Points of one turn
// mostly have one pole among them, points of intersections one each. Terms of the same poles are added first; then
// sums are joined two and two, over the product of all their poles, and the only common divisor to look for is
// that of the last sum. Poles are numbered along the terms (curves of intersection, mostly), so that what is
// joined shares few.
#include "kernel/selection/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
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

// Adds r . (p x q) to the sum. `minor` is memory for the components of p x q, so that none is taken per call.
void add_determinant(Integer& sum, const IntegerPoint& r, const IntegerPoint& p, const IntegerPoint& q,
                     Integer& minor) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    mpz_mul(minor.get_mpz_t(), p[i].get_mpz_t(), q[j].get_mpz_t());
    mpz_submul(minor.get_mpz_t(), p[j].get_mpz_t(), q[i].get_mpz_t());
    mpz_addmul(sum.get_mpz_t(), r[k].get_mpz_t(), minor.get_mpz_t());
  }
}

using Pole = std::uint32_t;

// A numerator over the product of its poles, which are ascending and may be there more than once.
struct PoleSum {
  std::vector<Pole> poles;
  Integer numerator, denominator;
};

Integer product(const std::vector<Integer>& weights, std::span<const Pole> poles) {
  Integer out = 1;
  for (Pole p : poles) out *= weights[p];
  return out;
}

PoleSum joined(const std::vector<Integer>& weights, PoleSum a, PoleSum b) {
  std::vector<Pole> shared, all;
  std::ranges::set_intersection(a.poles, b.poles, std::back_inserter(shared));
  std::ranges::set_union(a.poles, b.poles, std::back_inserter(all));
  const Integer common = product(weights, shared);
  mpz_divexact(b.denominator.get_mpz_t(), b.denominator.get_mpz_t(), common.get_mpz_t());
  a.numerator *= b.denominator;
  b.denominator *= a.denominator;
  mpz_divexact(a.denominator.get_mpz_t(), a.denominator.get_mpz_t(), common.get_mpz_t());
  a.numerator += b.numerator * a.denominator;
  return {std::move(all), std::move(a.numerator), std::move(b.denominator)};
}

PoleSum sum_of(const std::vector<Integer>& weights, std::span<const PoleSum> terms) {
  if (terms.size() == 1) return terms[0];
  const std::size_t half = terms.size() / 2;
  PoleSum a, b;
  const auto first = [&] { a = sum_of(weights, terms.first(half)); };
  const auto second = [&] { b = sum_of(weights, terms.subspan(half)); };
  constexpr std::size_t kFew = 64;  // terms that are not worth a thread
  if (terms.size() <= kFew) first(), second();
  else tbb::parallel_invoke(first, second);
  return joined(weights, std::move(a), std::move(b));
}

class VolumeSum {
 public:
  explicit VolumeSum(const Complex& complex)
      : complex_(complex), place_(complex.points.size()), weight_(complex.points.size()) {}

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
    number_along_terms();
    int exponent = terms_[0].exponent;
    for (const Term& term : terms_) exponent = std::min(exponent, term.exponent);
    std::sort(terms_.begin(), terms_.end(), [](const Term& a, const Term& b) { return a.poles < b.poles; });
    std::vector<PoleSum> sums;
    for (Term& term : terms_) {
      term.numerator <<= static_cast<unsigned long>(term.exponent - exponent);
      if (sums.empty() || sums.back().poles != term.poles) {
        sums.push_back({std::move(term.poles), 0, 0});
        sums.back().denominator = product(weights_, sums.back().poles);
      }
      sums.back().numerator += term.numerator;
    }
    const PoleSum six = sum_of(weights_, sums);
    Rational out(six.numerator, six.denominator);
    out.canonicalize();
    if (exponent >= 0) out <<= static_cast<unsigned long>(exponent);
    else out >>= static_cast<unsigned long>(-exponent);
    return out / 6;
  }

 private:
  // numerator 2^exponent over the product of the poles (ascending).
  struct Term {
    std::vector<Pole> poles;
    Integer numerator;
    int exponent = 0;
  };

  // 2^exponent times a pole.
  static constexpr Pole kNoPole = 0xffffffffu;
  struct Weight {
    int exponent;
    Pole pole;
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
    const auto add = [&](const Range& range, Integer sum) {
      Integer face, minor;
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        face = 0;
        add_face(double_faces_[i].first, scaled, face, minor);
        if (double_faces_[i].second > 0) sum += face;
        else sum -= face;
      }
      return sum;
    };
    const Range all(0, double_faces_.size(), 1024);
    if (!all.is_divisible()) return add(all, 0);
    return tbb::parallel_reduce(all, Integer(0), add,
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
          const Weight& weight = weight_of(v);
          term.exponent -= weight.exponent;
          if (weight.pole != kNoPole) term.poles.push_back(weight.pole);
        }
        terms_.push_back(std::move(term));
      }
    }
  }
  const Weight& weight_of(VertexId v) {
    if (weight_.get(v) == 0) {
      Integer odd = complex_.points.exact(v).w;
      const auto exponent = mpz_scan1(odd.get_mpz_t(), 0);
      odd >>= exponent;
      Pole pole = kNoPole;
      if (odd != 1) {
        pole = pole_.try_emplace(odd, static_cast<Pole>(weights_.size())).first->second;
        if (pole == weights_.size()) weights_.push_back(std::move(odd));
      }
      known_weights_.push_back({static_cast<int>(exponent), pole});
      weight_[v] = static_cast<std::uint32_t>(known_weights_.size());
    }
    return known_weights_[weight_.get(v) - 1];
  }

  // Depth first over the poles that have a term in common.
  void number_along_terms() {
    std::vector<std::pair<Pole, Pole>> links;
    for (const Term& term : terms_) {
      for (Pole a : term.poles) {
        for (Pole b : term.poles) links.emplace_back(a, b);
      }
    }
    sort_unique(links);
    const auto by_first = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::vector<Pole> number(weights_.size()), open;
    std::vector<char> known(weights_.size(), 0);
    std::vector<Integer> weights;
    for (Pole start = 0; start < weights_.size(); ++start) {
      for (open.push_back(start); !open.empty();) {
        const Pole p = open.back();
        open.pop_back();
        if (known[p]) continue;
        known[p] = 1;
        number[p] = static_cast<Pole>(weights.size());
        weights.push_back(weights_[p]);
        const auto [first, last] = std::equal_range(links.begin(), links.end(), std::pair(p, Pole{0}), by_first);
        std::transform(first, last, std::back_inserter(open), [](const auto& link) { return link.second; });
      }
    }
    weights_ = std::move(weights);
    for (Term& term : terms_) {
      for (Pole& p : term.poles) p = number[p];
      std::sort(term.poles.begin(), term.poles.end());
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
  Scratch<VertexId, std::uint32_t> weight_;  // 1 + index into known_weights_
  std::vector<Weight> known_weights_;
  std::map<Integer, Pole> pole_;
  std::vector<Integer> weights_;  // by pole
  int scale_ = 0;                 // all corners of double_faces_ are multiples of 2^scale_
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
