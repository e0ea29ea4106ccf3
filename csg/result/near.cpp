#include "csg/result/near.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>

#include "kernel/base/error.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

using Index = Parts::Index;

double largest(const DoubleVector& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// The nearest points of two points, segments and triangles, exactly: closest points of rational simplices are
/// rational, and so is the square of their distance. Only what is nearest in the interior of both is asked for.
struct NearestPoints {
  RationalPoint a, b;  ///< on the first and on the second
  Rational squared;    ///< of their distance
};

NearestPoints nearest_pair(const RationalPoint& a, RationalPoint b) {
  const RationalPoint d = b - a;
  return {a, std::move(b), dot(d, d)};
}

/// Of p and the open segment from a to b; nothing if p is nearest to an end.
std::optional<NearestPoints> nearest_in_segment(const RationalPoint& p, const RationalPoint& a,
                                                const RationalPoint& b) {
  const RationalPoint along = whole(b - a);
  const auto beyond = [&](const RationalPoint& end) { return sgn(dot(whole(p - end), along)); };
  if (beyond(a) <= 0 || beyond(b) >= 0) return {};
  return nearest_pair(p, a + Rational(dot(p - a, along) / dot(along, along)) * along);
}

/// Of p and the closed triangle; nothing unless p is straight above or below it. The triangle must have an area.
std::optional<NearestPoints> nearest_in_triangle(const RationalPoint& p, const RationalPoint& a,
                                                 const RationalPoint& b, const RationalPoint& c) {
  const RationalPoint normal = cross(whole(b - a), whole(c - a));
  const auto beside = [&](const RationalPoint& from, const RationalPoint& to) {
    return dot(cross(whole(to - from), whole(p - from)), normal) < 0;
  };
  if (beside(a, b) || beside(b, c) || beside(c, a)) return {};
  const Rational height = dot(p - a, normal) / dot(normal, normal);
  return nearest_pair(p, p - height * normal);
}

/// Of the open segments from a to b and from c to d; nothing if an end is as near, so also if they are parallel.
std::optional<NearestPoints> nearest_in_segments(const RationalPoint& a, const RationalPoint& b,
                                                 const RationalPoint& c, const RationalPoint& d) {
  const RationalPoint u = whole(b - a), v = whole(d - c), normal = cross(u, v);
  if (is_zero(normal)) return {};
  // On which side of the end of one line the other line passes, as seen along the normal.
  const auto side = [&](const RationalPoint& from, const RationalPoint& to, const RationalPoint& line) {
    return sgn(dot(cross(whole(to - from), line), normal));
  };
  if (side(a, c, v) <= 0 || side(b, c, v) >= 0 || side(a, c, u) <= 0 || side(a, d, u) >= 0) return {};
  const RationalPoint w = c - a;
  const Rational square = dot(normal, normal);
  return nearest_pair(a + Rational(dot(cross(w, v), normal) / square) * u,
                      c + Rational(dot(cross(w, u), normal) / square) * v);
}

template <class Loops, class Visit>
void for_each_side(const Loops& loops, const Visit& visit) {
  for (const auto& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) visit(loop[k], loop[(k + 1) % loop.size()]);
  }
}

}  // namespace

