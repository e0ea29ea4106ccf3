// A group sums up what its parts know. Components have no parts: each value of them is counted and measured anew.
#include "csg/evaluate/rows.h"

#include <tbb/parallel_for.h>

#include <map>
#include <utility>

#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

std::array<std::size_t, 4> raw_counts(const Selection& selection) {
  return {selection.vertices.size(), selection.edges.size(), selection.faces.size(), selection.regions.size()};
}

/// One more region or component with 3-cells; nothing for an unbounded one.
void add_region(const std::optional<Rational>& volume, NodeRow& row) {
  ++row.regions;
  if (row.total && volume) *row.total += *volume;
  else row.total.reset();
}

void fill_group(const Complex& complex, NodeValue& value, const SimplifiedValue* simplified, NodeRow& row) {
  if (simplified == nullptr) return fill_totals(totals_of(complex, value.parts()), row);
  row.raw_cells = simplified->counts().raw;
  row.cells = simplified->counts().simplified;
  row.total = Rational(0);
  for (const PartRef& part : std::as_const(value).parts().parts) {
    row.regions += part->group().regions.size();
    const PartVolume& volume = part->volume(complex);
    if (row.total && volume.unbounded == 0) *row.total += volume.bounded;
    else row.total.reset();
  }
}

void fill_group_regions(const Complex& complex, const PartedGroup& group, NodeRow& row) {
  row.volumes = volumes(complex, group);
  for (const auto& [part, region] : region_order(group)) {
    const auto number = static_cast<Component>(row.named.size() + 1);
    row.named.emplace_back(number, group.parts[part]->group().regions[region - 1].name);
  }
}

void fill_components(const Complex& complex, const NodeValue& value, bool region_volumes,
                     const SimplifiedValue* simplified, NodeRow& row) {
  const Selection& selection = value.components().selection;
  row.components = value.component_count();
  row.raw_cells = raw_counts(selection);
  row.cells =
      simplified != nullptr ? simplified->counts().simplified : simplified_counts(complex, value, selection);
  row.total = Rational(0);
  std::map<Component, std::vector<RegionId>> cells;
  for (const auto& [cell, component] : selection.regions) cells[component].push_back(cell);
  for (const auto& [component, list] : cells) {
    std::optional<Rational> one = volume(complex, list);
    add_region(one, row);
    if (!region_volumes) continue;
    row.volumes.push_back(std::move(one));
    row.named.emplace_back(component, value.attributes(component).name);
  }
}

}  // namespace

NodeRow row_of(const Tree& tree, const Unfolding& unfolding, InstanceId id) {
  const Instance& instance = unfolding.instances[id];
  const Node& node = tree.nodes[instance.node];
  NodeRow row;
  row.node = instance.node;
  row.name = unfolding.count[instance.node] == 1 ? node.name : node.name + "#" + std::to_string(instance.number);
  row.operator_name = node.operator_name;
  return row;
}

void fill_totals(const Totals& totals, NodeRow& row) {
  row.raw_cells = totals.raw;
  row.cells = totals.simplified;
  row.regions = totals.regions;
  row.total = totals.volume();
}

void fill_totals(const Complex& complex, NodeValue& value, bool region_volumes, const SimplifiedValue* simplified,
                 NodeRow& row) {
  row.is_group = value.is_group();
  if (!value.is_group()) return fill_components(complex, value, region_volumes, simplified, row);
  fill_group(complex, value, simplified, row);
  if (region_volumes) fill_group_regions(complex, std::as_const(value).parts(), row);
}

void prepare_totals(const Complex& complex, ValueStore& values) {
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
    const InstanceId id(i);
    if (!values.has(id) || !values[id].is_group()) return;
    for (const PartRef& part : std::as_const(values[id]).parts().parts) {
      part->counts(complex);
      part->volume(complex);
    }
  });
}

}  // namespace cnrg
