// Which cells of leaves hold a cell of the complex: faces by the covers, wires by the segments under edges,
// regions by the labels, each of the cells around it.
#include "csg/operators/origins.h"

#include <algorithm>
#include <iterator>

#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

bool among(std::span<const LeafId> leaves, LeafId leaf) {
  return std::binary_search(leaves.begin(), leaves.end(), leaf);
}

void add_cover(const Complex& complex, FaceId f, std::span<const LeafId> leaves, std::vector<LeafCell>& out) {
  for (const Cover& cover : complex.cover(f)) {
    const Soup::Face& face = complex.sources[cover.source];
    if (among(leaves, face.leaf)) out.push_back({face.leaf, 2, face.leaf_face});
  }
}

void add_wires(const Complex& complex, EdgeId e, std::span<const LeafId> leaves, std::vector<LeafCell>& out) {
  for (const SegmentId s : complex.edge_segments[e]) {
    for (const WireId w : complex.segment_wires[s]) {
      const Soup::Wire& wire = complex.wires[w];
      if (among(leaves, wire.leaf)) out.push_back({wire.leaf, 1, wire.leaf_edge});
    }
  }
}

/// The labels of regions around a cell. Many faces of it look into few regions: those met last are not read again.
class LabelsOnce {
 public:
  LabelsOnce(const Complex& complex, std::span<const LeafId> leaves, std::vector<LeafCell>& out)
      : complex_(complex), leaves_(leaves), out_(out) {
    last_.fill(RegionId::none());
  }
  /// Nothing for none().
  void add(RegionId r) {
    if (!r.valid() || std::find(last_.begin(), last_.end(), r) != last_.end()) return;
    last_[next_++ % last_.size()] = r;
    append_leaf_cells(complex_, r, leaves_, out_);
  }

 private:
  const Complex& complex_;
  std::span<const LeafId> leaves_;
  std::vector<LeafCell>& out_;
  std::array<RegionId, 4> last_;
  std::size_t next_ = 0;
};

void add_face(const Complex& complex, FaceId f, std::span<const LeafId> leaves, LabelsOnce& labels,
              std::vector<LeafCell>& out) {
  add_cover(complex, f, leaves, out);
  for (const RegionId r : complex.face_regions[f]) labels.add(r);
}

/// `from`: only those that walk the edge from there.
void add_faces_around(const Complex& complex, EdgeId e, std::span<const LeafId> leaves, LabelsOnce& labels,
                      std::vector<LeafCell>& out, VertexId from = {}) {
  labels.add(complex.edge_region[e]);
  for (const FaceUse& use : complex.edge_uses[e]) {
    if (!from.valid() || complex.origin(use.half_edge) == from) add_face(complex, use.face, leaves, labels, out);
  }
}

/// Those that the complex knows of the cell by itself.
void add_further(std::span<const LeafCell> cells, std::span<const LeafId> leaves, std::vector<LeafCell>& out) {
  for (const LeafCell& cell : cells) {
    if (among(leaves, cell.leaf)) out.push_back(cell);
  }
}

bool same(const SaidPointer& a, const SaidPointer& b) {
  return a == b || (a != nullptr && b != nullptr && *a == *b);
}

// Who dominates matters only where something is said of both.
std::tuple<LeafSetId, LeafSetId, Dominance> union_key(LeafSetId a, LeafSetId b, const SaidPointer& said_a,
                                                      const SaidPointer& said_b, Dominance dominance) {
  if (said_a != nullptr && said_b != nullptr) return {a, b, dominance};
  return {std::min(a, b), std::max(a, b), Dominance::equal};
}

}  // namespace

// Rules for the attributes of a cell that two operands have.

SaidPointer merged(const SaidPointer& left, const SaidPointer& right, Dominance dominance) {
  if (right == nullptr || left == right) return left;
  if (left == nullptr) return right;
  if (left->dimension != right->dimension) return left->dimension < right->dimension ? left : right;
  if (dominance != Dominance::equal) return dominance == Dominance::left ? left : right;
  Said filled = *left;
  fill_in(filled.attributes, right->attributes);
  return filled == *left ? left : std::make_shared<const Said>(std::move(filled));
}

std::vector<Yielded> at_odds(const SaidPointer& left, const SaidPointer& right, int dimension) {
  std::vector<Yielded> yielded;
  if (left == nullptr || right == nullptr || left == right) return yielded;
  if (left->dimension != dimension || right->dimension != dimension) return yielded;
  Attributes filled = left->attributes;
  fill_in(filled, right->attributes, yielded);
  return yielded;
}

LeafSets::LeafSets() { intern(std::span<const LeafId>()); }

