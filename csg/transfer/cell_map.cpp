#include "csg/transfer/cell_map.h"

#include <algorithm>
#include <unordered_map>

#include "kernel/base/sorted.h"
#include "kernel/refine/input.h"

namespace cnrg {
namespace {

using Piece = CellMap::Piece;

/// Leaves the piece of the lowest dimension of each part; notes two of that dimension.
void keep_lowest(std::vector<Piece>& pieces, std::optional<std::pair<Piece, Piece>>& overlap) {
  sort_unique(pieces);
  std::size_t kept = 0;
  for (const Piece& piece : pieces) {
    if (kept == 0 || pieces[kept - 1].part != piece.part) pieces[kept++] = piece;
    else if (pieces[kept - 1].dimension == piece.dimension && !overlap) overlap.emplace(pieces[kept - 1], piece);
  }
  pieces.resize(kept);
}

}  // namespace

CellMap::CellMap(const Complex& complex, const std::vector<Part>& parts) : part_of_(complex.leaf_count, kNone) {
  std::unordered_multimap<std::uint64_t, Piece> at_ends;
  std::vector<std::pair<VertexId, Piece>> at_vertex;
  for (Index i = 0; i < parts.size(); ++i) {
    part_of_[parts[i].leaf] = i;
    for (const auto& [ends, edge] : parts[i].segments)
      at_ends.emplace(RefineInput::key(ends[0], ends[1]), Piece{i, 1, edge});
    for (const auto& [v, vertex] : parts[i].vertices) at_vertex.emplace_back(v, Piece{i, 0, vertex});
  }
  std::sort(at_vertex.begin(), at_vertex.end());
  std::vector<Piece> here;
  const auto add = [&](const Piece& piece) { here.push_back(piece); };
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    here.clear();
    for (const SegmentId s : complex.edge_segments[e]) {
      const auto& [a, b] = complex.segment_ends[s];
      const auto [begin, end] = at_ends.equal_range(RefineInput::key(a, b));
      for (auto it = begin; it != end; ++it) add(it->second);
    }
    for (const FaceUse& use : complex.edge_uses[e]) for_each_piece(complex, use.face, add);
    keep_lowest(here, overlap_);
    edges_.push_back(here);
  }
  place_.assign(complex.points.size(), 0);
  vertices_.push_back(std::vector<Piece>());
  auto at = at_vertex.begin();
  for (const VertexId v : complex.vertices) {
    here.clear();
    while (at != at_vertex.end() && at->first < v) ++at;
    for (; at != at_vertex.end() && at->first == v; ++at) add(at->second);
    for (const EdgeId e : complex.vertex_edges[v]) {
      for (const Piece& piece : pieces(e)) add(piece);
    }
    for (const FaceId f : complex.vertex_faces[v]) for_each_piece(complex, f, add);
    if (here.empty()) continue;
    keep_lowest(here, overlap_);
    place_[v] = static_cast<Index>(vertices_.size());
    vertices_.push_back(here);
  }
}

}  // namespace cnrg
