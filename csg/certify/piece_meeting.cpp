// How pieces of one leaf hang together, and how facets of two leaves meet, exactly; see the header.
#include <algorithm>
#include <unordered_map>

#include "csg/certify/piece_parts.h"
#include "kernel/base/limits.h"
#include "kernel/base/point_hash.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

using namespace surface_math;

namespace {

bool has_corner(const Piece& piece, std::uint32_t number) {
  const auto numbers = piece.numbers();
  return piece.kind == Piece::Kind::flat ? std::binary_search(numbers.begin(), numbers.end(), number)
                                         : std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

bool Pieces::share_corner(std::span<const std::uint32_t> pieces) const {
  return std::ranges::any_of(pieces_[pieces[0]].numbers(), [&](std::uint32_t p) {
    return std::ranges::all_of(pieces, [&](std::uint32_t i) { return has_corner(pieces_[i], p); });
  });
}

std::array<Interval, 2> Pieces::range_beside(std::uint32_t cell, std::uint32_t other) const {
  const Piece& piece = pieces_[cell];
  std::array<Interval, 2> range = piece.range;
  bool any = false;
  for (std::size_t i = 0; i < piece.corner_count; ++i) {
    if (!has_corner(pieces_[other], piece.points[i])) continue;
    for (std::size_t k = 0; k < 2; ++k) range[k] = any ? hull(range[k], Interval(piece.at[i][k])) : piece.at[i][k];
    any = true;
  }
  return range;
}

namespace {

bool same(const Interval& a, const Interval& b) { return a.inf() == b.inf() && a.sup() == b.sup(); }
bool same(std::span<const Interval> a, std::span<const Interval> b) {
  return std::ranges::equal(a, b, [](const Interval& x, const Interval& y) { return same(x, y); });
}
bool same(std::span<const Interval3> a, std::span<const Interval3> b) {
  return std::ranges::equal(a, b, [](const Interval3& x, const Interval3& y) { return same(x, y); });
}
/// True if pieces, of leaves with one number, have the same facets and surfaces but for what is beside them.
bool same(const Piece& a, const Piece& b) {
  if (a.kind != b.kind || a.leaf != b.leaf || a.patch != b.patch || a.box.lo != b.box.lo || a.box.hi != b.box.hi)
    return false;
  if (a.kind == Piece::Kind::flat) {
    return same(a.normal, b.normal) && same(a.point, b.point) &&
           std::ranges::equal(a.limits, b.limits, [](const auto& x, const auto& y) {
             return x.first == y.first && same(x.second, y.second);
           });
  }
  const bool cell = a.kind == Piece::Kind::cell;
  const auto corners = [&](const Piece& p) { return std::span(p.corners).first(cell ? p.corner_count : 2u); };
  return a.corner_count == b.corner_count && a.torn == b.torn && a.grid == b.grid && a.bent == b.bent &&
         a.blind == b.blind && !a.column == !b.column && a.at == b.at && same(a.range, b.range) &&
         same(corners(a), corners(b)) && !a.surface == !b.surface && !a.curve == !b.curve &&
         (cell || a.exact() || (same(a.side[0], b.side[0]) && same(a.side[1], b.side[1])));
}

}  // namespace

std::vector<std::uint32_t> Pieces::same_in(const Pieces& other) const {
  const auto place = [](const Piece& piece) { return hash_of_point(piece.box.lo.data()) ^ piece.leaf.index(); };
  std::unordered_multimap<std::uint64_t, std::uint32_t> there;
  for (std::uint32_t j = 0; j < other.pieces_.size(); ++j) there.emplace(place(other.pieces_[j]), j);
  std::vector<std::uint32_t> alike(pieces_.size(), kNone);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const auto [first, last] = there.equal_range(place(pieces_[i]));
    for (auto it = first; it != last && alike[i] == kNone; ++it) {
      if (same(pieces_[i], other.pieces_[it->second])) alike[i] = it->second;
    }
  }
  std::vector<std::uint32_t> result = alike;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    if (alike[i] == kNone) continue;
    const auto beside = [&](const Piece& piece, const auto& number) {
      std::vector<std::pair<std::uint32_t, std::uint8_t>> all;
      for (const auto& [j, bits] : piece.neighbours) all.emplace_back(number(j), bits);
      for (const std::uint32_t j : piece.foreign) all.emplace_back(number(j), std::uint8_t(0));
      std::sort(all.begin(), all.end());
      return all;
    };
    const auto own = beside(pieces_[i], [&](std::uint32_t j) { return alike[j]; });
    if (own != beside(other.pieces_[alike[i]], [](std::uint32_t j) { return j; })) result[i] = kNone;
  }
  return result;
}

