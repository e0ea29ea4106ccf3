// Random leaves, and how those that fail are made smaller.
#include <algorithm>

#include "tests/scenes/scene.h"

namespace cnrg::scenes {
namespace {

RationalPoint grid_point(Random& random, int size) {
  return {random.between(0, size), random.between(0, size), random.between(0, size)};
}

RationalPoint plus(const RationalPoint& p, int x, int y, int z) { return {p[0] + x, p[1] + y, p[2] + z}; }

/// Corners of a box with edges of at least `least`.
std::array<RationalPoint, 2> random_box(Random& random, int size, int least) {
  const RationalPoint low = grid_point(random, size - least);
  RationalPoint high;
  for (int k = 0; k < 3; ++k) {
    const int room = size - static_cast<int>(low[k].get_d());
    high[k] = low[k] + random.between(least, std::max(least, std::min(room, size / 2 + 1)));
  }
  return {low, high};
}

std::array<RationalPoint, 4> random_tetrahedron(Random& random, int size) {
  for (;;) {
    std::array<RationalPoint, 4> c;
    for (auto& p : c) p = grid_point(random, size);
    std::array<RationalPoint, 3> d;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) d[i][k] = c[i + 1][k] - c[0][k];
    const Rational det = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                         d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                         d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    if (det != 0) return c;
  }
}

/// An L or a triangle in a coordinate plane, as a base; `unit` is the step of its corners.
Polygon random_base(Random& random, const RationalPoint& o, int unit) {
  const int u = unit * random.between(1, 2), v = unit * random.between(1, 2);
  if (random.one_in(2)) return {o, plus(o, u, 0, 0), plus(o, 0, v, 0)};
  return {
      o, plus(o, 2 * u, 0, 0), plus(o, 2 * u, v, 0), plus(o, u, v, 0), plus(o, u, 2 * v, 0), plus(o, 0, 2 * v, 0)};
}

void cycle_axes(Leaf& leaf, int times) {
  Motion turn;
  turn.matrix = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  for (int i = 0; i < times; ++i) apply(turn, leaf);
}

Fill random_fill(Random& random) {
  constexpr std::array<Fill, 4> fills{Fill::sides, Fill::winding, Fill::parity, Fill::cells};
  return fills[static_cast<std::size_t>(random.below(4))];
}

void add_random_sheet(Leaf& leaf, Random& random, int size) {
  const int unit = std::max(1, size / 5);
  if (random.one_in(3)) {
    const auto t = random_tetrahedron(random, size);
    add_sheet(leaf, {{t[0], t[1], t[2]}});
    return;
  }
  const RationalPoint o = grid_point(random, size / 2);
  if (random.one_in(2)) {
    const int w = unit * random.between(1, 3), h = unit * random.between(1, 3);
    Polygon outer{o, plus(o, w, 0, 0), plus(o, w, h, 0), plus(o, 0, h, 0)};
    std::vector<Polygon> loops{outer};
    if (w >= 3 && h >= 3 && random.one_in(2)) {
      loops.push_back({plus(o, 1, 1, 0), plus(o, 1, 2, 0), plus(o, 2, 2, 0), plus(o, 2, 1, 0)});
      if (random.one_in(2)) std::reverse(loops.back().begin(), loops.back().end());
    }
    add_sheet(leaf, std::move(loops));
  } else {
    add_sheet(leaf, {random_base(random, o, unit)});
  }
}

void add_random_wires(Leaf& leaf, Random& random, int size) {
  RationalPoint at = grid_point(random, size);
  for (int i = random.between(1, 3); i > 0; --i) {
    RationalPoint to = grid_point(random, size);
    if (random.one_in(2)) {  // along an axis
      const int keep = random.below(3);
      for (int k = 0; k < 3; ++k)
        if (k != keep) to[k] = at[k];
    }
    if (to == at) continue;
    leaf.wires.push_back({at, to});
    at = to;
  }
  if (leaf.wires.empty()) leaf.points.push_back(at);
}

/// A crack: a rectangle inside region 1 of a leaf, half a unit above the bottom of its box.
void add_crack(Leaf& leaf, Random& random, const RationalPoint& low, const RationalPoint& high) {
  const auto inside = [&](int k) -> Rational { return low[k] + (high[k] - low[k]) * random.between(0, 2) / 4; };
  const Rational x = inside(0), y = inside(1), z = low[2] + Rational(1, 2);
  const Rational u = (x + high[0]) / 2, v = random.one_in(2) ? high[1] : Rational((y + high[1]) / 2);
  add_sheet(leaf, {{{x, y, z}, {u, y, z}, {u, v, z}, {x, v, z}}});
  leaf.faces.back().front = leaf.faces.back().back = 1;
}

Leaf random_leaf(Random& random, int size) {
  const int unit = std::max(1, size / 5);
  Leaf leaf;
  switch (random.below(10)) {
    case 0:
    case 1:
    case 2: {
      const auto [low, high] = random_box(random, size, unit);
      leaf = solid_leaf(box_solid(low, high), random_fill(random));
      if (leaf.fill == Fill::sides) add_crack(leaf, random, low, high);
      break;
    }
    case 3:
    case 4: leaf = solid_leaf(tetrahedron_solid(random_tetrahedron(random, size)), random_fill(random)); break;
    case 5: {
      const RationalPoint o = grid_point(random, size / 2);
      leaf = solid_leaf(prism_solid(random_base(random, o, unit), {0, 0, unit * random.between(1, 3)}),
                        random_fill(random));
      break;
    }
    case 6: {
      const auto [low, high] = random_box(random, size, 2 * unit);
      leaf = layered_leaf(low, high, {low[2] + unit});
      if (random.one_in(3)) add_crack(leaf, random, low, high);
      break;
    }
    case 7:
    case 8: add_random_sheet(leaf, random, size); break;
    default: add_random_wires(leaf, random, size); break;
  }
  cycle_axes(leaf, random.below(3));
  if (random.one_in(3)) {
    if (random.one_in(2)) add_random_wires(leaf, random, size);
    else leaf.points.push_back(grid_point(random, size));
  }
  return leaf;
}

Motion random_rotation(Random& random) {
  for (;;) {
    const int w = random.between(1, 4), x = random.between(-3, 3), y = random.between(-3, 3),
              z = random.between(-3, 3);
    if (x * x + y * y + z * z > 0) return Motion::rotation(w, x, y, z);
  }
}

/// The leaf with less in it, but for nothing at all.
std::vector<Leaf> smaller_leaf(const Leaf& leaf) {
  std::vector<Leaf> out;
  if (!leaf.solids.empty()) {  // a solid alone, or what is there besides solids
    Leaf less = leaf;
    less.solids.clear();
    less.fill = Fill::sides;
    std::erase_if(less.faces, [](const Face& f) { return !f.sheet; });
    for (Face& f : less.faces) f.front = f.back = 0;
    out.push_back(std::move(less));
    if (leaf.solids.size() > 1)
      for (const Solid& solid : leaf.solids) out.push_back(solid_leaf(solid));
  }
  const auto change = [&](auto edit) {
    out.push_back(leaf);
    edit(out.back());
  };
  for (std::size_t i = 0; i < leaf.wires.size(); ++i) change([&](Leaf& l) { l.wires = without(l.wires, i); });
  for (std::size_t i = 0; i < leaf.points.size(); ++i) change([&](Leaf& l) { l.points = without(l.points, i); });
  for (std::size_t i = 0; i < leaf.faces.size(); ++i) {
    if (!leaf.faces[i].sheet) continue;
    change([&](Leaf& l) { l.faces = without(l.faces, i); });
    for (std::size_t h = 1; h < leaf.faces[i].loops.size(); ++h)
      change([&](Leaf& l) { l.faces[i].loops = without(l.faces[i].loops, h); });
  }
  std::erase_if(out, [](const Leaf& l) { return l.faces.empty() && l.wires.empty() && l.points.empty(); });
  return out;
}

}  // namespace

std::uint64_t Random::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

std::vector<Leaf> random_leaves(std::uint64_t seed, int count, Position position) {
  Random random(seed);
  std::vector<Leaf> leaves;
  for (int i = 0; i < count; ++i) {
    leaves.push_back(random_leaf(random, position == Position::general ? 20 : 5));
    if (position == Position::general) {
      Motion motion = random_rotation(random);
      // About the middle of the box of coordinates, so that leaves still meet.
      const RationalPoint middle{10, 10, 10}, turned = motion(middle);
      for (int k = 0; k < 3; ++k) motion.offset[k] = middle[k] - turned[k];
      apply(motion, leaves.back());
    }
  }
  if (position == Position::tilted) apply_to_all(random_rotation(random), leaves);
  return leaves;
}

std::vector<std::vector<Leaf>> smaller(const std::vector<Leaf>& leaves) {
  std::vector<std::vector<Leaf>> out;
  for (std::size_t l = 0; l < leaves.size(); ++l)
    for (Leaf& less : smaller_leaf(leaves[l])) {
      out.push_back(leaves);
      out.back()[l] = std::move(less);
    }
  return out;
}

}  // namespace cnrg::scenes
