// What starting costs: libraries that most runs never need are not loaded, and strange ones never.
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

TEST_CASE("the program loads at most 20 shared objects", "[app]") {
  const Workshop w;
  const Outcome o = w.shell("ldd '" CNRG_PROGRAM "' >.out 2>.err");
  CHECK(o.status == 0);
  INFO(o.out);
  CHECK(lines_in(o.out) > 5);  // it is linked to some
  CHECK(lines_in(o.out) <= 20);
  for (const char* library : {"libTK", "libhdf5", "libcairo", "libtet"})
    CHECK(o.out.find(library) == std::string::npos);
}

TEST_CASE("a module that is not of this build is no plug-in", "[app]") {
  const Workshop w;
  // Any shared library will do: one that the program has loaded.
  const Outcome copied =
      w.shell("{ cp \"$(ldd '" CNRG_PROGRAM
              "' | sed -nE 's/.*gmp.* => ([^ ]+) .*/\\1/p' | head -1)\" cnrg_cad.so; } >.out 2>.err");
  REQUIRE(copied.status == 0);
  const Outcome o = w.shell("LD_LIBRARY_PATH=\"$PWD\" '" CNRG_PROGRAM "' --version >.out 2>.err");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  CHECK(o.out.find(
            "the file cnrg_cad.so that was found is no plug-in for OpenCASCADE of this build of cnrg: install or "
            "build cnrg again, with it") != std::string::npos);
}

}  // namespace
}  // namespace cnrg
