#include "csg/weld/planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "csg/geometry/planar_polygon.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/refine/box_tree.h"

namespace cnrg::welding {
namespace {

double square_distance_to_segment(const Vector& a, const Vector& b, const Vector& p) {
  const Vector along = minus(b, a), to = minus(p, a);
  const double square = dot(along, along), t = square > 0 ? std::clamp(dot(along, to) / square, 0.0, 1.0) : 0;
  const Vector off{to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2]};
  return dot(off, off);
}

/// The two coordinates that a projection along the largest component of the normal keeps.
std::array<std::size_t, 2> kept(const Vector& normal) {
  const std::size_t axis = steepest_axis(normal);
  return {(axis + 1) % 3, (axis + 2) % 3};
}

/// True if a side of the first loop parts the two, but for a strip.
bool parts(const std::vector<Index>& a, const std::vector<Index>& b, const std::vector<Vector>& points,
           std::size_t u, std::size_t v, double d) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector &from = points[a[i]], &to = points[a[i + 1 < a.size() ? i + 1 : 0]];
    const double x = to[v] - from[v], y = from[u] - to[u], length = hypotenuse(x, y);
    if (length == 0) continue;
    const auto range = [&](const std::vector<Index>& loop) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Index p : loop) {
        const double at = (x * (points[p][u] - from[u]) + y * (points[p][v] - from[v])) / length;
        low = std::min(low, at);
        high = std::max(high, at);
      }
      return std::array{low, high};
    };
    const auto of_a = range(a), of_b = range(b);
    if (std::max(of_b[0] - of_a[1], of_a[0] - of_b[1]) > -d) return true;
  }
  return false;
}

double largest(const Vector& a) { return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }

/// Twice the area vector of a loop, seen from its first corner.
Vector area_of(const std::vector<Vector>& near, const std::vector<Index>& loop) {
  Vector sum{0, 0, 0};
  const auto side = [&](std::size_t i) { return minus(near[loop[i]], near[loop[0]]); };
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vector part = cross(side(i), side(i + 1));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += part[k];
  }
  return sum;
}

/// How wide corners are along a normal whose largest component is 1, and the middle of them.
struct Slab {
  Rational width, low, high;
  Rational middle() const { return (low + high) / 2; }
};

class PlaneFinder {
 public:
  PlaneFinder(const WeldModel& model, const std::vector<Index>& number, const std::vector<RationalPoint>& points,
              const std::vector<Vector>& near, const std::vector<Index>& spot_of, const Rational& d)
      : model_(model),
        number_(number),
        points_(points),
        near_(near),
        spot_of_(spot_of),
        d_(d),
        d_up_(rounded_up(d)) {
    for (const Vector& p : near_) scale_ = std::max(scale_, largest(p));
  }

  Planes run() {
    make_parts();
    join();
    make_carriers();
    return std::move(found_);
  }

 private:
  struct Cluster {
    std::vector<Index> parts;
    Index largest = 0;  ///< part
    Vector normal{0, 0, 0};
    Slab slab;
  };

  // --- parts

  void make_parts() {
    std::vector<std::vector<Index>> of_face(model_.faces.size());
    for (Index f = 0; f < model_.facets.size(); ++f) of_face[model_.facets[f].face].push_back(f);
    for (Index face = 0; face < of_face.size(); ++face) {
      curved_.push_back(model_.faces[face].curved || !add_part(face, of_face[face]));
      if (!curved_.back()) continue;
      for (const Index facet : of_face[face]) add_part(face, {facet});
    }
    const auto key = [](const Part& p) { return std::tie(p.box.lo, p.box.hi, p.area, p.corners); };
    std::sort(found_.parts.begin(), found_.parts.end(),
              [&](const Part& a, const Part& b) { return key(a) < key(b); });
  }

