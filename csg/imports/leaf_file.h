// Files that leaves name.
#pragma once

#include <string>

namespace cnrg {

/// The content of a file that a leaf reads, as `read_file` of csg/text/input_file.h does. Throws LeafFileError
/// with the `remedy` for a file that is empty or has nothing but blanks.
std::string read_leaf_file(const std::string& path, const std::string& inside, const std::string& remedy);

}  // namespace cnrg
