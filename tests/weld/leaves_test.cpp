// Trees that are welded: what is meant to touch does, whatever the order and the place of the leaves. Counts are
// those of the same tree without noise, which needs no weld.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Cells = std::array<std::size_t, 4>;

Evaluation run(const std::string& text, const std::string& file = "t.yaml") {
  EvaluateOptions options;
  options.validate = true;
  return evaluate(parse_tree("cnrg: 1\n" + text, file), options);
}

std::string failure(const std::string& text) {
  try {
    run(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

/// What stays the same when leaves change their order and place.
struct Counts {
  Cells cells, raw;
  std::size_t regions;
  friend bool operator==(const Counts&, const Counts&) = default;
};
std::ostream& operator<<(std::ostream& out, const Counts& c) {
  for (const std::size_t n : c.cells) out << n << ' ';
  out << "raw ";
  for (const std::size_t n : c.raw) out << n << ' ';
  return out << "regions " << c.regions;
}
Counts counts(const std::string& text) {
  const Evaluation evaluation = run(text);
  const NodeRow& row = evaluation.rows.back();
  return {row.cells, row.raw_cells, row.regions};
}

/// The whole result, exactly.
std::string result_text(const Evaluation& evaluation) {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("cnrg_weld_" + std::to_string(getpid()))).string() + ".json";
  write(file, evaluation.result());
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::filesystem::remove(file);
  return text;
}

std::string point(const std::array<double, 3>& p) {
  char text[100];
  std::snprintf(text, sizeof text, "[%.17g, %.17g, %.17g]", p[0], p[1], p[2]);
  return text;
}

/// Boxes between planes of a grid, some left out, some two or three cells long; `noise`: each of their six numbers
/// is off by that much at most.
std::string grid(std::uint64_t seed, double noise, const std::string& attributes) {
  std::mt19937_64 random(seed);
  std::mt19937_64 errors(seed + 1);
  std::uniform_real_distribution<double> error(-noise, noise);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
  std::array<std::vector<double>, 3> planes;
  for (auto& list : planes) {
    double at = below(7) * 0.1;
    for (int i = 0; i < 5; ++i) list.push_back(at), at += 0.3 + below(9) * 0.1;
  }
  std::vector<std::string> boxes;
  const std::size_t count = 3 + static_cast<std::size_t>(below(8));
  while (boxes.size() < count) {
    std::array<double, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = below(4), j = i + 1 + below(std::min(3, 4 - i));
      low[k] = planes[k][static_cast<std::size_t>(i)] + error(errors);
      high[k] = planes[k][static_cast<std::size_t>(j)] + error(errors);
    }
    boxes.push_back("{box: {min: " + point(low) + ", max: " + point(high) + "}" + attributes + "}");
  }
  std::shuffle(boxes.begin(), boxes.end(), errors);
  std::string text = "nodes:\n  all: {union: [";
  for (const std::string& box : boxes) text += box + ", ";
  return text + "]}\nresult: all\n";
}

TEST_CASE("boxes of a grid that are off by a quarter of the length make the grid", "[weld][random]") {
  const char* const seeds = std::getenv("CNRG_SEEDS");
  const std::uint64_t count = seeds != nullptr ? std::strtoull(seeds, nullptr, 10) : 30;
  const char* const from = std::getenv("CNRG_FIRST_SEED");
  const std::uint64_t first = from != nullptr ? std::strtoull(from, nullptr, 10) : 1;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    for (const std::string turn : {"", ", rotate: {axis: [1, 2, 3], degrees: 33}"}) {
      CAPTURE(seed, turn);
      const Counts exact = counts(grid(seed, 0, turn));
      CHECK(counts("weld: 1e-6\n" + grid(seed, 0.24e-6, turn)) == exact);
      CHECK(counts("weld: 1e-3\n" + grid(seed, 1e-14, turn)) == exact);
      CHECK(counts("weld: 1e-6\n" + grid(seed, 0, turn)) == exact);
    }
  }
}

const char* const kCubes = R"(  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {box: {min: [1.000000001, 0, 0], max: [2, 1, 1]}}
)";

TEST_CASE("two cubes with a gap below the length have one wall", "[weld]") {
  const std::string nodes = std::string("nodes:\n") + kCubes;
  const std::string turned =
      "nodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}, rotate: {axis: [1, 2, 2], degrees: 20}}\n"
      "  b: {box: {min: [1.000000001, 0, 0], max: [2, 1, 1]}, rotate: {axis: [1, 2, 2], degrees: 20}}\n";
  const std::string mirrored =
      "nodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}, mirror: {normal: [1, 2, 0]}}\n"
      "  b: {box: {min: [1.000000001, 0, 0], max: [2, 1, 1]}, mirror: {normal: [1, 2, 0]}}\n";
  for (const std::string& leaves : {nodes, turned, mirrored}) {
    for (const char* operands : {"[a, b]", "[b, a]", "[a, b, a]"}) {
      const std::string tree = leaves + "  u: {union: " + operands + "}\nresult: u\n";
      CHECK(counts(tree).raw == Cells{16, 24, 12, 2});
      CHECK(counts("weld: 1e-10\n" + tree).raw == Cells{16, 24, 12, 2});
      CHECK(counts("weld: 1e-6\n" + tree).raw == Cells{12, 20, 11, 2});
      CHECK(counts("weld: 1e-9\n" + tree).raw == Cells{12, 20, 11, 2});
    }
  }
  const Evaluation evaluation = run("weld: 1e-6\n" + nodes + "  u: {union: [a, b]}\nresult: u\n");
  CHECK(*evaluation.rows.back().volume() == 2);
  REQUIRE(evaluation.diagnostics.size() == 1);
  CHECK(evaluation.diagnostics[0].message ==
        "weld 0.000001: moved 4 points, by 1e-09 at most; 1 plane and 4 points joined with others");
  CHECK(evaluation.diagnostics[0].at.line == 2);
}

