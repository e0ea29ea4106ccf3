// meshio, VTK and Gmsh open what we write and find what is exact; what VTK writes we read: a script, which needs
// the readers of others, and the program from outside.
#include <sys/wait.h>

#include <cstdlib>
#include <sstream>
#include <string>

#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

/// Runs a script of this folder with the program, words, and an empty folder. What it leaves out it says in lines
/// that begin with `left out: `.
void check_script(const std::string& script, const std::string& words) {
  const ScratchFolder dir;
  const std::string log = dir / "log";
  const std::string command = "/usr/bin/python3 '" CNRG_SOURCES "/tests/formats/" + script +
                              "' '" CNRG_PROGRAM "' " + words + " '" + dir.path() + "' >'" + log + "' 2>&1";
  const int status = std::system(command.c_str());
  const std::string said = text_of(log);
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("left out: ")) WARN(line);
  }
  INFO(said);
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
}

void check_case(const std::string& name) { check_script("ecosystem.py", name); }

}  // namespace

TEST_CASE(".vtu and .msh in meshio, VTK and Gmsh: measures of all regions, walls, sheets, wires", "[ecosystem]") {
  check_case("written");
}
TEST_CASE(".vtu and .msh in meshio, VTK and Gmsh: results with little in them, raw and open ones", "[ecosystem]") {
  check_case("little");
}
TEST_CASE(".vtu and .msh in meshio, VTK and Gmsh: second order, parameters, graded materials", "[ecosystem]") {
  check_case("curved");
}
TEST_CASE(".vtu and .msh in meshio, VTK and Gmsh: names of all kinds", "[ecosystem]") { check_case("names"); }
TEST_CASE(".vtu and .msh in meshio, VTK and Gmsh: results that rounding breaks", "[ecosystem]") {
  check_case("snapped");
}
TEST_CASE("surfaces that VTK writes are read, in every form", "[ecosystem]") { check_case("read"); }
TEST_CASE("labels of cells and flat cells of grids in VTK's files", "[ecosystem]") { check_case("labelled"); }
TEST_CASE("the supported tunnel in meshio and Gmsh: measures and properties of all groups", "[ecosystem]") {
  check_script("supported_tunnel.py", "");
}

/// What each asks for stands in the script.
TEST_CASE("meshes in the programs that they are written for", "[ecosystem][meshes]") {
  for (const char* const name : {"msh", "medit", "nastran", "abaqus", "faults", "periodic", "flac3d", "med",
                                 "xdmf", "h5m", "surfaces", "quads", "same"}) {
    DYNAMIC_SECTION(name) { check_script("mesh_programs.py", name); }
  }
}
