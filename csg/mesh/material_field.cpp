// Fractions of materials by component and point. Tetrahedra of a component share corners: each is sampled once.
#include "csg/mesh/material_field.h"

#include <algorithm>
#include <map>
#include <set>

#include "kernel/exact/integers.h"

namespace cnrg {

MaterialField::MaterialField(const ResultView& view) : components_(view.value->attributes()) {
  const auto graded = [](const RegionAttributes& a) { return a.material.grade() != nullptr; };
  if (std::none_of(components_.begin(), components_.end(), graded)) return;
  std::set<std::string> used;
  for (const RegionAttributes& a : components_) {
    samplers_.emplace_back(a.material);
    for (const std::string& name : samplers_.back().names()) used.insert(name);
  }
  for (const auto& m : view.materials) {
    if (used.erase(m.name) != 0) names_.push_back(m.name);
  }
  names_.insert(names_.end(), used.begin(), used.end());
}

std::vector<double> MaterialField::at(Component component, const RationalPoint& p) const {
  std::vector<double> out(names_.size(), 0.0);
  if (component == 0 || component > samplers_.size()) return out;
  for (const auto& [name, fraction] : samplers_[component - 1].at(p)) {
    out[std::size_t(std::find(names_.begin(), names_.end(), name) - names_.begin())] = to_double(fraction);
  }
  return out;
}

std::vector<double> MaterialField::at(Component component, std::span<const std::array<double, 3>> corners) const {
  RationalPoint center{0, 0, 0};
  for (const auto& p : corners) {
    for (std::size_t k = 0; k < 3; ++k) center[k] += from_double(p[k]);
  }
  for (Rational& x : center) x /= to_integer(corners.size());
  return at(component, center);
}

void add_properties(const ResultView& view, Mesh& mesh) {
  const PropertyFields properties(view);
  for (const PropertyFields::Field& field : properties.fields()) {
    if (!field.numeric) continue;
    Mesh::Property& property = mesh.properties.emplace_back();
    property.key = field.key;
    for (std::size_t d = 0; d < 4; ++d) {
      for (const Mesh::Entity& entity : mesh.entities[d]) {
        property.values[d].push_back(PropertyFields::number(field, entity.tags));
      }
    }
  }
}

void sample_materials(const ResultView& view, Mesh& mesh) {
  const MaterialField field(view);
  for (const std::string& name : field.names()) mesh.fields.push_back({"fraction of " + name, {}});
  if (field.empty()) return;
  std::map<std::pair<Component, Mesh::Index>, std::vector<double>> known;
  for (const auto& t : mesh.tetrahedra) {
    const Component component = material_component(view, mesh.entities[3][t.entity].tags);
    for (const Mesh::Index p : t.points) {
      const auto [it, fresh] = known.try_emplace({component, p});
      if (fresh) it->second = field.at(component, std::span(&mesh.points[p], 1));
      const std::vector<double>& fractions = it->second;
      for (std::size_t k = 0; k < fractions.size(); ++k) mesh.fields[k].values.push_back(fractions[k]);
    }
  }
}

}  // namespace cnrg
