// Two pieces of a leaf from the side or corner that they have in common; see pieces.h.
//
// Points of both cells are e(s) + t v and e(s') + t' v' along a common side e, where v and v' are means of the
// derivatives across it, t and t' not below 0. They are one point only if (s - s') e' + t v - t' v' vanishes: not
// where e', v and v' are independent, nor where e' and all between v and -v' are, for points with t + t' > 0.
// A cell that goes on smoothly from a flat piece is on the other side of their side, seen along the plane: of a
// straight side, or in every half-plane through the axis of both.
// About a common corner, a plane between the derivatives away from it parts the pieces.
#include <algorithm>
#include <optional>
#include <set>

#include "csg/certify/piece_parts.h"

namespace cnrg {

using namespace surface_math;

namespace {

using Range = std::array<Interval, 2>;

/// The corners that a piece has in common with another one, or with all flat ones in its plane: of each as many,
/// one by one; a pole not first.
struct CommonCorners {
  std::vector<std::size_t> of_a, of_b;
};
CommonCorners common_corners(const Pieces& pieces, std::uint32_t first, std::uint32_t second) {
  const std::vector<Piece>& all = pieces.all();
  const Piece &a = all[first], &b = all[second];
  CommonCorners common;
  if (b.kind == Piece::Kind::flat) {
    std::set<std::uint32_t> in_plane;
    for (const Piece& flat : all) {
      if (flat.kind == Piece::Kind::flat && flat.leaf == b.leaf && flat.sheet == b.sheet)
        in_plane.insert(flat.corner_numbers.begin(), flat.corner_numbers.end());
    }
    for (std::size_t i = 0; i < a.numbers().size(); ++i) {
      if (in_plane.contains(a.points[i])) common.of_a.push_back(i);
    }
    return common;
  }
  for (std::size_t i = 0; i < a.numbers().size(); ++i) {
    for (std::size_t j = 0; j < b.numbers().size(); ++j) {
      if (!pieces.same_corner(first, i, second, j)) continue;
      const bool again =
          std::ranges::any_of(common.of_a, [&](std::size_t k) { return a.points[k] == a.points[i]; });
      if (again) continue;  // a pole
      common.of_a.push_back(i);
      common.of_b.push_back(j);
    }
  }
  if (common.of_a.size() > 1 && std::ranges::count(a.numbers(), a.points[common.of_a[0]]) > 1) {
    std::swap(common.of_a[0], common.of_a[1]);
    std::swap(common.of_b[0], common.of_b[1]);
  }
  return common;
}

/// The derivatives of all H of a curve.
Interval3 along_curve(const std::vector<Piece>& all, const Piece& curve, const Range& range) {
  constexpr int kParts = 16;
  Interval3 result = normalized(curve.along_u);
  const Interval start(range[0].inf()), step = Interval(range[0].sup()) - start;
  for (int k = 0; k < kParts && !curve.exact(); ++k) {
    const Interval part = start + step * Interval(double(k) / kParts, double(k + 1) / kParts);
    result = hull(result, normalized(part_of(all, curve, {part, range[1]}, Between::surfaces).along_u));
  }
  return result;
}

/// A piece that is not flat, as seen from corners that it has in common with another one.
class Opened {
 public:
  /// `corners`: one, or the ends of a side.
  Opened(const std::vector<Piece>& all, const Piece& piece, const std::vector<std::size_t>& corners)
      : all_(all), piece_(piece), corner_(corners[0]) {
    if (piece.kind == Piece::Kind::curve) {
      ends_ = {1 - corner_};
      return;
    }
    const std::size_t n = piece.corner_count, next = (corner_ + 1) % n, before = (corner_ + n - 1) % n;
    ends_ = {next, before};
    std::erase_if(ends_, [&](std::size_t end) { return piece.points[end] == piece.points[corner_]; });
    if (corners.size() < 2 || ends_.size() < 2) return;
    const std::uint32_t other = piece.points[corners[1]];
    if (piece.points[before] == other) std::swap(ends_[0], ends_[1]);
    by_side_ =
        piece.points[ends_[0]] == other && (piece.torn >> (ends_[0] == before ? before : corner_) & 1u) == 0;
  }

