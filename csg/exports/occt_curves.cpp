// Newton's method for points, interpolation for curves; see the header.
#include "csg/exports/occt_curves.h"

#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/base/error.h"

namespace cnrg::occt {
namespace {

using namespace surface_math;
using Index = CadParts::Index;

constexpr double kExact = 1e-11;  // of the size: what a line or circle is off by the rounding of doubles
constexpr std::size_t kFewest = 16, kMost = 2048;

double length(const CadPoint& v) { return std::hypot(v[0], v[1], v[2]); }
double distance(const CadPoint& a, const CadPoint& b) { return length(difference(a, b)); }
CadPoint unit(const CadPoint& v) { return scaled(1 / length(v), v); }

/// A polyline by the fraction of its length.
class Path {
 public:
  explicit Path(std::vector<CadPoint> points) : points_(std::move(points)), lengths_{0} {
    for (std::size_t i = 1; i < points_.size(); ++i)
      lengths_.push_back(lengths_.back() + distance(points_[i - 1], points_[i]));
  }
  CadPoint at(double fraction) const {
    const double way = fraction * lengths_.back();
    std::size_t i = 0;
    while (i + 2 < points_.size() && lengths_[i + 1] < way) ++i;
    const double step = lengths_[i + 1] - lengths_[i];
    const double t = step > 0 ? std::clamp((way - lengths_[i]) / step, 0.0, 1.0) : 0;
    return sum(points_[i], scaled(t, difference(points_[i + 1], points_[i])));
  }

 private:
  std::vector<CadPoint> points_;
  std::vector<double> lengths_;
};

Handle(Geom_BSplineCurve) spline_through(const std::vector<CadPoint>& points) {
  const int n = static_cast<int>(points.size());
  const Handle(TColgp_HArray1OfPnt) at = new TColgp_HArray1OfPnt(1, n);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, n);
  double way = 0;
  for (int i = 1; i <= n; ++i) {
    const auto k = static_cast<std::size_t>(i - 1);
    if (i > 1) way += distance(points[k - 1], points[k]);
    at->SetValue(i, pnt(points[k]));
    parameters->SetValue(i, way);
  }
  GeomAPI_Interpolate interpolate(at, parameters, false, 1e-12 * way);
  interpolate.Perform();
  if (!interpolate.IsDone()) throw InputError("no spline goes through the points of one of its edges");
  return interpolate.Curve();
}

}  // namespace

CadCurves::CadCurves(const CadParts& parts, const CadLayout& layout, double tolerance, Faceted& failed)
    : parts_(parts), layout_(layout), tolerance_(tolerance), points_(parts.points) {
  faces_of_piece_.resize(layout.pieces().size());
  for (const LaidFace& face : layout.faces()) {
    if (face.chart->flat()) continue;
    for (const auto& loop : face.loops) {
      for (const PieceUse& use : loop) faces_of_piece_[use.piece].insert(face.source);
    }
    for (const PieceUse& use : face.inner) faces_of_piece_[use.piece].insert(face.source);
  }
  place_points(failed);
  if (!failed.empty()) return;
  for (Index i = 0; i < layout.pieces().size(); ++i) {
    std::string why;
    try {
      curves_.push_back(make(i));
      continue;
    } catch (const InputError& error) {
      why = error.what();
    } catch (const Standard_Failure& failure) {
      why = std::string("OpenCASCADE fails with ") + failure.DynamicType()->Name();
    }
    curves_.emplace_back();
    if (faces_of_piece_[i].empty()) throw InputError("an edge has no curve: " + why);
    for (const Index source : faces_of_piece_[i]) failed.emplace(source, why);
  }
}

