// Vertex neighbourhoods (mantyla1988, section 15.6). On a small sphere about a contact each boundary is a closed
// curve: edges are its points, sectors of faces its arcs, wide sectors bisected. Where the curves cross is decided
// from the arcs next to each point that they share: a part of an arc on the other curve (an on-sector) goes to the
// side of the book's table, a point between an IN and an OUT arc (an on-edge) to a side that depends on the
// operation alone, or to the side of an on-sector next to it. So both ends of an edge are decided alike.
//
// Without the departure `arcs`: sector_pairs.cpp.
#include <algorithm>
#include <utility>

#include "bench/baseline/sectors.h"

namespace cnrg::bench::mantyla {
namespace {

template <class N>
void check_class(const Scene<N>& scene, bool holds, const char* what) {
  check(scene.departures, holds, Stage::classification, what);
}

/// Half of the curve at a point of it: the direction to the end of the arc, and its plane.
template <class N>
struct Half {
  Vec<N> end, normal;
};

/// A point that two neighbourhoods share. On each it is the `to` of a sector, or inside of a sector.
template <class N>
struct Meeting {
  Vec<N> direction;
  std::array<std::size_t, 2> sector;
  std::array<bool, 2> at_edge;
};

template <class N>
class VertexVertexClassifier {
 public:
  VertexVertexClassifier(const Scene<N>& scene, const VertexVertex& pair)
      : scene_(scene),
        metric_(scene.metric),
        sectors_{neighbourhood(scene, pair.a), neighbourhood(scene, pair.b)} {
    crossing_.vertices = {pair.a, pair.b};
    crossing_.point = scene.point(pair.a);
  }

  Crossing<N> run() {
    find_meetings();
    for (const Meeting<N>& meeting : meetings_) classify(meeting);
    for (int solid = 0; solid < 2; ++solid)
      crossing_.stars[solid] = star_of(sectors_[solid], places_[solid], crossing_.rays);
    return std::move(crossing_);
  }

 private:
  /// The sector test: all points that the curves share, those of whole common arcs by their ends.
  void find_meetings() {
    const auto& [a, b] = sectors_;
    std::vector<bool> met_a(a.size(), false), met_b(b.size(), false);
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j)
        if (!met_a[i] && !met_b[j] && same_direction(metric_, a[i].to, b[j].to)) {
          met_a[i] = met_b[j] = true;
          meetings_.push_back({a[i].to, {i, j}, {true, true}});
        }
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) {
        if (!met_a[i] && strictly_within(metric_, a[i].to, b[j])) {
          met_a[i] = true;
          meetings_.push_back({a[i].to, {i, j}, {true, false}});
        }
        if (!met_b[j] && strictly_within(metric_, b[j].to, a[i])) {
          met_b[j] = true;
          meetings_.push_back({b[j].to, {i, j}, {false, true}});
        }
      }
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) {
        const Vec<N> line = cross(a[i].normal, b[j].normal);
        if (metric_.null_unit(line)) continue;
        for (const int turned : {1, -1}) {
          const Vec<N> p = Metric<N>::direction(line * N(turned));
          if (strictly_within(metric_, p, a[i]) && strictly_within(metric_, p, b[j]))
            meetings_.push_back({p, {i, j}, {false, false}});
        }
      }
  }

  std::array<Half<N>, 2> halves(const Meeting<N>& meeting, int solid) const {
    const auto& sectors = sectors_[solid];
    const std::size_t i = meeting.sector[solid];
    const std::size_t after = meeting.at_edge[solid] ? (i + 1) % sectors.size() : i;
    return {Half<N>{sectors[i].from, sectors[i].normal}, Half<N>{sectors[after].to, sectors[after].normal}};
  }

  /// The side of one half of a curve against the other curve at their common point p.
  std::pair<Side, bool> side(int solid, const Vec<N>& p, const Half<N>& half,
                             const std::array<Half<N>, 2>& other) const {
    std::array<int, 2> above;
    for (int k = 0; k < 2; ++k) {
      above[k] = metric_.unit_sign(dot(other[k].normal, half.end));
      if (above[k] == 0 && dot(cross(p, half.end), cross(p, other[k].end)) > 0)
        return {scene_.coplanar_side(solid, dot(half.normal, other[k].normal) > 0), true};
    }
    const int reflex = metric_.unit_sign(dot(other[0].normal, other[1].end));
    check_class(scene_, above[0] != 0 || above[1] != 0, "a sector is on the other boundary and is not");
    const bool out = reflex > 0 ? above[0] >= 0 && above[1] >= 0 : above[0] > 0 || above[1] > 0;
    return {out ? Side::out : Side::in, false};
  }

  void classify(const Meeting<N>& meeting) {
    const std::array<std::array<Half<N>, 2>, 2> both = {halves(meeting, 0), halves(meeting, 1)};
    std::array<bool, 2> crosses;
    std::array<bool, 2> enters;
    std::array<Place, 2> places;
    for (int solid = 0; solid < 2; ++solid) {
      const auto [before, before_on] = side(solid, meeting.direction, both[solid][0], both[1 - solid]);
      const auto [after, after_on] = side(solid, meeting.direction, both[solid][1], both[1 - solid]);
      crosses[solid] = before != after;
      enters[solid] = after == Side::in;
      places[solid] = {meeting.sector[solid], Within::inside};
      if (!crosses[solid] || !meeting.at_edge[solid]) continue;
      check_class(scene_, !before_on || !after_on, "an edge between two coplanar sectors of different sides");
      const Side free = meeting.at_edge[1 - solid] ? scene_.edge_side(solid) : scene_.edge_in_sector(solid);
      const Side edge = before_on ? before : after_on ? after : free;
      if (edge == before) places[solid] = {(meeting.sector[solid] + 1) % sectors_[solid].size(), Within::start};
      else places[solid].within = Within::end;
    }
    check_class(scene_, crosses[0] == crosses[1], "one neighbourhood crosses the other, which does not cross it");
    if (!crosses[0]) return;
    check_class(scene_, enters[0] != enters[1], "both neighbourhoods enter each other in one direction");
    for (int solid = 0; solid < 2; ++solid) places_[solid].push_back(places[solid]);
    crossing_.rays.push_back({meeting.direction, enters[0]});
  }

  const Scene<N>& scene_;
  const Metric<N>& metric_;
  std::array<std::vector<Sector<N>>, 2> sectors_;
  std::vector<Meeting<N>> meetings_;
  std::array<std::vector<Place>, 2> places_;  // of rays
  Crossing<N> crossing_;
};

