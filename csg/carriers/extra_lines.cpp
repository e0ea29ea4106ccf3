// Parameters as directions and rows.
#include "csg/carriers/extra_lines.h"

#include <set>

#include "csg/carriers/turns.h"
#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
RevolvedLines revolved_lines(const ExtraLines& lines, const RevolvedForm& form, const Transform& transform,
                             const Rational& scale) {
  const CircleFrame frame(form.axis);
  RevolvedLines result;
  std::set<Rational> turns;
  std::size_t number = 0;
  for (const auto& line : form.lines) {
    for (const MeridianPiece& piece : line) {
      const std::size_t k = number++;
      const auto of = lines.of.find(piece.patch);
      if (of == lines.of.end() ||
          (piece.from.r == 0 && piece.to.r == 0 && piece.kind == MeridianPiece::Kind::line))
        continue;
      const auto& [u, v] = of->second;
      for (const Rational& turn : form.turn_is_u ? u : v) {
        if (form.around()) turns.insert(within_one(turn));
        else if (sgn(turn) > 0 && turn < 1) turns.insert(turn);
      }
      each_between(form.turn_is_u ? v : u, piece.parameters, [&](const Rational& way) {
        result.rows.push_back({k, way});
      });
    }
  }
  for (const Rational& turn : turns) {
    result.directions.push_back(Rational(1 / scale) *
                                transform.apply_to_vector(frame.offset(1, turn * form.degrees)));
  }
  return result;
}

RevolvedLines revolved_lines(const ExtraLines& lines, const ExtrudeForm& form, const ExtrudedArc& arc) {
  RevolvedLines result;
  const auto of = lines.of.find(arc.segment + (form.shape.profile.closed ? 2 : 0));
  if (of == lines.of.end()) return result;
  std::size_t first = 0;
  for (const ProfileLine& line : form.shape.profile.lines) {
    if (arc.segment < first + line.segments.size()) {
      const std::vector<Span> spans = curve_spans(line.segments[arc.segment - first]);
      each_between(of->second[0], spans[arc.piece], [&](const Rational& way) {
        const RationalPoint p = arc.curve.at(way);
        const AxisLine& axis = arc.placed.axis;
        const RationalPoint out = p - (axis.foot + axis.place_of(p) * axis.direction);
        result.directions.push_back((1 / arc.placed.lines[0][0].from.r) * out);
      });
      break;
    }
    first += line.segments.size();
  }
  return result;
}

}  // namespace cnrg
