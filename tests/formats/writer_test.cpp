// Each format written and parsed back: exact counts, exact volumes, errors, and old files that stay.
#include <sys/stat.h>
#include <unistd.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "csg/operators/cnrg.h"
#include "csg/result/flat.h"
#include "csg/text/file.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

struct Triangles {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::vector<std::size_t>> lines;
  std::vector<std::size_t> dots;
};

Triangles read_off_text(const std::string& text) {
  std::istringstream in(text);
  std::string head;
  std::size_t points, faces, edges, n;
  in >> head >> points >> faces >> edges;
  REQUIRE(head == "OFF");
  Triangles mesh;
  mesh.points.resize(points);
  mesh.triangles.resize(faces);
  for (auto& p : mesh.points) in >> p[0] >> p[1] >> p[2];
  for (auto& t : mesh.triangles) in >> n >> t[0] >> t[1] >> t[2];
  REQUIRE(in);
  return mesh;
}

Triangles read_ply_text(const std::string& text) {
  const auto number_after = [&](const std::string& key) {
    return std::stoul(text.substr(text.find(key) + key.size()));
  };
  Triangles mesh;
  mesh.points.resize(number_after("element vertex "));
  mesh.triangles.resize(number_after("element face "));
  std::istringstream in(text.substr(text.find("end_header\n") + 11));
  std::size_t n;
  for (auto& p : mesh.points) in >> p[0] >> p[1] >> p[2];
  for (auto& t : mesh.triangles) in >> n >> t[0] >> t[1] >> t[2];
  REQUIRE(in);
  return mesh;
}

Triangles read_stl_text(const std::string& text) {
  std::istringstream in(text);
  std::string word;
  Triangles mesh;
  std::map<std::array<double, 3>, std::size_t> known;
  std::vector<std::size_t> corners;
  while (in >> word) {
    if (word != "vertex") continue;
    std::array<double, 3> p;
    in >> p[0] >> p[1] >> p[2];
    const auto [entry, fresh] = known.try_emplace(p, mesh.points.size());
    if (fresh) mesh.points.push_back(p);
    corners.push_back(entry->second);
  }
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  return mesh;
}

Triangles read_obj_text(const std::string& text) {
  std::istringstream in(text);
  std::string line;
  Triangles mesh;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    std::vector<std::size_t> numbers;
    if (key == "v") {
      std::array<double, 3> p;
      words >> p[0] >> p[1] >> p[2];
      mesh.points.push_back(p);
      continue;
    }
    if (key == "g" || key == "#") continue;
    for (std::size_t n; words >> n;) numbers.push_back(n - 1);
    if (key == "f") mesh.triangles.push_back({numbers[0], numbers[1], numbers[2]});
    if (key == "l") mesh.lines.push_back(numbers);
    if (key == "p") mesh.dots.push_back(numbers[0]);
  }
  return mesh;
}

/// The exact volume that the triangles enclose.
Rational enclosed(const Triangles& mesh) {
  Rational sum = 0;
  for (const auto& t : mesh.triangles) {
    std::array<RationalPoint, 3> p;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) p[i][k] = from_double(mesh.points[t[i]][k]);
    }
    for (int k = 0; k < 3; ++k) {
      sum += p[0][k] * (p[1][(k + 1) % 3] * p[2][(k + 2) % 3] - p[1][(k + 2) % 3] * p[2][(k + 1) % 3]);
    }
  }
  return sum / 6;
}

/// Every edge of a closed surface is used as often in one direction as in the other.
bool closed(const Triangles& mesh) {
  std::map<std::pair<std::size_t, std::size_t>, int> balance;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
}

