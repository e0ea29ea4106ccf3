// Tetrahedra as foretold and as made.
#include "csg/mesh/forecast.h"

#include <cmath>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/mesh/result_of.h"

using namespace cnrg;

namespace {

struct Model {
  const char* name;
  std::string nodes;
  double size, growth;
};

const std::string kTunnel = R"(
  rock:   {box: {min: [0, 0, 0], max: [40, 40, 40]}, size: 10}
  tunnel: {cylinder: {from: [20, -1, 20], to: [20, 41, 20], radius: 4, segments: 24}, size: 2}
  model:  {difference: [rock, tunnel]}
)";
const std::string kLayers = R"(
  low:   {box: {min: [0, 0, 0], max: [4, 4, 2]}}
  high:  {box: {min: [0, 0, 2], max: [4, 4, 4]}, size: 1/4}
  bolt:  {polyline: [[1, 1, 1], [1, 1, 5]], size: 1/8}
  model: {union: [bolt, low, high], dominance: left}
)";

const std::vector<Model>& models() {
  static const std::vector<Model> all{
      {"block, coarse", kBlock, 0.2, 0.3},
      {"block, fine", kBlock, 0.06, 0.3},
      {"ball", "  model: {sphere: {center: [0, 0, 0], radius: 1, segments: 24}}\n", 0.2, 0.3},
      {"ball, by its facets", "  model: {sphere: {center: [0, 0, 0], radius: 1, segments: 32}}\n", 1, 0.3},
      {"tunnel", kTunnel, 0, 0.3},
      {"tunnel, gentle", kTunnel, 0, 0.15},
      {"tunnel, steep", kTunnel, 0, 1},
      {"layers and a bolt", kLayers, 0, 0.3},
      {"layers, overall", kLayers, 0.3, 0.5},
      {"plate", "  model: {box: {min: [0, 0, 0], max: [8, 8, 1/2]}}\n", 0.4, 0.3},
      {"turned plate",
       "  model: {box: {min: [0, 0, 0], max: [8, 8, 1/2]}, rotate: {axis: [1, 2, 0], degrees: 40}}\n", 0.4, 0.3},
      {"thin plate", "  model: {box: {min: [0, 0, 0], max: [8, 8, 1/10]}}\n", 0.5, 0.3},
      {"rod", "  model: {cylinder: {from: [0, 0, 0], to: [20, 0, 0], radius: 1, segments: 32}}\n", 1, 0.3},
      {"shell", R"(
  shell:  {sphere: {center: [0, 0, 0], radius: 4, segments: 32}}
  cavity: {sphere: {center: [0, 0, 0], radius: 3, segments: 32}}
  model:  {difference: [shell, cavity]}
)",
       0.5, 0.3},
      {"notch", R"(
  block: {box: {min: [0, 0, 0], max: [8, 8, 8]}}
  notch: {box: {min: [4, 4, 7], max: [4.25, 4.25, 9]}}
  model: {difference: [block, notch]}
)",
       2, 0.3},
      {"fine point in a block",
       "  block: {box: {min: [0, 0, 0], max: [8, 8, 8]}}\n  probe: {points: [[3, 4, 5]], size: 1/50}\n"
       "  model: {union: [probe, block], dominance: left}\n",
       2, 0.4},
  };
  return all;
}

TetrahedraOptions sizes(double size, double growth) {
  TetrahedraOptions options;
  options.size = size;
  options.growth = growth;
  return options;
}

void check_close(const MeshForecast& told, double made) {
  CHECK(told.least < made);
  CHECK(made < told.most);
  CHECK(told.most < 10 * told.least);  // a range that says something
}

/// A sheet that rises from an edge of a block's floor to such a height.
std::string wedge(const std::string& height) {
  return "  sheet: {polygon: [[0, 0, 0], [10, 0, " + height + "], [10, 10, " + height +
         "], [0, 10, 0]]}\n  block: {box: {min: [0, 0, 0], max: [10, 10, 10]}}\n"
         "  model: {union: [sheet, block], dominance: left}\n";
}

}  // namespace

