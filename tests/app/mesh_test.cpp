// `cnrg mesh` from outside; the tunnel of Pereira et al. through Gmsh and tetgen.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "kernel/exact/rational.h"
#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/scenes/mesh_readers.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;

const char* const kPair = R"(cnrg: 1
materials: {rock: {color: "#998877"}}
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}, material: rock}
  b: {box: {min: [2, 0, 0], max: [4, 2, 2]}}
  sheet: {polygon: [["1/2", "1/2", 1], ["3/2", "1/2", 1], ["3/2", "3/2", 1]]}
  u: {union: [sheet, a, b], dominance: left}
result: u
)";

TEST_CASE("mesh: a row per region and files in every format", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", kPair);
  const Outcome o = w.run("mesh t.yaml -o t.msh -o t.mesh -o t.vtu --quality 1.5 --max-volume 0.5");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, StartsWith("notice: from ") && Contains(" tetrahedra are expected, up to "));
  CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
  CHECK_THAT(o.out, StartsWith("region  tetrahedra  worst  median  below 0.1  volume\na ") && Contains("\nall ") &&
                        Contains("  16\n") && Contains(" triangles on faces, "));
  const test::MeshFile msh = test::read_msh(w.read("t.msh")), medit = test::read_medit(w.read("t.mesh"));
  CHECK(msh.volume("a") == 8);
  CHECK(msh.volume("material rock") == 8);
  CHECK(medit.volume("b") == 8);
  CHECK(msh.names_of(2).count("face of sheet") == 1);
  CHECK_THAT(w.read("t.vtu"), Contains("NumberOfCells"));
  CHECK(w.run("mesh t.yaml -Y --quiet -o again.msh").out.empty());
  CHECK(w.run("mesh t.yaml --node sheet -o s.msh").status == 2);
}

TEST_CASE("mesh: elements of second order follow curved faces", "[app][mesh]") {
  const Workshop w;
  w.write("ball.yaml",
          "cnrg: 1\nnodes:\n  ball: {sphere: {center: [0, 0, 0], radius: 1, segments: 12}}\nresult: ball\n");
  Outcome o = w.run("mesh ball.yaml -o ball.msh -o ball.vtu --curved");
  CHECK(o.status == 0);
  CHECK_THAT(o.out, StartsWith("region  tetrahedra  curved  straight  worst  median  below 0.1  volume\nball ") &&
                        Contains(" points moved to the surfaces, by 0.0") && Contains(" edges bent\n"));
  // Blocks of elements `dimension entity type count`: lines of 3 nodes, triangles of 6, tetrahedra of 10.
  std::istringstream msh(w.read("ball.msh"));
  std::string line;
  while (std::getline(msh, line) && line != "$Elements") {
  }
  std::getline(msh, line);
  std::map<int, std::size_t> blocks;
  while (std::getline(msh, line) && line != "$EndElements") {
    std::istringstream block(line);
    int dimension = 0, entity = 0, type = 0, count = 0;
    REQUIRE((block >> dimension >> entity >> type >> count));
    const std::map<int, std::size_t> nodes{{15, 1}, {8, 3}, {9, 6}, {11, 10}};
    REQUIRE(nodes.count(type) == 1);
    ++blocks[type];
    for (int i = 0; i < count; ++i) {
      REQUIRE(std::getline(msh, line));
      std::istringstream element(line);
      std::size_t n = 0;
      for (long x = 0; element >> x;) ++n;
      REQUIRE(n == 1 + nodes.at(type));
    }
  }
  CHECK(blocks[9] == 1);
  CHECK(blocks[11] == 1);
  CHECK(w.run("mesh ball.yaml --curved --quiet -o again.msh --threads 1").out.empty());
  CHECK(w.read("again.msh") == w.read("ball.msh"));

  o = w.run("mesh ball.yaml -o ball.mesh --curved");
  CHECK(o.status == 2);
  CHECK_THAT(o.err,
             Contains("ball.mesh: this format holds elements of first order only; use one of .msh .msh2 .vtu"));
  CHECK(!std::filesystem::exists(w.path("ball.mesh")));
  CHECK(w.run("mesh ball.yaml --curved --order 2 --quiet -o again.msh").out.empty());
  CHECK(w.read("again.msh") == w.read("ball.msh"));
  for (const std::string file : {"ball.h5m", "ball.mesh"}) {
    o = w.run("mesh ball.yaml --order 2 -o " + file);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Contains("first order only") && Contains("--order 2"));
  }
  CHECK(w.run("mesh ball.yaml --order 3 -o ball.msh").status == 2);
  o = w.run("mesh ball.yaml -o ball.msh --curved --snap");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("--curved"));
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

