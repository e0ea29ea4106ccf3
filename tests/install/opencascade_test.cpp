// OpenCASCADE by the names of its toolkits before and since 7.8, and why an OpenCASCADE that is there cannot be
// used: stand-ins of its CMake package, which name targets and have no library.
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/install/installed.h"

namespace cnrg {
namespace {

const char* const kCommon = "TKXSBase TKMesh TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel";

/// What csg/opencascade.cmake finds where the configuration of the package is `package`: the toolkits, a bar, and
/// what is lacking. The folder of the package is HERE.
std::string found(const std::string& package, const std::string& header = "STEPControl_Reader.hxx") {
  const Workshop w;
  const std::string here = w.path("package").string();
  succeed(w, "mkdir -p package/include && touch package/include/" + header);
  w.write("package/OpenCASCADEConfig.cmake", package);
  w.write("package/OpenCASCADEConfigVersion.cmake",
          "set(PACKAGE_VERSION 7.8.1)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n");
  w.write("CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\nproject(found LANGUAGES NONE)\n"
          "include(\"" CNRG_CONSUMER
          "/../../csg/opencascade.cmake\")\n"
          "file(WRITE found \"${CNRG_OPENCASCADE_TOOLKITS}|${CNRG_OPENCASCADE_LACK}\")\n");
  succeed(w, "'" CNRG_CMAKE "' -G '" CNRG_GENERATOR "' -S . -B build -DOpenCASCADE_DIR='" + here + "'");
  std::string result = w.read("found");
  for (std::size_t at; (at = result.find(here)) != std::string::npos;) result.replace(at, here.size(), "HERE");
  return result;
}

/// The package of a version with toolkits.
std::string package(const std::string& toolkits) {
  return "set(OpenCASCADE_VERSION 7.8.1)\nset(OpenCASCADE_INCLUDE_DIR ${CMAKE_CURRENT_LIST_DIR}/include)\n"
         "foreach(toolkit " +
         toolkits + ")\n  add_library(${toolkit} UNKNOWN IMPORTED)\nendforeach()\n";
}

TEST_CASE("OpenCASCADE is found by its toolkits before 7.8 and since", "[install]") {
  const std::string common = "TKXSBase;TKMesh;TKTopAlgo;TKGeomAlgo;TKBRep;TKGeomBase;TKG3d;TKG2d;TKMath;TKernel|";
  CHECK(found(package(std::string(kCommon) + " TKSTEP TKSTEPBase TKSTEPAttr")) ==
        "TKSTEP;TKSTEPBase;TKSTEPAttr;" + common);
  CHECK(found(package(std::string(kCommon) + " TKDESTEP")) == "TKDESTEP;" + common);
}

TEST_CASE("an OpenCASCADE that is there and cannot be used: the reason", "[install]") {
  CHECK(
      found(package(kCommon)) ==
      "|OpenCASCADE 7.8.1 in HERE lacks TKSTEP (TKDESTEP since 7.8), TKSTEPBase (TKDESTEP since 7.8), TKSTEPAttr "
      "(TKDESTEP since 7.8)");
  CHECK(found(package("TKDESTEP TKXSBase TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d TKernel")) ==
        "|OpenCASCADE 7.8.1 in HERE lacks TKMesh, TKMath");
  CHECK(found(package(std::string(kCommon) + " TKDESTEP"), "other.hxx") ==
        "|OpenCASCADE 7.8.1 lacks HERE/include/STEPControl_Reader.hxx");
  CHECK(found("set(OpenCASCADE_FOUND FALSE)\nset(OpenCASCADE_NOT_FOUND_MESSAGE \"no VTK\")\n") ==
        "|HERE/OpenCASCADEConfig.cmake refuses: no VTK");
}

}  // namespace
}  // namespace cnrg
