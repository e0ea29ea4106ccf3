// Random dags, their text, and how a failing one is made smaller.
#include "tests/oracles/dag.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

namespace cnrg::properties {
namespace {

using scenes::Random;
using scenes::without;

constexpr int kMostDepth = 8;

const char* word_of(Operator op) {
  switch (op) {
    case Operator::leaf: return "group";
    case Operator::unite: return "union";
    case Operator::intersect: return "intersection";
    case Operator::subtract: return "difference";
    case Operator::aggregate: return "aggregate";
    case Operator::unify: return "unify";
    case Operator::sum: return "sum";
    case Operator::product: return "product";
    case Operator::cnrg_subtract: return "subtract";
    case Operator::complement: return "complement";
    case Operator::interior: return "interior";
    case Operator::closure: return "closure";
    case Operator::boundary: return "boundary";
    case Operator::regularize: return "regularize";
    case Operator::simplify: return "simplify";
    // Surfaces and criteria are of single scenes: tests/operators. `within` of `simplify` is drawn by joined_dag
    // (joined_dags.h) alone: it makes cells that the refinement of the leaves does not have, and the other oracles
    // know no others.
    case Operator::below:
    case Operator::above:
    case Operator::select: break;
  }
  throw std::logic_error("random dags do not draw this operator");
}

const char* word_of(DominantOperand d) {
  return d == DominantOperand::left ? "left" : d == DominantOperand::right ? "right" : "equal";
}

Standing standing(const DagNode& node, const std::vector<Standing>& below) {
  const auto all_closed = [&] {
    return std::none_of(node.operands.begin(), node.operands.end(), [&](std::size_t i) {
      return below[i] == Standing::open || below[i] == Standing::complement;
    });
  };
  const bool of_group = !node.operands.empty() && below[node.operands[0]] == Standing::group && !node.each;
  Standing value = Standing::open;
  switch (node.op) {
    case Operator::leaf:
    case Operator::unite:
    case Operator::intersect:
    case Operator::subtract: return Standing::group;
    case Operator::simplify:
      value = below[node.operands[0]];
      if (node.within && value == Standing::complement) value = Standing::open;  // a leaf that is components
      break;
    case Operator::closure:
    case Operator::regularize: value = of_group ? Standing::group : Standing::closed; break;
    case Operator::boundary: value = Standing::closed; break;
    case Operator::aggregate:
    case Operator::unify:
    case Operator::sum:
    case Operator::product: value = all_closed() ? Standing::closed : Standing::open; break;
    case Operator::complement:
      value = below[node.operands[0]] == Standing::group ? Standing::complement : Standing::open;
      break;
    case Operator::cnrg_subtract:
    case Operator::interior: break;
    case Operator::below:
    case Operator::above:
    case Operator::select: throw std::logic_error("random dags do not draw this operator");
  }
  return node.regularize && value != Standing::group ? Standing::closed : value;
}

/// `key: value` for what is said and for the number of dominance.
std::vector<std::string> attribute_fields(const Attributes& said) {
  std::vector<std::string> out;
  if (!said.name.empty()) out.push_back("name: \"" + said.name.text() + "\"");
  if (!said.material.empty()) out.push_back("material: " + said.material.name());
  std::string properties;
  for (const auto& [key, value] : said.properties) {
    const bool text = std::holds_alternative<std::string>(value);
    properties +=
        (properties.empty() ? "" : ", ") + key + (text ? ": \"" : ": ") + to_text(value) + (text ? "\"" : "");
  }
  if (!properties.empty()) out.push_back("attributes: {" + properties + "}");
  return out;
}

std::string text_of_leaf(const DagNode& node, const scenes::Leaf& leaf) {
  std::string out = "    group:\n" + scenes::group_text(leaf), parts;
  for (const auto& [number, said] : node.parts) {
    const bool occurs = std::any_of(leaf.faces.begin(), leaf.faces.end(),
                                    [&, k = number](const auto& f) { return f.front == k || f.back == k; });
    std::string fields;
    for (const std::string& field : attribute_fields(said)) fields += (fields.empty() ? "" : ", ") + field;
    if (occurs && !fields.empty()) parts += "        " + std::to_string(number) + ": {" + fields + "}\n";
  }
  if (!parts.empty()) out += "      regions:\n" + parts;
  for (const std::string& field : attribute_fields(node.said)) out += "    " + field + "\n";
  if (node.number) out += "    dominance: " + std::to_string(*node.number) + "\n";
  return out;
}

/// The materials that somebody names, declared.
std::string declared_materials(const RandomDag& dag) {
  std::map<std::string, bool> names;
  for (const DagNode& node : dag.nodes) {
    if (!node.said.material.empty()) names[node.said.material.name()];
    for (const auto& [number, said] : node.parts)
      if (!said.material.empty()) names[said.material.name()];
  }
  std::string out;
  for (const auto& [name, unused] : names) out += (out.empty() ? "materials: {" : ", ") + name + ": {}";
  return out.empty() ? out : out + "}\n";
}

RationalPoint middle_of(const RationalPoint& p, const RationalPoint& q) {
  return {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
}

/// Corners, edges, middles of edges and facets of other leaves as points, wires and sheets: what the operators
/// take off and put back in the same places.
scenes::Leaf echo(Random& random, const std::vector<scenes::Leaf>& leaves) {
  scenes::Leaf out;
  for (int k = random.between(1, 4); k > 0; --k) {
    const scenes::Leaf& leaf = leaves[static_cast<std::size_t>(random.below(static_cast<int>(leaves.size())))];
    scenes::Polygon corners;  // one after another along an edge
    if (leaf.faces.empty() || (!leaf.wires.empty() && random.one_in(2))) {
      if (leaf.wires.empty()) {
        out.points.push_back(leaf.points.front());
        continue;
      }
      const auto& wire = leaf.wires[static_cast<std::size_t>(random.below(static_cast<int>(leaf.wires.size())))];
      corners = {wire[0], wire[1]};
    } else {
      corners = leaf.faces[static_cast<std::size_t>(random.below(static_cast<int>(leaf.faces.size())))].loops[0];
    }
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(corners.size())));
    const RationalPoint &p = corners[at], &q = corners[(at + 1) % corners.size()];
    switch (random.below(5)) {
      case 0: out.points.push_back(p); break;
      case 1: out.points.push_back(middle_of(p, q)); break;
      case 2: out.wires.push_back({p, random.one_in(2) ? q : middle_of(p, q)}); break;
      case 3: out.wires.push_back({p, q}); break;
      default:
        if (corners.size() > 2) scenes::add_sheet(out, {corners});
        else out.points.push_back(q);
    }
  }
  return out;
}

class Maker {
 public:
  Maker(std::uint64_t seed, scenes::Position position) : random_(seed * 31 + 7) {
    const int leaves = 2 + (random_.one_in(2) ? 1 : 0) + (random_.one_in(4) ? 1 : 0);
    dag_.leaves = scenes::random_leaves(seed + 500000, leaves, position);
    for (int k = random_.below(3); k > 0; --k) dag_.leaves.push_back(echo(random_, dag_.leaves));
    push_leaves();
  }

