// One pass per dimension over the complex. The leaves at an edge are those of the faces around it and of its
// wires, the leaves at a vertex those of its edges.
//
// Nearly all cells lie on faces of one leaf, with one cover each: for these nothing is listed or sorted, a cell
// keeps the leaf alone. A cell of several leaves is marked so and looked at again by who asks, so that the cost is
// that of all incidences. Blocks of cells are looked at in parallel; then every cell is dealt to its leaves in the
// order of ids.
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "csg/operators/detect_regions.h"
#include "csg/operators/group.h"
#include "kernel/base/sorted.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/curve.h"

namespace cnrg {
namespace {

constexpr LeafId kSeveral{0xfffffffe};  // more than one leaf at a cell; LeafId::none() is none
constexpr std::size_t kBlock = 8192;    // cells: some 100 us of work

// Which leaves have each cell of one kind.
template <class IdT>
class Holders {
 public:
  explicit Holders(std::size_t cells) : only_(cells) {}
  /// The one leaf that has the cell, none() or kSeveral.
  LeafId operator[](IdT cell) const { return only_[cell]; }
  void set(IdT cell, LeafId leaf) { only_[cell] = leaf; }

  void make_blocks(std::size_t count) { several_.resize(count); }
  /// Cells of one block come in the order of ids; `leaves` are ascending.
  void set(IdT cell, const std::vector<LeafId>& leaves, std::size_t block) {
    if (leaves.empty()) return;
    only_[cell] = leaves.size() == 1 ? leaves[0] : kSeveral;
    if (leaves.size() == 1) return;
    for (const LeafId leaf : leaves) several_[block].emplace_back(cell, leaf);
  }
  /// f(leaf, cell) for `cells` in blocks of kBlock, the leaves of each ascending.
  template <class Cells, class F>
  void for_each(std::size_t count, Cells cells, F f) const {
    for (std::size_t b = 0; b < several_.size(); ++b) {
      auto next = several_[b].begin();
      const std::size_t end = std::min(count, (b + 1) * kBlock);
      for (std::size_t i = b * kBlock; i < end; ++i) {
        const IdT cell = cells(i);
        if (only_[cell] == kSeveral) {
          for (; next != several_[b].end() && next->first == cell; ++next) f(next->second, cell);
        } else if (only_[cell].valid()) {
          f(only_[cell], cell);
        }
      }
    }
  }

 private:
  IdVector<IdT, LeafId> only_;
  std::vector<std::vector<std::pair<IdT, LeafId>>> several_;  // by block
};

class LeafGroups {
 public:
  explicit LeafGroups(const Complex& complex)
      : complex_(complex),
        groups_(complex.leaf_count),
        only_source_(complex.face_count()),
        faces_(complex.face_count()),
        edges_(complex.edge_count()),
        edge_features_(complex.edge_count()),
        vertices_(complex.points.size()),
        vertex_features_(complex.points.size()) {}

  std::vector<Group> run(const std::vector<std::vector<Attributes>>& attributes) {
    const auto face = [](std::size_t i) { return FaceId(i); };
    const auto edge = [](std::size_t i) { return EdgeId(i); };
    const auto vertex = [&](std::size_t i) { return complex_.vertices[i]; };
    const std::size_t faces = complex_.face_count(), edges = complex_.edge_count(),
                      vertices = complex_.vertex_count();
    faces_.make_blocks(block_count(faces));
    edges_.make_blocks(block_count(edges)), edge_features_.make_blocks(block_count(edges));
    vertices_.make_blocks(block_count(vertices)), vertex_features_.make_blocks(block_count(vertices));
    look_at(faces, [&](std::size_t i, Nearby& nearby) { look_at_face(face(i), i / kBlock, nearby); });
    look_at(edges, [&](std::size_t i, Nearby& nearby) { look_at_edge(edge(i), i / kBlock, nearby); });
    look_at(vertices, [&](std::size_t i, Nearby& nearby) { look_at_vertex(vertex(i), i / kBlock, nearby); });
    tbb::parallel_invoke(
        [&] { deal(faces_, faces, face, &Group::faces); }, [&] { deal(edges_, edges, edge, &Group::edges); },
        [&] {
          deal(
              edge_features_, edges, edge, [](Group & g) -> auto& { return g.features.edges; });
        },
        [&] { deal(vertices_, vertices, vertex, &Group::vertices); },
        [&] {
          deal(
              vertex_features_, vertices, vertex, [](Group & g) -> auto& { return g.features.vertices; });
        });
    const auto labelled = label_regions();
    tbb::parallel_for(std::size_t{0}, groups_.size(), [&](std::size_t leaf) {
      regions(LeafId(leaf), labelled[leaf], leaf < attributes.size() ? attributes[leaf] : kNoAttributes);
      origins(LeafId(leaf));
    });
    return std::move(groups_);
  }

