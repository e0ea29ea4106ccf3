// One pass per dimension over the complex; every list is filled in the order of ids. The leaves at an edge are
// those of the faces around it and of its wires, the leaves at a vertex those of its edges: computed once per
// cell, so that the cost is that of all incidences.
#include "csg/operators/leaf_group.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "csg/operators/boolean.h"
#include "kernel/selection/curve.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

class LeafGroups {
 public:
  explicit LeafGroups(const Complex& complex) : complex_(complex), groups_(complex.leaf_count) {
    collect_cover_leaves();
    collect_curved_patches();
  }

  std::vector<Group> run(const std::vector<std::vector<RegionAttributes>>& attributes) {
    faces();
    edges();
    vertices();
    regions(attributes);
    origins();
    return std::move(groups_);
  }

 private:
  bool counts(LeafId leaf) const { return leaf != complex_.frame; }

  void collect_cover_leaves() {
    cover_leaves_.reserve(complex_.covers.size(), complex_.covers.value_count());
    std::vector<LeafId> leaves;
    for (SourceSetId set : IdRange<SourceSetId>(complex_.covers.size())) {
      leaves.clear();
      for (const Cover& c : complex_.covers[set]) {
        const LeafId leaf = complex_.sources[c.source].leaf;
        if (counts(leaf)) leaves.push_back(leaf);
      }
      sort_unique(leaves);
      cover_leaves_.push_back(leaves);
    }
  }

