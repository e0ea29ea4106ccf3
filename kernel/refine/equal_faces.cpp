// In a mesh that meets no other, every side is one of two faces in opposite directions. A face with such a side
// has one equal face at most, so it is not looked up: meshes in general position cost nothing.
#include "kernel/refine/equal_faces.h"

#include <algorithm>
#include <map>

namespace cnrg {

EqualFaces equal_faces(const RefineInput& in) {
  std::vector<std::pair<std::uint64_t, SourceId>> faces;  // by the least and the greatest side
  for (const SourceId f : IdRange<SourceId>(in.corners.size())) {
    const auto sides = in.sides[f];
    if (sides.empty() || in.paired[sides[0]] != 0) continue;
    const auto [least, greatest] = std::ranges::minmax(sides);
    faces.emplace_back(std::uint64_t{least.value()} << 32 | greatest.value(), f);
  }
  std::sort(faces.begin(), faces.end());
  EqualFaces equal;
  for (auto begin = faces.begin(), end = begin; begin != faces.end(); begin = end) {
    end = std::find_if(begin, faces.end(), [&](const auto& face) { return face.first != begin->first; });
    if (end - begin == 1) continue;
    std::map<std::vector<SegmentId>, SourceId> by_sides;
    for (auto face = begin; face != end; ++face) {
      std::vector<SegmentId> sides(in.sides[face->second].begin(), in.sides[face->second].end());
      std::sort(sides.begin(), sides.end());
      const SourceId first = by_sides.try_emplace(std::move(sides), face->second).first->second;
      if (first != face->second) equal.pairs.emplace_back(first, face->second);
    }
  }
  if (equal.pairs.empty()) return equal;
  equal.copies.assign(in.corners.size(), 1);
  for (const auto& [first, other] : equal.pairs) {
    ++equal.copies[first.index()];
    equal.copies[other.index()] = 0;
  }
  return equal;
}

}  // namespace cnrg
