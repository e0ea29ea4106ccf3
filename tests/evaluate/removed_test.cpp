// What rows of the tables are counted to remove: cells that the two operands of a step make of each other, counted
// by hand, whatever else is in the tree.
#include <map>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using RowCounts = std::map<std::string, std::size_t>;

RowCounts removed(const std::string& nodes, const std::string& result, const std::string& node,
                  Refining refining = Refining::chosen, bool validate = false) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: " + result + "\n", "t.yaml");
  EvaluateOptions options;
  options.refining = refining;
  options.validate = validate;  // then no nodes are one fold
  const Evaluation evaluation = evaluate(tree, options);
  RowCounts out;
  for (const NodeRow* row : evaluation.all_rows()) {
    if (row->name != node) continue;
    for (const auto& [rule, count] : row->removals) out[table_rows()[rule].id] = count;
  }
  return out;
}

TEST_CASE("a difference removes the same beside a ball", "[removed]") {
  const std::string d = R"(  a: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  b: {box: {min: [2, 2, 2], max: [6, 6, 6]}}
  d: {difference: [a, b]}
)";
  const std::string m = d + R"(  e: {sphere: {center: [3, 3, 3], radius: 2, segments: 24}}
  m: {union: [d, e]}
)";
  // A corner of each is inside of the other: 3 faces, 3 edges and a vertex of a; b loses 3 whole faces, and of the
  // other 3 what is outside of a, with 9 edges, 3 pieces of edges and 7 vertices.
  const RowCounts right{{"difference.face.AinB", 3},   {"difference.face.BoutA", 6},
                        {"difference.edge.AinB", 3},   {"difference.edge.BoutA", 12},
                        {"difference.vertex.AinB", 1}, {"difference.vertex.BoutA", 7}};
  CHECK(removed(d, "d", "d") == right);
  for (const Refining refining : {Refining::chosen, Refining::together, Refining::apart}) {
    CHECK(removed(m, "m", "d", refining) == right);
  }
}

TEST_CASE("each node of a chain removes what it would alone", "[removed]") {
  const std::string d1 = R"(  p: {box: {min: [0, 0, 0], max: [10, 10, 1]}}
  h1: {box: {min: [1, 1, -1], max: [2, 2, 2]}}
  d1: {difference: [p, h1]}
)";
  const std::string d4 = d1 + R"(  h2: {box: {min: [3, 1, -1], max: [4, 2, 2]}}
  h3: {box: {min: [5, 1, -1], max: [6, 2, 2]}}
  h4: {box: {min: [1.5, 1.5, -1], max: [3.5, 3, 2]}}
  d2: {difference: [d1, h2]}
  d3: {difference: [d2, h3]}
  d4: {difference: [d3, h4]}
)";
  // A square of the plate above and below; the prism's ends, its four sides above and below, 8 edges around the
  // ends, and the uprights above and below.
  const RowCounts hole{{"difference.face.AinB", 2},
                       {"difference.face.BoutA", 10},
                       {"difference.edge.BoutA", 16},
                       {"difference.vertex.BoutA", 8}};
  // The last one joins two holes: of the plate it takes a piece above and below, two walls of each hole with
  // uprights between them, and what bounds these. Its own sides are one face where a hole joins what is above and
  // below, so 1 + 1 + 1 + 2 and the two ends; two of its uprights are in the holes as a whole.
  const RowCounts last{{"difference.face.AinB", 6},   {"difference.edge.AinB", 10},
                       {"difference.vertex.AinB", 4}, {"difference.face.BoutA", 7},
                       {"difference.edge.BoutA", 14}, {"difference.vertex.BoutA", 8}};
  CHECK(removed(d1, "d1", "d1") == hole);
  for (const bool one_by_one : {false, true}) {
    for (const Refining refining : {Refining::together, Refining::apart}) {
      for (const char* const node : {"d1", "d2", "d3"})
        CHECK(removed(d4, "d4", node, refining, one_by_one) == hole);
      CHECK(removed(d4, "d4", "d4", refining, one_by_one) == last);
    }
  }
}

TEST_CASE("a curved face is one until the other operand cuts it", "[removed]") {
  // The side of the bore is parted in three; the outer parts go with the ends, two rims each.
  const std::string nodes = R"(  block: {box: {min: [-2, -2, 0], max: [2, 2, 4]}}
  bore: {cylinder: {from: [0, 0, -1], to: [0, 0, 5], radius: 1, segments: 32}}
  d: {difference: [block, bore]}
)";
  const RowCounts right{{"difference.face.AinB", 2}, {"difference.face.BoutA", 4}, {"difference.edge.BoutA", 2}};
  CHECK(removed(nodes, "d", "d") == right);
  CHECK(removed(nodes + "  k: {box: {min: [0, 0, -9], max: [9, 9, 9]}}\n  u: {union: [d, k]}\n", "u", "d") ==
        right);
}

TEST_CASE("with many operands each step counts what it removes", "[removed]") {
  const std::string leaves = R"(  a: {box: {min: [0, 0, 0], max: [3, 1, 1]}}
  b: {box: {min: [1, -1, -1], max: [2, 2, 2]}}
  c: {box: {min: [0, 0, 0], max: [3, 1, 1]}, translate: [0, 0, 1/2]}
)";
  const RowCounts first = removed(leaves + "  n: {union: [a, b]}\n", "n", "n"),
                  second = removed(leaves + "  n1: {union: [a, b]}\n  n: {union: [n1, c]}\n", "n", "n"),
                  both = removed(leaves + "  n: {union: [a, b, c]}\n", "n", "n");
  // b has the middle of a inside: four walls, the eight pieces of its edges; the openings of b's walls.
  CHECK(first ==
        RowCounts{{"union.face.AinB.equal", 4}, {"union.edge.AinB.equal", 4}, {"union.face.BinA.equal", 2}});
  RowCounts sum = first;
  for (const auto& [row, count] : second) sum[row] += count;
  CHECK(both == sum);
}

}  // namespace
}  // namespace cnrg
