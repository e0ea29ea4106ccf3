// Very thin parts: whatever is asked for ends with a mesh that keeps it where the model is wide.
#include <algorithm>
#include <cmath>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "csg/mesh/has_to_be_split.h"
#include "csg/mesh/plc.h"
#include "csg/mesh/tetgen_run.h"
#include "kernel/base/error.h"
#include "kernel/tetrahedra/shapes.h"
#include "tests/catch.h"
#include "tests/mesh/result_of.h"

using namespace cnrg;

namespace {

/// Two slabs, a million and ten thousand times as wide as thick, and a bolt through both.
const std::string kSlabs = R"(
  block: {box: {min: [0, 0, 0], max: [10, 10, 10]}}
  thin:  {box: {min: [0, 0, 3], max: [10, 10, "300001/100000"]}}
  thick: {box: {min: [0, 0, 6], max: [10, 10, "6001/1000"]}}
  bolt:  {polyline: [[5, 5, 1], [5, 5, 9]]}
  model: {union: [bolt, thin, thick, block], dominance: left}
)";
/// A plate that ends at a plane one double above its other side.
const std::string kNoDouble = R"(
  low:   {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  plate: {box: {min: [0, 0, 1], max: [1, 1, "4503599627370497/4503599627370496"]}}
  model: {union: [plate, low], dominance: left}
)";

bool is_wide(const TetrahedralMesh& made, const Mesh::Simplex<4>& t) {
  return made.regions[t.entity].name.starts_with("block");
}
std::array<std::array<double, 3>, 4> corners(const Mesh& mesh, const Mesh::Simplex<4>& t) {
  const auto& p = mesh.points;
  return {p[t.points[0]], p[t.points[1]], p[t.points[2]], p[t.points[3]]};
}
std::size_t wide_ones(const TetrahedralMesh& made) {
  return std::size_t(std::count_if(made.mesh.tetrahedra.begin(), made.mesh.tetrahedra.end(),
                                   [&](const auto& t) { return is_wide(made, t); }));
}

}  // namespace

TEST_CASE("lengths end where parts are very thin, and hold where it is wide", "[mesh][thin]") {
  const Result result = result_of(kSlabs);
  for (const int way : {0, 1, 2, 3}) {
    TetrahedraOptions options;
    options.size = 2;
    options.surface_first = way == 1;
    options.constrained = way == 2;
    options.quality = way == 3 ? 1.6 : 0;
    const TetrahedralMesh made = tetrahedra(result, options);
    INFO("way " << way << ": " << made.notice);
    CHECK(made.mesh.tetrahedra.size() < 5000);
    CHECK(made.expected > 0.5 * double(made.mesh.tetrahedra.size()));
    CHECK(made.expected < 2 * double(made.mesh.tetrahedra.size()));
    CHECK_THAT(made.notice, Catch::Contains("tetrahedra of a good shape would fill regions that are very thin"));
    std::size_t longer = 0, bad = 0;
    for (const auto& t : made.mesh.tetrahedra) {
      if (!is_wide(made, t)) continue;
      const auto p = corners(made.mesh, t);
      bad += measures_of(p).shape < 0.2;
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; l < k; ++l)
          longer += std::hypot(p[k][0] - p[l][0], p[k][1] - p[l][1], p[k][2] - p[l][2]) > 3.2;
    }
    CHECK(longer * 50 < 6 * wide_ones(made));
    CHECK(bad * 100 < wide_ones(made));
  }
}

TEST_CASE("a quality ends where parts are very thin, and holds where it is wide", "[mesh][thin]") {
  const Result result = result_of(kSlabs);
  for (const bool constrained : {false, true}) {
    TetrahedraOptions options;
    options.quality = 2;
    options.constrained = constrained;
    const TetrahedralMesh made = tetrahedra(result, options);
    INFO(constrained << ": " << made.notice);
    CHECK(made.mesh.tetrahedra.size() < 5000);
    CHECK_THAT(made.notice, Catch::Contains("those there are as flat as they have to be") &&
                                !Catch::Contains("--seconds"));  // no machine makes them
    CHECK(made.quality.beyond > 0);
    std::size_t beyond = 0, sum = 0;
    for (std::size_t i = 0; i < made.regions.size(); ++i) {
      sum += made.quality.regions[i].beyond;
      if (made.regions[i].name.starts_with("block")) beyond += made.quality.regions[i].beyond;
    }
    CHECK(sum == made.quality.beyond);
    if (!constrained) CHECK(beyond * 10 < wide_ones(made));
  }
}

TEST_CASE("volumes are bounded where parts are very thin", "[mesh][thin]") {
  TetrahedraOptions options;
  options.max_volume = 5;
  options.constrained = GENERATE(false, true);
  const TetrahedralMesh made = tetrahedra(result_of(kSlabs), options);
  CHECK(made.quality.larger == 0);
  CHECK(made.mesh.tetrahedra.size() < 5000);
}

