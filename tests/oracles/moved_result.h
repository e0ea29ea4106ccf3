// A result whose points have been moved, held against the one before: by points in space, sums over triangles, and
// distances of all pairs of parts in doubles. It knows nothing of how cells were told what they are.
//
// Each function returns the first difference in words, or an empty string.
#pragma once

#include <string>
#include <vector>

#include "csg/result/result.h"

namespace cnrg::properties {

/// What is told of a move.
struct ToldMove {
  double displacement = 0;                ///< no point moved farther
  std::vector<std::string> lost_regions;  ///< as of JoinReport and SnapReport
};

/// What holds of every moved result: it is a complex; what lies farther than the displacement from all faces
/// before is in a region of the same name, material and attributes as it was; volumes by these differ by no more
/// than the moved faces can sweep; each face, edge and vertex that stands for itself is what something within the
/// displacement was; and every region of which nothing is left is in the list.
std::string moved_failure(const Result& before, const Result& after, const ToldMove& told);

/// Two parts that share no point and are nearer than `within`, as near.h has it, by comparing all with all.
std::string near_failure(const Result& result, double within);

/// Written as `.json` into the folder and read: the same components, cells, volumes; written again and read, the
/// same text.
std::string file_failure(const Result& result, const std::string& folder);

}  // namespace cnrg::properties
