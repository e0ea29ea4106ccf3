// Gmsh's and glTF's files by hand: what is read, and the errors of those that are broken. Files of ours are read
// back in tests/app/read_back_test.cpp.
#include <cstring>

#include "csg/imports/mesh_file.h"
#include "csg/text/zip.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;
using Catch::Contains;

namespace {

/// A tetrahedron with two groups of faces, the line and the point of an edge of it, another line and another
/// point.
const std::string kMsh2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"wall\"\n$EndPhysicalNames\n"
    "$Nodes\n7\n10 0 0 0\n11 1 0 0\n12 0 1 0\n13 0 0 1\n20 5 0 0\n21 5 0 1\n22 6 0 0\n$EndNodes\n"
    "$Elements\n9\n1 15 2 0 1 10\n2 1 2 0 1 10 11\n3 2 2 7 1 10 12 11\n4 2 2 7 1 10 11 13\n5 2 2 8 2 11 12 13\n"
    "6 2 2 8 2 12 10 13\n7 4 2 9 1 10 11 12 13\n8 1 2 0 3 20 21\n9 15 2 0 2 22\n$EndElements\n";
const std::string kMsh4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nby hand\n$EndComments\n"
    "$Entities\n1 1 2 1\n1 0 0 0 0\n1 0 0 0 1 0 0 0 0\n1 0 0 0 1 1 0 2 7 9 0\n2 0 0 0 1 1 1 1 8 0\n"
    "1 0 0 0 1 1 1 0 2 1 2\n$EndEntities\n"
    "$Nodes\n2 7 10 22\n2 1 0 4\n10\n11\n12\n13\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 3 1 3\n20\n21\n22\n5 0 0 0\n5 0 1 "
    "1\n6 0 0 "
    "2\n$EndNodes\n"
    "$Elements\n6 9 1 9\n0 1 15 2\n1 10\n9 22\n1 1 1 1\n2 10 11\n2 1 2 2\n3 10 12 11\n4 10 11 13\n2 2 2 2\n5 11 "
    "12 13\n"
    "6 12 10 13\n3 1 4 1\n7 10 11 12 13\n1 3 1 1\n8 20 21\n$EndElements\n";

std::string with(std::string text, const std::string& old, const std::string& now) {
  text.replace(text.find(old), old.size(), now);
  return text;
}

/// A GLB of a document, and of floats and then 16-bit numbers.
std::string glb(std::string json, const std::vector<float>& floats, const std::vector<std::uint16_t>& numbers) {
  std::string binary(floats.size() * 4 + numbers.size() * 2, '\0');
  std::memcpy(binary.data(), floats.data(), floats.size() * 4);
  std::memcpy(binary.data() + floats.size() * 4, numbers.data(), numbers.size() * 2);
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  const auto word = [](std::size_t n) {
    const auto bits = static_cast<std::uint32_t>(n);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &bits, 4);
    return bytes;
  };
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json +
         word(binary.size()) + std::string("BIN\0", 4) + binary;
}

const std::string kScene =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)"
    R"({"children": [1, 2], "translation": [10, 0, 0]}, {"mesh": 0, "scale": [2, 2, 2]}, {"mesh": 1}], "meshes": [)"
    R"({"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}, {"primitives": [{"attributes": {"POSITION": 0},)"
    R"( "mode": 1}]}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},)"
    R"( {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}], "bufferViews": [)"
    R"({"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}], "buffers": [{"byteLength": 72}]})";
const std::vector<float> kPlaces{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<std::uint16_t> kTriangles{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

/// Two tetrahedra of one object: placed by the build, and by another object that moves it.
const std::string kModel =
    R"(<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">)"
    R"(<resources><object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>)"
    R"(<vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>)"
    R"(<triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/></triangles>)"
    R"(</mesh></object><object id="2"><components><component objectid="1" transform="2 0 0 0 2 0 0 0 2 10 0 0"/>)"
    R"(</components></object></resources><build><item objectid="1"/><item objectid="2" )"
    R"(transform="0 1 0 -1 0 0 0 0 1 0 0 5"/></build></model>)";

std::string three_mf(const std::string& model) {
  return zip({{"[Content_Types].xml", "<Types/>"}, {"3D/3dmodel.model", model}});
}

}  // namespace

