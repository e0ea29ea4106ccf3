// Every cell of the complex that lies on the leaf is a piece of one stored cell (cell_map.h), a 3-cell is by its
// label.
#include "csg/transfer/leaf_value.h"

#include <algorithm>
#include <map>
#include <string>

#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/complex/by_dimension.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

using Index = CellMap::Index;
constexpr const char* kAgain = "; write the file again with `cnrg eval -o`";

[[noreturn]] void refuse_group(const std::string& fault) {
  throw InputError("the result calls itself a group but " + fault + kAgain);
}

[[noreturn]] void refuse_overlap(const CellMap::Piece& a, const CellMap::Piece& b) {
  static constexpr const char* kCells[] = {"vertices", "edges", "faces"};
  throw InputError("the cells of the result overlap: " + std::string(kCells[a.dimension]) + " " +
                   std::to_string(a.number) + " and " + std::to_string(b.number) + kAgain);
}

class LeafValue {
 public:
  LeafValue(const Complex& complex, LeafId leaf, const Group& cells, const StoredValue& stored, const CellMap& map)
      : complex_(complex), leaf_(leaf), cells_(cells), stored_(stored), map_(map), part_(map.part_of(leaf)) {
    const auto& regions = stored.cells.regions;
    const auto outside = std::find_if(regions.begin(), regions.end(), [](const auto& r) { return !r.bounded; });
    if (outside != regions.end()) outside_ = Index(outside - regions.begin());
  }

