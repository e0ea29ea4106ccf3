// One pass over the faces of the value: the complex knows on which side of each the front of its source is.
#include "csg/operators/sides.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "csg/operators/component_lists.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

template <class Faces, class FaceAt, class ComponentAt>
TouchedSides touched(const Complex& complex, const Origins& origins, const Faces& faces, std::size_t count,
                     const FaceAt& face_at, const ComponentAt& component_at) {
  TouchedSides out(count);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const FaceId f = face_at(faces[k]);
    const auto came_from = origins.sets[origins.faces[k]];
    for (const Cover& cover : complex.cover(f)) {
      const LeafId leaf = complex.sources[cover.source].leaf;
      if (complex.leaf_regions[leaf] != 0 || !std::binary_search(came_from.begin(), came_from.end(), leaf))
        continue;
      for (const HalfFace side : {HalfFace(f, 0), HalfFace(f, 1)}) {
        const Component c = component_at(complex.region(side));
        if (c != 0) out[c - 1].push_back({leaf, (side.side() == 0) == cover.same});
      }
    }
  }
  for (std::vector<SurfaceSide>& sides : out) sort_unique(sides);
  return out;
}

/// By name, those that are not both of them there.
std::map<std::string, bool> by_name(const std::vector<SurfaceSide>& touched,
                                    const std::function<std::string(LeafId)>& name_of) {
  std::map<std::string, bool> sides;
  std::set<std::string> both;
  for (const SurfaceSide& side : touched) {
    const std::string name = name_of(side.surface);
    if (sides.try_emplace(name, side.front).first->second != side.front) both.insert(name);
  }
  std::erase_if(sides, [&](const auto& side) { return side.first.empty() || both.contains(side.first); });
  return sides;
}

}  // namespace

TouchedSides touched_sides(const Complex& complex, const Group& group) {
  return touched(
      complex, group.origins, group.faces, group.regions.size(), [](FaceId f) { return f; },
      [&](RegionId r) { return group.region_of(r); });
}

TouchedSides touched_sides(const Complex& complex, const Components& components) {
  const Selection& selection = components.selection;
  return touched(
      complex, components.origins, selection.faces, components.attributes.size(),
      [](const auto& entry) { return entry.first; },
      [&](RegionId r) { return component_in(selection.regions, r); });
}

bool lies_on(const std::vector<SurfaceSide>& touched, std::span<const LeafId> surfaces, bool front) {
  bool found = false;
  for (const SurfaceSide& side : touched) {
    if (!std::binary_search(surfaces.begin(), surfaces.end(), side.surface)) continue;
    if (side.front != front) return false;
    found = true;
  }
  return found;
}

std::vector<std::vector<NamedSide>> named_sides(const Complex& complex, const NodeValue& value,
                                                const std::function<std::string(LeafId)>& name_of) {
  TouchedSides touched =
      value.is_group() ? touched_sides(complex, value.group()) : touched_sides(complex, value.components());
  touched.resize(value.component_count());    // entities of a group touch nothing
  std::map<std::string, std::size_t> pieces;  // by their name
  std::map<std::pair<std::string, std::pair<std::string, bool>>, std::size_t> there;  // pieces on a side
  std::vector<std::map<std::string, bool>> sides;
  for (Component i = 1; i <= touched.size(); ++i) {
    const std::string& name = value.attributes(i).name.text();
    ++pieces[name];
    for (const auto& side : sides.emplace_back(by_name(touched[i - 1], name_of))) ++there[{name, side}];
  }
  std::vector<std::vector<NamedSide>> out(touched.size());
  for (Component i = 1; i <= touched.size(); ++i) {
    const std::string& name = value.attributes(i).name.text();
    for (const auto& [surface, front] : sides[i - 1]) {
      const bool all = there.at({name, {surface, front}}) == pieces.at(name);
      out[i - 1].push_back({surface, front, !all});
    }
  }
  return out;
}

}  // namespace cnrg