std::string message_of(const std::string& path, const ResultView& view) {
  try {
    write(path, view);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Case two_overlapping_boxes() {
  Soup soup;
  add_box(soup, {0, 0, 0}, {2, 2, 2});
  add_box(soup, {1, 1, 1}, {3, 3, 3});
  Case c(soup);
  c.show(c.unite());
  return c;
}

}  // namespace

TEST_CASE("off, ply, stl and obj of a union parse back to the exact solid") {
  const Case c = two_overlapping_boxes();
  const ScratchFolder dir;
  for (const std::string name : {"m.off", "m.ply", "m.stl", "m.obj"}) {
    CAPTURE(name);
    const RoundingReport rounding = write(dir / name, c.view());
    CHECK(rounding.moved == 0);
    CHECK(rounding.embedded);
    const std::string text = text_of(dir / name);
    const Triangles mesh = name == "m.off"   ? read_off_text(text)
                           : name == "m.ply" ? read_ply_text(text)
                           : name == "m.stl" ? read_stl_text(text)
                                             : read_obj_text(text);
    CHECK(mesh.points.size() == 20);
    CHECK(mesh.triangles.size() == 2 * 20 - 4);
    CHECK(closed(mesh));
    CHECK(enclosed(mesh) == 15);
  }
}

TEST_CASE("walls, sheets, wires and points: obj holds them, the others say which they cannot") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {2, 2, 2});
  add_sheet(soup, {{1, -1, -1}, {1, 3, -1}, {1, 3, 3}, {1, -1, 3}});
  add_wire(soup, {4, 0, 0}, {4, 0, 1});
  add_point(soup, {5, 5, 5});
  Case c(soup);
  c.show(c.unite());
  const ScratchFolder dir;
  const std::string message = message_of(dir / "m.stl", c.view());
  CHECK(has(message, "m.stl: STL"));
  CHECK(has(message, "1 wall between regions"));
  CHECK(has(message, "1 face that bounds no region"));
  CHECK(has(message, "1 wire"));
  CHECK(has(message, "1 isolated point"));
  CHECK(has(message, ".obj"));
  CHECK_FALSE(std::filesystem::exists(dir / "m.stl"));
  CHECK(message_of(dir / "m.off", c.view()) != "");
  CHECK(message_of(dir / "m.ply", c.view()) != "");

  write(dir / "m.obj", c.view());
  const Triangles mesh = read_obj_text(text_of(dir / "m.obj"));
  CHECK(mesh.lines.size() == 1);
  CHECK(mesh.dots.size() == 1);
  CHECK(mesh.points.size() == 8 + 4 + 4 + 2 + 1);
  CHECK(has(text_of(dir / "m.obj"), " region1 region2\n"));
}

TEST_CASE("a region without bounds is refused by surface formats, not by json") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup);
  c.show(complement(*c.complex, c.leaves[0]));
  const ScratchFolder dir;
  for (const std::string name : {"m.off", "m.ply", "m.stl", "m.obj"}) {
    CHECK(has(message_of(dir / name, c.view()), "without bounds"));
  }
  write(dir / "m.json", c.view());
  const auto json = nlohmann::json::parse(text_of(dir / "m.json"));
  std::set<std::string> volumes;
  for (const auto& region : json["regions"]) {
    CHECK(region["bounded"].get<bool>() == (region["component"] == 0));
    volumes.insert(region["volume"].dump());
  }
  CHECK(volumes == std::set<std::string>{"\"1\"", "null"});
}

TEST_CASE("an open set is refused by formats of closed ones") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup);
  c.show(topological_operation(*c.complex, Topological::interior, components_of(*c.complex, c.group)).value);
  const ResultView view = c.view();
  const ScratchFolder dir;
  CHECK(has(message_of(dir / "m.obj", view), "closure"));
  CHECK(has(message_of(dir / "m.off", view), "lacks 6 boundary faces, 12 boundary edges, 8 boundary vertices;"));
  write(dir / "m.json", view);
  const auto json = nlohmann::json::parse(text_of(dir / "m.json"));
  CHECK(json["faces"].size() == 6);
  CHECK(json["faces"][0]["component"] == 0);
  write(dir / "m.vtu", view);
}

