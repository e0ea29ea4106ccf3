// Sets of near values, axes and centres first, then what depends on them.
#include "csg/weld/round_carriers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ranges>
#include <set>
#include <tuple>

#include "csg/geometry/circle.h"
#include "csg/weld/near_sets.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"
#include "kernel/exact/trigonometry.h"
#include "kernel/refine/box_tree.h"

namespace cnrg::welding {
namespace {

template <class Value>
std::size_t digits(const Value& value) {
  return bits_of(value);
}
std::size_t digits(const AxisLine& line) { return bits_of(line.direction) + bits_of(line.foot); }

Rational distance_bound(const RationalPoint& a, const RationalPoint& b) { return root_above(dot(a - b, a - b)); }

RationalPoint on_line(const AxisLine& line, const Rational& place) { return line.foot + place * line.direction; }

Rational distance_bound(const RationalPoint& p, const AxisLine& line) {
  return distance_bound(p, on_line(line, line.place_of(p)));
}

/// Where two lines meet, if they do in one point.
std::optional<RationalPoint> common_point(const AxisLine& a, const AxisLine& b) {
  const RationalPoint normal = cross(a.direction, b.direction), off = b.foot - a.foot;
  if (is_zero(normal) || dot(off, normal) != 0) return std::nullopt;
  return on_line(a, dot(cross(off, b.direction), normal) / dot(normal, normal));
}

/// Of each value the one that its set takes.
template <class Value>
std::vector<Value> agreed(const std::vector<Value>& values, UnionFind& sets) {
  std::vector<Index> best(values.size());
  for (Index i = 0; i < values.size(); ++i) best[i] = sets.find(i);
  for (Index i = 0; i < values.size(); ++i) {
    Index& of = best[sets.find(i)];
    const auto key = [&](Index v) { return std::make_pair(digits(values[v]), v); };
    if (key(i) < key(of)) of = i;
  }
  std::vector<Value> result;
  for (Index i = 0; i < values.size(); ++i) result.push_back(values[best[sets.find(i)]]);
  return result;
}

template <class Value>
Index number_in(const std::vector<Value>& sorted, const Value& value) {
  return static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}
class RoundWelder {
 public:
  RoundWelder(const std::vector<RoundPart>& parts, const Rational& d) : parts_(parts), d_(d) {}

  RoundWeld run() {
    result_.parts.resize(parts_.size());
    find_near();
    join_axes();
    join_centers();
    join_numbers();
    for (Index i = 0; i < parts_.size(); ++i) {
      if (result_.parts[i].moved > d_) keep(i);
    }
    std::sort(result_.left.begin(), result_.left.end());
    return std::move(result_);
  }

 private:
  // --- pairs of parts whose boxes are within d of each other

  Box box_of(const RoundPart& part) const {
    Box box;
    std::vector<RationalPoint> points{part.center};
    if (!part.ball) points = {on_line(part.axis, part.ends[0]), on_line(part.axis, part.ends[1])};
    for (const RationalPoint& p : points) box.extend(to_doubles(p), to_doubles(p));
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) size = std::max({size, std::abs(box.lo[k]), std::abs(box.hi[k])});
    return grown(box, rounded_up(part.reach) + rounded_up(d_) + 1e-12 * size);
  }

  void find_near() {
    std::vector<Box> boxes;
    for (const RoundPart& part : parts_) boxes.push_back(box_of(part));
    const BoxTree tree(boxes);
    for (Index a = 0; a < parts_.size(); ++a) {
      tree.query([&](const Box& box) { return box.meets(boxes[a]); },
                 [&](Index b) {
                   if (a < b) near_.push_back({a, b});
                 });
    }
    std::sort(near_.begin(), near_.end());
  }

  // --- axes

  struct Line {
    AxisLine line;
    std::array<Rational, 2> ends;
    Rational reach = 0;
  };

  /// How far the surfaces about an axis go at most when they are put on another one: each point of the axis to the
  /// nearest one, and circles with it.
  static Rational apart(const Line& a, const AxisLine& b) {
    Rational most = 0;
    for (const Rational& end : a.ends) most = std::max(most, distance_bound(on_line(a.line, end), b));
    const RationalPoint normal = cross(a.line.direction, b.direction);
    const Rational lengths = dot(a.line.direction, a.line.direction) * dot(b.direction, b.direction);
    // The chord of the angle is less than 3/2 of its sine, up to a right angle.
    return most + fraction(3, 2) * a.reach * root_above(dot(normal, normal) / lengths);
  }
  static Rational apart(const Line& a, const Line& b) { return std::max(apart(a, b.line), apart(b, a.line)); }

