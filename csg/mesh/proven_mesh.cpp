#include "csg/mesh/proven_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/mesh/cell_mesh.h"
#include "csg/mesh/exact_volume.h"
#include "csg/mesh/improved.h"
#include "csg/mesh/reach.h"
#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

using Index = Mesh::Index;
using Vector = std::array<double, 3>;
constexpr std::size_t kUnchecked = 1 << 16;  // tetrahedra that are proven between two looks at the watch

class Proof {
 public:
  Proof(const ResultView& view, const FlatComplex& flat, const Plc& plc, const PlcMesh& out, KeptBoundary kept,
        const Watch& watch)
      : view_(view), flat_(flat), plc_(plc), out_(out), kept_(kept), watch_(watch) {}

  ProvenMesh run() {
    make_entities();
    take_tetrahedra();
    take_triangles();
    take_segments();
    take_vertices();
    watch_.check();
    prove_boundary_kept();
    prove_edges(mesh_, flat_);
    prove_faces(mesh_, flat_);
    watch_.check();
    prove_sides(mesh_, flat_, region_entity_, watch_);
    if (has_outside(flat_)) prove_outside();
    prove_volumes();
    return {std::move(mesh_), std::move(regions_)};
  }

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  const Plc& plc_;
  const PlcMesh& out_;
  const KeptBoundary kept_;
  const Watch& watch_;
  Mesh mesh_;
  std::vector<RegionTetrahedra> regions_;
  std::vector<Index> region_entity_;  // of each region of the result, or kNone

  void make_entities() {
    mesh_ = mesh_of_cells(view_, flat_, true);
    region_entity_.assign(flat_.regions.size(), kNone);
    for (Index i = 0; i < flat_.regions.size(); ++i) {
      if (flat_.regions[i].component == 0) continue;
      region_entity_[i] = Index(regions_.size());
      const Mesh::Entity& entity = mesh_.entities[3][region_entity_[i]];
      regions_.push_back({mesh_.groups[3][entity.groups[0] - 1], 0, 0});
    }
  }

  /// Those of active regions, turned so that their determinant is positive, by region.
  void take_tetrahedra() {
    PointTable table;
    for (const Vector& p : out_.points) table.add(p[0], p[1], p[2]);
    for (std::size_t i = 0; i < out_.tetrahedra.size(); ++i) {
      if (i % kUnchecked == 0) watch_.check();
      const std::int32_t attribute = out_.attribute[i];
      if (attribute < 1 || attribute > std::int32_t(plc_.regions.size())) continue;
      auto t = out_.tetrahedra[i];
      const int sign = orient3d(table, VertexId(t[0]), VertexId(t[1]), VertexId(t[2]), VertexId(t[3]));
      require(sign != 0, "tetrahedra: the mesher returns a flat tetrahedron");
      if (sign < 0) std::swap(t[2], t[3]);
      mesh_.tetrahedra.push_back({t, region_entity_[plc_.regions[std::size_t(attribute) - 1].region]});
    }
    sort_by_entity(mesh_.tetrahedra);
  }

  Vector normal_of(const std::vector<Index>& loop) const {
    Vector n{};
    const Vector origin = out_.points[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vector part = cross(minus(out_.points[loop[i]], origin), minus(out_.points[loop[i + 1]], origin));
      for (std::size_t k = 0; k < 3; ++k) n[k] += part[k];
    }
    return n;
  }

  /// Turned as their facets are: the two planes are the same or opposite, so doubles tell.
  void take_triangles() {
    std::vector<Vector> normals;
    for (const auto& facet : plc_.facets) normals.push_back(normal_of(facet.polygons[0]));
    for (std::size_t i = 0; i < out_.triangles.size(); ++i) {
      if (std::size_t(out_.facet[i]) >= plc_.facets.size()) continue;  // on the box
      auto t = out_.triangles[i];
      if (dot(normal_of({t[0], t[1], t[2]}), normals[std::size_t(out_.facet[i])]) < 0) std::swap(t[1], t[2]);
      mesh_.triangles.push_back({t, plc_.facets[std::size_t(out_.facet[i])].face});
    }
    sort_by_entity(mesh_.triangles);
  }

