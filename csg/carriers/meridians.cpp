// Contacts of lines and circles, and the vertices of circles.
#include "csg/carriers/meridians.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

using Point = MeridianPoint;
using Kind = MeridianPiece::Kind;

Rational meridian_cross(const Point& a, const Point& b) { return a.r * b.t - a.t * b.r; }
Rational meridian_dot(const Point& a, const Point& b, const Rational& square) {
  return a.r * b.r + square * a.t * b.t;
}

double degrees_of(const Point& p, const Point& middle, const Rational& square) {
  return rounded::arc_tangent(to_double(p.t - middle.t) * std::sqrt(to_double(square)),
                              to_double(p.r - middle.r)) *
         180 / std::numbers::pi;
}

/// How far an angle is along an arc, in degrees from its start in the direction of its sweep, 0 to 360.
Rational along(const MeridianPiece& arc, const Rational& degrees) {
  const Rational way = arc.sweep < 0 ? arc.start - degrees : degrees - arc.start, turns = way / 360;
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), turns.get_num_mpz_t(), turns.get_den_mpz_t());
  return way - 360 * whole;
}

/// Nearer to an end than this, in degrees, a point is not told from it.
constexpr double kNearAngle = 1e-9;

bool on_circle(const MeridianPiece& arc, const Point& p, const Rational& square) {
  const Point off = p - arc.middle;
  return meridian_dot(off, off, square) == arc.radius * arc.radius;
}

/// For a point on the circle of the arc, or next to it.
bool arc_holds(const MeridianPiece& arc, const Point& p, const Rational& square) {
  if (p == arc.from || p == arc.to || abs(arc.sweep) == 360) return true;
  const double way = to_double(along(arc, from_double(degrees_of(p, arc.middle, square))));
  return way > kNearAngle && way < std::abs(to_double(arc.sweep)) - kNearAngle;
}

bool on_line(const MeridianPiece& line, const Point& p) {
  const Point way = line.to - line.from, off = p - line.from;
  if (meridian_cross(way, off) != 0) return false;
  const Rational part = way.r != 0 ? Rational(off.r / way.r) : Rational(off.t / way.t);
  return part >= 0 && part <= 1;
}

}  // namespace

bool on_piece(const MeridianPiece& piece, const Point& p, const Rational& square) {
  if (p == piece.from || p == piece.to) return true;
  if (piece.kind == Kind::line) return on_line(piece, p);
  return piece.kind == Kind::arc && on_circle(piece, p, square) && arc_holds(piece, p, square);
}

namespace {

void join_lines(const MeridianPiece& p, const MeridianPiece& q, MeridianContact& result) {
  if (p.flat() || q.flat()) return;
  const Point a = p.to - p.from, b = q.to - q.from, off = q.from - p.from;
  const Rational turn = meridian_cross(a, b);
  if (turn != 0) {
    const Rational s = meridian_cross(off, b) / turn, t = meridian_cross(off, a) / turn;
    result.joins = s >= 0 && s <= 1 && t >= 0 && t <= 1 && p.from.r + s * a.r > 0;
  } else if (meridian_cross(a, off) == 0) {
    result.joins = on_line(p, q.from) || on_line(p, q.to) || on_line(q, p.from);
  }
}

/// Points of a straight piece that are on the circle of an arc.
std::vector<Point> line_on_circle(const MeridianPiece& line, const MeridianPiece& arc, const Rational& square,
                                  bool& touches) {
  const Point way = line.to - line.from, off = line.from - arc.middle;
  const Rational a = meridian_dot(way, way, square), b = meridian_dot(way, off, square),
                 c = meridian_dot(off, off, square) - arc.radius * arc.radius, root2 = b * b - a * c;
  touches = root2 == 0;
  if (root2 < 0) return {};
  const Rational half = root(root2);
  std::vector<Point> points;
  for (const Rational& s : {Rational((-b - half) / a), Rational((half - b) / a)}) {
    if (s >= 0 && s <= 1) points.push_back(line.from + s * way);
    if (touches) break;
  }
  return points;
}

/// Points of two different circles; `touches` if it is one.
std::vector<Point> circles(const MeridianPiece& p, const MeridianPiece& q, const Rational& square) {
  const Point apart = q.middle - p.middle;
  const Rational distance2 = meridian_dot(apart, apart, square);
  if (distance2 == 0) return {};
  const Rational part = (p.radius * p.radius - q.radius * q.radius + distance2) / (2 * distance2);
  const Rational across2 = (p.radius * p.radius / distance2 - part * part) / square;
  if (across2 < 0) return {};
  const Point foot = p.middle + part * apart, across{-square * apart.t, apart.r};
  if (across2 == 0) return {foot};
  const Rational reach = root(across2);
  return {foot + reach * across, foot - reach * across};
}

/// True for two arcs of whose circles p's touches q's from inside, somewhere.
bool touches_from_inside(const MeridianPiece& p, const MeridianPiece& q, const Rational& square) {
  if (p.kind != Kind::arc || q.kind != Kind::arc || p.radius >= q.radius) return false;
  const Point apart = p.middle - q.middle;
  return meridian_dot(apart, apart, square) == (q.radius - p.radius) * (q.radius - p.radius);
}

bool same_circle(const MeridianPiece& p, const MeridianPiece& q) {
  return p.middle == q.middle && p.radius == q.radius;
}

/// Adds points that both arcs hold, but not next to one that is known.
void add_points(const MeridianPiece& p, const MeridianPiece& q, std::vector<Point> found, bool even_if_flat,
                const Rational& square, MeridianContact& result) {
  const bool flat = p.flat() || q.flat();
  for (const Point& x : found) {
    if (x.r <= 0) continue;
    bool held = true, known = false;
    for (const MeridianPiece* arc : {&p, &q}) {
      if (arc->kind != Kind::arc) continue;
      held = held && arc_holds(*arc, x, square);
      for (const Point& y : result.points) {
        known = known ||
                std::abs(std::remainder(degrees_of(x, arc->middle, square) - degrees_of(y, arc->middle, square),
                                        360)) < kNearAngle;
      }
    }
    if (!held || known) continue;
    if (!flat) result.joins = true;
    if (!flat || even_if_flat) result.points.push_back(x);
  }
}

}  // namespace

