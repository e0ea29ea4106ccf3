// Which points are in which node: by the definition of leaves and operators, point by point.
//
// A point off all faces, wires and points of the leaves has them constant around it, so that every operator is
// logic there: union is `or`, closure changes nothing, a boundary is empty. On an entity union, intersection, sum,
// product and their like are logic still; what a closure or an interior makes there depends on the surroundings,
// and only what follows from the point itself is held against the program.
#include <optional>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/node_value.h"
#include "tests/campaign/families/families.h"
#include "tests/campaign/families/solids.h"
#include "tests/oracles/dag.h"
#include "tests/oracles/point_sets.h"

namespace cnrg::campaign {
namespace {

using properties::DagNode;
using properties::RandomDag;
using properties::Standing;
using scenes::Leaf;
using scenes::Polygon;
using scenes::Random;

/// { p : normal . (p - point) = 0 }, or all behind it.
struct Plane {
  RationalPoint point, normal;
  bool solid = false;
};

struct Places {
  RandomDag dag;
  /// Of the leaves that are planes, which say their number (`plane_of`); empty in most families.
  std::vector<Plane> planes;
  std::uint64_t seed = 0;
};

// A plane has no faces of its own in a scene: its leaf is one point far away, which says its number.
const int kFar = 1000000;
Leaf mark(std::size_t plane) {
  Leaf leaf;
  leaf.points.push_back({kFar, static_cast<int>(plane), 0});
  return leaf;
}
std::optional<std::size_t> plane_of(const Leaf& leaf) {
  if (leaf.points.size() != 1 || leaf.points[0][0] != kFar) return std::nullopt;
  return static_cast<std::size_t>(leaf.points[0][1].get_num().get_ui());
}

Rational height(const Plane& plane, const RationalPoint& p) {
  Rational h = 0;
  for (int k = 0; k < 3; ++k) h += plane.normal[k] * (p[k] - plane.point[k]);
  return h;
}

std::string point_text(const RationalPoint& p) {
  return "[\"" + to_string(p[0]) + "\", \"" + to_string(p[1]) + "\", \"" + to_string(p[2]) + "\"]";
}

/// The tree file of the dag with the planes in their places.
std::string places_text(const Places& places) {
  const std::string all = properties::tree_file(places.dag);
  std::string out = "cnrg: 1\nnodes:\n";
  const RandomDag& dag = places.dag;
  for (std::size_t i = 0; i < dag.nodes.size() && dag.nodes[i].op == Operator::leaf; ++i) {
    const Leaf& leaf = dag.leaves[dag.nodes[i].leaf];
    out += "  " + properties::name_of(dag, i) + ":\n";
    if (const auto number = plane_of(leaf)) {
      const Plane& plane = places.planes[*number];
      out += std::string("    ") + (plane.solid ? "halfspace" : "plane") + ": {point: " + point_text(plane.point) +
             ", normal: " + point_text(plane.normal) + "}\n";
    } else {
      out += "    group:\n" + scenes::group_text(leaf);
    }
  }
  const std::size_t inner = all.find("\n  n");
  out += all.substr(
      (inner == std::string::npos || inner > all.rfind("\nresult: ") ? all.rfind("\nresult: ") : inner) + 1);
  return out;
}

enum class Answer : std::uint8_t { out, in, open };  // `open`: the point itself does not tell

Answer of(bool in) { return in ? Answer::in : Answer::out; }
Answer no(Answer a) { return a == Answer::open ? a : of(a == Answer::out); }
Answer both(Answer a, Answer b) {
  if (a == Answer::out || b == Answer::out) return Answer::out;
  return a == Answer::in && b == Answer::in ? Answer::in : Answer::open;
}
Answer either(Answer a, Answer b) { return no(both(no(a), no(b))); }

/// The answers at one point for all nodes.
class ByDefinition {
 public:
  ByDefinition(const Places& places, const RationalPoint& p) : places_(places), dag_(places.dag) {
    generic_ = true;
    for (const Leaf& leaf : dag_.leaves) {
      const auto plane = plane_of(leaf);
      if (plane ? height(places_.planes[*plane], p) == 0 : properties::on_entity(leaf, p)) generic_ = false;
    }
    standings_ = properties::standings(dag_);
    for (const DagNode& node : dag_.nodes) {
      Answer a = node.op == Operator::leaf ? of_leaf(dag_.leaves[node.leaf], p) : of_node(node);
      if (node.regularize && !generic_) a = Answer::open;
      answers_.push_back(a);
    }
  }
  const std::vector<Answer>& answers() const { return answers_; }

