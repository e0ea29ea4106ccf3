// CGAL's tree of boxes over exact simplices; its lazy numbers decide most comparisons by intervals.
#include "kernel/exact/distance.h"

#include <CGAL/AABB_tree.h>
#include <mpfr.h>

#include <optional>

#if __has_include(<CGAL/AABB_traits_3.h>)  // CGAL 6 has a second dimension of these
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include "kernel/base/error.h"
#include "kernel/exact/lazy.h"

namespace cnrg {
namespace {

using K = lazy::Kernel;
using lazy::point;
using Segments = std::vector<K::Segment_3>;
using Triangles = std::vector<K::Triangle_3>;
#if __has_include(<CGAL/AABB_traits_3.h>)
template <class Primitive>
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<K, Primitive>>;
using SegmentTree = Tree<CGAL::AABB_segment_primitive_3<K, Segments::const_iterator>>;
using TriangleTree = Tree<CGAL::AABB_triangle_primitive_3<K, Triangles::const_iterator>>;
#else
template <class Primitive>
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<K, Primitive>>;
using SegmentTree = Tree<CGAL::AABB_segment_primitive<K, Segments::const_iterator>>;
using TriangleTree = Tree<CGAL::AABB_triangle_primitive<K, Triangles::const_iterator>>;
#endif

template <class Number>
Rational rational(const Number& value) {
  if constexpr (requires { value.backend().data(); }) return Rational(value.backend().data());
  else if constexpr (requires { value.mpq(); }) return Rational(value.mpq());
  else return Rational(value);
}

}  // namespace

struct DistanceTo::Trees {
  Segments segments;
  Triangles triangles;
  SegmentTree of_segments;
  TriangleTree of_triangles;
};

DistanceTo::DistanceTo(std::span<const RationalPoint> points,
                       std::span<const std::array<std::uint32_t, 1>> vertices,
                       std::span<const std::array<std::uint32_t, 2>> segments,
                       std::span<const std::array<std::uint32_t, 3>> triangles)
    : trees_(std::make_unique<Trees>()) {
  require(!(vertices.empty() && segments.empty() && triangles.empty()), "a distance to nothing");
  // A point is a segment from it to itself.
  for (const auto& [a] : vertices) trees_->segments.emplace_back(point(points[a]), point(points[a]));
  for (const auto& [a, b] : segments) trees_->segments.emplace_back(point(points[a]), point(points[b]));
  for (const auto& [a, b, c] : triangles) {
    trees_->triangles.emplace_back(point(points[a]), point(points[b]), point(points[c]));
  }
  trees_->of_segments.insert(trees_->segments.cbegin(), trees_->segments.cend());
  trees_->of_triangles.insert(trees_->triangles.cbegin(), trees_->triangles.cend());
}

DistanceTo::~DistanceTo() = default;
DistanceTo::DistanceTo(DistanceTo&&) noexcept = default;

Rational DistanceTo::squared(const RationalPoint& p) const {
  const K::Point_3 q = point(p);
  std::optional<K::FT> least;
  const auto see = [&](const auto& tree) {
    if (tree.empty()) return;
    const K::FT d = tree.squared_distance(q);
    if (!least || d < *least) least = d;
  };
  see(trees_->of_triangles);
  see(trees_->of_segments);
  return rational(least->exact());
}

double nearest_root(const Rational& square) {
  require(sgn(square) >= 0, "the root of a negative number");
  // A root half-way between two doubles has 54 bits, its square 108: then both bounds are exact. Any other root is
  // told from the middle by enough bits (Ziv 1991).
  for (mpfr_prec_t precision = 128;; precision *= 2) {
    mpfr_t low, high;
    mpfr_init2(low, precision);
    mpfr_init2(high, precision);
    mpfr_set_q(low, square.get_mpq_t(), MPFR_RNDD);
    mpfr_set_q(high, square.get_mpq_t(), MPFR_RNDU);
    mpfr_sqrt(low, low, MPFR_RNDD);
    mpfr_sqrt(high, high, MPFR_RNDU);
    const double a = mpfr_get_d(low, MPFR_RNDN), b = mpfr_get_d(high, MPFR_RNDN);
    mpfr_clear(low);
    mpfr_clear(high);
    if (a == b) return a;
  }
}

}  // namespace cnrg
