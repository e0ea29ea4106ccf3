#include "kernel/selection/measure.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/sorted.h"
#include "kernel/complex/complex.h"
#include "kernel/exact/determinant_sum.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

// The volume that faces bound.
//
// A planar face and the origin span a cone of volume r . N / 3, where r is a point of the face's plane and N its
// area vector, half of the sum of p x q over its directed edges pq: so 6 V = sum of det(r, p, q). No triangle is
// made; holes and slits take themselves off. Faces whose corners are doubles cost integers (determinant_sum.h).
//
// Corners that were constructed make fractions, and an exact sum of fractions costs their number times the length
// of the sum. So first as many as can be are taken out of it. Let the edges of one plane that lie on one segment
// be pieces v0 v1, v1 v2, ... of the line through o. Then det(r, v0, v1) = det(r, o, v1) - det(r, o, v0), and what
// is summed is a multiple of det(r, o, v) per plane, segment and vertex. It vanishes at a vertex where the line
// goes on, and along an edge between two faces of the plane: the cuts that other bodies have made leave no trace.
// And o can be an end of the segment, which mostly is a double.
//
// The denominator of a term is the product of the weights w of its points (ExactPoint). Powers of two are kept
// apart; what is odd in a weight, and not 1, is a *pole* of the term, as often as it is there. Points of one turn
// mostly have one pole among them, points of intersections one each. Terms of the same poles are added first; then
// sums are joined two and two, over the product of all their poles, and the only common divisor to look for is
// that of the last sum. Poles are numbered along the terms (curves of intersection, mostly), so that what is
// joined shares few.

class VolumeSum {
 public:
  explicit VolumeSum(const Complex& complex);
  /// `outward`: +1 if the front normal points out of the volume, else -1.
  void add(FaceId f, int outward);
  /// To be called once.
  Rational total();

 private:
  using Pole = std::uint32_t;
  static constexpr Pole kNoPole = 0xffffffffu;
  using Poles = std::array<Pole, 3>;  // ascending, with kNoPole at the end
  /// numerator 2^exponent over the product of the poles.
  struct Term {
    Poles poles;
    Integer numerator;
    int exponent = 0;
  };
  /// 2^exponent times a pole.
  struct Weight {
    int exponent;
    Pole pole;
  };
  /// times det(r, o, vertex), r of the plane and o of the segment.
  struct Corner {
    std::uint64_t line;  ///< plane and segment
    VertexId vertex;
    int times;
    bool same_place(const Corner& other) const { return line == other.line && vertex == other.vertex; }
    bool operator<(const Corner& other) const {
      return line != other.line ? line < other.line : vertex < other.vertex;
    }
  };
  struct Determinant {
    std::uint32_t r, p, q;
    int times;
  };

  void add_corners(FaceId f, int outward);
  void merge_corners();
  std::uint32_t number(VertexId v);
  VertexId origin(SegmentId s) const;
  void add_term(VertexId r, VertexId o, VertexId v, int times);
  const Weight& weight_of(VertexId v);
  Integer sum_of_doubles();
  void number_along_terms();

  const Complex& complex_;
  std::vector<std::pair<FaceId, int>> double_faces_;  // all of whose corners are doubles
  std::vector<Corner> corners_;                       // of other faces
  std::vector<Determinant> determinants_;             // of these, if all three points are doubles
  std::vector<Term> terms_;                           // else
  ScaledPoints points_;
  Scratch<VertexId, std::uint32_t> place_;   // 1 + index into points_
  Scratch<VertexId, std::uint32_t> weight_;  // 1 + index into known_weights_
  std::vector<Weight> known_weights_;
  std::map<Integer, Pole> pole_;
  std::vector<Integer> weights_;  // by pole
};

/// A numerator over the product of its poles, which are ascending and may be there more than once.
struct PoleSum {
  std::vector<std::uint32_t> poles;
  Integer numerator, denominator;
};

Integer product(const std::vector<Integer>& weights, std::span<const std::uint32_t> poles) {
  Integer out = 1;
  for (const std::uint32_t p : poles) out *= weights[p];
  return out;
}

