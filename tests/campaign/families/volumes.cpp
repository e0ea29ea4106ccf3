// Volumes to the last digit: inclusion and exclusion, and echoes, copies of a solid that nearly coincide with it.
//
// The volume of any Boolean of n solids follows from the volumes of their 2^n - 1 common parts. Of boxes these are
// products of lengths, written down here; of other solids each is evaluated in a tree of its own, so that the
// large tree is held against many small ones, and single solids against the sum over their facets.
#include <algorithm>

#include "tests/campaign/families/families.h"
#include "tests/campaign/families/solids.h"
#include "tests/oracles/cubical_dag.h"
#include "tests/oracles/evaluation.h"
#include "tests/oracles/point_sets.h"

namespace cnrg::campaign {
namespace {

using scenes::Expression;
using scenes::Leaf;
using scenes::Motion;
using scenes::Op;
using scenes::Random;
using scenes::Scene;
using scenes::Solid;

struct Boxes {
  std::vector<std::array<RationalPoint, 2>> corners;
  scenes::ExpressionPtr root;
  Motion place;
};

Rational determinant(const Motion& motion) {
  const auto& m = motion.matrix;
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Scene scene_of(const std::vector<Solid>& solids, const scenes::ExpressionPtr& root) {
  Scene scene;
  for (const Solid& solid : solids) scene.leaves.push_back(scenes::solid_leaf(solid, Fill::winding));
  scene.root = root;
  return scene;
}

std::vector<Solid> solids_of(const Boxes& boxes) {
  std::vector<Solid> out;
  for (const auto& [low, high] : boxes.corners) {
    Solid box = moved(boxes.place, scenes::box_solid(low, high));
    if (determinant(boxes.place) < 0)
      for (scenes::Polygon& facet : box) std::reverse(facet.begin(), facet.end());
    out.push_back(std::move(box));
  }
  return out;
}

bool holds_atom(const Expression& e, std::size_t atom) {
  switch (e.op) {
    case Op::leaf: return (atom >> e.leaf & 1) != 0;
    case Op::unite: return holds_atom(*e.left, atom) || holds_atom(*e.right, atom);
    case Op::intersect: return holds_atom(*e.left, atom) && holds_atom(*e.right, atom);
    default: return holds_atom(*e.left, atom) && !holds_atom(*e.right, atom);
  }
}

/// `common[set]`: the volume that the solids of a set share. Of each atom, what is in these and no others:
/// by inclusion and exclusion.
std::vector<Rational> atoms(std::vector<Rational> common) {
  for (std::size_t bit = 1; bit < common.size(); bit *= 2)
    for (std::size_t set = 0; set < common.size(); ++set)
      if ((set & bit) == 0) common[set] -= common[set | bit];
  return common;
}

/// Every node of the expression has the volume of its atoms.
class Check {
 public:
  Check(const Scene& scene, std::vector<Rational> common)
      : built_(build_complex(scenes::make_soup(scene.leaves), {.threads = 1})),
        groups_(leaf_groups(*built_)),
        atoms_(atoms(std::move(common))) {}

  std::string run(const Expression& e, Group& group) const {
    if (e.op == Op::leaf) {
      group = groups_[e.leaf];
    } else {
      Group a, b;
      if (std::string f = run(*e.left, a); !f.empty()) return f;
      if (std::string f = run(*e.right, b); !f.empty()) return f;
      group =
          boolean_operation(*built_, properties::boolean_op(e.op), properties::dominance(e.ranking), a, b).group;
    }
    if (std::string f = properties::validate(*built_, group); !f.empty()) return "no group: " + f;
    Rational want = 0;
    for (std::size_t atom = 1; atom < atoms_.size(); ++atom)
      if (holds_atom(e, atom)) want += atoms_[atom];
    const Rational have = properties::volume(*built_, group);
    if (have == want) return {};
    const char* const names[] = {"leaf", "union", "intersection", "difference"};
    return std::string("the volume of a ") + names[static_cast<int>(e.op)] + " is " + to_string(have) + ", not " +
           to_string(want);
  }

  std::string valid() const { return cnrg::validate(*built_); }

 private:
  std::shared_ptr<const Complex> built_;
  std::vector<Group> groups_;
  std::vector<Rational> atoms_;
};

std::string check_volumes(const Scene& scene, std::vector<Rational> common) {
  const Check c(scene, std::move(common));
  if (std::string f = c.valid(); !f.empty()) return "the complex is not valid: " + f;
  Group group;
  return c.run(*scene.root, group);
}

Boxes random_boxes(std::uint64_t seed, bool echoes) {
  Random random(seed * 5 + (echoes ? 1 : 0));
  Boxes boxes;
  const int count = random.between(2, 5);
  for (int i = 0; i < count; ++i) {
    RationalPoint low, high;
    if (echoes && i > 0 && !random.one_in(4)) {
      const auto& other = boxes.corners[static_cast<std::size_t>(random.below(i))];
      low = other[0], high = other[1];
      for (int k = 0; k < 3; ++k) {
        const Rational step = random_distance(random);
        low[k] += step;
        high[k] += random.one_in(2) ? step : random_distance(random);
      }
    } else {
      for (int k = 0; k < 3; ++k) {
        low[k] = random.between(0, 4);
        high[k] = low[k] + random.between(1, 3);
      }
    }
    boxes.corners.push_back({low, high});
  }
  boxes.root = random_expression(random, 0, static_cast<std::size_t>(count));
  if (random.one_in(2)) boxes.place = cubical::random_place(seed);
  return boxes;
}

std::string compare_boxes(const Boxes& boxes) {
  const Rational scale = abs(determinant(boxes.place));
  std::vector<Rational> common(std::size_t{1} << boxes.corners.size(), 0);
  for (std::size_t set = 1; set < common.size(); ++set) {
    Rational volume = scale;
    for (int k = 0; k < 3; ++k) {
      std::optional<Rational> low, high;
      for (std::size_t i = 0; i < boxes.corners.size(); ++i) {
        if ((set >> i & 1) == 0) continue;
        low = low ? std::max(*low, boxes.corners[i][0][k]) : boxes.corners[i][0][k];
        high = high ? std::min(*high, boxes.corners[i][1][k]) : boxes.corners[i][1][k];
      }
      volume *= std::max<Rational>(0, *high - *low);
    }
    common[set] = volume;
  }
  return check_volumes(scene_of(solids_of(boxes), boxes.root), std::move(common));
}

std::vector<Boxes> smaller_boxes(const Boxes& boxes) {
  std::vector<Boxes> out;
  Scene scene = scene_of(solids_of(boxes), boxes.root);
  // The scene's own way to lose operations; its leaves tell which boxes are left.
  for (const Scene& less : scenes::smaller(scene)) {
    Boxes next{{}, less.root, boxes.place};
    for (const Leaf& leaf : less.leaves)
      for (std::size_t i = 0; i < scene.leaves.size(); ++i)
        if (leaf.solids == scene.leaves[i].solids) {
          next.corners.push_back(boxes.corners[i]);
          break;
        }
    if (next.corners.size() == less.leaves.size()) out.push_back(std::move(next));
  }
  out.push_back(boxes);
  out.back().place = {};
  if (out.back().place.matrix == boxes.place.matrix && out.back().place.offset == boxes.place.offset)
    out.pop_back();
  return out;
}

struct Solids {
  std::vector<Solid> solids;
  scenes::ExpressionPtr root;
};

Solids random_solids(std::uint64_t seed) {
  Random random(seed * 5 + 2);
  Solids out;
  const int count = random.between(2, 3);
  for (int i = 0; i < count; ++i) {
    if (i > 0 && random.one_in(4)) out.solids.push_back(moved(translation(random_step(random)), out.solids[0]));
    else out.solids.push_back(random_solid(random));
  }
  out.root = random_expression(random, 0, static_cast<std::size_t>(count));
  return out;
}

std::string compare_solids(const Solids& s) {
  std::vector<Rational> common(std::size_t{1} << s.solids.size(), 0);
  for (std::size_t set = 1; set < common.size(); ++set) {
    std::vector<Solid> some;
    scenes::ExpressionPtr all;
    for (std::size_t i = 0; i < s.solids.size(); ++i) {
      if ((set >> i & 1) == 0) continue;
      const auto leaf = scenes::leaf_expression(some.size());
      all = all ? scenes::combine(Op::intersect, scenes::Ranking::equal, all, leaf) : leaf;
      some.push_back(s.solids[i]);
    }
    if (some.size() == 1) {
      common[set] = properties::volume(some[0]);
      continue;
    }
    const Scene scene = scene_of(some, all);
    const auto built = build_complex(scenes::make_soup(scene.leaves), {.threads = 1});
    common[set] = properties::volume(*built, properties::evaluate(*built, leaf_groups(*built), *all));
  }
  return check_volumes(scene_of(s.solids, s.root), std::move(common));
}

/// A convex solid in a slightly larger copy of itself, or the other way round.
struct Nested {
  Solid solid;
  Rational factor;
};

Nested random_nested(std::uint64_t seed) {
  Random random(seed * 5 + 3);
  Nested out;
  do {
    out.solid = random_solid(random);
  } while (!properties::convex(out.solid));
  Rational step = 0;
  while (step == 0) step = random_distance(random);
  out.factor = 1 + step;
  return out;
}

std::vector<Solid> solids_of(const Nested& nested) {
  return {nested.solid, moved(scaling(nested.factor, properties::middle(nested.solid)), nested.solid)};
}

std::string compare_nested(const Nested& nested) {
  const std::vector<Solid> solids = solids_of(nested);
  const Scene scene = scene_of(solids, nullptr);
  const auto built = build_complex(scenes::make_soup(scene.leaves), {.threads = 1});
  const Complex& complex = *built;
  if (std::string f = cnrg::validate(complex); !f.empty()) return "the complex is not valid: " + f;
  const std::vector<Group> g = leaf_groups(complex);
  const std::size_t outer = nested.factor > 1 ? 1 : 0, inner = 1 - outer;
  const Rational volume = properties::volume(nested.solid),
                 other = volume * nested.factor * nested.factor * nested.factor;
  const Rational large = outer == 1 ? other : volume, small = outer == 1 ? volume : other;
  const auto made = [&](BooleanOp op, std::size_t a, std::size_t b) {
    return boolean_operation(complex, op, Dominance::equal, g[a], g[b]).group;
  };
  const Group all = made(BooleanOp::unite, 0, 1), both = made(BooleanOp::intersect, 0, 1),
              shell = made(BooleanOp::subtract, outer, inner), nothing = made(BooleanOp::subtract, inner, outer);
  if (properties::volume(complex, all) != large) return "the union has another volume than the outer solid";
  if (properties::volume(complex, both) != small)
    return "the intersection has another volume than the inner solid";
  if (properties::volume(complex, shell) != large - small) return "the shell has another volume";
  if (!nothing.cells.empty() || nothing.has_entities()) return "something is left of the inner solid";
  if (std::string f = difference(properties::skeleton(complex, all), properties::skeleton(complex, g[outer]));
      !f.empty())
    return "the union and the outer solid:\n" + f;
  if (std::string f = difference(properties::skeleton(complex, both), properties::skeleton(complex, g[inner]));
      !f.empty())
    return "the intersection and the inner solid:\n" + f;
  return {};
}

}  // namespace

void add_volumes(Families& families) {
  const auto boxes = [&](const char* name, const char* oracle, double share, bool echoes) {
    Recipe<Boxes> recipe;
    recipe.name = name;
    recipe.oracle = oracle;
    recipe.share = share;
    recipe.make = [=](std::uint64_t seed) { return random_boxes(seed, echoes); };
    recipe.compare = compare_boxes;
    recipe.smaller = smaller_boxes;
    recipe.text = [](const Boxes& b) { return scenes::tree_file(scene_of(solids_of(b), b.root)); };
    add(families, recipe);
  };
  boxes("volumes-boxes", "inclusion and exclusion, by hand", 3, false);
  boxes("echoes-boxes", "inclusion and exclusion, by hand", 1, true);

  Recipe<Solids> solids;
  solids.name = "volumes-solids";
  solids.oracle = "inclusion and exclusion over small trees";
  solids.share = 1;
  solids.make = random_solids;
  solids.compare = compare_solids;
  solids.smaller = [](const Solids& s) {
    std::vector<Solids> out;
    const Scene scene = scene_of(s.solids, s.root);
    for (const Scene& less : scenes::smaller(scene)) {
      Solids next{{}, less.root};
      for (const Leaf& leaf : less.leaves)
        if (!leaf.solids.empty()) next.solids.push_back(leaf.solids[0]);
      if (next.solids.size() == less.leaves.size() && next.solids.size() < s.solids.size())
        out.push_back(std::move(next));
    }
    return out;
  };
  solids.text = [](const Solids& s) { return scenes::tree_file(scene_of(s.solids, s.root)); };
  add(families, solids);

  Recipe<Nested> nested;
  nested.name = "echoes-nested";
  nested.oracle = "a solid in a larger copy: volumes, cells";
  nested.share = 1.5;
  nested.make = random_nested;
  nested.compare = compare_nested;
  nested.smaller = [](const Nested&) { return std::vector<Nested>(); };
  nested.text = [](const Nested& n) {
    return scenes::tree_file(scene_of(
        solids_of(n),
        scenes::combine(Op::subtract, scenes::Ranking::equal, scenes::leaf_expression(n.factor > 1 ? 1 : 0),
                        scenes::leaf_expression(n.factor > 1 ? 0 : 1))));
  };
  add(families, nested);
}

}  // namespace cnrg::campaign
