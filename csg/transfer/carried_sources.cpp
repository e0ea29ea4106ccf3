// What the cells of a complex with carried values come from. The refinement names carried leaves, which no result
// may: each of their faces, wires, points and labels becomes those of the input that it stands for.
#include <algorithm>
#include <map>
#include <utility>

#include "csg/transfer/carried_groups.h"
#include "kernel/base/sorted.h"

namespace cnrg {

class CarriedGroups::SourcesMaker {
 public:
  SourcesMaker(const CarriedGroups& carried, const Complex& complex, LeafPlaces& places)
      : carried_(carried), groups_(carried.groups_), complex_(complex), places_(places) {}

  ComplexSources run(std::span<const std::vector<std::uint32_t>> surfaces) {
    out_.leaf_count = complex_.leaf_count - groups_.size();
    out_.fills = complex_.fills;
    out_.fills.resize(out_.leaf_count);
    out_.leaf_regions = complex_.leaf_regions;
    out_.leaf_regions.resize(out_.leaf_count);
    take_faces_and_wires();
    take_removed_facets();
    number_surfaces(surfaces);
    take_covers();
    take_segments();
    take_points();
    take_removed();
    take_labels();
    return std::move(out_);
  }

 private:
  const CarriedGroups& carried_;
  const std::vector<CarriedGroup>& groups_;
  const Complex& complex_;
  LeafPlaces& places_;
  ComplexSources out_;
  IdVector<SourceId, SourceId> kept_;  // of the complex's own; none() for faces of groups
  IdVector<WireId, WireId> kept_wires_;
  std::vector<std::vector<SourceId>> source_of_;  // by group
  std::vector<std::vector<WireId>> wire_of_;

  bool is_own(LeafId leaf) const { return carried_.cells_.part_of(leaf) == kNone; }

  /// A face or wire that several groups have, or a group and the soup, is listed once.
  void take_faces_and_wires() {
    std::vector<char> carried(complex_.leaf_count, 0);
    for (const CarriedGroup& group : groups_) {
      for (const auto& source : group.sources_) carried[source.face.leaf.index()] = 1;
      for (const auto& wire : group.wires_) carried[wire.wire.leaf.index()] = 1;
    }
    const LeafPlaces of_soup = std::exchange(places_, {});
    std::map<std::pair<LeafId, Index>, SourceId> known;
    std::map<std::pair<LeafId, Index>, WireId> known_wires;
    kept_ = take_own(complex_.sources, of_soup.faces, carried, known, out_.sources, places_.faces);
    kept_wires_ = take_own(complex_.wires, of_soup.wires, carried, known_wires, out_.wires, places_.wires);
    for (const CarriedGroup& group : groups_) {
      auto& sources = source_of_.emplace_back();
      for (const auto& [face, place, regions] : group.sources_) {
        sources.push_back(take(face, place, known, out_.sources, places_.faces));
        out_.leaf_regions[face.leaf] = regions;
      }
      auto& wires = wire_of_.emplace_back();
      for (const auto& [wire, place] : group.wires_)
        wires.push_back(take(wire, place, known_wires, out_.wires, places_.wires));
    }
  }
  /// Those of `all` that are not of carried leaves; `known` gets those of leaves that are carried, too.
  template <class IdT, class Item, class Places, class Known>
  IdVector<IdT, IdT> take_own(const IdVector<IdT, Item>& all, const Places& place_of,
                              const std::vector<char>& carried, Known& known, IdVector<IdT, Item>& out,
                              Places& places) const {
    IdVector<IdT, IdT> kept(all.size());
    for (const IdT i : IdRange<IdT>(all.size())) {
      const LeafId leaf = all[i].leaf;
      if (!is_own(leaf)) continue;
      kept[i] = out.push_back(all[i]);
      places.push_back(place_of[i]);
      if (carried[leaf.index()]) known.try_emplace({leaf, place_of[i]}, kept[i]);
    }
    return kept;
  }
  template <class IdT, class Item, class Places, class Known>
  static IdT take(const Item& item, Index place, Known& known, IdVector<IdT, Item>& out, Places& places) {
    const auto [it, fresh] = known.try_emplace({item.leaf, place}, IdT(out.size()));
    if (fresh) {
      out.push_back(item);
      places.push_back(place);
    }
    return it->second;
  }

