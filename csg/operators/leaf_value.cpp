// Every cell of the complex that lies on the leaf is a piece of one cell of the file: a face by its cover, a
// 3-cell by its label, an edge by the input segment under it (its ends are points of the file) or else by the face
// whose interior it is in, a vertex by its point, its edges or its face. Points of the file are known by their
// order: they are all there, and the order of points is that of their exact coordinates.
#include "csg/operators/leaf_value.h"

#include <algorithm>
#include <numeric>

#include "kernel/base/error.h"
#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

using Index = std::uint32_t;
constexpr const char* kAgain = "; write the file again with `cnrg eval -o`";

/// The number of the one cell of the file that is meant; there must not be two.
class One {
 public:
  explicit One(const char* what) : what_(what) {}
  void see(Index number) {
    if (number_ != kNone && number_ != number) {
      throw InputError("the cells of the result overlap: " + std::string(what_) + " " + std::to_string(number_) +
                       " and " + std::to_string(number) + kAgain);
    }
    number_ = number;
  }
  bool found() const { return number_ != kNone; }
  Index number() const { return number_; }

 private:
  const char* what_;
  Index number_ = kNone;
};

class LeafValue {
 public:
  LeafValue(const Complex& complex, LeafId leaf, const Group& cells, const CellTable& table)
      : complex_(complex),
        leaf_(leaf),
        cells_(cells),
        table_(table),
        point_(complex.points.size()),
        edge_(complex.edge_count()) {}