Parts::Parts(const ResultView& view, const FlatComplex& flat) : flat_(flat) {
  const PointTable& table = view.complex->points;
  const std::size_t n = flat.points.size();
  points_.resize(n), lo_.resize(n), hi_.resize(n);
  for_each_index(
      n,
      [&](std::size_t p) {
        const VertexId v = flat.points[p];
        points_[p] = table.rational(v);
        // The bounds of the table may be wide, even infinite, where planes that make a point are nearly parallel.
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = to_double(points_[p][k]);
          const bool same = is_double(points_[p][k]);
          lo_[p][k] = same ? x : std::nextafter(x, -kInfinity);
          hi_[p][k] = same ? x : std::nextafter(x, kInfinity);
        }
      },
      64);
  Box all;
  for (std::size_t p = 0; p < n; ++p) all.extend(lo_[p], hi_[p]);
  if (n > 0) diagonal_ = hypotenuse(all.hi[0] - all.lo[0], all.hi[1] - all.lo[1], all.hi[2] - all.lo[2]);

  constexpr Cell kUnknown{3, 0};
  cell_of_point_.assign(n, kUnknown);
  for (Index v = 0; v < flat.vertices.size(); ++v) cell_of_point_[flat.vertices[v].point] = {0, v};
  const auto add_segment = [&](Index a, Index b, Index edge, Index face) {
    if (sides_.insert(edge_key(a, b)).second) segments_.push_back({{std::min(a, b), std::max(a, b)}, edge, face});
  };
  for (Index e = 0; e < flat.edges.size(); ++e) {
    const FlatComplex::Edge& edge = flat.edges[e];
    for (const Index p : edge.points) {
      if (cell_of_point_[p] == kUnknown) cell_of_point_[p] = {1, e};
    }
    for_each_segment(edge, [&](Index a, Index b) { add_segment(a, b, e, kNone); });
  }
  for (Index f = 0; f < flat.faces.size(); ++f) {
    const FlatComplex::Face& face = flat.faces[f];
    for (const FlatComplex::Facet& facet : face.facets)
      for_each_side(facet.loops, [&](Index a, Index b) { add_segment(a, b, kNone, f); });
    Index number = 0;
    for_each_facet(face, [&](const auto&, const auto&, Index begin, Index end) {
      Facet& facet = facets_.emplace_back(Facet{f, number++, {}});
      for (Index i = begin; i < end; ++i) {
        const auto& t = face.triangles[i];
        facet.corners.insert(facet.corners.end(), t.begin(), t.end());
        triangles_.push_back({t, Index(facets_.size() - 1)});
      }
      sort_unique(facet.corners);
      for (const Index p : facet.corners) {
        if (cell_of_point_[p] == kUnknown) cell_of_point_[p] = {2, f};
      }
    });
  }
  std::sort(segments_.begin(), segments_.end(),
            [](const Segment& a, const Segment& b) { return a.ends < b.ends; });
}

Parts::Cell Parts::cell_of_segment(Index s) const {
  const Segment& segment = segments_[s];
  return segment.edge == kNone ? Cell{2, segment.face} : Cell{1, segment.edge};
}

const std::vector<FlatComplex::Loop>& Parts::loops(const Facet& facet) const {
  const FlatComplex::Face& face = flat_.faces[facet.face];
  return face.facets.empty() ? face.loops : face.facets[facet.number].loops;
}

const ShortList<Parts::Index, 2>& Parts::isolated(const Facet& facet) const {
  const FlatComplex::Face& face = flat_.faces[facet.face];
  return face.facets.empty() ? face.isolated : face.facets[facet.number].isolated;
}

