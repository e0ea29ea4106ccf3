// The algorithms are Boost.Graph's depth-first and breadth-first searches, which keep their own stack.
#include "csg/tree/dag.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/depth_first_search.hpp>
#include <boost/graph/topological_sort.hpp>
#include <iterator>

namespace cnrg {
namespace {

struct UseOfNode {
  Position at;
};
using Adjacency = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, UseOfNode>;
using Vertex = boost::graph_traits<Adjacency>::vertex_descriptor;
using Edge = boost::graph_traits<Adjacency>::edge_descriptor;

struct CycleFound {
  Edge edge;
};

/// Remembers the way down and stops at the first edge that leads back to it.
class CycleVisitor : public boost::default_dfs_visitor {
 public:
  explicit CycleVisitor(std::vector<Vertex>& parent) : parent_(&parent) {}
  void tree_edge(Edge e, const Adjacency& g) { (*parent_)[target(e, g)] = source(e, g); }
  [[noreturn]] void back_edge(Edge e, const Adjacency&) { throw CycleFound{e}; }

 private:
  std::vector<Vertex>* parent_;
};

}  // namespace

struct Dag::Graph {
  Adjacency adjacency;
};

Dag::Dag() : graph_(std::make_unique<Graph>()) {}
Dag::~Dag() = default;
Dag::Dag(Dag&&) noexcept = default;
Dag& Dag::operator=(Dag&&) noexcept = default;

NodeId Dag::add_node() { return NodeId(add_vertex(graph_->adjacency)); }

void Dag::add_operand(NodeId user, NodeId operand, Position mention) {
  add_edge(user.index(), operand.index(), UseOfNode{mention}, graph_->adjacency);
}

std::size_t Dag::size() const { return num_vertices(graph_->adjacency); }

std::vector<NodeId> Dag::operands(NodeId node) const {
  std::vector<NodeId> result;
  const auto [first, last] = adjacent_vertices(node.index(), graph_->adjacency);
  for (auto it = first; it != last; ++it) result.emplace_back(*it);
  return result;
}

Dag::Cycle Dag::find_cycle() const {
  const Adjacency& g = graph_->adjacency;
  std::vector<Vertex> parent(size());
  try {
    boost::depth_first_search(g, boost::visitor(CycleVisitor(parent)));
  } catch (const CycleFound& found) {
    Cycle cycle;
    cycle.mention = g[found.edge].at;
    const Vertex first = target(found.edge, g);
    Vertex v = source(found.edge, g);
    for (; v != first; v = parent[v]) cycle.nodes.emplace_back(v);
    cycle.nodes.emplace_back(first);
    std::reverse(cycle.nodes.begin(), cycle.nodes.end());
    return cycle;
  }
  return {};
}

std::vector<NodeId> Dag::order() const {
  std::vector<Vertex> sorted;
  sorted.reserve(size());
  boost::topological_sort(graph_->adjacency, std::back_inserter(sorted));
  std::vector<NodeId> result;
  result.reserve(sorted.size());
  for (const Vertex v : sorted) result.emplace_back(v);
  return result;
}

std::vector<char> Dag::reachable(const std::vector<NodeId>& roots) const {
  const Adjacency& g = graph_->adjacency;
  std::vector<boost::default_color_type> color(size(), boost::white_color);
  boost::queue<Vertex> waiting;
  for (const NodeId root : roots) {
    if (color[root.index()] != boost::white_color) continue;
    boost::breadth_first_visit(g, static_cast<Vertex>(root.index()), waiting, boost::default_bfs_visitor(),
                               color.data());
  }
  std::vector<char> result(size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = color[i] != boost::white_color;
  return result;
}

}  // namespace cnrg
