// The point set of a value as a model.
#pragma once

#include "bench/cases/model.h"
#include "csg/operators/node_value.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {

/// The point set alone, so that walls between regions and what hangs inside of them fall out.
SimplifiedComplex point_set(const Complex& complex, const NodeValue& value);

/// Of a closed, bounded point set. Faces may have holes.
Model model_of(const Complex& complex, const SimplifiedComplex& simplified);

}  // namespace cnrg::bench
