// `bench/run conserve`: a tiny model of each format is read as it is meant, held exactly and held by its mesh;
// what is lost is found.
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Json = nlohmann::json;

const std::string kCommand =
    "PYTHONDONTWRITEBYTECODE=1 python3 '" CNRG_SOURCES "/bench/conserve/conserve' --cnrg ";

/// Models by the name of their file.
Json rows_of(const Workshop& w, const std::map<std::string, std::string>& files, const std::string& more = "") {
  for (const auto& [name, text] : files) {
    std::filesystem::create_directories(w.path("models/" + name).parent_path());
    w.write("models/" + name, text);
  }
  const Outcome o = w.shell(kCommand + "'" CNRG_PROGRAM "' models --json rows.json " + more + " >.out 2>.err");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  return Json::parse(w.read("rows.json"));
}

void check_held(const Json& row, std::size_t regions, double volume, double area, double length) {
  INFO(row.dump());
  REQUIRE(row.contains("exact"));
  CHECK(row["exact"] == "held");
  CHECK(row["tetrahedra_held"] == "held");
  CHECK(row["faults"].empty());
  CHECK(row["tetrahedra"] > 0);
  CHECK(row["regions"] == regions);
  CHECK(row["volume"].get<double>() == Approx(volume));
  CHECK(row["area"].get<double>() == Approx(area));
  CHECK(row["length"].get<double>() == Approx(length));
}

TEST_CASE("fracture networks are read, meshed and held", "[conserve]") {
  const Json rows = rows_of(
      Workshop(),
      {
          // A box, a fracture through all of it and one that crosses it and leaves the box.
          {"net/fracture_network.csv",
           "0,0,0,1,1,1\n0.5,0,0,0.5,1,0,0.5,1,1,0.5,0,1\n"
           "0.25,0.5,0.25,1.25,0.5,0.25,1.25,0.5,0.75,0.25,0.5,0.75\n"},
          // A circle of eight points, in a plane at right angles to x: area of an octagon of radius 2, 8 sqrt 2.
          {"ellipses/fractures.csv", "0, 0, 0, 2, 2, 0, 0, 90, 8\n"},
          {"rect.dat",
           "nUserRect: 2\nRadii:\n1\n2\nAspect_Ratio:\n1\n0.5\nAngleOption:\n1\nBeta:\n0\n30\n"
           "Translation:\n{0,0,0}\n{0,0,0}\nNormal:\n{0,0,1}\n{1,1,0}\n"},
          {"corners.dat", "// by corners\nnRectangles: 1\nCoordinates:\n{0,0,0} {2,0,0} {2,1,0} {0,1,0}\n"},
          {"well.dat", "0 0 0\n3 4 0\n3 4 12\n"},
          {"survey.dev", "# a well\n MD X Y Z\n 0 0 0 0\n 5 0 3 -4\n"},
          {"sets.py",
           "import numpy as np\nf = np.array([[0, 1, 1, 0], [0, 0, 1, 1], [0.5, 0.5, 0.5, 0.5]])\n"
           "w = np.array([[0.5, 0.5], [0.5, 0.5], [0, 1]])\n"},
      });
  check_held(rows["net/fracture_network.csv"], 2, 1, 1 + 0.75 * 0.5, 0);
  check_held(rows["ellipses/fractures.csv"], 1, rows["ellipses/fractures.csv"]["volume"], 8 * std::sqrt(2.0), 0);
  check_held(rows["rect.dat"], 1, rows["rect.dat"]["volume"], 4 + 8, 0);
  check_held(rows["corners.dat"], 1, rows["corners.dat"]["volume"], 2, 0);
  check_held(rows["well.dat"], 1, rows["well.dat"]["volume"], 0, 17);
  check_held(rows["survey.dev"], 1, rows["survey.dev"]["volume"], 0, 5);
  check_held(rows["sets.py"], 1, rows["sets.py"]["volume"], 1, 1);
}

