// Of a group only entities are asked about, and these have origins. Components may be open: for a cell that they
// lack, the active cells around it answer.
#include "csg/operators/cell_sources.h"

#include <algorithm>
#include <map>

#include "csg/operators/component_lists.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

template <class IdT>
LeafSetId set_in(const Group& group, IdT cell) {
  const auto& list = list_for(group, cell);
  const auto it = std::ranges::lower_bound(list, cell);
  if (it == list.end() || *it != cell) return LeafSetId::none();
  return list_for(group.origins, cell)[static_cast<std::size_t>(it - list.begin())];
}

template <class IdT>
LeafSetId set_in(const Components& x, IdT cell) {
  const auto& list = list_for(x.selection, cell);
  const std::size_t k = place_in(list, cell);
  return k == list.size() ? LeafSetId::none() : list_for(x.origins, cell)[k];
}

bool add_origin(const LeafSets& sets, LeafSetId set, std::vector<LeafId>& out) {
  if (!set.valid()) return false;
  out.insert(out.end(), sets[set].begin(), sets[set].end());
  return true;
}

}  // namespace

ValueSources::ValueSources(const Complex& complex, const LeafSets& sets) : complex_(complex), sets_(sets) {
  if (!sets.says_anything()) return;
  std::map<Attributes, std::uint32_t, AttributesOrder> distinct;
  marks_.resize(sets.size(), 0);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const SaidPointer& said = sets.said(LeafSetId(s));
    if (said == nullptr || said->attributes.empty()) continue;
    marks_[s] =
        distinct.try_emplace(said->attributes, static_cast<std::uint32_t>(distinct.size() + 1)).first->second;
  }
}

LeafSetId ValueSources::said_set(FaceId f) const {
  if (marks_.empty()) return LeafSetId::none();
  const LeafSetId set = telling_set_of(f);
  return mark_of(set) == 0 ? LeafSetId::none() : set;
}

LeafSetId ValueSources::said_set(EdgeId e) const {
  if (marks_.empty()) return LeafSetId::none();
  const LeafSetId set = telling_set_of(e);
  if (mark_of(set) == 0) return LeafSetId::none();
  const auto uses = complex_.edge_uses[e];
  const bool speaks = sets_.said(set)->dimension <= 1 ||
                      std::none_of(uses.begin(), uses.end(), [&](const FaceUse& use) { return bounds(use.face); });
  return speaks ? set : LeafSetId::none();
}

LeafSetId ValueSources::said_set(VertexId v) const {
  if (marks_.empty()) return LeafSetId::none();
  const LeafSetId set = telling_set_of(v);
  if (mark_of(set) == 0) return LeafSetId::none();
  if (sets_.said(set)->dimension == 0) return set;
  const auto edges = complex_.vertex_edges[v];
  const auto faces = complex_.vertex_faces[v];
  const auto there = [&](auto cell) { return bounds(cell); };
  const bool end =
      std::any_of(edges.begin(), edges.end(), there) || std::any_of(faces.begin(), faces.end(), there);
  return end ? LeafSetId::none() : set;
}

LeafSetId GroupSources::set_of(FaceId f) const { return set_in(group_, f); }
LeafSetId GroupSources::set_of(EdgeId e) const { return set_in(group_, e); }
LeafSetId GroupSources::set_of(VertexId v) const { return set_in(group_, v); }

// Faces and edges that bound something kept are entities: a group is closed, and walls in a region are entities.
void GroupSources::leaves_of(FaceId f, std::vector<LeafId>& out) const {
  out.clear();
  require(add_origin(sets_, set_of(f), out), "a group was asked for the origin of a face that is no entity");
}

void GroupSources::leaves_of(EdgeId e, std::vector<LeafId>& out) const {
  out.clear();
  require(add_origin(sets_, set_of(e), out), "a group was asked for the origin of an edge that is no entity");
}

ComponentSources::ComponentSources(const Complex& complex, const Components& x)
    : ValueSources(complex, x.origins.sets), x_(x) {
  if (!sets_.says_anything()) return;
  std::pair<Component, LeafSetId> last(0, LeafSetId(0));
  const auto see = [&](const auto& list, const auto& origins) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::pair entry(list[k].second, origins[k]);
      if (entry == std::exchange(last, entry)) continue;
      const SaidPointer& said = sets_.said(entry.second);
      if (said == nullptr || repeated_.contains(entry)) continue;
      const Attributes& of_component = x.attributes[entry.first - 1];
      Attributes both = of_component;
      replace(both, said->attributes);
      if (both == of_component) repeated_.insert(entry);
    }
  };
  for_each_dimension(see, x.selection, x.origins);
}

template <class IdT>
LeafSetId ComponentSources::telling_set(IdT cell) const {
  const LeafSetId set = set_of(cell);
  const bool repeats = set.valid() && repeated_.contains({component_in(list_for(x_.selection, cell), cell), set});
  return repeats ? LeafSetId::none() : set;
}

LeafSetId ComponentSources::telling_set_of(FaceId f) const { return telling_set(f); }
LeafSetId ComponentSources::telling_set_of(EdgeId e) const { return telling_set(e); }
LeafSetId ComponentSources::telling_set_of(VertexId v) const { return telling_set(v); }

LeafSetId ComponentSources::set_of(FaceId f) const { return set_in(x_, f); }
LeafSetId ComponentSources::set_of(EdgeId e) const { return set_in(x_, e); }
LeafSetId ComponentSources::set_of(VertexId v) const { return set_in(x_, v); }

bool ComponentSources::stands_out(FaceId f) const {
  const auto sides = complex_.face_regions[f];
  return is_beside(sides, component_in(x_.selection.faces, f));
}
bool ComponentSources::stands_out(EdgeId e) const {
  std::vector<RegionId> around;
  complex_.star_regions(e, around);
  return is_beside(around, component_in(x_.selection.edges, e));
}
bool ComponentSources::is_beside(std::span<const RegionId> around, Component own) const {
  return own != 0 && std::any_of(around.begin(), around.end(),
                                 [&](RegionId r) { return component_in(x_.selection.regions, r) != own; });
}

void ComponentSources::leaves_of(FaceId f, std::vector<LeafId>& out) const {
  out.clear();
  if (add_origin(sets_, set_of(f), out)) return;
  for (const RegionId r : complex_.face_regions[f]) add_origin(sets_, set_in(x_, r), out);
  sort_unique(out);
}

void ComponentSources::leaves_of(EdgeId e, std::vector<LeafId>& out) const {
  out.clear();
  if (add_origin(sets_, set_of(e), out)) return;
  std::vector<RegionId> regions;
  for (const FaceUse& use : complex_.edge_uses[e]) add_origin(sets_, set_of(use.face), out);
  complex_.star_regions(e, regions);
  for (const RegionId r : regions) add_origin(sets_, set_in(x_, r), out);
  sort_unique(out);
}

}  // namespace cnrg
