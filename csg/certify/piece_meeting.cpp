// How pieces of one leaf hang together, and how facets of two leaves meet, exactly; see the header.
#include <algorithm>
#include <unordered_map>

#include "csg/certify/pieces.h"
#include "kernel/base/limits.h"
#include "kernel/base/point_hash.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {

using namespace surface_math;

namespace {

std::span<const std::uint32_t> corner_numbers(const Piece& piece) {
  if (piece.kind == Piece::Kind::flat) return piece.corner_numbers;
  return {piece.points.data(), piece.kind == Piece::Kind::curve ? 2u : piece.corner_count};
}
bool has_corner(const Piece& piece, std::uint32_t number) {
  const auto numbers = corner_numbers(piece);
  return piece.kind == Piece::Kind::flat ? std::binary_search(numbers.begin(), numbers.end(), number)
                                         : std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

bool Pieces::adjacent(std::uint32_t a, std::uint32_t b) const {
  return std::ranges::any_of(corner_numbers(pieces_[a]),
                             [&](std::uint32_t p) { return has_corner(pieces_[b], p); });
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
  return a.corner_count == b.corner_count && a.grid == b.grid && a.bent == b.bent && a.blind == b.blind &&
         a.at == b.at && same(a.range, b.range) && same(corners(a), corners(b)) && !a.surface == !b.surface &&
         !a.curve == !b.curve && (cell || a.exact() || (same(a.side[0], b.side[0]) && same(a.side[1], b.side[1])));
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
  if (pieces_[facet.piece].kind == Piece::Kind::flat) return planes_.at(pieces_[facet.piece].sheet);
  const RationalPoint normal = normal_of(facet);
  return {normal[0], normal[1], normal[2], Rational(-dot(normal, corner(facet, 0)))};
}

/// True if one of the points is in the closed hull of the corners of a facet, which are in one plane with it.
bool Pieces::holds(const Facet& facet, const std::vector<const RationalPoint*>& points) const {
  const RationalPoint normal = normal_of(facet);
  const std::size_t n = facet.corner_count;
  return std::ranges::any_of(points, [&](const RationalPoint* p) {
    int seen = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const RationalPoint& from = corner(facet, k);
      const int side = sgn(dot(normal, cross(corner(facet, (k + 1) % n) - from, *p - from)));
      seen |= side > 0 ? 1 : side < 0 ? 2 : 0;
    }
    return seen != 3 && dot(normal, *p - corner(facet, 0)) == 0;
  });
}

int Pieces::sides(const PlaneEquation& equation, const Facet& of, std::vector<const RationalPoint*>& on) const {
  int result = 0;
  for (std::size_t k = 0; k < of.corner_count; ++k) {
    const RationalPoint& p = corner(of, k);
    const int side = sgn(equation[0] * p[0] + equation[1] * p[1] + equation[2] * p[2] + equation[3]);
    result |= side > 0 ? 1 : side < 0 ? 2 : 0;
    if (side == 0) on.push_back(&p);
  }
  return result;
}

bool Pieces::drawn_alike(std::uint32_t a, std::uint32_t b) const {
  std::vector<const RationalPoint*> on;
  return std::ranges::all_of(facets_of(a), [&](const Facet& f) {
    return std::ranges::all_of(facets_of(b), [&](const Facet& g) {
      return sides(equation_of(f), g, on) != 3 || sides(equation_of(g), f, on) != 3;
    });
  });
}

const std::optional<Contact>& Pieces::contact_of(std::uint32_t sheet, std::uint32_t other) {
  const auto [it, fresh] = contacts_.try_emplace(std::minmax(sheet, other));
  if (!fresh) return it->second;
  const auto first = quadrics_.find(sheet), second = quadrics_.find(other);
  const auto plane = planes_.find(first == quadrics_.end() ? sheet : other);
  if (first != quadrics_.end() && second != quadrics_.end()) it->second = contact(first->second, second->second);
  else if ((first != quadrics_.end() || second != quadrics_.end()) && plane != planes_.end())
    it->second = contact(plane->second, (first != quadrics_.end() ? first : second)->second);
  return it->second;
}

namespace {

Rational row_times(const Quadric& q, std::size_t row, const RationalPoint& p) {
  return q[row][0] * p[0] + q[row][1] * p[1] + q[row][2] * p[2] + q[row][3];
}
RationalPoint gradient(const Quadric& q, const RationalPoint& p) {
  return {row_times(q, 0, p), row_times(q, 1, p), row_times(q, 2, p)};
}

}  // namespace

bool Pieces::on_true_side(const Facet& plane, const Facet& of, const Contact& contact) const {
  const Quadric& q = quadrics_.at(pieces_[plane.piece].sheet);
  const RationalPoint& at = corner(plane, 0);
  const RationalPoint normal = normal_of(plane);
  const int turned = sgn(dot(normal, gradient(q, at)));
  for (std::size_t k = 0; k < of.corner_count; ++k) {
    const RationalPoint& p = corner(of, k);
    if (contact.has(p)) continue;  // on both surfaces, but for what is rounded
    const int of_facet = sgn(dot(normal, p - at));
    const int of_surface = sgn(dot(p, gradient(q, p)) + row_times(q, 3, p));
    if (of_facet != 0 && of_facet * turned != of_surface) return false;
  }
  return turned != 0;
}

// The plane through the contact and at right angles to the surfaces has the cell on one side, as far as it is
// near.
bool Pieces::along_border(const Facet& cell, const Facet& other, const Contact& contact) const {
  if (contact.kind == Contact::Kind::point) return true;
  RationalPoint normal = contact.direction;
  if (contact.kind == Contact::Kind::line) {
    const auto quadric = quadrics_.find(pieces_[cell.piece].sheet);
    const RationalPoint out = gradient(
        quadric != quadrics_.end() ? quadric->second : quadrics_.at(pieces_[other.piece].sheet), contact.point);
    // The plane of the facet's pole, if the contact passes through it, and its two sides from there.
    const auto& points = pieces_[cell.piece].points;
    for (std::size_t k = 0; k < cell.corner_count; ++k) {
      const std::size_t n = cell.corner_count, next = (k + 1) % n;
      if (points[cell.corners[k]] != points[cell.corners[next]] || !contact.has(corner(cell, k))) continue;
      const RationalPoint& pole = corner(cell, k);
      const RationalPoint first = corner(cell, (next + 1) % n) - pole,
                          second = corner(cell, (k + n - 1) % n) - pole, across = cross(first, second);
      RationalPoint way = contact.direction;
      if (dot(way, first + second) < 0) way = Rational(-1) * way;
      // way = x first + y second + z across
      const Rational x = dot(cross(way, second), across), y = dot(cross(first, way), across);
      return !(x > 0 && y > 0);
    }
    normal = cross(contact.direction, out);
    if (is_zero(normal)) return false;  // at the apex of a cone
  }
  std::vector<const RationalPoint*> on;
  return sides({normal[0], normal[1], normal[2], Rational(-dot(normal, contact.point))}, cell, on) != 3;
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
    if (pieces_[plane.piece].kind == Piece::Kind::cell && !on_true_side(plane, of, contact)) continue;
    // What is not flat has the common points as corners, too.
    const bool met = !on.empty() && (pieces_[plane.piece].kind == Piece::Kind::flat || holds(plane, on));
    if (!met) return Meeting::apart;
    return along_border(of, plane, contact) ||
                   (pieces_[plane.piece].kind == Piece::Kind::cell && along_border(plane, of, contact))
               ? Meeting::at_contact
               : Meeting::otherwise;
  }
  if (pieces_[a.piece].kind == Piece::Kind::flat || pieces_[b.piece].kind == Piece::Kind::flat ||
      (contact.kind != Contact::Kind::point && contact.kind != Contact::Kind::line))
    return Meeting::otherwise;
  const RationalPoint normal = gradient(quadrics_.at(pieces_[a.piece].sheet), contact.point);
  if (is_zero(normal)) return Meeting::otherwise;
  const PlaneEquation tangent{normal[0], normal[1], normal[2], Rational(-dot(normal, contact.point))};
  std::vector<const RationalPoint*> on_a, on_b;
  const int of_a = sides(tangent, a, on_a), of_b = sides(tangent, b, on_b);
  if (of_a == 0 || of_b == 0 || (of_a | of_b) != 3 || of_a == of_b || !at_contact(on_a) || !at_contact(on_b))
    return Meeting::otherwise;
  if (on_a.empty() || !holds(b, on_a)) return Meeting::apart;
  return along_border(a, b, contact) || along_border(b, a, contact) ? Meeting::at_contact : Meeting::otherwise;
}

Pieces::Meeting Pieces::facets_meet(std::uint32_t a, std::uint32_t b, const Contact& contact) const {
  Meeting all = Meeting::apart;
  for (const Facet& f : facets_of(a)) {
    for (const Facet& g : facets_of(b)) {
      const Meeting one = facets_meet(f, g, contact);
      if (one == Meeting::otherwise) return one;
      if (one == Meeting::at_contact) all = one;
    }
  }
  return all;
}

}  // namespace cnrg
