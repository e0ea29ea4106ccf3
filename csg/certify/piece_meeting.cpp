// How pieces of one leaf hang together, and how facets of two leaves meet, exactly; see the header.
#include <algorithm>

#include "csg/certify/pieces.h"
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

void Pieces::join(std::uint32_t a, std::uint32_t b) {
  for (const auto& [x, y] : {std::pair(a, b), std::pair(b, a)}) {
    if (pieces_[x].kind == Piece::Kind::cell) pieces_[x].foreign.push_back(y);
  }
}

const RationalPoint& Pieces::corner(std::uint32_t piece, std::size_t k) const {
  return points_.at(pieces_[piece].leaf)[pieces_[piece].points[k]];
}

RationalPoint Pieces::normal_of(std::uint32_t cell) const {
  const RationalPoint& first = corner(cell, 0);
  const RationalPoint normal = cross(corner(cell, 1) - first, corner(cell, 2) - first);
  if (!is_zero(normal)) return normal;
  return cross(corner(cell, 2) - first, corner(cell, pieces_[cell].corner_count - 1u) - first);
}

PlaneEquation Pieces::equation_of(std::uint32_t piece) const {
  if (pieces_[piece].kind == Piece::Kind::flat) return planes_.at(pieces_[piece].sheet);
  const RationalPoint normal = normal_of(piece);
  return {normal[0], normal[1], normal[2], Rational(-dot(normal, corner(piece, 0)))};
}

/// True if one of the points is in the closed hull of the corners of a piece, which are in one plane with it.
bool Pieces::holds(std::uint32_t piece, const std::vector<const RationalPoint*>& points) const {
  const RationalPoint normal = normal_of(piece);
  const std::size_t n = pieces_[piece].corner_count;
  return std::ranges::any_of(points, [&](const RationalPoint* p) {
    int seen = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const RationalPoint& from = corner(piece, k);
      const int side = sgn(dot(normal, cross(corner(piece, (k + 1) % n) - from, *p - from)));
      seen |= side > 0 ? 1 : side < 0 ? 2 : 0;
    }
    return seen != 3 && dot(normal, *p - corner(piece, 0)) == 0;
  });
}

int Pieces::sides(const PlaneEquation& equation, std::uint32_t of, std::vector<const RationalPoint*>& on) const {
  int result = 0;
  for (std::size_t k = 0; k < pieces_[of].corner_count; ++k) {
    const RationalPoint& p = corner(of, k);
    const int side = sgn(equation[0] * p[0] + equation[1] * p[1] + equation[2] * p[2] + equation[3]);
    result |= side > 0 ? 1 : side < 0 ? 2 : 0;
    if (side == 0) on.push_back(&p);
  }
  return result;
}

bool Pieces::drawn_alike(std::uint32_t a, std::uint32_t b) const {
  std::vector<const RationalPoint*> on;
  return sides(equation_of(a), b, on) != 3 || sides(equation_of(b), a, on) != 3;
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

bool Pieces::on_true_side(std::uint32_t plane, std::uint32_t of, const Contact& contact) const {
  const Quadric& q = quadrics_.at(pieces_[plane].sheet);
  const RationalPoint& at = corner(plane, 0);
  const RationalPoint normal = normal_of(plane);
  const int turned = sgn(dot(normal, gradient(q, at)));
  for (std::size_t k = 0; k < pieces_[of].corner_count; ++k) {
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
bool Pieces::along_border(std::uint32_t cell, std::uint32_t other, const Contact& contact) const {
  if (contact.kind == Contact::Kind::point) return true;
  RationalPoint normal = contact.direction;
  if (contact.kind == Contact::Kind::line) {
    const auto quadric = quadrics_.find(pieces_[cell].sheet);
    const RationalPoint out =
        gradient(quadric != quadrics_.end() ? quadric->second : quadrics_.at(pieces_[other].sheet), contact.point);
    // The plane of the facet's pole, if the contact passes through it, and its two sides from there.
    for (std::size_t k = 0; k < pieces_[cell].corner_count; ++k) {
      const std::size_t n = pieces_[cell].corner_count, next = (k + 1) % n;
      if (pieces_[cell].points[k] != pieces_[cell].points[next] || !contact.has(corner(cell, k))) continue;
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
Pieces::Meeting Pieces::facets_meet(std::uint32_t a, std::uint32_t b, const Contact& contact) const {
  const auto at_contact = [&](const std::vector<const RationalPoint*>& on) {
    return std::ranges::all_of(on, [&](const RationalPoint* p) { return contact.has(*p); });
  };
  for (const auto& [plane, of] : {std::pair(a, b), std::pair(b, a)}) {
    if (pieces_[of].kind == Piece::Kind::flat) continue;
    std::vector<const RationalPoint*> on;
    const int side = sides(equation_of(plane), of, on);
    if (side == 3 || side == 0 || !at_contact(on)) continue;
    if (pieces_[plane].kind == Piece::Kind::cell && !on_true_side(plane, of, contact)) continue;
    // What is not flat has the common points as corners, too.
    const bool met = !on.empty() && (pieces_[plane].kind == Piece::Kind::flat || holds(plane, on));
    if (!met) return Meeting::apart;
    return along_border(of, plane, contact) ||
                   (pieces_[plane].kind == Piece::Kind::cell && along_border(plane, of, contact))
               ? Meeting::at_contact
               : Meeting::otherwise;
  }
  if (pieces_[a].kind == Piece::Kind::flat || pieces_[b].kind == Piece::Kind::flat ||
      (contact.kind != Contact::Kind::point && contact.kind != Contact::Kind::line))
    return Meeting::otherwise;
  const RationalPoint normal = gradient(quadrics_.at(pieces_[a].sheet), contact.point);
  if (is_zero(normal)) return Meeting::otherwise;
  const PlaneEquation tangent{normal[0], normal[1], normal[2], Rational(-dot(normal, contact.point))};
  std::vector<const RationalPoint*> on_a, on_b;
  const int of_a = sides(tangent, a, on_a), of_b = sides(tangent, b, on_b);
  if (of_a == 0 || of_b == 0 || (of_a | of_b) != 3 || of_a == of_b || !at_contact(on_a) || !at_contact(on_b))
    return Meeting::otherwise;
  if (on_a.empty() || !holds(b, on_a)) return Meeting::apart;
  return along_border(a, b, contact) || along_border(b, a, contact) ? Meeting::at_contact : Meeting::otherwise;
}

}  // namespace cnrg
