// Do two values mean the same? The answer of `cnrg compare`, for people and for programs: a text, and the same
// facts as JSON, whose members are in csg/explain/answers.schema.json. What it is made of is in compare.h.
#pragma once

#include <string>

#include "csg/tree/tree.h"
#include "kernel/base/progress.h"

namespace cnrg {

struct CompareOptions {
  int threads = 0;
  bool components = true;  ///< false: the point sets alone
  bool materials = true;
  bool names = true;
  bool attributes = true;  ///< keys with values
  bool features = true;    ///< which cells are left after simplification
  Watch watch{};
};

struct Difference {
  bool same = true;
  std::string text, json;  ///< the text is empty if they are the same
};

/// The values of two nodes compared. Throws what `evaluate` does, faults of a tree as if it were evaluated alone.
Difference difference(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b,
                      const CompareOptions& options = {});

}  // namespace cnrg
