// Names of a mesh's groups for formats that have room for few characters.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "csg/mesh/mesh.h"

namespace cnrg {

/// At most so many bytes of a text, whole characters; `...` at its end says that there was more.
std::string cut(const std::string& text, std::size_t longest);

/// ASCII letters, digits, `_` and `-`, beginning with a letter; everything else becomes `_`.
std::string plain_label(std::string_view name);

/// By dimension and group - 1: `clean` of the name, at most `longest` bytes, unlike all others of the mesh even
/// where upper and lower case are one (`wall`, `wall_2`).
std::array<std::vector<std::string>, 4> distinct_names(const Mesh& mesh, std::string (*clean)(std::string_view),
                                                       std::size_t longest);

}  // namespace cnrg