/// Pairs of one kind. A determinant of doubles tells most pairs that are far: what it is off by is bounded by what
/// vectors between points are off by, which is `off_` at most in each coordinate.
class NearSearch {
 public:
  NearSearch(const Parts& parts, const Rational& within, Ends ends)
      : parts_(parts),
        ends_(ends),
        square_(within * within),
        reach_(std::nextafter(to_double(within), kInfinity)) {
    double size = 0, width = 0;
    for (std::size_t p = 0; p < parts.points_.size(); ++p) {
      auto& x = middle_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const double lo = parts.lo_[p][k], hi = parts.hi_[p][k];
        x[k] = lo + (hi - lo) / 2;
        size = std::max({size, std::abs(lo), std::abs(hi)});
        width = std::max(width, hi - lo);
      }
    }
    off_ = 2 * width + 8 * kUlp * size;
  }

  /// Nothing where there are more than `most`.
  std::optional<std::vector<NearPair>> run(Near kind, std::size_t most, const Watch& watch) {
    const std::size_t n = kind == Near::segments ? parts_.segments_.size() : parts_.points_.size();
    Steps steps(watch, "near features", n);
    const BoxTree tree(boxes(kind));
    watch.check();
    std::vector<std::vector<NearPair>> found(n);
    std::atomic<std::size_t> count = 0;
    for_each_index(
        n,
        [&](std::size_t i) {
          steps.step();
          if (count.load(std::memory_order_relaxed) > most) return;
          const Index a = Index(i);
          const Box own = kind == Near::segments ? around(parts_.segments_[a].ends) : around(std::array{a});
          tree.query([&](const Box& other) { return other.meets(own); },
                     [&](std::uint32_t b) {
                       if (auto pair = meet(kind, a, b)) found[i].push_back(std::move(*pair));
                     });
          count += found[i].size();
        },
        64);
    watch.check();
    if (count > most) return {};
    std::vector<NearPair> out;
    for (auto& list : found) std::move(list.begin(), list.end(), std::back_inserter(out));
    std::sort(out.begin(), out.end(), [](const NearPair& x, const NearPair& y) {
      const int order = cmp(x.squared, y.squared);
      return order != 0 ? order < 0 : std::pair(x.a, x.b) < std::pair(y.a, y.b);
    });
    // Above a side that two triangles of a facet share, both are met.
    out.erase(std::unique(out.begin(), out.end(),
                          [](const NearPair& x, const NearPair& y) { return x.a == y.a && x.b == y.b; }),
              out.end());
    return out;
  }

 private:
  const Parts& parts_;
  const Ends ends_;
  const Rational square_;
  const double reach_;  // at least the distance
  double off_ = 0;
  std::vector<DoubleVector> middle_;

  template <class Points>
  Box hull(const Points& points) const {
    Box box;
    for (const Index p : points) box.extend(parts_.lo_[p], parts_.hi_[p]);
    return box;
  }
  template <class Points>
  Box around(const Points& points) const {
    Box box = hull(points);
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = std::nextafter(box.lo[k] - reach_, -kInfinity);
      box.hi[k] = std::nextafter(box.hi[k] + reach_, kInfinity);
    }
    return box;
  }
  std::vector<Box> boxes(Near kind) const {
    std::vector<Box> out;
    if (kind == Near::points) {
      for (Index p = 0; p < parts_.points_.size(); ++p) out.push_back(hull(std::array{p}));
    } else if (kind == Near::point_facet) {
      for (const Parts::Triangle& t : parts_.triangles_) out.push_back(hull(t.corners));
    } else {
      for (const Parts::Segment& s : parts_.segments_) out.push_back(hull(s.ends));
    }
    return out;
  }

  std::optional<NearPair> meet(Near kind, Index a, Index b) const {
    const auto& x = parts_.points_;
    std::optional<NearestPoints> nearest;
    if (kind == Near::points) {
      if (a >= b || (ends_ == Ends::left_out && parts_.is_segment(a, b))) return {};
      nearest = nearest_pair(x[a], x[b]);
    } else if (kind == Near::point_segment) {
      const auto& [p, q] = parts_.segments_[b].ends;
      if (a == p || a == q || is_far(a, p, q) || are_apart(std::array{a}, std::array{p, q})) return {};
      nearest = nearest_in_segment(x[a], x[p], x[q]);
    } else if (kind == Near::point_facet) {
      const Parts::Triangle& t = parts_.triangles_[b];
      const auto& corners = parts_.facets_[t.facet].corners;
      if (std::binary_search(corners.begin(), corners.end(), a)) return {};
      const auto& [p, q, r] = t.corners;
      if (is_far({p, q}, {p, r}, {p, a}) || are_apart(std::array{a}, t.corners)) return {};
      nearest = nearest_in_triangle(x[a], x[p], x[q], x[r]);
      if (nearest && is_on_boundary(t, nearest->b)) return {};
      b = t.facet;
    } else {
      const auto &s = parts_.segments_[a].ends, &t = parts_.segments_[b].ends;
      if (a >= b || s[0] == t[0] || s[0] == t[1] || s[1] == t[0] || s[1] == t[1]) return {};
      if (is_far(s, t, {s[0], t[0]}) || are_apart(s, t) || are_apart(t, s)) return {};
      nearest = nearest_in_segments(x[s[0]], x[s[1]], x[t[0]], x[t[1]]);
    }
    if (!nearest || nearest->squared >= square_) return {};
    return NearPair{kind, a, b, std::move(nearest->a), std::move(nearest->b), std::move(nearest->squared)};
  }

  /// A corner, or on a side that is a segment; other sides of triangles are in the interior of the facet.
  bool is_on_boundary(const Parts::Triangle& t, const RationalPoint& q) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t.corners[k], b = t.corners[(k + 1) % 3];
      if (q == parts_.points_[a]) return true;
      if (parts_.is_segment(a, b) && collinear(parts_.points_[a], parts_.points_[b], q)) return true;
    }
    return false;
  }

  /// Two hulls are certainly not within reach, since along a side of the second, or from a side of it straight to
  /// a point of the first, all of one comes that much before the other. That tells what lies side by side in a
  /// plane.
  bool are_apart(std::span<const Index> first, std::span<const Index> second) const {
    for (std::size_t k = 0; k < (second.size() == 2 ? 1 : second.size()); ++k) {
      const Index p = second[k], q = second[(k + 1) % second.size()];
      const DoubleVector u = vector(p, q);
      const double square = dot(u, u);
      if (is_gap(u, first, second)) return true;
      for (const Index a : first) {
        DoubleVector n = vector(p, a);
        const double along = dot(n, u) / square;
        for (std::size_t i = 0; i < 3; ++i) n[i] -= along * u[i];
        if (is_gap(n, first, second)) return true;
      }
    }
    return false;
  }
  /// Is what is between the hulls along a direction, or along the opposite one, certainly longer than the reach?
  /// Any direction will do, so it may be off.
  bool is_gap(DoubleVector n, std::span<const Index> first, std::span<const Index> second) const {
    const double size = largest(n);
    if (!(size > 0) || !std::isfinite(size)) return false;
    for (double& x : n) x /= size;
    const double reach = reach_ * std::sqrt(dot(n, n)) * (1 + 8 * kUlp);
    double low = kInfinity, high = -kInfinity;
    for (const Index a : first) {
      for (const Index b : second) {
        const DoubleVector w = vector(b, a);
        const double way = dot(n, w), fault = 3 * (off_ + 8 * kUlp * largest(w));
        low = std::min(low, way - fault), high = std::max(high, way + fault);
      }
    }
    return low > reach || high < -reach;
  }

  DoubleVector vector(Index from, Index to) const { return minus(middle_[to], middle_[from]); }

  /// The point a is certainly not within reach of the line through p and q.
  bool is_far(Index a, Index p, Index q) const {
    const DoubleVector u = vector(p, q), w = vector(p, a), c = cross(u, w);
    const double size = largest(u), other = largest(w), product = (size + off_) * (other + off_);
    const double fault = 4 * ((product - size * other) + 16 * kUlp * product);
    return std::sqrt(dot(c, c)) * (1 - 8 * kUlp) - fault >
           reach_ * (std::sqrt(dot(u, u)) + 2 * off_) * (1 + 8 * kUlp);
  }
  /// Two parallel planes, spanned by the first two vectors, are certainly not within reach: w goes from one to the
  /// other.
  bool is_far(const std::array<Index, 2>& from_to_u, const std::array<Index, 2>& from_to_v,
              const std::array<Index, 2>& from_to_w) const {
    const DoubleVector u = vector(from_to_u[0], from_to_u[1]), v = vector(from_to_v[0], from_to_v[1]),
                       w = vector(from_to_w[0], from_to_w[1]), n = cross(u, v);
    const double a = largest(u), b = largest(v), c = largest(w);
    const double area = (a + off_) * (b + off_), volume = area * (c + off_);
    const double area_fault = 4 * ((area - a * b) + 16 * kUlp * area);
    const double fault = 6 * ((volume - a * b * c) + 32 * kUlp * volume);
    return std::abs(dot(n, w)) - fault > reach_ * (std::sqrt(dot(n, n)) + area_fault) * (1 + 8 * kUlp);
  }
};