TEST_CASE("3MF: objects where the build places them") {
  const Files files;
  const std::string path = files.write("t.3mf", three_mf(kModel));
  const MeshData mesh = read_mesh(path, false);
  CHECK(mesh.face_count() == 8);
  CHECK(mesh.groups == std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1});
  // Doubled, moved by 10 along x, turned so that x becomes y, raised by 5.
  CHECK(std::vector<double>(mesh.xyz.begin() + 12, mesh.xyz.end()) ==
        std::vector<double>{0, 10, 5, 0, 12, 5, -2, 10, 5, 0, 10, 7});
  CHECK(volume(soup_of(MeshShape{path, {}, false})) == Rational(3, 2));
}

TEST_CASE("3MF that is broken is refused") {
  const Files files;
  const auto error = [&](const std::string& bytes) {
    return error_of(MeshShape{files.write("bad.3mf", bytes), {}, false});
  };
  const auto model = [&](const std::string& old, const std::string& now) {
    return error(three_mf(with(kModel, old, now)));
  };
  const std::string whole = three_mf(kModel);
  CHECK_THAT(error("OFF\n"), Contains("bad.3mf: error: this is no ZIP archive"));
  CHECK_THAT(error(whole.substr(0, whole.size() - 30)), Contains("no ZIP archive"));
  CHECK_THAT(error(zip({{"a", "b"}})), Contains("the archive has no part 3D/3dmodel.model"));
  std::string damaged = whole;
  damaged[whole.find("3D/3dmodel.model") + 40] ^= 0x55;
  CHECK_THAT(error(damaged), Contains("truncated, or damaged") || Contains("no XML"));
  CHECK_THAT(model("v3=\"3\"", "v3=\"4\""), Contains("line 1: a triangle has the point 4 of 4"));
  CHECK_THAT(model("x=\"1\"", "x=\"1e999\""), Contains("is no finite number"));
  CHECK_THAT(model("x=\"1\" ", ""), Contains("the attribute x is missing"));
  CHECK_THAT(model("transform=\"2 0", "transform=\"0"), Contains("a transform has 12 numbers"));
  CHECK_THAT(model("<component objectid=\"1\"", "<component objectid=\"2\""), Contains("in a circle"));
  CHECK_THAT(model("<item objectid=\"1\"", "<item objectid=\"7\""), Contains("there is no object 7"));
  CHECK_THAT(model("<object id=\"2\"", "<object id=\"1\""), Contains("the object 1 is there twice"));
  CHECK_THAT(model("unit=", "requiredextensions=\"b\" unit="), Contains("the extension `b` is required"));
  CHECK_THAT(model("</build>", "</bild>"), Contains("this is no XML"));
  CHECK_THAT(model("<model", "<!DOCTYPE model []><model"), Contains("no DOCTYPE"));
}

TEST_CASE("Gmsh's text of both versions: faces, and what does not belong to them") {
  const Files files;
  for (const std::string& text : {kMsh2, kMsh4}) {
    const std::string path = files.write("t.msh", text);
    const MeshData mesh = read_msh(path, text, false);
    CHECK(mesh.face_count() == 4);
    CHECK(mesh.groups == std::vector<std::uint32_t>{0, 0, 1, 1});
    CHECK(mesh.wires == std::vector<std::array<std::uint32_t, 2>>{{4, 5}});
    CHECK(mesh.points == std::vector<std::uint32_t>{6});
    const Soup soup = soup_of(MeshShape{path, {}, false});
    CHECK(soup.fill(LeafId(0)) == Fill::winding);
    CHECK(volume(soup) == Rational(1, 6));
  }
  const std::string tenth = with(kMsh2, "11 1 0 0", "11 0.1 0 0");
  CHECK(volume(soup_of(MeshShape{files.write("d.msh", tenth), {}, true})) == Rational(1, 60));
}

TEST_CASE("Gmsh's text that is broken is refused with the line") {
  const Files files;
  const auto error = [&](const std::string& text) {
    return error_of(MeshShape{files.write("bad.msh", text), {}, false});
  };
  CHECK_THAT(error(with(kMsh2, "2.2 0", "2.2 1")),
             Contains("bad.msh:2: error: binary files are not read: write text"));
  CHECK_THAT(error(with(kMsh2, "2.2 0", "4.0 0")),
             Contains("the version '4.0' is not read: write version 4.1 or 2.2"));
  CHECK_THAT(error("OFF\n"), Contains("'OFF' is no beginning of a file of Gmsh"));
  CHECK_THAT(error(with(kMsh2, "2 8 2 11", "2 8 2 99")), Contains("bad.msh:24: error: there is no node 99"));
  CHECK_THAT(error(with(kMsh2, "11 1 0 0", "10 1 0 0")), Contains("the node 10 is there twice"));
  CHECK_THAT(error(with(kMsh2, "3 2 2 7 1", "3 9 2 7 1")), Contains("elements of second order are not read"));
  CHECK_THAT(error(kMsh2.substr(0, kMsh2.size() - 14)), Contains("the file ends before $EndElements"));
  CHECK_THAT(error(with(kMsh2, "$Nodes\n7", "$Nodes\n-7")), Contains("the number of nodes is negative"));
}

