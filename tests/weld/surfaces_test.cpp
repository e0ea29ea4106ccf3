// Round surfaces that are meant to be one and differ in their last digits: welded, a tree has what the same tree
// has with equal numbers.
#include <algorithm>
#include <cmath>
#include <random>

#include "csg/evaluate/evaluate.h"
#include "csg/leaves/leaf.h"
#include "csg/operators/node_value.h"
#include "csg/weld/round_carriers.h"
#include "csg/weld/weld_surfaces.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

Evaluation weld_run(const std::string& text) {
  EvaluateOptions options;
  options.validate = true;
  return evaluate(parse_tree("cnrg: 1\n" + text, "t.yaml"), options);
}

struct SurfaceCounts {
  std::array<std::size_t, 4> cells;
  std::size_t regions;
  double volume;
  friend bool operator==(const SurfaceCounts& a, const SurfaceCounts& b) {
    // Axes that are tilted a little begin their turns elsewhere: other facets of the same surfaces.
    return a.cells == b.cells && a.regions == b.regions && std::abs(a.volume - b.volume) < 0.1;
  }
};
std::ostream& operator<<(std::ostream& out, const SurfaceCounts& c) {
  for (const std::size_t n : c.cells) out << n << ' ';
  return out << "regions " << c.regions << " volume " << c.volume;
}
SurfaceCounts surface_counts(const std::string& text) {
  const Evaluation evaluation = weld_run(text);
  const NodeRow& row = evaluation.rows.back();
  return {row.cells, row.regions, row.volume() ? to_double(*row.volume()) : 0};
}

std::string notices(const std::string& text) {
  std::string all;
  for (const Diagnostic& d : weld_run(text).diagnostics) all += d.message + "\n";
  return all;
}

