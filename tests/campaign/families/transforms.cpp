// Transforms of nodes: a tree below `translate`, `scale`, `mirror` and `rotate` is the tree of leaves with the
// mapped coordinates. The maps are made here from their definitions, not by the program's matrices.
#include <algorithm>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/node_value.h"
#include "tests/campaign/families/families.h"
#include "tests/oracles/cubical_pair.h"
#include "tests/oracles/dag_values.h"
#include "tests/oracles/evaluation.h"

namespace cnrg::campaign {
namespace {

using properties::RandomDag;
using scenes::Motion;
using scenes::Random;

struct Step {
  std::string text;  ///< `translate: [1, 2, 3]`
  Motion motion;
};

struct Moved {
  RandomDag dag;
  std::vector<Step> steps;  ///< one of a kind, in the order in which they act
};

std::string coordinates_text(const RationalPoint& p) {
  return "[\"" + to_string(p[0]) + "\", \"" + to_string(p[1]) + "\", \"" + to_string(p[2]) + "\"]";
}

/// p -> m (p - center) + center.
Motion about(Motion motion, const RationalPoint& center) {
  motion.offset = {0, 0, 0};
  const RationalPoint image = motion(center);
  for (int k = 0; k < 3; ++k) motion.offset[k] = center[k] - image[k];
  return motion;
}

Step random_move_step(Random& random, int kind) {
  const auto number = [&]() -> Rational { return Rational(random.between(-6, 6)) / random.between(1, 5); };
  const auto point = [&] { return RationalPoint{number(), number(), number()}; };
  Step step;
  switch (kind) {
    case 0:
      step.motion.offset = point();
      step.text = "translate: " + coordinates_text(step.motion.offset);
      break;
    case 1: {
      RationalPoint factors;
      for (Rational& x : factors) {
        do {
          x = number();
        } while (x == 0);
      }
      for (int k = 0; k < 3; ++k) step.motion.matrix[k][k] = factors[k];
      step.text = "scale: " + coordinates_text(factors);
      break;
    }
    case 2: {
      RationalPoint normal, at = point();
      do {
        normal = {random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)};
      } while (normal == RationalPoint{0, 0, 0});
      const Rational square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          step.motion.matrix[i][k] = (i == k ? 1 : 0) - 2 * normal[i] * normal[k] / square;
      step.motion = about(step.motion, at);
      step.text = "mirror: {normal: " + coordinates_text(normal) + ", point: " + coordinates_text(at) + "}";
      break;
    }
    default: {
      // A quarter turn about axis k takes axis u to axis v.
      const int k = random.below(3), u = (k + 1) % 3, v = (k + 2) % 3, quarters = random.between(1, 3);
      const int cosine = quarters == 2 ? -1 : 0, sine = quarters == 1 ? 1 : quarters == 3 ? -1 : 0;
      step.motion.matrix[u][u] = step.motion.matrix[v][v] = cosine;
      step.motion.matrix[v][u] = sine;
      step.motion.matrix[u][v] = -sine;
      const RationalPoint center = point();
      step.motion = about(step.motion, center);
      RationalPoint axis{0, 0, 0};
      axis[k] = 1;
      step.text = "rotate: {axis: " + coordinates_text(axis) + ", degrees: " + std::to_string(90 * quarters) +
                  ", center: " + coordinates_text(center) + "}";
    }
  }
  return step;
}

Moved random_moved(std::uint64_t seed) {
  Random random(seed * 7 + 5);
  Moved out;
  out.dag = properties::random_dag(seed + 900'000'000, properties::position_of(seed));
  const int first = random.below(4), count = random.between(1, 3), stride = random.one_in(2) ? 1 : 3;
  for (int i = 0; i < count; ++i) out.steps.push_back(random_move_step(random, (first + i * stride) % 4));
  return out;
}

std::string moved_text(const Moved& moved) {
  std::string out = properties::tree_file(moved.dag);
  const std::string last = properties::name_of(moved.dag, moved.dag.nodes.size() - 1);
  out.erase(out.rfind("result: "));
  out += "  moved: {simplify: " + last;
  for (const Step& step : moved.steps) out += ", " + step.text;
  return out + "}\nresult: moved\n";
}

std::string compare_moved(const Moved& moved) {
  RandomDag mapped = moved.dag;
  for (scenes::Leaf& leaf : mapped.leaves)
    for (const Step& step : moved.steps) cubical::place(step.motion, leaf);
  EvaluateOptions options;
  options.threads = 1;
  options.validate = true;
  options.region_volumes = true;
  const Evaluation a = evaluate(parse_tree(moved_text(moved), "moved.yaml"), options),
                   b = evaluate(parse_tree(properties::tree_file(mapped), "mapped.yaml"), options);
  const NodeValue &x = *a.kept.front().value, &y = *b.kept.front().value;
  const Selection sx = selection_of(*a.complex, x), sy = selection_of(*b.complex, y);
  if (std::string f = properties::difference(properties::skeleton(*a.complex, properties::joined(sx)),
                                             properties::skeleton(*b.complex, properties::joined(sy)));
      !f.empty())
    return "under transforms first, then of mapped leaves:\n" + f;
  if (x.component_count() != y.component_count()) return "numbers of components differ";
  const NodeRow &row_x = a.rows.back(), &row_y = b.rows.back();
  if (row_x.cells != row_y.cells) return "counts of simplified cells differ";
  auto volumes_x = row_x.volumes, volumes_y = row_y.volumes;
  std::sort(volumes_x.begin(), volumes_x.end());
  std::sort(volumes_y.begin(), volumes_y.end());
  return volumes_x == volumes_y ? "" : "volumes differ";
}

}  // namespace

void add_transforms(Families& families) {
  Recipe<Moved> recipe;
  recipe.name = "transforms";
  recipe.oracle = "leaves with coordinates mapped by definition";
  recipe.share = 1;
  recipe.make = random_moved;
  recipe.compare = compare_moved;
  recipe.smaller = [](const Moved& moved) {
    std::vector<Moved> out;
    for (std::size_t i = 0; i < moved.steps.size(); ++i) {
      out.push_back(moved);
      out.back().steps.erase(out.back().steps.begin() + static_cast<std::ptrdiff_t>(i));
    }
    for (RandomDag& less : properties::smaller(moved.dag)) out.push_back({std::move(less), moved.steps});
    return out;
  };
  recipe.text = moved_text;
  add(families, recipe);
}

}  // namespace cnrg::campaign
