// A result as a leaf. Reading one in .json has three parts: a cursor on the JSON document
// (csg/imports/json_cursor.h); the tables of the file with every number checked (result_reader.cpp), and held
// against the cells that they make (result_check.cpp); and the leaf made from them, here.
//
// Edges are wires where the faces alone would not give the same edge again:
//   * A face walks a slit in both directions.
//   * A bent chain is one edge because it is one curve (kernel/selection/curve.h), and a wire is one.
//   * Two edges that meet in a corner of curved faces might become one curve: a wire along one of them parts them.
#include <algorithm>
#include <map>
#include <utility>

#include "csg/leaves/parameters.h"
#include "csg/result/file_numbers.h"
#include "csg/result/result_data.h"
#include "csg/text/escape.h"
#include "csg/transfer/stored_value.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

using Index = StoredValue::Index;
using Loop = FlatComplex::Loop;

/// Of each edge, whether it is a wire of the soup.
std::vector<char> find_wires(const StoredValue& value) {
  const auto straight = [&](Index a, Index b, Index c) {
    return collinear(value.points[a], value.points[b], value.points[c]);
  };
  const std::vector<FlatComplex::Edge>& edges = value.cells.edges;
  const auto curved = [&](const FlatComplex::Edge& edge) {
    return std::any_of(edge.around.begin(), edge.around.end(),
                       [&](Index side) { return !value.cells.faces[side / 2].facets.empty(); });
  };
  std::vector<char> wires;
  std::map<Index, std::vector<std::pair<Index, Index>>> ends;  // point -> edges that end there, next point
  for (Index i = 0; i < edges.size(); ++i) {
    const Loop& p = edges[i].points;
    bool bent = edges[i].closed;
    for (std::size_t k = 1; !bent && k + 1 < p.size(); ++k) bent = !straight(p[k - 1], p[k], p[k + 1]);
    wires.push_back(edges[i].around.empty() || edges[i].slit || bent);
    if (edges[i].closed) continue;
    ends[p.front()].emplace_back(i, p[1]);
    ends[p.back()].emplace_back(i, p[p.size() - 2]);
  }
  for (const auto& [point, list] : ends) {
    if (list.size() != 2 || straight(list[0].second, point, list[1].second)) continue;
    const auto [a, b] = std::pair(list[0].first, list[1].first);
    wires[a] = wires[a] || (curved(edges[a]) && curved(edges[b]));
  }
  return wires;
}

class StoredLeaf : public PreparedLeaf {
 public:
  explicit StoredLeaf(StoredValue value) : value_(std::move(value)) {
    if (!value_.patches.empty()) set_parameters([made = parameters()] { return made; });
  }

  LeafId add_to(Soup& soup, const Transform& transform) const override {
    return result::add_to(soup, value_, transform, Fill::sides);
  }
  std::vector<Attributes> regions() const override { return value_.components; }
  const StoredValue* stored() const override { return &value_; }
  std::optional<double> volume_bound() const override { return value_.volume_bound; }

 private:
  /// Faces and wires as `add_to` adds them; curves have no parameters in files.
  std::shared_ptr<const LeafParameters> parameters() const {
    auto parameters = std::make_shared<LeafParameters>();
    for (const auto& [patch, name] : value_.patches) parameters->name_patch(patch, name);
    for (const FlatComplex::Face& face : value_.cells.faces) {
      if (face.cells.empty()) for_each_facet(face, [&](auto&&...) { parameters->add_flat_facet(); });
      for (const auto& cells : face.cells) parameters->add_facet(cells);
    }
    const std::vector<char> wires = find_wires(value_);
    for (Index i = 0; i < wires.size(); ++i) {
      if (!wires[i]) continue;
      for_each_segment(value_.cells.edges[i], [&](Index a, Index b) {
        parameters->add_wire({{value_.points[a], value_.points[b]}, {0, 0}});
      });
    }
    return parameters;
  }

  StoredValue value_;
};

}  // namespace