/// The area of the first loop of the first path with a pattern, and that of the box about it.
std::array<double, 2> first_loop(const std::string& page) {
  const std::size_t path = page.find("<path fill=\"url("), begin = page.find(" d=\"m", path) + 5;
  std::string text = page.substr(begin, page.find('z', begin) - begin), numbers;
  for (const char c : text) numbers += c == '-' ? " -" : std::string(1, c);
  std::istringstream in(numbers);
  std::vector<std::array<double, 2>> points;
  for (double dx = 0, dy = 0, x = 0, y = 0; in >> dx >> dy; points.push_back({x, y})) x += dx, y += dy;
  double twice = 0;
  std::array<double, 2> low = points.at(0), high = low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    twice += a[0] * b[1] - a[1] * b[0];
    for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], a[k]), high[k] = std::max(high[k], a[k]);
  }
  return {std::abs(twice) / 2, (high[0] - low[0]) * (high[1] - low[1])};
}

TEST_CASE("mesh: a report of quadrilaterals tells and shows them", "[app][mesh]") {
  const Workshop w;
  w.write("s.yaml", "cnrg: 1\nnodes:\n  s: {polygon: [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]}\nresult: s\n");
  const Outcome o = w.run("mesh s.yaml --surface --quads --size 1 -o q.html");
  INFO(o.err);
  CHECK(o.status == 0);
  const std::string page = w.read("q.html");
  CHECK_THAT(page, Contains("quadrilaterals on faces") && Contains("least quality"));
  const std::size_t at = o.out.find(" quadrilaterals and "), begin = o.out.rfind(' ', at - 1) + 1;
  REQUIRE(at != std::string::npos);
  CHECK_THAT(page, Contains("<b>" + o.out.substr(begin, at - begin) + "</b><span>quadrilaterals"));
  const auto [area, box] = first_loop(page);  // the sheet without a gap
  CHECK(box > 0);
  CHECK(area == box);
}