void CadCurves::place_points(Faceted& failed) {
  std::vector<double> reach(points_.size(), 0);  // no vertex goes farther than its longest edge is long
  std::vector<std::vector<Index>> pieces(points_.size());
  for (Index i = 0; i < layout_.pieces().size(); ++i) {
    const std::vector<Index>& chain = layout_.pieces()[i].points;
    double way = 0;
    for (std::size_t k = 1; k < chain.size(); ++k)
      way += distance(parts_.points[chain[k - 1]], parts_.points[chain[k]]);
    for (const Index end : {chain.front(), chain.back()}) {
      reach[end] = std::max(reach[end], way);
      pieces[end].push_back(i);
    }
  }
  // Ends of seams come last: where a seam begins in a vertex of the result, it follows that.
  std::vector<Index> order;
  std::vector<char> of_result(points_.size(), 0);
  for (const FlatComplex::Vertex& vertex : parts_.flat.vertices) of_result[vertex.point] = 1;
  for (const char first : {1, 0}) {
    for (Index p = 0; p < points_.size(); ++p) {
      if (layout_.is_vertex(p) && of_result[p] == first) order.push_back(p);
    }
  }
  for (const Index p : order) {
    const std::vector<const Chart*>& charts = layout_.charts_at(p);
    if (charts.empty()) {
      for (const Index i : pieces[p]) {
        const Piece& piece = layout_.pieces()[i];
        if (piece.at.empty()) continue;
        const Handle(Geom_Curve) curve = occt::curve_of(parts_.curves[*parts_.edges[*piece.edge].curve]);
        points_[p] = numbers(curve->Value(piece.points.front() == p ? piece.at.front() : piece.at.back()).XYZ());
        break;
      }
    } else if (std::any_of(charts.begin(), charts.end(), [](const Chart* c) { return !c->flat(); })) {
      std::vector<Chart::Strip> strips;
      if (!of_result[p]) {
        for (const Index i : pieces[p]) add_strip(i, p, of_result, strips);
      }
      std::optional<CadPoint> found = on_charts(p, strips);
      if (!found && !strips.empty()) found = on_charts(p, {});
      if (found && (reach[p] == 0 || distance(*found, points_[p]) <= reach[p])) {
        points_[p] = *found;
      } else {
        bool any = false;
        for (const Index i : pieces[p]) {
          for (const Index source : faces_of_piece_[i]) {
            failed.emplace(source, "no point near to one of its vertices is on all surfaces that meet there");
            any = true;
          }
        }
        if (!any) throw InputError("a vertex is not on the surfaces that meet there");
      }
    }
    if (points_[p] == parts_.points[p]) continue;
    ++moved_;
    farthest_ = std::max(farthest_, distance(points_[p], parts_.points[p]));
  }
}

std::optional<CadPoint> CadCurves::on_charts(Index p, const std::vector<Chart::Strip>& strips) const {
  std::vector<SurfaceSite> sites;
  for (const bool flat : {false, true}) {
    for (const Chart* chart : layout_.charts_at(p)) {
      if (chart->flat() != flat) continue;
      CadParameters at{};
      if (!flat) at = chart->place(points_[p], layout_.near(chart, p)).value_or(CadParameters{});
      sites.push_back(chart->site(at));
    }
  }
  for (const Chart::Strip& strip : strips) sites.push_back(strip.site());
  return find_common(sites, points_[p]);
}

void CadCurves::add_strip(Index number, Index p, const std::vector<char>& of_result,
                          std::vector<Chart::Strip>& strips) const {
  const Piece& piece = layout_.pieces()[number];
  if (!piece.seam) return;
  const Chart& chart = *piece.charts[0];
  const std::optional<PieceUse> use = some_use(number);
  require(use.has_value(), "exports: a seam that no face has");
  const bool at_front = use->corners.front().point == p;
  const UnrollCorner &here = at_front ? use->corners.front() : use->corners.back(),
                     &there = at_front ? use->corners.back() : use->corners.front();
  if (here.free[0] || here.free[1]) return;
  for (std::size_t d = 0; d < 2; ++d) {
    if (std::abs(here.at[d] - there.at[d]) > chart.slack()[d]) continue;
    CadParameters at = here.at;
    if (of_result[there.point] && !there.free[0] && !there.free[1]) {
      if (const auto moved = chart.place(points_[there.point], there.at)) at[d] = (*moved)[d];
    }
    strips.emplace_back(chart, d, at);
    return;
  }
}

