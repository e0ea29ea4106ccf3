// The point set of a value as a model.
#pragma once

#include "bench/cases/model.h"
#include "csg/operators/node_value.h"
#include "kernel/selection/selection.h"
#include "kernel/selection/simplify.h"

namespace cnrg::bench {

/// All cells as one component.
Selection as_one(const CellSet& set);

/// The point set alone, so that walls between regions and what hangs inside of them fall out.
SimplifiedComplex point_set(const Complex& complex, const NodeValue& value);

/// Of a closed, bounded point set. Faces may have holes.
Model model_of(const Complex& complex, const SimplifiedComplex& simplified);

}  // namespace cnrg::bench
