// Segments to be split come first, then triangles, those with the shortest sides before others: what they need
// often mends the larger ones beside them. The order depends on the mesh alone.
#include "csg/mesh/refine_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "csg/mesh/input_lines.h"
#include "csg/mesh/reach.h"
#include "csg/text/digits.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/tetrahedra/constrained.h"

namespace cnrg {
namespace {

using Index = FacetMesh::Index;
using Vector = FacetMesh::Vector;
constexpr double kRadians = kLeastAngle * 3.14159265358979323846 / 180;

double cosine(const Vector& u, const Vector& v) {
  const double l = std::sqrt(dot(u, u)) * std::sqrt(dot(v, v));
  return l > 0 ? dot(u, v) / l : 1;
}

/// The corner opposite to the shortest side of a triangle.
std::size_t sharpest(const std::array<Vector, 3>& p) {
  std::size_t best = 0;
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < 3; ++k) {
    const double l = distance(p[(k + 1) % 3], p[(k + 2) % 3]);
    if (l < least) least = l, best = k;
  }
  return best;
}

class Refiner {
 public:
  Refiner(FacetMesh& mesh, const SurfaceOptions& options, const SizeAt& said, SurfaceNarrow narrow)
      : mesh_(mesh), options_(options), said_(said), has_narrow_(narrow == SurfaceNarrow::left), lines_(mesh) {
    // Angles of smaller triangles are those of rounding.
    shortest_ = std::ldexp(Reach(mesh_.points()).largest, -32);
    double area = 0;
    for (Index t = 0; t < mesh_.triangles().size(); ++t) {
      const auto p = corners(t);
      area += length(cross(minus(p[1], p[0]), minus(p[2], p[0]))) / 2;
    }
    const double side = std::sqrt(area / double(std::max<std::size_t>(mesh_.triangles().size(), 1)));
    wide_ = narrow_ = std::max(shortest_, kWide * side);
    for (const auto& segment : mesh_.segments()) whole_.push_back(segment.ends);
  }

  std::vector<SmallAngle> run() {
    const double cosine = std::cos(kRadians);
    cosine_ = cosine;
    // A little nearer to the side than the angle would allow, so that it is met.
    off_center_ = 0.475 * std::sqrt((1 + cosine) / (1 - cosine));
    options_.watch.begin("mesh: surface");
    mesh_.make_delaunay();
    look_at_changed();
    for (Index s = 0; s < mesh_.segments().size(); ++s) {
      if (is_too_long(s)) segments_.push(s);
    }
    treat_all();
    treat_narrow();
    treat_long_gaps();
    require_sizes();
    return reasons();
  }

 private:
  struct Candidate {
    double shortest;
    std::size_t number;
    Index triangle;
    std::array<Index, 3> points;
    bool operator<(const Candidate& other) const {
      return shortest != other.shortest ? shortest > other.shortest : number > other.number;
    }
  };
  FacetMesh& mesh_;
  const SurfaceOptions& options_;
  const SizeAt& said_;
  bool has_narrow_;  // that stays
  InputLines lines_;
  double shortest_ = 0, cosine_ = 0, off_center_ = 0;
  /// What is flatter than this part of the sides of facets, as they are on the average, is narrow; what is narrow
  /// has that part of all points, or as many as all else, if that is more; so have gaps that are so many times
  /// longer than wide, by an estimate, and in fact as many times what is counted.
  static constexpr double kWide = 1.0 / 64, kNarrowPart = 0.02, kShortGap = 16, kGapPoints = 4;
  static constexpr double kAsWide = 1 - 1e-6;  // widths that rounding tells apart
  double wide_ = 0, narrow_ = 0;  // what is flatter than the first counts as narrow; than the second it stays
  double least_gap_ = HUGE_VAL;   // long gaps that are narrower stay
  double ration_ = 0;             // points for what is narrow that are left
  std::vector<std::array<Index, 2>> whole_;  // ends of the segments of the input
  std::queue<Index> segments_;
  std::priority_queue<Candidate> triangles_;
  std::size_t numbered_ = 0;
  /// Of each point: how many times on the way to it a side was mended by a shorter one. A segment that is split
  /// for the sake of a triangle makes such: half of it has 1 / sqrt(2) of the circumradius at least, and that 1 /
  /// (2 sin 25) of the side, which is 0.83 of it.
  std::vector<std::uint8_t> rank_;
  static constexpr int kMostRank = 32;