void Pieces::join(std::uint32_t a, std::uint32_t b) {
  for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
    if (pieces_[x].kind == Piece::Kind::cell) pieces_[x].foreign.push_back(y);
  }
}

std::vector<Pieces::Facet> Pieces::facets_of(std::uint32_t piece) const {
  if (pieces_[piece].bent) return {{piece, 3, {0, 1, 2, 0}}, {piece, 3, {0, 2, 3, 0}}};
  return {{piece, pieces_[piece].corner_count, {0, 1, 2, 3}}};
}

const RationalPoint& Pieces::corner(const Facet& facet, std::size_t k) const {
  const Piece& piece = pieces_[facet.piece];
  return points_.at(piece.leaf)[piece.points[facet.corners[k]]];
}

RationalPoint Pieces::normal_of(const Facet& facet) const {
  const RationalPoint& first = corner(facet, 0);
  const RationalPoint normal = cross(corner(facet, 1) - first, corner(facet, 2) - first);
  if (!is_zero(normal)) return normal;
  return cross(corner(facet, 2) - first, corner(facet, facet.corner_count - 1u) - first);
}

PlaneEquation Pieces::equation_of(const Facet& facet) const {
  if (pieces_[facet.piece].kind == Piece::Kind::flat) return plane_of(pieces_[facet.piece].sheet);
  const RationalPoint normal = normal_of(facet);
  return {normal[0], normal[1], normal[2], Rational(-dot(normal, corner(facet, 0)))};
}

/// True if the closed hull of the corners of a facet has a point of the hull of the others, on a line in its
/// plane.
bool Pieces::holds(const Facet& facet, const std::vector<const RationalPoint*>& points) const {
  const RationalPoint normal = normal_of(facet);
  const std::size_t n = facet.corner_count;
  const auto between = [&](const RationalPoint* p, const RationalPoint* q) {
    Rational low = 0, high = 1;  // of q - p
    for (std::size_t k = 0; k < n; ++k) {
      const RationalPoint& from = corner(facet, k);
      const RationalPoint inward = cross(normal, corner(facet, (k + 1) % n) - from);
      const Rational at_p = dot(inward, *p - from), at_q = dot(inward, *q - from);
      if (at_p < 0 && at_q < 0) return false;
      if (at_p < 0) low = std::max(low, Rational(at_p / (at_p - at_q)));
      if (at_q < 0) high = std::min(high, Rational(at_p / (at_p - at_q)));
    }
    return low <= high && dot(normal, *p - corner(facet, 0)) == 0;
  };
  return std::ranges::any_of(points, [&](const RationalPoint* p) {
    return std::ranges::any_of(points, [&](const RationalPoint* q) { return between(p, q); });
  });
}

int Pieces::sides(const PlaneEquation& equation, const Facet& of, std::vector<const RationalPoint*>& on) const {
  int result = 0;
  for (std::size_t k = 0; k < of.corner_count; ++k) {
    const RationalPoint& p = corner(of, k);
    const int side = sgn(equation[0] * p[0] + equation[1] * p[1] + equation[2] * p[2] + equation[3]);
    result |= side > 0 ? 1 : side < 0 ? 2 : 0;
    // A pole is two corners.
    if (side == 0 && std::ranges::none_of(on, [&](const RationalPoint* q) { return *q == p; })) on.push_back(&p);
  }
  return result;
}

Interval3 Pieces::rough_normal(const Facet& facet) const {
  const bool quad = facet.corner_count == 4;  // by its diagonals: a side may be a point
  return cross(difference(rough(facet, quad ? 2 : 1), rough(facet, 0)),
               difference(rough(facet, quad ? 3 : 2), rough(facet, quad ? 1 : 0)));
}

