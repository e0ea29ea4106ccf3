// One pass per dimension over the complex. The leaves at an edge are those of the faces around it and of its
// wires, the leaves at a vertex those of its edges.
//
// Nearly all cells lie on faces of one leaf, with one cover each: for these nothing is listed or sorted, a cell
// keeps the leaf alone. A cell of several leaves is marked so and looked at again by who asks, so that the cost is
// that of all incidences. Blocks of cells are looked at in parallel and note (leaf, cell); dealing the notes out
// block by block fills every list in the order of ids.
#include "csg/operators/leaf_group.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <tuple>

#include "csg/operators/boolean.h"
#include "kernel/selection/curve.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

constexpr LeafId kSeveral{0xfffffffe};  // more than one leaf at a cell; LeafId::none() is none
constexpr std::size_t kBlock = 8192;    // cells: some 100 us of work

template <class IdT>
using Notes = std::vector<std::pair<LeafId, IdT>>;

// What one block of cells found.
template <class IdT>
struct Block {
  Notes<IdT> cells, features;
};

LeafId only_one(const std::vector<LeafId>& leaves) {
  return leaves.empty() ? LeafId::none() : leaves.size() == 1 ? leaves[0] : kSeveral;
}

// The patches that are curved: their facets lie in more than one sheet, and they are one face for people. Made
// when it is first asked for; thread-safe.
class CurvedPatches {
 public:
  explicit CurvedPatches(const Complex& complex) : complex_(complex) {}

  bool has(LeafId leaf, std::uint32_t patch) const {
    std::call_once(collected_, [&] { collect(); });
    return std::binary_search(patches_.begin(), patches_.end(), std::pair(leaf, patch));
  }

 private:
  void collect() const {
    std::vector<std::tuple<LeafId, std::uint32_t, SheetId>> facets;
    facets.reserve(complex_.face_count());
    for (FaceId f : IdRange<FaceId>(complex_.face_count())) {
      for (const Cover& c : complex_.cover(f)) {
        const Soup::Face& source = complex_.sources[c.source];
        const std::tuple facet(source.leaf, source.patch, complex_.face_sheet[f]);
        if (facets.empty() || facets.back() != facet) facets.push_back(facet);
      }
    }
    sort_unique(facets);
    for (std::size_t i = 1; i < facets.size(); ++i) {
      const auto& [leaf, patch, sheet] = facets[i];
      if (std::get<0>(facets[i - 1]) == leaf && std::get<1>(facets[i - 1]) == patch) {
        patches_.emplace_back(leaf, patch);
      }
    }
    sort_unique(patches_);
  }

  const Complex& complex_;
  mutable std::once_flag collected_;
  mutable std::vector<std::pair<LeafId, std::uint32_t>> patches_;
};

class LeafGroups {
 public:
  explicit LeafGroups(const Complex& complex)
      : complex_(complex), groups_(complex.leaf_count), curved_(complex), only_source_(complex.face_count()),
        edge_leaf_(complex.edge_count()), edge_feature_(complex.edge_count()) {}

  std::vector<Group> run(const std::vector<std::vector<RegionAttributes>>& attributes) {
    const auto faces = look_at<FaceId>(complex_.face_count(), [&](std::size_t i, Nearby& nearby, auto& block) {
      look_at_face(FaceId(i), nearby, block);
    });
    const auto edges = look_at<EdgeId>(complex_.edge_count(), [&](std::size_t i, Nearby& nearby, auto& block) {
      look_at_edge(EdgeId(i), nearby, block);
    });
    const auto vertices =
        look_at<VertexId>(complex_.vertices.size(), [&](std::size_t i, Nearby& nearby, auto& block) {
          look_at_vertex(complex_.vertices[i], nearby, block);
        });
    tbb::parallel_invoke(
        [&] { deal(faces, &Block<FaceId>::cells, [](Group& g) -> auto& { return g.faces; }); },
        [&] { deal(edges, &Block<EdgeId>::cells, [](Group& g) -> auto& { return g.edges; }); },
        [&] { deal(edges, &Block<EdgeId>::features, [](Group& g) -> auto& { return g.features.edges; }); },
        [&] { deal(vertices, &Block<VertexId>::cells, [](Group& g) -> auto& { return g.vertices; }); },
        [&] { deal(vertices, &Block<VertexId>::features, [](Group& g) -> auto& { return g.features.vertices; }); });
    const auto labelled = label_regions();
    tbb::parallel_for(std::size_t{0}, groups_.size(), [&](std::size_t leaf) {
      regions(LeafId(leaf), labelled[leaf], leaf < attributes.size() ? attributes[leaf] : kNoAttributes);
      origins(LeafId(leaf));
    });
    return std::move(groups_);
  }

