// Time and stops: what ends in time, what is kept when it is over, and that every stage hears of a stop.
#include "csg/mesh/deadline.h"

#include <vector>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "csg/mesh/curved_mesh.h"
#include "csg/result/result_data.h"
#include "tests/catch.h"
#include "tests/mesh/result_of.h"

using namespace cnrg;

namespace {

const std::string kRound = R"(
  block: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  hole:  {cylinder: {from: [2, 2, -1], to: [2, 2, 5], radius: 1, segments: 24}}
  model: {difference: [block, hole]}
)";

/// Counts stages as they begin, and asks for a stop at one of them.
struct Stages {
  std::vector<std::string> told;
  std::size_t stop_at = 0;  // the first is 1; 0: never
  std::stop_source stop;
  Watch watch() {
    return {[this](std::string_view stage, std::size_t done, std::size_t) {
              if (done > 0) return;
              told.emplace_back(stage);
              if (told.size() == stop_at) stop.request_stop();
            },
            stop.get_token()};
  }
};

template <class Work>
void stop_everywhere(const Work& work) {
  Stages all;
  work(all.watch());
  REQUIRE(all.told.size() > 2);
  for (std::size_t at = 1; at <= all.told.size(); ++at) {
    INFO("a stop in " << all.told[at - 1]);
    Stages some;
    some.stop_at = at;
    CHECK_THROWS_AS(work(some.watch()), Stopped);
    CHECK(some.told.size() == at);  // nothing was begun after it
  }
}

}  // namespace

TEST_CASE("a deadline ends work that looks at its watch, and says where", "[deadline]") {
  const auto endless = [](const Deadline& deadline) {
    deadline.watch().begin("first");
    deadline.watch().begin("second", 5);
    for (;;) deadline.watch().check();
  };
  const Deadline deadline(Watch{}, 0.1, "box");
  CHECK(deadline.bounded());
  CHECK_THROWS_WITH(deadline.run([&]() -> int {
    endless(deadline);
    return 0;
  }),
                    Catch::Contains("stage `second`") && Catch::EndsWith("a larger box"));
  CHECK(deadline.over());
  CHECK(deadline.seconds_left() == 0);
  // Who waits may still stop it, and that is no matter of time.
  std::stop_source stop;
  const Deadline later(Watch{{}, stop.get_token()}, 1000);
  CHECK(later.seconds_left() > 900);
  CHECK(later.run([] { return 7; }) == 7);
  stop.request_stop();
  CHECK_THROWS_AS(later.run([&]() -> int {
    endless(later);
    return 0;
  }),
                  Stopped);
  CHECK_FALSE(later.over());
  const Deadline never(Watch{}, 0);
  CHECK_FALSE(never.bounded());
  CHECK_FALSE(never.watch().stop.stop_possible());
}

TEST_CASE("a mesh that is there when time is over is kept, proven, and said to be so", "[deadline]") {
  TetrahedraOptions options;
  options.seconds = 4;
  options.max_volume = 3e-7;
  options.constrained = GENERATE(false, true);
  const TetrahedralMesh made = tetrahedra(result_of(kBlock), options);
  CHECK_THAT(made.notice, Catch::Contains("time was over before the mesh was improved to the end") &&
                              Catch::Contains("--max-volume") && Catch::Contains("give more --seconds"));
  REQUIRE(made.regions.size() == 1);
  CHECK(made.regions[0].volume == 1);
  CHECK(made.mesh.tetrahedra.size() > 12);
}

TEST_CASE("where there is no mesh when time is over, that is an error", "[deadline][errors]") {
  SurfaceOptions options;
  options.seconds = 1;
  options.overall = 1e-4;
  options.max_points = 1'000'000'000;
  // The refinement and the clock end it at about the same time.
  CHECK_THROWS_WITH(surface_triangles(result_of(kBlock), options),
                    Catch::Contains(" 1 seconds") && Catch::Contains("give more --seconds"));
  // Constrained tetrahedra of a ball with many facets.
  TetrahedraOptions many;
  many.seconds = 1;
  many.constrained = true;
  const Result ball = result_of("  model: {sphere: {center: [0, 0, 0], radius: 1, segments: 600}}\n");
  CHECK_THROWS_WITH(tetrahedra(ball, many),
                    Catch::StartsWith("there is no mesh after 1 seconds, which ended in the stage `") &&
                        Catch::EndsWith("a larger --size, --quality or --max-volume"));
}

TEST_CASE("every stage hears of a stop", "[deadline]") {
  const Result result = result_of(kRound);
  TetrahedraOptions options;
  SECTION("TetGen") {}
  SECTION("constrained") { options.constrained = true; }
  SECTION("constrained, with sizes") {
    options.constrained = true;
    options.size = 1;
  }
  stop_everywhere([&](const Watch& watch) {
    TetrahedraOptions asked = options;
    asked.watch = watch;
    tetrahedra(result, asked);
  });
}

TEST_CASE("every stage of bending hears of a stop", "[deadline][curved]") {
  const Result result = result_of(kRound);
  const TetrahedralMesh straight = tetrahedra(result, {.quality = 2});
  stop_everywhere([&](const Watch& watch) {
    TetrahedralMesh made = straight;
    curve(result.data().view(true), made, watch);
  });
}

TEST_CASE("every stage of a surface mesh hears of a stop", "[deadline]") {
  const Result result = result_of(kRound);
  stop_everywhere([&](const Watch& watch) {
    SurfaceOptions asked;
    asked.overall = 0.5;
    asked.quads = true;
    asked.watch = watch;
    surface_triangles(result, asked);
  });
}
