// Which regions touch: the adjacency of the components that hold 3-cells, as a graph.
//
// Nodes are such components, and the outside (all that is inactive) where it has a wall with one of them. An edge
// joins two nodes with a wall between: a simplified face with one on either side. Faces with the same node on both
// sides (sheets within, walls inside of one component) make no edge.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "csg/operators/group.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

struct RegionGraph {
  struct Node {
    Component component = 0;     ///< 0: outside
    std::string name, material;  ///< as `component_name` has it
  };
  struct Edge {
    std::array<std::uint32_t, 2> nodes{};  ///< indices, ascending
    std::size_t faces = 0;                 ///< simplified faces of the wall
    friend bool operator==(const Edge&, const Edge&) = default;
  };
  std::vector<Node> nodes;  ///< by component
  std::vector<Edge> edges;  ///< by nodes

  /// The part of the graph, from 0, that each node is connected with; `skip_outside`: as if the outside were not
  /// there (it is then a part of its own).
  std::vector<std::uint32_t> parts(bool skip_outside) const;
  /// Graphviz, with names, materials and numbers of faces; the same bytes for the same graph.
  std::string dot() const;
};

/// What is known of component i is `components[i - 1]`; there may be fewer.
RegionGraph region_graph(const SimplifiedComplex& simplified, std::span<const RegionAttributes> components);

/// How a component is called: `3 granite`, since names may repeat, or `component 3`; `outside` for 0.
std::string component_name(std::span<const RegionAttributes> components, Component component);

}  // namespace cnrg
