// A patch against itself: neighbours among its cells; see pieces.h.
//
// Where all derivatives of H by u are in a convex cone, and those by v in another one, and no vector of the one is
// parallel to one of the other, H(x) and H(y) differ for all x and y that are joined by a line of parameters
// there: their difference is a mean of the first times a step of u and a mean of the second times a step of v. In
// columns H(x) and H(y) are at their own angles about the axis, so the cone along the meridian will do. About a
// pole the same is true of x and y of piece_poles.cpp, where cells fill a convex polygon.
#include <algorithm>
#include <set>

#include "csg/certify/piece_parts.h"

namespace cnrg {

using namespace surface_math;

namespace {

using Range = std::array<Interval, 2>;

Range least(const Range& a, const Range& b) { return {hull(a[0], b[0]), hull(a[1], b[1])}; }

bool meet(const Range& a, const Range& b) {
  return a[0].inf() < b[0].sup() && b[0].inf() < a[0].sup() && a[1].inf() < b[1].sup() && b[1].inf() < a[1].sup();
}

/// Corners that two cells have in common, some, are at the same parameters of both, but for poles.
bool side_by_side(const Piece& a, const Piece& b) {
  bool some = false;
  for (std::size_t i = 0; i < a.corner_count; ++i) {
    for (std::size_t j = 0; j < b.corner_count; ++j) {
      if (a.points[i] != b.points[j] || std::ranges::count(a.numbers(), a.points[i]) > 1) continue;
      if (a.at[i] != b.at[j]) return false;
      some = true;
    }
  }
  return some;
}

class Neighbours {
 public:
  /// Asks parts of two cells of a patch.
  Neighbours(const std::vector<Piece>& all, std::span<const std::uint32_t> patch, const Piece& a, const Piece& b,
             std::size_t& left)
      : all_(all), left_(left) {
    const Range both = least(a.range, b.range);
    std::ranges::copy_if(patch, std::back_inserter(between_), [&](auto i) { return meet(all[i].range, both); });
  }

  /// True if the derivatives prove it.
  bool differ(const PiecePart& a, const PiecePart& b) const {
    if (between_.empty()) return false;
    const Range both = least(a.range, b.range);
    const SurfaceJet<Interval> jet = all_[between_[0]].surface->over(both[0], both[1]);
    Interval3 u = normalized(jet.way_u), v = normalized(jet.way_v);
    for (const std::uint32_t i : between_) {
      const Piece& piece = all_[i];
      if (!meet(piece.range, both)) continue;
      if (piece.blind) return false;
      u = hull(u, normalized(piece.along_u));
      v = hull(v, normalized(piece.along_v));
    }
    return independent(u, v) || (a.piece == b.piece && a.piece->column && rises(*a.piece, both));
  }
  bool alone(const PiecePart& part) {
    if (about_pole(part, part) || differ(part, part)) return true;
    if (left_ == 0) return false;
    --left_;
    const std::array<PiecePart, 2> both = halves(all_, part, part.longer(), Between::facets_and_surfaces);
    return alone(both[0]) && alone(both[1]) && ask(both[0], both[1]);
  }
  bool ask(const PiecePart& a, const PiecePart& b) {
    const auto proven = [&](const PiecePart& x, const PiecePart& y) {
      return differ(x, y) || parted(std::array{x, y}, Between::facets_and_surfaces);
    };
    return proven_by_halves(all_, a, b, proven, left_);
  }

 private:
  /// True if all H in a half-plane of a column go one way there; F is up to `flat` shorter across the axis.
  static bool rises(const Piece& piece, Range range) {
    const std::size_t around = piece.column->around, k = piece.at[0][around] == piece.at[1][around] ? 0 : 1;
    range[around] = Interval(piece.at[k][around]);
    const SurfaceJet<Interval> jet = piece.surface->over(range[0], range[1]);
    const Interval3 side = difference(piece.corners[(k + 1) % 4], piece.corners[k]);
    const Interval up(piece.at[(k + 1) % 4][1 - around] > piece.at[k][1 - around] ? 1 : -1);
    const Interval3 all = hull(normalized(around == 0 ? jet.way_v : jet.way_u), normalized(scaled(up, side))),
                    way = thin(middle_of(all));
    return dot(way, all).inf() >
           ((Interval(piece.column->flat) + piece.column->turned) * length(way) * length(all)).sup();
  }

  const std::vector<Piece>& all_;
  std::vector<std::uint32_t> between_;  // cells of the patch in the least range that holds both
  std::size_t& left_;                   // steps
};

}  // namespace

bool about_pole(const PiecePart& a, const PiecePart& b) {
  const auto &x = a.piece->pole, &y = b.piece->pole;
  if (!x || !y || a.piece->leaf != b.piece->leaf || a.piece->patch != b.piece->patch || x->away != y->away ||
      x->at != y->at || !x->is_near(a.range) || !y->is_near(b.range))
    return false;
  const auto convex = [](const Piece::Pole& first, const Piece::Pole& second) {
    const std::array<Interval, 4> e{first.ends[0][0], first.ends[0][1], second.ends[1][0], second.ends[1][1]};
    return first.ends[1] == second.ends[0] && (e[0] * e[3] - e[1] * e[2]).inf() > 0;
  };
  return (a.piece == b.piece ||
          (a.piece->torn == 0 && b.piece->torn == 0 && (convex(*x, *y) || convex(*y, *x)))) &&
         independent(hull(x->along[0], y->along[0]), hull(x->along[1], y->along[1]));
}

bool meet_at_pole(const Piece& a, const Piece& b) {
  if (!(a.exact() || a.column) || !(b.exact() || b.column)) return false;
  std::set<std::uint32_t> common, poles;
  for (const std::uint32_t p : a.numbers()) {
    if (std::ranges::count(b.numbers(), p) > 0) common.insert(p);
  }
  for (const Piece* one : {&a, &b}) {
    for (std::size_t k = 0; k < one->corner_count; ++k) {
      if (one->points[k] == one->points[(k + 1) % one->corner_count]) poles.insert(one->points[k]);
    }
  }
  return common.size() == 2 && std::ranges::any_of(common, [&](std::uint32_t p) { return poles.contains(p); });
}

bool differ(const std::vector<Piece>& all, std::span<const std::uint32_t> patch, std::uint32_t a,
            std::uint32_t b) {
  std::size_t none = 0;
  return Neighbours(all, patch, all[a], all[b], none)
      .differ(part_of(all, all[a], all[a].range), part_of(all, all[b], all[b].range));
}

bool one_to_one(const Pieces& pieces, std::span<const std::uint32_t> patch, std::uint32_t a, std::uint32_t b,
                std::size_t& steps) {
  const std::vector<Piece>& all = pieces.all();
  if (a != b && !side_by_side(all[a], all[b])) return apart_but_beside(pieces, a, b, steps);  // where it is closed
  const PiecePart one = part_of(all, all[a], all[a].range);
  std::size_t left = kMostOwnSteps;
  Neighbours question(all, patch, all[a], all[b], left);
  const bool proven = a == b ? question.alone(one) : question.ask(one, part_of(all, all[b], all[b].range));
  steps += kMostOwnSteps - left;
  return proven;
}

}  // namespace cnrg
