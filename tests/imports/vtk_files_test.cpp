// VTK's files of surfaces by hand: what is read, and the errors of those that are broken. The forms that VTK
// itself writes are in tests/formats/ecosystem.py.
#include <bit>

#include "csg/imports/mesh_file.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;
using Catch::Contains;

namespace {

const std::string kHead = "# vtk DataFile Version 4.2\nby hand\n";
const std::string kPoints = "POINTS 4 double\n0 0 0 1 0 0\n0 1 0 0 0 1\n";
const std::string kPolygons = "POLYGONS 4 16\n3 0 2 1\n3 0 1 3 3 1 2 3\n3 2 0 3\n";

/// The numbers, the greatest byte first.
template <class T>
std::string big(const std::vector<T>& values) {
  std::string text;
  for (const T value : values) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (std::endian::native == std::endian::little) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
  }
  return text;
}

std::string vtp(const std::string& piece, const std::string& head = " version=\"1.0\" byte_order=\"LittleEndian\"",
                const std::string& tail = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"" + head + ">\n<PolyData>\n" + piece +
         "</PolyData>\n" + tail + "</VTKFile>\n";
}
std::string array(const std::string& type, const std::string& name, const std::string& text,
                  const std::string& more = "") {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" format=\"ascii\"" + more + ">\n" + text +
         "\n</DataArray>\n";
}
std::string points(const std::string& text) {
  return "<Points>\n" + array("Float64", "Points", text, " NumberOfComponents=\"3\"") + "</Points>\n";
}
std::string cells(const std::string& kind, const std::string& connectivity, const std::string& offsets) {
  return "<" + kind + ">\n" + array("Int64", "connectivity", connectivity) + array("Int32", "offsets", offsets) +
         "</" + kind + ">\n";
}
std::string piece(const std::string& counts, const std::string& text) {
  return "<Piece " + counts + ">\n" + text + "</Piece>\n";
}

const std::string kXmlPoints = "0 0 0 1 0 0\n0 1 0\n0 0 1";
const std::string kXmlPolys = cells("Polys", "0 2 1 0 1 3 1 2 3 2 0 3", "3 6 9 12");

}  // namespace