 private:
  inline static const std::vector<Attributes> kNoAttributes;

  // A soup face that covers a face around an edge.
  struct Piece {
    LeafId leaf;
    std::uint32_t use;  // its place around the edge
    SourceId source;
    auto operator<=>(const Piece&) const = default;
  };

  // Lists about one cell, kept for their memory.
  struct Nearby {
    std::vector<LeafId> leaves, bordering, features;
    std::vector<Piece> pieces;
    std::vector<LeafId> at_vertex;
    std::vector<std::pair<LeafId, EdgeId>> feature_edges;
  };

  bool counts(LeafId leaf) const { return leaf != complex_.frame; }

  static std::size_t block_count(std::size_t cells) { return (cells + kBlock - 1) / kBlock; }

  // look(i, nearby) for all i < count, blocks in parallel.
  template <class Look>
  static void look_at(std::size_t count, Look look) {
    tbb::parallel_for(std::size_t{0}, block_count(count), [&](std::size_t b) {
      Nearby nearby;
      const std::size_t end = std::min(count, (b + 1) * kBlock);
      for (std::size_t i = b * kBlock; i < end; ++i) look(i, nearby);
    });
  }

  // Fills the lists of all groups: `list(group)` is that of one.
  template <class IdT, class Cells, class List>
  void deal(const Holders<IdT>& holders, std::size_t cells, Cells cell_at, List list) {
    std::vector<std::size_t> count(groups_.size(), 0);
    holders.for_each(cells, cell_at, [&](LeafId leaf, IdT) { ++count[leaf.index()]; });
    for (std::size_t leaf = 0; leaf < count.size(); ++leaf) std::invoke(list, groups_[leaf]).reserve(count[leaf]);
    holders.for_each(cells, cell_at,
                     [&](LeafId leaf, IdT cell) { std::invoke(list, groups_[leaf.index()]).push_back(cell); });
  }

  void look_at_face(FaceId f, std::size_t block, Nearby& nearby) {
    if (complex_.on_frame(f)) return;
    const auto covers = complex_.cover(f);
    if (covers.size() == 1) {
      const LeafId leaf = complex_.sources[covers[0].source].leaf;
      if (!counts(leaf)) return;
      only_source_[f] = covers[0].source;
      faces_.set(f, leaf);
      return;
    }
    nearby.leaves.clear();
    add_covering(f, nearby.leaves);
    sort_unique(nearby.leaves);
    faces_.set(f, nearby.leaves, block);
  }

  void add_covering(FaceId f, std::vector<LeafId>& leaves) const {
    for (const Cover& c : complex_.cover(f)) {
      const LeafId leaf = complex_.sources[c.source].leaf;
      if (counts(leaf)) leaves.push_back(leaf);
    }
  }

  void look_at_edge(EdgeId e, std::size_t block, Nearby& nearby) {
    if (complex_.on_frame(e) || parts_one_leaf(e)) return;
    find_leaves(e, nearby);
    edges_.set(e, nearby.leaves, block);
    edge_features_.set(e, nearby.features, block);
  }

