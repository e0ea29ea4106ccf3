// Leaves from shapes, without a tree file, and their exact volumes.
//
// A shape is data; `prepare` checks it and makes its geometry; an instance is that geometry under an exact
// transform. A rotation by an angle is a rational one next to it, exactly orthogonal: it keeps volumes.
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

int main() {
  const auto plate = prepare(PrismShape{.base = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}},
                                        .holes = {{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}},
                                        .vector = {0, 0, Rational(1, 3)}});
  const auto roof = prepare(TetrahedronShape{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  const Transform turn = Transform::rotation({0, 0, 1}, 30, {0, 0, 0});
  const Transform shift = Transform::translation({9, 0, 0});
  const auto complex = build_complex(make_soup({{plate}, {plate, turn}, {roof, shift}}));
  for (const Group& group : leaf_groups(*complex)) {
    const Result leaf(complex, group);  // of one region: others cut it into several cells
    std::cout << group.cells.size() << " cells, volume " << *leaf.volume(1) << "\n";
  }
}

// Output:
// 4 cells, volume 8/3
// 4 cells, volume 8/3
// 1 cells, volume 1/6
