// The pieces of which a proof speaks: what facets are and what they stand for, side by side.
//
// A curved leaf has a map F from the parameters of its cells to its facets, and S to its true surfaces. The proof
// (proof.h) moves one into the other: H = (1 - t) F + t S for t from 0 to 1, or nearly (piece_columns.cpp). A
// *piece* is a cell of a curved patch, a flat face or an edge of a curve, with boxes that hold all its H, and the
// derivatives of all its H. PieceParts of a piece, by parameters, have smaller ones.
//
// Pieces lie on *sheets*. Sheets have one number where they are one surface in truth: planes where they are equal,
// curved patches by csg/carriers/surface_numbers.h.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "csg/carriers/placed_leaves.h"
#include "csg/certify/contact.h"
#include "csg/certify/piece_moulds.h"
#include "csg/curves/surface_math.h"
#include "csg/curves/surface_placed.h"
#include "kernel/refine/box.h"

namespace cnrg {

using Interval3 = Vector3<Interval>;

inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}
inline Interval3 hull(const Interval3& a, const Interval3& b) {
  return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}
inline double largest(const Interval& x) { return std::max(x.sup(), -x.inf()); }
inline Interval3 enclose3(const RationalPoint& p) {
  return {surface_math::enclose(p[0]), surface_math::enclose(p[1]), surface_math::enclose(p[2])};
}
/// Also where nothing is known of x (NaN).
inline bool holds_zero(const Interval& x) { return !(x.inf() > 0 || x.sup() < 0); }
inline bool holds_zero(const Interval3& x) {
  return std::all_of(x.begin(), x.end(), [](const Interval& c) { return c.inf() <= 0 && c.sup() >= 0; });
}
inline Box box_of(const Interval3& x) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) box.lo[k] = x[k].inf(), box.hi[k] = x[k].sup();
  return box;
}
inline Interval3 all_of(const Box& box) {
  return {Interval(box.lo[0], box.hi[0]), Interval(box.lo[1], box.hi[1]), Interval(box.lo[2], box.hi[2])};
}

// Guesses: what they are decides which steps a proof takes, on every machine the same ones.
using enclosure::Upward;
using Guess3 = Vector3<Upward>;
using enclosure::middle_of;
inline Guess3 middle_of(const Interval3& x) { return {middle_of(x[0]), middle_of(x[1]), middle_of(x[2])}; }
inline Upward width_of(const Interval& x) { return Upward(x.sup()) - x.inf(); }
inline Vector3<double> doubles(const Guess3& x) { return {double(x[0]), double(x[1]), double(x[2])}; }

Interval3 thin(const Guess3& x);
template <class N>
N length(const Vector3<N>& x) {
  using std::sqrt;
  return sqrt(surface_math::dot(x, x));
}
/// By so much, each coordinate.
inline Interval3 widened(Interval3 x, double by) {
  for (Interval& c : x) c += Interval(-by, by);
  return x;
}
/// To about length 1.
Interval3 normalized(const Interval3& x);
/// Of length 1; nothing if there is none.
template <class N>
std::optional<Vector3<N>> direction(const Vector3<N>& x) {
  using std::isfinite;
  const N size = length(x);
  if (!(size > 0) || !isfinite(size)) return std::nullopt;
  return surface_math::scaled(N(N(1) / size), x);
}
/// True if the cones of normals, two or three, hold no dependent vectors.
bool independent(const Interval3& a, const Interval3& b);
bool independent(const Interval3& a, const Interval3& b, const Interval3& c);

