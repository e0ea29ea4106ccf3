// Exact cuts have long numbers, and cuts of cuts have longer ones. So a cut is moved along what carries it to a
// place that few bits say, as near to the exact one as needs be for it to see all walls of its hole: then each new
// point is as short a combination of points of the input.
#include "kernel/tetrahedra/recovery.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "kernel/base/error.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

/// Bits of places that are tried before the exact one.
constexpr unsigned kBits[] = {16, 40, 80, 160};
/// How often points are spread and taken away.
constexpr int kRounds = 8;

Rational rounded(const Rational& x, unsigned bits) {
  const Integer scale = Integer(1) << bits;
  Integer n;
  const Rational scaled = x * scale + Rational(1, 2);
  mpz_fdiv_q(n.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational out(n, scale);
  out.canonicalize();
  return out;
}

RationalPoint minus(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Rational dot(const RationalPoint& u, const RationalPoint& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

RationalPoint along(const RationalPoint& p, const Rational& t, const RationalPoint& way) {
  return {p[0] + t * way[0], p[1] + t * way[1], p[2] + t * way[2]};
}

/// Of the way from p to q the part up to the plane of three points.
Rational part_to_plane(const RationalPoint& p, const RationalPoint& q, const std::array<RationalPoint, 3>& plane) {
  const RationalPoint normal = cross(minus(plane[1], plane[0]), minus(plane[2], plane[0]));
  return dot(normal, minus(plane[0], p)) / dot(normal, minus(q, p));
}

}  // namespace

Recovery::Recovery(PointTable& points, Tetrahedra& tetrahedra, std::span<const Ends> segments,
                   std::span<const std::vector<std::array<VertexId, 3>>> facets,
                   std::span<const std::vector<Ends>> borders)
    : points_(points),
      tetrahedra_(tetrahedra),
      segments_(segments),
      facets_(facets),
      borders_(borders),
      chains_(segments.size()),
      inside_(facets.size()) {}

void Recovery::run(const Watch& watch) {
  Steps segments(watch, "tetrahedra: segments", segments_.size());
  for (Index i = 0; i < segments_.size(); ++i) {
    cut_segment(i);
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

/// Points that have no double in their star go to the middle of it on their segment or facet: there may be one, and
/// they may go altogether. Returns how many have moved.
std::size_t Recovery::spread(const Watch& watch) {
  std::size_t moved = 0;
  for (VertexId v : all_new()) {
    watch.check();
    const Carrier carrier = new_.at(v);
    if (near_double(v).valid()) continue;
    const auto& way = carrier.segment ? std::span<const VertexId>(segments_[carrier.of])
                                      : std::span<const VertexId>(facets_[carrier.of][0]);
    const RationalPoint from = points_.rational(way[0]);
    for (std::size_t k = 1; k < way.size(); ++k) moved += to_middle(v, minus(points_.rational(way[k]), from));
    take_away(v);
  }
  return moved;
}

/// The double next to a point, if that could be in its place.
VertexId Recovery::near_double(VertexId v) {
  if (points_.is_double(v)) return v;
  const auto [x, y, z] = points_.nearest(v);
  const VertexId w = points_.add(x, y, z);
  tetrahedra_.around(v, star_);
  return tetrahedra_.sees(w, star_) ? w : VertexId::none();
}

/// Moves a point on a line through it to the middle of where it sees its star; false where it is there already.
bool Recovery::to_middle(VertexId& v, const RationalPoint& way) {
  tetrahedra_.around(v, star_);
  const RationalPoint at = points_.rational(v);
  Rational low, high;
  bool has_low = false, has_high = false;
  for (const Index t : star_) {
    const auto& corners = tetrahedra_.corners(t);
    const auto [a, b, c] =
        tetrahedra_.face({t, static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin())});
    const RationalPoint p = points_.rational(a),
                        normal = cross(minus(points_.rational(b), p), minus(points_.rational(c), p));
    const Rational slope = dot(normal, way);
    if (slope == 0) continue;
    const Rational end = -dot(normal, minus(at, p)) / slope;
    if (slope > 0 && (!has_low || end > low)) low = end, has_low = true;
    if (slope < 0 && (!has_high || end < high)) high = end, has_high = true;
  }
  if (!has_low || !has_high) return false;
  const Rational middle = (low + high) / 2, near = (high - low) / 8;
  if (abs(middle) < near) return false;
  for (const unsigned bits : kBits) {
    const Rational step = rounded(middle, bits);
    if (abs(Rational(step - middle)) >= near) continue;
    const VertexId w = points_.add(along(at, step, way));
    tetrahedra_.rename(v, w);
    const Carrier carrier = new_.at(v);
    auto& list = carrier.segment ? chains_[carrier.of] : inside_[carrier.of];
    std::replace(list.begin(), list.end(), v, w);
    new_.erase(v);
    new_.emplace(w, carrier);
    v = w;
    return true;
  }
  return false;
}

/// From each end of what there is already through the next face, or through an edge of it.
void Recovery::cut_segment(Index i) {
  const auto& [a, b] = segments_[i];
  std::vector<VertexId> fresh;
  VertexId last = a;
  for (;;) {
    tetrahedra_.around(last, star_);
    Index next = Tetrahedra::kNone;
    std::array<VertexId, 3> face{};
    std::array<int, 3> turns{};
    bool there = false;
    for (const Index t : star_) {
      const auto& corners = tetrahedra_.corners(t);
      if (std::find(corners.begin(), corners.end(), b) != corners.end()) {
        there = true;
        break;
      }
      if (next != Tetrahedra::kNone) continue;
      const auto f = tetrahedra_.face(
          {t, static_cast<int>(std::find(corners.begin(), corners.end(), last) - corners.begin())});
      bool ahead = true;
      for (std::size_t k = 0; k < 3 && ahead; ++k) {
        turns[k] = orient3d(points_, a, b, f[k], f[(k + 1) % 3]);
        ahead = turns[k] <= 0;
      }
      if (!ahead || std::count(turns.begin(), turns.end(), 0) > 1) continue;
      next = t;
      face = f;
      const auto edge = std::find(turns.begin(), turns.end(), 0);
      if (edge == turns.end()) continue;
      const auto k = static_cast<std::size_t>(edge - turns.begin());
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(k), face.end());
    }
    if (there) break;
    require(next != Tetrahedra::kNone, "tetrahedra: a point is inside of a segment");
    if (orient3d(points_, a, b, face[0], face[1]) == 0) {
      tetrahedra_.around(face[0], face[1], hole_);
    } else {
      hole_ = {next};
      for (int k = 0; k < 4; ++k) {
        const VertexId v = tetrahedra_.corners(next)[static_cast<std::size_t>(k)];
        if (v == last) hole_.push_back(tetrahedra_.neighbour(next, k));
      }
    }
    const std::array<RationalPoint, 3> plane{points_.rational(face[0]), points_.rational(face[1]),
                                             points_.rational(face[2])};
    last = put_on_segment(i, part_to_plane(points_.rational(a), points_.rational(b), plane));
    chains_[i].push_back(last);
    fresh.push_back(last);
  }
  take_away_all(std::move(fresh));
}

void Recovery::cut_facet(Index i) {
  Wall all = wall(i);
  if (all.faces().size() < needed(i)) {
    const auto& [p, q, r] = facets_[i][0];
    const std::array<RationalPoint, 3> plane{points_.rational(p), points_.rational(q), points_.rational(r)};
    for (const auto& [below, above] : all.edges_through()) {
      tetrahedra_.around(below, above, hole_);
      const RationalPoint from = points_.rational(below), to = points_.rational(above);
      inside_[i].push_back(put_on_facet(i, along(from, part_to_plane(from, to, plane), minus(to, from))));
    }
    take_away_all(inside_[i]);
  }
}

Wall Recovery::wall(Index facet) const {
  std::vector<Ends> border;
  for (const auto& [a, b] : borders_[facet]) {
    const std::vector<VertexId> list = chain(a, b);
    for (std::size_t k = 0; k + 1 < list.size(); ++k) border.push_back({list[k], list[k + 1]});
  }
  return {points_, tetrahedra_, facets_[facet], std::move(border), inside_[facet]};
}

/// Each point on a side parts a triangle, each point inside one in three.
std::size_t Recovery::needed(Index facet) const {
  std::size_t count = facets_[facet].size() + 2 * inside_[facet].size();
  for (const auto& [a, b] : borders_[facet]) count += chain(a, b).size() - 2;
  return count;
}

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

std::vector<std::array<VertexId, 3>> Recovery::faces(Index facet) const {
  auto out = wall(facet).faces();
  require(out.size() == needed(facet), "tetrahedra: a facet is not made of faces");
  return out;
}

/// A point in the hole, where `at` places it by so many bits; by none exactly.
template <class At>
VertexId Recovery::put(const At& at, const Carrier& carrier) {
  VertexId v;
  for (const unsigned bits : kBits) {
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
  const RationalPoint from = points_.rational(segments_[i][0]),
                      way = minus(points_.rational(segments_[i][1]), from);
  return put([&](unsigned bits) { return along(from, bits == 0 ? place : rounded(place, bits), way); }, {true, i});
}

VertexId Recovery::put_on_facet(Index i, const RationalPoint& place) {
  const auto& [a, b, c] = facets_[i][0];
  const RationalPoint p = points_.rational(a), u = minus(points_.rational(b), p),
                      v = minus(points_.rational(c), p), w = minus(place, p), normal = cross(u, v);
  const Rational size = dot(normal, normal);
  const Rational x = dot(cross(w, v), normal) / size, y = dot(cross(u, w), normal) / size;
  return put(
      [&](unsigned bits) { return bits == 0 ? place : along(along(p, rounded(x, bits), u), rounded(y, bits), v); },
      {false, i});
}

/// To `near_`: the vertices that share an edge with it, which is in the same segment or facet.
void Recovery::neighbours_on_carrier(VertexId v, const Carrier& carrier) {
  near_.clear();
  if (carrier.segment) {
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
    std::erase(carrier.segment ? chains_[carrier.of] : inside_[carrier.of], v);
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

std::unordered_map<VertexId, VertexId> Recovery::move_to_doubles(const Watch& watch) {
  std::vector<VertexId> open = all_new();
  watch.begin("tetrahedra: doubles");
  std::unordered_map<VertexId, VertexId> moved;
  const auto move = [&](VertexId v) {
    const VertexId w = near_double(v);
    if (!w.valid()) return false;
    if (w != v) {
      tetrahedra_.rename(v, w);
      moved.emplace(v, w);
    }
    return true;
  };
  while (std::erase_if(open, move) > 0) watch.check();
  if (open.empty()) return moved;
  std::ostringstream text;
  const auto [x, y, z] = points_.approx(open[0]);
  text << "tetrahedra are too thin for doubles near (" << x << ", " << y << ", " << z
       << "); move nearly touching parts apart or together there, or join them by `weld`";
  throw NearFault(text.str());
}

}  // namespace cnrg
