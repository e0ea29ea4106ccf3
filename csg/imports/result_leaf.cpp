// A result as a leaf. Reading one in .json has three parts: a cursor on the JSON document (json_cursor.h); the
// tables of the file with every number checked (result_reader.cpp), and held against the cells that they make
// (csg/transfer/result_check.cpp); and the leaf made from them, here. All cells of the file go to the soup, active
// or not; the cell table says which are active.
//
// Edges are wires where the faces alone would not give the same edge again:
//   * A face is handed to the soup without its slits (edges that it walks in both directions): loops of the soup
//     enclose by parity.
//   * A bent chain is one edge because it is one curve (kernel/selection/curve.h), and a wire is one.
//   * Two edges that meet in a corner of curved faces might become one curve: a wire along one of them parts them.
#include <algorithm>
#include <set>
#include <utility>

#include "csg/imports/result_content.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace result {
namespace {

/// Twice the vector area of a loop: along the normal of the side from which it is counter-clockwise.
RationalPoint area(const std::vector<RationalPoint>& points, const Loop& loop) {
  RationalPoint sum{0, 0, 0};
  const RationalPoint& o = points[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum = sum + cross(points[loop[i]] - o, points[loop[i + 1]] - o);
  }
  return sum;
}

bool has_slit(const Loop& walk) {
  std::vector<std::pair<Index, Index>> steps;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    steps.push_back(std::minmax(walk[i], walk[i + 1 < walk.size() ? i + 1 : 0]));
  }
  std::sort(steps.begin(), steps.end());
  return std::adjacent_find(steps.begin(), steps.end()) != steps.end();
}

/// Splits a walk at edges that it walks in both directions: they nest like parentheses, since the face is
/// planar, and each closed part between them is a loop of its own.
void split_at_slits(const Loop& walk, std::vector<Loop>& loops) {
  using Step = std::pair<Index, Index>;
  const std::size_t n = walk.size();
  std::set<Step> steps;
  for (std::size_t i = 0; i < n; ++i) steps.insert({walk[i], walk[(i + 1) % n]});
  std::vector<std::pair<Step, Loop>> open{{Step{}, {}}};
  for (std::size_t i = 0; i < n; ++i) {
    const Step step{walk[i], walk[(i + 1) % n]};
    if (!steps.contains({step.second, step.first})) {
      open.back().second.push_back(step.first);
    } else if (open.size() > 1 && open.back().first == Step{step.second, step.first}) {
      if (open.back().second.size() >= 3) loops.push_back(std::move(open.back().second));
      open.pop_back();
    } else {
      open.push_back({step, {}});
    }
  }
  for (auto& [step, loop] : open) {
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
}

}  // namespace

bool take_slits_out(const std::vector<RationalPoint>& points, Facet& facet) {
  if (std::none_of(facet.walks.begin(), facet.walks.end(), has_slit)) return true;
  RationalPoint normal{0, 0, 0};
  for (const Loop& walk : facet.walks) {
    normal = normal + area(points, walk);
    split_at_slits(walk, facet.loops);
  }
  if (facet.loops.empty()) return false;
  std::size_t outer = 0;
  Rational most = 0;
  for (std::size_t i = 0; i < facet.loops.size(); ++i) {
    const Rational extent = dot(normal, area(points, facet.loops[i]));
    if (extent > most) {
      most = extent;
      outer = i;
    }
  }
  std::swap(facet.loops[0], facet.loops[outer]);
  return true;
}