TEST_CASE("mesh: histograms in the table, and a report with pictures", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
materials: {rock: {color: "#998877"}}
nodes:
  a: {box: {min: [0, 0, 0], max: [10, 10, 10]}, name: "a <b> & c", material: rock}
  fault: {polygon: [[0, 0, 0], [10, 0, 0.05], [10, 10, 0.05], [0, 10, 0]]}
  u: {union: [fault, a], dominance: left}
result: u
)");
  Outcome o = w.run("mesh t.yaml -o r.html -o t.msh");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains("\nsmallest dihedral angle ") && Contains("  90 degrees\n") && Contains("█") &&
                        Contains("\ncircumradius to shortest edge ") && Contains("3.6 and more\n"));
  const std::string page = w.read("r.html");
  CHECK_THAT(page, StartsWith("<!DOCTYPE html>") && Contains("a &lt;b&gt; &amp; c") && !Contains("a <b>") &&
                       !Contains("<script") && !Contains("src=") && !Contains("href="));
  CHECK(count_of(page, "<svg") == 4);  // the picture, three histograms
  CHECK_THAT(page, Contains("background:#998877") && Contains(">outside</text>") &&
                       Contains(">opened in the middle</text>"));
  // Bars count every tetrahedron in each histogram.
  const test::MeshFile msh = test::read_msh(w.read("t.msh"));
  std::size_t counted = 0;
  for (std::size_t at = 0; (at = page.find("<rect", at)) != std::string::npos; ++at) {
    const std::size_t colon = page.find(": ", page.find("<title>", at));
    std::string digits = page.substr(colon + 2, page.find('<', colon) - colon - 2);
    std::erase(digits, ',');
    counted += std::stoul(digits);
  }
  CHECK(counted == 3 * msh.count(3));
  // The worst have rings with their numbers.
  REQUIRE(o.out.find("the worst shapes of ") != std::string::npos);
  CHECK_THAT(page, Contains("The worst shapes") && Contains(">1</text>") && Contains("fault"));
  CHECK(w.run("mesh t.yaml --threads 1 --quiet -o again.html").out.empty());
  CHECK(w.read("again.html") == page);
  CHECK(w.run("mesh t.yaml --quality 3 --quiet -o q.html").status == 0);
  CHECK_THAT(w.read("q.html"), Contains("asked for: 3") && Contains("class=\"asked\""));

  o = w.run("mesh t.yaml --surface --size 3 -o s.htm --quiet");
  CHECK(o.status == 0);
  CHECK_THAT(w.read("s.htm"), Contains("The smallest angles") && Contains("boundary of a &lt;b&gt; &amp; c"));
  CHECK(count_of(w.read("s.htm"), "<svg") == 2);
  w.write("wire.yaml", "cnrg: 1\nnodes:\n  p: {polyline: [[0, 0, 0], [1, 0, 1]]}\nresult: p\n");
  CHECK(w.run("mesh wire.yaml --surface -o w.html --quiet").status == 0);
  o = w.run("mesh t.yaml -o t.txt");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains(".xdmf .html"));
  CHECK(w.run("mesh t.yaml --order 2 -o second.html --quiet").status == 0);
}

TEST_CASE("mesh: a grid of XDMF says what it leaves out, unless that is asked for", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  rock:  {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  sheet: {polygon: [[1, 1, 2], [3, 1, 2], [3, 3, 2]]}
  bolt:  {polyline: [[1, 1, 1], [1, 1, 3]]}
  model: {union: [bolt, sheet, rock], dominance: left}
result: model
)");
  Outcome o = w.run("mesh t.yaml -o t.xdmf");
  CHECK(o.status == 0);
  CHECK_FALSE(std::filesystem::exists(w.path("t.faces.xdmf")));
  CHECK_THAT(o.err, Contains("t.xdmf: notice: a grid has elements of one dimension; ask for -o t.faces.xdmf -o "
                             "t.edges.xdmf -o t.points.xdmf, too, which hold "));
  o = w.run("mesh t.yaml --order 2 -o t.xdmf -o t.faces.xdmf");
  CHECK(o.status == 0);
  CHECK(std::filesystem::exists(w.path("t.faces.xdmf")));
  CHECK_THAT(o.err, Contains("ask for -o t.edges.xdmf -o t.points.xdmf, too, which hold ") &&
                        Contains(" segments, ") && !Contains("t.faces.xdmf: notice: a grid"));
  o = w.run("mesh t.yaml -o t.xdmf -o t.faces.xdmf -o t.edges.xdmf -o t.points.xdmf");
  CHECK(o.status == 0);
  CHECK(o.err.empty());
  CHECK(w.run("mesh t.yaml --quiet -o t.xdmf").err.empty());
}

TEST_CASE("mesh: a distance of joining that changes the volume is told", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  rock: {box: {min: [0, 0, 0], max: [60, 40, 30]}}
  seam: {box: {min: [0, 0, 30], max: [60, 40, 34]}}
  model: {union: [seam, rock], dominance: left}
result: model
)");
  for (const std::string quiet : {"", " --quiet"}) {
    const Outcome o = w.run("mesh t.yaml -o t.msh --join 5" + quiet);
    CHECK(o.status == 0);
    CHECK_THAT(o.err,
               Contains("t.yaml: warning: `model`: the regions have 12 % less volume than before; give a smaller "
                        "distance\n"));
  }
  CHECK_THAT(w.run("mesh t.yaml -o t.msh --join 1").err, !Contains("volume than before"));
}

