// The text of a `.csg` file as statements: `name(argument = value, ...) { children }`.
//
// OpenSCAD writes such files with all variables, loops and modules resolved. What is left are calls of modules
// with numbers, texts, truth values and lists of these; anything else is an error with its line and column.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "csg/openscad/fineness.h"
#include "csg/openscad/polyset.h"

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

// The arguments of a statement by name, read strictly.

/// Throws LeafFileError at the statement: "`NAME` FAULT".
[[noreturn]] void fail(const std::string& path, const Statement& at, const std::string& fault);

class Arguments {
 public:
  /// Fails for an argument that is not among `known`; `$fn`, `$fa`, `$fs` and `convexity` always are. One without
  /// a name gets the first of these.
  Arguments(const std::string& path, const Statement& statement, std::initializer_list<std::string_view> known);

  /// Without a look at what there is.
  Arguments(const std::string& path, const Statement& statement) : path_(path), statement_(statement) {}

  bool has(std::string_view name) const { return find(name) != nullptr; }
  double number(std::string_view name, double otherwise) const;
  bool boolean(std::string_view name) const;  ///< false without it
  std::string text(std::string_view name) const;
  /// A list of `count` numbers, or one number for all of them.
  std::vector<double> numbers(std::string_view name, std::size_t count, double otherwise) const;
  /// A list of points of `count` numbers.
  std::vector<std::vector<double>> points(std::string_view name, std::size_t count) const;
  /// A list of lists of numbers of points, from 0 to below `points`; empty for `undef`.
  std::vector<Face> indices(std::string_view name, std::size_t points) const;
  Matrix matrix(std::string_view name) const;

 private:
  const std::string& path_;
  const Statement& statement_;
  std::string_view first_;

  const Literal* find(std::string_view name) const;
  [[noreturn]] void fail_wanted(std::string_view name, const std::string& wanted) const;
  std::vector<double> list(std::string_view name, const Literal& value, std::size_t count,
                           const std::string& wanted) const;
};

/// Of the statement and its children, by `$fn`, `$fa` and `$fs`: those that it does not say are of its parent.
Fineness fineness_of(const std::string& path, const Statement& statement, const Fineness& parent);

}  // namespace cnrg::openscad
