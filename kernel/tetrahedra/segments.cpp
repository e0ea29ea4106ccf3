#include "kernel/tetrahedra/segments.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <unordered_set>

#include "kernel/base/error.h"
#include "kernel/refine/input.h"

namespace cnrg {
namespace {

/// Cuts that are made at most, and for each point and segment that there is.
constexpr std::size_t kCuts = 200'000, kCutsEach = 30;
/// So many points are looked at before one is chosen.
constexpr std::size_t kLooked = 1000;
/// Where segments nearly touch, their cuts must lie opposite to each other more exactly than doubles tell; but
/// numbers must not grow from cut to cut.
constexpr unsigned kBits = 160;

Rational shortened(const Rational& x) { return Rational(mpf_class(x, kBits)); }
Rational root(const Rational& x) { return Rational(sqrt(mpf_class(x, kBits))); }

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
/// from its ends to all of them through points in the ball. Doubles are enough to choose.
VertexId SegmentChains::in_the_way(VertexId a, VertexId b) const {
  const auto p = points_.approx(a), q = points_.approx(b);
  std::vector<VertexId> found{a, b};
  std::unordered_set<VertexId> seen{a, b};
  std::vector<Index> star;
  VertexId best;
  double widest = 0;
  for (std::size_t i = 0; i < found.size() && found.size() < kLooked; ++i) {
    tetrahedra_.around(found[i], star);
    for (const Index t : star) {
      for (const VertexId v : tetrahedra_.corners(t)) {
        if (tetrahedra_.on_box(v) || !seen.insert(v).second) continue;
        const auto x = points_.approx(v);
        double dot = 0, u = 0, w = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          dot += (p[k] - x[k]) * (q[k] - x[k]);
          u += (p[k] - x[k]) * (p[k] - x[k]);
          w += (q[k] - x[k]) * (q[k] - x[k]);
        }
        if (dot > 0) continue;
        found.push_back(v);
        const double angle = -dot / std::sqrt(u * w);
        if (best.valid() && angle <= widest) continue;
        best = v;
        widest = angle;
      }
    }
  }
  return best;
}

Rational SegmentChains::place_of_cut(const Piece& piece) const {
  Rational middle = (piece.from + piece.to) / 2;
  const VertexId v = in_the_way(at(piece.segment, piece.from), at(piece.segment, piece.to));
  if (!v.valid()) return middle;
  const auto& [a, b] = segments_[piece.segment];
  const RationalPoint p = points_.rational(a), q = points_.rational(b), x = points_.rational(v);
  Rational length = 0, along = 0, from_a = 0, from_b = 0;  // squares, but for `along`
  for (std::size_t k = 0; k < 3; ++k) {
    length += (q[k] - p[k]) * (q[k] - p[k]);
    along += (x[k] - p[k]) * (q[k] - p[k]);
    from_a += (x[k] - p[k]) * (x[k] - p[k]);
    from_b += (x[k] - q[k]) * (x[k] - q[k]);
  }
  const Rational foot = along / length, away = root(from_a / length - foot * foot);
  const Rational margin = std::min(away, Rational((piece.to - piece.from) / 5));
  const auto inside = [&](const Rational& t) { return piece.from + margin < t && t < piece.to - margin; };
  const auto other = segment_of_.find(v);
  if (other != segment_of_.end()) {
    for (const VertexId end : segments_[other->second]) {
      if (end != a && end != b) continue;
      Rational t = end == a ? root(from_a / length) : 1 - root(from_b / length);
      if (inside(t)) return t;
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

void SegmentChains::run(const Watch& watch) {
  std::vector<Key> open;
  open.reserve(pieces_.size());
  for (const auto& [ends, piece] : pieces_) open.push_back(ends);
  std::sort(open.begin(), open.end(), std::greater());
  std::vector<std::array<VertexId, 2>> lost;
  const std::size_t most = points_.size() + kCuts + kCutsEach * (points_.size() + segments_.size());
  while (!open.empty()) {
    watch.check();
    const Key ends = open.back();
    open.pop_back();
    const auto found = pieces_.find(ends);
    if (found == pieces_.end()) continue;
    const Piece piece = found->second;
    const VertexId a = at(piece.segment, piece.from), b = at(piece.segment, piece.to);
    if (tetrahedra_.has_edge(a, b)) continue;
    if (points_.size() > most) throw InputError(crowded(a));
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
