// Each cell is asked once; what is around it is read off the complex. The closure is marked (subgroup.h), and one
// pass over the lists of the group takes what is marked.
#include "csg/operators/select.h"

#include <algorithm>

#include "csg/operators/cell_sources.h"
#include "csg/operators/subgroup.h"

namespace cnrg {
namespace {

template <class T>
bool one_of(const std::vector<T>& wanted, const T& value) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), value) != wanted.end();
}

class Picker {
 public:
  Picker(const Complex& complex, const Group& group, const Criteria& criteria)
      : complex_(complex), group_(group), criteria_(criteria), sources_(complex, group) {}

  bool picks_region(std::uint32_t region) const {
    const RegionAttributes& attributes = group_.regions[region - 1];
    return one_of(criteria_.dimensions, 3) && criteria_.between.empty() && says(&attributes) &&
           one_of(criteria_.regions, attributes.name) && from(attributes.leaves);
  }

  template <class IdT>
  bool picks(IdT cell, int dimension, LeafSetId origin) const {
    if (!one_of(criteria_.dimensions, dimension) || !says(sources_.said(cell)) ||
        !from(group_.origins.sets[origin])) {
      return false;
    }
    if (criteria_.regions.empty() && criteria_.between.empty()) return true;
    const std::vector<std::uint32_t> around = regions_around(cell);
    return touches_region(around) && is_between(around);
  }

 private:
  bool says(const Attributes* said) const {
    if (criteria_.names.empty() && criteria_.materials.empty() && criteria_.properties.empty()) return true;
    if (said == nullptr) return false;
    const auto has = [&](const std::pair<std::string, Property>& wanted) {
      const auto it = said->properties.find(wanted.first);
      return it != said->properties.end() && it->second == wanted.second;
    };
    // Values of one key are alternatives; every key must hold.
    const auto key_holds = [&](const std::pair<std::string, Property>& wanted) {
      return std::any_of(criteria_.properties.begin(), criteria_.properties.end(),
                         [&](const auto& other) { return other.first == wanted.first && has(other); });
    };
    return one_of(criteria_.names, said->name) && one_of(criteria_.materials, said->material.name()) &&
           std::all_of(criteria_.properties.begin(), criteria_.properties.end(), key_holds);
  }

  template <class Leaves>
  bool from(const Leaves& leaves) const {
    return criteria_.leaves.empty() ||
           std::any_of(leaves.begin(), leaves.end(), [&](LeafId leaf) { return one_of(criteria_.leaves, leaf); });
  }

  /// Regions of the group around a cell, ascending and unique; 0 is none.
  template <class IdT>
  std::vector<std::uint32_t> regions_around(IdT cell) const {
    std::vector<RegionId> cells;
    add_star(cell, cells);
    std::vector<std::uint32_t> regions;
    regions.reserve(cells.size());
    for (const RegionId r : cells) regions.push_back(group_.region_of(r));
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    return regions;
  }
  void add_star(FaceId f, std::vector<RegionId>& out) const {
    out.assign(complex_.face_regions[f].begin(), complex_.face_regions[f].end());
  }
  void add_star(EdgeId e, std::vector<RegionId>& out) const { complex_.star_regions(e, out); }
  void add_star(VertexId v, std::vector<RegionId>& out) const { complex_.star_regions(v, out); }

  bool touches_region(const std::vector<std::uint32_t>& around) const {
    return criteria_.regions.empty() || std::any_of(around.begin(), around.end(), [&](std::uint32_t region) {
             return region != 0 && one_of(criteria_.regions, group_.regions[region - 1].name);
           });
  }

  bool is(std::uint32_t region, const SideName& side) const {
    if (region == 0 || !side) return region == 0 && !side;
    const RegionAttributes& attributes = group_.regions[region - 1];
    return attributes.name == *side || attributes.material.name() == *side;
  }
  bool is_between(const std::vector<std::uint32_t>& around) const {
    if (criteria_.between.empty()) return true;
    for (const auto& [first, second] : criteria_.between) {
      for (const std::uint32_t a : around) {
        for (const std::uint32_t b : around) {
          if (a != b && is(a, first) && is(b, second)) return true;
        }
      }
    }
    return false;
  }

  const Complex& complex_;
  const Group& group_;
  const Criteria& criteria_;
  GroupSources sources_;
};

}  // namespace

Group select(const Complex& complex, const Group& group, const Criteria& criteria) {
  const Picker picker(complex, group, criteria);
  WantedEntities wanted(complex);
  const auto want = [&](const auto& cells, const auto& origins, int dimension) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (picker.picks(cells[k], dimension, origins[k])) wanted.add(cells[k]);
    }
  };
  want(group.faces, group.origins.faces, 2);
  want(group.edges, group.origins.edges, 1);
  want(group.vertices, group.origins.vertices, 0);

  std::vector<std::uint32_t> number(group.regions.size() + 1, 0);  // in the selection; 0: not picked
  std::vector<RegionAttributes> regions;
  for (std::uint32_t region = 1; region <= group.regions.size(); ++region) {
    if (!picker.picks_region(region)) continue;
    regions.push_back(group.regions[region - 1]);
    number[region] = static_cast<std::uint32_t>(regions.size());
  }
  for (const auto& [cell, region] : group.cells) {
    if (number[region] == 0) continue;
    for (const HalfFace h : complex.region_faces[cell]) wanted.add(h.face());
    for (const EdgeId e : complex.region_wires[cell]) wanted.add(e);
    for (const VertexId v : complex.region_vertices[cell]) wanted.add(v);
  }

  Group out = wanted.of(group);
  for (const auto& [cell, region] : group.cells) {
    if (number[region] != 0) out.cells.emplace_back(cell, number[region]);
  }
  out.regions = std::move(regions);
  return out;
}

}  // namespace cnrg
