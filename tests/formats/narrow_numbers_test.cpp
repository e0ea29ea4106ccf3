// Numbers in columns, read back as the programs read them, and what a mesh is refused for.
#include "csg/formats/narrow_numbers.h"

#include <cmath>
#include <cstdlib>
#include <random>

#include "csg/formats/formats.h"
#include "csg/mesh/straight_order.h"
#include "kernel/base/error.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

/// As Nastran reads a real: a sign behind a digit begins the exponent.
double nastran_value(std::string text) {
  const std::size_t sign = text.find_first_of("+-", 1);
  if (sign != std::string::npos) text.insert(sign, "e");
  return std::strtod(text.c_str(), nullptr);  // also below the least normal number
}

Mesh one_tetrahedron(double at, double size) {
  Mesh mesh;
  mesh.points = {{at, at, at}, {at + size, at, at}, {at, at + size, at}, {at, at, at + size}};
  mesh.tetrahedra = {{{0, 1, 2, 3}, 0}};
  mesh.entities[3].resize(1);
  return mesh;
}

}  // namespace

TEST_CASE("numbers in columns fit, read back, and are as near as their digits allow", "[formats][columns]") {
  std::mt19937_64 random(7);
  std::vector<double> numbers{0,
                              -0.0,
                              1,
                              -1,
                              0.5,
                              1.0 / 3,
                              -1.0 / 3,
                              1e22,
                              -1e300,
                              5e-324,
                              1.5e10,
                              -2e-07,
                              1e15,
                              1e16 / 3,
                              123456.789,
                              0.001,
                              9.9999999999999995e-5};
  for (int i = 0; i < 20000; ++i) {
    const double mantissa = std::uniform_real_distribution<>(-10, 10)(random);
    numbers.push_back(mantissa *
                      std::pow(10.0, std::uniform_int_distribution<>(-120, 120)(random) / (i % 2 ? 1 : 20)));
  }
  for (const double x : numbers) {
    CAPTURE(x);
    const NarrowNumber nastran = narrow_number(x, Column::nastran), abaqus = narrow_number(x, Column::abaqus);
    REQUIRE(nastran.text.size() <= 16);
    REQUIRE(abaqus.text.size() <= 20);
    REQUIRE(nastran.text.find('.') != std::string::npos);
    REQUIRE(nastran.text.find('e') == std::string::npos);
    REQUIRE(nastran_value(nastran.text) == nastran.value);
    REQUIRE(std::strtod(abaqus.text.c_str(), nullptr) == abaqus.value);
    const bool plain = std::abs(x) >= 0.1 && std::abs(x) < 1e14;
    REQUIRE(std::abs(nastran.value - x) <= (plain ? 5e-14 : 5e-10) * std::abs(x));
    REQUIRE(std::abs(abaqus.value - x) <= 5e-13 * std::abs(x));
    REQUIRE((!plain || std::abs(abaqus.value - x) <= 2e-16 * std::abs(x)));
  }
  CHECK(narrow_number(-0.0, Column::nastran).text == "0.");
  CHECK(narrow_number(0.5, Column::nastran).text == ".5");
  CHECK(narrow_number(-2e-7, Column::nastran).text == "-2.-7");
  CHECK(narrow_number(1e22, Column::nastran).text == "1.+22");
}

TEST_CASE("a tetrahedron that the digits of a column flatten is refused", "[formats][columns][errors]") {
  const Mesh fine = one_tetrahedron(1'000'000, 1), tiny = one_tetrahedron(1'000'000, 2e-9);
  CHECK(nastran_text(fine).find("CTETRA") != std::string::npos);
  CHECK(abaqus_text(tiny).find("C3D4") != std::string::npos);
  CHECK_THROWS_WITH(nastran_text(tiny), Catch::Contains("16 characters") && Catch::Contains(".msh"));
  Mesh second = fine;
  add_straight_middles(second);
  CHECK(nastran_text(second).find("\n+ ") != std::string::npos);
  second = one_tetrahedron(1'000'000, 2e-7);
  CHECK(nastran_text(second).find("CTETRA") != std::string::npos);
  add_straight_middles(second);
  CHECK(abaqus_text(second).find("C3D10") != std::string::npos);
}

TEST_CASE("second order with straight edges: a middle for each edge once, and no tetrahedron without a proof",
          "[formats][order]") {
  Mesh mesh = one_tetrahedron(0, 1);
  mesh.points.push_back({1, 1, 1});
  mesh.tetrahedra.push_back({{1, 2, 3, 4}, 0});
  mesh.triangles = {{{1, 2, 3}, 0}};
  mesh.segments = {{{0, 4}, 0}};
  add_straight_middles(mesh);
  REQUIRE(mesh.middles.size() == 6 + 3 + 1);
  for (const auto& [edge, at] : mesh.middles) {
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(mesh.points[at][k] == (mesh.points[edge[0]][k] + mesh.points[edge[1]][k]) / 2);
  }
  CHECK(mesh.points.size() == 15);
  // Between neighbouring doubles there is no middle.
  Mesh thin = one_tetrahedron(1, 1);
  thin.points[3] = {1.25, 1.25, std::nextafter(1.0, 2.0)};
  CHECK_THROWS_WITH(add_straight_middles(thin), Catch::Contains("--order 2"));
}
