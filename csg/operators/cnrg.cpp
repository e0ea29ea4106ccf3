// An operator on one value or two is one of three passes over sorted lists: an overlay of two selections (a cell
// goes to the pair of its components), a restriction of one selection to a set with one component more, or,
// component by component, a list of memberships. Then components that have cells are numbered. Many operands are
// not overlaid pair by pair: `aggregate` and `sum` collect atoms (atoms.h), `subtract` marks what it takes away.
#include "csg/operators/cnrg.h"

#include <algorithm>
#include <map>

#include "csg/operators/atoms.h"
#include "csg/operators/component_attributes.h"
#include "csg/operators/component_lists.h"
#include "kernel/base/error.h"
#include "kernel/base/leaf_words.h"
#include "kernel/selection/measure.h"
#include "kernel/selection/scratch.h"

namespace cnrg {
namespace {

using Pair = std::pair<Component, Component>;  // components of X and of Y; 0: none

int dimension(const CellSet& set) {
  if (!set.regions.empty()) return 3;
  if (!set.faces.empty()) return 2;
  if (!set.edges.empty()) return 1;
  return set.vertices.empty() ? -1 : 0;
}

std::string text_of(const RationalPoint& p) {
  return "(" + to_decimal(p[0]) + ", " + to_decimal(p[1]) + ", " + to_decimal(p[2]) + ")";
}

// How many cells, and where one of them is; of regions the volume, and the leaves that hold one.
LeafWords words_of(const Complex& complex, const CellSet& set) {
  const std::string count = std::to_string(set.size()) + (set.size() == 1 ? " cell" : " cells");
  if (!set.regions.empty()) {
    const std::optional<Rational> size = volume(complex, set.regions);
    const FaceId wall = complex.region_faces[set.regions[0]].front().face();
    LeafWords words = count + " of the volume " + (size ? to_decimal(*size) : "infinity") +
                      ", among them the region at the face near " +
                      text_of(interior_point(complex, wall).rational()) + ", inside ";
    std::size_t others = complex.labels(set.regions[0]).size();
    for (const Label& label : complex.labels(set.regions[0]))
      words = words + LeafPlace{label.leaf.value()} + (--others == 0 ? "" : others == 1 ? " and " : ", ");
    return words;
  }
  const auto inside = [&](auto cell) { return text_of(interior_point(complex, cell).rational()); };
  if (!set.faces.empty()) return count + ", among them the face at " + inside(set.faces[0]);
  if (!set.edges.empty()) return count + ", among them the edge at " + inside(set.edges[0]);
  return count + ", among them the vertex at " + text_of(complex.points.rational(set.vertices[0]));
}

// Numbers keys of components in their order. Neighbouring cells mostly have one key: the last one is remembered.
template <class Key>
class Numbering {
 public:
  void see(const Key& key) {
    if (last_ == numbers_.end() || last_->first != key) last_ = numbers_.try_emplace(key, 0).first;
  }
  void number() {
    Component next = 0;
    for (auto& [key, number] : numbers_) number = ++next;
  }
  Component operator[](const Key& key) {
    if (last_ == numbers_.end() || last_->first != key) last_ = numbers_.find(key);
    return last_->second;
  }
  const std::map<Key, Component>& all() const { return numbers_; }

 private:
  std::map<Key, Component> numbers_;
  typename std::map<Key, Component>::iterator last_ = numbers_.end();
};

// --- overlays of two selections

/// Order of the pairs in a result: those of X alone, of both, of Y alone.
struct PairKey {
  int kind;  // 0, 1, 2
  Pair pair;
  friend auto operator<=>(const PairKey&, const PairKey&) = default;
};
PairKey pair_key(Pair pair) { return {pair.second == 0 ? 0 : pair.first != 0 ? 1 : 2, pair}; }

class Overlay {
 public:
  Overlay(const Components& x, const Components& y, bool x_alone, bool both, bool y_alone)
      : x_(x),
        y_(y),
        wanted_{x_alone, both, y_alone},
        from_x_(x.origins.sets, out_.value.origins.sets),
        from_y_(y.origins.sets, out_.value.origins.sets) {}

