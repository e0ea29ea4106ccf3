#include "bench/sweep/facts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/cases/value_model.h"
#include "kernel/base/union_find.h"
#include "kernel/selection/manifold.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

/// Faces with solid on one side only, and how they go on at their edges.
///
/// Notation: a use is a place among the values of `Complex::edge_uses`; use * 2 is the end of its half-edge where
/// it leaves, use * 2 + 1 where it arrives. Joined ends are one corner of the surface, seen from the solid.
class BoundaryWalk {
 public:
  BoundaryWalk(const Complex& complex, const std::vector<RegionId>& solid)
      : complex_(complex), solid_(complex.region_count), first_use_(complex.edge_count() + 1) {
    for (const RegionId r : solid) solid_[r.index()] = 1;
    for (std::size_t e = 0; e < complex.edge_count(); ++e)
      first_use_[e + 1] = first_use_[e] + static_cast<std::uint32_t>(complex.edge_uses[EdgeId(e)].size());
    corners_ = UnionFind(2 * first_use_.back());
    used_.resize(corners_.size());
    faces_ = UnionFind(complex.face_count());
  }

  BoundarySurface surface() {
    long euler = 0;
    for (std::size_t i = 0; i < complex_.face_count(); ++i) {
      if (const FaceId f(i); on_boundary(f)) euler += 2 - go_around(f);
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) euler -= join_over(EdgeId(e));
    BoundarySurface surface;
    for (std::size_t i = 0; i < complex_.face_count(); ++i)
      if (on_boundary(FaceId(i)) && faces_.find(static_cast<std::uint32_t>(i)) == i) ++surface.shells;
    for (std::uint32_t corner = 0; corner < corners_.size(); ++corner)
      if (used_[corner] && corners_.find(corner) == corner) ++euler;
    surface.genus = static_cast<long>(surface.shells) - euler / 2;
    return surface;
  }

 private:
  bool inside(HalfFace h) const { return solid_[complex_.region(h).index()]; }
  bool on_boundary(FaceId f) const {
    const auto& [front, back] = complex_.face_regions[f];
    return solid_[front.index()] != solid_[back.index()];
  }
  std::uint32_t use_of(FaceId f, HalfEdge h) const {
    const auto uses = complex_.edge_uses[h.edge()];
    const auto at = std::find(uses.begin(), uses.end(), FaceUse{f, h});
    return first_use_[h.edge().index()] + static_cast<std::uint32_t>(at - uses.begin());
  }
  /// Joins the ends of half-edges that follow each other; the number of loops.
  long go_around(FaceId f) {
    long loops = 0;
    for (const LoopId l : complex_.face_loops[f]) {
      ++loops;
      std::uint32_t before = use_of(f, complex_.loop[l].back());
      for (const HalfEdge h : complex_.loop[l]) {
        const std::uint32_t use = use_of(f, h);
        corners_.unite(2 * before + 1, 2 * use);
        used_[2 * before + 1] = used_[2 * use] = 1;
        before = use;
      }
    }
    return loops;
  }
  /// Joins the two faces at each sector of solid around an edge; the number of such sectors.
  long join_over(EdgeId e) {
    const auto uses = complex_.edge_uses[e];
    const auto n = static_cast<std::uint32_t>(uses.size());
    long sectors = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (!on_boundary(uses[i].face) || !inside(uses[i].after())) continue;
      std::uint32_t k = (i + 1) % n;
      while (!on_boundary(uses[k].face)) k = (k + 1) % n;
      ++sectors;
      faces_.unite(uses[i].face.value(), uses[k].face.value());
      const std::uint32_t a = first_use_[e.index()] + i, b = first_use_[e.index()] + k;
      const bool turned = uses[i].half_edge != uses[k].half_edge;
      corners_.unite(2 * a, 2 * b + turned);
      corners_.unite(2 * a + 1, 2 * b + !turned);
    }
    return sectors;
  }

  const Complex& complex_;
  std::vector<char> solid_;
  std::vector<std::uint32_t> first_use_;
  UnionFind corners_, faces_;
  std::vector<char> used_;
};

/// Non-manifold cells of the simplified set; an edge that the refinement cut is one.
void count_non_manifold(const Complex& complex, const CellSet& set, const SimplifiedComplex& simplified,
                        Facts& facts) {
  Neighbourhoods neighbourhoods(complex);
  const Manifoldness shapes = manifoldness(complex, set, neighbourhoods);
  std::set<std::uint32_t> edges, vertices;
  for (const auto& [e, shape] : shapes.edges) {
    if (shape.form != LocalForm::non_manifold) continue;
    edges.insert(simplified.edge_place[e.index()].index);
  }
  for (const auto& [v, shape] : shapes.vertices) {
    const SimplifiedComplex::Place place = simplified.vertex_place[v.index()];
    if (shape.form == LocalForm::non_manifold && place.dimension == 0) vertices.insert(place.index);
  }
  facts.non_manifold_edges = edges.size();
  facts.non_manifold_vertices = vertices.size();
}

}  // namespace

BoundarySurface boundary_surface(const Complex& complex, const std::vector<RegionId>& solid) {
  return BoundaryWalk(complex, solid).surface();
}

CellSet dangling(const Complex& complex, const CellSet& set) {
  CellSet solid;
  solid.regions = set.regions;
  return subtract(set, closure(complex, solid));
}

double area(const Complex& complex, const std::vector<FaceId>& faces) {
  double sum = 0;
  for (const FaceId f : faces) sum += std::sqrt(to_double(squared_area(complex, f)));
  return sum;
}

double length(const Complex& complex, const std::vector<EdgeId>& edges) {
  double sum = 0;
  for (const EdgeId e : edges) sum += std::sqrt(to_double(squared_length(complex, e)));
  return sum;
}

Facts facts_of(const Complex& complex, const CellSet& set) {
  Facts facts;
  facts.volume = cnrg::to_string(volume(complex, set.regions).value());
  const SimplifiedComplex simplified = simplify(complex, as_one(set), {}, SimplifyMode::points);
  const auto counts = active_counts(simplified);
  facts.vertices = counts[0];
  facts.edges = counts[1];
  facts.faces = counts[2];
  facts.regions = counts[3];
  const BoundarySurface surface = boundary_surface(complex, set.regions);
  facts.shells = surface.shells;
  facts.genus = surface.genus;
  count_non_manifold(complex, set, simplified, facts);

  // Places of dangling cells; a wire is an edge off all dangling faces too.
  const CellSet loose = dangling(complex, set);
  CellSet sheets;
  sheets.faces = loose.faces;
  const CellSet wires = subtract(loose, closure(complex, sheets));
  CellSet curves;
  curves.edges = wires.edges;
  const CellSet points = subtract(wires, closure(complex, curves));
  const auto distinct = [](const auto& cells, const auto& places, int dimension) {
    std::set<std::uint32_t> found;
    for (const auto cell : cells)
      if (const auto& place = places[cell.index()]; place.dimension == dimension) found.insert(place.index);
    return found.size();
  };
  facts.dangling_faces = distinct(sheets.faces, simplified.face_place, 2);
  facts.dangling_edges = distinct(wires.edges, simplified.edge_place, 1);
  facts.dangling_vertices = distinct(points.vertices, simplified.vertex_place, 0);
  return facts;
}

}  // namespace cnrg::bench
