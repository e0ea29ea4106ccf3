// Notation: *held* is the accumulated left operand, *new* the one that a step takes in. Flags say so per cell; all
// decisions of a step are made with the flags of both operands as they were, then the step is committed.
//
// Regions of held are disjoint sets of 3-cells, named by their smallest cell, their members linked in rings. A
// union joins them at the new 3-cells only. Where a wall comes to stand inside of a region this may fall into
// several: then its cells are joined anew. A difference never joins regions: each piece has the attributes of the
// first operand's region that it is of, and pieces are found at the end.
#include "csg/operators/accumulator.h"

#include <algorithm>
#include <tuple>

#include "csg/operators/attributes.h"
#include "csg/operators/free_cells.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

constexpr std::uint8_t kHeld = 1, kNew = 2, kRemoved = 4, kFeature = 8, kSeen = 16, kBordering = 32, kListed = 64;

// The entities of one dimension.
template <class IdT>
struct Entities {
  explicit Entities(std::size_t cells) : flags(cells), origin(cells) {}
  bool has(IdT cell, std::uint8_t any) const { return (flags[cell] & any) != 0; }
  bool kept(IdT cell) const { return has(cell, kHeld | kNew) && !has(cell, kRemoved); }
  /// Marks a held entity inside of the new operand.
  void see(IdT cell) {
    if (!has(cell, kHeld) || has(cell, kNew | kSeen)) return;
    flags[cell] |= kSeen;
    inside_new.push_back(cell);
  }

  Marks<IdT> flags;
  Scratch<IdT, LeafSetId> origin;  // of held ones
  std::vector<IdT> listed;         // all that were ever held
  std::vector<IdT> inside_new;     // of this step
};

}  // namespace

class Accumulator::State {
 public:
  explicit State(const Complex& complex)
      : complex_(complex),
        faces_(complex.face_count()),
        edges_(complex.edge_count()),
        vertices_(complex.points.size()),
        inside_(complex.region_count),
        new_region_(complex.region_count),
        regions_(complex.region_count),
        next_(complex.region_count),
        attributes_(complex.region_count) {}

  void apply(BooleanOp op, Dominance dominance, std::span<const Group* const> parts, FoldStep& step) {
    roles_ = roles(op, dominance);
    op_ = op;
    step_ = &step;
    mark_new(parts);
    decide(
        parts, faces_, [](const Group& g) -> const auto& { return g.faces; }, 2);
    decide(
        parts, edges_, [](const Group& g) -> const auto& { return g.edges; }, 1);
    decide(
        parts, vertices_, [](const Group& g) -> const auto& { return g.vertices; }, 0);
    if (op == BooleanOp::unite) {
      join_regions(parts);
    } else {
      for (const RegionId c : new_cells_) inside_[c] = 0;
      held_regions_.clear();
    }
    commit(parts);
  }

  Group group() {
    Group out;
    LeafSetMap sets(sets_, out.origins.sets);
    const auto write = [&](const auto& entities, auto& list, auto& origins) {
      for (const auto cell : entities.listed) {
        if (entities.has(cell, kHeld)) list.push_back(cell);
      }
      std::sort(list.begin(), list.end());
      origins.reserve(list.size());
      for (const auto cell : list) origins.push_back(sets(entities.origin[cell]));
    };
    write(faces_, out.faces, out.origins.faces);
    write(edges_, out.edges, out.origins.edges);
    write(vertices_, out.vertices, out.origins.vertices);
    const auto features = [](const auto& entities, const auto& list, auto& to) {
      for (const auto cell : list) {
        if (entities.has(cell, kFeature)) to.push_back(cell);
      }
    };
    features(edges_, out.edges, out.features.edges);
    features(vertices_, out.vertices, out.features.vertices);
    out.cells = detect_regions(complex_, inside(), out.faces);
    for (const auto& [cell, region] : out.cells) {
      if (region > out.regions.size()) out.regions.push_back(*pool_[attributes_[find(cell)] - 1]);
    }
    return out;
  }

 private:
  using Pieces = std::vector<std::pair<RegionId, RegionId>>;

  // --- the cells that a step touches

