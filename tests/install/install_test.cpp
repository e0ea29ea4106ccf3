// What a stranger gets: the built tree installed to a folder of its own, and a project outside that finds it.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/app/program.h"

namespace cnrg {
namespace {

using Catch::StartsWith;
namespace fs = std::filesystem;

/// Runs a command in the folder; fails the test with all that it said.
std::string succeed(const Workshop& w, const std::string& command) {
  const Outcome o = w.shell(command + " >.out 2>.err");
  INFO(command << "\n" << o.out << o.err);
  REQUIRE(o.status == 0);
  return o.out;
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

const char* const kInstall = "'" CNRG_CMAKE "' --install '" CNRG_BUILD "' --prefix installed";

TEST_CASE("installed headers name installed headers only", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  const fs::path include = w.path("installed/include/cnrg");
  std::size_t headers = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(include)) {
    if (!entry.is_regular_file()) continue;
    ++headers;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      INFO(entry.path().string() << ": " << line);
      if (line.rfind("#include \"", 0) == 0) {
        CHECK(fs::exists(include / line.substr(10, line.find('"', 10) - 10)));
      } else if (line.rfind("#include <", 0) == 0 && line.find('/') != std::string::npos) {
        FAIL_CHECK("a header of another library, which who uses ours would need");
      }
    }
  }
  CHECK(headers > 40);
  CHECK_FALSE(fs::exists(include / "csg/app"));
}

TEST_CASE("the installed program runs", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  CHECK_THAT(succeed(w, "installed/bin/cnrg --version"), StartsWith("cnrg "));
}

TEST_CASE("a project outside finds, compiles, links and runs the installed library", "[install]") {
  const Workshop w;
  succeed(w, kInstall);
  succeed(w, quoted(CNRG_CMAKE) +
                 " -S '" CNRG_CONSUMER "' -B consumer -G '" CNRG_GENERATOR
                 "'"
                 " -DCMAKE_PREFIX_PATH=" +
                 quoted(w.path("installed").string()) + " " CNRG_CONSUMER_OPTIONS);
  succeed(w, quoted(CNRG_CMAKE) + " --build consumer");
  CHECK(succeed(w, "consumer/consumer") ==
        "a 8, center in a cell of dimension 3\n"
        "2 regions, \n"
        "2 regions, \n");
}

}  // namespace
}  // namespace cnrg
