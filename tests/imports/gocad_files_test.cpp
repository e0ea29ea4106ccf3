// GOCAD's surfaces, lines and wells: variants that are well-formed, and the errors of those that are not.
#include "csg/imports/mesh_file.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;
using Catch::Contains;

namespace {

std::string object(const std::string& type, const std::string& body, const std::string& positive = "Elevation") {
  return "GOCAD " + type +
         " 1 \nHEADER {\nname: a part\n*solid*color: 1 0 0 1\nEND of a note\nVRTX in a note\n}\n"
         "GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME \" gocad Local\" \nAXIS_UNIT \"m\" \"m\" \"m\"\nZPOSITIVE " +
         positive + "\nEND_ORIGINAL_COORDINATE_SYSTEM\n" + body + "END\n";
}

const std::string kGocadTetrahedron =
    "VRTX 1 0 0 0\nPVRTX 20 1 0 0 0.25 -99999 CNXYZ\nVRTX 3 0 1 0\nPVRTX 4 0 0 1 7 8\n"
    "TRGL 1 3 20\nTRGL 1 20 4\nTRGL 20 3 4 \nTRGL 3 1 4\n";

using Wires = std::vector<std::array<std::uint32_t, 2>>;

}  // namespace

TEST_CASE("GOCAD surfaces") {
  const Files files;
  const auto soup = [&](const std::string& text) {
    return soup_of(MeshShape{files.write("a.TS", text), {}, false});
  };
  const Soup plain = soup("# made by hand\r\n\n" + object("TSurf", "TFACE\n" + kGocadTetrahedron));
  CHECK(plain.fill(LeafId(0)) == Fill::winding);
  CHECK(plain.face_count() == 4);
  CHECK(volume(plain) == Rational(1, 6));
  // Words that are of no matter here, and blocks of them.
  CHECK(soup("GOCAD TSurf 1\nHEADER {name:x}\nPROPERTIES a b\nPROPERTY_CLASS_HEADER a {\nkind: b\nunit: m\n}\n"
             "PROPERTY_CLASS_HEADER b\n{\nTRGL\n}\nTFACE\n" +
             kGocadTetrahedron + "BSTONE 1\nBORDER 7 1 20\nEND")
            .face_count() == 4);

  const MeshData two = read_mesh(
      files.write("two.ts",
                  object("SGrid", "VRTX of a grid\nTRGL x\n") +
                      object("TSurf", "TFACE\n" + kGocadTetrahedron +
                                          "TFACE\nATOM 7 20\nPATOM 8 3 0.5\nVRTX 9 1 1 0\nTRGL 7 8 9\n") +
                      object("TSurf", "VRTX 1 5 0 2\nVRTX 2 6 0 2\nVRTX 3 5 1 2.1\nTRGL 1 2 3\n", "Depth") +
                      object("PLine", "ILINE\nVRTX 1 0 0 0\nVRTX 2 0 0 9\nSEG 1 2\n", "Depth")),
      true);
  CHECK(two.groups == std::vector<std::uint32_t>{0, 0, 0, 0, 1, 2});
  CHECK(std::vector<std::uint32_t>(two.corners.end() - 6, two.corners.end()) ==
        std::vector<std::uint32_t>{1, 2, 4, 5, 6, 7});
  CHECK(two.xyz[5 * 3 + 2] == -2);
  CHECK(two.xyz[3 * 3 + 2] == 1);  // of the first surface, which has elevations
  REQUIRE(two.exact.size() == 1);
  CHECK(two.exact[0].second == RationalPoint{5, 1, Rational(-21, 10)});
  CHECK(two.wires == Wires{{8, 9}});
  CHECK(two.xyz[9 * 3 + 2] == -9);

  // Coplanar triangles of two parts are two faces, those of one part are one.
  const std::string corners = "VRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 1 1 0\nVRTX 4 0 1 0\n";
  const auto faces = [&](const std::string& between) {
    std::set<std::uint32_t> numbers;
    const Soup made = soup(object("TSurf", corners + "TRGL 1 2 3\n" + between + "TRGL 1 3 4\n"));
    for (SourceId f : IdRange<SourceId>(made.face_count())) numbers.insert(made.face(f).leaf_face);
    return numbers.size();
  };
  CHECK(faces("") == 1);
  CHECK(faces("TFACE\n") == 2);
}

TEST_CASE("GOCAD lines and wells") {
  const Files files;
  const MeshData lines = read_mesh(
      files.write("a.pl", object("PLine",
                                 "ILINE\nVRTX 1 0 0 0\nPVRTX 2 1 0 0 5\nVRTX 3 1 1 0\nSEG 1 2 \nSEG 2 3 \n"
                                 "SEG 3 1\nILINE\nVRTX 4 0 0 5\nATOM 5 1\nSEG 4 5\n")),
      false);
  CHECK(lines.wires == Wires{{0, 1}, {1, 2}, {2, 0}, {3, 0}});
  CHECK(lines.point_count() == 4);

  const std::string path =
      "WREF 100.1 200 -5\nDATUM KellyBushing\nKB -0\nPATH 0 -5 0 0\nPATH 10.5 5.25 0.2 -1\nPATH 20 15 0.2 -1.5\n"
      "MRKR top 1 3.5\nNORM 0 0 1\nWELL_CURVE\nPROPERTY a\nEND_CURVE\n";
  const MeshData depth = read_mesh(files.write("a.wl", object("Well", path, "Depth")), true);
  CHECK(depth.wires == Wires{{0, 1}, {1, 2}});
  CHECK(depth.xyz[2] == 5);
  REQUIRE(depth.exact.size() == 3);
  CHECK(depth.exact[1].second == RationalPoint{Rational(1003, 10), 199, Rational(-21, 4)});
  const MeshData doubles = read_mesh(files.write("b.wl", object("Well", path)), false);
  CHECK(doubles.exact.empty());
  CHECK(doubles.xyz[3] == 100.1 + 0.2);
  CHECK(doubles.xyz[5] == 5.25);
  const MeshData vertices =
      read_mesh(files.write("c.wl", object("Well", "WREF 1 2 3\nVRTX 1 2 3\nVRTX 1 2 -3\n")), false);
  CHECK(vertices.wires == Wires{{0, 1}});
  CHECK(soup_of(MeshShape{files.write("d.wl", object("Well", path)), {}, false}).wires().size() == 2);
}

