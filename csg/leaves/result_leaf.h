// A result read back as a leaf.
#pragma once

#include <memory>

#include "csg/leaves/leaf.h"

namespace cnrg {

/// Reads a `.json` result: a leaf with the same cells, regions, names and materials.
/// Throws InputError or FileError as `prepare` does.
std::unique_ptr<PreparedLeaf> prepare_result(const ResultShape& shape);

}  // namespace cnrg
