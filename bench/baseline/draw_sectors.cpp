// Neighbourhoods of contacts as small triangles, each called after the side that the classification gave it.
//
// A star is a clockwise list of half-edges and crossings. Between two crossings all sectors are on one side of the
// other solid: which one, a crossing says. A sector in the plane of one of the other solid is on it, and was
// counted as one of the sides.
#include <algorithm>
#include <map>

#include "bench/baseline/draw.h"
#include "bench/baseline/sectors.h"

namespace cnrg::bench::mantyla {
namespace {

/// A direction of a neighbourhood, clockwise after the one before; behind a crossing there is another side.
template <class N>
struct Spoke {
  Vec<N> direction;
  const Ray<N>* ray = nullptr;
  std::size_t sector = 0;  ///< what lies before it
};

template <class N>
class SectorDrawer {
 public:
  SectorDrawer(const Scene<N>& scene, Drawings& drawings, int solid)
      : scene_(scene), drawings_(drawings), solid_(solid) {}

  /// `mine`: the vertex of this solid; `others`: the sectors of the other one, or its face alone.
  void draw(VertexId mine, const std::vector<Sector<N>>& others, const Crossing<N>* crossing) {
    const std::vector<Sector<N>> sectors = neighbourhood(scene_, mine);
    std::vector<Spoke<N>> spokes;
    std::size_t next = 0;  // of the star
    const std::vector<StarItem> star = crossing ? crossing->stars[solid_] : std::vector<StarItem>();
    for (std::size_t k = 0; k < sectors.size(); ++k) {
      std::vector<Spoke<N>> within = edges_within(sectors[k], others, k);
      for (; next < star.size() && star[next].half_edge == kNo<HalfEdgeId>; ++next) {
        const Ray<N>& ray = crossing->rays[star[next].ray];
        const bool later = sectors[k].half_edge == kNo<HalfEdgeId> && !in_sector(ray.direction, sectors[k]);
        if (later) break;
        within.push_back({ray.direction, &ray, k});
      }
      sort_clockwise(within, sectors[k]);
      spokes.insert(spokes.end(), within.begin(), within.end());
      spokes.push_back({sectors[k].to, nullptr, k});
      if (sectors[k].half_edge != kNo<HalfEdgeId> && next < star.size()) ++next;
    }
    fan(scene_.point(mine), radius(mine), sectors, spokes, others);
  }

  /// The face about a vertex of the other solid in it.
  void draw_flat(const Crossing<N>& crossing, const Sector<N>& face, const std::vector<Sector<N>>& others,
                 double radius) {
    std::vector<Spoke<N>> given, spokes;
    for (const Ray<N>& ray : crossing.rays) given.push_back({ray.direction, &ray, 0});
    for (const Sector<N>& other : others)
      if (scene_.metric.unit_sign(dot(other.to, face.normal)) == 0) given.push_back({other.to, nullptr, 0});
    sort_about(given, face.normal);
    for (std::size_t k = 0; k < given.size(); ++k) {
      const Vec<N>& here = given[k].direction;
      spokes.push_back(given[k]);
      Vec<N> turned = here;
      const Vec<N>& after = given[(k + 1) % given.size()].direction;
      for (int n = given.size() == 1 ? 3 : quarters_before(here, after, face.normal); n > 0; --n) {
        turned = cross(turned, face.normal);
        spokes.push_back({Metric<N>::direction(turned), nullptr, 0});
      }
    }
    fan(crossing.point, radius, {face}, spokes, others);
  }

  /// Of the triangles of a contact.
  double radius(VertexId vertex) const {
    double shortest = 0;
    for (const HalfEdgeId h : scene_.topology.star(vertex)) {
      const double length = distance(scene_.point(scene_.topology.target(h)), scene_.point(vertex));
      if (shortest == 0 || length < shortest) shortest = length;
    }
    return 0.3 * shortest;
  }

 private:
  bool in_sector(const Vec<N>& p, const Sector<N>& s) const {
    return same_direction(scene_.metric, p, s.from) || same_direction(scene_.metric, p, s.to) ||
           strictly_within(scene_.metric, p, s);
  }

  /// Whole quarters of a turn, clockwise, strictly between two directions in a plane; 0 where they are one.
  static int quarters_before(const Vec<N>& from, const Vec<N>& to, const Vec<N>& normal) {
    const N turn = dot(normal, cross(to, from)), along = dot(to, from);
    if (turn == 0) return along > 0 ? 0 : 1;
    if (turn > 0) return along < 0 ? 1 : 0;
    return along > 0 ? 3 : 2;
  }

  /// Edges of the other solid inside of a sector that lies in one of its sectors' plane.
  std::vector<Spoke<N>> edges_within(const Sector<N>& sector, const std::vector<Sector<N>>& others,
                                     std::size_t k) const {
    std::vector<Spoke<N>> within;
    for (const Sector<N>& other : others)
      if (other.half_edge != kNo<HalfEdgeId> && strictly_within(scene_.metric, other.to, sector))
        within.push_back({other.to, nullptr, k});
    return within;
  }

  static void sort_clockwise(std::vector<Spoke<N>>& spokes, const Sector<N>& sector) {
    std::stable_sort(spokes.begin(), spokes.end(), [&](const Spoke<N>& s, const Spoke<N>& t) {
      return dot(sector.normal, cross(t.direction, s.direction)) > 0;
    });
  }

