// Exact cuts have long numbers, and cuts of cuts have longer ones. So a cut is moved along what carries it to a
// place that few bits say, as near to the exact one as needs be for it to see all walls of its hole: then each new
// point is as short a combination of points of the input.
#include "kernel/tetrahedra/recovery.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <unordered_set>

#include "kernel/base/error.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/input.h"

namespace cnrg {
namespace {

/// Bits of places that are tried before the exact one.
constexpr unsigned kBits[] = {16, 40, 80, 160};
/// How often points are spread and taken away.
constexpr int kRounds = 8;
/// Places along a segment or facet that are looked at for a double.
constexpr int kPlaces = 40;
/// A point that sees an edge under an angle with a cosine below minus this nearly touches it.
constexpr double kFlat = 0.99;

Rational rounded(const Rational& x, unsigned bits) {
  const Integer scale = Integer(1) << bits;
  Integer n;
  const Rational scaled = x * scale + Rational(1, 2);
  mpz_fdiv_q(n.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational out(n, scale);
  out.canonicalize();
  return out;
}

/// Of the way from p to q the part up to the plane of three points.
Rational part_to_plane(const RationalPoint& p, const RationalPoint& q, const std::array<RationalPoint, 3>& plane) {
  const RationalPoint normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  return dot(normal, plane[0] - p) / dot(normal, q - p);
}

double cosine_at(const std::array<double, 3>& p, const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double along = 0, u = 0, w = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (a[k] - p[k]) * (b[k] - p[k]);
    u += (a[k] - p[k]) * (a[k] - p[k]);
    w += (b[k] - p[k]) * (b[k] - p[k]);
  }
  return u > 0 && w > 0 ? along / std::sqrt(u * w) : 1;
}

std::string too_thin(const std::array<double, 3>& p) {
  std::ostringstream text;
  text.precision(9);
  text << "tetrahedra are too thin for doubles near (" << p[0] << " " << p[1] << " " << p[2]
       << "); move nearly touching parts apart or together there, or join them by `weld`";
  return text.str();
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
      inside_(facets.size()),
      flips_(points, tetrahedra) {}

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

/// The ways that a point may take on what it is inside of: one, two, or none.
std::vector<RationalPoint> Recovery::ways(const Carrier& carrier) const {
  std::span<const VertexId> corners;
  if (carrier.on == On::segment) corners = segments_[carrier.of];
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
    if (near_double(v).valid()) continue;
    for (const RationalPoint& way : ways(carrier)) moved += to_middle(v, way);
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

/// From where to where a point may move along a line, as parts of `way`, and still sees its star, which `star_`
/// is.
std::optional<std::array<Rational, 2>> Recovery::free_part(VertexId v, const RationalPoint& way) const {
  const RationalPoint at = points_.rational(v);
  std::optional<Rational> low, high;
  for (const Index t : star_) {
    const auto [a, b, c] = tetrahedra_.face({t, tetrahedra_.place(t, v)});
    const RationalPoint p = points_.rational(a), normal = cross(points_.rational(b) - p, points_.rational(c) - p);
    const Rational slope = dot(normal, way);
    if (slope == 0) continue;
    const Rational end = -dot(normal, at - p) / slope;
    if (slope > 0 && (!low || end > *low)) low = end;
    if (slope < 0 && (!high || end < *high)) high = end;
  }
  if (!low || !high) return std::nullopt;
  return std::array{*low, *high};
}

/// Moves a point on a line through it to the middle of where it sees its star; false where it is there already.
bool Recovery::to_middle(VertexId& v, const RationalPoint& way) {
  tetrahedra_.around(v, star_);
  const auto part = free_part(v, way);
  if (!part) return false;
  const auto& [low, high] = *part;
  const RationalPoint at = points_.rational(v);
  const Rational middle = (low + high) / 2, near = (high - low) / 8;
  if (abs(middle) < near) return false;
  for (const unsigned bits : kBits) {
    const Rational step = rounded(middle, bits);
    if (abs(Rational(step - middle)) >= near) continue;
    const VertexId w = points_.add(at + step * way);
    tetrahedra_.rename(v, w);
    const Carrier carrier = new_.at(v);
    if (carrier.on != On::nothing) {
      auto& list = points_on(carrier);
      std::replace(list.begin(), list.end(), v, w);
    }
    new_.erase(v);
    new_.emplace(w, carrier);
    v = w;
    return true;
  }
  return false;
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
  if (face.size() < 3) return false;
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

void Recovery::move_to_doubles(ConstrainedTetrahedra& made, const Watch& watch) {
  watch.begin("tetrahedra: doubles");
  std::unordered_map<VertexId, VertexId> moved, origin;
  std::unordered_set<std::uint64_t> pieces;
  std::set<std::array<VertexId, 3>> faces;
  for (const auto& segment : made.segments) pieces.insert(RefineInput::key(segment.ends[0], segment.ends[1]));
  for (const auto& triangle : made.triangles) {
    auto corners = triangle.corners;
    std::sort(corners.begin(), corners.end());
    faces.insert(corners);
  }
  const auto bound = [&](std::span<const VertexId> corners) {
    std::array<VertexId, 3> f{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto at = origin.find(corners[k]);
      f[k] = at == origin.end() ? corners[k] : at->second;
    }
    if (corners.size() == 2) return pieces.contains(RefineInput::key(f[0], f[1]));
    std::sort(f.begin(), f.end());
    return faces.contains(f);
  };
  bool look_far = false;
  const auto move = [&](VertexId v) {
    VertexId w = near_double(v);
    if (!w.valid() && look_far) w = far_double(v);
    if (!w.valid()) return false;
    if (w == v) return true;
    tetrahedra_.rename(v, w);
    moved.emplace(v, w);
    origin.emplace(w, v);
    return true;
  };
  std::vector<VertexId> open = all_new();
  for (int round = 0;; ++round) {
    do {
      look_far = false;
      while (std::erase_if(open, move) > 0) watch.check();
      look_far = true;
    } while (std::erase_if(open, move) > 0);
    if (open.empty()) break;
    std::vector<VertexId> more;
    for (const VertexId v : open) {
      watch.check();
      const VertexId m = round < kRounds ? make_room(v, bound) : VertexId::none();
      if (m.valid()) more.push_back(m);
    }
    if (more.empty()) throw NearFault(too_thin(points_.approx(open[0])));
    open.insert(open.begin(), more.begin(), more.end());
  }
  const auto follow = [&](auto& corners) {
    for (VertexId& v : corners) {
      if (const auto at = moved.find(v); at != moved.end()) v = at->second;
    }
  };
  for (auto& segment : made.segments) follow(segment.ends);
  for (auto& triangle : made.triangles) follow(triangle.corners);
}

/// Between faces that are one plane but for the last digits there is room for one double and not for the next. So
/// a point looks along what carries it for a place where there is.
VertexId Recovery::far_double(VertexId v) {
  const Carrier carrier = new_.at(v);
  tetrahedra_.around(v, star_);
  const RationalPoint at = points_.rational(v);
  for (const RationalPoint& way : ways(carrier)) {
    const auto part = free_part(v, way);
    if (!part) continue;
    const auto& [low, high] = *part;
    for (int i = 1; i <= kPlaces; ++i) {
      const int place = i % 2 == 0 ? kPlaces + i : kPlaces - i;  // from the middle on
      const RationalPoint exact = at + Rational(low + (high - low) * place / (2 * kPlaces + 1)) * way;
      const std::array<double, 3> p = to_doubles(exact);
      for (int beside = 0; beside < 7; ++beside) {
        auto q = p;
        if (beside > 0) {
          double& x = q[static_cast<std::size_t>(beside - 1) / 2];
          x = std::nextafter(x, beside % 2 == 0 ? HUGE_VAL : -HUGE_VAL);
        }
        const VertexId w = points_.add(q[0], q[1], q[2]);
        if (tetrahedra_.sees(w, star_)) return w;
      }
    }
  }
  return VertexId::none();
}

/// Is nothing that has to stay in this edge or face?
bool Recovery::is_free(std::span<const VertexId> corners,
                       const std::function<bool(std::span<const VertexId>)>& bound) const {
  if (bound(corners)) return false;
  if (corners.size() == 3) return true;
  std::vector<Index> ring;
  tetrahedra_.around(corners[0], corners[1], ring);
  return std::none_of(ring.begin(), ring.end(), [&](Index t) {
    const auto& all = tetrahedra_.corners(t);
    return std::any_of(all.begin(), all.end(), [&](VertexId v) {
      return v != corners[0] && v != corners[1] && bound(std::array{corners[0], corners[1], v});
    });
  });
}

/// A point whose star has no double nearly touches an edge or a face of it. If that is nobody's, a new point takes
/// it away from there: returns that point, if there is one.
VertexId Recovery::make_room(VertexId v, const std::function<bool(std::span<const VertexId>)>& bound) {
  const auto nearest = points_.nearest(v);
  const VertexId w = points_.add(nearest[0], nearest[1], nearest[2]);
  tetrahedra_.around(v, star_);
  for (const Index t : star_) {
    const int k = tetrahedra_.place(t, v);
    auto f = tetrahedra_.face({t, k});
    if (orient3d(points_, f[0], f[1], f[2], w) > 0) continue;
    // The side of the face that is nearest, by the angle at the point.
    double widest = -2;
    std::size_t side = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double cosine = cosine_at(nearest, points_.approx(f[i]), points_.approx(f[(i + 1) % 3]));
      if (-cosine > widest) widest = -cosine, side = i;
    }
    std::rotate(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(side), f.end());
    const bool edge = widest > kFlat;
    const std::span<const VertexId> at(f.data(), edge ? 2 : 3);
    if (!is_free(at, bound)) continue;
    const RationalPoint a = points_.rational(f[0]), ab = points_.rational(f[1]) - a,
                        ac = points_.rational(f[2]) - a;
    RationalPoint place;
    if (edge) {
      tetrahedra_.around(f[0], f[1], hole_);
      const Rational foot = dot(points_.rational(v) - a, ab) / dot(ab, ab);
      place = a + std::clamp(rounded(foot, kBits[0]), Rational(1, 64), Rational(63, 64)) * ab;
    } else {
      hole_ = {t, tetrahedra_.neighbour(t, k)};
      place = a + Rational(1, 4) * (ab + ac);
    }
    VertexId m = points_.add(place);
    require(tetrahedra_.sees(m, hole_), "tetrahedra: a hole with a gap");
    tetrahedra_.fill(m, hole_);
    new_.emplace(m, Carrier{On::nothing, 0});
    to_middle(m, cross(ab, ac));
    to_middle(m, ab);
    to_middle(m, ac);
    return m;
  }
  return VertexId::none();
}

}  // namespace cnrg
