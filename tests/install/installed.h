// The built tree installed to a folder of a test.
#pragma once

#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {

inline const char* const kInstall = "'" CNRG_CMAKE "' --install '" CNRG_BUILD "' --prefix installed";

/// Runs a command in the folder, and gives what it prints; fails the test with all that it said.
inline std::string succeed(const Workshop& w, const std::string& command) {
  const Outcome o = w.shell(command + " >.out 2>.err");
  INFO(command << "\n" << o.out << o.err);
  REQUIRE(o.status == 0);
  return o.out;
}

}  // namespace cnrg
