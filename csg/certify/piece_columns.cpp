// Cells between half-planes through an axis: F is at the angle of S there; see pieces.h.
//
// Along a straight edge from one half-plane to the other, at right angles to the one in their middle, a point at
// the angle w from that middle is (1 + tan w / tan h) / 2 of the way, if the ends are at -h and h. So H of such a
// cell stays in the half-plane of its angle for all t, and all leaves about one axis do so alike (coaxial.h).
#include "csg/certify/pieces.h"

namespace cnrg {

using namespace surface_math;

namespace {

Interval tangent_of(const Interval& turns) { return sine(turns) / cosine(turns); }
Interval from_middle(const Interval& way) { return Interval(2) * way - Interval(1); }

std::optional<Piece::Column> column_of(const Piece& piece) {
  constexpr double kMostTurns = 0.2;
  const auto turn = piece.grid && !piece.bent && !piece.blind ? piece.surface->revolution() : std::nullopt;
  if (!turn) return std::nullopt;
  const Interval& range = piece.range[turn->around];
  const Interval half = Interval(turn->turns / 2) * (Interval(range.sup()) - Interval(range.inf()));
  if (!(half.inf() > 0) || !(half.sup() < kMostTurns / 2)) return std::nullopt;
  return Piece::Column{turn->around, half, tangent_of(half)};
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
}

}  // namespace cnrg