MeridianContact contact(const MeridianPiece& p, const MeridianPiece& q, const Rational& square) {
  MeridianContact result;
  if (p.kind == Kind::line && q.kind == Kind::line) {
    join_lines(p, q, result);
    return result;
  }
  // Where one ends on the other.
  for (const auto& [piece, other] : {std::pair(&p, &q), std::pair(&q, &p)}) {
    for (const Point& end : {piece->from, piece->to}) {
      if (end.r == 0 || !on_piece(*other, end, square)) continue;
      result.joins = true;
      if (std::find(result.points.begin(), result.points.end(), end) == result.points.end())
        result.points.push_back(end);
    }
  }
  if (p.kind == Kind::net || q.kind == Kind::net) {
    result.joins = result.joins || (p.kind == q.kind && canonical(p.net).curve.net == canonical(q.net).curve.net);
    return result;
  }
  if (p.kind == Kind::arc && q.kind == Kind::arc) {
    if (same_circle(p, q)) result.joins = true;
    else add_points(p, q, circles(p, q, square), true, square, result);
    return result;
  }
  const MeridianPiece &line = p.kind == Kind::line ? p : q, &arc = p.kind == Kind::line ? q : p;
  bool touches = false;
  const std::vector<Point> found = line_on_circle(line, arc, square, touches);
  add_points(p, q, found, touches, square, result);
  return result;
}

// --- the plane