TEST_CASE("formats of closed sets name the operator that helps, and it does") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {2, 2, 2});
  add_box(soup, {1, 0, 0}, {3, 2, 2});
  add_sheet(soup, {{0, 0, 1}, {5, 0, 1}, {5, 2, 1}, {0, 2, 1}});
  Case c(soup, {{{"a", "", {}}}, {{"b", "", {}}}});
  const Complex& complex = *c.complex;
  std::vector<Components> leaves;
  for (const Group& group : c.leaves) leaves.push_back(components_of(complex, group));
  const ScratchFolder dir;
  const auto says = [&](const Components& value, const std::string& format) {
    c.show(value);
    return message_of(dir / ("m." + format), c.view());
  };
  const auto volume = [&](const Components& value) {
    c.show(value);
    Rational result;
    for (const std::string name : {"m.off", "m.obj", "m.stl", "m.ply"}) {
      CAPTURE(name);
      CHECK(message_of(dir / name, c.view()) == "");
    }
    return enclosed(read_off_text(text_of(dir / "m.off")));
  };
  // A sheet without its rim, and a face without an inner edge, are not closed.
  const Components sheet = subtract(complex, leaves[2], leaves[0]).value;
  const std::string lacks = "lacks 1 boundary edge, 2 boundary vertices; write .json or .vtu, or apply `closure`";
  for (const std::string format : {"obj", "off", "stl", "ply"}) CHECK(has(says(sheet, format), lacks));
  CHECK(has(says(topological_operation(complex, Topological::closure, sheet).value, "stl"), "apply `regularize`"));
  CHECK(says(topological_operation(complex, Topological::closure, sheet).value, "obj") == "");

  // Three solids with walls between them: unify.
  const Components parts = sum(complex, leaves[0], leaves[1]).value;
  CHECK(has(says(parts, "off"), "2 walls between regions"));
  CHECK(has(says(parts, "off"), "or apply `unify`"));
  CHECK_FALSE(has(says(parts, "off"), "`regularize`"));
  CHECK(volume(unify(complex, parts).value) == 12);

  // With the sheet, which is partly inside and partly out of them: both.
  const Components all = sum(complex, parts, leaves[2]).value;
  CHECK(has(says(all, "ply"), "`regularize` (it drops what bounds no region) and `unify`"));
  CHECK(volume(unify(complex, topological_operation(complex, Topological::regularize, all).value).value) == 12);
}

TEST_CASE("solids that touch in an edge are what they are") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {1, 1, 0}, {2, 2, 1});
  Case c(soup);
  c.show(c.unite());
  const ScratchFolder dir;
  write(dir / "m.off", c.view());
  const Triangles mesh = read_off_text(text_of(dir / "m.off"));
  CHECK(mesh.points.size() == 14);
  CHECK(mesh.triangles.size() == 24);
  CHECK(closed(mesh));
  CHECK(enclosed(mesh) == 2);
}

