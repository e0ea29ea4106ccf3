// The values of a tree on the grid, node by node (cubical_values.h).
#include "tests/oracles/cubical_values.h"

#include <algorithm>

#include "tests/oracles/cubical_pair.h"

namespace cubical {
namespace {

using cnrg::Operator;
using cnrg::properties::CellIncidence;
using cnrg::properties::DagNode;
using cnrg::properties::is_group_boolean;
using cnrg::properties::RandomDag;

/// The cells in the boundary of each cell of the grid, of all dimensions.
CellIncidence incidence(const Grid& grid) {
  std::vector<std::vector<std::size_t>> closure(static_cast<std::size_t>(grid.cells()));
  std::vector<Cell> order(closure.size());
  for (Cell c = 0; c < grid.cells(); ++c) order[static_cast<std::size_t>(c)] = c;
  std::stable_sort(order.begin(), order.end(),
                   [&](Cell a, Cell b) { return grid.dimension(a) < grid.dimension(b); });
  for (const Cell c : order) {
    auto& own = closure[static_cast<std::size_t>(c)];
    for (const Cell b : grid.boundary(c)) {
      const auto& below = closure[static_cast<std::size_t>(b)];
      own.push_back(static_cast<std::size_t>(b));
      own.insert(own.end(), below.begin(), below.end());
    }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
  }
  return CellIncidence(std::move(closure));
}

class BruteForce {
 public:
  BruteForce(const Grid& grid, const RandomDag& dag) : grid_(grid), cells_(incidence(grid)), dag_(dag) {}

  /// The values of all nodes, or nothing and the reason why not.
  std::string run(std::vector<Value>& values) const {
    for (const DagNode& node : dag_.nodes) {
      Value value;
      if (std::string f = apply(node, values, value); !f.empty()) return f;
      values.push_back(std::move(value));
    }
    return {};
  }

 private:
  Value of_group(Group g) const {
    Value value;
    value.is_group = true;
    value.labels.assign(static_cast<std::size_t>(grid_.cells()), 0);
    for (Cell c = 0; c < grid_.cells(); ++c) {
      auto& label = value.labels[static_cast<std::size_t>(c)];
      if (grid_.dimension(c) < 3 && g.entity[c]) label = static_cast<std::uint32_t>(g.region_count) + 1;
      else label = static_cast<std::uint32_t>(std::max(0, region_around(grid_, g, c)));
    }
    value.group = std::move(g);
    return value;
  }

  /// Closed components as a group (csg/SEMANTICS.md#from-one-family-to-the-other).
  Group group_of_components(const Labels& x) const {
    Group g;
    g.inside.assign(static_cast<std::size_t>(grid_.cells()), 0);
    g.entity = g.inside;
    std::vector<char> inner(x.size(), 1);  // the whole star is of one component
    for (Cell c = 0; c < grid_.cells(); ++c)
      for (const Cell d : grid_.cubes(c)) mark_star(c, d, x, inner);
    for (Cell c = 0; c < grid_.cells(); ++c) {
      if (grid_.dimension(c) == 3) g.inside[c] = x[static_cast<std::size_t>(c)] != 0;
      else g.entity[c] = x[static_cast<std::size_t>(c)] != 0 && !inner[static_cast<std::size_t>(c)];
    }
    complete(grid_, g);
    return g;
  }

  /// All cells between a cell and a cube of its star.
  void mark_star(Cell c, Cell cube, const Labels& x, std::vector<char>& inner) const {
    const auto p = grid_.position(c), q = grid_.position(cube);
    for (int code = 1; code < 8; ++code) {
      auto r = p;
      for (int k = 0; k < 3; ++k)
        if (code >> k & 1) r[k] = q[k];
      if (x[static_cast<std::size_t>(grid_.at(r[0], r[1], r[2]))] != x[static_cast<std::size_t>(c)])
        inner[static_cast<std::size_t>(c)] = 0;
    }
  }

  Group operand(const Value& value) const {
    return value.is_group || value.complement ? value.group : group_of_components(value.labels);
  }

  std::string apply(const DagNode& node, const std::vector<Value>& values, Value& out) const {
    if (node.op == Operator::leaf) {
      out = of_group(group_of(grid_, dag_.leaves[node.leaf]));
    } else if (is_group_boolean(node.op)) {
      for (const std::size_t i : node.operands) {
        out.operands.push_back(operand(values[i]));
        out.number = std::max(out.number, values[i].number);
      }
      Group g = out.operands.front();
      int largest = values[node.operands[0]].number;
      for (std::size_t k = 1; k < node.operands.size(); ++k) {
        const Group& b = out.operands[k];
        const int number = values[node.operands[k]].number;
        using cnrg::DominantOperand;
        const auto dominant = node.dominant.value_or(largest > number   ? DominantOperand::left
                                                     : number > largest ? DominantOperand::right
                                                                        : DominantOperand::equal);
        largest = std::max(largest, number);
        const Op op = node.op == Operator::unite       ? Op::unite
                      : node.op == Operator::intersect ? Op::intersect
                                                       : Op::subtract;
        const bool swapped = dominant == DominantOperand::right && op != Op::subtract;
        g = boolean_operation(grid_, op, dominant != DominantOperand::equal, swapped ? b : g, swapped ? g : b);
        if (g.region_count < 0) return "the brute force itself left an invalid group";
        out.steps.push_back({op, dominant, g});
      }
      const Value whole = of_group(std::move(g));
      out.is_group = true;
      out.group = whole.group;
      out.labels = whole.labels;
    } else {
      const Value& first = values[node.operands[0]];
      if (node.op == Operator::simplify) {
        out = first;
        out.operands.clear();
        out.steps.clear();
        out.first_labels.clear();
      } else if (first.is_group && !node.each &&
                 (node.op == Operator::closure || node.op == Operator::regularize)) {
        out = node.op == Operator::closure ? first : of_group(regularize(grid_, first.group));
      } else {
        std::vector<Labels> x;
        for (const std::size_t i : node.operands) x.push_back(values[i].labels);
        out.labels = operator_by_definition(cells_, node, x);
        if (node.op == Operator::complement && first.is_group) {
          out.complement = true;
          out.group = complement(grid_, first.group);
        }
      }
    }
    if (node.regularize) {
      if (out.is_group) {
        const Value whole = of_group(regularize(grid_, out.group));
        out.group = whole.group;
        out.labels = whole.labels;
      } else {
        out.first_labels = out.labels;
        out.labels = regularized_by_definition(cells_, out.labels);
        out.complement = false;
      }
    }
    if (node.number) out.number = *node.number;
    return {};
  }

  const Grid& grid_;
  const CellIncidence cells_;
  const RandomDag& dag_;
};

}  // namespace

std::string values_by_brute_force(const Grid& grid, const RandomDag& dag, std::vector<Value>& values) {
  return BruteForce(grid, dag).run(values);
}

}  // namespace cubical
