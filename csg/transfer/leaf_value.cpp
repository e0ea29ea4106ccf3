// Every cell of the complex that lies on the leaf is a piece of one cell of the file (cell_map.h), a 3-cell is by
// its label.
#include "csg/transfer/leaf_value.h"

#include <algorithm>
#include <map>
#include <string>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

using Index = CellMap::Index;
constexpr const char* kAgain = "; write the file again with `cnrg eval -o`";

[[noreturn]] void refuse_overlap(const CellMap::Piece& a, const CellMap::Piece& b) {
  static constexpr const char* kCells[] = {"vertices", "edges", "faces"};
  throw InputError("the cells of the result overlap: " + std::string(kCells[a.dimension]) + " " +
                   std::to_string(a.number) + " and " + std::to_string(b.number) + kAgain);
}

class LeafValue {
 public:
  LeafValue(const Complex& complex, LeafId leaf, const Group& cells, const CellTable& table, const CellMap& map)
      : complex_(complex), leaf_(leaf), cells_(cells), table_(table), map_(map), part_(map.part_of(leaf)) {}

  Components run(const std::vector<Attributes>& attributes, const std::vector<Attributes>& said) {
    select(static_cast<Component>(attributes.size()));
    const Selection& s = out_.selection;
    const auto set_origins = [&](const auto& cells, std::vector<LeafSetId>& origins) {
      for (const auto& [cell, component] : cells) origins.push_back(set_of(made(piece(cell)), nullptr));
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
  using Piece = CellMap::Piece;
  using Made = CellMakers::Made;

  // The cell of the file that a cell is a piece of.
  std::optional<Piece> piece_on(FaceId f) const {
    std::optional<Piece> found;
    map_.for_each_piece(complex_, f, [&](const Piece& piece) {
      if (piece.part != part_) return;
      if (found && *found != piece) refuse_overlap(*found, piece);
      found = piece;
    });
    return found;
  }
  template <class IdT>
  std::optional<Piece> piece_on(IdT cell) const {
    const auto pieces = map_.pieces(cell);
    const auto found = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& p) { return p.part == part_; });
    return found == pieces.end() ? std::nullopt : std::optional(*found);
  }
  Piece piece(RegionId r) const { return {part_, 3, label(r)}; }
  Piece piece(FaceId f) const {
    const std::optional<Piece> found = piece_on(f);
    return found ? *found : piece(complex_.face_regions[f][0]);
  }
  template <class IdT>
  Piece piece(IdT cell) const {
    const std::optional<Piece> found = piece_on(cell);
    return found ? *found : piece(complex_.some_region(cell));
  }