TEST_CASE("the tetrahedra that are made lie in the range that is foretold", "[size][forecast]") {
  const bool constrained = GENERATE(false, true);
  for (const Model& model : models()) {
    TetrahedraOptions options = sizes(model.size, model.growth);
    options.constrained = constrained;
    MeshForecast told;
    options.foretold = [&](const MeshForecast& mesh) { told = mesh; };
    const TetrahedralMesh made = tetrahedra(result_of(model.nodes), options);
    std::size_t count = 0;
    for (const RegionTetrahedra& region : made.regions) count += region.tetrahedra;
    INFO(model.name << (constrained ? ", constrained: " : ": ") << told.tetrahedra << " foretold, " << count
                    << " made");
    CHECK(made.notice.empty());
    CHECK(told.tetrahedra == made.expected);
    check_close(told, double(count));
  }
}

TEST_CASE("a thin slab and a sheet that leaves its region: constrained, no more than is foretold, and none is bad",
          "[size][forecast]") {
  TetrahedraOptions options = sizes(1.43, 0.3);
  options.constrained = true;
  MeshForecast told;
  options.foretold = [&](const MeshForecast& mesh) { told = mesh; };
  const TetrahedralMesh made = tetrahedra(result_of(R"(
  slab:  {box: {min: [-0.5, 7.88, -0.5], max: [10.5, 7.91, 10.5]}}
  sheet: {polygon: [[1.5, 4.6, 1.5], [8.5, 4.6, 1.5], [8.5, 4.6, 8.5], [1.5, 4.6, 8.5]]}
  block: {box: {min: [1.53, 0.06, 2.04], max: [8.47, 9.94, 7.96]}}
  model: {union: [slab, sheet, block], dominance: left}
)"),
                                          options);
  const auto count = double(made.mesh.tetrahedra.size());
  INFO(told.tetrahedra << " foretold, " << count << " made");
  CHECK(made.quality.bad == 0);
  check_close(told, count);
}

namespace {

/// What is foretold of a mesh, and how many tetrahedra it has.
std::pair<MeshForecast, double> told_and_made(const std::string& nodes, TetrahedraOptions options) {
  MeshForecast told;
  options.foretold = [&](const MeshForecast& mesh) { told = mesh; };
  const TetrahedralMesh made = tetrahedra(result_of(nodes), options);
  CHECK(made.expected == told.tetrahedra);
  return {told, double(made.mesh.tetrahedra.size())};
}

double volume_of_model(const Model& model) {
  double volume = 0;
  for (const RegionTetrahedra& region : tetrahedra(result_of(model.nodes), {}).regions)
    volume += to_double(region.volume);
  return volume;
}

}  // namespace

TEST_CASE("what lies between a wall and a face beside it is foretold", "[size][forecast]") {
  // A tenth and an eightieth of the edges elsewhere, where nobody has asked for short ones.
  for (const char* x : {"79/10", "159/20"}) {
    const std::string nodes =
        std::string("  block: {box: {min: [0, 0, 0], max: [8, 8, 8]}}\n  wall: {polygon: [[") + x +
        ", -1, -1], [" + x + ", 9, -1], [" + x + ", 9, 9], [" + x +
        ", -1, 9]]}\n  model: {union: [wall, block], dominance: left}\n";
    const auto [told, made] = told_and_made(nodes, sizes(x == std::string("79/10") ? 1 : 4, 0.3));
    INFO(told.tetrahedra << " foretold, " << made << " made");
    check_close(told, made);
  }
}

TEST_CASE("thin parts and what edges grow from there are foretold, whatever is asked for", "[size][forecast]") {
  // A slab alone, one inside of a block, a sheet that ends beside a face, a slab beside one.
  const std::string block = "  block: {box: {min: [0, 0, 0], max: [10, 10, 10]}}\n";
  const std::string both = block + "  model: {union: [thin, block], dominance: left}\n";
  for (const std::string& nodes :
       {std::string("  model: {box: {min: [0, 0, 0], max: [10, 10, 1/10]}}\n"),
        "  thin: {box: {min: [2, 2, 4], max: [7, 7, 41/10]}}\n" + both,
        "  thin: {polygon: [[1, 1, 9.9], [9, 1, 9.9], [9, 9, 9.9], [1, 9, 9.9]]}\n" + both,
        "  thin: {box: {min: [2, 2, 2], max: [8, 8, 9.9]}}\n" + both}) {
    const int ask = GENERATE(1, 2, 3);
    TetrahedraOptions options;
    if (ask == 1) options.size = 1;
    if (ask == 2) options.quality = 2;
    if (ask == 3) options.max_volume = 1;
    const auto [told, made] = told_and_made(nodes, options);
    INFO(nodes << ask << ": " << told.least << " to " << told.most << " foretold, " << made << " made");
    check_close(told, made);
  }
}

