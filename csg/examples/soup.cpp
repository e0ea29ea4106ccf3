// A soup by hand: a square sheet, a wire through it, a point on it. Refinement cuts them into
// cells that meet only along their boundaries.
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

int main() {
  Soup soup;
  const LeafId sheet = soup.add_leaf(Fill::none), wire = soup.add_leaf(Fill::none),
               point = soup.add_leaf(Fill::none);
  const std::vector<std::vector<PointId>> square{
      {soup.add_point(0, 0, 0), soup.add_point(2, 0, 0), soup.add_point(2, 2, 0), soup.add_point(0, 2, 0)}};
  soup.add_face(sheet, square, 0, 0);  // the leaf's face 0, on its surface 0
  soup.add_wire(wire, soup.add_point(1, 1, -1), soup.add_point(1, 1, 2), 0);
  soup.add_isolated(point, soup.add_point({Rational(1, 3), Rational(1, 3), 0}));

  const auto complex = build_complex(soup);
  std::cout << complex->vertex_count() << " vertices, " << complex->edge_count() << " edges, "
            << complex->face_count() << " faces, " << complex->region_count << " regions\n";
  for (const VertexId v : complex->face_vertices[FaceId(0)]) {  // isolated in the interior of the sheet
    const RationalPoint p = complex->points.rational(v);
    std::cout << "in the sheet: " << p[0] << " " << p[1] << " " << p[2]
              << ", wires there: " << complex->vertex_edges[v].size() << "\n";
  }
  std::cout << "faults: `" << validate(*complex) << "`\n";
}

// Output:
// 8 vertices, 6 edges, 1 faces, 1 regions
// in the sheet: 1/3 1/3 0, wires there: 0
// in the sheet: 1 1 0, wires there: 2
// faults: ``
