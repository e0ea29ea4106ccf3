// Facets grow from the largest one: it takes in its neighbours in its plane, then the largest facet left does the
// same. Edges used by exactly one facet of the merged group bound it.
#include "csg/mesh/planar_facets.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "csg/geometry/canonical_loop.h"
#include "csg/mesh/reach.h"
#include "csg/result/rounding.h"
#include "kernel/base/limits.h"
#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/base/vectors.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using DirectedEdge = std::array<Index, 2>;
using Vector = DoubleVector;

DirectedEdge turned(const DirectedEdge& side) { return {side[1], side[0]}; }

class FacetUniter {
 public:
  /// `kept`: sides that are on edges of the result, ascending, each in both directions.
  FacetUniter(const std::vector<Vector>& xyz, const std::vector<DirectedEdge>& kept, double slack)
      : xyz_(xyz), kept_(kept), slack_(slack) {}

  void run(FlatComplex::Face& face) {
    read(face);
    unite();
    if (std::size_t(*std::max_element(part_.begin(), part_.end())) + 1 == part_.size()) return;
    write(face);
  }

 private:
  const std::vector<Vector>& xyz_;
  const std::vector<DirectedEdge>& kept_;
  const double slack_;
  const FlatComplex::Face* face_ = nullptr;
  std::vector<std::pair<DirectedEdge, Index>> facet_of_;  // of each side of a loop that is on no edge; ascending
  std::vector<Vector> normal_;                            // of each facet, as long as twice its area
  std::vector<Index> part_;                               // the new facet that each one is in

  Index begin_of(std::size_t facet) const { return facet == 0 ? 0 : face_->facet_ends[facet - 1]; }
  Vector normal_of(const FlatComplex::Triangle& t) const {
    return cross(minus(xyz_[t[1]], xyz_[t[0]]), minus(xyz_[t[2]], xyz_[t[0]]));
  }
  Index facet_of(const DirectedEdge& side) const {
    const auto found = std::lower_bound(facet_of_.begin(), facet_of_.end(), std::pair(side, Index(0)));
    return found != facet_of_.end() && found->first == side ? found->second : kNone;
  }
  template <class Visit>
  static void for_each_side(const FlatComplex::Facet& facet, const Visit& visit) {
    for (const auto& loop : facet.loops) {
      for (std::size_t k = 0; k < loop.size(); ++k) visit(DirectedEdge{loop[k], loop[(k + 1) % loop.size()]});
    }
  }

  void read(const FlatComplex::Face& face) {
    face_ = &face;
    facet_of_.clear();
    normal_.assign(face.facets.size(), {});
    part_.assign(face.facets.size(), kNone);
    for (Index f = 0; f < face.facets.size(); ++f) {
      for (Index t = begin_of(f); t < face.facet_ends[f]; ++t) {
        const Vector normal = normal_of(face.triangles[t]);
        for (std::size_t j = 0; j < 3; ++j) normal_[f][j] += normal[j];
      }
      for_each_side(face.facets[f], [&](const DirectedEdge& side) {
        if (!std::binary_search(kept_.begin(), kept_.end(), side)) facet_of_.push_back({side, f});
      });
    }
    std::sort(facet_of_.begin(), facet_of_.end());
  }

  void unite() {
    std::vector<std::pair<double, Index>> order;  // larger ones first, of equals the first
    for (Index f = 0; f < normal_.size(); ++f) order.emplace_back(-dot(normal_[f], normal_[f]), f);
    std::sort(order.begin(), order.end());
    Index parts = 0;
    for (const auto& entry : order) {
      const double area = entry.first;
      const Index first = entry.second;
      if (part_[first] != kNone) continue;
      part_[first] = parts;
      std::vector<Index> reached{first};
      for (std::size_t i = 0; area < 0 && i < reached.size(); ++i) {
        for_each_side(face_->facets[reached[i]], [&](const DirectedEdge& side) {
          const Index beyond = facet_of(side) == kNone ? kNone : facet_of(turned(side));
          if (beyond == kNone || part_[beyond] != kNone || !is_in_plane(beyond, first)) return;
          part_[beyond] = parts;
          reached.push_back(beyond);
        });
      }
      ++parts;
    }
  }