  Maker(std::uint64_t seed, std::vector<scenes::Leaf> leaves) : random_(seed * 31 + 7) {
    dag_.leaves = std::move(leaves);
    push_leaves();
  }

  RandomDag make() {
    const std::size_t most = dag_.leaves.size() + 3 + static_cast<std::size_t>(random_.below(9));
    while (dag_.nodes.size() < most) add();
    for (int k = random_.below(3); k > 0; --k) join();
    return compact(std::move(dag_));
  }

 private:
  void push_leaves() {
    for (std::size_t i = 0; i < dag_.leaves.size(); ++i) {
      DagNode node;
      node.leaf = i;
      push(node);
    }
  }

  std::size_t push(DagNode node) {
    int depth = 0;
    for (const std::size_t i : node.operands) {
      depth = std::max(depth, depth_[i] + 1);
      ++uses_[i];
    }
    standing_.push_back(standing(node, standing_));
    depth_.push_back(depth);
    uses_.push_back(0);
    dag_.nodes.push_back(std::move(node));
    return dag_.nodes.size() - 1;
  }

  std::size_t push(Operator op, std::vector<std::size_t> operands) {
    DagNode node;
    node.op = op;
    node.operands = std::move(operands);
    return push(std::move(node));
  }

  /// A node that leaves room for two more levels; more often one that nobody uses, the latest first.
  std::size_t pick() {
    if (!random_.one_in(3)) {
      for (std::size_t i = dag_.nodes.size(); i-- > 0;)
        if (uses_[i] == 0 && depth_[i] <= kMostDepth - 2 && !random_.one_in(3)) return i;
    }
    for (;;) {
      const auto i = static_cast<std::size_t>(random_.below(static_cast<int>(dag_.nodes.size())));
      if (depth_[i] <= kMostDepth - 2) return i;
    }
  }