TEST_CASE("GOCAD files that are broken") {
  const Files files;
  const auto error = [&](const std::string& text) {
    return error_of(MeshShape{files.write("bad.ts", text), {}, false});
  };
  CHECK_THAT(error(""), Contains("bad.ts:1:1: error: the file is empty"));
  CHECK_THAT(error("TSurf\n"), Contains("bad.ts:1: error: 'TSurf' where an object begins: `GOCAD TSurf 1`"));
  CHECK_THAT(error("GOCAD Voxet 1\nEND\n"), Contains("bad.ts:1: error: no object is a TSurf, PLine or Well"));
  CHECK_THAT(error("GOCAD TSurf 1\n"), Contains("the file ends within the object of line 1, which has no END"));
  CHECK_THAT(error("GOCAD TSurf 1\nTFACE\nGOCAD TSurf 1\nEND\n"),
             Contains("bad.ts:3: error: an object begins, but that of line 1 has no END"));
  CHECK_THAT(error("GOCAD TSurf 1\nHEADER {\nname: x\n"),
             Contains("bad.ts:2: error: a block that is not closed: add a line with }"));
  CHECK_THAT(error("GOCAD TSurf 1\nZPOSITIVE Up\nEND\n"),
             Contains("bad.ts:2: error: ZPOSITIVE is 'Up': it must be Elevation or Depth"));
  CHECK_THAT(error("GOCAD TSurf 1\nZPOSITIVE\nEND\n"), Contains("ZPOSITIVE has 0 entries"));
  CHECK_THAT(error("GOCAD TSurf 1\nVRTX 1 0 0\nVRTX 2 0 0 0\nEND\n"),
             Contains("bad.ts:2: error: VRTX has 3 entries: give its number, x, y and z"));
  CHECK_THAT(error("GOCAD TSurf 1\nVRTX 1 0 0 0\nVRTX 1 0 0 1\nEND\n"),
             Contains("bad.ts:3: error: the vertex 1 was given in line 2"));
  CHECK_THAT(error("GOCAD TSurf 1\nVRTX 1 0 0 inf\nEND\n"),
             Contains("bad.ts:2: error: 'inf' is no finite number"));
  CHECK_THAT(error("GOCAD TSurf 1\nVRTX x 0 0 0\nEND\n"), Contains("'x' is no whole number"));
  CHECK_THAT(error("GOCAD TSurf 1\nATOM 2 1\nEND\n"),
             Contains("bad.ts:2: error: the vertex 1 did not come before"));
  // Numbers of another object are not known.
  CHECK_THAT(error(object("TSurf", kGocadTetrahedron) + "GOCAD TSurf 1\nTRGL 1 3 4\nEND\n"),
             Contains("bad.ts:23: error: the vertex 1 did not come before in the object of line 22"));
  CHECK_THAT(error("GOCAD TSurf 1\nVRTX 1 0 0 0\nTRGL 1 1\nEND\n"),
             Contains("bad.ts:3: error: TRGL has 2 entries: give the numbers of three vertices"));
  CHECK_THAT(error("GOCAD TSurf 1\nVRTX 1 0 0 0\nEND\n"), Contains("has no faces, only points"));
  CHECK_THAT(error("GOCAD PLine 1\nILINE\nVRTX 1 0 0 0\nEND\n"),
             Contains("bad.ts:2: error: a line without segments: give them as SEG"));
  CHECK_THAT(error("GOCAD PLine 1\nILINE\nILINE\nEND\n"), Contains("bad.ts:2: error: a line without segments"));
  CHECK_THAT(error("GOCAD Well 1\nWREF 0 0 0\nPATH 0 0 0 0\nEND\n"),
             Contains("bad.ts:1: error: a well with 1 point of its path: give at least 2"));
  CHECK_THAT(error("GOCAD Well 1\nPATH 0 0 0 0\nEND\n"),
             Contains("bad.ts:2: error: PATH counts x and y from WREF"));
  CHECK_THAT(error("GOCAD Well 1\nWREF 0 0 0\nTVSS_PATH 0 0 0 0\nEND\n"),
             Contains("bad.ts:3: error: a path given by TVSS_PATH is not read"));
  CHECK_THAT(error("GOCAD Well 1\nWREF 1e308 0 0\nPATH 0 0 1e308 0\nEND\n"),
             Contains("bad.ts:3: error: a coordinate beyond the largest double"));
}
