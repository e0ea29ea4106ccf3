#include "kernel/tetrahedra/segments.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <unordered_set>

#include "kernel/base/error.h"
#include "kernel/refine/input.h"
#include "kernel/tetrahedra/constrained.h"

namespace cnrg {
namespace {

/// Cuts that are made at most, and for each point and segment that there is.
constexpr std::size_t kCuts = 5'000;
/// So many points are looked at before one is chosen.
constexpr std::size_t kLooked = 1000;
/// Where segments nearly touch, their cuts must lie opposite to each other more exactly than doubles tell; but
/// numbers must not grow from cut to cut.
constexpr unsigned kBits = 160;

Rational shortened(const Rational& x) { return Rational(mpf_class(x, kBits)); }
Rational root(const Rational& x) { return Rational(sqrt(mpf_class(x, kBits))); }

RationalPoint difference(const RationalPoint& p, const RationalPoint& q) {
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}
Rational dot(const RationalPoint& u, const RationalPoint& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/// Where to cut a segment, p and its way, that nearly crosses another one, from c to d, of which x is a cut: first
/// where they are nearest, then as far from there as x is. Nothing where x is not farther from there than they are
/// from each other, or they are nearest elsewhere.
std::vector<Rational> places_at_crossing(const RationalPoint& p, const RationalPoint& way, const RationalPoint& c,
                                         const RationalPoint& d, const RationalPoint& x) {
  const RationalPoint other = difference(c, d), between = difference(p, c);
  const Rational uu = dot(way, way), uv = dot(way, other), vv = dot(other, other);
  const Rational det = uu * vv - uv * uv;
  if (det == 0) return {};
  const Rational wu = dot(between, way), wv = dot(between, other);
  const Rational s = (wu * vv - wv * uv) / det, t = (wu * uv - wv * uu) / det;
  if (s < 0 || s > 1 || t < 0 || t > 1) return {};
  RationalPoint gap, away;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational near = c[k] + t * other[k];
    gap[k] = near - p[k] - s * way[k];
    away[k] = x[k] - near;
  }
  const Rational far = dot(away, away);
  if (far <= dot(gap, gap)) return {};
  const Rational step = root(far / uu);
  return {shortened(s), shortened(dot(away, way) < 0 ? Rational(s - step) : Rational(s + step))};
}

}  // namespace

SegmentChains::SegmentChains(PointTable& points, Tetrahedra& tetrahedra,
                             std::vector<std::array<VertexId, 2>> segments)
    : points_(points), tetrahedra_(tetrahedra), segments_(std::move(segments)), cuts_(segments_.size()) {
  for (Index i = 0; i < segments_.size(); ++i) {
    const auto& [a, b] = segments_[i];
    require(pieces_.try_emplace(RefineInput::key(a, b), Piece{i, 0, 1}).second, "tetrahedra: a segment twice");
  }
}

VertexId SegmentChains::at(Index segment, const Rational& t) const {
  if (t == 0) return segments_[segment][0];
  if (t == 1) return segments_[segment][1];
  return cuts_[segment].at(t);
}

/// Of the points in the ball whose diameter is the piece, the one that sees it under the widest angle. Edges lead
/// from its ends to all of them through points in the ball.
VertexId SegmentChains::in_the_way(VertexId a, VertexId b) const {
  std::vector<VertexId> found{a, b};
  std::unordered_set<VertexId> seen{a, b};
  std::vector<Index> star;
  VertexId best;
  double widest = -1;
  for (std::size_t i = 0; i < found.size() && found.size() < kLooked; ++i) {
    tetrahedra_.around(found[i], star);
    for (const Index t : star) {
      for (const VertexId v : tetrahedra_.corners(t)) {
        if (tetrahedra_.on_box(v) || !seen.insert(v).second) continue;
        const double angle = -cosine(v, a, b);
        if (angle < 0) continue;
        found.push_back(v);
        if (angle <= widest) continue;
        best = v;
        widest = angle;
      }
    }
  }
  return best;
}

/// Of the angle at v between the ways to a and b, with the right sign. Points that lie beside the ends of a piece
/// see it under nearly a right angle; what doubles say of them would have the piece cut again and again.
double SegmentChains::cosine(VertexId v, VertexId a, VertexId b) const {
  const auto x = points_.approx(v), p = points_.approx(a), q = points_.approx(b);
  double along = 0, u = 0, w = 0, most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (p[k] - x[k]) * (q[k] - x[k]);
    u += (p[k] - x[k]) * (p[k] - x[k]);
    w += (q[k] - x[k]) * (q[k] - x[k]);
    most = std::max({most, std::abs(x[k]), std::abs(p[k]), std::abs(q[k])});
  }
  // Each difference is off by 4u of the largest coordinate at most (u = 2^-53), and by as much of itself.
  constexpr double kRelative = 1e-14;
  const double bound =
      kRelative * (most * (std::sqrt(u) + std::sqrt(w)) + std::sqrt(u * w) + kRelative * most * most);
  if (std::abs(along) > bound) return along / std::sqrt(u * w);
  const RationalPoint from = points_.rational(v), to_a = difference(from, points_.rational(a)),
                      to_b = difference(from, points_.rational(b));
  const Rational exact = dot(to_a, to_b);
  if (exact == 0) return 0;
  return std::copysign(std::sqrt(Rational(exact * exact / (dot(to_a, to_a) * dot(to_b, to_b))).get_d()),
                       sgn(exact));
}

