// Meridians of Bézier curves, and the way from rows and columns to facets.
//
// A Bézier curve of degree 2 is an arc of a circle if its inner control point p1 is as far from both ends, p0 and
// p2, and w1^2 / (w0 w2) is the square of the cosine of half its opening; all of it is rational. Along
// it, the tangent of a quarter of the opening grows with t' = t r / (t r + 1 - t), r = sqrt(w2 / w0).
#include "csg/curves/revolved.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "csg/geometry/circle.h"
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

class Sweep {
 public:
  using PointAt = std::function<RationalPoint(const MeridianPoint&, std::size_t)>;
  Sweep(const RevolvedForm& form, const RevolvedGrid& grid, const PointAt& point, LeafParameters* record)
      : form_(form), grid_(grid), point_(point), builder_(form.solid ? Fill::winding : Fill::none, record, true) {}

  std::unique_ptr<PreparedLeaf> run() {
    if (form_.closed_lines) check_profile();
    for (const auto& [patch, name] : form_.names) builder_.name_patch(patch, name.c_str());
    std::vector<std::vector<PointId>> first, last;  // of each line
    for (std::size_t l = 0; l < form_.lines.size(); ++l) {
      first.emplace_back();
      last.emplace_back();
      add_line(l, first.back(), last.back());
    }
    if (!form_.around()) {
      if (form_.closed_lines) add_ends(first, last);
      else if (!form_.solid) builder_.end_curves(first[0]), builder_.end_curves(last[0]);
    }
    return builder_.finish();
  }

 private:
  using Ring = std::vector<PointId>;

  /// With further corners it may cross itself.
  void check_profile() const {
    std::vector<std::vector<RationalPoint>> loops;
    for (const auto& line : grid_.rows) {
      loops.emplace_back();
      for (const auto& piece : line)
        for (std::size_t j = 0; j + 1 < piece.size(); ++j)
          loops.back().push_back({piece[j].at.r, 0, piece[j].at.t});
    }
    check_polygon(loops, {"the profile of revolve", [&](std::size_t l, std::size_t i) {
                            return "[" + to_decimal(loops[l][i][0]) + ", " + to_decimal(loops[l][i][2]) + "]";
                          }});
  }

  std::size_t columns() const { return grid_.columns.size() - (form_.around() ? 1 : 0); }

  Ring ring(const MeridianPoint& at) {
    if (at.r == 0) return Ring(columns(), builder_.point(point_(at, 0)));
    Ring result;
    for (std::size_t i = 0; i < columns(); ++i) result.push_back(builder_.point(point_(at, i)));
    return result;
  }

  /// Notes the points of the first and of the last column, in the order of the line.
  void add_line(std::size_t l, std::vector<PointId>& first, std::vector<PointId>& last) {
    const auto& pieces = form_.lines[l];
    const Ring begin = ring(grid_.rows[l][0].front().at);
    Ring lower = begin;
    const auto note = [&](const Ring& of) {
      first.push_back(of.front());
      last.push_back(of.back());
    };
    note(begin);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const auto& rows = grid_.rows[l][p];
      if (is_apex(pieces[p], pieces[p].from)) builder_.soup().add_curve_end(builder_.leaf(), lower[0]);
      for (std::size_t j = 1; j < rows.size(); ++j) {
        const bool closes = form_.closed_lines && p + 1 == pieces.size() && j + 1 == rows.size();
        const Ring upper = closes ? begin : ring(rows[j].at);
        if (rows[j - 1].at.r != 0 || rows[j].at.r != 0) add_band(lower, upper, pieces[p], rows[j - 1], rows[j]);
        if (!closes) note(upper);
        lower = upper;
      }
      if (is_apex(pieces[p], pieces[p].to)) builder_.soup().add_curve_end(builder_.leaf(), lower[0]);
    }
    if (!form_.discs) return;
    if (begin[0] != begin[1]) builder_.face(Ring(begin.rbegin(), begin.rend()), 0);
    if (lower[0] != lower[1]) builder_.face(lower, 1);
  }

  void add_band(const Ring& lower, const Ring& upper, const MeridianPiece& piece, const RevolvedGrid::Row& low,
                const RevolvedGrid::Row& high) {
    const Rational &p0 = low.parameter, &p1 = high.parameter;
    for (std::size_t i = 0; i + 1 < grid_.columns.size(); ++i) {
      const std::size_t j = (i + 1) % lower.size();
      const Rational &t0 = grid_.columns[i].turn, &t1 = grid_.columns[i + 1].turn;
      if (form_.turn_is_u) {
        builder_.facet(lower[i], lower[j], upper[j], upper[i], piece.patch,
                       {{{&t0, &p0}, {&t1, &p0}, {&t1, &p1}, {&t0, &p1}}});
      } else {
        builder_.facet(lower[i], lower[j], upper[j], upper[i], piece.patch,
                       {{{&p0, &t0}, {&p0, &t1}, {&p1, &t1}, {&p1, &t0}}});
      }
    }
  }

  /// The areas at the two ends of a turn.
  void add_ends(const std::vector<std::vector<PointId>>& first, std::vector<std::vector<PointId>> last) {
    builder_.face(first, grid_.mirrored ? 1 : 0);
    for (auto& loop : last) std::reverse(loop.begin(), loop.end());
    builder_.face(last, grid_.mirrored ? 0 : 1);
  }

  const RevolvedForm& form_;
  const RevolvedGrid& grid_;
  const PointAt& point_;
  LeafBuilder builder_;
};