TEST_CASE("an overlap below the length is a contact, and an edge on a face lies on it", "[weld]") {
  const std::string overlapping = R"(nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {box: {min: [0.25, 0.25, 0.9999999], max: [0.5, 0.5, 2]}}
  u: {union: [a, b]}
result: u
)";
  CHECK(counts("weld: 1e-6\n" + overlapping).raw == Cells{16, 24, 12, 2});
  // A prism whose edge is above the top of a box: what they have in common is the edge.
  const std::string edge = R"(nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  b: {prism: {base: [[0.25, 0.5, 1.0000001], [0.25, 0, 2], [0.25, 1, 2]], vector: [0.5, 0, 0]}}
  i: {intersection: [a, b]}
result: i
)";
  CHECK(counts(edge).raw == Cells{0, 0, 0, 0});
  CHECK(counts("weld: 1e-6\n" + edge).raw == Cells{2, 1, 0, 0});
}

TEST_CASE("a weld of nothing near changes nothing", "[weld]") {
  const std::string tree = R"(nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}, rotate: {axis: [1, 2, 2], degrees: 20}}
  b: {cylinder: {from: [0, 0, 0], to: [1, 2, 3], radius: 0.7}}
  c: {sphere: {center: [1, 0, 0], radius: 1}}
  u: {union: [a, b, c]}
result: u
)";
  const Evaluation plain = run(tree), welded = run("weld: 1e-9\n" + tree);
  CHECK(welded.diagnostics.empty());
  CHECK(result_text(welded) == result_text(plain));
}

TEST_CASE("chains are cut at their widest links, in every order", "[weld]") {
  // Walls between slabs at 1, 1 + 4e-7, 1 + 8e-7, 1 + 13e-7: with 1e-6 the first three are one, the last is not.
  const auto slab = [](const std::string& from, const std::string& to, int y) {
    return "{box: {min: [" + from + ", " + std::to_string(y) + ", 0], max: [" + to + ", " + std::to_string(y + 1) +
           ", 1]}}";
  };
  std::vector<std::string> slabs{slab("0", "1", 0), slab("0", "1.0000004", 1), slab("0", "1.0000008", 2),
                                 slab("0", "1.0000013", 3)};
  std::sort(slabs.begin(), slabs.end());
  do {
    std::string tree = "weld: 1e-6\nnodes:\n  u: {union: [";
    for (const std::string& one : slabs) tree += one + ", ";
    const Evaluation evaluation = run(tree + "]}\nresult: u\n");
    const NodeRow& row = evaluation.rows.back();
    // Corners of the last two are near, too, and are joined: its wall is turned a little.
    CHECK(row.raw_cells == Cells{20, 36, 21, 4});
    REQUIRE(evaluation.diagnostics.size() == 1);
    CHECK_THAT(evaluation.diagnostics[0].message, Contains("near but not joined"));
    CHECK_THAT(evaluation.diagnostics[0].message, !Contains("leaf "));
  } while (std::next_permutation(slabs.begin(), slabs.end()));
}

TEST_CASE("a weld that would make something vanish is refused by name", "[weld]") {
  const std::string plate = "nodes:\n  plate: {box: {min: [0, 0, 0], max: [1, 1, 0.0001]}}\nresult: plate\n";
  CHECK(counts("weld: 1e-5\n" + plate).raw == Cells{8, 12, 6, 1});
  CHECK_THAT(failure("weld: 1e-3\n" + plate),
             Contains("t.yaml:4:11: error: weld: face ") && Contains("of `plate` would vanish") &&
                 Contains("within 0.001 of each other") && Contains("give a smaller length"));
  // A thin wedge, all of whose faces would stay.
  const std::string thin = R"(nodes:
  thin: {tetrahedron: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.3, 0.3, 0.0001]]}
result: thin
)";
  CHECK_THAT(failure("weld: 1e-3\n" + thin), Contains("weld: ") && Contains("`thin`"));
}

