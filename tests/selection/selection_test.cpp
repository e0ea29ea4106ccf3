// Topology of cell sets by incidence: one box, one sheet, one wire.
#include "kernel/selection/selection.h"

#include "tests/catch.h"
#include "tests/operators/pieces.h"

namespace cnrg {
namespace {

using namespace pieces;

CellSet region_set(RegionId r) {
  CellSet out;
  out.regions = {r};
  return out;
}

TEST_CASE("closure, interior, boundary and star of a box", "[selection]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {1, 1, 1})});
  const Complex& complex = *built_complex;
  REQUIRE(complex.region_count == 2);
  const CellSet open = region_set(RegionId(1));
  const CellSet closed = closure(complex, open);
  CHECK(closed.faces.size() == 6);
  CHECK(closed.edges.size() == 12);
  CHECK(closed.vertices.size() == 8);
  CHECK(closure(complex, closed) == closed);
  CHECK(interior(complex, closed) == open);
  CHECK(interior(complex, open) == open);
  CHECK(boundary(complex, open) == subtract(closed, open));
  CHECK(boundary(complex, closed) == subtract(closed, open));
  CHECK(star(complex, open) == open);
  CHECK(star(complex, closed) == all_cells(complex));
  // The boundary of a set is that of its complement.
  CHECK(boundary(complex, subtract(all_cells(complex), closed)) == boundary(complex, closed));
}

TEST_CASE("interior tests the whole star, also where the complex is not simplified", "[selection]") {
  // A wire and a sheet run through the box: their cells are interior to it, but for those on its walls.
  const auto built_complex = complex_of(
      {box({0, 0, 0}, {4, 4, 4}), sheet({0, 0, 2}, {4, 4, 2}), wire({1, 1, 0}, {1, 1, 4}), point({3, 3, 3})});
  const Complex& complex = *built_complex;
  REQUIRE(complex.region_count == 3);
  CellSet halves;
  halves.regions = {RegionId(1), RegionId(2)};
  const CellSet closed = closure(complex, halves);
  const CellSet inner = interior(complex, closed);
  CHECK(inner.regions.size() == 2);
  CHECK(inner.faces.size() == 1);
  CHECK(inner.edges.size() == 2);     // the wire, above and below the sheet
  CHECK(inner.vertices.size() == 2);  // where it passes the sheet, and the point
  // Without the sheet's face the open halves alone hold no lower cell.
  CHECK(interior(complex, halves) == halves);
  // A single face has no interior; its closure is its boundary.
  CellSet face;
  face.faces = inner.faces;
  CHECK(interior(complex, face).empty());
  CHECK(boundary(complex, face) == closure(complex, face));
  // De Morgan for interior and closure.
  const CellSet space = all_cells(complex);
  CHECK(subtract(space, closure(complex, face)) == interior(complex, subtract(space, face)));
}

TEST_CASE("components of selections", "[selection]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {1, 1, 1})});
  const Complex& complex = *built_complex;
  const CellSet closed = closure(complex, region_set(RegionId(1)));
  Selection s;
  s.regions = {{RegionId(1), 1}};
  s = add_component(s, closed, 2);
  CHECK(support(s) == closed);
  CHECK(support(s, 1).size() == 1);
  CHECK(support(s, 2) == subtract(closed, support(s, 1)));
  CHECK(restrict_to(s, support(s, 1)).regions == s.regions);
  CHECK(restrict_to(s, support(s, 1)).faces.empty());
  CHECK(unite(support(s, 1), support(s, 2)) == closed);
  CHECK(intersect(support(s, 1), support(s, 2)).empty());
}

}  // namespace
}  // namespace cnrg
