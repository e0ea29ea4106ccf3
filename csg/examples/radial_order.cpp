// Around an edge that two boxes share: four faces in radial order, and the region in each wedge between them.
//
// The order is counter-clockwise as seen with the edge pointing towards the viewer (Weiler 1986).
#include <cnrg.h>

#include <iostream>

using namespace cnrg;

int main() {
  const auto complex = build_complex(
      make_soup({{prepare(BoxShape{{0, 0, 0}, {1, 1, 1}})}, {prepare(BoxShape{{1, 1, 0}, {2, 2, 1}})}}));
  for (const EdgeId e : IdRange<EdgeId>(complex->edge_count())) {
    const std::span<const FaceUse> uses = complex->edge_uses[e];
    if (uses.size() == 2) continue;
    const auto [from, to] = complex->edge_ends[e];
    std::cout << "edge from";
    for (const Rational& x : complex->points.rational(from)) std::cout << " " << x;
    std::cout << " to";
    for (const Rational& x : complex->points.rational(to)) std::cout << " " << x;
    std::cout << "\n";
    for (const FaceUse& use : uses) {
      const LeafId leaf = complex->sources[complex->cover(use.face).front().source].leaf;
      const RationalPoint normal = area_vector(*complex, use.face);  // of the front
      std::cout << "  face of box " << leaf.value() << ", normal " << normal[0] << " " << normal[1] << " "
                << normal[2];
      const RegionId wedge = complex->region(use.after());
      if (complex->labels(wedge).empty()) std::cout << ", then outside";
      for (const Label& label : complex->labels(wedge)) std::cout << ", then box " << label.leaf.value();
      std::cout << "\n";
    }
  }
}

// Output:
// edge from 1 1 0 to 1 1 1
//   face of box 0, normal 1 0 0, then outside
//   face of box 1, normal 0 1 0, then box 1
//   face of box 1, normal 1 0 0, then outside
//   face of box 0, normal 0 1 0, then box 0
