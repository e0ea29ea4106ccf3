// Reads the numbers that expressions of a tree file name.
#pragma once

#include "csg/tree/tree.h"
#include "csg/tree/yaml_value.h"

namespace cnrg {

/// `parameters` of the file, in its order, to the document: an expression names those before it. Throws TreeError,
/// and InputError for what `options` gives and the file has not, or what is no expression.
void read_parameters(Document& document, const Value& top, const ReadOptions& options);

}  // namespace cnrg
