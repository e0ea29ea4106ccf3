// What becomes of mesh files, each in a process of its own: a line per case and a count of each kind of end.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "bench/cases/child.h"

namespace cnrg::bench {

/// The files among `paths` and the meshes (.off .obj .stl .ply) in its folders, searched through; sorted.
std::vector<std::string> mesh_files(const std::vector<std::string>& paths);

struct MeshCase {
  std::string name;
  std::function<std::string()> work;  ///< returns a line whose first word is its kind
};

/// Runs each case within the limits and prints its line: what the work returned; `error` with the message of an
/// InputError or FileError, `BUG` with that of an InvariantError; or CRASH, TIMEOUT, OOM. Then how often each kind
/// was. Returns the exit status: 1 if there was a kind that is neither `error` nor in `good`.
int run_cases(const std::vector<MeshCase>& cases, const Limits& limits, const std::set<std::string>& good);

}  // namespace cnrg::bench