int Pieces::sides_of(const Facet& plane, const Facet& of) const {
  const Interval3 normal = rough_normal(plane);
  int seen = 0;
  for (std::size_t k = 0; k < of.corner_count && seen != 3; ++k) {
    bool shared = false;
    for (std::size_t i = 0; i < plane.corner_count && !shared; ++i)
      shared = same(rough(plane, i), rough(of, k)) && corner(plane, i) == corner(of, k);
    if (shared) continue;
    const Interval side = dot(normal, difference(rough(of, k), rough(plane, 0)));
    if (holds_zero(side)) {
      std::vector<const RationalPoint*> on;
      return sides(equation_of(plane), of, on);
    }
    seen |= side.inf() > 0 ? 1 : 2;
  }
  return seen;
}

// Quadrics here are balls, cylinders and cones, or those stretched: facets that have no corner beyond each other's
// planes, on the side where the surface is, are all facets of the convex hull of their corners.
bool Pieces::drawn_alike(std::uint32_t a, std::uint32_t b) const {
  const Piece &one = pieces_[a], &other = pieces_[b];
  if (!is_quadric(one.sheet)) return !(one.blind || other.blind) || drawn_as_one(a, b);
  const auto none_beyond = [&](const Facet& plane, const Facet& of) {
    const Piece& cell = pieces_[plane.piece];
    const Interval side =
        dot(rough_normal(plane), difference(PiecePart{&cell, cell.range}.middle(), rough(plane, 0)));
    if (holds_zero(side)) return is_zero(normal_of(plane));
    return (sides_of(plane, of) & (side.inf() > 0 ? 1 : 2)) == 0;
  };
  for (const Facet& f : facets_of(a)) {
    for (const Facet& g : facets_of(b)) {
      if (!none_beyond(f, g) || !none_beyond(g, f)) return drawn_as_one(a, b);
    }
  }
  return true;
}

bool Pieces::same_corner(std::uint32_t a, std::size_t i, std::uint32_t b, std::size_t j) const {
  const Piece &one = pieces_[a], &other = pieces_[b];
  if (one.leaf == other.leaf) return one.points[i] == other.points[j];
  return same(one.corners[i], other.corners[j]) &&
         points_.at(one.leaf)[one.points[i]] == points_.at(other.leaf)[other.points[j]];
}

bool Pieces::ends_in(const Piece& curve, std::size_t end, const Piece& other) const {
  const RationalPoint& p = points_.at(curve.leaf)[curve.points[end]];
  if (other.kind == Piece::Kind::flat) {
    const auto& [a, b, c, d] = plane_of(other.sheet);
    return a * p[0] + b * p[1] + c * p[2] + d == 0;
  }
  // Corners of another leaf are rounded.
  return std::ranges::any_of(other.numbers(), [&](std::uint32_t n) { return points_.at(other.leaf)[n] == p; }) &&
         (other.kind == Piece::Kind::curve || curve.leaf == other.leaf ||
          (has_equation(other.sheet) && side(std::uint32_t(&other - pieces_.data()), p) == 0));
}

std::optional<Interval3> Pieces::away_from(const Piece& flat, std::uint32_t p, std::uint32_t q) const {
  const std::vector<RationalPoint>& points = points_.at(flat.leaf);
  const auto& [a, b, c, d] = plane_of(flat.sheet);
  const RationalPoint way = cross(RationalPoint{a, b, c}, points[q] - points[p]);
  std::set<int> sides;
  for (const std::uint32_t n : flat.corner_numbers) sides.insert(sgn(dot(way, points[n] - points[p])));
  sides.erase(0);
  if (sides.size() != 1) return std::nullopt;
  return enclose3(Rational(-*sides.begin()) * way);
}

