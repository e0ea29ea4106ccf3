// Carried values are found again in the complex that their soup became: faces by their covers, edges by their
// ends, 3-cells by their labels.
#include "csg/evaluate/carried_groups.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/refine/input.h"

namespace cnrg {

LeafSetId CarriedGroups::origin(const Piece& piece) const {
  const CarriedGroup& group = groups_[piece.group];
  if (piece.dimension == 2) return group.faces_[piece.index].origin;
  return piece.dimension == 1 ? group.edges_[piece.index].origin : group.vertices_[piece.index].origin;
}

const std::vector<LeafCell>& CarriedGroups::gone(const Piece& piece) const {
  const CarriedGroup& group = groups_[piece.group];
  if (piece.dimension == 2) return group.gone_[group.faces_[piece.index].gone];
  return group.gone_[piece.dimension == 1 ? group.edges_[piece.index].gone : group.vertices_[piece.index].gone];
}

/// Of each group a cell is a piece of one cell at most: of that of the lowest dimension that holds it.
void CarriedGroups::match(const Complex& complex, const std::vector<VertexId>& vertex_of) {
  std::size_t points = 0;
  for (const CarriedGroup& group : groups_) points += group.points_.size();
  std::size_t offset = vertex_of.size() - points;
  std::unordered_multimap<std::uint64_t, Piece> at_ends;
  std::vector<std::pair<VertexId, Piece>> at_vertex;
  for (Index g = 0; g < groups_.size(); ++g) {
    const CarriedGroup& group = groups_[g];
    const auto vertex = [&](Index p) { return vertex_of[moved_[offset + p].index()]; };
    for (Index i = 0; i < group.edges_.size(); ++i) {
      const auto& [a, b] = group.edges_[i].ends;
      at_ends.emplace(RefineInput::key(vertex(a), vertex(b)), Piece{g, 1, i});
    }
    for (Index i = 0; i < group.vertices_.size(); ++i)
      at_vertex.emplace_back(vertex(group.vertices_[i].point), Piece{g, 0, i});
    offset += group.points_.size();
  }
  std::sort(at_vertex.begin(), at_vertex.end());
  std::vector<Piece> here;
  const auto add = [&](const Piece& piece) {
    const auto known =
        std::find_if(here.begin(), here.end(), [&](const Piece& p) { return p.group == piece.group; });
    if (known == here.end()) here.push_back(piece);
    else if (piece.dimension < known->dimension) *known = piece;
  };
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    here.clear();
    for (const SegmentId s : complex.edge_segments[e]) {
      const auto& [a, b] = complex.segment_ends[s];
      const auto [begin, end] = at_ends.equal_range(RefineInput::key(a, b));
      for (auto it = begin; it != end; ++it) add(it->second);
    }
    for (const FaceUse& use : complex.edge_uses[e]) for_each_piece(complex, use.face, add);
    std::sort(here.begin(), here.end());
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
      for (const Piece& piece : std::as_const(edges_)[e]) add(piece);
    }
    for (const FaceId f : complex.vertex_faces[v]) for_each_piece(complex, f, add);
    if (here.empty()) continue;
    std::sort(here.begin(), here.end());
    place_[v] = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(here);
  }
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
  first_ = LeafId(complex.leaf_count - groups_.size());
  match(complex, vertex_of);
  std::vector<Group> out(groups_.size());
  const auto list = [&](const Piece& piece, auto cell, auto& cells, auto& origins) {
    if (!origin(piece).valid()) return;
    cells.push_back(cell);
    origins.push_back(origin(piece));
  };
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    for_each_piece(complex, f, [&](const Piece& piece) {
      list(piece, f, out[piece.group].faces, out[piece.group].origins.faces);
    });
  }
  for (const EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
    for (const Piece& piece : std::as_const(edges_)[e]) {
      Group& group = out[piece.group];
      list(piece, e, group.edges, group.origins.edges);
      if (piece.dimension == 1 && groups_[piece.group].edges_[piece.index].feature)
        group.features.edges.push_back(e);
    }
  }
  for (const VertexId v : complex.vertices) {
    for (const Piece& piece : pieces(v)) {
      Group& group = out[piece.group];
      list(piece, v, group.vertices, group.origins.vertices);
      if (piece.dimension == 0 && groups_[piece.group].vertices_[piece.index].feature)
        group.features.vertices.push_back(v);
    }
  }
  std::vector<std::vector<std::uint32_t>> number(groups_.size());
  for (std::size_t g = 0; g < groups_.size(); ++g) number[g].assign(groups_[g].regions_.size() + 1, 0);
  for (const RegionId r : IdRange<RegionId>(complex.region_count)) {
    for (const Label& label : complex.labels(r)) {
      const Index g = group_of(label.leaf);
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