std::size_t MeridianPlane::add(const MeridianPiece& piece) {
  if (piece.kind == Kind::arc) {
    Arc& arc = arcs_[{piece.middle, piece.radius}];
    arc.middle = piece.middle;
    arc.radius = piece.radius;
    const double steps = std::ceil(piece.steps * 360.0 / std::abs(to_double(piece.sweep)) - 1e-9);
    arc.steps = std::max({arc.steps, static_cast<int>(steps), 3});
    for (const Point& end : {piece.from, piece.to}) arc.marks.push_back(end);
  }
  if (piece.kind == Kind::net) {
    int& steps = nets_[canonical(piece.net).curve.net].even;
    steps = std::max(steps, piece.steps);
  }
  std::vector<Point> points{piece.from, piece.to};
  double up = 0, out = 0;
  if (piece.kind == Kind::arc) {
    points = {piece.middle};
    out = to_double(piece.radius);
    up = out / std::sqrt(to_double(square_));
  }
  for (const Homogeneous& h : piece.net.net) points.push_back({h[0] / h[3], h[2] / h[3]});
  Bounds bounds{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (const Point& p : points) {
    const double r = to_double(p.r), t = to_double(p.t), margin = 1e-9;
    bounds.low_r = std::min(bounds.low_r, r - out - margin * (std::abs(r) + out));
    bounds.high_r = std::max(bounds.high_r, r + out + margin * (std::abs(r) + out));
    bounds.low_t = std::min(bounds.low_t, t - up - margin * (std::abs(t) + up));
    bounds.high_t = std::max(bounds.high_t, t + up + margin * (std::abs(t) + up));
  }
  bounds_.push_back(bounds);
  pieces_.push_back(piece);
  return pieces_.size() - 1;
}

void MeridianPlane::add_vertex(std::size_t i, const MeridianPoint& at) {
  const MeridianPiece& piece = pieces_[i];
  if (piece.kind != Kind::arc) return;
  const double radius = to_double(piece.radius);
  const Point off = at - piece.middle;
  if (std::abs(std::sqrt(to_double(meridian_dot(off, off, square_))) - radius) > kNearAngle * radius) return;
  arcs_.at({piece.middle, piece.radius}).marks.push_back(at);
}

void MeridianPlane::add_across(std::size_t i, const MeridianPiece& other) {
  const MeridianPiece& piece = pieces_[i];
  if (piece.kind != Kind::arc) return;
  for (const Point& end : {other.from, other.to}) {
    const Rational up = end.t - piece.middle.t, square = piece.radius * piece.radius,
                   out = square - square_ * up * up, off = end.r - piece.middle.r;
    if (out > 0 && end.r > 0 && abs(off * off - out) * 8 <= square && off * off != out)
      add_vertex(i, {piece.middle.r + (off < 0 ? -1 : 1) * root(out), end.t});
  }
}

void MeridianPlane::add_row(std::size_t i, const Rational& way) {
  const MeridianPiece& piece = pieces_[i];
  if (piece.kind == Kind::line) {
    lines_[i].insert(way);
  } else if (piece.kind == Kind::net) {
    const CanonicalCurve of = canonical(piece.net);
    nets_.at(of.curve.net).lines.insert(of.reversed ? Rational(1 - way) : way);
  } else {
    Arc& arc = arcs_.at({piece.middle, piece.radius});
    if (piece.net.net.empty()) {
      Rational degrees = piece.start + way * piece.sweep;
      while (degrees > 180) degrees -= 360;
      while (degrees <= -180) degrees += 360;
      arc.rows.insert({on_arc(arc, degrees), degrees});
    } else {
      const RationalPoint p = piece.net.at(way);
      const Point at{p[0], p[2]};
      arc.rows.insert({at, from_double(angle_of(arc, at))});
    }
  }
}

void MeridianPlane::solve() {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (pieces_[i].kind != Kind::arc && pieces_[j].kind != Kind::arc) continue;
      if (!bounds_[i].meets(bounds_[j])) continue;
      const MeridianContact found = contact(pieces_[i], pieces_[j], square_);
      for (const Point& at : found.points) {
        add_vertex(i, at);
        add_vertex(j, at);
      }
      add_across(i, pieces_[j]);
      add_across(j, pieces_[i]);
    }
  }
  // A chord that crosses what its arc does not is halved; the other way round it would be for ever where two arcs
  // touch from inside, hence the bound, after which the chords stay as they are.
  constexpr int kMostRounds = 12;
  for (int round = 0; round < kMostRounds; ++round) {
    for (auto& [key, arc] : arcs_) sample(arc);
    if (!separate_chords()) return;
  }
}

double MeridianPlane::angle_of(const Arc& arc, const MeridianPoint& p) const {
  return degrees_of(p, arc.middle, square_);
}

MeridianPoint MeridianPlane::on_arc(const Arc& arc, const Rational& degrees) const {
  const Rational out2 = arc.radius * arc.radius;
  return round_(
      {arc.middle.r + scaled_cosine(degrees, out2), arc.middle.t + scaled_cosine(90 - degrees, out2 / square_)});
}