bool Pieces::drawn_as_one(std::uint32_t a, std::uint32_t b) const {
  const std::vector<Facet> of_a = facets_of(a), of_b = facets_of(b);
  const auto in_plane = [&, plane = equation_of(of_a[0])](const Facet& facet) {
    std::vector<const RationalPoint*> on;
    return sides(plane, facet, on) == 0;
  };
  if (std::ranges::all_of(of_a, in_plane) && std::ranges::all_of(of_b, in_plane)) return true;
  const auto facets = [&](std::uint32_t piece) {
    std::set<std::vector<RationalPoint>> all;
    for (const Facet& facet : facets_of(piece)) {
      std::vector<RationalPoint> corners;
      for (std::size_t k = 0; k < facet.corner_count; ++k) corners.push_back(corner(facet, k));
      std::sort(corners.begin(), corners.end());
      all.insert(std::move(corners));
    }
    return all;
  };
  // What is the same as a cell beside one is beside it as that is.
  const auto is_beside = [&](std::uint32_t x, std::uint32_t y) {
    const auto own = facets(x);
    return own == facets(y) ||
           std::ranges::any_of(pieces_[y].neighbours, [&](const auto& n) { return own == facets(n.first); });
  };
  return is_beside(a, b) || is_beside(b, a);
}

const std::optional<Contact>& Pieces::contact_of(std::uint32_t sheet, std::uint32_t other) {
  const auto [it, fresh] = contacts_.try_emplace(std::minmax(sheet, other));
  if (!fresh) return it->second;
  // A plane, a quadric or a torus each, in this order.
  const auto& quadrics = equations_.quadrics;
  const auto& tori = equations_.tori;
  const auto rank = [&](std::uint32_t s) { return tori.contains(s) ? 2 : quadrics.contains(s) ? 1 : 0; };
  const auto order = std::minmax(sheet, other, [&](auto a, auto b) { return rank(a) < rank(b); });
  const std::uint32_t low = order.first, high = order.second;
  const auto plane = planes_.find(low);
  const auto with = [&, &found = it->second](const auto& surface) {
    if (rank(low) == 1) found = contact(quadrics.at(low), surface);
    else if (plane != planes_.end()) found = contact(plane->second, surface);
  };
  if (rank(low) == 2) it->second = contact(tori.at(low), tori.at(high));
  else if (rank(high) == 2) with(tori.at(high));
  else if (rank(high) == 1) with(quadrics.at(high));
  return it->second;
}

RationalPoint Pieces::gradient(std::uint32_t cell, const RationalPoint& p) const {
  const auto torus = equations_.tori.find(pieces_[cell].sheet);
  if (torus == equations_.tori.end()) return gradient_of(equations_.quadrics.at(pieces_[cell].sheet), p);
  const auto& [center, axis, radius, tube] = torus->second;
  const RationalPoint way = p - center, flat = way - Rational(dot(way, axis) / dot(axis, axis)) * axis;
  return Rational(dot(way, way) + radius * radius - tube * tube) * way - Rational(2 * radius * radius) * flat;
}

int Pieces::side(std::uint32_t cell, const RationalPoint& p) const {
  const auto torus = equations_.tori.find(pieces_[cell].sheet);
  if (torus == equations_.tori.end())
    return sgn(dot(p, gradient(cell, p)) + row_times(equations_.quadrics.at(pieces_[cell].sheet), 3, p));
  const auto& [center, axis, radius, tube] = torus->second;
  const RationalPoint way = p - center;
  const Rational along = dot(way, axis), square = dot(way, way), level = square + radius * radius - tube * tube;
  return sgn(level * level - 4 * radius * radius * (square - along * along / dot(axis, axis)));
}

// Seen along n, the cell is a graph over a half-plane beside the ruling, and falls from there: facets, surface and
// all between. Two graphs that fall from rulings which cross in a point are equal in a curve through this point.
std::optional<std::array<Rational, 3>> Pieces::ruling(std::uint32_t cell, const CylinderAxis& axis,
                                                      const RationalPoint& n) const {
  const Piece& piece = pieces_[cell];
  if (piece.kind == Piece::Kind::curve) return std::array<Rational, 3>{dot(n, axis.middle), 0, 0};
  std::vector<RationalPoint> on, off;  // from the middle
  for (std::size_t k = 0; k < piece.corner_count; ++k) {
    const RationalPoint& p = points_.at(piece.leaf)[piece.points[k]];
    (is_zero(cross(gradient(cell, p), n)) ? on : off).push_back(p - axis.middle);
  }
  const auto along = [&](const auto& ends) {
    return ends.size() == 2 && is_zero(cross(ends[0] - ends[1], axis.direction));
  };
  if (!piece.grid || !along(on) || !along(off)) return std::nullopt;
  const Rational height = dot(n, on[0]), lower = dot(n, off[0]);
  if (height * lower <= 0 || abs(lower) >= abs(height)) return std::nullopt;
  const RationalPoint &m = axis.middle, out = gradient(cell, axis.middle + on[0]);
  const Rational level = row_times(equations_.quadrics.at(piece.sheet), 3, m);
  return std::array<Rational, 3>{dot(n, m), height, Rational(-level * height * height / dot(out, on[0]))};
}

