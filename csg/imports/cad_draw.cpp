// From grids of points to facets: corners first, then edges, then faces.
//
// A corner lies on several faces, and each band says where it is; an edge likewise. They agree where the numbers
// of the file do, and where they do not there would be a gap: then nothing is drawn. Planes take the points of
// their edges, so they cannot disagree with anyone; if these points are not exactly on one plane, triangles do it.
#include "csg/imports/cad_draw.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Side = BandBorder::Side;
using Point3 = std::array<double, 3>;

/// The angle of a point of a circle, or the parameter of one of a line.
double parameter_on(const CadCurve& curve, const Point3& p) {
  const Point3 off = minus(p, curve.axes.origin);
  const double x = dot(off, curve.axes.x), y = dot(off, curve.axes.y);
  return curve.kind == CadCurve::Kind::circle ? std::atan2(y, x) : x;
}

class Drawer {
 public:
  Drawer(const CadModel& model, const std::vector<RationalPoint>& welded, const CadBands& bands,
         const std::vector<BandGrid>& grids, bool seams, double slack)
      : old_(model),
        welded_(welded),
        bands_(bands),
        grids_(grids),
        seams_(seams),
        slack_(slack),
        place_(model.points.size(), kNone) {
    for (const Point3& p : old_.points) size_ = std::max({size_, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
    made_.model = model;
  }

  DrawnCad run() {
    try {
      for (std::size_t b = 0; b < grids_.size(); ++b) number_grid(b);
      for (std::size_t b = 0; b < grids_.size(); ++b) place_corners(b);
      draw_edges();
      for (CadModel::Vertex& vertex : made_.model.vertices) vertex.point = corner(vertex.point);
      draw_faces();
      made_.model.points.clear();
      for (const RationalPoint& p : made_.points) made_.model.points.push_back(to_doubles(p));
    } catch (const NotDrawn& unfit) {
      made_.obstacle = unfit.words;
      made_.finer = unfit.finer;
    }
    return std::move(made_);
  }

 private:
  Index number(const RationalPoint& p) {
    const auto [it, fresh] = number_.try_emplace(p, static_cast<Index>(made_.points.size()));
    if (fresh) made_.points.push_back(p);
    return it->second;
  }

  void number_grid(std::size_t b) {
    auto& rows = rows_.emplace_back();
    for (const auto& row : grids_[b].rows) {
      rows.emplace_back();
      for (const RationalPoint& p : row) rows.back().push_back(number(p));
    }
  }

  // --- corners

  void place(Index p, Index at) {
    const Point3 x = to_doubles(made_.points[at]);
    const Point3& from = old_.points[p];
    const double moved = std::abs(x[0] - from[0]) + std::abs(x[1] - from[1]) + std::abs(x[2] - from[2]);
    if (moved > kRounding * size_ + 2 * slack_)
      throw NotDrawn{"its corner at " + describe(exact(p)) + " is not on its surface, by more than doubles round"};
    if (place_[p] != kNone && place_[p] != at)
      throw NotDrawn{"two surfaces differ by what doubles round about where its corner at " + describe(exact(p)) +
                     " is"};
    place_[p] = at;
  }
  void place_corners(std::size_t b) {
    const BandBorder& border = bands_.borders[b];
    for (const BandBorder::Corner& of : border.corners) {
      const auto& row = of.last ? rows_[b].back() : rows_[b].front();
      place(of.point, row[grids_[b].marks[of.mark]]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (border.poles[i] < 0) continue;
      place(static_cast<Index>(border.poles[i]), i == 0 ? rows_[b].front()[0] : rows_[b].back()[0]);
    }
  }
  RationalPoint exact(Index p) const { return welded_.empty() ? from_doubles(old_.points[p]) : welded_[p]; }
  Index corner(Index p) {
    if (place_[p] == kNone) place_[p] = number(exact(p));
    return place_[p];
  }

  // --- edges

  void draw_edges() {
    std::vector<bool> drawn(old_.edges.size(), false);
    for (std::size_t b = 0; b < grids_.size(); ++b) {
      for (const auto& [e, side] : bands_.borders[b].edges) {
        const std::vector<Index> points = side_points(b, e, side);
        std::vector<Index>& known = made_.model.edges[e].points;
        if (drawn[e] && known != points)
          throw NotDrawn{"two surfaces differ by what doubles round about where edge " + std::to_string(e) +
                         " is"};
        known = points;
        if (!drawn[e]) set_parameters(e);
        drawn[e] = true;
      }
    }
    for (Index e = 0; e < old_.edges.size(); ++e) {
      if (drawn[e] || old_.edges[e].points.empty()) continue;
      CadModel::Edge& edge = made_.model.edges[e];
      if (edge.points.size() > 1 && edge.seam && !seams_) {
        edge.points.clear();
        edge.parameters.clear();
        continue;
      }
      const bool is_point = edge.points.size() == 1;
      edge.points = {corner(edge.points.front()), corner(edge.points.back())};
      edge.parameters = {edge.parameters.front(), edge.parameters.back()};
      if (!is_point) continue;
      edge.points.pop_back();
      edge.parameters.pop_back();
    }
  }

  /// The points of an edge at a side of a band, along its curve.
  std::vector<Index> side_points(std::size_t b, Index e, Side side) {
    const auto& rows = rows_[b];
    std::vector<Index> all;
    bool closed = false;
    if (side == Side::first_row || side == Side::last_row) {
      all = side == Side::first_row ? rows.front() : rows.back();
      closed = bands_.bands[b].whole;
    } else {
      for (const auto& row : rows) all.push_back(side == Side::start ? row.front() : row.back());
      closed = all.front() == all.back();
    }
    if (closed) all.pop_back();
    const CadModel::Edge& edge = old_.edges[e];
    const Index from = corner(edge.points.front()), to = corner(edge.points.back());
    const auto first = std::find(all.begin(), all.end(), from);
    if (first == all.end() || std::find(all.begin(), all.end(), to) == all.end())
      throw NotDrawn{"edge " + std::to_string(e) + " does not end on a side of face " +
                     std::to_string(bands_.bands[b].face)};
    if (closed) std::rotate(all.begin(), first, all.end());
    return along(all, from, to, closed, with_curve(bands_.bands[b], edge.curve, side));
  }

  /// True if the points of a closed side run as the parameter of its circle grows.
  static bool with_curve(const Band& band, const CadCurve& curve, Side side) {
    Point3 way = to_doubles(band.form.axis);  // of a parallel
    if (side == Side::start || side == Side::end)
      way = to_doubles(cross(side == Side::start ? band.start : band.end, band.form.axis));
    return dot(way, cross(curve.axes.x, curve.axes.y)) > 0;
  }

  static std::vector<Index> along(std::vector<Index> all, Index from, Index to, bool closed, bool with) {
    if (closed) {
      if (!with) std::reverse(all.begin() + 1, all.end());
      all.push_back(all.front());
      const auto last = std::find(all.begin() + 1, all.end(), to);
      return {all.begin(), last + 1};
    }
    const auto a = std::find(all.begin(), all.end(), from), b = std::find(all.begin(), all.end(), to);
    if (a <= b) return {a, b + 1};
    std::vector<Index> back(b, a + 1);
    std::reverse(back.begin(), back.end());
    return back;
  }

  void set_parameters(Index e) {
    const CadModel::Edge& old = old_.edges[e];
    CadModel::Edge& edge = made_.model.edges[e];
    edge.parameters.clear();
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      double t = parameter_on(edge.curve, to_doubles(made_.points[edge.points[i]]));
      if (edge.curve.kind == CadCurve::Kind::circle && i > 0) {
        const double before = edge.parameters.back();
        t = before + std::remainder(t - before, kTurn);
      }
      if (i == 0) t = old.parameters.front();
      if (i + 1 == edge.points.size()) t = old.parameters.back();
      edge.parameters.push_back(t);
    }
  }

  // --- faces

  void draw_faces() {
    std::vector<std::int64_t> band_of(old_.faces.size(), -1);
    for (std::size_t b = 0; b < grids_.size(); ++b) band_of[bands_.bands[b].face] = static_cast<std::int64_t>(b);
    for (Index f = 0; f < old_.faces.size(); ++f) {
      if (old_.faces[f].triangles.empty()) continue;
      CadModel::Face& face = made_.model.faces[f];
      face.triangles.clear();
      face.places.clear();
      if (band_of[f] >= 0) draw_band(static_cast<std::size_t>(band_of[f]), face);
      else draw_plane(f, face);
    }
  }

  /// The value as far as whole turns go: from `start` on, in the direction of `up`.
  static double from_start(double value, double start, bool up) {
    const double off = up ? value - start : start - value;
    double way = off - kTurn * std::floor(off / kTurn);
    if (way > kTurn * (1 - 1e-6)) way -= kTurn;
    return up ? start + way : start - way;
  }
  static void unwind(std::vector<double>& values, double start, bool up) {
    values[0] = from_start(values[0], start, up);
    for (std::size_t i = 1; i < values.size(); ++i) {
      values[i] = values[i - 1] + std::remainder(values[i] - values[i - 1], kTurn);
    }
  }

  void draw_band(std::size_t b, CadModel::Face& face) {
    const auto& rows = rows_[b];
    const BandBorder& border = bands_.borders[b];
    const std::size_t round = rows.front().front() == rows.front().back() && rows.front()[0] == rows.front()[1]
                                  ? 1
                                  : 0;  // a row that is no pole
    std::vector<double> u, v;
    for (const Index p : rows[round]) u.push_back(parameters_at(face.surface, to_doubles(made_.points[p]))[0]);
    for (const auto& row : rows) v.push_back(parameters_at(face.surface, to_doubles(made_.points[row[0]]))[1]);
    unwind(u, border.turns_up ? border.low[0] : border.high[0], border.turns_up);
    if (face.surface.kind == CadSurface::Kind::torus)
      unwind(v, border.ahead ? border.low[1] : border.high[1], border.ahead);
    using Corner = std::array<std::size_t, 2>;  // row, column
    const auto add = [&](Corner x, Corner y, Corner z) {
      if (!border.outward) std::swap(y, z);
      CadModel::Place place;
      std::array<Index, 3> points{};
      const std::array<Corner, 3> corners{x, y, z};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& [row, column] = corners[k];
        points[k] = rows[row][column];
        place.at[k] = {u[column], v[row]};
        if (rows[row][0] != rows[row][1]) continue;
        place.pole = static_cast<std::uint8_t>(k);
        place.free = 0;
      }
      face.triangles.push_back(points);
      face.places.push_back(place);
    };
    for (std::size_t j = 0; j + 1 < rows.size(); ++j) {
      for (std::size_t i = 0; i + 1 < rows[j].size(); ++i) {
        const Corner p{j, i}, q{j, i + 1}, r{j + 1, i + 1}, s{j + 1, i};
        const bool low = rows[j][0] == rows[j][1], high = rows[j + 1][0] == rows[j + 1][1];
        if (low && high) continue;
        if (low) add(p, r, s);
        else if (high) add(p, q, r);
        else if (grids_[b].mirrored) add(p, q, s), add(q, r, s);
        else add(p, q, r), add(p, r, s);
      }
    }
  }

  void draw_plane(Index f, CadModel::Face& face) {
    std::multimap<Index, Index> next;
    for (const auto& [e, forward] : face.border) {
      const std::vector<Index>& points = made_.model.edges[e].points;
      for (std::size_t i = 1; i < points.size(); ++i)
        next.emplace(points[forward ? i - 1 : i], points[forward ? i : i - 1]);
    }
    PointTable table;
    std::map<Index, VertexId> ids;
    std::vector<Index> points;
    std::vector<std::vector<VertexId>> loops;
    while (!next.empty()) {
      auto& loop = loops.emplace_back();
      const Index start = next.begin()->first;
      Index at = start;
      do {
        const auto side = next.find(at);
        if (side == next.end()) throw NotDrawn{"the border of face " + std::to_string(f) + " is not closed"};
        const auto [it, fresh] = ids.try_emplace(at);
        if (fresh) {
          it->second = table.add(made_.points[at]);
          points.push_back(at);
        }
        loop.push_back(it->second);
        at = side->second;
        next.erase(side);
      } while (at != start);
    }
    if (!welded_.empty()) check_welded(f, points);
    try {
      for (const auto& t : triangulate(table, seen_from_front(f), loops)) {
        auto& corners = face.triangles.emplace_back();
        CadModel::Place& place = face.places.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          corners[k] = points[t[k].index()];
          place.at[k] = parameters_at(face.surface, to_doubles(made_.points[corners[k]]));
        }
      }
    } catch (const InvariantError&) {
      throw NotDrawn{"the border of face " + std::to_string(f) + " crosses itself at this fineness", true};
    }
  }