TEST_CASE("legacy VTK and its variants") {
  const Files files;
  const std::string ascii = kHead + "ASCII\nDATASET POLYDATA\n";
  int number = 0;
  for (const std::string& text : std::vector<std::string>{
           ascii + kPoints + kPolygons,
           ascii + kPoints + "\n" + kPolygons + "POINT_DATA 4\nNORMALS n float\n" + "0 0 1 0 0 1 0 0 1 0 0 1\n",
           "# vtk DataFile Version 1.0\r\nx\r\nascii\r\ndataset polydata\r\nPoints 4 float\r\n0 0 0 1 0 0 0 1 0 0 "
           "0 "
           "1\r\n"
           "polygons 3 12\r\n3 0 2 1 3 0 1 3 3 1 2 3\r\ntriangle_strips 1 4\r\n3 2 0 3\r\n",
           ascii + "FIELD FieldData 2\nwords 1 2 string\none%20two\n\nTIME 1 1 double\n7\n" + kPoints +
               "METADATA\nINFORMATION 1\nNAME L2_NORM LOCATION vtkDataArray\nDATA 2 1 2\n\n" + kPolygons +
               "CELL_DATA 4\nSCALARS quality float 1\nLOOKUP_TABLE own\n1 2 3 4\nLOOKUP_TABLE own 2\n0 0 0 1 1 1 "
               "1 1\n"
               "COLOR_SCALARS c 3\n0 0 0 1 1 1 0 0 0 1 1 1\nTENSORS6 t float\n1 2 3 4 5 6 1 2 3 4 5 6 1 2 3 4 5 6 "
               "1 2 "
               "3 "
               "4 5 6\nMETADATA\nCOMPONENT_NAMES\nxx\n\nzz\n\n\n\n\nTEXTURE_COORDINATES t 2 float\n0 0 0 1 1 1 1 "
               "0\n"
               "FIELD f 1\nbits 1 4 bit\n0 1 0 1\n",
           "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\n" + kPoints +
               "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n0 2 1 0 1 3 1 2 3 2 0 "
               "3\n",
           kHead + "ASCII\nDATASET UNSTRUCTURED_GRID\n" + kPoints +
               "CELLS 4 16\n3 0 2 1\n3 0 1 3 3 1 2 3\n3 2 0 3\n" + "CELL_TYPES 4\n5 7 6 5\n"}) {
    check_tetrahedron(files.write(std::to_string(number++) + ".vtk", text));
  }
  const std::string binary = kHead + "BINARY\nDATASET POLYDATA\nFIELD F 1\nw 1 2 string\n" + "\xc2x\n" +
                             std::string(1, '\xc0') + "\nPOINTS 4 float\n" +
                             big<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) + "\nPOLYGONS 4 16\n" +
                             big<std::int32_t>({3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3}) +
                             "\nCELL_DATA 4\nFIELD f 2\nbits 1 4 bit\n" + std::string(1, '\x50') +
                             "\nlabel 1 4 char\n" + std::string("\1\1\2\2") + "\n";
  check_tetrahedron(files.write("b.vtk", binary));
  CHECK(read_mesh(files.path("b.vtk"), false).groups == std::vector<std::uint32_t>{0, 0, 1, 1});

  const std::string mixed =
      kHead +
      "ASCII\nDATASET POLYDATA\nPOINTS 6 float\n0 0 0 1 0 0 1 1 0 0 1 0 5 5 5 0.1 0 0\nVERTICES 1 2\n1 4\n"
      "LINES 1 4\n3 3 4 5\nPOLYGONS 1 4\n3 0 1 2\nTRIANGLE_STRIPS 1 5\n4 0 1 3 2\nCELL_DATA 4\n"
      "SCALARS label int\nLOOKUP_TABLE default\n9 9 4 5\n";
  const MeshData mesh = read_mesh(files.write("mixed.vtk", mixed), true);
  CHECK(mesh.points == std::vector<std::uint32_t>{4});
  CHECK(mesh.wires == std::vector<std::array<std::uint32_t, 2>>{{3, 4}, {4, 5}});
  CHECK(mesh.corners == std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3, 3, 1, 2});
  CHECK(mesh.groups == std::vector<std::uint32_t>{0, 1, 1});
  REQUIRE(mesh.exact.size() == 1);
  CHECK(mesh.exact[0].second[0] == Rational(1, 10));
}

