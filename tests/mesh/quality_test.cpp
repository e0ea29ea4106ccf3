// Shapes of tetrahedra, where they are bad and why; and results so near to touch that there are none in doubles.
#include "csg/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "csg/result/join.h"
#include "csg/tree/tree.h"
#include "kernel/tetrahedra/constrained.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

using Corners = std::array<std::array<double, 3>, 4>;

TetrahedralMesh mesh_of_tree(const std::string& tree, const TetrahedraOptions& options = {}) {
  Result result = evaluate(parse_tree(tree, "test.yaml")).result();
  SnapReport report;
  return snapped_tetrahedra(result, options, report);
}

Corners corners_of(const Mesh& mesh, const Mesh::Simplex<4>& t) {
  Corners p;
  for (std::size_t k = 0; k < 4; ++k) p[k] = mesh.points[t.points[k]];
  return p;
}

/// The smallest angle between faces by their normals: another way than that of the program.
double dihedral(const Corners& p) {
  const auto normal = [&](std::size_t k) {
    const auto &a = p[(k + 1) % 4], &b = p[(k + 2) % 4], &c = p[(k + 3) % 4];
    std::array<double, 3> u, v, n;
    for (std::size_t i = 0; i < 3; ++i) u[i] = b[i] - a[i], v[i] = c[i] - a[i];
    for (std::size_t i = 0; i < 3; ++i) n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
    double side = 0, length = 0;
    for (std::size_t i = 0; i < 3; ++i) side += n[i] * (p[k][i] - a[i]), length += n[i] * n[i];
    for (double& x : n) x /= (side > 0 ? -1 : 1) * std::sqrt(length);  // outward
    return n;
  };
  double least = 180;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      const auto m = normal(k), n = normal(l);
      const double cosine = -(m[0] * n[0] + m[1] * n[1] + m[2] * n[2]);
      least = std::min(least, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / M_PI);
    }
  }
  return least;
}

}  // namespace

namespace {

/// A tetrahedron in which two edges (0), an edge and a face (1) or two faces (2) meet at so many radians.
Corners sharp(int kind, double angle, const std::array<double, 6>& x) {
  const double c = std::cos(angle), s = std::sin(angle);
  if (kind == 0) return {{{0, 0, 0}, {x[0], 0, 0}, {x[1] * c, x[1] * s, 0}, {x[2], x[3], x[4]}}};
  if (kind == 1)
    return {{{0, 0, 0},
             {x[0], 0, 0},
             {x[1], x[2], 0},
             {x[3] * c * std::cos(x[4]), x[3] * c * std::sin(x[4]), x[3] * s}}};
  return {{{0, 0, 0}, {x[0], 0, 0}, {x[1], x[2], 0}, {x[3], x[4] * c, x[4] * s}}};
}

}  // namespace

// By climbing from random places: the best is an edge beside a face.
TEST_CASE("no shape is 0.1 where a tetrahedron is as sharp as what counts as forced", "[mesh][quality]") {
  std::mt19937_64 random(7);
  const double angle = MeshQuality::kForced * M_PI / 180;
  std::normal_distribution<double> normal;
  for (int kind = 0; kind < 3; ++kind) {
    double best = 0;
    for (int start = 0; start < 40; ++start) {
      std::array<double, 6> at;
      for (double& x : at) x = normal(random);
      double shape = measures_of(sharp(kind, angle, at)).shape;
      for (double step = 1; step > 1e-5; step *= 0.99) {
        auto next = at;
        for (double& x : next) x += step * normal(random);
        const double there = measures_of(sharp(kind, angle, next)).shape;
        if (there > shape) shape = there, at = next;
      }
      best = std::max(best, shape);
    }
    INFO("kind " << kind << " best " << best);
    CHECK(best > 0.06);
    CHECK(best < 0.98 * MeshQuality::kBad);
  }
}

