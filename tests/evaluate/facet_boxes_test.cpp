// The boxes of facets, noted while leaves are made, hold what their parameters are, exactly and afterwards.
#include <algorithm>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/leaves/surface_parameters.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

TEST_CASE("boxes of facets are the least that hold the parameters of their corners", "[evaluate][curved]") {
  const std::string shapes[] = {
      "sphere: {center: [0, 0, 0], radius: 1, segments: 9}",
      "cylinder: {from: [0, 0, 0], to: [1, 2, 3], radius: 1, segments: 7}",
      "cone: {from: [0, 0, 0], to: [1, 2, 3], radius: 1, top: 0, segments: 7}",
      "torus: {center: [0, 0, 0], axis: [0, 1, 1], radius: 3, tube: 1, segments: 7}",
      "revolve: {profile: [[1, 0], {bezier: [[2, 1]]}, [1, 2]], degrees: 100, segments: 7}",
      "extrude: {profile: [[0, 0, 0], {bezier: [[1, 2, 0]]}, [2, 0, 0]], vector: [0, 0, 1], chord: 0.01}",
      "extrude: {profile: [[0, 0, 0], [1, 2, 0], [2, 0, 0]], vector: [0, 0, 1], twist: 90, chord: 0.01}",
      "bezier: {patch: [[[0, 0, 0], [1, 0, 1], [2, 0, 0]], [[0, 1, 0], [1, 1, 2], [2, 1, 0]]], chord: 0.01}",
  };
  for (const std::string& shape : shapes) {
    INFO(shape);
    const std::string text = "cnrg: 1\nnodes:\n  a: {" + shape +
                             "}\n  b: {box: {min: [-9, -9, -9], max: [9, 9, 9]}}\n"
                             "  c: {union: [a, b], dominance: left}\nresult: c\n";
    const Evaluation evaluation = evaluate(parse_tree(text, "t.yaml"));
    const SurfaceParameters& parameters = *evaluation.parameters;
    std::size_t curved = 0;
    for (const SourceId s : IdRange<SourceId>(evaluation.complex->sources.size())) {
      const auto cells = parameters.cells(s);
      const auto boxes = parameters.boxes(s);
      REQUIRE(boxes.size() == cells.size());
      if (cells.empty()) continue;
      REQUIRE(cells.size() == 1);
      ++curved;
      for (std::size_t d = 0; d < 2; ++d) {
        const auto [low, high] =
            std::minmax_element(cells[0].begin(), cells[0].end(),
                                [d](const PatchCorner& a, const PatchCorner& b) { return a.at[d] < b.at[d]; });
        CHECK(from_double(boxes[0][d][0]) <= low->at[d]);
        CHECK(from_double(boxes[0][d][1]) >= high->at[d]);
        CHECK(boxes[0][d][0] >= to_double(low->at[d]) - 1e-15);
        CHECK(boxes[0][d][1] <= to_double(high->at[d]) + 1e-15);
      }
    }
    CHECK(curved > 4);
  }
}

}  // namespace
}  // namespace cnrg