  const Vector& at(Index p) const { return mesh_.points()[p]; }
  int rank(Index p) const { return p < rank_.size() ? rank_[p] : 0; }
  void set_rank(Index p, int rank) {
    rank_.resize(mesh_.points().size(), 0);
    rank_[p] = std::uint8_t(rank);
  }
  double segment_length(Index s) const {
    const auto& [a, b] = mesh_.segments()[s].ends;
    return distance(at(a), at(b));
  }
  void treat_all() {
    for (std::size_t steps = 0;; ++steps) {
      if (steps % 64 == 0) check();
      if (!segments_.empty()) {
        const Index s = segments_.front();
        segments_.pop();
        if (const std::optional<Encroached> by = encroached(s)) {
          if (may_add(std::min(segment_length(s) / 2, by->height), is_too_long(s))) split(s, by->rank);
        } else if (is_too_long(s) || is_unmatched(s)) split(s, 0);
      } else if (!triangles_.empty()) {
        const Candidate next = triangles_.top();
        triangles_.pop();
        if (mesh_.triangles()[next.triangle].points == next.points) treat(next.triangle);
      } else {
        return;
      }
    }
  }

  /// May a point be added where there is so much room? `wanted`: a side is too long there.
  bool may_add(double room, bool wanted) {
    if (wanted || room > wide_) return true;
    if (ration_ < 1) return false;
    --ration_;
    return true;
  }
  void look_at_all() {
    for (Index t = 0; t < mesh_.triangles().size(); ++t) look_at(t);
  }

  /// Of triangles with small angles that have been left as they are since they are narrow: the greatest height.
  double widest_left() const {
    double widest = 0;
    for (Index t = 0; t < mesh_.triangles().size(); ++t) {
      if (mesh_.facets()[mesh_.triangles()[t].facet].fixed) continue;
      const auto p = corners(t);
      const double least = least_height(p);
      if (least < narrow_ && least > widest && has_small_angle(p, sharpest(p))) widest = least;
    }
    return widest;
  }
  /// What is narrow, the wider before the narrower, as far as the ration goes.
  void treat_narrow() {
    if (has_narrow_) return;
    constexpr double kStep = 4;
    ration_ = std::max(kNarrowPart * double(options_.max_points), double(mesh_.points().size()));
    double before = narrow_;
    while (narrow_ > shortest_ && ration_ >= 1) {
      before = narrow_;
      narrow_ = std::max(shortest_, widest_left() / kStep);
      look_at_all();
      treat_all();
    }
    if (ration_ >= 1) return;
    narrow_ = before;  // the last ones may be half done
    has_narrow_ = true;
    look_at_all();
    treat_all();
  }

  /// Of long gaps the widest, as many as there are points for: a gap takes about as many for each of its sides as
  /// it is longer than wide, whatever its lines are cut into, and as many again to come from there to longer
  /// sides.
  void treat_long_gaps() {
    if (has_narrow_) return;
    double left = std::max(kNarrowPart * double(options_.max_points), double(mesh_.points().size()));
    while (true) {
      std::vector<std::array<double, 2>> gaps;  // width and ratio
      for (Index t = 0; t < mesh_.triangles().size(); ++t) {
        if (mesh_.facets()[mesh_.triangles()[t].facet].fixed) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const double width = height(corners(t), k);
          if (width >= shortest_ && is_in_long_gap(t, k)) gaps.push_back({width, gap(t, k, false)});
        }
      }
      std::sort(gaps.rbegin(), gaps.rend());
      double sum = 0;
      std::size_t taken = 0;
      while (taken < gaps.size()) {  // those that are as wide are open together
        double together = 0;
        std::size_t end = taken;
        for (; end < gaps.size() && gaps[end][0] >= kAsWide * gaps[taken][0]; ++end) together += gaps[end][1];
        if (sum + together > left) break;
        sum += together, taken = end;
      }
      has_narrow_ = taken < gaps.size();
      if (taken == 0) return;
      least_gap_ = std::min(gaps[taken - 1][0], least_gap_ / 2);
      left -= sum;
      ration_ = kGapPoints * sum;
      look_at_all();
      treat_all();
      if (ration_ >= 1) continue;
      has_narrow_ = true;
      return;
    }
  }

  bool is_full() const { return mesh_.points().size() >= options_.max_points; }

  void check() const {
    options_.watch.check();
    if (options_.watch.progress) options_.watch.progress("mesh: surface", mesh_.points().size(), 0);
  }

