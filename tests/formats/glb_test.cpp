// GLB: taken apart by a reader of the test, and by Khronos's validator, where npm can fetch it.
#include <sys/wait.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/tree/tree.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Point = std::array<double, 3>;

struct Vertex {
  Point at, normal;  ///< in the model
};

/// A node with its mesh in coordinates of the model.
struct GlbPart {
  int mode = 0;
  std::size_t mesh = 0;
  std::string material;
  std::array<double, 4> color{};
  bool both_sides = false, unlit = false;
  nlohmann::json extras;
  std::vector<Vertex> corners;  ///< by index: three of a triangle, two of a segment

  double volume() const {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const Point &a = corners[i].at, &b = corners[i + 1].at, &c = corners[i + 2].at;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3]);
      }
    }
    return sum / 6;
  }
};

struct Glb {
  nlohmann::json document;
  std::map<std::string, std::vector<GlbPart>> parts;  ///< by name of the node

  const GlbPart& one(const std::string& name) const {
    const auto found = parts.find(name);
    if (found == parts.end() || found->second.size() != 1) throw std::runtime_error("not one node " + name);
    return found->second[0];
  }
};

std::uint32_t number4_at(const std::string& bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (int k = 4; k-- > 0;) n = n << 8 | std::uint8_t(bytes.at(at + std::size_t(k)));
  return n;
}

Point by_quaternion(const nlohmann::json& q, const Point& p) {
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const Point t{2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])};
  return {p[0] + w * t[0] + y * t[2] - z * t[1], p[1] + w * t[1] + z * t[0] - x * t[2],
          p[2] + w * t[2] + x * t[1] - y * t[0]};
}

Glb read_glb(const std::string& bytes) {
  REQUIRE(bytes.substr(0, 4) == "glTF");
  CHECK(number4_at(bytes, 4) == 2);
  CHECK(number4_at(bytes, 8) == bytes.size());
  const std::size_t length = number4_at(bytes, 12);
  CHECK(length % 4 == 0);
  REQUIRE(bytes.substr(16, 4) == "JSON");
  Glb glb;
  glb.document = nlohmann::json::parse(bytes.substr(20, length));
  const auto& d = glb.document;
  std::size_t begin = 20 + length;
  if (begin < bytes.size()) {
    CHECK(number4_at(bytes, begin) == bytes.size() - begin - 8);
    REQUIRE(bytes.substr(begin + 4, 4) == std::string("BIN\0", 4));
    CHECK(d["buffers"][0]["byteLength"] == bytes.size() - begin - 8);
    begin += 8;
  }
  const auto numbers = [&](std::size_t accessor, auto kind, std::size_t parts) {
    const auto& a = d["accessors"][accessor];
    const auto& view = d["bufferViews"][a["bufferView"].get<std::size_t>()];
    std::size_t at = begin + view["byteOffset"].get<std::size_t>() + a.value("byteOffset", std::size_t(0));
    std::vector<decltype(kind)> all;
    for (std::size_t i = 0; i < a["count"].get<std::size_t>() * parts; ++i, at += 4) {
      all.push_back(std::bit_cast<decltype(kind)>(number4_at(bytes, at)));
    }
    return all;
  };
  const auto& root = d["nodes"][0];
  for (const auto& child : root.value("children", nlohmann::json::array())) {
    const auto& node = d["nodes"][child.get<std::size_t>()];
    GlbPart part;
    part.mesh = node["mesh"];
    part.extras = node.value("extras", nlohmann::json());
    const auto& primitives = d["meshes"][part.mesh]["primitives"];
    REQUIRE(primitives.size() == 1);
    const auto& primitive = primitives[0];
    part.mode = primitive["mode"];
    const auto& material = d["materials"][primitive["material"].get<std::size_t>()];
    part.material = material["name"];
    for (std::size_t k = 0; k < 4; ++k) part.color[k] = material["pbrMetallicRoughness"]["baseColorFactor"][k];
    part.both_sides = material.value("doubleSided", false);
    part.unlit = material.contains("extensions");
    const auto& attributes = primitive["attributes"];
    const auto positions = numbers(attributes["POSITION"], float(), 3);
    std::vector<float> normals(positions.size());
    CHECK(attributes.contains("NORMAL") == (part.mode == 4));
    if (part.mode == 4) normals = numbers(attributes["NORMAL"], float(), 3);
    for (const std::uint32_t i : numbers(primitive["indices"], std::uint32_t(), 1)) {
      Vertex v;
      for (std::size_t k = 0; k < 3; ++k) {
        v.at[k] = positions[3 * i + k] + node.value("translation", std::vector<double>{0, 0, 0})[k];
        v.at[k] *= root["scale"][k].get<double>();
        v.normal[k] = normals[3 * i + k];
      }
      v.at = by_quaternion(root["rotation"], v.at);
      v.normal = by_quaternion(root["rotation"], v.normal);
      for (std::size_t k = 0; k < 3; ++k) v.at[k] += root["translation"][k].get<double>();
      // From y upwards to z upwards.
      v.at = {v.at[0], -v.at[2], v.at[1]};
      v.normal = {v.normal[0], -v.normal[2], v.normal[1]};
      part.corners.push_back(v);
    }
    glb.parts[node["name"]].push_back(part);
  }
  return glb;
}

