// Where a row of the tables is decided: `State::decide`.
//
// A Boolean takes the entities of both operands and removes some, faces first, then edges, then vertices. What
// bounds something that stays, stays. Of every other entity the relation of the two operands there (AinB, INTERS,
// ...) names one row, the row has a condition, and the condition is asked of the two operands as they were.
//
// The obvious ways to fold many operands fail. A Boolean per pair reads the value so far in every step: a union of
// n solids costs n^2. A second evaluation for folds, beside that for pairs, is two readings of each condition, and
// these drift apart. So there is one, and a pair is a fold of two: the value so far, *held*, stays where it is, as
// flags on the cells of the complex, and a step walks the *next* operand. That is enough, since rows decide about
// an entity by what lies around it, and outside of next's regions (AoutB, BoutA) unions and differences keep all
// of held. An intersection removes all that is outside: its step has to read held, too, but leaves less of it to
// the step after.
//
//   take_in            marks next, and asks for the entities of held that a row may remove
//   decide             faces, edges, vertices: row, condition
//   RemovedEntities    counts what went, in cells of the refinement of the two operands (pair_refinement.h)
//   HeldRegions        does the operator on regions, which end at the faces that stay
//   commit             makes next's entities held ones; what was removed goes
//
// A and B of the rows are held and next, or next and held where the right operand dominates: `a_` and `b_` say
// which, and what the conditions ask of A and B (see holds_for_face, holds_for_lower) is answered by `Face` and
// `Lower`. No other code knows which is which.
#include "csg/operators/table_engine.h"

#include <array>
#include <optional>

#include "csg/operators/bounds.h"
#include "csg/operators/held_regions.h"
#include "csg/operators/removed_entities.h"
#include "csg/operators/tally.h"

namespace cnrg {
namespace {

using Operands = std::span<const Group* const>;

using IntoUnions = LeafSetMap<LeafSets, LeafUnions>;
using FromUnions = LeafSetMap<LeafUnions, LeafSets>;

// An operand of a step; the value is the flag of its entities.
enum class Who : std::uint8_t { held = kHeld, next = kNext };

}  // namespace

class TableEngine::State {
 public:
  State(const Complex& complex, BooleanOp op, Operands first, const LeafOrder& order, Removed removed,
        bool tallies)
      : complex_(complex),
        op_(op),
        counts_removed_(removed == Removed::counted),
        marks_(complex),
        regions_(complex, op, marks_.faces, order),
        removed_(complex, marks_, sets_) {
    for (const Group* part : first) load(*part);
    regions_.load(first);
    if (tallies) tally_.emplace(complex, marks_, sets_, regions_, first);
  }

  void step(Dominance dominance, Operands next, FoldStep& step) {
    roles_ = roles(op_, dominance);
    a_ = roles_.swapped ? Who::next : Who::held;
    b_ = roles_.swapped ? Who::held : Who::next;
    take_in(next);
    decide<FaceId>(next), decide<EdgeId>(next), decide<VertexId>(next);
    if (counts_removed_) removed_.count(next, step.removed);
    regions_.update(roles_, next, step.conflicts);
    CellSet changed;
    if (tally_) changed = what_changes(next);
    commit(next);
    if (tally_) {
      tally_->update(changed, step.change);
      step.tallied = step.tallied && tally_->known();
    }
    std::vector<AttributeConflict> of_entities;
    at_odds_.take_to(of_entities);
    for (AttributeConflict& conflict : of_entities)
      step.conflicts.emplace_back(RegionId::none(), std::move(conflict));
  }

  bool empty() const { return listed() == 0 && regions_.empty(); }

  Group group() {
    Group out;
    LeafSetMap sets(sets_, out.origins.sets);
    for_each_entity([&](const auto& marks, auto& list, auto& origins) { write(marks, sets, list, origins); },
                    marks_, out, out.origins);
    write_features(marks_.edges, out.edges, out.features.edges);
    write_features(marks_.vertices, out.vertices, out.features.vertices);
    regions_.write(out);
    return out;
  }

 private:
  // --- the operands

