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

/// What the name of a group may be in a file.
struct GroupNameForm {
  std::string (*clean)(std::string_view);
  std::size_t longest;                ///< bytes
  std::string before = "_", after{};  ///< around what tells names apart: `wall_faces`, `wall (faces)`
  bool case_matters = false;
};

/// By dimension and group - 1: the names of a format that has one list of groups for all dimensions, unlike each
/// other. Of groups of one name in several dimensions the highest has the name, the others say what they hold:
/// `round_1`, `round_1_faces`. What a format cannot tell apart otherwise is numbered: `wall`, `wall_2`.
std::array<std::vector<std::string>, 4> distinct_names(const Mesh& mesh, const GroupNameForm& form);

}  // namespace cnrg