  void join_axes() {
    for (const RoundPart& part : parts_) {
      if (!part.ball) axes_.push_back(part.axis);
    }
    sort_unique(axes_);
    lines_.resize(axes_.size());
    for (const RoundPart& part : parts_) {
      if (part.ball) continue;
      Line& line = lines_[number_in(axes_, part.axis)];
      const auto [low, high] = std::minmax(part.ends[0], part.ends[1]);
      const bool fresh = is_zero(line.line.direction);
      line.line = part.axis;
      line.ends = fresh ? std::array<Rational, 2>{low, high}
                        : std::array<Rational, 2>{std::min(line.ends[0], low), std::max(line.ends[1], high)};
      line.reach = std::max(line.reach, part.reach);
    }
    std::map<Pair, Pair> parts_of;  // that are near, by the numbers of their values
    for (const auto& [i, j] : near_) {
      if (parts_[i].ball || parts_[j].ball) continue;
      Pair pair{number_in(axes_, parts_[i].axis), number_in(axes_, parts_[j].axis)};
      if (pair[0] == pair[1]) continue;
      if (pair[0] > pair[1]) std::swap(pair[0], pair[1]);
      if (roughly_apart(lines_[pair[0]], lines_[pair[1]])) continue;
      parts_of.try_emplace(pair, Pair{i, j});
    }
    std::vector<Pair> left;
    UnionFind sets = join(
        axes_.size(), std::views::keys(parts_of), d_,
        [&](Index a, Index b) { return apart(lines_[a], lines_[b]); }, left);
    for (const Pair& pair : left) result_.left.push_back(parts_of.at(pair));
    taken_axes_ = agreed(axes_, sets);
    for (Index i = 0; i < parts_.size(); ++i) {
      if (!parts_[i].ball) result_.parts[i].axis = taken_axes_[number_in(axes_, parts_[i].axis)];
    }
  }

  /// Most pairs of axes are far apart, and doubles know it.
  bool roughly_apart(const Line& a, const Line& b) const {
    const auto p = to_doubles(a.line.direction), q = to_doubles(b.line.direction);
    const double pq = dot(p, q), pp = dot(p, p), qq = dot(q, q);
    if (std::abs(pq) < 0.5 * std::sqrt(pp * qq)) return true;
    const auto at = to_doubles(on_line(a.line, a.ends[0])), foot = to_doubles(b.line.foot);
    double along = 0, square = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) along += (at[k] - foot[k]) * q[k] / qq;
    for (std::size_t k = 0; k < 3; ++k) {
      const double off = at[k] - foot[k] - along * q[k];
      square += off * off;
      size = std::max({size, std::abs(at[k]), std::abs(foot[k])});
    }
    return std::sqrt(square) > 2 * to_double(d_) + 1e-9 * size;
  }

  // --- centres of balls

  void join_centers() {
    std::vector<RationalPoint> values;
    for (const RoundPart& part : parts_) {
      if (part.ball) values.push_back(part.center);
    }
    sort_unique(values);
    std::map<Pair, Pair> parts_of;                         // that are near, by the numbers of their values
    std::vector<std::set<AxisLine>> lines(values.size());  // near a centre
    for (const auto& [i, j] : near_) {
      if (parts_[i].ball && parts_[j].ball) {
        Pair pair{number_in(values, parts_[i].center), number_in(values, parts_[j].center)};
        if (pair[0] == pair[1]) continue;
        if (pair[0] > pair[1]) std::swap(pair[0], pair[1]);
        parts_of.try_emplace(pair, Pair{i, j});
      } else if (parts_[i].ball != parts_[j].ball) {
        const RationalPoint& center = parts_[parts_[i].ball ? i : j].center;
        const AxisLine& line = result_.parts[parts_[i].ball ? j : i].axis;
        if (distance_bound(center, line) <= d_) lines[number_in(values, center)].insert(line);
      }
    }
    std::vector<Pair> left;
    UnionFind sets = join(
        values.size(), std::views::keys(parts_of), d_,
        [&](Index a, Index b) { return distance_bound(values[a], values[b]); }, left);
    for (const Pair& pair : left) result_.left.push_back(parts_of.at(pair));
    std::vector<RationalPoint> taken = agreed(values, sets);
    std::map<Index, std::vector<Index>> members;
    for (Index i = 0; i < values.size(); ++i) members[sets.find(i)].push_back(i);
    const auto lines_of = [&](const std::vector<Index>& of) {
      std::set<AxisLine> all;
      for (const Index i : of) all.insert(lines[i].begin(), lines[i].end());
      return all;
    };
    std::map<AxisLine, std::set<RationalPoint>> corners;
    for (const auto& [first, of] : members) {
      const std::set<AxisLine> all = lines_of(of);
      if (all.size() < 2) continue;
      const RationalPoint at = point_on_most(taken[first], of, values, all);
      for (const Index i : of) taken[i] = at;
      for (const AxisLine& line : all) corners[line].insert(at);
    }
    const std::map<AxisLine, AxisLine> moved = through_corners(corners);
    for (const auto& [first, of] : members) {
      const std::set<AxisLine> all = lines_of(of);
      if (all.size() != 1) continue;
      const auto it = moved.find(*all.begin());
      const RationalPoint at =
          point_on_most(taken[first], of, values, {it == moved.end() ? *all.begin() : it->second});
      for (const Index i : of) taken[i] = at;
    }
    for (Index i = 0; i < parts_.size(); ++i) {
      RoundPlace& place = result_.parts[i];
      if (parts_[i].ball) {
        place.center = taken[number_in(values, parts_[i].center)];
        place.moved = distance_bound(place.center, parts_[i].center);
        continue;
      }
      const auto it = moved.find(place.axis);
      if (it != moved.end()) place.axis = it->second;
      if (place.axis != parts_[i].axis) place.moved = apart(lines_[number_in(axes_, parts_[i].axis)], place.axis);
    }
  }