TEST_CASE("what the model forces is counted", "[mesh][quality]") {
  const auto counts = [](const std::string& nodes) {
    const TetrahedralMesh made =
        mesh_of_tree("cnrg: 1\nnodes:\n  rock: {box: {min: [0, 0, 0], max: [10, 10, 10]}}\n" + nodes +
                     "  model: {union: [rock, a]}\nresult: model\n");
    return std::array{made.quality.forced, made.quality.bad};
  };
  // A corner of half a degree on one sheet; the same of two degrees; none.
  const auto needle = counts("  a: {polygon: [[1, 5, 5], [9, 5, 5], [9, 5.07, 5]]}\n");
  CHECK(needle[0] >= 2);
  CHECK(needle[0] <= needle[1]);
  CHECK(counts("  a: {polygon: [[1, 5, 5], [9, 5, 5], [9, 5.28, 5]]}\n")[0] == 0);
  CHECK(counts("  a: {polygon: [[1, 5, 5], [9, 5, 5], [9, 9, 5]]}\n")[0] == 0);
  // A solid wedge of half a degree.
  const TetrahedralMesh wedge = mesh_of_tree(
      "cnrg: 1\nnodes:\n  model: {prism: {base: [[0, 0, 0], [8, 0, 0], [8, 0.07, 0]], vector: [0, 0, 1]}}\n"
      "result: model\n");
  CHECK(wedge.quality.forced > 0);
  CHECK(forced_text(wedge.quality).find("meet at less than 0.9 degrees") != std::string::npos);
  CHECK(forced_text({}).empty());
}

TEST_CASE("what nearly touches is said to be joined where much is bad for it", "[mesh][quality]") {
  const MeshQuality near = mesh_of_tree(
                               "cnrg: 1\nnodes:\n  rock: {box: {min: [0, 0, 0], max: [10, 10, 10]}}\n"
                               "  a: {polyline: [[5, 5, 5], [9, 4, 2]]}\n"
                               "  b: {polyline: [[5, 5.001, 5], [1, 6, 2]]}\n"
                               "  c: {polygon: [[1, 1, 9.99], [9, 1, 9.995], [9, 9, 9.99]]}\n"
                               "  model: {union: [rock, a, b, c]}\nresult: model\n")
                               .quality;
  CHECK(near.near > 0);
  CHECK(near.near <= near.bad);
  CHECK_THAT(joining_text(near), Catch::StartsWith("in " + std::to_string(near.near) + " of them two cells") &&
                                     Catch::EndsWith("--join joins it"));
  CHECK_THAT(joining_text(near), Catch::Contains(" nearly touch, the nearest 0.001 apart; "));
  // Few that are as wide as somebody draws are not worth a word; some that nobody draws are.
  MeshQuality few = near;
  few.shapes.back() += 100 * few.bad;
  few.narrowest = 0.0009;
  CHECK_FALSE(joining_text(few).empty());
  few.narrowest = 0.002;
  CHECK(joining_text(few).empty());
}

// The corners of a flat tetrahedron lie far from each other beside the gap that it is flat for.
TEST_CASE("reasons tell how wide the gap is between cells that do not touch", "[mesh][quality]") {
  const std::string box = "cnrg: 1\nnodes:\n  rock: {box: {min: [0, 0, 0], max: [10, 10, 4]}}\n";
  const std::string model = "  model: {union: [a, rock], dominance: left}\nresult: model\n";
  TetrahedraOptions fine;
  fine.size = 3;
  for (const auto& [nodes, reason] :
       {std::pair("  a: {polygon: [[3, 0, 0], [3, 10, 0], [3, 10, 3.99999], [3, 0, 3.99999]]}\n",
                  " and f3 of `rock` are 1e-05 apart"),
        std::pair("  b: {polyline: [[5, 5, 4], [5, 5, 2.00001]]}\n"
                  "  s: {polygon: [[2, 2, 2], [8, 2, 2], [8, 8, 2], [2, 8, 2]]}\n  a: {union: [b, s]}\n",
                  " of `b` and f5 of `s` are 1e-05 apart"),
        std::pair("  a: {polyline: [[1, 1e-5, 1], [9, 1e-5, 1]]}\n",
                  " of `a` and f1 of `rock` are 1e-05 apart")}) {
    for (const TetrahedraOptions& options : {TetrahedraOptions{}, fine}) {
      // To sizes TetGen puts points about the end of the wire, ever closer, and no shape is bad.
      if (options.size > 0 && std::string(nodes).find("  s:") != std::string::npos) continue;
      const MeshQuality quality = mesh_of_tree(box + nodes + model, options).quality;
      INFO(reason);
      CHECK(quality.bad > 0);
      CHECK(quality.near == quality.bad);
      CHECK(quality.narrowest == Approx(1e-5));
      bool said = false;
      for (const MeshQuality::Bad& bad : quality.worst_ones) {
        INFO(bad.why);
        CHECK_THAT(bad.why, Catch::Contains(" apart"));
        said |= bad.why.find(reason) != std::string::npos;
      }
      CHECK(said);
      CHECK_THAT(joining_text(quality), Catch::StartsWith("in " + std::to_string(quality.bad) + " of them"));
    }
  }
}

