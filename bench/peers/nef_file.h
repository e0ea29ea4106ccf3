// Results of OpenSCAD are Nef polyhedra of CGAL; their exact text is read where Nef polyhedra are known.
#pragma once

#include <string>

#include "bench/cases/model.h"

namespace cnrg::bench {

/// The point set of a file of `Selective Nef Complex`. Throws std::runtime_error if it cannot be read, Refusal
/// with stage `output` if CGAL finds it faulty.
Model read_nef(const std::string& path);

}  // namespace cnrg::bench