LeafId result::add_to(Soup& soup, const StoredValue& value, const Transform& transform, Fill fill) {
  const LeafId leaf = soup.add_leaf(fill);
  const bool mirrored = sgn(transform.determinant()) < 0;
  std::vector<PointId> ids;
  ids.reserve(value.points.size());
  for (const RationalPoint& p : value.points)
    ids.push_back(soup.add_point(transform.identity() ? p : transform.apply(p)));
  const auto label = [&](Index region) { return fill == Fill::sides ? value.label(region) : 0; };
  const std::vector<std::size_t> patches = patch_numbers(value.cells);
  std::vector<std::vector<PointId>> rings;
  for (Index i = 0; i < value.cells.faces.size(); ++i) {
    const FlatComplex::Face& face = value.cells.faces[i];
    for_each_facet(face, [&](const std::vector<Loop>& walks, auto&&...) {
      rings.clear();
      for (const Loop& loop : walks) {
        if (loop.size() < 3) continue;  // a slit alone: its edge is a wire
        auto& ring = rings.emplace_back();
        for (const Index p : loop) ring.push_back(ids[p]);
        if (mirrored) std::reverse(ring.begin(), ring.end());
      }
      soup.add_face(leaf, rings, i, Index(patches[i]), label(face.regions[0]), label(face.regions[1]));
    });
  }
  const std::vector<char> wires = find_wires(value);
  for (Index i = 0; i < wires.size(); ++i) {
    if (!wires[i]) continue;
    for_each_segment(value.cells.edges[i], [&](Index a, Index b) { soup.add_wire(leaf, ids[a], ids[b], i); });
  }
  for (const FlatComplex::Vertex& vertex : value.cells.vertices) {
    if (vertex.free) soup.add_isolated(leaf, ids[vertex.point]);
  }
  return leaf;
}

std::unique_ptr<PreparedLeaf> leaf_of(StoredValue value) { return std::make_unique<StoredLeaf>(std::move(value)); }

StoredValue store(const ResultView& view, FlatComplex cells) {
  StoredValue out;
  out.group = view.value->is_group();
  if (out.group) {
    const Group& group = view.value->group();
    out.components.assign(group.regions.begin(), group.regions.end());
    out.dominances.push_back(group.dominance);
  } else {
    for (const ComponentAttributes& component : view.value->components().attributes) {
      out.components.push_back(component);
      out.dominances.push_back(component.dominance);
    }
  }
  for (const VertexId v : cells.points) out.points.push_back(view.complex->points.rational(v));
  const std::vector<std::size_t> patches = patch_numbers(cells);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const FlatComplex::Face& face = cells.faces[i];
    if (!face.cells.empty())
      out.patches[Index(patches[i])] = view.parameters->patch_name(face.patch->first, face.patch->second);
  }
  const auto keep_said = [&](auto& list) {
    for (auto& cell : list) {
      if (cell.origin.said != nullptr) cell.origin.said = &*out.said.insert(*cell.origin.said).first;
    }
  };
  keep_said(cells.vertices), keep_said(cells.edges), keep_said(cells.faces);
  out.cells = std::move(cells);
  if (view.volume_bound) out.volume_bound = view.volume_bound();
  return out;
}

void forget_origins(FlatComplex& cells) {
  const auto forget = [](auto& list) {
    for (auto& cell : list) cell.origin.leaves = {}, cell.origin.cells = {};
  };
  forget(cells.vertices), forget(cells.edges), forget(cells.faces), forget(cells.regions);
}

std::shared_ptr<const PreparedLeaf> leaf_of(const Result& result) {
  const ResultView view = result.data().view(true);
  FlatComplex cells = flatten(view);
  if (!cells.frame_points.empty()) {
    throw InputError("`" + shown(result.name()) +
                     "` has no bounds, and those of a leaf must have some; cut the node with a box before");
  }
  forget_origins(cells);
  StoredValue stored = store(view, std::move(cells));
  if (!view.volume_bound) stored.volume_bound = std::nullopt;
  return leaf_of(std::move(stored));
}

}  // namespace cnrg
