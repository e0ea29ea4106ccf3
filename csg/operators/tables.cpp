// The rows of the tables, the search for the row of an entity, and their text.
#include "csg/operators/tables.h"

#include <algorithm>
#include <array>

#include "csg/operators/paper_terms.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

using enum BooleanOp;
using enum Standing;
using enum Relation;
using enum Condition;

constexpr TableRow kRows[] = {
    {"union.face.AinB.dominant", unite, dominant, 2, a_in_b, never},
    {"union.face.BinA.dominant", unite, dominant, 2, b_in_a, always},
    {"union.face.INTERS.dominant", unite, dominant, 2, common, never},
    {"union.face.AoutB.dominant", unite, dominant, 2, a_out_b, never},
    {"union.face.BoutA.dominant", unite, dominant, 2, b_out_a, never},
    {"union.face.AinB.equal", unite, equal, 2, a_in_b, one_region_a},
    {"union.face.BinA.equal", unite, equal, 2, b_in_a, one_region_b},
    {"union.face.INTERS.equal", unite, equal, 2, common, opposite_regions},
    {"union.face.AoutB.equal", unite, equal, 2, a_out_b, never},
    {"union.face.BoutA.equal", unite, equal, 2, b_out_a, never},
    {"union.edge.AinB.dominant", unite, dominant, 1, a_in_b, never},
    {"union.edge.BinA.dominant", unite, dominant, 1, b_in_a, always},
    {"union.edge.INTERS.dominant", unite, dominant, 1, common, never},
    {"union.edge.AoutB.dominant", unite, dominant, 1, a_out_b, never},
    {"union.edge.BoutA.dominant", unite, dominant, 1, b_out_a, never},
    {"union.edge.AinB.equal", unite, equal, 1, a_in_b, not_free_a},
    {"union.edge.BinA.equal", unite, equal, 1, b_in_a, not_free_b},
    {"union.edge.INTERS.equal", unite, equal, 1, common, free_in_neither},
    {"union.edge.AoutB.equal", unite, equal, 1, a_out_b, never},
    {"union.edge.BoutA.equal", unite, equal, 1, b_out_a, never},
    {"union.vertex.AinB.dominant", unite, dominant, 0, a_in_b, never},
    {"union.vertex.BinA.dominant", unite, dominant, 0, b_in_a, always},
    {"union.vertex.INTERS.dominant", unite, dominant, 0, common, never},
    {"union.vertex.AoutB.dominant", unite, dominant, 0, a_out_b, never},
    {"union.vertex.BoutA.dominant", unite, dominant, 0, b_out_a, never},
    {"union.vertex.AinB.equal", unite, equal, 0, a_in_b, not_free_a},
    {"union.vertex.BinA.equal", unite, equal, 0, b_in_a, not_free_b},
    {"union.vertex.INTERS.equal", unite, equal, 0, common, free_in_neither},
    {"union.vertex.AoutB.equal", unite, equal, 0, a_out_b, never},
    {"union.vertex.BoutA.equal", unite, equal, 0, b_out_a, never},
    {"intersection.face.AinB.dominant", intersect, dominant, 2, a_in_b, never},
    {"intersection.face.BinA.dominant", intersect, dominant, 2, b_in_a, parts_or_hangs_in_b},
    {"intersection.face.INTERS.dominant", intersect, dominant, 2, common, never},
    {"intersection.face.AoutB.dominant", intersect, dominant, 2, a_out_b, always},
    {"intersection.face.BoutA.dominant", intersect, dominant, 2, b_out_a, always},
    {"intersection.face.AinB.equal", intersect, equal, 2, a_in_b, never},
    {"intersection.face.BinA.equal", intersect, equal, 2, b_in_a, never},
    {"intersection.face.INTERS.equal", intersect, equal, 2, common, never},
    {"intersection.face.AoutB.equal", intersect, equal, 2, a_out_b, always},
    {"intersection.face.BoutA.equal", intersect, equal, 2, b_out_a, always},
    {"intersection.edge.AinB.dominant", intersect, dominant, 1, a_in_b, never},
    {"intersection.edge.BinA.dominant", intersect, dominant, 1, b_in_a, inside_region_b},
    {"intersection.edge.INTERS.dominant", intersect, dominant, 1, common, never},
    {"intersection.edge.AoutB.dominant", intersect, dominant, 1, a_out_b, always},
    {"intersection.edge.BoutA.dominant", intersect, dominant, 1, b_out_a, always},
    {"intersection.edge.AinB.equal", intersect, equal, 1, a_in_b, never},
    {"intersection.edge.BinA.equal", intersect, equal, 1, b_in_a, never},
    {"intersection.edge.INTERS.equal", intersect, equal, 1, common, never},
    {"intersection.edge.AoutB.equal", intersect, equal, 1, a_out_b, always},
    {"intersection.edge.BoutA.equal", intersect, equal, 1, b_out_a, always},
    {"intersection.vertex.AinB.dominant", intersect, dominant, 0, a_in_b, never},
    {"intersection.vertex.BinA.dominant", intersect, dominant, 0, b_in_a, inside_region_b},
    {"intersection.vertex.INTERS.dominant", intersect, dominant, 0, common, never},
    {"intersection.vertex.AoutB.dominant", intersect, dominant, 0, a_out_b, always},
    {"intersection.vertex.BoutA.dominant", intersect, dominant, 0, b_out_a, always},
    {"intersection.vertex.AinB.equal", intersect, equal, 0, a_in_b, never},
    {"intersection.vertex.BinA.equal", intersect, equal, 0, b_in_a, never},
    {"intersection.vertex.INTERS.equal", intersect, equal, 0, common, never},
    {"intersection.vertex.AoutB.equal", intersect, equal, 0, a_out_b, always},
    {"intersection.vertex.BoutA.equal", intersect, equal, 0, b_out_a, always},
    {"difference.face.AinB", subtract, any, 2, a_in_b, always},
    {"difference.face.BinA", subtract, any, 2, b_in_a, no_new_region},
    {"difference.face.INTERS", subtract, any, 2, common, no_side_survives},
    {"difference.face.AoutB", subtract, any, 2, a_out_b, never},
    {"difference.face.BoutA", subtract, any, 2, b_out_a, always},
    {"difference.edge.AinB", subtract, any, 1, a_in_b, always},
    {"difference.edge.BinA", subtract, any, 1, b_in_a, always},
    {"difference.edge.INTERS", subtract, any, 1, common, always},
    {"difference.edge.AoutB", subtract, any, 1, a_out_b, never},
    {"difference.edge.BoutA", subtract, any, 1, b_out_a, always},
    {"difference.vertex.AinB", subtract, any, 0, a_in_b, always},
    {"difference.vertex.BinA", subtract, any, 0, b_in_a, always},
    {"difference.vertex.INTERS", subtract, any, 0, common, always},
    {"difference.vertex.AoutB", subtract, any, 0, a_out_b, never},
    {"difference.vertex.BoutA", subtract, any, 0, b_out_a, always},
};

