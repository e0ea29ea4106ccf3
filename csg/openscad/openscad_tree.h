// OpenSCAD's `.csg` files as tree files (csg/FORMATS.md#openscad).
//
// `value.h` says what a statement makes; what is left in the end are nodes of the tree. What OpenSCAD keeps
// as polygons of doubles (primitives, extrusions, hulls, also where they are moved) is worked out here, in
// OpenSCAD's own arithmetic; where it makes an exact solid of them, for a Boolean, the tree has a leaf and the
// Boolean a node. So the tree has the corners that OpenSCAD has, and is exact from there on, as OpenSCAD is.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cnrg {

/// A tree file, a node in each line.
struct OpenscadTree {
  struct Place {
    int line = 1, column = 1;
  };
  std::string yaml;
  std::vector<Place> places;  ///< of each line of `yaml`: where the `.csg` file has what it stands for
  std::vector<std::pair<Place, std::string>> warnings;
  std::vector<std::string> inputs;  ///< files that it imports
};

/// True for a name that ends as those of such files do.
bool is_openscad_file(const std::string& path);

/// The tree of the text of a file. `inside`: the folder that imported files must lie in; empty: anywhere. Throws
/// LeafFileError with line and column for what is no such text, or is not read; for an imported file as
/// `read_mesh`.
OpenscadTree openscad_tree(const std::string& text, const std::string& path, const std::string& inside = {});

}  // namespace cnrg
