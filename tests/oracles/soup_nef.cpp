#include "tests/oracles/soup_nef.h"

#include "tests/oracles/evaluation.h"
#include "tests/scenes/measure.h"

namespace cnrg::properties {
namespace {

using scenes::Leaf;
using scenes::Random;

RationalPoint grid_point(Random& random, int size) {
  return {random.between(0, size), random.between(0, size), random.between(0, size)};
}

bool on_a_line(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3;
    if ((b[k] - a[k]) * (c[i] - a[i]) != (b[i] - a[i]) * (c[k] - a[k])) return false;
  }
  return true;
}

/// All cells up to dimension 2, as a group without regions.
Group walls(const Complex& c) {
  Group g;
  for (const FaceId f : IdRange<FaceId>(c.face_count())) g.faces.push_back(f);
  for (const EdgeId e : IdRange<EdgeId>(c.edge_count())) g.edges.push_back(e);
  g.vertices = c.vertices;
  return g;
}

}  // namespace

std::vector<Leaf> random_soup(std::uint64_t seed, int parts, int size) {
  Random random(seed);
  std::vector<Leaf> leaves(1 + static_cast<std::size_t>(random.below(3)));
  for (Leaf& leaf : leaves) leaf.fill = random.one_in(2) ? Fill::none : Fill::cells;
  for (int i = 0; i < parts; ++i) {
    Leaf& leaf = leaves[static_cast<std::size_t>(random.below(static_cast<int>(leaves.size())))];
    const RationalPoint a = grid_point(random, size), b = grid_point(random, size), c = grid_point(random, size);
    switch (random.below(8)) {
      case 0: leaf.points.push_back(a); break;
      case 1:
      case 2:
        if (a != b) leaf.wires.push_back({a, b});
        break;
      case 3: {  // a parallelogram, which may stick out of the grid
        if (on_a_line(a, b, c)) break;
        RationalPoint d;
        for (int k = 0; k < 3; ++k) d[k] = a[k] + c[k] - b[k];
        scenes::add_sheet(leaf, {{a, b, c, d}});
        break;
      }
      default:
        if (!on_a_line(a, b, c)) scenes::add_sheet(leaf, {{a, b, c}});
        break;
    }
  }
  if (random.one_in(2)) {
    const scenes::Motion turn = scenes::Motion::rotation(3, random.between(1, 3), random.between(-2, 2), -1);
    for (Leaf& leaf : leaves) apply(turn, leaf);
  }
  return leaves;
}

std::string compare_soup_with_nef(const std::vector<Leaf>& leaves) {
  const auto built_c = build_complex(scenes::make_soup(leaves));
  const Complex& c = *built_c;
  if (std::string f = cnrg::validate(c); !f.empty()) return "the complex is not valid: " + f;
  std::vector<NefSet> sets;
  for (const Leaf& leaf : leaves) sets.push_back(NefSet::leaf(leaf));
  const NefSet all = NefSet::unite_all(std::move(sets));
  const Skeleton ours = skeleton(c, walls(c)), theirs = all.skeleton();
  if (std::string f = difference(ours, theirs); !f.empty()) return "ours first, then Nef's:\n" + f;
  // Filled, cavity by cavity: all bounded regions of ours and of Nef.
  std::vector<RationalPoint> inside;
  Rational volume = 0;
  for (const RegionId r : IdRange<RegionId>(c.region_count)) {
    if (c.unbounded(r)) continue;
    inside.push_back(scenes::point_in(c, r));
    volume += scenes::volume(c, r);
  }
  if (!inside.empty() && all.fill(inside).volume() != volume) return "the cavities have another volume";
  return {};
}

}  // namespace cnrg::properties
