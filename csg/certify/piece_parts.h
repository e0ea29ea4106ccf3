// Parts of pieces by parameters, which a proof halves (proof.h): what they hold, and whether a plane parts them.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "csg/certify/pieces.h"

namespace cnrg {

/// What a part is of: facets and surfaces and all between, or surfaces alone.
enum class Between : std::uint8_t { facets_and_surfaces, surfaces };

/// A part of a piece: what its parameters are limited to, a box around it for all t, and what is at right angles
/// to it there (of a curve: along it), for all t, up to factors.
struct PiecePart {
  const Piece* piece = nullptr;
  std::array<Interval, 2> range{0, 0};
  Interval3 box{}, cone{};
  Interval3 along_u{}, along_v{};  ///< of S
  bool blind = false;              ///< `cone` says nothing
  /// F is in their convex hull; of a cell, not of surfaces alone.
  struct FacetCorners {
    std::array<Interval3, 6> all;
    std::size_t count = 0;
    void add(const Interval3& p) { all[count++] = p; }
  } facet{};
  /// How much of its piece it is by u and by v, added; 0 of what is flat; and the parameter by which it is more.
  Upward share() const;
  std::size_t longer() const;
  /// S in the middle of the range, once it is asked for.
  const Interval3& middle() const;
  /// About how far facets are from the surface there.
  double thickness() const;
  mutable std::optional<Interval3> known_middle{};
  mutable std::optional<double> known_thickness{};
};
/// Of all pieces of `all`; who calls keeps an enclosure::RoundOutward alive, here and below.
PiecePart part_of(const std::vector<Piece>& all, const Piece& piece, const std::array<Interval, 2>& range,
                  Between between = Between::facets_and_surfaces);
/// How much a half of a part would tell, by u and by v, lengths: how far the surface goes in a direction d, and
/// how far it bends away from a plane.
std::array<Upward, 2> gains(const PiecePart& part, const Guess3& d);
/// The parameter that leads away from a pole of the part, if no cone holds its normals: they go all around.
std::optional<std::size_t> way_from_pole(const PiecePart& part);
/// Two halves by u (0) or v (1).
std::array<PiecePart, 2> halves(const std::vector<Piece>& all, const PiecePart& part, std::size_t k,
                                Between between);
/// What holds d . x for all x of a part: of its facets, and of its surface.
struct Extents {
  Interval facets{0}, surface{0};
  double bulge = 0;
  Interval all() const { return hull(facets, surface) + Interval(-bulge, bulge); }
};
Extents extents(const PiecePart& part, const Guess3& d, Between between);
/// True if parts with these extents have no point in common at any t: facets and surfaces are on the same sides.
bool parted(const Extents& a, const Extents& b);
/// True if two of the parts are on different sides of a plane across one of them.
bool parted(std::span<const PiecePart> parts, Between between);

/// True if a plane across one, or along a side of one and a side of the other is between them.
bool parted_along_sides(const PiecePart& a, const PiecePart& b);
/// True for two or three parts, none of them blind, that are at an angle wherever they meet, and no curve ends
/// there.
bool at_angle(const Pieces& pieces, std::span<const PiecePart> parts);
/// True if the box has no point of the flat piece.
bool misses(const Piece& flat, const Interval3& box);
/// True if a contact along a line has no point of the part in the box.
bool misses_line(const PiecePart& part, const Contact& contact, const Interval3& box, Between between);
double size_of(const Interval3& x);
/// The box, or where it has no bounds, since cells are narrower than doubles tell, that of the corners of a piece.
Interval3 bounded(const Interval3& box, const Piece& piece);
/// False where a part of a piece is no longer than facets are away from the surface there: it gets no thinner.
bool worth_halving(const PiecePart& part, const PiecePart& whole, Between between);
/// Nothing if it is empty.
std::optional<Interval3> common_box(std::span<const PiecePart> parts);

/// True if derivatives prove that two cells of a patch have no point in common but for equal parameters.
bool differ(const std::vector<Piece>& all, std::span<const std::uint32_t> patch, std::uint32_t a, std::uint32_t b);

/// How often parts are halved for one of the questions below; `steps` gets more by it.
constexpr std::size_t kMostOwnSteps = 200;
/// True if H is one to one on two parts of a patch, for they are near a pole.
bool about_pole(const PiecePart& a, const PiecePart& b);
/// True if `proven(x, y)` holds of two parts, or of all pairs into which the larger ones are halved.
template <class Proven>
bool proven_by_halves(const std::vector<Piece>& all, const PiecePart& a, const PiecePart& b, const Proven& proven,
                      std::size_t& left) {
  if (!box_of(a.box).meets(box_of(b.box)) || about_pole(a, b) || proven(a, b)) return true;
  if (left == 0) return false;
  --left;
  const bool first = a.share() >= b.share();
  const PiecePart& part = first ? a : b;
  return std::ranges::all_of(halves(all, part, part.longer(), Between::facets_and_surfaces),
                             [&](const PiecePart& half) {
                               return proven_by_halves(all, first ? half : a, first ? b : half, proven, left);
                             });
}
/// True if two pieces, flat or in columns, have a side in common that ends in a pole: a half-plane parts them.
bool meet_at_pole(const Piece& a, const Piece& b);
/// True if H is one to one on two cells of a patch that have corners in common, or on one. `patch`: all its cells.
bool one_to_one(const Pieces& pieces, std::span<const std::uint32_t> patch, std::uint32_t a, std::uint32_t b,
                std::size_t& steps);
/// True if two pieces have no more in common than their common side or corner (piece_beside.cpp). They do not meet
/// at a pole; a curve may be asked with itself.
bool apart_but_beside(const Pieces& pieces, std::uint32_t a, std::uint32_t b, std::size_t& steps);
/// True if two pieces that are not flat have a corner in common, of one leaf or of two.
bool share_corner(const Pieces& pieces, std::uint32_t a, std::uint32_t b);

}  // namespace cnrg
