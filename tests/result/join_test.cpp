// Joined results: nothing that does not touch is nearer than the distance, what the scene meant comes out, and
// what is gone is named.
#include "csg/result/join.h"

#include <map>
#include <set>

#include "csg/formats/formats.h"
#include "csg/formats/result_file.h"
#include "csg/formats/tetrahedra_arrays.h"
#include "csg/result/near.h"
#include "csg/result/result_data.h"
#include "csg/topology/region_graph.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/homology.h"
#include "kernel/selection/measure.h"
#include "tests/catch.h"
#include "tests/result/near_scenes.h"
#include "tests/result/region_volumes.h"
#include "tests/result/stops.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

const Rational kSlight(1, 1000000);

Result result_of(const Case& c) {
  ResultNames names;
  names.result = "model";
  for (const LeafInfo& info : c.infos) names.leaves.push_back(info.name);
  return Result(c.complex, c.group, names);
}

/// The least square of a distance below `within`; nothing if nothing is as near.
std::optional<Rational> least_distance(const Result& result, const Rational& within) {
  const ResultView view = result.data().view();
  const FlatComplex flat = flatten(view);
  const Parts parts(view, flat);
  std::optional<Rational> least;
  for (const Near kind : kNears) {
    const auto pairs = near_pairs(parts, kind, within);
    if (!pairs.empty() && (!least || pairs.front().squared < *least)) least = pairs.front().squared;
  }
  return least;
}

/// What a result is but for its measures: Betti numbers of the whole and of the solids by name, and which of these
/// touch. Whether a solid that a sheet cuts is one component or two, its order has no say in.
std::string shape_of(const Result& result) {
  const Selection selection = result.selection();
  std::vector<Component> solid, all;
  const auto see = [](const auto& cells, std::vector<Component>& to) {
    for (const auto& [cell, component] : cells) to.push_back(component);
  };
  see(selection.regions, solid);
  see(selection.regions, all), see(selection.faces, all), see(selection.edges, all), see(selection.vertices, all);
  sort_unique(solid), sort_unique(all);
  Neighbourhoods neighbourhoods(result.complex());
  BettiCounter counter(neighbourhoods);
  const std::vector<BettiNumbers> numbers = betti_numbers(selection, all, counter);
  std::map<std::string, std::array<long, 3>> by_name{{"whole", numbers[0].z2}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!std::binary_search(solid.begin(), solid.end(), all[i])) continue;
    auto& sum = by_name[result.attributes(all[i]).name];
    for (std::size_t k = 0; k < 3; ++k) sum[k] += numbers[i + 1].z2[k];
  }
  const RegionGraph graph = region_graph(result.cells(), result.data().value->attributes());
  std::set<std::array<std::string, 2>> touching;
  for (const auto& edge : graph.edges) {
    std::array<std::string, 2> names;
    for (std::size_t k = 0; k < 2; ++k) {
      const Component c = graph.nodes[edge.nodes[k]].component;
      names[k] = c == 0 ? "outside" : result.attributes(c).name;
    }
    std::sort(names.begin(), names.end());
    if (names[0] != names[1]) touching.insert(names);
  }
  std::string text;
  for (const auto& [name, b] : by_name)
    text += name + ": " + std::to_string(b[0]) + " " + std::to_string(b[1]) + " " + std::to_string(b[2]) + "\n";
  for (const auto& [a, b] : touching) text += a + " touches " + b + "\n";
  return text;
}

std::string told(const JoinReport& report, const Rational& within) {
  std::string text = report.text(within) + "\n";
  for (const std::string& line : report.merged) text += line + "\n";
  for (const std::string& line : report.lost_regions) text += "lost " + line + "\n";
  return text;
}