  // A patch is curved when its facets lie in more than one sheet: then it is one face for people.
  void collect_curved_patches() {
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
        curved_patches_.emplace_back(leaf, patch);
      }
    }
    sort_unique(curved_patches_);
  }

  void faces() {
    for (FaceId f : IdRange<FaceId>(complex_.face_count())) {
      if (complex_.on_frame(f)) continue;
      for (LeafId leaf : cover_leaves_[complex_.face_cover[f]]) groups_[leaf.index()].faces.push_back(f);
    }
  }

  void edges() {
    edge_leaves_.reserve(complex_.edge_count(), complex_.edge_count());
    feature_leaves_.reserve(complex_.edge_count(), complex_.edge_count());
    std::vector<LeafId> leaves, bordering, wired, features;
    for (EdgeId e : IdRange<EdgeId>(complex_.edge_count())) {
      leaves.clear(), bordering.clear(), wired.clear(), features.clear();
      if (!complex_.on_frame(e)) {
        for (const FaceUse& use : complex_.edge_uses[e]) {
          if (complex_.on_frame(use.face)) continue;
          const auto covering = cover_leaves_[complex_.face_cover[use.face]];
          leaves.insert(leaves.end(), covering.begin(), covering.end());
        }
        for (SegmentId s : complex_.edge_segments[e]) {
          for (WireId w : complex_.segment_wires[s]) wired.push_back(complex_.wires[w].leaf);
          for (SourceId f : complex_.segment_faces[s]) bordering.push_back(complex_.sources[f].leaf);
        }
        leaves.insert(leaves.end(), wired.begin(), wired.end());
        sort_unique(leaves), sort_unique(bordering), sort_unique(wired);
        for (LeafId leaf : bordering) {
          if (counts(leaf) && parts_faces(e, leaf)) features.push_back(leaf);
        }
        features.insert(features.end(), wired.begin(), wired.end());
        sort_unique(features);
        for (LeafId leaf : leaves) groups_[leaf.index()].edges.push_back(e);
        for (LeafId leaf : features) groups_[leaf.index()].features.edges.push_back(e);
      }
      edge_leaves_.push_back(leaves);
      feature_leaves_.push_back(features);
    }
  }

  // False if the faces of the leaf around the edge are two pieces of one and the same face or curved patch.
  bool parts_faces(EdgeId e, LeafId leaf) {
    pieces_.clear();
    for (const FaceUse& use : complex_.edge_uses[e]) {
      for (const Cover& c : complex_.cover(use.face)) {
        const Soup::Face& source = complex_.sources[c.source];
        if (source.leaf != leaf) continue;
        const bool curved = std::binary_search(curved_patches_.begin(), curved_patches_.end(),
                                               std::pair(leaf, source.patch));
        pieces_.emplace_back(curved, curved ? source.patch : source.leaf_face, use.face, use.half_edge);
      }
    }
    sort_unique(pieces_);
    return pieces_.size() != 2 || std::get<0>(pieces_[0]) != std::get<0>(pieces_[1]) ||
           std::get<1>(pieces_[0]) != std::get<1>(pieces_[1]);
  }

  void vertices() {
    std::vector<LeafId> leaves;
    std::vector<std::pair<LeafId, EdgeId>> features;
    for (VertexId v : complex_.vertices) {
      if (complex_.on_frame(v)) continue;
      leaves.clear(), features.clear();
      for (EdgeId e : complex_.vertex_edges[v]) {
        const auto at_edge = edge_leaves_[e];
        leaves.insert(leaves.end(), at_edge.begin(), at_edge.end());
        for (LeafId leaf : feature_leaves_[e]) features.emplace_back(leaf, e);
      }
      for (FaceId f : complex_.vertex_faces[v]) {
        const auto covering = cover_leaves_[complex_.face_cover[f]];
        leaves.insert(leaves.end(), covering.begin(), covering.end());
      }
      const auto isolated = complex_.isolated_leaves[v];
      leaves.insert(leaves.end(), isolated.begin(), isolated.end());
      sort_unique(leaves);
      std::sort(features.begin(), features.end());
      for (LeafId leaf : leaves) {
        if (!counts(leaf)) continue;
        Group& group = groups_[leaf.index()];
        group.vertices.push_back(v);
        const bool own = std::find(isolated.begin(), isolated.end(), leaf) != isolated.end();
        if (own || ends_features(v, leaf, features)) group.features.vertices.push_back(v);
      }
    }
  }

  bool ends_features(VertexId v, LeafId leaf, const std::vector<std::pair<LeafId, EdgeId>>& features) const {
    auto it = std::lower_bound(features.begin(), features.end(), std::pair(leaf, EdgeId(0)));
    std::size_t n = 0;
    EdgeId at[2];
    for (; it != features.end() && it->first == leaf; ++it, ++n) {
      if (n < 2) at[n] = it->second;
    }
    if (n == 0) return false;
    return n != 2 || !(straight(complex_, v, at[0], at[1]) || one_curve(complex_, v, at[0], at[1], leaf));
  }

  void regions(const std::vector<std::vector<RegionAttributes>>& attributes) {
    std::vector<std::vector<std::pair<RegionId, std::uint32_t>>> labelled(complex_.leaf_count);
    for (RegionId r : IdRange<RegionId>(complex_.region_count)) {
      if (complex_.outside_frame(r)) continue;
      for (const Label& label : complex_.labels(r)) {
        if (counts(label.leaf)) labelled[label.leaf.index()].emplace_back(r, label.region);
      }
    }
    std::vector<RegionId> inside;
    for (std::size_t leaf = 0; leaf < labelled.size(); ++leaf) {
      Group& group = groups_[leaf];
      inside.clear();
      for (const auto& [cell, label] : labelled[leaf]) inside.push_back(cell);
      group.cells = detect_regions(complex_, inside, group.faces);
      for (std::size_t i = 0; i < group.cells.size(); ++i) {
        if (group.cells[i].second <= group.regions.size()) continue;
        const std::size_t label = labelled[leaf][i].second - 1;
        RegionAttributes region;
        if (leaf < attributes.size() && label < attributes[leaf].size()) region = attributes[leaf][label];
        region.leaves = {LeafId(leaf)};
        group.regions.push_back(std::move(region));
      }
    }
  }

  void origins() {
    for (std::size_t leaf = 0; leaf < groups_.size(); ++leaf) {
      Group& group = groups_[leaf];
      const LeafSetId own = group.origins.sets.intern(LeafId(leaf));
      group.origins.faces.assign(group.faces.size(), own);
      group.origins.edges.assign(group.edges.size(), own);
      group.origins.vertices.assign(group.vertices.size(), own);
    }
  }

  const Complex& complex_;
  std::vector<Group> groups_;
  Csr<SourceSetId, LeafId> cover_leaves_;
  std::vector<std::pair<LeafId, std::uint32_t>> curved_patches_;
  Csr<EdgeId, LeafId> edge_leaves_, feature_leaves_;
  std::vector<std::tuple<bool, std::uint32_t, FaceId, HalfEdge>> pieces_;
};

}  // namespace

std::vector<Group> leaf_groups(const Complex& complex,
                               const std::vector<std::vector<RegionAttributes>>& attributes) {
  return LeafGroups(complex).run(attributes);
}

}  // namespace cnrg