  Components run(const std::vector<Attributes>& attributes,
                 const std::function<Attributes(const Attributes&)>& placed) {
    select(static_cast<Component>(attributes.size()));
    const Selection& s = out_.selection;
    const auto set_origins = [&](const auto& cells, std::vector<LeafSetId>& origins) {
      for (const auto& [cell, component] : cells) origins.push_back(set_of(stored(piece(cell)), nullptr));
    };
    for_each_dimension(set_origins, s, out_.origins);
    put_said(placed);
    for (std::size_t i = 0; i < attributes.size(); ++i) {
      out_.attributes.push_back({{attributes[i], {leaf_}}, stored_.dominances[stored_.group ? 0 : i]});
    }
    for (std::size_t i = 0; i < s.regions.size(); ++i) {
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
  using Origin = FlatComplex::Provenance;
  /// What is told of a cell.
  struct Stored {
    Component component = 0;
    bool feature = false;
    const Origin* origin = nullptr;
  };

  // The stored cell that a cell is a piece of.
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
  Piece piece(RegionId r) const { return {part_, 3, region(r)}; }
  Piece piece(FaceId f) const {
    const std::optional<Piece> found = piece_on(f);
    return found ? *found : piece(complex_.face_regions[f][0]);
  }
  template <class IdT>
  Piece piece(IdT cell) const {
    const std::optional<Piece> found = piece_on(cell);
    return found ? *found : piece(complex_.some_region(cell));
  }

  Stored stored(const Piece& of) const {
    const auto told = [](const auto& cell) {
      Stored out{cell.component, false, &cell.origin};
      if constexpr (requires { cell.feature; }) out.feature = cell.feature;
      return out;
    };
    switch (of.dimension) {
      case 0: return told(stored_.cells.vertices.at(of.number));
      case 1: return told(stored_.cells.edges.at(of.number));
      case 2: return told(stored_.cells.faces.at(of.number));
      default: return of.number == FlatComplex::kNone ? Stored() : told(stored_.cells.regions.at(of.number));
    }
  }
  LeafId here(LeafId of_run) const { return LeafId(leaf_.value() + 1 + of_run.value()); }

  /// The leaf and those that a cell came from, with what is said of it.
  LeafSetId set_of(const Stored& cell, const SaidPointer& said) {
    const Origin* const origin = cell.origin != nullptr && !cell.origin->leaves.empty() ? cell.origin : nullptr;
    LeafSetId& set = sets_[{origin, said.get()}];
    if (set.valid()) return set;
    std::vector<LeafId> leaves{leaf_};
    if (origin != nullptr) {
      for (const LeafId leaf : origin->leaves) leaves.push_back(here(leaf));
    }
    return set = out_.origins.sets.intern(leaves, said);
  }

 public:
  /// After `run`: the cells of the leaves that its cells came from.
  void list_held(const Selection& selection, HeldCells& held) const {
    const auto add = [&](const auto& cells, auto& list) {
      for (const auto& [cell, component] : cells) {
        for (const LeafCell& of : stored(piece(cell)).origin->cells)
          list.emplace_back(cell, LeafCell{here(of.leaf), of.dimension, of.number});
      }
    };
    for_each_entity(add, selection, held);
  }

 private:
  /// A cell has what is said of the cell that it is a piece of; else what is said of a face or an edge that it
  /// bounds.
  void put_said(const std::function<Attributes(const Attributes&)>& placed) {
    if (stored_.said.empty()) return;
    Scratch<EdgeId, LeafSetId::Value> at_edge(complex_.edge_count());  // 1 + the set
    Scratch<VertexId, LeafSetId::Value> at_vertex(complex_.points.size());
    std::map<std::pair<const Attributes*, int>, SaidPointer> known;
    const auto said_by = [&](LeafSetId set) -> const SaidPointer& { return out_.origins.sets.said(set); };
    const auto told = [&](const Piece& of) {
      const Stored cell = stored(of);
      SaidPointer& what = known[{cell.origin->said, of.dimension}];
      if (what == nullptr) what = std::make_shared<const Said>(Said{placed(*cell.origin->said), of.dimension});
      return set_of(cell, what);
    };
    const auto speaks = [&](const Piece& of, int dimension) {
      return of.dimension == dimension && stored(of).origin->said != nullptr;
    };
    const auto bound = [&](auto& around, auto cell, LeafSetId set) {
      if (around.get(cell) == 0) around[cell] = set.value() + 1;
    };
    const Selection& s = out_.selection;
    for (std::size_t i = 0; i < s.faces.size(); ++i) {
      const FaceId f = s.faces[i].first;
      if (!speaks(piece(f), 2)) continue;
      const LeafSetId set = out_.origins.faces[i] = told(piece(f));
      for_each_bounding(complex_, f, [&](auto cell) {
        if constexpr (std::is_same_v<decltype(cell), EdgeId>) bound(at_edge, cell, set);
        else bound(at_vertex, cell, set);
      });
    }
    for (std::size_t i = 0; i < s.edges.size(); ++i) {
      const EdgeId e = s.edges[i].first;
      const Piece of = piece(e);
      LeafSetId& set = out_.origins.edges[i];
      if (speaks(of, 1)) {
        set = told(of);
        for (const VertexId v : complex_.edge_ends[e]) at_vertex[v] = set.value() + 1;
      } else if (at_edge.get(e) != 0) {
        set = set_of(stored(of), said_by(LeafSetId(at_edge.get(e) - 1)));
      }
    }
    for (std::size_t i = 0; i < s.vertices.size(); ++i) {
      const VertexId v = s.vertices[i].first;
      const Piece of = piece(v);
      if (speaks(of, 0)) out_.origins.vertices[i] = told(of);
      else if (at_vertex.get(v) != 0)
        out_.origins.vertices[i] = set_of(stored(of), said_by(LeafSetId(at_vertex.get(v) - 1)));
    }
  }

  /// The stored region of a 3-cell; kNone where there is none.
  Index region(RegionId r) const {
    for (const Label& label : complex_.labels(r)) {
      if (label.leaf == leaf_) return label.region - 1;
    }
    return outside_;
  }

  /// Active 3-cells and what is inside of their regions, then the cells that lie on the leaf.
  void select(Component count) {
    Group inside;
    inside.faces = cells_.faces;
    inside.edges = cells_.edges;
    inside.vertices = cells_.vertices;
    inside.regions.resize(count);
    const auto add = [&](RegionId r) {
      const Component c = stored(piece(r)).component;
      if (c != 0) inside.cells.emplace_back(r, c);
    };
    if (outside_ == FlatComplex::kNone || stored_.cells.regions[outside_].component == 0) {
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
        const Stored cell = stored(*of);
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
  const StoredValue& stored_;
  const CellMap& map_;
  const Index part_;
  Index outside_ = FlatComplex::kNone;  // the unbounded region
  std::map<std::pair<const Origin*, const Said*>, LeafSetId> sets_;
  Components out_;
};

/// `group_of` numbers regions as they come in the complex; in the value region i is component i.
void keep_numbers(const Components& components, Group& group) {
  std::vector<RegionAttributes> regions(components.attributes.size() - 1);
  std::vector<Component> number(group.regions.size() + 1, 0);
  for (std::size_t i = 0; i < group.cells.size(); ++i) {
    const Component stated = components.selection.regions[i].second;
    Component& made = number[group.cells[i].second];
    if ((made != 0 && made != stated) || stated > regions.size())
      refuse_group("one region is of several components");
    made = group.cells[i].second = stated;
  }
  if (group.regions.size() != regions.size()) refuse_group("a component is not one region");
  for (std::size_t i = 1; i < number.size(); ++i) regions[number[i] - 1] = std::move(group.regions[i - 1]);
  group.regions = std::move(regions);
}

}  // namespace

CellMap::Part part_of(LeafId leaf, const StoredValue& stored, std::span<const VertexId> points) {
  CellMap::Part part{leaf, {}, {}};
  const auto& [vertices, edges] = std::tie(stored.cells.vertices, stored.cells.edges);
  for (Index i = 0; i < edges.size(); ++i) {
    for_each_segment(edges[i], [&](Index a, Index b) { part.segments.push_back({{points[a], points[b]}, i}); });
  }
  for (Index i = 0; i < vertices.size(); ++i) part.vertices.emplace_back(points[vertices[i].point], i);
  return part;
}

NodeValue leaf_value(const Complex& complex, LeafId leaf, const Group& cells, const StoredValue& stored,
                     const CellMap& map, const std::vector<Attributes>& attributes,
                     const std::function<Attributes(const Attributes&)>& placed, HeldCells* held) {
  std::vector<Attributes> all = attributes;
  if (stored.group) all.push_back({.name = Name::of_entities()});
  if (map.overlap() && map.overlap()->first.part == map.part_of(leaf))
    refuse_overlap(map.overlap()->first, map.overlap()->second);
  LeafValue made(complex, leaf, cells, stored, map);
  Components components = made.run(all, placed);
  if (held != nullptr) made.list_held(components.selection, *held);
  if (!stored.group) return components;
  const CellSet missing = missing_boundary(complex, components);
  if (!missing.empty())
    refuse_group("is not closed: " + std::to_string(missing.size()) + " cells of its boundary are missing");
  Group group = group_of(complex, components);
  keep_numbers(components, group);
  group.dominance = stored.dominances[0];
  return {complex, std::move(group)};
}

}  // namespace cnrg
