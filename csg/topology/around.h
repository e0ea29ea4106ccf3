// What is around cells, in words: radial order about edges, neighbourhoods of vertices, shells of regions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "csg/operators/group.h"
#include "kernel/selection/neighbourhood.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// One line per listed edge of the simplified complex: the faces and regions about it in radial order,
/// counter-clockwise as seen with the edge pointing towards the viewer (weiler1986); at most `most` lines, then
/// how many more. Faces are called as `cnrg locate` calls them, regions by `component_name`.
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