TEST_CASE("legacy VTK that is broken") {
  const Files files;
  const auto error = [&](const std::string& text) {
    return error_of(MeshShape{files.write("bad.vtk", text), {}, false});
  };
  const std::string ascii = kHead + "ASCII\nDATASET POLYDATA\n",
                    grid = kHead + "ASCII\nDATASET UNSTRUCTURED_GRID\n";
  CHECK_THAT(error("<?xml?>\n"), Contains("bad.vtk:1: error: the file does not begin with") && Contains(".vtp"));
  CHECK_THAT(error("# vtk DataFile Version 6.0\nx\nASCII\n"), Contains("bad.vtk:1: error: the version '6.0'"));
  CHECK_THAT(error("# vtk DataFile Version x\nx\nASCII\n"), Contains("the version 'x'"));
  CHECK_THAT(error(kHead + "TEXT\n"), Contains("bad.vtk:3: error: 'text' is found where ASCII or BINARY"));
  CHECK_THAT(
      error(kHead + "ASCII\nDATASET STRUCTURED_GRID\n"),
      Contains("bad.vtk:4: error: a data set 'structured_grid' is no surface: write its surface as POLYDATA"));
  CHECK_THAT(error(kHead), Contains("the file ends where ASCII or BINARY is expected"));
  CHECK_THAT(error(ascii + "POINTS 2 float\n0 0 0 1 0\n"),
             Contains("bad.vtk:6: error: the file ends where a coord"));
  CHECK_THAT(error(ascii + "POINTS -2 float\n"), Contains("bad.vtk:5: error: the number of points is -2"));
  CHECK_THAT(error(ascii + "POINTS 99999999999 float\n"), Contains("which the file cannot hold"));
  CHECK_THAT(error(ascii + "POINTS 1 float\n0 0 nan\n"), Contains("bad.vtk:6: error: 'nan' is no finite number"));
  CHECK_THAT(error(ascii + "POINTS 1 string\nx\n"), Contains("points are numbers"));
  CHECK_THAT(error(ascii + kPoints + kPoints), Contains("POINTS twice"));
  CHECK_THAT(error(ascii + kPoints + "POLYGONS 1 4\n3 0 1 4\n"),
             Contains("bad.vtk:8: error: polygon 0 has the point 4, but there are 4 points"));
  CHECK_THAT(error(ascii + kPoints + "POLYGONS 1 4\n3 0 1 -1\n"), Contains("the point -1"));
  CHECK_THAT(error(ascii + kPoints + "POLYGONS 1 3\n3 0 1\n"),
             Contains("bad.vtk:8: error: cell 0 of a list is longer"));
  CHECK_THAT(error(ascii + kPoints + "POLYGONS 1 5\n3 0 1 2 3\n"),
             Contains("has 4 numbers, and its size is given as 5"));
  CHECK_THAT(error(ascii + kPoints + kPolygons + kPolygons), Contains("'polygons' twice"));
  CHECK_THAT(error(ascii + kPoints + "POLYGONS 1 4\n3 0 1.5 2\n"),
             Contains("bad.vtk:9: error: '1.5' is no whole"));
  CHECK_THAT(error(ascii + kPoints + "LINES 1 2\n1 0\n"), Contains("line 0 has 1 points, and needs at least 2"));
  CHECK_THAT(error(ascii + kPoints + "TRIANGLE_STRIPS 1 3\n2 0 1\n"), Contains("strip 0 has 2 points"));
  CHECK_THAT(error(ascii + kPoints + "CELLS 1 4\n"),
             Contains("bad.vtk:8: error: 'cells' is no part of a legacy VTK"));
  CHECK_THAT(error(ascii + kPoints + kPolygons + "CELL_DATA 3\n"),
             Contains("CELL_DATA is of 3 cells, and the file has 4"));
  CHECK_THAT(error(ascii + kPoints + kPolygons + "CELL_DATA 4\nWORDS a\n"), Contains("'words' is no attribute"));
  CHECK_THAT(error(ascii + kPoints + kPolygons + "CELL_DATA 4\nSCALARS a variant\n"),
             Contains("'variant' is no type of arrays"));
  CHECK_THAT(error(ascii + "POINTS 0 float\n"), Contains("has no faces"));
  const std::string fifth = "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\n" + kPoints;
  CHECK_THAT(error(fifth + "POLYGONS 2 3\n0 3\n0 1 2\n"), Contains("the key OFFSETS is expected"));
  CHECK_THAT(error(fifth + "POLYGONS 2 3\nOFFSETS float\n0 3\n"), Contains("cells are lists of whole numbers"));
  for (const std::string offsets : {"1 3", "0 2", "0 4"}) {
    CHECK_THAT(error(fifth + "POLYGONS 2 3\nOFFSETS int\n" + offsets + "\nCONNECTIVITY int\n0 1 2\n"),
               Contains("bad.vtk:8: error: the offsets of cells must rise from 0 to 3"));
  }
  CHECK_THAT(error(grid + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"),
             Contains("bad.vtk:10: error: cell 0 is of type 10") && Contains("write the surface"));
  CHECK_THAT(error(grid + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n5\n"),
             Contains("cell 0 has 4 points, and one of type 5 has 3"));
  CHECK_THAT(error(grid + kPoints + "CELLS 1 4\n3 0 1 2\n"), Contains("1 cells and 0 CELL_TYPES"));

  const std::string binary = kHead + "BINARY\nDATASET POLYDATA\nPOINTS 4 float\n";
  CHECK_THAT(error(binary + "xx"),
             Contains("bad.vtk: error: byte " + std::to_string(binary.size()) + ": the file ends"));
  CHECK_THAT(error(binary + big<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, HUGE_VALF, 1})),
             Contains("point 3 has a coord"));
  CHECK_THAT(error(kHead + "BINARY\nDATASET POLYDATA\nFIELD F 1\nw 1 1 string\n\xffx"),
             Contains("the file ends within"));
}