void MeridianPlane::sample(Arc& arc) const {
  // Of marks that are one point but for what square roots round, that which is nearest to the circle stays.
  std::vector<std::pair<Rational, Point>> by_error;
  for (const Point& p : arc.marks) {
    const Point off = p - arc.middle;
    by_error.emplace_back(abs(meridian_dot(off, off, square_) - arc.radius * arc.radius), p);
  }
  std::sort(by_error.begin(), by_error.end());
  std::vector<Point> kept;
  std::vector<double> marked;
  for (const auto& [error, p] : by_error) {
    const double angle = angle_of(arc, p);
    const bool known = std::any_of(marked.begin(), marked.end(), [&](double other) {
      return std::abs(std::remainder(angle - other, 360)) < kNearAngle;
    });
    if (known) continue;
    kept.push_back(p);
    marked.push_back(angle);
  }
  arc.marks = std::move(kept);
  std::vector<Point> fixed = arc.marks;
  fixed.insert(fixed.end(), arc.halvings.begin(), arc.halvings.end());
  arc.vertices.clear();
  marked.clear();
  for (const Point& p : fixed) {
    marked.push_back(angle_of(arc, p));
    arc.vertices.push_back({p, from_double(marked.back())});
  }
  std::sort(marked.begin(), marked.end());
  // A sphere's even steps begin at its pole, all others at the outermost circle.
  const bool sphere = arc.middle.r == 0;
  const double near = 360.0 / arc.steps * 0x1p-32;
  const auto is_marked = [&](double angle) {
    const auto next = std::lower_bound(marked.begin(), marked.end(), angle - near);
    if (next != marked.end() && *next <= angle + near) return true;
    return !marked.empty() && (marked.front() + 360 - angle <= near || angle + 360 - marked.back() <= near);
  };
  for (int j = 0; j < arc.steps; ++j) {
    Rational degrees = fraction(std::int64_t{360} * j, arc.steps) - (sphere ? 90 : 0);
    if (degrees > 180) degrees -= 360;
    if (is_marked(to_double(degrees))) continue;
    const Point p = on_arc(arc, degrees);
    if (p.r >= 0) arc.vertices.push_back({p, degrees});
  }
  constexpr double kNearRow = 1e-12;
  for (const Vertex& row : arc.rows) {
    const bool known = std::any_of(arc.vertices.begin(), arc.vertices.end(), [&](const Vertex& other) {
      return std::abs(std::remainder(to_double(row.degrees - other.degrees), 360)) < kNearRow;
    });
    if (!known) arc.vertices.push_back(row);
  }
}

std::vector<MeridianPoint> MeridianPlane::marks(std::size_t i) const {
  return arcs_.at({pieces_[i].middle, pieces_[i].radius}).marks;
}

std::vector<MeridianPoint> MeridianPlane::vertices(const MeridianPoint& middle, const Rational& radius,
                                                   bool only_marks) const {
  const auto arc = arcs_.find({middle, radius});
  if (arc == arcs_.end()) return {};
  if (only_marks) return arc->second.marks;
  std::vector<MeridianPoint> result;
  for (const Vertex& vertex : arc->second.vertices) result.push_back(vertex.at);
  return result;
}

std::vector<RevolvedGrid::Row> MeridianPlane::rows(std::size_t i) const {
  const MeridianPiece& piece = pieces_[i];
  std::vector<RevolvedGrid::Row> result{{piece.from, piece.parameters[0]}};
  if (piece.kind == Kind::net) {
    const CanonicalCurve of = canonical(piece.net);
    for (const Rational& way : nets_.at(of.curve.net).inside(of.reversed)) {
      const RationalPoint p = piece.net.at(way);
      result.push_back({{p[0], p[2]}, in_span(piece.parameters, way)});
    }
  }
  if (const auto rows = lines_.find(i); rows != lines_.end()) {
    for (const Rational& way : rows->second)
      result.push_back({piece.from + way * (piece.to - piece.from), in_span(piece.parameters, way)});
  }
  if (piece.kind == Kind::arc) {
    const Arc& arc = arcs_.at({piece.middle, piece.radius});
    const double whole = std::abs(to_double(piece.sweep));
    std::vector<std::pair<Rational, Point>> inside;
    for (const Vertex& vertex : arc.vertices) {
      if (vertex.at == piece.from || vertex.at == piece.to) continue;
      const Rational way = along(piece, vertex.degrees);
      if (to_double(way) > kNearAngle && to_double(way) < whole - kNearAngle) inside.emplace_back(way, vertex.at);
    }
    std::sort(inside.begin(), inside.end());
    for (const auto& [way, p] : inside) {
      const Rational degrees = piece.start + Rational(piece.sweep < 0 ? -1 : 1) * way;
      result.push_back({p, parameter_of(piece, degrees)});
    }
  }
  result.push_back({piece.to, piece.parameters[1]});
  return result;
}

