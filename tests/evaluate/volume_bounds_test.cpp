// Volumes of curved solids beside their true ones: within the bound, and not far below it.
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/text/number.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

constexpr double kHalfCircle = std::numbers::pi;

struct Known {
  std::string node;
  double volume = 0;
};

NodeRow only_row(const std::string& node) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n  a: {" + node + "}\nresult: a\n", "t.yaml");
  return evaluate(tree, {}).rows.back();
}

/// `most_ratio`: of the bound to what is off, as it was measured for 8 to 48 segments, for bounds that say
/// something.
void check_known(const Known& known, double most_ratio) {
  INFO(known.node);
  const NodeRow row = only_row(known.node);
  const std::optional<double> bound = row.volume_bound();
  REQUIRE(bound);
  const double off = std::abs(to_double(*row.volume()) - known.volume);
  CHECK(off <= *bound + 1e-12 * known.volume);
  CHECK(*bound <= most_ratio * off);
}

double lens_volume(double d) { return kHalfCircle * (2 - d) * (2 - d) * (d * d + 4 * d) / (12 * d); }

}  // namespace

TEST_CASE("the true volume of a curved solid is within the bound of its facets", "[volume]") {
  std::mt19937 random(456);
  for (int trial = 0; trial < 12; ++trial) {
    const int segments = 8 + static_cast<int>(random() % 40);
    const std::string s = ", segments: " + std::to_string(segments),
                      turn = "rotate: {axis: [1, 2, 3], degrees: " + std::to_string(random() % 360) + "}";
    check_known({"sphere: {center: [1, 2, 3], radius: 2" + s + "}, " + turn, 32 * kHalfCircle / 3}, 8);
    check_known({"sphere: {center: [0, 0, 0], radius: 1" + s + "}, scale: [1, 2, 3]", 8 * kHalfCircle}, 8);
    check_known({"cylinder: {from: [0, 0, 0], to: [1, 2, 2], radius: 2" + s + "}, " + turn, 12 * kHalfCircle}, 2);
    check_known({"cone: {from: [0, 0, 0], to: [1, 2, 2], radius: 2, top: 1" + s + "}, " + turn, 7 * kHalfCircle},
                6);
    check_known({"cone: {from: [0, 0, 0], to: [1, 2, 2], radius: 2" + s + "}, " + turn, 4 * kHalfCircle}, 6);
    check_known({"torus: {center: [0, 1, 0], axis: [1, 1, 1], radius: 3, tube: 1" + s + "}",
                 6 * kHalfCircle * kHalfCircle},
                16);
    const double d = 1 + (random() % 900) / 1000.0;
    const std::string two = "[{sphere: {center: [0, 0, 0], radius: 1" + s + "}}, {sphere: {center: [" +
                            std::to_string(d) + ", 0, 0], radius: 1" + s + "}, " + turn + "}]";
    check_known({"intersection: " + two, lens_volume(std::stod(std::to_string(d)))}, 60);
    check_known({"union: " + two, 8 * kHalfCircle / 3 - lens_volume(std::stod(std::to_string(d)))}, 10);
    check_known(
        {"difference: [{box: {min: [0, 0, 0], max: [2, 2, 2]}}, {cylinder: {from: [1, 1, -9], to: [1, 1, 30], "
         "radius: 0.5" +
             s + "}}]",
         8 - kHalfCircle / 2},
        5);
  }
}

TEST_CASE("a volume without curved surfaces has the bound 0, one of a curve that the others cut off, too",
          "[volume]") {
  CHECK(only_row("box: {min: [0, 0, 0], max: [1, 2, 3]}").volume_bound() == 0.0);
  CHECK(only_row("difference: [{box: {min: [0, 0, 0], max: [1, 1, 1]}}, {sphere: {center: [5, 5, 5], radius: 1}}]")
            .volume_bound() == 0.0);
}

TEST_CASE("a bound is shown in three digits, rounded up", "[volume]") {
  CHECK(bound_text(0.0).empty());
  CHECK(bound_text(std::nullopt) == "unknown");
  CHECK(bound_text(35.52) == "35.6");
  CHECK(bound_text(1.2345e-7) == "1.24e-07");
  CHECK(bound_text(9.999) == "10");
  for (const double x : {1.0, 0.1, 123.0, 99.95, 1e-300, 7.77e9}) {
    CHECK(std::stod(bound_text(x)) >= x);
    CHECK(std::stod(bound_text(x)) <= 1.02 * x);
  }
}

}  // namespace cnrg