TEST_CASE("mesh: a page draws wires in their color, from outside, too", "[app][mesh]") {
  const Workshop w;
  const auto page = [&](const std::string& material) {
    w.write("t.yaml",
            "cnrg: 1\nmaterials: {steel: {color: \"#3040c0\"}}\nnodes:\n"
            "  rock:  {box: {min: [0, 0, 0], max: [4, 4, 4]}}\n"
            "  bolt:  {polyline: [[1, 1, 1], [1, 1, 3]]" +
                material +
                "}\n"
                "  model: {union: [bolt, rock], dominance: left}\nresult: model\n");
    CHECK(w.run("mesh t.yaml --quiet -o t.html").status == 0);
    const std::string text = w.read("t.html");
    return text.substr(text.find("<h2>Picture"), text.find("<h2>Regions") - text.find("<h2>Picture"));
  };
  CHECK_THAT(page(", material: steel"), Contains("#3040c0"));
  CHECK_THAT(page(""), Contains("#4b2e83") && !Contains("#a5460a"));
}

TEST_CASE("mesh: boxes that nearly touch are told, though no shape is bad", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  lower: {box: {min: [0, 0, 0], max: [10, 10, 4]}}
  upper: {box: {min: [0, 0, 4.00001], max: [10, 10, 8]}}
  model: {union: [lower, upper], dominance: left}
result: model
)");
  const std::string told =
      "t.yaml: notice: `model`: 4 pairs of cells do not touch and are nearer than a millionth of "
      "the model, the nearest 1e-05 apart; `cnrg check --features` lists what is near, and --join "
      "2e-05 joins it\n";
  for (const std::string options : {"", " --size 4", " --quality 1.4", " --surface"}) {
    INFO(options);
    const Outcome o = w.run("mesh t.yaml -o t.msh" + options);
    CHECK(o.status == 0);
    CHECK_THAT(o.err, Contains(told));
  }
  CHECK_THAT(w.run("mesh t.yaml -o t.msh --join 2e-5").err, !Contains("do not touch"));
  CHECK(w.run("mesh t.yaml -o t.msh --quiet").err.empty());
}

TEST_CASE("mesh: a page has the numbers of tetrahedra that doubles find flat", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  low:   {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  plate: {box: {min: [0, 0, 1], max: [1, 1, "1125899906842629/1125899906842624"]}}
  both:  {union: [plate, low], dominance: left}
  model: {simplify: both, rotate: {axis: [1, 2, 3], degrees: 20}}
result: model
)");
  const Outcome o = w.run("mesh t.yaml --quality 2 -o t.html --no-snap");
  INFO(o.out << o.err);
  REQUIRE(o.status == 0);
  const std::string page = w.read("t.html");
  CHECK_THAT(page, !Contains(">inf<") && !Contains(">nan<") && !Contains(">-nan<") && Contains("e-10</b>"));
  CHECK_THAT(o.out, Contains("; the largest is ") && Contains("e+14; 6 are in plate\n") && !Contains("inf"));
}

