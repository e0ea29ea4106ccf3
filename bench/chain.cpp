// A chain of unions: does a node cost what it touches, and is memory of values given back?
//
//   bench_chain [--nodes N] [--rounds R] [--seed S]
//
// N + 1 small solids (tetrahedra and boxes, each in a cell of a lattice of its own, so scattered in space; every
// tenth overlaps the one before it) are united one after the other: ((a u b) u c) u ... . For comparison the same
// complex with N unions of two neighbours each. Rows with counts and exact volumes are made for every node, as
// `cnrg eval` does. What is printed:
//   * seconds per node in tenths of the chain, and those of the pairs: the ratio of the last tenth to the pairs is
//     to stay below 2
//   * peak memory of the process with values freed after their last use, and with all values kept
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/cases/child.h"
#include "csg/evaluate/evaluate.h"

namespace cnrg::bench {
namespace {

struct Settings {
  int nodes = 1000, rounds = 5;
  unsigned seed = 1;
};

std::string point(double x, double y, double z) {
  std::ostringstream text;
  text << "[" << x << ", " << y << ", " << z << "]";
  return text.str();
}

std::string solids(const Settings& s) {
  std::mt19937 random(s.seed);
  const auto number = [&](int low, int high) { return low + static_cast<int>(random() % (high - low + 1)); };
  const int side = static_cast<int>(std::ceil(std::cbrt(s.nodes + 1)));
  std::vector<int> places(static_cast<std::size_t>(side * side * side));
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<int>(i);
  std::shuffle(places.begin(), places.end(), random);
  std::string text;
  for (int i = 0; i <= s.nodes; ++i) {
    const int at = places[static_cast<std::size_t>(i % 10 == 9 ? i - 1 : i)], shift = i % 10 == 9 ? 3 : 0;
    const double x = 20 * (at % side) + shift, y = 20 * (at / side % side) + shift, z = 20 * (at / side / side);
    text += "  s" + std::to_string(i) + ": ";
    if (i % 2 == 0) {
      text += "{box: {min: " + point(x, y, z) + ", max: " +
              point(x + number(5, 10), y + number(5, 10), z + number(5, 10)) + "}}\n";
    } else {
      text += "{tetrahedron: [" + point(x, y, z) + ", " + point(x + number(6, 12), y, z + 1) + ", " +
              point(x, y + number(6, 12), z + 2) + ", " + point(x + 1, y + 2, z + number(6, 12)) + "]}\n";
    }
  }
  return text;
}

std::string chain(const Settings& s) {
  std::string text = "cnrg: 1\nnodes:\n" + solids(s);
  for (int i = 1; i <= s.nodes; ++i) {
    const std::string left = i == 1 ? "s0" : "u" + std::to_string(i - 1);
    text += "  u" + std::to_string(i) + ": {union: [" + left + ", s" + std::to_string(i) + "]}\n";
  }
  // Volumes by region are made for the result alone: it is a node of its own.
  return text + "  all: {simplify: u" + std::to_string(s.nodes) + "}\nresult: all\n";
}

std::string pairs(const Settings& s) {
  std::string text = "cnrg: 1\nnodes:\n" + solids(s);
  for (int i = 1; i <= s.nodes; ++i) {
    const std::string left = "s" + std::to_string(i - 1), right = "s" + std::to_string(i);
    text += "  u" + std::to_string(i) + ": {union: [" + left + ", " + right + "]}\n";
  }
  return text + "result: u1\n";
}

/// Seconds of each union, its row included.
std::vector<double> seconds_per_union(const std::string& text, bool all_roots, bool keep_all) {
  const Tree tree = parse_tree(text, "chain.yaml");
  EvaluateOptions options;
  options.keep_all = keep_all;
  if (all_roots) {
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
      if (tree.nodes[id].op == Operator::unite) options.nodes.push_back(id);
    }
  }
  const Evaluation evaluation = evaluate(tree, options);
  std::vector<double> out;
  for (const NodeRow& row : evaluation.rows) {
    if (row.operator_name == "union") out.push_back(row.seconds + row.measure_seconds);
  }
  return out;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

double mean(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += values[i];
  return sum / static_cast<double>(end - begin);
}

/// Tenths of the list, by their means.
std::string tenths(const std::vector<double>& values) {
  std::ostringstream text;
  text.precision(9);
  for (std::size_t k = 0; k < 10; ++k) {
    text << mean(values, values.size() * k / 10, values.size() * (k + 1) / 10) << " ";
  }
  return text.str();
}

std::vector<double> numbers(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> out;
  for (double x; in >> x;) out.push_back(x);
  return out;
}

ChildResult checked(ChildResult child) {
  if (child.end != ChildResult::End::done) throw std::runtime_error("an evaluation did not end");
  return child;
}

int run(const Settings& s) {
  const std::string chain_text = chain(s), pairs_text = pairs(s);
  std::vector<std::vector<double>> by_tenth(10);
  std::vector<double> of_pairs;
  std::size_t freed = 0, kept = 0;
  for (int round = 0; round < s.rounds; ++round) {
    const ChildResult one =
        checked(run_child([&] { return tenths(seconds_per_union(chain_text, false, false)); }));
    const std::vector<double> means = numbers(one.text);
    for (std::size_t k = 0; k < 10; ++k) by_tenth[k].push_back(means.at(k));
    freed = std::max(freed, one.peak_bytes);
    const ChildResult all = checked(run_child([&] { return tenths(seconds_per_union(chain_text, false, true)); }));
    kept = std::max(kept, all.peak_bytes);
    const ChildResult two = checked(run_child([&] { return tenths(seconds_per_union(pairs_text, true, false)); }));
    const std::vector<double> pair_means = numbers(two.text);
    of_pairs.push_back(mean(pair_means, 0, pair_means.size()));
  }
  std::printf("%d unions of small solids scattered in space, microseconds per node (medians of %d rounds)\n",
              s.nodes, s.rounds);
  for (std::size_t k = 0; k < 10; ++k) {
    std::printf("  tenth %2zu of the chain   %8.1f\n", k + 1, 1e6 * median(by_tenth[k]));
  }
  const double last = median(by_tenth[9]), pair = median(of_pairs);
  std::printf("  unions of two solids    %8.1f\n  last tenth : two solids %8.2f  (to be below 2)\n", 1e6 * pair,
              last / pair);
  std::printf("peak memory: values freed after their last use %.1f MB, all kept %.1f MB\n", freed / 1e6,
              kept / 1e6);
  return last < 2 * pair ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  using namespace cnrg::bench;
  Settings s;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string arg = argv[i];
      const auto value = [&] {
        if (++i >= argc) throw std::runtime_error(arg + " needs a number");
        return std::stoi(argv[i]);
      };
      if (arg == "--nodes") s.nodes = value();
      else if (arg == "--rounds") s.rounds = value();
      else if (arg == "--seed") s.seed = static_cast<unsigned>(value());
      else throw std::runtime_error("unknown option " + arg + "; use --nodes, --rounds, --seed");
    }
    if (s.nodes < 10 || s.rounds < 1) throw std::runtime_error("at least 10 nodes and 1 round");
    return run(s);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_chain: %s\n", error.what());
    return 2;
  }
}
