// Group operators work on parts and seldom need the group as a whole, so it is merged when somebody asks, once for
// all threads.
#include "csg/operators/node_value.h"

#include <algorithm>
#include <numeric>

#include "csg/leaves/geometry_leaf.h"
#include "csg/operators/cell_sources.h"
#include "csg/operators/component_lists.h"
#include "kernel/base/error.h"
#include "kernel/complex/region_order.h"
#include "kernel/selection/scratch.h"

namespace cnrg {

const PartedGroup& NodeValue::parts() const {
  require(is_group(), "a group was asked of a value of components");
  return std::get<PartedGroup>(held_);
}

PartedGroup& NodeValue::parts() {
  require(is_group(), "a group was asked of a value of components");
  whole_ = std::make_unique<Whole>();  // the caller may change the parts, and the whole would be out of date
  return std::get<PartedGroup>(held_);
}

const Group& NodeValue::group() const {
  const PartedGroup& value = parts();
  if (value.parts.size() == 1 && value.parts[0]->group().dominance == value.dominance) {
    return value.parts[0]->group();
  }
  std::call_once(whole_->once, [&] { whole_->group = whole(value); });
  return *whole_->group;
}

const Components& NodeValue::components() const {
  require(!is_group(), "components were asked of a group");
  return std::get<Components>(held_);
}

Components& NodeValue::components() {
  require(!is_group(), "components were asked of a group");
  return std::get<Components>(held_);
}

const Features& NodeValue::features() const {
  static const Features none;
  return is_group() ? group().features : none;
}

const Origins& NodeValue::origins() const { return is_group() ? group().origins : components().origins; }

std::size_t NodeValue::component_count() const {
  if (!is_group()) return components().attributes.size();
  return group().regions.size() + (group().has_entities() ? 1 : 0);
}

const RegionAttributes& NodeValue::attributes(Component i) const {
  static const RegionAttributes entities{{.name = Name::of_entities()}, {}};
  if (!is_group()) return components().attributes.at(i - 1);
  return i <= group().regions.size() ? group().regions[i - 1] : entities;
}

std::vector<RegionAttributes> NodeValue::attributes() const {
  std::vector<RegionAttributes> out;
  for (Component i = 1; i <= component_count(); ++i) out.push_back(attributes(i));
  return out;
}

std::vector<const Attributes*> all_said(const NodeValue& value) {
  std::vector<const Attributes*> out;
  for (Component i = 1; i <= value.component_count(); ++i) out.push_back(&value.attributes(i));
  const LeafSets& sets = value.origins().sets;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (const SaidPointer& said = sets.said(LeafSetId(s))) out.push_back(&said->attributes);
  }
  return out;
}

std::unique_ptr<const ValueSources> sources_of(const Complex& complex, const NodeValue& value) {
  if (value.is_group()) return std::make_unique<GroupSources>(complex, value.group());
  return std::make_unique<ComponentSources>(complex, value.components());
}

const Attributes* said_of(const Complex& complex, const NodeValue& value, const Location& cell) {
  const std::unique_ptr<const ValueSources> sources = sources_of(complex, value);
  switch (cell.dimension) {
    case 0: return sources->said(cell.vertex);
    case 1: return sources->said(cell.edge);
    case 2: return sources->said(cell.face);
    default: return nullptr;
  }
}

Selection selection_of(const Complex& complex, const NodeValue& value) {
  return value.is_group() ? selection_of(complex, value.group()) : value.components().selection;
}

SimplifiedComplex simplify(const Complex& complex, const NodeValue& value, const Selection& selection,
                           SimplifyMode mode) {
  return simplify(complex, selection, value.features(), mode, sources_of(complex, value).get());
}

std::array<std::size_t, 4> simplified_counts(const Complex& complex, const NodeValue& value,
                                             const Selection& selection) {
  return simplified_counts(complex, selection, value.features(), SimplifyMode::features,
                           sources_of(complex, value).get());
}

Components components_of(const Complex& complex, const NodeValue& value) {
  return value.is_group() ? components_of(complex, value.group()) : value.components();
}

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