TEST_CASE("json: counts, exact volumes, names, provenance, sides") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {3, 3, 3});
  add_box(soup, {Rational(1, 3), Rational(1, 3), Rational(1, 3)}, {1, 1, 1});
  Case c(soup, {{{"rock", "granite", {}}}, {{"core", "ore", {}}}});
  c.materials = {{"granite", "#998877"}, {"ore", ""}};
  c.show(c.unite(Dominance::right));
  const ScratchFolder dir;
  write(dir / "m.json", c.view());
  const auto json = nlohmann::json::parse(text_of(dir / "m.json"));
  CHECK(json["format"] == "cnrg result");
  CHECK(json["version"] == 1);
  CHECK(json["points"].size() == 16);
  CHECK(json["points"][1] == nlohmann::json{"0", "0", "3"});
  CHECK(json["points"][4] == nlohmann::json{"1/3", "1/3", "1/3"});
  CHECK(json["vertices"].size() == 16);
  CHECK(json["edges"].size() == 24);
  CHECK(json["faces"].size() == 12);
  CHECK(json["materials"][0]["color"] == "#998877");
  std::map<std::string, std::string> volumes;
  for (const auto& region : json["regions"]) {
    if (region["component"] != 0) volumes[region["name"]] = region["volume"];
    for (const auto& shell : region["shells"]) {
      for (const auto& side : shell) {
        const auto& face = json["faces"][side["face"].get<std::size_t>()];
        CHECK(&json["regions"][face["regions"][side["side"] == "front" ? 0 : 1].get<std::size_t>()] == &region);
      }
    }
  }
  CHECK(volumes == std::map<std::string, std::string>{{"rock", "721/27"}, {"core", "8/27"}});
  for (const auto& face : json["faces"]) {
    std::size_t named = 0;
    std::size_t leaf = 0;
    for (const auto& item : face["origin"]) {
      if (!item.contains("faces")) continue;
      leaf = item["leaf"].get<std::size_t>();
      named += item["faces"].size();
    }
    CHECK(named == 1);
    CHECK(json["leaves"][leaf]["name"] == "leaf" + std::to_string(leaf));
    CHECK(face["triangles"].size() == 2);
  }
}

TEST_CASE("coordinates that are no doubles: the report counts them and checks the rounded shape") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {Rational(1, 3), 1, 1});
  Case c(soup);
  const ScratchFolder dir;
  const RoundingReport rounding = write(dir / "m.off", c.view());
  CHECK(rounding.moved == 4);
  CHECK(rounding.embedded);
}

TEST_CASE("a shape thinner than doubles is reported as not embedded") {
  Soup soup;
  const Rational thin(1, Integer("1000000000000000000000000"));
  add_box(soup, {1, 0, 0}, {1 + thin, 1, 1});
  Case c(soup);
  const ScratchFolder dir;
  const RoundingReport rounding = write(dir / "m.off", c.view());
  CHECK(rounding.moved == 4);
  CHECK_FALSE(rounding.embedded);
  // Sides that are lines now have coordinates of their own all the same.
  write(dir / "m.msh", c.view());
  CHECK(text_of(dir / "m.msh").find("nan") == std::string::npos);
}

TEST_CASE("faces of a curved patch are one face with facets") {
  Soup soup;
  add_drum(soup, 12, 0, 4);
  Case c(soup);
  const ScratchFolder dir;
  write(dir / "m.json", c.view());
  const auto json = nlohmann::json::parse(text_of(dir / "m.json"));
  CHECK(json["faces"].size() == 3);
  CHECK(json["points"].size() == 24);
  std::size_t facets = 0;
  for (const auto& face : json["faces"]) facets += face.contains("facets") ? face["facets"].size() : 0;
  CHECK(facets == 12);
  write(dir / "m.off", c.view());
  const Triangles mesh = read_off_text(text_of(dir / "m.off"));
  CHECK(closed(mesh));
  CHECK(mesh.triangles.size() == 2 * 24 - 4);
}

TEST_CASE("points that only the refinement made are left out") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {2, 2, 2});
  add_sheet(soup, {{1, -1, -1}, {1, 3, -1}, {1, 3, 3}, {1, -1, 3}});
  Case c(soup);
  const FlatComplex flat = flatten(c.view());  // the first leaf alone, cut by the second
  CHECK(flat.points.size() == 8);
  CHECK(flat.edges.size() == 12);
  CHECK(flat.faces.size() == 6);
  for (const auto& face : flat.faces) CHECK(face.triangles.size() == 2);
}

