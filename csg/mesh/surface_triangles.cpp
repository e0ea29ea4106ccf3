// Points that refinement adds are rounded off their planes and lines. Where two faces of the result nearly touch,
// that may make them cross, as it may for the points of the result themselves. So what was made is refined
// exactly; where triangles turn out to be cut, their facets have to stay as they were, and all is made again. In
// the end that is the mesh of the rounded result, of which it is known that it is right.
#include "csg/mesh/surface_triangles.h"

#include <algorithm>
#include <cmath>

#include "csg/mesh/cell_mesh.h"
#include "csg/mesh/deadline.h"
#include "csg/mesh/mesh_sizes.h"
#include "csg/mesh/planar_facets.h"
#include "csg/mesh/quads.h"
#include "csg/mesh/reach.h"
#include "csg/mesh/rounded_result.h"
#include "csg/result/solid.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"
#include "kernel/tetrahedra/bounds.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = DoubleVector;

/// As the result's drawing, with the triangles and segments of a mesh.
Drawing drawing_by_facets(const FlatComplex& flat, const FacetMesh& mesh) {
  Drawing drawing = drawing_of(flat);
  drawing.triangles.clear(), drawing.sides.clear();
  drawing.segments.clear(), drawing.around_segments.clear();
  for (const auto& t : mesh.triangles()) {
    drawing.triangles.push_back(t.points);
    drawing.sides.push_back(flat.faces[mesh.facets()[t.facet].face].regions);
  }
  for (const auto& s : mesh.segments()) {
    if (s.edge == kNone || !flat.edges[s.edge].wire) continue;
    drawing.segments.push_back(s.ends);
    drawing.around_segments.push_back(flat.edges[s.edge].region);
  }
  return drawing;
}

/// The facets of triangles that are not as they were drawn, marked; none if what is wrong is no matter of
/// triangles.
std::vector<char> crossed_facets(const FacetMesh& mesh, const RoundedPoints& points, const Drawing& drawing,
                                 const std::stop_token& stop) {
  const Redrawing drawn = redraw(points, drawing, stop);
  const Complex& complex = *drawn.complex;
  std::vector<std::size_t> pieces(drawing.triangles.size(), 0);
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    const auto covers = complex.cover(f);
    const auto loops = complex.face_loops[f];
    const bool whole = covers.size() == 1 && loops.size() == 1 && complex.loop[loops[0]].size() == 3 &&
                       complex.face_vertices[f].empty();
    for (const Cover& cover : covers) pieces[cover.source.index()] += whole ? 1 : 2;
  }
  std::vector<char> crossed(mesh.facets().size(), 0);
  for (std::size_t t = 0; t < pieces.size(); ++t) {
    if (pieces[t] != 1) crossed[mesh.triangles()[t].facet] = 1;
  }
  return crossed;
}

struct Refined {
  FacetMesh mesh;
  std::vector<SmallAngle> why;  // by triangle
  std::size_t kept = 0;
};

Refined refined(const FlatComplex& flat, const RoundedPoints& rounded, SurfaceOptions options, SizeAt said,
                SurfaceNarrow narrow = SurfaceNarrow::rationed) {
  constexpr int kRounds = 5;
  const PeriodicSides sides(options.periodic, rounded.xyz);
  options.size = sides.least(options.size), said = sides.least(said);
  std::vector<char> fixed;
  for (int round = 0;; ++round) {
    FacetMesh mesh(flat, sides.aligned(rounded.xyz), fixed, sides);
    const bool all = round == kRounds;
    for (Index s = 0; all && s < mesh.segments().size(); ++s) mesh.fix(s);
    std::vector<SmallAngle> why = refine(mesh, options, said, narrow);
    for (const Index source : mesh.add_images()) why.push_back(why[source]);
    options.watch.begin("mesh: proof");
    const RoundedPoints points{mesh.points()};
    const Drawing drawing = drawing_by_facets(flat, mesh);
    if (is_faithful(points, drawing, options.watch.stop)) {
      const std::size_t kept = std::size_t(std::count(fixed.begin(), fixed.end(), 1));
      return {std::move(mesh), std::move(why), kept};
    }
    if (all && sides.any())
      throw InputError(
          "--periodic: opposite sides differ in last digits, and without these something crosses; move "
          "what nearly touches there");
    require(!all, "surface: the triangles of the result cross");
    const std::vector<char> crossed = crossed_facets(mesh, points, drawing, options.watch.stop);
    fixed.resize(crossed.size(), 0);
    bool more = false;
    for (std::size_t f = 0; f < fixed.size(); ++f) {
      more = more || (crossed[f] != 0 && fixed[f] == 0);
      fixed[f] = fixed[f] != 0 || crossed[f] != 0;
    }
    if (!more || round + 1 == kRounds) {
      std::fill(fixed.begin(), fixed.end(), 1);
      round = kRounds - 1;
    }
  }
}

