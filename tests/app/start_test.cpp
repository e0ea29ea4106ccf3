// What starting costs: libraries that most runs never need are not loaded, and strange ones never.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include "tests/catch.h"

namespace cnrg {
namespace {

/// What a command of the shell prints, and its status.
std::pair<std::string, int> run(const std::string& command) {
  std::FILE* const pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string said;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said += char(c);
  return {said, pclose(pipe)};
}

TEST_CASE("the program loads at most 20 shared objects", "[app]") {
  const auto [listed, status] = run("ldd '" CNRG_PROGRAM "'");
  CHECK(status == 0);
  INFO(listed);
  const auto lines = std::count(listed.begin(), listed.end(), '\n');
  CHECK(lines > 5);  // it is linked to some
  CHECK(lines <= 20);
  for (const char* library : {"libTK", "libhdf5", "libcairo", "libtet"})
    CHECK(listed.find(library) == std::string::npos);
}

TEST_CASE("a module that is not of this build is no plug-in", "[app]") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "cnrg_start_test";
  std::filesystem::create_directories(folder);
  // Any shared library will do: one that the program has loaded.
  const std::string commands =
      "set -e; cp \"$(ldd '" CNRG_PROGRAM "' | sed -nE 's/.*gmp.* => ([^ ]+) .*/\\1/p' | head -1)\" '" +
      folder.string() + "/cnrg_cad.so'; LD_LIBRARY_PATH='" + folder.string() + "' '" CNRG_PROGRAM "' --version";
  const auto [said, status] = run(commands);
  std::filesystem::remove_all(folder);
  INFO(said);
  CHECK(status == 0);
  CHECK(said.find(
            "the file cnrg_cad.so that was found is no plug-in for OpenCASCADE of this build of cnrg: install or "
            "build cnrg again, with it") != std::string::npos);
}

}  // namespace
}  // namespace cnrg
