// The soup of a case: one leaf per mesh, regions by winding.
#pragma once

#include "bench/cases/case.h"
#include "kernel/refine/soup.h"

namespace cnrg::bench {

Soup soup_of(const Case& c);

}  // namespace cnrg::bench
