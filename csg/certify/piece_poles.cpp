// Directions about poles; see pieces.h.
//
// Where a side of a cell is a point, u and v are no coordinates: along one of them cells turn once around the
// point. Coordinates there are (x, y) = r (c + f (d - c)), in a cell whose far corners are at c and d: r from 0 at
// the pole to 1 at the far side, f from 0 to 1 along that. F is linear in them. Derivatives of S by r, and by f
// divided by r, which is a mean of the mixed derivative, give those by x and y.
#include <map>
#include <set>

#include "csg/certify/pieces.h"

namespace cnrg {

using namespace surface_math;

namespace {

/// A cell at a pole: `from` and `to` are its far corners, by the parameter around.
struct Wedge {
  std::uint32_t piece;
  std::size_t around, away, at_pole, from, to;
};

std::optional<Wedge> wedge_of(const std::vector<Piece>& all, std::uint32_t number, std::uint32_t pole) {
  const Piece& piece = all[number];
  for (std::size_t i = 0; piece.grid && !piece.bent && !piece.blind && i < 4; ++i) {
    const std::size_t next = (i + 1) % 4, around = piece.at[i][0] != piece.at[next][0] ? 0 : 1, away = 1 - around;
    if (piece.points[i] != pole || piece.points[next] != pole) continue;
    const double at = piece.at[i][away];
    if (at != piece.range[away].inf() && at != piece.range[away].sup()) continue;  // not known as a double
    std::size_t from = (i + 2) % 4, to = (i + 3) % 4;
    if (piece.at[from][around] > piece.at[to][around]) std::swap(from, to);
    return Wedge{number, around, away, i, from, to};
  }
  return std::nullopt;
}

/// The cells at a pole, one after another around it; none if they are no such row or ring.
std::vector<Wedge> wedges_about(const std::vector<Piece>& all, std::uint32_t number, std::uint32_t pole) {
  std::map<std::uint32_t, Wedge> by_from, by_to;
  const auto add = [&](std::uint32_t i) {
    const auto wedge = wedge_of(all, i, pole);
    return wedge && by_from.try_emplace(all[i].points[wedge->from], *wedge).second &&
           by_to.try_emplace(all[i].points[wedge->to], *wedge).second;
  };
  if (!add(number)) return {};
  for (const auto& [j, bits] : all[number].neighbours) {
    bool there = false;
    for (std::size_t k = 0; k < 4; ++k) there = there || ((bits >> k & 1u) != 0 && all[number].points[k] == pole);
    if (there && !add(j)) return {};
  }
  auto it = by_from.begin();
  for (auto at = by_from.begin(); at != by_from.end(); ++at) {
    if (!by_to.contains(at->first)) it = at;
  }
  std::vector<Wedge> row;
  while (it != by_from.end() && (row.empty() || it->second.piece != row[0].piece)) {
    row.push_back(it->second);
    it = by_from.find(all[it->second.piece].points[it->second.to]);
  }
  return row.size() == by_from.size() ? row : std::vector<Wedge>{};
}

using Places = std::vector<std::array<double, 2>>;

/// All around, by shares of the parameter.
Places places_of_ring(const std::vector<Piece>& all, const std::vector<Wedge>& wedges) {
  std::vector<Upward> ends{0};
  for (const auto& [number, around, away, at_pole, from, to] : wedges)
    ends.push_back(ends.back() + (Upward(all[number].at[to][around]) - all[number].at[from][around]));
  Places places;
  for (const Upward end : ends) {
    const Interval turns(double(end / ends.back()));
    places.push_back({middle_of(cosine(turns)), middle_of(sine(turns))});
  }
  places.back() = places.front();
  return places;
}

/// One after another by the angles at the pole; none if these go all around.
Places places_of_row(const std::vector<Piece>& all, const std::vector<Wedge>& wedges) {
  Places places{{1, 0}};
  for (const auto& [number, around, away, at_pole, from, to] : wedges) {
    const Piece& piece = all[number];
    const auto way = [&, &pole = piece.corners[at_pole]](std::size_t k) {
      return middle_of(difference(piece.corners[k], pole));
    };
    const Guess3 a = way(from), b = way(to);
    const Upward c = dot(a, b), s = length(cross(a, b)), size = sqrt(c * c + s * s), x = places.back()[0],
                 y = places.back()[1];
    places.push_back({double((x * c - y * s) / size), double((x * s + y * c) / size)});
    if (y < 0 && !(places.back()[1] < 0)) return {};
  }
  return places;
}

/// Hulls of the derivatives by x and y.
struct Directions {
  std::optional<std::array<Interval3, 2>> hulls{};
  /// `by_r` along (x, y), and `by_f` along (dx, dy).
  void add(const Interval3& by_r, const Interval3& by_f, const std::array<Interval, 2>& at,
           const std::array<Interval, 2>& step) {
    const Interval one = Interval(1) / (at[0] * step[1] - at[1] * step[0]);
    const Interval3 x = scaled(one, difference(scaled(step[1], by_r), scaled(at[1], by_f))),
                    y = scaled(one, difference(scaled(at[0], by_f), scaled(step[0], by_r)));
    hulls = hulls ? std::array{hull((*hulls)[0], x), hull((*hulls)[1], y)} : std::array{x, y};
  }
};

Interval near_pole(const Piece& piece, const Wedge& wedge) {
  return hull(Interval(piece.at[wedge.at_pole][wedge.away]), Interval(middle_of(piece.range[wedge.away])));
}

/// Of each cell near the pole the hulls of derivatives by x and y, and where its sides go, one more than cells.
struct Fan {
  std::vector<std::array<Interval3, 2>> along{};
  Places places;
};
std::optional<Fan> fan_about(const std::vector<Piece>& all, const std::vector<Wedge>& wedges) {
  constexpr int kParts = 4;  // of a cell, around
  const Wedge &first = wedges.front(), &last = wedges.back();
  // Where far corners are on the circle about (0, 0): one more than wedges.
  const bool ring = all[first.piece].points[first.from] == all[last.piece].points[last.to];
  Fan fan{.places = ring ? places_of_ring(all, wedges) : places_of_row(all, wedges)};
  if (fan.places.empty()) return std::nullopt;
  for (std::size_t i = 0; i < wedges.size(); ++i) {
    const auto& [number, around, away, at_pole, from, to] = wedges[i];
    const Piece& piece = all[number];
    const auto& [place, next] = std::pair(fan.places[i], fan.places[i + 1]);
    const std::array<Interval, 2> c{place[0], place[1]}, step{Interval(next[0]) - c[0], Interval(next[1]) - c[1]};
    if (!((c[0] * step[1] - c[1] * step[0]).inf() > 0)) return std::nullopt;
    Directions found;
    found.add(difference(piece.corners[from], piece.corners[at_pole]),
              difference(piece.corners[to], piece.corners[from]), c, step);
    const Interval begin(piece.at[from][around]),
        wide = Interval(piece.at[to][around]) - begin,
        length = Interval(piece.at[from][away]) - piece.at[at_pole][away];
    std::array<Interval, 2> range;
    range[away] = near_pole(piece, wedges[i]);
    for (int k = 0; k < kParts; ++k) {
      const Interval f(double(k) / kParts, double(k + 1) / kParts);
      range[around] = begin + f * wide;
      const SurfaceJet<Interval> jet = piece.surface->over(range[0], range[1]);
      const auto twist = piece.surface->fan_over(around, piece.at[at_pole][away], range[0], range[1]);
      if (!twist) return std::nullopt;
      const Interval3 by_r = scaled(length, away == 0 ? jet.along_u : jet.along_v),
                      by_f = scaled(Interval(length * wide), *twist);
      if (!piece.column) {
        found.add(by_r, by_f, {c[0] + f * step[0], c[1] + f * step[1]}, step);
        continue;
      }
      // What H has besides, as a function of r and f, is at most chord flat r / 2 long.
      const Piece::Column& column = *piece.column;
      const Interval share = column.share(f), radians = Interval(2) * turn<Interval>() * column.half;
      const double more_by_r = (Interval(column.chord) * column.flat).sup() / 2,
                   more_by_f = (radians * (column.tangent + Interval(column.flat)) * column.chord).sup() / 2;
      found.add(widened(by_r, more_by_r), scaled(Interval(1) / column.growth(f), widened(by_f, more_by_f)),
                {c[0] + share * step[0], c[1] + share * step[1]}, step);
    }
    fan.along.push_back(*found.hulls);
  }
  return fan;
}

}  // namespace

void find_poles(std::vector<Piece>& all, std::size_t first) {
  const enclosure::RoundOutward outward;
  std::set<std::pair<std::uint32_t, std::uint32_t>> asked;  // patches and points
  for (std::uint32_t i = static_cast<std::uint32_t>(first); i < all.size(); ++i) {
    for (std::size_t k = 0; all[i].grid && k < 4; ++k) {
      const std::uint32_t point = all[i].points[k];
      if (point != all[i].points[(k + 1) % 4] || !asked.emplace(all[i].patch, point).second) continue;
      const std::vector<Wedge> wedges = wedges_about(all, i, point);
      const auto fan = wedges.empty() ? std::nullopt : fan_about(all, wedges);
      if (!fan) continue;
      std::array<Interval3, 2> along = fan->along[0];
      for (const auto& [by_x, by_y] : fan->along) along = {hull(along[0], by_x), hull(along[1], by_y)};
      for (std::size_t w = 0; w < wedges.size(); ++w) {
        Piece& piece = all[wedges[w].piece];
        piece.pole = {.away = wedges[w].away,
                      .at = piece.at[wedges[w].at_pole][wedges[w].away],
                      .near = near_pole(piece, wedges[w]),
                      .normals = cross(along[0], along[1]),
                      .along = fan->along[w],
                      .ends = {fan->places[w], fan->places[w + 1]}};
      }
    }
  }
}

}  // namespace cnrg