  std::size_t closed(std::size_t i) { return standing_[i] == Standing::open ? push(Operator::closure, {i}) : i; }

  void add_many(Operator op) {
    DagNode node;
    node.op = op;
    for (int k = random_.one_in(5) ? 3 : 2; k > 0; --k) {
      const std::size_t i = pick();
      node.operands.push_back(is_group_boolean(op) ? closed(i) : i);
      ++uses_[i];  // the next pick looks elsewhere
    }
    for (const std::size_t i : node.operands) uses_[i] = std::max(0, uses_[i] - 1);
    if (op != Operator::subtract && op != Operator::cnrg_subtract && random_.one_in(2))
      node.dominant = static_cast<DominantOperand>(random_.below(3));
    node.regularize = random_.one_in(10);
    push(std::move(node));
  }

  void add_one(Operator op) {
    DagNode node;
    node.op = op;
    node.operands = {pick()};
    const bool topological = op == Operator::interior || op == Operator::closure || op == Operator::boundary ||
                             op == Operator::regularize;
    node.each = topological && random_.one_in(3);
    node.points = op == Operator::simplify && random_.one_in(2);
    node.regularize = op != Operator::simplify && op != Operator::regularize && random_.one_in(12);
    push(std::move(node));
  }

  void add_aggregate() {
    const std::size_t x = pick(), y = pick();
    switch (random_.below(5)) {
      case 0: push(Operator::aggregate, {push(Operator::cnrg_subtract, {x, y}), y}); break;
      case 1: {
        const std::size_t both = push(Operator::product, {x, y});
        push(Operator::aggregate, {push(Operator::cnrg_subtract, {y, x}), both});
        break;
      }
      case 2:
        push(Operator::aggregate, {push(Operator::cnrg_subtract, {x, y}), push(Operator::product, {y, x}),
                                   push(Operator::cnrg_subtract, {y, x})});
        break;
      case 3: push(Operator::aggregate, {push(Operator::interior, {x}), push(Operator::boundary, {x})}); break;
      default: push(Operator::aggregate, {x, push(Operator::complement, {x})}); break;
    }
  }

  /// The last node with one that nobody uses.
  void join() {
    const std::size_t last = dag_.nodes.size() - 1;
    for (std::size_t i = last; i-- > 0;) {
      if (uses_[i] > 0 || std::max(depth_[i], depth_[last]) > kMostDepth - 1) continue;
      constexpr Operator kOps[] = {Operator::sum, Operator::sum, Operator::product, Operator::cnrg_subtract};
      push(kOps[random_.below(4)], {last, i});
      return;
    }
  }

  void add() {
    constexpr Operator kMany[] = {Operator::unite, Operator::unite, Operator::intersect, Operator::subtract,
                                  Operator::sum,   Operator::sum,   Operator::product,   Operator::cnrg_subtract};
    constexpr Operator kOne[] = {
        Operator::unify,   Operator::complement, Operator::complement, Operator::interior,   Operator::interior,
        Operator::closure, Operator::boundary,   Operator::boundary,   Operator::regularize, Operator::simplify};
    const int kind = random_.below(12);
    if (kind < 6) {
      add_many(kMany[random_.below(8)]);
    } else if (kind < 11) {
      add_one(kOne[random_.below(10)]);
    } else {
      add_aggregate();
    }
  }

