// Counting without matrices.
//
// The ways from a root down to a node are counted in one pass over the graph. If all of them are few, so are the
// instances. If not, different ways may still lead to one place: a stair of a hundred steps, each "the one before,
// and the same shifted by 1", has 2^100 ways and 100 places. So places are told apart, by a fingerprint: the image
// of one fixed row under the accumulated matrix, modulo a prime. It is four numbers, goes from node to operand as
// the matrix would, and differs only if the matrix does.
//
// Not all places need to be made. A node's own transform is invertible, so all nodes below one stand at as many
// places as that one, at least: a tree of doublings is refused when its first thousands are counted.
#include "csg/tree/count_instances.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "csg/tree/dag.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

using Residue = std::uint64_t;
constexpr Residue kPrime = (Residue{1} << 61) - 1;

Residue add(Residue a, Residue b) { return a + b >= kPrime ? a + b - kPrime : a + b; }
Residue multiply(Residue a, Residue b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = Wide{a} * b;
  return add(static_cast<Residue>(product & kPrime), static_cast<Residue>(product >> 61));
}
Residue inverse(Residue a) {
  Residue out = 1;
  for (Residue exponent = kPrime - 2; exponent != 0; exponent >>= 1) {
    if (exponent & 1) out = multiply(out, a);
    a = multiply(a, a);
  }
  return out;
}

Residue residue(const Integer& n) {
  static const Integer prime = to_integer(kPrime);
  Integer rest;
  mpz_fdiv_r(rest.get_mpz_t(), n.get_mpz_t(), prime.get_mpz_t());
  return to_machine<Residue>(rest);
}

/// Nothing if the denominator is 0 modulo the prime.
std::optional<Residue> residue(const Rational& x) {
  const Residue den = residue(x.get_den());
  if (den == 0) return std::nullopt;
  const Residue num = residue(x.get_num());
  return den == 1 ? num : multiply(num, inverse(den));
}

/// A row (x, y, z, 1-part) times a matrix of four rows whose last one is (0, 0, 0, 1).
using Row = std::array<Residue, 4>;
constexpr Row kStart{0x1234567890abcdef >> 4, 0x0fedcba987654321, 0x1357924680bdf9ec >> 4, 0x1a2b3c4d5e6f708};

struct Matrix {
  std::array<std::array<Residue, 4>, 3> rows;
  Row operator()(const Row& row) const {
    Row out{0, 0, 0, row[3]};
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 3; ++i) out[j] = add(out[j], multiply(row[i], rows[i][j]));
    }
    return out;
  }
};

std::optional<Matrix> matrix(const Transform& transform) {
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto value = residue(j < 3 ? transform.linear[i][j] : transform.offset[i]);
      if (!value) return std::nullopt;
      out.rows[i][j] = *value;
    }
  }
  return out;
}

/// Places at which a node is used, without those that came twice.
class Places {
 public:
  void add(const std::vector<Row>& rows) {
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    if (rows_.size() > 2 * once_ + 64) settle();
  }
  std::vector<Row> take() {
    settle();
    return std::move(rows_);
  }

 private:
  void settle() {
    std::sort(rows_.begin(), rows_.end());
    rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
    once_ = rows_.size();
  }
  std::vector<Row> rows_;
  std::size_t once_ = 0;
};

class Counter {
 public:
  Counter(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most)
      : tree_(tree), roots_(roots), most_(most), order_(tree.dag->order()) {
    std::reverse(order_.begin(), order_.end());  // users first
  }

  void run() {
    if (few_ways()) return;
    std::vector<Places> places(tree_.nodes.size());
    for (const NodeId root : roots_) places[root.index()].add({kStart});
    std::size_t counted = 0, asked = kWorthAsking / 2;
    for (const NodeId id : order_) {
      std::vector<Row> here = places[id.index()].take();
      if (here.empty()) continue;
      counted += here.size();
      if (counted > most_) fail(id, here.size(), counted);
      if (here.size() >= 2 * asked) {
        asked = here.size();
        const std::size_t all = counted + below(id) * here.size();
        if (all > most_) fail(id, here.size(), all);
      }
      if (const std::optional<Transform>& own = tree_.nodes[id].transform) {
        const std::optional<Matrix> map = matrix(*own);
        if (!map) return;
        for (Row& row : here) row = (*map)(row);
      }
      for (const NodeId operand : operands(id)) places[operand.index()].add(here);
    }
  }

 private:
  static constexpr std::size_t kWorthAsking = 1024;

  /// Each once.
  std::vector<NodeId> operands(NodeId id) const {
    std::vector<NodeId> all = tree_.operands_within(id);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  bool few_ways() const {
    std::vector<std::size_t> ways(tree_.nodes.size(), 0);
    for (const NodeId root : roots_) ways[root.index()] = 1;
    std::size_t all = 0;
    for (const NodeId id : order_) {
      const std::size_t here = ways[id.index()];
      if (here == 0) continue;
      all += here;
      if (all > most_) return false;
      for (const NodeId operand : operands(id)) ways[operand.index()] += here;
    }
    return true;
  }

  std::size_t below(NodeId id) const {
    const std::vector<char> reached = tree_.dag->reachable({id});
    return static_cast<std::size_t>(std::count_if(reached.begin(), reached.end(), [](char c) { return c != 0; })) -
           1;
  }

  [[noreturn]] void fail(NodeId id, std::size_t places, std::size_t instances) const {
    const Node& node = tree_.nodes[id];
    std::string text = "the tree unfolds to more than " + std::to_string(most_) + " instances, to " +
                       std::to_string(instances) + " at least";
    if (places > 1) {
      text += ": `" + node.name + "` stands at " + std::to_string(places) +
              " places, and every node below it at as many or more";
    }
    throw TreeError(tree_.file, node.at, text + "; share nodes under one transform or use fewer copies");
  }

  const Tree& tree_;
  const std::vector<NodeId>& roots_;
  const std::size_t most_;
  std::vector<NodeId> order_;
};

}  // namespace

void refuse_too_many_instances(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most) {
  Counter(tree, roots, most).run();
}

}  // namespace cnrg
