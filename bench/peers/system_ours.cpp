// The library: one refinement of all operands, groups on it, group Booleans, the point set simplified.
#include <tbb/global_control.h>

#include "bench/cases/soup_of.h"
#include "bench/peers/built_in.h"
#include "bench/peers/face_loops.h"
#include "csg/evaluate/operate.h"
#include "csg/operators/group.h"
#include "kernel/base/error.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {
namespace {

Operator operator_of(Operation operation) {
  switch (operation) {
    case Operation::unite: return Operator::unite;
    case Operation::intersect: return Operator::intersect;
    default: return Operator::subtract;
  }
}

/// One n-ary node, as a tree has it.
NodeValue node_value(const Complex& complex, Operation operation, std::vector<NodeValue> values) {
  Node node;
  node.op = operator_of(operation);
  node.name = "node";
  node.operator_name = to_string(operation);
  node.dominant = DominantOperand::equal;
  std::vector<Operand> operands;
  for (NodeValue& value : values) operands.push_back({&value, "operand", &value, {}});
  return std::move(operate(complex, node, {}, operands, false, {}).value);
}

/// An operand has one leaf, or one for its solid and one for what hangs loose.
NodeValue operand_value(const Complex& complex, std::vector<Group>& groups, const std::vector<LeafId>& leaves) {
  std::vector<NodeValue> values;
  for (const LeafId leaf : leaves) values.emplace_back(complex, std::move(groups[leaf.index()]));
  if (values.size() == 1) return std::move(values[0]);
  return node_value(complex, Operation::unite, std::move(values));
}

/// Runs of one operation are one node each: (m0 op m1 op m2 ...).
NodeValue folded_value(const Complex& complex, const Problem& problem, std::vector<NodeValue> operands) {
  NodeValue value = std::move(operands[0]);
  for (std::size_t i = 0; i < problem.steps.size();) {
    std::vector<NodeValue> run;
    run.push_back(std::move(value));
    std::size_t end = i;
    for (; end < problem.steps.size() && problem.steps[end] == problem.steps[i]; ++end)
      run.push_back(std::move(operands[end + 1]));
    value = node_value(complex, problem.steps[i], std::move(run));
    i = end;
  }
  return value;
}

/// The point set alone, so that walls between regions and what hangs inside of them fall out.
SimplifiedComplex point_set(const Complex& complex, const NodeValue& value) {
  Selection selection = selection_of(complex, value);
  const auto join = [](auto& cells) {
    for (auto& [cell, component] : cells) component = 1;
  };
  join(selection.vertices);
  join(selection.edges);
  join(selection.faces);
  join(selection.regions);
  return simplify(complex, selection, {}, SimplifyMode::points);
}

/// The simplified cells as a model. All faces are planar and all edges straight, so points that are no vertices of
/// the simplified complex are not needed.
class OurModelMaker {
 public:
  OurModelMaker(const Complex& complex, const SimplifiedComplex& simplified)
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

std::shared_ptr<const Complex> complex_of(const Soup& soup, RefineReport& report) {
  try {
    return build_complex(soup, {.threads = 1}, &report);
  } catch (const InputError& error) {
    throw Refusal("input", error.what());
  }
}

Answer answer_of_ours(const Problem& problem) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  Measurement measurement;
  Soup soup;
  std::vector<std::vector<LeafId>> leaves;
  for (const Model& operand : problem.operands) leaves.push_back(add_model(soup, operand));
  measurement.lap("conversion");
  RefineReport report;
  const auto built_complex = complex_of(soup, report);
  const Complex& complex = *built_complex;
  measurement.lap("complex");
  std::vector<Group> groups = leaf_groups(complex);
  std::vector<NodeValue> operands;
  for (const std::vector<LeafId>& of_operand : leaves)
    operands.push_back(operand_value(complex, groups, of_operand));
  measurement.lap("leaves");
  const NodeValue value = folded_value(complex, problem, std::move(operands));
  measurement.lap("Boolean");
  const SimplifiedComplex simplified = point_set(complex, value);
  measurement.lap("simplify");

  Answer answer;
  answer.measures = measurement.stop();
  answer.model = OurModelMaker(complex, simplified).run();
  answer.exact_share = report.stages.exact_share();
  answer.note = "constructed " + std::to_string(report.constructed);
  return answer;
}

}  // namespace

System our_system() {
  return {.name = "ours",
          .title = "cnrg",
          .guarantee = "solids by winding number, surfaces, wires and points; exact; one thread",
          .version = [] { return std::string(CNRG_VERSION); },
          .rounding = 0,
          .regularized = false,
          .absent = "",
          .evaluate = answer_of_ours};
}

}  // namespace cnrg::bench