 private:
  Answer of_leaf(const Leaf& leaf, const RationalPoint& p) const {
    const auto number = plane_of(leaf);
    if (!number) return of(properties::contains(leaf, p));
    const Plane& plane = places_.planes[*number];
    const Rational h = height(plane, p);
    return of(h == 0 || (plane.solid && h < 0));
  }

  /// A group Boolean takes the complement of a group with its boundary.
  Answer group_operand(std::size_t i) const {
    const Answer a = answers_[i];
    return standings_[i] != Standing::complement || generic_ || a == Answer::in ? a : Answer::open;
  }

  Answer of_node(const DagNode& node) const {
    const auto fold = [&](bool groups, auto op) {
      const auto operand = [&](std::size_t k) {
        return groups ? group_operand(node.operands[k]) : answers_[node.operands[k]];
      };
      Answer all = operand(0);
      for (std::size_t k = 1; k < node.operands.size(); ++k) all = op(all, operand(k));
      return all;
    };
    const auto without = [](Answer a, Answer b) { return both(a, no(b)); };
    const Answer x = answers_[node.operands[0]];
    switch (node.op) {
      case Operator::unite: return fold(true, either);
      case Operator::intersect: return fold(true, both);
      case Operator::subtract: {
        // cl(A - B): what A lacks is out, what is in A alone is in.
        if (generic_) return fold(true, without);
        const Answer a = group_operand(node.operands[0]);
        const Answer rest = fold(true, without);
        return a == Answer::out || rest == Answer::in ? rest : Answer::open;
      }
      case Operator::aggregate:
      case Operator::sum: return fold(false, either);
      case Operator::product: return fold(false, both);
      case Operator::cnrg_subtract: return fold(false, without);
      case Operator::complement: return no(x);
      case Operator::unify:
      case Operator::simplify: return x;
      case Operator::interior: return generic_ || x == Answer::out ? x : Answer::open;
      case Operator::closure: return generic_ || x == Answer::in ? x : Answer::open;
      case Operator::boundary: return generic_ ? Answer::out : Answer::open;
      default: return generic_ ? x : Answer::open;
    }
  }

