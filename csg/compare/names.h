// Which names count. A region that nobody named is called after its node; the nodes of an answer to an exercise
// may be called anything.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "csg/compare/together.h"

namespace cnrg {

class Names {
 public:
  Names(std::string mark_of_nodes, std::array<Given, 2> given)
      : mark_(std::move(mark_of_nodes)), given_(std::move(given)) {}
  /// As the program shows it.
  std::string plain(const std::string& name) const;
  /// Two names differ where one of them has a word that the other one has not and that somebody gave: by `name`,
  /// in a group, in a CAD model. Words of a result that was read back may be either; they differ from given ones
  /// and from each other, not from those of nodes.
  bool differ(const std::string& in_a, const std::string& in_b) const;

 private:
  std::string mark_;
  std::array<Given, 2> given_;
};

}  // namespace cnrg
