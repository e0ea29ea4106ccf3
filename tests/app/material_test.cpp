// Graded materials in files and on the command line.
#include <cmath>
#include <sstream>
#include <string>

#include "program.h"
#include "tests/catch.h"
#include "tests/formats/vtu_reader.h"
#include "tests/scenes/mesh_readers.h"

namespace cnrg {
namespace {

using Catch::Contains;

const std::string kMaterialTree = R"(cnrg: 1
materials:
  steel: {color: "#667788"}
  ceramic: {}
  rubber: {}
  blend: {linear: {from: [0, 0, 0], to: [0, 0, 4], stops: [[0, steel], [1/2, {steel: 1/4, ceramic: 3/4}], [1, ceramic]]}}
  coat: {distance: {to: bolt, stops: [[0, ceramic], [1, rubber]]}}
nodes:
  body: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: blend}
  bolt: {polyline: [[2, 2, -1], [2, 2, 5]]}
  sleeve: {box: {min: [1, 1, 0], max: [3, 3, 4]}, material: coat, dominance: 2}
  part: {union: [body, sleeve]}
result: part
)";

const char* const kNames[] = {"fraction of steel", "fraction of ceramic", "fraction of rubber"};

/// What the field is made of at a point, by the definitions alone.
std::array<double, 3> expected(int region, double x, double y, double z) {
  if (region == 1) {
    const double t = z / 4;
    const double ceramic = t < 0.5 ? 1.5 * t : 0.75 + 0.5 * (t - 0.5);
    return {1 - ceramic, ceramic, 0};
  }
  const double d = std::min(1.0, std::hypot(x - 2, y - 2));
  return {0, 1 - d, d};
}

TEST_CASE("graded materials are sampled in .vtu, kept in .json, and told by locate", "[app][material]") {
  const Workshop w;
  w.write("t.yaml", kMaterialTree);
  const Outcome o = w.run("eval t.yaml --quiet -o t.json -o t.vtu");
  INFO(o.err);
  REQUIRE(o.status == 0);
  CHECK(o.err == "");  // the bolt is used, by a material

  const test::Vtu vtu{w.read("t.vtu")};
  const auto points = vtu.array<double>("Points");
  const auto corners = vtu.array<std::int64_t>("connectivity"), ends = vtu.array<std::int64_t>("offsets");
  const auto dimension = vtu.array<std::int32_t>("dimension"), region = vtu.array<std::int32_t>("region");
  std::array<std::vector<double>, 3> fractions;
  for (std::size_t k = 0; k < 3; ++k) fractions[k] = vtu.array<double>(kNames[k]);
  std::size_t solids = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    REQUIRE(fractions[0].size() == ends.size());
    if (dimension[i] < 3) continue;
    ++solids;
    double center[3] = {0, 0, 0};
    for (auto k = i == 0 ? 0 : ends[i - 1]; k < ends[i]; ++k) {
      for (std::size_t c = 0; c < 3; ++c) center[c] += points[3 * std::size_t(corners[std::size_t(k)]) + c] / 3;
    }
    const auto want = expected(region[i], center[0], center[1], center[2]);
    for (std::size_t k = 0; k < 3; ++k) CHECK(fractions[k][i] == Approx(want[k]).margin(1e-14));
  }
  CHECK(solids > 20);

  // Read back, moved: the grades move along, and a second copy is the same to the byte.
  w.write("back.yaml", "cnrg: 1\nnodes: {r: {cnrg: t.json}}\nresult: r\n");
  w.write("moved.yaml", "cnrg: 1\nnodes: {r: {cnrg: t.json, translate: [10, 0, 1]}}\nresult: r\n");
  REQUIRE(w.run("eval back.yaml --quiet -o back.json").status == 0);
  const auto grades = [&](const std::string& file) {
    const std::string text = w.read(file);
    const auto begin = text.find("\"grades\"");
    REQUIRE(begin != std::string::npos);
    return text.substr(begin, text.find("\"components\"") - begin);
  };
  CHECK(grades("back.json") == grades("t.json"));
  CHECK(w.run("locate t.yaml --material", "0.5 2 1\n1.5 2 3\n2 2 -0.5\n0 1 1\n").out ==
        "3 r0 1 body\tmaterial: steel 5/8, ceramic 3/8\n3 r2 2 sleeve\tmaterial: ceramic 1/2, rubber 1/2\n" +
            w.run("locate t.yaml", "2 2 -0.5\n0 1 1\n").out);
  CHECK_THAT(w.run("locate moved.yaml --material", "10.5 2 2\n").out,
             Contains("material: steel 5/8, ceramic 3/8"));
  CHECK_THAT(w.run("explain t.yaml --point 0.5,2,1").out, Contains("steel 5/8, ceramic 3/8"));
}