std::vector<NearPair> near_pairs(const Parts& parts, Near kind, const Rational& within, Ends ends,
                                 const Watch& watch) {
  auto pairs = near_pairs_if_few(parts, kind, within, kMostPairs, ends, watch);
  if (pairs) return std::move(*pairs);
  throw InputError("more than " + std::to_string(kMostPairs) + " pairs are nearer than " + to_decimal(within, 6) +
                   "; give a smaller distance");
}

std::optional<std::vector<NearPair>> near_pairs_if_few(const Parts& parts, Near kind, const Rational& within,
                                                       std::size_t most, Ends ends, const Watch& watch) {
  return NearSearch(parts, within, ends).run(kind, most, watch);
}

std::vector<NearPair> nearest_pairs(const Parts& parts, Near kind, std::size_t count, Ends ends) {
  if (!(parts.diagonal() > 0)) return {};
  if (!std::isfinite(parts.diagonal()))
    throw InputError("the result is larger than doubles reach; give a distance");
  // The reach is doubled until there are enough: then those that are missing are farther than all that were found.
  std::vector<NearPair> out;
  for (double reach = std::ldexp(parts.diagonal(), -40);; reach *= 2) {
    out = near_pairs(parts, kind, from_double(reach), ends);
    if (out.size() >= count || reach > parts.diagonal()) break;
  }
  if (out.size() > count) out.resize(count);
  return out;
}

}  // namespace cnrg