struct Piece {
  enum class Kind : std::uint8_t { cell, flat, curve };
  Kind kind = Kind::cell;
  bool grid = false;   ///< of a cell: four corners, those of `range` in u and v
  bool bent = false;   ///< of a grid: its facets are two triangles, which share corners 0 and 2
  bool blind = false;  ///< its directions are not known: a net at its pole
  bool wall = false;   ///< of a flat piece of an extrusion or skin: its sides are straight
  std::uint8_t corner_count = 0;
  std::uint8_t torn = 0;  ///< of a cell: bits of the sides whose curve is not the one beside it
  LeafId leaf;
  std::uint32_t patch = 0;                       ///< Soup::Face::patch; of a wire Soup::Wire::leaf_edge
  std::uint32_t sheet = 0;                       ///< of a curve: a number of its own, equal along one curve
  std::array<std::uint32_t, 4> points{};         ///< corners by number, equal ones of one leaf are one
  std::array<std::array<double, 2>, 4> at{};     ///< their parameters, in the middle of `bounds`
  std::array<Interval3, 4> corners{};            ///< where they are
  std::array<Interval, 2> range{0, 0};           ///< of u and v; of a curve the first, from 0 to 1
  Interval3 along_u{0, 0, 0}, along_v{0, 0, 0};  ///< of F, hulls, of a grid up to factors; of a curve the first
  /// Of a cell with a side that is a point, where it is known (piece_poles.cpp): the parameter that leads `away`
  /// from there, its value `at` the point and the half of it that is `near`; in that half what is at right angles
  /// to all H of all cells about the point.
  struct Pole {
    std::size_t away;
    double at;
    Interval near;
    Interval3 normals;
    std::array<Interval3, 2> along;             ///< all H of this cell there, by x and by y
    std::array<std::array<double, 2>, 2> ends;  ///< of x and y: the directions of its sides
    bool is_near(const std::array<Interval, 2>& range) const {
      return near.inf() <= range[away].inf() && range[away].sup() <= near.sup();
    }
  };
  std::optional<Pole> pole{};
  /// Of cells between two half-planes through the axis of their surface of revolution, and of curves from one to
  /// the other: F is at the angle of S, and H turns as the column does (piece_columns.cpp).
  struct Column {
    std::size_t around;      ///< the parameter that is the angle
    Interval half, tangent;  ///< turns from the middle to a side, and their tangent
    double flat;             ///< 1 less the cosine of `half`
    double off;              ///< of two triangles: how far they are from one plane, by rounded corners
    double turned;           ///< by how much these may turn directions
    double chord;            ///< how far F and S are apart in the half-plane of a side, at most
    double tilt;             ///< by how much directions along the meridian may differ from F's and S's, by `flat`
    /// How far H is from (1 - t) F + t S, at most.
    double bulge() const { return double(Upward(chord) * flat * 0.25); }
    /// How far a point of a straight edge is from one end to the other, by how far its angle is.
    Interval share(const Interval& way) const;
    Interval growth(const Interval& way) const;  ///< its derivative
  };
  std::optional<Column> column{};
  std::array<double, 2> turn{0, 0};        ///< about how far its normal turns along u and v, in radians
  const PlacedSurface* surface = nullptr;  ///< of a cell, or of a curve that is a side of one
  std::shared_ptr<const Curve> curve{};    ///< of a curved wire
  std::array<std::array<Interval, 2>, 2> side{
      {{0, 0}, {0, 0}}};  ///< of a curve: parameters of its ends on `surface` or `curve`
  /// Of a flat piece: its plane, and d . x for some d in it and all points x of it.
  Interval3 normal{0, 0, 0}, point{0, 0, 0};
  std::vector<std::pair<Guess3, Interval>> limits{};
  std::vector<std::uint32_t> corner_numbers{};  ///< of a flat piece, ascending
  /// Of a curve: the sheets that it lies in, ascending.
  std::vector<std::uint32_t> in_sheets{};
  /// Cells of the same patch that share corners, and which (bits); curves that go on from its ends.
  std::vector<std::pair<std::uint32_t, std::uint8_t>> neighbours{};
  /// Pieces that continue the surface smoothly and are of another patch or leaf.
  std::vector<std::uint32_t> foreign{};
  Box box{};
  bool exact() const { return kind == Kind::flat || (kind == Kind::curve && surface == nullptr && !curve); }
  /// Its corners by number.
  std::span<const std::uint32_t> numbers() const {
    if (kind == Kind::flat) return corner_numbers;
    return {points.data(), kind == Kind::curve ? 2u : corner_count};
  }
};