PoleSum joined(const std::vector<Integer>& weights, PoleSum a, PoleSum b) {
  std::vector<std::uint32_t> all = in_either(a.poles, b.poles);
  const Integer common = product(weights, in_common(a.poles, b.poles));
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

VolumeSum::VolumeSum(const Complex& complex)
    : complex_(complex), place_(complex.points.size()), weight_(complex.points.size()) {}

void VolumeSum::add(FaceId f, int outward) {
  bool doubles = true;
  for (const HalfEdge h : complex_.half_edges(f))
    doubles = doubles && complex_.points.is_double(complex_.origin(h));
  if (!doubles) return add_corners(f, outward);
  double_faces_.emplace_back(f, outward);
  for (const HalfEdge h : complex_.half_edges(f)) number(complex_.origin(h));
}

void VolumeSum::add_corners(FaceId f, int outward) {
  const std::uint64_t plane = std::uint64_t{complex_.plane(f).value()} << 32;
  for (const HalfEdge h : complex_.half_edges(f)) {
    const std::uint64_t line = plane | std::ranges::min(complex_.edge_segments[h.edge()]).value();
    corners_.push_back({line, complex_.target(h), outward});
    corners_.push_back({line, complex_.origin(h), -outward});
  }
}

void VolumeSum::merge_corners() {
  std::sort(corners_.begin(), corners_.end());
  for (std::size_t i = 0, end = 0; i < corners_.size(); i = end) {
    int times = 0;
    for (end = i; end < corners_.size() && corners_[end].same_place(corners_[i]); ++end)
      times += corners_[end].times;
    if (times == 0) continue;
    const PlaneId plane(static_cast<std::uint32_t>(corners_[i].line >> 32));
    const SegmentId segment(static_cast<std::uint32_t>(corners_[i].line));
    // Any point of the plane serves as r; an input point is the shortest.
    add_term(complex_.points.plane_points(plane)[0], origin(segment), corners_[i].vertex, times);
  }
  corners_ = {};
}

VertexId VolumeSum::origin(SegmentId s) const {
  const auto [a, b] = complex_.segment_ends[s];
  const auto rank = [&](VertexId v) {
    return complex_.points.is_double(v) ? 0 : complex_.points.is_constructed(v) ? 2 : 1;
  };
  return rank(b) < rank(a) ? b : a;
}

void VolumeSum::add_term(VertexId r, VertexId o, VertexId v, int times) {
  if (r == o || r == v || o == v) return;
  const PointTable& points = complex_.points;
  if (points.is_double(r) && points.is_double(o) && points.is_double(v)) {
    determinants_.push_back({number(r), number(o), number(v), times});
    return;
  }
  const ExactPoint &a = points.exact(r), &b = points.exact(o), &c = points.exact(v);
  Term term{{kNoPole, kNoPole, kNoPole}, {}, 0};
  term.numerator = a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
  if (term.numerator == 0) return;
  term.numerator *= times;
  std::size_t count = 0;
  for (const VertexId p : {r, o, v}) {
    const Weight& weight = weight_of(p);
    term.exponent -= weight.exponent;
    if (weight.pole != kNoPole) term.poles[count++] = weight.pole;
  }
  terms_.push_back(std::move(term));
}

std::uint32_t VolumeSum::number(VertexId v) {
  if (place_.get(v) == 0) {
    points_.add(complex_.points.doubles(v));
    place_[v] = static_cast<std::uint32_t>(points_.size());
  }
  return place_.get(v) - 1;
}

const VolumeSum::Weight& VolumeSum::weight_of(VertexId v) {
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

// In units of 2^(3 exponent) of the points.
Integer VolumeSum::sum_of_doubles() {
  points_.scale();
  const auto place = [&](VertexId v) -> std::size_t { return place_.get(v) - 1; };
  const auto add_face = [&](FaceId f, bool plus, DeterminantSum& sum) {
    const VertexId r = complex_.origin(complex_.loop[complex_.face_loops[f][0]][0]);
    for (const HalfEdge h : complex_.half_edges(f)) {
      const VertexId p = complex_.origin(h), q = complex_.target(h);
      if (p != r && q != r) sum.add(place(r), place(p), place(q), plus);
    }
  };
  using Range = tbb::blocked_range<std::size_t>;
  const auto add = [&](const Range& range, DeterminantSum sum) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      add_face(double_faces_[i].first, double_faces_[i].second > 0, sum);
    return sum;
  };
  const Range all(0, double_faces_.size(), 1024);
  DeterminantSum sum = !all.is_divisible() ? add(all, DeterminantSum(points_))
                                           : tbb::parallel_reduce(all, DeterminantSum(points_), add,
                                                                  [](DeterminantSum a, const DeterminantSum& b) {
                                                                    a.add(b);
                                                                    return a;
                                                                  });
  for (const auto& [r, p, q, times] : determinants_) {
    for (int i = 0; i < std::abs(times); ++i) sum.add(r, p, q, times > 0);
  }
  return sum.value();
}

Rational VolumeSum::total() {
  merge_corners();
  Term doubles{{kNoPole, kNoPole, kNoPole}, sum_of_doubles(), 0};
  doubles.exponent = 3 * points_.exponent();
  terms_.push_back(std::move(doubles));
  number_along_terms();
  int exponent = terms_[0].exponent;
  for (const Term& term : terms_) exponent = std::min(exponent, term.exponent);
  std::ranges::sort(terms_, {}, &Term::poles);
  std::vector<PoleSum> sums;
  const Term* last = nullptr;
  for (Term& term : terms_) {
    term.numerator <<= static_cast<mp_bitcnt_t>(term.exponent - exponent);
    if (last == nullptr || last->poles != term.poles) {
      std::vector<Pole> poles(term.poles.begin(), std::ranges::find(term.poles, kNoPole));
      Integer denominator = product(weights_, poles);
      sums.push_back({std::move(poles), 0, std::move(denominator)});
    }
    sums.back().numerator += term.numerator;
    last = &term;
  }
  const PoleSum six = sum_of(weights_, sums);
  Rational out(six.numerator, six.denominator);
  out.canonicalize();
  if (exponent >= 0) out <<= static_cast<mp_bitcnt_t>(exponent);
  else out >>= static_cast<mp_bitcnt_t>(-exponent);
  return out / 6;
}

// Depth first over the poles that have a term in common.
void VolumeSum::number_along_terms() {
  std::vector<std::pair<Pole, Pole>> links;
  for (const Term& term : terms_) {
    for (const Pole a : term.poles) {
      for (const Pole b : term.poles) {
        if (a != kNoPole && b != kNoPole) links.emplace_back(a, b);
      }
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
    for (Pole& p : term.poles) p = p == kNoPole ? p : number[p];
    std::ranges::sort(term.poles);
  }
}

}  // namespace

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
