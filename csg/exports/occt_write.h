// Shapes to the texts of files. Knows OpenCASCADE's types.
#pragma once

#include "csg/exports/cad_text.h"
#include "csg/exports/occt_model.h"

namespace cnrg::occt {

/// A product for each part, with its name, its material as description and colour, in one assembly. Lengths are in
/// millimetres. The same bytes for the same model.
std::string step_text(const CadParts& parts, const CadModelMade& model);
/// Shapes only: the format has no names.
std::string brep_text(const CadModelMade& model);

}  // namespace cnrg::occt