EdgeCurve CadCurves::line(const CadPoint& a, const CadPoint& b) const {
  const double way = distance(a, b);
  if (!(way > 0)) throw InputError("one of its edges has no length");
  const CadPoint d = unit(difference(b, a));
  return {new Geom_Line(pnt(a), gp_Dir(d[0], d[1], d[2])), 0, way, 0, false};
}

EdgeCurve CadCurves::on_given_curve(const Piece& piece) const {
  const Handle(Geom_BSplineCurve) curve =
      Handle(Geom_BSplineCurve)::DownCast(occt::curve_of(parts_.curves[*parts_.edges[*piece.edge].curve]));
  std::vector<double> at = piece.at;
  if (curve->IsClosed()) {
    if (!curve->IsPeriodic()) curve->SetPeriodic();
    const double period = curve->Period();
    // The parameter goes on by less than half a period; where the curve closes it may be either end.
    const std::size_t middle = at.size() / 2;
    for (std::size_t i = middle + 1; i < at.size(); ++i)
      at[i] -= period * std::round((at[i] - at[i - 1]) / period);
    for (std::size_t i = middle; i-- > 0;) at[i] -= period * std::round((at[i] - at[i + 1]) / period);
  }
  if (at.front() > at.back()) {
    const double first = curve->ReversedParameter(at.front()), last = curve->ReversedParameter(at.back());
    curve->Reverse();
    return {Handle(Geom_Curve)(curve), first, last, 0, true};
  }
  return {Handle(Geom_Curve)(curve), at.front(), at.back(), 0, true};
}

std::optional<PieceUse> CadCurves::some_use(Index piece) const {
  for (const LaidFace& face : layout_.faces()) {
    for (const auto& loop : face.loops) {
      for (const PieceUse& use : loop) {
        if (use.piece == piece) return use;
      }
    }
  }
  return std::nullopt;
}

std::vector<CadPoint> CadCurves::sample_seam(Index number, std::size_t n) const {
  const Piece& piece = layout_.pieces()[number];
  const Chart& chart = *piece.charts[0];
  std::optional<PieceUse> use = some_use(number);
  require(use.has_value(), "exports: a seam that no face has");
  if (!use->forward) std::reverse(use->corners.begin(), use->corners.end());
  const CadPoint ends[2] = {points_[piece.points.front()], points_[piece.points.back()]};
  CadParameters at[2];
  for (const std::size_t k : {0, 1}) {
    const UnrollCorner& corner = k == 0 ? use->corners.front() : use->corners.back();
    at[k] = corner.at;
    const auto found = chart.place(ends[k], corner.at);
    if (!found) throw InputError("no place on its surface was found for an end of its seam");
    for (std::size_t d = 0; d < 2; ++d) {
      if (!corner.free[d]) at[k][d] = (*found)[d];
    }
  }
  std::vector<CadPoint> result{ends[0]};
  for (std::size_t i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    result.push_back(chart.point({at[0][0] + t * (at[1][0] - at[0][0]), at[0][1] + t * (at[1][1] - at[0][1])}));
  }
  result.push_back(ends[1]);
  return result;
}

std::optional<CadPoint> CadCurves::common(const Piece& piece, const CadPoint& guess, Index corner,
                                          std::map<const Chart*, CadParameters>& near) const {
  std::vector<SurfaceSite> sites;
  std::vector<const Chart*> of;
  for (const bool flat : {false, true}) {
    for (const Chart* chart : piece.charts) {
      if (chart->flat() != flat) continue;
      of.push_back(chart);
      if (flat) {
        sites.push_back(chart->site({}));
        continue;
      }
      std::optional<CadParameters> hint = layout_.near(chart, corner);
      if (const auto last = near.find(chart); last != near.end()) hint = last->second;
      const auto at = chart->place(guess, hint);
      if (!at) return std::nullopt;
      sites.push_back(chart->site(*at));
    }
  }
  const std::optional<CadPoint> found = find_common(sites, guess);
  for (std::size_t k = 0; k < of.size() && found; ++k) {
    if (!of[k]->flat()) near[of[k]] = sites[k].at;
  }
  return found;
}