std::string weld_failure(const std::string& text) {
  try {
    weld_run(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

/// Numbers after a `~` are off by noise.
std::string near(const std::string& text, double size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> noise(-size, size);
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '~') {
      result += text[i];
      continue;
    }
    std::size_t used = 0;
    const double value = std::stod(text.substr(i + 1), &used);
    i += used;
    char number[40];
    std::snprintf(number, sizeof number, "%.17g", value + (size == 0 ? 0 : noise(random)));
    result += number;
  }
  return result;
}

const std::vector<std::pair<const char*, const char*>> kScenes = {
    {"shaft in its bore",
     "nodes:\n"
     "  block: {box: {min: [-2, -2, 0], max: [2, 2, 4]}}\n"
     "  bore:  {cylinder: {from: [~0, ~0, 0], to: [~0, ~0, 4], radius: ~1, segments: 32}}\n"
     "  shaft: {cylinder: {from: [~0, ~0, ~4], to: [~0, ~0, ~0], radius: ~1, segments: 24}}\n"
     "  both:  {union: [{difference: [block, bore]}, shaft], dominance: left}\n"
     "result: both\n"},
    {"pieces of one pin",
     "nodes:\n"
     "  a: {cylinder: {from: [~1, ~2, ~0], to: [~3, ~4, ~3], radius: ~1, segments: 12}}\n"
     "  b: {cylinder: {from: [~2, ~3, ~1.5], to: [~5, ~6, ~6], radius: ~1, segments: 20}}\n"
     "  all: {union: [a, b]}\n"
     "result: all\n"},
    {"ball less ball",
     "nodes:\n"
     "  a: {sphere: {center: [~1, ~0, ~0], radius: ~1, segments: 12}}\n"
     "  b: {sphere: {center: [~1, ~0, ~0], radius: ~1, segments: 10}, rotate: {axis: [1, 2, 3], degrees: 20, "
     "center: "
     "[1, 0, 0]}}\n"
     "  none: {difference: [a, b]}\n"
     "result: none\n"},
    {"torus less torus",
     "nodes:\n"
     "  a: {torus: {center: [~0, ~0, ~0], axis: [0, 0, ~1], radius: ~3, tube: ~1, segments: 12, rings: 8}}\n"
     "  b: {torus: {center: [~0, ~0, ~0], axis: [~0, ~0, ~1], radius: ~3, tube: ~1, segments: 16, rings: 6}}\n"
     "  none: {difference: [a, b]}\n"
     "result: none\n"},
    {"cone in its countersink",
     "nodes:\n"
     "  block: {box: {min: [-2, -2, 0], max: [2, 2, 4]}}\n"
     "  sink:  {cone: {from: [~0, ~0, 4], to: [~0, ~0, ~1], radius: ~1.5, segments: 16}}\n"
     "  cone:  {cone: {from: [~0, ~0, 4], to: [~0, ~0, ~1], radius: ~1.5, segments: 12}}\n"
     "  both:  {union: [{difference: [block, sink]}, cone], dominance: left}\n"
     "result: both\n"},
    {"ball in a pipe of its radius",
     "nodes:\n"
     "  block: {box: {min: [-2, -2, 0], max: [2, 2, 4]}}\n"
     "  bore:  {cylinder: {from: [~0, ~0, 0], to: [~0, ~0, 4], radius: ~1, segments: 16}}\n"
     "  ball:  {sphere: {center: [~0, ~0, ~2], radius: ~1, segments: 12}}\n"
     "  touch: {intersection: [{difference: [block, bore]}, ball]}\n"
     "result: touch\n"},
    {"cap on a pin",
     "nodes:\n"
     "  pin:  {cylinder: {from: [~0, ~0, 0], to: [~0, ~0, ~2], radius: ~1, segments: 16}}\n"
     "  ball: {sphere: {center: [~0, ~0, ~2], radius: ~1, segments: 12}}\n"
     "  cap:  {difference: [ball, pin]}\n"
     "result: cap\n"},
    {"corner of a rounded box",
     "nodes:\n"
     "  ball: {sphere: {center: [~0, ~0, ~0], radius: ~1, segments: 12}}\n"
     "  x: {cylinder: {from: [-2, ~0, ~0], to: [~0, ~0, ~0], radius: ~1, segments: 12}}\n"
     "  y: {cylinder: {from: [~0, -2, ~0], to: [~0, ~0, ~0], radius: ~1, segments: 16}}\n"
     "  all: {union: [ball, x, y]}\n"
     "result: all\n"},
    {"stepped hole by revolve",
     "nodes:\n"
     "  hole: {revolve: {profile: [[0, 0], [~1, 0], [~1, ~2], [~2, ~2], [~2, ~3], [0, ~3]], center: [~0, ~0, 0], "
     "segments: 12}}\n"
     "  bolt: {revolve: {profile: [[0, 0], [~1, 0], [~1, ~2], [~2, ~2], [~2, ~3], [0, ~3]], center: [~0, ~0, 0], "
     "segments: 16}}\n"
     "  none: {difference: [bolt, hole]}\n"
     "result: none\n"},
};

TEST_CASE("round surfaces that are nearly one are one where the tree is welded", "[weld][surfaces]") {
  for (const auto& [name, text] : kScenes) {
    CAPTURE(name);
    const SurfaceCounts exact = surface_counts(near(text, 0, 1));
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      CAPTURE(seed);
      CHECK(surface_counts("weld: 1e-9\n" + near(text, 1e-12, seed)) == exact);
      CHECK(surface_counts("weld: 1e-6\n" + near(text, 1e-15, seed)) == exact);
    }
    CHECK(surface_counts("weld: 1e-9\n" + near(text, 0, 1)) == exact);
  }
}

/// A pin of radius 1 in pins a little wider, in any order.
std::string pins(const std::vector<std::string>& radii) {
  std::string text = "nodes:\n  all: {union: [";
  for (const std::string& r : radii)
    text += "{cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: " + r + ", segments: 12}}, ";
  return text + "]}\nresult: all\n";
}

