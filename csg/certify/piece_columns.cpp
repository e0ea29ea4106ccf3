// Cells between half-planes through an axis: F is at the angle of S there; see pieces.h.
//
// Along a straight edge from one half-plane to the other, at right angles to the one in their middle, a point at
// the angle w from that middle is (1 + tan w / tan h) / 2 of the way, if the ends are at -h and h, and its
// distance from the axis is l = cos h / cos w times that of the ends. So F is at (l p, q), S at (r, z) in the
// half-plane at w. H is at (((1 - t) p + t r) ((1 - t) l + t), (1 - t) q + t z): in every half-plane of the column
// the same but for a common factor of all surfaces about the axis (coaxial.h). From (1 - t) F + t S it is t (1 -
// t) (p - r) (1 - l) away.
#include <cmath>
#include <unordered_map>

#include "csg/certify/pieces.h"

namespace cnrg {

using namespace surface_math;

namespace {

Interval tangent_of(const Interval& turns) { return sine(turns) / cosine(turns); }
Interval from_middle(const Interval& way) { return Interval(2) * way - Interval(1); }

/// How far a corner is from the plane of three others, at most, and the length of the shortest side.
std::array<Upward, 2> flatness(const Piece& piece) {
  const auto way = [&](std::size_t a, std::size_t b) { return difference(piece.corners[b], piece.corners[a]); };
  const Interval3 normal = cross(way(0, 1), way(0, 3));
  const Interval off = dot(normal, way(0, 2));
  Upward shortest = HUGE_VAL;
  for (std::size_t i = 0; i < 4; ++i) {
    if (piece.points[i] != piece.points[(i + 1) % 4])
      shortest = std::min(shortest, length(middle_of(way(i, (i + 1) % 4))));
  }
  return {2 * Upward(largest(off)) / length(middle_of(normal)), shortest};
}

/// The derivative of F in a half-plane of a side, and by how much that of S differs from it, at most.
struct MeridianSlope {
  Interval chord;
  double off;
};
MeridianSlope slope_of(const Piece& piece, std::size_t along) {
  constexpr int kParts = 4;
  std::size_t from = 0;  // a side along the meridian begins here
  while (piece.at[from][along] == piece.at[(from + 1) % 4][along]) ++from;
  const std::size_t to = (from + 1) % 4;
  const Interval start(piece.at[from][along]), step = Interval(piece.at[to][along]) - start;
  const Interval3 chord = scaled(Interval(1) / step, difference(piece.corners[to], piece.corners[from]));
  std::array<Interval, 2> at{Interval(piece.at[from][0]), Interval(piece.at[from][1])};
  MeridianSlope slope{CGAL::sqrt(dot(chord, chord)), 0};
  for (int k = 0; k < kParts; ++k) {
    at[along] = start + step * Interval(double(k) / kParts, double(k + 1) / kParts);
    const SurfaceJet<Interval> jet = piece.surface->over(at[0], at[1]);
    const Interval3 off = difference(along == 0 ? jet.along_u : jet.along_v, chord);
    slope.off = std::max(slope.off, double(length(Guess3{largest(off[0]), largest(off[1]), largest(off[2])})));
  }
  return slope;
}

std::optional<Piece::Column> column_of(const Piece& piece) {
  constexpr double kMostTurns = 0.24;
  constexpr double kMostOff = 1e-7;  // of the shortest side
  const auto turn = piece.grid && !piece.blind ? piece.surface->revolution() : std::nullopt;
  if (!turn) return std::nullopt;
  const auto [off, shortest] = piece.bent ? flatness(piece) : std::array<Upward, 2>{0, 1};
  if (!(off <= kMostOff * shortest)) return std::nullopt;
  const Interval& range = piece.range[turn->around];
  const Interval half = Interval(turn->turns / 2) * (Interval(range.sup()) - Interval(range.inf()));
  if (!(half.inf() > 0) || !(half.sup() < kMostTurns / 2)) return std::nullopt;
  const std::size_t along = 1 - turn->around;
  const MeridianSlope slope = slope_of(piece, along);
  // F's slope is less in the middle.
  const double least = (slope.chord * cosine(half) - Interval(slope.off)).inf();
  if (!(least > 0)) return std::nullopt;
  const double wide = (Interval(piece.range[along].sup()) - Interval(piece.range[along].inf())).sup();
  return Piece::Column{.around = turn->around,
                       .half = half,
                       .tangent = tangent_of(half),
                       .flat = (Interval(1) - cosine(half)).sup(),
                       .off = double(off),
                       .turned = off > 0 ? std::max(1e-9, double(10 * off / shortest)) : 0,
                       .chord = (Interval(slope.off) * wide).sup() / 2,
                       .tilt = double(Upward(slope.off) / least * 0.25 * (1 + 1e-12))};
}

bool goes_around(const Piece& cell, std::size_t side) {
  const std::size_t k = cell.column->around;
  return cell.at[side][k] != cell.at[(side + 1) % cell.corner_count][k];
}

}  // namespace

Interval Piece::Column::share(const Interval& way) const {
  if (way.inf() == way.sup() && (way.inf() == 0 || way.inf() == 1)) return way;
  return Interval(0.5) + tangent_of(from_middle(way) * half) / (Interval(2) * tangent);
}
Interval Piece::Column::growth(const Interval& way) const {
  const Interval c = cosine(Interval(from_middle(way) * half));
  return surface_math::turn<Interval>() * half / (tangent * c * c);
}

void find_neighbours(std::vector<Piece>& all, std::size_t first) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at_point;
  for (std::size_t i = first; i < all.size() && all[i].kind == Piece::Kind::cell; ++i) {
    for (std::size_t k = 0; k < all[i].corner_count; ++k) at_point[all[i].points[k]].push_back(std::uint32_t(i));
  }
  for (std::size_t i = first; i < all.size() && all[i].kind == Piece::Kind::cell; ++i) {
    std::map<std::uint32_t, std::uint8_t> found;
    for (std::size_t k = 0; k < all[i].corner_count; ++k) {
      for (const std::uint32_t j : at_point[all[i].points[k]]) {
        if (j != i && all[j].patch == all[i].patch) found[j] |= std::uint8_t(1u << k);
      }
    }
    all[i].neighbours.assign(found.begin(), found.end());
  }
}

