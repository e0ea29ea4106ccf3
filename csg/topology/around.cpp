// Faces that simplification merged away are passed over: the regions on both sides of them are one.
#include "csg/topology/around.h"

#include "csg/text/escape.h"
#include "csg/text/table.h"
#include "csg/topology/region_graph.h"
#include "kernel/selection/incidence.h"

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

}  // namespace

std::string radial_orders_text(const Complex& complex, const SimplifiedComplex& simplified,
                               std::span<const RegionAttributes> components, std::span<const std::uint32_t> edges,
                               std::size_t most) {
  return lines("radial order (faces and regions about the edge)", edges, most, [&](std::uint32_t i) {
    const EdgeId e = simplified.edges[i].chain.front().edge();
    std::string text = cell_name(1, i) + ":";
    bool any = false;
    for (const RadialStep& step : radial_order(complex, e)) {
      const SimplifiedComplex::Place face = simplified.face_place[step.face.face().index()];
      if (face.dimension != 2) continue;
      text += std::string(any ? ", " : " ") + cell_name(2, face.index) + ", " +
              region_name(simplified, components, step.region);
      any = true;
    }
    return any ? text : text + " a wire in " + region_name(simplified, components, complex.some_region(e));
  });
}

std::string neighbourhoods_text(const SimplifiedComplex& simplified, Neighbourhoods& neighbourhoods,
                                std::span<const std::uint32_t> vertices, std::size_t most) {
  return lines("neighbourhood (graph on a small sphere, in cells of the refinement)", vertices, most,
               [&](std::uint32_t i) {
                 const Neighbourhood n = neighbourhoods.at(simplified.vertices[i].cell);
                 return cell_name(0, i) + ": " + numbered(n.nodes.size(), "node (edge)", "nodes (edges)") + ", " +
                        numbered(n.arcs.size(), "arc (corner of a face)", "arcs (corners of faces)") + ", " +
                        numbered(n.germs.size(), "face (piece of a region)", "faces (pieces of regions)") + ", " +
                        numbered(n.parts, "connected part", "connected parts");
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