TEST_CASE("mesh: surfaces alone, with a row per group of faces", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", kPair);
  Outcome o = w.run("mesh t.yaml --surface -o t.msh -o t.mesh -o t.vtu --size 0.5");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, StartsWith("faces ") && Contains("\nwall a | b ") && Contains("\nall ") &&
                        Contains(" triangles on faces, "));
  const test::MeshFile msh = test::read_msh(w.read("t.msh")), medit = test::read_medit(w.read("t.mesh"));
  CHECK(msh.count(3) == 0);
  CHECK(msh.measure(msh.in_group(2, "wall a | b")) == Approx(4).epsilon(1e-12));
  CHECK(medit.count(2) == msh.count(2));
  CHECK_THAT(w.read("t.vtu"), Contains("NumberOfCells"));
  CHECK(w.run("mesh t.yaml --surface --size 0.5 --threads 1 --quiet -o again.msh").out.empty());
  CHECK(w.read("again.msh") == w.read("t.msh"));
  CHECK(w.run("mesh t.yaml --surface --node sheet -o s.msh").status == 0);
  CHECK(test::read_msh(w.read("s.msh")).count(2) > 0);

  o = w.run("mesh t.yaml --surface --quads --size 0.5 -o q.msh -o q.mesh");
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains(" quadrilaterals and ") && Contains("least quality"));
  CHECK_THAT(w.read("q.mesh"), Contains("Quadrilaterals\n"));
  CHECK(w.run("mesh t.yaml --surface-first --size 0.5 -o first.msh").status == 0);
  CHECK(test::read_msh(w.read("first.msh")).count(2) == msh.count(2));
  CHECK(w.run("mesh t.yaml --quads -o bad.msh").status == 2);
  CHECK_THAT(w.run("mesh t.yaml --surface --quads -o bad.h5m").err,
             Contains("take triangles only; use one of .msh"));
  CHECK(w.run("mesh t.yaml --surface --order 2 -o two.msh").status == 0);
  for (const std::string option : {"--quads --order 2", "--surface-first"})
    CHECK(w.run("mesh t.yaml --surface -o bad.msh " + option).status == 2);
  CHECK(w.run("mesh t.yaml --surface-first -Y -o bad.msh").status == 2);

  for (const std::string option :
       {"--quality 2", "--max-volume 1", "-Y", "--constrained", "--curved", "--max-points 0", "--max-points x"}) {
    CHECK(w.run("mesh t.yaml --surface -o bad.msh " + option).status == 2);
  }
  CHECK(w.run("mesh t.yaml --max-points 5 -o bad.msh").status == 2);
  o = w.run("mesh t.yaml --surface --size 0.01 --max-points 500 -o bad.msh");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("t.yaml:") && Contains("coarser than asked for") && Contains("--max-points"));
  w.write("p.yaml", "cnrg: 1\nnodes:\n  p: {points: [[0, 0, 0]]}\nresult: p\n");
  CHECK_THAT(w.run("mesh p.yaml --surface -o bad.msh").err, Contains("neither faces nor wires to mesh"));
  CHECK(!std::filesystem::exists(w.path("bad.msh")));
}

TEST_CASE("mesh: what is foretold once more says why", "[app][mesh]") {
  const Workshop w;
  w.write("near.yaml",
          "cnrg: 1\nnodes:\n  box:  {box: {min: [0, 0, 0], max: [1, 2, 3]}}\n"
          "  near: {polygon: [[-1, -1, 3.00001], [3, -1, 3.00001], [0.5, 4, 3.00001]]}\n"
          "  all:  {union: [near, box], dominance: left}\nresult: all\n");
  const Outcome o = w.run("mesh near.yaml --size 1 -o near.msh");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.err, StartsWith("notice: from ") &&
                        Contains("\nnotice: TetGen has made no mesh to these bounds, so others are made: from "));
}

TEST_CASE("mesh: a thin slab is meshed whatever way is taken, and what it lacks is told", "[app][mesh]") {
  const Workshop w;
  w.write("slab.yaml", "cnrg: 1\nnodes:\n  slab: {box: {min: [0, 0, 0], max: [10, 10, 0.0001]}}\nresult: slab\n");
  for (const std::string way :
       {"", "-Y", "--constrained", "--surface-first", "--size 5", "--size 5 --surface-first", "--quality 2"}) {
    const Outcome o = w.run("mesh slab.yaml -o s.msh " + way);
    INFO(way << "\n" << o.out << o.err);
    CHECK(o.status == 0);
    CHECK_THAT(o.out, !Contains("e+00"));
    CHECK_THAT(o.err, Contains("very thin") || Contains("thinner than the triangles"));
  }
  Outcome o = w.run("mesh slab.yaml -o s.msh --surface");
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains("blank: none"));
  CHECK_THAT(o.err, Contains("8 triangles stay thin in parts that are very narrow") && Contains("1000000"));
  o = w.run("mesh slab.yaml -o s.msh --quality 2 --seconds 0");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("leave out --quality"));
}

