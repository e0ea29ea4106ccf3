// Exact cuts have long numbers, and cuts of cuts have longer ones. So a cut is moved along what carries it to a
// place that few bits say, as near to the exact one as needs be for it to see all walls of its hole: then each new
// point is as short a combination of points of the input.
#include "kernel/tetrahedra/recovery.h"

#include <algorithm>
#include <unordered_set>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

/// From so many triangles on a facet has a tree of their boxes.
constexpr std::size_t kMany = 32;

/// How often points are spread and taken away.
constexpr int kRounds = 8;

/// Of the way from p to q the part up to the plane of three points.
Rational part_to_plane(const RationalPoint& p, const RationalPoint& q, const std::array<RationalPoint, 3>& plane) {
  const RationalPoint normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  return dot(normal, plane[0] - p) / dot(normal, q - p);
}

}  // namespace

Wall::Wall(const PointTable& points, const Tetrahedra& tetrahedra, std::span<const Triangle> facet,
           std::vector<Ends> border, std::span<const VertexId> inside)
    : points_(points), tetrahedra_(tetrahedra), facet_(facet), border_(std::move(border)) {
  corners_.assign(inside.begin(), inside.end());
  for (const Triangle& t : facet_) corners_.insert(corners_.end(), t.begin(), t.end());
  for (const Ends& ends : border_) corners_.push_back(ends[0]);
  sort_unique(corners_);
  std::sort(border_.begin(), border_.end());
  for (const VertexId v : corners_) side_[v] = 0;
}

int Wall::side(VertexId v) const {
  const auto [it, fresh] = side_.try_emplace(v, 0);
  if (fresh) it->second = orient3d(points_, facet_[0][0], facet_[0][1], facet_[0][2], v);
  return it->second;
}

std::vector<Wall::Triangle> Wall::faces() const {
  std::vector<Triangle> all;
  std::vector<Index> star;
  for (const VertexId v : corners_) {
    tetrahedra_.around(v, star);
    for (const Index t : star) {
      for (int k = 0; k < 4; ++k) {
        Triangle f = tetrahedra_.face({t, k});
        const bool in = std::all_of(f.begin(), f.end(), [&](VertexId p) {
          return std::binary_search(corners_.begin(), corners_.end(), p);
        });
        if (!in) continue;
        if (side(tetrahedra_.corners(t)[static_cast<std::size_t>(k)]) < 0) std::swap(f[1], f[2]);
        std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
        all.push_back(f);
      }
    }
  }
  sort_unique(all);
  return within_border(all);
}

/// From the faces at the border to those that share with them a side that is none of it.
std::vector<Wall::Triangle> Wall::within_border(const std::vector<Triangle>& faces) const {
  std::vector<std::pair<Ends, std::size_t>> sides;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) sides.push_back({{faces[i][k], faces[i][(k + 1) % 3]}, i});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<char> seen(faces.size(), 0);
  std::vector<Triangle> out;
  const auto take = [&](const Ends& side) {
    const auto at = std::lower_bound(sides.begin(), sides.end(), std::pair(side, std::size_t{0}));
    if (at == sides.end() || at->first != side || seen[at->second]) return;
    seen[at->second] = 1;
    out.push_back(faces[at->second]);
  };
  for (const Ends& side : border_) take(side);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = out[i][k], b = out[i][(k + 1) % 3];
      if (!std::binary_search(border_.begin(), border_.end(), Ends{a, b})) take({b, a});
    }
  }
  return out;
}

std::vector<Wall::Ends> Wall::edges_through() {
  std::unordered_set<Index> known;
  std::vector<Index> star, all;
  const auto take = [&](Index t) {
    if (known.insert(t).second && pierced(t)) all.push_back(t);
  };
  for (const VertexId v : corners_) {
    tetrahedra_.around(v, star);
    for (const Index t : star) take(t);
  }
  std::vector<Ends> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      const Index u = tetrahedra_.neighbour(all[i], k);
      if (u != Tetrahedra::kNone) take(u);
    }
    for (const VertexId a : tetrahedra_.corners(all[i])) {
      for (const VertexId b : tetrahedra_.corners(all[i])) {
        if (side(a) < 0 && side(b) > 0) out.push_back({a, b});
      }
    }
  }
  sort_unique(out);
  return out;
}