  void take_segments() {
    for (std::size_t i = 0; i < out_.segments.size(); ++i) {
      if (out_.edge[i] < 0) continue;
      mesh_.segments.push_back({out_.segments[i], Index(out_.edge[i])});
    }
    sort_by_entity(mesh_.segments);
  }

  void take_vertices() {
    for (Index i = 0; i < flat_.vertices.size(); ++i) mesh_.vertices.push_back({{flat_.vertices[i].point}, i});
  }

  /// With `KeptBoundary::points`: nothing but points of the result on faces and edges.
  void prove_boundary_kept() {
    if (kept_ == KeptBoundary::facets) return prove_facets_kept();
    if (kept_ == KeptBoundary::no) return;
    const auto kept = [&](const auto& simplex) {
      return std::all_of(simplex.points.begin(), simplex.points.end(),
                         [&](Index p) { return p < plc_.points.size(); });
    };
    if (!std::all_of(mesh_.triangles.begin(), mesh_.triangles.end(), kept) ||
        !std::all_of(mesh_.segments.begin(), mesh_.segments.end(), kept)) {
      throw InputError(
          "TetGen cannot fill the regions without new points on faces or edges; leave out "
          "--keep-boundary");
    }
  }

  /// With `KeptBoundary::facets`: on faces are its triangles, and on edges its segments, and no others.
  void prove_facets_kept() {
    const auto sorted = [](auto simplices) {
      for (auto& s : simplices) std::sort(s.first.begin(), s.first.end());
      std::sort(simplices.begin(), simplices.end());
      return simplices;
    };
    std::vector<std::pair<std::array<Index, 3>, Index>> given, found;
    for (const auto& f : plc_.facets)
      given.push_back({{f.polygons[0][0], f.polygons[0][1], f.polygons[0][2]}, f.face});
    for (const auto& t : mesh_.triangles) found.emplace_back(t.points, t.entity);
    std::vector<std::pair<std::array<Index, 2>, Index>> given_segments, found_segments;
    for (const auto& s : plc_.segments) given_segments.emplace_back(s.ends, s.edge);
    for (const auto& s : mesh_.segments) found_segments.emplace_back(s.points, s.entity);
    require(sorted(given) == sorted(found) && sorted(given_segments) == sorted(found_segments),
            "tetrahedra: the mesher does not keep the triangles of surfaces");
  }

