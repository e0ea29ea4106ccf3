// Intervals where the rounding mode cannot be changed (WebAssembly): 1 + 1e-300, 1/3 and a product that vanishes
// have to lie between two doubles. The exit status is 1 if one of them is a point.
#include <initializer_list>
#include <iostream>
#include <sstream>

#include "kernel/exact/enclosure.h"

namespace cnrg {
namespace {

using enclosure::Interval;

/// The compiler is not to know the numbers.
Interval read(const char* text) {
  double value = 0;
  std::istringstream(text) >> value;
  return Interval(value);
}

int points_among(std::initializer_list<Interval> sums) {
  int points = 0;
  std::cout.precision(17);
  for (const Interval& x : sums) {
    std::cout << x.inf() << " " << x.sup() << "\n";
    points += !(x.inf() < x.sup());
  }
  return points;
}

int run() {
  const enclosure::RoundOutward rounding;
  const Interval one = read("1"), tiny = read("1e-300");
  const Interval sum = one + tiny, third = one / read("3"), none = tiny * tiny;
  const enclosure::Upward above = enclosure::Upward(one.sup()) + tiny.sup();
  const bool enclosed = double(above) > 1 && sum.inf() <= 1 && sum.sup() > 1 && third.inf() < third.sup() &&
                        none.inf() <= 0 && none.sup() > 0;
  const int exact = points_among({one + one, read("3") * read("0.25"), read("1") / read("4"), one - one});
  return points_among({sum, third, none}) > 0 || exact != 4 || !enclosed ? 1 : 0;
}

}  // namespace
}  // namespace cnrg

int main() { return cnrg::run(); }