/// All pieces of leaves as they are drawn.
class Pieces {
 public:
  /// `of_themselves`: leaves are asked whether they meet themselves, but for single surfaces with an equation.
  Pieces(const PlacedLeaves& leaves, std::span<const RationalPoint> reach, Moulds& moulds, bool of_themselves);
  const std::vector<Piece>& all() const { return pieces_; }
  /// True if the pieces, of one leaf, all have one corner in common.
  bool share_corner(std::span<const std::uint32_t> pieces) const;
  bool adjacent(std::uint32_t a, std::uint32_t b) const { return share_corner(std::array{a, b}); }
  /// True if they are proven to be at an angle all along a common side.
  bool cross_at_edge(std::uint32_t a, std::uint32_t b) const { return at_angle_.contains(std::minmax(a, b)); }
  /// Parameters of a cell that hold the corners which it has in common with another piece of its leaf.
  std::array<Interval, 2> range_beside(std::uint32_t cell, std::uint32_t other) const;
  /// By piece: the same one, beside the same ones, in a drawing of the same leaves; kNone if there is none.
  std::vector<std::uint32_t> same_in(const Pieces& other) const;
  /// Says that one goes on smoothly as the other.
  void join(std::uint32_t a, std::uint32_t b);
  /// True if two cells of one surface, of different leaves, are drawn so that they do not cross or overlap, or it
  /// is asked (proof.cpp): they are equal, lie in one plane, or on a quadric in one convex polyhedron.
  bool drawn_alike(std::uint32_t a, std::uint32_t b) const;
  /// True if all their facets are in one plane, or those of one are those of the other or of a cell beside it:
  /// what is asked of a patch itself tells how they meet.
  bool drawn_as_one(std::uint32_t a, std::uint32_t b) const;
  /// True if corners of two pieces that are not flat, by their places there, are one point.
  bool same_corner(std::uint32_t a, std::size_t i, std::uint32_t b, std::size_t j) const;
  /// True if an end of a curve is in the plane of a flat piece, or is a corner of another one, exactly.
  bool ends_in(const Piece& curve, std::size_t end, const Piece& other) const;
  /// Away from a flat piece in its plane, at right angles to two of its points; nothing if it is on both sides.
  std::optional<Interval3> away_from(const Piece& flat, std::uint32_t p, std::uint32_t q) const;
  /// What two sheets have in common, if one is on one side of the other, exactly.
  const std::optional<Contact>& contact_of(std::uint32_t sheet, std::uint32_t other);
  bool is_quadric(std::uint32_t sheet) const { return equations_.quadrics.contains(sheet); }
  /// A quadric or torus does not meet itself.
  bool has_equation(std::uint32_t sheet) const { return is_quadric(sheet) || equations_.tori.contains(sheet); }
  /// Whether it is asked if pieces of the leaf meet.
  bool asked_of_itself(LeafId leaf) const { return own_.contains(leaf); }
  /// True if a cell has an equation and perhaps a side in the plane of a flat piece.
  bool may_share_rim(std::uint32_t flat, std::uint32_t cell) const;
  /// Sides of two such cells in one plane, for all t: one conic with the same corners, so that they have a side or
  /// a corner in common there and nothing else, or (not `shared`) one within the other.
  struct Rim {
    std::array<int, 2> sides{0, 0};  ///< of the plane, by its equation, on which the cells are
    bool shared = false;
  };
  /// Nothing where that is not proven. The plane is across axes, or through that of a torus.
  const std::optional<Rim>& rim(std::uint32_t flat, std::uint32_t a, std::uint32_t b);
  /// Of a flat sheet.
  const PlaneEquation& plane_of(std::uint32_t sheet) const { return planes_.at(sheet); }
  /// How the facets of two cells, or of a cell and a flat piece, meet.
  enum class Meeting : std::uint8_t {
    apart,       ///< one is on one side of the other, without a common point
    at_contact,  ///< the same, and what they have in common is on the contact
    otherwise,
  };
  Meeting facets_meet(std::uint32_t a, std::uint32_t b, const Contact& contact) const;
  /// True for cells of two cylinders with normals in common only in a ruling each, drawn exactly, which cross: the
  /// curve in which cylinders cross passes through itself there, and so do facets, whatever t is. Or for such a
  /// cell and a straight line in place of the other ruling.
  bool cross_in_rulings(std::uint32_t a, std::uint32_t b) const;
  /// Leaves with curved patches of which no surface is known, such as those of a CAD model; ascending.
  const std::set<LeafId>& unknown() const { return unknown_; }

