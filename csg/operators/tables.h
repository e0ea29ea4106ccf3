// The tables of the group Booleans as data (csg/SEMANTICS.md#the-tables; pereira2012 3, Fig. 3).
//
// Fig. 3 is an image whose cells the text does not carry: the rows are our reading, derived from the paper's
// text, from point-set identities and from Fig. 10. A row says when an entity is removed. A is the dominant
// operand, or the left one when both are equal; for the difference A is the left one always.
//
//   faces                  | A > B                                        | A = B
//   union         AinB     | never                                        | numRegA = 1
//                 BinA     | always                                       | numRegB = 1
//                 INTERS   | never                                        | numRegA = numRegB = 1 and nA != nB
//                 out      | never                                        | never
//   intersection  BinA     | numRegB = 2, or numRegB = 0 and insideB      | never
//                 AinB, INTERS | never                                    | never
//                 out      | always                                       | always
//   difference    AinB, BoutA always; AoutB never; BinA numRegB != 1;
//                 INTERS no side is in A and out of B's regions, or numRegA = numRegB = 0
//
//   edges, vertices (that bound no kept face or edge)
//   union         AinB     | never                                        | not free in A
//                 BinA     | always                                       | not free in B
//                 INTERS   | never                                        | free in neither
//                 out      | never                                        | never
//   intersection  BinA     | inside one region of B (see below)           | never
//                 AinB, INTERS | never                                    | never
//                 out      | always                                       | always
//   difference    AoutB never; all others always
//
// A cell inside of a wall between two regions of B lies in none of them; the table keeps it. That is meant for
// features of B (a border between two leaf faces, a wire on the wall). Where only the common refinement cut the
// wall, the cell goes with it, or the result would depend on what other leaves of the tree happen to cross there.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace cnrg {

enum class BooleanOp : std::uint8_t { unite, intersect, subtract };
enum class Dominance : std::uint8_t { left, right, equal };

/// Where an entity of one group lies with respect to the other one (pereira2012 3).
enum class Relation : std::uint8_t {
  a_in_b,   ///< AinB: of A only, inside one region of B
  b_in_a,   ///< BinA
  common,   ///< INTERS: of both
  a_out_b,  ///< AoutB: of A only, outside all regions of B
  b_out_a,  ///< BoutA
};
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

struct TableRow {
  const char* id;  ///< such as `union.face.AinB.equal`
  BooleanOp op;
  Standing standing;
  std::uint8_t dimension;
  Relation relation;
  Condition condition;
};

/// All rows: 60 of union and intersection, 15 of difference.
std::span<const TableRow> table_rows();
/// The number of the row in `table_rows()` for an entity of a dimension up to 2.
std::size_t table_row(BooleanOp op, bool dominant, int dimension, Relation relation);

/// The regions of both groups on the two sides of a face (0: none) and whose entity it is.
struct FaceSides {
  std::uint32_t a[2] = {0, 0}, b[2] = {0, 0};
  int regions_of_a() const { return bounded(a); }  ///< numRegA
  int regions_of_b() const { return bounded(b); }  ///< numRegB

 private:
  static int bounded(const std::uint32_t (&side)[2]) {
    return side[0] == side[1] ? 0 : (side[0] == 0 || side[1] == 0 ? 1 : 2);
  }
};
/// Evaluates a condition of faces.
bool holds(Condition condition, const FaceSides& sides);

/// The tables in Markdown, with a head that says that they are our reading of Fig. 3.
std::string tables_markdown();

}  // namespace cnrg
