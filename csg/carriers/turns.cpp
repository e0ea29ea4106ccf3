// Directions around an axis in their order, decided exactly.
#include "csg/carriers/turns.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "csg/geometry/circle.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

Rational error_of(const RationalPoint& d) { return abs(dot(d, d) - 1); }

}  // namespace

Rational within_one(const Rational& turn) {
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), turn.get_num_mpz_t(), turn.get_den_mpz_t());
  return turn - whole;
}

/// 0 for directions in [0, 180) degrees from the first vector, 1 for the others.
int Turns::half_of(const Frame& frame, const RationalPoint& d) {
  const int up = sgn(dot(d, frame.second));
  return up > 0 || (up == 0 && dot(d, frame.first) > 0) ? 0 : 1;
}

/// Negative if a comes before b.
int Turns::compare(const Frame& frame, const RationalPoint& a, const RationalPoint& b) {
  const int half_a = half_of(frame, a), half_b = half_of(frame, b);
  return half_a != half_b ? half_a - half_b : -sgn(dot(cross(a, b), frame.axis));
}

Turns::Turns(const RationalPoint& axis, const RationalPoint& start, int segments,
             const std::vector<RationalPoint>& marks, const std::vector<RationalPoint>& others,
             const std::set<RationalPoint>& lines)
    : frame_{start, cross(axis, start), axis} {
  const Rational across = 1 / dot(axis, axis);  // the second vector is as long as the axis
  lines_.reserve(static_cast<std::size_t>(segments) + marks.size());
  for (int i = 0; i < segments; ++i) {
    const Rational degrees = fraction(std::int64_t{360} * i, segments);
    const RationalPoint direction =
        scaled_cosine(degrees, 1) * frame_.first + scaled_cosine(90 - degrees, across) * frame_.second;
    lines_.push_back({direction, fraction(i, segments), true, false});
  }
  const double near = 0x1p-32 / segments;
  std::set<double> taken;
  const auto is_taken = [&](double turn) {
    const auto next = taken.lower_bound(turn - near);
    if (next != taken.end() && *next <= turn + near) return true;
    return !taken.empty() && (*taken.begin() + 1 - turn <= near || turn + 1 - *taken.rbegin() <= near);
  };
  for (const RationalPoint& d : marks) {
    const double turn = to_double(turn_of(d));
    taken.insert(turn);
    lines_.push_back({d, from_double(turn), false, true});
  }
  for (const RationalPoint& d : others) {
    const double turn = to_double(turn_of(d));
    if (is_taken(turn)) continue;
    taken.insert(turn);
    lines_.push_back({d, from_double(turn), false, false});
  }
  std::sort(lines_.begin(), lines_.end(), [&](const Line& a, const Line& b) {
    const int order = compare(frame_, a.direction, b.direction);
    if (order != 0) return order < 0;
    if (const Rational x = error_of(a.direction), y = error_of(b.direction); x != y) return x < y;
    return a.direction != b.direction ? a.direction < b.direction : a.even > b.even;
  });
  std::vector<Line> kept;
  for (std::size_t i = 0; i < lines_.size();) {
    // Those of one ray: the best direction, and the exact turn if one of them has it. An even step gives way to
    // one that others have, however near to a unit vector: they have its very point.
    Line line = lines_[i];
    bool fixed = !line.even, is_mark = line.mark;
    for (++i; i < lines_.size() && compare(frame_, line.direction, lines_[i].direction) == 0; ++i) {
      fixed = fixed || !lines_[i].even;
      is_mark = is_mark || lines_[i].mark;
      if (line.even && !line.mark && !lines_[i].even && !lines_[i].mark) line.direction = lines_[i].direction;
      if (!lines_[i].even || line.even) continue;
      line.turn = lines_[i].turn;
      line.even = true;
    }
    if (!fixed && is_taken(to_double(line.turn))) continue;
    line.mark = is_mark;
    kept.push_back(line);
  }
  lines_ = std::move(kept);
  add_lines(lines);
}