bool Pieces::cross_in_rulings(std::uint32_t a, std::uint32_t b) const {
  const auto axis = [&](std::uint32_t i) -> std::optional<CylinderAxis> {
    const Piece& piece = pieces_[i];
    if (is_quadric(piece.sheet)) return cylinder_axis(equations_.quadrics.at(piece.sheet));
    if (piece.kind != Piece::Kind::curve || !piece.exact()) return std::nullopt;
    const RationalPoint &from = points_.at(piece.leaf)[piece.points[0]],
                        &to = points_.at(piece.leaf)[piece.points[1]];
    return CylinderAxis{to - from, from};
  };
  const auto one = axis(a), other = axis(b);
  if (!one || !other) return false;
  const RationalPoint n = cross(one->direction, other->direction);
  if (is_zero(n)) return false;
  const auto p = ruling(a, *one, n), q = ruling(b, *other, n);
  return p && q && (*p)[0] + (*p)[1] == (*q)[0] + (*q)[1] &&
         equal_roots((*p)[0] - (*q)[0], (*p)[1] < 0 ? -1 : 1, (*p)[2], (*q)[1] < 0 ? -1 : 1, (*q)[2]);
}

bool Pieces::on_true_side(const RationalPoint& normal, const RationalPoint& at, std::uint32_t cell,
                          const Facet& of, const Contact& contact) const {
  const int turned = sgn(dot(normal, gradient(cell, at)));
  for (std::size_t k = 0; k < of.corner_count; ++k) {
    const RationalPoint& p = corner(of, k);
    if (contact.has(p)) continue;  // on both surfaces, but for what is rounded
    const int of_plane = sgn(dot(normal, p - at));
    if (of_plane != 0 && of_plane * turned != side(cell, p)) return false;
  }
  return turned != 0;
}

// The plane through the contact and at right angles to the surfaces, or a cylinder, has the cell on one side, as
// far as it is near.
bool Pieces::along_border(const Facet& cell, const Facet& other, const Contact& contact) const {
  if (contact.kind == Contact::Kind::point) return true;
  RationalPoint normal = contact.direction;
  if (contact.kind == Contact::Kind::circle) {
    const std::size_t n = cell.corner_count;
    std::size_t on = 0;
    while (on < n && !contact.has(corner(cell, on))) ++on;
    if (on < n && is_zero(cross(gradient(cell.piece, corner(cell, on)), normal))) {
      int seen = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const RationalPoint across = cross(corner(cell, k) - contact.point, normal);
        const Rational off = dot(across, across) - contact.radius * contact.radius * dot(normal, normal);
        if (!contact.has(corner(cell, k))) seen |= off > 0 ? 1 : 2;
      }
      return seen != 3;
    }
  }
  if (contact.kind == Contact::Kind::line) {
    const std::uint32_t curved = pieces_[cell.piece].kind == Piece::Kind::cell ? cell.piece : other.piece;
    RationalPoint out = gradient(curved, contact.point);
    if (is_zero(out))
      out = gradient(curved, contact.point + contact.direction);  // the point is the apex of a cone
    // The plane of the facet's pole, if the contact passes through it, and its two sides from there.
    const auto& points = pieces_[cell.piece].points;
    for (std::size_t k = 0; k < cell.corner_count; ++k) {
      const std::size_t n = cell.corner_count, next = (k + 1) % n;
      if (points[cell.corners[k]] != points[cell.corners[next]] || !contact.has(corner(cell, k))) continue;
      const RationalPoint& pole = corner(cell, k);
      const RationalPoint first = corner(cell, (next + 1) % n) - pole,
                          second = corner(cell, (k + n - 1) % n) - pole, across = cross(first, second),
                          polar = gradient(cell.piece, pole + (first + second));
      const int inside = sgn(dot(gradient(cell.piece, pole + first), second));
      // From the apex of a cone along the contact, on the side of it where the facet is.
      const int ahead = sgn(dot(polar, contact.direction)) * inside;
      return inside * sgn(dot(across, polar)) * ahead * sgn(dot(across, contact.direction)) >= 0;
    }
    normal = cross(contact.direction, out);
  }
  std::vector<const RationalPoint*> on;
  return sides({normal[0], normal[1], normal[2], Rational(-dot(normal, contact.point))}, cell, on) != 3;
}