void choose_wires(Content& content) {
  const std::vector<RationalPoint>& points = content.table.points;
  const auto straight = [&](Index a, Index b, Index c) { return collinear(points[a], points[b], points[c]); };
  std::map<Index, std::vector<std::pair<Index, Index>>> ends;  // point -> edges that end there, next point
  std::vector<char> on_edge(points.size(), 0);
  for (Index i = 0; i < content.edges.size(); ++i) {
    Edge& edge = content.edges[i];
    const Loop& p = edge.points;
    for (const Index point : p) on_edge[point] = 1;
    bool bent = edge.closed;
    for (std::size_t k = 1; !bent && k + 1 < p.size(); ++k) bent = !straight(p[k - 1], p[k], p[k + 1]);
    edge.wire = edge.uses == 0 || edge.slit || bent;
    if (edge.closed) continue;
    ends[p.front()].emplace_back(i, p[1]);
    ends[p.back()].emplace_back(i, p[p.size() - 2]);
  }
  for (const auto& [point, list] : ends) {
    if (list.size() != 2 || straight(list[0].second, point, list[1].second)) continue;
    Edge &a = content.edges[list[0].first], &b = content.edges[list[1].first];
    a.wire = a.wire || (a.curved && b.curved);
  }
  for (const auto& [point, vertex] : content.table.vertices) {
    if (!on_edge[point]) content.isolated.push_back(point);
  }
}

LeafId add_to(Soup& soup, const Content& content, const Transform& transform, Fill fill) {
  const LeafId leaf = soup.add_leaf(fill);
  const bool mirrored = sgn(transform.determinant()) < 0;
  std::vector<PointId> ids;
  ids.reserve(content.table.points.size());
  for (const RationalPoint& p : content.table.points) {
    ids.push_back(soup.add_point(transform.identity() ? p : transform.apply(p)));
  }
  const auto label = [&](Index region) { return fill == Fill::sides ? content.regions[region].label : 0; };
  std::vector<std::vector<PointId>> loops;
  for (const Facet& facet : content.facets) {
    loops.clear();
    for (const Loop& loop : facet.outline()) {
      auto& ring = loops.emplace_back();
      for (const Index p : loop) ring.push_back(ids[p]);
      if (mirrored) std::reverse(ring.begin(), ring.end());
    }
    const Face& face = content.faces[facet.face];
    soup.add_face(leaf, loops, facet.face, face.patch, label(face.regions[0]), label(face.regions[1]));
  }
  for (Index number = 0; number < content.edges.size(); ++number) {
    const Edge& edge = content.edges[number];
    if (!edge.wire) continue;
    const Loop& p = edge.points;
    for (std::size_t i = 1; i < p.size(); ++i) soup.add_wire(leaf, ids[p[i - 1]], ids[p[i]], number);
  }
  for (const Index p : content.isolated) soup.add_isolated(leaf, ids[p]);
  return leaf;
}

}  // namespace result

namespace {

using result::Content;

class ResultLeaf : public PreparedLeaf {
 public:
  explicit ResultLeaf(Content content) : content_(std::move(content)) {
    if (content_.patches.empty()) return;
    set_parameters([made = parameters_of(content_)] { return made; });
  }

  LeafId add_to(Soup& soup, const Transform& transform) const override {
    return result::add_to(soup, content_, transform, Fill::sides);
  }
  std::vector<Attributes> regions() const override { return content_.components; }
  const CellTable* cells() const override { return &content_.table; }

 private:
  /// Faces and wires as `add_to` adds them; curves have no parameters in files.
  static std::shared_ptr<const LeafParameters> parameters_of(const Content& content) {
    auto parameters = std::make_shared<LeafParameters>();
    for (const auto& [patch, name] : content.patches) parameters->name_patch(patch, name);
    for (const result::Facet& facet : content.facets) {
      std::vector<std::vector<PatchCorner>> cells;
      for (const result::Index cell : facet.cells) cells.push_back(content.cells[cell]);
      parameters->add_facet(cells);
    }
    for (const result::Edge& edge : content.edges) {
      if (!edge.wire) continue;
      const auto& points = content.table.points;
      for (std::size_t i = 1; i < edge.points.size(); ++i) {
        parameters->add_wire({{points[edge.points[i - 1]], points[edge.points[i]]}, {0, 0}});
      }
    }
    return parameters;
  }

  Content content_;
};

}  // namespace

std::unique_ptr<PreparedLeaf> result::leaf_of(Content content) {
  return std::make_unique<ResultLeaf>(std::move(content));
}

}  // namespace cnrg
