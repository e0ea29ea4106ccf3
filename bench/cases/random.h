// Numbers from a seed, the same with every standard library (whose distributions are not).
#pragma once

#include <random>

namespace cnrg::bench {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  /// From low to high, both included.
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }
  double real(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }

 private:
  std::mt19937 engine_;
};

}  // namespace cnrg::bench