TEST_CASE("mesh: one error for what cannot be meshed or written", "[app][mesh][errors]") {
  const Workshop w;
  w.write("t.yaml", kPair);
  Outcome o = w.run("mesh t.yaml");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, StartsWith("cnrg: error: ") && Contains("-o"));
  o = w.run("mesh t.yaml -o t.stl");
  CHECK(o.status == 2);
  CHECK_THAT(o.err,
             Contains("no writer of tetrahedra for the extension `.stl`; use one of .msh .msh2 .mesh .vtu"));
  o = w.run("mesh t.yaml -o t.poly");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("`cnrg eval -o` writes it"));
  o = w.run("mesh t.yaml --node sheet -o s.msh");
  CHECK_THAT(o.err, Contains("t.yaml:6:3: error: the result has no region to fill with tetrahedra"));
  for (const std::string options : {"--quality 1", "--quality x", "--max-volume 0", "--max-volume -1"}) {
    CHECK(w.run("mesh t.yaml -o t.msh " + options).status == 2);
  }
  w.write("open.yaml", "cnrg: 1\nnodes:\n  a: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}\nresult: a\n");
  o = w.run("mesh open.yaml -o t.msh");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("without bounds"));
  CHECK_FALSE(std::filesystem::exists(w.path("t.msh")));
}

TEST_CASE("mesh: where TetGen ends by an assertion the program does not", "[app][mesh][errors]") {
  // A tetrahedron as thin as the last digit of a double: embedded, and too much for TetGen.
  const Workshop w;
  w.write("thin.yaml", R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  t: {tetrahedron: [[0.4, 0.5, 1.5], [1.5, 0.6, 1.5], [1.4, 1.5, 1.5], [0.5, 1.4, 1.500000000000001]]}
  w: {union: [t, a], dominance: left}
result: w
)");
  const Outcome o = w.run("mesh thin.yaml -o t.msh --quality 1.2");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("t.msh: notice: TetGen was stopped by a fault of its own") &&
                        Contains("; these are constrained tetrahedra, improved"));
  CHECK_THAT(o.out, Contains("all") && Contains(" 8\n"));
}

