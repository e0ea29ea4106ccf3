// The tags of a cell: its numbers in the flattened result, then its material and the first leaf that it came from.
#include "csg/result/cell_tags.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "kernel/base/sorted.h"

namespace cnrg {

std::int32_t CellTagger::region_number(FlatComplex::Index region) const {
  return flat_.active(region) ? std::int32_t(flat_.regions[region].component) : 0;
}

std::vector<std::vector<NamedSide>> named_sides(const ResultView& view) {
  return named_sides(*view.complex, *view.value, [&](LeafId leaf) {
    const bool named = view.leaves != nullptr && leaf.index() < view.leaves->size();
    return named ? (*view.leaves)[leaf.index()].name : std::string();
  });
}

Component material_component(const ResultView& view, const CellTags& tags) {
  const bool entity = (view.value->is_group() || view.of_group) && tags.dimension < 3;
  return Component(entity ? tags.region : tags.component);
}

PropertyFields::PropertyFields(const ResultView& view) {
  std::map<std::string, std::set<Property>> values;
  for (const Attributes* said : all_said(*view.value)) {
    for (const auto& [key, value] : said->properties) values[key].insert(value);
  }
  for (const auto& [key, of_key] : values) {
    Field& field = fields_.emplace_back();
    field.key = key;
    field.numeric = std::all_of(of_key.begin(), of_key.end(),
                                [](const Property& value) { return std::holds_alternative<Rational>(value); });
    if (field.numeric) continue;
    for (const Property& value : of_key) field.texts.push_back(to_text(value));
    sort_unique(field.texts);
  }
}

double PropertyFields::number(const Field& field, const CellTags& tags) {
  if (tags.said == nullptr) return std::numeric_limits<double>::quiet_NaN();
  const auto it = tags.said->properties.find(field.key);
  if (it == tags.said->properties.end()) return std::numeric_limits<double>::quiet_NaN();
  return to_double(std::get<Rational>(it->second));
}

std::int32_t PropertyFields::text(const Field& field, const CellTags& tags) {
  if (tags.said == nullptr) return 0;
  const auto it = tags.said->properties.find(field.key);
  if (it == tags.said->properties.end()) return 0;
  const auto place = std::lower_bound(field.texts.begin(), field.texts.end(), to_text(it->second));
  return static_cast<std::int32_t>(place - field.texts.begin()) + 1;
}

/// What is said, material and source.
void CellTagger::finish(CellTags& tags, const FlatComplex::Provenance& origin) const {
  const Component component = material_component(view_, tags);
  const bool entity = tags.dimension < 3 && (view_.value->is_group() || view_.of_group);
  tags.said = origin.said;
  if (tags.said == nullptr && !entity && component != 0) tags.said = &attributes_of(view_, component);
  const bool own = origin.said != nullptr && !origin.said->material.empty();
  const std::string& name = (own ? *origin.said : attributes_of(view_, component)).material.name();
  for (std::size_t i = 0; i < view_.materials.size(); ++i) {
    if (view_.materials[i].name != name) continue;
    tags.material = std::int32_t(i + 1);
    break;
  }
  const auto came_from = [&](LeafId leaf) {
    tags.source = leaf;
    tags.leaf = std::int32_t(view_.place(leaf));
  };
  if (!origin.leaves.empty()) came_from(origin.leaves[0]);
  if (tags.dimension == 3) return;
  for (const LeafCell& cell : origin.cells) {
    if (cell.dimension != 2) continue;
    came_from(cell.leaf);
    tags.face = std::int32_t(cell.number);
    return;
  }
}

template <class Cell>
CellTags CellTagger::in_region(std::int32_t dimension, FlatComplex::Index i, const Cell& cell) const {
  CellTags tags;
  tags.dimension = dimension;
  tags.cell = std::int32_t(i);
  tags.component = std::int32_t(cell.component);
  tags.region = region_number(cell.region);
  finish(tags, cell.origin);
  return tags;
}
CellTags CellTagger::vertex(FlatComplex::Index i) const { return in_region(0, i, flat_.vertices[i]); }
CellTags CellTagger::edge(FlatComplex::Index i) const { return in_region(1, i, flat_.edges[i]); }

CellTags CellTagger::face(FlatComplex::Index i) const {
  const auto& f = flat_.faces[i];
  CellTags tags;
  tags.dimension = 2;
  tags.cell = std::int32_t(i);
  tags.component = std::int32_t(f.component);
  tags.front = region_number(f.regions[0]);
  tags.back = region_number(f.regions[1]);
  tags.region = tags.back != 0 ? tags.back : tags.front;
  tags.bounded = flat_.regions_bounded(f);
  finish(tags, f.origin);
  return tags;
}

CellTags CellTagger::region(FlatComplex::Index i) const {
  const auto& r = flat_.regions[i];
  CellTags tags;
  tags.dimension = 3;
  tags.cell = std::int32_t(i);
  tags.component = tags.region = std::int32_t(r.component);
  finish(tags, r.origin);
  return tags;
}

}  // namespace cnrg