TEST_CASE("VTK's XML and its variants") {
  const Files files;
  const std::string counts = "NumberOfPoints=\"4\" NumberOfPolys=\"4\"";
  const std::string good = piece(counts, points(kXmlPoints) + kXmlPolys);
  check_tetrahedron(files.write("a.vtp", vtp(good)));
  check_tetrahedron(
      files.write("b.VTP", vtp("<FieldData><Array type=\"String\" Name=\"x\"/></FieldData>" + good, "")));
  // In two pieces, which count their points by themselves; strips come after polys.
  const MeshData two = read_mesh(
      files.write(
          "two.vtp",
          vtp(piece("NumberOfPoints=\"3\" NumberOfPolys=\"1\" NumberOfVerts=\"1\"",
                    "<CellData>" + array("Float32", "label", "7 1.5") + "</CellData>" +
                        points("0 0 0 1 0 0 0 1 0") + cells("Verts", "2", "1") + cells("Polys", "0 1 2", "3")) +
              piece("NumberOfPoints=\"4\" NumberOfStrips=\"1\" NumberOfLines=\"1\"",
                    points("5 0 0 6 0 0 5 1 0 6 1 0.1") + cells("Strips", "0 1 2 3", "4") +
                        cells("Lines", "0 1 3", "3") + "<CellData>" + array("Int8", "quality", "1 2") +
                        array("Int8", "label", "1 2") + "</CellData>"))),
      true);
  CHECK(two.points == std::vector<std::uint32_t>{2});
  CHECK(two.wires == std::vector<std::array<std::uint32_t, 2>>{{3, 4}, {4, 6}});
  CHECK(two.corners == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 5, 4, 6});
  CHECK(two.groups == std::vector<std::uint32_t>{0, 1, 1});
  CHECK(two.exact.size() == 1);

  // A header that is encoded by itself, with its padding, and one that is not; blanks among the letters.
  const auto binary = [&](const std::string& text) {
    return vtp(piece(counts, "<Points><DataArray type=\"UInt8\" NumberOfComponents=\"3\" format=\"binary\">" +
                                 text + "</DataArray></Points>" + kXmlPolys));
  };
  check_tetrahedron(files.write("c.vtp", binary("DAAAAA== AAAAAQAA AAEA AAAB")));
  check_tetrahedron(files.write("d.vtp", binary("DAAAAAAAAAEAAAABAAAAAQ==")));
}