Pieces::Common Pieces::in_common(const std::vector<const RationalPoint*>& a,
                                 const std::vector<const RationalPoint*>& b, const Contact& contact) {
  if (a.empty() || b.empty()) return Common::nothing;
  if (a.size() > 2 || b.size() > 2) return Common::more;
  const RationalPoint &p = *a.front(), &q = *a.back(), &r = *b.front(), &s = *b.back();
  const RationalPoint u = q - p, v = s - r, normal = cross(u, v);
  const auto on_edge = [](const RationalPoint& x, const RationalPoint& from, const RationalPoint& to) {
    return is_zero(cross(x - from, to - from)) && dot(x - from, x - to) <= 0;
  };
  std::vector<RationalPoint> points;  // the only one, or the ends of all
  if (is_zero(normal)) {
    for (const RationalPoint* x : a) {
      if (on_edge(*x, r, s)) points.push_back(*x);
    }
    for (const RationalPoint* x : b) {
      if (on_edge(*x, p, q)) points.push_back(*x);
    }
  } else {
    const RationalPoint x = p + Rational(dot(cross(r - p, v), normal) / dot(normal, normal)) * u;
    if (on_edge(x, p, q) && on_edge(x, r, s)) points.push_back(x);
  }
  if (points.empty()) return Common::nothing;
  return std::ranges::all_of(points, [&](const RationalPoint& x) { return contact.has(x); }) ? Common::contact
                                                                                             : Common::more;
}

Pieces::Meeting Pieces::met(Common common, const Facet& a, const Facet& b, const Contact& contact) const {
  if (common == Common::nothing) return Meeting::apart;
  const bool both = pieces_[b.piece].kind == Piece::Kind::cell;
  return along_border(a, b, contact) || (both && along_border(b, a, contact)) ? Meeting::at_contact
                                                                              : Meeting::otherwise;
}

// A plane that has all of one on one side and all of the other on the other side: that of one of them, or where
// surfaces touch from outside, the one in which both are tangent.
Pieces::Meeting Pieces::facets_meet(const Facet& a, const Facet& b, const Contact& contact) const {
  const auto at_contact = [&](const std::vector<const RationalPoint*>& on) {
    return std::ranges::all_of(on, [&](const RationalPoint* p) { return contact.has(*p); });
  };
  for (const auto& [plane, of] : {std::pair(a, b), std::pair(b, a)}) {
    if (pieces_[of.piece].kind == Piece::Kind::flat) continue;
    std::vector<const RationalPoint*> on;
    const int side = sides(equation_of(plane), of, on);
    if (side == 3 || side == 0 || !at_contact(on)) continue;
    if (pieces_[plane.piece].kind == Piece::Kind::cell &&
        !on_true_side(normal_of(plane), corner(plane, 0), plane.piece, of, contact))
      continue;
    const bool flat = pieces_[plane.piece].kind == Piece::Kind::flat;
    return met(on.empty() || !(flat || holds(plane, on)) ? Common::nothing : Common::contact, of, plane, contact);
  }
  if (pieces_[a.piece].kind == Piece::Kind::flat || pieces_[b.piece].kind == Piece::Kind::flat)
    return Meeting::otherwise;
  if (contact.kind != Contact::Kind::point && contact.kind != Contact::Kind::line)
    return parted_by_edges(a, b, contact);
  const RationalPoint normal = gradient(a.piece, contact.point);
  if (is_zero(normal)) return Meeting::otherwise;
  const PlaneEquation tangent{normal[0], normal[1], normal[2], Rational(-dot(normal, contact.point))};
  std::vector<const RationalPoint*> on_a, on_b;
  const int of_a = sides(tangent, a, on_a), of_b = sides(tangent, b, on_b);
  if (of_a == 0 || of_b == 0 || (of_a | of_b) != 3 || of_a == of_b) return parted_by_edges(a, b, contact);
  const Common common = in_common(on_a, on_b, contact);
  return common == Common::more ? parted_by_edges(a, b, contact) : met(common, a, b, contact);
}

