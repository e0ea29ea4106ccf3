#include "bench/cases/value_model.h"

#include <algorithm>

#include "bench/cases/face_loops.h"

namespace cnrg::bench {
namespace {

/// The simplified cells as a model. All faces are planar and all edges straight, so points that are no vertices of
/// the simplified complex are not needed.
class ModelMaker {
 public:
  ModelMaker(const Complex& complex, const SimplifiedComplex& simplified)
      : complex_(complex),
        simplified_(simplified),
        number_(complex.points.size(), kNone),
        bounds_(complex.edge_count(), 0) {}

  Model run() {
    for (const SimplifiedComplex::Face& face : simplified_.faces) add_face(face);
    for (const SimplifiedComplex::Edge& edge : simplified_.edges) add_wire(edge);
    for (const SimplifiedComplex::Vertex& vertex : simplified_.vertices) add_isolated(vertex);
    return std::move(model_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  bool active(std::uint32_t region) const { return simplified_.regions[region].component != 0; }
  bool is_vertex(VertexId v) const { return simplified_.vertex_place[v.index()].dimension == 0; }

  std::uint32_t number(VertexId v) {
    std::uint32_t& n = number_[v.index()];
    if (n == kNone) {
      n = static_cast<std::uint32_t>(model_.points.size());
      model_.points.push_back(complex_.points.rational(v));
    }
    return n;
  }

  void add_face(const SimplifiedComplex::Face& face) {
    for (const auto& loop : face.loops)
      for (const HalfEdge h : loop) bounds_[h.edge().index()] = 1;
    for (const VertexId v : face.isolated) number(v);  // on a face, so not by itself
    if (face.component == 0) return;
    const bool front = active(face.regions[0]), back = active(face.regions[1]);
    std::vector<PointLoop> walks;
    for (const auto& loop : face.loops) {
      PointLoop& walk = walks.emplace_back();
      for (const HalfEdge h : loop)
        if (is_vertex(complex_.origin(h))) walk.push_back(number(complex_.origin(h)));
      if (front) std::reverse(walk.begin(), walk.end());
    }
    model_.faces.push_back({simple_loops(model_.points, walks), front != back});
  }

  void add_wire(const SimplifiedComplex::Edge& edge) {
    const HalfEdge first = edge.chain.front(), last = edge.chain.back();
    const VertexId from = complex_.origin(first), to = complex_.target(last);
    if (bounds_[first.edge().index()] == 0) model_.wires.push_back({number(from), number(to)});
  }

  /// Whatever is a corner of a face or an end of a wire has a number by now.
  void add_isolated(const SimplifiedComplex::Vertex& vertex) {
    if (number_[vertex.cell.index()] == kNone) model_.isolated.push_back(number(vertex.cell));
  }

  const Complex& complex_;
  const SimplifiedComplex& simplified_;
  std::vector<std::uint32_t> number_;  // of each point of the complex in the model
  std::vector<char> bounds_;           // edges of the complex on the boundary of a face
  Model model_;
};

}  // namespace

Selection as_one(const CellSet& set) {
  Selection selection;
  const auto fill = [](const auto& cells, auto& out) {
    for (const auto cell : cells) out.emplace_back(cell, 1);
  };
  fill(set.vertices, selection.vertices);
  fill(set.edges, selection.edges);
  fill(set.faces, selection.faces);
  fill(set.regions, selection.regions);
  return selection;
}

SimplifiedComplex point_set(const Complex& complex, const NodeValue& value) {
  return simplify(complex, as_one(support(selection_of(complex, value))), {}, SimplifyMode::points);
}

Model model_of(const Complex& complex, const SimplifiedComplex& simplified) {
  return ModelMaker(complex, simplified).run();
}

}  // namespace cnrg::bench