TEST_CASE("chains of radii are cut at their widest links, in any order of leaves", "[weld][surfaces]") {
  std::vector<std::string> radii{"1", "1.0000004", "1.0000009", "1.000001"};
  // 0.1 and 0.4 of the length are joined; from there it would be 1.0, which fits, and 0.5 with it.
  CHECK(surface_counts("weld: 1e-6\n" + pins(radii)) == surface_counts(pins({"1", "1"})));
  // With less, both pairs are, and the two pairs stay apart.
  std::sort(radii.begin(), radii.end());
  std::optional<std::string> first;
  do {
    const std::string text = "weld: 0.9e-6\n" + pins(radii);
    const Evaluation evaluation = weld_run(text);
    const std::string volume = to_decimal(*evaluation.rows.back().volume(), 20);
    if (!first) first = volume;
    CHECK(volume == *first);
    CHECK_THAT(notices(text),
               Contains("round surfaces of 2 leaves joined with others, moved by 4e-07 at most; 1 pair "
                        "of round surfaces is near but not joined"));
  } while (std::next_permutation(radii.begin(), radii.end()));
}

TEST_CASE("what is farther apart than the length stays apart", "[weld][surfaces]") {
  const std::string text = pins({"1", "1.0000011"});
  CHECK(surface_counts("weld: 1e-6\n" + text) == surface_counts(text));
  CHECK_THAT(notices("weld: 1e-6\n" + text), !Contains("joined"));
}

TEST_CASE("axes that are tilted count as far apart as they are at the ends", "[weld][surfaces]") {
  const auto pair = [](const char* end) {
    return std::string(
               "nodes:\n  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 12}}\n"
               "  b: {cylinder: {from: [0, 0, 0], to: [") +
           end + ", 0, 4], radius: 1, segments: 16}}\n  rest: {difference: [a, b]}\nresult: rest\n";
  };
  CHECK(weld_run("weld: 1e-9\n" + pair("4e-13")).rows.back().regions == 0);
  CHECK(weld_run("weld: 1e-9\n" + pair("6e-10")).rows.back().regions == 0);
  CHECK_THAT(notices("weld: 1e-9\n" + pair("2e-9")), !Contains("round surfaces"));
}

TEST_CASE("leaves that the tree turns and mirrors are welded where it places them", "[weld][surfaces]") {
  const auto text = [](const char* radius) {
    return std::string("nodes:\n  bore: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 16}}\n") +
           "  shaft: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: " + radius +
           ", segments: 12}, mirror: {normal: [0, 0, 1]}, scale: 2, translate: [0, 0, 4]}\n"
           "  rest: {difference: [shaft, bore], rotate: {axis: [1, 2, 3], degrees: 33}, translate: [1, 2, 3]}\n"
           "result: rest\n";
  };
  CHECK(weld_run(text("0.5")).rows.back().regions == 0);
  CHECK(weld_run("weld: 1e-9\n" + text("0.500000000001")).rows.back().regions == 0);
  CHECK(weld_run("weld: 1e-9\n" + text("0.499999999999")).rows.back().regions == 0);
}

TEST_CASE("a wall that is thinner than the length is refused by name", "[weld][surfaces]") {
  const std::string text =
      "nodes:\n"
      "  pipe: {revolve: {profile: [[1, 0], [1.0000001, 0], [1.0000001, 2], [1, 2]], segments: 8}}\n"
      "  pin:  {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 8}}\n"
      "  all:  {union: [pipe, pin]}\nresult: all\n";
  CHECK(weld_failure("weld: 1e-9\n" + text) == "no error");
  CHECK_THAT(weld_failure("weld: 1e-6\n" + text),
             Contains("of `pipe` would vanish") && Contains("give a smaller length"));
  const std::string ring =
      "nodes:\n"
      "  ring: {torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 1, tube: 0.9999999, segments: 8, rings: 6}}\n"
      "  half: {difference: [ring, {box: {min: [-3, -3, 0], max: [3, 3, 3]}}]}\nresult: half\n";
  CHECK_THAT(weld_failure("weld: 1e-6\n" + ring), Contains("of `ring` would vanish"));
}

