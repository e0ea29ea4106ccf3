#include "tests/oracles/near_trees.h"

#include <algorithm>
#include <sstream>

#include "csg/evaluate/evaluate.h"
#include "csg/result/join.h"
#include "tests/oracles/moved_result.h"
#include "tests/result/region_volumes.h"

namespace cnrg::properties {
namespace {

using Kind = test::LatticeLeaf::Kind;

NearTree random_tree(std::uint64_t seed, const Rational& unit, const Rational& within) {
  test::Dice dice(seed);
  NearTree tree;
  for (test::LatticeLeaf& shape : test::lattice_scene(dice, 3, dice(2) == 0)) {
    NearTree::Leaf leaf{std::move(shape), {}};
    for (std::size_t i = 0; i < leaf.shape.corners.size(); ++i)
      leaf.jitter.push_back({dice(3) - 1, dice(3) - 1, dice(3) - 1});
    tree.leaves.push_back(std::move(leaf));
  }
  // Not always what has no thickness first.
  if (dice(2) == 0) std::reverse(tree.leaves.begin(), tree.leaves.end());
  tree.op = dice(4) == 0 ? "sum" : "union";
  const char* const words[] = {"left", "left", "right", "equal", ""};
  tree.dominance = words[dice(5)];
  tree.unit = unit, tree.within = within;
  return tree;
}

std::string point_text(const RationalPoint& p) {
  return "[" + to_string(p[0]) + ", " + to_string(p[1]) + ", " + to_string(p[2]) + "]";
}

std::string shape_text(const NearTree::Leaf& leaf, const Rational& unit) {
  std::vector<RationalPoint> p;
  for (std::size_t i = 0; i < leaf.jitter.size(); ++i) {
    p.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) p[i][k] = leaf.shape.corners[i][k] + unit * leaf.jitter[i][k];
  }
  const auto list = [&] {
    std::string out;
    for (const RationalPoint& q : p) out += (out.empty() ? "[" : ", ") + point_text(q);
    return out + "]";
  };
  switch (leaf.shape.kind) {
    case Kind::box: return "box: {min: " + point_text(p[0]) + ", max: " + point_text(p[1]) + "}";
    case Kind::rectangle: {
      std::size_t flat = 0;
      while (leaf.shape.corners[0][flat] != leaf.shape.corners[1][flat]) ++flat;
      const std::size_t u = (flat + 1) % 3, v = (flat + 2) % 3;
      const RationalPoint low = p[0], high = p[1];
      p.assign(4, low);
      p[1][u] = p[2][u] = high[u];
      p[2][v] = p[3][v] = high[v];
      return "polygon: " + list();
    }
    case Kind::triangle: return "polygon: " + list();
    case Kind::wire: return "polyline: " + list();
    case Kind::point: return "points: " + list();
    case Kind::tetrahedron: return "tetrahedron: " + list();
  }
  return {};
}

Result result_of(const NearTree& tree, const std::string& node) {
  EvaluateOptions options;
  options.threads = 1;
  return evaluate(parse_tree(text_of(tree, node), "near.yaml"), options).result();
}

/// By name: a group has a region for each piece of a component.
std::string volume_failure(const Result& a, const Result& b) {
  const auto x = volumes(a), y = volumes(b);
  if (x == y) return {};
  std::ostringstream out;
  out << "volumes of the result that is joined, and of the node:";
  for (const auto& all : {x, y}) {
    out << "\n";
    for (const auto& [name, volume] : all) out << " " << name << " " << to_decimal(volume);
  }
  return out.str();
}

std::string thrown_by(const std::function<std::string()>& check) {
  try {
    return check();
  } catch (const std::exception& e) {
    return std::string("thrown: ") + e.what();
  }
}

}  // namespace

NearTree near_tree(std::uint64_t seed) {
  const Rational unit(1, 1000);
  const int factors[] = {2, 4, 16};
  return random_tree(seed, unit, unit * factors[seed % 3]);
}