TEST_CASE("segments of one edge, and cells that touch, are no gap to be joined", "[mesh][quality]") {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {0, 0.1, 0}, {5, 1, 0}, {5, 0, 1}};
  mesh.vertices = {{{0}, 0}};
  mesh.segments = {{{0, 1}, 0}, {{1, 2}, 0}, {{0, 3}, 1}};
  mesh.tetrahedra = {{{1, 2, 4, 5}, 0}};
  mesh.entities[0].resize(1);
  mesh.entities[1].resize(2);
  mesh.entities[3].resize(1);
  MeshQuality q = quality_of(mesh, {});
  REQUIRE(q.worst_ones.size() == 1);
  CHECK(q.worst_ones[0].why == "points of e0 are 0.1 apart");
  CHECK(q.near == 0);
  mesh.tetrahedra[0].points = {1, 3, 4, 5};
  q = quality_of(mesh, {});
  REQUIRE(q.worst_ones.size() == 1);
  CHECK(q.worst_ones[0].why == "e0 and e1, which touch, have points 0.141 apart");
  CHECK(q.near == 0);
  CHECK(joining_text(q).empty());
}

// No corner is near to what it is not on: two segments cross at a distance.
TEST_CASE("segments that pass each other are a gap", "[mesh][quality]") {
  Mesh mesh;
  mesh.points = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0.02}, {0, 1, 0.02}};
  mesh.segments = {{{0, 1}, 0}, {{2, 3}, 1}};
  mesh.tetrahedra = {{{0, 1, 3, 2}, 0}};
  mesh.entities[1].resize(2);
  mesh.entities[3].resize(1);
  const MeshQuality q = quality_of(mesh, {});
  REQUIRE(q.worst_ones.size() == 1);
  CHECK(q.worst_ones[0].why == "e0 and e1 are 0.02 apart here");
  CHECK(q.near == 1);
  CHECK(q.narrowest == Approx(0.02));
}

TEST_CASE("measures of tetrahedra that are known", "[mesh][quality]") {
  const auto regular = measures_of({{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}});
  CHECK(regular.shape == Approx(1));
  CHECK(regular.radius_edge == Approx(std::sqrt(6) / 4));
  CHECK(regular.dihedral == Approx(std::acos(1.0 / 3) * 180 / M_PI));
  const auto corner = measures_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  CHECK(corner.shape == Approx(12 * std::pow(0.5, 2.0 / 3) / 9));
  CHECK(corner.radius_edge == Approx(std::sqrt(3) / 2));
  CHECK(corner.dihedral == Approx(std::acos(1 / std::sqrt(3)) * 180 / M_PI));
}