/// Does the facet pass through the inside of a tetrahedron? Its border is made of edges, so where the plane cuts
/// the tetrahedron, all of the cut is in the facet or nothing of it: any edge across the plane tells.
bool Wall::pierced(Index t) {
  VertexId above, below;
  for (const VertexId v : tetrahedra_.corners(t)) {
    const int s = side(v);
    if (s > 0) above = v;
    if (s < 0) below = v;
  }
  return above.valid() && below.valid() && is_crossed(below, above);
}

bool Wall::is_crossed(VertexId below, VertexId above) {
  if (side(below) > side(above)) std::swap(below, above);
  if (side(below) >= 0 || side(above) <= 0) return false;
  const auto through = [&](const Triangle& f) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (orient3d(points_, below, above, f[k], f[(k + 1) % 3]) < 0) return false;
    }
    return true;
  };
  if (facet_.size() < kMany) return std::any_of(facet_.begin(), facet_.end(), through);
  const auto box_of = [&](std::span<const VertexId> corners) {
    Box box;
    for (const VertexId v : corners) {
      const PointView p = points_.view(v);
      box.extend(p.lo, p.hi);
    }
    return box;
  };
  if (!boxes_) {
    std::vector<Box> boxes;
    for (const Triangle& f : facet_) boxes.push_back(box_of(f));
    boxes_.emplace(std::move(boxes));
  }
  const Box edge = box_of(std::array{above, below});
  bool found = false;
  boxes_->query([&](const Box& box) { return !found && box.meets(edge); },
                [&](std::uint32_t i) { found = found || through(facet_[i]); });
  return found;
}

Recovery::Recovery(PointTable& points, Tetrahedra& tetrahedra, std::span<const Ends> segments,
                   std::span<const std::vector<std::array<VertexId, 3>>> facets,
                   std::span<const std::vector<Ends>> borders)
    : points_(points),
      tetrahedra_(tetrahedra),
      segments_(segments),
      facets_(facets),
      borders_(borders),
      chains_(segments.size()),
      inside_(facets.size()),
      flips_(points, tetrahedra),
      room_(points, tetrahedra) {}

void Recovery::run(const Watch& watch) {
  Steps segments(watch, "tetrahedra: segments", segments_.size());
  std::vector<Index> open = short_first();
  const auto flipped = [&](Index i) {
    if (!put_in_segment(i, Cuts::none)) return false;
    segments.step();
    return true;
  };
  while (std::erase_if(open, flipped) > 0) {
  }
  for (const Index i : open) {
    put_in_segment(i, Cuts::some);
    segments.step();
  }
  Steps facets(watch, "tetrahedra: facets", facets_.size());
  for (Index i = 0; i < facets_.size(); ++i) {
    cut_facet(i);
    facets.step();
  }
  watch.begin("tetrahedra: new points");
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t before = new_.size();
    take_away_all(all_new());
    if (spread(watch) == 0 && new_.size() == before) break;
  }
}

std::vector<VertexId> Recovery::all_new() const {
  std::vector<VertexId> out;
  for (const auto& [v, carrier] : new_) out.push_back(v);
  std::sort(out.begin(), out.end());
  return out;
}

/// The ways that a point may take on what it is inside of: one or two.
std::vector<RationalPoint> Recovery::ways(const Carrier& carrier) const {
  std::span<const VertexId> corners = segments_[carrier.of];
  if (carrier.on == On::facet) corners = facets_[carrier.of][0];
  std::vector<RationalPoint> out;
  for (std::size_t k = 1; k < corners.size(); ++k)
    out.push_back(points_.rational(corners[k]) - points_.rational(corners[0]));
  return out;
}

/// The new points on a segment or facet.
std::vector<VertexId>& Recovery::points_on(const Carrier& carrier) {
  return carrier.on == On::segment ? chains_[carrier.of] : inside_[carrier.of];
}

