// Nets cut to boxes; see the header.
#include "csg/curves/surface_spline.h"

#include <optional>

#include "kernel/base/error.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

using namespace surface_math;

template <class N>
using Point4 = std::array<N, 4>;
template <class N>
using Row = std::vector<Point4<N>>;

ConstantRow row_of(const ControlRow& row, const RationalPoint& origin) {
  ConstantRow result;
  for (const Homogeneous& h : row) {
    result.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      result.back()[k] = constant(k < 3 ? Rational(h[k] - h[3] * origin[k]) : h[3]);
  }
  return result;
}

Homogeneous step(const Homogeneous& a, const Homogeneous& b, std::size_t degree) {
  Homogeneous d;
  for (std::size_t k = 0; k < 4; ++k) d[k] = to_integer(degree) * (b[k] - a[k]);
  return d;
}

/// The control row of the derivative; of a point, zero.
ControlRow derivative(const ControlRow& row) {
  ControlRow result;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) result.push_back(step(row[i], row[i + 1], row.size() - 1));
  if (result.empty()) result.push_back({0, 0, 0, 0});
  return result;
}

bool all_weights_are_one(const ControlRow& row) {
  return std::all_of(row.begin(), row.end(), [](const Homogeneous& h) { return h[3] == 1; });
}

template <class N>
Row<N> as_numbers(const ConstantRow& row) {
  Row<N> result;
  for (const auto& h : row) result.push_back({as<N>(h[0]), as<N>(h[1]), as<N>(h[2]), as<N>(h[3])});
  return result;
}

/// Whether the first or last column (of u, 0), or row, has equal points.
bool is_point(const std::vector<ControlRow>& net, std::size_t parameter, bool first) {
  const auto at = [&](const auto& row) { return first ? row.front() : row.back(); };
  if (parameter == 1) return std::ranges::count(at(net), at(net)[0]) == std::ptrdiff_t(net[0].size());
  return std::ranges::all_of(net, [&](const ControlRow& row) { return at(row) == at(net[0]); });
}

template <class N>
void mix(Row<N>& row, std::size_t last, const N& t) {
  const N s = N(1) - t;
  for (std::size_t i = 0; i < last; ++i) {
    for (std::size_t k = 0; k < 4; ++k) row[i][k] = s * row[i][k] + t * row[i + 1][k];
  }
}

/// Adds what a row is at a number: one point. Over an interval: the control points of the part there.
void add_cut(Row<double> row, double t, Row<double>& result) {
  for (std::size_t n = row.size() - 1; n > 0; --n) mix(row, n, t);
  result.push_back(row[0]);
}
void add_cut(Row<Interval> row, const Interval& t, Row<Interval>& result) {
  if (t.is_point() && (t.inf() == 0 || t.inf() == 1))
    return result.push_back(t.inf() == 0 ? row.front() : row.back());
  // The blossom at the upper end taken ever more often, and else at the lower end.
  Row<Interval> d;
  for (std::size_t degree = row.size() - 1;; --degree) {
    d.assign(row.begin(), row.begin() + std::ptrdiff_t(degree) + 1);
    for (std::size_t n = degree; n > 0; --n) mix(d, n, Interval(t.inf()));
    result.push_back(d[0]);
    if (degree == 0) return;
    mix(row, degree, Interval(t.sup()));
  }
}
template <class N>
Row<N> cut(const ConstantRow& row, const N& t) {
  Row<N> result;
  add_cut(as_numbers<N>(row), t, result);
  return result;
}

double joined(double a, double) { return a; }
Interval joined(const Interval& a, const Interval& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}
template <class N>
Vector3<N> joined(const Vector3<N>& a, const Vector3<N>& b) {
  return {joined(a[0], b[0]), joined(a[1], b[1]), joined(a[2], b[2])};
}

/// The hull of some points, or of those that they stand for.
template <class N>
Point4<N> hull(const Row<N>& row) {
  Point4<N> h = row[0];
  for (const Point4<N>& p : row) {
    for (std::size_t k = 0; k < 4; ++k) h[k] = joined(h[k], p[k]);
  }
  return h;
}
template <class N>
Vector3<N> projected_hull(Row<N> row, bool polynomial) {
  for (Point4<N>& p : row) {
    for (std::size_t k = 0; k < 3 && !polynomial; ++k) p[k] = p[k] / p[3];
  }
  const Point4<N> h = hull(row);
  return {h[0], h[1], h[2]};
}