/// What holds for every joined result.
void check_joined(const Result& before, const Result& after, const JoinReport& report, const Rational& within) {
  INFO(told(report, within));
  REQUIRE(validate(after.complex()) == "");
  CHECK(report.displacement < kMostJoinMoves * to_double(within));
  const std::optional<Rational> least = least_distance(after, within);
  CHECK(least.has_value() == (report.remaining > 0));
  if (!least) {
    JoinReport again;
    const Result twice = join(after, within, &again);
    CHECK(again.rounds == 0);
    CHECK(&twice.complex() == &after.complex());
  }
  CHECK(after.data().value->is_group() == before.data().value->is_group());
  const auto was = volumes(before), is = volumes(after);
  for (const auto& [name, volume] : was) {
    if (is.contains(name)) continue;
    INFO("region " << name);
    CHECK(std::any_of(report.lost_regions.begin(), report.lost_regions.end(),
                      [&, n = name](const std::string& text) {
                        return text.starts_with(n + ",") || text.starts_with(n + " (all ");
                      }));
  }
  for (const auto& [name, volume] : is) CHECK(was.contains(name));
}

}  // namespace

TEST_CASE("join: a jittered lattice becomes the lattice", "[join][random]") {
  const Rational d(1, 50);
  const auto [first, last] = scenes::seeds(60);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    Dice dice(seed);
    const auto scene = lattice_scene(dice, 4, false);
    INFO(to_text(scene));
    const Case meant = lattice_case(scene, dice, 0), typed = lattice_case(scene, dice, d / 8);
    const Result exact = result_of(meant), rough = result_of(typed);
    JoinReport report;
    const Result joined = join(rough, d, &report);
    check_joined(rough, joined, report, d);
    INFO(told(report, d));
    CHECK(report.remaining == 0);
    CHECK(shape_of(joined) == shape_of(exact));
    const auto want = volumes(exact), have = volumes(joined);
    CHECK(want.size() == have.size());
    for (const auto& [name, volume] : want) {
      INFO("region " << name);
      REQUIRE(have.contains(name));
      CHECK(abs(have.at(name) - volume) < Rational(2));
    }
  }
}

TEST_CASE("join: scenes of any directions", "[join][random]") {
  const auto [first, last] = scenes::seeds(40);
  std::size_t remained = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    Dice dice(seed + 1'000'000);
    const auto scene = lattice_scene(dice, 3, true);
    INFO(to_text(scene));
    const Rational d = Rational(1, dice(2) == 0 ? 50 : 7);
    const Case typed = lattice_case(scene, dice, d / 8);
    const Result rough = result_of(typed);
    JoinReport report;
    const Result joined = join(rough, d, &report);
    check_joined(rough, joined, report, d);
    remained += report.remaining > 0;
  }
  CHECK(remained * 200 <= last - first);
}

TEST_CASE("join: a bolt's end goes to the fault, which stays flat", "[join]") {
  const Rational gap(1, 100000);
  Soup soup;
  add_wire(soup, {2, 2, 1}, {2, 2, 2 - gap});
  add_sheet(soup, {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}});
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  Case c(soup, {{}, {}, {{"rock", "granite", {}}}});
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, Rational(1, 1000), &report);
  check_joined(before, after, report, Rational(1, 1000));
  CHECK(report.rounds == 1);
  JoinReport harmless;
  CHECK(shape_of(join(before, Rational(1, 1000), &harmless, {}, Joins::harmless)) == shape_of(after));
  CHECK((harmless.rounds == 1 && !harmless.refused));
  REQUIRE(report.merged.size() == 1);
  CHECK_THAT(report.merged[0], Catch::Contains("point v") && Catch::Contains("of leaf0 and face f") &&
                                   Catch::Contains("of leaf1, at (2, 2, 2): 1e-05 apart"));
  CHECK(report.displacement == Approx(1e-5));
  CHECK(report.lost_regions.empty());
  // As if it had been typed so; the bolt's end is a vertex in the middle of the fault.
  Soup meant;
  add_wire(meant, {2, 2, 1}, {2, 2, 2});
  add_sheet(meant, {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}});
  add_box(meant, {0, 0, 0}, {4, 4, 4});
  Case m(meant, {{}, {}, {{"rock", "granite", {}}}});
  m.show(m.unite(Dominance::left));
  CHECK(active_counts(after.cells()) == active_counts(result_of(m).cells()));
  CHECK(volumes(after).at("rock") == 64);
  for (Component i = 1; i <= Component(before.component_count()); ++i) {
    CHECK(after.attributes(i).name == before.attributes(i).name);
    CHECK(after.attributes(i).material == before.attributes(i).material);
  }
  // Cells still know their leaves.
  const ResultView view = after.data().view();
  const FlatComplex flat = flatten(view);
  for (const auto& e : flat.edges) {
    if (e.wire) CHECK(e.origin.leaves == ShortList<LeafId, 2>{LeafId(0)});
  }
}