std::vector<CadPoint> CadCurves::guide(const Piece& piece) const {
  std::vector<CadPoint> line{points_[piece.points.front()]};
  std::map<const Chart*, CadParameters> near;
  for (std::size_t i = 1; i + 1 < piece.points.size(); ++i) {
    const auto found = common(piece, parts_.points[piece.points[i]], piece.points[i], near);
    if (found) line.push_back(*found);
  }
  line.push_back(points_[piece.points.back()]);
  // An end that moved along the curve may have passed points of the chain.
  const auto drop = [&](bool front) {
    const auto at = [&](std::size_t i) { return line[front ? i : line.size() - 1 - i]; };
    while (line.size() > 3 && dot(difference(at(1), at(0)), difference(at(2), at(1))) <= 0)
      line.erase(front ? line.begin() + 1 : line.end() - 2);
  };
  drop(true);
  drop(false);
  return line;
}

std::vector<CadPoint> CadCurves::sample(Index number, const std::vector<CadPoint>& guide, std::size_t n) const {
  const Piece& piece = layout_.pieces()[number];
  if (piece.seam) return sample_seam(number, n);
  const Path path(guide);
  std::vector<CadPoint> result{guide.front()};
  std::map<const Chart*, CadParameters> near;
  for (std::size_t i = 1; i < n; ++i) {
    const auto found =
        common(piece, path.at(static_cast<double>(i) / static_cast<double>(n)), piece.points.front(), near);
    if (!found) throw InputError("no points near to one of its edges are on all surfaces that meet there");
    result.push_back(*found);
  }
  result.push_back(guide.back());
  return result;
}

double CadCurves::off(const Piece& piece, const CadPoint& p, std::map<const Chart*, CadParameters>& near) const {
  double worst = 0;
  for (const Chart* chart : piece.charts) {
    std::optional<CadParameters> hint;
    if (const auto last = near.find(chart); last != near.end()) hint = last->second;
    if (!hint && !chart->flat()) hint = layout_.near(chart, piece.points.front());
    const auto at = chart->place(p, hint);
    if (!at) throw InputError("no place on its surface was found for a point of one of its edges");
    near[chart] = *at;
    worst = std::max(worst, distance(chart->point(*at), p));
  }
  return worst;
}

std::optional<EdgeCurve> CadCurves::circle(const Piece& piece, const std::vector<CadPoint>& samples) const {
  std::vector<std::pair<CadPoint, CadPoint>> axes;  // a point and a direction
  std::vector<CadPoint> spheres;
  for (const Chart* chart : piece.charts) {
    if (chart->has_axis()) axes.emplace_back(chart->axis_point(), chart->axis());
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(chart->surface()); !sphere.IsNull())
      spheres.push_back(numbers(sphere->Location().XYZ()));
  }
  for (const CadPoint& center : spheres) {
    for (const Chart* chart : piece.charts) {
      if (chart->flat()) axes.emplace_back(center, chart->site({}).normal);
    }
    if (distance(center, spheres[0]) > 0) axes.emplace_back(center, unit(difference(center, spheres[0])));
  }
  const std::size_t n = samples.size() - 1;
  const CadPoint &p = samples[0], &q = samples[n / 3], &r = samples[2 * n / 3];
  // The axis of the circle through three of the points.
  const CadPoint pq = difference(q, p), pr = difference(r, p), normal = cross(pq, pr);
  if (const double square = dot(normal, normal); square > 1e-24 * dot(pq, pq) * dot(pr, pr)) {
    const CadPoint way = sum(scaled(dot(pq, pq), cross(pr, normal)), scaled(dot(pr, pr), cross(normal, pq)));
    axes.emplace_back(sum(p, scaled(1 / (2 * square), way)), unit(normal));
  }
  for (auto& [on, axis] : axes) {
    const CadPoint center = sum(on, scaled(dot(difference(p, on), axis), axis));
    const CadPoint out = difference(p, center);
    const double radius = length(out);
    if (radius <= 1e-9 * parts_.size) continue;
    const CadPoint x = unit(out);
    CadPoint y = cross(axis, x);
    if (dot(y, difference(samples[1], center)) < 0) axis = scaled(-1.0, axis), y = scaled(-1.0, y);
    bool fits = true;
    double angle = 0;
    for (std::size_t i = 1; i <= n && fits; ++i) {
      const CadPoint d = difference(samples[i], center);
      fits =
          std::abs(dot(d, axis)) <= kExact * parts_.size && std::abs(length(d) - radius) <= kExact * parts_.size;
      double next = std::atan2(dot(d, y), dot(d, x));
      while (next < angle - 1e-9) next += 2 * std::numbers::pi;
      fits = fits && next - angle < std::numbers::pi;
      angle = next;
    }
    if (!fits || angle > 2 * std::numbers::pi + 1e-9) continue;
    const gp_Ax2 axes2(pnt(center), gp_Dir(axis[0], axis[1], axis[2]), gp_Dir(x[0], x[1], x[2]));
    return EdgeCurve{new Geom_Circle(axes2, radius), 0, piece.closed() ? 2 * std::numbers::pi : angle, 0, false};
  }
  return std::nullopt;
}

