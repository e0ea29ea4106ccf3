// The removal stage. Notation: A is the operand of the rows (the dominant or left one), B the other.
//
// Membership is a byte of flags per cell (kA, kB, kKept), zeroed only where touched, and the lists of A and B
// are merged in the order of ids, so that every list of the result comes out sorted.
#include "csg/operators/boolean.h"

#include <algorithm>
#include <iterator>

#include "csg/operators/attributes.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/free_cells.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

constexpr std::uint8_t kA = 1, kB = 2, kKept = 4, kFeature = 8;

// Group::region_of in one step, at the cost of the group's cells.
class RegionLookup {
 public:
  RegionLookup(const Complex& complex, const Group& group) : region_(complex.region_count) {
    for (const auto& [cell, region] : group.cells) region_[cell] = region;
  }
  std::uint32_t operator()(RegionId r) const { return region_[r]; }

 private:
  Scratch<RegionId, std::uint32_t> region_;
};

Relation relation_of(std::uint8_t flags, bool in_other) {
  if ((flags & kA) && (flags & kB)) return Relation::common;
  if (flags & kA) return in_other ? Relation::a_in_b : Relation::a_out_b;
  return in_other ? Relation::b_in_a : Relation::b_out_a;
}

// Lists of two groups as one: each cell once, in the order of ids, with the leaves that it came from.
template <class IdT>
class MergedList {
 public:
  MergedList(const std::vector<IdT>& a, const std::vector<LeafSetId>& a_origins, const std::vector<IdT>& b,
             const std::vector<LeafSetId>& b_origins)
      : a_(a), b_(b), a_origins_(a_origins), b_origins_(b_origins) {}
  /// Appends the cells that `keep` keeps, and their origins.
  template <class Keep>
  void filter(Keep keep, LeafSetMap& from_a, LeafSetMap& from_b, LeafSets& sets, std::vector<IdT>& cells,
              std::vector<LeafSetId>& origins) const {
    for (std::size_t i = 0, j = 0; i < a_.size() || j < b_.size();) {
      const bool in_a = i < a_.size() && (j == b_.size() || !(b_[j] < a_[i]));
      const bool in_b = j < b_.size() && (i == a_.size() || !(a_[i] < b_[j]));
      const IdT cell = in_a ? a_[i] : b_[j];
      if (keep(cell)) {
        LeafSetId origin(0);
        if (in_a) origin = from_a(a_origins_[i]);
        if (in_b) origin = sets.unite(origin, from_b(b_origins_[j]));
        cells.push_back(cell);
        origins.push_back(origin);
      }
      i += in_a, j += in_b;
    }
  }

 private:
  const std::vector<IdT>&a_, &b_;
  const std::vector<LeafSetId>&a_origins_, &b_origins_;
};

// One evaluation of A op B.
class Removal {
 public:
  Removal(const Complex& complex, BooleanOp op, bool dominant, const Group& a, const Group& b)
      : complex_(complex),
        op_(op),
        dominant_(dominant),
        a_(a),
        b_(b),
        in_a_(complex, a),
        in_b_(complex, b),
        faces_(complex.face_count()),
        edges_(complex.edge_count()),
        vertices_(complex.points.size()),
        removed_(table_rows().size(), 0) {
    flag(a.faces, faces_, kA);
    flag(b.faces, faces_, kB);
    flag(a.edges, edges_, kA);
    flag(b.edges, edges_, kB);
    flag(a.vertices, vertices_, kA);
    flag(b.vertices, vertices_, kB);
  }

  void run(Group& result) {
    Origins& o = result.origins;
    LeafSetMap from_a(a_.origins.sets, o.sets), from_b(b_.origins.sets, o.sets);
    const auto filter = [&](const auto& a, const auto& origins_a, const auto& b, const auto& origins_b,
                            auto& cells, auto& origins) {
      MergedList(a, origins_a, b, origins_b)
          .filter([&](auto cell) { return keep(cell); }, from_a, from_b, o.sets, cells, origins);
    };
    filter(a_.faces, a_.origins.faces, b_.faces, b_.origins.faces, result.faces, o.faces);
    for (FaceId f : result.faces) keep_closure(f);
    filter(a_.edges, a_.origins.edges, b_.edges, b_.origins.edges, result.edges, o.edges);
    for (EdgeId e : result.edges) {
      for (VertexId v : complex_.edge_ends[e]) vertices_[v] |= kKept;
    }
    filter(a_.vertices, a_.origins.vertices, b_.vertices, b_.origins.vertices, result.vertices, o.vertices);
    result.features = features(result);
    result.cells = detect_regions(complex_, inside(), result.faces);
  }