  /// What the file says of a cell.
  CellTable::Cell stated(const Piece& of) const {
    switch (of.dimension) {
      case 0: return table_.vertices.at(of.number);
      case 1: return table_.edges.at(of.number);
      case 2: return {table_.faces.at(of.number), false, table_.said_of_faces.at(of.number)};
      default: return {table_.regions.at(of.number)};
    }
  }
  /// What made it; nullptr where only the leaf is known.
  const Made* made(const Piece& of) const {
    if (table_.makers == nullptr) return nullptr;
    switch (of.dimension) {
      case 0: return &table_.makers->vertices.at(of.number);
      case 1: return &table_.makers->edges.at(of.number);
      case 2: return &table_.makers->faces.at(of.number);
      default: return &table_.makers->regions.at(of.number);
    }
  }

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
        const Made* const by = made(piece(cell));
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
  /// A cell has what the file says of the cell that it is a piece of; else what is said of a face or an edge that
  /// it bounds.
  void put_said(const std::vector<Attributes>& said) {
    if (said.empty()) return;
    Scratch<EdgeId, LeafSetId::Value> at_edge(complex_.edge_count());  // 1 + the set
    Scratch<VertexId, LeafSetId::Value> at_vertex(complex_.points.size());
    std::map<std::pair<Index, int>, SaidPointer> known;
    const auto said_by = [&](LeafSetId set) -> const SaidPointer& { return out_.origins.sets.said(set); };
    const auto told = [&](const Piece& of) {
      SaidPointer& what = known[{stated(of).said, of.dimension}];
      if (what == nullptr) what = std::make_shared<const Said>(Said{said[stated(of).said], of.dimension});
      return set_of(made(of), what);
    };
    const auto speaks = [&](const Piece& of, int dimension) {
      return of.dimension == dimension && stated(of).said != CellTable::kSilent;
    };
    const auto bound = [&](auto& around, auto cell, LeafSetId set) {
      if (around.get(cell) == 0) around[cell] = set.value() + 1;
    };
    const Selection& s = out_.selection;
    for (std::size_t i = 0; i < s.faces.size(); ++i) {
      const FaceId f = s.faces[i].first;
      if (!speaks(piece(f), 2)) continue;
      const LeafSetId set = out_.origins.faces[i] = told(piece(f));
      for (const LoopId l : complex_.face_loops[f]) {
        for (const HalfEdge h : complex_.loop[l]) {
          bound(at_edge, h.edge(), set);
          bound(at_vertex, complex_.origin(h), set);
        }
      }
      for (const VertexId v : complex_.face_vertices[f]) bound(at_vertex, v, set);
    }
    for (std::size_t i = 0; i < s.edges.size(); ++i) {
      const EdgeId e = s.edges[i].first;
      const Piece of = piece(e);
      LeafSetId& set = out_.origins.edges[i];
      if (speaks(of, 1)) {
        set = told(of);
        for (const VertexId v : complex_.edge_ends[e]) at_vertex[v] = set.value() + 1;
      } else if (at_edge.get(e) != 0) {
        set = set_of(made(of), said_by(LeafSetId(at_edge.get(e) - 1)));
      }
    }
    for (std::size_t i = 0; i < s.vertices.size(); ++i) {
      const VertexId v = s.vertices[i].first;
      const Piece of = piece(v);
      if (speaks(of, 0)) out_.origins.vertices[i] = told(of);
      else if (at_vertex.get(v) != 0)
        out_.origins.vertices[i] = set_of(made(of), said_by(LeafSetId(at_vertex.get(v) - 1)));
    }
  }

  std::uint32_t label(RegionId r) const {
    for (const Label& label : complex_.labels(r)) {
      if (label.leaf == leaf_) return label.region;
    }
    return 0;
  }

  /// Active 3-cells and what is inside of their regions, then the cells that lie on the leaf.
  void select(Component count) {
    Group inside;
    inside.faces = cells_.faces;
    inside.edges = cells_.edges;
    inside.vertices = cells_.vertices;
    inside.regions.resize(count);
    const auto add = [&](RegionId r) {
      const Component c = stated(piece(r)).component;
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
    const auto fill = [&](auto& list, int dimension, const auto& see_feature) {
      for (auto& [id, c] : list) {
        if (c != count + 1) continue;
        const std::optional<Piece> of = piece_on(id);
        require(of.has_value(), "leaf_value: a cell of a leaf lies on none of its faces");
        const CellTable::Cell cell = stated(*of);
        c = cell.component;
        if (cell.feature && c != 0 && of->dimension == dimension) see_feature(id);
      }
      std::erase_if(list, [](const auto& entry) { return entry.second == 0; });
    };
    fill(s.faces, 2, [](FaceId) {});
    fill(s.edges, 1, [&](EdgeId e) { out_.features.edges.push_back(e); });
    fill(s.vertices, 0, [&](VertexId v) { out_.features.vertices.push_back(v); });
  }

  const Complex& complex_;
  const LeafId leaf_;
  const Group& cells_;
  const CellTable& table_;
  const CellMap& map_;
  const Index part_;
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

CellMap::Part part_of(LeafId leaf, const CellTable& table, std::span<const VertexId> points) {
  CellMap::Part part{leaf, {}, {}};
  for (const auto& [ends, edge] : table.segments)
    part.segments.push_back({{points[ends.first], points[ends.second]}, edge});
  for (const auto& [point, cell] : table.vertices) part.vertices.emplace_back(points[point], point);
  return part;
}

NodeValue leaf_value(const Complex& complex, LeafId leaf, const Group& cells, const CellTable& table,
                     const CellMap& map, const std::vector<Attributes>& attributes,
                     const std::vector<Attributes>& said, HeldCells* held) {
  std::vector<Attributes> all = attributes;
  if (table.group) all.push_back({.name = Name::of_entities()});
  if (map.overlap() && map.overlap()->first.part == map.part_of(leaf))
    refuse_overlap(map.overlap()->first, map.overlap()->second);
  LeafValue made(complex, leaf, cells, table, map);
  Components components = made.run(all, said);
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