  /// Curved patches without a number of the tree have got one in each complex; here they get one for all.
  void number_surfaces(std::span<const std::vector<std::uint32_t>> surfaces) {
    std::uint32_t most = 0;
    for (const auto& of_leaf : surfaces) {
      for (const std::uint32_t number : of_leaf) most = std::max(most, number);
    }
    std::map<std::pair<LeafId, std::uint32_t>, std::uint32_t> own;
    const auto renumber = [&](Soup::Face& face) {
      if (face.surface == 0) return;
      const std::size_t leaf = face.leaf.index();
      const bool numbered = leaf < surfaces.size() && face.patch < surfaces[leaf].size();
      face.surface = numbered ? surfaces[leaf][face.patch] : 0;
      if (face.surface != 0) return;
      const auto next = static_cast<std::uint32_t>(most + 1 + own.size());
      face.surface = own.try_emplace({face.leaf, face.patch}, next).first->second;
    };
    for (Soup::Face& face : out_.sources) renumber(face);
    for (RemovedFacet& facet : out_.removed_facets) renumber(facet.source);
  }

  /// Those of all groups, each with the sheet of its plane, if one is near.
  void take_removed_facets() {
    std::vector<std::size_t> first;
    for (const CarriedGroup& group : groups_) {
      first.push_back(out_.removed_facets.size());
      out_.removed_facets.insert(out_.removed_facets.end(), group.facets_.begin(), group.facets_.end());
    }
    if (out_.removed_facets.empty()) return;
    auto& at_edges = out_.edge_removed_facets;
    std::map<std::array<Integer, 4>, SheetId> known;
    IdVector<SheetId, char> seen(complex_.sheet_plane.size(), 0);
    const auto see_sheets = [&](EdgeId e) {
      for (const FaceUse& use : complex_.edge_uses[e]) {
        const SheetId sheet = complex_.face_sheet[use.face];
        if (std::exchange(seen[sheet], 1) == 0)
          known.try_emplace(either_side(complex_.points.exact_plane(complex_.sheet_plane[sheet])), sheet);
      }
    };
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      const std::size_t before = at_edges.size();
      for (const Piece& piece : carried_.cells_.pieces(e)) {
        if (piece.dimension != 1) continue;
        const CarriedGroup& group = groups_[piece.part];
        for (const Index k : group.facets_of_[group.edges_[piece.number].facets])
          at_edges.emplace_back(e, static_cast<std::uint32_t>(first[piece.part] + k));
      }
      if (at_edges.size() == before) continue;
      for (const VertexId v : complex_.edge_ends[e]) {
        for (const EdgeId other : complex_.vertex_edges[v]) see_sheets(other);
      }
    }
    std::size_t next = complex_.sheet_plane.size();
    for (RemovedFacet& facet : out_.removed_facets) {
      const auto [it, fresh] = known.try_emplace(either_side(facet.plane), SheetId(next));
      facet.sheet = it->second;
      next += fresh ? 1 : 0;
    }
  }

  static std::array<Integer, 4> either_side(const ExactPlane& plane) {
    std::array<Integer, 4> out{plane.a, plane.b, plane.c, plane.d};
    const auto first = std::find_if(out.begin(), out.end(), [](const Integer& x) { return sgn(x) != 0; });
    if (sgn(*first) > 0) return out;
    for (Integer& x : out) x = -x;
    return out;
  }

  /// Sets with what `add` lists for each of their members, each set once; returns what becomes of each set.
  template <class SetId, class Item, class Add>
  static IdVector<SetId, SetId> rename(const Csr<SetId, Item>& sets, Csr<SetId, Item>& out, const Add& add) {
    DistinctLists<SetId, Item> known;
    IdVector<SetId, SetId> renamed;
    for (const SetId set : IdRange<SetId>(sets.size())) {
      std::vector<Item> list;
      for (const Item& item : sets[set]) add(item, list);
      renamed.push_back(known(std::move(list)));
    }
    out = known.take();
    return renamed;
  }

  /// A piece of a carried face is a piece of the input faces that this one is a piece of.
  void take_covers() {
    const auto renamed = rename(complex_.covers, out_.covers, [&](const Cover& cover, std::vector<Cover>& list) {
      const Soup::Face& source = complex_.sources[cover.source];
      const Index g = carried_.cells_.part_of(source.leaf);
      if (g == kNone) {
        list.push_back({kept_[cover.source], cover.same});
        return;
      }
      for (const auto& [s, same] : groups_[g].covers_[groups_[g].faces_[source.leaf_face].cover])
        list.push_back({source_of_[g][s], same == cover.same});
    });
    out_.face_cover = complex_.face_cover;
    for (SourceSetId& set : out_.face_cover) set = renamed[set];
  }