TEST_CASE("geology and meshes are read, meshed and held", "[conserve]") {
  const std::string cube =
      "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 3 2 1\n4 4 5 6 7\n"
      "4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  const Json rows = rows_of(
      Workshop(),
      {
          {"fault.ts",
           "GOCAD TSurf 1\nHEADER {\nname: fault\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 3 0 0\nPVRTX 3 0 4 0 7\n"
           "TFACE\nATOM 4 2\nVRTX 5 3 4 1\nTRGL 1 2 3\nTRGL 4 5 3\nEND\n"},
          {"line.pl",
           "GOCAD PLine 1\nHEADER {\nname: line\n}\nILINE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 1 2 0\nSEG 1 2\n"
           "SEG 2 3\nSEG 3 2\nEND\n"},
          {"cube.off", cube},
          {"two.msh",
           "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n"
           "$EndNodes\n$Elements\n4\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 2 3 4 5\n3 2 2 3 3 2 3 4\n4 1 2 4 4 4 1\n"
           "$EndElements\n"},
          {"tet.smesh",
           "4 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n0\n0\n"},
          {"city.json", R"({"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "CityObjects": {"a": {"geometry": [
      {"type": "Solid", "boundaries": [[[[0,2,1]],[[0,1,3]],[[1,2,3]],[[0,3,2]]]]}]}}})"},
          {"a/sheet.obj", "v 0 0 0.5\nv 1 0 0.5\nv 0 1 0.5\nf 1 2 3\n"},
          {"bad.ts", "GOCAD TSurf 1\nEND\n"},
          {"other.xyz", "nothing of ours\n"},
      });
  CHECK(rows.size() == 8);
  // The area of the triangle 2 5 3: half of |(0, 4, 1) x (-3, 4, 0)| = |(-4, -3, 12)| = 13.
  check_held(rows["fault.ts"], 1, rows["fault.ts"]["volume"], 6 + 6.5, 0);
  check_held(rows["line.pl"], 1, rows["line.pl"]["volume"], 0, 3);
  check_held(rows["cube.off"], 1, 1, 0, 0);
  check_held(rows["two.msh"], 2, 1.0 / 6 + 2.0 / 6, std::sqrt(3.0) / 2, 1);
  check_held(rows["tet.smesh"], 1, 1.0 / 6, 0, 0);
  check_held(rows["city.json"], 1, 1.0 / 6, 0, 0);
  check_held(rows["a/sheet.obj"], 1, rows["a/sheet.obj"]["volume"], 0.5, 0);
  CHECK(rows["bad.ts"]["left_out"] == "no triangles and no lines in it");
}

TEST_CASE("a script of Gmsh is triangulated in a copy of its folder", "[conserve]") {
  const Workshop w;
  const Json rows = rows_of(
      w, {
             {"box.geo",
              "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 2, 3};\nMesh.CharacteristicLengthMin = 2;\n"
              "Mesh 2;\nSave \"box.msh\";\n"},
             {"calls.geo", "SystemCall \"true\";\n"},
         });
  check_held(rows["box.geo"], 1, 6, 0, 0);
  CHECK_FALSE(std::filesystem::exists(w.path("models/box.msh")));
  CHECK(rows["calls.geo"]["left_out"] == "it wants to run other programs");
}

TEST_CASE("the files of a folder make one model", "[conserve]") {
  const auto triangle = [](const std::string& points) {
    return "GOCAD TSurf 1\nVRTX 1 " + points + "\nTRGL 1 2 3\nEND\n";
  };
  const Json rows = rows_of(Workshop(),
                            {{"faults/a.ts", triangle("0 0 0\nVRTX 2 2 0 0\nVRTX 3 0 2 0")},
                             {"faults/b.ts", triangle("0.5 0.5 -1\nVRTX 2 0.5 0.5 1\nVRTX 3 1.5 0.5 1")}},
                            "--together");
  CHECK(rows.size() == 1);
  check_held(rows["faults"], 1, rows["faults"]["volume"], 2 + 1, 0);
}

/// A program that answers as ours does, but for what a filter of Python does to a file that it writes.
void write_liar(const Workshop& w, const std::string& file, const std::string& filter) {
  w.write("liar", "#!/bin/sh\n'" CNRG_PROGRAM "' \"$@\" || exit\n[ -e " + file +
                      " ] || exit 0\npython3 - <<'END'\n" + "text = open('" + file + "').read()\n" + filter +
                      "\nopen('" + file + "', 'w').write(text)\nEND\n");
  std::filesystem::permissions(w.path("liar"), std::filesystem::perms::owner_all);
}

TEST_CASE("what is lost is found", "[conserve]") {
  const Workshop w;
  std::filesystem::create_directories(w.path("models"));
  w.write("models/net.csv",
          "0,0,0,1,1,1\n0.5,0,0,0.5,1,0,0.5,1,1,0.5,0,1\n"
          "0.25,0.5,0.25,0.75,0.5,0.25,0.75,0.5,0.75,0.25,0.5,0.75\n");
  struct Lie {
    std::string file, filter, fault;
  };
  const std::string json = "import json\nd = json.loads(text)\n", back = "\ntext = json.dumps(d)";
  const Lie lies[] = {
      {"model.json",
       json + "d['regions'][[r['bounded'] for r in d['regions'] if r].index(True)]['volume'] = '1/3'" + back,
       "volume of the regions, and of the domain"},
      {"model.json",
       json +
           "for f in d['faces']:\n  if len(f['origin']) == 1 and f['origin'][0]['leaf'] == 2:\n"
           "    f['component'] = 0\n    break" +
           back,
       "area of sheet 1 fracture 2"},
      {"model.msh", "text = text.replace('\\n1 1 1\\n', '\\n1 1 0.999999\\n')", "volume of"},
      {"model.msh", "text = 'nothing'", "regions with tetrahedra"},
  };
  for (const Lie& lie : lies) {
    INFO(lie.file << ": " << lie.filter);
    write_liar(w, lie.file, lie.filter);
    const Outcome o = w.shell(kCommand + "./liar models >.out 2>.err");
    INFO(o.out << o.err);
    CHECK(o.status == 1);
    CHECK_THAT(o.err, Contains(lie.fault));
  }
}

}  // namespace
}  // namespace cnrg
