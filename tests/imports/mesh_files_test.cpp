// Readers of mesh files: variants that are well-formed, and the errors of those that are not.
#include <bit>
#include <cctype>
#include <cstring>

#include "csg/imports/mesh_file.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;
using Catch::Contains;

namespace {

template <class T>
std::string bytes(T value, bool big = false) {
  std::string text(sizeof value, '\0');
  std::memcpy(text.data(), &value, sizeof value);
  if (big == (std::endian::native == std::endian::little)) std::reverse(text.begin(), text.end());
  return text;
}

const float kTetrahedron[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

std::string binary_stl(const std::string& header, std::uint32_t count = 4) {
  std::string text = header;
  text.resize(80, ' ');
  text += bytes(count);
  for (const auto& face : kFaces) {
    for (int k = 0; k < 3; ++k) text += bytes(0.0f);
    for (int corner : face) {
      for (float x : kTetrahedron[corner]) text += bytes(x);
    }
    text += bytes(std::uint16_t{7});
  }
  return text;
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty double y\n" +
         "property float z\nproperty list uchar int extra\nelement face 4\nproperty uchar red\n" +
         "property list uchar uint vertex_indices\nproperty int label\nend_header\n";
}

std::string binary_ply(bool big) {
  std::string text = ply_header(big ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : kTetrahedron) {
    text += bytes(p[0], big) + bytes(static_cast<double>(p[1]), big) + bytes(p[2], big);
    text += bytes(std::uint8_t{2}) + bytes(std::int32_t{5}, big) + bytes(std::int32_t{6}, big);
  }
  for (const auto& face : kFaces) {
    text += bytes(std::uint8_t{255}) + bytes(std::uint8_t{3});
    for (int corner : face) text += bytes(static_cast<std::uint32_t>(corner), big);
    text += bytes(std::int32_t{face[0]}, big);
  }
  return text;
}

}  // namespace

TEST_CASE("OFF and its variants") {
  const Files files;
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const char* good[] = {
      "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
      "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
      "# first\nOFF # a word\n\n# counts\n4 4\n\n0 0 0 # a vertex\n1 0 0\n# between\n0 1 0\n0 0 1\n",
      "OFF4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
      "4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
      "COFF\r\n4 4 0\r\n0 0 0 1 0 0 1\r\n1 0 0 1 0 0 1\r\n0 1 0 1 0 0 1\r\n0 0 1 0.5 0.5 0.5 1\r\n",
      "NOFF\n4 4 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n",
      "STCNOFF\n4 4 0\n0 0 0 0 0 1 9 9\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n",
      "\xEF\xBB\xBFOFF\n4 4 0\n-0 0 0\n+1 0.0 -0\n0 1e0 0\n0 0 10E-1\n",
  };
  int number = 0;
  for (const char* text : good) check_tetrahedron(files.write(std::to_string(number++) + ".off", text + faces));
  check_tetrahedron(
      files.write("color.OFF", std::string(good[0]) + "3 0 2 1 255 0 0\n3 0 1 3 1\n3 1 2 3 # c\n3 2 0 3"));
}

TEST_CASE("OFF that is broken") {
  const Files files;
  const auto error = [&](const std::string& text) {
    return error_of(MeshShape{files.write("bad.off", text), {}, false});
  };
  CHECK_THAT(error(""), Contains("bad.off:1:1: error: the file is empty"));
  CHECK_THAT(error("\n \n"), Contains("the file is empty"));
  CHECK_THAT(error("PLY\n"), Contains("bad.off:1: error: 'PLY' is no OFF header"));
  CHECK_THAT(error("4OFF\n1 1 1\n"), Contains("another dimension"));
  CHECK_THAT(error("OFF BINARY\n"), Contains("binary OFF is not read"));
  CHECK_THAT(error("OFF\n"), Contains("error: the file ends where the number of vertices is expected"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n"), Contains("the file ends after 2 of 3 vertices"));
  CHECK_THAT(error("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), Contains("the file ends after 1 of 2 faces"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1"),
             Contains("bad.off:6: error: the file ends where the index"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
             Contains("bad.off:6: error: face 0 has the vertex 3, but there are 3"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), Contains("the vertex -1"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
             Contains("bad.off:4: error: 'nan' is no finite number"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 -inf 0\n0 1 0\n3 0 1 2\n"), Contains("no finite number"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 1e999 0\n0 1 0\n3 0 1 2\n"), Contains("beyond the largest double"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 1,5 0\n0 1 0\n3 0 1 2\n"), Contains("'1,5' is no number"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"), Contains("'1.5' is no whole number"));
  CHECK_THAT(error("OFF\n2 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
             Contains("bad.off:5: error: a face with 0 corners"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n"),
             Contains("bad.off:7: error: there is more data"));
  CHECK_THAT(error("OFF\n-3 1 0\n"), Contains("bad.off:2: error: the number of vertices is -3, but must be"));
  CHECK_THAT(error("\nOFF\n99999999999999999999 1 0\n"),
             Contains("bad.off:3: error: '99999999999999999999' is no"));
  CHECK_THAT(error("OFF\n999999999 999999999 0\n0 0 0\n"),
             Contains("the file ends after 1 of 999999999 vertices"));
  CHECK_THAT(error("OFF\n3 -1 0\n0 0 0\n"), Contains("the number of faces is -1"));
  CHECK_THAT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n0\n"), Contains("0 corners"));
  CHECK_THAT(error("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), Contains("has no faces, only points"));
}

TEST_CASE("files that are not there or not known") {
  const Files files;
  CHECK_THROWS_AS(prepare(MeshShape{files.path("none.off"), {}, false}), FileError);
  CHECK_THROWS_WITH(prepare(MeshShape{files.path("none.off"), {}, false}), Contains("there is no file"));
  CHECK_THAT(error_of(MeshShape{files.write("a.step", "x"), {}, false}),
             Contains("unknown format") && Contains(".ply"));
  std::filesystem::create_directories(files.path("folder.off"));
  CHECK_THROWS_AS(prepare(MeshShape{files.path("folder.off"), {}, false}), FileError);
  CHECK_THROWS_AS(prepare(MeshShape{files.write("b.off", "x"), {}, false}), LeafFileError);
}

TEST_CASE("OBJ") {
  const Files files;
  check_tetrahedron(files.write(
      "a.obj",
      "# made by hand\nmtllib x.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0 .1 .2 .3\n"
      "vt 0 0\nvn 0 0 1\nv 0 0 1\ns off\nf 1 3 2\nf 1/1 2/1 4/1\nf 2//1 3//1 4//1\nf 3/1/1 1/1/1 \\\n 4/1/1\n"));
  check_tetrahedron(files.write(
      "b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n"));
  check_tetrahedron(files.write(
      "c.obj", "f 1 3 2\r\nf 1 2 4\r\nf 2 3 4\r\nf 3 1 4\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1"));
  const Soup wires = soup_of(
      MeshShape{files.write("w.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 5 5\nl 1 2 3\nl 3 3\np 4 1\n"), {}, false});
  CHECK(wires.wires().size() == 2);
  CHECK(wires.isolated().size() == 2);
  CHECK(wires.fill(LeafId(0)) == Fill::none);

  const auto error = [&](const std::string& text) {
    return error_of(MeshShape{files.write("bad.obj", text), {}, false});
  };
  CHECK_THAT(error("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n"),
             Contains("bad.obj:5: error: the vertex index 4, but the file has 3"));
  CHECK_THAT(error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), Contains("bad.obj:4: error: the vertex index 0"));
  CHECK_THAT(error("v 0 0 0\nv 1 0 0\nf -3 1 2\nv 0 1 0\n"), Contains("bad.obj:3: error: the vertex index -3"));
  CHECK_THAT(error("v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n"),
             Contains("bad.obj:2: error: a vertex with fewer than 3"));
  CHECK_THAT(error("v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n"),
             Contains("bad.obj:2: error: 'inf' is no finite number"));
  CHECK_THAT(error("v 0 0 0\nv 1 0 0\nf 1 2\n"), Contains("bad.obj:3: error: a face with 2 corners"));
  CHECK_THAT(error("v 0 0 0\nf 1 x 1\n"), Contains("'x' is no vertex index"));
  CHECK_THAT(error("v 0 0 0\nf 1 1.5 1\n"), Contains("'1.5' is no vertex index"));
  CHECK_THAT(error("v 0 0 0\nl 1\n"), Contains("a line with fewer than 2 points"));
  CHECK_THAT(error("# nothing\n"), Contains("has no faces"));
  CHECK_THAT(error("v 0 0 0\nsurf 0 1 0 1 1\n"), Contains("free-form"));
}

TEST_CASE("STL") {
  const Files files;
  std::string text = "solid thing with words\n";
  for (const auto& face : kFaces) {
    text += "  FACET normal nan 0 0\n outer loop\n";
    for (int corner : face) {
      const float* p = kTetrahedron[corner];
      text += "vertex " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "e0\n";
    }
    text += "endloop endfacet\n";
  }
  check_tetrahedron(files.write("a.stl", text + "endsolid thing with words\n"));
  check_tetrahedron(files.write("b.stl", binary_stl("a binary file")));
  check_tetrahedron(files.write("c.stl", binary_stl("solid but binary")));

  const auto error = [&](const std::string& content) {
    return error_of(MeshShape{files.write("bad.stl", content), {}, false});
  };
  CHECK_THAT(error(text), Contains("error: the file ends where 'facet' or 'endsolid'"));
  CHECK_THAT(
      error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n"),
      Contains("bad.stl:6: error: 'endloop' is found where 'vertex'"));
  CHECK_THAT(error("solid a\nendsolid a\n"), Contains("has no faces"));
  CHECK_THAT(error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n"),
             Contains("bad.stl:4: error: 'nan'"));
  const std::string binary = binary_stl("x");
  CHECK_THAT(error(binary.substr(0, 60)), Contains("bad.stl: error: byte 60: the file ends within the header"));
  CHECK_THAT(error(binary.substr(0, 200)),
             Contains("bad.stl: error: byte 200: the file ends within triangle 3 of 4"));
  CHECK_THAT(error(binary_stl("solid x").substr(0, 200)), Contains("within triangle 3"));
  CHECK_THAT(error(binary + "more"), Contains("bad.stl: error: byte 284: more data"));
  std::string infinite = binary;
  infinite.replace(84 + 12, 4, bytes(std::numeric_limits<float>::infinity()));
  CHECK_THAT(error(infinite), Contains("bad.stl: error: byte 96: triangle 1"));
  CHECK_THAT(error(binary_stl("x", 0).substr(0, 84)), Contains("has no faces"));
}

TEST_CASE("PLY") {
  const Files files;
  std::string text = ply_header("ascii");
  for (const auto& p : kTetrahedron) {
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + " 2 5 6\n";
  }
  std::string last;
  for (const auto& f : kFaces) {
    last = "255 3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + " 1\n";
    text += last;
  }
  check_tetrahedron(files.write("a.ply", text));
  check_tetrahedron(files.write("b.ply", binary_ply(false)));
  check_tetrahedron(files.write("c.ply", binary_ply(true)));
  const MeshData labels = read_mesh(files.path("b.ply"), false);
  CHECK(labels.groups == std::vector<std::uint32_t>{0, 0, 1, 2});
  CHECK(read_mesh(files.path("a.ply"), false).groups.empty());  // one label only
  const Soup wires =
      soup_of(MeshShape{files.write("w.ply",
                                    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                                    "property float z\nelement edge 1\nproperty int vertex1\nproperty int "
                                    "vertex2\nend_header\n0 0 0.1\n1 1 1\n0 1\n"),
                        {},
                        true});
  CHECK(wires.wires().size() == 1);
  CHECK(value(wires, PointId(0))[2] == Rational(1, 10));

  const auto error = [&](const std::string& content) {
    return error_of(MeshShape{files.write("bad.ply", content), {}, false});
  };
  CHECK_THAT(error("plyx\n"), Contains("bad.ply:1: error: the file does not start with 'ply'"));
  CHECK_THAT(error("ply\nformat ascii 1.0\nelement vertex 3\n"), Contains("where 'end_header' is expected"));
  CHECK_THAT(error("ply\nformat morse 1.0\nend_header\n"), Contains("bad.ply:2: error: 'morse' is no format"));
  CHECK_THAT(error("ply\nend_header\n"), Contains("no 'format'"));
  CHECK_THAT(error("ply\nformat ascii 1.0\nend_header\n"), Contains("has no faces"));
  CHECK_THAT(error("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\nend_header\n"),
             Contains("'real' is no type"));
  CHECK_THAT(error("ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n1\n"),
             Contains("no properties x, y and z"));
  CHECK_THAT(error(text.substr(0, text.size() - last.size())), Contains("the file ends where"));
  CHECK_THAT(error(text + "1 2 3\n"), Contains("more data follows"));
  CHECK_THAT(error(text.substr(0, text.size() - last.size()) + "255 3 0 1 4 1\n"),
             Contains("face 3 has the vertex 4, but there are 4"));
  const std::string binary = binary_ply(false);
  CHECK_THAT(error(binary.substr(0, binary.size() - 3)),
             Contains("bad.ply: error: byte ") && Contains("truncated"));
  CHECK_THAT(error(binary + "x"), Contains("more data follows"));
  std::string infinite = binary;
  infinite.replace(binary.find("end_header\n") + 11, 4, bytes(std::numeric_limits<float>::quiet_NaN()));
  CHECK_THAT(error(infinite), Contains("vertex 0 has a coordinate that is no finite number"));
}

TEST_CASE("errors of damaged mesh files say where and what to do") {
  const Files files;
  const std::pair<const char*, const char*> kDamaged[] = {
      {"bad.off", "PLY\n"},
      {"bad.off", "OFF\n-3 1 0\n"},
      {"bad.off", "OFF\nx 1 0\n"},
      {"bad.off", "OFFx 1 0\n"},
      {"bad.off", "OFF\n3 -1 0\n"},
      {"bad.off", "OFF\n3\n"},
      {"bad.off", "OFF\n3 1 0\n0 0 0\n"},
      {"bad.off", "OFF\n1 1 0\n0 0 0\n"},
      {"bad.off", "OFF\n1 1 0\n0 x 0\n"},
      {"bad.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1.5\n"},
      {"bad.obj", "v 0 0 0\nf 0 1 1\n"},
      {"bad.obj", "v 0 0 0\nf a 1 1\n"},
      {"bad.obj", "v 0 0 0\nf 1 2 3\n"},
      {"bad.obj", "v 0 0 0\nf 1 -2 -1\n"},
      {"bad.obj", "v 0 0\n"},
      {"bad.obj", "v 0 0 y\n"},
      {"bad.stl", "solid a\nfoo\n"},
      {"bad.stl", "solid a\nfacet normal 0 0 1\ninner loop\n"},
      {"bad.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n"},
      {"bad.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\n"},
      {"bad.ply", "ply\nformat ascii 1.0\nvertices 3\n"},
      {"bad.vtk", "# vtk DataFile Version 3.0\ntitle\nTEXT\n"},
      {"bad.vtk", "# vtk DataFile Version 3.0\ntitle\nASCII\nPOLYDATA\n"},
      {"bad.ts", "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nVRTX 1 0 0 0\nEND\n"},
      {"bad.ts", "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nTRGL 1 2 3\nEND\n"},
  };
  for (const auto& [name, text] : kDamaged) {
    const std::string error = error_of(MeshShape{files.write(name, text), {}, false});
    INFO(error);
    const std::size_t at = error.find(": error: ");
    REQUIRE(at != std::string::npos);
    CHECK(error.find(std::string(name) + ":") != std::string::npos);
    CHECK(std::isdigit(static_cast<unsigned char>(error[at - 1])));  // the line
    const std::string said = error.substr(at + 9);
    CHECK((said.find(": ") != std::string::npos || said.find("; ") != std::string::npos));
  }
}