  ComponentsResult run(std::optional<Dominance> dominance) {
    stated_ = dominance;
    Selection& s = out_.value.selection;
    for_each_dimension([&](auto&... of) { overlay(of...); }, x_.selection, x_.origins, y_.selection, y_.origins,
                       pairs_, out_.value.origins);
    numbering_.number();
    for_each_dimension([&](const auto& pairs, auto& list) { assign(pairs, list); }, pairs_, s);
    attributes(dominance);
    at_odds_.take_to(out_.conflicts);
    out_.value.features = active(s, unite(x_.features, y_.features));
    collect_leaves(out_.value);
    return std::move(out_);
  }

 private:
  template <class IdT>
  using Pairs = std::vector<std::pair<IdT, Pair>>;

  template <class IdT>
  void overlay(const std::vector<std::pair<IdT, Component>>& x, const std::vector<LeafSetId>& x_origins,
               const std::vector<std::pair<IdT, Component>>& y, const std::vector<LeafSetId>& y_origins,
               Pairs<IdT>& pairs, std::vector<LeafSetId>& origins) {
    for (std::size_t i = 0, j = 0; i < x.size() || j < y.size();) {
      const bool in_x = i < x.size() && (j == y.size() || !(y[j].first < x[i].first));
      const bool in_y = j < y.size() && (i == x.size() || !(x[i].first < y[j].first));
      const IdT id = in_x ? x[i].first : y[j].first;
      const Pair pair(in_x ? x[i].second : 0, in_y ? y[j].second : 0);
      const PairKey key = pair_key(pair);
      if (wanted_[key.kind]) {
        LeafSetId origin(0);
        if (in_x) origin = from_x_(x_origins[i]);
        if (in_x && in_y) origin = united(id, pair, origin, from_y_(y_origins[j]));
        else if (in_y) origin = from_y_(y_origins[j]);
        pairs.emplace_back(id, pair);
        origins.push_back(origin);
        numbering_.see(key);
      }
      i += in_x, j += in_y;
    }
  }

  template <class IdT>
  LeafSetId united(IdT cell, Pair pair, LeafSetId of_x, LeafSetId of_y) {
    LeafSets& sets = out_.value.origins.sets;
    if (sets.said(of_x) == nullptr || sets.said(of_y) == nullptr) return sets.unite(of_x, of_y);
    const Dominance decides = dominant(x_.attributes[pair.first - 1], y_.attributes[pair.second - 1], stated_);
    if (decides == Dominance::equal) at_odds_.see(cell, sets.said(of_x), sets.said(of_y));
    return sets.unite(of_x, of_y, decides);
  }

  template <class IdT>
  void assign(const Pairs<IdT>& pairs, std::vector<std::pair<IdT, Component>>& list) {
    list.reserve(pairs.size());
    for (const auto& [id, pair] : pairs) list.emplace_back(id, numbering_[pair_key(pair)]);
  }

  // Two materials meet where the common part is as large as one of the components: a wall where two solids touch
  // is no conflict.
  void attributes(std::optional<Dominance> dominance) {
    const std::vector<int> in_x = dimensions(x_), in_y = dimensions(y_);
    for (const auto& [key, number] : numbering_.all()) {
      const auto [i, j] = key.pair;
      if (j == 0) {
        out_.value.attributes.push_back(x_.attributes[i - 1]);
      } else if (i == 0) {
        out_.value.attributes.push_back(y_.attributes[j - 1]);
      } else {
        Combined c = combine(x_.attributes[i - 1], y_.attributes[j - 1], dominance);
        CellSet cells;
        if (!c.yielded.empty()) cells = support(out_.value.selection, number);
        if (!cells.empty() && dimension(cells) >= std::min(in_x[i - 1], in_y[j - 1])) {
          for (const Yielded& other : c.yielded) out_.conflicts.push_back(conflict(c.attributes, other, cells));
        }
        out_.value.attributes.push_back(std::move(c.attributes));
      }
    }
  }