/// Moves homogeneous points, or the differences of such, so that `center` becomes the origin: P_t w - P w_t stays
/// what it is, and over a box it is the narrower the smaller P is.
void recenter(Row<double>&, const Vector3<double>&) {}
void recenter(Row<Interval>& row, const Vector3<Interval>& center) {
  for (Point4<Interval>& p : row) {
    for (std::size_t k = 0; k < 3; ++k) p[k] -= p[3] * center[k];
  }
}
double middle(double x) { return x; }
Interval middle(const Interval& x) { return enclosure::middle_of(x); }

/// P_t w - P w_t, a positive multiple of the derivative of P / w.
template <class N>
Vector3<N> direction(const Point4<N>& p, const Point4<N>& p_t, bool polynomial) {
  if (polynomial) return {p_t[0], p_t[1], p_t[2]};
  Vector3<N> d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = p_t[k] * p[3] - p[k] * p_t[3];
  return d;
}

/// The place in a span, from 0 to 1; of an interval the part that is there. Nothing for an interval beside it.
std::optional<double> local(double t, const Constant& from, const Constant& size, bool first, bool last) {
  const double x = (t - from.value) / size.value;
  if ((x < 0 && !first) || (x > 1 && !last)) return std::nullopt;
  return std::clamp(x, 0.0, 1.0);
}
std::optional<Interval> local(const Interval& t, const Constant& from, const Constant& size, bool, bool) {
  const Interval x = (t - from.range) / size.range;
  if (x.sup() < 0 || x.inf() > 1) return std::nullopt;
  return Interval(std::max(x.inf(), 0.0), std::min(x.sup(), 1.0));
}

bool one_is_enough(double) { return true; }
bool one_is_enough(const Interval&) { return false; }

}  // namespace

SplineCurve::SplineCurve(const std::vector<BezierCurve>& pieces, const std::vector<Span>& spans) {
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const ControlRow& row = pieces[k].net;
    const RationalPoint origin = project(row[0]);
    pieces_.push_back({constant(spans[k][0]), constant(Rational(spans[k][1] - spans[k][0])), constants(origin),
                       row_of(row, origin), row_of(derivative(row), origin), all_weights_are_one(row)});
  }
}

template <class N>
CurveJet<N> SplineCurve::jet(const N& t) const {
  std::optional<CurveJet<N>> result;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const std::optional<N> at = local(t, piece.from, piece.size, i == 0, i + 1 == pieces_.size());
    if (!at) continue;
    Row<N> row = cut(piece.net, *at), row_t = cut(piece.derivative, *at);
    const Vector3<N> point = projected_hull(row, piece.polynomial);
    if (!piece.polynomial) {
      const Vector3<N> center{middle(point[0]), middle(point[1]), middle(point[2])};
      recenter(row, center);
      recenter(row_t, center);
    }
    const Point4<N> p = hull(row), p_t = hull(row_t);
    const N scale = N(1) / (as<N>(piece.size) * (piece.polynomial ? N(1) : p[3] * p[3]));
    CurveJet<N> jet{sum(as<N>(piece.origin), point), scaled(scale, direction(p, p_t, piece.polynomial))};
    if (result) jet = {joined(result->point, jet.point), joined(result->along, jet.along)};
    result = jet;
    if (one_is_enough(t)) break;
  }
  require(result.has_value(), "surfaces: a parameter beyond the ends of its curve");
  return *result;
}
template CurveJet<double> SplineCurve::jet(const double&) const;
template CurveJet<Interval> SplineCurve::jet(const Interval&) const;

SplinePatch::SplinePatch(const std::vector<BezierPatch>& pieces, const std::vector<std::array<Span, 2>>& spans) {
  const auto border = [&](std::size_t d, std::size_t end) {
    return (end == 0 ? spans.front() : spans.back())[d][end];
  };
  std::array<std::array<bool, 2>, 2> points{{{true, true}, {true, true}}};  // by parameter, end: that side is one
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::vector<ControlRow>& net = pieces[k].net;
    const RationalPoint origin = project(net[0][0]);
    Piece piece;
    piece.origin = constants(origin);
    piece.polynomial = std::ranges::all_of(net, all_weights_are_one);
    for (std::size_t d = 0; d < 2; ++d) {
      piece.from[d] = constant(spans[k][d][0]);
      piece.size[d] = constant(Rational(spans[k][d][1] - spans[k][d][0]));
      for (std::size_t end = 0; end < 2; ++end) {
        if (!piece.polynomial || (spans[k][d][end] == border(d, end) && !is_point(net, d, end == 0)))
          points[d][end] = false;
      }
    }
    for (std::size_t j = 0; j < net.size(); ++j) {
      piece.net.push_back(row_of(net[j], origin));
      piece.along_u.push_back(row_of(derivative(net[j]), origin));
      if (j + 1 == net.size() && j > 0) continue;
      ControlRow across;
      for (std::size_t i = 0; i < net[j].size(); ++i) {
        across.push_back(j + 1 == net.size() ? Homogeneous{0, 0, 0, 0}
                                             : step(net[j][i], net[j + 1][i], net.size() - 1));
      }
      piece.along_v.push_back(row_of(across, origin));
      piece.twist.push_back(row_of(derivative(across), origin));
    }
    pieces_.push_back(std::move(piece));
  }
  for (std::size_t d = 0; d < 2; ++d) {
    for (std::size_t end = 0; end < 2; ++end) {
      if (points[d][end]) poles_[d].push_back(constant(border(d, end)).value);
    }
  }
}