  void mark_new(std::span<const Group* const> parts) {
    new_cells_.clear(), new_attributes_.clear(), new_first_.clear();
    for (const Group* part : parts) {
      for (FaceId f : part->faces) faces_.flags[f] |= kNew;
      for (EdgeId e : part->edges) edges_.flags[e] |= kNew;
      for (VertexId v : part->vertices) vertices_.flags[v] |= kNew;
      const auto base = static_cast<std::uint32_t>(new_attributes_.size());
      for (const RegionAttributes& region : part->regions) new_attributes_.push_back(&region);
      new_first_.resize(new_attributes_.size());
      for (const auto& [cell, region] : part->cells) {
        new_region_[cell] = base + region;
        RegionId& first = new_first_[base + region - 1];
        first = std::min(first, cell);  // none() is the largest
        new_cells_.push_back(cell);
      }
    }
    for (RegionId cell : new_cells_) see_inside(cell);
  }

  // Held entities in the closure of a new 3-cell that are none of new are inside of its region.
  void see_inside(RegionId cell) {
    for (HalfFace h : complex_.region_faces[cell]) {
      const FaceId f = h.face();
      if (h.side() != 0 || faces_.has(f, kNew)) continue;  // inside: the same region on both sides
      faces_.see(f);
      for (LoopId l : complex_.face_loops[f]) {
        for (HalfEdge e : complex_.loop[l]) {
          edges_.see(e.edge());
          vertices_.see(complex_.origin(e));
        }
      }
      for (VertexId v : complex_.face_vertices[f]) vertices_.see(v);
    }
    for (EdgeId e : complex_.region_wires[cell]) {
      edges_.see(e);
      for (VertexId v : complex_.edge_ends[e]) vertices_.see(v);
    }
    for (VertexId v : complex_.region_vertices[cell]) vertices_.see(v);
  }

  // --- the rows

  // Decides about new entities and held ones inside of new.
  template <class IdT, class List>
  void decide(std::span<const Group* const> parts, Entities<IdT>& entities, List list, int dimension) {
    const auto decide_one = [&](IdT cell) {
      if (bounds_kept(cell)) return;
      const std::size_t row = table_row(op_, roles_.dominant, dimension, relation(entities, cell));
      if (removes(table_rows()[row].condition, cell)) {
        entities.flags[cell] |= kRemoved;
        if (step_->removed.empty()) step_->removed.resize(table_rows().size(), 0);
        ++step_->removed[row];
      }
    };
    for (const Group* part : parts) {
      for (const IdT cell : list(*part)) decide_one(cell);
    }
    for (const IdT cell : entities.inside_new) decide_one(cell);
  }

  template <class IdT>
  Relation relation(const Entities<IdT>& entities, IdT cell) const {
    if (entities.has(cell, kHeld)) {
      if (entities.has(cell, kNew)) return Relation::common;
      return roles_.swapped ? Relation::b_in_a : Relation::a_in_b;
    }
    const bool in_held = is_inside(complex_.some_region(cell));
    if (roles_.swapped) return in_held ? Relation::a_in_b : Relation::a_out_b;
    return in_held ? Relation::b_in_a : Relation::b_out_a;
  }