  void load(const Group& part) {
    LeafSetMap sets(part.origins.sets, sets_);
    const auto hold = [&](auto& marks, const auto& cells, const auto& origins) {
      marks.listed.insert(marks.listed.end(), cells.begin(), cells.end());
      for (std::size_t i = 0; i < cells.size(); ++i) {
        marks.flags[cells[i]] = kHeld | kListed;
        marks.origin[cells[i]] = sets(origins[i]);
      }
    };
    for_each_entity(hold, marks_, part, part.origins);
    flag_features(part, kHeldFeature);
  }

  void flag_features(const Group& part, std::uint8_t flag) {
    for (const EdgeId e : part.features.edges) marks_.edges.flags[e] |= flag;
    for (const VertexId v : part.features.vertices) marks_.vertices.flags[v] |= flag;
  }

  void take_in(Operands next) {
    const auto flag = [](auto& marks, const auto& cells) {
      for (const auto cell : cells) marks.flags[cell] |= kNext;
    };
    for (const Group* part : next) {
      for_each_entity(flag, marks_, *part);
      flag_features(*part, kNextFeature);
    }
    regions_.take_in(next);
    ask_held();
  }

  // The entities of held that a row may remove: all, if the rows remove what is outside of next; else those in the
  // regions of next. Where held has fewer than there are faces in these, it is cheaper to ask all of them.
  void ask_held() {
    const Relation outside = relation_of(a_ == Who::held, b_ == Who::held, false);
    bool all = !keeps_outside(op_, roles_.dominant, outside);
    if (!all) {
      std::size_t faces = 0;
      for (const RegionId cell : regions_.next_cells()) faces += complex_.region_faces[cell].size();
      all = listed() < faces;
    }
    if (all) {
      const auto ask = [](auto& marks) {
        for (const auto cell : marks.listed) marks.ask(cell);
      };
      for_each_entity(ask, marks_);
    } else {
      for (const RegionId cell : regions_.next_cells()) ask_inside(cell);
    }
  }

  std::size_t listed() const {
    return marks_.faces.listed.size() + marks_.edges.listed.size() + marks_.vertices.listed.size();
  }

  // Entities of held in the closure of a 3-cell of next that are none of next are inside of its region.
  void ask_inside(RegionId cell) {
    const auto ask = [&](auto of) { list_for(marks_, of).ask(of); };
    for (const HalfFace h : complex_.region_faces[cell]) {
      const FaceId f = h.face();
      if (h.side() != 0 || marks_.faces.has(f, kNext)) continue;  // inside: the same region on both sides
      ask(f);
      for_each_bounding(complex_, f, ask);
    }
    for (const EdgeId e : complex_.region_wires[cell]) {
      ask(e);
      for_each_bounding(complex_, e, ask);
    }
    for (const VertexId v : complex_.region_vertices[cell]) ask(v);
  }

  // --- the rows

  template <class IdT>
  void decide(Operands next) {
    EntityMarks<IdT>& marks = list_for(marks_, IdT());
    std::array<std::size_t, kRelations> rows;
    for (std::size_t r = 0; r < kRelations; ++r) {
      rows[r] = table_row(op_, roles_.dominant, dimension_of(IdT()), static_cast<Relation>(r));
    }
    const auto decide_one = [&](IdT cell) {
      const std::size_t row = rows[static_cast<std::size_t>(relation(cell))];
      const Condition condition = table_rows()[row].condition;
      if (condition == Condition::never || bounds_kept(cell) || !holds(condition, cell)) return;
      marks.flags[cell] |= kRemoved;
      if (counts_removed_) removed_.add(cell, row);
    };
    for (const Group* part : next) {
      for (const IdT cell : list_for(*part, IdT())) decide_one(cell);
    }
    for (const IdT cell : marks.asked) decide_one(cell);
  }

  bool bounds_kept(FaceId) const { return false; }
  template <class IdT>
  bool bounds_kept(IdT cell) const {
    return bounds_any(complex_, cell, [&](auto other) { return list_for(marks_, other).kept(other); });
  }

  template <class IdT>
  Relation relation(IdT cell) const {
    const bool of_a = has(a_, cell), of_b = has(b_, cell);
    const bool inside = of_a != of_b && in_region(of_a ? b_ : a_, complex_.some_region(cell));
    return relation_of(of_a, of_b, inside);
  }

  bool holds(Condition condition, FaceId f) { return holds_for_face(condition, Face{*this, f}); }
  template <class IdT>
  bool holds(Condition condition, IdT cell) {
    return holds_for_lower(condition, Lower<IdT>{*this, cell});
  }

