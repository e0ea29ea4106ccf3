// Rows of small trees, and random places for them.
#pragma once

#include <array>
#include <random>
#include <string>

#include "csg/evaluate/evaluate.h"

namespace cnrg {

using Cells = std::array<std::size_t, 4>;

inline Evaluation evaluated(const std::string& nodes, const std::string& result = "model",
                            AskedProof proof = AskedProof::within_budget) {
  EvaluateOptions options;
  options.validate = true;
  options.proof = proof;
  return evaluate(parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: " + result + "\n", "t.yaml"), options);
}
inline NodeRow row(const std::string& nodes) { return evaluated(nodes).rows.back(); }

inline std::string number(long value) { return std::to_string(value); }

/// A random vector of small whole numbers, not zero.
inline std::string direction(std::mt19937_64& random) {
  std::uniform_int_distribution<int> some(-4, 4);
  int x = 0, y = 0, z = 0;
  while (x == 0 && y == 0 && z == 0) x = some(random), y = some(random), z = some(random);
  return "[" + number(x) + ", " + number(y) + ", " + number(z) + "]";
}

/// A random rotation and shift, the same text each time it is used.
inline std::string placed(std::mt19937_64& random) {
  std::uniform_int_distribution<int> degrees(1, 359), shift(-30, 30);
  return ", rotate: {axis: " + direction(random) + ", degrees: " + number(degrees(random)) + "}, translate: [" +
         number(shift(random)) + ".3, " + number(shift(random)) + ".7, " + number(shift(random)) + "]";
}

}  // namespace cnrg