TEST_CASE("flat tetrahedra are measured exactly", "[mesh][quality]") {
  // Doubles have no determinant of these: 2^-60 beside a corner of 1.
  const double h = std::ldexp(1.0, -60), up = std::nextafter(1.0, 2);
  const TetrahedronMeasures thin = measures_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, h}}});
  CHECK(thin.volume == Approx(h / 6).epsilon(1e-12));
  CHECK(thin.shape == Approx(12 * std::pow(h / 2, 2.0 / 3) / 8).epsilon(1e-12));
  CHECK(thin.dihedral == Approx(h * std::sqrt(2.0) * 180 / M_PI).epsilon(0.5));
  CHECK(thin.dihedral > 0);
  // Corners of a plane but for the last digits.
  const TetrahedronMeasures tilted = measures_of({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.0 / 3, 1.0 / 3, 1.0 / 3}}});
  CHECK(tilted.shape > 0);
  CHECK(tilted.shape < 1e-9);
  CHECK(std::isfinite(tilted.radius_edge));
  CHECK(tilted.radius_edge > 1e14);
  const TetrahedronMeasures far = measures_of({{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1.25, 1.25, up}}});
  CHECK(far.volume == Approx(std::ldexp(1.0, -52) / 6));
  CHECK(std::isfinite(far.radius_edge));
  CHECK(far.shape > 0);
}

TEST_CASE("a long bore gets tetrahedra of good shape, and the table counts them right", "[mesh][quality]") {
  const TetrahedralMesh made = mesh_of_tree(R"(cnrg: 1
nodes:
  rock: {box: {min: [0, 0, 0], max: [60, 60, 60]}, name: rock}
  bore: {cylinder: {from: [30, -5, 30], to: [30, 65, 30], radius: 3, segments: 24}}
  model: {difference: [rock, bore]}
result: model
)");
  std::size_t bad = 0;
  double worst = 1, sharpest = 180;
  std::vector<double> shapes;
  for (const auto& t : made.mesh.tetrahedra) {
    const Corners p = corners_of(made.mesh, t);
    const double shape = measures_of(p).shape;
    bad += shape < 0.1;
    worst = std::min(worst, shape);
    sharpest = std::min(sharpest, dihedral(p));
    shapes.push_back(shape);
  }
  std::sort(shapes.begin(), shapes.end());
  CHECK(made.quality.bad == bad);
  CHECK(bad == 0);
  CHECK(made.quality.worst == Approx(worst));
  CHECK(made.quality.median == Approx(shapes[shapes.size() / 2]));
  CHECK(made.quality.smallest_dihedral == Approx(sharpest));
  std::array<std::size_t, 20> by_shape{};
  std::array<std::size_t, 18> by_angle{};
  std::array<std::size_t, 16> by_ratio{};
  for (const auto& t : made.mesh.tetrahedra) {
    const Corners p = corners_of(made.mesh, t);
    const TetrahedronMeasures m = measures_of(p);
    const auto add = [](auto& counts, double place) {
      ++counts[std::size_t(std::min(std::floor(place), double(counts.size() - 1)))];
    };
    add(by_shape, m.shape / 0.05), add(by_angle, m.dihedral / 5), add(by_ratio, (m.radius_edge - 0.6) / 0.2);
  }
  CHECK(made.quality.shapes == by_shape);
  CHECK(made.quality.dihedrals == by_angle);
  CHECK(made.quality.ratios == by_ratio);
}

TEST_CASE("triangles are counted by their smallest angles, the worst first", "[mesh][quality]") {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, std::sqrt(0.75), 0}, {10, 0.5, 0}};
  mesh.groups[2] = {"face of a", "from a"};
  mesh.sources = 1;
  mesh.entities[2].resize(1);
  mesh.entities[2][0].groups = {1, 2};
  mesh.triangles = {{{0, 1, 2}, 0}, {{0, 1, 3}, 0}, {{0, 1, 4}, 0}};
  const TriangleQuality q = triangle_quality_of(mesh, {"a"});
  std::array<std::size_t, 12> expected{};
  expected[0] = expected[9] = 1;  // atan(1/18) and 45 degrees
  expected[11] = 1;
  CHECK(q.angles == expected);
  REQUIRE(q.worst_ones.size() == 3);
  CHECK(q.worst_ones[0].triangle == 2);
  CHECK(q.worst_ones[0].angle == Approx((std::atan2(0.5, 9) - std::atan2(0.5, 10)) * 180 / M_PI));
  CHECK(q.worst_ones[0].nodes == std::vector<std::string>{"a"});
  CHECK(q.worst_ones[1].triangle == 0);
  CHECK(q.worst_ones[1].at[0] == Approx(1.0 / 3));
}