  // --- what the conditions ask

  class Face {
   public:
    Face(State& state, FaceId f) : state_(state), sides_(state.complex_.face_regions[f]) {}
    bool in_a(int side) const { return in(state_.a_, side); }
    bool in_b(int side) const { return in(state_.b_, side); }
    int num_reg_a() const { return num_reg(state_.a_); }
    int num_reg_b() const { return num_reg(state_.b_); }

   private:
    bool in(Who who, int side) const { return state_.in_region(who, sides_[static_cast<std::size_t>(side)]); }
    int num_reg(Who who) const {
      const bool front = in(who, 0), back = in(who, 1);
      if (front != back) return 1;
      return !front || state_.one_region(who, sides_[0], sides_[1]) ? 0 : 2;
    }
    State& state_;
    const std::array<RegionId, 2>& sides_;
  };

  template <class IdT>
  class Lower {
   public:
    Lower(State& state, IdT cell) : state_(state), cell_(cell) {}
    bool free_in_a() const { return free_in(state_.a_); }
    bool free_in_b() const { return free_in(state_.b_); }
    bool in_regions_of_b() const {
      return all_around([&](RegionId r) { return state_.in_region(state_.b_, r); });
    }
    bool in_one_region_of_b() const {
      const RegionId first = state_.complex_.some_region(cell_);
      return in_regions_of_b() && all_around([&](RegionId r) { return state_.one_region(state_.b_, first, r); });
    }
    bool only_cut_in_b() const { return state_.only_cut(state_.b_, cell_); }

   private:
    bool free_in(Who who) const {
      return state_.has(who, cell_) &&
             !bounds_any(state_.complex_, cell_, [&](auto other) { return state_.has(who, other); });
    }
    template <class F>
    bool all_around(F f) const {
      std::vector<RegionId>& around = state_.around_;
      state_.complex_.star_regions(cell_, around);
      return std::all_of(around.begin(), around.end(), f);
    }
    State& state_;
    IdT cell_;
  };

  template <class IdT>
  bool has(Who who, IdT cell) const {
    return list_for(marks_, cell).has(cell, static_cast<std::uint8_t>(who));
  }
  bool in_region(Who who, RegionId cell) const {
    return who == Who::held ? regions_.in_held(cell) : regions_.in_next(cell);
  }
  bool one_region(Who who, RegionId a, RegionId b) {
    return who == Who::held ? regions_.same_in_held(a, b) : regions_.same_in_next(a, b);
  }
  bool only_cut(Who who, EdgeId e) const { return !marks_.edges.has(e, feature(who)); }
  bool only_cut(Who who, VertexId v) const {
    const auto edges = complex_.vertex_edges[v];
    return !marks_.vertices.has(v, feature(who)) &&
           std::all_of(edges.begin(), edges.end(), [&](EdgeId e) { return only_cut(who, e); });
  }
  static std::uint8_t feature(Who who) { return who == Who::held ? kHeldFeature : kNextFeature; }

  // --- the end of a step

  // Entities that held loses or that are of next and stay, and the 3-cells that this step was about.
  CellSet what_changes(Operands next) {
    CellSet out;
    const auto list_next = [](const auto& marks, const auto& entities, auto& cells) {
      for (const auto cell : entities) {
        if (marks.has(cell, kHeld) || marks.kept(cell)) cells.push_back(cell);
      }
    };
    const auto list_removed = [](const auto& marks, auto& cells) {
      for (const auto cell : marks.asked) {
        if (marks.has(cell, kRemoved)) cells.push_back(cell);
      }
    };
    for (const Group* part : next) for_each_entity(list_next, marks_, *part, out);
    for_each_entity(list_removed, marks_, out);
    out.regions = regions_.next_cells();
    const std::vector<RegionId>& gone = regions_.outside_next();
    out.regions.insert(out.regions.end(), gone.begin(), gone.end());
    return out;
  }

  void commit(Operands next) {
    if (op_ == BooleanOp::subtract) mark_borders(next);
    for (const Group* part : next) {
      LeafSetMap sets(part->origins.sets, sets_);
      for_each_entity([&](auto&... of) { commit(of..., sets); }, marks_, *part, part->origins);
    }
    for_each_entity([&](auto& marks) { commit_asked(marks); }, marks_);
  }