// Facets about the point of a contact that have only it in common are all on one side of the others there. So one
// pair tells the side.
bool Pieces::beside_contact(const Facet& a, const Facet& b, const Contact& contact) const {
  if (contact.kind != Contact::Kind::point || pieces_[a.piece].kind == Piece::Kind::flat ||
      pieces_[b.piece].kind == Piece::Kind::flat || parted_by_edges(a, b, contact, true) != Meeting::at_contact)
    return false;
  const auto about = [&](const Facet& facet) {
    std::vector<Facet> all;
    const auto add = [&](std::uint32_t piece) {
      for (const Facet& one : facets_of(piece)) {
        bool has = false;
        for (std::size_t k = 0; k < one.corner_count; ++k) has = has || contact.has(corner(one, k));
        if (has) all.push_back(one);
      }
    };
    add(facet.piece);
    for (const auto& [other, bits] : pieces_[facet.piece].neighbours) add(other);
    return all;
  };
  const std::vector<Facet> of_b = about(b);
  return std::ranges::any_of(about(a), [&](const Facet& x) {
    return std::ranges::any_of(of_b,
                               [&](const Facet& y) { return facets_meet(x, y, contact) == Meeting::at_contact; });
  });
}

// If any plane parts two polygons, one does that is parallel to one of them or to an edge of each.
Pieces::Meeting Pieces::parted_by_edges(const Facet& a, const Facet& b, const Contact& contact,
                                        bool beside) const {
  const std::size_t n = a.corner_count, m = b.corner_count;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      RationalPoint normal = cross(corner(a, (i + 1) % n) - corner(a, i), corner(b, (j + 1) % m) - corner(b, j));
      if (is_zero(normal)) continue;
      for (const int turned : {1, -1}) {
        normal = Rational(turned) * normal;
        std::size_t high = 0, low = 0;  // the highest corner of a, the lowest of b
        for (std::size_t k = 0; k < n; ++k) {
          if (dot(normal, corner(a, k) - corner(a, high)) > 0) high = k;
        }
        for (std::size_t k = 0; k < m; ++k) {
          if (dot(normal, corner(b, k) - corner(b, low)) < 0) low = k;
        }
        const RationalPoint& at = corner(a, high);
        const int gap = sgn(dot(normal, corner(b, low) - at));
        if (gap < 0 || (!beside && !on_true_side(normal, at, a.piece, b, contact))) continue;
        if (gap > 0) return Meeting::apart;
        std::vector<const RationalPoint*> on_a, on_b;
        const PlaneEquation plane{normal[0], normal[1], normal[2], Rational(-dot(normal, at))};
        sides(plane, a, on_a);
        sides(plane, b, on_b);
        const Common common = in_common(on_a, on_b, contact);
        if (common != Common::more) return met(common, a, b, contact);
      }
    }
  }
  return Meeting::otherwise;
}

Pieces::Meeting Pieces::facets_meet(std::uint32_t a, std::uint32_t b, const Contact& contact) const {
  Meeting all = Meeting::apart;
  for (const Facet& f : facets_of(a)) {
    for (const Facet& g : facets_of(b)) {
      const Meeting one = facets_meet(f, g, contact);
      if (one == Meeting::otherwise && !beside_contact(f, g, contact)) return one;
      if (one != Meeting::apart) all = Meeting::at_contact;
    }
  }
  return all;
}

}  // namespace cnrg