  bool bounds_kept(FaceId) const { return false; }
  bool bounds_kept(EdgeId e) const {
    const auto uses = complex_.edge_uses[e];
    return std::any_of(uses.begin(), uses.end(), [&](const FaceUse& use) { return faces_.kept(use.face); });
  }
  bool bounds_kept(VertexId v) const {
    const auto edges = complex_.vertex_edges[v];
    const auto faces = complex_.vertex_faces[v];
    return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) { return edges_.kept(e); }) ||
           std::any_of(faces.begin(), faces.end(), [&](FaceId f) { return faces_.kept(f); });
  }

  bool removes(Condition condition, FaceId f) {
    if (condition == Condition::never) return false;
    const auto& [front, back] = complex_.face_regions[f];
    FaceSides sides;
    auto& held = roles_.swapped ? sides.b : sides.a;
    auto& fresh = roles_.swapped ? sides.a : sides.b;
    held[0] = is_inside(front), held[1] = is_inside(back);
    fresh[0] = region_of_new(front), fresh[1] = region_of_new(back);
    // Only here one region of held on both sides and two of them are not the same.
    if (condition == Condition::no_side_survives && held[0] && held[1] && !fresh[0] && !fresh[1]) {
      held[0] = region_of_held(front), held[1] = region_of_held(back);
    }
    return holds(condition, sides);
  }

  template <class IdT>
  bool removes(Condition condition, IdT cell) {
    const std::uint8_t a = roles_.swapped ? kNew : kHeld, b = roles_.swapped ? kHeld : kNew;
    switch (condition) {
      case Condition::never: return false;
      case Condition::always: return true;
      case Condition::not_free_a: return !is_free(cell, a);
      case Condition::not_free_b: return !is_free(cell, b);
      case Condition::free_in_neither: return !is_free(cell, a) && !is_free(cell, b);
      default: break;
    }
    throw InvariantError("accumulator: a condition of faces or of intersections was asked of an edge or a vertex");
  }

  bool has(FaceId f, std::uint8_t group) const { return faces_.has(f, group); }
  bool has(EdgeId e, std::uint8_t group) const { return edges_.has(e, group); }
  bool has(VertexId v, std::uint8_t group) const { return vertices_.has(v, group); }
  template <class IdT>
  bool is_free(IdT cell, std::uint8_t group) const {
    return cnrg::is_free(complex_, cell, [&](auto id) { return has(id, group); });
  }

  // --- regions

  bool is_inside(RegionId cell) const { return inside_[cell] != 0; }
  std::uint32_t region_of_new(RegionId cell) const { return new_region_[cell]; }

  std::vector<RegionId> inside() const {
    std::vector<RegionId> out;
    for (const RegionId cell : listed_cells_) {
      if (is_inside(cell)) out.push_back(cell);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  // Of a difference, as held was before this step.
  std::uint32_t region_of_held(RegionId cell) {
    if (held_regions_.empty()) {
      std::vector<FaceId> walls;
      for (const FaceId f : faces_.listed) {
        if (faces_.has(f, kHeld)) walls.push_back(f);
      }
      std::sort(walls.begin(), walls.end());
      held_regions_ = detect_regions(complex_, inside(), walls);
    }
    const auto it = std::lower_bound(held_regions_.begin(), held_regions_.end(), std::pair(cell, 0u));
    return it->second;
  }

  RegionId find(RegionId cell) { return regions_.find(cell); }
  // The rings of both are joined at the end of the step: until then they are those of the old regions.
  void join(RegionId a, RegionId b) {
    a = find(a), b = find(b);
    if (regions_.unite(a, b)) joined_.emplace_back(std::minmax(a, b));
  }
  RegionId next(RegionId cell) const { return next_[cell] == 0 ? cell : RegionId(next_[cell] - 1); }
  template <class F>
  void for_each_member(RegionId region, F f) const {
    RegionId cell = region;
    do {
      f(cell);
      cell = next(cell);
    } while (cell != region);
  }

  // f(3-cell) for the neighbours across faces that are no walls once the step is done.
  template <class F>
  void for_each_neighbour(RegionId cell, F f) const {
    for (HalfFace h : complex_.region_faces[cell]) {
      if (!faces_.kept(h.face())) f(complex_.region(h.opposite()));
    }
  }

  // Joins new 3-cells to each other and to held ones, then gives the regions that came of it their attributes.
  void join_regions(std::span<const Group* const> parts) {
    pieces_.clear(), joined_.clear();
    for (const RegionId c : new_cells_) {
      if (is_inside(c)) pieces_.emplace_back(c, find(c));
      for_each_neighbour(c, [&](RegionId other) {
        if (is_inside(other) && !region_of_new(other)) pieces_.emplace_back(other, find(other));
      });
    }
    split_regions(parts);
    for (const RegionId c : new_cells_) {
      for_each_neighbour(c, [&](RegionId other) {
        if (is_inside(other) || region_of_new(other)) join(c, other);
      });
    }
    for (const RegionId c : new_cells_) {
      if (is_inside(c)) continue;
      inside_[c] = 1;
      listed_cells_.push_back(c);
    }
    combine();
    for (const auto& [a, b] : joined_) {
      const RegionId after_a = next(a), after_b = next(b);
      next_[a] = after_b.value() + 1, next_[b] = after_a.value() + 1;
    }
  }

  // Regions of held in which a wall of new comes to stand fall into cells, which are joined anew.
  void split_regions(std::span<const Group* const> parts) {
    split_.clear();
    for (const Group* part : parts) {
      for (const FaceId f : part->faces) {
        if (faces_.has(f, kHeld | kRemoved)) continue;
        const auto& [front, back] = complex_.face_regions[f];
        if (is_inside(front) && is_inside(back) && find(front) == find(back)) split_.push_back(find(front));
      }
    }
    sort_unique(split_);
    std::vector<RegionId> cells;
    for (const RegionId region : split_) {
      for_each_member(region, [&](RegionId c) {
        cells.push_back(c);
        pieces_.emplace_back(c, region);
      });
    }
    for (const RegionId c : cells) regions_.reset(c), next_[c] = 0;
    for (const RegionId c : cells) {
      for_each_neighbour(c, [&](RegionId other) {
        if (is_inside(other)) join(c, other);
      });
    }
  }

  // One region of an operand in a region of the result; sorted, these are its sources from the strongest on.
  struct Source {
    RegionId result;
    bool second;     // not of the operand that comes first
    RegionId first;  // the smallest cell of the source
    bool held;
    std::uint32_t attributes;  // index into the pool, or into those of new
    auto key() const { return std::tuple(result, second, first); }
  };

  void combine() {
    const bool new_first = roles_.swapped && roles_.dominant;
    std::vector<Source> sources;
    const auto add = [&](const Source& source) {
      if (sources.empty() || sources.back().key() != source.key()) sources.push_back(source);
    };
    for (const auto& [cell, region] : pieces_) {
      add({find(cell), new_first, region, true, attributes_[region] - 1});
    }
    for (const RegionId cell : new_cells_) {
      const std::uint32_t i = region_of_new(cell) - 1;
      add({find(cell), !new_first, new_first_[i], false, i});
    }
    std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.key() < b.key(); });
    sources.erase(std::unique(sources.begin(), sources.end(),
                              [](const Source& a, const Source& b) { return a.key() == b.key(); }),
                  sources.end());
    std::vector<std::pair<RegionId, RegionAttributes>> made;
    std::vector<const RegionAttributes*> of_region;
    std::vector<RegionMaterial> others;
    for (auto begin = sources.begin(); begin != sources.end();) {
      const auto end =
          std::find_if(begin, sources.end(), [&](const Source& s) { return s.result != begin->result; });
      of_region.clear();
      for (auto it = begin; it != end; ++it) of_region.push_back(&attributes_of(*it));
      made.emplace_back(begin->result, combined(of_region, roles_.dominant, others));
      for (const RegionMaterial& other : others) {
        MaterialConflict conflict{0, made.back().second.material, other, {}};
        conflict.cells.regions = cells_of(std::span(begin, end), other);
        step_->conflicts.emplace_back(begin->result, std::move(conflict));
      }
      begin = end;
    }
    for (const Source& source : sources) {
      if (source.held) attributes_[source.first] = 0, pool_[source.attributes].reset();
    }
    for (auto& [region, attributes] : made) {
      pool_.push_back(std::make_unique<RegionAttributes>(std::move(attributes)));
      attributes_[region] = static_cast<std::uint32_t>(pool_.size());
    }
  }

  const RegionAttributes& attributes_of(const Source& source) const {
    return source.held ? *pool_[source.attributes] : *new_attributes_[source.attributes];
  }

  // The 3-cells of one region of the result where an operand has the material.
  std::vector<RegionId> cells_of(std::span<const Source> sources, const RegionMaterial& material) {
    std::vector<RegionId> out;
    const RegionId result = sources.front().result;
    const auto add = [&](RegionId cell) {
      if (find(cell) == result) out.push_back(cell);
    };
    for (const Source& source : sources) {
      if (attributes_of(source).material != material) continue;
      if (!source.held) {
        for (const RegionId cell : new_cells_) {
          if (region_of_new(cell) == source.attributes + 1) add(cell);
        }
      } else if (std::binary_search(split_.begin(), split_.end(), source.first)) {
        for (const auto& [cell, region] : pieces_) {
          if (region == source.first) add(cell);
        }
      } else {
        for_each_member(source.first, add);
      }
    }
    sort_unique(out);
    return out;
  }

  // --- the end of a step

  void commit(std::span<const Group* const> parts) {
    if (op_ == BooleanOp::subtract) mark_new_borders(parts);
    for (const Group* part : parts) {
      LeafSetMap sets(part->origins.sets, sets_);
      for (const EdgeId e : part->features.edges) add_feature(edges_, e);
      for (const VertexId v : part->features.vertices) add_feature(vertices_, v);
      commit(faces_, part->faces, part->origins.faces, sets);
      commit(edges_, part->edges, part->origins.edges, sets);
      commit(vertices_, part->vertices, part->origins.vertices, sets);
    }
    commit_inside(faces_), commit_inside(edges_), commit_inside(vertices_);
    for (const RegionId c : new_cells_) new_region_[c] = 0;
  }

  // The closure of kept faces of new alone: a difference takes the features of new there.
  void mark_new_borders(std::span<const Group* const> parts) {
    for (const Group* part : parts) {
      for (const FaceId f : part->faces) {
        if (faces_.has(f, kHeld | kRemoved)) continue;
        for (LoopId l : complex_.face_loops[f]) {
          for (HalfEdge h : complex_.loop[l]) {
            edges_.flags[h.edge()] |= kBordering;
            vertices_.flags[complex_.origin(h)] |= kBordering;
          }
        }
        for (VertexId v : complex_.face_vertices[f]) vertices_.flags[v] |= kBordering;
      }
    }
  }

  template <class IdT>
  void add_feature(Entities<IdT>& entities, IdT cell) {
    if (op_ == BooleanOp::unite || entities.has(cell, kBordering)) entities.flags[cell] |= kFeature;
  }

  template <class IdT>
  void commit(Entities<IdT>& entities, const std::vector<IdT>& cells, const std::vector<LeafSetId>& origins,
              LeafSetMap& sets) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::uint8_t& flags = entities.flags[cells[i]];
      if (flags & kRemoved) {
        flags &= kListed;
        continue;
      }
      LeafSetId& origin = entities.origin[cells[i]];
      origin = (flags & kHeld) ? sets_.unite(origin, sets(origins[i])) : sets(origins[i]);
      if (!(flags & kListed)) entities.listed.push_back(cells[i]);
      flags = static_cast<std::uint8_t>(kHeld | kListed | (flags & kFeature));
    }
  }

  template <class IdT>
  static void commit_inside(Entities<IdT>& entities) {
    for (const IdT cell : entities.inside_new) {
      std::uint8_t& flags = entities.flags[cell];
      flags &= (flags & kRemoved) ? kListed : static_cast<std::uint8_t>(~kSeen);
    }
    entities.inside_new.clear();
  }

  const Complex& complex_;
  Entities<FaceId> faces_;
  Entities<EdgeId> edges_;
  Entities<VertexId> vertices_;
  LeafSets sets_;

  // 3-cells: `inside_` of held; sets of them, rings by 1 + the next (0: itself).
  Marks<RegionId> inside_;
  Scratch<RegionId, std::uint32_t> new_region_;  // 1 + index of the region of new
  SparseSets<RegionId> regions_;
  Scratch<RegionId, std::uint32_t> next_;
  Scratch<RegionId, std::uint32_t> attributes_;  // of a set's smallest cell: 1 + index into the pool
  std::vector<std::unique_ptr<RegionAttributes>> pool_;
  std::vector<RegionId> listed_cells_;  // all that were ever inside
  std::vector<std::pair<RegionId, std::uint32_t>> held_regions_;

  // The step.
  BooleanOp op_ = BooleanOp::unite;
  Roles roles_{};  // swapped: A of the rows is new
  FoldStep* step_ = nullptr;
  std::vector<RegionId> new_cells_, new_first_;  // first: the smallest cell of each region of new
  std::vector<const RegionAttributes*> new_attributes_;
  Pieces pieces_;                // 3-cells of held that were met, with the regions that they were of
  Pieces joined_;                // sets, in the order in which they were joined
  std::vector<RegionId> split_;  // regions that fell into cells
};

Accumulator::Accumulator(const Complex& complex, std::span<const Group* const> parts)
    : state_(std::make_unique<State>(complex)) {
  FoldStep first;
  state_->apply(BooleanOp::unite, Dominance::equal, parts, first);
}
Accumulator::~Accumulator() = default;

void Accumulator::apply(BooleanOp op, Dominance dominance, std::span<const Group* const> parts, FoldStep& step) {
  state_->apply(op, dominance, parts, step);
}

Group Accumulator::group() { return state_->group(); }

}  // namespace cnrg
