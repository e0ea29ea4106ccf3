// Carried values are found again in the complex that their soup became, 3-cells by their labels.
#include "csg/transfer/carried_groups.h"

#include "kernel/base/error.h"
#include "kernel/complex/by_dimension.h"

namespace cnrg {

LeafSetId CarriedGroups::origin(const Piece& piece) const {
  const CarriedGroup& group = groups_[piece.part];
  if (piece.dimension == 2) return group.faces_[piece.number].origin;
  return piece.dimension == 1 ? group.edges_[piece.number].origin : group.vertices_[piece.number].origin;
}

const std::vector<LeafCell>& CarriedGroups::gone(const Piece& piece) const {
  const CarriedGroup& group = groups_[piece.part];
  if (piece.dimension == 2) return group.gone_[group.faces_[piece.number].gone];
  return group.gone_[piece.dimension == 1 ? group.edges_[piece.number].gone : group.vertices_[piece.number].gone];
}

CellMap CarriedGroups::map_of(const Complex& complex, const std::vector<VertexId>& vertex_of) const {
  std::size_t offset = vertex_of.size();
  for (const CarriedGroup& group : groups_) offset -= group.leaf_->geometry().point_count();
  std::vector<CellMap::Part> parts;
  for (const CarriedGroup& group : groups_) {
    const auto vertex = [&](Index p) { return vertex_of[offset + p]; };
    CellMap::Part& part = parts.emplace_back();
    part.leaf = LeafId(complex.leaf_count - groups_.size() + parts.size() - 1);
    for (Index i = 0; i < group.edges_.size(); ++i) {
      const auto& [a, b] = group.edges_[i].ends;
      part.segments.push_back({{vertex(a), vertex(b)}, i});
    }
    for (Index i = 0; i < group.vertices_.size(); ++i)
      part.vertices.emplace_back(vertex(group.vertices_[i].point), i);
    offset += group.leaf_->geometry().point_count();
  }
  return {complex, parts};
}

std::vector<Group> CarriedGroups::on(const Complex& complex, const std::vector<VertexId>& vertex_of) {
  require(complex.leaf_count >= groups_.size() && !complex.frame.valid(), "carried: not the last leaves");
  cells_ = map_of(complex, vertex_of);
  std::vector<Group> out(groups_.size());
  const auto list = [&](const Piece& piece, auto cell, auto& cells, auto& origins) {
    if (!origin(piece).valid()) return;
    cells.push_back(cell);
    origins.push_back(origin(piece));
  };
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    cells_.for_each_piece(complex, f, [&](const Piece& piece) {
      list(piece, f, out[piece.part].faces, out[piece.part].origins.faces);
    });
  }
  const auto list_pieces = [&](auto cell, auto CarriedGroup::*stored) {
    for (const Piece& piece : cells_.pieces(cell)) {
      Group& group = out[piece.part];
      list(piece, cell, list_for(group, cell), list_for(group.origins, cell));
      if (piece.dimension == dimension_of(cell) && (groups_[piece.part].*stored)[piece.number].feature)
        list_for(group.features, cell).push_back(cell);
    }
  };
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) list_pieces(e, &CarriedGroup::edges_);
  for (const VertexId v : complex.vertices) list_pieces(v, &CarriedGroup::vertices_);
  std::vector<std::vector<std::uint32_t>> number(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) number[g].assign(groups_[g].regions_.size() + 1, 0);
  for (const RegionId r : IdRange<RegionId>(complex.region_count)) {
    for (const Label& label : complex.labels(r)) {
      const Index g = cells_.part_of(label.leaf);
      if (g == kNone) continue;
      const std::uint32_t region = groups_[g].classes_[label.region - 1].region;
      if (number[g][region] == 0) {
        out[g].regions.push_back(groups_[g].regions_[region - 1]);
        number[g][region] = static_cast<std::uint32_t>(out[g].regions.size());
      }
      out[g].cells.emplace_back(r, number[g][region]);
    }
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    out[g].origins.sets = groups_[g].sets_;
    out[g].dominance = groups_[g].dominance_;
  }
  return out;
}

}  // namespace cnrg