EdgeCurve CadCurves::make(Index number) const {
  const Piece& piece = layout_.pieces()[number];
  const CadPoint &a = points_[piece.points.front()], &b = points_[piece.points.back()];
  const bool curved =
      std::any_of(piece.charts.begin(), piece.charts.end(), [](const Chart* c) { return !c->flat(); });
  if (!curved) return piece.at.empty() ? line(a, b) : on_given_curve(piece);
  const std::vector<CadPoint> path = guide(piece);
  const auto measured = [&](EdgeCurve made, std::size_t n) {
    std::map<const Chart*, CadParameters> near;
    for (std::size_t i = 1; i < 4 * n; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(4 * n);
      made.off = std::max(
          made.off, off(piece, numbers(made.curve->Value(made.first + t * (made.last - made.first)).XYZ()), near));
    }
    return made;
  };
  std::vector<CadPoint> samples = sample(number, path, kFewest);
  if (!piece.closed() && distance(a, b) > 0) {
    const CadPoint d = unit(difference(b, a));
    const bool on_line = std::all_of(samples.begin(), samples.end(), [&](const CadPoint& p) {
      return length(cross(difference(p, a), d)) <= kExact * parts_.size;
    });
    if (on_line) return measured(line(a, b), 4);
  }
  if (const auto found = circle(piece, samples)) return measured(*found, 8);
  for (std::size_t n = kFewest;; n *= 2) {
    if (n > kFewest) samples = sample(number, path, n);
    const Handle(Geom_BSplineCurve) spline = spline_through(samples);
    EdgeCurve made =
        measured({Handle(Geom_Curve)(spline), spline->FirstParameter(), spline->LastParameter(), 0, true}, n);
    if (made.off <= tolerance_ / 2) return made;
    if (n < kMost) continue;
    if (made.off <= 100 * tolerance_) return made;
    throw InputError("one of its edges has no spline within the tolerance");
  }
}