  /// Clockwise from the first one; of equal directions a crossing comes last, for behind it is another side.
  static void sort_about(std::vector<Spoke<N>>& spokes, const Vec<N>& normal) {
    const Vec<N> first = spokes.front().direction;
    const auto half = [&](const Vec<N>& d) {
      const N turn = dot(normal, cross(d, first));
      return turn > 0 || (turn == 0 && dot(d, first) > 0) ? 0 : 1;
    };
    std::stable_sort(spokes.begin(), spokes.end(), [&](const Spoke<N>& s, const Spoke<N>& t) {
      const int a = half(s.direction), b = half(t.direction);
      if (a != b) return a < b;
      return dot(normal, cross(t.direction, s.direction)) > 0;
    });
  }

  std::string side_after(const Ray<N>* ray) const {
    if (!ray) return "no crossing here";
    return ray->forward == (solid_ == 0) ? "in" : "out";
  }

  /// Whether a sector of the other solid has the direction, in the same plane.
  bool is_on(const Vec<N>& direction, const Vec<N>& normal, const std::vector<Sector<N>>& others) const {
    return std::any_of(others.begin(), others.end(), [&](const Sector<N>& s) {
      if (!scene_.metric.null_unit(cross(s.normal, normal))) return false;
      const bool flat = scene_.metric.null_unit(s.from) && scene_.metric.null_unit(s.to);  // a whole face
      return flat || strictly_within(scene_.metric, direction, s);
    });
  }

  void fan(const Vec<N>& at, double radius, const std::vector<Sector<N>>& sectors,
           const std::vector<Spoke<N>>& spokes, const std::vector<Sector<N>>& others) {
    const Ray<N>* last = nullptr;
    for (const Spoke<N>& spoke : spokes)
      if (spoke.ray) last = spoke.ray;
    for (std::size_t k = 0; k < spokes.size(); ++k) {
      const Spoke<N>&before = spokes[(k + spokes.size() - 1) % spokes.size()], &here = spokes[k];
      if (before.ray) last = before.ray;
      if (same_direction(scene_.metric, before.direction, here.direction)) continue;
      const Vec<N> middle = Metric<N>::direction(before.direction * length_of(here.direction) +
                                                 here.direction * length_of(before.direction));
      const bool on = is_on(middle, sectors[here.sector].normal, others);
      drawings_.of(name(side_after(last), on))
          .triangle(exact(at), along(at, before.direction, radius), along(at, here.direction, radius));
    }
  }

  /// Rounded; it only has to lead into the corner.
  static N length_of(const Vec<N>& v) { return N(std::sqrt(approximate(dot(v, v)))); }

  std::string name(const std::string& side, bool on) const {
    const std::string other = solid_ == 0 ? " B" : " A";
    if (side.starts_with("no")) return on ? "on" + other + ", " + side : side;
    return on ? "on" + other + ", counted as " + side : (side == "in" ? "in" : "out of") + other;
  }

  const Scene<N>& scene_;
  Drawings& drawings_;
  int solid_;
};

}  // namespace

template <class N>
std::array<std::vector<Drawing>, 2> draw_sectors(const Scene<N>& scene) {
  std::array<Drawings, 2> drawings;
  std::array<SectorDrawer<N>, 2> drawer = {SectorDrawer<N>(scene, drawings[0], 0),
                                           SectorDrawer<N>(scene, drawings[1], 1)};
  std::map<std::array<std::uint32_t, 3>, const Crossing<N>*> crossings;
  const auto key = [](VertexId a, VertexId b, FaceId face) {
    return std::array{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                      static_cast<std::uint32_t>(face)};
  };
  for (const Crossing<N>& c : scene.crossings) crossings[key(c.vertices[0], c.vertices[1], c.face)] = &c;
  const auto find = [&](VertexId a, VertexId b, FaceId face) {
    const auto found = crossings.find(key(a, b, face));
    return found == crossings.end() ? nullptr : found->second;
  };
  for (const auto& [solid, vertex, face] : scene.vertex_faces) {
    std::array<VertexId, 2> vertices{kNo<VertexId>, kNo<VertexId>};
    vertices[solid] = vertex;
    const Crossing<N>* crossing = find(vertices[0], vertices[1], face);
    const Vec<N> none = {N(0), N(0), N(0)};
    const Sector<N> whole{none, none, scene.plane(face).normal, kNo<HalfEdgeId>};
    drawer[solid].draw(vertex, {whole}, crossing);
    if (crossing)
      drawer[1 - solid].draw_flat(*crossing, whole, neighbourhood(scene, vertex), drawer[solid].radius(vertex));
  }
  for (const auto& [a, b] : scene.vertex_vertices) {
    const Crossing<N>* crossing = find(a, b, kNo<FaceId>);
    drawer[0].draw(a, neighbourhood(scene, b), crossing);
    drawer[1].draw(b, neighbourhood(scene, a), crossing);
  }
  return {drawings[0].take(), drawings[1].take()};
}

template std::array<std::vector<Drawing>, 2> draw_sectors(const Scene<double>&);
template std::array<std::vector<Drawing>, 2> draw_sectors(const Scene<Rational>&);

}  // namespace cnrg::bench::mantyla