  const Places& places_;
  const RandomDag& dag_;
  bool generic_ = false;
  std::vector<Standing> standings_;
  std::vector<Answer> answers_;
};

/// Corners, middles between two of them, middles of faces, and places near these.
std::vector<RationalPoint> points_of(const Places& places) {
  Random random(places.seed + 99);
  std::vector<RationalPoint> corners, out;
  for (const Leaf& leaf : places.dag.leaves) {
    if (plane_of(leaf)) continue;
    for (const scenes::Face& f : leaf.faces)
      for (const Polygon& loop : f.loops) corners.insert(corners.end(), loop.begin(), loop.end());
    for (const auto& w : leaf.wires) corners.insert(corners.end(), w.begin(), w.end());
    corners.insert(corners.end(), leaf.points.begin(), leaf.points.end());
  }
  for (const Plane& plane : places.planes) corners.push_back(plane.point);
  const auto corner = [&]() -> const RationalPoint& {
    return corners[static_cast<std::size_t>(random.below(static_cast<int>(corners.size())))];
  };
  for (int i = 0; i < 24; ++i) {
    RationalPoint p = corner();
    const RationalPoint &q = corner(), &r = corner();
    switch (random.below(4)) {
      case 0: break;
      case 1:
        for (int k = 0; k < 3; ++k) p[k] = (p[k] + q[k]) / 2;
        break;
      default:
        for (int k = 0; k < 3; ++k) p[k] = (p[k] * 5 + q[k] * 7 + r[k] * 11) / 23;
    }
    if (random.one_in(2)) {
      const RationalPoint step = random_step(random);
      for (int k = 0; k < 3; ++k) p[k] += step[k] / 3;
    }
    out.push_back(std::move(p));
  }
  return out;
}

std::string compare_places(const Places& places) {
  const RandomDag& dag = places.dag;
  const std::vector<RationalPoint> points = points_of(places);
  const Tree tree = parse_tree(places_text(places), "places.yaml");
  EvaluateOptions options;
  options.threads = 1;
  options.validate = true;
  options.rows = Rows::none;
  options.reach = points;
  for (std::size_t i = 0; i < dag.nodes.size(); ++i)
    options.nodes.push_back(tree.find(properties::name_of(dag, i)));
  const Evaluation evaluation = evaluate(tree, options);
  const Locator locator(*evaluation.complex);
  for (const RationalPoint& p : points) {
    const ByDefinition want(places, p);
    const Location at = locator.locate(p);
    for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
      if (want.answers()[i] == Answer::open) continue;
      const KeptValue& value = evaluation.value(tree.find(properties::name_of(dag, i)));
      const bool in = component_of(*value.simplified, value.simplified->place(*evaluation.complex, at)) != 0;
      if (in == (want.answers()[i] == Answer::in)) continue;
      return properties::name_of(dag, i) + " (" + properties::operator_name(dag.nodes[i]) + "): " + point_text(p) +
             (in ? " is in it, by definition it is not" : " is not in it, by definition it is");
    }
  }
  return {};
}

std::vector<Places> smaller(const Places& places) {
  std::vector<Places> out;
  for (RandomDag& less : properties::smaller(places.dag))
    out.push_back({std::move(less), places.planes, places.seed});
  return out;
}

/// Leaves and copies of them that are a little away.
std::vector<Leaf> echoes(std::uint64_t seed) {
  Random random(seed + 31);
  std::vector<Leaf> leaves{scenes::solid_leaf(random_solid(random), Fill::winding)};
  if (random.one_in(2)) leaves.push_back(scenes::random_leaves(random.next(), 1, scenes::Position::degenerate)[0]);
  const int copies = random.between(1, 2);
  for (int i = 0; i < copies; ++i) {
    Leaf copy = leaves[static_cast<std::size_t>(random.below(static_cast<int>(leaves.size())))];
    apply(translation(random_step(random)), copy);
    leaves.push_back(std::move(copy));
  }
  return leaves;
}

}  // namespace

void add_places(Families& families) {
  const auto places = [&](const char* name, const char* oracle, double share, auto make) {
    Recipe<Places> recipe;
    recipe.name = name;
    recipe.oracle = oracle;
    recipe.share = share;
    recipe.make = make;
    recipe.compare = compare_places;
    recipe.smaller = smaller;
    recipe.text = places_text;
    add(families, recipe);
  };
  places("places", "points by definition", 1, [](std::uint64_t seed) {
    return Places{properties::random_dag(seed + 600'000'000, properties::position_of(seed)), {}, seed};
  });
  places("echoes-places", "points by definition", 0.6, [](std::uint64_t seed) {
    return Places{properties::random_dag(seed + 700'000'000, echoes(seed)), {}, seed};
  });
  places("places-planes", "points by definition, unbounded leaves", 1, [](std::uint64_t seed) {
    Random random(seed + 41);
    Places out;
    out.seed = seed;
    std::vector<Leaf> leaves;
    const int planes = random.between(1, 3);
    for (int i = 0; i < planes; ++i) {
      Plane plane;
      plane.solid = !random.one_in(3);
      for (Rational& x : plane.point) x = random.between(0, 5);
      do {
        for (Rational& x : plane.normal) x = random.one_in(2) ? 0 : random.between(-3, 3);
      } while (plane.normal == RationalPoint{0, 0, 0});
      if (random.one_in(4))
        for (Rational& x : plane.point) x += random_distance(random);
      leaves.push_back(mark(out.planes.size()));
      out.planes.push_back(std::move(plane));
    }
    const auto others = scenes::random_leaves(random.next(), random.between(1, 2), scenes::Position::degenerate);
    leaves.insert(leaves.end(), others.begin(), others.end());
    out.dag = properties::random_dag(seed + 800'000'000, std::move(leaves));
    return out;
  });
}

}  // namespace cnrg::campaign