  /// False if the facets are not flat together.
  bool add_part(Index face, const std::vector<Index>& facets) {
    Part part;
    part.face = face;
    part.facets = facets;
    for (const Index facet : facets) {
      const WeldModel::Loops& loops = model_.facets[facet].loops;
      Box& box = part.boxes.emplace_back();
      Vector outer{0, 0, 0};
      for (std::size_t i = 0; i < loops.size(); ++i) {
        std::vector<Index> loop;
        for (const Index p : loops[i]) loop.push_back(number_[p]);
        for (const Index p : loop) box.extend(near_[p], near_[p]);
        Vector area = area_of(near_, loop);
        if (i == 0) outer = area;
        const double sign = i > 0 && dot(area, outer) > 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) part.area[k] += sign * area[k];
        part.corners.insert(part.corners.end(), loop.begin(), loop.end());
      }
    }
    sort_unique(part.corners);
    for (const Box& box : part.boxes) part.box.extend(box);
    if (part.corners.size() < 3 || largest(part.area) == 0) return false;
    part.area = narrower(part.area, part.corners);
    if (slab(part.area, part.corners).width > d_ * length(part.area)) return false;
    found_.parts.push_back(std::move(part));
    return true;
  }

  // --- slabs

  /// Of a vector with the largest component 1: its length, not less than 1 and never too large.
  static Rational length(const Vector& v) {
    const double m = largest(v);
    const double l = std::sqrt(dot(v, v)) / m * (1 - 1e-15);
    return from_double(std::max(1.0, l));
  }
  static RationalPoint unit(const Vector& v) {
    const double m = largest(v);
    return {from_double(v[0] / m), from_double(v[1] / m), from_double(v[2] / m)};
  }

  Slab slab(const RationalPoint& normal, const std::vector<Index>& corners) const {
    Slab s;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Rational at = dot(normal, points_[corners[i]]);
      if (i == 0 || at < s.low) s.low = at;
      if (i == 0 || at > s.high) s.high = at;
    }
    s.width = s.high - s.low;
    return s;
  }
  Slab slab(const Vector& v, const std::vector<Index>& corners) const { return slab(unit(v), corners); }

  /// A lower bound of the width of a slab, as a distance: cheap, to leave out what is far from flat.
  double least_width(const Vector& v, const Part& a, const Part& b) const {
    const double m = std::sqrt(dot(v, v));
    double low = kInfinity, high = -low;
    const Vector& from = near_[a.corners[0]];
    for (const Part* part : {&a, &b}) {
      for (const Index p : part->corners) {
        const double at = dot(v, minus(near_[p], from)) / m;
        low = std::min(low, at);
        high = std::max(high, at);
      }
    }
    return high - low - 1e-14 * scale_;
  }

  static Vector added(const Vector& a, const Vector& b) {
    const double sign = dot(a, b) < 0 ? -1 : 1;
    return {a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]};
  }

  /// The normal of least squares, as long as `v`, if only planes are asked for and its slab is narrower.
  Vector narrower(const Vector& v, const std::vector<Index>& corners) const {
    if (!model_.only_planes || corners.size() < 4) return v;
    std::vector<RationalPoint> points;
    for (const Index p : corners) points.push_back(points_[p]);
    const Vector n = to_doubles(least_squares_normal(points, unit(v)));
    if (largest(n) == 0 || slab(n, corners).width / length(n) >= slab(v, corners).width / length(v)) return v;
    const double scale = std::sqrt(dot(v, v) / dot(n, n));
    return {scale * n[0], scale * n[1], scale * n[2]};
  }

  // --- joining

  /// Facets of curved faces that only touch, as neighbours do, need no common plane.
  bool may_join(const Part& a, const Part& b, bool on_each_other) const {
    return a.face != b.face && (on_each_other || !(curved_[a.face] || curved_[b.face]));
  }

  /// True if two facets overlap, or a corner of one part is on the other and no corner of it.
  bool on_each_other(const Part& a, const Part& b) const {
    for (std::size_t i = 0; i < a.facets.size(); ++i) {
      const WeldModel::Loops first = loops_of(a.facets[i]);
      for (std::size_t j = 0; j < b.facets.size(); ++j) {
        if (a.boxes[i].meets(grown(b.boxes[j], d_up_)) &&
            overlap(first, loops_of(b.facets[j]), near_, a.area, d_up_))
          return true;
      }
    }
    return has_corner_on(a, b) || has_corner_on(b, a);
  }

  std::vector<Index> spots(const Part& part) const {
    std::vector<Index> list;
    for (const Index p : part.corners) list.push_back(spot_of_[p]);
    std::sort(list.begin(), list.end());
    return list;
  }

  /// Whatever becomes of their corners, these stay the same.
  bool same_triangle(const Part& a, const Part& b) const {
    return a.corners.size() == 3 && b.corners.size() == 3 && spots(a) == spots(b);
  }

  bool has_corner_on(const Part& a, const Part& b) const {
    const std::vector<Index> corners = spots(b);
    return std::any_of(a.corners.begin(), a.corners.end(), [&](Index p) {
      if (std::binary_search(corners.begin(), corners.end(), spot_of_[p])) return false;
      Box at;
      at.extend(near_[p], near_[p]);
      at = grown(at, d_up_);
      for (std::size_t i = 0; i < b.facets.size(); ++i) {
        if (b.boxes[i].meets(at) && is_in(loops_of(b.facets[i]), near_, b.area, near_[p], d_up_)) return true;
      }
      return false;
    });
  }

  WeldModel::Loops loops_of(Index facet) const { return numbered_loops(model_, facet, number_); }

  void join() {
    const std::vector<Part>& parts = found_.parts;
    std::vector<Box> boxes;
    boxes.reserve(parts.size());
    for (const Part& part : parts) boxes.push_back(part.box);
    const BoxTree tree(boxes);
    std::vector<std::tuple<double, Index, Index>> pairs;
    std::vector<std::pair<Index, Index>> overlaps;
    for (Index a = 0; a < parts.size(); ++a) {
      const Box around = grown(parts[a].box, d_up_);
      tree.query([&](const Box& box) { return box.meets(around); },
                 [&](Index b) {
                   if (b <= a) return;
                   const double width = width_of_pair(parts[a], parts[b]);
                   if (width < 0) return;
                   const bool overlap = on_each_other(parts[a], parts[b]);
                   if (overlap && !same_triangle(parts[a], parts[b])) overlaps.emplace_back(a, b);
                   if (may_join(parts[a], parts[b], overlap)) pairs.emplace_back(width, a, b);
                 });
    }
    std::sort(pairs.begin(), pairs.end());
    clusters_.resize(parts.size());
    for (Index i = 0; i < parts.size(); ++i) {
      clusters_[i] = {{i}, i, parts[i].area, slab(parts[i].area, parts[i].corners)};
    }
    sets_ = UnionFind(parts.size());
    for (const auto& [width, a, b] : pairs) unite(sets_.find(a), sets_.find(b));
    for (const auto& [width, a, b] : pairs) {
      if (sets_.find(a) != sets_.find(b)) found_.left.emplace_back(a, b);
    }
    overlap_.assign(parts.size(), false);
    for (const auto& [a, b] : overlaps) {
      if (sets_.find(a) == sets_.find(b)) overlap_[sets_.find(a)] = true;
    }
  }

  /// The width of the slab that holds two parts, rounded; below 0 if it is wider than d.
  double width_of_pair(const Part& a, const Part& b) const {
    double best = -1;
    const Vector both = added(a.area, b.area);
    const Vector& larger = dot(a.area, a.area) < dot(b.area, b.area) ? b.area : a.area;
    for (const Vector& v : {both, larger}) {
      if (largest(v) == 0 || least_width(v, a, b) > d_up_) continue;
      const RationalPoint n = unit(v);
      const Slab s = slab(n, a.corners), t = slab(n, b.corners);
      const Rational width = (std::max(s.high, t.high) - std::min(s.low, t.low)) / length(v);
      if (width > d_) continue;
      const double rounded = to_double(width);
      if (best < 0 || rounded < best) best = rounded;
    }
    return best;
  }

  /// Joins two clusters if a slab holds them. The normal of the larger one is tried first, which leaves its own
  /// corners alone: many small parts on one plane cost no more than their number.
  void unite(Index i, Index j) {
    if (i == j) return;
    const bool swap = clusters_[i].parts.size() < clusters_[j].parts.size();
    Cluster &large = clusters_[swap ? j : i], &small = clusters_[swap ? i : j];
    std::vector<Index> corners;
    for (const Index p : small.parts) append(corners, found_.parts[p].corners);
    const auto bigger = [&](Index a, Index b) {
      const double x = dot(found_.parts[a].area, found_.parts[a].area);
      const double y = dot(found_.parts[b].area, found_.parts[b].area);
      return x < y ? b : y < x ? a : std::min(a, b);
    };
    Cluster both;
    both.largest = bigger(large.largest, small.largest);
    Slab s = slab(large.normal, corners);
    s.low = std::min(s.low, large.slab.low);
    s.high = std::max(s.high, large.slab.high);
    s.width = s.high - s.low;
    both.normal = large.normal;
    both.slab = s;
    if (s.width > d_ * length(large.normal)) {
      for (const Index p : large.parts) append(corners, found_.parts[p].corners);
      bool held = false;
      for (const Vector& v : {total_area(large, small), found_.parts[both.largest].area}) {
        if (held || largest(v) == 0) continue;
        both.normal = v;
        both.slab = slab(v, corners);
        held = both.slab.width <= d_ * length(v);
      }
      if (!held) return;
    }
    append(large.parts, small.parts);
    both.parts = std::move(large.parts);
    small = Cluster();
    sets_.unite(i, j);
    clusters_[sets_.find(i)] = std::move(both);
  }

  template <class List>
  static void append(List& list, const List& more) {
    list.insert(list.end(), more.begin(), more.end());
  }

  /// The sum of areas, turned alike, in the order of the parts.
  Vector total_area(const Cluster& a, const Cluster& b) const {
    std::vector<Index> parts = a.parts;
    append(parts, b.parts);
    return total_area(std::move(parts));
  }
  Vector total_area(std::vector<Index> parts) const {
    std::sort(parts.begin(), parts.end());
    Vector sum = found_.parts[parts[0]].area;
    for (std::size_t i = 1; i < parts.size(); ++i) sum = added(sum, found_.parts[parts[i]].area);
    return sum;
  }

  // --- carriers

  void make_carriers() {
    found_.carrier_of.resize(found_.parts.size());
    for (Index i = 0; i < found_.parts.size(); ++i) {
      if (sets_.find(i) != i) continue;
      Carrier carrier;
      carrier.parts = clusters_[i].parts;
      std::sort(carrier.parts.begin(), carrier.parts.end());
      for (const Index p : carrier.parts) {
        append(carrier.corners, found_.parts[p].corners);
        found_.carrier_of[p] = static_cast<Index>(found_.carriers.size());
      }
      sort_unique(carrier.corners);
      carrier.overlap = overlap_[i];
      place(carrier, clusters_[i]);
      found_.carriers.push_back(std::move(carrier));
    }
  }

  /// The plane of a carrier: the exact one if there is one, else the one with the shortest numbers among those
  /// that are about as near to the corners as any: within d / 8, or an eighth of the slab where planes are all.
  void place(Carrier& carrier, const Cluster& cluster) const {
    if (exact_plane(carrier)) return;
    const Vector total = narrower(total_area(cluster.parts), carrier.corners);
    Vector best = cluster.normal;
    Slab at = cluster.slab;
    if (largest(total) > 0) {
      const Slab s = slab(total, carrier.corners);
      if (s.width / length(total) < at.width / length(best)) best = total, at = s;
    }
    const RationalPoint n = unit(best);
    const Rational width = at.width / length(best), slack = model_.only_planes ? width : d_;
    const Rational most = std::min(d_, Rational(width + slack / 8));
    carrier.plane = {n, rounded(at.middle(), slack)};
    constexpr int kSteps[] = {0, 4, 8, 16, 24, 32, 40};
    for (const int bits : kSteps) {
      RationalPoint shorter;
      for (std::size_t k = 0; k < 3; ++k)
        shorter[k] = from_double(std::ldexp(std::nearbyint(std::ldexp(to_double(n[k]), bits)), -bits));
      const Slab s = slab(shorter, carrier.corners);
      // The length of the normal is at least 1: without it this is on the safe side.
      if (s.width > (model_.only_planes ? Rational(most * length(to_doubles(shorter))) : most)) continue;
      carrier.plane = {shorter, rounded(s.middle(), slack)};
      return;
    }
  }

  static Rational scaled(const Rational& x, int exponent) {
    Rational result;
    const auto by = static_cast<unsigned>(std::abs(exponent));
    if (exponent < 0) mpq_div_2exp(result.get_mpq_t(), x.get_mpq_t(), by);
    else mpq_mul_2exp(result.get_mpq_t(), x.get_mpq_t(), by);
    return result;
  }

  /// The nearest multiple of a power of two that is at most 1/32 of `slack`.
  static Rational rounded(const Rational& x, const Rational& slack) {
    const int exponent = std::ilogb(rounded_up(slack)) - 6;
    const Rational at = scaled(x, -exponent) + Rational(1, 2);
    Integer whole;
    mpz_fdiv_q(whole.get_mpz_t(), at.get_num_mpz_t(), at.get_den_mpz_t());
    return scaled(Rational(whole), exponent);
  }

  bool exact_plane(Carrier& carrier) const {
    // Three corners that span most: the first, the farthest from it, the farthest from their line.
    const std::vector<Index>& c = carrier.corners;
    const auto farthest = [&](const auto& measure) {
      Index best = c[0];
      double most = -1;
      for (const Index p : c) {
        const double at = measure(near_[p]);
        if (at > most) most = at, best = p;
      }
      return best;
    };
    const Vector& o = near_[c[0]];
    const Index b = farthest([&](const Vector& p) { return dot(minus(p, o), minus(p, o)); });
    const Vector along = minus(near_[b], o);
    const Index e = farthest([&](const Vector& p) {
      const Vector x = cross(minus(p, o), along);
      return dot(x, x);
    });
    RationalPoint n = cross(points_[b] - points_[c[0]], points_[e] - points_[c[0]]);
    if (is_zero(n)) return false;
    Rational most = 0;
    for (const Rational& x : n) most = std::max(most, Rational(abs(x)));
    n = Rational(1 / most) * n;
    const Rational offset = dot(n, points_[c[0]]);
    for (const Index p : c) {
      if (dot(n, points_[p]) != offset) return false;
    }
    carrier.plane = {n, offset};
    carrier.exact = true;
    return true;
  }

  const WeldModel& model_;
  const std::vector<Index>& number_;
  const std::vector<RationalPoint>& points_;
  const std::vector<Vector>& near_;
  const std::vector<Index>& spot_of_;
  const Rational& d_;
  double d_up_, scale_ = 0;
  Planes found_;
  std::vector<bool> curved_;  // of faces
  std::vector<Cluster> clusters_;
  UnionFind sets_;
  std::vector<bool> overlap_;  // of clusters: some of its parts lie on each other
};

}  // namespace