static_assert(std::size(kRows) == kTableRows);

constexpr std::size_t kDimensions = 3;
constexpr std::size_t slot(BooleanOp op, bool dominant, std::size_t dimension, Relation relation) {
  return ((static_cast<std::size_t>(op) * 2 + (dominant ? 0 : 1)) * kDimensions + dimension) * kRelations +
         static_cast<std::size_t>(relation);
}

constexpr auto index_rows() {
  std::array<std::uint8_t, 3 * 2 * kDimensions * kRelations> index{};
  for (auto& entry : index) entry = 0xff;
  for (std::size_t i = 0; i < std::size(kRows); ++i) {
    const TableRow& r = kRows[i];
    const auto number = static_cast<std::uint8_t>(i);
    if (r.standing != Standing::equal) index[slot(r.op, true, r.dimension, r.relation)] = number;
    if (r.standing != Standing::dominant) index[slot(r.op, false, r.dimension, r.relation)] = number;
  }
  return index;
}
constexpr auto kIndex = index_rows();
constexpr bool complete() {
  for (auto entry : kIndex) {
    if (entry == 0xff) return false;
  }
  return true;
}
static_assert(complete(), "each operator, standing, dimension and relation has a row");

constexpr Relation kOrder[] = {a_in_b, b_in_a, common, a_out_b, b_out_a};

void print_table(std::string& out, BooleanOp op, int dimension) {
  const bool split = op != BooleanOp::subtract;
  out += split ? "| | A > B | A = B |\n|---|---|---|\n" : "| | A - B |\n|---|---|\n";
  for (Relation relation : kOrder) {
    out += std::string("| ") + name(relation);
    for (bool dominant : {true, false}) {
      if (!split && !dominant) continue;
      const TableRow& r = kRows[table_row(op, dominant, dimension, relation)];
      out += " | " + condition_words(r) + " (`" + r.id + "`)";
    }
    out += " |\n";
  }
  out += "\n";
}

}  // namespace

