// The tables as data, and a small pair for each row that can remove something.
#include <algorithm>
#include <set>
#include <string>

#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "csg/operators/identities.h"
#include "csg/operators/verdict.h"
#include "tests/catch.h"
#include "tests/operators/pieces.h"

namespace cnrg {
namespace {

using namespace pieces;

TEST_CASE("each row has an id of its own and is found by what it is about", "[tables]") {
  CHECK(table_rows().size() == 75);
  std::set<std::string> ids;
  for (std::size_t i = 0; i < table_rows().size(); ++i) {
    const TableRow& row = table_rows()[i];
    CHECK(ids.insert(row.id).second);
    CHECK(table_row(row.op, row.standing != Standing::equal, row.dimension, row.relation) == i);
    const std::string id = row.id;
    CHECK(id.find(name(row.op)) == 0);
    CHECK(id.find(name(row.relation)) != std::string::npos);
  }
}

TEST_CASE("the printed tables say that they are our reading", "[tables]") {
  const std::string text = tables_markdown();
  CHECK(text.find("our reading") != std::string::npos);
  for (const TableRow& row : table_rows()) CHECK(text.find(std::string("`") + row.id + "`") != std::string::npos);
}

struct Case {
  std::string row;
  Piece left, right;
};

// Boxes that overlap, that share a wall of four pieces, that lie in each other; sheets, wires and points.
std::vector<Case> cases() {
  const Piece a = box({0, 0, 0}, {4, 4, 4}, 1, 0), b = box({2, 1, 1}, {6, 3, 3}, 1, 0);
  const Piece neighbour = box({4, 0, 0}, {8, 4, 4}, 1, 0);
  const Piece large = box({-2, -2, -2}, {8, 8, 8});
  const Piece parted = parted_box({1, 0, 0}, {3, 4, 4}, 2);
  const Piece outside = sheet({10, 0, 0}, {10, 2, 2}) + wire({12, 0, 0}, {12, 2, 0}) + point({14, 0, 0});
  const Piece inside = sheet({1, 1, 1}, {1, 2, 2}, 1) + wire({2, 1, 1}, {2, 2, 1}) + point({3, 3, 3});
  const Piece loose = a + inside;
  return {
      {"union.face.AinB.equal", a, b},
      {"union.face.BinA.dominant", a, b},
      {"union.face.BinA.equal", a, b},
      {"union.face.INTERS.equal", a, neighbour},
      {"intersection.face.BinA.dominant", large, parted},
      {"intersection.face.BinA.dominant", large, loose},
      {"intersection.face.AoutB.dominant", a, b},
      {"intersection.face.AoutB.equal", a, b},
      {"intersection.face.BoutA.dominant", a, b},
      {"intersection.face.BoutA.equal", a, b},
      {"difference.face.AinB", a, b},
      {"difference.face.BinA", large, parted},
      {"difference.face.INTERS", a, box({0, 0, 0}, {2, 2, 2})},
      {"difference.face.BoutA", a, b},

      {"union.edge.AinB.equal", a, large},
      {"union.edge.BinA.dominant", large, a},
      {"union.edge.BinA.equal", large, a},
      {"union.edge.INTERS.equal", a, neighbour},
      {"intersection.edge.BinA.dominant", large, loose},
      {"intersection.edge.AoutB.dominant", outside, a},
      {"intersection.edge.AoutB.equal", outside, a},
      {"intersection.edge.BoutA.dominant", a, outside},
      {"intersection.edge.BoutA.equal", a, outside},
      {"difference.edge.AinB", a, large},
      {"difference.edge.BinA", large, parted},
      {"difference.edge.INTERS", a, a},
      {"difference.edge.BoutA", a, outside},

      {"union.vertex.AinB.equal", a, large},
      {"union.vertex.BinA.dominant", large, a},
      {"union.vertex.BinA.equal", large, a},
      {"union.vertex.INTERS.equal", a, neighbour},
      {"intersection.vertex.BinA.dominant", large, loose},
      {"intersection.vertex.AoutB.dominant", outside, a},
      {"intersection.vertex.AoutB.equal", outside, a},
      {"intersection.vertex.BoutA.dominant", a, outside},
      {"intersection.vertex.BoutA.equal", a, outside},
      {"difference.vertex.AinB", a, large},
      {"difference.vertex.BinA", large, parted},
      {"difference.vertex.INTERS", a, a},
      {"difference.vertex.BoutA", a, outside},
  };
}

TEST_CASE("each row that can remove does so somewhere, also with the operands exchanged", "[tables]") {
  std::set<std::string> fired;
  for (const Case& c : cases()) {
    INFO(c.row);
    const auto row =
        std::find_if(table_rows().begin(), table_rows().end(), [&](const TableRow& r) { return r.id == c.row; });
    REQUIRE(row != table_rows().end());
    const auto built_complex = complex_of({c.left, c.right});
    const Complex& complex = *built_complex;
    CHECK(validate(complex) == "");
    const auto leaves = leaf_groups(complex);
    const Dominance dominance = row->standing == Standing::equal ? Dominance::equal : Dominance::left;
    const BooleanResult result = boolean_operation(complex, row->op, dominance, leaves[0], leaves[1]);
    CHECK(result.removals.of(static_cast<std::size_t>(row - table_rows().begin())) > 0);
    CHECK(check_boolean(complex, row->op, leaves[0], leaves[1], result.group) == "");
    fired.insert(c.row);
    if (row->op == BooleanOp::subtract) continue;
    // The right operand dominates: the same result, the same rows.
    const Dominance mirrored = dominance == Dominance::equal ? Dominance::equal : Dominance::right;
    const BooleanResult exchanged = boolean_operation(complex, row->op, mirrored, leaves[1], leaves[0]);
    CHECK(exchanged.group.faces == result.group.faces);
    CHECK(exchanged.group.edges == result.group.edges);
    CHECK(exchanged.group.vertices == result.group.vertices);
    CHECK(exchanged.group.cells == result.group.cells);
    if (dominance == Dominance::left) CHECK(exchanged.removals == result.removals);
  }
  for (const TableRow& row : table_rows()) {
    if (row.condition != Condition::never) CHECK((fired.count(row.id) == 1 ? "" : row.id) == std::string());
  }
}

TEST_CASE("a verdict names the row, or the boundary that kept an entity", "[tables]") {
  const auto built_complex = complex_of({box({0, 0, 0}, {4, 4, 4}), box({2, 1, 1}, {6, 3, 3})});
  const Complex& complex = *built_complex;
  const auto leaves = leaf_groups(complex);
  for (const BooleanOp op : {BooleanOp::unite, BooleanOp::intersect, BooleanOp::subtract}) {
    for (const Dominance d : {Dominance::left, Dominance::right, Dominance::equal}) {
      const Group result = boolean_operation(complex, op, d, leaves[0], leaves[1]).group;
      for (FaceId f : IdRange<FaceId>(complex.face_count())) {
        const Verdict v = verdict(complex, op, d, leaves[0], leaves[1], result, f);
        REQUIRE(v.entity);
        CHECK_FALSE(v.bounds_kept);
        if (v.row->condition == Condition::always) CHECK(v.removed);
        if (v.row->condition == Condition::never) CHECK(!v.removed);
      }
      for (EdgeId e : IdRange<EdgeId>(complex.edge_count())) {
        const Verdict v = verdict(complex, op, d, leaves[0], leaves[1], result, e);
        REQUIRE(v.entity);
        if (v.bounds_kept) CHECK(!v.removed);
        else if (v.row->condition == Condition::always) CHECK(v.removed);
      }
      for (VertexId x : complex.vertices) {
        const Verdict v = verdict(complex, op, d, leaves[0], leaves[1], result, x);
        REQUIRE(v.entity);
        if (v.bounds_kept) CHECK(!v.removed);
      }
    }
  }
}

}  // namespace
}  // namespace cnrg