  bool is_in_plane(Index facet, Index of) const {
    const Vector& normal = normal_[of];
    const Vector& origin = xyz_[face_->triangles[begin_of(of)][0]];
    const double most = slack_ * std::sqrt(dot(normal, normal));
    for (Index t = begin_of(facet); t < face_->facet_ends[facet]; ++t) {
      const auto& corners = face_->triangles[t];
      if (dot(normal_of(corners), normal) <= 0) return false;
      for (const Index p : corners) {
        if (std::abs(dot(minus(xyz_[p], origin), normal)) > most) return false;
      }
    }
    return true;
  }

  /// Triangles by their new facets, and around each what no other triangle of it has on the other side.
  void write(FlatComplex::Face& face) {
    std::vector<std::vector<Index>> members(std::size_t(*std::max_element(part_.begin(), part_.end())) + 1);
    for (Index f = 0; f < part_.size(); ++f) members[part_[f]].push_back(f);
    std::sort(members.begin(), members.end());
    std::vector<FlatComplex::Facet> facets;
    std::vector<Index> ends;
    decltype(face.triangles) triangles;
    for (const auto& list : members) {
      for (const Index f : list) {
        triangles.append(face.triangles.begin() + begin_of(f), face.triangles.begin() + face.facet_ends[f]);
      }
      facets.push_back(list.size() == 1 ? face.facets[list[0]] : united(list));
      ends.push_back(Index(triangles.size()));
    }
    face.facets = std::move(facets);
    face.facet_ends = std::move(ends);
    face.triangles = std::move(triangles);
  }

  FlatComplex::Facet united(const std::vector<Index>& list) const {
    FlatComplex::Facet out;
    std::vector<DirectedEdge> around;
    std::vector<Index> seen;
    for (const Index f : list) {
      const FlatComplex::Facet& facet = face_->facets[f];
      out.isolated.append(facet.isolated.begin(), facet.isolated.end());
      for_each_side(facet, [&](const DirectedEdge& side) {
        seen.push_back(side[0]);
        const Index beyond = facet_of(side) == kNone ? kNone : facet_of(turned(side));
        if (beyond == kNone || beyond == f || part_[beyond] != part_[f]) around.push_back(side);
      });
    }
    std::sort(around.begin(), around.end());
    std::vector<char> walked(around.size(), 0);
    std::vector<Index> on_loops;
    for (std::size_t first = 0; first < around.size(); ++first) {
      if (walked[first]) continue;
      auto& loop = out.loops.emplace_back();
      for (std::size_t i = first; i < around.size() && !walked[i];) {
        walked[i] = 1;
        loop.push_back(around[i][0]), on_loops.push_back(around[i][0]);
        i = std::size_t(std::lower_bound(around.begin(), around.end(), DirectedEdge{around[i][1], 0}) -
                        around.begin());
        while (i < around.size() && walked[i] && i + 1 < around.size() && around[i + 1][0] == around[i][0]) ++i;
      }
    }
    put_in_order(out.loops);
    sort_unique(seen), sort_unique(on_loops);
    const std::vector<Index> inner = in_first_alone(seen, on_loops);  // points between facets that are one now
    out.isolated.append(inner.begin(), inner.end());
    std::sort(out.isolated.begin(), out.isolated.end());
    return out;
  }
};

std::vector<DirectedEdge> sides_of_edges(const FlatComplex& flat) {
  std::vector<DirectedEdge> sides;
  for (const auto& edge : flat.edges) {
    for_each_segment(edge, [&](Index a, Index b) {
      sides.push_back({a, b});
      sides.push_back(turned(sides.back()));
    });
  }
  sort_unique(sides);
  return sides;
}

}  // namespace

FlatComplex flatten_for_mesh(const ResultView& view) {
  FlatComplex flat = flatten(view);
  const bool of_triangles = view.region_parts != nullptr;  // snapped or joined
  if (!of_triangles || std::none_of(flat.faces.begin(), flat.faces.end(), is_curved)) return flat;
  std::vector<Vector> xyz(flat.points.size());
  for_each_index(xyz.size(),
                 [&](std::size_t p) { xyz[p] = nearest_doubles(view.complex->points, flat.points[p]); });
  const double slack = kPlanarDigits * std::ldexp(1.0, std::ilogb(Reach(xyz).largest) - 52);
  const std::vector<DirectedEdge> kept = sides_of_edges(flat);
  for_each_index(
      flat.faces.size(),
      [&](std::size_t i) {
        if (is_curved(flat.faces[i])) FacetUniter(xyz, kept, slack).run(flat.faces[i]);
      },
      1);
  return flat;
}

}  // namespace cnrg
