// Meridians of two cells in a common half-plane; see the header.
#include "csg/certify/coaxial.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cnrg {

using namespace surface_math;

namespace {

// Of the size of coordinates: what may be rounded, and what rounding in here adds at most.
constexpr double kRounded = 1e-13, kOfOwn = 4e-15;
constexpr double kMargin = 10;  // of what is rounded
constexpr double kAngleMargin = 1e-8;
constexpr double kLeastLength = 1e-10;  // of a chord
constexpr int kMostHalvings = 20000;

/// Away from the axis and along it.
using Point2 = std::array<Interval, 2>;
Interval cross2(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }
Upward length_of(Upward x, Upward y) { return sqrt(x * x + y * y); }
Upward length_of(const Point2& a) { return length_of(middle_of(a[0]), middle_of(a[1])); }

/// A point and a direction of length 1, nearly.
struct Axis {
  Guess3 center, way;
  explicit Axis(const Revolution& turn)
      : center{turn.center[0], turn.center[1], turn.center[2]}, way{turn.axis[0], turn.axis[1], turn.axis[2]} {}
};

struct HalfPlane {
  Axis axis;
  Guess3 away;
  Point2 way(const Interval3& v) const { return {dot(thin(away), v), dot(thin(axis.way), v)}; }
  Point2 at(const Interval3& p) const { return way(difference(p, thin(axis.center))); }
};

/// A cell in one of its two half-planes.
struct Meridian {
  const Piece* piece;
  HalfPlane plane;
  std::size_t along;
  double angle = 0;                               ///< the parameter that is the angle, here
  std::array<double, 2> range{};                  ///< of the other one
  std::array<Point2, 2> corners{};                ///< at its ends
  Point2 chord{};                                 ///< the derivative of F
  Upward rounded = 0;                             ///< how far corners are from where they should be, at most
  Upward turned = 0;                              ///< by how much that may turn it
  std::array<std::optional<Point2>, 2> beyond{};  ///< that of the next cells, at these ends

  Point2 on_chord(const Interval& m) const {
    const Interval off = m - Interval(range[0]);
    return {corners[0][0] + off * chord[0], corners[0][1] + off * chord[1]};
  }
  SurfaceJet<Interval> jet(const Interval& m) const {
    return along == 1 ? piece->surface->over(Interval(angle), m) : piece->surface->over(m, Interval(angle));
  }
};

/// A part of a meridian: F and S.
struct MeridianPart {
  const Meridian* of;
  std::array<double, 2> range;
  Point2 chord{};                  // F in the middle
  std::array<Point2, 3> tangents;  // of F, with the next cells at an end
  std::size_t count = 0;
  Point2 middle{}, tangent{};  // of S
  Interval off = 0;            // parameters from its middle

  MeridianPart(const Meridian& meridian, const std::array<double, 2>& of_range, Between between)
      : of(&meridian), range(of_range) {
    const Interval whole(range[0], range[1]), at(middle_of(whole));
    off = whole - at;
    middle = of->plane.at(of->jet(at).point);
    const SurfaceJet<Interval> jet = of->jet(whole);
    tangent = of->plane.way(of->along == 1 ? jet.along_v : jet.along_u);
    tangents[count++] = between == Between::surfaces ? tangent : of->chord;
    chord = between == Between::surfaces ? middle : of->on_chord(at);
    for (std::size_t k = 0; between != Between::surfaces && k < 2; ++k) {
      if (range[k] == of->range[k] && of->beyond[k]) tangents[count++] = *of->beyond[k];
    }
  }
  Upward length() const { return length_of(tangent) * (Upward(range[1]) - range[0]); }
  bool beside_axis() const {
    return (middle[0] + off * tangent[0]).inf() > 0 && (chord[0] + off * tangents[0][0]).inf() > 0;
  }
};

class MeridianQuestion {
 public:
  MeridianQuestion(Meridian a, Meridian b, Between between)
      : a_(std::move(a)), b_(std::move(b)), between_(between), margin_(kMargin * (a_.rounded + b_.rounded)) {}
  Coaxial run() {
    if (!answer(MeridianPart(a_, a_.range, between_), MeridianPart(b_, b_.range, between_))) return Coaxial::open;
    return some_ ? Coaxial::crossing : Coaxial::apart;
  }

