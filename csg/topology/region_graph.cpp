// Walls are counted over simplified faces; Boost.Graph finds connected parts and writes the graph.
#include "csg/topology/region_graph.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graphviz.hpp>
#include <map>
#include <sstream>

#include "csg/text/graphviz.h"

namespace cnrg {
namespace {

struct Wall {
  std::size_t faces = 0;
};
using Adjacency = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Wall>;

Adjacency adjacency(const RegionGraph& graph, bool skip_outside) {
  Adjacency out(graph.nodes.size());
  for (const RegionGraph::Edge& e : graph.edges) {
    if (skip_outside && graph.nodes[e.nodes[0]].component == 0) continue;
    add_edge(e.nodes[0], e.nodes[1], Wall{e.faces}, out);
  }
  return out;
}

}  // namespace

std::string component_name(std::span<const RegionAttributes> components, Component component) {
  if (component == 0) return "outside";
  const std::string number = std::to_string(component);
  const bool named = component <= components.size() && !components[component - 1].name.empty();
  return named ? number + " " + components[component - 1].name.text() : "component " + number;
}

RegionGraph region_graph(const SimplifiedComplex& simplified, std::span<const RegionAttributes> components) {
  const auto component_of = [&](std::uint32_t region) {
    return region == SimplifiedComplex::kNowhere ? Component(0) : simplified.regions[region].component;
  };
  std::map<Component, std::uint32_t> number;
  for (const auto& region : simplified.regions) {
    if (region.component != 0) number.emplace(region.component, 0);
  }
  std::map<std::array<Component, 2>, std::size_t> walls;
  for (const auto& face : simplified.faces) {
    std::array<Component, 2> sides{component_of(face.regions[0]), component_of(face.regions[1])};
    if (sides[0] == sides[1]) continue;
    std::sort(sides.begin(), sides.end());
    ++walls[sides];
    number.emplace(sides[0], 0);
  }
  RegionGraph out;
  for (auto& [component, place] : number) {
    place = static_cast<std::uint32_t>(out.nodes.size());
    const bool known = component != 0 && component <= components.size();
    out.nodes.push_back({component, component_name(components, component),
                         known ? components[component - 1].material.name() : std::string()});
  }
  for (const auto& [sides, faces] : walls) out.edges.push_back({{number[sides[0]], number[sides[1]]}, faces});
  return out;
}

std::vector<std::uint32_t> RegionGraph::parts(bool skip_outside) const {
  std::vector<std::uint32_t> out(nodes.size());
  if (!nodes.empty()) boost::connected_components(adjacency(*this, skip_outside), out.data());
  return out;
}

std::string RegionGraph::dot() const {
  const Adjacency graph = adjacency(*this, false);
  const auto node = [&](std::ostream& stream, std::size_t i) {
    const Node& n = nodes[i];
    stream << "[label=\"" << graphviz_text(n.name) << (n.material.empty() ? "" : "\\n" + graphviz_text(n.material))
           << "\"" << (n.component == 0 ? ", style=dashed]" : "]");
  };
  const auto edge = [&](std::ostream& stream, const auto& e) {
    stream << "[label=\"" << graph[e].faces << (graph[e].faces == 1 ? " face" : " faces") << "\"]";
  };
  const auto whole = [](std::ostream& stream) {
    stream << "graph [layout=neato, overlap=false]\nnode [shape=box]\n";
  };
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // without memory it would end in the middle
  boost::write_graphviz(text, graph, node, edge, whole);
  return text.str();
}

}  // namespace cnrg