 private:
  inline static const std::vector<RegionAttributes> kNoAttributes;

  // Lists about one cell, kept for their memory.
  struct Nearby {
    std::vector<LeafId> leaves, bordering, features;
    std::vector<std::pair<LeafId, EdgeId>> feature_edges;
    std::vector<std::tuple<bool, std::uint32_t, FaceId, HalfEdge>> pieces;
    std::vector<LeafId> at_vertex;
  };

  bool counts(LeafId leaf) const { return leaf != complex_.frame; }

  // look(i, nearby, block) for all i < count, in blocks.
  template <class IdT, class Look>
  static std::vector<Block<IdT>> look_at(std::size_t count, Look look) {
    std::vector<Block<IdT>> blocks((count + kBlock - 1) / kBlock);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
      Nearby nearby;
      const std::size_t end = std::min(count, (b + 1) * kBlock);
      blocks[b].cells.reserve(end - b * kBlock);
      for (std::size_t i = b * kBlock; i < end; ++i) look(i, nearby, blocks[b]);
    });
    return blocks;
  }

  template <class IdT, class List>
  void deal(const std::vector<Block<IdT>>& blocks, Notes<IdT> Block<IdT>::*which, List list) {
    std::vector<std::size_t> count(groups_.size(), 0);
    for (const Block<IdT>& block : blocks) {
      for (const auto& [leaf, cell] : block.*which) ++count[leaf.index()];
    }
    for (std::size_t leaf = 0; leaf < count.size(); ++leaf) list(groups_[leaf]).reserve(count[leaf]);
    for (const Block<IdT>& block : blocks) {
      for (const auto& [leaf, cell] : block.*which) list(groups_[leaf.index()]).push_back(cell);
    }
  }

  void look_at_face(FaceId f, Nearby& nearby, Block<FaceId>& block) {
    if (complex_.on_frame(f)) return;
    const auto covers = complex_.cover(f);
    if (covers.size() == 1) {
      const LeafId leaf = complex_.sources[covers[0].source].leaf;
      if (!counts(leaf)) return;
      only_source_[f] = covers[0].source;
      block.cells.emplace_back(leaf, f);
      return;
    }
    nearby.leaves.clear();
    add_covering(f, nearby.leaves);
    sort_unique(nearby.leaves);
    for (const LeafId leaf : nearby.leaves) block.cells.emplace_back(leaf, f);
  }

  void add_covering(FaceId f, std::vector<LeafId>& leaves) const {
    for (const Cover& c : complex_.cover(f)) {
      const LeafId leaf = complex_.sources[c.source].leaf;
      if (counts(leaf)) leaves.push_back(leaf);
    }
  }

  void look_at_edge(EdgeId e, Nearby& nearby, Block<EdgeId>& block) {
    if (complex_.on_frame(e)) return;
    if (parts_one_leaf(e)) {
      block.cells.emplace_back(edge_leaf_[e], e);
      if (edge_feature_[e].valid()) block.features.emplace_back(edge_leaf_[e], e);
      return;
    }
    find_leaves(e, nearby);
    edge_leaf_[e] = only_one(nearby.leaves);
    edge_feature_[e] = only_one(nearby.features);
    for (const LeafId leaf : nearby.leaves) block.cells.emplace_back(leaf, e);
    for (const LeafId leaf : nearby.features) block.features.emplace_back(leaf, e);
  }

  // An edge between two faces that one face each of one and the same leaf covers, and nothing else at it: notes
  // its leaf, and if it is a feature. False for any other edge.
  bool parts_one_leaf(EdgeId e) {
    const auto uses = complex_.edge_uses[e];
    if (uses.size() != 2) return false;
    const SourceId front = only_source_[uses[0].face], back = only_source_[uses[1].face];
    if (!front.valid() || !back.valid()) return false;
    const Soup::Face &a = complex_.sources[front], &b = complex_.sources[back];
    if (a.leaf != b.leaf) return false;
    bool borders = false;
    for (SegmentId s : complex_.edge_segments[e]) {
      if (!complex_.segment_wires[s].empty()) return false;
      for (SourceId f : complex_.segment_faces[s]) {
        if (f != front && f != back && complex_.sources[f].leaf != a.leaf) return false;
        borders = true;
      }
    }
    edge_leaf_[e] = a.leaf;
    if (borders && parts(a, b)) edge_feature_[e] = a.leaf;
    return true;
  }

  // False for two pieces of one and the same face or curved patch.
  bool parts(const Soup::Face& a, const Soup::Face& b) const {
    if ((a.leaf_face == b.leaf_face) == (a.patch == b.patch)) return a.patch != b.patch;
    const bool curved = curved_.has(a.leaf, a.patch);
    return curved != curved_.has(b.leaf, b.patch) || (curved ? a.patch != b.patch : a.leaf_face != b.leaf_face);
  }

  // Any edge: fills `leaves` and `features`, ascending.
  void find_leaves(EdgeId e, Nearby& nearby) const {
    auto& [leaves, bordering, features, feature_edges, pieces, at_vertex] = nearby;
    leaves.clear(), bordering.clear(), features.clear();
    for (SegmentId s : complex_.edge_segments[e]) {
      for (WireId w : complex_.segment_wires[s]) features.push_back(complex_.wires[w].leaf);
      for (SourceId f : complex_.segment_faces[s]) bordering.push_back(complex_.sources[f].leaf);
    }
    leaves = features;
    for (const FaceUse& use : complex_.edge_uses[e]) {
      if (!complex_.on_frame(use.face)) add_covering(use.face, leaves);
    }
    sort_unique(leaves), sort_unique(bordering);
    for (LeafId leaf : bordering) {
      if (counts(leaf) && parts_faces(e, leaf, pieces)) features.push_back(leaf);
    }
    sort_unique(features);
  }

  // False if the faces of the leaf around the edge are two pieces of one and the same face or curved patch.
  template <class Pieces>
  bool parts_faces(EdgeId e, LeafId leaf, Pieces& pieces) const {
    pieces.clear();
    for (const FaceUse& use : complex_.edge_uses[e]) {
      for (const Cover& c : complex_.cover(use.face)) {
        const Soup::Face& source = complex_.sources[c.source];
        if (source.leaf != leaf) continue;
        const bool curved = curved_.has(leaf, source.patch);
        pieces.emplace_back(curved, curved ? source.patch : source.leaf_face, use.face, use.half_edge);
      }
    }
    sort_unique(pieces);
    return pieces.size() != 2 || std::get<0>(pieces[0]) != std::get<0>(pieces[1]) ||
           std::get<1>(pieces[0]) != std::get<1>(pieces[1]);
  }

  void look_at_vertex(VertexId v, Nearby& nearby, Block<VertexId>& block) const {
    if (complex_.on_frame(v)) return;
    if (LeafId leaf; is_of_one_leaf(v, leaf)) {
      FeatureEnds ends;
      for (EdgeId e : complex_.vertex_edges[v]) {
        if (edge_feature_[e].valid()) ends.add(e);
      }
      block.cells.emplace_back(leaf, v);
      if (end_features(v, leaf, ends)) block.features.emplace_back(leaf, v);
      return;
    }
    auto& leaves = nearby.at_vertex;
    auto& features = nearby.feature_edges;
    leaves.clear(), features.clear();
    for (EdgeId e : complex_.vertex_edges[v]) {
      find_leaves(e, nearby);
      leaves.insert(leaves.end(), nearby.leaves.begin(), nearby.leaves.end());
      for (LeafId leaf : nearby.features) features.emplace_back(leaf, e);
    }
    for (FaceId f : complex_.vertex_faces[v]) add_covering(f, leaves);
    const auto isolated = complex_.isolated_leaves[v];
    leaves.insert(leaves.end(), isolated.begin(), isolated.end());
    sort_unique(leaves);
    std::sort(features.begin(), features.end());
    for (LeafId leaf : leaves) {
      if (!counts(leaf)) continue;
      FeatureEnds ends;
      auto it = std::lower_bound(features.begin(), features.end(), std::pair(leaf, EdgeId(0)));
      for (; it != features.end() && it->first == leaf; ++it) ends.add(it->second);
      block.cells.emplace_back(leaf, v);
      const bool own = std::find(isolated.begin(), isolated.end(), leaf) != isolated.end();
      if (own || end_features(v, leaf, ends)) block.features.emplace_back(leaf, v);
    }
  }

  // All edges at the vertex are of one and the same leaf, and there are no other cells of leaves.
  bool is_of_one_leaf(VertexId v, LeafId& leaf) const {
    const auto edges = complex_.vertex_edges[v];
    if (edges.empty() || !complex_.vertex_faces[v].empty() || !complex_.isolated_leaves[v].empty()) return false;
    leaf = edge_leaf_[edges[0]];
    return leaf.valid() && leaf != kSeveral &&
           std::all_of(edges.begin(), edges.end(), [&](EdgeId e) {
             return edge_leaf_[e] == leaf && (!edge_feature_[e].valid() || edge_feature_[e] == leaf);
           });
  }

  // The feature edges of a leaf at a vertex, in the order of ids: the first two count.
  struct FeatureEnds {
    EdgeId at[2];
    std::size_t count = 0;
    void add(EdgeId e) {
      if (count < 2) at[count] = e;
      ++count;
    }
  };

  bool end_features(VertexId v, LeafId leaf, const FeatureEnds& ends) const {
    const auto& [a, b] = ends.at;
    if (ends.count == 0) return false;
    return ends.count != 2 || !(straight(complex_, v, a, b) || one_curve(complex_, v, a, b, leaf));
  }

  using Labelled = std::vector<std::pair<RegionId, std::uint32_t>>;  // 3-cells and labels of one leaf

  std::vector<Labelled> label_regions() const {
    std::vector<Labelled> labelled(complex_.leaf_count);
    for (RegionId r : IdRange<RegionId>(complex_.region_count)) {
      if (complex_.outside_frame(r)) continue;
      for (const Label& label : complex_.labels(r)) {
        if (counts(label.leaf)) labelled[label.leaf.index()].emplace_back(r, label.region);
      }
    }
    return labelled;
  }

  void regions(LeafId leaf, const Labelled& labelled, const std::vector<RegionAttributes>& attributes) {
    Group& group = groups_[leaf.index()];
    std::vector<RegionId> inside;
    inside.reserve(labelled.size());
    for (const auto& [cell, label] : labelled) inside.push_back(cell);
    group.cells = detect_regions(complex_, inside, group.faces);
    for (std::size_t i = 0; i < group.cells.size(); ++i) {
      if (group.cells[i].second <= group.regions.size()) continue;
      const std::size_t label = labelled[i].second - 1;
      RegionAttributes region;
      if (label < attributes.size()) region = attributes[label];
      region.leaves = {leaf};
      group.regions.push_back(std::move(region));
    }
  }

  void origins(LeafId leaf) {
    Group& group = groups_[leaf.index()];
    const LeafSetId own = group.origins.sets.intern(leaf);
    group.origins.faces.assign(group.faces.size(), own);
    group.origins.edges.assign(group.edges.size(), own);
    group.origins.vertices.assign(group.vertices.size(), own);
  }

  const Complex& complex_;
  std::vector<Group> groups_;
  CurvedPatches curved_;
  IdVector<FaceId, SourceId> only_source_;  // of a face with one cover, off the frame; none() otherwise
  IdVector<EdgeId, LeafId> edge_leaf_, edge_feature_;
};

}  // namespace

std::vector<Group> leaf_groups(const Complex& complex,
                               const std::vector<std::vector<RegionAttributes>>& attributes) {
  return LeafGroups(complex).run(attributes);
}

}  // namespace cnrg