/// Rays of a point inside of a face, clockwise.
template <class N>
std::vector<StarItem> flat_star(const Vec<N>& normal, const std::vector<Ray<N>>& rays) {
  const Vec<N>& first = rays.front().direction;
  const auto quarter = [&](const Vec<N>& d) {
    const N turn = dot(normal, cross(d, first));
    return turn > 0 ? 1 : turn < 0 ? 3 : dot(d, first) > 0 ? 0 : 2;
  };
  std::vector<StarItem> star;
  for (std::uint32_t r = 0; r < rays.size(); ++r) star.push_back({kNo<HalfEdgeId>, r});
  std::stable_sort(star.begin(), star.end(), [&](const StarItem& s, const StarItem& t) {
    const Vec<N>&p = rays[s.ray].direction, &q = rays[t.ray].direction;
    const int a = quarter(p), b = quarter(q);
    return a != b ? a < b : dot(normal, cross(q, p)) > 0;
  });
  return star;
}

/// A vertex inside of a face: only the face's plane matters.
template <class N>
Crossing<N> classify_vertex_face(const Scene<N>& scene, const VertexFace& contact) {
  const Metric<N>& metric = scene.metric;
  const Vec<N>& normal = scene.plane(contact.face).normal;
  const auto solid = static_cast<int>(contact.solid);
  const std::vector<Sector<N>> sectors = neighbourhood(scene, contact.vertex);
  const std::size_t count = sectors.size();
  const auto before = [&](std::size_t k) { return (k + count - 1) % count; };
  std::vector<N> heights;  // of the `to` of each sector
  std::vector<Side> sides;
  for (const Sector<N>& s : sectors) {
    heights.push_back(dot(normal, s.to));
    const int sign = metric.unit_sign(heights.back());
    sides.push_back(sign > 0 ? Side::out : sign < 0 ? Side::in : Side::on);
    if (sign == 0) heights.back() = 0;
  }
  const std::vector<Side> found = sides;
  for (std::size_t k = 0; k < count; ++k)
    if (found[k] == Side::on && found[before(k)] == Side::on && metric.null_unit(cross(sectors[k].normal, normal)))
      sides[k] = sides[before(k)] = scene.coplanar_side(solid, dot(sectors[k].normal, normal) > 0);
  const std::vector<Side> with_sectors = sides;
  for (std::size_t k = 0; k < count; ++k) {
    if (with_sectors[k] != Side::on) continue;
    const Side left = with_sectors[before(k)], right = with_sectors[(k + 1) % count];
    check_class(scene, left != Side::on && right != Side::on,
                "a sector with both edges on a face whose plane it leaves");
    const bool in_left = left == Side::in, in_right = right == Side::in;  // on: as if OUT
    sides[k] = in_left == in_right ? (in_left ? Side::in : Side::out) : scene.edge_in_face(solid);
  }
  Crossing<N> crossing;
  crossing.vertices[contact.solid] = contact.vertex;
  crossing.face = contact.face;
  crossing.point = scene.point(contact.vertex);
  auto& star = crossing.stars[contact.solid];
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t j = before(k);
    if (sides[j] != sides[k]) {
      const N hj = heights[j] < 0 ? N(-heights[j]) : heights[j], hk = heights[k] < 0 ? N(-heights[k]) : heights[k];
      check_class(scene, hj != 0 || hk != 0, "two edges on a face that are on different sides");
      const Vec<N> direction = Metric<N>::direction(sectors[j].to * hk + sectors[k].to * hj);
      star.push_back({kNo<HalfEdgeId>, static_cast<std::uint32_t>(crossing.rays.size())});
      crossing.rays.push_back({direction, (sides[k] == Side::in) == (solid == 0)});
    }
    if (sectors[k].half_edge != kNo<HalfEdgeId>) star.push_back({sectors[k].half_edge, 0});
  }
  if (!crossing.rays.empty()) crossing.stars[1 - solid] = flat_star(normal, crossing.rays);
  return crossing;
}