  /// Axes that meet in the centres of balls go through these: through the two that are farthest apart.
  static std::map<AxisLine, AxisLine> through_corners(const std::map<AxisLine, std::set<RationalPoint>>& corners) {
    std::map<AxisLine, AxisLine> moved;
    for (const auto& entry : corners) {
      const AxisLine& line = entry.first;
      const std::set<RationalPoint>& points = entry.second;
      if (std::all_of(points.begin(), points.end(), [&](const RationalPoint& p) { return line.holds(p); }))
        continue;
      const auto before = [&](const RationalPoint& p, const RationalPoint& q) {
        return line.place_of(p) < line.place_of(q);
      };
      const auto [first, last] = std::minmax_element(points.begin(), points.end(), before);
      moved.emplace(line, axis_line(*first, *first == *last ? line.direction : *last - *first));
    }
    return moved;
  }

  /// A point within d of all members that lies on as many of the lines as can be.
  RationalPoint point_on_most(const RationalPoint& start, const std::vector<Index>& of,
                              const std::vector<RationalPoint>& centers, const std::set<AxisLine>& lines) const {
    std::vector<RationalPoint> points{start};
    for (const AxisLine& line : lines) {
      points.push_back(on_line(line, line.place_of(start)));
      for (const AxisLine& other : lines) {
        if (const auto p = line < other ? common_point(line, other) : std::nullopt) points.push_back(*p);
      }
    }
    std::optional<std::tuple<std::size_t, Rational, RationalPoint>> best;
    for (const RationalPoint& p : points) {
      Rational farthest = 0;
      for (const Index i : of) farthest = std::max(farthest, distance_bound(p, centers[i]));
      if (farthest > d_) continue;
      const auto on = static_cast<std::size_t>(
          std::count_if(lines.begin(), lines.end(), [&](const AxisLine& line) { return line.holds(p); }));
      std::tuple key{lines.size() - on, farthest, p};
      if (!best || key < *best) best = std::move(key);
    }
    return best ? std::get<2>(*best) : start;
  }

  // --- radii and places

  /// Parts about one axis or centre that are near each other.
  bool hang_together(Index i, Index j) const {
    const RoundPlace &a = result_.parts[i], &b = result_.parts[j];
    if (parts_[i].ball && parts_[j].ball) return a.center == b.center;
    if (parts_[i].ball) return b.axis.holds(a.center);
    if (parts_[j].ball) return a.axis.holds(b.center);
    return a.axis == b.axis;
  }

  /// Joins numbers of parts that are in one set; `numbers` gives those of a part, `fixed` those that stay.
  template <class Numbers, class Take>
  void join_values(UnionFind& parts, const std::vector<std::vector<Rational>>& fixed, const Numbers& numbers,
                   const Take& take) {
    std::map<Index, std::vector<Index>> members;
    for (Index i = 0; i < parts_.size(); ++i) members[parts.find(i)].push_back(i);
    for (const auto& [first, of] : members) {
      std::map<Rational, std::set<Index>> owners;
      for (const Index i : of) {
        for (const Rational& x : numbers(i)) owners[x].insert(i);
        for (const Rational& x : fixed[i]) owners[x].insert(i);
      }
      std::vector<Rational> values;
      for (const auto& [x, its] : owners) values.push_back(x);
      std::vector<Pair> near;
      for (Index k = 1; k < values.size(); ++k) near.push_back({k - 1, k});
      std::vector<Pair> left;
      UnionFind sets = join(
          values.size(), near, d_, [&](Index a, Index b) { return Rational(abs(values[a] - values[b])); }, left);
      for (const auto& [a, b] : left) {
        const std::set<Index>&p = owners.at(values[a]), &q = owners.at(values[b]);
        const Index i = *p.begin(), j = *q.begin() != i ? *q.begin() : *q.rbegin();
        const Index k = i != j ? i : *p.rbegin();
        if (k != j) result_.left.push_back({std::min(k, j), std::max(k, j)});
      }
      std::vector<Rational> taken = agreed(values, sets);
      std::map<Index, Rational> stays;
      for (const Index i : of) {
        for (const Rational& x : fixed[i]) {
          const auto it = stays.try_emplace(sets.find(number_in(values, x)), x).first;
          it->second = std::min(it->second, x);
        }
      }
      for (Index k = 0; k < values.size(); ++k) {
        if (const auto it = stays.find(sets.find(k)); it != stays.end()) taken[k] = it->second;
      }
      for (const Index i : of) {
        for (const Rational& x : numbers(i)) take(i, x, taken[number_in(values, x)]);
      }
    }
  }