Result glb_result(const std::string& tree) { return evaluate(parse_tree(tree, "t.yaml")).result(); }

std::string glb_bytes(const Result& result, RoundingReport* report = nullptr) {
  const ScratchFolder dir;
  const RoundingReport said = write(dir / "m.glb", result);
  if (report != nullptr) *report = said;
  return text_of(dir / "m.glb");
}

const char* const kSlope = R"(cnrg: 1
materials: {rock: {color: "#ff8000"}}
nodes:
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}, material: rock}
  fault:  {polygon: [[20, -5, -5], [70, -5, 65], [70, 105, 65], [20, 105, -5]]}
  bolt:   {polyline: [[60, 50, 30], [60, 50, 50]]}
  flag:   {polygon: [[100, 50, 60], [110, 50, 60], [110, 50, 70]]}
  dot:    {points: [[120, 0, 0]]}
  inside: {intersection: [fault, ground]}
  model:  {union: [bolt, inside, flag, dot, ground], dominance: left}
result: model
)";

}  // namespace

TEST_CASE("glb: regions, sheets, wires and points with names and colours") {
  const Glb glb = read_glb(glb_bytes(glb_result(kSlope)));
  CHECK(glb.document["asset"]["version"] == "2.0");
  CHECK(glb.parts.size() == 5);
  double volume = 0;
  for (const std::string name : {"ground 1", "ground 2"}) {
    const GlbPart& part = glb.one(name);
    CHECK(part.mode == 4);
    CHECK(part.material == "rock");
    CHECK(part.color[0] == 1);
    CHECK(part.color[1] == Approx(0.2158605));  // 128 of 255 in sRGB
    CHECK(part.color[2] == 0);
    CHECK_FALSE(part.both_sides);
    CHECK(part.extras["material"] == "rock");
    volume += part.volume();
  }
  CHECK(volume == Approx(600000));
  const GlbPart& flag = glb.one("face of flag");
  CHECK(flag.mode == 4);
  CHECK(flag.both_sides);
  CHECK(flag.corners.size() == 3);
  const GlbPart& bolt = glb.one("wire of bolt");
  CHECK(bolt.mode == 1);
  CHECK(bolt.unlit);
  REQUIRE(bolt.corners.size() == 2);
  for (const Vertex& v : bolt.corners) {
    CHECK(v.at[0] == Approx(60));
    CHECK(v.at[1] == Approx(50));
    CHECK((v.at[2] == Approx(30) || v.at[2] == Approx(50)));
  }
  const GlbPart& dot = glb.one("point of dot");
  CHECK(dot.mode == 0);
  REQUIRE(dot.corners.size() == 1);
  CHECK(dot.corners[0].at[0] == Approx(120));
  CHECK(glb.document["extensionsUsed"] == nlohmann::json{"KHR_materials_unlit"});
}