TEST_CASE("what is nearly touched is named where shapes are bad", "[mesh][quality]") {
  const TetrahedralMesh made = mesh_of_tree(R"(cnrg: 1
nodes:
  rock:  {box: {min: [0, 0, 0], max: [10, 10, 10]}}
  fault: {polygon: [[0, 0, 0], [10, 0, 0.05], [10, 10, 0.05], [0, 10, 0]]}
  model: {union: [fault, rock], dominance: left}
result: model
)");
  REQUIRE(made.quality.bad > 0);
  REQUIRE(!made.quality.worst_ones.empty());
  for (std::size_t i = 1; i < made.quality.worst_ones.size(); ++i)
    CHECK(made.quality.worst_ones[i - 1].measures.shape <= made.quality.worst_ones[i].measures.shape);
  const auto named = [&](const char* name) {
    return std::any_of(made.quality.worst_ones.begin(), made.quality.worst_ones.end(), [&](const auto& bad) {
      return std::find(bad.nodes.begin(), bad.nodes.end(), name) != bad.nodes.end();
    });
  };
  CHECK(named("fault"));
  CHECK(named("rock"));
  // At the border of the fault both meet: a reason that has a vertex or an edge there names both.
  CHECK(std::any_of(made.quality.worst_ones.begin(), made.quality.worst_ones.end(), [](const auto& bad) {
    return bad.why.find(" of `fault` and `rock`") != std::string::npos ||
           bad.why.find(" of `rock` and `fault`") != std::string::npos;
  }));
}

// The ends of wires are the doubles nearest to points on sides of a triangle, as programs write them: no double
// lies between.
TEST_CASE("wires that end beside the sides of a sheet need no joining", "[mesh][quality]") {
  const auto [begin, end] = scenes::seeds(12);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    const auto part = [&] { return double(random() % 1'000'000) / 1e6; };
    std::array<std::array<double, 3>, 3> p;
    for (auto& point : p)
      for (double& x : point) x = double(random() % 11) / 10;
    std::ostringstream tree;
    tree.precision(17);
    const auto write = [&](const std::array<double, 3>& q) {
      tree << "[" << q[0] << ", " << q[1] << ", " << q[2] << "]";
    };
    const auto on = [&](const auto& a, const auto& b) {
      const double t = part();
      std::array<double, 3> q;
      for (std::size_t k = 0; k < 3; ++k) q[k] = a[k] + (b[k] - a[k]) * t;
      return q;
    };
    tree << "cnrg: 1\nnodes:\n  rock: {box: {min: [-1, -1, -1], max: [2, 2, 2]}}\n  sheet: {polygon: [";
    write(p[0]), tree << ", ", write(p[1]), tree << ", ", write(p[2]);
    tree << "]}\n  bolt: {polyline: [";
    write(on(p[0], p[1]));
    tree << ", [0.5, 0.5, 1.5]]}\n  rod: {polyline: [";
    write(on(p[1], p[2]));
    tree << ", [0.5, 0.6, -0.9]]}\n  model: {union: [rock, sheet, bolt, rod]}\nresult: model\n";
    TetrahedraOptions options;
    options.constrained = true;
    TetrahedralMesh made;
    try {
      made = mesh_of_tree(tree.str(), options);
    } catch (const InputError& e) {  // the three points are on one line
      REQUIRE(std::string(e.what()).find("line") != std::string::npos);
      continue;
    }
    REQUIRE(made.regions.size() == 1);
    CHECK(std::fabs(to_double(made.regions[0].volume) - 27) < 1e-9);
    CHECK(made.notice.find("joined") == std::string::npos);
  }
}

