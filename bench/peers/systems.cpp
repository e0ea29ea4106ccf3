#include <cmath>

#include "bench/peers/built_in.h"

namespace cnrg::bench {
namespace {

/// A power of two that makes the largest coordinate lie from 2^exponent to below 2^(exponent + 1). 1 if all are
/// zero.
Rational scale_to(const std::vector<Model>& models, int exponent) {
  Rational largest = 0;
  for (const Model& model : models)
    for (const RationalPoint& p : model.points)
      for (const Rational& x : p)
        if (abs(x) > largest) largest = abs(x);
  if (largest == 0) return 1;
  int binary = 0;  // largest is in [2^(binary - 1), 2^binary)
  std::frexp(to_double(largest), &binary);
  return from_double(std::ldexp(1.0, exponent - (binary - 1)));
}

void multiply(Model& model, const Rational& scale) {
  for (RationalPoint& p : model.points)
    for (Rational& x : p) x *= scale;
}

}  // namespace

System rescaled(System system, int exponent, double rounding) {
  system.title += " (scaled)";
  system.guarantee += "; operands are multiplied by a power of two, so that their largest coordinate is 2^" +
                      std::to_string(exponent) + " or more, and its results are divided by it";
  system.rounding = rounding;
  system.arrange = {};  // of operands as they are
  system.evaluate = [exponent, plain = std::move(system.evaluate)](const Problem& problem) {
    const Rational scale = scale_to(problem.operands, exponent);
    Problem there = problem;
    for (Model& operand : there.operands) multiply(operand, scale);
    Answer answer = plain(there);
    multiply(answer.model, 1 / scale);
    return answer;
  };
  return system;
}

namespace {

System with_suffix(System system) {
  system.name += "-rescaled";
  return system;
}

}  // namespace

std::vector<System> systems() {
  std::vector<System> all{
      our_system(),
      our_tree_system(),
      mantyla_double_system(),
      mantyla_exact_system(),
      nef_system(),
      corefinement_system(),
      occt_system(),
      with_suffix(rescaled(occt_system(), 9, 1e-9)),  // a part in millimetres
      openscad_system(),
      with_suffix(rescaled(openscad_system(), 32, 0x1p-50))};  // then 52 bits are above its grid
  for (System& published : mantyla_published_systems()) all.push_back(std::move(published));
  return all;
}

}  // namespace cnrg::bench
