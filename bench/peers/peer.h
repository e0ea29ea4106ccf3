// Systems that unite two closed meshes, behind one face.
//
// `unite` times from the system's own input structure in memory to its result in memory; making the structure from
// the triangles and checking the result (`check`: volume, invariants) are not timed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/cases/triangle_mesh.h"

namespace cnrg::bench {

struct Outcome {
  std::vector<std::pair<std::string, double>> stages;  ///< seconds
  std::size_t vertices = 0, faces = 0;                 ///< of the result, as the system counts them
  double volume = 0;  ///< of the result if checked, rounded from the exact value if any
  std::string note;
  double seconds() const;
};

struct Peer {
  const char* name;
  Outcome (*unite)(const TriangleMesh& a, const TriangleMesh& b, bool check);
};

Outcome unite_ours(const TriangleMesh& a, const TriangleMesh& b, bool check);          ///< all threads
Outcome unite_ours_one_thread(const TriangleMesh& a, const TriangleMesh& b, bool check);
Outcome unite_corefinement(const TriangleMesh& a, const TriangleMesh& b, bool check);  ///< CGAL, EPICK, in place
Outcome unite_nef(const TriangleMesh& a, const TriangleMesh& b, bool check);  ///< CGAL, conversion and Boolean

/// Seconds since the last call, or since construction.
class Stopwatch {
 public:
  Stopwatch();
  double lap();

 private:
  double last_;
};

}  // namespace cnrg::bench
