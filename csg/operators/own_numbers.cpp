#include "csg/operators/own_numbers.h"

#include <algorithm>
#include <numeric>

#include "csg/leaves/geometry_leaf.h"
#include "csg/operators/component_lists.h"
#include "kernel/complex/region_order.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

std::vector<Component> own_numbers(const Complex& complex, const Group& group, const Transform& transform) {
  std::vector<Component> numbers(group.regions.size() + 1);
  std::iota(numbers.begin(), numbers.end(), Component{0});
  if (numbers.size() <= 2 || transform.identity()) return numbers;
  const std::optional<LeafAxes> axes = moved_axes(nullptr, transform);
  if (!axes) return numbers;
  Scratch<RegionId, Component> region_of(complex.region_count);
  Marks<FaceId> faces(complex.face_count());
  for (const auto& [cell, region] : group.cells) {
    region_of[cell] = region;
    for (const HalfFace h : complex.region_faces[cell]) faces[h.face()] = 1;
  }
  const BodiesOfSpace bodies{faces.ids(), [&](HalfFace h) { return region_of.get(complex.region(h)); },
                             static_cast<std::uint32_t>(numbers.size())};
  const std::vector<std::uint32_t> order = in_order_of_place(complex, bodies, &*axes);
  for (std::size_t i = 0; i < order.size(); ++i) numbers[order[i]] = static_cast<Component>(i + 1);
  return numbers;
}

Components components_of(const Complex& complex, const NodeValue& value, const Transform& transform) {
  Components out = components_of(complex, value);
  if (!value.is_group()) return out;
  const std::vector<Component> numbers = own_numbers(complex, value.group(), transform);
  if (std::is_sorted(numbers.begin(), numbers.end())) return out;
  const auto own = [&](Component c) { return c < numbers.size() ? numbers[c] : c; };
  const auto renumber = [&](auto& list) {
    for (auto& [cell, component] : list) component = own(component);
  };
  for_each_dimension(renumber, out.selection);
  const std::vector<ComponentAttributes> attributes = out.attributes;
  for (Component c = 1; c <= attributes.size(); ++c) out.attributes[own(c) - 1] = attributes[c - 1];
  return out;
}

}  // namespace cnrg
