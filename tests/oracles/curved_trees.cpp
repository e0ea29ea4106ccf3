#include "tests/oracles/curved_trees.h"

#include <array>
#include <optional>
#include <random>
#include <vector>

#include "csg/operators/identities.h"
#include "csg/operators/node_value.h"
#include "kernel/selection/simplify.h"
#include "tests/oracles/paper_classification.h"

namespace cnrg::properties {
namespace {

class RandomTree {
 public:
  /// `swept`: half of the leaves are extrusions, revolutions and patches.
  explicit RandomTree(std::uint64_t seed, bool swept = false) : random_(seed), swept_(swept) {}

  std::string text() {
    std::vector<std::string> pool;
    std::string nodes;
    const int leaves = between(2, 6);
    for (int i = 0; i < leaves; ++i) {
      pool.push_back("l" + std::to_string(i));
      nodes += "  " + pool.back() + ": {" + leaf() + "}\n";
    }
    for (int i = 0; pool.size() > 1; ++i) {
      const std::string number = std::to_string(i);
      const std::string a = take(pool);
      std::string b = take(pool);
      if (between(0, 6) == 0) {
        nodes += "  c" + number + ": {complement: " + b + "}\n";
        b = "c" + number;
      }
      const char* ops[] = {"union", "union", "intersection", "difference"};
      const char* dominances[] = {"left", "right", "equal"};
      const std::string op = ops[between(0, 3)];
      nodes += "  n" + number + ": {" + op + ": [" + a + ", " + b + "]";
      if (op != "difference") nodes += std::string(", dominance: ") + dominances[between(0, 2)];
      nodes += "}\n";
      pool.push_back("n" + number);
    }
    return "cnrg: 1\nnodes:\n" + nodes + "result: " + pool[0] + "\n";
  }

  /// Small numbers of facets: oracles are slow.
  std::string solid() {
    const char* profiles[] = {"[[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]",
                              "[[0, 0, 0], [3, 0, 0], [3, 1, 0], [1, 1, 0], [1, 3, 0], [0, 3, 0]]",
                              "[[0, 0, 0], [2, 0, 0], {bezier: [[2, 2, 0], [0, 2, 0]]}]"};
    const char* turned[] = {"[[1, -1], {bezier: [[3, -1], [3, 1]]}, [1, 1]]",
                            "[[0, -2], {bezier: [[2, -2], [2, 2]]}, [0, 2]]"};
    const std::string place = ", translate: " + text(point(-1, 1));
    switch (between(0, 6)) {
      case 0: return "cylinder: {" + axis() + ", segments: " + std::to_string(between(3, 6)) + "}";
      case 1: return "cone: {" + axis() + ", segments: " + std::to_string(between(3, 6)) + "}";
      case 2:
        return "sphere: {center: " + text(point(-1, 1)) + ", radius: " + std::to_string(between(1, 2)) +
               ", segments: " + std::to_string(between(3, 6)) + ", rings: " + std::to_string(between(2, 4)) + "}";
      case 3:
        return "torus: {center: " + text(point(-1, 1)) + ", axis: " + text({between(-1, 1), between(-1, 1), 1}) +
               ", radius: 2, tube: 1, segments: " + std::to_string(between(3, 5)) +
               ", rings: " + std::to_string(between(3, 4)) + "}";
      case 4:
        return std::string("extrude: {profile: ") + profiles[between(0, 2)] +
               ", vector: " + text({between(-1, 1), between(-1, 1), between(1, 3)}) + ", segments: 2}" + place;
      case 5:
        return std::string("extrude: {profile: ") + profiles[between(0, 2)] +
               ", vector: [0, 0, 2], twist: " + std::to_string(30 * between(-2, 2)) +
               ", scale: " + std::to_string(between(1, 2)) + ", center: [1, 1, 0], segments: 2}" + place;
      default:
        return std::string("revolve: {profile: ") + turned[between(0, 1)] +
               ", degrees: " + std::to_string(90 * between(1, 4)) +
               ", segments: " + std::to_string(between(2, 4)) + "}" + place;
    }
  }