PlaneCurve CadCurves::in_plane(const LaidFace& face, const PieceUse& use) const {
  const Chart& chart = *face.chart;
  const EdgeCurve& edge = curves_[use.piece];
  // A corner from which to go on along the curve, inside of the chain where that has one.
  const UnrollCorner* anchor = nullptr;
  const std::size_t m = use.corners.size() / 2;
  for (std::size_t i = 0; i < use.corners.size() && anchor == nullptr; ++i) {
    const UnrollCorner& corner = use.corners[(m + i) % use.corners.size()];
    if (!corner.free[0] && !corner.free[1]) anchor = &corner;
  }
  PlaneCurve best;
  for (std::size_t n = kFewest; n <= kMost; n *= 2) {
    std::vector<double> t(n + 1);
    std::vector<CadPoint> points(n + 1);
    std::vector<CadParameters> at(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
      t[i] = edge.first + (edge.last - edge.first) * static_cast<double>(i) / static_cast<double>(n);
      points[i] = numbers(edge.curve->Value(t[i]).XYZ());
    }
    std::size_t start = n / 2;
    CadParameters near = use.corners[m].at;
    if (anchor == nullptr) {  // from pole to pole: what the corners say holds all along
      for (std::size_t d = 0; d < 2; ++d) {
        if (use.corners.front().free[d]) near[d] = use.corners.back().at[d];
      }
    } else {
      near = anchor->at;
      const CadPoint place = points_[anchor->point];
      for (std::size_t i = 0; i <= n; ++i) {
        if (distance(points[i], place) < distance(points[start], place)) start = i;
      }
    }
    const auto find = [&](std::size_t i, const CadParameters& from) {
      const auto found = chart.place(points[i], from);
      if (!found) throw InputError("no place on its surface was found for a point of one of its edges");
      at[i] = *found;
    };
    find(start, near);
    for (std::size_t i = start + 1; i <= n; ++i) find(i, at[i - 1]);
    for (std::size_t i = start; i-- > 0;) find(i, at[i + 1]);
    for (std::size_t d = 0; d < 2; ++d) {
      if (chart.is_free(d, at[0])) at[0][d] = 3 * at[1][d] - 3 * at[2][d] + at[3][d];
      if (chart.is_free(d, at[n])) at[n][d] = 3 * at[n - 1][d] - 3 * at[n - 2][d] + at[n - 3][d];
    }
    PlaneCurve made;
    made.first = at[0], made.last = at[n];
    const auto slack = chart.slack();
    bool straight = true;
    for (std::size_t i = 1; i < n; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(n);
      for (std::size_t d = 0; d < 2; ++d)
        straight = straight && std::abs(at[0][d] + s * (at[n][d] - at[0][d]) - at[i][d]) <= 1e-4 * slack[d];
    }
    const double way = std::hypot(at[n][0] - at[0][0], at[n][1] - at[0][1]), range = edge.last - edge.first;
    if (straight && std::abs(way / range - 1) < 1e-12) {
      const gp_Dir2d direction(at[n][0] - at[0][0], at[n][1] - at[0][1]);
      made.curve = new Geom2d_Line(
          gp_Pnt2d(at[0][0] - edge.first * direction.X(), at[0][1] - edge.first * direction.Y()), direction);
    } else if (straight) {
      TColgp_Array1OfPnt2d poles(1, 2);
      poles.SetValue(1, gp_Pnt2d(at[0][0], at[0][1]));
      poles.SetValue(2, gp_Pnt2d(at[n][0], at[n][1]));
      TColStd_Array1OfReal knots(1, 2);
      knots.SetValue(1, edge.first);
      knots.SetValue(2, edge.last);
      TColStd_Array1OfInteger counts(1, 2);
      counts.Init(2);
      made.curve = new Geom2d_BSplineCurve(poles, knots, counts, 1);
    } else {
      const Handle(TColgp_HArray1OfPnt2d) through = new TColgp_HArray1OfPnt2d(1, static_cast<int>(n) + 1);
      const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, static_cast<int>(n) + 1);
      for (std::size_t i = 0; i <= n; ++i) {
        through->SetValue(static_cast<int>(i) + 1, gp_Pnt2d(at[i][0], at[i][1]));
        parameters->SetValue(static_cast<int>(i) + 1, t[i]);
      }
      Geom2dAPI_Interpolate interpolate(through, parameters, false, 1e-15);
      interpolate.Perform();
      if (!interpolate.IsDone())
        throw InputError("one of its edges has no curve in the parameters of its surface");
      made.curve = interpolate.Curve();
    }
    for (std::size_t i = 0; i <= 4 * n; ++i) {
      const double s = edge.first + range * static_cast<double>(i) / static_cast<double>(4 * n);
      const gp_Pnt2d uv = made.curve->Value(s);
      made.off = std::max(made.off, distance(chart.point({uv.X(), uv.Y()}), numbers(edge.curve->Value(s).XYZ())));
    }
    if (best.curve.IsNull() || made.off < best.off) best = made;
    if (made.off <= tolerance_ || (straight && n > kFewest)) break;
  }
  if (best.off > 200 * tolerance_) throw InputError("one of its edges is not on its surface within the tolerance");
  return best;
}

}  // namespace cnrg::occt