Rational SegmentChains::place_of_cut(const Piece& piece) const {
  Rational middle = (piece.from + piece.to) / 2;
  const VertexId v = in_the_way(at(piece.segment, piece.from), at(piece.segment, piece.to));
  if (!v.valid()) return middle;
  const auto& [a, b] = segments_[piece.segment];
  const RationalPoint p = points_.rational(a), q = points_.rational(b), x = points_.rational(v);
  const RationalPoint way = difference(p, q), to_x = difference(p, x);
  const Rational length = dot(way, way), from_a = dot(to_x, to_x), foot = dot(to_x, way) / length;
  const Rational size = piece.to - piece.from;
  const Rational margin = std::min(Rational((from_a / length - foot * foot) / (2 * size)), Rational(size / 5));
  const auto inside = [&](const Rational& t) { return piece.from + margin < t && t < piece.to - margin; };
  const auto other = segment_of_.find(v);
  if (other != segment_of_.end()) {
    const auto& [c, d] = segments_[other->second];
    for (const VertexId end : {c, d}) {
      if (end != a && end != b) continue;
      const RationalPoint from_b = difference(q, x);
      Rational t = end == a ? root(from_a / length) : 1 - root(dot(from_b, from_b) / length);
      if (inside(t)) return t;
    }
    if (c != a && c != b && d != a && d != b) {
      for (const Rational& t : places_at_crossing(p, way, points_.rational(c), points_.rational(d), x)) {
        if (inside(t)) return t;
      }
    }
  }
  if (inside(foot)) return shortened(foot);
  return middle;
}

std::string SegmentChains::crowded(VertexId v) const {
  std::ostringstream text;
  const auto [x, y, z] = points_.approx(v);
  text << "tetrahedra need too many points near (" << x << ", " << y << ", " << z
       << "): edges nearly touch there; move them apart or together, or join them by `weld`";
  return text.str();
}

void SegmentChains::run(const Watch& watch, double cuts) {
  std::vector<Key> open;
  open.reserve(pieces_.size());
  for (const auto& [ends, piece] : pieces_) open.push_back(ends);
  std::sort(open.begin(), open.end(), std::greater());
  std::vector<std::array<VertexId, 2>> lost;
  const std::size_t most = points_.size() + kCuts +
                           static_cast<std::size_t>(cuts * static_cast<double>(points_.size() + segments_.size()));
  while (!open.empty()) {
    watch.check();
    const Key ends = open.back();
    open.pop_back();
    const auto found = pieces_.find(ends);
    if (found == pieces_.end()) continue;
    const Piece piece = found->second;
    const VertexId a = at(piece.segment, piece.from), b = at(piece.segment, piece.to);
    if (tetrahedra_.has_edge(a, b)) continue;
    if (points_.size() > most) throw NearFault(crowded(a));
    const Rational t = place_of_cut(piece);
    const auto& [first, last] = segments_[piece.segment];
    const RationalPoint p = points_.rational(first), q = points_.rational(last);
    RationalPoint cut;
    for (std::size_t k = 0; k < 3; ++k) cut[k] = p[k] + t * (q[k] - p[k]);
    const VertexId v = points_.add(cut);
    cuts_[piece.segment].emplace(t, v);
    segment_of_.emplace(v, piece.segment);
    pieces_.erase(found);
    pieces_.emplace(RefineInput::key(a, v), Piece{piece.segment, piece.from, t});
    pieces_.emplace(RefineInput::key(v, b), Piece{piece.segment, t, piece.to});
    lost.clear();
    tetrahedra_.insert(v, a, lost);
    for (const auto& [c, d] : lost) {
      if (pieces_.contains(RefineInput::key(c, d))) open.push_back(RefineInput::key(c, d));
    }
    open.push_back(RefineInput::key(a, v)), open.push_back(RefineInput::key(v, b));
  }
}

std::vector<VertexId> SegmentChains::chain(Index segment) const {
  std::vector<VertexId> out{segments_[segment][0]};
  for (const auto& [t, v] : cuts_[segment]) out.push_back(v);
  out.push_back(segments_[segment][1]);
  return out;
}

}  // namespace cnrg
