#include "csg/weld/weld_leaves.h"

#include <algorithm>
#include <map>
#include <optional>

#include "csg/curves/surface_placed.h"
#include "csg/geometry/planar_polygon.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/weld/weld.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/triangulate.h"

namespace cnrg {
namespace {

using Index = WeldModel::Index;

std::vector<std::vector<PointId>> loops_of(const Soup& soup, SourceId f) {
  std::vector<std::vector<PointId>> loops(1);
  for (const PointId p : soup.corners(f)) {
    if (p.valid()) loops.back().push_back(p);
    else loops.emplace_back();
  }
  return loops;
}

bool on_one_plane(const std::vector<std::vector<RationalPoint>>& loops) {
  const RationalPoint normal = area_vector(loops[0]);
  const Rational offset = dot(normal, loops[0][0]);
  return std::all_of(loops.begin(), loops.end(), [&](const auto& loop) {
    return std::all_of(loop.begin(), loop.end(), [&](const RationalPoint& p) { return dot(normal, p) == offset; });
  });
}

/// Parameters of a leaf that was moved; what its facets were before is `sources`.
std::shared_ptr<const LeafParameters> moved_parameters(const LeafParameters& old, const Transform& transform,
                                                       const std::map<RationalPoint, RationalPoint>& moved,
                                                       const std::vector<Index>& sources, const Soup& soup) {
  const auto place = [&](const RationalPoint& p) {
    const RationalPoint at = transform.apply(p);
    const auto it = moved.find(at);
    return it == moved.end() ? at : it->second;
  };
  auto made = std::make_shared<LeafParameters>();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::uint32_t patch = soup.face(SourceId(i)).patch;
    made->name_patch(patch, old.patch_name(patch));
    std::vector<std::vector<PatchCorner>> cells;
    for (std::vector<PatchCorner> cell : old.cells(sources[i])) {
      for (PatchCorner& corner : cell) corner.point = place(corner.point);
      if (is_cell(cell)) cells.push_back(std::move(cell));
      else if (cell.size() == 4) {
        for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
          const std::vector<PatchCorner> half{cell[a], cell[b], cell[c]};
          if (is_cell(half)) cells.push_back(half);
        }
      }
    }
    made->add_facet(cells);
  }
  const auto wires = soup.wires();
  for (std::size_t i = 0, from = 0; i < old.wire_count(); ++i) {
    LeafParameters::Wire wire = old.wire(i);
    for (RationalPoint& p : wire.ends) p = place(p);
    if (wire.ends[0] == wire.ends[1]) continue;
    made->name_curve(wires[from].leaf_edge, old.curve_name(wires[from].leaf_edge));
    made->add_wire(wire);
    ++from;
  }
  return made;
}

class LeafWelder {
 public:
  LeafWelder(const std::vector<LeafInstance>& instances, const Rational& d, const Rational& moved)
      : instances_(instances), d_(d), way_(d - moved) {}

  WeldedLeaves run() {
    for (Index i = 0; i < instances_.size(); ++i) take(i);
    model_.face_name = [this](Index f) { return LeafPlace{names_[f].first, {names_[f].second}}; };
    made_ = weld(model_, way_);
    WeldedLeaves result{instances_, made_.notice(d_)};
    for (Index i = 0; i < instances_.size(); ++i) {
      if (soups_[i] && is_moved(i)) result.instances[i] = replaced(i);
    }
    return result;
  }

 private:
  // --- to the model

  void take(Index i) {
    soups_.emplace_back();
    first_point_.push_back(static_cast<Index>(model_.points.size()));
    const PreparedLeaf& leaf = *instances_[i].leaf;
    if (leaf.unbounded() || leaf.stored() != nullptr || instances_[i].transform->determinant() == 0) return;
    Soup& soup = soups_.back().emplace();
    leaf.add_to(soup, instances_[i].transform);
    for (PointId p : IdRange<PointId>(soup.point_count())) model_.points.push_back(exact_value(soup, p));
    const Fill fill = soup.fill(LeafId(0));
    std::map<Index, Index> face_of;            // leaf_face: of the model
    std::map<Index, WeldModel::Solid> solids;  // by region
    for (SourceId f : IdRange<SourceId>(soup.face_count())) {
      const Soup::Face& face = soup.face(f);
      const auto [it, fresh] = face_of.try_emplace(face.leaf_face, static_cast<Index>(model_.faces.size()));
      if (fresh) {
        model_.faces.emplace_back();
        names_.emplace_back(i, face.leaf_face);
      }
      const auto number = static_cast<Index>(model_.facets.size());
      WeldModel::Facet& facet = model_.facets.emplace_back();
      facet.face = it->second;
      for (const auto& loop : loops_of(soup, f)) {
        auto& ring = facet.loops.emplace_back();
        for (const PointId p : loop) ring.push_back(first_point_[i] + p.value());
      }
      if (fill == Fill::winding) solids[1].facets.emplace_back(number, true);
      if ((fill == Fill::sides || fill == Fill::solids) && face.front != face.back) {
        if (face.back != 0) solids[face.back].facets.emplace_back(number, true);
        if (face.front != 0) solids[face.front].facets.emplace_back(number, false);
      }
    }
    for (auto& [region, solid] : solids) {
      solid.name = fill == Fill::solids ? LeafPlace{i, {}, {region}} : LeafPlace{i};
      model_.solids.push_back(std::move(solid));
    }
  }

  // --- and back

  const RationalPoint& moved(Index i, PointId p) const { return made_.points[first_point_[i] + p.value()]; }