TEST_CASE("a wedge takes no more for being thin where its faces meet", "[size][forecast]") {
  for (const char* z : {"9/5", "3"}) {
    const auto [told, made] = told_and_made(wedge(z), sizes(1, 0.3));
    INFO(z << ": " << told.tetrahedra << " foretold, " << made << " made");
    check_close(told, made);
  }
}

TEST_CASE("a wedge takes no more however thin it is", "[size][forecast]") {
  for (const char* z : {"9/10", "2/5"}) {
    const auto [told, made] = told_and_made(wedge(z), sizes(2, 0.3));
    INFO(z << ": " << told.tetrahedra << " foretold, " << made << " made");
    check_close(told, made);
  }
}

TEST_CASE("lengths that grow as fast as can be are foretold", "[size][forecast]") {
  const auto [told, made] = told_and_made(
      "  block: {box: {min: [0, 0, 0], max: [10, 10, 10]}}\n"
      "  wire: {polyline: [[2, 3, 4], [8, 7, 6]], size: 1/10}\n"
      "  model: {union: [wire, block], dominance: left}\n",
      sizes(5, 2));
  INFO(told.tetrahedra << " foretold, " << made << " made");
  check_close(told, made);
}

TEST_CASE("constrained slabs whose sides ask for nothing are foretold", "[size][forecast]") {
  TetrahedraOptions options = sizes(0.5, 0.3);
  options.constrained = true;
  const auto [told, made] = told_and_made("  model: {box: {min: [0, 0, 0], max: [2.5, 2, 1/1000]}}\n", options);
  INFO(told.tetrahedra << " foretold, " << made << " made");
  check_close(told, made);
}

TEST_CASE("constrained tetrahedra come to a quality by sizes, and are foretold", "[forecast]") {
  for (const Model& model : models()) {
    const std::string name = model.name;
    if (name != "ball" && name != "shell" && name != "notch" && name != "rod") continue;
    TetrahedraOptions options;
    options.constrained = true;
    options.quality = GENERATE(1.4, 2.0);
    MeshForecast told;
    options.foretold = [&](const MeshForecast& mesh) { told = mesh; };
    const TetrahedralMesh made = tetrahedra(result_of(model.nodes), options);
    const auto n = double(made.mesh.tetrahedra.size());
    INFO(name << ", " << options.quality << ": " << told.least << " to " << told.most << ", made " << n);
    CHECK(told.least < n);
    CHECK(n < told.most);
    CHECK(double(made.quality.beyond) < 0.25 * n);
    if (options.quality == 2) CHECK(made.notice.empty());  // at 1.4 halves may be in vain
  }
}

TEST_CASE("what a bound of volumes makes is foretold", "[forecast]") {
  for (const Model& model : models()) {
    if (model.nodes.find("size:") != std::string::npos) continue;
    TetrahedraOptions options;
    options.max_volume = volume_of_model(model) / 10'000;
    const auto [told, made] = told_and_made(model.nodes, options);
    INFO(model.name << ": " << told.tetrahedra << " foretold, " << made << " made");
    check_close(told, made);
    CHECK(told.bytes > 300 * made);
    CHECK(told.seconds > 0);
  }
  // With sizes the finer one of both counts.
  TetrahedraOptions both;
  both.size = 0.2;
  both.max_volume = 1e-4;
  const auto [told, made] = told_and_made(kBlock, both);
  INFO(told.tetrahedra << " foretold, " << made << " made");
  check_close(told, made);
}

TEST_CASE("what a bound of volumes makes of constrained tetrahedra is foretold", "[forecast]") {
  for (const Model& model : models()) {
    if (model.nodes.find("size:") != std::string::npos) continue;
    TetrahedraOptions options;
    options.constrained = true;
    options.max_volume = volume_of_model(model) / 10'000;
    const auto [told, made] = told_and_made(model.nodes, options);
    INFO(model.name << ": " << told.least << " to " << told.most << " foretold, " << made << " made");
    check_close(told, made);
  }
}