TEST_CASE("what is no length is refused with its place", "[weld]") {
  const std::string tree = std::string("nodes:\n") + kCubes + "result: a\n";
  CHECK_THAT(failure("weld: 0\n" + tree), Contains("t.yaml:2:7: error: `weld` of a tree file must be above 0"));
  CHECK_THAT(failure("weld: -1\n" + tree), Contains("must be above 0"));
  for (const char* leaf : {"mesh: {file: a.off", "step: {file: a.step", "brep: {file: a.brep"}) {
    CHECK_THAT(failure(std::string("nodes: {a: {") + leaf + ", weld: 0}}}\nresult: a\n"),
               Contains("error: `weld` of ") && Contains("must be above 0: give the length"));
  }
  CHECK_THAT(failure("weld: near\n" + tree),
             Contains("t.yaml:2:7: error: `weld` of a tree file: `near` is no number"));
}

TEST_CASE("curved leaves keep their parameters where they are welded", "[weld]") {
  // The cylinder stands 1e-9 above the box, and its base becomes a part of the box's top.
  const std::string tree = R"(weld: 1e-6
nodes:
  floor: {box: {min: [-2, -2, -1], max: [2, 2, 0]}}
  pillar: {cylinder: {from: [0, 0, 0.000000001], to: [0, 0, 1], radius: 1, segments: 12}}
  u: {union: [floor, pillar]}
result: u
)";
  const Evaluation evaluation = run(tree);
  CHECK(evaluation.rows.back().cells == Cells{8, 14, 8, 1});
  const std::vector<LeafId> pillar{LeafId(1)};
  REQUIRE(evaluation.parameters->has(pillar[0]));
  std::size_t found = 0;
  const Complex& complex = *evaluation.complex;
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    for (const PlacedCell& cell : evaluation.parameters->cells(f, pillar)) {
      ++found;
      for (const PatchCorner& corner : cell.corners) {
        CHECK((corner.point[2] == 0 || corner.point[2] == 1));
        CHECK(corner.at[1] == corner.point[2]);
      }
    }
  }
  CHECK(found == 12);
}

TEST_CASE("a mesh less its copy with errors is nothing", "[weld]") {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("cnrg_weld_" + std::to_string(getpid()))).string();
  const auto write_ball = [&](const std::string& name, double noise) {
    constexpr int kRows = 12, kColumns = 24;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> error(-noise, noise);
    std::string points, faces;
    const auto add_point = [&](double up, double round) {
      char text[100];
      std::snprintf(text, sizeof text, "%.17g %.17g %.17g\n", std::sin(up) * std::cos(round) + error(random),
                    std::sin(up) * std::sin(round) + error(random), std::cos(up) + error(random));
      points += text;
    };
    const auto add_face = [&](int a, int b, int c) {
      faces += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    };
    const auto number = [&](int i, int j) { return 1 + (i - 1) * kColumns + j % kColumns; };
    const int last = number(kRows, 0);
    add_point(0, 0);
    for (int i = 1; i < kRows; ++i) {
      for (int j = 0; j < kColumns; ++j) add_point(i * 3.14159265358979 / kRows, j * 6.28318530717959 / kColumns);
    }
    add_point(3.14159265358979, 0);
    for (int j = 0; j < kColumns; ++j) {
      add_face(0, number(1, j), number(1, j + 1));
      add_face(last, number(kRows - 1, j + 1), number(kRows - 1, j));
      for (int i = 1; i + 1 < kRows; ++i) {
        add_face(number(i, j), number(i + 1, j), number(i + 1, j + 1));
        add_face(number(i, j), number(i + 1, j + 1), number(i, j + 1));
      }
    }
    std::ofstream(name) << "OFF\n" << last + 1 << " " << kColumns * (2 * kRows - 2) << " 0\n" << points << faces;
  };
  write_ball(file + "1.off", 0);
  write_ball(file + "2.off", 1e-10);
  const std::string tree = "nodes:\n  a: {mesh: {file: " + file + "1.off}}\n  b: {mesh: {file: " + file +
                           "2.off}}\n  none: {difference: [a, b]}\nresult: none\n";
  CHECK(counts(tree).raw[3] > 0);
  const Evaluation welded = run("weld: 1e-8\n" + tree);
  CHECK(welded.rows.back().raw_cells == Cells{0, 0, 0, 0});
  CHECK_THAT(welded.diagnostics.back().message,
             Contains("0 planes and 266 points joined") && !Contains("off a plane"));
  std::filesystem::remove(file + "1.off");
  std::filesystem::remove(file + "2.off");
}

TEST_CASE("a sheet and a wire near a solid lie on it", "[weld]") {
  const std::string tree = R"(weld: 1e-6
nodes:
  ground: {box: {min: [0, 0, 0], max: [4, 4, 1]}}
  sheet: {polygon: [[1, 1, 1.0000001], [2, 1, 0.9999999], [2, 2, 0.9999999], [1, 2, 1.0000001]]}
  bolt: {polyline: [[3, 3, 1.0000005], [3, 3, 0.5]]}
  u: {union: [ground, sheet, bolt]}
result: u
)";
  const NodeRow row = run(tree).rows.back();
  CHECK(row.raw_cells == Cells{14, 17, 7, 1});
}

}  // namespace
}  // namespace cnrg