  bool is_moved(Index i) const {
    for (Index p = 0; p < soups_[i]->point_count(); ++p) {
      if (made_.points[first_point_[i] + p] != model_.points[first_point_[i] + p]) return true;
    }
    return false;
  }

  LeafInstance replaced(Index i) const {
    const Soup& from = *soups_[i];
    Soup soup;
    const LeafId leaf = soup.add_leaf(from.fill(LeafId(0)), from.curved_sides(LeafId(0)));
    if (const LeafAxes* const axes = from.own_axes(LeafId(0))) soup.set_own_axes(leaf, *axes);
    std::map<RationalPoint, PointId> ids;
    const auto id = [&](const RationalPoint& p) {
      const auto [it, fresh] = ids.try_emplace(p);
      if (fresh) it->second = soup.add_point(p);
      return it->second;
    };
    std::vector<Index> sources;
    for (SourceId f : IdRange<SourceId>(from.face_count())) {
      const Soup::Face& face = from.face(f);
      for (const auto& loops : polygons(i, f)) {
        std::vector<std::vector<PointId>> rings;
        for (const auto& loop : loops) {
          auto& ring = rings.emplace_back();
          for (const RationalPoint& p : loop) ring.push_back(id(p));
        }
        soup.add_face(leaf, rings, face.leaf_face, face.patch, face.front, face.back);
        sources.push_back(static_cast<Index>(f.index()));
      }
    }
    for (const Soup::Wire& wire : from.wires()) {
      const RationalPoint &a = moved(i, wire.a), &b = moved(i, wire.b);
      if (a == b) continue;
      const PointId first = id(a), second = id(b);
      soup.add_wire(leaf, first, second, wire.leaf_edge);
    }
    for (const Soup::Isolated& point : from.isolated()) soup.add_isolated(leaf, id(moved(i, point.point)));
    for (const Soup::Isolated& end : from.curve_ends()) soup.add_curve_end(leaf, id(moved(i, end.point)));

    const LeafInstance& old = instances_[i];
    const auto kept = std::make_shared<const Soup>(soup);
    auto made = std::make_shared<GeometryLeaf>(std::move(soup), old.leaf->regions());
    if (const ParameterSource source = old.leaf->parameters()) {
      std::map<RationalPoint, RationalPoint> moves;
      for (PointId p : IdRange<PointId>(from.point_count())) {
        const RationalPoint was = exact_value(from, p);
        if (was != moved(i, p)) moves.emplace(was, moved(i, p));
      }
      made->set_parameters([source, transform = old.transform, moves, sources, kept] {
        return moved_parameters(*source(), transform, moves, sources, *kept);
      });
    }
    if (old.leaf->surfaces()) made->set_surfaces(cnrg::moved(old.leaf->surfaces(), old.transform, false));
    return {std::move(made), {}};
  }

  using Polygon = std::vector<std::vector<RationalPoint>>;

  /// What a facet became: a polygon, triangles where it is not planar any more, nothing where it vanished.
  std::vector<Polygon> polygons(Index i, SourceId f) const {
    const auto loops = loops_of(*soups_[i], f);
    Polygon polygon;
    for (const auto& loop : loops) {
      std::vector<RationalPoint> ring;
      ring.reserve(loop.size());
      for (const PointId p : loop) ring.push_back(moved(i, p));
      drop_repeated(ring);
      if (ring.size() < 3 || is_zero(area_vector(ring))) {
        if (polygon.empty()) return {};
        continue;
      }
      polygon.push_back(std::move(ring));
    }
    if (on_one_plane(polygon)) return {polygon};
    return triangles(i, loops);
  }

  static void drop_repeated(std::vector<RationalPoint>& ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  }

  /// The facet was planar before: it is cut into triangles there.
  std::vector<Polygon> triangles(Index i, const std::vector<std::vector<PointId>>& loops) const {
    PointTable table;
    std::map<RationalPoint, VertexId> ids;
    std::vector<PointId> point;
    std::vector<std::vector<VertexId>> walks;
    std::vector<RationalPoint> outer;
    for (const auto& loop : loops) {
      auto& walk = walks.emplace_back();
      for (const PointId p : loop) {
        const RationalPoint at = exact_value(*soups_[i], p);
        if (walks.size() == 1) outer.push_back(at);
        const auto [it, fresh] = ids.try_emplace(at);
        if (fresh) {
          it->second = table.add(at);
          point.push_back(p);
        }
        walk.push_back(it->second);
      }
    }
    std::vector<Polygon> result;
    for (const auto& triangle : triangulate(table, seen_along(area_vector(outer)), walks)) {
      std::vector<RationalPoint> ring;
      ring.reserve(3);
      for (const VertexId v : triangle) ring.push_back(moved(i, point[v.index()]));
      if (!collinear(ring[0], ring[1], ring[2])) result.push_back({ring});
    }
    return result;
  }

  const std::vector<LeafInstance>& instances_;
  const Rational& d_;
  const Rational way_;  // that points may still go
  WeldModel model_;
  Weld made_;
  std::vector<std::optional<Soup>> soups_;      // of each instance that is welded, where it is
  std::vector<Index> first_point_;              // of the model, by instance
  std::vector<std::pair<Index, Index>> names_;  // of faces: leaf, and its face
};

}  // namespace

WeldedLeaves weld_leaves(const std::vector<LeafInstance>& instances, const Rational& d, const Rational& moved) {
  if (moved >= d) return {instances, {}};
  return LeafWelder(instances, d, moved).run();
}

}  // namespace cnrg
