// The surface around each region, cut where the region touches itself.
//
// Two boxes of one region that share an edge have four triangles there, and no format of closed surfaces can say
// which two belong together. The radial order of the faces around the edge can: a wedge of the region lies between
// two of them, and these are neighbours, as if the region were made a little thinner. Corners of triangles that
// hang together by neighbours are one vertex, others in the same point are not.
//
// That parts two boxes, but not two cavities that share an edge: their surfaces go on through the solid at both
// ends of the edge, which would still have four triangles. There what lies between wedges of the region makes
// neighbours, as if the region were a little thicker, and the cavities part.
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

#include "csg/result/solid.h"
#include "kernel/base/error.h"
#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Pair = std::array<Index, 2>;

std::uint64_t directed_key(Index a, Index b) { return std::uint64_t(a) << 32 | b; }

/// A straight piece of an edge of the result by its ends, the lesser first: the edge.
std::unordered_map<std::uint64_t, Index> pieces_of(const FlatComplex& flat) {
  std::unordered_map<std::uint64_t, Index> pieces;
  for (Index e = 0; e < flat.edges.size(); ++e) {
    for_each_segment(flat.edges[e],
                     [&](Index a, Index b) { pieces.emplace(directed_key(std::min(a, b), std::max(a, b)), e); });
  }
  return pieces;
}

class Boundary {
 public:
  Boundary(const FlatComplex& flat, const std::unordered_map<std::uint64_t, Index>& pieces, Index region)
      : flat_(flat), pieces_(pieces) {
    made_.region = region;
    for (const auto& shell : flat.regions[region].shells) {
      for (const Index side : shell) add_side(side);
    }
    tbb::parallel_sort(uses_.begin(), uses_.end());
  }

  RegionBoundary run(const std::string& format) {
    for (std::set<Pair> again = number(); !again.empty(); again = number()) {
      const std::size_t before = thicker_.size();
      thicker_.merge(again);
      if (thicker_.size() == before) {
        throw InputError(
            format +
            " holds surfaces with two triangles at each edge, and a region touches itself where no cut "
            "makes that of it; write .glb, .obj or .json");
      }
    }
    return std::move(made_);
  }

 private:
  /// The sides of triangles between two points, each by the corner where it begins: from the lesser to the greater
  /// point, and back.
  using Uses = std::array<std::vector<Index>, 2>;
  struct Use {
    Pair ends;
    std::size_t way;
    Index corner;
    friend auto operator<=>(const Use&, const Use&) = default;
  };

  const FlatComplex& flat_;
  const std::unordered_map<std::uint64_t, Index>& pieces_;
  RegionBoundary made_;
  std::vector<std::array<Index, 3>> triangles_;  // points of the flattened result
  std::vector<Index> sides_;                     // of each triangle: face * 2 + side
  std::vector<Use> uses_;                        // by the two points
  std::set<Pair> thicker_;                       // where neighbours are across what is not the region

  /// see(ends, uses) for each two points that sides of triangles run between.
  template <class See>
  void for_each_ends(const See& see) const {
    Uses uses;
    for (std::size_t i = 0, end = 0; i < uses_.size(); i = end) {
      for (auto& of : uses) of.clear();
      for (; end < uses_.size() && uses_[end].ends == uses_[i].ends; ++end)
        uses[uses_[end].way].push_back(uses_[end].corner);
      see(uses_[i].ends, uses);
    }
  }

