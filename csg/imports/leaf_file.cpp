// An empty file is told as such by all readers alike. Each would find something else to miss in it: a header, a
// count, a bracket.
#include "csg/imports/leaf_file.h"

#include "csg/leaves/leaf.h"
#include "csg/text/input_file.h"

namespace cnrg {

std::string read_leaf_file(const std::string& path, const std::string& inside, const std::string& remedy) {
  std::string content = in_value_of("file", [&] { return read_file(path, inside); });
  if (without_mark(content).find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw LeafFileError(path, 1, 1, "the file is empty: " + remedy);
  return content;
}

}  // namespace cnrg
