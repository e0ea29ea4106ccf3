// One value in three forms. Two boxes side by side become one region.
//
// raw: the cells of the common refinement; features: cuts of the refinement are gone, borders between faces of
// leaves stay; points: all that the point set does not need is gone.
#include <cnrg.h>

#include <iostream>
#include <utility>

using namespace cnrg;

int main() {
  // Only in the complex: it cuts the cells of the second box.
  const auto cut = prepare(PolygonShape{{{2, -1, -1}, {2, 2, -1}, {2, 2, 2}, {2, -1, 2}}, {}});
  const auto complex = build_complex(
      make_soup({{prepare(BoxShape{{0, 0, 0}, {1, 1, 1}})}, {prepare(BoxShape{{1, 0, 0}, {3, 1, 1}})}, {cut}}));
  const std::vector<Group> groups = leaf_groups(*complex);
  const Group both = boolean_operation(*complex, BooleanOp::unite, Dominance::equal, groups[0], groups[1]).group;
  for (const auto& [name, mode] :
       {std::pair("raw", SimplifyMode::raw), std::pair("features", SimplifyMode::features),
        std::pair("points", SimplifyMode::points)}) {
    const Result result(complex, both, {}, mode);
    std::cout << name << ":";
    for (const std::size_t count : active_counts(result.cells())) std::cout << " " << count;
    std::cout << "\n";
    for (const SimplifiedComplex::Region& region : result.cells().regions) {
      if (region.component == 0) continue;
      std::cout << "  region of " << region.cells.size() << " cells, volume " << *volume(*complex, region.cells)
                << "\n";
    }
  }
}

// Output:
// raw: 16 28 16 3
//   region of 1 cells, volume 1
//   region of 1 cells, volume 1
//   region of 1 cells, volume 1
// features: 12 20 10 1
//   region of 3 cells, volume 3
// points: 8 12 6 1
//   region of 3 cells, volume 3