TEST_CASE("join: a corner of a sheet goes along the floor to its edge", "[join]") {
  const Rational gap(1, 10000);
  Soup soup;
  add_sheet(soup, {{1, gap, 0}, {3, gap, 4 - gap}, {3, 4 - gap, 4 - gap}, {1, 4 - gap, 0}});
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  Case c(soup, {{}, {{"rock", "", {}}}});
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, Rational(1, 1000), &report);
  check_joined(before, after, report, Rational(1, 1000));
  CHECK(volumes(after).at("rock") == 64);  // no wall has moved
  CHECK(report.regions_before == 1);
  CHECK(report.regions_after == 2);  // the fault parts it now
}

TEST_CASE("join: a region thinner than the distance vanishes and is named", "[join]") {
  const Rational thin(1, 100000);
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {0, 0, 1}, {1, 1, 1 + thin});
  add_box(soup, {0, 0, 1 + thin}, {1, 1, 2});
  Case c(soup, {{{"low", "", {}}}, {{"dust", "", {}}}, {{"high", "", {}}}});
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  JoinReport report;
  const Result whole = join(before, Rational(1, 1000), &report, {}, Joins::harmless);
  CHECK(&whole.complex() == &before.complex());
  CHECK((report.refused && report.rounds == 0 && report.lost_regions.empty()));
  const Result after = join(before, Rational(1, 1000), &report);
  check_joined(before, after, report, Rational(1, 1000));
  CHECK_FALSE(report.refused);
  REQUIRE(report.lost_regions.size() == 1);
  CHECK_THAT(report.lost_regions[0], Catch::StartsWith("dust, r") && Catch::Contains(", at (0, 0, 1)"));
  CHECK(volumes(after) == std::map<std::string, Rational>{{"low", 1}, {"high", 1}});
  CHECK(active_counts(after.cells()) == std::array<std::size_t, 4>{12, 20, 11, 2});
  CHECK(report.reach == Rational(1, 1000));
  // What has vanished is no component of the file, which is read back.
  CHECK(after.component_count() == 3);  // low, high, their entities
  const test::ScratchFolder scratch;
  write(scratch / "left.json", after);
  const Result read = read_result(scratch / "left.json");
  CHECK(volumes(read) == volumes(after));
  CHECK(active_counts(read.cells()) == active_counts(after.cells()));
}

TEST_CASE("join: a region loses the slits that it fills and stays", "[join]") {
  const Rational thin(1, 100000), d(1, 1000);
  Soup soup;
  add_box(soup, {0, 0, 0}, {9, 1, 1});
  add_box(soup, {0, 0, 1 + thin}, {4, 1, 2});
  add_box(soup, {5, 0, 1 + thin}, {9, 1, 2});
  add_box(soup, {0, 0, 0}, {9, 1, 2});
  Case c(soup, {{{"low", "", {}}}, {{"left", "", {}}}, {{"right", "", {}}}, {{"filling", "", {}}}});
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, d, &report);
  check_joined(before, after, report, d);
  CHECK(volumes(after).size() == 4);
  CHECK(report.lost_regions.empty());
  CHECK(report.remaining == 0);
}

