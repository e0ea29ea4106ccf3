// The leaves of a tree as data: what the tree file says, before any geometry is made (csg/FORMATS.md#leaves).
//
// All numbers are exact. Lengths are in the model's unit. Angles are in degrees. The tree reader fills these
// structures; `prepare` (leaf.h) reads and checks them, `make_soup` makes their geometry.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "kernel/exact/rational.h"
#include "kernel/refine/soup.h"

namespace cnrg {

struct MeshData;
class PreparedLeaf;

/// `{box: {min: [x, y, z], max: [x, y, z]}}`, min < max in every axis.
struct BoxShape {
  RationalPoint min, max;
};
/// `{prism: {base: [[x, y, z], ...], holes: [[[x, y, z], ...], ...], vector: [x, y, z], fit: 1e-5}}`: a planar
/// simple polygon with holes (if any), swept along a vector. `fit`: corners that are so nearly in a plane move
/// onto it (csg/weld/fit_polygon.h).
struct PrismShape {
  std::vector<RationalPoint> base;
  std::vector<std::vector<RationalPoint>> holes;
  RationalPoint vector;
  std::optional<Rational> fit{};  ///< a length above 0
};
/// `{pyramid: {base: [[x, y, z], ...], apex: [x, y, z], fit: 1e-5}}`
struct PyramidShape {
  std::vector<RationalPoint> base;
  RationalPoint apex;
  std::optional<Rational> fit{};  ///< as of a prism
};
/// `{tetrahedron: [p, q, r, s]}`
struct TetrahedronShape {
  std::array<RationalPoint, 4> points;
};
/// `{hull: [p, ...]}`: the convex hull; `{minkowski: [[p, ...], [p, ...], ...]}`: all sums of a point of each
/// hull.
struct HullShape {
  std::vector<std::vector<RationalPoint>> summands;  ///< one of `hull`, two or more of `minkowski`
  const char* name() const { return summands.size() == 1 ? "hull" : "minkowski"; }
};
/// `{polygon: [p, ...]}` or `{polygon: {outer: [p, ...], holes: [[p, ...], ...], fit: 1e-5}}`: planar, simple
/// loops.
struct PolygonShape {
  std::vector<RationalPoint> outer;
  std::vector<std::vector<RationalPoint>> holes;
  std::optional<Rational> fit{};  ///< as of a prism
};
/// `{disk: {center: p, radii: [a, b], normal: n, along: w, segments: n}}`, or `dip` and `strike` for `normal` and
/// `along`: a planar polygon of points on an ellipse, a along `along`, or the strike.
struct DiskShape {
  RationalPoint center;
  std::array<Rational, 2> radii;
  RationalPoint normal, along;  ///< neither of them 0; of the part of `along` across the normal
  int segments = 32;
};
/// `{polyline: [p, ...]}` or `{polyline: {points: [p, ...], closed: true}}`
struct PolylineShape {
  std::vector<RationalPoint> points;
  bool closed = false;
};
/// `{points: [p, ...]}`
struct PointsShape {
  std::vector<RationalPoint> points;
};
/// `{plane: {point: p, normal: n}}`: the whole plane as one face.
struct PlaneShape {
  RationalPoint point, normal;
};
/// `{halfspace: {point: p, normal: n}}`: one region on the side that the normal points away from.
struct HalfspaceShape {
  RationalPoint point, normal;
};
/// `{sphere: {center: p, radius: r, segments: n, rings: m}}`: n meridians, m rows (default n / 2).
struct SphereShape {
  RationalPoint center;
  Rational radius;
  int segments = 32, rings = 0;
};
/// `{cylinder: {from: p, to: q, radius: r, segments: n}}`
struct CylinderShape {
  RationalPoint from, to;
  Rational radius;
  int segments = 32;
};
/// `{cone: {from: p, to: q, radius: r, top: r2, segments: n}}`: radius at `from`, `top` (default 0) at `to`.
struct ConeShape {
  RationalPoint from, to;
  Rational radius, top = 0;
  int segments = 32;
};
/// `{torus: {center: p, axis: n, radius: R, tube: r, segments: n, rings: m}}`
struct TorusShape {
  RationalPoint center, axis;
  Rational radius, tube;
  int segments = 32, rings = 16;
};
/// `{heightfield: {origin: [x, y], spacing: [dx, dy], heights: [[z, ...], ...]}}` (rows run along y, entries of
/// a row along x) or `{heightfield: {file: grid.asc}}` (ESRI ASCII grid). A surface; each cell is two triangles
/// of one patch. With `base: z` the solid down to that level.
struct HeightfieldShape {
  Rational origin_x = 0, origin_y = 0, spacing_x = 1, spacing_y = 1;
  std::vector<std::vector<Rational>> heights;
  std::string file;
  std::optional<Rational> base, within{};
  std::string inside{};  ///< the folder that `file` must lie in (csg/text/input_file.h); empty: any
};
/// `{mesh: {file: part.off, fill: winding, coordinates: decimal, weld: 1e-6}}`: OFF, OBJ, STL, PLY; path already
/// resolved. Or `{mesh: {points: [p, ...], faces: [[i, j, k], ...], fill: winding, weld: 1e-6}}`: the mesh itself,
/// by the numbers of its points from 0. `weld`: what is that near is made to coincide (csg/imports/weld.h).
struct MeshShape {
  std::string file;  ///< empty: `data` is given
  std::optional<Fill> fill;
  bool decimal = false;
  std::string inside{};                    ///< as of a heightfield
  std::optional<Rational> weld{};          ///< a length above 0
  std::optional<Rational> fit{};           ///< as of a prism, of each face; with `weld` nothing
  std::shared_ptr<const MeshData> data{};  ///< instead of a file (csg/leaves/mesh_data.h)
};
/// `{group: {vertices, faces, edges, points, regions, fill}}` (csg/FORMATS.md#groups).
struct GroupShape {
  struct Face {
    std::vector<std::vector<std::uint32_t>> loops;
    std::array<std::uint32_t, 2> sides{0, 0};
    int line = 0, column = 0;  ///< where the tree file has it, for errors
  };
  struct Region {
    std::string material, name;
  };
  std::vector<RationalPoint> vertices;
  std::vector<Face> faces;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> points;
  std::map<std::uint32_t, Region> regions;
  std::optional<Fill> fill;  ///< instead of sides
};
/// How fine curved leaves are: `chord: e`, the largest distance of a facet or wire from the exact shape, in the
/// model's unit; or `segments: n`, equal steps of every curve and of a whole turn. Neither: 16 segments.
struct Tessellation {
  std::optional<Rational> chord;
  std::optional<int> segments;
};
/// `{points: [p, ...], weights: [w, ...], degree: d, knots: [t, ...]}` or a list of points. Weights are positive
/// and rational (default 1): [1, 1, 2] makes of three points a quarter of a circle exactly, sqrt(2)/2 cannot be
/// given. Bézier curves have neither degree nor knots; B-splines have a degree, and knots that ascend, degree + 1
/// more than points, with inner ones at most `degree` times (default: clamped, spans of equal length).
struct CurveNet {
  std::vector<RationalPoint> points;
  std::vector<Rational> weights;  ///< empty: all 1
  int degree = 0;                 ///< 0: Bézier
  std::vector<Rational> knots;
};
/// `{points: [[p, ...], ...], weights: [[w, ...], ...], degree: [p, q], knots: [[...], [...]]}`: rows run along v,
/// the entries of a row along u (degree and knots: u, then v). The front is the side of S_u x S_v: where rows go
/// up on a sheet of paper and entries to the right, it is the side that one sees.
struct PatchNet {
  std::vector<std::vector<RationalPoint>> points;
  std::vector<std::vector<Rational>> weights;
  std::array<int, 2> degree{0, 0};
  std::array<std::vector<Rational>, 2> knots;
};
/// `{bezier: {patches: [...], curves: [...], fill: winding, chord: e}}`; a single one as `patch:` or `curve:`.
/// Patches are surfaces, curves are wires; with `fill` (as for a group) patches that meet in sides with equal
/// control points make a solid. Facets of one patch are one face, wires of one curve one curve. `bspline` is the
/// same with degrees and knots (`is_spline`); its spans are Bézier patches of one number.
struct BezierShape {
  std::vector<PatchNet> patches;
  std::vector<CurveNet> curves;
  Fill fill = Fill::none;
  Tessellation tessellation;
  bool is_spline = false;
};
/// `{coons: {patches: [[c, c, c, c], ...], fill: winding, chord: e}}` or `patch: [c, c, c, c]`: the bilinearly
/// blended patch of four Bézier curves that go round, each beginning where the one before it ends. Its front is
/// the side from which they go counter-clockwise. The first runs along u; a side may be one point: `[p, p]`.
struct CoonsShape {
  std::vector<std::array<CurveNet, 4>> patches;
  Fill fill = Fill::none;
  Tessellation tessellation;
};
/// A line of straight and curved segments: `[p, p, {bezier: [p, ...], weights: [...]}, p, ...]`. Between two
/// corners a `bezier` gives the inner control points of the curve from one to the other (its weights are those of
/// all its control points, ends too); without one the segment is straight. A closed line
/// returns to its first corner.
struct ProfileLine {
  std::vector<CurveNet> segments;
};
/// `profile: [...]` or `{outer: [...], holes: [[...], ...]}`: closed lines that bound an area, for a solid;
/// `curve: [...]`: an open line, for a surface.
struct Profile {
  std::vector<ProfileLine> lines;
  bool closed = true;
};
/// `{extrude: {profile: ..., vector: [x, y, z], twist: degrees, scale: s, center: p, chord: e}}`: a planar profile
/// (a `curve` need not be planar) swept along a vector, meanwhile turned about the axis through `center` along the
/// vector, by `twist` in all, and scaled from 1 to s about the center (default: the first corner). Profiles that
/// are twisted or scaled lie at right angles to the vector. s = 0 ends in a point.
struct ExtrudeShape {
  Profile profile;
  RationalPoint vector;
  Rational twist = 0, scale = 1;
  std::optional<RationalPoint> center{};
  Tessellation tessellation{};
};
/// `{revolve: {profile: [[r, z], ...], center: p, axis: n, degrees: 360, chord: e}}`: the profile, r >= 0 from the
/// axis and z along it, turned about the axis by the right-hand rule.
struct RevolveShape {
  Profile profile;  ///< points are (r, 0, z)
  RationalPoint center{0, 0, 0}, axis{0, 0, 1};
  Rational degrees = 360;
  Tessellation tessellation;
};
/// `{sweep: {profile: ..., path: [p, q, ...], radius: r, chord: e}}`: the profile, at right angles to the path's
/// first piece, moved along the path without turning about it; bends have the radius, or are mitred.
struct SweepShape {
  Profile profile;
  std::vector<RationalPoint> path;
  std::optional<Rational> radius{};  ///< above 0
  Tessellation tessellation{};
};
/// `{loft: {profiles: [..., ...], chord: e}}`: between each profile and the next, segment by segment, all that
/// lies on straight lines from points of one to those of the other with equal parameters.
struct LoftShape {
  std::vector<Profile> profiles;
  Tessellation tessellation{};
};
/// `{step: {file: part.step, chord: e, unit: mm, solids: [2, bolt], fill: solids, seams: false, weld: d}}`,
/// `{brep: {file: part.brep, ...}}`: a boundary representation, read by OpenCASCADE; path already resolved. Each
/// face of the model is one face, each edge an edge, each solid a region. `unit` (STEP only) is that of the model;
/// default: the file's own. `solids`: only those, by number (from 1) or by name, which several may have. Without
/// `fill`: Fill::solids if there are any. `seams`: edges where a face meets itself, such as the generator at which
/// a cylinder's parameters start, are edges too, with their ends and the poles of spheres. Facets are as far from
/// the faces as `chord` at most where it is measured, at four points of each (cad_occt_mesh.cpp). `weld` as of a
/// mesh.
struct CadShape {
  enum class Format { step, brep };
  Format format = Format::step;
  std::string file;
  Tessellation tessellation;
  std::optional<Fill> fill;
  std::string unit;                 ///< um mm cm m km in ft; empty: the file's own
  std::vector<std::string> solids;  ///< empty: everything
  bool seams = false;
  std::string inside{};            ///< as of a heightfield
  std::optional<Rational> weld{};  ///< a length above 0
  const char* name() const { return format == Format::step ? "step" : "brep"; }
};
/// `{cnrg: file.json}`: a result read back.
struct ResultShape {
  std::string file;
  std::string inside{};                             ///< as of a heightfield
  std::shared_ptr<const PreparedLeaf> in_memory{};  ///< instead of a file: a result at hand, by `leaf_of`
};

using Shape =
    std::variant<BoxShape, PrismShape, PyramidShape, TetrahedronShape, HullShape, PolygonShape, DiskShape,
                 PolylineShape, PointsShape, PlaneShape, HalfspaceShape, SphereShape, CylinderShape, ConeShape,
                 TorusShape, BezierShape, CoonsShape, ExtrudeShape, RevolveShape, SweepShape, LoftShape,
                 HeightfieldShape, MeshShape, CadShape, GroupShape, ResultShape>;

}  // namespace cnrg
