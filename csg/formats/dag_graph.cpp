// Instances of nodes are the vertices of a Boost graph, operands its edges; Boost.Graph writes it.
#include "csg/formats/dag_graph.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graphviz.hpp>
#include <sstream>

#include "csg/text/graphviz.h"
#include "csg/text/number.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

struct Use {
  std::size_t number = 0;  // of the operand, from 1; 0: the only one
};
using Uses = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, boost::no_property, Use>;

std::string label_of(const NodeRow& row) {
  const auto& [v, e, f, r] = row.cells;
  std::string text = graphviz_text(row.name) + "\\n" + row.operator_name + "\\n" + std::to_string(v) + " v  " +
                     std::to_string(e) + " e  " + std::to_string(f) + " f  " + std::to_string(r) + " r";
  if (!row.is_group)
    text += "\\n" + std::to_string(row.components) + (row.components == 1 ? " component" : " components");
  if (row.regions == 0) return text;
  const std::optional<Rational>& volume = row.volume();
  text += "\\nvolume " + (volume ? to_decimal(*volume) : "unbounded");
  const std::string bound = volume ? bound_text(row.volume_bound()) : "";
  return bound.empty() ? text : text + " within " + bound;
}

}  // namespace

std::string dag_dot(const Evaluation& evaluation) {
  require(evaluation.rows.size() == evaluation.instances.size(), "dag_dot: an evaluation without rows");
  Uses graph(evaluation.instances.size());
  for (const InstanceId user : IdRange<InstanceId>(evaluation.instances.size())) {
    const std::vector<InstanceId>& operands = evaluation.instances[user].operands;
    for (std::size_t k = 0; k < operands.size(); ++k) {
      add_edge(operands[k].index(), user.index(), Use{operands.size() == 1 ? 0 : k + 1}, graph);
    }
  }
  const auto node = [&](std::ostream& stream, std::size_t i) {
    const NodeRow& row = evaluation.rows[i];
    stream << "[label=\"" << label_of(row) << "\""
           << (evaluation.instances[InstanceId(i)].operands.empty() ? ", style=rounded]" : "]");
  };
  const auto edge = [&](std::ostream& stream, const auto& e) {
    if (graph[e].number != 0) stream << "[label=\"" << graph[e].number << "\"]";
  };
  const auto whole = [](std::ostream& stream) { stream << "node [shape=box]\n"; };
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // without memory it would end in the middle
  boost::write_graphviz(text, graph, node, edge, whole);
  return text.str();
}

}  // namespace cnrg
