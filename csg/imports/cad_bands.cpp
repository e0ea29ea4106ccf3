// Which edges are parallels and meridians, then where they are exactly.
#include "csg/imports/cad_bands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "csg/carriers/axes.h"
#include "csg/geometry/circle.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
using Kind = CadSurface::Kind;
using Side = BandBorder::Side;
using Point3 = std::array<double, 3>;

bool has_arcs(Kind kind) { return kind == Kind::sphere || kind == Kind::torus; }

const char* name_of(Kind kind) {
  static constexpr const char* kNames[] = {"a surface", "a cylinder", "a cone", "a sphere", "a torus"};
  return kNames[is_round(kind) ? static_cast<std::size_t>(kind) : 0];
}
const char* name_of(CadCurve::Kind kind) {
  static constexpr const char* kNames[] = {
      "a curve of another kind", "a line", "a circle", "an ellipse", "a spline", "a curve of another kind"};
  return kNames[static_cast<std::size_t>(kind)];
}

[[noreturn]] void refuse(const std::string& words) { throw NotDrawn{words}; }

std::string face_name(Index f) { return "face " + std::to_string(f); }
std::string edge_name(Index e) { return "edge " + std::to_string(e); }

class Finder {
 public:
  Finder(const CadModel& model, const CadRound& round, const std::vector<RationalPoint>& welded,
         const Fineness& fineness, bool seams)
      : model_(model), round_(round), welded_(welded), fineness_(fineness), seams_(seams) {
    result_.slack = round.slack;
    for (const Point3& p : model.points) size_ = std::max({size_, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  }

  CadBands run() {
    for (Index f = 0; f < model_.faces.size(); ++f) {
      if (!model_.faces[f].triangles.empty()) attempt([&] { look_at(f); });
    }
    attempt([&] { check_edges(); });
    find_bound();
    for (const Face& face : faces_) attempt([&] { take(face); });
    if (!result_.obstacle.empty()) {
      result_.bands.clear();
      result_.borders.clear();
      for (Index f = 0; f < model_.faces.size(); ++f) {
        if (!model_.faces[f].triangles.empty() && is_round(model_.faces[f].surface.kind)) take_roughly(f);
      }
    }
    return std::move(result_);
  }

 private:
  /// A curved face whose edges are parallels and meridians.
  struct Face {
    Index face = 0;
    AxisLine line;
    BandBorder border;
    bool whole = false, ring = false;  ///< all around the axis, all around the tube
  };
  /// A circle about an axis on which corners lie, by one of these; and a half-plane likewise.
  using Place = std::pair<AxisLine, Index>;

  template <class Work>
  void attempt(Work work) {
    try {
      work();
    } catch (const NotDrawn& unfit) {
      if (result_.obstacle.empty()) result_.obstacle = unfit.words;
    }
  }

  const CadModel::Edge& edge(Index e) const { return model_.edges[e]; }
  const CadSurface& surface(const Face& face) const { return model_.faces[face.face].surface; }
  const RoundFace& exactly(Index f) const { return *round_.faces[f]; }

  // --- what is what, in doubles

  void look_at(Index f) {
    const CadModel::Face& of = model_.faces[f];
    if (of.surface.kind == Kind::plane) {
      for (const auto& [e, forward] : of.border) plane_at_.emplace(e, f);
      return;
    }
    if (!is_round(of.surface.kind))
      refuse(face_name(f) + " is on a " + of.surface.name + ", which is not drawn so");
    Face face;
    face.face = f;
    const CadAxes& axes = of.surface.axes;
    face.line = exactly(f).axis;
    const Point3 along = to_doubles(face.line.direction);
    face.border.ahead = dot(axes.z, along) > 0;
    face.border.turns_up = dot(cross(axes.x, axes.y), along) > 0;
    BandBorder& border = face.border;
    border.low = border.high = of.places[0].at[0];
    for (const CadModel::Place& place : of.places) {
      for (const auto& at : place.at) {
        for (std::size_t k = 0; k < 2; ++k) {
          border.low[k] = std::min(border.low[k], at[k]);
          border.high[k] = std::max(border.high[k], at[k]);
        }
      }
    }
    face.whole = border.high[0] - border.low[0] > kTurn * (1 - kRounding);
    face.ring = of.surface.kind == Kind::torus && border.high[1] - border.low[1] > kTurn * (1 - kRounding);
    std::set<Index> met;
    for (const auto& [e, forward] : of.border) {
      if (met.insert(e).second && (seams_ || !edge(e).seam)) add_side(face, e);
    }
    check_rectangle(face);
    find_poles(face);
    find_front(face);
    faces_.push_back(std::move(face));
  }

  /// Whether the edge is a parallel or a meridian, and at which of the four sides.
  void add_side(Face& face, Index e) {
    const CadCurve& curve = edge(e).curve;
    const CadSurface& of = surface(face);
    const auto fail = [&] {
      refuse(edge_name(e) + ", " + name_of(curve.kind) + ", is neither a parallel nor a meridian of " +
             face_name(face.face) + ", " + name_of(of.kind));
    };
    const Point3& z = of.axes.z;
    const double size = of.radius + of.minor_radius + length(minus(curve.axes.origin, of.axes.origin));
    bool parallel = false;
    if (curve.kind == CadCurve::Kind::circle) {
      parallel = length(cross(curve.axes.z, z)) < kRounding;
      if (parallel && length(cross(minus(curve.axes.origin, of.axes.origin), z)) > kRounding * size) fail();
      if (!parallel && (!has_arcs(of.kind) || std::abs(dot(curve.axes.z, z)) > kRounding)) fail();
    } else if (curve.kind != CadCurve::Kind::line || has_arcs(of.kind)) {
      fail();
    }
    const std::size_t k = parallel ? 1 : 0;
    const double value = parameters_at(of, middle_of(e))[k];
    const bool angle = k == 0 || of.kind == Kind::torus;
    const double unit = angle ? 1 : size + std::abs(value);
    const auto near = [&](double x) {
      const double off = angle ? std::remainder(value - x, kTurn) : value - x;
      return std::abs(off) < 1e3 * kRounding * unit;
    };
    const bool at_low = near(face.border.low[k]), at_high = near(face.border.high[k]);
    if (!at_low && !at_high) fail();
    Side side;
    if (parallel) side = at_low == face.border.ahead ? Side::first_row : Side::last_row;
    else side = at_low == face.border.turns_up ? Side::start : Side::end;
    if (parallel && face.ring) side = Side::first_row;
    if (!parallel && face.whole) side = Side::start;
    face.border.edges.emplace_back(e, side);
    (parallel ? of_parallels_ : of_meridians_).push_back({face.line, e});
  }

  /// Corners may be poles, which have no u; the middle of an edge is none.
  Point3 middle_of(Index e) const {
    const CadCurve& curve = edge(e).curve;
    const double t = (curve.first + curve.last) / 2;
    const bool circle = curve.kind == CadCurve::Kind::circle;
    const double x = circle ? curve.radius * std::cos(t) : t, y = circle ? curve.radius * std::sin(t) : 0;
    Point3 p = curve.axes.origin;
    for (std::size_t k = 0; k < 3; ++k) p[k] += x * curve.axes.x[k] + y * curve.axes.y[k];
    return p;
  }

  static double radius_at(const CadSurface& of, const Point3& p) {
    return length(cross(minus(p, of.axes.origin), of.axes.z));
  }

  /// The sides that are there go all along.
  void check_rectangle(const Face& face) const {
    std::array<double, 4> extent{};
    for (const auto& [e, side] : face.border.edges) {
      const CadCurve& curve = edge(e).curve;
      double way = curve.last - curve.first;
      if (curve.kind == CadCurve::Kind::line) {
        way *= std::abs(dot(curve.axes.x, surface(face).axes.z));
        if (surface(face).kind == Kind::cone) way /= std::cos(surface(face).half_angle);
      }
      extent[static_cast<std::size_t>(side)] += way;
    }
    const double u = face.border.high[0] - face.border.low[0], v = face.border.high[1] - face.border.low[1];
    for (const Side side : {Side::first_row, Side::last_row, Side::start, Side::end}) {
      const double has = extent[static_cast<std::size_t>(side)];
      const bool row = side == Side::first_row || side == Side::last_row;
      const double wants = row ? u : v;
      if (has == 0 && (row || face.whole)) continue;  // a pole, a seam
      if (std::abs(has - wants) < 1e-6 * wants) continue;
      refuse("the border of " + face_name(face.face) + ", " + name_of(surface(face).kind) +
             ", is not made of two parallels and two meridians");
    }
  }

  void find_poles(Face& face) const {
    bool rows[2] = {false, false};
    for (const auto& [e, side] : face.border.edges) {
      if (side == Side::first_row) rows[0] = true;
      if (side == Side::last_row) rows[1] = true;
    }
    if (face.ring) return;
    for (std::size_t i = 0; i < 2; ++i) {
      if (rows[i]) continue;
      if (surface(face).kind != Kind::sphere && surface(face).kind != Kind::cone) {
        refuse("the border of " + face_name(face.face) + " has no circle at one end");
      }
      // The corner of triangles that is farthest along, or back along, the axis.
      const Point3 along = to_doubles(face.line.direction);
      double most = 0;
      for (const auto& t : model_.faces[face.face].triangles) {
        for (const Index p : t) {
          const double way = (i == 0 ? -1 : 1) * dot(model_.points[p], along);
          if (face.border.poles[i] >= 0 && way <= most) continue;
          most = way;
          face.border.poles[i] = p;
        }
      }
      const Point3& pole = model_.points[static_cast<Index>(face.border.poles[i])];
      if (radius_at(surface(face), pole) > kRounding * size_ + 2 * result_.slack)
        refuse("the border of " + face_name(face.face) + " has no circle at one end, and no pole");
    }
  }

  /// By the facets that the face has.
  void find_front(Face& face) const {
    const CadSurface& of = surface(face);
    double sum = 0;
    for (const auto& t : model_.faces[face.face].triangles) {
      const Point3 &a = model_.points[t[0]], &b = model_.points[t[1]], &c = model_.points[t[2]];
      const Point3 normal = cross(minus(b, a), minus(c, a));
      for (const Point3* p : {&a, &b, &c}) {
        const Point3 off = minus(*p, of.axes.origin);
        Point3 out = off;
        const double t_along = dot(off, of.axes.z);
        for (std::size_t k = 0; k < 3; ++k) out[k] -= t_along * of.axes.z[k];
        const double r = length(out);
        if (of.kind == Kind::sphere) out = off;
        if (of.kind == Kind::torus && r > 0) {
          for (std::size_t k = 0; k < 3; ++k) out[k] = off[k] - of.radius / r * out[k];
        }
        sum += dot(normal, out);
      }
    }
    face.border.outward = sum > 0;
  }

  /// Every edge is straight or belongs to a band.
  void check_edges() const {
    std::set<Index> known;
    for (const Face& face : faces_) {
      for (const auto& [e, side] : face.border.edges) known.insert(e);
    }
    for (Index e = 0; e < model_.edges.size(); ++e) {
      const CadModel::Edge& of = model_.edges[e];
      if (of.points.size() < 2 || of.seam || known.contains(e) || of.curve.kind == CadCurve::Kind::line) continue;
      refuse(edge_name(e) + ", " + name_of(of.curve.kind) + ", is in no face on a surface of revolution");
    }
  }

  /// A corner at which nothing but circles about an axis begin and end may be anywhere on these circles.
  void find_bound() {
    std::set<Index> circles;
    for (const auto& [line, e] : of_parallels_) circles.insert(e);
    for (Index e = 0; e < model_.edges.size(); ++e) {
      const CadModel::Edge& of = model_.edges[e];
      if (of.points.size() < 2 || of.seam || (circles.contains(e) && of.points.front() == of.points.back()))
        continue;
      bound_.insert({of.points.front(), of.points.back()});
    }
  }

  // --- where it is, exactly

  RationalPoint at(Index p) const { return welded_.empty() ? from_doubles(model_.points[p]) : welded_[p]; }
  static RationalPoint away(const AxisLine& line, const RationalPoint& p) {
    return p - (line.foot + line.place_of(p) * line.direction);
  }
  bool is_pole(const AxisLine& line, Index p) const {
    return length(to_doubles(away(line, at(p)))) < kRounding * size_ + 2 * result_.slack;
  }

  /// The least of the corners that lie on one parallel, or meridian, with p.
  Index least(const AxisLine& line, Index p, const std::vector<std::pair<AxisLine, Index>>& of,
              std::map<Place, Index>& known) const {
    if (known.empty()) {
      std::map<Place, Index> number;
      std::vector<Place> places;
      const auto number_of = [&](const AxisLine& l, Index q) {
        const auto [it, fresh] = number.try_emplace({l, q}, static_cast<Index>(places.size()));
        if (fresh) places.push_back({l, q});
        return it->second;
      };
      std::vector<std::array<Index, 2>> links;
      for (const auto& [l, e] : of) {
        const Index a = edge(e).points.front(), b = edge(e).points.back();
        if (is_pole(l, a) || is_pole(l, b)) continue;
        links.push_back({number_of(l, a), number_of(l, b)});
      }
      UnionFind sets(places.size());
      for (const auto& [a, b] : links) sets.unite(a, b);
      std::map<Index, Index> first;
      for (Index i = 0; i < places.size(); ++i) {
        const auto [it, fresh] = first.try_emplace(sets.find(i), places[i].second);
        it->second = std::min(it->second, places[i].second);
      }
      for (Index i = 0; i < places.size(); ++i) known[places[i]] = first.at(sets.find(i));
      known[{AxisLine{}, 0}] = 0;  // known, even if there are none
    }
    const auto it = known.find({line, p});
    return it == known.end() ? p : it->second;
  }

  /// Of the parallel through corner p: all its corners get one place along the axis.
  MeridianPoint parallel(const Face& face, Index p) {
    const Index first = least(face.line, p, of_parallels_, parallel_of_);
    const auto [it, fresh] = circles_.try_emplace({face.line, first});
    if (fresh && face.ring) it->second = largest_circle(face);
    else if (fresh) it->second = circle_of(face, first);
    return it->second;
  }
  /// Where a face that goes all around the tube of a torus begins and ends.
  MeridianPoint largest_circle(const Face& face) const {
    if (std::abs(std::remainder(face.border.low[1], kTurn)) > kRounding)
      refuse(face_name(face.face) + ", all around a torus, does not begin at its largest circle");
    const RoundFace& of = exactly(face.face);
    return {of.radius + of.minor_radius, face.line.place_of(of.origin)};
  }
  /// Its place is that of a plane across the axis, or of the circle's centre where that is on the axis, else that
  /// of its corner; its radius that of a surface which has the parallel, or of its circle.
  MeridianPoint circle_of(const Face& face, Index first) const {
    std::optional<Rational> place;
    std::vector<std::pair<const Face*, Index>> of;  // with an edge on the parallel
    for (const Face& other : faces_) {
      if (!(other.line == face.line)) continue;
      for (const auto& [e, side] : other.border.edges) {
        if (side == Side::start || side == Side::end) continue;
        if (least(face.line, edge(e).points.front(), of_parallels_, parallel_of_) != first) continue;
        of.emplace_back(&other, e);
        if (!place) place = place_in_file(face.line, e);
      }
    }
    if (of.empty()) refuse("a corner of " + face_name(face.face) + " is on no parallel");
    MeridianPoint circle{0, place ? *place : face.line.place_of(at(first))};
    for (const auto& [other, e] : of) {
      if (surface(*other).kind != Kind::cylinder) continue;
      circle.r = exactly(other->face).radius;
      return circle;
    }
    circle.r = from_double(edge(of[0].second).curve.radius);
    for (const auto& [other, e] : of) {
      if (!has_arcs(surface(*other).kind)) continue;
      if (const std::optional<Rational> radius = radius_on_arc(*other, circle)) circle.r = *radius;
      break;
    }
    return circle;
  }
  std::optional<Rational> place_in_file(const AxisLine& line, Index e) const {
    if (!welded_.empty()) return std::nullopt;  // planes may have been moved, to where the corners are now
    if (const auto plane = plane_at_.find(e); plane != plane_at_.end()) {
      const CadAxes& axes = model_.faces[plane->second].surface.axes;
      if (is_zero(cross(from_doubles(axes.z), line.direction))) return line.place_of(from_doubles(axes.origin));
    }
    const RationalPoint center = from_doubles(edge(e).curve.axes.origin);
    return line.holds(center) ? std::optional(line.place_of(center)) : std::nullopt;
  }
  /// Of the parallel of a sphere or torus at a place along the axis; nothing where that says little, since the
  /// surface runs across the axis.
  std::optional<Rational> radius_on_arc(const Face& face, const MeridianPoint& near) const {
    const RoundFace& of = exactly(face.face);
    const bool ball = surface(face).kind == Kind::sphere;
    const Rational radius = ball ? of.radius : of.minor_radius;
    const Rational middle = ball ? Rational(0) : of.radius;
    const Rational up = near.t - face.line.place_of(of.origin);
    const Rational out = radius * radius - up * up * dot(face.line.direction, face.line.direction);
    if (out * 4 < radius * radius) return std::nullopt;
    const Rational root = round_cosine(0, out, exponent_of_root(out) - 60);
    return near.r < middle ? Rational(middle - root) : Rational(middle + root);
  }

  /// The direction from the axis to a corner of a parallel; the same for all of a meridian.
  RationalPoint direction(const Face& face, Index p) {
    const Index first = least(face.line, p, of_meridians_, meridian_of_);
    const auto [it, fresh] = directions_.try_emplace({face.line, first});
    if (!fresh) return it->second;
    const RationalPoint out = away(face.line, at(first));
    if (!bound_.contains(first)) return it->second = near_step(face.line, out);
    // A corner whose surface was welded is not on it yet.
    return it->second = round_.moved > 0 ? unit(out) : Rational(1 / parallel(face, first).r) * out;
  }
  /// Of a corner that is there only for a circle to begin somewhere, as near as doubles know it: so such corners
  /// of several circles, which are meant to begin in one half-plane, do.
  static RationalPoint near_step(const AxisLine& line, const RationalPoint& out) {
    const CircleFrame frame(line.direction);
    const Point3 p = to_doubles(out), first = to_doubles(frame.first()), second = to_doubles(frame.second());
    const double turn = std::atan2(dot(p, second) / length(second), dot(p, first) / length(first)) / kTurn;
    return frame.offset(1, 360 * from_double(std::round(turn * 0x1p40) * 0x1p-40));
  }
  /// That of a meridian. From pole to pole it has no corner to go by.
  RationalPoint direction_of_edge(const Face& face, Index e) {
    for (const Index p : {edge(e).points.front(), edge(e).points.back()}) {
      if (!is_pole(face.line, p)) return direction(face, p);
    }
    return unit(away(face.line, from_doubles(middle_of(e))));
  }
  static RationalPoint unit(const RationalPoint& v) {
    const Rational square = dot(v, v);
    return Rational(1 / round_cosine(0, square, exponent_of_root(square) - 60)) * v;
  }

  std::size_t mark(Band& band, const RationalPoint& direction) const {
    const auto it = std::find(band.marks.begin(), band.marks.end(), direction);
    if (it != band.marks.end()) return static_cast<std::size_t>(it - band.marks.begin());
    const double off = to_double(dot(direction, direction)) - 1;
    if (!(std::abs(off) < 4 * kRounding))
      refuse("a corner of " + face_name(band.face) + " is not on its surface, by more than doubles round");
    band.marks.push_back(direction);
    return band.marks.size() - 1;
  }

  void take(const Face& face) {
    Band band = empty_band(face.face, face.line);
    BandBorder border = face.border;
    band.whole = face.whole;
    const MeridianPoint* rows[2] = {nullptr, nullptr};
    MeridianPoint ends[2];
    bool starts = false, stops = false;
    for (const auto& [e, side] : border.edges) {
      band.edges.push_back(e);
      const std::vector<Index>& points = edge(e).points;
      if (side == Side::first_row || side == Side::last_row) {
        const std::size_t i = side == Side::last_row ? 1 : 0;
        ends[i] = parallel(face, points.front());
        rows[i] = &ends[i];
        for (const Index p : {points.front(), points.back()})
          border.corners.push_back({p, mark(band, direction(face, p)), i == 1});
      } else {
        const RationalPoint d = direction_of_edge(face, e);
        const std::size_t at_mark = mark(band, d);
        if (face.ring) border.corners.push_back({points.front(), at_mark, false});
        (side == Side::start ? band.start : band.end) = d;
        (side == Side::start ? starts : stops) = true;
      }
    }
    sort_unique(band.edges);
    if (!face.whole && (!starts || !stops)) refuse(face_name(face.face) + " has no meridian at one side");
    if (face.whole) {
      if (!starts) band.start = band.marks.empty() ? frame_of(face) : band.marks[0];
      band.end = band.start;
    }
    fill_piece(face, rows, band.form.lines[0][0]);
    result_.bands.push_back(std::move(band));
    result_.borders.push_back(std::move(border));
  }

  static RationalPoint frame_of(const Face& face) { return CircleFrame(face.line.direction).offset(1, 0); }

  Band empty_band(Index f, const AxisLine& line) const {
    Band band;
    band.face = f;
    const CadModel::Face& of = model_.faces[f];
    for (const auto* solids : {&of.behind, &of.before})
      band.solids.insert(band.solids.end(), solids->begin(), solids->end());
    std::sort(band.solids.begin(), band.solids.end());
    band.form.center = line.foot;
    band.form.axis = line.direction;
    double radius = of.surface.radius + of.surface.minor_radius;
    for (const auto& t : of.triangles) {
      for (const Index p : t) radius = std::max(radius, radius_at(of.surface, model_.points[p]));
    }
    band.form.segments = std::max(3, fineness_.steps_of_turn(radius * (1 + 1e-9), 360));
    band.form.lines.assign(1, std::vector<MeridianPiece>(1));
    return band;
  }

  /// `rows` is null for a pole, and for both ends of a whole ring.
  void fill_piece(const Face& face, const MeridianPoint* const* rows, MeridianPiece& piece) {
    const CadSurface& of = surface(face);
    const Rational square = dot(face.line.direction, face.line.direction);
    const RoundFace& round = exactly(face.face);
    const Rational middle = face.line.place_of(round.origin);
    if (!has_arcs(of.kind)) {
      for (std::size_t i = 0; i < 2; ++i) {
        MeridianPoint& end = i == 0 ? piece.from : piece.to;
        end = rows[i] != nullptr
                  ? *rows[i]
                  : MeridianPoint{0, face.line.place_of(at(static_cast<Index>(face.border.poles[i])))};
      }
      return;
    }
    piece.kind = MeridianPiece::Kind::arc;
    piece.radius = of.kind == Kind::sphere ? round.radius : round.minor_radius;
    piece.middle = {of.kind == Kind::sphere ? Rational(0) : round.radius, middle};
    double angles[2]{};
    const double axis = std::sqrt(to_double(square));
    for (std::size_t i = 0; i < 2; ++i) {
      MeridianPoint& end = i == 0 ? piece.from : piece.to;
      if (rows[i] != nullptr) {
        end = *rows[i];
        angles[i] = std::atan2(to_double(end.t - middle) * axis, to_double(end.r - piece.middle.r)) * 360 / kTurn;
      } else if (of.kind == Kind::sphere) {
        const Rational up = piece.radius * piece.radius / square;
        const Rational reach = round_cosine(0, up, exponent_of_root(up) - 51);
        end = {0, i == 0 ? Rational(middle - reach) : Rational(middle + reach)};
        angles[i] = i == 0 ? -90 : 90;
      }
    }
    piece.start = from_double(angles[0]);
    if (face.ring) {
      piece.from = piece.to = largest_circle(face);
      piece.start = 0;
      piece.sweep = 360;
    } else {
      double way = std::remainder(angles[1] - angles[0], 360);
      if (way <= 0) way += 360;
      piece.sweep = from_double(way);
    }
    const double turn = to_double(piece.sweep);
    piece.steps = std::max(
        1, static_cast<int>(std::ceil(fineness_.steps_of_turn(to_double(piece.radius), 360) * turn / 360 - 1e-9)));
  }

  /// The surface of a face, as far as its facets reach: to see what else lies on it.
  void take_roughly(Index f) {
    const CadSurface& of = model_.faces[f].surface;
    const RoundFace& round = exactly(f);
    const AxisLine& line = round.axis;
    Band band = empty_band(f, line);
    MeridianPiece& piece = band.form.lines[0][0];
    const Rational middle = line.place_of(round.origin);
    if (has_arcs(of.kind)) {
      const bool ball = of.kind == Kind::sphere;
      piece.kind = MeridianPiece::Kind::arc;
      piece.radius = ball ? round.radius : round.minor_radius;
      piece.middle = {ball ? Rational(0) : round.radius, middle};
      piece.from = piece.to = {piece.middle.r + piece.radius, middle};
      piece.sweep = 360;
    } else {
      bool any = false;
      for (const auto& t : model_.faces[f].triangles) {
        for (const Index p : t) {
          const RationalPoint q = at(p);
          const Rational place = line.place_of(q);
          const Rational radius =
              of.kind == Kind::cylinder ? round.radius : from_double(radius_at(of, model_.points[p]));
          if (!any || place < piece.from.t) piece.from = {radius, place};
          if (!any || place > piece.to.t) piece.to = {radius, place};
          any = true;
        }
      }
    }
    band.start = band.end = CircleFrame(line.direction).offset(1, 0);
    result_.bands.push_back(std::move(band));
  }

  const CadModel& model_;
  const CadRound& round_;
  const std::vector<RationalPoint>& welded_;
  const Fineness& fineness_;
  bool seams_;
  double size_ = 0;  // of all coordinates
  CadBands result_;
  std::vector<Face> faces_;
  std::vector<std::pair<AxisLine, Index>> of_parallels_, of_meridians_;  // edges
  std::map<Index, Index> plane_at_;                                      // of an edge, the first
  std::set<Index> bound_;                                     // corners that edges between two corners end at
  mutable std::map<Place, Index> parallel_of_, meridian_of_;  // least corners
  std::map<Place, MeridianPoint> circles_;
  std::map<Place, RationalPoint> directions_;
};

}  // namespace

CadBands bands_of(const CadModel& model, const CadRound& round, const std::vector<RationalPoint>& welded,
                  const Fineness& fineness, bool seams) {
  return Finder(model, round, welded, fineness, seams).run();
}

std::array<double, 2> parameters_at(const CadSurface& surface, const std::array<double, 3>& p) {
  const Point3 off = minus(p, surface.axes.origin);
  const double x = dot(off, surface.axes.x), y = dot(off, surface.axes.y), z = dot(off, surface.axes.z);
  const double u = std::atan2(y, x), r = std::hypot(x, y);
  switch (surface.kind) {
    case Kind::plane: return {x, y};
    case Kind::cone: return {u, z / std::cos(surface.half_angle)};
    case Kind::sphere: return {u, std::atan2(z, r)};
    case Kind::torus: return {u, std::atan2(z, r - surface.radius)};
    default: return {u, z};
  }
}

}  // namespace cnrg