TEST_CASE("the tunnel of Pereira et al.: our tetrahedra, Gmsh's and tetgen's have the volumes of the regions",
          "[app][mesh][programs]") {
  const Workshop w;
  const std::string tree = "'" + std::filesystem::absolute("papers/pereira2012/fig10.yaml").string() + "'";
  const auto close = [](double volume, const Rational& exact) {
    return volume == Approx(to_double(exact)).epsilon(1e-9);
  };
  REQUIRE(w.run("mesh " + tree + " -Y --quiet -o kept.msh").status == 0);
  const test::MeshFile kept = test::read_msh(w.read("kept.msh"));
  CHECK(kept.names_of(3).size() == 8 + 1 + 4 + 8);  // each, all of their name, materials, sides of four surfaces
  std::map<int, Rational> exact;
  for (int region = 1; region <= 8; ++region) exact[region] = kept.volume(region);
  CHECK(kept.loose(2) == 0);
  REQUIRE(w.run("mesh " + tree + " -Y --max-volume 500 --quiet -o inside.msh").status == 0);
  const test::MeshFile inside = test::read_msh(w.read("inside.msh"));
  std::set<int> on_boundary;
  for (const auto& e : inside.elements) {
    if (e.dimension == 2) on_boundary.insert(e.nodes.begin(), e.nodes.end());
  }
  CHECK(inside.nodes.size() > on_boundary.size());  // points came inside, and there alone
  CHECK(inside.count(2) == kept.count(2));
  for (const auto& [region, volume] : exact) CHECK(inside.volume(region) == volume);
  REQUIRE(w.run("mesh " + tree + " --quality 1.8 --quiet -o fine.msh").status == 0);
  const test::MeshFile fine = test::read_msh(w.read("fine.msh"));
  CHECK(fine.count(3) > 3 * kept.count(3));
  for (const auto& [region, volume] : exact) CHECK(close(to_double(fine.volume(region)), volume));

  REQUIRE(w.run("eval " + tree + " --quiet -o m.msh -o p.poly -o s.smesh").status == 0);
  if (test::installed("gmsh")) {
    const Outcome o = w.shell("gmsh -3 m.msh -o out.msh >.out 2>.err");
    CHECK(o.status == 0);
    CHECK_THAT(o.out, !Contains("Error"));
    const test::MeshFile mesh = test::read_msh(w.read("out.msh"));
    for (const auto& [region, volume] : exact) CHECK(close(to_double(mesh.volume(region)), volume));
    // It also opens the tetrahedra that we made (and writes 16 digits of each coordinate).
    CHECK(w.shell("gmsh kept.msh -save -o again.msh >.out 2>.err").status == 0);
    const test::MeshFile again = test::read_msh(w.read("again.msh"));
    for (const auto& [region, volume] : exact) CHECK(close(to_double(again.volume(region)), volume));
  } else {
    WARN("left out: gmsh is not installed (Debian: gmsh)");
  }
  if (test::installed("tetgen")) {
    for (const std::string name : {"p.poly", "s.smesh"}) {
      CHECK(w.shell("tetgen -pAQ " + name + " >.out 2>.err").status == 0);
      const std::string stem = name.substr(0, 1);
      const auto volumes = test::tetgen_volumes(w.read(stem + ".1.node"), w.read(stem + ".1.ele"));
      REQUIRE(volumes.size() == 8);
      double found = 0, all = 0;
      for (const auto& [region, volume] : volumes) found += volume;
      for (const auto& [region, volume] : exact) all += to_double(volume);
      CHECK(found == Approx(all).epsilon(1e-12));
    }
  } else {
    WARN("left out: tetgen is not installed (Debian: tetgen)");
  }
}

TEST_CASE("where TetGen stumbles over a regular model it is meshed another way", "[app][mesh]") {
  // Two triangles in a cube about the same centre as TetGen's own box: it stops at an assertion of its own there.
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  box: {box: {min: [-0.13, -0.13, -0.13], max: [1.13, 1.13, 1.13]}}
  folded:
    group:
      vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
      faces: [{loops: [[0, 1, 2]]}, {loops: [[0, 3, 2]]}]
      fill: none
  model: {union: [box, folded]}
result: model
)");
  const Outcome o = w.run("mesh t.yaml -o t.msh");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains("2.000376"));
}

/// The corners of all triangles of a .msh.
std::set<std::array<double, 3>> places_on_faces(const std::string& msh) {
  const test::MeshFile mesh = test::read_msh(msh);
  std::set<std::array<double, 3>> places;
  for (const auto& element : mesh.elements) {
    if (element.dimension != 2) continue;
    for (const int node : element.nodes) places.insert(mesh.nodes.at(node));
  }
  return places;
}

TEST_CASE("where TetGen fails -Y takes constrained tetrahedra that need no point on the boundary", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  base: {box: {min: [0, 0, 0], max: [10, 10, 6]}}
  bolt: {polyline: [[5, 5, 1], [5, 5, 5.99999]]}
  all:  {union: [bolt, base], dominance: left}
result: all
)");
  const Outcome o = w.run("mesh t.yaml -Y -o t.msh");
  INFO(o.err);
  REQUIRE(o.status == 0);
  const test::MeshFile mesh = test::read_msh(w.read("t.msh"));
  CHECK(mesh.volume("base") == 600);
  CHECK(mesh.count(2) == 12);
  CHECK(mesh.count(1) == 13);
  for (const auto& element : mesh.elements) {
    if (element.dimension != 2) continue;
    for (const int node : element.nodes) {
      const auto& [x, y, z] = mesh.nodes.at(node);
      CHECK(((x == 0 || x == 10) && (y == 0 || y == 10) && (z == 0 || z == 6)));
    }
  }
}