bool MeridianPlane::separate_chords() {
  bool changed = false;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const MeridianPiece &p = pieces_[i], &q = pieces_[j];
      if (!bounds_[i].meets(bounds_[j])) continue;
      if ((p.kind != Kind::arc && q.kind != Kind::arc) || p.flat() || q.flat()) continue;
      if (p.kind == Kind::arc && q.kind == Kind::arc && same_circle(p, q)) continue;
      // Of two arcs the larger one is drawn finer.
      const bool first = p.kind == Kind::arc && (q.kind != Kind::arc || p.radius >= q.radius);
      changed = separate(first ? i : j, first ? j : i) || changed;
    }
  }
  return changed;
}

/// Halves the chords of arc i that meet piece j elsewhere than in a vertex of it, and where j touches it from
/// inside those that leave this point at an angle to the arc which is not clearly smaller.
bool MeridianPlane::separate(std::size_t i, std::size_t j) {
  const std::vector<RevolvedGrid::Row> mine = rows(i), others = rows(j);
  const MeridianPiece& piece = pieces_[i];
  Arc& arc = arcs_.at({piece.middle, piece.radius});
  struct Chord {
    double low_r, high_r, low_t, high_t;
    Chord(const Point& a, const Point& b)
        : low_r(std::min(to_double(a.r), to_double(b.r))),
          high_r(std::max(to_double(a.r), to_double(b.r))),
          low_t(std::min(to_double(a.t), to_double(b.t))),
          high_t(std::max(to_double(a.t), to_double(b.t))) {}
    bool meets(const Chord& c) const {
      return low_r <= c.high_r && c.low_r <= high_r && low_t <= c.high_t && c.low_t <= high_t;
    }
  };
  std::vector<Chord> boxes;
  for (std::size_t l = 1; l < others.size(); ++l) boxes.emplace_back(others[l - 1].at, others[l].at);
  const bool inside = touches_from_inside(pieces_[j], piece, square_);
  const auto sweep = [&](const MeridianPiece& of, const Point& from, const Point& to) {
    return std::remainder(degrees_of(to, of.middle, square_) - degrees_of(from, of.middle, square_), 360);
  };
  /// For a chord of each from one point, as far as they are on one side of it; chords are at half their angles.
  const auto too_wide = [&](const Point& from, const Point& to, const Point& other) {
    const double wide = sweep(piece, from, to), narrow = sweep(pieces_[j], from, other);
    return wide * narrow > 0 && std::abs(wide) > 0.75 * std::abs(narrow);
  };
  bool changed = false;
  for (std::size_t k = 1; k < mine.size(); ++k) {
    const Point &a = mine[k - 1].at, &b = mine[k].at;
    const Chord box(a, b);
    for (std::size_t l = 1; l < others.size(); ++l) {
      if (!box.meets(boxes[l - 1])) continue;
      const Point &c = others[l - 1].at, &d = others[l].at;
      const int side_a = sgn(meridian_cross(d - c, a - c)), side_b = sgn(meridian_cross(d - c, b - c));
      const int side_c = sgn(meridian_cross(b - a, c - a)), side_d = sgn(meridian_cross(b - a, d - a));
      if (side_a * side_b > 0 || side_c * side_d > 0) continue;
      const bool collinear = side_a == 0 && side_b == 0;
      if (inside && (a == c || a == d || b == c || b == d)) {
        const bool at_a = a == c || a == d;
        const Point& from = at_a ? a : b;
        if (!too_wide(from, at_a ? b : a, from == c ? d : c)) continue;
      } else if (collinear) {
        // They overlap in more than a point if the ends lie so along the line.
        const auto place = [&](const Point& x) -> Rational {
          return a.r != b.r ? Rational((x.r - a.r) / (b.r - a.r)) : Rational((x.t - a.t) / (b.t - a.t));
        };
        const Rational low = std::min(place(c), place(d)), high = std::max(place(c), place(d));
        if (high <= 0 || low >= 1) continue;
      } else if (side_a == 0 || side_b == 0) {
        continue;  // in a vertex of the arc
      }
      const double from = angle_of(arc, a), way = std::remainder(angle_of(arc, b) - from, 360);
      arc.halvings.push_back(on_arc(arc, from_double(from + way / 2)));
      changed = true;
      break;
    }
  }
  return changed;
}

}  // namespace cnrg
