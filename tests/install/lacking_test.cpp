// What CMake says where libraries are lacking: once, in our own words, with the package that brings them.
#include <filesystem>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// What a configuration that fails says, which may use the folder `broken`. CMake breaks no line that begins with
/// spaces.
std::string refusal(const std::string& options) {
  const Workshop w;
  std::filesystem::create_directory(w.path("broken"));
  w.write("broken/hdf5.h", "#error \"broken here\"\n");
  const Outcome o = w.shell("'" CNRG_CMAKE "' -S '" CNRG_SOURCES "' -B build -G '" CNRG_GENERATOR
                            "' -DCMAKE_CXX_COMPILER='" CNRG_CXX "' -DBUILD_TESTING=OFF " +
                            options + " >.out 2>.err");
  INFO(o.out << o.err);
  CHECK(o.status == 1);
  CHECK(o.err.find("CMake Error") == o.err.rfind("CMake Error"));
  return o.err;
}

TEST_CASE("all libraries that a build cannot do without and lacks are named at once", "[install]") {
  CHECK_THAT(
      refusal("-DGMPXX_LIBRARIES=/gone/libgmpxx.so -DCNRG_CGAL_INCLUDE=CNRG_CGAL_INCLUDE-NOTFOUND "
              "-DCMAKE_IGNORE_PATH=/usr/include -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON "
              "-DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON"),
      Catch::Contains("cnrg cannot be built:") &&
          Catch::Contains("the cache of CMake names what does not exist: GMPXX_LIBRARIES=/gone/libgmpxx.so; "
                          "correct it, or configure with --fresh (Debian: libgmp-dev)\n") &&
          Catch::Contains("not found: MPFR_INCLUDE_DIR) (Debian: libmpfr-dev)\n") &&
          Catch::Contains("CGAL is not installed (not found: CNRG_CGAL_INCLUDE) (Debian: libcgal-dev)\n") &&
          Catch::Contains("oneTBB is not installed (not found: TBB) (Debian: libtbb-dev)\n") &&
          Catch::Contains("CLI11 is not installed (not found: CLI11) (Debian: libcli11-dev)\n") &&
          Catch::Contains("kernel/install-deps installs all it needs") && Catch::Contains("CNRG_PROGRAM=OFF"));
}

TEST_CASE("an optional library whose path in CMake's cache is gone is refused with the path", "[install]") {
  const std::string said = refusal("-DCNRG_PROGRAM=OFF -DCNRG_VTP=ON -DEXPAT_LIBRARY=/gone/libexpat.so");
  for (const char* words : {"CNRG_VTP is ON, but", "/gone/libexpat.so", "libexpat1-dev", "CNRG_VTP=OFF"})
    CHECK_THAT(said, Catch::Contains(words));
}

TEST_CASE("what is there and cannot be used is refused with the reason, not replaced without a word",
          "[install]") {
  CHECK_THAT(refusal("-DCNRG_PROGRAM=OFF -DTBB_DIR=\"$PWD/broken\""),
             Catch::Contains("TBB_DIR=/") && Catch::Contains("TBBConfig.cmake; correct it"));
  CHECK_THAT(refusal("-DCNRG_PROGRAM=OFF -DCNRG_OPENCASCADE=ON -DOpenCASCADE_DIR=\"$PWD/broken\""),
             Catch::Contains("OpenCASCADE_DIR=/") && Catch::Contains("OpenCASCADEConfig.cmake:"));
  CHECK_THAT(refusal("-DCNRG_HDF5=ON -DCNRG_HDF5_INCLUDE=\"$PWD/broken\""),
             Catch::Contains("CNRG_HDF5 is ON") && Catch::Contains("broken here"));
}

}  // namespace
}  // namespace cnrg