  std::vector<std::pair<std::string, std::size_t>> removals() const {
    std::vector<std::pair<std::string, std::size_t>> out;
    for (std::size_t i = 0; i < removed_.size(); ++i) {
      if (removed_[i] != 0) out.emplace_back(table_rows()[i].id, removed_[i]);
    }
    return out;
  }

 private:
  template <class IdT>
  static void flag(const std::vector<IdT>& list, Marks<IdT>& marks, std::uint8_t bit) {
    for (IdT id : list) marks[id] |= bit;
  }

  // The region of the group that the cell is not an entity of, at a cell of A or B only.
  template <class IdT>
  Relation relate(IdT cell, std::uint8_t flags) {
    if ((flags & kA) && (flags & kB)) return Relation::common;
    const RegionId r = complex_.some_region(cell);
    return relation_of(flags, ((flags & kA) ? in_b_(r) : in_a_(r)) != 0);
  }

  bool keep(FaceId f) {
    const Relation relation = relate(f, faces_[f]);
    const std::size_t row = table_row(op_, dominant_, 2, relation);
    const auto& [front, back] = complex_.face_regions[f];
    FaceSides sides;
    sides.a[0] = in_a_(front), sides.a[1] = in_a_(back);
    sides.b[0] = in_b_(front), sides.b[1] = in_b_(back);
    if (holds(table_rows()[row].condition, sides)) {
      ++removed_[row];
      return false;
    }
    faces_[f] |= kKept;
    return true;
  }

  void keep_closure(FaceId f) {
    for (LoopId l : complex_.face_loops[f]) {
      for (HalfEdge h : complex_.loop[l]) edges_[h.edge()] |= kKept;
    }
    for (VertexId v : complex_.face_vertices[f]) vertices_[v] |= kKept;
  }

  template <class IdT>
  bool keep_lower(IdT cell, std::uint8_t flags, int dimension) {
    const std::size_t row = table_row(op_, dominant_, dimension, relate(cell, flags));
    if (!removes(table_rows()[row].condition, cell)) return true;
    ++removed_[row];
    return false;
  }
  bool keep(EdgeId e) { return (edges_[e] & kKept) || keep_lower(e, edges_[e], 1); }
  bool keep(VertexId v) { return (vertices_[v] & kKept) || keep_lower(v, vertices_[v], 0); }

  template <class IdT>
  bool removes(Condition condition, IdT cell) {
    switch (condition) {
      case Condition::never: return false;
      case Condition::always: return true;
      case Condition::not_free_a: return !is_free(cell, kA);
      case Condition::not_free_b: return !is_free(cell, kB);
      case Condition::free_in_neither: return !is_free(cell, kA) && !is_free(cell, kB);
      case Condition::inside_region_b: return inside_region_of_b(cell);
      default: break;
    }
    throw InvariantError("tables: a condition of faces was asked of an edge or a vertex");
  }

  bool has(FaceId f, std::uint8_t group) const { return (faces_[f] & group) != 0; }
  bool has(EdgeId e, std::uint8_t group) const { return (edges_[e] & group) != 0; }
  bool has(VertexId v, std::uint8_t group) const { return (vertices_[v] & group) != 0; }
  template <class IdT>
  bool is_free(IdT cell, std::uint8_t group) const {
    return cnrg::is_free(complex_, cell, [&](auto id) { return has(id, group); });
  }

  template <class IdT>
  bool inside_region_of_b(IdT cell) {
    around_.clear();
    complex_.star_regions(cell, around_);
    const std::uint32_t first = in_b_(around_.front());
    bool one = first != 0, all = first != 0;
    for (RegionId r : around_) {
      const std::uint32_t region = in_b_(r);
      one = one && region == first;
      all = all && region != 0;
    }
    return one || (all && only_cut_in_b(cell));
  }

  // Made by the common refinement: no feature of B, nor an end of one.
  bool only_cut_in_b(EdgeId e) const {
    return !std::binary_search(b_.features.edges.begin(), b_.features.edges.end(), e);
  }
  bool only_cut_in_b(VertexId v) const {
    const auto edges = complex_.vertex_edges[v];
    return !std::binary_search(b_.features.vertices.begin(), b_.features.vertices.end(), v) &&
           std::all_of(edges.begin(), edges.end(), [&](EdgeId e) { return only_cut_in_b(e); });
  }

