// OpenSCAD's `.csg` files as trees (csg/FORMATS.md#openscad).
#pragma once

#include "csg/tree/tree.h"

namespace cnrg {

/// As `parse_tree`, of the text of a `.csg` file; places are those of that file.
Tree parse_openscad(const std::string& text, const std::string& file, const ReadOptions& options = {});

}  // namespace cnrg