  // A difference takes features of next only where they bound a face that held does not have and that stays: such
  // a face lies inside of held. A next that only touches held leaves it as it was.
  void mark_borders(Operands next) {
    for (const Group* part : next) {
      for (const FaceId f : part->faces) {
        if (marks_.faces.has(f, kHeld | kRemoved)) continue;
        for_each_bounding(complex_, f, [&](auto cell) { list_for(marks_, cell).flags[cell] |= kBorder; });
      }
    }
  }

  template <class IdT>
  void commit(EntityMarks<IdT>& marks, const std::vector<IdT>& cells, const std::vector<LeafSetId>& origins,
              IntoUnions& sets) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      std::uint8_t& flags = marks.flags[cells[i]];
      if (flags & kRemoved) {
        flags &= kListed;
        continue;
      }
      LeafSetId& origin = marks.origin[cells[i]];
      origin = (flags & kHeld) ? united(cells[i], origin, sets(origins[i])) : sets(origins[i]);
      if (!(flags & kListed)) marks.listed.push_back(cells[i]);
      const bool from_next = (flags & kNextFeature) && (op_ != BooleanOp::subtract || (flags & kBorder));
      flags = kHeld | kListed | (from_next || (flags & kHeldFeature) ? kHeldFeature : 0);
    }
  }

  // The origin of a cell that both have. A difference says of a cell of held what held says.
  template <class IdT>
  LeafSetId united(IdT cell, LeafSetId held, LeafSetId next) {
    if (sets_.said(next) == nullptr) return sets_.unite(held, next);
    if (op_ == BooleanOp::subtract) return sets_.unite(held, sets_.intern(sets_[next]));
    if (roles_.dominant) return sets_.unite(held, next, roles_.swapped ? Dominance::right : Dominance::left);
    at_odds_.see(cell, sets_.said(held), sets_.said(next));
    return sets_.unite(held, next);
  }

  template <class IdT>
  void commit_asked(EntityMarks<IdT>& marks) const {
    for (const IdT cell : marks.asked) {
      std::uint8_t& flags = marks.flags[cell];
      flags &= (flags & kRemoved) ? kListed : static_cast<std::uint8_t>(~kAsked);
    }
    marks.asked.clear();
    if (op_ != BooleanOp::intersect) return;
    // Few are left: the next step is to read these alone.
    std::erase_if(marks.listed, [&](IdT cell) {
      if (marks.has(cell, kHeld)) return false;
      marks.flags[cell] = 0;
      return true;
    });
  }

  // --- the result

  template <class IdT>
  static void write(const EntityMarks<IdT>& marks, FromUnions& sets, std::vector<IdT>& list,
                    std::vector<LeafSetId>& origins) {
    list.reserve(marks.listed.size());
    for (const IdT cell : marks.listed) {
      if (marks.has(cell, kHeld)) list.push_back(cell);
    }
    merge_runs(list);
    origins.reserve(list.size());
    for (const IdT cell : list) origins.push_back(sets(marks.origin[cell]));
  }

  template <class IdT>
  static void write_features(const EntityMarks<IdT>& marks, const std::vector<IdT>& list, std::vector<IdT>& out) {
    for (const IdT cell : list) {
      if (marks.has(cell, kHeldFeature)) out.push_back(cell);
    }
  }

  const Complex& complex_;
  const BooleanOp op_;
  const bool counts_removed_;
  OfEntities<EntityMarks> marks_;
  HeldRegions regions_;
  LeafUnions sets_;  // of the origins of held

  // The step.
  Roles roles_{};
  Who a_ = Who::held, b_ = Who::next;  // A and B of the rows
  RemovedEntities removed_;
  std::vector<RegionId> around_;
  AtOdds at_odds_;

  std::optional<Tally> tally_;  // keeps references to the marks above
};

TableEngine::TableEngine(const Complex& complex, BooleanOp op, std::span<const Group* const> parts,
                         const LeafOrder& order, Removed removed, bool tallies)
    : state_(std::make_unique<State>(complex, op, parts, order, removed, tallies)) {}
TableEngine::~TableEngine() = default;

void TableEngine::step(Dominance dominance, std::span<const Group* const> parts, FoldStep& step) {
  state_->step(dominance, parts, step);
}
bool TableEngine::empty() const { return state_->empty(); }
Group TableEngine::group() { return state_->group(); }

}  // namespace cnrg