TEST_CASE("join: places where joined things meet keep few digits", "[join]") {
  // Wires pass each other and sheets at distances below d, in no special direction: each meeting is at the foot of
  // what earlier ones made.
  const Rational d(1, 100);
  Soup soup;
  Dice dice(7);
  const auto off = [&](int x) -> Rational { return x + d / 4 * dice.unit() / 3; };
  for (int i = 0; i < 5; ++i)
    add_wire(soup, {off(-5 - i), off(2 * i - 5), off(3 - i)}, {off(5 + i), off(5 - 2 * i), off(i - 3)});
  add_sheet(soup, {{off(-2), off(-3), off(1)}, {off(3), off(-2), off(0)}, {off(0), off(4), off(-1)}});
  add_sheet(soup, {{off(-3), off(-2), off(-1)}, {off(2), off(-3), off(0)}, {off(1), off(4), off(1)}});
  Case c(soup);
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, d, &report);
  check_joined(before, after, report, d);
  CHECK(report.rounds > 1);
  std::size_t most = 0;
  const FlatComplex flat = flatten(after.data().view());
  for (const VertexId v : flat.points) {
    for (const Rational& x : after.complex().points.rational(v))
      most = std::max(most, mpz_sizeinbase(x.get_den_mpz_t(), 2));
  }
  CHECK(most < 8192);
}

TEST_CASE("join: what is far stays the same object", "[join]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  Case c(soup);
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, Rational(1, 1000), &report);
  CHECK(report.rounds == 0);
  CHECK(&after.complex() == &before.complex());
  CHECK(report.text(Rational(1, 1000)) == "nothing is nearer than 0.001 that does not touch; nothing was joined");
  // Not at most, but less.
  CHECK(&join(before, Rational(1) - kSlight).complex() == &before.complex());
}

TEST_CASE("join: two surfaces of many triangles in one place become one", "[join]") {
  // Their edges cross in more points than the two have.
  const Rational d(1, 1000), ripple = d / 5;
  Soup soup;
  Dice dice(1);
  std::size_t corners = 0;
  for (const int n : {7, 8}) {
    const LeafId leaf = soup.add_leaf(Fill::none);
    std::vector<PointId> at;
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; k <= n; ++k) {
        at.push_back(soup.add_point(RationalPoint{Rational(10 * i + 2 * dice.unit()) / n,
                                                  Rational(10 * k + 2 * dice.unit()) / n,
                                                  ripple * dice.unit() + (n == 7 ? Rational(0) : 2 * ripple)}));
      }
    }
    corners += at.size();
    std::uint32_t number = 0;
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        const PointId p = at[i * (n + 1) + k], q = at[(i + 1) * (n + 1) + k], r = at[(i + 1) * (n + 1) + k + 1],
                      s = at[i * (n + 1) + k + 1];
        soup.add_triangle(leaf, p, q, r, number, number), ++number;
        soup.add_triangle(leaf, p, r, s, number, number), ++number;
      }
    }
  }
  Case c(soup);
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, d, &report);
  check_joined(before, after, report, d);
  CHECK(report.remaining == 0);
  CHECK(active_counts(after.cells())[0] > 2 * corners);
}

TEST_CASE("join: more pairs than a few are not joined as harmless", "[join]") {
  const Rational gap(1, 100000);
  for (const std::size_t pairs : {kFewPairs, kFewPairs + 1}) {
    Soup soup;
    for (std::size_t i = 0; i < pairs; ++i) {
      const Rational x(i);
      add_wire(soup, {x, 0, 0}, {x, 1, 0});
      add_wire(soup, {x, 1 + gap, 0}, {x, 2, 0});
    }
    Case c(soup);
    c.show(c.unite(Dominance::left));
    const Result before = result_of(c);
    JoinReport report;
    const Result after = join(before, Rational(1, 1000), &report, {}, Joins::harmless);
    CHECK(report.refused == (pairs > kFewPairs));
    CHECK(report.merged.size() == (report.refused ? 0 : pairs));
  }
}