 private:
  bool answer(const MeridianPart& a, const MeridianPart& b) {
    for (const MeridianPart* const one : {&a, &b}) {
      const Point2 &f = one->tangents[0], &s = one->tangent;
      if (parted(a, b, f, s) || parted(a, b, {f[1], -f[0]}, {s[1], -s[0]})) return true;
    }
    if (a.beside_axis() && b.beside_axis() && cross(a, b)) {
      some_ = true;
      return true;
    }
    if (steps_++ == kMostHalvings) return false;
    const bool first = a.length() >= b.length();
    const MeridianPart& longer = first ? a : b;
    const double middle = middle_of(Interval(longer.range[0], longer.range[1]));
    if (!(longer.range[0] < middle && middle < longer.range[1]) || !(longer.length() > margin_)) return false;
    for (const std::array<double, 2>& half : {std::array{longer.range[0], middle}, {middle, longer.range[1]}}) {
      const MeridianPart part(*longer.of, half, between_);
      if (!answer(first ? part : a, first ? b : part)) return false;
    }
    return true;
  }

  /// By a line that turns from one direction to another while t goes from 0 to 1.
  bool parted(const MeridianPart& a, const MeridianPart& b, const Point2& first, const Point2& last) const {
    const auto across = [](const Point2& way) {
      const Upward length = length_of(way);
      return Point2{double(-middle_of(way[1]) / length), double(middle_of(way[0]) / length)};
    };
    const Point2 d = across(first), e = across(last);
    const auto dot2 = [](const Point2& x, const Point2& p) { return x[0] * p[0] + x[1] * p[1]; };
    bool before = true, behind = true;
    const Interval margin = double(margin_);
    const auto compare = [&](const auto& extent) {
      const Interval of_a = extent(a), of_b = extent(b);
      before = before && (of_a + margin).sup() < of_b.inf();
      behind = behind && (of_b + margin).sup() < of_a.inf();
    };
    compare([&](const MeridianPart& part) { return dot2(e, part.middle) + part.off * dot2(e, part.tangent); });
    if (between_ == Between::surfaces) return before || behind;
    compare([&](const MeridianPart& part) { return dot2(d, part.chord) + part.off * dot2(d, part.tangents[0]); });
    compare([&](const MeridianPart& part) {
      return dot2(d, part.middle) + dot2(e, part.chord) +
             part.off * (dot2(d, part.tangent) + dot2(e, part.tangents[0]));
    });
    return before || behind;
  }

  /// True if tangents are at an angle, of one sign.
  bool cross(const MeridianPart& a, const MeridianPart& b) const {
    bool left = true, right = true;
    const auto compare = [&](const Interval& x, Upward of) {
      const Upward least = (kAngleMargin + a_.turned + b_.turned) * of;
      left = left && x.inf() > least;
      right = right && x.sup() < -least;
    };
    compare(cross2(a.tangent, b.tangent), length_of(a.tangent) * length_of(b.tangent));
    if (between_ == Between::surfaces) return left || right;
    for (std::size_t i = 0; i < a.count; ++i) {
      for (std::size_t j = 0; j < b.count; ++j) {
        const Point2 &f = a.tangents[i], &g = b.tangents[j];
        compare(cross2(f, g), length_of(f) * length_of(g));
        compare(cross2(f, b.tangent) + cross2(a.tangent, g),
                length_of(f) * length_of(b.tangent) + length_of(a.tangent) * length_of(g));
      }
    }
    return left || right;
  }

  const Meridian a_, b_;
  const Between between_;
  const Upward margin_;
  int steps_ = 0;
  bool some_ = false;
};

/// Of a cell in a column: corners at its two half-planes, at the ends of the other parameter.
struct Sides {
  std::size_t around;
  std::array<std::array<std::size_t, 2>, 2> corners{};
  explicit Sides(const Piece& piece) : around(piece.column->around) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto last = [&](std::size_t k) {
        return std::ranges::any_of(piece.at, [&](const auto& at) { return at[k] < piece.at[i][k]; });
      };
      corners[last(around) ? 1 : 0][last(1 - around) ? 1 : 0] = i;
    }
  }
};