  /// Makes vertices. Returns where two of them still have more than two triangles.
  std::set<Pair> number() {
    UnionFind corners(3 * triangles_.size());
    for_each_ends([&](const Pair& ends, const Uses& uses) {
      for (const auto& [along, against] : neighbours(ends, uses)) {
        corners.unite(along, next(against));
        corners.unite(next(along), against);
      }
    });
    made_.points.clear();
    made_.triangles.clear();
    std::vector<Index> vertex(corners.size(), FlatComplex::kNone);
    for (Index c = 0; c < corners.size(); ++c) {  // the representative of a set is its smallest corner
      const Index first = corners.find(c);
      if (first == c) {
        vertex[c] = Index(made_.points.size());
        made_.points.push_back(triangles_[c / 3][c % 3]);
      } else {
        vertex[c] = vertex[first];
      }
    }
    for (Index c = 0; c < corners.size(); c += 3) {
      made_.triangles.push_back({vertex[c], vertex[c + 1], vertex[c + 2]});
    }
    std::set<Pair> crowded;
    for_each_ends([&](const Pair& ends, const Uses& uses) {
      if (uses[0].size() < 2) return;
      std::set<Pair> sides;
      for (const Index c : uses[0]) {
        if (!sides.insert({vertex[c], vertex[next(c)]}).second) crowded.insert(ends);
      }
    });
    return crowded;
  }

  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  /// A face with the region on both sides is no boundary of it.
  void add_side(Index side) {
    const FlatComplex::Face& face = flat_.faces[side >> 1];
    if (face.regions[0] == face.regions[1]) return;
    for (auto t : face.triangles) {
      if ((side & 1) == 0) std::swap(t[1], t[2]);
      const Index first = Index(3 * triangles_.size());
      for (Index k = 0; k < 3; ++k) {
        const Index a = t[k], b = t[(k + 1) % 3];
        uses_.push_back({{std::min(a, b), std::max(a, b)}, a < b ? std::size_t{0} : 1, first + k});
      }
      triangles_.push_back(t);
      sides_.push_back(side);
    }
  }

  /// The sides of triangles that are neighbours between two points: from the lesser to the greater, and back.
  std::vector<Pair> neighbours(const Pair& ends, const Uses& uses) const {
    require(uses[0].size() == uses[1].size(), "region_boundaries: a region's boundary is not closed");
    if (uses[0].size() == 1) return {{uses[0][0], uses[1][0]}};
    const auto piece = pieces_.find(directed_key(ends[0], ends[1]));
    require(piece != pieces_.end(), "region_boundaries: a surface crosses itself off its edges");
    std::vector<Index> around;  // sides of the boundary's faces, as they come
    for (const Index side : flat_.edges[piece->second].around) {
      const auto& regions = flat_.faces[side >> 1].regions;
      if (regions[0] != regions[1] && (regions[0] == made_.region || regions[1] == made_.region)) {
        around.push_back(side);
      }
    }
    // The order goes round the edge one way or the other.
    for (const std::size_t way : {0, 1}) {
      if (const auto pairs = pairs_of(around, uses, way, thicker_.count(ends) != 0)) return *pairs;
    }
    throw InvariantError("region_boundaries: the order around an edge fits none of its triangles");
  }

  /// A wedge lies between the far side of a face and the side of the next one that is seen first; of what is not
  /// the region these are the other sides of both. None if the order goes the other way.
  std::optional<std::vector<Pair>> pairs_of(const std::vector<Index>& around, const Uses& uses, std::size_t way,
                                            bool outside) const {
    const auto corner = [&](Index side, std::size_t w) -> std::optional<Index> {
      for (const Index c : uses[w]) {
        if (sides_[c / 3] == side) return c;
      }
      return std::nullopt;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Index next = around[(i + 1) % around.size()];
      const bool inside = flat_.faces[next >> 1].regions[next & 1] == made_.region;
      if (inside == outside) continue;
      const auto a = corner(outside ? around[i] : around[i] ^ 1, outside ? 1 - way : way);
      const auto b = corner(outside ? next ^ 1 : next, outside ? way : 1 - way);
      if (!a || !b) return std::nullopt;
      const bool along = (way == 0) != outside;
      pairs.push_back(along ? Pair{*a, *b} : Pair{*b, *a});
    }
    if (pairs.size() != uses[0].size()) return std::nullopt;
    return pairs;
  }
};

}  // namespace

std::vector<RegionBoundary> region_boundaries(const FlatComplex& flat, const std::string& format) {
  const auto pieces = pieces_of(flat);
  std::vector<RegionBoundary> all;
  for (Index r = 0; r < flat.regions.size(); ++r) {
    if (flat.active(r)) all.push_back(Boundary(flat, pieces, r).run(format));
  }
  return all;
}

}  // namespace cnrg