// Six wires miss a point by their last digits, and so each other.
TEST_CASE("what no doubles fit between is joined, and that is said", "[mesh][quality]") {
  const auto [begin, end] = scenes::seeds(12);
  std::size_t joined = 0;
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    const auto part = [&] { return double(random() % 1'000'000) / 1e6; };
    const std::array<double, 3> middle{part(), part(), part()};
    std::ostringstream tree;
    tree.precision(17);
    tree << "cnrg: 1\nnodes:\n  rock: {box: {min: [-1, -1, -1], max: [2, 2, 2]}}\n";
    for (int wire = 0; wire < 6; ++wire) {
      const std::array<double, 3> way{part() - 0.5, part() - 0.5, part() - 0.5};
      const auto at = [&](double t) {
        std::ostringstream text;
        text.precision(17);
        text << "[" << middle[0] + t * way[0] << ", " << middle[1] + t * way[1] << ", " << middle[2] + t * way[2]
             << "]";
        return text.str();
      };
      tree << "  w" << wire << ": {polyline: [" << at(1) << ", " << at(-0.5 - part() / 2) << "]}\n";
    }
    tree << "  model: {union: [rock, w0, w1, w2, w3, w4, w5]}\nresult: model\n";
    TetrahedraOptions options;
    options.constrained = true;
    const TetrahedralMesh made = mesh_of_tree(tree.str(), options);
    REQUIRE(made.regions.size() == 1);
    CHECK(std::fabs(to_double(made.regions[0].volume) - 27) < 1e-9);
    joined += made.notice.find("joined") != std::string::npos;
  }
  CHECK(joined * 3 > end - begin);
}

TEST_CASE("places are told to a millionth of the mesh, wherever it lies", "[mesh][quality]") {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {30, 20, 30}};
  CHECK(PlaceText(mesh)({19.36023456, 4.3, 1.25e-7}) == "19.3602 4.3 1.25e-07");
  mesh.points = {{4500000, 5800000, -200}, {4500500, 5800400, 100}};
  CHECK(PlaceText(mesh)({4500270.43211234, 5800400, -62.40841234}) == "4500270.4321 5800400 -62.40841234");
  mesh.points.clear();
  CHECK(PlaceText(mesh)({0.1, 0, 2}) == "0.1 0 2");
}

TEST_CASE("a flat tetrahedron between two faces that others touch names them", "[mesh][quality]") {
  Mesh mesh;
  mesh.points = {{0, 0, 0},    {9, 0, 0},     {0, 9, 0},     {0, 0, 0.01},  {9, 0, 0.01},
                 {0, 9, 0.01}, {1, 1, 0.004}, {2, 1, 0.006}, {2, 2, 0.004}, {1, 2, 0.006}};
  mesh.triangles = {{{0, 1, 2}, 0}, {{3, 4, 5}, 1}};
  mesh.tetrahedra = {{{6, 7, 8, 9}, 0}};
  mesh.entities[2].resize(2);
  mesh.entities[3].resize(1);
  MeshQuality q = quality_of(mesh, {});
  REQUIRE(q.worst_ones.size() == 1);
  CHECK(q.worst_ones[0].why == "f0 and f1 are within 0.01 of each other");
  for (std::size_t p = 3; p < 6; ++p) mesh.points[p][2] = 1;
  q = quality_of(mesh, {});
  REQUIRE(q.worst_ones.size() == 1);
  CHECK(q.worst_ones[0].why == "no local move makes it better");
}

// Two ends are typed 4e-5 inside of the tunnel, so these bolts pierce it a unit in the last place beside an edge,
// once all is turned. TetGen stops there (an assertion, or signal 11).
TEST_CASE("what lies some units in the last place apart does not spoil the shapes of a mesh", "[mesh][quality]") {
  const std::string model = R"(
cnrg: 1
nodes:
  ground: {box: {min: [0, 0, 0], max: [30, 30, 30]}}
  tunnel: {cylinder: {from: [15, -1, 12], to: [15, 31, 12], radius: 4, segments: 32}}
  bolt: {polyline: [[17.8284, 5, 14.8284], [20.6569, 5, 17.6569]]}
  other: {polyline: [[17.8284, 10, 14.8284], [20.6569, 10, 17.6569]]}
  rock: {difference: [ground, tunnel]}
  bolted: {union: [bolt, other, rock], dominance: left}
  model: {simplify: bolted, rotate: {axis: [1, 2, 5], degrees: 17}}
result: model
)";
  Result result = evaluate(parse_tree(model, "test.yaml")).result();
  SnapReport report;
  SurfaceOptions asked;
  asked.overall = 2;
  const SurfaceTriangles surface = snapped_surface_triangles(result, asked, report);
  CHECK_THAT(surface.notice, Catch::Contains("without that: joined 2 pairs nearer than"));
  for (const FaceTriangles& of : surface.groups) CHECK(of.why[std::size_t(SmallAngle::digits)] == 0);
  TetrahedraOptions options;
  options.size = 2;
  const TetrahedralMesh made = mesh_of_tree(model, options);
  INFO(made.notice);
  CHECK(made.quality.bad == 0);
  CHECK(made.mesh.tetrahedra.size() < 100'000);
  CHECK(
      (made.notice.empty() || made.notice.find("without that: joined 2 pairs nearer than") != std::string::npos));
}