 private:
  /// A facet of a cell, by its corners, or a flat piece.
  struct Facet {
    std::uint32_t piece;
    std::uint8_t corner_count;
    std::array<std::uint8_t, 4> corners;
  };
  std::vector<Facet> facets_of(std::uint32_t piece) const;
  /// Of a piece that is not flat.
  const RationalPoint& corner(const Facet& facet, std::size_t k) const;
  RationalPoint normal_of(const Facet& facet) const;
  /// True if the contact, a line or conic, runs along the border of the cell, or not through it.
  bool along_border(const Facet& cell, const Facet& other, const Contact& contact) const;
  /// True if corners of `of` are on the side of a plane, through `at` of `cell`, on which they are of its surface.
  bool on_true_side(const RationalPoint& normal, const RationalPoint& at, std::uint32_t cell, const Facet& of,
                    const Contact& contact) const;
  /// Of cells: by planes along an edge of each. `beside`: it does not matter on which side of the other one is.
  Meeting parted_by_edges(const Facet& a, const Facet& b, const Contact& contact, bool beside = false) const;
  /// True if cells have the point of a contact in common and are beside each other there, as others about it are.
  bool beside_contact(const Facet& a, const Facet& b, const Contact& contact) const;
  /// Of the surface of a cell, of which an equation is known, outwards, and on which side a point is.
  RationalPoint gradient(std::uint32_t cell, const RationalPoint& p) const;
  int side(std::uint32_t cell, const RationalPoint& p) const;
  /// A quadric that has the same curve in the plane, about p, as a surface with an equation.
  std::optional<Quadric> trace(std::uint32_t sheet, const RationalPoint& normal, const RationalPoint& p) const;
  /// The corners of a cell in a plane, the ends of a side that is there, and on which side of the plane others
  /// are.
  struct RimSide {
    std::set<RationalPoint> ends;
    int side = 0;
  };
  const std::optional<RimSide>& rim_side(std::uint32_t sheet, std::uint32_t cell);
  std::optional<Rim> find_rim(std::uint32_t sheet, const std::array<std::uint32_t, 2>& cells,
                              const std::array<const std::set<RationalPoint>*, 2>& ends) const;
  PlaneEquation equation_of(const Facet& facet) const;
  bool holds(const Facet& facet, const std::vector<const RationalPoint*>& points) const;
  /// The sides of a plane on which corners of a facet are: 1 in front, 2 behind; and those on it.
  int sides(const PlaneEquation& plane, const Facet& of, std::vector<const RationalPoint*>& on) const;
  Meeting facets_meet(const Facet& a, const Facet& b, const Contact& contact) const;
  /// Of a ruling that is a side of the cell of a cylinder and has the normal n or -n: along n where the axis is,
  /// how far it is from there as it is drawn, and the square of how far it is in truth. A line is its own axis.
  std::optional<std::array<Rational, 3>> ruling(std::uint32_t cell, const CylinderAxis& axis,
                                                const RationalPoint& n) const;
  enum class Common : std::uint8_t { nothing, contact, more };
  /// Of convex polygons that have no more than an edge each in a plane between them: of these.
  static Common in_common(const std::vector<const RationalPoint*>& a, const std::vector<const RationalPoint*>& b,
                          const Contact& contact);
  /// Of a cell, and another one or a flat piece.
  Meeting met(Common common, const Facet& a, const Facet& b, const Contact& contact) const;
  const Interval3& rough(const Facet& facet, std::size_t k) const {
    return pieces_[facet.piece].corners[facet.corners[k]];
  }
  Interval3 rough_normal(const Facet& facet) const;
  /// As `sides`.
  int sides_of(const Facet& plane, const Facet& of) const;
  std::vector<std::shared_ptr<const LeafSurfaces>> leaf_surfaces_;
  std::map<std::pair<LeafId, std::uint32_t>, std::unique_ptr<const PlacedSurface>> placed_;
  std::vector<Piece> pieces_;
  std::map<LeafId, std::vector<RationalPoint>> points_;  // by number, placed
  std::map<std::uint32_t, PlaneEquation> planes_;        // by sheet
  SurfaceEquations equations_;                           // by sheet
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::optional<Contact>> contacts_;
  std::map<std::array<std::uint32_t, 2>, std::optional<RimSide>> rim_sides_;  // by sheet and cell
  std::map<std::array<std::uint32_t, 3>, std::optional<Rim>> rims_;           // by sheet and cells
  std::set<LeafId> unknown_, own_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> at_angle_;
  friend class PieceMaker;
};

/// The pieces at an edge of a leaf, and which side of each it is; kNone for cells that are no pieces.
using PieceSides =
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::pair<std::uint32_t, std::uint8_t>>>;
/// Sets which cells from `first` on, of one leaf, share corners with others of their patch.
void find_neighbours(std::vector<Piece>& all, std::size_t first);
/// Sets which of them are in columns.
void find_columns(std::vector<Piece>& all, std::size_t first, const PieceSides& sides);
/// Sets what cells from `first` on, of one leaf, have at poles; `neighbours` and columns are known.
void find_poles(std::vector<Piece>& all, std::size_t first);

}  // namespace cnrg