TEST_CASE("glb: normals of flat faces are theirs, those of curved faces of the true surface") {
  const char* const tree = R"(cnrg: 1
nodes:
  drum:  {cylinder: {from: [1, 2, 3], to: [1, 2, 7], radius: 2, segments: 8}}
  half:  {box: {min: [1, -9, -9], max: [9, 9, 9]}}
  model: {intersection: [drum, half]}
result: model
)";
  const Glb glb = read_glb(glb_bytes(glb_result(tree)));
  REQUIRE(glb.parts.size() == 1);
  const GlbPart& part = glb.parts.begin()->second[0];
  std::size_t round = 0, flat = 0;
  for (std::size_t i = 0; i < part.corners.size(); i += 3) {
    Point p[3], mean{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) mean[c] += (p[k][c] = part.corners[i + k].at[c]) / 3;
    }
    // Outward, as the triangle runs.
    Point n;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      n[k] = (p[1][a] - p[0][a]) * (p[2][b] - p[0][b]) - (p[1][b] - p[0][b]) * (p[2][a] - p[0][a]);
    }
    const double length = std::hypot(n[0], n[1], n[2]);
    const bool on_side = std::abs(n[2]) < 1e-5 && n[0] > 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex& v = part.corners[i + k];
      const Point radial{(v.at[0] - 1) / 2, (v.at[1] - 2) / 2, 0};
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = on_side ? radial[c] : n[c] / length;
        CHECK(v.normal[c] == Approx(expected).margin(1e-5));
      }
    }
    ++(on_side ? round : flat);
  }
  CHECK(round == 8);
  CHECK(flat > 6);

  // Without true surfaces facets are what is meant.
  const ScratchFolder dir;
  write(dir / "m.json", glb_result(tree));
  const Glb plain = read_glb(glb_bytes(read_result(dir / "m.json")));
  for (const Vertex& v : plain.parts.begin()->second[0].corners) {
    CHECK((std::abs(v.normal[2]) == Approx(1).margin(1e-6) || v.normal[2] == Approx(0).margin(1e-6)));
  }
}

TEST_CASE("glb: a sphere has the normals of a sphere, poles and all; halves of two leaves, too") {
  const char* const tree = R"(cnrg: 1
nodes:
  ball:  {sphere: {center: [0, 0, 0], radius: 3, segments: 12}}
  cap:   {box: {min: [-4, -4, 1], max: [4, 4, 4]}}
  other: {sphere: {center: [0, 0, 0], radius: 3, segments: 12}}
  rest:  {difference: [other, cap]}
  top:   {intersection: [ball, cap]}
  model: {unify: {union: [rest, top]}}
result: model
)";
  const Glb glb = read_glb(glb_bytes(glb_result(tree)));
  REQUIRE(glb.parts.size() == 1);
  const GlbPart& part = glb.parts.begin()->second[0];
  CHECK(part.corners.size() > 300);
  for (const Vertex& v : part.corners) {
    const double length = std::hypot(v.at[0], v.at[1], v.at[2]);
    // Corners on the cut are on facets, within the chord of the sphere.
    for (std::size_t k = 0; k < 3; ++k) CHECK(v.normal[k] == Approx(v.at[k] / length).margin(0.06));
  }
}

TEST_CASE("glb: what is equal but for an exact translation is one mesh with several nodes") {
  const std::string pins = R"(cnrg: 1
materials: {steel: {color: "#667788"}}
nodes:
  pin:    {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 12}, name: pin}
  second: {simplify: pin, translate: ["10/3", 0, 0]}
  third:  {simplify: pin, translate: [0, 5, 1]}
  turned: {simplify: pin, rotate: {axis: [1, 0, 0], degrees: 90}, translate: [9, 9, 9]}
  model:  {union: [pin, second, third, turned]}
  steel:  {union: [model, pin], material: steel}
result: )";
  // Each region has a colour of its own: a mesh each, on the same numbers.
  const Glb colored = read_glb(glb_bytes(glb_result(pins + "model\n")));
  CHECK(colored.document["meshes"].size() == 4);
  CHECK(colored.document["accessors"].size() == 6);

  const Glb glb = read_glb(glb_bytes(glb_result(pins + "steel\n")));
  CHECK(glb.document["meshes"].size() == 2);
  std::map<std::size_t, int> uses;
  std::multiset<int> x;
  double volume = 0;
  for (const auto& [name, parts] : glb.parts) {
    for (const GlbPart& part : parts) {
      ++uses[part.mesh];
      volume += part.volume();
      double low = 1e9;
      for (const Vertex& v : part.corners) low = std::min(low, v.at[0]);
      x.insert(int(std::lround(3 * low)));
    }
  }
  CHECK(volume == Approx(4 * 4 * 3.0));  // a regular dodecagon of radius 1 has the area 3
  CHECK(x == std::multiset<int>{-3, -3, 7, 24});
  std::multiset<int> counts;
  for (const auto& [mesh, n] : uses) counts.insert(n);
  CHECK(counts == std::multiset<int>{1, 3});
}

