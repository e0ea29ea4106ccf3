// Each operand decides by itself which of its entities vanish when it is simplified (kernel/selection/merging.h).
// One Merging of the union of both would not do: a wall of one operand may lie in a wall of the other, and where it
// ends there the union has nothing to tell, but the operands have.
//
// Faces are entities, and remain. An edge vanishes if it does in each operand that has it, between the same two
// faces. Around a vertex that vanishes in each operand that has it are
//   two edges   both of each operand that has the vertex: it lies in the edge that they are
//   none        one face of all these operands: it lies inside of that; otherwise two faces touch here
// and whatever else is around it, edges end or cross there.
#include "csg/operators/pair_refinement.h"

#include <algorithm>
#include <iterator>

namespace cnrg {
namespace {

template <class IdT>
std::vector<IdT> united(const std::vector<IdT>& a, const std::vector<IdT>& b) {
  std::vector<IdT> out;
  out.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

template <class IdT>
void put(Merging& merging, const std::vector<IdT>& cells, const std::vector<IdT>& features) {
  auto feature = features.begin();
  for (const IdT cell : cells) {
    while (feature != features.end() && *feature < cell) ++feature;
    merging.put(cell, 1, feature != features.end() && *feature == cell);
  }
}

}  // namespace

PairRefinement::Operand::Operand(const Complex& complex, const Group& group)
    : sources(complex, group), merging(complex, {}, {}, SimplifyMode::features, &sources) {
  for (const FaceId f : group.faces) merging.put(f, 1);
  put(merging, group.edges, group.features.edges);
  put(merging, group.vertices, group.features.vertices);
}

PairRefinement::PairRefinement(const Complex& complex, const Group& a, const Group& b)
    : complex_(complex),
      a_(complex, a),
      b_(complex, b),
      faces_(complex.face_count()),
      chains_(complex.edge_count()),
      face_of_edge_(complex.edge_count()),
      edge_of_vertex_(complex.points.size()),
      face_of_vertex_(complex.points.size()) {
  for (const EdgeId e : united(a.edges, b.edges)) decide(e);
  faces_.settle();
  for (const VertexId v : united(a.vertices, b.vertices)) decide(v);
}

void PairRefinement::decide(EdgeId e) {
  const bool of_both = a_.has(e) && b_.has(e);
  const Merging& one = (a_.has(e) ? a_ : b_).merging;
  if (one.fate(e) != Fate::in_face || (of_both && b_.merging.fate(e) != Fate::in_face)) return;
  const auto [f, g] = one.merged_over(e);
  if (of_both && b_.merging.merged_over(e) != std::pair(f, g)) return;
  // A face that would have one side ends here.
  if (faces_.unite(f.face, g.face, f.half_edge == g.half_edge)) face_of_edge_[e] = f.face.value() + 1;
}

void PairRefinement::decide(VertexId v) {
  for (const Operand* operand : {&a_, &b_}) {
    if (operand->has(v) && operand->merging.fate(v) == Fate::kept) return;
  }
  EdgeId pair[2];
  std::size_t n = 0;
  for (const EdgeId e : complex_.vertex_edges[v]) {
    if (!(a_.has(e) || b_.has(e)) || !is_kept(e)) continue;
    if (n == 2) return;
    pair[n++] = e;
  }
  if (n == 2 && is_with(v, pair[0]) && is_with(v, pair[1])) {
    chains_.unite(pair[0], pair[1]);
    edge_of_vertex_[v] = pair[0].value() + 1;
  }
  if (n == 0) {
    if (const FaceId f = common_face(v); f.valid()) face_of_vertex_[v] = f.value() + 1;
  }
}

// Of all operands that have the vertex; none() if there is none.
FaceId PairRefinement::common_face(VertexId v) const {
  for (const FaceId f : complex_.vertex_faces[v]) {
    if (is_with(v, f)) return f;
  }
  for (const EdgeId e : complex_.vertex_edges[v]) {
    for (const FaceUse& use : complex_.edge_uses[e]) {
      if (is_with(v, use.face)) return use.face;
    }
  }
  return FaceId::none();
}

Location PairRefinement::place(FaceId f) { return {2, {}, {}, faces_.find(f).first, {}}; }
Location PairRefinement::place(EdgeId e) {
  if (face_of_edge_[e] != 0) return place(FaceId(face_of_edge_[e] - 1));
  return {1, {}, chains_.find(e), {}, {}};
}
Location PairRefinement::place(VertexId v) {
  if (edge_of_vertex_[v] != 0) return place(EdgeId(edge_of_vertex_[v] - 1));
  if (face_of_vertex_[v] != 0) return place(FaceId(face_of_vertex_[v] - 1));
  return {0, v, {}, {}, {}};
}

}  // namespace cnrg