TEST_CASE("graded materials are sampled at the corners of tetrahedra in .msh, and Gmsh reads them",
          "[app][material][mesh]") {
  const Workshop w;
  w.write("t.yaml", kMaterialTree);
  REQUIRE(w.run("mesh t.yaml --quiet --max-volume 0.05 -o t.msh -o t.vtu").status == 0);
  const std::string text = w.read("t.msh");
  const test::MeshFile mesh = test::read_msh(text);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = text.find("\"" + std::string(kNames[k]) + "\"\n");
    REQUIRE(at != std::string::npos);
    std::istringstream in(text.substr(at + std::string(kNames[k]).size() + 3));
    int tags, steps, step, size, count;
    double time;
    in >> tags >> time >> steps >> step >> size >> count;
    CHECK(std::size_t(count) == mesh.count(3));
    std::size_t mixed = 0;
    for (int i = 0; i < count; ++i) {
      std::size_t element, corners;
      in >> element >> corners;
      REQUIRE(corners == 4);
      const auto& t = mesh.elements.at(element - 1);
      REQUIRE(t.dimension == 3);
      double x = 0, y = 0;
      for (const int n : t.nodes) x += mesh.nodes.at(n)[0] / 4, y += mesh.nodes.at(n)[1] / 4;
      const int region = std::abs(x - 2) < 1 && std::abs(y - 2) < 1 ? 2 : 1;
      for (std::size_t c = 0; c < 4; ++c) {
        double value;
        in >> value;
        const auto& p = mesh.nodes.at(t.nodes[c]);
        CHECK(value == Approx(expected(region, p[0], p[1], p[2])[k]).margin(1e-14));
        mixed += value > 0 && value < 1;
      }
    }
    CHECK(mixed > 0);
  }
  if (test::installed("gmsh")) {
    const Outcome o = w.shell("gmsh t.msh -save -o again.msh >.out 2>.err");
    CHECK(o.status == 0);
    CHECK_THAT(o.out + o.err, !Contains("Error"));
    CHECK(test::read_msh(w.read("again.msh")).count(3) == mesh.count(3));
  } else {
    WARN("left out: gmsh is not installed (Debian: gmsh)");
  }
}

TEST_CASE("broken grades in a result are refused at their place", "[app][material]") {
  const Workshop w;
  w.write("t.yaml", kMaterialTree);
  REQUIRE(w.run("eval t.yaml --quiet -o t.json").status == 0);
  w.write("back.yaml", "cnrg: 1\nnodes: {r: {cnrg: t.json}}\nresult: r\n");
  const std::string good = w.read("t.json");
  const auto broken = [&](const std::string& what, const std::string& by) {
    std::string text = good;
    const auto at = text.find(what);
    REQUIRE(at != std::string::npos);
    w.write("t.json", text.replace(at, what.size(), by));
    const Outcome o = w.run("eval back.yaml");
    CHECK(o.status == 2);
    return o.err;
  };
  CHECK_THAT(broken("\"grade\":1", "\"grade\":2"), Contains("grade 2 does not exist: numbers are 0 to 1"));
  CHECK_THAT(broken("\"steel\":\"1/4\"", "\"steel\":\"1/3\""), Contains("fractions add up to 1"));
  CHECK_THAT(broken("\"segments\":[[0,1]]", "\"segments\":[[0,2]]"), Contains("point 2 does not exist"));
  CHECK_THAT(broken("\"segments\":[[0,1]]", "\"segments\":[]"), Contains("nothing to measure a distance to"));
  CHECK_THAT(broken("\"at\":\"1/2\"", "\"at\":\"2\""), Contains("stops are ascending"));
}

}  // namespace
}  // namespace cnrg