  /// Outside of all regions, too, no tetrahedron is flat, two that have a face in common lie on its two sides, and
  /// each triangle is a face. None of these tetrahedra is in the mesh, but what is made of it relies on them.
  void prove_outside() {
    struct Side {
      std::array<Index, 3> corners;
      int turn;  // of the face, seen from its tetrahedron; 0: a triangle
      auto operator<=>(const Side&) const = default;
    };
    std::vector<Side> sides;
    const auto add = [&](std::array<Index, 3> corners, int turn) {
      for (const std::size_t k : {0, 1, 0}) {
        if (corners[k] < corners[k + 1]) continue;
        std::swap(corners[k], corners[k + 1]);
        turn = -turn;
      }
      sides.push_back({corners, turn});
    };
    for (std::size_t i = 0; i < out_.tetrahedra.size(); ++i) {
      if (i % kUnchecked == 0) watch_.check();
      const auto& [a, b, c, d] = out_.tetrahedra[i];
      const auto& p = out_.points;
      const int sign = orient3d(p[a].data(), p[b].data(), p[c].data(), p[d].data());
      require(sign != 0, "tetrahedra: the mesher returns a flat tetrahedron outside of all regions");
      add({b, c, d}, sign), add({a, c, d}, -sign), add({a, b, d}, sign), add({a, b, c}, -sign);
    }
    for (const auto& t : mesh_.triangles) add(t.points, 0);
    watch_.check();
    std::sort(sides.begin(), sides.end());
    watch_.check();
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      std::array<std::size_t, 3> n{};
      for (; end < sides.size() && sides[end].corners == sides[i].corners; ++end)
        ++n[std::size_t(sides[end].turn + 1)];
      require(n[0] <= 1 && n[2] <= 1 && n[0] + n[2] > 0,
              "tetrahedra: the mesher returns tetrahedra that overlap outside of all regions, or none at a face");
    }
  }

  /// Of each face, as the mesher has got them: those of the result, or with `KeptBoundary::facets` those of its
  /// complex.
  std::vector<std::vector<std::array<Index, 3>>> given_triangles() const {
    std::vector<std::vector<std::array<Index, 3>>> given(flat_.faces.size());
    for (Index f = 0; f < given.size() && kept_ != KeptBoundary::facets; ++f)
      given[f].assign(flat_.faces[f].triangles.begin(), flat_.faces[f].triangles.end());
    for (std::size_t i = 0; i < plc_.facets.size() && kept_ == KeptBoundary::facets; ++i) {
      const auto& p = plc_.facets[i].polygons[0];
      given[plc_.facets[i].face].push_back({p[0], p[1], p[2]});
    }
    return given;
  }

  void prove_volumes() {
    ExactVolume volume(out_.points);
    const auto& all = mesh_.tetrahedra;
    std::size_t at = 0;
    const std::vector<std::vector<std::array<Index, 3>>> boundary = given_triangles();
    // New points on faces are off them by rounding, in the last digits of their coordinates.
    const Reach reach(plc_.points);
    const double off =
        std::max(1e-8 * reach.longest_side(), 64 * std::numeric_limits<double>::epsilon() * reach.largest);
    for (Index i = 0; i < flat_.regions.size(); ++i) {
      const Index entity = region_entity_[i];
      if (entity == kNone) continue;
      RegionTetrahedra& region = regions_[entity];
      volume.clear();
      for (; at < all.size() && all[at].entity == entity; ++at) {
        if (at % kUnchecked == 0) watch_.check();
        const auto& t = all[at].points;
        volume.add(t[0], t[1], t[2], t[3]);
        ++region.tetrahedra;
      }
      region.volume = volume.value();
      volume.clear();
      double area = 0;
      for (const auto& shell : flat_.regions[i].shells) {
        for (const Index side : shell) {
          for (const auto& t : boundary[side >> 1]) {
            if ((side & 1) == 0) volume.add(0, t[0], t[2], t[1]);
            else volume.add(0, t[0], t[1], t[2]);
            const Vector n = normal_of({t[0], t[1], t[2]});
            area += std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
          }
        }
      }
      const Rational difference = abs(region.volume - volume.value());
      const Rational bound = kept_ != KeptBoundary::no ? Rational(0) : from_double(area * off);
      require(difference <= bound, "tetrahedra: those of region `" + region.name + "` have the volume " +
                                       to_decimal(region.volume) + " and not " + to_decimal(volume.value()));
    }
    require(at == all.size(), "tetrahedra: the mesher returns a tetrahedron of no region");
  }
};

}  // namespace

ProvenMesh proven_mesh(const ResultView& view, const FlatComplex& flat, const Plc& plc, const PlcMesh& made,
                       KeptBoundary kept, const Watch& watch) {
  return Proof(view, flat, plc, made, kept, watch).run();
}

void number_points(Mesh& mesh, const FlatComplex& flat, const std::vector<Vector>& points) {
  std::vector<char> filled(points.size(), 0);
  for (const auto& t : mesh.tetrahedra)
    for (const Index p : t.points) filled[p] = 1;
  for (const auto& v : flat.vertices) {
    const bool inside = v.region != kNone && flat.active(v.region);
    require(!inside || filled[v.point], "tetrahedra: the mesher lost a point inside of a region");
  }
  take_points(mesh, points);
}

}  // namespace cnrg
