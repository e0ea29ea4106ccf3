// A result as text, exact and lossless: what a `.json` holds, and what a node whose value is computed apart hands
// on.
#pragma once

#include <string>

#include "csg/result/flat.h"

namespace cnrg {

/// The text of a `.json` (csg/FORMATS.md, Exact JSON). Parameters are those of the view.
std::string result_json(const ResultView& view);
/// The same with other flattened cells than those of the view, for one that reads what they say.
std::string result_json(const ResultView& view, FlatComplex flat);

}  // namespace cnrg