  /// Those of the soup without the carried leaves, and under carried edges those of the sections.
  void take_segments() {
    std::vector<SourceId> faces;
    std::vector<WireId> wires;
    const auto add = [&](const std::array<VertexId, 2>& ends) { return out_.add_segment(ends, faces, wires); };
    for (const SegmentId s : IdRange<SegmentId>(complex_.segment_ends.size())) {
      faces.clear(), wires.clear();
      for (const SourceId f : complex_.segment_faces[s]) {
        if (kept_[f].valid()) faces.push_back(kept_[f]);
      }
      for (const WireId w : complex_.segment_wires[s]) {
        if (kept_wires_[w].valid()) wires.push_back(kept_wires_[w]);
      }
      add(complex_.segment_ends[s]);
    }
    std::map<Piece, SegmentId> of_edge;  // the first one of those of a carried edge
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      const auto own = complex_.edge_segments[e];
      std::vector<SegmentId> list(own.begin(), own.end());
      for (const Piece& piece : carried_.cells_.pieces(e)) {
        if (piece.dimension != 1) continue;
        const CarriedGroup& group = groups_[piece.part];
        const auto& segments = group.segments_of_[group.edges_[piece.number].segments];
        const auto [it, fresh] = of_edge.try_emplace(piece, SegmentId(out_.segment_ends.size()));
        if (fresh) {
          for (const Index k : segments) {
            faces.clear(), wires.clear();
            for (const Index f : group.segments_[k].sources) faces.push_back(source_of_[piece.part][f]);
            for (const Index w : group.segments_[k].wires) wires.push_back(wire_of_[piece.part][w]);
            add(complex_.edge_ends[e]);
          }
        }
        for (std::size_t k = 0; k < segments.size(); ++k) list.push_back(SegmentId(it->second.index() + k));
      }
      sort_unique(list);
      out_.edge_segments.push_back(list);
    }
  }

  /// Isolated points, and ends of curves.
  void take_points() {
    auto &isolated = out_.isolated_leaves, &curve_ends = out_.curve_ends;
    for (const VertexId v : complex_.vertices) {
      for (const LeafId leaf : complex_.isolated_leaves[v]) {
        if (is_own(leaf)) isolated.emplace_back(v, leaf);
      }
      for (const LeafId leaf : complex_.curve_ends[v]) curve_ends.emplace_back(v, leaf);
      for (const Piece& piece : carried_.cells_.pieces(v)) {
        if (piece.dimension != 0) continue;
        const CarriedGroup::Vertex& vertex = groups_[piece.part].vertices_[piece.number];
        for (const LeafId leaf : vertex.isolated) isolated.emplace_back(v, leaf);
        for (const LeafId leaf : vertex.curve_ends) curve_ends.emplace_back(v, leaf);
      }
    }
  }

  /// What held cells and was removed in the sections.
  void take_removed() {
    const auto add = [&](auto cell, const Piece& piece, auto& list) {
      for (const LeafCell& gone : carried_.gone(piece)) list.emplace_back(cell, gone);
    };
    for (const FaceId f : IdRange<FaceId>(complex_.face_count()))
      carried_.cells_.for_each_piece(complex_, f, [&](const Piece& piece) { add(f, piece, out_.held.faces); });
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      for (const Piece& piece : carried_.cells_.pieces(e)) add(e, piece, out_.held.edges);
    }
    for (const VertexId v : complex_.vertices) {
      for (const Piece& piece : carried_.cells_.pieces(v)) add(v, piece, out_.held.vertices);
    }
  }

  /// A class of a group stands for the regions of leaves in which its 3-cells lay.
  void take_labels() {
    const auto renamed =
        rename(complex_.label_sets, out_.label_sets, [&](const Label& label, std::vector<Label>& list) {
          const Index g = carried_.cells_.part_of(label.leaf);
          if (g == kNone) {
            list.push_back(label);
            return;
          }
          const auto& labels = groups_[g].classes_[label.region - 1].labels;
          list.insert(list.end(), labels.begin(), labels.end());
        });
    out_.region_labels = complex_.region_labels;
    for (LabelSetId& set : out_.region_labels) set = renamed[set];
  }
};

ComplexSources CarriedGroups::sources(const Complex& complex, std::span<const std::vector<std::uint32_t>> surfaces,
                                      LeafPlaces& places) const {
  return SourcesMaker(*this, complex, places).run(surfaces);
}

}  // namespace cnrg
