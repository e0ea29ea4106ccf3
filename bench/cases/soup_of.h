// Soups of cases and models, regions by winding.
#pragma once

#include "bench/cases/case.h"
#include "bench/cases/model.h"
#include "kernel/refine/soup.h"

namespace cnrg::bench {

/// One leaf per mesh.
Soup soup_of(const Case& c);

/// Adds a leaf with the faces of the solid, if there are any, and one without regions with everything else, if
/// there is anything; one empty leaf for an empty model. Returns the leaves.
std::vector<LeafId> add_model(Soup& soup, const Model& model);

}  // namespace cnrg::bench