void find_columns(std::vector<Piece>& all, std::size_t first, const PieceSides& sides) {
  bool any = false;
  for (std::size_t i = first; i < all.size() && all[i].kind == Piece::Kind::cell; ++i) {
    all[i].column = column_of(all[i]);
    any = any || all[i].column;
  }
  // Both cells at an edge have one F there, so a column has none but such cells. Beyond those that are pieces
  // nothing is near.
  while (any) {
    any = false;
    for (const auto& [edge, pieces] : sides) {
      const auto other = [&](const auto& p) {
        return p.first != kNone && all[p.first].kind == Piece::Kind::cell &&
               !(all[p.first].column && goes_around(all[p.first], p.second));
      };
      if (std::ranges::none_of(pieces, other)) continue;
      for (const auto& [i, side] : pieces) {
        if (i == kNone || !all[i].column || !goes_around(all[i], side)) continue;
        all[i].column.reset();
        any = true;
      }
    }
  }
  for (std::size_t i = first; i < all.size() && all[i].kind == Piece::Kind::cell; ++i) {
    if (!all[i].column) continue;
    const Piece::Column& column = *all[i].column;
    // The directions of two triangles are no farther from those of their sides.
    Interval3& around = column.around == 0 ? all[i].along_u : all[i].along_v;
    Interval3& along = column.around == 0 ? all[i].along_v : all[i].along_u;
    around = widened(normalized(around), column.turned);
    along = widened(normalized(along), double(column.turned + Upward(column.tilt) * column.flat));
  }
}

}  // namespace cnrg
