// The tables of the group Booleans as data (csg/SEMANTICS.md#the-tables; pereira2012 3, Fig. 3).
//
// Fig. 3 is an image whose cells the text does not carry: the rows are our reading, derived from the paper's
// text, from point-set identities and from Fig. 10. A row says when an entity is removed. A is the dominant
// operand, or the left one when both are equal; for the difference A is the left one always.
//
// The rows are in tables.cpp, and csg/SEMANTICS.md#the-tables shows them as the tables of the paper.
//
// A cell inside of a wall between two regions of B lies in none of them; the table keeps it. That is meant for
// features of B (a border between two leaf faces, a wire on the wall). Where only the common refinement cut the
// wall, the cell goes with it, or the result would depend on what other leaves of the tree happen to cross there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "csg/operators/dominance.h"

namespace cnrg {

enum class BooleanOp : std::uint8_t { unite, intersect, subtract };

/// Where an entity of one group lies with respect to the other one (pereira2012 3).
enum class Relation : std::uint8_t {
  a_in_b,   ///< AinB: of A only, inside one region of B
  b_in_a,   ///< BinA
  common,   ///< INTERS: of both
  a_out_b,  ///< AoutB: of A only, outside all regions of B
  b_out_a,  ///< BoutA
};
inline constexpr std::size_t kRelations = 5;
/// `AinB`, `BinA`, `INTERS`, `AoutB`, `BoutA`.
const char* name(Relation relation);
/// `union`, `intersection`, `difference`.
const char* name(BooleanOp op);

/// How A stands to B in a row.
enum class Standing : std::uint8_t { dominant, equal, any };

/// When a row removes.
enum class Condition : std::uint8_t {
  never,
  always,
  one_region_a,         ///< face: numRegA = 1
  one_region_b,         ///< face: numRegB = 1
  opposite_regions,     ///< face: numRegA = numRegB = 1, the regions on opposite sides
  parts_or_hangs_in_b,  ///< face: numRegB = 2, or numRegB = 0 inside a region of B
  no_new_region,        ///< face: numRegB != 1
  no_side_survives,     ///< face: no side is in A and out of B's regions, or numRegA = numRegB = 0
  not_free_a,           ///< edge, vertex: it bounds something of A
  not_free_b,           ///< edge, vertex: it bounds something of B
  free_in_neither,      ///< edge, vertex: not free in A and not free in B
  inside_region_b,      ///< edge, vertex: all around it is one region of B; also a mere cut of a wall inside of B
};
/// The condition in the words of csg/SEMANTICS.md#the-tables.
const char* words(Condition condition);
/// Throws InvariantError: a condition of faces was asked of a lower cell, or the other way round.
[[noreturn]] void wrong_dimension();

struct TableRow {
  const char* id;  ///< such as `union.face.AinB.equal`
  BooleanOp op;
  Standing standing;
  std::uint8_t dimension;
  Relation relation;
  Condition condition;
};

inline constexpr std::size_t kTableRows = 75;
/// All rows: 60 of union and intersection, 15 of difference.
std::span<const TableRow> table_rows();
/// The number of the row in `table_rows()` for an entity of a dimension up to 2.
std::size_t table_row(BooleanOp op, bool dominant, int dimension, Relation relation);

/// Which operand is A in the rows, and whether it is dominant there.
struct Roles {
  bool swapped;   ///< A is the right operand
  bool dominant;  ///< the rows of A > B, and those of the difference
};
Roles roles(BooleanOp op, Dominance dominance);

/// Where an entity of A, of B or of both lies; `inside`: in a region of the operand that it is not of.
constexpr Relation relation_of(bool of_a, bool of_b, bool inside) {
  if (of_a && of_b) return Relation::common;
  if (of_a) return inside ? Relation::a_in_b : Relation::a_out_b;
  return inside ? Relation::b_in_a : Relation::b_out_a;
}

/// What the rows say of all entities outside of the other operand (AoutB or BoutA): kept, or removed.
bool keeps_outside(BooleanOp op, bool dominant, Relation relation);

/// Does the condition of a row hold for a face? It answers for A, and in the same way for B:
///   in_a(side)   true if the 3-cell in front (0) or behind it (1) is in a region of A
///   num_reg_a()  numRegA: 0 when both sides are of one region of A or of none, else how many regions meet there
template <class Face>
bool holds_for_face(Condition condition, const Face& face) {
  switch (condition) {
    case Condition::never: return false;
    case Condition::always: return true;
    case Condition::one_region_a: return face.num_reg_a() == 1;
    case Condition::one_region_b: return face.num_reg_b() == 1;
    case Condition::opposite_regions:
      return face.num_reg_a() == 1 && face.num_reg_b() == 1 && face.in_a(0) != face.in_b(0);
    case Condition::parts_or_hangs_in_b: {
      const int regions = face.num_reg_b();
      return regions == 2 || (regions == 0 && face.in_b(0));
    }
    case Condition::no_new_region: return face.num_reg_b() != 1;
    case Condition::no_side_survives: {
      const bool survives = (face.in_a(0) && !face.in_b(0)) || (face.in_a(1) && !face.in_b(1));
      return !survives || (face.num_reg_b() == 0 && face.num_reg_a() == 0);
    }
    default: wrong_dimension();
  }
}

/// Does it hold for an edge or a vertex? It answers:
///   free_in_a(), free_in_b()  true if it is of that operand and bounds nothing of it
///   in_one_region_of_b()      true if all 3-cells around it are of one region of B
///   in_regions_of_b()         true if all of them are of some region of B
///   only_cut_in_b()           true if it is no feature of B, nor an end of one: the refinement has made it
template <class Lower>
bool holds_for_lower(Condition condition, const Lower& cell) {
  switch (condition) {
    case Condition::never: return false;
    case Condition::always: return true;
    case Condition::not_free_a: return !cell.free_in_a();
    case Condition::not_free_b: return !cell.free_in_b();
    case Condition::free_in_neither: return !cell.free_in_a() && !cell.free_in_b();
    case Condition::inside_region_b:
      return cell.in_one_region_of_b() || (cell.in_regions_of_b() && cell.only_cut_in_b());
    default: wrong_dimension();
  }
}

/// Whether steps count the cells that rows of the tables remove; that may cost more than the steps.
enum class Removed : std::uint8_t { counted, uncounted };

/// How many cells (pair_refinement.h) the rows removed: (row, count), in the order in which rows first removed.
class Removals {
 public:
  void add(std::size_t row, std::size_t count);
  void add(const Removals& more);
  std::size_t of(std::size_t row) const;
  std::size_t total() const;
  bool empty() const { return counts_.empty(); }
  auto begin() const { return counts_.begin(); }
  auto end() const { return counts_.end(); }
  friend bool operator==(const Removals&, const Removals&) = default;

 private:
  std::vector<std::pair<std::size_t, std::size_t>> counts_;  // none is zero
};

/// The tables in Markdown, with a head that says that they are our reading of Fig. 3.
std::string tables_markdown();

}  // namespace cnrg