TEST_CASE("the numbering does not depend on the order of the input") {
  const auto text = [](bool swapped) {
    Soup soup;
    const auto one = [&] { add_box(soup, {0, 0, 0}, {2, 2, 2}); };
    const auto two = [&] { add_box(soup, {1, 1, 1}, {3, 3, 3}); };
    if (swapped) {
      two();
      one();
    } else {
      one();
      two();
    }
    Case c(soup);
    c.show(c.unite());
    const ScratchFolder dir;
    write(dir / "m.obj", c.view());
    return text_of(dir / "m.obj");
  };
  CHECK(text(false) == text(true));
}

TEST_CASE("raw cells are written too, and are no walls") {
  Case c = two_overlapping_boxes();
  c.show(c.group, SimplifyMode::raw);
  const ScratchFolder dir;
  write(dir / "m.off", c.view());
  CHECK(enclosed(read_off_text(text_of(dir / "m.off"))) == 15);
  write(dir / "m.json", c.view());
  const auto json = nlohmann::json::parse(text_of(dir / "m.json"));
  CHECK(json["regions"].size() == 4);
}

TEST_CASE("an empty result is a valid file") {
  Case c = two_overlapping_boxes();
  c.show(boolean_operation(*c.complex, BooleanOp::subtract, Dominance::equal, c.leaves[0], c.leaves[0]).group);
  const ScratchFolder dir;
  for (const std::string name : {"m.off", "m.ply", "m.stl", "m.obj", "m.json", "m.vtu"}) {
    CHECK(write(dir / name, c.view()).embedded);
  }
  CHECK(text_of(dir / "m.off") == "OFF\n0 0 0\n");
}

TEST_CASE("an unknown extension names the known ones") {
  const Case c = two_overlapping_boxes();
  const ScratchFolder dir;
  CHECK(has(message_of(dir / "m.xyz", c.view()),
            "`.xyz`; use one of .json .vtu .msh .msh2 .mesh .smesh .poly .inp .bdf .h5m .med .obj"));
  CHECK(has(message_of(dir / "model", c.view()), "no writer"));
  write(dir / "M.OFF", c.view());
}

TEST_CASE("a file that cannot be written: the old one stays, nothing is left behind") {
  const Case c = two_overlapping_boxes();
  const ScratchFolder dir;
  CHECK_THROWS_AS(write(dir / "no/such/m.off", c.view()), FileError);
  std::filesystem::create_directory(dir / "d.off");
  CHECK_THROWS_AS(write(dir / "d.off", c.view()), FileError);
  CHECK(std::filesystem::is_directory(dir / "d.off"));

  replace_file(dir / "m.off", "old");
  if (geteuid() != 0) {
    chmod(dir.path().c_str(), 0500);
    CHECK_THROWS_AS(write(dir / "m.off", c.view()), FileError);
    chmod(dir.path().c_str(), 0700);
    CHECK(text_of(dir / "m.off") == "old");
  }
  // A name that is too long.
  const std::string longest(252, 'x');
  replace_file(dir / "short.off", "old");
  CHECK_THROWS_AS(write(dir / (longest + ".off"), c.view()), FileError);
  // A result that the format cannot hold leaves the old file alone.
  Case open = two_overlapping_boxes();
  open.show(complement(*open.complex, open.group));
  CHECK_THROWS_AS(write(dir / "m.off", open.view()), InputError);
  CHECK(text_of(dir / "m.off") == "old");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(dir.path())) ++files;
  CHECK(files == 3);
}

TEST_CASE("a replaced file keeps its permissions, a link its target") {
  const ScratchFolder dir;
  replace_file(dir / "a.txt", "one");
  chmod((dir / "a.txt").c_str(), 0640);
  std::filesystem::create_symlink(dir / "a.txt", dir / "b.txt");
  replace_file(dir / "b.txt", "two");
  CHECK(std::filesystem::is_symlink(dir / "b.txt"));
  CHECK(text_of(dir / "a.txt") == "two");
  struct stat info;
  stat((dir / "a.txt").c_str(), &info);
  CHECK((info.st_mode & 0777) == 0640);
  CHECK_THROWS_AS(replace_file("/dev/null", "x"), FileError);
}
