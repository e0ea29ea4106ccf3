// The classification of the paper (pereira2012 3), beside the propagation that the engine of the tables uses.
//
// The paper locates each vertex among the other group's regions; an edge takes the class of one of its vertices
// that is not INTERS, a face that of such a vertex of its outer loop; an edge or face whose vertices are all
// INTERS is located by an interior point. A test holds both equal.
#pragma once

#include <vector>

#include "csg/operators/group.h"

namespace cnrg {

enum class Classification : std::uint8_t { inters, in, out };

/// Parallel to `vertices`, `edges` and `faces` of the classified group.
struct GroupClassification {
  std::vector<Classification> vertices, edges, faces;
  friend bool operator==(const GroupClassification&, const GroupClassification&) = default;
};

/// By point location: rays against the faces of `other` alone.
GroupClassification classify_by_location(const Complex& complex, const Group& group, const Group& other);
/// By the labels of the 3-cells around each entity.
GroupClassification classify_by_propagation(const Complex& complex, const Group& group, const Group& other);

}  // namespace cnrg