  /// What a weld has put on one plane, exactly, stays there: a plane that it has tilted may hold no meridian.
  void check_welded(Index f, const std::vector<Index>& points) const {
    for (const auto& t : old_.faces[f].triangles) {
      const RationalPoint a = exact(t[0]), normal = cross(exact(t[1]) - a, exact(t[2]) - a);
      if (is_zero(normal)) continue;
      const auto on_plane = [&](const RationalPoint& p) { return dot(normal, p - a) == 0; };
      for (const auto& other : old_.faces[f].triangles) {
        for (const Index p : other) {
          if (!on_plane(exact(p))) return;
        }
      }
      if (std::all_of(points.begin(), points.end(), [&](Index p) { return on_plane(made_.points[p]); })) return;
      throw NotDrawn{"face " + std::to_string(f) + " would leave the plane that it was welded to"};
    }
  }

  Projection seen_from_front(Index f) const {
    Point3 normal{0, 0, 0};
    for (const auto& t : old_.faces[f].triangles) {
      const Point3& a = old_.points[t[0]];
      const Point3 part = cross(minus(old_.points[t[1]], a), minus(old_.points[t[2]], a));
      for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
    }
    return seen_along(normal);
  }

  const CadModel& old_;
  const std::vector<RationalPoint>& welded_;
  const CadBands& bands_;
  const std::vector<BandGrid>& grids_;
  bool seams_;
  double slack_;
  double size_ = 0;
  DrawnCad made_;
  std::map<RationalPoint, Index> number_;
  std::vector<Index> place_;                           // of old points: the new one
  std::vector<std::vector<std::vector<Index>>> rows_;  // of each grid
};

}  // namespace

DrawnCad draw_by_bands(const CadModel& model, const std::vector<RationalPoint>& welded, const CadBands& bands,
                       const std::vector<BandGrid>& grids, bool seams, double slack) {
  return Drawer(model, welded, bands, grids, seams, slack).run();
}

}  // namespace cnrg