TEST_CASE("glb: far from the origin positions keep their precision, and simple ones are exact") {
  const char* const tree = R"(cnrg: 1
nodes:
  a: {box: {min: [4000000, 6000000, 100], max: [4000001, 6000003, 100.25]}}
result: a
)";
  RoundingReport report;
  const Glb glb = read_glb(glb_bytes(glb_result(tree), &report));
  CHECK(report.notices.empty());
  for (const Vertex& v : glb.one("a").corners) {
    CHECK((v.at[0] == Approx(4000000).epsilon(1e-14) || v.at[0] == Approx(4000001).epsilon(1e-14)));
    CHECK((v.at[1] == Approx(6000000).epsilon(1e-14) || v.at[1] == Approx(6000003).epsilon(1e-14)));
  }
  const Result thirds = glb_result("cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1/3]}}\nresult: a\n");
  glb_bytes(thirds, &report);
  REQUIRE(report.notices.size() == 1);
  CHECK_THAT(report.notices[0], Catch::Contains("32 bits: they are off by 5e-09 at most"));
}

TEST_CASE("glb: nothing, and what it cannot hold") {
  const std::string head = R"(cnrg: 1
nodes:
  a:     {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  none:  {difference: [a, a]}
  inner: {interior: a}
  rest:  {complement: a}
)";
  const Glb glb = read_glb(glb_bytes(glb_result(head + "result: none\n")));
  CHECK(glb.parts.empty());
  CHECK_FALSE(glb.document.contains("buffers"));
  const ScratchFolder dir;
  CHECK_THROWS_WITH(write(dir / "m.glb", glb_result(head + "result: inner\n")),
                    Catch::Contains("apply `closure`"));
  CHECK_THROWS_WITH(write(dir / "m.glb", glb_result(head + "result: rest\n")), Catch::Contains("without bounds"));
}

TEST_CASE("glb: names are on one line, as they may be shown") {
  const Glb glb = read_glb(glb_bytes(glb_result(
      "cnrg: 1\nnodes:\n  \"x\\n\\u202e\": {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nresult: \"x\\n\\u202e\"\n")));
  CHECK(glb.parts.begin()->first == "x\\n\\u202e");
  CHECK(glb.document["nodes"][0]["name"] == "x\\n\\u202e");
}

TEST_CASE("glb: the same result gives the same bytes") {
  CHECK(glb_bytes(glb_result(kSlope)) == glb_bytes(glb_result(kSlope)));
}

TEST_CASE("glb: Khronos's validator has nothing to say", "[programs]") {
  const ScratchFolder dir;
  std::string files;
  const auto add = [&](const std::string& name, const std::string& tree) {
    write(dir / name, glb_result(tree));
    files += " " + (dir / name);
  };
  add("slope.glb", kSlope);
  add("empty.glb",
      "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
      "  none: {difference: [a, a]}\nresult: none\n");
  add("wire.glb", "cnrg: 1\nnodes:\n  a: {polyline: [[0, 0, 0], [1, 1, 1]]}\nresult: a\n");
  add("dot.glb", "cnrg: 1\nnodes:\n  a: {points: [[1e9, 0, 0]]}\nresult: a\n");
  add("pins.glb",
      "cnrg: 1\nnodes:\n  a: {cone: {from: [0, 0, 0], to: [0, 0, 1], radius: 1}, name: \"\\u00fc \\\\ \\u202e\"}\n"
      "  b: {simplify: a, translate: [5, 0, 0]}\n  all: {union: [a, b]}\nresult: all\n");
  const int status =
      std::system(("tests/formats/gltf/run build/gltf" + files + " >" + (dir / "said") + " 2>&1").c_str());
  const std::string said = text_of(dir / "said");
  if (WIFEXITED(status) && WEXITSTATUS(status) == 77) {
    WARN(said);
    return;
  }
  CHECK(status == 0);
  CHECK(said == "");
}