void Turns::add_lines(const std::set<RationalPoint>& lines) {
  if (lines.empty()) return;
  constexpr double kNear = 1e-12;
  std::set<double> taken;
  for (const Line& line : lines_) taken.insert(to_double(line.turn));
  for (const RationalPoint& d : lines) {
    const double turn = to_double(turn_of(d));
    const auto next = taken.lower_bound(turn - kNear);
    if ((next != taken.end() && *next <= turn + kNear) || *taken.begin() + 1 - turn <= kNear ||
        turn + 1 - *taken.rbegin() <= kNear)
      continue;
    taken.insert(turn);
    lines_.push_back({d, from_double(turn), false, false});
  }
  std::sort(lines_.begin(), lines_.end(),
            [&](const Line& a, const Line& b) { return compare(frame_, a.direction, b.direction) < 0; });
}

const Turns::Line* Turns::find(const RationalPoint& direction) const {
  const auto place = std::lower_bound(
      lines_.begin(), lines_.end(), direction,
      [&](const Line& line, const RationalPoint& d) { return compare(frame_, line.direction, d) < 0; });
  return place != lines_.end() && compare(frame_, place->direction, direction) == 0 ? &*place : nullptr;
}

std::vector<RationalPoint> Turns::directions(bool only_marks) const {
  std::vector<RationalPoint> result;
  result.reserve(lines_.size());
  for (const Line& line : lines_) {
    if (line.mark || !only_marks) result.push_back(line.direction);
  }
  return result;
}

std::array<RationalPoint, 2> Turns::beside(const RationalPoint& direction) const {
  const Line* const line = find(direction);
  require(line != nullptr, "the direction of a contact is a line of its family");
  const auto place = static_cast<std::size_t>(line - lines_.data());
  const std::size_t n = lines_.size();
  return {lines_[(place + n - 1) % n].direction, lines_[(place + 1) % n].direction};
}

Rational Turns::turn_of(const RationalPoint& d) const {
  const double x = to_double(dot(d, frame_.first)) / std::sqrt(to_double(dot(frame_.first, frame_.first)));
  const double y = to_double(dot(d, frame_.second)) / std::sqrt(to_double(dot(frame_.second, frame_.second)));
  return within_one(from_double(rounded::arc_tangent(y, x) / (2 * std::numbers::pi)));
}

std::vector<RevolvedGrid::Column> Turns::around(const Lie& lie) const {
  const Line* const known = find(lie.start);
  const Rational start = known != nullptr ? known->turn : turn_of(lie.start);
  std::vector<RevolvedGrid::Column> columns;
  for (const Line& line : lines_) {
    const bool with = lie.along != lie.mirrored;  // the leaf turns with these
    columns.push_back({line.direction, within_one(with ? line.turn - start : start - line.turn), line.mark});
  }
  if (!lie.along) std::reverse(columns.begin(), columns.end());
  // Counter-clockwise about the leaf's own axis turns grow, but where they begin anew (mirrored: they fall).
  const auto least = std::min_element(columns.begin(), columns.end(),
                                      [](const auto& a, const auto& b) { return a.turn < b.turn; });
  std::rotate(columns.begin(), least, columns.end());
  columns.push_back(columns.front());
  (lie.mirrored ? columns.front() : columns.back()).turn += 1;
  return columns;
}

std::vector<RevolvedGrid::Column> Turns::part(const Lie& lie, const RationalPoint& end,
                                              const Rational& degrees) const {
  const Line *const first = find(lie.start), *const last = find(end);
  require(first != nullptr && last != nullptr, "the ends of a part of a turn are lines of it");
  std::vector<RevolvedGrid::Column> columns = around(lie);
  const Rational whole = degrees / 360;
  if (lie.mirrored) std::reverse(columns.begin(), columns.end());  // now turns grow
  std::vector<RevolvedGrid::Column> result{{first->direction, 0, true}};
  for (const RevolvedGrid::Column& column : columns) {
    if (column.direction == first->direction || column.direction == last->direction) continue;
    if (column.turn > 0 && column.turn < whole)
      result.push_back({column.direction, column.turn / whole, column.mark});
  }
  result.push_back({last->direction, 1, true});
  if (lie.mirrored) std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace cnrg