bool overlap(const WeldModel::Loops& a, const WeldModel::Loops& b, const std::vector<Vector>& points,
             const Vector& normal, double d) {
  const auto [u, v] = kept(normal);
  return !parts(a[0], b[0], points, u, v, d) && !parts(b[0], a[0], points, u, v, d);
}

bool is_in(const WeldModel::Loops& loops, const std::vector<Vector>& points, const Vector& normal, const Vector& p,
           double d) {
  const auto [u, v] = kept(normal);
  bool inside = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector &a = points[loop[i]], &b = points[loop[i + 1 < loop.size() ? i + 1 : 0]];
      if (square_distance_to_segment(a, b, p) <= d * d) return true;
      if ((a[v] > p[v]) == (b[v] > p[v])) continue;
      if (p[u] < a[u] + (p[v] - a[v]) * ((b[u] - a[u]) / (b[v] - a[v]))) inside = !inside;
    }
  }
  return inside;
}

Box grown(const Box& box, double by) {
  Box result = box;
  for (std::size_t k = 0; k < 3; ++k) {
    result.lo[k] = std::nextafter(std::nextafter(box.lo[k], -kInfinity) - by, -kInfinity);
    result.hi[k] = std::nextafter(std::nextafter(box.hi[k], kInfinity) + by, kInfinity);
  }
  return result;
}

WeldModel::Loops numbered_loops(const WeldModel& model, Index facet, const std::vector<Index>& number) {
  WeldModel::Loops loops = model.facets[facet].loops;
  for (auto& loop : loops) {
    for (Index& p : loop) p = number[p];
  }
  return loops;
}

double rounded_up(const Rational& d) { return std::nextafter(to_double(d), kInfinity); }

Planes find_planes(const WeldModel& model, const std::vector<Index>& number,
                   const std::vector<RationalPoint>& points, const std::vector<Vector>& near,
                   const std::vector<Index>& spot_of, const Rational& d) {
  return PlaneFinder(model, number, points, near, spot_of, d).run();
}

}  // namespace cnrg::welding