/// Forward and backward rays take turns about a contact.
template <class N>
void check_turns(const Scene<N>& scene, const Crossing<N>& crossing) {
  for (const auto& star : crossing.stars) {
    std::vector<bool> forward;
    for (const StarItem& item : star)
      if (item.half_edge == kNo<HalfEdgeId>) forward.push_back(crossing.rays[item.ray].forward);
    for (std::size_t k = 0; k < forward.size(); ++k)
      check_class(scene, forward[k] != forward[(k + 1) % forward.size()],
                  "a boundary enters the other twice in a row");
  }
}

}  // namespace

template <class N>
std::vector<Sector<N>> neighbourhood(const Scene<N>& scene, VertexId vertex) {
  const Topology& topology = scene.topology;
  const std::vector<HalfEdgeId> star = topology.star(vertex);
  const auto towards = [&](HalfEdgeId h) {
    return Metric<N>::direction(scene.point(topology.target(h)) - scene.point(vertex));
  };
  std::vector<Sector<N>> sectors;
  for (std::size_t k = 0; k < star.size(); ++k) {
    const HalfEdgeId h = star[k];
    Sector<N> sector{towards(star[(k + star.size() - 1) % star.size()]), towards(h),
                     scene.plane(topology.face(h)).normal, h};
    const int width = scene.metric.unit_sign(dot(sector.normal, cross(sector.to, sector.from)));
    if (width <= 0) {
      check_class(scene, width < 0 || dot(sector.to, sector.from) <= 0, "a corner without an angle");
      const Vec<N> middle =
          Metric<N>::direction(width == 0 ? cross(sector.normal, sector.to) : (sector.from + sector.to) * N(-1));
      sectors.push_back({sector.from, middle, sector.normal, kNo<HalfEdgeId>});
      sector.from = middle;
    }
    sectors.push_back(sector);
  }
  return sectors;
}

template <class N>
std::vector<StarItem> star_of(const std::vector<Sector<N>>& sectors, const std::vector<Place>& places,
                              const std::vector<Ray<N>>& rays) {
  std::vector<std::uint32_t> sorted(rays.size());
  for (std::uint32_t r = 0; r < sorted.size(); ++r) sorted[r] = r;
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::uint32_t r, std::uint32_t t) {
    if (places[r].sector != places[t].sector) return places[r].sector < places[t].sector;
    if (places[r].within != places[t].within) return places[r].within < places[t].within;
    if (places[r].within != Within::inside) return false;
    return dot(sectors[places[r].sector].normal, cross(rays[t].direction, rays[r].direction)) > 0;
  });
  std::vector<StarItem> star;
  auto ray = sorted.begin();
  for (std::size_t k = 0; k < sectors.size(); ++k) {
    for (; ray != sorted.end() && places[*ray].sector == k; ++ray) star.push_back({kNo<HalfEdgeId>, *ray});
    if (sectors[k].half_edge != kNo<HalfEdgeId>) star.push_back({sectors[k].half_edge, 0});
  }
  return star;
}

template <class N>
void classify(Scene<N>& scene) {
  const auto add = [&](Crossing<N> crossing) {
    if (crossing.rays.empty()) return;
    check_turns(scene, crossing);
    scene.crossings.push_back(std::move(crossing));
  };
  const auto at = [&](VertexId vertex, auto&& step) {
    staged(Stage::classification, step, [&] { return Failure::Places{exact(scene.point(vertex))}; });
  };
  for (const VertexFace& contact : scene.vertex_faces)
    at(contact.vertex, [&] { add(classify_vertex_face(scene, contact)); });
  for (const VertexVertex& pair : scene.vertex_vertices)
    at(pair.a, [&] {
      add(scene.departures.arcs ? VertexVertexClassifier<N>(scene, pair).run() : compare_pairs(scene, pair));
    });
}

template std::vector<Sector<double>> neighbourhood(const Scene<double>&, VertexId);
template std::vector<Sector<Rational>> neighbourhood(const Scene<Rational>&, VertexId);
template std::vector<StarItem> star_of(const std::vector<Sector<double>>&, const std::vector<Place>&,
                                       const std::vector<Ray<double>>&);
template std::vector<StarItem> star_of(const std::vector<Sector<Rational>>&, const std::vector<Place>&,
                                       const std::vector<Ray<Rational>>&);
template void classify(Scene<double>&);
template void classify(Scene<Rational>&);

}  // namespace cnrg::bench::mantyla
