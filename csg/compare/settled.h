// A tree with `weld`, compared.
//
// What is near is joined among the leaves of that tree alone, before anything cuts anything. Among the leaves of
// two trees more would be near, and differences would go with it. So such a tree is evaluated by itself, and what
// is compared is its result, exact as a `.json` holds it.
#pragma once

#include "csg/compare/together.h"
#include "csg/text/child.h"

namespace cnrg {

class Settled {
 public:
  /// Evaluates the node. InputError if the result reaches infinity, which no `.json` can give back.
  Settled(const Tree& tree, NodeId node, int threads);
  /// One leaf, the result; of use as long as this lives.
  const Tree& tree() const { return tree_; }

 private:
  MemoryFile file_;
  Tree tree_;
};

}  // namespace cnrg