  Components run(const Transform& transform, const std::vector<Attributes>& attributes,
                 const std::vector<Attributes>& said) {
    number_points(transform);
    number_edges();
    select(static_cast<Component>(attributes.size()));
    const Selection& s = out_.selection;
    const auto set_origins = [&](const auto& cells, std::vector<LeafSetId>& origins) {
      for (const auto& [cell, component] : cells) origins.push_back(set_of(made(cell), nullptr));
    };
    set_origins(s.vertices, out_.origins.vertices);
    set_origins(s.edges, out_.origins.edges);
    set_origins(s.faces, out_.origins.faces);
    set_origins(s.regions, out_.origins.regions);
    put_said(said);
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      out_.attributes.push_back({{attributes[i], {leaf_}}, table_.dominances[table_.group ? 0 : i]});
    }
    for (std::size_t i = 0; table_.makers != nullptr && i < s.regions.size(); ++i) {
      const auto set = out_.origins.sets[out_.origins.regions[i]];
      std::vector<LeafId>& leaves = out_.attributes[s.regions[i].second - 1].leaves;
      if (leaves.size() < set.size() || !std::includes(leaves.begin(), leaves.end(), set.begin(), set.end())) {
        leaves.insert(leaves.end(), set.begin(), set.end());
        sort_unique(leaves);
      }
    }
    return std::move(out_);
  }

 private:
  bool is_of_leaf(SegmentId s) const {
    const auto faces = complex_.segment_faces[s];
    const auto wires = complex_.segment_wires[s];
    const auto has_face = [&](SourceId f) { return complex_.sources[f].leaf == leaf_; };
    const auto has_wire = [&](WireId w) { return complex_.wires[w].leaf == leaf_; };
    return std::any_of(faces.begin(), faces.end(), has_face) || std::any_of(wires.begin(), wires.end(), has_wire);
  }

  using Made = CellMakers::Made;

  /// What made the cell of the file that a cell is a piece of; nullptr where only the leaf is known.
  const Made* made(FaceId f) const {
    if (table_.makers == nullptr) return nullptr;
    One face("faces");
    see(f, face);
    if (face.found()) return &table_.makers->faces.at(face.number());
    return made_inside(complex_.face_regions[f][0]);
  }
  const Made* made(EdgeId e) const {
    if (table_.makers == nullptr) return nullptr;
    if (edge_[e] != 0) return &table_.makers->edges.at(edge_[e] - 1);
    One face("faces");
    see(e, face);
    if (face.found()) return &table_.makers->faces.at(face.number());
    return made_inside(complex_.some_region(e));
  }
  const Made* made(VertexId v) const {
    if (table_.makers == nullptr) return nullptr;
    if (point_[v] != 0) {
      const auto vertex = table_.makers->vertices.find(point_[v] - 1);
      if (vertex != table_.makers->vertices.end()) return &vertex->second;
    }
    One edge("edges"), face("faces");
    for (const EdgeId e : complex_.vertex_edges[v]) {
      if (edge_[e] != 0) edge.see(edge_[e] - 1);
    }
    if (edge.found()) return &table_.makers->edges.at(edge.number());
    for (const EdgeId e : complex_.vertex_edges[v]) see(e, face);
    for (const FaceId f : complex_.vertex_faces[v]) see(f, face);
    if (face.found()) return &table_.makers->faces.at(face.number());
    return made_inside(complex_.some_region(v));
  }
  const Made* made(RegionId r) const { return table_.makers == nullptr ? nullptr : made_inside(r); }
  const Made* made_inside(RegionId r) const { return &table_.makers->regions.at(label(r)); }

  LeafId here(LeafId of_run) const { return LeafId(leaf_.value() + 1 + of_run.value()); }

  /// The leaf and those that made a cell, with what is said of it.
  LeafSetId set_of(const Made* made, const SaidPointer& said) {
    LeafSetId& set = sets_[{made, said.get()}];
    if (set.valid()) return set;
    std::vector<LeafId> leaves{leaf_};
    if (made != nullptr) {
      for (const LeafId leaf : made->leaves) leaves.push_back(here(leaf));
    }
    return set = out_.origins.sets.intern(leaves, said);
  }

 public:
  /// After `run`: the cells of the leaves that made its cells.
  void list_held(const Selection& selection, HeldCells& held) const {
    const auto add = [&](const auto& cells, auto& list) {
      for (const auto& [cell, component] : cells) {
        const Made* const by = made(cell);
        if (by == nullptr) continue;
        for (const LeafCell& of : by->cells)
          list.emplace_back(cell, LeafCell{here(of.leaf), of.dimension, of.number});
      }
    };
    add(selection.faces, held.faces);
    add(selection.edges, held.edges);
    add(selection.vertices, held.vertices);
  }

 private:
  void number_points(const Transform& transform) {
    std::vector<VertexId> vertices;
    for (const EdgeId e : cells_.edges) {
      for (const SegmentId s : complex_.edge_segments[e]) {
        if (!is_of_leaf(s)) continue;
        vertices.insert(vertices.end(), complex_.segment_ends[s].begin(), complex_.segment_ends[s].end());
      }
    }
    for (const VertexId v : cells_.vertices) {
      const auto leaves = complex_.isolated_leaves[v];
      if (std::find(leaves.begin(), leaves.end(), leaf_) != leaves.end()) vertices.push_back(v);
    }
    sort_unique(vertices);
    std::sort(vertices.begin(), vertices.end(),
              [&](VertexId a, VertexId b) { return compare_lex(complex_.points, a, b) < 0; });
    const std::vector<Index> order = order_of_points(transform);
    if (vertices.size() != order.size()) {
      throw InputError("the cells of the result do not fit together: " + std::to_string(vertices.size()) +
                       " of its " + std::to_string(order.size()) + " points are on their boundaries" + kAgain);
    }
    for (std::size_t i = 0; i < order.size(); ++i) point_[vertices[i]] = order[i] + 1;
  }

  /// The points of the file in the order of their images.
  std::vector<Index> order_of_points(const Transform& transform) const {
    std::vector<Index> order(table_.points.size());
    std::iota(order.begin(), order.end(), 0u);
    if (transform.identity()) return order;
    std::vector<RationalPoint> images;
    images.reserve(order.size());
    for (const RationalPoint& p : table_.points) images.push_back(transform.apply(p));
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return images[a] < images[b]; });
    return order;
  }

  void number_edges() {
    for (const EdgeId e : cells_.edges) {
      One edge("edges");
      for (const SegmentId s : complex_.edge_segments[e]) {
        if (!is_of_leaf(s)) continue;
        const auto& [a, b] = complex_.segment_ends[s];
        const auto found = table_.segments.find(std::minmax(point_[a] - 1, point_[b] - 1));
        if (found != table_.segments.end()) edge.see(found->second);
      }
      if (edge.found()) edge_[e] = edge.number() + 1;
    }
  }

  void see(FaceId f, One& face) const {
    for (const Cover& cover : complex_.cover(f)) {
      const Soup::Face& source = complex_.sources[cover.source];
      if (source.leaf == leaf_) face.see(source.leaf_face);
    }
  }
  void see(EdgeId e, One& face) const {
    for (const FaceUse& use : complex_.edge_uses[e]) see(use.face, face);
  }

  Component of(const One& face) const {
    require(face.found(), "leaf_value: a cell of a leaf lies on none of its faces");
    return table_.faces.at(face.number());
  }
  /// A cell has what the file says of the cell that it is a piece of; else what is said of a face or an edge that
  /// it bounds.
  void put_said(const std::vector<Attributes>& said) {
    if (said.empty()) return;
    Scratch<EdgeId, LeafSetId::Value> at_edge(complex_.edge_count());  // 1 + the set
    Scratch<VertexId, LeafSetId::Value> at_vertex(complex_.points.size());
    std::map<std::pair<Index, int>, SaidPointer> known;
    const auto said_by = [&](LeafSetId set) -> const SaidPointer& { return out_.origins.sets.said(set); };
    const auto told = [&](auto cell, Index number, int dimension) {
      SaidPointer& what = known[{number, dimension}];
      if (what == nullptr) what = std::make_shared<const Said>(Said{said[number], dimension});
      return set_of(made(cell), what);
    };
    const auto bound = [&](auto& around, auto cell, LeafSetId set) {
      if (around.get(cell) == 0) around[cell] = set.value() + 1;
    };
    const Selection& s = out_.selection;
    for (std::size_t i = 0; i < s.faces.size(); ++i) {
      One face("faces");
      see(s.faces[i].first, face);
      const Index number = face.found() ? table_.said_of_faces.at(face.number()) : CellTable::kSilent;
      if (number == CellTable::kSilent) continue;
      const LeafSetId set = out_.origins.faces[i] = told(s.faces[i].first, number, 2);
      for (const LoopId l : complex_.face_loops[s.faces[i].first]) {
        for (const HalfEdge h : complex_.loop[l]) {
          bound(at_edge, h.edge(), set);
          bound(at_vertex, complex_.origin(h), set);
        }
      }
      for (const VertexId v : complex_.face_vertices[s.faces[i].first]) bound(at_vertex, v, set);
    }
    for (std::size_t i = 0; i < s.edges.size(); ++i) {
      const EdgeId e = s.edges[i].first;
      LeafSetId& set = out_.origins.edges[i];
      const Index number = edge_[e] != 0 ? table_.edges[edge_[e] - 1].said : CellTable::kSilent;
      if (number != CellTable::kSilent) {
        set = told(e, number, 1);
        for (const VertexId v : complex_.edge_ends[e]) at_vertex[v] = set.value() + 1;
      } else if (at_edge.get(e) != 0) {
        set = set_of(made(e), said_by(LeafSetId(at_edge.get(e) - 1)));
      }
    }
    for (std::size_t i = 0; i < s.vertices.size(); ++i) {
      const VertexId v = s.vertices[i].first;
      const auto vertex = point_[v] == 0 ? table_.vertices.end() : table_.vertices.find(point_[v] - 1);
      const Index number = vertex == table_.vertices.end() ? CellTable::kSilent : vertex->second.said;
      LeafSetId& set = out_.origins.vertices[i];
      if (number != CellTable::kSilent) set = told(v, number, 0);
      else if (at_vertex.get(v) != 0) set = set_of(made(v), said_by(LeafSetId(at_vertex.get(v) - 1)));
    }
  }

  Component component(FaceId f) const {
    One face("faces");
    see(f, face);
    return of(face);
  }
  CellTable::Cell cell(EdgeId e) const {
    if (edge_[e] != 0) return table_.edges[edge_[e] - 1];
    One face("faces");
    see(e, face);
    return {of(face), false};
  }
  CellTable::Cell cell(VertexId v) const {
    if (point_[v] != 0) {
      const auto vertex = table_.vertices.find(point_[v] - 1);
      if (vertex != table_.vertices.end()) return vertex->second;
    }
    One edge("edges"), face("faces");
    for (const EdgeId e : complex_.vertex_edges[v]) {
      if (edge_[e] != 0) edge.see(edge_[e] - 1);
    }
    if (edge.found()) return {table_.edges[edge.number()].component, false};
    for (const EdgeId e : complex_.vertex_edges[v]) see(e, face);
    for (const FaceId f : complex_.vertex_faces[v]) see(f, face);
    return {of(face), false};
  }

  std::uint32_t label(RegionId r) const {
    for (const Label& label : complex_.labels(r)) {
      if (label.leaf == leaf_) return label.region;
    }
    return 0;
  }
  Component component(RegionId r) const { return table_.regions.at(label(r)); }

  /// Active 3-cells and what is inside of their regions, then the cells that lie on the leaf.
  void select(Component count) {
    Group inside;
    inside.faces = cells_.faces;
    inside.edges = cells_.edges;
    inside.vertices = cells_.vertices;
    inside.regions.resize(count);
    const auto add = [&](RegionId r) {
      const Component c = component(r);
      if (c != 0) inside.cells.emplace_back(r, c);
    };
    if (table_.regions[0] == 0) {
      for (const auto& [r, region] : cells_.cells) add(r);
    } else {
      for (const RegionId r : IdRange<RegionId>(complex_.region_count)) {
        if (!complex_.outside_frame(r)) add(r);
      }
    }
    Selection& s = out_.selection = selection_of(complex_, inside);
    const auto fill = [&](auto& list, auto component_of) {
      for (auto& [id, c] : list) {
        if (c == count + 1) c = component_of(id);
      }
      std::erase_if(list, [](const auto& entry) { return entry.second == 0; });
    };
    fill(s.faces, [&](FaceId f) { return component(f); });
    fill(s.edges, [&](EdgeId e) {
      const CellTable::Cell found = cell(e);
      if (found.feature && found.component != 0) out_.features.edges.push_back(e);
      return found.component;
    });
    fill(s.vertices, [&](VertexId v) {
      const CellTable::Cell found = cell(v);
      if (found.feature && found.component != 0) out_.features.vertices.push_back(v);
      return found.component;
    });
  }

  const Complex& complex_;
  const LeafId leaf_;
  const Group& cells_;
  const CellTable& table_;
  Scratch<VertexId, Index> point_;  // of the file, from 1
  Scratch<EdgeId, Index> edge_;     // of the file, from 1
  std::map<std::pair<const Made*, const Said*>, LeafSetId> sets_;
  Components out_;
};

