// Everything is a copy of FlatComplex in another order, but for two things that it does not say, the walks of
// faces by edges and the ends of edges by vertices. Both follow from points: two straight pieces between the same
// two points are the same piece, so a pair of neighbours in a loop names the edge that it runs along.
#include "csg/result/arrays.h"

#include <unordered_map>

#include "csg/result/cell_tags.h"
#include "csg/result/file_numbers.h"
#include "csg/result/flat.h"
#include "csg/result/result_data.h"
#include "csg/result/rounding.h"
#include "csg/result/said_table.h"

namespace cnrg {
namespace {

using Index = FlatComplex::Index;
using Number = std::int32_t;
constexpr Number kNoNumber = ResultArrays::kNone;

/// Also of FlatComplex::kNone.
Number number(Index i) { return i == FlatComplex::kNone ? kNoNumber : static_cast<Number>(i); }

template <class List>
void append_list(NumberLists& lists, const List& list) {
  for (const auto& item : list) lists.values.push_back(number(Index(item)));
  lists.offsets.push_back(static_cast<std::int64_t>(lists.values.size()));
}

/// A list of so many.
void append_count(ListOffsets& lists, std::size_t count) {
  lists.offsets.push_back(lists.offsets.back() + static_cast<std::int64_t>(count));
}

class Filler {
 public:
  explicit Filler(const Result& result)
      : view_(result.data().view()),
        flat_(flatten(view_)),
        leaf_numbers_(leaf_numbers(view_, flat_)),
        tagger_(view_, flat_) {}

  ResultArrays run() {
    add_points();
    add_edges();
    add_vertices();
    add_faces();
    add_regions();
    add_names();
    return std::move(out_);
  }

 private:
  const ResultView view_;
  const FlatComplex flat_;
  const std::map<LeafId, std::size_t> leaf_numbers_;
  const CellTagger tagger_;
  SaidTableMaker said_;
  ResultArrays out_;
  /// The edge between two neighbouring points of its chain, as edge * 2 if from the first of the key to the
  /// second.
  std::unordered_map<std::uint64_t, Index> edge_between_;

  static std::uint64_t key(Index a, Index b) { return (std::uint64_t{a} << 32) | b; }

  void add_points() {
    for (const std::array<double, 3>& p : round_points(view_, flat_).xyz) {
      out_.points.insert(out_.points.end(), p.begin(), p.end());
    }
    out_.ids = flat_.points;
    for (const Index p : flat_.frame_points) out_.frame_points.push_back(number(p));
    out_.point_vertices.assign(flat_.points.size(), kNoNumber);
    for (Index i = 0; i < flat_.vertices.size(); ++i) out_.point_vertices[flat_.vertices[i].point] = number(i);
  }

  template <class Cell>
  void add_common(ResultArrays::Common& to, const Cell& cell, const CellTags& tags) {
    to.holder.push_back(tags.region);
    to.material.push_back(tags.material - 1);
    to.said.push_back(said_.place(tags));
    to.leaf.push_back(tags.leaf < 0 ? kNoNumber : static_cast<Number>(leaf_numbers_.at(tags.source)));
    to.leaf_face.push_back(tags.face);
    to.component.push_back(static_cast<Number>(cell.component));
    if constexpr (requires { cell.entity; }) to.entity.push_back(cell.entity);
    std::vector<std::size_t> leaves;
    for (const LeafId leaf : cell.origin.leaves) leaves.push_back(leaf_numbers_.at(leaf));
    append_list(to.origin.leaves, leaves);
    NumberLists& cells = to.origin.cells;
    for (const LeafCell& on : cell.origin.cells) {
      for (const std::size_t x : {leaf_numbers_.at(on.leaf), std::size_t{on.dimension}, std::size_t{on.number}}) {
        cells.values.push_back(static_cast<Number>(x));
      }
    }
    append_count(cells, cell.origin.cells.size());
  }

  void add_edges() {
    ResultArrays::Edges& to = out_.edges;
    for (Index i = 0; i < flat_.edges.size(); ++i) {
      const FlatComplex::Edge& edge = flat_.edges[i];
      add_common(to, edge, tagger_.edge(i));
      append_list(to.points, edge.points);
      const Number first = out_.point_vertices[edge.points.front()],
                   last = out_.point_vertices[edge.points.back()];
      to.vertices.push_back(edge.closed ? kNoNumber : first);
      to.vertices.push_back(edge.closed ? kNoNumber : last);
      to.closed.push_back(edge.closed);
      to.feature.push_back(edge.feature);
      to.wire.push_back(edge.wire);
      to.slit.push_back(edge.slit);
      to.region.push_back(number(edge.region));
      append_list(to.around, edge.around);
      for (std::size_t k = 0; k + 1 < edge.points.size() + edge.closed; ++k) {
        const Index a = edge.points[k], b = edge.points[(k + 1) % edge.points.size()];
        edge_between_[key(a, b)] = i * 2;
        edge_between_[key(b, a)] = i * 2 + 1;
      }
    }
  }

