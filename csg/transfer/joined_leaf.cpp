#include "csg/transfer/joined_leaf.h"

#include <algorithm>
#include <map>
#include <utility>

#include "csg/imports/result_content.h"
#include "csg/result/file_numbers.h"

namespace cnrg {
namespace {

using result::Content;
using result::Index;
using result::Loop;

class ContentMaker {
 public:
  ContentMaker(const ResultView& view, const FlatComplex& flat) : view_(view), flat_(flat) {}

  Content run() {
    take_components();
    for (const VertexId v : flat_.points) table_.points.push_back(view_.complex->points.rational(v));
    take_regions();
    take_vertices();
    take_edges();
    take_faces();
    choose_wires(content_);
    table_.makers = std::move(makers_);
    if (view_.volume_bound) table_.volume_bound = view_.volume_bound();
    return std::move(content_);
  }

 private:
  const ResultView& view_;
  const FlatComplex& flat_;
  Content content_;
  CellTable& table_ = content_.table;
  std::shared_ptr<CellMakers> makers_ = std::make_shared<CellMakers>();
  std::map<Attributes, Index, AttributesOrder> said_number_;
  std::map<std::vector<PatchCorner>, Index> cell_number_;

  static CellMakers::Made made(const FlatComplex::Provenance& origin) {
    return {{origin.leaves.begin(), origin.leaves.end()}, {origin.cells.begin(), origin.cells.end()}};
  }

  void take_components() {
    const NodeValue& value = *view_.value;
    table_.group = value.is_group();
    if (table_.group) {
      const Group& group = value.group();
      content_.components.assign(group.regions.begin(), group.regions.end());
      table_.dominances.push_back(group.dominance);
      return;
    }
    for (const ComponentAttributes& component : value.components().attributes) {
      content_.components.push_back(component);
      table_.dominances.push_back(component.dominance);
    }
  }

  void take_regions() {
    table_.regions.assign(flat_.regions.size() + 1, 0);
    makers_->regions.resize(flat_.regions.size() + 1);
    for (Index r = 0; r < flat_.regions.size(); ++r) {
      const FlatComplex::Region& region = flat_.regions[r];
      const Index label = region.bounded ? r + 1 : 0;
      content_.regions.push_back({label, region.component});
      table_.regions[label] = region.component;
      makers_->regions[label] = made(region.origin);
    }
  }

  Index said(const FlatComplex::Provenance& origin) {
    if (origin.said == nullptr) return CellTable::kSilent;
    const auto [it, fresh] = said_number_.try_emplace(*origin.said, Index(table_.said.size()));
    if (fresh) table_.said.push_back(*origin.said);
    return it->second;
  }

  void take_vertices() {
    for (const FlatComplex::Vertex& vertex : flat_.vertices) {
      table_.vertices[vertex.point] = {vertex.component, vertex.feature, said(vertex.origin)};
      makers_->vertices[vertex.point] = made(vertex.origin);
    }
  }

  void take_edges() {
    for (const FlatComplex::Edge& from : flat_.edges) {
      const auto number = Index(content_.edges.size());
      result::Edge& edge = content_.edges.emplace_back();
      edge.points.assign(from.points.begin(), from.points.end());
      edge.closed = from.closed;
      if (edge.closed) edge.points.push_back(edge.points[0]);
      edge.uses = Index(from.around.size());
      edge.slit = from.slit;
      edge.curved = std::any_of(from.around.begin(), from.around.end(),
                                [&](Index side) { return !flat_.faces[side / 2].facets.empty(); });
      for (std::size_t i = 1; i < edge.points.size(); ++i)
        table_.segments.emplace(std::minmax(edge.points[i - 1], edge.points[i]), number);
      table_.edges.push_back({from.component, from.feature, said(from.origin)});
      makers_->edges.push_back(made(from.origin));
    }
  }

  void take_faces() {
    const std::vector<std::size_t> patches = patch_numbers(flat_);
    for (const FlatComplex::Face& from : flat_.faces) {
      const auto number = Index(content_.faces.size());
      result::Face face;
      face.flat = from.facets.empty();
      face.first = content_.facets.size();
      face.regions = from.regions;
      face.patch = Index(patches[number]);
      if (face.flat) {
        add_facet(from.loops, from.isolated, number);
      } else {
        face.walks = loops(from.loops);
        for (const FlatComplex::Facet& facet : from.facets) add_facet(facet.loops, facet.isolated, number);
      }
      face.facets = content_.facets.size() - face.first;
      for (std::size_t k = 0; k < from.cells.size(); ++k) {
        for (const auto& cell : from.cells[k])
          content_.facets[face.first + k].cells.push_back(cell_of_patch(cell));
      }
      if (!from.cells.empty())
        content_.patches[face.patch] = view_.parameters->patch_name(from.patch->first, from.patch->second);
      content_.faces.push_back(std::move(face));
      table_.faces.push_back(from.component);
      table_.said_of_faces.push_back(said(from.origin));
      makers_->faces.push_back(made(from.origin));
    }
  }

  static std::vector<Loop> loops(const std::vector<FlatComplex::Loop>& from) {
    std::vector<Loop> out;
    for (const FlatComplex::Loop& loop : from) out.emplace_back(loop.begin(), loop.end());
    return out;
  }

  template <class Isolated>
  void add_facet(const std::vector<FlatComplex::Loop>& walks, const Isolated& isolated, Index face) {
    result::Facet& facet = content_.facets.emplace_back();
    facet.walks = loops(walks);
    facet.isolated.assign(isolated.begin(), isolated.end());
    facet.face = face;
    take_slits_out(table_.points, facet);
  }

  Index cell_of_patch(const std::vector<PatchCorner>& cell) {
    const auto [it, fresh] = cell_number_.try_emplace(cell, Index(content_.cells.size()));
    if (fresh) content_.cells.push_back(cell);
    return it->second;
  }
};

}  // namespace

std::unique_ptr<PreparedLeaf> joined_leaf(const ResultView& view, const FlatComplex& flat) {
  return leaf_of(ContentMaker(view, flat).run());
}

}  // namespace cnrg