  Random random_;
  RandomDag dag_;
  std::vector<Standing> standing_;
  std::vector<int> depth_, uses_;
};

/// `node` gives way to `other`, which comes before it.
RandomDag replaced(RandomDag dag, std::size_t node, std::size_t other) {
  for (DagNode& user : dag.nodes)
    for (std::size_t& i : user.operands)
      if (i == node) i = other;
  if (node + 1 == dag.nodes.size()) dag.nodes.resize(other + 1);
  return dag;
}

}  // namespace

std::string operator_name(const DagNode& node) {
  return std::string(word_of(node.op)) + (node.each ? " each" : "") + (node.points ? " points" : "") +
         (node.within ? " within" : "");
}

std::string name_of(const RandomDag& dag, std::size_t node) {
  return (dag.nodes[node].op == Operator::leaf ? "a" : "n") + std::to_string(node);
}

std::string tree_file(const RandomDag& dag) {
  std::ostringstream out;
  out << "cnrg: 1\n" << declared_materials(dag) << "nodes:\n";
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    const DagNode& node = dag.nodes[i];
    if (node.op == Operator::leaf) {
      out << "  " << name_of(dag, i) << ":\n" << text_of_leaf(node, dag.leaves[node.leaf]);
      continue;
    }
    out << "  " << name_of(dag, i) << ": {" << word_of(node.op) << ": ";
    if (node.op == Operator::simplify && (node.points || node.within)) {
      out << "{of: " << name_of(dag, node.operands[0]) << (node.points ? ", mode: points" : "")
          << (node.within ? ", within: " + to_string(*node.within) : "") << "}";
    } else if (node.operands.size() == 1) {
      out << name_of(dag, node.operands[0]);
    } else {
      for (std::size_t k = 0; k < node.operands.size(); ++k)
        out << (k == 0 ? "[" : ", ") << name_of(dag, node.operands[k]);
      out << "]";
    }
    if (node.dominant) out << ", dominance: " << word_of(*node.dominant);
    if (node.number) out << ", dominance: " << *node.number;
    for (const std::string& field : attribute_fields(node.said)) out << ", " << field;
    if (node.each) out << ", each: true";
    if (node.regularize) out << ", regularize: true";
    out << "}\n";
  }
  out << "result: " << name_of(dag, dag.nodes.size() - 1) << "\n";
  return out.str();
}

std::vector<int> depths(const RandomDag& dag) {
  std::vector<int> out;
  for (const DagNode& node : dag.nodes) {
    out.push_back(0);
    for (const std::size_t i : node.operands) out.back() = std::max(out.back(), out[i] + 1);
  }
  return out;
}

std::vector<Standing> standings(const RandomDag& dag) {
  std::vector<Standing> out;
  for (const DagNode& node : dag.nodes) out.push_back(standing(node, out));
  return out;
}

bool well_formed(const RandomDag& dag) {
  const std::vector<Standing> standing = standings(dag);
  const auto open = [&](std::size_t i) { return standing[i] == Standing::open; };
  return std::all_of(dag.nodes.begin(), dag.nodes.end(), [&](const DagNode& node) {
    return !is_group_boolean(node.op) || std::none_of(node.operands.begin(), node.operands.end(), open);
  });
}

scenes::Position position_of(std::uint64_t seed) {
  switch (seed % 4) {
    case 1: return scenes::Position::tilted;
    case 3: return scenes::Position::general;
    default: return scenes::Position::degenerate;
  }
}

RandomDag random_dag(std::uint64_t seed, scenes::Position position) { return Maker(seed, position).make(); }

RandomDag random_dag(std::uint64_t seed, std::vector<scenes::Leaf> leaves) {
  return Maker(seed, std::move(leaves)).make();
}

RandomDag boolean_tree(Random& random, std::vector<scenes::Leaf> leaves) {
  RandomDag out;
  out.leaves = std::move(leaves);
  for (std::size_t i = 0; i < out.leaves.size(); ++i) out.nodes.emplace_back().leaf = i;
  const auto over = [&](const auto& self, std::size_t first, std::size_t count) -> std::size_t {
    if (count == 1) return first;
    const std::size_t left = 1 + static_cast<std::size_t>(random.below(static_cast<int>(count) - 1));
    DagNode node;
    node.op = std::array{Operator::unite, Operator::intersect,
                         Operator::subtract}[static_cast<std::size_t>(random.below(3))];
    node.dominant = static_cast<DominantOperand>(random.below(3));
    node.operands = {self(self, first, left), self(self, first + left, count - left)};
    out.nodes.push_back(std::move(node));
    return out.nodes.size() - 1;
  };
  over(over, 0, out.leaves.size());
  return out;
}