 private:
  int between(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
  }
  std::string take(std::vector<std::string>& pool) {
    const auto at = pool.begin() + between(0, static_cast<int>(pool.size()) - 1);
    std::string out = *at;
    pool.erase(at);
    return out;
  }
  static std::string text(const std::array<int, 3>& p) {
    return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
  }
  std::array<int, 3> point(int low = -2, int high = 2) {
    return {between(low, high), between(low, high), between(low, high)};
  }
  std::string axis() {
    const auto from = point();
    auto to = from;
    to[static_cast<std::size_t>(between(0, 2))] += between(1, 4);
    return "from: " + text(from) + ", to: " + text(to) + ", radius: " + std::to_string(between(1, 2));
  }
  std::string plane() {
    const char* normals[] = {"[0, 0, 1]", "[1, 0, 0]", "[1, 1, 0]", "[1, 2, 3]"};
    return "{point: " + text(point()) + ", normal: " + normals[between(0, 3)] + "}";
  }
  std::string fineness() {
    return between(0, 1) == 0 ? "segments: " + std::to_string(between(2, 4)) : std::string("chord: 1/4");
  }
  // Corners on whole numbers, so that leaves touch: a square, an L or a half-round, turned or not.
  std::string swept_leaf() {
    const char* profiles[] = {"[[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]",
                              "[[0, 0, 0], [3, 0, 0], [3, 1, 0], [1, 1, 0], [1, 3, 0], [0, 3, 0]]",
                              "[[0, 0, 0], [2, 0, 0], {bezier: [[2, 2, 0], [0, 2, 0]]}]",
                              "{outer: [[-2, -2, 0], [2, -2, 0], {bezier: [[2, 2, 0]], weights: [1, 1, 2]}, "
                              "[-2, 2, 0]], "
                              "holes: [[[-1, -1, 0], [0, -1, 0], [-1, 0, 0]]]}"};
    const char* turned[] = {"[[0, 0], [2, 0], [1, 2]]", "[[1, -1], {bezier: [[3, -1], [3, 1]]}, [1, 1]]",
                            "[[0, -2], {bezier: [[2, -2], [2, 2]]}, [0, 2]]"};
    const std::string place = ", translate: " + text(point());
    switch (between(0, 4)) {
      case 0:
        return std::string("extrude: {profile: ") + profiles[between(0, 3)] +
               ", vector: " + text({between(-1, 1), between(-1, 1), between(1, 3)}) + ", " + fineness() + "}" +
               place;
      case 1:
        return std::string("extrude: {profile: ") + profiles[between(0, 2)] +
               ", vector: [0, 0, 2], twist: " + std::to_string(30 * between(-3, 3)) +
               ", scale: " + std::to_string(between(0, 2)) + ", center: [1, 1, 0], chord: 1/4}" + place;
      case 2:
        return std::string("revolve: {profile: ") + turned[between(0, 2)] +
               ", degrees: " + std::to_string(90 * between(1, 4)) + ", " + fineness() + "}" + place;
      case 3: {
        std::string rows;
        for (int j = 0; j < 3; ++j) {
          rows += j == 0 ? "[" : ", [";
          for (int i = 0; i < 3; ++i) rows += (i == 0 ? "" : ", ") + text({2 * i - 2, 2 * j - 2, between(-2, 2)});
          rows += "]";
        }
        return "bezier: {patch: [" + rows + "], " + fineness() + "}" + place;
      }
      default:
        return "bspline: {curve: {points: [" + text(point()) + ", [3, 3, 3], " + text(point()) + ", [-3, 3, 0], " +
               text(point()) + "], degree: 2}, segments: 2}";
    }
  }
  std::string leaf() {
    if (swept_ && between(0, 1) == 0) return swept_leaf();
    switch (between(0, 9)) {
      case 0: {
        const auto low = point(-3, 1);
        const auto size = point(1, 3);
        return "box: {min: " + text(low) +
               ", max: " + text({low[0] + size[0], low[1] + size[1], low[2] + size[2]}) + "}";
      }
      case 1: return "cylinder: {" + axis() + ", segments: " + std::to_string(2 * between(2, 4)) + "}";
      case 2:
        return "sphere: {center: " + text(point()) + ", radius: " + std::to_string(between(1, 2)) +
               ", segments: 8}";
      case 3: return "cone: {" + axis() + ", segments: 6}";
      case 4:
        return "torus: {center: " + text(point()) +
               ", axis: [0, 0, 1], radius: 2, tube: 1, segments: 6, rings: 6}";
      case 5: return "halfspace: " + plane();
      case 6: return "plane: " + plane();
      case 7: {
        const std::string z = std::to_string(between(-2, 2));
        return "polygon: [[-3, -3, " + z + "], [3, -3, " + z + "], [3, 3, " + z + "], [0, 0, " + z +
               "], [-3, 3, " + z + "]]";
      }
      case 8:
        return "polyline: [" + text(point()) + ", [5, 5, " + std::to_string(between(-5, 5)) + "], [-4, -3, 1]]";
      default: return "points: [" + text(point()) + "]";
    }
  }
  std::mt19937_64 random_;
  bool swept_;
};

std::optional<BooleanOp> boolean_of(const std::string& operator_name) {
  for (const BooleanOp op : {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract}) {
    if (operator_name == name(op)) return op;
  }
  return std::nullopt;
}

// Chains join and end in vertices (or on the frame), loops close over listed edges, faces name their regions.
std::string check_simplified(const Complex& complex, const SimplifiedComplex& s) {
  for (const auto& edge : s.edges) {
    for (std::size_t i = 0; i + 1 < edge.chain.size(); ++i) {
      if (complex.target(edge.chain[i]) != complex.origin(edge.chain[i + 1])) return "a chain is torn";
    }
    const VertexId head = complex.origin(edge.chain.front()), tail = complex.target(edge.chain.back());
    if (edge.closed && head != tail) return "a closed chain is open";
    for (VertexId v : {head, tail}) {
      if (!edge.closed && !complex.on_frame(v) && s.vertex_place[v.index()].dimension != 0) {
        return "a chain ends in no vertex";
      }
    }
  }
  for (const auto& face : s.faces) {
    for (std::uint32_t r : face.regions) {
      if (r == SimplifiedComplex::kNowhere) return "a face names no region";
    }
    for (const auto& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (complex.target(loop[i]) != complex.origin(loop[(i + 1) % loop.size()])) return "a loop is open";
        const EdgeId e = loop[i].edge();
        if (!complex.on_frame(e) && s.edge_place[e.index()].dimension != 1) return "a loop has a merged edge";
      }
    }
  }
  return "";
}

// The group that a node is, or stands for: the complement of one.
const Group& group_value(const Evaluation& evaluation, NodeId id) {
  const NodeValue& value = *evaluation.value(id).value;
  return value.is_group() ? value.group() : value.stands_for.value();
}

std::string check_node(const Tree& tree, const Evaluation& evaluation, NodeId id) {
  const Complex& complex = *evaluation.complex;
  const Group& g = group_value(evaluation, id);
  std::string out = check_group(complex, g);
  const std::vector<NodeId> operands = tree.operands(id);
  if (out.empty() && tree.nodes[id].operator_name == "complement") {
    out = check_complement(complex, group_value(evaluation, operands[0]), g);
  }
  if (const auto op = boolean_of(tree.nodes[id].operator_name); op && out.empty()) {
    const Group &a = group_value(evaluation, operands[0]), &b = group_value(evaluation, operands[1]);
    out = check_boolean(complex, *op, a, b, g);
    if (out.empty() && (classify_by_location(complex, a, b) != classify_by_propagation(complex, a, b) ||
                        classify_by_location(complex, b, a) != classify_by_propagation(complex, b, a))) {
      out = "the paper's classification and propagation differ";
    }
  }
  for (const SimplifyMode mode : {SimplifyMode::features, SimplifyMode::points, SimplifyMode::raw}) {
    if (!out.empty()) break;
    out = check_simplified(complex, simplify(complex, selection_of(complex, g), g.features, mode));
  }
  return out;
}

}  // namespace

std::string random_curved_tree(std::uint64_t seed, bool swept) { return RandomTree(seed, swept).text(); }

std::string random_curved_solid(std::uint64_t seed) { return RandomTree(seed, true).solid(); }

std::string check_curved_tree(const std::string& text) {
  const Tree tree = parse_tree(text, "random.yaml");
  EvaluateOptions options;
  options.validate = true;
  options.threads = 1;
  for (NodeId id : IdRange<NodeId>(tree.nodes.size())) options.nodes.push_back(id);
  const Evaluation evaluation = evaluate(tree, options);
  for (NodeId id : IdRange<NodeId>(tree.nodes.size())) {
    if (std::string f = check_node(tree, evaluation, id); !f.empty()) return tree.nodes[id].name + ": " + f;
  }
  return {};
}

}  // namespace cnrg::properties
