// Joined results: nothing that does not touch is nearer than the distance, what the scene meant comes out, and
// what is gone is named.
#include "csg/result/join.h"

#include <catch2/catch.hpp>

#include "csg/formats/formats.h"
#include "csg/formats/result_file.h"
#include "csg/result/near.h"
#include "csg/result/result_data.h"
#include "csg/topology/region_graph.h"
#include "kernel/base/error.h"
#include "kernel/base/sorted.h"
#include "kernel/selection/homology.h"
#include "kernel/selection/measure.h"
#include "tests/result/near_scenes.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

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

/// Volumes by the names of regions.
std::map<std::string, Rational> volumes(const Result& result) {
  std::map<std::string, Rational> out;
  for (Component i = 1; i <= Component(result.component_count()); ++i) {
    const std::optional<Rational> volume = result.volume(i);
    if (volume && *volume != 0) out[result.attributes(i).name] += *volume;
  }
  return out;
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
  CHECK(report.remaining == 0);
  CHECK(!least_distance(after, within));
  JoinReport again;
  const Result twice = join(after, within, &again);
  CHECK(again.rounds == 0);
  CHECK(&twice.complex() == &after.complex());
  CHECK(after.component_count() == before.component_count());
  const auto was = volumes(before), is = volumes(after);
  for (const auto& [name, volume] : was) {
    if (is.contains(name)) continue;
    INFO("region " << name);
    CHECK(std::any_of(report.lost_regions.begin(), report.lost_regions.end(),
                      [&, n = name](const std::string& text) { return text.starts_with(n + ","); }));
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
  }
}
