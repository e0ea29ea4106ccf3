// A value made by hand as a result: its cells simplified and put in the order of files, names for what it shows. A
// selection does not know which leaves made its cells; each then comes from all the leaves that hold it.
#include "csg/result/result.h"

#include <algorithm>
#include <set>

#include "csg/materials/grade.h"
#include "csg/result/result_data.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/canonical.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

std::shared_ptr<const Result::Data> data_of(std::shared_ptr<const Complex> complex, NodeValue value,
                                            ResultNames names, SimplifyMode mode) {
  auto data = std::make_shared<Result::Data>();
  SimplifiedComplex simplified = simplify(*complex, value, selection_of(*complex, value), mode);
  put_in_order(*complex, simplified);
  data->simplified = std::make_shared<const SimplifiedComplex>(std::move(simplified));
  data->complex = std::move(complex);
  data->value = std::make_shared<const NodeValue>(std::move(value));
  data->raw = mode == SimplifyMode::raw;
  names.leaves.resize(data->complex->leaf_count);
  data->name(std::move(names));
  return data;
}

/// The leaves that hold a cell, boundaries included.
template <class IdT>
std::vector<LeafSetId> origins_of(const Complex& complex, const std::vector<std::pair<IdT, Component>>& cells,
                                  LeafSets& sets) {
  std::vector<LeafId> all, leaves;
  for (const LeafId leaf : IdRange<LeafId>(complex.leaf_count)) all.push_back(leaf);
  std::vector<LeafSetId> origins;
  for (const auto& [cell, component] : cells) {
    leaves.clear();
    for (const LeafCell& on : leaf_cells(complex, cell, all)) {
      if (leaves.empty() || leaves.back() != on.leaf) leaves.push_back(on.leaf);
    }
    origins.push_back(sets.intern(leaves));
  }
  return origins;
}

Components components_by_selection(const Complex& complex, Selection selection) {
  Components out;
  Component count = 0;
  const auto see = [&](const auto& cells) {
    for (const auto& [cell, component] : cells) count = std::max(count, component);
  };
  for_each_dimension(see, selection);
  out.attributes.resize(count);
  for_each_dimension(
      [&](const auto& cells, auto& origins) { origins = origins_of(complex, cells, out.origins.sets); }, selection,
      out.origins);
  out.selection = std::move(selection);
  return out;
}

}  // namespace

void Result::Data::name(ResultNames names) {
  node = std::move(names.result);
  for (std::string& leaf : names.leaves)
    leaves.push_back({std::move(leaf), static_cast<std::uint32_t>(leaves.size())});
  for (ResultNames::Material& m : names.materials) materials.push_back({std::move(m.name), std::move(m.color)});
  std::set<std::string> known;
  for (const ResultView::Material& m : materials) known.insert(m.name);
  const auto add = [&](const std::string& material) {
    if (!material.empty() && known.insert(material).second) materials.push_back({material, ""});
  };
  std::set<const PlacedGrade*> grades;
  for (const Attributes* said : all_said(*value)) {
    const RegionMaterial& material = said->material;
    add(material.name());
    if (material.grade() == nullptr || !grades.insert(material.grade()).second) continue;
    for_each_name(*material.grade(), add);
  }
}

ResultView Result::Data::view(bool with_parameters) const {
  ResultView view;
  view.node = node;
  view.complex = complex.get();
  view.value = value.get();
  view.simplified = simplified.get();
  view.leaves = &leaves;
  view.materials = materials;
  view.of_group = of_group;
  view.region_parts = region_parts.get();
  view.volume_bound = volume_bound;
  if (with_parameters) view.parameters = parameters.get();
  return view;
}

Result::Result(std::shared_ptr<const Complex> complex, Group group, ResultNames names, SimplifyMode mode) {
  NodeValue value(*complex, std::move(group));
  data_ = data_of(std::move(complex), std::move(value), std::move(names), mode);
}

Result::Result(std::shared_ptr<const Complex> complex, Components components, ResultNames names, SimplifyMode mode)
    : data_(data_of(std::move(complex), NodeValue(std::move(components)), std::move(names), mode)) {}

Result::Result(std::shared_ptr<const Complex> complex, Selection selection, ResultNames names, SimplifyMode mode) {
  NodeValue value(components_by_selection(*complex, std::move(selection)));
  data_ = data_of(std::move(complex), std::move(value), std::move(names), mode);
}

const std::string& Result::name() const { return data_->node; }
const Complex& Result::complex() const { return *data_->complex; }
const SimplifiedComplex& Result::cells() const { return *data_->simplified; }
std::size_t Result::component_count() const { return data_->value->component_count(); }
const RegionAttributes& Result::attributes(Component i) const { return data_->value->attributes(i); }
Selection Result::selection() const { return selection_of(*data_->complex, *data_->value); }

std::optional<Rational> Result::volume(Component i) const {
  return cnrg::volume(*data_->complex, support(selection(), i).regions);
}

SimplifiedComplex::Place Result::place(const Location& location) const {
  return data_->simplified->place(*data_->complex, location);
}

}  // namespace cnrg