  /// False if the corners are no side.
  bool by_side() const { return by_side_; }
  /// Where a range is from the first common corner to the second, from 0 to 1.
  Interval along(const Range& range) const {
    if (!piece_.grid) return {0, 1};
    const std::size_t k = parameter(0);
    return (range[k] - Interval(at(corner_, k))) / (Interval(at(ends_[0], k)) - Interval(at(corner_, k)));
  }
  /// The least range that holds a part, what it has in common with the other piece, and `along` of the side.
  Range from_common(Range range, const std::optional<Interval>& along) const {
    if (piece_.kind == Piece::Kind::curve) return {hull(range[0], Interval(double(corner_))), range[1]};
    if (!piece_.grid) return piece_.range;
    for (std::size_t i = 0; i < ends_.size(); ++i)
      range[parameter(i)] = hull(range[parameter(i)], Interval(at(corner_, parameter(i))));
    if (!along) return range;
    const std::size_t k = parameter(0);
    const Interval wide =
        Interval(at(corner_, k)) + *along * (Interval(at(ends_[0], k)) - Interval(at(corner_, k)));
    const Interval all = hull(range[k], wide);
    range[k] = Interval(std::max(all.inf(), piece_.range[k].inf()), std::min(all.sup(), piece_.range[k].sup()));
    return range;
  }
  /// Of all H there from the common corner: F is in the cone of the ways to other corners, S in that of its
  /// derivatives.
  std::vector<Interval3> ways_from_corner(const Range& range) const {
    if (!piece_.grid || piece_.pole) return ways(range);
    const SurfaceJet<Interval> jet = piece_.surface->over(range[0], range[1]);
    std::vector<Interval3> result;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      result.push_back(toward(i, normalized(parameter(i) == 0 ? jet.way_u : jet.way_v)));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (piece_.points[i] != piece_.points[corner_])
        result.push_back(normalized(difference(piece_.corners[i], piece_.corners[corner_])));
    }
    return result;
  }
  /// The derivatives of all H along a side, where a range has it.
  Interval3 along_side(Range range) const {
    if (!piece_.grid || piece_.pole) return ways(range)[0];
    const std::size_t k = parameter(0);
    range[1 - k] = at(corner_, 1 - k);
    const SurfaceJet<Interval> jet = piece_.surface->over(range[0], range[1]);
    return hull(normalized(difference(piece_.corners[ends_[0]], piece_.corners[corner_])),
                toward(0, normalized(k == 0 ? jet.way_u : jet.way_v)));
  }
  /// The derivatives of all H there, away from the common corner: of a side the first is along it.
  std::vector<Interval3> ways(const Range& range) const {
    std::vector<Interval3> result;
    if (piece_.kind == Piece::Kind::curve) {
      const Interval3 all = along_curve(all_, piece_, range);
      return {corner_ == 0 ? all : scaled(Interval(-1), all)};
    }
    const SurfaceJet<Interval> jet = piece_.surface->over(range[0], range[1]);
    if (piece_.grid) {
      std::array<Interval3, 2> all{jet.way_u, jet.way_v};
      const auto& pole = piece_.pole;
      if (pole && range[pole->away].inf() <= pole->at && pole->at <= range[pole->away].sup()) {
        const bool upper = pole->at > middle_of(piece_.range[pole->away]);
        all[1 - pole->away] = scaled(Interval(upper ? -1 : 1),
                                     *piece_.surface->fan_over(1 - pole->away, pole->at, range[0], range[1]));
      }
      all = {hull(normalized(piece_.along_u), normalized(all[0])),
             hull(normalized(piece_.along_v), normalized(all[1]))};
      for (std::size_t i = 0; i < ends_.size(); ++i) result.push_back(toward(i, all[parameter(i)]));
      return result;
    }
    const Interval3 u = hull(piece_.along_u, jet.along_u), v = hull(piece_.along_v, jet.along_v);
    for (const std::size_t end : ends_) {
      const auto step = [&](std::size_t k) { return Interval(at(end, k)) - Interval(at(corner_, k)); };
      result.push_back(normalized(sum(scaled(step(0), u), scaled(step(1), v))));
    }
    return result;
  }

 private:
  double at(std::size_t corner, std::size_t k) const { return piece_.at[corner][k]; }
  /// The derivative by the parameter that leads to an end, in this direction.
  Interval3 toward(std::size_t end, const Interval3& way) const {
    const std::size_t k = parameter(end);
    return at(ends_[end], k) > at(corner_, k) ? way : scaled(Interval(-1), way);
  }
  /// Of a grid: which one leads from the common corner to an end.
  std::size_t parameter(std::size_t end) const { return at(ends_[end], 0) != at(corner_, 0) ? 0 : 1; }

