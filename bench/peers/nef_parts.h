// What Nef polyhedra are made from. Surfaces and Nef polyhedra are each slow to compile, so each has a file.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <vector>

#include "bench/peers/system.h"

namespace cnrg::bench::nef {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Shell {
  Mesh mesh;  ///< oriented outward
  bool cavity = false;
};

/// The parts of an operand in CGAL's own forms: it is their union, cavities taken out of the shells before them.
struct Parts {
  std::vector<Shell> shells;
  std::vector<std::vector<Kernel::Point_3>> sheets;
  std::vector<std::array<Kernel::Point_3, 2>> wires;
  std::vector<Kernel::Point_3> points;
};

/// Throws Refusal, or what CGAL's assertions throw, for an operand that CGAL does not take.
Parts parts_of(const Model& model);
/// The same of a result, whose faces may have holes, and whose solids may touch themselves: contacts are doubled
/// before, so that shells are 2-manifolds.
Parts parts_of_result(Model model);

}  // namespace cnrg::bench::nef