  void join_numbers() {
    UnionFind together(parts_.size()), about_one(parts_.size());
    for (const auto& [i, j] : near_) {
      if (!hang_together(i, j)) continue;
      together.unite(i, j);
      if (!parts_[i].ball && !parts_[j].ball) about_one.unite(i, j);
    }
    std::vector<std::vector<Rational>> by(parts_.size());  // how far each radius goes
    join_values(
        together, std::vector<std::vector<Rational>>(parts_.size()),
        [&](Index i) -> const std::vector<Rational>& { return parts_[i].radii; },
        [&](Index i, const Rational& was, const Rational& is) {
          if (result_.parts[i].radii.emplace(was, is).second) by[i].push_back(abs(is - was));
        });
    for (Index i = 0; i < parts_.size(); ++i) {
      // A point depends on one of them or, on the ring of an arc, on two.
      std::sort(by[i].rbegin(), by[i].rend());
      for (std::size_t k = 0; k < std::min<std::size_t>(2, by[i].size()); ++k) result_.parts[i].moved += by[i][k];
    }
    // Places are in units of their axis' direction; as lengths they can be compared with d.
    std::vector<std::vector<Rational>> lengths(parts_.size()), centers(parts_.size());
    std::vector<Rational> unit(parts_.size(), 1);
    for (Index i = 0; i < parts_.size(); ++i) {
      if (parts_[i].ball || parts_[i].places.empty()) continue;
      const AxisLine& axis = result_.parts[i].axis;
      unit[i] = root_above(dot(axis.direction, axis.direction));
      for (const Rational& place : parts_[i].places)
        lengths[i].push_back(unit[i] * axis.place_of(on_line(parts_[i].axis, place)));
    }
    for (const auto& [i, j] : near_) {
      if (parts_[i].ball == parts_[j].ball || !hang_together(i, j)) continue;
      const auto [ball, other] = parts_[i].ball ? std::pair(i, j) : std::pair(j, i);
      centers[other].push_back(unit[other] * result_.parts[other].axis.place_of(result_.parts[ball].center));
    }
    std::vector<Rational> most(parts_.size(), 0);
    std::vector<std::map<Rational, Rational>> taken(parts_.size());
    join_values(
        about_one, centers, [&](Index i) -> const std::vector<Rational>& { return lengths[i]; },
        [&](Index i, const Rational& was, const Rational& is) {
          taken[i].emplace(was, is);
          most[i] = std::max(most[i], Rational(abs(is - was)));
        });
    for (Index i = 0; i < parts_.size(); ++i) {
      for (std::size_t k = 0; k < lengths[i].size(); ++k)
        result_.parts[i].places.emplace(parts_[i].places[k], taken[i].at(lengths[i][k]) / unit[i]);
      result_.parts[i].moved += most[i];
    }
  }

  /// What all moves together would carry too far stays where it is.
  void keep(Index i) {
    RoundPlace& place = result_.parts[i];
    place = {parts_[i].center, parts_[i].axis, {}, {}, 0};
    for (const Rational& x : parts_[i].radii) place.radii.emplace(x, x);
    for (const Rational& x : parts_[i].places) place.places.emplace(x, x);
    result_.left.push_back({i, i});
  }

  const std::vector<RoundPart>& parts_;
  const Rational& d_;
  std::vector<Pair> near_;
  std::vector<AxisLine> axes_;        // different ones, ascending
  std::vector<Line> lines_;           // what is about these
  std::vector<AxisLine> taken_axes_;  // what these become
  RoundWeld result_;
};

}  // namespace

Rational root_above(const Rational& square) {
  if (square == 0) return 0;
  if (const std::optional<Rational> root = rational_root(square)) return *root;
  return round_cosine(0, square, exponent_of_root(square) - 40) * (1 + fraction(1, std::int64_t{1} << 36));
}

RoundWeld weld_round(const std::vector<RoundPart>& parts, const Rational& d) {
  return RoundWelder(parts, d).run();
}

}  // namespace cnrg::welding