  const std::vector<Piece>& all_;
  const Piece& piece_;
  std::size_t corner_;
  std::vector<std::size_t> ends_;  // beside the corner, but for a pole; of a side its other end first
  bool by_side_ = false;
};

bool all_above(const Guess3& d, const std::vector<Interval3>& ways, double sign) {
  return std::ranges::all_of(ways,
                             [&](const Interval3& w) { return (Interval(sign) * dot(thin(d), w)).inf() > 0; });
}

/// True if a plane is between the directions of one and of the other.
bool between(const std::vector<Interval3>& a, const std::vector<Interval3>& b) {
  std::vector<Guess3> all;
  for (const Interval3& w : a) all.push_back(direction(middle_of(w)).value_or(Guess3{}));
  for (const Interval3& w : b) all.push_back(scaled(Upward(-1), direction(middle_of(w)).value_or(Guess3{})));
  const auto parts = [&](const Guess3& d) { return all_above(d, a, 1) && all_above(d, b, -1); };
  Guess3 mean{};
  for (const Guess3& w : all) mean = sum(mean, w);
  if (parts(mean)) return true;
  // Between two of them, or at one angle to three.
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (parts(sum(all[i], all[j]))) return true;
      for (std::size_t k = 0; k < j; ++k) {
        const Guess3 d = sum(cross(all[i], all[j]), sum(cross(all[j], all[k]), cross(all[k], all[i])));
        if (parts(d) || parts(scaled(Upward(-1), d))) return true;
      }
    }
  }
  return false;
}

class Beside {
 public:
  Beside(const Pieces& pieces, const Piece& a, const Piece& b, const CommonCorners& common)
      : a_(pieces.all(), a, common.of_a), side_(a_.by_side()) {
    if (b.kind == Piece::Kind::flat) {
      flat_ = &b;
      const auto around = [&](std::size_t corner) { return a.at[common.of_a[corner]][a.column->around]; };
      if (side_ && (b.wall || (a.column && around(0) != around(1))))
        away_ = pieces.away_from(b, a.points[common.of_a[0]], a.points[common.of_a[1]]);
      return;
    }
    b_.emplace(pieces.all(), b, common.of_b);
    side_ = side_ && b_->by_side();
  }

  /// True if two parts have no more in common than the side or corner.
  bool proven(const PiecePart& a, const PiecePart& b) const {
    return parted(std::array{a, b}, Between::facets_and_surfaces) || joined(a, b);
  }

 private:
  bool joined(const PiecePart& a, const PiecePart& b) const {
    std::optional<Interval> along;
    if (side_) along = hull(a_.along(a.range), b_ ? b_->along(b.range) : a_.along(a.range));
    const Range range_of_a = a_.from_common(a.range, along);
    if (!side_ && flat_ == nullptr)
      return between(a_.ways_from_corner(range_of_a), b_->ways_from_corner(b_->from_common(b.range, along)));
    const std::vector<Interval3> of_a = a_.ways(range_of_a);
    if (flat_ != nullptr) {
      const std::vector<Interval3> away = side_ ? std::vector{of_a[1]} : of_a;
      const auto sign = [&](const Interval3& w) { return dot(flat_->normal, w); };
      return std::ranges::all_of(away, [&](const Interval3& w) { return sign(w).inf() > 0; }) ||
             std::ranges::all_of(away, [&](const Interval3& w) { return sign(w).sup() < 0; }) ||
             (away_ && dot(*away_, of_a[1]).inf() > 0);
    }
    const Range range_of_b = b_->from_common(b.range, along);
    const std::vector<Interval3> of_b = b_->ways(range_of_b);
    const Interval3 e = hull(a_.along_side(range_of_a), b_->along_side(range_of_b));
    // Of e and all between v and -v'.
    const std::vector<Interval3> across{normalized(cross(e, of_a[1])), normalized(cross(of_b[1], e))};
    return all_above(sum(middle_of(across[0]), middle_of(across[1])), across, 1) ||
           independent(e, of_a[1], of_b[1]);
  }

  Opened a_;
  std::optional<Opened> b_;
  const Piece* flat_ = nullptr;
  std::optional<Interval3> away_;
  bool side_;
};

}  // namespace

bool share_corner(const Pieces& pieces, std::uint32_t a, std::uint32_t b) {
  return !common_corners(pieces, a, b).of_a.empty();
}

bool apart_but_beside(const Pieces& pieces, std::uint32_t a, std::uint32_t b, std::size_t& steps) {
  const std::vector<Piece>& all = pieces.all();
  if (a == b) {  // a curve does not return where all its directions are on one side
    const Interval3 way = along_curve(all, all[a], all[a].range);
    return dot(thin(middle_of(way)), way).inf() > 0;
  }
  if (all[a].kind == Piece::Kind::flat) std::swap(a, b);
  const CommonCorners common = common_corners(pieces, a, b);
  if (common.of_a.size() > 2 || common.of_a.empty()) return false;
  const Beside beside(pieces, all[a], all[b], common);
  std::size_t left = kMostOwnSteps;
  const bool proven = proven_by_halves(
      all, part_of(all, all[a], all[a].range), part_of(all, all[b], all[b].range),
      [&](const PiecePart& x, const PiecePart& y) { return beside.proven(x, y); }, left);
  steps += kMostOwnSteps - left;
  return proven;
}

}  // namespace cnrg