  // The common case: at the edge are two faces and nothing else, and each is covered by one face, both of the same
  // leaf. Notes that leaf, and if the edge is a feature. False for any other edge.
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
        if (complex_.sources[f].leaf != a.leaf) return false;
        borders = true;
      }
    }
    edges_.set(e, a.leaf);
    if (borders && parts(a, b)) edge_features_.set(e, a.leaf);
    return true;
  }

  // False for two pieces of one and the same face or curved patch.
  bool parts(const Soup::Face& a, const Soup::Face& b) const {
    if ((a.leaf_face == b.leaf_face) == (a.patch == b.patch)) return a.patch != b.patch;
    const bool curved = a.surface != 0;
    return curved != (b.surface != 0) || (curved ? a.patch != b.patch : a.leaf_face != b.leaf_face);
  }

  // Any edge: fills `leaves` and `features`, ascending.
  void find_leaves(EdgeId e, Nearby& nearby) const {
    auto& [leaves, bordering, features, pieces, at_vertex, feature_edges] = nearby;
    leaves.clear(), bordering.clear(), features.clear();
    for (SegmentId s : complex_.edge_segments[e]) {
      for (WireId w : complex_.segment_wires[s]) features.push_back(complex_.wires[w].leaf);
      for (SourceId f : complex_.segment_faces[s]) bordering.push_back(complex_.sources[f].leaf);
    }
    leaves = features;
    list_pieces(e, pieces);
    for (const Piece& piece : pieces) {
      if (!leaves.empty() && leaves.back() == piece.leaf) continue;
      if (counts(piece.leaf) && !complex_.on_frame(complex_.edge_uses[e][piece.use].face))
        leaves.push_back(piece.leaf);
    }
    sort_unique(leaves), sort_unique(bordering);
    for (LeafId leaf : bordering) {
      const auto of_leaf = std::ranges::equal_range(pieces, leaf, {}, &Piece::leaf);
      if (counts(leaf) && parts_faces(of_leaf)) features.push_back(leaf);
    }
    sort_unique(features);
  }

  void list_pieces(EdgeId e, std::vector<Piece>& pieces) const {
    pieces.clear();
    const auto uses = complex_.edge_uses[e];
    for (std::uint32_t use = 0; use < uses.size(); ++use) {
      for (const Cover& c : complex_.cover(uses[use].face)) {
        pieces.push_back({complex_.sources[c.source].leaf, use, c.source});
      }
    }
    std::sort(pieces.begin(), pieces.end());
  }

  // Of all pieces of a leaf around an edge: false if there are two and the same faces or curved patches of the
  // leaf cover both, or if there are none: a face without area borders edges and covers nothing.
  bool parts_faces(std::span<const Piece> pieces) const {
    if (pieces.empty()) return false;
    if (pieces.size() < 2 || pieces.front().use == pieces.back().use) return true;
    // There are two uses at least. A third one makes a feature; of two, each may be covered by several faces,
    // which all go on beyond the edge or do not.
    const std::uint32_t one = pieces.front().use;
    const auto first_of_back =
        std::find_if(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.use != one; });
    const std::uint32_t other = first_of_back->use;
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece& p) {
      if (p.use != one && p.use != other) return true;
      return std::none_of(pieces.begin(), pieces.end(), [&](const Piece& q) {
        return q.use != p.use && !parts(complex_.sources[p.source], complex_.sources[q.source]);
      });
    });
  }

  void look_at_vertex(VertexId v, std::size_t block, Nearby& nearby) {
    if (complex_.on_frame(v)) return;
    if (LeafId leaf; is_of_one_leaf(v, leaf)) {
      FeatureEnds ends;
      for (EdgeId e : complex_.vertex_edges[v]) {
        if (edge_features_[e].valid()) ends.add(e);
      }
      vertices_.set(v, leaf);
      if (end_features(v, leaf, ends)) vertex_features_.set(v, leaf);
      return;
    }
    auto& leaves = nearby.at_vertex;
    auto& features = nearby.feature_edges;
    leaves.clear(), features.clear();
    for (EdgeId e : complex_.vertex_edges[v]) {
      if (edges_[e] == kSeveral || edge_features_[e] == kSeveral) {
        find_leaves(e, nearby);
        leaves.insert(leaves.end(), nearby.leaves.begin(), nearby.leaves.end());
        for (LeafId leaf : nearby.features) features.emplace_back(leaf, e);
      } else {
        if (edges_[e].valid()) leaves.push_back(edges_[e]);
        if (edge_features_[e].valid()) features.emplace_back(edge_features_[e], e);
      }
    }
    for (FaceId f : complex_.vertex_faces[v]) add_covering(f, leaves);
    const auto isolated = complex_.isolated_leaves[v];
    leaves.insert(leaves.end(), isolated.begin(), isolated.end());
    sort_unique(leaves);
    std::erase_if(leaves, [&](LeafId leaf) { return !counts(leaf); });
    std::sort(features.begin(), features.end());
    vertices_.set(v, leaves, block);
    std::erase_if(leaves, [&](LeafId leaf) {
      FeatureEnds ends;
      auto it = std::lower_bound(features.begin(), features.end(), std::pair(leaf, EdgeId(0)));
      for (; it != features.end() && it->first == leaf; ++it) ends.add(it->second);
      const bool own = std::find(isolated.begin(), isolated.end(), leaf) != isolated.end();
      return !own && !end_features(v, leaf, ends);
    });
    vertex_features_.set(v, leaves, block);
  }

  // All edges at the vertex are of one and the same leaf, and there are no other cells of leaves.
  bool is_of_one_leaf(VertexId v, LeafId& leaf) const {
    const auto edges = complex_.vertex_edges[v];
    if (edges.empty() || !complex_.vertex_faces[v].empty() || !complex_.isolated_leaves[v].empty()) return false;
    leaf = edges_[edges[0]];
    return leaf.valid() && leaf != kSeveral && std::all_of(edges.begin(), edges.end(), [&](EdgeId e) {
             return edges_[e] == leaf && (!edge_features_[e].valid() || edge_features_[e] == leaf);
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
    const std::span<const LeafId> own(&leaf, 1);
    return ends.count != 2 || !(share_segment(complex_, a, b) || one_curve(complex_, v, {a, own}, {b, own}));
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

  void regions(LeafId leaf, const Labelled& labelled, const std::vector<Attributes>& attributes) {
    Group& group = groups_[leaf.index()];
    std::vector<RegionId> inside;
    inside.reserve(labelled.size());
    for (const auto& [cell, label] : labelled) inside.push_back(cell);
    group.cells = detect_regions(complex_, inside, group.faces);
    for (std::size_t i = 0; i < group.cells.size(); ++i) {
      if (group.cells[i].second <= group.regions.size()) continue;
      const std::size_t label = labelled[i].second - 1;
      group.regions.push_back({label < attributes.size() ? attributes[label] : Attributes{}, {leaf}});
    }
  }

  void origins(LeafId leaf) {
    Group& group = groups_[leaf.index()];
    const LeafSetId own = group.origins.sets.intern(leaf);
    for_each_entity([&](auto& origins, const auto& cells) { origins.assign(cells.size(), own); }, group.origins,
                    group);
  }

  const Complex& complex_;
  std::vector<Group> groups_;
  IdVector<FaceId, SourceId> only_source_;  // of a face with one cover, off the frame; none() otherwise
  Holders<FaceId> faces_;
  Holders<EdgeId> edges_, edge_features_;
  Holders<VertexId> vertices_, vertex_features_;
};

}  // namespace

std::vector<Group> leaf_groups(const Complex& complex, const std::vector<std::vector<Attributes>>& attributes) {
  return LeafGroups(complex).run(attributes);
}

}  // namespace cnrg
