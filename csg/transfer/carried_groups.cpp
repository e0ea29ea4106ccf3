// Carried values are found again in the complex that their soup became, 3-cells by their labels.
#include "csg/transfer/carried_groups.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "kernel/base/error.h"

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
  for (const CarriedGroup& group : groups_) offset -= group.points_.size();
  std::vector<CellMap::Part> parts;
  for (const CarriedGroup& group : groups_) {
    const auto vertex = [&](Index p) { return vertex_of[moved_[offset + p].index()]; };
    CellMap::Part& part = parts.emplace_back();
    part.leaf = LeafId(complex.leaf_count - groups_.size() + parts.size() - 1);
    for (Index i = 0; i < group.edges_.size(); ++i) {
      const auto& [a, b] = group.edges_[i].ends;
      part.segments.push_back({{vertex(a), vertex(b)}, i});
    }
    for (Index i = 0; i < group.vertices_.size(); ++i)
      part.vertices.emplace_back(vertex(group.vertices_[i].point), i);
    offset += group.points_.size();
  }
  return {complex, parts};
}

void CarriedGroups::put_in_order(Soup& soup) {
  // Points are listed leaf by leaf, in the order of the leaves.
  const std::size_t own = soup.leaf_count() - groups_.size();
  std::vector<LeafId> leaf_of(soup.point_count(), LeafId(0));
  const auto see = [&](PointId p, LeafId leaf) {
    if (p.valid()) leaf_of[p.index()] = leaf;
  };
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    for (const PointId p : soup.corners(f)) see(p, soup.face(f).leaf);
  }
  for (const Soup::Wire& wire : soup.wires()) see(wire.a, wire.leaf), see(wire.b, wire.leaf);
  for (const Soup::Isolated& point : soup.isolated()) see(point.point, point.leaf);
  std::size_t points = soup.point_count();
  for (const CarriedGroup& group : groups_) points -= group.points_.size();
  std::vector<PointPlace> places;
  LeafId last;
  Index next = 0;
  for (std::size_t p = 0; p < points; ++p) {
    const LeafId leaf = last.valid() ? std::max(last, leaf_of[p]) : leaf_of[p];  // some points have no cell
    if (leaf != last) next = 0;
    places.emplace_back(last = leaf, next++);
  }
  Index constructed = 0;
  for (const CarriedGroup& group : groups_) {
    for (const PointPlace& place : group.points_)
      places.push_back(place.first.valid() ? place : PointPlace(LeafId::none(), constructed++));
  }
  require(own <= soup.leaf_count() && places.size() == soup.point_count(), "carried: not the last leaves");
  if (groups_.empty()) {
    of_point_ = std::move(places);
    return;
  }
  std::vector<PointId> order;
  for (const PointId p : IdRange<PointId>(places.size())) order.push_back(p);
  std::stable_sort(order.begin(), order.end(),
                   [&](PointId a, PointId b) { return places[a.index()] < places[b.index()]; });
  moved_.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    moved_[order[i].index()] = PointId(i);
    of_point_.push_back(places[order[i].index()]);
  }
  soup.reorder_points(order);
  soup.reorder_faces(order_of_faces(soup));
}

IdVector<VertexId, PointPlace> CarriedGroups::points(const Complex& complex,
                                                     const std::vector<VertexId>& vertex_of) const {
  IdVector<VertexId, PointPlace> out(complex.points.size(), {LeafId::none(), 0});
  for (std::size_t p = vertex_of.size(); p-- > 0;) out[vertex_of[p]] = of_point_[p];  // the first one stays
  Index constructed = 0;
  for (PointPlace& place : out) {
    if (!place.first.valid()) place.second = constructed++;
  }
  return out;
}

IdVector<LeafId, std::vector<VertexId>> CarriedGroups::points_of_leaves(
    const Complex& complex, const std::vector<VertexId>& vertex_of) const {
  IdVector<LeafId, std::vector<VertexId>> out(complex.leaf_count);
  for (std::size_t p = 0; p < of_point_.size(); ++p) {
    const auto& [leaf, place] = of_point_[p];
    if (!leaf.valid()) continue;
    std::vector<VertexId>& of_leaf = out[leaf];
    if (of_leaf.size() <= place) of_leaf.resize(place + 1);
    of_leaf[place] = vertex_of[p];
  }
  return out;
}

std::vector<SourceId> CarriedGroups::order_of_faces(const Soup& soup) const {
  const std::size_t own = soup.leaf_count() - groups_.size();
  std::vector<std::tuple<LeafId, Index, SourceId>> faces;
  faces.reserve(soup.face_count());
  std::vector<Index> next(own, 0);
  for (const SourceId f : IdRange<SourceId>(soup.face_count())) {
    const Soup::Face& face = soup.face(f);
    if (face.leaf.index() < own) {
      faces.emplace_back(face.leaf, next[face.leaf.index()]++, f);
      continue;
    }
    const CarriedGroup& group = groups_[face.leaf.index() - own];
    std::pair<LeafId, Index> first(LeafId::none(), 0);
    for (const auto& [source, same] : group.covers_[group.faces_[face.leaf_face].cover]) {
      const CarriedGroup::Source& of = group.sources_[source];
      first = std::min(first, {of.face.leaf, of.place});
    }
    faces.emplace_back(first.first, first.second, f);
  }
  std::sort(faces.begin(), faces.end());
  std::vector<SourceId> order;
  order.reserve(faces.size());
  for (const auto& [leaf, place, f] : faces) order.push_back(f);
  return order;
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
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    for (const Piece& piece : cells_.pieces(e)) {
      Group& group = out[piece.part];
      list(piece, e, group.edges, group.origins.edges);
      if (piece.dimension == 1 && groups_[piece.part].edges_[piece.number].feature)
        group.features.edges.push_back(e);
    }
  }
  for (const VertexId v : complex.vertices) {
    for (const Piece& piece : cells_.pieces(v)) {
      Group& group = out[piece.part];
      list(piece, v, group.vertices, group.origins.vertices);
      if (piece.dimension == 0 && groups_[piece.part].vertices_[piece.number].feature)
        group.features.vertices.push_back(v);
    }
  }
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
