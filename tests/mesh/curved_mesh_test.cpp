// Meshes that follow the true surfaces: what is proven of each element, where its nodes are, how volumes converge.
#include <cmath>
#include <random>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/mesh_file.h"
#include "csg/mesh/second_order.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

constexpr double kPi = 3.14159265358979323846;
using Point = std::array<double, 3>;

SecondOrderNodes straight(const std::array<Point, 4>& corners) {
  SecondOrderNodes nodes;
  std::copy(corners.begin(), corners.end(), nodes.begin());
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [i, j] = kSecondOrderEdges[e];
    for (std::size_t k = 0; k < 3; ++k) nodes[4 + e][k] = (corners[i][k] + corners[j][k]) / 2;
  }
  return nodes;
}

const std::array<Point, 4> kUnit{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// The determinant by the quadratic shape functions at barycentric coordinates.
double determinant(const SecondOrderNodes& nodes, const std::array<double, 4>& l) {
  double m[3][3];  // derivatives by l1, l2, l3 with l0 = 1 - l1 - l2 - l3
  for (std::size_t k = 1; k < 4; ++k) {
    for (std::size_t x = 0; x < 3; ++x) {
      const auto by = [&](std::size_t i) {  // of the shape functions by l_i, the others fixed
        double sum = (4 * l[i] - 1) * nodes[i][x];
        for (std::size_t e = 0; e < 6; ++e) {
          const auto& [a, b] = kSecondOrderEdges[e];
          if (a == i) sum += 4 * l[b] * nodes[4 + e][x];
          if (b == i) sum += 4 * l[a] * nodes[4 + e][x];
        }
        return sum;
      };
      m[k - 1][x] = by(k) - by(0);
    }
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

struct Bent {
  TetrahedralMesh made;
  CurvedReport report;
  double volume = 0;
  explicit Bent(const Tree& tree, const std::string& node = "", double quality = 1.4) {
    EvaluateOptions options;
    options.rows = Rows::none;
    if (!node.empty()) options.nodes = {tree.find(node)};
    const Evaluation evaluation = evaluate(tree, options);
    const Result result = node.empty() ? evaluation.result() : evaluation.result(node);
    made = tetrahedra(result, {.quality = quality, .curved = true});
    report = *made.bent;
    for (const RegionTetrahedra& region : made.regions) volume += to_double(region.volume);
  }
  std::size_t straight() const {
    std::size_t n = 0;
    for (const std::size_t s : report.straight) n += s;
    return n;
  }
};

/// The nodes of a tetrahedron of a mesh.
SecondOrderNodes nodes_of(const Mesh& mesh, const Mesh::Simplex<4>& t) {
  SecondOrderNodes nodes;
  const std::vector<Mesh::Index> numbers = mesh.nodes(t, kSecondOrderEdges);
  REQUIRE(numbers.size() == 10);
  for (std::size_t k = 0; k < 10; ++k) nodes[k] = mesh.points[numbers[k]];
  return nodes;
}

TEST_CASE("a tetrahedron of second order is proven to be turned right, or it is not", "[mesh][curved]") {
  CHECK(has_positive_determinant(straight(kUnit)));
  CHECK(!has_positive_determinant(straight({kUnit[1], kUnit[0], kUnit[2], kUnit[3]})));
  CHECK(!has_positive_determinant(straight({kUnit[0], kUnit[1], kUnit[2], kUnit[2]})));
  // A middle that comes to a quarter of its edge, and farther: the map turns round at the corner.
  SecondOrderNodes nodes = straight(kUnit);
  nodes[4] = {0.26, 0, 0};
  CHECK(has_positive_determinant(nodes));
  nodes[4] = {0.25, 0, 0};
  CHECK(!has_positive_determinant(nodes));
  nodes[4] = {0.24, 0, 0};
  CHECK(!has_positive_determinant(nodes));
  // Positive at all nodes, negative in the middle of an edge: coefficients know.
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-0.35, 0.35), any(0, 1);
  int proven = 0, refused = 0;
  for (int i = 0; i < 2000; ++i) {
    nodes = straight(kUnit);
    const double size = any(random);
    for (std::size_t n = 4; n < 10; ++n) {
      for (double& x : nodes[n]) x += size * off(random);
    }
    double least = HUGE_VAL;
    for (int k = 0; k < 600; ++k) {
      std::array<double, 4> l{-std::log(any(random)), -std::log(any(random)), -std::log(any(random)),
                              -std::log(any(random))};
      // Inside, on the four sides, the six edges, at the corners.
      for (std::size_t c = 0; c < 4; ++c) {
        if ((k % 15 + 1) >> c & 1) continue;
        l[c] = 0;
      }
      const double sum = l[0] + l[1] + l[2] + l[3];
      for (double& x : l) x /= sum;
      least = std::min(least, determinant(nodes, l));
    }
    const bool right = has_positive_determinant(nodes);
    if (right) CHECK(least > 0);
    if (least < -1e-12) CHECK(!right);
    if (least > 0.1) CHECK(right);
    (right ? proven : refused) += 1;
  }
  CHECK(proven > 500);
  CHECK(refused > 500);
  const auto [six, six_straight] = six_volumes(straight(kUnit));
  CHECK(six == Approx(1));
  CHECK(six_straight == Approx(1));
}

TEST_CASE("nodes on curved faces lie on the surfaces, and every element is turned right", "[mesh][curved]") {
  const Bent bent(
      parse_tree("cnrg: 1\nnodes:\n"
                 "  can: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1}}\n"
                 "  drill: {cylinder: {from: [-3, 0.1, 1], to: [3, 0.1, 1], radius: 0.4, segments: 24}}\n"
                 "  part: {difference: [can, drill]}\nresult: part\n",
                 "t.yaml"));
  const Mesh& mesh = bent.made.mesh;
  REQUIRE(!mesh.middles.empty());
  CHECK(bent.report.moved > 100);
  CHECK(bent.report.left == 0);
  CHECK(bent.straight() < mesh.tetrahedra.size() / 50);
  for (const auto& t : mesh.tetrahedra) REQUIRE(has_positive_determinant(nodes_of(mesh, t)));
  // Nodes of triangles are on one of the cylinders or on a flat end; but for the few of straight elements.
  std::size_t on = 0, all = 0;
  for (const auto& t : mesh.triangles) {
    for (const Mesh::Index p :
         mesh.nodes(t, std::array<std::array<std::size_t, 2>, 3>{{{0, 1}, {1, 2}, {0, 2}}})) {
      const auto& [x, y, z] = mesh.points[p];
      const double off = std::min({std::abs(std::hypot(x, y) - 1), std::abs(std::hypot(y - 0.1, z - 1) - 0.4),
                                   std::abs(z), std::abs(z - 2)});
      ++all;
      on += off < 1e-12;
      CHECK(off < 0.01);
    }
  }
  CHECK(on * 100 > all * 95);
  CHECK(to_double(bent.made.regions[0].volume) == Approx(bent.volume));
}

TEST_CASE("volumes of bent tetrahedra converge with the third power of the size or better", "[mesh][curved]") {
  const auto bottle_volume = 17.961661365056;  // papers/keyser2004/curved.py
  const std::string file = "papers/keyser2004/curved.yaml";
  for (const auto& [node, exact, times] :
       {std::tuple{"ball", 4 * kPi / 3, 2}, {"can", 2 * kPi, 4}, {"bottle", bottle_volume, 2}}) {
    INFO(node);
    std::vector<double> errors;
    for (int finer = 1; finer <= times; finer *= 2) {
      Tree tree = read_tree(file);
      make_finer(tree, finer);
      const Bent bent(tree, node);
      errors.push_back(std::abs(bent.volume - exact));
      CHECK(bent.report.left == 0);
      CHECK(bent.straight() * 50 < bent.made.mesh.tetrahedra.size());
    }
    for (std::size_t i = 1; i < errors.size(); ++i) CHECK(errors[i - 1] / errors[i] > 8);
    CHECK(errors.back() < 1e-4);
  }
}

TEST_CASE("flat solids become elements of second order that stay straight", "[mesh][curved]") {
  const Bent bent(
      parse_tree("cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 2, 3]}}\nresult: a\n", "t.yaml"), "", 0);
  CHECK(bent.made.regions[0].volume == 6);
  CHECK(bent.report.moved == 0);
  CHECK(bent.report.middles == 0);
  CHECK(bent.report.curved[0] == 0);
  CHECK(bent.straight() == 0);
  for (const auto& [edge, p] : bent.made.mesh.middles) {
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(bent.made.mesh.points[p][k] ==
            (bent.made.mesh.points[edge[0]][k] + bent.made.mesh.points[edge[1]][k]) / 2);
    }
  }
}

}  // namespace
}  // namespace cnrg
