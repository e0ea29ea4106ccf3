// The tables of forms.h for editors.
#pragma once

#include <string>

namespace cnrg {

/// The JSON Schema (draft 2020-12) of a tree file. What it cannot say: which names there are, how values depend on
/// each other, what an expression is worth.
std::string tree_schema();

}  // namespace cnrg
