// ParaView's format, read by a small parser of our own: counts by dimension, volumes, tables of names.
#include <map>

#include "csg/operators/cnrg.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"
#include "tests/formats/vtu_reader.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

Vtu vtu_of(const ResultView& view) {
  const ScratchFolder dir;
  write(dir / "m.vtu", view);
  return {text_of(dir / "m.vtu")};
}

}  // namespace

TEST_CASE("vtu: cells by dimension, volumes by region, tables of names") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {3, 3, 3});
  add_box(soup, {1, 1, 1}, {2, 2, 2});
  add_wire(soup, {5, 0, 0}, {5, 0, 1});
  add_point(soup, {6, 6, 6});
  Case c(soup, {{{"a <&> \"b\"", "granite", {}}}, {{"core", "ore", {}}}});
  c.materials = {{"ore", ""}, {"granite", "#998877"}};
  c.show(c.unite(Dominance::right));
  const Vtu vtu = vtu_of(c.view());
  const auto dimension = vtu.array<std::int32_t>("dimension");
  std::map<int, int> cells;
  for (const auto d : dimension) ++cells[d];
  CHECK(cells == std::map<int, int>{{0, 19}, {1, 25}, {2, 24}, {3, 36}});

  const auto points = vtu.array<double>("Points");
  const auto connectivity = vtu.array<std::int64_t>("connectivity");
  const auto offsets = vtu.array<std::int64_t>("offsets");
  const auto types = vtu.array<std::uint8_t>("types");
  const auto region = vtu.array<std::int32_t>("region");
  const auto material = vtu.array<std::int32_t>("material");
  const auto bounded = vtu.array<std::int32_t>("regions_bounded");
  const auto source = vtu.array<std::int32_t>("source_leaf");
  CHECK(points.size() == 3 * 19);
  CHECK(offsets.size() == dimension.size());
  CHECK(offsets.back() == std::int64_t(connectivity.size()));
  const auto materials = vtu.names("material");
  const auto regions = vtu.names("region");
  CHECK(materials == std::map<int, std::string>{{1, "ore"}, {2, "granite"}});
  CHECK(vtu.names("source_leaf") ==
        std::map<int, std::string>{{0, "leaf0"}, {1, "leaf1"}, {2, "leaf2"}, {3, "leaf3"}});
  std::map<std::string, double> volume;
  std::map<int, int> faces_bounding;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const std::size_t begin = i == 0 ? 0 : std::size_t(offsets[i - 1]), end = std::size_t(offsets[i]);
    if (dimension[i] == 0) CHECK((types[i] == 1 && end - begin == 1));
    if (dimension[i] == 1) CHECK((types[i] == 3 && end - begin == 2));
    if (dimension[i] == 2) {
      ++faces_bounding[bounded[i]];
      CHECK((source[i] == 0 || source[i] == 1));
    }
    if (dimension[i] < 3) continue;
    REQUIRE((types[i] == 5 && end - begin == 3));
    const double* p[3];
    for (int k = 0; k < 3; ++k) p[k] = points.data() + 3 * connectivity[begin + std::size_t(k)];
    double six = 0;
    for (int k = 0; k < 3; ++k) {
      const int m = (k + 1) % 3, n = (k + 2) % 3;
      six += p[0][k] * (p[1][m] * p[2][n] - p[1][n] * p[2][m]);
    }
    const std::string name = regions.at(region[i]);
    volume[name] += six / 6;
    CHECK(materials.at(material[i]) == (name == "core" ? "ore" : "granite"));
  }
  CHECK(faces_bounding == std::map<int, int>{{1, 12}, {2, 12}});
  CHECK(volume.size() == 2);
  CHECK(volume["core"] == Approx(1));
  CHECK(volume["a <&> \"b\""] == Approx(26));
}

TEST_CASE("vtu: a closed curve has one cell number, and so has a curved patch") {
  Soup soup;
  add_drum(soup, 12, 0, 4);
  Case c(soup);
  const Vtu vtu = vtu_of(c.view());
  const auto dimension = vtu.array<std::int32_t>("dimension");
  const auto cell = vtu.array<std::int32_t>("cell");
  std::map<int, int> lines, triangles;
  for (std::size_t i = 0; i < dimension.size(); ++i) {
    if (dimension[i] == 1) ++lines[cell[i]];
    triangles[cell[i]] += dimension[i] == 2;
  }
  CHECK(lines == std::map<int, int>{{0, 12}, {1, 12}});
  CHECK(triangles == std::map<int, int>{{0, 24}, {1, 10}, {2, 10}});
}

TEST_CASE("vtu: a region without bounds is shown by its boundary") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup);
  c.show(complement(*c.complex, c.group));
  CHECK_NOTHROW(vtu_of(c.view()));
}

TEST_CASE("vtu: of an open set the region is drawn, its boundary is not; materials are those of components") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup, {{{"a", "rock", {}}}});
  c.materials = {{"steel", ""}, {"rock", ""}};
  const Components a = components_of(*c.complex, c.leaves[0]);
  c.show(topological_operation(*c.complex, Topological::interior, a).value);
  Vtu vtu = vtu_of(c.view());
  CHECK(vtu.array<std::int32_t>("dimension") == std::vector<std::int32_t>(12, 3));
  CHECK(vtu.array<std::int32_t>("component") == std::vector<std::int32_t>(12, 1));
  CHECK(vtu.array<std::int32_t>("material") == std::vector<std::int32_t>(12, 2));
  CHECK(vtu.array<std::int32_t>("source_leaf") == std::vector<std::int32_t>(12, 0));

  Components boundary = topological_operation(*c.complex, Topological::boundary, a).value;  // the entities alone
  REQUIRE(boundary.attributes.size() == 1);
  boundary.attributes[0].material = "steel";
  c.show(boundary);
  vtu = vtu_of(c.view());
  CHECK(vtu.array<std::int32_t>("dimension").size() == 8 + 12 + 12);
  CHECK(vtu.array<std::int32_t>("material") == std::vector<std::int32_t>(32, 1));
  CHECK(vtu.array<std::int32_t>("region") == std::vector<std::int32_t>(32, 0));
  const auto face = vtu.array<std::int32_t>("source_face");
  for (std::size_t i = 0; i < face.size(); ++i) CHECK(face[i] >= 0);

  c.show(c.leaves[0]);  // of a group the faces show the material of the region that they bound
  vtu = vtu_of(c.view());
  CHECK(vtu.names("region") == std::map<int, std::string>{{1, "a"}, {2, "entities"}});
  const auto material = vtu.array<std::int32_t>("material");
  const auto dimensions = vtu.array<std::int32_t>("dimension");
  for (std::size_t i = 0; i < material.size(); ++i) CHECK(material[i] == (dimensions[i] < 2 ? 0 : 2));
}