double angle_of(const MeridianPoint& p, const MeridianPoint& middle, double axis) {
  return rounded::arc_tangent(to_double(p.t - middle.t) * axis, to_double(p.r - middle.r)) * 180 /
         std::numbers::pi;
}

/// Makes an arc of the piece, if its curve is one.
void make_arc(MeridianPiece& piece, const ControlRow& row, const Rational& square) {
  const auto point = [&](std::size_t i) {
    const RationalPoint p = project(row[i]);
    return MeridianPoint{p[0], p[2]};
  };
  const auto distance2 = [&](const MeridianPoint& a, const MeridianPoint& b) -> Rational {
    return (a.r - b.r) * (a.r - b.r) + square * (a.t - b.t) * (a.t - b.t);
  };
  const MeridianPoint p0 = point(0), p1 = point(1), p2 = point(2);
  const MeridianPoint middle{(p0.r + p2.r) / 2, (p0.t + p2.t) / 2};
  const auto reach = center_of_arc(row, distance2(p0, p1), distance2(p1, p2), distance2(p0, middle));
  if (!reach) return;
  const MeridianPoint center{p1.r + *reach * (middle.r - p1.r), p1.t + *reach * (middle.t - p1.t)};
  const std::optional<Rational> radius = rational_root(distance2(p0, center));
  if (!radius) return;
  const double axis = std::sqrt(to_double(square));
  const double from = angle_of(p0, center, axis), to = angle_of(p2, center, axis);
  piece.kind = MeridianPiece::Kind::arc;
  piece.middle = center;
  piece.radius = *radius;
  piece.start = from_double(from);
  piece.sweep = from_double(std::remainder(to - from, 360));
}

}  // namespace

std::optional<Rational> center_of_arc(const ControlRow& net, const Rational& to_first, const Rational& to_last,
                                      const Rational& half_chord) {
  const Rational cosine2 = net[1][3] * net[1][3] / (net[0][3] * net[2][3]);
  if (to_first != to_last || cosine2 >= 1 || cosine2 * to_first != half_chord) return std::nullopt;
  return Rational(1 / (1 - cosine2));
}

MeridianPiece meridian_piece(const BezierCurve& curve, const Span& span, const Rational& square) {
  MeridianPiece piece;
  piece.parameters = span;
  piece.net = curve;
  const RationalPoint from = curve.at(0), to = curve.at(1);
  piece.from = {from[0], from[2]};
  piece.to = {to[0], to[2]};
  const ControlRow row = reduced(curve.net);
  if (row.size() == 2) return piece;
  piece.kind = MeridianPiece::Kind::net;
  if (row.size() == 3) make_arc(piece, row, square);
  return piece;
}

MeridianPiece reversed(MeridianPiece piece) {
  std::swap(piece.from, piece.to);
  std::swap(piece.parameters[0], piece.parameters[1]);
  std::reverse(piece.net.net.begin(), piece.net.net.end());
  piece.start += piece.sweep;
  piece.sweep = -piece.sweep;
  return piece;
}

Rational parameter_of(const MeridianPiece& arc, const Rational& degrees) {
  const Rational way = (degrees - arc.start) / arc.sweep;
  if (arc.net.net.empty()) return in_span(arc.parameters, way);
  const double quarter = std::abs(to_double(arc.sweep)) * std::numbers::pi / 720;
  const double even = (rounded::tangent((2 * to_double(way) - 1) * quarter) / rounded::tangent(quarter) + 1) / 2;
  const ControlRow row = reduced(arc.net.net);
  const double ratio = std::sqrt(to_double(row[2][3] / row[0][3]));
  return in_span(arc.parameters, from_double(even / (even + ratio * (1 - even))));
}

bool is_apex(const MeridianPiece& piece, const MeridianPoint& end) {
  if (end.r != 0 || piece.flat()) return false;
  if (piece.kind == MeridianPiece::Kind::arc) return piece.middle.r != 0;
  if (piece.kind == MeridianPiece::Kind::line) return piece.from.r != piece.to.r;
  const ControlRow& net = piece.net.net;
  const bool first = end == piece.from;
  return project(first ? net[0] : net.back())[2] != project(first ? net[1] : net[net.size() - 2])[2];
}

std::unique_ptr<PreparedLeaf> tessellate(
    const RevolvedForm& form, const RevolvedGrid& grid,
    const std::function<RationalPoint(const MeridianPoint&, std::size_t)>& point, LeafParameters* record) {
  return Sweep(form, grid, point, record).run();
}

}  // namespace cnrg
