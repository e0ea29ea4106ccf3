// Chains of Booleans and shared nodes: does a node cost what it touches, do numbers grow, is memory given back?
//
//   bench_chain [--nodes N] [--rounds R] [--seed S]
//
// Three trees (cases/chain_tree.h). Rows with counts and exact volumes are made for every node, as `cnrg eval`
// does.
//   * N + 1 small solids scattered in space, united one after the other: ((a u b) u c) u ... ; the same solids
//     as N unions of two neighbours each. Printed: seconds per node in tenths of the chain, and those of the
//     pairs: the ratio of the last tenth to the pairs is to stay below 2. Peak memory of the process with values
//     freed after their last use, and with all values kept.
//   * A chain of solids that all hang together, of depth 1 to 1,000. Printed: nanoseconds of the operators per
//     cell of their operands, which is to grow at most twofold from depth 10 on; and the largest coordinate of
//     the result in bits. Booleans make no planes, so that is below a bound that knows nothing of the depth.
//   * Layers of unions of neighbours in the layer below, each value used twice; likewise.
// Exit status 1 if one of these does not hold.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/cases/chain_tree.h"
#include "bench/cases/child.h"
#include "bench/cases/statistics.h"
#include "bench/command.h"
#include "csg/evaluate/evaluate.h"

