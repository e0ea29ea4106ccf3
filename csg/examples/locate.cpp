// Exact point location: the cell of a node that holds a point with rational coordinates, and its component.
// A sloped seam parts a block of ground. The middle of the block is on the seam, a billionth beside it is not.
#include <cnrg.h>

#include <iostream>
#include <sstream>

using namespace cnrg;

int main() {
  const Result model = evaluate(parse_tree(R"(cnrg: 1
nodes:
  ground: {box: {min: [0, 0, 0], max: [1, 1, 1]}, name: ground}
  seam:   {polygon: [["1/3", 0, 0], ["1/3", 1, 0], ["2/3", 1, 1], ["2/3", 0, 1]]}
  bolt:   {polyline: [[1, "1/2", "1/2"], [2, "1/2", "1/2"]]}
  model:  {union: [bolt, {union: [seam, ground], dominance: left}]}
result: model
)",
                                           "model.yaml"))
                           .result();
  const Locator locator(model.complex());
  std::istringstream points(
      "0 0 0  1/3 1/2 0  1/2 1/2 1/2  500000001/1000000000 1/2 1/2  1/3 1/3 1/3  4/3 1/2 1/2  1 1/3 1/3  2 2 2");
  for (RationalPoint p; points >> p[0] >> p[1] >> p[2];) {
    const SimplifiedComplex::Place place = model.place(locator.locate(p));
    const Component component = model.component(place);
    std::cout << p[0] << " " << p[1] << " " << p[2] << ": dimension " << place.dimension << ", "
              << cell_name(place.dimension, place.index) << ", "
              << (component == 0 ? "inactive" : model.attributes(component).name.text()) << "\n";
  }
}

// Output:
// 0 0 0: dimension 0, v0, entities
// 1/3 1/2 0: dimension 1, e8, entities
// 1/2 1/2 1/2: dimension 2, f5, entities
// 500000001/1000000000 1/2 1/2: dimension 3, r2, ground
// 1/3 1/3 1/3: dimension 3, r0, ground
// 4/3 1/2 1/2: dimension 1, e19, entities
// 1 1/3 1/3: dimension 2, f10, entities
// 2 2 2: dimension 3, r1, inactive