/// The size of coordinates.
Upward size_of_corners(const Piece& piece) {
  double size = 0;
  for (const Interval3& p : piece.corners) {
    for (const Interval& x : p) size = std::max({size, std::abs(x.inf()), std::abs(x.sup())});
  }
  return size;
}

/// The way to a point from the axis, and how far along that it begins.
std::pair<Guess3, Upward> off_axis(const Interval3& p, const Axis& axis) {
  const Guess3 way = difference(middle_of(p), axis.center);
  const Upward high = dot(way, axis.way);
  return {difference(way, scaled(high, axis.way)), high};
}

/// Of its two half-planes the ways from the axis to the corner that is farther off.
std::array<Guess3, 2> ways_off(const Axis& turn, const Piece& piece, const Sides& sides) {
  const auto farther = [&](const std::array<std::size_t, 2>& ends) {
    const auto off = [&](std::size_t i) { return off_axis(piece.corners[i], turn).first; };
    const Guess3 a = off(ends[0]), b = off(ends[1]);
    return length(a) >= length(b) ? a : b;
  };
  return {farther(sides.corners[0]), farther(sides.corners[1])};
}

/// True if the other way of two is counter-clockwise from way i.
bool ahead(const Axis& turn, const std::array<Guess3, 2>& ways, std::size_t i) {
  return dot(cross(ways[i], ways[1 - i]), turn.way) > 0;
}
/// True if a half-plane of one is between those of the other.
bool overlap(const Axis& turn, const std::array<Guess3, 2>& a, const std::array<Guess3, 2>& b) {
  const auto between = [&](const std::array<Guess3, 2>& ways, const Guess3& x) {
    const std::size_t first = ahead(turn, ways, 0) ? 0 : 1;
    return dot(cross(ways[first], x), turn.way) > 0 && dot(cross(x, ways[1 - first]), turn.way) > 0;
  };
  const auto any = [&](const auto& ways, const auto& others) {
    return between(ways, others[0]) || between(ways, others[1]) || between(ways, sum(others[0], others[1]));
  };
  return any(a, b) || any(b, a);
}

/// Of cells in columns that have at most the axis in common: where this goes through each, if it does.
Coaxial ask_on_axis(const Axis& turn, const Piece& a, const Piece& b, Upward size) {
  const auto pole = [](const Piece& piece) -> std::optional<Guess3> {
    for (std::size_t i = 0; i < 4; ++i) {
      if (piece.points[i] == piece.points[(i + 1) % 4]) return middle_of(piece.corners[i]);
    }
    return std::nullopt;
  };
  const auto p = pole(a), q = pole(b);
  if (p && q && abs(dot(difference(*p, *q), turn.way)) <= kMargin * kRounded * size) return Coaxial::other;
  return Coaxial::apart;
}

/// How far one axis is from the other, within a size.
Upward between_axes(const Axis& a, const Axis& b, Upward size) {
  return length(cross(a.way, b.way)) * size + length(cross(difference(b.center, a.center), a.way));
}

Point2 slope(const Point2& p, const Point2& q, double from, double to) {
  const Interval step = Interval(to) - Interval(from);
  return {(q[0] - p[0]) / step, (q[1] - p[1]) / step};
}

/// The slopes of the chords of the next cells of the patch in the column; `shortest` gets the length of one that
/// is shorter.
void find_beyond(const std::vector<Piece>& all, const Sides& sides, std::size_t side, Meridian& result,
                 Upward& shortest) {
  const Piece& piece = *result.piece;
  for (const auto& [number, bits] : piece.neighbours) {
    const Piece& next = all[number];
    for (std::size_t k = 0; k < 2; ++k) {
      const bool whole = (bits >> sides.corners[0][k] & 1u) != 0 && (bits >> sides.corners[1][k] & 1u) != 0;
      if (!whole || !next.column) continue;
      const std::uint32_t corner = piece.points[sides.corners[side][k]];
      const Sides of(next);
      for (const auto& ends : of.corners) {
        const std::size_t near = ends[1 - k], far = ends[k];
        if (next.points[near] != corner) continue;
        const Point2 end = result.plane.at(next.corners[far]);
        shortest = std::min(shortest, length_of({end[0] - result.corners[k][0], end[1] - result.corners[k][1]}));
        result.beyond[k] = slope(result.corners[k], end, next.at[near][result.along], next.at[far][result.along]);
      }
    }
  }
}

