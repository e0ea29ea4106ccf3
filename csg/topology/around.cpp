// Faces that simplification merged away are passed over: the regions on both sides of them are one.
#include "csg/topology/around.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "csg/topology/region_graph.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/predicates.h"
#include "kernel/selection/canonical.h"

namespace cnrg {
namespace {

std::string numbered(std::size_t count, const char* one, const char* many) {
  return grouped(count) + " " + (count == 1 ? one : many);
}

// The lines of a list, and how many were left out.
template <class Items, class Line>
std::string lines(const char* title, const Items& items, std::size_t most, Line line) {
  if (items.empty()) return "";
  std::string out = std::string(title) + "\n";
  for (std::size_t i = 0; i < std::min<std::size_t>(items.size(), most); ++i)
    append_line(out, "  " + line(items[i]));
  if (items.size() > most) out += "  and " + grouped(items.size() - most) + " more\n";
  return out;
}

std::string region_name(const SimplifiedComplex& simplified, std::span<const RegionAttributes> components,
                        RegionId r) {
  return component_name(components, component_of(simplified, simplified.region_place[r.index()]));
}

/// A half-edge of an edge along the way that its points tell: from the lesser end; of a closed edge from its least
/// vertex to the lesser one of the corners next to it.
HalfEdge way_of(const Complex& complex, const SimplifiedComplex::Edge& edge) {
  const HalfEdge first = edge.chain.front();
  const auto less = [&](VertexId a, VertexId b) { return compare_lex(complex.points, a, b) < 0; };
  if (!edge.closed) return less(complex.origin(first), complex.target(edge.chain.back())) ? first : first.twin();
  const std::vector<VertexId> v = chain_vertices(complex, edge);
  const std::size_t n = v.size(), least = std::size_t(std::min_element(v.begin(), v.end(), less) - v.begin());
  const auto corner = [&](std::size_t step) {  // the next vertex in which the edge bends
    std::size_t k = least;
    do k = (k + step) % n;
    while (k != least && collinear(complex.points, v[(k + n - 1) % n], v[k], v[(k + 1) % n]));
    return v[k];
  };
  return less(corner(1), corner(n - 1)) ? first : first.twin();
}

/// How many of each the graph on a small sphere around a vertex has, in cells of the result.
struct SphereGraph {
  std::size_t nodes = 0, arcs = 0, germs = 0, parts = 0;
};

SphereGraph graph_of(const SimplifiedComplex& simplified, const Neighbourhood& n) {
  using Index = Neighbourhood::Index;
  const auto is_node = [&](Index i) {
    return simplified.edge_place[n.nodes[i].edge.edge().index()].dimension == 1;
  };
  const auto is_arc = [&](Index i) { return simplified.face_place[n.arcs[i].face.index()].dimension == 2; };
  const auto node_count = Index(n.nodes.size());
  UnionFind arcs(n.arcs.size()), germs(n.germs.size()), parts(n.nodes.size() + n.arcs.size());
  std::vector<Index> ending(n.nodes.size(), Neighbourhood::kNone);  // an arc at a node that is gone
  for (Index i = 0; i < n.arcs.size(); ++i) {
    if (!is_arc(i)) {
      germs.unite(n.arcs[i].germs[0], n.arcs[i].germs[1]);
      continue;
    }
    for (const Index node : n.arcs[i].nodes) {
      if (node == Neighbourhood::kNone) continue;
      if (is_node(node)) {
        parts.unite(node, node_count + i);
      } else if (ending[node] == Neighbourhood::kNone) {
        ending[node] = i;
      } else {
        arcs.unite(ending[node], i);
        parts.unite(node_count + ending[node], node_count + i);
      }
    }
  }
  SphereGraph out;
  for (Index i = 0; i < n.nodes.size(); ++i) {
    if (!is_node(i)) continue;
    ++out.nodes;
    out.parts += parts.find(i) == i;
  }
  for (Index i = 0; i < n.arcs.size(); ++i) {
    if (!is_arc(i)) continue;
    out.arcs += arcs.find(i) == i;
    out.parts += parts.find(node_count + i) == node_count + i;
  }
  for (Index i = 0; i < n.germs.size(); ++i) out.germs += germs.find(i) == i;
  return out;
}

}  // namespace

EdgeAbout faces_about(const Complex& complex, const SimplifiedComplex& simplified,
                      const SimplifiedComplex::Edge& edge) {
  EdgeAbout out{way_of(complex, edge), {}};
  const bool along = out.way.direction() == 0;
  for (const FaceUse& use : complex.edge_uses[out.way.edge()]) {
    const SimplifiedComplex::Place face = simplified.face_place[use.face.index()];
    if (face.dimension != 2 || face.index == SimplifiedComplex::kNowhere) continue;
    const RegionId behind = complex.region(along ? use.after() : use.before());
    const SimplifiedComplex::Place place = simplified.region_place[behind.index()];
    const bool listed = place.dimension == 3 && place.index != SimplifiedComplex::kNowhere;
    out.faces.push_back({face.index, listed ? place.index + 1 : 0, use, behind});
  }
  if (!along) std::reverse(out.faces.begin(), out.faces.end());
  const auto less = [](const FaceAbout& a, const FaceAbout& b) {
    return std::tie(a.face, a.region) < std::tie(b.face, b.region);
  };
  auto least = out.faces;
  for (std::size_t i = 1; i < out.faces.size(); ++i) {
    std::rotate(out.faces.begin(), out.faces.begin() + 1, out.faces.end());
    if (std::ranges::lexicographical_compare(out.faces, least, less)) least = out.faces;
  }
  out.faces = std::move(least);
  return out;
}

std::string radial_orders_text(const Complex& complex, const SimplifiedComplex& simplified,
                               std::span<const RegionAttributes> components, std::span<const std::uint32_t> edges,
                               std::size_t most) {
  return lines("radial order (faces and regions about the edge)", edges, most, [&](std::uint32_t i) {
    const SimplifiedComplex::Edge& edge = simplified.edges[i];
    std::string text;
    for (const FaceAbout& about : faces_about(complex, simplified, edge).faces)
      text += (text.empty() ? " " : ", ") + cell_name(2, about.face) + ", " +
              region_name(simplified, components, about.behind);
    if (text.empty())
      text = " a wire in " + region_name(simplified, components, complex.some_region(edge.chain.front().edge()));
    return cell_name(1, i) + ":" + text;
  });
}

std::string neighbourhoods_text(const SimplifiedComplex& simplified, Neighbourhoods& neighbourhoods,
                                std::span<const std::uint32_t> vertices, std::size_t most) {
  return lines("neighbourhood (graph on a small sphere)", vertices, most, [&](std::uint32_t i) {
    const SphereGraph g = graph_of(simplified, neighbourhoods.at(simplified.vertices[i].cell));
    return cell_name(0, i) + ": " + numbered(g.nodes, "node (edge)", "nodes (edges)") + ", " +
           numbered(g.arcs, "arc (corner of a face)", "arcs (corners of faces)") + ", " +
           numbered(g.germs, "face (piece of a region)", "faces (pieces of regions)") + ", " +
           numbered(g.parts, "connected part", "connected parts");
  });
}

std::string shells_text(const SimplifiedComplex& simplified, std::span<const RegionAttributes> components,
                        std::size_t most) {
  std::vector<std::uint32_t> regions;
  for (std::uint32_t i = 0; i < simplified.regions.size(); ++i) {
    if (simplified.regions[i].component != 0) regions.push_back(i);
  }
  return lines("shells", regions, most, [&](std::uint32_t i) {
    const SimplifiedComplex::Region& region = simplified.regions[i];
    std::string text = cell_name(3, i) + " (" + component_name(components, region.component) +
                       "): " + numbered(region.shells.size(), "shell", "shells");
    for (std::size_t k = 0; k < std::min(region.shells.size(), most); ++k) {
      text += (k == 0 ? " of " : ", ") + numbered(region.shells[k].size(), "side of a face", "sides of faces");
    }
    return region.shells.size() > most ? text + ", ..." : text;
  });
}

}  // namespace cnrg
