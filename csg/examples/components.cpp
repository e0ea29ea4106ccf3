// Operators of Constructive Non-Regularized Geometry: sum and product of two boxes.
//
// As their operand a group is its components: each region, and all entities (here the walls) together as one more.
// The result has a component for each way in which components of the operands meet.
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

void print(const char* title, const Complex& complex, const Components& value) {
  std::cout << title << "\n";
  for (Component i = 1; i <= value.attributes.size(); ++i) {
    const auto [vertices, edges, faces, regions] = support(value.selection, i);
    std::cout << "  " << value.attributes[i - 1].name.text() << ": " << vertices.size() << " vertices, "
              << edges.size() << " edges, " << faces.size() << " faces, volume " << *volume(complex, regions)
              << "\n";
  }
}

int main() {
  const auto complex = build_complex(
      make_soup({{prepare(BoxShape{{0, 0, 0}, {2, 2, 2}})}, {prepare(BoxShape{{1, 1, 1}, {3, 3, 3}})}}));
  const std::vector<Group> groups = leaf_groups(*complex, {{{.name = "a"}}, {{.name = "b"}}});
  const Components x = components_of(*complex, groups[0]), y = components_of(*complex, groups[1]);
  print("a", *complex, x);
  print("sum", *complex, sum(*complex, x, y).value);
  print("product", *complex, product(*complex, x, y).value);
  print("unify(sum)", *complex, unify(*complex, sum(*complex, x, y).value).value);
}

// Output:
// a
//   a: 1 vertices, 3 edges, 3 faces, volume 8
//   entities: 14 vertices, 21 edges, 9 faces, volume 0
// sum
//   a: 0 vertices, 0 edges, 0 faces, volume 7
//   entities: 7 vertices, 12 edges, 6 faces, volume 0
//   a & b: 0 vertices, 0 edges, 0 faces, volume 1
//   a: 1 vertices, 3 edges, 3 faces, volume 0
//   b: 1 vertices, 3 edges, 3 faces, volume 0
//   entities: 6 vertices, 6 edges, 0 faces, volume 0
//   b: 0 vertices, 0 edges, 0 faces, volume 7
//   entities: 7 vertices, 12 edges, 6 faces, volume 0
// product
//   a & b: 0 vertices, 0 edges, 0 faces, volume 1
//   a: 1 vertices, 3 edges, 3 faces, volume 0
//   b: 1 vertices, 3 edges, 3 faces, volume 0
//   entities: 6 vertices, 6 edges, 0 faces, volume 0
// unify(sum)
//   a & b: 22 vertices, 36 edges, 18 faces, volume 15