TEST_CASE("glTF: nodes place meshes, y becomes z") {
  const Files files;
  const std::string path = files.write("t.glb", glb(kScene, kPlaces, kTriangles));
  const MeshData mesh = read_mesh(path, false);
  REQUIRE(mesh.face_count() == 4);
  CHECK(mesh.groups.empty());
  // (x, y, z) of the file is (x, -z, y): twice as large, moved by 10 along x; then as lines, as they are.
  CHECK(mesh.xyz ==
        std::vector<double>{10, 0, 0, 12, 0, 0, 10, 0, 2, 10, -2, 0, 10, 0, 0, 11, 0, 0, 10, 0, 1, 10, -1, 0});
  CHECK(mesh.wires == std::vector<std::array<std::uint32_t, 2>>{{4, 5}, {6, 7}});
  CHECK(volume(soup_of(MeshShape{path, {}, false})) == Rational(4, 3));
  // A quarter turn about y, whose roots are rounded, is exact; a matrix by columns.
  const std::string turned =
      with(kScene, "\"scale\": [2, 2, 2]", "\"rotation\": [0, 0.7071067811865476, 0, 0.7071067811865476]");
  CHECK(read_mesh(files.write("r.glb", glb(turned, kPlaces, kTriangles)), false).xyz[4] == 1);
  CHECK(read_mesh(files.write("r.glb", glb(turned, kPlaces, kTriangles)), false).xyz[3] == 10);
  const std::string matrix =
      with(kScene, "\"scale\": [2, 2, 2]", "\"matrix\": [3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]");
  const MeshData moved = read_mesh(files.write("m.glb", glb(matrix, kPlaces, kTriangles)), false);
  CHECK(std::vector<double>(moved.xyz.begin(), moved.xyz.begin() + 6) ==
        std::vector<double>{15, -7, 6, 18, -7, 6});
}

TEST_CASE("glTF that is broken is refused") {
  const Files files;
  const auto error = [&](const std::string& bytes) {
    return error_of(MeshShape{files.write("bad.glb", bytes), {}, false});
  };
  const auto scene = [&](const std::string& old, const std::string& now) {
    return error(glb(with(kScene, old, now), kPlaces, kTriangles));
  };
  const std::string whole = glb(kScene, kPlaces, kTriangles);
  for (const std::size_t size : {std::size_t(10), std::size_t(40), whole.size() - 4})
    CHECK_THAT(error(whole.substr(0, size)), Contains("the file is truncated, or no GLB"));
  CHECK_THAT(scene("\"children\": [1, 2]", "\"children\": [0]"), Contains("in a circle"));
  CHECK_THAT(scene("\"count\": 12", "\"count\": 13"),
             Contains("/accessors/1 reaches beyond the bytes of the file"));
  CHECK_THAT(scene("\"count\": 4", "\"count\": 3"), Contains("names point 3 of 3"));
  CHECK_THAT(scene("5126", "5120"), Contains("/accessors/0 is no list of three floats"));
  CHECK_THAT(scene("\"mode\": 1", "\"mode\": 5"), Contains("has strips, fans or loops"));
  CHECK_THAT(scene("\"mesh\": 1", "\"mesh\": 2"), Contains("there is no meshes 2"));
  CHECK_THAT(scene("\"scene\": 0", "\"extensionsRequired\": [\"KHR_draco\"]"),
             Contains("the extension `KHR_draco` is not read"));
  CHECK_THAT(scene("[10, 0, 0]", "[10, 0]"), Contains("must have 3 numbers"));
  CHECK_THAT(scene("[10, 0, 0]", "[10, 0, 1e999]"), Contains("is no finite number"));
  CHECK_THAT(error(with(whole, "\"asset\"", "\"asset,")), Contains("bad.glb: error: byte 32: "));
}