  const Components &x_, &y_;
  std::array<bool, 3> wanted_;
  std::optional<Dominance> stated_;
  AtOdds at_odds_;
  ComponentsResult out_;
  LeafSetMap<LeafSets, LeafSets> from_x_, from_y_;
  Numbering<PairKey> numbering_;
  OfCells<Pairs> pairs_;
};

// --- one selection, restricted

// One component made of all of `x`: strongest attributes first, conflicts with the first of them.
ComponentAttributes strongest(const Components& x, std::vector<AttributeConflict>& conflicts) {
  ComponentAttributes out;
  if (x.attributes.empty()) return out;
  out.dominance = largest_dominance(x);
  std::optional<Rational> level;  // of the materials among the strongest
  for (const ComponentAttributes& a : x.attributes) {
    if (a.dominance == out.dominance) level = std::max(level, std::optional(a.material.dominance()));
  }
  for (std::size_t i = 0; i < x.attributes.size(); ++i) {
    const ComponentAttributes& a = x.attributes[i];
    if (a.dominance != out.dominance || a.material.dominance() != level) continue;
    out.name = join_names(out.name, a.name);
    std::vector<Yielded> yielded;
    fill_in(out, a, yielded);
    for (const Yielded& other : yielded) {
      conflicts.push_back(conflict(out, other, support(x.selection, static_cast<Component>(i + 1))));
    }
  }
  return out;
}

// Drops components without cells and numbers the others from 1.
void renumber(Components& x) {
  std::vector<Component> number(x.attributes.size() + 1, 0);
  const auto see = [&](const auto& list) {
    for (const auto& entry : list) number[entry.second] = 1;
  };
  for_each_dimension(see, x.selection);
  std::vector<ComponentAttributes> kept;
  for (std::size_t c = 1; c < number.size(); ++c) {
    if (number[c] == 0) continue;
    kept.push_back(std::move(x.attributes[c - 1]));
    number[c] = static_cast<Component>(kept.size());
  }
  x.attributes = std::move(kept);
  const auto renumber_list = [&](auto& list) {
    for (auto& entry : list) entry.second = number[entry.second];
  };
  for_each_dimension(renumber_list, x.selection);
}

// Origins of cells that X lacks: those of the cells of X next to them, and the leaves among `below` that have a
// boundary there.
class NearbyOrigins {
 public:
  NearbyOrigins(const Complex& complex, const Components& x, std::span<const LeafId> below, LeafSets& sets)
      : complex_(complex), x_(x), below_(below), sets_(sets), map_(x.origins.sets, sets) {}

  LeafSetId of(RegionId) { return LeafSetId(0); }
  template <class IdT>
  LeafSetId of(IdT cell) {
    out_ = LeafSetId(0);
    if constexpr (std::is_same_v<IdT, VertexId>) {
      for (const EdgeId e : complex_.vertex_edges[cell]) add(x_.selection.edges, x_.origins.edges, e);
    }
    if constexpr (!std::is_same_v<IdT, FaceId>) {
      complex_.star_faces(cell, faces_);
      for (const FaceId f : faces_) add(x_.selection.faces, x_.origins.faces, f);
    }
    complex_.star_regions(cell, regions_);
    for (const RegionId r : regions_) add(x_.selection.regions, x_.origins.regions, r);
    for (const LeafCell& at : leaf_cells(complex_, cell, below_)) {
      if (at.dimension < 3) out_ = sets_.unite(out_, sets_.intern(at.leaf));
    }
    return out_;
  }

 private:
  template <class List, class IdT>
  void add(const List& list, const std::vector<LeafSetId>& origins, IdT id) {
    const std::size_t k = place_in(list, id);
    if (k != list.size()) out_ = sets_.unite(out_, map_(origins[k]));
  }

