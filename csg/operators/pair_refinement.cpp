// Each operand decides by itself which of its entities vanish when it is simplified (kernel/selection/merging.h).
// One Merging of the union of both would not do: a wall of one operand may lie in a wall of the other, and what
// vanishes in one of them may be where the other one ends.
//
// Faces are entities, and remain. An edge vanishes if it does in each operand that has it, between the same two
// faces. Around a vertex that vanishes in each operand that has it are
//   two edges   both of each operand that has the vertex: it lies in the edge that they are
//   none        one face of all these operands: it lies inside of that; otherwise two faces touch here
// and whatever else is around it, edges end or cross there.
#include "csg/operators/pair_refinement.h"

namespace cnrg {
namespace {

// Flags of a cell: which operands it is an entity of, and of an edge in which it vanishes.
constexpr std::uint8_t kA = 1, kB = 2, kBoth = kA | kB;
constexpr int kVanishes = 2;           // an operand's flag, this far to the left
constexpr std::uint8_t kStays = 0x80;  // a vertex of the simplified operand

template <class IdT>
void put(Merging& merging, const std::vector<IdT>& cells, const std::vector<IdT>& features) {
  auto feature = features.begin();
  for (const IdT cell : cells) {
    while (feature != features.end() && *feature < cell) ++feature;
    merging.put(cell, 1, feature != features.end() && *feature == cell);
  }
}

}  // namespace

PairRefinement::PairRefinement(const Complex& complex)
    : complex_(complex),
      merging_(complex, {}, {}, SimplifyMode::features, &sources_),
      of_(complex),
      faces_(complex.face_count()),
      chains_(complex.edge_count()),
      face_of_edge_(complex.edge_count()),
      edge_of_vertex_(complex.points.size()),
      face_of_vertex_(complex.points.size()) {}

void PairRefinement::refine(const Group& a, const Group& b) {
  clear();
  simplify(a, kA), simplify(b, kB);
  cells_ = unite({a.vertices, a.edges, a.faces, {}}, {b.vertices, b.edges, b.faces, {}});
  for (const EdgeId e : cells_.edges) decide(e);
  faces_.settle();
  for (const VertexId v : cells_.vertices) decide(v);
}

void PairRefinement::clear() {
  for (const FaceId f : cells_.faces) of_.faces[f] = 0;
  for (const EdgeId e : cells_.edges) {
    of_.edges[e] = 0, face_of_edge_[e] = 0;
    chains_.reset(e);
  }
  for (const VertexId v : cells_.vertices) of_.vertices[v] = 0, edge_of_vertex_[v] = 0, face_of_vertex_[v] = 0;
  faces_.reset();
}

// An operand by itself.
void PairRefinement::simplify(const Group& operand, std::uint8_t flag) {
  sources_.of.emplace(complex_, operand);
  for (const FaceId f : operand.faces) {
    merging_.put(f, 1);
    of_.faces[f] |= flag;
  }
  put(merging_, operand.edges, operand.features.edges);
  put(merging_, operand.vertices, operand.features.vertices);
  for (const EdgeId e : operand.edges) {
    const bool vanishes = merging_.fate(e) == Fate::in_face;
    of_.edges[e] |= static_cast<std::uint8_t>(flag | (vanishes ? flag << kVanishes : 0));
  }
  for (const VertexId v : operand.vertices) {
    of_.vertices[v] |= static_cast<std::uint8_t>(flag | (merging_.fate(v) == Fate::kept ? kStays : 0));
  }
  for (const FaceId f : operand.faces) merging_.put(f, 0);
  for (const EdgeId e : operand.edges) merging_.put(e, 0, false);
  for (const VertexId v : operand.vertices) merging_.put(v, 0, false);
}

void PairRefinement::decide(EdgeId e) {
  const std::uint8_t of = of_.edges[e] & kBoth;
  if ((of_.edges[e] >> kVanishes & kBoth) != of) return;
  FaceUse pair[2];
  std::size_t n = 0;
  for (const FaceUse& use : complex_.edge_uses[e]) {
    const std::uint8_t there = of_.faces[use.face] & of;
    if (there == 0) continue;
    if (there != of) return;
    pair[n++] = use;
  }
  const auto& [f, g] = pair;
  // A face that would have one side ends here.
  if (faces_.unite(f.face, g.face, f.half_edge == g.half_edge)) face_of_edge_[e] = f.face.value() + 1;
}

void PairRefinement::decide(VertexId v) {
  const std::uint8_t of = of_.vertices[v] & kBoth;
  if (of_.vertices[v] & kStays) return;
  EdgeId pair[2];
  std::size_t n = 0;
  for (const EdgeId e : complex_.vertex_edges[v]) {
    if (of_.edges[e] == 0 || !is_kept(e)) continue;
    if (n == 2) return;
    pair[n++] = e;
  }
  if (n == 2 && (of_.edges[pair[0]] & of_.edges[pair[1]] & of) == of) {
    chains_.unite(pair[0], pair[1]);
    edge_of_vertex_[v] = pair[0].value() + 1;
  }
  if (n == 0) {
    if (const FaceId f = common_face(v); f.valid()) face_of_vertex_[v] = f.value() + 1;
  }
}

// Of all operands that have the vertex; none() if there is none.
FaceId PairRefinement::common_face(VertexId v) const {
  const std::uint8_t of = of_.vertices[v] & kBoth;
  for (const FaceId f : complex_.vertex_faces[v]) {
    if ((of_.faces[f] & of) == of) return f;
  }
  for (const EdgeId e : complex_.vertex_edges[v]) {
    for (const FaceUse& use : complex_.edge_uses[e]) {
      if ((of_.faces[use.face] & of) == of) return use.face;
    }
  }
  return FaceId::none();
}

Location PairRefinement::place(EdgeId e) {
  if (!is_kept(e)) return place(FaceId(face_of_edge_[e] - 1));
  return {1, {}, chains_.find(e), {}, {}};
}
Location PairRefinement::place(VertexId v) {
  if (edge_of_vertex_[v] != 0) return place(EdgeId(edge_of_vertex_[v] - 1));
  if (face_of_vertex_[v] != 0) return place(FaceId(face_of_vertex_[v] - 1));
  return {0, v, {}, {}, {}};
}

}  // namespace cnrg
