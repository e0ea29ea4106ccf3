// Facets are parted where they are not planar in doubles. Regions are found from the walls: on each side of a face
// is the region that the result has there, and it goes as far as the next wall.
#include "csg/mesh/constrained_run.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"
#include "kernel/tetrahedra/constrained.h"

namespace cnrg {
namespace {

using Index = Plc::Index;
using FacetCorners = std::array<VertexId, 3>;

class ConstrainedRun {
 public:
  ConstrainedRun(const Plc& plc, const FlatComplex& flat, const Watch& watch)
      : plc_(plc), flat_(flat), watch_(watch) {
    for (const auto& p : plc_.points) points_.add(p[0], p[1], p[2]);
    box_ = points_.size();
  }

  PlcMesh run() {
    made_ = constrained_tetrahedra(points_, of_complex(), watch_, NewPoints::doubles);
    find_regions();
    write();
    return std::move(out_);
  }

 private:
  static constexpr Index kNone = FlatComplex::kNone;
  const Plc& plc_;
  const FlatComplex& flat_;
  const Watch& watch_;
  PointTable points_;
  std::vector<Index> facet_, segment_;  // of the constraints, by those of the complex
  ConstrainedTetrahedra made_;
  std::size_t box_ = 0;        // the first corner of the box
  std::vector<Index> region_;  // of each tetrahedron, or kNone
  PlcMesh out_;

  Constraints of_complex() {
    Constraints out;
    for (Index i = 0; i < plc_.segments.size(); ++i) {
      const auto& [a, b] = plc_.segments[i].ends;
      add_segment(out, {VertexId(a), VertexId(b)}, i);
    }
    for (Index i = 0; i < plc_.facets.size(); ++i) {
      const auto& polygons = plc_.facets[i].polygons;
      require(polygons.size() == 1 && polygons[0].size() == 3, "constrained: a facet is no triangle");
      add_triangle(out, {VertexId(polygons[0][0]), VertexId(polygons[0][1]), VertexId(polygons[0][2])}, i);
    }
    return out;
  }

  void add_segment(Constraints& out, const std::array<VertexId, 2>& ends, Index of) {
    out.segments.push_back(ends);
    segment_.push_back(of);
  }
  void add_triangle(Constraints& out, const FacetCorners& corners, Index of) {
    const bool same = !facet_.empty() && plc_.facets[facet_.back()].face == plc_.facets[of].face &&
                      continues(out.facets.back()[0], corners);
    if (!same) {
      out.facets.emplace_back();
      facet_.push_back(of);
    }
    out.facets.back().push_back(corners);
  }

  /// Is a triangle in the plane of another one, and turned alike?
  bool continues(const FacetCorners& first, const FacetCorners& t) const {
    for (const VertexId v : t) {
      if (orient3d(points_, first[0], first[1], first[2], v) != 0) return false;
    }
    for (const Projection axes : {Projection{0, 1}, Projection{1, 2}, Projection{2, 0}}) {
      const int turn = orient2d(points_, axes, first[0], first[1], first[2]);
      if (turn != 0) return orient2d(points_, axes, t[0], t[1], t[2]) == turn;
    }
    return false;
  }

  struct Side {
    FacetCorners corners;  // sorted
    Index tetrahedron;
    VertexId apex;
  };

