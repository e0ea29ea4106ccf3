// Which names count. A region that nobody named is called after its node; the nodes of an answer to an exercise
// may be called anything.
#pragma once

#include <array>
#include <string>

#include "csg/compare/together.h"

namespace cnrg {

class Names {
 public:
  /// `together` must outlive this.
  explicit Names(const Together& together) : together_(together) {}
  /// As the program shows it.
  std::string plain(const std::string& name) const;
  /// Two names differ where one of them has a word that the other one has not and that somebody gave: by `name`,
  /// in a group, in a CAD model. Words of a result that was read back may be either; they differ from given ones
  /// and from each other, not from those of nodes.
  bool differ(const std::string& in_a, const std::string& in_b) const;

 private:
  const Together& together_;
};

}  // namespace cnrg