NearTree slight_tree(std::uint64_t seed) {
  const Rational unit(1, Integer("100000000000000000"));
  return random_tree(seed + 1'000'000, unit, 16 * unit);
}

std::string text_of(const NearTree& tree, const std::string& result) {
  std::ostringstream out;
  out << "cnrg: 1\nmaterials: {m0: {}, m1: {}, m2: {}}\nnodes:\n";
  std::string list;
  for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
    const std::string n = std::to_string(i);
    out << "  a" << n << ": {" << shape_text(tree.leaves[i], tree.unit) << ", name: s" << n << ", material: m"
        << i % 3 << ", attributes: {number: " << n << ", kind: k" << i % 2 << "}}\n";
    list += (i == 0 ? "a" : ", a") + n;
  }
  out << "  model: {" << tree.op << ": [" << list << "]"
      << (tree.dominance.empty() ? "" : ", dominance: " + tree.dominance) << "}\n"
      << "  joined: {simplify: {of: model, within: " << to_string(tree.within) << "}}\nresult: " << result << "\n";
  return out.str();
}

std::vector<NearTree> smaller(const NearTree& tree) {
  std::vector<NearTree> out;
  for (std::size_t i = 0; i < tree.leaves.size() && tree.leaves.size() > 2; ++i) {
    out.push_back(tree);
    out.back().leaves.erase(out.back().leaves.begin() + std::ptrdiff_t(i));
  }
  for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
    for (std::size_t p = 0; p < tree.leaves[i].jitter.size(); ++p) {
      if (tree.leaves[i].jitter[p] == std::array{0, 0, 0}) continue;
      out.push_back(tree);
      out.back().leaves[i].jitter[p] = {0, 0, 0};
    }
  }
  return out;
}

std::string join_failure(const NearTree& tree) {
  return thrown_by([&]() -> std::string {
    const Result before = result_of(tree, "model");
    JoinReport report;
    const Result after = join(before, tree.within, &report);
    const std::string told = report.text(tree.within) + ": ";
    if (std::string f = moved_failure(before, after, {report.displacement, report.lost_regions}); !f.empty())
      return told + f;
    if (report.displacement >= kMostJoinMoves * to_double(tree.within)) return told + "moved too far";
    std::string near = near_failure(after, to_double(tree.within));
    if (near.empty() != (report.remaining == 0))
      return told + (near.empty() ? "told that something is near, and nothing is" : near);
    const test::ScratchFolder folder;
    if (std::string f = file_failure(after, folder.path()); !f.empty()) return told + f;
    // The node does the same, and says so.
    EvaluateOptions options;
    options.threads = 1;
    const Evaluation e = evaluate(parse_tree(text_of(tree, "joined"), "near.yaml"), options);
    if (std::string f = volume_failure(after, e.result()); !f.empty()) return told + f;
    for (const std::string& warning : report.warnings(tree.within)) {
      const bool said = std::any_of(e.diagnostics.begin(), e.diagnostics.end(), [&](const Diagnostic& d) {
        return d.level == Diagnostic::Level::warning && d.message.find(warning) != std::string::npos;
      });
      if (!said) return told + "the node does not say: " + warning;
    }
    return {};
  });
}

std::string snap_failure(const NearTree& tree) {
  return thrown_by([&]() -> std::string {
    const Result before = result_of(tree, "model");
    SnapReport report;
    const Result after = snap(before, &report);
    if (report.rounds == 0) return {};
    const std::string told = report.text() + ": ";
    if (std::string f = moved_failure(before, after, {report.displacement, report.lost_regions}); !f.empty())
      return told + f;
    for (const VertexId v : after.complex().vertices) {
      const RationalPoint p = after.complex().points.rational(v);
      if (!is_double(p[0]) || !is_double(p[1]) || !is_double(p[2])) return told + "a vertex is no double";
    }
    const test::ScratchFolder folder;
    if (std::string f = file_failure(after, folder.path()); !f.empty()) return told + f;
    return {};
  });
}

}  // namespace cnrg::properties
