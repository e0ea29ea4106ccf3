// What a statement makes: nothing, an area, polygons of doubles, or an exact solid, as OpenSCAD has it at that
// place.
//
// One operand alone passes through a Boolean unchanged, so that it stays polygons of doubles. Of an exact solid
// that is a union of convex ones the corners of these are kept: hulls and Minkowski sums are faster with them.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "csg/openscad/exact_solid.h"

namespace cnrg::openscad {

using Parts = std::vector<std::vector<Point3>>;

struct Solid {
  Polyset polyset;
  const Statement* from;
};
struct Exact {
  ExactSolidRef solid;
  std::optional<Parts> parts;  ///< of a union of convex ones
};
using Value = std::variant<std::monostate, Area, Solid, Exact>;

/// Without area or volume.
bool is_empty(const Value& value);

/// What was met on the way.
struct Report {
  struct Warning {
    int line, column;
    std::string text;
  };
  std::vector<Warning> warnings;
  std::vector<std::string> inputs;  ///< files that were imported
};

/// The statement must live as long as the value. `path`: of the file, for messages, and to find files that it
/// names; `inside`: the folder that these must lie in. Throws LeafFileError, and for a file
/// that is imported as `read_mesh`.
Value evaluate(const Statement& statement, const std::string& path, const std::string& inside, Report& report);

}  // namespace cnrg::openscad
