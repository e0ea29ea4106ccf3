// Middles of straight edges are rounded: what is flatter than that is refused, and said where.
#include "csg/mesh/straight_order.h"

#include <cmath>

#include "kernel/base/error.h"
#include "kernel/exact/predicates.h"
#include "tests/catch.h"

using namespace cnrg;
using Catch::Contains;

TEST_CASE("a tetrahedron that is flatter than rounded middles is told with its place", "[mesh][order]") {
  Mesh mesh;
  mesh.points = {{0.1, 0.2, 0.3}, {1.1, 0.7, 0.5}, {0.3, 1.9, 0.9}, {0.46, 0.86, 0.54}};
  const auto turned = [&] {
    return orient3d(mesh.points[0].data(), mesh.points[1].data(), mesh.points[2].data(), mesh.points[3].data());
  };
  const int before = turned();  // one step of the last digit is enough to lie on the other side
  while (turned() == before) mesh.points[3][2] = std::nextafter(mesh.points[3][2], before > 0 ? -10.0 : 10.0);
  while (turned() == 0) mesh.points[3][2] = std::nextafter(mesh.points[3][2], before > 0 ? -10.0 : 10.0);
  mesh.tetrahedra = {{{0, 1, 2, 3}, 0}};
  if (turned() < 0) std::swap(mesh.tetrahedra[0].points[0], mesh.tetrahedra[0].points[1]);
  CHECK_THROWS_WITH(add_straight_middles(mesh), Contains("1 tetrahedron is so flat") &&
                                                    Contains("one at 0.49 0.915 0.56;") && Contains("--join"));
}