  void find_regions() {
    std::vector<Side> sides;
    for (Index i = 0; i < made_.tetrahedra.size(); ++i) {
      const auto& t = made_.tetrahedra[i];
      for (std::size_t k = 0; k < 4; ++k)
        sides.push_back({sorted(FacetCorners{t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]}), i, t[k]});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.corners < b.corners; });
    std::vector<std::pair<FacetCorners, Index>> walls;  // sorted corners, piece
    for (Index i = 0; i < made_.triangles.size(); ++i) walls.emplace_back(sorted(made_.triangles[i].corners), i);
    std::sort(walls.begin(), walls.end());
    region_.assign(made_.tetrahedra.size(), kNone);
    std::vector<std::array<Index, 4>> next(made_.tetrahedra.size(), {kNone, kNone, kNone, kNone});
    std::vector<Index> known;
    const auto set = [&](Index t, Index region) {
      if (!flat_.active(region)) return;
      require(region_[t] == kNone || region_[t] == region, "constrained: a region leaks");
      if (region_[t] == kNone) known.push_back(t);
      region_[t] = region;
    };
    for (std::size_t i = 0; i < sides.size();) {
      const bool inner = i + 1 < sides.size() && sides[i + 1].corners == sides[i].corners;
      const auto wall = std::lower_bound(walls.begin(), walls.end(), std::pair(sides[i].corners, Index{0}));
      const bool is_wall = wall != walls.end() && wall->first == sides[i].corners;
      if (is_wall) {
        const auto& piece = made_.triangles[wall->second];
        const auto& face = flat_.faces[plc_.facets[facet_[piece.of]].face];
        for (std::size_t k = i; k < i + (inner ? 2 : 1); ++k) {
          const auto& [a, b, c] = piece.corners;
          const bool front = orient3d(points_, a, b, c, sides[k].apex) > 0;
          set(sides[k].tetrahedron, face.regions[front ? 0 : 1]);
        }
      } else if (inner) {
        const auto link = [&](const Side& from, const Side& to) {
          auto& list = next[from.tetrahedron];
          *std::find(list.begin(), list.end(), kNone) = to.tetrahedron;
        };
        link(sides[i], sides[i + 1]), link(sides[i + 1], sides[i]);
      }
      i += inner ? 2 : 1;
    }
    while (!known.empty()) {
      const Index t = known.back();
      known.pop_back();
      for (const Index u : next[t]) {
        if (u != kNone) set(u, region_[t]);
      }
    }
  }

  void write() {
    // Points of the complex, then those that were added and are in use; the corners of the box come last.
    std::vector<Index> number(points_.size(), kNone);
    const auto take = [&](std::size_t v) {
      if (number[v] != kNone) return;
      number[v] = static_cast<Index>(out_.points.size());
      out_.points.push_back(points_.nearest(VertexId(v)));
    };
    for (std::size_t v = 0; v < box_; ++v) take(v);
    for (const auto& t : made_.tetrahedra) {
      for (const VertexId v : t) {
        if (v.index() >= box_ + 8) take(v.index());
      }
    }
    for (std::size_t k = 0; k < 8; ++k) take(box_ + k);
    std::unordered_map<Index, std::int32_t> attribute;
    for (std::size_t i = 0; i < plc_.regions.size(); ++i)
      attribute.emplace(plc_.regions[i].region, static_cast<std::int32_t>(i + 1));
    for (std::size_t i = 0; i < made_.tetrahedra.size(); ++i) {
      const auto& [a, b, c, d] = made_.tetrahedra[i];
      out_.tetrahedra.push_back({number[a.index()], number[b.index()], number[c.index()], number[d.index()]});
      out_.attribute.push_back(region_[i] == kNone ? 0 : attribute.at(region_[i]));
    }
    for (const auto& triangle : made_.triangles) {
      const auto& [a, b, c] = triangle.corners;
      out_.triangles.push_back({number[a.index()], number[b.index()], number[c.index()]});
      out_.facet.push_back(static_cast<std::int32_t>(facet_[triangle.of]));
    }
    for (const auto& segment : made_.segments) {
      out_.segments.push_back({number[segment.ends[0].index()], number[segment.ends[1].index()]});
      out_.edge.push_back(static_cast<std::int32_t>(plc_.segments[segment_[segment.of]].edge));
    }
  }
};

}  // namespace

PlcMesh run_constrained(const Plc& plc, const FlatComplex& flat, const Watch& watch) {
  return ConstrainedRun(plc, flat, watch).run();
}

}  // namespace cnrg
