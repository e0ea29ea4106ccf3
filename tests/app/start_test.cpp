// What starting costs: libraries that most runs never need are not loaded.
#include <algorithm>
#include <cstdio>
#include <string>

#include "tests/catch.h"

namespace cnrg {
namespace {

TEST_CASE("the program loads at most 20 shared objects", "[app]") {
  std::FILE* const pipe = popen("ldd '" CNRG_PROGRAM "'", "r");
  REQUIRE(pipe != nullptr);
  std::string listed;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) listed += char(c);
  CHECK(pclose(pipe) == 0);
  INFO(listed);
  const auto lines = std::count(listed.begin(), listed.end(), '\n');
  CHECK(lines > 5);  // it is linked to some
  CHECK(lines <= 20);
  for (const char* library : {"libTK", "libhdf5", "libcairo", "libtet"})
    CHECK(listed.find(library) == std::string::npos);
}

}  // namespace
}  // namespace cnrg
