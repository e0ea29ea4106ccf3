// Classes of numbers that grow together: union and find.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cnrg {

class Classes {
 public:
  /// A new number, in a class of its own.
  std::size_t add() {
    up_.push_back(up_.size());
    return up_.size() - 1;
  }
  void join(std::size_t a, std::size_t b) {
    a = first_of(a);
    b = first_of(b);
    up_[std::max(a, b)] = std::min(a, b);
  }
  /// The least number of the class.
  std::size_t first_of(std::size_t a) {
    while (up_[a] != a) {
      up_[a] = up_[up_[a]];
      a = up_[a];
    }
    return a;
  }

 private:
  std::vector<std::size_t> up_;
};

}  // namespace cnrg