  const Complex& complex_;
  const Components& x_;
  std::span<const LeafId> below_;
  LeafSets& sets_;
  LeafSetMap<LeafSets, LeafSets> map_;
  LeafSetId out_;
  std::vector<FaceId> faces_;
  std::vector<RegionId> regions_;
};

// Cells of X keep theirs, others take those of the cells of X next to them.
void inherit_origins(const Complex& complex, const Components& x, std::span<const LeafId> below,
                     Components& value) {
  LeafSetMap map(x.origins.sets, value.origins.sets);
  NearbyOrigins nearby(complex, x, below, value.origins.sets);
  const auto inherit = [&](const auto& list, auto& origins, const auto& from, const auto& from_origins) {
    std::size_t k = 0;
    for (const auto& [id, component] : list) {
      while (k < from.size() && from[k].first < id) ++k;
      const bool own = k < from.size() && from[k].first == id;
      origins.push_back(own ? map(from_origins[k]) : nearby.of(id));
    }
  };
  for_each_dimension(inherit, value.selection, value.origins, x.selection, x.origins);
}

// The union of all origins.
std::vector<LeafId> all_leaves(const Components& x) {
  std::vector<LeafId> out;
  for (const ComponentAttributes& a : x.attributes) out.insert(out.end(), a.leaves.begin(), a.leaves.end());
  sort_unique(out);
  return out;
}

}  // namespace

const char* name(Topological op) {
  switch (op) {
    case Topological::interior: return "interior";
    case Topological::closure: return "closure";
    case Topological::boundary: return "boundary";
    default: return "regularize";
  }
}

CellSet topological_operation(const Complex& complex, Topological op, const CellSet& set) {
  switch (op) {
    case Topological::interior: return interior(complex, set);
    case Topological::closure: return closure(complex, set);
    case Topological::boundary: return boundary(complex, set);
    default: return closure(complex, interior(complex, set));
  }
}

namespace {

// Names the first operand that overlaps the last one.
[[noreturn]] void refuse_overlap(const Complex& complex, std::span<const Components* const> operands,
                                 std::span<const std::string> names) {
  const std::size_t k = operands.size() - 1;
  for (std::size_t i = 0; i < k; ++i) {
    const CellSet overlap = intersect(support(operands[i]->selection), support(operands[k]->selection));
    if (overlap.empty()) continue;
    if (names[i] == names[k]) {
      throw InputError("aggregate: the operand `" + names[i] + "` is listed twice; list it once");
    }
    throw LeafError("aggregate: the operands `" + names[i] + "` and `" + names[k] + "` overlap in " +
                    words_of(complex, overlap) + "; use `sum`, or take one from the other with `subtract`");
  }
  throw InvariantError("aggregate: an overlap with no operand");
}

}  // namespace

ComponentsResult aggregate(const Complex& complex, std::span<const Components* const> operands,
                           std::span<const std::string> names) {
  require(!operands.empty() && names.size() == operands.size(), "aggregate: operands without names");
  if (operands.size() == 1) return {*operands[0], {}};
  Atoms atoms(complex);
  for (std::size_t k = 0; k < operands.size(); ++k) {
    if (atoms.meet(*operands[k])) refuse_overlap(complex, operands.first(k + 1), names);
    atoms.add(*operands[k], {});
  }
  return atoms.result();
}

ComponentsResult sum(const Complex& complex, std::span<const Components* const> operands,
                     std::optional<Dominance> dominance) {
  Atoms atoms(complex);
  for (const Components* operand : operands) atoms.add(*operand, dominance);
  return atoms.result();
}

ComponentsResult subtract(const Complex& complex, std::span<const Components* const> operands) {
  require(!operands.empty(), "subtract: no operands");
  const Components& x = *operands[0];
  OfCells<Marks> taken(complex);
  const auto mark = [](const auto& list, auto& marks) {
    for (const auto& entry : list) marks[entry.first] = 1;
  };
  for (const Components* y : operands.subspan(1)) for_each_dimension(mark, y->selection, taken);
  ComponentsResult out;
  Components& value = out.value;
  LeafSetMap sets(x.origins.sets, value.origins.sets);
  const auto keep = [&](const auto& from, const auto& origins, const auto& marks, auto& to, auto& to_origins) {
    for (std::size_t k = 0; k < from.size(); ++k) {
      if (marks[from[k].first]) continue;
      to.push_back(from[k]);
      to_origins.push_back(sets(origins[k]));
    }
  };
  for_each_dimension(keep, x.selection, x.origins, std::as_const(taken), value.selection, value.origins);
  value.attributes = x.attributes;
  value.features = active(value.selection, x.features);
  renumber(value);
  collect_leaves(value);
  return out;
}

ComponentsResult unify(const Complex&, const Components& x) {
  ComponentsResult out;
  out.value = x;
  out.value.attributes.clear();
  if (!x.attributes.empty()) {
    out.value.attributes.push_back(strongest(x, out.conflicts));
    out.value.attributes[0].leaves = all_leaves(x);
  }
  const auto unite_list = [](auto& list) {
    for (auto& entry : list) entry.second = 1;
  };
  for_each_dimension(unite_list, out.value.selection);
  return out;
}

ComponentsResult sum(const Complex&, const Components& x, const Components& y,
                     std::optional<Dominance> dominance) {
  return Overlay(x, y, true, true, true).run(dominance);
}

ComponentsResult product(const Complex&, const Components& x, const Components& y,
                         std::optional<Dominance> dominance) {
  return Overlay(x, y, false, true, false).run(dominance);
}

ComponentsResult subtract(const Complex&, const Components& x, const Components& y) {
  return Overlay(x, y, true, false, false).run({});
}

ComponentsResult complement(const Complex& complex, const Components& x) {
  ComponentsResult out;
  const CellSet rest = subtract(all_cells(complex), support(x.selection));
  if (rest.empty()) return out;
  Components& value = out.value;
  value.selection = add_component({}, rest, 1);
  value.attributes.emplace_back();
  value.attributes[0].leaves = all_leaves(x);
  value.attributes[0].dominance = largest_dominance(x);
  const LeafSetId origin = value.origins.sets.intern(value.attributes[0].leaves);
  for_each_dimension([&](auto& origins, const auto& cells) { origins.assign(cells.size(), origin); },
                     value.origins, rest);
  return out;
}

ComponentsResult topological_operation(const Complex& complex, Topological op, const Components& x,
                                       std::span<const LeafId> below) {
  const CellSet have = support(x.selection);
  const CellSet want = topological_operation(complex, op, have);
  const auto extra = static_cast<Component>(x.attributes.size() + 1);
  ComponentsResult out;
  Components& value = out.value;
  value.selection = add_component(restrict_to(x.selection, want), subtract(want, have), extra);
  value.attributes = x.attributes;
  value.attributes.emplace_back();
  value.attributes.back().name = Name(std::vector{NamePart{name(op), 0, NameOrigin::operation}});
  inherit_origins(complex, x, below, value);
  value.features = active(value.selection, x.features);
  value.attributes.back().dominance = largest_dominance(x);
  renumber(value);
  collect_leaves(value);
  return out;
}

// Atoms of several components are boundaries that they share: no conflict of materials.
ComponentsResult topological_operation_of_each(const Complex& complex, Topological op, const Components& x,
                                               std::span<const LeafId> below) {
  Memberships memberships;
  const std::vector<CellSet> own = supports(x);
  for (std::size_t i = 0; i < own.size(); ++i) {
    memberships.add(topological_operation(complex, op, own[i]), static_cast<Component>(i + 1));
  }
  ComponentsResult out;
  Components& value = out.value;
  std::vector<std::vector<Component>> atoms = memberships.atoms(value.selection);
  inherit_origins(complex, x, below, value);
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    ComponentAttributes attributes = x.attributes[atoms[a][0] - 1];
    for (std::size_t k = 1; k < atoms[a].size(); ++k) {
      Combined c = combine(attributes, x.attributes[atoms[a][k] - 1], {});
      attributes = std::move(c.attributes);
    }
    value.attributes.push_back(std::move(attributes));
  }
  value.features = active(value.selection, x.features);
  collect_leaves(value);
  return out;
}

}  // namespace cnrg
