// Families of problems for experiments on robustness: each by a size, a seed and a distance to degeneracy.
//
// A problem is a fold: ((m0 op1 m1) op2 m2) ... . The families of this source are made by `ProblemId`; which ones
// a sweep has is said in bench/experiments.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/cases/model.h"
#include "bench/cases/operation.h"
#include "csg/tree/tree.h"

namespace cnrg::bench {

struct Problem {
  std::string name;                    ///< see `ProblemId`
  std::vector<Model> operands;         ///< faces have one loop each
  std::vector<Operation> steps;        ///< one less; step i takes operand i + 1
  std::shared_ptr<const Tree> tree{};  ///< that it is a node of, if it is
  NodeId node{};
  bool solids() const;                 ///< all operands are
  std::size_t triangle_count() const;  ///< of all operands
};

/// `FAMILY-OPERATION-sSIZE-kDISTANCE-rSEED`, such as `edge-union-s4-k7-r3`. A file's name can be made of it.
struct ProblemId {
  std::string family;
  std::string operation;  ///< `union`, `difference`, `intersection`; `fold` where the family mixes them
  long size = 1;
  /// k: the operands are 10^-k of their size away from the degenerate position; `kexact` in names when there is
  /// none: they are in it.
  std::optional<int> distance;
  unsigned seed = 1;
  std::string name() const;
};

/// Makes a problem of a family. Throws std::runtime_error with what is known for an unknown family, an operation
/// or a size that the family does not have, and a distance out of 0 to 16; `check_problem` does that alone.
Problem make_problem(const ProblemId& id);
void check_problem(const ProblemId& id);

/// Problems of a folder of mesh files (OFF, OBJ, STL, PLY; searched through), by name: of files that belong
/// together by their names (`x_left` and `x_right`, `src-x` and `cut-x`, `xA` and `xB`), and of each other file
/// and its copy turned about its middle. An open mesh is a surface, and so is one without volume. Names are as
/// `files-union-a+x_left.off-x_right.off`, paths below the folder with `+` for `/`. Throws
/// std::runtime_error for another operation than those of operation.h.
std::vector<std::string> folder_problems(const std::string& folder, const std::string& operation = "union");
/// Throws std::runtime_error, or as the reader of mesh leaves does.
Problem make_folder_problem(const std::string& folder, const std::string& name);

}  // namespace cnrg::bench