TEST_CASE("join: a group is a group again, and its file has the same cells", "[join]") {
  // Found by random scenes: the tops become two faces of several facets, with edges of either box that are
  // features. Read back as components, coplanar sides of the two were one.
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 2});
  add_box(soup, {1, 0, 0}, {2, 2, Rational(1999, 1000)});
  Case c(soup, {{{"left", "", {}}}, {{"right", "", {}}}});
  c.show(c.unite());
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, Rational(1, 250), &report);
  check_joined(before, after, report, Rational(1, 250));
  CHECK(after.data().value->is_group());
  const test::ScratchFolder scratch;
  write(scratch / "group.json", after);
  const Result read = read_result(scratch / "group.json");
  CHECK(read.data().value->is_group());
  CHECK(active_counts(read.cells()) == active_counts(after.cells()));
}

TEST_CASE("join: components of a group keep their order", "[join]") {
  // Numbers follow the leaves, not the places.
  Soup soup;
  add_box(soup, {4, 0, 0}, {5, 1, 1});
  add_box(soup, {1, 0, 0}, {2, 1, 1});
  add_box(soup, {Rational(2001, 1000), 0, 0}, {3, 1, 1});
  add_box(soup, {0, 0, 0}, {Rational(999, 1000), 1, 1});
  Case c(soup, {{{"a", "", {}}}, {{"b", "", {}}}, {{"c", "", {}}}, {{"d", "", {}}}});
  c.show(c.unite());
  const Result before = result_of(c), after = join(before, Rational(1, 250));
  const auto names = [](const Result& result) {
    std::vector<std::string> out;
    for (const RegionAttributes& region : result.data().value->group().regions) out.push_back(region.name);
    return out;
  };
  REQUIRE(names(before).size() == 4);
  CHECK(names(after) == names(before));
}

TEST_CASE("join: stopped at each stage", "[join]") {
  const Rational thin(1, 100000);
  Soup soup;
  add_wire(soup, {2, 2, 1}, {2, 2, 2 - thin});
  add_sheet(soup, {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}});
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add_box(soup, {0, 0, 4 + thin}, {4, 4, 5});
  Case c(soup);
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  check_stops([&](const Watch& watch) { join(before, Rational(1, 1000), nullptr, watch); },
              {"join, round 1: near features", "join, round 1: move", "join, round 1: refine: contacts",
               "join, round 2: near features"});
}

TEST_CASE("join: distances that are none", "[join]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 2, 3});
  Case c(soup);
  const Result result = result_of(c);
  CHECK_THROWS_WITH(join(result, 0), Catch::Contains("must be positive, and is 0"));
  CHECK_THROWS_WITH(join(result, -1), Catch::Contains("must be positive, and is -1"));
  CHECK_THROWS_WITH(join(result, 3), Catch::Contains("the whole result is 3 long; give a smaller distance"));
  Soup wire;
  add_wire(wire, {0, 0, 0}, {1, 1, 1});
  Case w(wire);
  CHECK_NOTHROW(join(result_of(w), Rational(1, 2)));
}

TEST_CASE("join: written, read back, and meshed", "[join]") {
  const Rational gap(1, 10000);
  Soup soup;
  add_sheet(soup, {{-1, 1, 1 + gap}, {5, 1, 3}, {5, 3, 3}, {-1, 3, 1 + gap}});
  add_box(soup, {0, 0, 0}, {2, 4, 4});
  add_box(soup, {2 + gap, 0, 0}, {4, 4, 4});
  Case c(soup, {{}, {{"a", "", {}}}, {{"b", "", {}}}});
  c.show(c.unite(Dominance::left));
  const Result before = result_of(c);
  JoinReport report;
  const Result after = join(before, Rational(1, 100), &report);
  check_joined(before, after, report, Rational(1, 100));
  const test::ScratchFolder scratch;
  for (const char* const name : {"j.json", "j.vtu", "j.msh", "j.obj", "j.glb", "j.poly"})
    CHECK_NOTHROW(write(scratch / name, after));
  const Result read = read_result(scratch / "j.json");
  CHECK(active_counts(read.cells()) == active_counts(after.cells()));
  CHECK(volumes(read) == volumes(after));
  Rational sum = 0;
  for (const RegionTetrahedra& region : TetrahedralResult(after).arrays().regions) sum += region.volume;
  CHECK(to_double(abs(sum - volumes(after).at("a") - volumes(after).at("b"))) < 1e-12);
}
