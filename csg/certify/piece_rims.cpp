// Sides that cells of two surfaces have in common in a plane, exactly; see pieces.h.
//
// In a plane across the axis, at a corner at the angle w from the middle of a side, H is at ((1 - t) cos h / cos w
// + t) of the radius (piece_columns.cpp): of two surfaces of revolution it is the same for all t. A torus has half
// a circle in each half-plane from its axis. There H is elsewhere between the same chord and arc, and can be moved
// in the plane to where that of the other cell is, with directions between those of chord and arc.
#include <algorithm>

#include "csg/certify/pieces.h"
#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

using namespace surface_math;

std::optional<Quadric> Pieces::trace(std::uint32_t sheet, const RationalPoint& normal,
                                     const RationalPoint& p) const {
  if (is_quadric(sheet)) return equations_.quadrics.at(sheet);
  const auto& [center, axis, radius, tube] = equations_.tori.at(sheet);
  RationalPoint out = cross(axis, normal);
  const auto length = rational_root(dot(out, out));
  if (!length || *length == 0 || dot(axis, normal) != 0 || dot(p - center, normal) != 0) return std::nullopt;
  const RationalPoint middle = center + Rational(sgn(dot(p - center, out)) * radius / *length) * out;
  Quadric ball{};
  for (std::size_t i = 0; i < 3; ++i) ball[i][i] = 1, ball[i][3] = ball[3][i] = -middle[i];
  ball[3][3] = dot(middle, middle) - tube * tube;
  return ball;
}

bool Pieces::may_share_rim(std::uint32_t flat, std::uint32_t cell) const {
  const Piece &plane = pieces_[flat], &piece = pieces_[cell];
  return piece.column && has_equation(piece.sheet) &&
         std::ranges::count_if(std::span(piece.corners).first(piece.corner_count), [&](const Interval3& p) {
           return holds_zero(dot(plane.normal, difference(p, plane.point)));
         }) == 2;
}

const std::optional<Pieces::RimSide>& Pieces::rim_side(std::uint32_t sheet, std::uint32_t cell) {
  const auto [it, fresh] = rim_sides_.try_emplace({sheet, cell});
  if (!fresh) return it->second;
  const Piece& piece = pieces_[cell];
  const auto& [x, y, z, w] = plane_of(sheet);
  const RationalPoint normal{x, y, z};
  const bool torus = !is_quadric(piece.sheet);
  const std::size_t fixed = torus ? piece.column->around : 1 - piece.column->around;
  RimSide found;
  std::set<double> levels;
  std::set<RationalPoint> ring;  // of cells beside it
  const auto add = [&](const Piece& of, std::set<RationalPoint>& to) {
    for (std::size_t k = 0; k < of.corner_count; ++k) {
      const RationalPoint& p = points_.at(of.leaf)[of.points[k]];
      const int side = sgn(dot(normal, p) + w);
      if (side == 0) to.insert(p), levels.insert(of.at[k][fixed]);
      else if (&of == &piece) found.side = side;
    }
  };
  add(piece, found.ends);
  if (found.ends.size() != 2 || levels.size() != 1) return it->second;
  for (std::size_t k = 0; !torus && k < piece.neighbours.size(); ++k)
    add(pieces_[piece.neighbours[k].first], ring);
  if (levels.size() == 1 && (torus || ring.size() > 2)) it->second = std::move(found);
  return it->second;
}

const std::optional<Pieces::Rim>& Pieces::rim(std::uint32_t flat, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t sheet = pieces_[flat].sheet;
  const auto [it, fresh] = rims_.try_emplace({sheet, a, b});
  if (!fresh) return it->second;
  const auto &of_a = rim_side(sheet, a), &of_b = rim_side(sheet, b);
  if (of_a && of_b) it->second = find_rim(sheet, {a, b}, {&of_a->ends, &of_b->ends});
  if (it->second) it->second->sides = {of_a->side, of_b->side};
  return it->second;
}

std::optional<Pieces::Rim> Pieces::find_rim(std::uint32_t sheet, const std::array<std::uint32_t, 2>& cells,
                                            const std::array<const std::set<RationalPoint>*, 2>& ends) const {
  const auto& [x, y, z, w] = plane_of(sheet);
  const RationalPoint normal{x, y, z};
  Rim rim;
  // Both equations on the plane, from one of its points along two ways: equal but for a factor.
  const RationalPoint from = *ends[0]->begin(), along = *ends[0]->rbegin() - from, across = cross(normal, along);
  std::array<std::array<Rational, 6>, 2> conics;
  std::array<RationalPoint, 2> out, middle;  // from the middle of a chord, at right angles to it
  for (std::size_t i = 0; i < 2; ++i) {
    const auto q = trace(pieces_[cells[i]].sheet, normal, *ends[i]->begin());
    if (!q) return std::nullopt;
    const RationalPoint g = gradient_of(*q, from), u = gradient_of(*q, from + along) - g,
                        v = gradient_of(*q, from + across) - g, n = gradient_of(*q, from + normal) - g;
    if (!is_zero(cross(n, normal))) return std::nullopt;  // the plane is not across the axis
    middle[i] = Rational(Rational(1) / 2) * (*ends[i]->begin() + *ends[i]->rbegin());
    out[i] = Rational(sgn(dot(along, u))) * gradient_of(*q, middle[i]);
    conics[i] = {dot(along, u), dot(along, v),  dot(across, v),
                 dot(along, g), dot(across, g), Rational(dot(from, g) + row_times(*q, 3, from))};
    divide_by_first(conics[i]);
  }
  const Rational wider = conics[0][5] - conics[1][5];  // b's
  conics[0][5] = conics[1][5];
  if (conics[0] != conics[1]) return std::nullopt;
  if (wider != 0) {  // one ring, at every angle, in the other one, if chords are
    const std::size_t inner = wider > 0 ? 0 : 1, outer = 1 - inner;
    const bool apart = std::ranges::all_of(
        *ends[inner], [&](const RationalPoint& p) { return dot(out[outer], p - middle[outer]) < 0; });
    return apart ? std::optional(rim) : std::nullopt;
  }
  rim.shared = true;
  if (*ends[0] == *ends[1]) return rim;
  // They have one in common, and the others are on both sides of it.
  std::vector<RationalPoint> corner, others;
  std::ranges::set_intersection(*ends[0], *ends[1], std::back_inserter(corner));
  std::ranges::set_symmetric_difference(*ends[0], *ends[1], std::back_inserter(others));
  const auto beyond = [&](std::size_t i) { return sgn(dot(others[i] - corner[0], cross(normal, out[0]))); };
  return !corner.empty() && beyond(0) * beyond(1) < 0 ? std::optional(rim) : std::nullopt;
}

}  // namespace cnrg
