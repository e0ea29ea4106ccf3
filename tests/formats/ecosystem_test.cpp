// meshio, VTK and Gmsh open what we write and find what is exact; what VTK writes we read: a script, which needs
// the readers of others, and the program from outside.
#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

void check_case(const std::string& name) {
  const Scratch dir;
  const std::string log = dir / "log";
  const std::string command = "/usr/bin/python3 '" CNRG_SOURCES "/tests/formats/ecosystem.py' '" CNRG_PROGRAM
                              "' " +
                              name + " '" + dir.path() + "' >'" + log + "' 2>&1";
  const int status = std::system(command.c_str());
  INFO(text_of(log));
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
}

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
