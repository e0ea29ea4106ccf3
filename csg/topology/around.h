// What is around cells, in words: radial order about edges, neighbourhoods of vertices, shells of regions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "csg/operators/group.h"
#include "kernel/selection/neighbourhood.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// A face about an edge, and the region after it.
struct FaceAbout {
  std::uint32_t face;    ///< in the simplified complex
  std::uint32_t region;  ///< 1 + its number there; 0: none that is listed
  FaceUse use;
  RegionId behind;
};
struct EdgeAbout {
  HalfEdge way;  ///< of the first edge of the chain, along the way of the edge, which its points tell
  std::vector<FaceAbout> faces;
};
/// The faces about an edge in radial order, counter-clockwise as seen with the way of the edge pointing towards
/// the viewer (weiler1986), from the least one. Faces that simplification took away are passed over.
EdgeAbout faces_about(const Complex& complex, const SimplifiedComplex& simplified,
                      const SimplifiedComplex::Edge& edge);

/// One line per listed edge of the simplified complex: what `faces_about` tells; at most `most` lines, then how
/// many more. Faces are called as `cnrg locate` calls them, regions by `component_name`.
std::string radial_orders_text(const Complex& complex, const SimplifiedComplex& simplified,
                               std::span<const RegionAttributes> components, std::span<const std::uint32_t> edges,
                               std::size_t most = 12);

/// One line per listed vertex: its neighbourhood as a planar graph on a small sphere, in cells of the result.
std::string neighbourhoods_text(const SimplifiedComplex& simplified, Neighbourhoods& neighbourhoods,
                                std::span<const std::uint32_t> vertices, std::size_t most = 12);

/// One line per active region: how many shells bound it, and of how many sides of faces.
std::string shells_text(const SimplifiedComplex& simplified, std::span<const RegionAttributes> components,
                        std::size_t most = 12);

}  // namespace cnrg