  std::vector<RegionId> inside() const {
    std::vector<RegionId> a, b, out;
    for (const auto& cell : a_.cells) a.push_back(cell.first);
    for (const auto& cell : b_.cells) b.push_back(cell.first);
    const auto to = std::back_inserter(out);
    switch (op_) {
      case BooleanOp::unite: std::set_union(a.begin(), a.end(), b.begin(), b.end(), to); break;
      case BooleanOp::intersect: std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), to); break;
      case BooleanOp::subtract: std::set_difference(a.begin(), a.end(), b.begin(), b.end(), to); break;
    }
    return out;
  }

  // Features of either operand that are still entities. The difference takes those of B only where they bound
  // a kept face that lies inside A: a B that only touches A leaves it as it was.
  Features features(const Group& result) {
    Features out;
    if (op_ != BooleanOp::subtract) {
      out = unite(a_.features, b_.features);
    } else {
      for (FaceId f : result.faces) {
        if ((faces_[f] & (kA | kB)) != kB) continue;
        for (LoopId l : complex_.face_loops[f]) {
          for (HalfEdge h : complex_.loop[l]) {
            edges_[h.edge()] |= kFeature;
            vertices_[complex_.origin(h)] |= kFeature;
          }
        }
        for (VertexId v : complex_.face_vertices[f]) vertices_[v] |= kFeature;
      }
      Features of_b = b_.features;
      std::erase_if(of_b.edges, [&](EdgeId e) { return !(edges_[e] & kFeature); });
      std::erase_if(of_b.vertices, [&](VertexId v) { return !(vertices_[v] & kFeature); });
      out = unite(a_.features, of_b);
    }
    return among_entities(result, out);
  }

  const Complex& complex_;
  BooleanOp op_;
  bool dominant_;
  const Group &a_, &b_;
  RegionLookup in_a_, in_b_;
  Marks<FaceId> faces_;
  Marks<EdgeId> edges_;
  Marks<VertexId> vertices_;
  std::vector<std::size_t> removed_;
  std::vector<RegionId> around_;
};

// The entities of `g` in the closure of `walls`, with its features.
void keep_walls(const Complex& complex, const Group& g, Group& out) {
  Marks<EdgeId> edges(complex.edge_count());
  Marks<VertexId> vertices(complex.points.size());
  for (FaceId f : out.faces) {
    for (LoopId l : complex.face_loops[f]) {
      for (HalfEdge h : complex.loop[l]) {
        edges[h.edge()] = 1;
        vertices[complex.origin(h)] = 1;
      }
    }
    for (VertexId v : complex.face_vertices[f]) vertices[v] = 1;
  }
  LeafSetMap map(g.origins.sets, out.origins.sets);
  const auto pick = [&](const auto& from, const auto& from_origins, const auto& marks, auto& to, auto& origins) {
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (!marks[from[k]]) continue;
      to.push_back(from[k]);
      origins.push_back(map(from_origins[k]));
    }
  };
  pick(g.edges, g.origins.edges, edges, out.edges, out.origins.edges);
  pick(g.vertices, g.origins.vertices, vertices, out.vertices, out.origins.vertices);
  std::size_t k = 0;
  for (FaceId f : out.faces) {
    while (g.faces[k] != f) ++k;
    out.origins.faces.push_back(map(g.origins.faces[k]));
  }
  const auto still = [](const auto& from, const auto& marks, auto& to) {
    for (auto id : from) {
      if (marks[id]) to.push_back(id);
    }
  };
  still(g.features.edges, edges, out.features.edges);
  still(g.features.vertices, vertices, out.features.vertices);
  out.dominance = g.dominance;
}

template <class IdT>
Verdict judge(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
              const Group& result, IdT cell, int dimension, bool bounds_kept) {
  const auto [swapped, dominant] = roles(op, dominance);
  const Group& a = swapped ? right : left;
  const Group& b = swapped ? left : right;
  Verdict out;
  const std::uint8_t flags = (a.has(cell) ? kA : 0) | (b.has(cell) ? kB : 0);
  if (flags == 0) return out;
  const RegionId r = complex.some_region(cell);
  out.entity = true;
  out.swapped = swapped;
  out.relation = relation_of(flags, ((flags & kA) ? b.region_of(r) : a.region_of(r)) != 0);
  out.bounds_kept = bounds_kept;
  out.removed = !result.has(cell);
  out.row = &table_rows()[table_row(op, dominant, dimension, out.relation)];
  return out;
}

}  // namespace