RandomDag compact(RandomDag dag) {
  std::vector<char> reached(dag.nodes.size());
  reached.back() = 1;
  for (std::size_t i = dag.nodes.size(); i-- > 0;)
    if (reached[i])
      for (const std::size_t k : dag.nodes[i].operands) reached[k] = 1;
  RandomDag out;
  std::vector<std::size_t> number(dag.nodes.size());
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    if (!reached[i]) continue;
    DagNode& node = dag.nodes[i];
    for (std::size_t& k : node.operands) k = number[k];
    if (node.op == Operator::leaf) {
      out.leaves.push_back(dag.leaves[node.leaf]);
      node.leaf = out.leaves.size() - 1;
    }
    number[i] = out.nodes.size();
    out.nodes.push_back(std::move(node));
  }
  return out;
}

std::vector<RandomDag> smaller(const RandomDag& dag) {
  std::vector<RandomDag> out;
  for (std::size_t i = 0; i + 1 < dag.nodes.size(); ++i) {
    if (dag.nodes[i].op == Operator::leaf) continue;
    RandomDag less = dag;
    less.nodes.resize(i + 1);
    out.push_back(std::move(less));
  }
  for (std::size_t i = dag.nodes.size(); i-- > 0;) {
    const DagNode& node = dag.nodes[i];
    for (const std::size_t k : node.operands) out.push_back(replaced(dag, i, k));
    if (node.operands.size() > 2)
      for (std::size_t k = 0; k < node.operands.size(); ++k) {
        out.push_back(dag);
        out.back().nodes[i].operands = without(node.operands, k);
      }
    const auto change = [&](bool has, auto edit) {
      if (!has) return;
      out.push_back(dag);
      edit(out.back().nodes[i]);
    };
    change(node.each, [](DagNode& n) { n.each = false; });
    change(node.regularize, [](DagNode& n) { n.regularize = false; });
    change(node.points, [](DagNode& n) { n.points = false; });
    change(node.within.has_value(), [](DagNode& n) { n.within.reset(); });
    change(node.dominant.has_value(), [](DagNode& n) { n.dominant.reset(); });
    change(node.number.has_value(), [](DagNode& n) { n.number.reset(); });
    change(!node.said.name.empty(), [](DagNode& n) { n.said.name = {}; });
    change(!node.said.material.empty(), [](DagNode& n) { n.said.material = {}; });
    for (const auto& [key, value] : node.said.properties)
      change(true, [k = key](DagNode& n) { n.said.properties.erase(k); });
    for (const auto& [number, said] : node.parts) change(true, [k = number](DagNode& n) { n.parts.erase(k); });
    // A use of an inner node by a leaf below it.
    for (std::size_t k = 0; k < node.operands.size(); ++k) {
      if (dag.nodes[node.operands[k]].op == Operator::leaf) continue;
      for (std::size_t l = 0; l < node.operands[k]; ++l) {
        if (dag.nodes[l].op != Operator::leaf) continue;
        change(true, [&](DagNode& n) { n.operands[k] = l; });
      }
    }
  }
  // One leaf for two; leaves come before all inner nodes.
  for (std::size_t a = 0; a < dag.nodes.size(); ++a)
    for (std::size_t b = 0; b < dag.nodes.size(); ++b)
      if (a != b && dag.nodes[a].op == Operator::leaf && dag.nodes[b].op == Operator::leaf)
        out.push_back(replaced(dag, a, b));
  for (RandomDag& less : out) less = compact(std::move(less));
  for (std::vector<scenes::Leaf>& leaves : scenes::smaller(dag.leaves))
    out.push_back({std::move(leaves), dag.nodes});
  std::erase_if(out, [](const RandomDag& less) { return !well_formed(less); });
  return out;
}

}  // namespace cnrg::properties
