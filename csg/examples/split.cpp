// From shapes to a file without a tree: a block, parted by a sheet, written for ParaView.
//
// This is the program of csg/README.md#the-library-from-c.
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

int main() {
  const auto block = prepare(BoxShape{{0, 0, 0}, {3, 3, 3}});
  const auto sheet = prepare(PolygonShape{{{1, 0, 0}, {2, 0, 3}, {2, 3, 3}, {1, 3, 0}}, {}});
  const auto complex = build_complex(make_soup({{block}, {sheet}}));
  const std::vector<Group> leaves = leaf_groups(*complex);
  const Group split = boolean_operation(*complex, BooleanOp::unite, Dominance::right, leaves[0], leaves[1]).group;
  const Result result(complex, split, {.result = "split", .leaves = {"block", "sheet"}});
  for (Component i = 1; i <= split.regions.size(); ++i) {
    std::cout << "region " << i << " has the volume " << *result.volume(i) << "\n";
  }
  write("split.vtu", result);
}

// Output:
// region 1 has the volume 27/2
// region 2 has the volume 27/2