LeafSetId LeafSets::intern(std::span<const LeafId> leaves, const SaidPointer& said) {
  std::vector<LeafId> key(leaves.begin(), leaves.end());
  std::vector<LeafSetId>& with_these = known_[key];
  for (const LeafSetId id : with_these) {
    if (same(said_[id.index()], said)) return id;
  }
  const LeafSetId id = sets_.push_back(key);
  said_.push_back(said);
  says_anything_ = says_anything_ || (said != nullptr && !said->attributes.empty());
  with_these.push_back(id);
  return id;
}

LeafSetId LeafSets::unite(LeafSetId a, LeafSetId b, Dominance dominance) {
  if (a == b || b == LeafSetId(0)) return a;
  if (a == LeafSetId(0)) return b;
  const auto [it, fresh] = united_.try_emplace(union_key(a, b, said(a), said(b), dominance));
  if (fresh) it->second = intern(in_either(sets_[a], sets_[b]), merged(said(a), said(b), dominance));
  return it->second;
}

LeafUnions::LeafUnions() { intern(std::span<const LeafId>()); }

LeafSetId LeafUnions::intern(std::span<const LeafId> leaves, const SaidPointer& said) {
  const LeafSetId set = sets_.intern(leaves, said);
  if (set.index() >= of_set_.size()) of_set_.resize(sets_.size(), LeafSetId::none());
  LeafSetId& id = of_set_[set.index()];
  if (!id.valid()) {
    id = LeafSetId(made_of_.size());
    made_of_.emplace_back(LeafSetId::none(), set);
    said_.push_back(sets_.said(set));
  }
  return id;
}

LeafSetId LeafUnions::unite(LeafSetId a, LeafSetId b, Dominance dominance) {
  if (a == b || b == LeafSetId(0)) return a;
  if (a == LeafSetId(0)) return b;
  const auto& [before, last] = made_of_[a.index()];
  if (before.valid() && last == b && same(merged(said(a), said(b), dominance), said(a))) return a;
  const auto [it, fresh] = united_.try_emplace(union_key(a, b, said(a), said(b), dominance));
  if (fresh) {
    it->second = LeafSetId(made_of_.size());
    said_.push_back(merged(said(a), said(b), dominance));
    made_of_.emplace_back(a, b);
  }
  return it->second;
}

std::vector<LeafId> LeafUnions::operator[](LeafSetId set) const {
  std::vector<LeafId> leaves;
  std::vector<LeafSetId> open{set};
  while (!open.empty()) {
    const auto [a, b] = made_of_[open.back().index()];
    open.pop_back();
    if (a.valid()) {
      open.push_back(a), open.push_back(b);
    } else {
      leaves.insert(leaves.end(), sets_[b].begin(), sets_[b].end());
    }
  }
  sort_unique(leaves);
  return leaves;
}

void append_leaf_cells(const Complex& complex, VertexId v, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out) {
  LabelsOnce labels(complex, leaves, out);
  labels.add(complex.vertex_region[v]);
  for (const EdgeId e : complex.vertex_edges[v]) {
    add_faces_around(complex, e, leaves, labels, out, v);
    add_wires(complex, e, leaves, out);
  }
  for (const FaceId f : complex.vertex_faces[v]) add_face(complex, f, leaves, labels, out);
  for (const LeafId leaf : complex.isolated_leaves[v]) {
    if (among(leaves, leaf)) out.push_back({leaf, 0, 0});
  }
  add_further(complex.vertex_leaf_cells[v], leaves, out);
}

void append_leaf_cells(const Complex& complex, EdgeId e, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out) {
  LabelsOnce labels(complex, leaves, out);
  add_faces_around(complex, e, leaves, labels, out);
  add_wires(complex, e, leaves, out);
  add_further(complex.edge_leaf_cells[e], leaves, out);
}

void append_leaf_cells(const Complex& complex, FaceId f, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out) {
  LabelsOnce labels(complex, leaves, out);
  add_face(complex, f, leaves, labels, out);
  add_further(complex.face_leaf_cells[f], leaves, out);
}

void append_leaf_cells(const Complex& complex, RegionId r, std::span<const LeafId> leaves,
                       std::vector<LeafCell>& out) {
  for (const Label& label : complex.labels(r)) {
    if (among(leaves, label.leaf)) out.push_back({label.leaf, 3, label.region});
  }
}

template <class IdT>
std::vector<LeafCell> leaf_cells(const Complex& complex, IdT cell, std::span<const LeafId> leaves) {
  std::vector<LeafCell> out;
  append_leaf_cells(complex, cell, leaves, out);
  sort_unique(out);
  return out;
}

template std::vector<LeafCell> leaf_cells(const Complex&, VertexId, std::span<const LeafId>);
template std::vector<LeafCell> leaf_cells(const Complex&, EdgeId, std::span<const LeafId>);
template std::vector<LeafCell> leaf_cells(const Complex&, FaceId, std::span<const LeafId>);
template std::vector<LeafCell> leaf_cells(const Complex&, RegionId, std::span<const LeafId>);

}  // namespace cnrg
