// Random leaves and trees, and how a failing one is made smaller.
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

ExpressionPtr random_expression(Random& random, std::size_t first, std::size_t count) {
  if (count == 1) return leaf_expression(first);
  const std::size_t left = 1 + static_cast<std::size_t>(random.below(static_cast<int>(count) - 1));
  return combine(static_cast<Op>(1 + random.below(3)), static_cast<Ranking>(random.below(3)),
                 random_expression(random, first, left), random_expression(random, first + left, count - left));
}

/// The leaves that an expression names get new numbers in the order of their use; others go.
Scene compact(const Scene& scene, const ExpressionPtr& root) {
  Scene result;
  const auto rebuild = [&](auto&& self, const Expression& e) -> ExpressionPtr {
    if (e.op != Op::leaf) {
      ExpressionPtr left = self(self, *e.left);
      return combine(e.op, e.ranking, std::move(left), self(self, *e.right));
    }
    result.leaves.push_back(scene.leaves[e.leaf]);
    return leaf_expression(result.leaves.size() - 1);
  };
  result.root = rebuild(rebuild, *root);
  return result;
}

/// All expressions that have one operation less.
std::vector<ExpressionPtr> dropped(const ExpressionPtr& e) {
  std::vector<ExpressionPtr> result;
  if (e->op == Op::leaf) return result;
  result.push_back(e->left);
  result.push_back(e->right);
  for (const ExpressionPtr& l : dropped(e->left)) result.push_back(combine(e->op, e->ranking, l, e->right));
  for (const ExpressionPtr& r : dropped(e->right)) result.push_back(combine(e->op, e->ranking, e->left, r));
  return result;
}

}  // namespace

std::uint64_t Random::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

Scene random_scene(std::uint64_t seed, int leaf_count, Position position) {
  Random random(seed);
  Scene scene;
  for (int i = 0; i < leaf_count; ++i) {
    scene.leaves.push_back(random_leaf(random, position == Position::general ? 20 : 5));
    if (position == Position::general) {
      Motion motion = random_rotation(random);
      // About the middle of the box of coordinates, so that leaves still meet.
      const RationalPoint middle{10, 10, 10}, turned = motion(middle);
      for (int k = 0; k < 3; ++k) motion.offset[k] = middle[k] - turned[k];
      apply(motion, scene.leaves.back());
    }
  }
  if (position == Position::tilted) apply(random_rotation(random), scene);
  scene.root = random_expression(random, 0, scene.leaves.size());
  return scene;
}

std::vector<Scene> smaller(const Scene& scene) {
  std::vector<Scene> result;
  for (const ExpressionPtr& e : dropped(scene.root)) result.push_back(compact(scene, e));
  for (std::size_t l = 0; l < scene.leaves.size(); ++l) {
    const auto try_leaf = [&](const Leaf& leaf) {
      Scene s = scene;
      s.leaves[l] = leaf;
      result.push_back(std::move(s));
    };
    const Leaf& leaf = scene.leaves[l];
    for (std::size_t i = 0; i < leaf.wires.size(); ++i) {
      Leaf less = leaf;
      less.wires.erase(less.wires.begin() + static_cast<std::ptrdiff_t>(i));
      try_leaf(less);
    }
    for (std::size_t i = 0; i < leaf.points.size(); ++i) {
      Leaf less = leaf;
      less.points.erase(less.points.begin() + static_cast<std::ptrdiff_t>(i));
      try_leaf(less);
    }
    for (std::size_t i = 0; i < leaf.faces.size(); ++i) {
      if (!leaf.faces[i].sheet) continue;
      Leaf less = leaf;
      less.faces.erase(less.faces.begin() + static_cast<std::ptrdiff_t>(i));
      try_leaf(less);
    }
  }
  return result;
}

}  // namespace cnrg::scenes