const char* name(Relation relation) {
  switch (relation) {
    case Relation::a_in_b: return "AinB";
    case Relation::b_in_a: return "BinA";
    case Relation::common: return "INTERS";
    case Relation::a_out_b: return "AoutB";
    case Relation::b_out_a: return "BoutA";
  }
  throw InvariantError("tables: unknown relation");
}

const char* name(BooleanOp op) {
  switch (op) {
    case BooleanOp::unite: return "union";
    case BooleanOp::intersect: return "intersection";
    case BooleanOp::subtract: return "difference";
  }
  throw InvariantError("tables: unknown operator");
}

const char* words(Condition condition) {
  switch (condition) {
    case Condition::never: return "never";
    case Condition::always: return "always";
    case Condition::one_region_a: return "numRegA = 1";
    case Condition::one_region_b: return "numRegB = 1";
    case Condition::opposite_regions: return "numRegA = 1, numRegB = 1 and nA != nB";
    case Condition::parts_or_hangs_in_b: return "numRegB = 2, or numRegB = 0 and insideB";
    case Condition::no_new_region: return "numRegB != 1";
    case Condition::no_side_survives:
      return "no side is in A and out of B's regions; or numRegA = 0 and numRegB = 0";
    case Condition::not_free_a: return "not free in A";
    case Condition::not_free_b: return "not free in B";
    case Condition::free_in_neither: return "free in neither";
    case Condition::inside_region_b: return "it lies inside one region of B";
  }
  throw InvariantError("tables: unknown condition");
}

std::span<const TableRow> table_rows() { return kRows; }

std::size_t table_row(BooleanOp op, bool dominant, int dimension, Relation relation) {
  require(dimension >= 0 && dimension <= 2, "tables: entities have a dimension up to 2");
  return kIndex[slot(op, dominant, static_cast<std::size_t>(dimension), relation)];
}

void wrong_dimension() {
  throw InvariantError("tables: a condition was asked of an entity of the wrong dimension");
}

Roles roles(BooleanOp op, Dominance dominance) {
  if (op == BooleanOp::subtract) return {false, true};
  return {dominance == Dominance::right, dominance != Dominance::equal};
}

bool keeps_outside(BooleanOp op, bool dominant, Relation relation) {
  const auto condition = [&](int dimension) {
    return kRows[table_row(op, dominant, dimension, relation)].condition;
  };
  const Condition faces = condition(2);
  require(
      (faces == Condition::never || faces == Condition::always) && condition(1) == faces && condition(0) == faces,
      "tables: entities outside of the other operand are not all kept or all removed");
  return faces == Condition::never;
}

void Removals::add(std::size_t row, std::size_t count) {
  if (count == 0) return;
  const auto it =
      std::find_if(counts_.begin(), counts_.end(), [&](const auto& entry) { return entry.first == row; });
  if (it == counts_.end()) counts_.emplace_back(row, count);
  else it->second += count;
}

void Removals::add(const Removals& more) {
  for (const auto& [row, count] : more) add(row, count);
}

std::size_t Removals::of(std::size_t row) const {
  for (const auto& [known, count] : counts_) {
    if (known == row) return count;
  }
  return 0;
}

std::size_t Removals::total() const {
  std::size_t sum = 0;
  for (const auto& [row, count] : counts_) sum += count;
  return sum;
}

std::string tables_markdown() {
  std::string out =
      "# When an entity is removed\n\n"
      "The cells of Fig. 3 in Pereira et al. (2012) are an image that the paper's text does not carry. These\n"
      "tables are **our reading** of it: derived from the paper's text (section 3), from point-set identities\n"
      "and from its Fig. 10. A is the dominant operand (A > B) or the left one of two equals (A = B); the\n"
      "difference A - B ignores dominance. Edges and vertices that bound a kept face or edge are kept; the\n"
      "rows of edges and vertices decide about the others.\n\n"
      "The terms are those of its section 3. AinB: of A, inside a region of B; AoutB: of A, outside of all\n"
      "regions of B; INTERS: of both. numRegA: how many regions of A the face bounds; nA: its outward normal\n"
      "there; insideB: inside a region of B. numFaceA: how many faces of A the edge bounds; numEdgeA: how many\n"
      "edges of A end at the vertex. dangOrLoose: an edge in the interior of a removed face, which it does not\n"
      "bound; loose: a vertex there.\n\n";
  const char* dimensions[] = {"vertices", "edges", "faces"};
  for (BooleanOp op : {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract}) {
    for (int dimension : {2, 1, 0}) {
      out += std::string("## ") + name(op) + ", " + dimensions[dimension] + ": remove when\n\n";
      print_table(out, op, dimension);
    }
  }
  return out;
}

}  // namespace cnrg
