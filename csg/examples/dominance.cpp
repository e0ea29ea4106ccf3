// The union of two overlapping boxes under each dominance: the walls that remain, and what each row of the tables
// removed. The dominant operand keeps its walls inside of the other; equal ones melt into one region.
#include <cnrg.h>

#include <iostream>
#include <utility>

using namespace cnrg;

int main() {
  const auto complex = build_complex(
      make_soup({{prepare(BoxShape{{0, 0, 0}, {2, 2, 2}})}, {prepare(BoxShape{{1, 1, 1}, {3, 3, 3}})}}));
  const std::vector<Group> groups = leaf_groups(*complex, {{{.name = "a"}}, {{.name = "b"}}});
  for (const auto& [title, dominance] : {std::pair("left", Dominance::left), std::pair("right", Dominance::right),
                                         std::pair("equal", Dominance::equal)}) {
    std::cout << title << "\n";
    const auto done = boolean_operation(*complex, BooleanOp::unite, dominance, groups[0], groups[1]);
    const Result result(complex, done.group);
    for (Component i = 1; i <= done.group.regions.size(); ++i) {
      std::cout << "  region " << result.attributes(i).name.text() << ", volume " << *result.volume(i) << "\n";
    }
    for (const auto& [row, count] : done.removals)
      std::cout << "  " << table_rows()[row].id << " removed " << count << "\n";
  }
}

// Output:
// left
//   region a, volume 8
//   region b, volume 7
//   union.face.BinA.dominant removed 3
//   union.edge.BinA.dominant removed 3
//   union.vertex.BinA.dominant removed 1
// right
//   region a, volume 7
//   region b, volume 8
//   union.face.BinA.dominant removed 3
//   union.edge.BinA.dominant removed 3
//   union.vertex.BinA.dominant removed 1
// equal
//   region a, volume 15
//   union.face.AinB.equal removed 3
//   union.face.BinA.equal removed 3
//   union.edge.AinB.equal removed 3
//   union.edge.BinA.equal removed 3
//   union.vertex.AinB.equal removed 1
//   union.vertex.BinA.equal removed 1