namespace cnrg::bench {
namespace {

struct Settings {
  int nodes = 1000, rounds = 5;
  unsigned seed = 1;
};

/// In a process of its own; throws if that ends badly.
template <class Work>
nlohmann::json in_child(const Work& work, std::size_t* peak_bytes = nullptr) {
  const ChildResult child = run_child([&] {
    try {
      return nlohmann::json(work()).dump();
    } catch (const std::exception& error) {
      return nlohmann::json{{"error", error.what()}}.dump();
    }
  });
  if (child.end != ChildResult::End::done || child.text.empty())
    throw std::runtime_error("an evaluation did not end");
  nlohmann::json result = nlohmann::json::parse(child.text);
  if (result.is_object() && result.contains("error")) throw std::runtime_error(result["error"].get<std::string>());
  if (peak_bytes != nullptr) *peak_bytes = std::max(*peak_bytes, child.peak_bytes);
  return result;
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
    if (row.operator_name == "union") out.push_back(row.seconds + row.totals_seconds);
  }
  return out;
}

double mean(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += values[i];
  return sum / static_cast<double>(end - begin);
}

double mean_of_tenth(const std::vector<double>& values, std::size_t k) {
  return mean(values, values.size() * k / 10, values.size() * (k + 1) / 10);
}

bool run_scattered(const Settings& s) {
  const ScatteredSolids solids{s.nodes, s.seed};
  const std::string chain_text = scattered_chain(solids), pairs_text = scattered_pairs(solids);
  std::vector<std::vector<double>> by_tenth(10);
  std::vector<double> of_pairs;
  std::size_t freed = 0, kept = 0;
  for (int round = 0; round < s.rounds; ++round) {
    const std::vector<double> one = in_child([&] { return seconds_per_union(chain_text, false, false); }, &freed);
    for (std::size_t k = 0; k < 10; ++k) by_tenth[k].push_back(mean_of_tenth(one, k));
    in_child([&] { return seconds_per_union(chain_text, false, true); }, &kept);
    const std::vector<double> two = in_child([&] { return seconds_per_union(pairs_text, true, false); });
    of_pairs.push_back(mean(two, 0, two.size()));
  }
  std::printf("%d unions of small solids scattered in space, microseconds per node (medians of %d rounds)\n",
              s.nodes, s.rounds);
  for (std::size_t k = 0; k < 10; ++k) {
    std::printf("  tenth %2zu of the chain   %8.1f\n", k + 1, 1e6 * median(by_tenth[k]));
  }
  const double last = median(by_tenth[9]), pair = median(of_pairs);
  std::printf("  unions of two solids    %8.1f\n  last tenth : two solids %8.2f  (to be below 2)\n", 1e6 * pair,
              last / pair);
  std::printf("peak memory: values freed after their last use %.1f MB, all kept %.1f MB\n",
              static_cast<double>(freed) / 1e6, static_cast<double>(kept) / 1e6);
  return last < 2 * pair;
}

/// What the unions of a tree cost and touch.
struct Cost {
  std::vector<double> seconds, touched;  ///< by union, operands first; cells of its operands
  std::size_t bits = 0;                  ///< of the largest number in a vertex of the result, as x : y : z : w
};

void to_json(nlohmann::json& out, const Cost& cost) { out = {cost.seconds, cost.touched, cost.bits}; }
void from_json(const nlohmann::json& in, Cost& cost) {
  in.at(0).get_to(cost.seconds);
  in.at(1).get_to(cost.touched);
  in.at(2).get_to(cost.bits);
}

double cells(const NodeRow& row) {
  double sum = 0;
  for (const std::size_t n : row.raw_cells) sum += static_cast<double>(n);
  return sum;
}

std::size_t largest_bits(const KeptValue& value, const PointTable& points) {
  std::size_t bits = 0;
  for (const SimplifiedComplex::Vertex& vertex : value.simplified->vertices) {
    const ExactPoint& p = points.exact(vertex.cell);
    for (const Integer& number : {p.x, p.y, p.z, p.w})
      bits = std::max(bits, mpz_sizeinbase(number.get_mpz_t(), 2));
  }
  return bits;
}

Cost cost_of(const std::string& text) {
  const Tree tree = parse_tree(text, "chain.yaml");
  const Evaluation evaluation = evaluate(tree);
  Cost cost;
  for (const InstanceId id : IdRange<InstanceId>(evaluation.instances.size())) {
    const NodeRow& row = evaluation.rows[id.index()];
    if (row.operator_name != "union") continue;
    double touched = 0;
    for (const InstanceId operand : evaluation.instances[id].operands)
      touched += cells(evaluation.rows[operand.index()]);
    cost.seconds.push_back(row.seconds);
    cost.touched.push_back(touched);
  }
  cost.bits = largest_bits(evaluation.kept[0], evaluation.complex->points);
  return cost;
}

/// Bits of a vertex of planes through points with integers below 2^k. Differences are below 2^k, so a normal is
/// below 2^(2k+1) and the plane's constant below 3 2^(3k+1); the determinant of two columns of normals and one of
/// constants, six terms, is below 18 2^(7k+3) < 2^(7k+8), that of normals is less.
constexpr std::size_t kBitsBound = 7 * kWindingBits + 8;

struct Rate {
  double microseconds = 0, touched = 0, nanoseconds = 0;  ///< per node, per node, per cell touched
};

Rate rate(const Cost& cost, std::size_t begin, std::size_t end) {
  const double seconds = mean(cost.seconds, begin, end), touched = mean(cost.touched, begin, end);
  return {1e6 * seconds, touched, 1e9 * seconds / touched};
}

/// The run with the least sum of times.
Cost least_cost(const std::string& text, int rounds) {
  Cost best;
  double least_sum = 0;
  for (int round = 0; round < rounds; ++round) {
    const Cost cost = in_child([&] { return cost_of(text); });
    const double sum = mean(cost.seconds, 0, cost.seconds.size());
    if (round > 0 && sum >= least_sum) continue;
    least_sum = sum;
    best = cost;
  }
  return best;
}

void print_head(const char* title, const char* first) {
  std::printf("\n%s\n%12s %14s %14s %12s %14s\n", title, first, "us per node", "cells touched", "ns per cell",
              "bits (< bound)");
}

void print_rate(const std::string& name, const Rate& r, const std::string& bits) {
  std::printf("%12s %14.1f %14.0f %12.1f %14s\n", name.c_str(), r.microseconds, r.touched, r.nanoseconds,
              bits.c_str());
}

std::string bits_text(std::size_t bits) { return std::to_string(bits) + " (" + std::to_string(kBitsBound) + ")"; }

/// Nothing per cell grows more than twofold; numbers stay below the bound.
bool judge(double first, double last, std::size_t bits) {
  const bool cost = last <= 2 * first, numbers = bits <= kBitsBound;
  std::printf("  cost per cell touched: %.2f x, to be at most 2 x: %s; numbers: %s\n", last / first,
              cost ? "met" : "NOT MET", numbers ? "met" : "NOT MET");
  return cost && numbers;
}

bool run_depths(const Settings& s) {
  print_head("chains of solids that hang together, by depth", "depth");
  double at_ten = 0, last = 0;
  std::size_t bits = 0;
  for (const int depth : {1, 10, 100, 1000}) {
    // The deepest takes a minute; its thousand nodes are repetition enough.
    const Cost cost = least_cost(winding_chain(depth, s.seed), depth < 1000 ? s.rounds : 1);
    const Rate r = rate(cost, 0, cost.seconds.size());
    print_rate(std::to_string(depth), r, bits_text(cost.bits));
    if (depth == 10) at_ten = r.nanoseconds;
    last = r.nanoseconds;
    bits = std::max(bits, cost.bits);
  }
  return judge(at_ten, last, bits);
}

bool run_layers(const Settings& s) {
  constexpr int kLayers = 60, kShown = 12;
  print_head("layers of unions, each value used twice", "layers");
  const Cost cost = least_cost(shared_layers(kLayers, s.seed), s.rounds);
  // Operands come first, but not layer by layer: the size of the operands tells the layer.
  std::vector<std::size_t> order(cost.seconds.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cost.touched[a] < cost.touched[b]; });
  Cost sorted;
  for (const std::size_t i : order) {
    sorted.seconds.push_back(cost.seconds[i]);
    sorted.touched.push_back(cost.touched[i]);
  }
  double first = 0, last = 0;
  std::size_t begin = 0;
  for (int layer = 1; layer <= kLayers; layer += kShown) {
    std::size_t end = begin;
    for (int l = layer; l < layer + kShown; ++l) end += static_cast<std::size_t>(kLayers - l + 1);
    const Rate r = rate(sorted, begin, end);
    const bool result = layer + kShown > kLayers;
    print_rate(std::to_string(layer) + "-" + std::to_string(layer + kShown - 1), r,
               result ? bits_text(cost.bits) : "");
    if (layer == 1) first = r.nanoseconds;
    last = r.nanoseconds;
    begin = end;
  }
  return judge(first, last, cost.bits);
}

int run(const Settings& s) {
  bool met = run_scattered(s);
  met = run_depths(s) && met;
  met = run_layers(s) && met;
  return met ? 0 : 1;
}

}  // namespace
}  // namespace cnrg::bench

int main(int argc, char** argv) {
  cnrg::bench::Settings settings;
  CLI::App program{"What a node of chains and of shared trees costs; size of numbers; memory.", "bench_chain"};
  program.add_option("--nodes", settings.nodes, "Unions of the scattered solids (1000)")
      ->check(CLI::Range(10, 1000000));
  program.add_option("--rounds", settings.rounds, "Runs of each tree (5)")->check(CLI::Range(1, 1000));
  program.add_option("--seed", settings.seed, "Of the solids (1)");
  return cnrg::bench::command(program, argc, argv, [&] { return cnrg::bench::run(settings); });
}