TEST_CASE("who says that he waits gets good shapes in thin parts, too", "[mesh][thin]") {
  // 2.4 million by TetGen.
  const Result plate = result_of("  model: {box: {min: [0, 0, 0], max: [8, 8, 1/100]}}\n");
  TetrahedraOptions options;
  options.quality = 2;
  options.max_volume = 1;
  const TetrahedralMesh made = tetrahedra(plate, options);
  CHECK_THAT(made.notice, Catch::Contains("; --seconds 0 makes them"));
  struct Told {};
  options.seconds = GENERATE(0, 1000);
  options.foretold = [](const MeshForecast& mesh) {
    CHECK(mesh.tetrahedra > 1e6);
    throw Told();
  };
  CHECK_THROWS_AS(tetrahedra(plate, options), Told);
}

TEST_CASE("what is flat is left as it is, and what is wide is bounded", "[mesh][thin]") {
  const std::array<double, 3> a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  CHECK(is_flat(a, b, c, {0, 0, 0.02}));
  CHECK_FALSE(is_flat(a, b, c, {0, 0, 0.025}));
  CHECK_FALSE(is_flat(a, b, c, {0, 0, 1}));
  CHECK(is_flat(b, c, {0, 0, 1e-9}, a));
}

TEST_CASE("where TetGen does not end of refining, it fills", "[mesh][thin]") {
  const Result block = result_of("  model: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n");
  TetrahedraOptions options;
  options.size = 0.3;
  SECTION("sizes") {}
  SECTION("a surface that was meshed first") { options.surface_first = true; }
  SECTION("the boundary is kept") { options.keep_boundary = true; }
  SECTION("volumes") { options.size = 0, options.max_volume = 0.01; }
  SECTION("a quality and volumes") { options.size = 0, options.max_volume = 0.01, options.quality = 1.4; }
  const TetrahedralMesh ended = tetrahedra(block, options);
  CHECK(ended.notice.find("filled") == std::string::npos);
  const TetgenLooksAtMost few(20);
  int told = 0;  // also what others make
  options.foretold = [&](const MeshForecast&) { ++told; };
  const TetrahedralMesh filled = tetrahedra(block, options);
  CHECK_THAT(filled.notice, Catch::StartsWith("TetGen did not come to an end") &&
                                Catch::Contains("; it has filled the regions, and the tetrahedra are improved"));
  if (!options.keep_boundary) CHECK(told == 2);
  if (options.surface_first || options.keep_boundary)
    CHECK(filled.mesh.triangles.size() == ended.mesh.triangles.size());
  CHECK(filled.regions[0].volume == 1);
  CHECK(filled.quality.larger == 0);
  CHECK(double(filled.mesh.tetrahedra.size()) > 0.5 * double(ended.mesh.tetrahedra.size()));
}

TEST_CASE("a plate without a double inside: its faces are kept; meshed first it is refused, with what helps",
          "[mesh][thin][errors]") {
  const Result result = result_of(kNoDouble);
  TetrahedraOptions options;
  options.keep_boundary = true;
  const TetrahedralMesh kept = tetrahedra(result, options);
  CHECK_THAT(kept.notice, Catch::Contains("these are constrained tetrahedra"));
  CHECK(kept.mesh.points.size() == 12);
  CHECK(kept.regions.size() == 2);
  options.keep_boundary = false;
  options.surface_first = true;
  CHECK_THROWS_WITH(tetrahedra(result, options),
                    Catch::Contains("one region is too thin for that") &&
                        Catch::EndsWith("leave out --surface-first, give other sizes, or join what nearly touches "
                                        "by --join"));
}

TEST_CASE("TetGen ends after so many steps, whatever the machine", "[mesh]") {
  Plc plc;
  plc.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 3, 1}, {1, 2, 3}, {3, 1, 2}, {3, 3, 3}};
  const auto run = [&](const TetgenBounds& bounds) {
    return run_tetgen(plc, {}, TetgenFrame::even, bounds).tetrahedra;
  };
  const auto all = run({});
  // The least number with which it ends, by halves; it is the same in every run.
  std::size_t few = 0, enough = 1 << 20;
  while (enough - few > 1) {
    const std::size_t middle = (few + enough) / 2;
    try {
      const auto made = run({.steps = middle});
      CHECK(made == all);
      enough = middle;
    } catch (const TetgenLate&) {
      few = middle;
    }
  }
  CHECK(few > 10);
  CHECK(run({.steps = enough}) == all);
  CHECK(run({.idle = enough}) == all);  // it does not refine
  for (const TetgenBounds& bounds : {TetgenBounds{.steps = few}, TetgenBounds{.idle = few}})
    CHECK_THROWS_WITH(run(bounds),
                      Catch::StartsWith("TetGen did not come to an end; ") && Catch::Contains("--seconds 0"));
}

TEST_CASE("TetGen's own refusals say to join what nearly touches", "[mesh][errors]") {
  Plc plc;
  plc.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {1, 0.4, 1}};
  plc.facets = {{{{0, 1, 2}}, {}, 0, 0}, {{{3, 4, 5}}, {}, 1, 1}};  // they cross, in whichever way it stops then
  CHECK_THROWS_WITH(
      run_tetgen(plc, {}, TetgenFrame::even, {}),
      Catch::StartsWith("TetGen ") && Catch::Contains("join what nearly touches by --join, remove slivers"));
}
