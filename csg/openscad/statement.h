// The text of a `.csg` file as statements: `name(argument = value, ...) { children }`.
//
// OpenSCAD writes such files with all variables, loops and modules resolved. What is left are calls of modules
// with numbers, texts, truth values and lists of these; anything else is an error with its line and column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cnrg::openscad {

/// A value of an argument.
struct Literal {
  enum class Kind { undefined, boolean, number, text, list };
  Kind kind = Kind::undefined;
  double number = 0;  ///< of a boolean 0 or 1
  std::string text{};
  std::vector<Literal> items{};
};

struct Argument {
  std::string name;  ///< empty: by position
  Literal value;
  int line = 0, column = 0;
};

struct Statement {
  std::string name;
  int line = 1, column = 1;
  bool is_root = false;  ///< marked `!`: the only one that is shown
  std::vector<Argument> arguments{};
  std::vector<Statement> children{};
};

/// The statements of the file, without those marked `%` (background) or `*` (disabled). Throws LeafFileError.
std::vector<Statement> parse_statements(const std::string& path, std::string_view text);

}  // namespace cnrg::openscad