/// `group_of` numbers regions as they come in the complex; in the file region i is component i.
void keep_numbers(const Components& components, Group& group) {
  std::vector<RegionAttributes> regions(components.attributes.size() - 1);
  std::vector<Component> number(group.regions.size() + 1, 0);
  for (std::size_t i = 0; i < group.cells.size(); ++i) {
    const Component stated = components.selection.regions[i].second;
    Component& made = number[group.cells[i].second];
    require((made == 0 || made == stated) && stated <= regions.size(), "leaf_value: a component is no region");
    made = group.cells[i].second = stated;
  }
  require(group.regions.size() == regions.size(), "leaf_value: a component is in several pieces");
  for (std::size_t i = 1; i < number.size(); ++i) regions[number[i] - 1] = std::move(group.regions[i - 1]);
  group.regions = std::move(regions);
}

}  // namespace

NodeValue leaf_value(const Complex& complex, LeafId leaf, const Group& cells, const CellTable& table,
                     const Transform& transform, const std::vector<Attributes>& attributes,
                     const std::vector<Attributes>& said, HeldCells* held) {
  std::vector<Attributes> all = attributes;
  if (table.group) all.push_back({.name = Name::of_entities()});
  LeafValue made(complex, leaf, cells, table);
  Components components = made.run(transform, all, said);
  if (held != nullptr) made.list_held(components.selection, *held);
  if (!table.group) return components;
  const CellSet missing = missing_boundary(complex, components);
  if (!missing.empty()) {
    throw InputError("the result calls itself a group but is not closed: " + std::to_string(missing.size()) +
                     " cells of its boundary are missing" + kAgain);
  }
  Group group = group_of(complex, components);
  keep_numbers(components, group);
  group.dominance = table.dominances[0];
  return {complex, std::move(group)};
}

}  // namespace cnrg
