// Interior, closure, boundary and regularization of a set that is neither open nor closed: a box without a sheet
// that cuts it in part. The sheet is a crack; closing the set heals it, regularizing its interior too.
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

void print(const char* title, const CellSet& set) {
  std::cout << title << ": " << set.vertices.size() << " vertices, " << set.edges.size() << " edges, "
            << set.faces.size() << " faces, " << set.regions.size() << " regions\n";
}

int main() {
  const auto sheet = prepare(PolygonShape{{{1, 0, 0}, {1, 1, 0}, {1, 1, 2}, {1, 0, 2}}, {}});
  const auto complex = build_complex(make_soup({{prepare(BoxShape{{0, 0, 0}, {2, 2, 2}})}, {sheet}}));
  const std::vector<Group> groups = leaf_groups(*complex);
  const Components x = components_of(*complex, groups[0]), y = components_of(*complex, groups[1]);
  const Components cracked = subtract(*complex, x, y).value;
  const CellSet set = support(cracked.selection);
  print("box - sheet", set);
  print("interior", interior(*complex, set));
  print("closure", closure(*complex, set));
  print("boundary", boundary(*complex, set));
  // The same on components, which keep their names.
  for (const Topological op : {Topological::closure, Topological::regularize}) {
    const Components result = topological_operation(*complex, op, cracked).value;
    std::cout << name(op) << " has " << result.attributes.size() << " components, " << cracked.attributes.size()
              << " before\n";
  }
}

// Output:
// box - sheet: 8 vertices, 14 edges, 7 faces, 1 regions
// interior: 0 vertices, 0 edges, 0 faces, 1 regions
// closure: 12 vertices, 18 edges, 8 faces, 1 regions
// boundary: 12 vertices, 18 edges, 8 faces, 0 regions
// closure has 3 components, 2 before
// regularize has 3 components, 2 before