double area_of(const Vector& a, const Vector& b, const Vector& c) {
  return length(cross(minus(b, a), minus(c, a))) / 2;
}
/// A sum of many numbers with what rounding took away (neumaier1974): plainly added, a million equal areas are off
/// by 1e-11 of their sum and more, always to one side, which is beyond the bound below.
class CompensatedSum {
 public:
  void add(double x) {
    const double sum = sum_ + x;
    lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

class SurfaceTriangulation {
 public:
  SurfaceTriangulation(const ResultView& view, const SurfaceOptions& options)
      : view_(view), options_(options), flat_(flatten_for_mesh(view)) {}

  SurfaceTriangles run() {
    if (options_.quads && options_.order == 2)
      throw InputError("there are no quadrilaterals of second order; mesh without --quads, or of order 1");
    if (options_.quads && options_.periodic != PeriodicAxes{})
      throw InputError(
          "quadrilaterals of opposite sides would differ; mesh without --quads, or without --periodic");
    require_off_frame(flat_, "a surface mesh");
    require_closed(flat_, "a surface mesh");
    const bool wires = std::any_of(flat_.edges.begin(), flat_.edges.end(), [](const auto& e) { return e.wire; });
    if (flat_.faces.empty() && !wires) {
      throw InputError("the result has neither faces nor wires to mesh; `cnrg eval -o` writes its points");
    }
    const RoundedPoints rounded = round_points(view_, flat_);
    options_.watch.begin("mesh: rounding");
    result_.rounding = report_rounding(rounded, drawing_of(flat_), options_.watch.stop);
    if (!result_.rounding.embedded) refuse_rounding("a surface mesh", "breaks the result");
    SizeAt said = options_.size;
    if (!said) {
      said = sizes(rounded, true);
      options_.size = sizes(rounded, false);
    }
    const Refined made = refined(flat_, rounded, options_, said);
    result_.kept = made.kept;
    result_.mesh = mesh_of_cells(view_, flat_, false);
    take_simplices(made.mesh);
    prove_edges(mesh(), flat_);
    prove_faces(mesh(), flat_);
    prove_areas(made.mesh.points());
    if (options_.quads) merge(made.mesh);
    report(made);
    take_points(mesh(), made.mesh.points());
    return std::move(result_);
  }

 private:
  const ResultView& view_;
  SurfaceOptions options_;
  const FlatComplex flat_;
  SurfaceTriangles result_;
  std::vector<MergedQuad> quads_;
  std::vector<char> merged_;  // of each triangle, where there are quads
  Mesh& mesh() { return result_.mesh; }

  /// As of tetrahedra: where sizes are the aim, sides are longer and shorter ones. `said`: without features.
  SizeAt sizes(const RoundedPoints& rounded, bool said) const {
    const MeshSizes sizes = mesh_sizes(view_, flat_, rounded, {options_.overall, options_.growth, false, said});
    if (sizes.empty()) return {};
    return [field = sizes.field](const Vector& p) { return kLongestEdge * field.at(p); };
  }

  void take_simplices(const FacetMesh& made) {
    for (Index i = 0; i < flat_.vertices.size(); ++i) mesh().vertices.push_back({{flat_.vertices[i].point}, i});
    for (const auto& s : made.segments()) {
      if (s.edge != kNone) mesh().segments.push_back({s.ends, s.edge});
    }
    sort_by_entity(mesh().segments);
    take_triangles(made);
  }
  bool is_merged(std::size_t t) const { return !merged_.empty() && merged_[t] != 0; }
  void take_triangles(const FacetMesh& made) {
    mesh().triangles.clear();
    for (std::size_t i = 0; i < made.triangles().size(); ++i) {
      const auto& t = made.triangles()[i];
      if (!is_merged(i)) mesh().triangles.push_back({t.points, made.facets()[t.facet].face});
    }
    sort_by_entity(mesh().triangles);
  }

  void merge(const FacetMesh& made) {
    quads_ = merge_triangles(made, options_.watch);
    merged_.assign(made.triangles().size(), 0);
    for (const MergedQuad& q : quads_) {
      for (const Index t : q.triangles) {
        require(merged_[t] == 0, "surface: a triangle is in two quadrilaterals");
        merged_[t] = 1;
      }
      mesh().quads.push_back({q.points, made.facets()[made.triangles()[q.triangles[0]].facet].face});
    }
    sort_by_entity(mesh().quads);
    take_triangles(made);
  }

  /// Each point is off the face by its last digits at most.
  void prove_areas(const std::vector<Vector>& points) const {
    const double largest = Reach(points).largest;
    std::vector<CompensatedSum> area(flat_.faces.size());
    std::vector<double> bound(flat_.faces.size(), 0);
    const auto add = [&](Index face, const std::array<Index, 3>& t, double sign) {
      const Vector &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
      const double part = area_of(a, b, c);
      area[face].add(sign * part);
      bound[face] += 1e-12 * part + 1e-15 * largest * (distance(a, b) + distance(b, c) + distance(c, a));
    };
    for (const auto& t : result_.mesh.triangles) add(t.entity, t.points, 1);
    for (Index f = 0; f < flat_.faces.size(); ++f) {
      for (const auto& t : flat_.faces[f].triangles) add(f, t, -1);
      require(std::abs(area[f].value()) <= bound[f], "surface: triangles have not the area of their face");
    }
  }

  void report(const Refined& made) {
    std::vector<std::size_t> row(mesh().groups[2].size() + 1, 0);  // of each group, + 1
    const auto& points = made.mesh.points();
    const auto row_of = [&](Index facet) -> FaceTriangles& {
      const auto& groups = mesh().entities[2][made.mesh.facets()[facet].face].groups;
      const Index group = groups.empty() ? 0 : groups[0];
      if (row[group] == 0) {
        result_.groups.push_back({group == 0 ? "faces" : mesh().groups[2][group - 1]});
        row[group] = result_.groups.size();
      }
      return result_.groups[row[group] - 1];
    };
    for (std::size_t i = 0; i < made.mesh.triangles().size(); ++i) {
      const auto& t = made.mesh.triangles()[i];
      FaceTriangles& of = row_of(t.facet);
      const std::array<Vector, 3> p{points[t.points[0]], points[t.points[1]], points[t.points[2]]};
      of.area += area_of(p[0], p[1], p[2]);
      if (is_merged(i)) continue;
      ++of.triangles;
      ++of.why[std::size_t(made.why[i])];
      const auto [angle, corner] = smallest_angle(p);
      if (angle < of.least_angle) of.least_angle = angle, of.where = p[corner];
    }
    for (const MergedQuad& q : quads_) {
      FaceTriangles& of = row_of(made.mesh.triangles()[q.triangles[0]].facet);
      ++of.quads;
      of.least_quad = std::min(of.least_quad, quad_quality({points[q.points[0]], points[q.points[1]],
                                                            points[q.points[2]], points[q.points[3]]}));
    }
  }
};

}  // namespace

SurfaceTriangles surface_triangles(const ResultView& view, const SurfaceOptions& options) {
  const Deadline deadline(options.watch, options.seconds, "--size");
  SurfaceOptions bound = options;
  bound.watch = deadline.watch();
  return deadline.run([&] { return SurfaceTriangulation(view, bound).run(); });
}

Plc refined_plc(const FlatComplex& flat, const RoundedPoints& points, const SurfaceOptions& options,
                const SizeAt& said, SurfaceNarrow narrow) {
  const Refined made = refined(flat, points, options, said ? said : options.size, narrow);
  Plc plc;
  plc.points = made.mesh.points();
  for (const auto& t : made.mesh.triangles()) {
    plc.facets.push_back(
        {{{t.points[0], t.points[1], t.points[2]}}, {}, made.mesh.facets()[t.facet].face, t.facet});
  }
  for (const auto& s : made.mesh.segments()) {
    if (s.edge != kNone) plc.segments.push_back({s.ends, s.edge, flat.edges[s.edge].wire});
  }
  add_regions(plc, flat);
  return plc;
}

FaceTriangles all_groups(const SurfaceTriangles& made) {
  FaceTriangles all{"all"};
  for (const FaceTriangles& of : made.groups) {
    all.triangles += of.triangles;
    all.quads += of.quads;
    all.least_quad = std::min(all.least_quad, of.least_quad);
    all.area += of.area;
    for (std::size_t i = 0; i < of.why.size(); ++i) all.why[i] += of.why[i];
    if (of.least_angle < all.least_angle) all.least_angle = of.least_angle, all.where = of.where;
  }
  return all;
}

}  // namespace cnrg
