// Trees of benchmarks: what they hold by counting, or by another tree of the same set.

#include "bench/cases/case.h"
#include "bench/cases/tree_cases.h"
#include "csg/evaluate/evaluate.h"
#include "kernel/exact/integers.h"
#include "tests/catch.h"
#include "tests/families/model_checks.h"

namespace cnrg::bench {
namespace {

NodeRow result_of(const std::string& text) {
  const Evaluation evaluation = evaluate(parse_tree(text, "case.yaml"));
  return evaluation.rows.back();
}

Rational tree_volume(const std::string& text) { return result_of(text).volume().value(); }

}  // namespace

TEST_CASE("a plate with holes has the volume that integers give, as meshes, in one difference and in a chain") {
  const PlateWithHoles five{5};
  CHECK(five.side() == 3);
  long long doubled_area = 0;  // fan of the first corner of one section
  const auto corners = five.section(4);
  REQUIRE(corners.size() == 24);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const long long ax = corners[i - 1][0] - corners[0][0], ay = corners[i - 1][1] - corners[0][1];
    const long long bx = corners[i][0] - corners[0][0], by = corners[i][1] - corners[0][1];
    const long long part = ax * by - ay * bx;
    CHECK(part > 0);
    doubled_area += part;
  }
  CHECK(five.volume() == (9LL << 20) * (9LL << 20) * 2 - 5 * doubled_area);
  CHECK(tree_volume(plate_difference(5)) == to_integer(five.volume()));
  CHECK(tree_volume(plate_chain(5)) == to_integer(five.volume()));
  const Case meshes = plate(5);
  REQUIRE(meshes.leaves.size() == 6);
  CHECK(meshes.volume == five.volume());
  CHECK(fault_of(model_of(meshes.leaves[5])).empty());
  CHECK(volume_of(model_of(meshes.leaves[5])) == to_integer(doubled_area * 3));
}

TEST_CASE("fractures in a block leave its volume as it is, as walls and sheets") {
  const NodeRow row = result_of(fractures_in_block(12, 1));
  CHECK(row.volume() == 1000000);
  CHECK(row.cells[2] > 6 + 12);
}

TEST_CASE("cut spheres are what the box leaves of the spheres' union, and each is there by itself") {
  std::string together = cut_spheres(5, 1), other = together;
  const std::string list = "all: {union: [k0, k1, k2, k3, k4]}";
  const std::size_t at = other.find(list);
  REQUIRE(at != std::string::npos);
  other.replace(at, list.size(), "spheres: {union: [s0, s1, s2, s3, s4]}\n  all: {intersection: [spheres, unit]}");
  const Rational whole = tree_volume(together);
  CHECK(whole == tree_volume(other));
  Rational sum = 0, largest = 0;
  const std::vector<std::string> apart = cut_spheres_apart(5, 1);
  REQUIRE(apart.size() == 5);
  for (const std::string& text : apart) {
    const Rational one = tree_volume(text);
    sum += one;
    if (one > largest) largest = one;
  }
  CHECK(whole < sum);
  CHECK(whole > largest);
}

TEST_CASE("shared boxes are as many as doublings make, apart from each other") {
  const NodeRow row = result_of(shared_boxes(7));
  CHECK(row.volume() == 128);
  CHECK(row.regions == 128);
  CHECK(row.cells[2] == 6 * 128);
}

}  // namespace cnrg::bench