TEST_CASE("where TetGen does not end or fails there are constrained tetrahedra, and bounds must be numbers",
          "[app][mesh]") {
  const Workshop w;
  // A box whose corners are off by a unit in the last place, and a point as near to it.
  w.write("t.yaml", R"(cnrg: 1
nodes:
  s: {box: {min: [1/3, "999999999999999/1000000000000000", 1],
            max: ["500000000000001/500000000000000", 1, "500000000000001/500000000000000"]}}
  q: {points: [["999999999999999/1000000000000000", 1, "1000000000000001/1000000000000000"]]}
  m: {union: [s, q]}
result: m
)");
  const Outcome kept = w.run("mesh t.yaml -o t.msh --seconds 4 --keep-boundary");
  CHECK(kept.status == 0);
  CHECK_THAT(kept.err, Contains("t.msh: notice: TetGen ") && Contains("; these are constrained tetrahedra"));
  REQUIRE(w.run("eval t.yaml --quiet -o faces.msh").status == 0);
  CHECK(places_on_faces(w.read("t.msh")) == places_on_faces(w.read("faces.msh")));
  const Outcome o = w.run("mesh t.yaml -o t.msh --seconds 4");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("t.msh: notice: TetGen ") && Contains("; these are constrained tetrahedra"));
  CHECK(std::filesystem::exists(w.path("t.msh")));
  const Outcome bound = w.run("mesh t.yaml -o u.msh --constrained --keep-boundary");
  CHECK(bound.status == 2);
  CHECK_THAT(bound.err, Contains("constrained tetrahedra need points on the boundary"));
  CHECK_FALSE(std::filesystem::exists(w.path("u.msh")));
  for (const std::string option : {"--max-volume nan", "--max-volume inf", "--max-volume 0", "--quality nan"}) {
    INFO(option);
    const Outcome bad = w.run("mesh t.yaml -o t.msh " + option);
    CHECK(bad.status == 2);
    CHECK_THAT(bad.err, Contains("is not a"));
  }
}

TEST_CASE("mesh: sizes are foretold before they are made", "[app][mesh][size]") {
  const Workshop w;
  w.write("t.yaml", kPair);
  Outcome o = w.run("mesh t.yaml -o t.msh --size 0.25 --growth 0.5");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, StartsWith("notice: from ") && Contains(" tetrahedra are expected, up to ") &&
                        Contains(" MB of memory, less than a second\n"));
  CHECK(w.run("mesh t.yaml -o quiet.msh --size 0.25 --growth 0.5 --quiet").err.empty());
  CHECK(w.read("quiet.msh") == w.read("t.msh"));
  CHECK(w.run("mesh t.yaml -o plain.msh").err.empty());
  CHECK(w.read("plain.msh").size() < w.read("t.msh").size());
  o = w.run("mesh t.yaml -o huge.msh --size 1e-3");
  CHECK(o.status == 2);
  CHECK_THAT(o.err,
             Contains("t.yaml:7:3: error: what is asked for takes about") && Contains("ask for a larger --size"));
  CHECK_FALSE(std::filesystem::exists(w.path("huge.msh")));
  for (const std::string option : {"--size 0", "--size -1", "--size nan", "--size inf", "--size x", "--growth 0",
                                   "--growth 0.01", "--growth 3", "--growth nan"}) {
    INFO(option);
    o = w.run("mesh t.yaml -o bad.msh " + option);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Contains("is not a"));
  }
  for (const std::string option : {"--seconds 1.5", "--seconds -1", "--threads x", "--max-points 0"}) {
    INFO(option);
    CHECK_THAT(w.run("mesh t.yaml -o bad.msh --surface " + option).err, Contains("` is not a whole number from "));
  }
  w.run("mesh t.yaml -o third.msh --size 1/3");
  w.run("mesh t.yaml -o decimal.msh --size 0.33333333333333331");
  CHECK(w.read("third.msh") == w.read("decimal.msh"));
  CHECK_THAT(w.run("mesh t.yaml -o bad.h5m --surface --quads").err, Contains(".xdmf .html for --quads"));
}

}  // namespace
}  // namespace cnrg