  bool is_too_long(Index a, Index b) const { return is_longer(a, b, options_.size); }
  bool is_longer(Index a, Index b, const SizeAt& size) const {
    if (!size) return false;
    Vector middle;
    for (std::size_t k = 0; k < 3; ++k) middle[k] = at(a)[k] / 2 + at(b)[k] / 2;
    return distance(at(a), at(b)) > size(middle);
  }
  bool is_too_long(Index s) const {
    const auto& [a, b] = mesh_.segments()[s].ends;
    return is_too_long(a, b);
  }

  bool is_in_circle(Index s, const Vector& p) const {
    const auto& [a, b] = mesh_.segments()[s].ends;
    constexpr double kDoubt = 1e-9;  // right angles are no fault
    return cosine(minus(at(a), p), minus(at(b), p)) < -kDoubt;
  }
  bool is_encroached(Index s, Index t, std::size_t k) const {
    const Index p = mesh_.triangles()[t].points[k];
    return is_in_circle(s, at(p)) && !is_flat(t, k) && !lines_.is_beside(mesh_, p, mesh_.segments()[s]);
  }
  /// Is a triangle so flat over the side opposite to corner k that no points mend it? Then its corners are on
  /// lines that are too near to each other.
  bool is_flat(Index t, std::size_t k) const { return height(corners(t), k) < narrow_ || is_in_long_gap(t, k); }
  bool is_hopeless(Index t, std::size_t k) const {
    return height(corners(t), k) < shortest_ || is_in_long_gap(t, k);
  }
  /// Of the input: what pieces are left of its lines does not matter.
  bool is_in_long_gap(Index t, std::size_t k) const {
    const auto& [points, next, segments, facet] = mesh_.triangles()[t];
    if (segments[k] == kNone) return false;
    const auto& segment = mesh_.segments()[segments[k]];
    const double width = height(corners(t), k);
    const auto& [a, b] = whole_[segment.input];
    // It is no longer than twice the segment.
    if (width >= least_gap_ || 2 * distance(at(a), at(b)) <= kShortGap * width) return false;
    return gap(t, k, true) > kShortGap && !lines_.is_beside(mesh_, points[k], segment);
  }
  bool is_in_long_gap(Index t) const {
    return is_in_long_gap(t, 0) || is_in_long_gap(t, 1) || is_in_long_gap(t, 2);
  }
  /// Length by width of the gap between the segment opposite to corner k and the segments that leave the corner
  /// beside it, over the part where they face each other. `whole`: input segments in place of their pieces.
  double gap(Index t, std::size_t k, bool whole) const {
    const auto& [points, next, segments, facet] = mesh_.triangles()[t];
    const auto& segment = mesh_.segments()[segments[k]];
    const auto& ends = whole ? whole_[segment.input] : segment.ends;
    const Vector &a = at(ends[0]), &b = at(ends[1]), &p = at(points[k]);
    const Vector along = minus(b, a);
    const double base = distance(a, b), above = height(corners(t), k);
    double sum = 0;
    for (const std::size_t side : {(k + 1) % 3, (k + 2) % 3}) {
      const Index beside = segment_round(t, side, points[k]);
      if (beside == kNone) continue;
      Index end = other_end(mesh_.segments()[beside].ends, points[k]);
      if (end == segment.ends[0] || end == segment.ends[1]) continue;  // they meet
      if (whole) end = farther_end(whole_[mesh_.segments()[beside].input], p, minus(at(end), p));
      const Vector &q = at(end), n = cross(along, minus(q, a));
      const double from = dot(minus(p, a), along) / base, to = dot(minus(q, a), along) / base;
      const double first = std::clamp(from, 0.0, base), last = std::clamp(to, 0.0, base);
      if (first == last) continue;
      const double beyond = std::sqrt(dot(n, n)) / base;  // above the segment, as `above`
      const double width = above + (beyond - above) * (last - from) / (to - from);
      sum += std::abs(last - first) / std::max(above, width);
    }
    return sum;
  }
  static Index other_end(const std::array<Index, 2>& ends, Index p) { return ends[0] == p ? ends[1] : ends[0]; }
  Index farther_end(const std::array<Index, 2>& ends, const Vector& p, const Vector& way) const {
    return dot(minus(at(ends[0]), p), way) > dot(minus(at(ends[1]), p), way) ? ends[0] : ends[1];
  }
  /// Does a line have much shorter pieces across a flat triangle? Left as it is, a segment would have flat
  /// triangles to all of them, as long as itself and all in one place: where thousands lie upon each other, each
  /// pair has to be told apart. Pieces are not shorter than those across, so lines match each other and are done.
  bool is_unmatched(Index s) const {
    constexpr double kParts = 3;  // the larger part of a segment that is split is up to two thirds of it
    for (const Index t : mesh_.segments()[s].fan) {
      const auto& triangle = mesh_.triangles()[t];
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.segments[k] != s || !is_in_circle(s, at(triangle.points[k])) || !is_hopeless(t, k)) continue;
        for (const std::size_t side : {(k + 1) % 3, (k + 2) % 3}) {
          const Index across = segment_beside(t, side, triangle.points[k]);
          if (across != kNone && segment_length(s) > kParts * segment_length(across)) return true;
        }
      }
    }
    return false;
  }
  /// Of the neighbour across a side of t: the segment at corner p of both.
  Index segment_beside(Index t, std::size_t side, Index p) const {
    const Index next = mesh_.triangles()[t].next[side];
    if (next == kNone) return kNone;
    const auto& beyond = mesh_.triangles()[next];
    for (std::size_t k = 0; k < 3; ++k) {
      if (beyond.points[k] != p && beyond.next[k] != t) return beyond.segments[k];
    }
    return kNone;
  }
  /// The first segment at corner p of t, beyond a side of t.
  Index segment_round(Index t, std::size_t side, Index p) const {
    constexpr int kMost = 64;  // triangles
    for (int steps = 0; steps < kMost; ++steps) {
      const auto& triangle = mesh_.triangles()[t];
      if (triangle.segments[side] != kNone) return triangle.segments[side];
      const Index next = triangle.next[side];
      if (next == kNone) return kNone;
      const auto& beyond = mesh_.triangles()[next];
      std::size_t k = 0;
      while (beyond.points[k] == p || beyond.next[k] == t) ++k;
      side = k, t = next;
    }
    return kNone;
  }
  /// Of the points that encroach on a segment.
  struct Encroached {
    int rank;       ///< the least
    double height;  ///< over the segment: the greatest
  };
  /// In a Delaunay triangulation a segment is encroached, if at all, by the corner of a triangle at it.
  std::optional<Encroached> encroached(Index s) const {
    std::optional<Encroached> result;
    for (const Index t : mesh_.segments()[s].fan) {
      const auto& triangle = mesh_.triangles()[t];
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.segments[k] != s || !is_encroached(s, t, k)) continue;
        const double above = height(corners(t), k);
        const int rank_here = rank(triangle.points[k]);
        if (!result) result = {rank_here, above};
        else result = {std::min(result->rank, rank_here), std::max(result->height, above)};
      }
    }
    return result;
  }
  /// Would a point in a facet split a segment in a gap that is too long? `beyond`: it is on the other side.
  bool is_across_long_gap(Index s, Index facet, const Vector& p, bool beyond) const {
    for (const Index t : mesh_.segments()[s].fan) {
      const auto& triangle = mesh_.triangles()[t];
      for (std::size_t k = 0; k < 3; ++k) {
        if (triangle.segments[k] != s || triangle.facet != facet) continue;
        const Vector &a = at(triangle.points[(k + 1) % 3]), &b = at(triangle.points[(k + 2) % 3]);
        const bool left = dot(cross(minus(b, a), minus(p, a)), mesh_.facets()[facet].normal) > 0;
        if (left != beyond && is_in_long_gap(t, k)) return true;
      }
    }
    return false;
  }
  /// Of corner k over the side that is opposite to it.
  static double height(const std::array<Vector, 3>& p, std::size_t k) {
    const Vector along = minus(p[(k + 2) % 3], p[(k + 1) % 3]), n = cross(along, minus(p[k], p[(k + 1) % 3]));
    return std::sqrt(dot(n, n) / dot(along, along));
  }
  static double least_height(const std::array<Vector, 3>& p) {
    return std::min({height(p, 0), height(p, 1), height(p, 2)});
  }

  /// Of segments that are split together one with a small angle says where.
  Vector split_place(Index s) const {
    Index by = s;
    mesh_.for_each_tied(s, [&](Index tied) {
      if (!lines_.has_apex(mesh_.segments()[by])) by = tied;
    });
    return lines_.split_place(mesh_, mesh_.segments()[by]);
  }
  /// False if it has to stay as it is. `rank`: of the new point.
  bool split(Index s, int rank) {
    const auto& segment = mesh_.segments()[s];
    if (segment.fixed || is_full()) return false;
    if (segment_length(s) < 2 * shortest_) return false;
    const std::vector<FacetMesh::Parts> split = mesh_.split(s, split_place(s));
    if (split.empty()) {
      mesh_.fix(s);
      return false;
    }
    for (const auto& [first, second, point] : split) {
      lines_.add_point(point, mesh_.segments()[first]);
      set_rank(point, rank);
      for (const Index part : {first, second}) {
        if (is_too_long(part)) segments_.push(part);
      }
    }
    look_at_changed();
    return true;
  }

  std::array<Vector, 3> corners(Index t) const {
    const auto& p = mesh_.triangles()[t].points;
    return {at(p[0]), at(p[1]), at(p[2])};
  }
  bool has_small_angle(const std::array<Vector, 3>& p, std::size_t k) const {
    return cosine(minus(p[(k + 1) % 3], p[k]), minus(p[(k + 2) % 3], p[k])) > cosine_;
  }
  bool has_long_side(Index t) const {
    const auto& p = mesh_.triangles()[t].points;
    return is_too_long(p[0], p[1]) || is_too_long(p[1], p[2]) || is_too_long(p[2], p[0]);
  }
  bool may_be_better(Index t, const std::array<Vector, 3>& p, std::size_t k) const {
    const auto& points = mesh_.triangles()[t].points;
    return has_small_angle(p, k) && least_height(p) > narrow_ &&
           !lines_.is_forced(mesh_, points[(k + 1) % 3], points[(k + 2) % 3]) && !is_in_long_gap(t);
  }

  void look_at_changed() {
    std::vector<Index> changed = mesh_.take_changed();
    sort_unique(changed);
    for (const Index t : changed) look_at(t);
  }
  void look_at(Index s, Index p) {
    if (!mesh_.segments()[s].fixed && is_in_circle(s, at(p))) segments_.push(s);
  }
  void look_across(Index t) {
    const auto& triangle = mesh_.triangles()[t];
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.segments[k] != kNone) look_at(triangle.segments[k], triangle.points[k]);
    }
  }
  void look_at(Index t) {
    const auto& triangle = mesh_.triangles()[t];
    if (mesh_.facets()[triangle.facet].fixed) return;
    const bool in_gap = is_in_long_gap(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index s = triangle.segments[k];
      if (s != kNone) look_at(s, triangle.points[k]);
      else if (in_gap || is_hopeless(t, k)) look_across(triangle.next[k]);
    }
    const auto p = corners(t);
    const std::size_t k = sharpest(p);
    if (!may_be_better(t, p, k) && !has_long_side(t)) return;
    triangles_.push({distance(p[(k + 1) % 3], p[(k + 2) % 3]), numbered_++, t, triangle.points});
  }

  /// A place that makes a triangle go: its circumcentre, or nearer to its shortest side.
  Vector center(Index t, const std::array<Vector, 3>& p, std::size_t k, bool small_angle) const {
    const Index facet = mesh_.triangles()[t].facet;
    const Vector &a = p[(k + 1) % 3], &b = p[(k + 2) % 3], &normal = mesh_.facets()[facet].normal;
    const Vector u = minus(b, a), v = minus(p[k], a);
    const Vector x = cross(normal, u), y = cross(v, normal);  // in the plane, at right angles to u and to v
    const double uu = dot(u, u), vv = dot(v, v), twice = 2 * dot(x, v);
    Vector d;
    for (std::size_t j = 0; j < 3; ++j) d[j] = (x[j] * vv + y[j] * uu) / twice;
    if (small_angle) {
      Vector off;
      for (std::size_t j = 0; j < 3; ++j) off[j] = u[j] / 2 + x[j] * off_center_;
      const Vector from_circle = minus(d, {u[0] / 2, u[1] / 2, u[2] / 2});
      if (!(dot(from_circle, from_circle) <= off_center_ * off_center_ * uu)) d = off;
    }
    return mesh_.on_plane(facet, {a[0] + d[0], a[1] + d[1], a[2] + d[2]});
  }

  void treat(Index t) {
    const auto p = corners(t);
    const std::size_t k = sharpest(p);
    const bool small_angle = may_be_better(t, p, k), long_side = has_long_side(t);
    if (is_full() || (!small_angle && !long_side)) return;
    const Vector c = center(t, p, k, small_angle);
    if (!std::isfinite(c[0] + c[1] + c[2])) return;
    const auto points = mesh_.triangles()[t].points;
    const Index facet = mesh_.triangles()[t].facet;
    const double shortest = distance(p[(k + 1) % 3], p[(k + 2) % 3]);
    if (!may_add(least_height(p), long_side)) return;
    const int rank_here = small_angle ? std::max(rank(points[(k + 1) % 3]), rank(points[(k + 2) % 3])) : 0;
    const FacetMesh::Walk end = mesh_.walk(t, c);
    std::vector<Index> in_the_way;
    double nearest = 0;
    if (end.segment != kNone) {
      in_the_way.push_back(end.segment);
    } else if (end.triangle != kNone) {
      const FacetMesh::Cavity cavity = mesh_.cavity(end.triangle, c);
      nearest = cavity.nearest;
      for (const Index s : cavity.segments)
        if (is_in_circle(s, c)) in_the_way.push_back(s);
    }
    // In a Delaunay triangulation there is more room, and segments in the way of a long side are longer. Where
    // doubles keep a long side, which bars the way for ever, those that are in the way besides would be split to
    // the last digit.
    constexpr double kLeastOfLongest = 0.25;
    const double longest = std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
    const double room = small_angle ? shortest : kLeastOfLongest * longest;
    if (!in_the_way.empty()) {
      bool any = false;
      for (const Index s : in_the_way) {
        const bool shorter = segment_length(s) / 2 < room;
        if (shorter && !small_angle) continue;
        if (!long_side && is_across_long_gap(s, facet, c, end.segment != kNone)) continue;
        const int rank_there = rank_here + (shorter ? 1 : 0);
        if (rank_there <= kMostRank) any = split(s, rank_there) || any;
      }
      if (any && mesh_.triangles()[t].points == points) triangles_.push({shortest, numbered_++, t, points});
      return;
    }
    if (nearest < room) return;
    if (end.triangle == kNone || !mesh_.insert(end.triangle, c)) return;
    set_rank(Index(mesh_.points().size() - 1), rank_here);
    look_at_changed();
  }

  void require_sizes() const {
    if (!options_.size) return;
    for (const auto& segment : mesh_.segments()) require_size(segment.ends[0], segment.ends[1], segment.fixed);
    for (const auto& t : mesh_.triangles()) {
      for (std::size_t k = 0; k < 3; ++k)
        require_size(t.points[k], t.points[(k + 1) % 3], mesh_.facets()[t.facet].fixed);
    }
  }
  void require_size(Index a, Index b, bool fixed) const {
    if (!is_too_long(a, b) || (!is_full() && !is_longer(a, b, said_))) return;
    std::string text = "near (";
    Line(text) << at(a);
    text += ") the surface mesh is coarser than asked for, since ";
    if (is_full()) {
      text += "it may have " + std::to_string(options_.max_points) +
              " points; ask for larger sizes, or give a greater --max-points";
      throw InputError(text);
    }
    text += fixed ? "a facet there is thinner than the digits of its points"
                  : "doubles have no room for more points there";
    throw NearFault(text +
                    "; join what nearly touches by --join, ask for larger sizes, or move the model nearer to "
                    "the origin");
  }

  /// Are points for it lacking that might be between doubles?
  bool lacks_points(Index t, const std::array<Vector, 3>& p) const {
    if (is_full()) return true;
    return has_narrow_ && !mesh_.facets()[mesh_.triangles()[t].facet].fixed && least_height(p) > shortest_;
  }

  std::vector<SmallAngle> reasons() const {
    std::vector<SmallAngle> result;
    for (Index t = 0; t < mesh_.triangles().size(); ++t) {
      const auto p = corners(t);
      const std::size_t k = sharpest(p);
      const auto& points = mesh_.triangles()[t].points;
      result.push_back(!has_small_angle(p, k) ? SmallAngle::none
                       : lines_.across_small_angle(mesh_, points[(k + 1) % 3], points[(k + 2) % 3])
                           ? SmallAngle::input
                       : lacks_points(t, p) ? SmallAngle::bound
                                            : SmallAngle::digits);
    }
    return result;
  }
};

}  // namespace

std::pair<double, std::size_t> smallest_angle(const std::array<Vector, 3>& p) {
  const std::size_t k = sharpest(p);
  const Vector u = minus(p[(k + 1) % 3], p[k]), v = minus(p[(k + 2) % 3], p[k]), n = cross(u, v);
  return {std::atan2(std::sqrt(dot(n, n)), dot(u, v)) * kLeastAngle / kRadians, k};
}

std::vector<SmallAngle> refine(FacetMesh& mesh, const SurfaceOptions& options, const SizeAt& said,
                               SurfaceNarrow narrow) {
  return Refiner(mesh, options, said, narrow).run();
}

}  // namespace cnrg