  void add_vertices() {
    ResultArrays::Vertices& to = out_.vertices;
    std::vector<std::vector<Index>> edges(flat_.vertices.size());
    for (std::size_t i = 0; i < out_.edges.vertices.size(); ++i) {
      const Number v = out_.edges.vertices[i];
      if (v != kNoNumber) edges[static_cast<std::size_t>(v)].push_back(Index(i / 2));
    }
    for (Index i = 0; i < flat_.vertices.size(); ++i) {
      const FlatComplex::Vertex& vertex = flat_.vertices[i];
      add_common(to, vertex, tagger_.vertex(i));
      to.point.push_back(number(vertex.point));
      to.feature.push_back(vertex.feature);
      to.free.push_back(vertex.free);
      to.region.push_back(number(vertex.region));
      append_list(to.edges, edges[i]);
    }
  }

  /// The edges along a loop, each once for each time that the loop runs along it. On the frame there are none.
  std::vector<Index> edges_along(const FlatComplex::Loop& loop) const {
    std::vector<Index> edges;
    std::vector<char> begins;  // whether an edge begins at each of them: it may follow itself
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index a = loop[k], b = loop[(k + 1) % loop.size()];
      const auto found = edge_between_.find(key(a, b));
      if (found == edge_between_.end()) continue;
      const FlatComplex::Edge& edge = flat_.edges[found->second / 2];
      const Index start = found->second % 2 == 0 ? edge.points.front() : edge.points.back();
      if (edges.empty() || edges.back() != found->second || (!edge.closed && a == start)) {
        edges.push_back(found->second);
        begins.push_back(a == start);
      }
    }
    // The walk may have begun within an edge: then that stands at both ends.
    if (edges.size() > 1 && edges.front() == edges.back() && !begins.front()) edges.pop_back();
    return edges;
  }

  void add_faces() {
    ResultArrays::Faces& to = out_.faces;
    for (Index i = 0; i < flat_.faces.size(); ++i) {
      const FlatComplex::Face& face = flat_.faces[i];
      add_common(to, face, tagger_.face(i));
      append_count(to.loops, face.loops.size());
      for (const FlatComplex::Loop& loop : face.loops) {
        append_list(to.loop_points, loop);
        append_list(to.loop_edges, edges_along(loop));
      }
      append_list(to.isolated, face.isolated);
      for (const Index region : face.regions) to.regions.push_back(number(region));
      to.flat.push_back(face.facets.empty());
      for (const auto& triangle : face.triangles) {
        for (const Index p : triangle) to.triangles.values.push_back(number(p));
      }
      append_count(to.triangles, face.triangles.size());
      append_count(to.facets, face.facets.size());
      for (std::size_t k = 0; k < face.facets.size(); ++k) {
        const FlatComplex::Facet& facet = face.facets[k];
        append_count(to.facet_loops, facet.loops.size());
        for (const FlatComplex::Loop& loop : facet.loops) append_list(to.facet_points, loop);
        append_list(to.facet_isolated, facet.isolated);
        to.facet_triangles.push_back(
            static_cast<Number>(face.facet_ends[k] - (k == 0 ? 0 : face.facet_ends[k - 1])));
      }
    }
    for (const std::size_t patch : patch_numbers(flat_)) to.patch.push_back(static_cast<Number>(patch));
  }

  void add_regions() {
    ResultArrays::Regions& to = out_.regions;
    for (Index i = 0; i < flat_.regions.size(); ++i) {
      const FlatComplex::Region& region = flat_.regions[i];
      add_common(to, region, tagger_.region(i));
      to.entity.push_back(0);
      to.bounded.push_back(region.bounded);
      append_count(to.shells, region.shells.size());
      for (const std::vector<Index>& shell : region.shells) append_list(to.shell_sides, shell);
    }
  }

  void add_names() {
    for (const LeafId leaf : in_order(leaf_numbers_)) out_.leaves.push_back(leaf_name(view_, leaf));
    for (Component i = 1; i <= view_.value->component_count(); ++i) {
      const RegionAttributes& from = view_.value->attributes(i);
      ResultArrays::Component& to = out_.components.emplace_back();
      to.name = from.name;
      to.material = from.material.name();
      to.properties = from.properties;
      for (const std::size_t leaf : numbers_of(from.leaves, leaf_numbers_))
        to.leaves.push_back(static_cast<Number>(leaf));
    }
    out_.materials = view_.materials;
    out_.said = said_.table(view_);
    out_.group = view_.value->is_group() || view_.of_group;
  }
};

}  // namespace

ResultArrays result_arrays(const Result& result) { return Filler(result).run(); }

}  // namespace cnrg
