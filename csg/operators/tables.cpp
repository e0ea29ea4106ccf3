// The rows, and the little that evaluates and prints them.
#include "csg/operators/tables.h"

#include <array>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

constexpr TableRow kRows[] = {
    {"union.face.AinB.dominant", BooleanOp::unite, Standing::dominant, 2, Relation::a_in_b, Condition::never},
    {"union.face.BinA.dominant", BooleanOp::unite, Standing::dominant, 2, Relation::b_in_a, Condition::always},
    {"union.face.INTERS.dominant", BooleanOp::unite, Standing::dominant, 2, Relation::common, Condition::never},
    {"union.face.AoutB.dominant", BooleanOp::unite, Standing::dominant, 2, Relation::a_out_b, Condition::never},
    {"union.face.BoutA.dominant", BooleanOp::unite, Standing::dominant, 2, Relation::b_out_a, Condition::never},
    {"union.face.AinB.equal", BooleanOp::unite, Standing::equal, 2, Relation::a_in_b, Condition::one_region_a},
    {"union.face.BinA.equal", BooleanOp::unite, Standing::equal, 2, Relation::b_in_a, Condition::one_region_b},
    {"union.face.INTERS.equal", BooleanOp::unite, Standing::equal, 2, Relation::common, Condition::opposite_regions},
    {"union.face.AoutB.equal", BooleanOp::unite, Standing::equal, 2, Relation::a_out_b, Condition::never},
    {"union.face.BoutA.equal", BooleanOp::unite, Standing::equal, 2, Relation::b_out_a, Condition::never},
    {"union.edge.AinB.dominant", BooleanOp::unite, Standing::dominant, 1, Relation::a_in_b, Condition::never},
    {"union.edge.BinA.dominant", BooleanOp::unite, Standing::dominant, 1, Relation::b_in_a, Condition::always},
    {"union.edge.INTERS.dominant", BooleanOp::unite, Standing::dominant, 1, Relation::common, Condition::never},
    {"union.edge.AoutB.dominant", BooleanOp::unite, Standing::dominant, 1, Relation::a_out_b, Condition::never},
    {"union.edge.BoutA.dominant", BooleanOp::unite, Standing::dominant, 1, Relation::b_out_a, Condition::never},
    {"union.edge.AinB.equal", BooleanOp::unite, Standing::equal, 1, Relation::a_in_b, Condition::not_free_a},
    {"union.edge.BinA.equal", BooleanOp::unite, Standing::equal, 1, Relation::b_in_a, Condition::not_free_b},
    {"union.edge.INTERS.equal", BooleanOp::unite, Standing::equal, 1, Relation::common, Condition::free_in_neither},
    {"union.edge.AoutB.equal", BooleanOp::unite, Standing::equal, 1, Relation::a_out_b, Condition::never},
    {"union.edge.BoutA.equal", BooleanOp::unite, Standing::equal, 1, Relation::b_out_a, Condition::never},
    {"union.vertex.AinB.dominant", BooleanOp::unite, Standing::dominant, 0, Relation::a_in_b, Condition::never},
    {"union.vertex.BinA.dominant", BooleanOp::unite, Standing::dominant, 0, Relation::b_in_a, Condition::always},
    {"union.vertex.INTERS.dominant", BooleanOp::unite, Standing::dominant, 0, Relation::common, Condition::never},
    {"union.vertex.AoutB.dominant", BooleanOp::unite, Standing::dominant, 0, Relation::a_out_b, Condition::never},
    {"union.vertex.BoutA.dominant", BooleanOp::unite, Standing::dominant, 0, Relation::b_out_a, Condition::never},
    {"union.vertex.AinB.equal", BooleanOp::unite, Standing::equal, 0, Relation::a_in_b, Condition::not_free_a},
    {"union.vertex.BinA.equal", BooleanOp::unite, Standing::equal, 0, Relation::b_in_a, Condition::not_free_b},
    {"union.vertex.INTERS.equal", BooleanOp::unite, Standing::equal, 0, Relation::common, Condition::free_in_neither},
    {"union.vertex.AoutB.equal", BooleanOp::unite, Standing::equal, 0, Relation::a_out_b, Condition::never},
    {"union.vertex.BoutA.equal", BooleanOp::unite, Standing::equal, 0, Relation::b_out_a, Condition::never},
    {"intersection.face.AinB.dominant", BooleanOp::intersect, Standing::dominant, 2, Relation::a_in_b, Condition::never},
    {"intersection.face.BinA.dominant", BooleanOp::intersect, Standing::dominant, 2, Relation::b_in_a, Condition::parts_or_hangs_in_b},
    {"intersection.face.INTERS.dominant", BooleanOp::intersect, Standing::dominant, 2, Relation::common, Condition::never},
    {"intersection.face.AoutB.dominant", BooleanOp::intersect, Standing::dominant, 2, Relation::a_out_b, Condition::always},
    {"intersection.face.BoutA.dominant", BooleanOp::intersect, Standing::dominant, 2, Relation::b_out_a, Condition::always},
    {"intersection.face.AinB.equal", BooleanOp::intersect, Standing::equal, 2, Relation::a_in_b, Condition::never},
    {"intersection.face.BinA.equal", BooleanOp::intersect, Standing::equal, 2, Relation::b_in_a, Condition::never},
    {"intersection.face.INTERS.equal", BooleanOp::intersect, Standing::equal, 2, Relation::common, Condition::never},
    {"intersection.face.AoutB.equal", BooleanOp::intersect, Standing::equal, 2, Relation::a_out_b, Condition::always},
    {"intersection.face.BoutA.equal", BooleanOp::intersect, Standing::equal, 2, Relation::b_out_a, Condition::always},
    {"intersection.edge.AinB.dominant", BooleanOp::intersect, Standing::dominant, 1, Relation::a_in_b, Condition::never},
    {"intersection.edge.BinA.dominant", BooleanOp::intersect, Standing::dominant, 1, Relation::b_in_a, Condition::inside_b},
    {"intersection.edge.INTERS.dominant", BooleanOp::intersect, Standing::dominant, 1, Relation::common, Condition::never},
    {"intersection.edge.AoutB.dominant", BooleanOp::intersect, Standing::dominant, 1, Relation::a_out_b, Condition::always},
    {"intersection.edge.BoutA.dominant", BooleanOp::intersect, Standing::dominant, 1, Relation::b_out_a, Condition::always},
    {"intersection.edge.AinB.equal", BooleanOp::intersect, Standing::equal, 1, Relation::a_in_b, Condition::never},
    {"intersection.edge.BinA.equal", BooleanOp::intersect, Standing::equal, 1, Relation::b_in_a, Condition::never},
    {"intersection.edge.INTERS.equal", BooleanOp::intersect, Standing::equal, 1, Relation::common, Condition::never},
    {"intersection.edge.AoutB.equal", BooleanOp::intersect, Standing::equal, 1, Relation::a_out_b, Condition::always},
    {"intersection.edge.BoutA.equal", BooleanOp::intersect, Standing::equal, 1, Relation::b_out_a, Condition::always},
    {"intersection.vertex.AinB.dominant", BooleanOp::intersect, Standing::dominant, 0, Relation::a_in_b, Condition::never},
    {"intersection.vertex.BinA.dominant", BooleanOp::intersect, Standing::dominant, 0, Relation::b_in_a, Condition::inside_b},
    {"intersection.vertex.INTERS.dominant", BooleanOp::intersect, Standing::dominant, 0, Relation::common, Condition::never},
    {"intersection.vertex.AoutB.dominant", BooleanOp::intersect, Standing::dominant, 0, Relation::a_out_b, Condition::always},
    {"intersection.vertex.BoutA.dominant", BooleanOp::intersect, Standing::dominant, 0, Relation::b_out_a, Condition::always},
    {"intersection.vertex.AinB.equal", BooleanOp::intersect, Standing::equal, 0, Relation::a_in_b, Condition::never},
    {"intersection.vertex.BinA.equal", BooleanOp::intersect, Standing::equal, 0, Relation::b_in_a, Condition::never},
    {"intersection.vertex.INTERS.equal", BooleanOp::intersect, Standing::equal, 0, Relation::common, Condition::never},
    {"intersection.vertex.AoutB.equal", BooleanOp::intersect, Standing::equal, 0, Relation::a_out_b, Condition::always},
    {"intersection.vertex.BoutA.equal", BooleanOp::intersect, Standing::equal, 0, Relation::b_out_a, Condition::always},
    {"difference.face.AinB", BooleanOp::subtract, Standing::any, 2, Relation::a_in_b, Condition::always},
    {"difference.face.BinA", BooleanOp::subtract, Standing::any, 2, Relation::b_in_a, Condition::no_new_region},
    {"difference.face.INTERS", BooleanOp::subtract, Standing::any, 2, Relation::common, Condition::no_side_survives},
    {"difference.face.AoutB", BooleanOp::subtract, Standing::any, 2, Relation::a_out_b, Condition::never},
    {"difference.face.BoutA", BooleanOp::subtract, Standing::any, 2, Relation::b_out_a, Condition::always},
    {"difference.edge.AinB", BooleanOp::subtract, Standing::any, 1, Relation::a_in_b, Condition::always},
    {"difference.edge.BinA", BooleanOp::subtract, Standing::any, 1, Relation::b_in_a, Condition::always},
    {"difference.edge.INTERS", BooleanOp::subtract, Standing::any, 1, Relation::common, Condition::always},
    {"difference.edge.AoutB", BooleanOp::subtract, Standing::any, 1, Relation::a_out_b, Condition::never},
    {"difference.edge.BoutA", BooleanOp::subtract, Standing::any, 1, Relation::b_out_a, Condition::always},
    {"difference.vertex.AinB", BooleanOp::subtract, Standing::any, 0, Relation::a_in_b, Condition::always},
    {"difference.vertex.BinA", BooleanOp::subtract, Standing::any, 0, Relation::b_in_a, Condition::always},
    {"difference.vertex.INTERS", BooleanOp::subtract, Standing::any, 0, Relation::common, Condition::always},
    {"difference.vertex.AoutB", BooleanOp::subtract, Standing::any, 0, Relation::a_out_b, Condition::never},
    {"difference.vertex.BoutA", BooleanOp::subtract, Standing::any, 0, Relation::b_out_a, Condition::always},
};