namespace {

/// All control points of the part of a net over a box, at a point the one there.
template <class N>
Row<N> cut(const std::vector<ConstantRow>& net, const N& u, const N& v) {
  Row<N> cells, column(net.size()), result;
  for (const ConstantRow& row : net) add_cut(as_numbers<N>(row), u, cells);
  const std::size_t length = cells.size() / net.size();
  for (std::size_t i = 0; i < length; ++i) {
    for (std::size_t j = 0; j < net.size(); ++j) column[j] = cells[j * length + i];
    add_cut(column, v, result);
  }
  return result;
}

}  // namespace

template <class N, class Body>
void SplinePatch::for_each_piece(const N& u, const N& v, const Body& body) const {
  const Piece& end = pieces_.back();
  for (const Piece& piece : pieces_) {
    const auto same = [](const Constant& a, const Constant& b) { return a.value == b.value; };
    std::array<std::optional<N>, 2> at;
    for (std::size_t d = 0; d < 2; ++d) {
      at[d] = local(d == 0 ? u : v, piece.from[d], piece.size[d], same(piece.from[d], pieces_[0].from[d]),
                    same(piece.from[d], end.from[d]));
    }
    if (!at[0] || !at[1]) continue;
    body(piece, *at[0], *at[1]);
    if (one_is_enough(u)) break;
  }
}

template <class N>
SurfaceJet<N> SplinePatch::jet(const N& u, const N& v) const {
  std::optional<SurfaceJet<N>> result;
  for_each_piece(u, v, [&](const Piece& piece, const N& x, const N& y) {
    Row<N> net = cut(piece.net, x, y), net_u = cut(piece.along_u, x, y), net_v = cut(piece.along_v, x, y);
    const Vector3<N> point = projected_hull(net, piece.polynomial);
    if (!piece.polynomial) {
      const Vector3<N> center{middle(point[0]), middle(point[1]), middle(point[2])};
      for (Row<N>* const row : {&net, &net_u, &net_v}) recenter(*row, center);
    }
    const Point4<N> p = hull(net), p_u = hull(net_u), p_v = hull(net_v);
    const Vector3<N> along_u = direction(p, p_u, piece.polynomial), along_v = direction(p, p_v, piece.polynomial);
    const N by = piece.polynomial ? N(1) : p[3] * p[3];
    SurfaceJet<N> jet{sum(as<N>(piece.origin), point), scaled(N(N(1) / (by * as<N>(piece.size[0]))), along_u),
                      scaled(N(N(1) / (by * as<N>(piece.size[1]))), along_v), cross(along_u, along_v)};
    if (result) {
      jet = {joined(result->point, jet.point), joined(result->along_u, jet.along_u),
             joined(result->along_v, jet.along_v), joined(result->normal, jet.normal)};
    }
    result = jet;
  });
  require(result.has_value(), "surfaces: parameters beyond the sides of their patch");
  return *result;
}

std::optional<Vector3<Interval>> SplinePatch::fan_over(std::size_t around, double pole, const Interval& u,
                                                       const Interval& v) const {
  if (std::ranges::count(poles_[1 - around], pole) == 0) return std::nullopt;
  std::optional<Vector3<Interval>> result;
  for_each_piece(u, v, [&](const Piece& piece, const Interval& x, const Interval& y) {
    const Point4<Interval> p = hull(cut(piece.twist, x, y));
    const Vector3<Interval> fan = scaled(
        Interval(Interval(1) / (as<Interval>(piece.size[0]) * as<Interval>(piece.size[1]))), {p[0], p[1], p[2]});
    result = result ? joined(*result, fan) : fan;
  });
  return result;
}

}  // namespace cnrg
