// Statements of a file, evaluated: each makes a value (value.h).
#pragma once

#include <string>
#include <vector>

#include "csg/openscad/value.h"

namespace cnrg::openscad {

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