constexpr std::size_t kDimensions = 3, kRelations = 5;
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

constexpr Relation kOrder[] = {Relation::a_in_b, Relation::b_in_a, Relation::common, Relation::a_out_b,
                               Relation::b_out_a};

void print_table(std::string& out, BooleanOp op, int dimension) {
  const bool split = op != BooleanOp::subtract;
  out += split ? "| | A > B | A = B |\n|---|---|---|\n" : "| | A - B |\n|---|---|\n";
  for (Relation relation : kOrder) {
    out += std::string("| ") + name(relation);
    for (bool dominant : {true, false}) {
      if (!split && !dominant) continue;
      const TableRow& r = kRows[table_row(op, dominant, dimension, relation)];
      out += std::string(" | ") + words(r.condition) + " (`" + r.id + "`)";
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
    case Condition::inside_b: return "all around it are regions of B";
  }
  throw InvariantError("tables: unknown condition");
}

std::span<const TableRow> table_rows() { return kRows; }

std::size_t table_row(BooleanOp op, bool dominant, int dimension, Relation relation) {
  require(dimension >= 0 && dimension <= 2, "tables: entities have a dimension up to 2");
  return kIndex[slot(op, dominant, static_cast<std::size_t>(dimension), relation)];
}

bool holds(Condition condition, const FaceSides& s) {
  switch (condition) {
    case Condition::never: return false;
    case Condition::always: return true;
    case Condition::one_region_a: return s.regions_of_a() == 1;
    case Condition::one_region_b: return s.regions_of_b() == 1;
    case Condition::opposite_regions:
      return s.regions_of_a() == 1 && s.regions_of_b() == 1 && (s.a[0] != 0) != (s.b[0] != 0);
    case Condition::parts_or_hangs_in_b:
      return s.regions_of_b() == 2 || (s.regions_of_b() == 0 && s.b[0] != 0);
    case Condition::no_new_region: return s.regions_of_b() != 1;
    case Condition::no_side_survives: {
      const bool survives = (s.a[0] != 0 && s.b[0] == 0) || (s.a[1] != 0 && s.b[1] == 0);
      return !survives || (s.regions_of_a() == 0 && s.regions_of_b() == 0);
    }
    default: break;
  }
  throw InvariantError("tables: a condition of edges and vertices was asked of a face");
}

std::string tables_markdown() {
  std::string out =
      "# When an entity is removed\n\n"
      "The cells of Fig. 3 in Pereira et al. (2012) are an image that the paper's text does not carry. These\n"
      "tables are **our reading** of it: derived from the paper's text (section 3), from point-set identities\n"
      "and from its Fig. 10. A is the dominant operand (A > B) or the left one of two equals (A = B); the\n"
      "difference A - B ignores dominance. Edges and vertices that bound a kept face or edge are kept; the\n"
      "rows of edges and vertices decide about the others.\n\n";
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
