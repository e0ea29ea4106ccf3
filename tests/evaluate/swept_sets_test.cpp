// Sweeps and lofts of convex profiles as point sets: between two sections they are the convex hull of both, which
// is a leaf that knows nothing of sweeps. Differences both ways are empty, exactly.
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/group.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// Both ways nothing is left of any dimension that has a region.
void check_equal(const std::string& solid, const std::string& hulls) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n  a: " + solid + "\n  b: " + hulls +
                                   "\n  more: {regularize: {difference: [a, b]}}\n"
                                   "  less: {regularize: {difference: [b, a]}}\n"
                                   "  r: {union: [more, less]}\nresult: r\n",
                               "t.yaml");
  EvaluateOptions options;
  options.validate = true;
  options.nodes = {tree.find("a"), tree.find("b")};
  const Evaluation e = evaluate(tree, options);
  const Group& left = e.kept[0].group();
  CHECK(left.cells.empty());
  CHECK(left.faces.empty());
  CHECK(e.kept[1].group().regions.size() == 1);
}

TEST_CASE("a mitred sweep is the hulls between its sections", "[sweep][evaluate]") {
  // Left, then up, then back to the right: at each bend the section lies in the plane that halves the angle.
  check_equal(
      "{sweep: {profile: [[0, -1, -1], [0, 1, -1], [0, 1, 1], [0, -1, 1]], path: [[0, 0, 0], [5, 0, 0], [5, 5, "
      "0], "
      "[11, 5, 0]]}}",
      "{union: [{hull: [[0, -1, -1], [0, 1, -1], [0, 1, 1], [0, -1, 1], [4, 1, -1], [4, 1, 1], [6, -1, -1], [6, "
      "-1, "
      "1]]}, {hull: [[4, 1, -1], [4, 1, 1], [6, -1, -1], [6, -1, 1], [4, 6, -1], [4, 6, 1], [6, 4, -1], [6, 4, "
      "1]]}, "
      "{hull: [[4, 6, -1], [4, 6, 1], [6, 4, -1], [6, 4, 1], [11, 4, -1], [11, 4, 1], [11, 6, -1], [11, 6, "
      "1]]}]}");
  // A triangle around a 3-4-5 bend: (5, 0) + t (-1, 2) is its plane, across (-4/5, 3/5).
  check_equal("{sweep: {profile: [[0, -1, 0], [0, 1, 0], [0, 0, 2]], path: [[0, 0, 0], [5, 0, 0], [8, 4, 0]]}}",
              "{union: [{hull: [[0, -1, 0], [0, 1, 0], [0, 0, 2], [5.5, -1, 0], [4.5, 1, 0], [5, 0, 2]]}, {hull: "
              "[[5.5, -1, "
              "0], [4.5, 1, 0], [5, 0, 2], [8.8, 3.4, 0], [7.2, 4.6, 0], [8, 4, 2]]}]}");
}

TEST_CASE("a loft of similar profiles is the hulls between them", "[loft][evaluate]") {
  check_equal(
      "{loft: {profiles: [[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[-2, -2, 3], [2, -2, 3], [2, 2, 3], "
      "[-2, "
      "2, 3]], [[0, 0, 4], [1, 0, 4], [1, 1, 4], [0, 1, 4]]]}}",
      "{union: [{hull: [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [-2, -2, 3], [2, -2, 3], [2, 2, 3], [-2, "
      "2, "
      "3]]}, {hull: [[-2, -2, 3], [2, -2, 3], [2, 2, 3], [-2, 2, 3], [0, 0, 4], [1, 0, 4], [1, 1, 4], [0, 1, "
      "4]]}]}");
}

}  // namespace
}  // namespace cnrg
