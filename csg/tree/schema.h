// The tables of forms.h as texts: for editors and for csg/FORMATS.md.
#pragma once

#include <string>

namespace cnrg {

/// The JSON Schema (draft 2020-12) of a tree file. What it cannot say: which names there are, how numbers depend
/// on each other, what an expression is worth.
std::string tree_schema();

/// The tables of keys in Markdown, each between `<!-- keys: SECTION -->` and `<!-- /keys -->`.
std::string key_tables();

}  // namespace cnrg