TEST_CASE("where only shapes are bounded the forecast is a wider range", "[forecast]") {
  for (const Model& model : models()) {
    if (std::string(model.name) != "ball" && std::string(model.name) != "shell") continue;
    TetrahedraOptions options;
    options.quality = GENERATE(1.2, 1.4, 2.0);
    const auto [told, made] = told_and_made(model.nodes, options);
    INFO(model.name << ", " << options.quality << ": " << told.least << " to " << told.most << ", made " << made);
    CHECK(told.least <= made);
    CHECK(made <= told.most);
    CHECK_THAT(forecast_text(told), Catch::StartsWith("from ") && Catch::Contains(", up to "));
  }
}

TEST_CASE("a forecast in words", "[forecast]") {
  CHECK(forecast_text({1'540'000, 1'078'000, 2'002'000, 616e6, 12.3}) ==
        "from 1,100,000 to 2,000,000 tetrahedra are expected, up to 620 MB of memory, 12 seconds");
  CHECK(forecast_text({10'000, 5'000, 15'000, 1.2e9, 100}) ==
        "from 5,000 to 15,000 tetrahedra are expected, up to 1 GB of memory, 2 minutes");
  CHECK(forecast_text({100, 70, 130, 40e6, 1e-3}) ==
        "from 70 to 130 tetrahedra are expected, up to 40 MB of memory, less than a second");
}

TEST_CASE("a mesh that the machine has no memory for is refused", "[forecast][errors]") {
  const MeshForecast mesh{1e7, 0.7e7, 1.3e7, 4.5e9, 100};
  CHECK_NOTHROW(require_possible(mesh, 8e9));
  CHECK_NOTHROW(require_possible(mesh, 4e9));  // the fewest that are expected have room
  CHECK_NOTHROW(require_possible(mesh, 0));
  CHECK_THROWS_WITH(require_possible(mesh, 2e9),
                    Catch::Contains("3 GB of memory at least, and the machine has 2 GB; ask for a larger --size"));
}

TEST_CASE("a forecast is the same each time", "[size][forecast]") {
  std::vector<double> told;
  TetrahedraOptions options = sizes(0.3, 0.5);
  options.foretold = [&](const MeshForecast& mesh) { told.push_back(mesh.tetrahedra); };
  for (int i = 0; i < 2; ++i) tetrahedra(result_of(kLayers), options);
  REQUIRE(told.size() == 2);
  CHECK(told[0] == told[1]);
}

TEST_CASE("more tetrahedra than memory holds are refused before they are made", "[size][forecast][errors]") {
  for (const auto& [nodes, size] : {std::pair(kBlock, 1e-4), std::pair(kBlock, 1e-30),
                                    std::pair(std::string("  model: {box: {min: [0, 0, 0], max: [1, 1, 1]}, "
                                                          "size: 1/10000}\n"),
                                              0.0)}) {
    TetrahedraOptions options = sizes(size, 0.3);
    options.foretold = [](const MeshForecast&) { FAIL("told as if it were made"); };
    try {
      tetrahedra(result_of(nodes), options);
      FAIL("made");
    } catch (const InputError& e) {
      CHECK_THAT(e.what(),
                 Catch::Contains("tetrahedra, and at most 200,000,000 are made; ask for a larger --size"));
    }
  }
}

TEST_CASE("a slab that good shapes would fill by billions is filled as flat as it is", "[size][forecast]") {
  const Result slab = result_of("  model: {box: {min: [0, 0, 0], max: [10, 10, 1/10000]}}\n");
  for (const bool sized : {false, true}) {
    for (const bool surface_first : {false, true}) {
      for (const bool bounded : {false, true}) {
        TetrahedraOptions options;
        if (sized) options.size = 1;
        if (bounded) options.max_volume = 1e-3;
        options.surface_first = surface_first;
        MeshForecast told;
        options.foretold = [&](const MeshForecast& mesh) { told = mesh; };
        const TetrahedralMesh made = tetrahedra(slab, options);
        INFO(sized << surface_first << bounded << ": " << made.notice);
        CHECK_THAT(made.notice, Catch::Contains("very thin") || Catch::Contains("thinner than the triangles"));
        CHECK(made.mesh.tetrahedra.size() < 200'000);
        CHECK(double(made.mesh.tetrahedra.size()) < (told.most > 0 ? told.most : HUGE_VAL));
        if (bounded) CHECK(made.quality.larger == 0);
      }
    }
  }
  // Who says that he waits is refused what no machine makes.
  TetrahedraOptions options;
  options.quality = 2;
  options.seconds = 0;
  CHECK_THROWS_WITH(tetrahedra(slab, options), Catch::Contains("leave out --quality"));
}

TEST_CASE("where nothing is bounded the forecast is a wide range", "[forecast]") {
  for (const Model& model : models()) {
    if (model.nodes.find("size:") != std::string::npos) continue;
    for (const bool keep : {false, true}) {
      TetrahedraOptions options;
      options.keep_boundary = keep;
      const auto [told, made] = told_and_made(model.nodes, options);
      INFO(model.name << (keep ? ", kept: " : ": ") << told.least << " to " << told.most << ", made " << made);
      CHECK(told.least <= told.tetrahedra);
      CHECK(made <= told.most);
      if (keep) CHECK(told.least <= made);  // proven: each has four sides
      CHECK_THAT(forecast_text(told), Catch::StartsWith("from ") && Catch::Contains(", up to "));
    }
  }
}

TEST_CASE("what is asked for with kept faces is a range from what these take", "[size][forecast]") {
  const auto ask = GENERATE(1, 2, 3);
  for (const Model& model : models()) {
    if (std::string(model.name) != "ball" && std::string(model.name) != "plate" &&
        std::string(model.name) != "block, coarse")
      continue;
    TetrahedraOptions options;
    options.keep_boundary = true;
    if (ask == 1) options.size = model.size;
    if (ask == 2) options.quality = 1.4;
    if (ask == 3) options.max_volume = 1e-2;
    const auto [told, made] = told_and_made(model.nodes, options);
    INFO(model.name << ": " << told.least << " to " << told.most << ", made " << made);
    CHECK(told.least <= made);
    CHECK(made <= told.most);
  }
}

TEST_CASE("what is larger than asked for since faces are kept is told", "[mesh][size]") {
  TetrahedraOptions options;
  options.keep_boundary = true;
  options.max_volume = 0.01;
  const TetrahedralMesh made = tetrahedra(result_of(kBlock), options);
  CHECK(made.quality.larger == made.mesh.tetrahedra.size());
  CHECK_THAT(made.notice,
             Catch::StartsWith(std::to_string(made.quality.larger) + " tetrahedra are larger than "
                                                                     "--max-volume, the largest 0.") &&
                 Catch::Contains("leave out --keep-boundary"));
  options.keep_boundary = false;
  CHECK(tetrahedra(result_of(kBlock), options).notice.empty());
  options.max_volume = 1;
  options.keep_boundary = true;
  CHECK(tetrahedra(result_of(kBlock), options).notice.empty());
}

TEST_CASE("sizes that kept faces leave no room for are told", "[mesh][size]") {
  TetrahedraOptions options = sizes(0.1, 0.3);
  options.keep_boundary = true;
  CHECK_THAT(tetrahedra(result_of(kBlock), options).notice,
             Catch::Contains("tetrahedra have an edge of more than 1.4 times the size that is asked for") &&
                 Catch::Contains("leave out --keep-boundary"));
  options.size = 2;
  CHECK(tetrahedra(result_of(kBlock), options).notice.empty());
}

TEST_CASE("constrained tetrahedra have sizes, too", "[size]") {
  TetrahedraOptions options;
  options.constrained = true;
  options.size = 0.2;
  const TetrahedralMesh made = tetrahedra(result_of(kBlock), options);
  CHECK(made.notice.empty());
  CHECK(double(made.mesh.tetrahedra.size()) > 0.7 * made.expected);
  CHECK(double(made.mesh.tetrahedra.size()) < 1.3 * made.expected);
  std::size_t longer = 0, all = 0;
  for (const auto& t : made.mesh.tetrahedra) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t l = 0; l < k; ++l, ++all) {
        double squares = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const double d = made.mesh.points[t.points[k]][i] - made.mesh.points[t.points[l]][i];
          squares += d * d;
        }
        longer += squares > 0.32 * 0.32;
      }
    }
  }
  CHECK(longer * 50 < all);
}

TEST_CASE("counts are rounded for people", "[size][forecast]") {
  CHECK(count_text(0.4) == "about 0");
  CHECK(count_text(12.4) == "about 12");
  CHECK(count_text(1234) == "about 1,230");
  CHECK(count_text(2e8) == "about 200,000,000");
  CHECK(count_text(1e300) == "more than 1,000,000,000,000,000");
  CHECK(count_text(std::nan("")) == "more than 1,000,000,000,000,000");
}