/// Nothing if the cell is not in the half-plane, or so short that its directions are rounded.
std::optional<Meridian> meridian(const std::vector<Piece>& all, const Piece& piece, const Sides& sides,
                                 std::size_t side, const HalfPlane& plane, Upward size, Upward between_axes) {
  Meridian result{&piece, plane, 1 - sides.around};
  const auto &ends = sides.corners[side], &others = sides.corners[1 - side];
  const Interval3 across = thin(cross(plane.axis.way, plane.away));
  const auto beside = [&](const Interval3& p) {
    const Interval off = dot(across, difference(p, thin(plane.axis.center)));
    return Upward(std::max(off.sup(), -off.inf()));
  };
  result.angle = piece.at[ends[0]][sides.around];
  for (std::size_t k = 0; k < 2; ++k) {
    result.range[k] = piece.at[ends[k]][result.along];
    result.corners[k] = plane.at(piece.corners[ends[k]]);
    // In the other half-plane it is where it is in this one.
    const auto [off, high] = off_axis(piece.corners[others[k]], plane.axis);
    result.rounded = std::max(
        {result.rounded, beside(piece.corners[ends[k]]), beside(result.jet(Interval(result.range[k])).point),
         length_of(length(off) - middle_of(result.corners[k][0]), high - middle_of(result.corners[k][1]))});
  }
  if (!(result.rounded <= kRounded * size)) return std::nullopt;
  result.rounded = result.rounded + kOfOwn * size + between_axes;
  result.chord = slope(result.corners[0], result.corners[1], result.range[0], result.range[1]);
  Upward shortest = length_of(result.chord) * (Upward(result.range[1]) - result.range[0]);
  find_beyond(all, sides, side, result, shortest);
  if (!(shortest > kLeastLength * size)) return std::nullopt;
  result.turned = kMargin * result.rounded / shortest;
  return result;
}

}  // namespace

Coaxial ask_coaxial(const std::vector<Piece>& all, const Piece& a, const Piece& b, Between between) {
  for (const Piece* const one : {&a, &b}) {
    if (one->kind != Piece::Kind::cell || !one->column || !one->foreign.empty()) return Coaxial::other;
  }
  const Axis turn(*a.surface->revolution()), other_turn(*b.surface->revolution());
  const Upward size = std::max(size_of_corners(a), size_of_corners(b));
  const Upward off = between_axes(turn, other_turn, size);
  if (!(off <= 2 * kRounded * size)) return Coaxial::other;
  const Sides of_a(a), of_b(b);
  const auto ways = ways_off(turn, a, of_a), others = ways_off(turn, b, of_b);
  if (!(length(difference(ways[1], ways[0])) > kLeastLength * size) ||
      !(length(difference(others[1], others[0])) > kLeastLength * size))
    return Coaxial::other;
  const Upward most = kRounded * size;
  const auto same = [&](const Guess3& x, const Guess3& y) {
    return dot(x, y) > 0 && length(cross(x, y)) <= most * std::max(length(x), length(y));
  };
  std::size_t count = 0, i = 0, j = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (same(ways[k / 2], others[k % 2]) && count++ == 0) i = k / 2, j = k % 2;
  }
  if (count < 2 && (count == 0 ? overlap(turn, ways, others) : ahead(turn, ways, i) == ahead(turn, others, j)))
    return Coaxial::other;
  if (count == 0) return ask_on_axis(turn, a, b, size);
  const auto away = direction(ways[i]);
  if (!away) return Coaxial::other;
  const HalfPlane plane{turn, *away};
  const auto one = meridian(all, a, of_a, i, plane, size, off),
             other = meridian(all, b, of_b, j, plane, size, off);
  if (!one || !other) return Coaxial::other;
  return MeridianQuestion(*one, *other, between).run();
}

}  // namespace cnrg
