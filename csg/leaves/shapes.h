// The leaves of a tree as data: what the tree file says, before any geometry is made (SEMANTICS 7).
//
// All numbers are exact. Lengths are in the model's unit. Angles are in degrees. The tree reader fills these
// structures; `add_to_soup` (leaf.h) makes their geometry.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "kernel/exact/rational.h"
#include "kernel/refine/soup.h"

namespace cnrg {

/// `{box: {min: [x, y, z], max: [x, y, z]}}`, min < max in every axis.
struct BoxShape { RationalPoint min, max; };
/// `{prism: {base: [[x, y, z], ...], vector: [x, y, z]}}`: a planar simple polygon swept along a vector; `holes` likewise.
struct PrismShape { std::vector<RationalPoint> base; std::vector<std::vector<RationalPoint>> holes; RationalPoint vector; };
/// `{pyramid: {base: [[x, y, z], ...], apex: [x, y, z]}}`
struct PyramidShape { std::vector<RationalPoint> base; RationalPoint apex; };
/// `{tetrahedron: [p, q, r, s]}`
struct TetrahedronShape { std::array<RationalPoint, 4> points; };
/// `{polygon: [p, ...]}` or `{polygon: {outer: [p, ...], holes: [[p, ...], ...]}}`: planar, simple loops.
struct PolygonShape { std::vector<RationalPoint> outer; std::vector<std::vector<RationalPoint>> holes; };
/// `{polyline: [p, ...]}` or `{polyline: {points: [p, ...], closed: true}}`
struct PolylineShape { std::vector<RationalPoint> points; bool closed = false; };
/// `{points: [p, ...]}`
struct PointsShape { std::vector<RationalPoint> points; };
/// `{plane: {point: p, normal: n}}`: the whole plane as one face.
struct PlaneShape { RationalPoint point, normal; };
/// `{halfspace: {point: p, normal: n}}`: one region on the side that the normal points away from.
struct HalfspaceShape { RationalPoint point, normal; };
/// `{sphere: {center: p, radius: r, segments: n, rings: m}}`: n meridians, m rows (default n / 2).
struct SphereShape { RationalPoint center; Rational radius; int segments = 32, rings = 0; };
/// `{cylinder: {from: p, to: q, radius: r, segments: n}}`
struct CylinderShape { RationalPoint from, to; Rational radius; int segments = 32; };
/// `{cone: {from: p, to: q, radius: r, top: r2, segments: n}}`: radius at `from`, `top` (default 0) at `to`.
struct ConeShape { RationalPoint from, to; Rational radius, top = 0; int segments = 32; };
/// `{torus: {center: p, axis: n, radius: R, tube: r, segments: n, rings: m}}`
struct TorusShape { RationalPoint center, axis; Rational radius, tube; int segments = 32, rings = 16; };
/// `{heightfield: {origin: [x, y], spacing: [dx, dy], heights: [[z, ...], ...]}}` (rows run along y, entries of
/// a row along x) or `{heightfield: {file: grid.asc}}` (ESRI ASCII grid). A surface; each cell is two triangles
/// of one patch. With `base: z` the solid down to that level.
struct HeightfieldShape {
  Rational origin_x = 0, origin_y = 0, spacing_x = 1, spacing_y = 1;
  std::vector<std::vector<Rational>> heights;
  std::string file;
  std::optional<Rational> base;
};
/// `{mesh: {file: part.off, fill: winding, coordinates: decimal}}`: OFF, OBJ, STL, PLY; path already resolved.
struct MeshShape { std::string file; std::optional<Fill> fill; bool decimal = false; };
/// `{group: {vertices, faces, edges, points, regions, fill}}` as INTERFACE has it.
struct GroupShape {
  struct Face {
    std::vector<std::vector<std::uint32_t>> loops;
    std::array<std::uint32_t, 2> sides{0, 0};
    int line = 0, column = 0;        ///< where the tree file has it, for errors
  };
  struct Region { std::string material, name; };
  std::vector<RationalPoint> vertices;
  std::vector<Face> faces;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> points;
  std::map<std::uint32_t, Region> regions;
  std::optional<Fill> fill;          ///< instead of sides
};
/// `{cnrg: file.json}`: a result read back.
struct ResultShape { std::string file; };

using Shape = std::variant<BoxShape, PrismShape, PyramidShape, TetrahedronShape, PolygonShape, PolylineShape, PointsShape,
                           PlaneShape, HalfspaceShape, SphereShape, CylinderShape, ConeShape, TorusShape,
                           HeightfieldShape, MeshShape, GroupShape, ResultShape>;

/// An exact affine map: p -> A p + b.
struct Transform {
  std::array<std::array<Rational, 3>, 3> linear{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  RationalPoint offset{0, 0, 0};
  static Transform translation(const RationalPoint& by);
  static Transform scaling(const RationalPoint& factors);              ///< no factor is zero
  /// By `degrees` about an axis through `center`: multiples of 90 degrees about a coordinate axis are exact;
  /// else the nearest rational rotation (exactly orthogonal; the angle's error is below 1e-15).
  static Transform rotation(const RationalPoint& axis, const Rational& degrees, const RationalPoint& center);
  /// The plane through `point` with `normal` as mirror.
  static Transform reflection(const RationalPoint& normal, const RationalPoint& point);
  bool identity() const;
  Rational determinant() const;
  RationalPoint apply(const RationalPoint& p) const;
  /// First `inner`, then this.
  Transform operator*(const Transform& inner) const;
};

}  // namespace cnrg
