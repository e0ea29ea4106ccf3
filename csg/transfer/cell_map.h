// Which cells of a complex are pieces of which cells that were brought into it.
//
// What enters a complex from another one, or from a file, comes as a leaf of its soup, a *part*, and is cut there
// by all other leaves. A part numbers its own faces, edges and vertices. A cell of the complex is a piece of one
// cell of a part at most: of that one, among those that hold it, that has the lowest dimension. Faces are known by
// their covers, edges by the segments under them, vertices by their points. What lies inside of the part's regions
// is no piece: there, labels tell.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernel/complex/complex.h"

namespace cnrg {

class CellMap {
 public:
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xffffffffu;

  /// A leaf of the soup. Its faces have the numbers Soup::Face::leaf_face.
  struct Part {
    LeafId leaf;
    std::vector<std::pair<std::array<VertexId, 2>, Index>> segments;  ///< with the edge of each
    std::vector<std::pair<VertexId, Index>> vertices;
  };
  /// A cell of a part.
  struct Piece {
    Index part;
    int dimension;
    Index number;
    friend auto operator<=>(const Piece&, const Piece&) = default;
  };

  CellMap() = default;
  CellMap(const Complex& complex, const std::vector<Part>& parts);

  /// kNone for other leaves.
  Index part_of(LeafId leaf) const { return leaf.index() < part_of_.size() ? part_of_[leaf] : kNone; }
  template <class See>
  void for_each_piece(const Complex& complex, FaceId f, const See& see) const {
    for (const Cover& cover : complex.cover(f)) {
      const Soup::Face& source = complex.sources[cover.source];
      const Index part = part_of(source.leaf);
      if (part != kNone) see(Piece{part, 2, source.leaf_face});
    }
  }
  /// Ascending.
  std::span<const Piece> pieces(EdgeId e) const { return edges_[e]; }
  std::span<const Piece> pieces(VertexId v) const { return vertices_[Id<PlaceTag>(place_[v])]; }

  /// Two cells of one part and one dimension on one edge or vertex, the first such pair: cells of a part that is
  /// sound do not overlap.
  const std::optional<std::pair<Piece, Piece>>& overlap() const { return overlap_; }

 private:
  struct PlaceTag;
  IdVector<LeafId, Index> part_of_;
  Csr<EdgeId, Piece> edges_;
  IdVector<VertexId, Index> place_;  // in `vertices_`
  Csr<Id<PlaceTag>, Piece> vertices_;
  std::optional<std::pair<Piece, Piece>> overlap_;
};

}  // namespace cnrg