std::string vtu(const std::string& cells, const std::string& types, const std::string& data = "") {
  return "<VTKFile type=\"UnstructuredGrid\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"4\" NumberOfCells=\"" +
         std::to_string(std::count(types.begin(), types.end(), ' ') + 1) + "\">\n" + points(kXmlPoints) +
         "<Cells>\n" + cells + array("UInt8", "types", types) + "</Cells>\n" + data +
         "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

TEST_CASE("unstructured grids in VTK's XML") {
  const Files files;
  const auto lists = [](const std::string& connectivity, const std::string& offsets) {
    return array("Int64", "connectivity", connectivity) + array("Int64", "offsets", offsets);
  };
  const std::string polys = lists("0 2 1 0 1 3 1 2 3 2 0 3", "3 6 9 12");
  check_tetrahedron(files.write("a.vtu", vtu(polys, "5 5 7 5")));
  const MeshData all =
      read_mesh(files.write("b.vtu", vtu(lists("3 0 1 0 2 1 1 2 3 0 1 2 3", "1 3 6 9 13"), "1 3 5 5 8",
                                         "<CellData>" + array("Int32", "label", "1 1 7 8 8") + "</CellData>")),
                true);
  CHECK(all.points == std::vector<std::uint32_t>{3});
  CHECK(all.wires == std::vector<std::array<std::uint32_t, 2>>{{0, 1}});
  CHECK(all.corners == std::vector<std::uint32_t>{0, 2, 1, 1, 2, 3, 0, 1, 3, 2});
  CHECK(all.groups.size() == 3);
  CHECK(all.groups[0] != all.groups[1]);
  CHECK(all.groups[1] == all.groups[2]);
  // Of a file of our own, a region and what bounds none.
  const std::string twice = lists("0 2 1 0 1 3 1 2 3 2 0 3 0 1 2 1 2 3", "3 6 9 12 15 18");
  const auto ours = [&](const std::string& dimension, const std::string& bounded) {
    return read_mesh(files.write("c.vtu", vtu(twice, "5 5 5 5 5 5",
                                              "<CellData>" + array("Int32", "dimension", dimension) +
                                                  array("Int32", "regions_bounded", bounded) + "</CellData>")),
                     true)
        .face_count();
  };
  CHECK(ours("3 3 3 3 2 2", "-1 -1 -1 -1 1 0") == 5);
  CHECK(ours("3 3 3 3 2 2", "-1 -1 -1 -1 2 1") == 4);
  const auto error = [&](const std::string& text) {
    return error_of(MeshShape{files.write("bad.vtu", text), {}, false});
  };
  CHECK_THAT(error(vtu(lists("0 1 2 3", "4"), "10")),
             Contains("bad.vtu") && Contains("cell 0 is of type 10") && Contains("write the surface of the grid"));
  CHECK_THAT(error(vtu(polys, "5 5 5 9")), Contains("cell 3 has 3 points, and one of type 9 has 4"));
  CHECK_THAT(error(vtu(lists("0 2 1", "3"), "5 5")), Contains("1 offsets of 2 cells"));
  CHECK_THAT(error(vtu(lists("0 2 9", "3"), "5")), Contains("polygon 0 has the point 9"));
  CHECK_THAT(error("<VTKFile type=\"UnstructuredGrid\"/>"), Contains("no element UnstructuredGrid"));
}

TEST_CASE("VTK's XML that is broken") {
  const Files files;
  const auto error = [&](const std::string& text) {
    return error_of(MeshShape{files.write("bad.vtp", text), {}, false});
  };
  const auto of_piece = [&](const std::string& counts, const std::string& text) {
    return error(vtp(piece(counts, text)));
  };
  const std::string counts = "NumberOfPoints=\"4\" NumberOfPolys=\"4\"", good = points(kXmlPoints) + kXmlPolys;
  CHECK_THAT(error("# vtk\n"), Contains("bad.vtp:1: error: this is no XML: "));
  CHECK_THAT(error("<a>\n<b>\n</a>"), Contains("bad.vtp:3: error: this is no XML: mismatched tag"));
  CHECK_THAT(error("<a>\n"), Contains("no element found"));
  CHECK_THAT(error("<!DOCTYPE a [<!ENTITY x \"y\">]>\n<a/>"),
             Contains("bad.vtp:1: error: files of VTK have no DOCTYPE"));
  CHECK_THAT(error("<vtk/>"), Contains("'vtk' is no VTKFile"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  CHECK_THAT(error(deep), Contains("nested too deep"));
  CHECK_THAT(error("<VTKFile type=\"ImageData\"/>"),
             Contains("a VTKFile of type 'ImageData' is no surface: write its surface as PolyData"));
  CHECK_THAT(error("<VTKFile type=\"PolyData\"/>"), Contains("no element PolyData"));
  CHECK_THAT(error(vtp("", " byte_order=\"Middle\"")), Contains("bad.vtp:2: error: the byte_order 'Middle'"));
  CHECK_THAT(error(vtp("", " header_type=\"UInt16\"")), Contains("the header_type 'UInt16'"));
  CHECK_THAT(error(vtp("", " compressor=\"vtkLZ4DataCompressor\"")),
             Contains("the compressor 'vtkLZ4DataCompressor' is not read: write the file with vtkZLib"));
  CHECK_THAT(error(vtp("")), Contains("has no faces"));
  CHECK_THAT(of_piece("NumberOfPoints=\"x\"", good), Contains("bad.vtp:4: error: NumberOfPoints is 'x'"));
  CHECK_THAT(of_piece(counts, kXmlPolys), Contains("no DataArray of Points"));
  CHECK_THAT(of_piece(counts, points("0 0 0 1 0 0 0 1 0") + kXmlPolys),
             Contains("bad.vtp:6: error: the piece has 4 points and 9 coordinates"));
  CHECK_THAT(of_piece(counts, points("0 0 0 1 0 0 0 1 0\n0 0") + kXmlPolys),
             Contains("the file ends where a coord"));
  CHECK_THAT(of_piece(counts, points("0 0 0\n1 0 x") + kXmlPolys), Contains("bad.vtp:8: error: 'x' is no number"));
  CHECK_THAT(of_piece(counts, points(kXmlPoints)), Contains("the piece has no element Polys"));
  CHECK_THAT(of_piece(counts, points(kXmlPoints) + "<Polys/>"), Contains("the array connectivity is missing"));
  CHECK_THAT(of_piece(counts, points(kXmlPoints) + cells("Polys", "0 2 1", "3")),
             Contains("1 offsets of 4 cells"));
  CHECK_THAT(of_piece(counts, points(kXmlPoints) + cells("Polys", "0 2 1", "0 3 2 3")),
             Contains("must rise to 3"));
  CHECK_THAT(of_piece(counts, points(kXmlPoints) + cells("Polys", "0 2 1", "-1 0 0 3")),
             Contains("must rise to 3"));
  CHECK_THAT(of_piece(counts, points(kXmlPoints) + cells("Polys", "0 1 2 0 1 4", "3 3 3 6")),
             Contains("bad.vtp:12: error: polygon 3 has the point 4, but there are 4 points"));
  CHECK_THAT(of_piece(counts, good + "<CellData>" + array("Int8", "label", "1 2") + "</CellData>"),
             Contains("2 labels of 4 cells"));
  CHECK_THAT(of_piece(counts, points(kXmlPoints) + "<Polys>" + array("Float32", "connectivity", "0")),
             Contains("XML"));
  CHECK_THAT(of_piece("NumberOfPoints=\"4\" NumberOfPolys=\"1\"",
                      points(kXmlPoints) + "<Polys>" + array("Float32", "connectivity", "0") + "</Polys>"),
             Contains("cells are lists of whole numbers"));
  CHECK_THAT(of_piece("NumberOfPoints=\"4\" NumberOfPolys=\"1\"",
                      points(kXmlPoints) + "<Polys>" + array("Bit", "connectivity", "0") + "</Polys>"),
             Contains("'Bit' is no type of numbers"));

  const auto binary = [&](const std::string& text, const std::string& head = "") {
    return error(vtp(piece(counts,
                           "<Points><DataArray type=\"Float64\" Name=\"P\" NumberOfComponents=\"3\" "
                           "format=\"binary\">" +
                               text + "</DataArray></Points>" + kXmlPolys),
                     head));
  };
  CHECK_THAT(binary("AAA"), Contains("bad.vtp:5: error: the array 'P' is cut off"));
  CHECK_THAT(binary("/////wAA"), Contains("the array 'P' is cut off"));
  CHECK_THAT(binary("CAAA!AAA"), Contains("letters that are not of base64"));
  CHECK_THAT(binary("AwAAAAAAAAA="), Contains("3 bytes, which are no whole numbers of type Float64"));
  CHECK_THAT(binary("CAAAAAAAAAAAAPB/"), Contains("point 0 has a coordinate that is no finite number"));
  const std::string packed = " compressor=\"vtkZLibDataCompressor\"";
  CHECK_THAT(binary("/////wAAAAAAAAAA", packed), Contains("cut off"));
  CHECK_THAT(binary("AQAAAAgAAAAIAAAABAAAAA==AAAAAA==", packed), Contains("damaged block of zlib"));
  CHECK_THAT(binary("AQAAAAAAIAAAAAAABAAAAA==AAAAAA==", packed), Contains("zlib cannot have made"));
  // Four points do not have 4 GB, whatever is packed.
  CHECK_THAT(binary("AQAAAP////8AAAAABAAAAA==AAAAAA==", packed),
             Contains("the array 'P' has far more bytes than the numbers of points and cells say"));

  const auto appended = [&](const std::string& offset, const std::string& block) {
    return error(
        vtp(piece(counts,
                  "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"" +
                      offset + "\"/></Points>" + kXmlPolys),
            "", block));
  };
  CHECK_THAT(error(vtp("<AppendedData encoding=\"raw\">_")), Contains("inside of another element"));
  CHECK_THAT(appended("0", ""), Contains("the offset 0 of the appended data, which have 0 bytes"));
  CHECK_THAT(appended("x", "<AppendedData encoding=\"raw\">_"), Contains("offset is 'x'"));
  CHECK_THAT(appended("0", "<AppendedData encoding=\"hex\">_"), Contains("the encoding 'hex' of AppendedData"));
  CHECK_THAT(appended("0", "<AppendedData encoding=\"raw\">\n  8"), Contains("does not begin with an underscore"));
  CHECK_THAT(appended("0", "<AppendedData encoding=\"raw\">_\x7f"), Contains("cut off"));
  CHECK_THAT(appended("99", "<AppendedData encoding=\"base64\">_AAAA</AppendedData>"),
             Contains("which have 4 bytes"));
}