// --- the rule itself

using welding::RoundPart;
using welding::RoundPlace;
using welding::RoundWeld;

RoundPart cylinder(const RationalPoint& from, const RationalPoint& to, const Rational& radius) {
  RoundPart part;
  part.axis = axis_line(from, to - from);
  part.ends = {part.axis.place_of(from), part.axis.place_of(to)};
  part.places = {part.ends[0], part.ends[1]};
  part.reach = radius;
  part.radii = {radius};
  return part;
}
RoundPart ball(const RationalPoint& center, const Rational& radius) {
  RoundPart part;
  part.ball = true;
  part.center = center;
  part.reach = radius;
  part.radii = {radius};
  return part;
}

bool same(const RoundPlace& a, const RoundPlace& b) {
  return a.center == b.center && a.axis == b.axis && a.radii == b.radii && a.places == b.places;
}

TEST_CASE("nothing moves farther than the length, and the order of parts does not matter", "[weld][surfaces]") {
  std::mt19937_64 random(7);
  const Rational d = fraction(1, 1000);
  const auto off = [&](int most) {
    return fraction(static_cast<long>(random() % static_cast<std::uint64_t>(2 * most + 1)) - most, 10000);
  };
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const int noise = 1 + round % 8;  // tenths of the length
    std::vector<RoundPart> parts;
    for (int i = 0; i < 8; ++i) {
      const Rational x = static_cast<long>(random() % 2) * 3 + off(noise), y = off(noise), z = off(noise);
      const Rational radius = 1 + off(noise);
      if (i % 3 == 0) parts.push_back(ball({x, y, z + static_cast<long>(random() % 2)}, radius));
      else parts.push_back(cylinder({x, y, z}, {x + off(1), y + off(1), z + 2}, radius));
    }
    const RoundWeld made = welding::weld_round(parts, d);
    std::vector<std::size_t> order(parts.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<RoundPart> shuffled;
    for (const std::size_t i : order) shuffled.push_back(parts[i]);
    const RoundWeld again = welding::weld_round(shuffled, d);
    CHECK(again.left.size() == made.left.size());
    for (std::size_t k = 0; k < order.size(); ++k) CHECK(same(again.parts[k], made.parts[order[k]]));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const RoundPart& was = parts[i];
      const RoundPlace& is = made.parts[i];
      CHECK(is.moved <= d);
      const Rational radius = is.radii.at(was.radii[0]);
      if (was.ball) {
        const RationalPoint by = is.center - was.center;
        const Rational room = d - abs(radius - was.radii[0]);
        CHECK(dot(by, by) <= room * room);
        continue;
      }
      // Of both rims, in eight directions.
      for (const Rational& t : was.places) {
        const RationalPoint from = was.axis.foot + t * was.axis.direction;
        const RationalPoint to = is.axis.foot + is.places.at(t) * is.axis.direction;
        for (int k = 0; k < 8; ++k) {
          const double a = 0.785398163 * k;
          const auto rim = [&](const AxisLine& axis, const RationalPoint& c, const Rational& r) {
            const auto n = to_doubles(axis.direction);
            const double length = std::hypot(n[0], n[1], n[2]);
            // Across x and y, made perpendicular.
            std::array<double, 3> e{std::cos(a), std::sin(a), 0};
            const double part = (e[0] * n[0] + e[1] * n[1]) / length / length;
            for (std::size_t i2 = 0; i2 < 3; ++i2) e[i2] -= part * n[i2];
            const double size = std::hypot(e[0], e[1], e[2]);
            auto p = to_doubles(c);
            for (std::size_t i2 = 0; i2 < 3; ++i2) p[i2] += to_double(r) * e[i2] / size;
            return p;
          };
          const auto p = rim(was.axis, from, was.radii[0]), q = rim(is.axis, to, radius);
          CHECK(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) <= to_double(d) * (1 + 1e-9));
        }
      }
    }
  }
}

}  // namespace
}  // namespace cnrg