std::vector<std::pair<RegionId, std::uint32_t>> detect_regions(const Complex& complex,
                                                               const std::vector<RegionId>& inside,
                                                               const std::vector<FaceId>& walls) {
  Scratch<RegionId, std::uint32_t> place(complex.region_count);  // 1 + index into `inside`
  Marks<FaceId> wall(complex.face_count());
  for (std::size_t i = 0; i < inside.size(); ++i) place[inside[i]] = static_cast<std::uint32_t>(i + 1);
  for (FaceId f : walls) wall[f] = 1;
  UnionFind sets(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    for (HalfFace h : complex.region_faces[inside[i]]) {
      if (h.side() != 0 || wall[h.face()]) continue;
      if (const auto other = place[complex.region(h.opposite())]) {
        sets.unite(static_cast<std::uint32_t>(i), other - 1);
      }
    }
  }
  std::vector<std::pair<RegionId, std::uint32_t>> out;
  std::vector<std::uint32_t> number(inside.size(), 0);
  std::uint32_t count = 0;
  out.reserve(inside.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    std::uint32_t& n = number[sets.find(static_cast<std::uint32_t>(i))];
    if (n == 0) n = ++count;
    out.emplace_back(inside[i], n);
  }
  return out;
}

Roles roles(BooleanOp op, Dominance dominance) {
  if (op == BooleanOp::subtract) return {false, true};
  return {dominance == Dominance::right, dominance != Dominance::equal};
}

BooleanResult apply(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                    const Group& right) {
  const auto [swapped, dominant] = roles(op, dominance);
  BooleanResult out;
  Removal removal(complex, op, dominant, swapped ? right : left, swapped ? left : right);
  removal.run(out.group);
  out.removals = removal.removals();
  out.group.dominance = std::max(left.dominance, right.dominance);
  if (op == BooleanOp::subtract) {
    combine_attributes(out.group, {&left}, true);
  } else if (dominance == Dominance::equal) {
    out.conflicts = combine_attributes(out.group, {&left, &right}, false);
  } else {
    combine_attributes(out.group, {swapped ? &right : &left, swapped ? &left : &right}, true);
  }
  return out;
}

Group complement(const Complex& complex, const Group& g) {
  Group out;
  Marks<RegionId> held(complex.region_count);
  for (const auto& [cell, region] : g.cells) held[cell] = 1;
  std::vector<RegionId> inside;
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    if (!held[r] && !complex.outside_frame(r)) inside.push_back(r);
  }
  for (FaceId f : g.faces) {
    const auto& [front, back] = complex.face_regions[f];
    if (held[front] != held[back]) out.faces.push_back(f);
  }
  keep_walls(complex, g, out);
  out.cells = detect_regions(complex, inside, out.faces);
  combine_attributes(out, {}, true);
  std::vector<LeafId> leaves;
  for (const RegionAttributes& region : g.regions) {
    leaves.insert(leaves.end(), region.leaves.begin(), region.leaves.end());
  }
  sort_unique(leaves);
  for (RegionAttributes& region : out.regions) region.leaves = leaves;
  return out;
}

Group regularize(const Complex& complex, const Group& g) {
  Group out;
  const RegionLookup in(complex, g);
  for (FaceId f : g.faces) {
    const auto& [front, back] = complex.face_regions[f];
    const auto a = in(front), b = in(back);
    if (a != b) out.faces.push_back(f);
  }
  keep_walls(complex, g, out);
  out.cells = g.cells;
  out.regions = g.regions;
  return out;
}

Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& a, const Group& b,
                const Group& result, FaceId f) {
  return judge(complex, op, dominance, a, b, result, f, 2, false);
}

Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& a, const Group& b,
                const Group& result, EdgeId e) {
  const auto uses = complex.edge_uses[e];
  const bool bounds = std::any_of(uses.begin(), uses.end(), [&](const FaceUse& u) { return result.has(u.face); });
  return judge(complex, op, dominance, a, b, result, e, 1, bounds);
}

Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& a, const Group& b,
                const Group& result, VertexId v) {
  const auto edges = complex.vertex_edges[v];
  const auto faces = complex.vertex_faces[v];
  const auto kept = [&](auto id) { return result.has(id); };
  const bool bounds =
      std::any_of(edges.begin(), edges.end(), kept) || std::any_of(faces.begin(), faces.end(), kept);
  return judge(complex, op, dominance, a, b, result, v, 0, bounds);
}

}  // namespace cnrg