// Sheets between corners and middles of a box, but for 1e-11: TetGen stops at both, whatever is joined of the
// first.
TEST_CASE("where TetGen fails, what is near is joined, or it is said by what", "[mesh][quality]") {
  const auto model = [](const std::string& sheets, const std::string& names) {
    return "cnrg: 1\nnodes:\n  rock: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n" + sheets + "  sheets: {union: [" +
           names + "]}\n  in: {intersection: [sheets, rock]}\n" +
           "  model: {union: [in, rock], dominance: left}\nresult: model\n";
  };
  const auto sheet = [](const std::string& name, const std::string& points) {
    return "  " + name + ": {mesh: {points: [" + points +
           "], faces: [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]], fill: none}}\n";
  };
  const auto fails = [](const TetrahedralMesh& made) {
    return made.notice.find("these are constrained tetrahedra") != std::string::npos;
  };
  const TetrahedralMesh joined = mesh_of_tree(model(
      sheet("s0",
            "[5.4e-12, 1.4e-11, 0], [0.5000000000038, 0.5, 0], [1.0000000000008, 1, 0], "
            "[1.0000000000152, 1.0000000000299, 1], [0.5000000000226, 0.5000000000007, 1], [0, -3.1e-12, 1]") +
          sheet("s1",
                "[4.1e-12, 1, 0], [0.4999999999977, 0.5000000000025, 0], [1.0000000000237, 0, 0], "
                "[0.9999999999942, -8.7e-12, 1], [0.5000000000055, 0.5000000000012, 1], [5.7e-12, 1, 1]") +
          sheet("s2",
                "[0.5, -6.9e-13, 0], [0.5000000000103, 0.4999999999993, 0], [0.5000000000027, 1, 0], "
                "[0.500000000002, 1.0000000000066, 1], [0.5000000000023, 0.5000000000158, 1], "
                "[0.5000000000037, 9.5e-13, 1]"),
      "s0, s1, s2"));
  INFO(joined.notice);
  CHECK((!fails(joined) || Catch::Contains("joined ").match(joined.notice)));
  const std::string apart =
      model(sheet("s0",
                  "[-6.9e-12, -4.8e-12, 0], [0.5, 0.5, 0], [0.9999999999978, 1, 0], [1.0000000000061, 1, 1], "
                  "[0.5, 0.5, 1], [-6.5e-12, -5.4e-12, 1]") +
                sheet("s1",
                      "[2.2e-12, 0.9999999999872, 0], [0.5000000000022, 0.5, 0], [0.9999999999866, 0, 0], "
                      "[1.0000000000242, 0, 1], [0.4999999999805, 0.5, 1], [-2.9e-11, 1.0000000000255, 1]"),
            "s0, s1");
  const TetrahedralMesh made = mesh_of_tree(apart);
  INFO(made.notice);
  CHECK((!fails(made) || Catch::Contains("--join 2.3e-10 does it").match(made.notice)));
  Result near = evaluate(parse_tree(apart, "test.yaml")).result();
  near = join(near, Rational(1, 4'000'000'000));
  SnapReport report;
  const TetrahedralMesh good = snapped_tetrahedra(near, {}, report);
  CHECK((good.quality.bad == 0 && made.quality.bad > 100));
}
