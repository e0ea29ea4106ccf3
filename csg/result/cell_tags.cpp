// The tags of a cell: its numbers in the flattened result, then its material and the first leaf that it came from.
#include "csg/result/cell_tags.h"

namespace cnrg {

std::int32_t CellTagger::region_number(FlatComplex::Index region) const {
  return flat_.active(region) ? std::int32_t(flat_.regions[region].component) : 0;
}

Component material_component(const ResultView& view, const CellTags& tags) {
  const bool entity = (view.value->is_group() || view.of_group) && tags.dimension < 3;
  return Component(entity ? tags.region : tags.component);
}

/// Material and source.
void CellTagger::finish(CellTags& tags, const FlatComplex::Provenance& origin) const {
  const std::string& name = attributes_of(view_, material_component(view_, tags)).material.name();
  for (std::size_t i = 0; i < view_.materials.size(); ++i) {
    if (view_.materials[i].name != name) continue;
    tags.material = std::int32_t(i + 1);
    break;
  }
  if (!origin.leaves.empty()) tags.leaf = std::int32_t(origin.leaves[0].value());
  if (tags.dimension == 3) return;
  for (const LeafCell& cell : origin.cells) {
    if (cell.dimension != 2) continue;
    tags.leaf = std::int32_t(cell.leaf.value());
    tags.face = std::int32_t(cell.number);
    return;
  }
}

CellTags CellTagger::vertex(FlatComplex::Index i) const {
  const auto& v = flat_.vertices[i];
  CellTags tags;
  tags.cell = std::int32_t(i);
  tags.component = std::int32_t(v.component);
  tags.region = region_number(v.region);
  finish(tags, v.origin);
  return tags;
}

CellTags CellTagger::edge(FlatComplex::Index i) const {
  const auto& e = flat_.edges[i];
  CellTags tags;
  tags.dimension = 1;
  tags.cell = std::int32_t(i);
  tags.component = std::int32_t(e.component);
  tags.region = region_number(e.region);
  finish(tags, e.origin);
  return tags;
}

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