/// Points that have no double in their star go to the middle of it on their segment or facet: there may be one,
/// and they may go altogether. Returns how many have moved.
std::size_t Recovery::spread(const Watch& watch) {
  std::size_t moved = 0;
  for (VertexId v : all_new()) {
    watch.check();
    const Carrier carrier = new_.at(v);
    if (room_.near_double(v).valid()) continue;
    for (const RationalPoint& way : ways(carrier)) {
      const VertexId w = room_.middle(v, way);
      if (!w.valid()) continue;
      tetrahedra_.rename(v, w);
      auto& list = points_on(carrier);
      std::replace(list.begin(), list.end(), v, w);
      new_.erase(v);
      new_.emplace(w, carrier);
      v = w, ++moved;
    }
    take_away(v);
  }
  return moved;
}

/// In a fan of segments a long one between two others has their points in its way, and would be cut as often as
/// they have been; a short one has little in its way.
std::vector<Recovery::Index> Recovery::short_first() const {
  std::vector<std::pair<double, Index>> order;
  for (Index i = 0; i < segments_.size(); ++i) {
    const DoubleVector d = minus(points_.approx(segments_[i][1]), points_.approx(segments_[i][0]));
    order.emplace_back(dot(d, d), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> out;
  out.reserve(order.size());
  for (const auto& [squared, i] : order) out.push_back(i);
  return out;
}

/// From what there is already through the next face, or through an edge of it, where neither can be flipped away.
/// False if it is not there, since it would have to be cut.
bool Recovery::put_in_segment(Index i, Cuts cuts) {
  const VertexId a = segments_[i][0], b = segments_[i][1];
  VertexId last = a;
  const auto is_there = [&] {
    tetrahedra_.around(last, star_);
    return std::any_of(star_.begin(), star_.end(), [&](Index t) { return tetrahedra_.place(t, b) < 4; });
  };
  while (!is_there()) {
    if (flip({last, b}) || is_there() || flip({b, last}) || is_there()) continue;
    if (cuts == Cuts::none) return false;
    const Obstacle next = ahead(last, b);
    const auto& [p, q, r] = next.corners;
    if (next.edge) tetrahedra_.around(p, q, hole_);
    else hole_ = {next.face.tetrahedron, tetrahedra_.neighbour(next.face.tetrahedron, next.face.k)};
    last = put_on_segment(i, part_to_plane(points_.rational(a), points_.rational(b),
                                           {points_.rational(p), points_.rational(q), points_.rational(r)}));
    chains_[i].push_back(last);
  }
  take_away_all(chains_[i]);
  return true;
}

/// Where a way from a vertex to another leaves the star of the first.
Recovery::Obstacle Recovery::ahead(VertexId from, VertexId to) {
  tetrahedra_.around(from, star_);
  for (const Index t : star_) {
    const int place = tetrahedra_.place(t, from);
    auto f = tetrahedra_.face({t, place});
    std::array<int, 3> turns{};
    for (std::size_t k = 0; k < 3; ++k) turns[k] = orient3d(points_, from, to, f[k], f[(k + 1) % 3]);
    if (*std::max_element(turns.begin(), turns.end()) > 0) continue;
    const auto zeros = std::count(turns.begin(), turns.end(), 0);
    if (zeros > 1) continue;
    std::rotate(f.begin(), f.begin() + (std::find(turns.begin(), turns.end(), 0) - turns.begin()) % 3, f.end());
    return {{t, place}, f, zeros == 1};
  }
  throw InvariantError("tetrahedra: a point is inside of a segment");
}

/// Does what is between the ends of a way pass through a face?
bool Recovery::crosses(const Ends& way, std::span<const VertexId> face) const {
  if (face.size() != 3) return false;
  if (std::any_of(face.begin(), face.end(), [&](VertexId v) { return v == way[0] || v == way[1]; })) return false;
  bool left = false, right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int turn = orient3d(points_, way[0], way[1], face[k], face[(k + 1) % 3]);
    left = left || turn > 0, right = right || turn < 0;
    if (left && right) return false;
  }
  return orient3d(points_, face[0], face[1], face[2], way[0]) *
             orient3d(points_, face[0], face[1], face[2], way[1]) <
         0;
}

/// Takes away what is next on a way; other things may be exchanged even where it stays.
bool Recovery::flip(const Ends& way) {
  const Obstacle obstacle = ahead(way[0], way[1]);
  const auto in_the_way = [&](std::span<const VertexId> part) { return crosses(way, part); };
  const auto& f = obstacle.corners;
  if (!obstacle.edge && flips_.remove_face(obstacle.face, in_the_way)) return true;
  for (std::size_t k = 0; k < (obstacle.edge ? 1 : 3); ++k) {
    if (flips_.remove_edge(f[k], f[(k + 1) % 3], in_the_way,
                           [&](VertexId p, VertexId q) { return !is_piece(p, q); }))
      return true;
  }
  return false;
}

/// Is an edge a segment or a part of one?
bool Recovery::is_piece(VertexId a, VertexId b) const {
  for (const auto& [v, w] : {std::pair(a, b), std::pair(b, a)}) {
    const auto carrier = new_.find(v);
    if (carrier == new_.end()) continue;
    if (carrier->second.on != On::segment) return false;
    const auto& [p, q] = segments_[carrier->second.of];
    const auto& list = chains_[carrier->second.of];
    const auto at = std::find(list.begin(), list.end(), v);
    return w == (at == list.begin() ? p : *(at - 1)) || w == (at + 1 == list.end() ? q : *(at + 1));
  }
  const Ends ends{std::min(a, b), std::max(a, b)};
  const auto at = std::lower_bound(segments_.begin(), segments_.end(), ends);
  return at != segments_.end() && *at == ends && chains_[static_cast<std::size_t>(at - segments_.begin())].empty();
}

void Recovery::cut_facet(Index i) {
  Wall all = wall(i);
  if (all.faces().size() < needed(i)) {
    const auto& [p, q, r] = facets_[i][0];
    const std::array<RationalPoint, 3> plane{points_.rational(p), points_.rational(q), points_.rational(r)};
    std::vector<Ends> through = all.edges_through();
    const auto in_the_way = [&](std::span<const VertexId> part) {
      return part.size() == 2 && all.is_crossed(part[0], part[1]);
    };
    // No other facet and no segment has one of these edges; edges next to them may have both.
    const auto flipped = [&](const Ends& edge) {
      return flips_.remove_edge(edge[0], edge[1], in_the_way,
                                [&](VertexId p, VertexId q) { return p == edge[0] && q == edge[1]; });
    };
    while (std::erase_if(through, flipped) > 0) {
    }
    for (const auto& [below, above] : through) {
      tetrahedra_.around(below, above, hole_);
      const RationalPoint from = points_.rational(below), to = points_.rational(above);
      inside_[i].push_back(put_on_facet(i, from + part_to_plane(from, to, plane) * (to - from)));
    }
    take_away_all(inside_[i]);
  }
}

Wall Recovery::wall(Index facet) const {
  std::vector<Ends> border;
  for (const auto& [a, b] : borders_[facet]) {
    const std::vector<Ends> some = pieces(a, b);
    border.insert(border.end(), some.begin(), some.end());
  }
  return {points_, tetrahedra_, facets_[facet], std::move(border), inside_[facet]};
}

/// Each point on a side parts a triangle, each point inside one in three.
std::size_t Recovery::needed(Index facet) const {
  std::size_t count = facets_[facet].size() + 2 * inside_[facet].size();
  for (const auto& [a, b] : borders_[facet]) count += chain(a, b).size() - 2;
  return count;
}

/// The points of a segment from a to b.
std::vector<VertexId> Recovery::chain(VertexId a, VertexId b) const {
  const Ends ends{std::min(a, b), std::max(a, b)};
  const auto at = std::lower_bound(segments_.begin(), segments_.end(), ends) - segments_.begin();
  std::vector<VertexId> out{ends[0]};
  const auto& between = chains_[static_cast<std::size_t>(at)];
  out.insert(out.end(), between.begin(), between.end());
  out.push_back(ends[1]);
  if (a != ends[0]) std::reverse(out.begin(), out.end());
  return out;
}

std::vector<Recovery::Ends> Recovery::pieces(VertexId a, VertexId b) const {
  const std::vector<VertexId> list = chain(a, b);
  std::vector<Ends> out;
  for (std::size_t k = 0; k + 1 < list.size(); ++k) out.push_back({list[k], list[k + 1]});
  return out;
}

std::vector<Recovery::Ends> Recovery::pieces() const {
  std::vector<Ends> out;
  for (const auto& [a, b] : segments_) {
    const std::vector<Ends> some = pieces(a, b);
    out.insert(out.end(), some.begin(), some.end());
  }
  return out;
}

std::vector<std::array<VertexId, 3>> Recovery::faces(Index facet) const {
  auto out = wall(facet).faces();
  require(out.size() == needed(facet), "tetrahedra: a facet is not made of faces");
  return out;
}

/// A point in the hole, where `at` places it by so many bits; by none exactly.
template <class At>
VertexId Recovery::put(const At& at, const Carrier& carrier) {
  VertexId v;
  for (const unsigned bits : kPlaceBits) {
    v = points_.add(at(bits));
    if (tetrahedra_.sees(v, hole_)) break;
    v = VertexId::none();
  }
  if (!v.valid()) v = points_.add(at(0));
  require(tetrahedra_.sees(v, hole_), "tetrahedra: segments or facets cross");
  tetrahedra_.fill(v, hole_);
  new_.emplace(v, carrier);
  return v;
}

VertexId Recovery::put_on_segment(Index i, const Rational& place) {
  const RationalPoint from = points_.rational(segments_[i][0]), way = points_.rational(segments_[i][1]) - from;
  return put([&](unsigned bits) { return from + (bits == 0 ? place : rounded(place, bits)) * way; },
             {On::segment, i});
}

VertexId Recovery::put_on_facet(Index i, const RationalPoint& place) {
  const auto& [a, b, c] = facets_[i][0];
  const RationalPoint p = points_.rational(a), u = points_.rational(b) - p, v = points_.rational(c) - p,
                      w = place - p, normal = cross(u, v);
  const Rational size = dot(normal, normal);
  const Rational x = dot(cross(w, v), normal) / size, y = dot(cross(u, w), normal) / size;
  return put([&](unsigned bits) { return bits == 0 ? place : p + rounded(x, bits) * u + rounded(y, bits) * v; },
             {On::facet, i});
}

/// To `near_`: the vertices that share an edge with it, which is in the same segment or facet.
void Recovery::neighbours_on_carrier(VertexId v, const Carrier& carrier) {
  near_.clear();
  if (carrier.on == On::segment) {
    const auto& list = chains_[carrier.of];
    const auto at = std::find(list.begin(), list.end(), v);
    near_.push_back(at == list.begin() ? segments_[carrier.of][0] : *(at - 1));
    near_.push_back(at + 1 == list.end() ? segments_[carrier.of][1] : *(at + 1));
    return;
  }
  const auto& [a, b, c] = facets_[carrier.of][0];
  for (const Index t : star_) {
    for (const VertexId w : tetrahedra_.corners(t)) {
      if (w != v && std::find(near_.begin(), near_.end(), w) == near_.end() && orient3d(points_, a, b, c, w) == 0)
        near_.push_back(w);
    }
  }
}

bool Recovery::take_away(VertexId v) {
  const Carrier carrier = new_.at(v);
  tetrahedra_.around(v, star_);
  neighbours_on_carrier(v, carrier);
  for (const VertexId w : near_) {
    if (!tetrahedra_.sees(w, star_)) continue;
    tetrahedra_.fill(w, star_);
    std::erase(points_on(carrier), v);
    new_.erase(v);
    return true;
  }
  return false;
}

/// The last first, as long as one can go.
void Recovery::take_away_all(std::vector<VertexId> from) {
  std::sort(from.begin(), from.end(), std::greater());
  while (std::erase_if(from, [&](VertexId v) { return take_away(v); }) > 0) {
  }
}

}  // namespace cnrg
