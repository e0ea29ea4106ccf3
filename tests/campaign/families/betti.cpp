// Betti numbers of random sets of cells: by elimination on grids, by duality on scenes.
#include "tests/oracles/betti.h"

#include "kernel/selection/homology.h"
#include "tests/campaign/families/families.h"

namespace cnrg::campaign {
namespace {

using scenes::Random;

std::string text_of(const CellSet& set) {
  return std::to_string(set.vertices.size()) + " vertices, " + std::to_string(set.edges.size()) + " edges, " +
         std::to_string(set.faces.size()) + " faces, " + std::to_string(set.regions.size()) + " 3-cells";
}

std::string text_of(const elimination::Numbers& n) {
  return std::to_string(n[0]) + " " + std::to_string(n[1]) + " " + std::to_string(n[2]);
}

std::string compare_grid(std::uint64_t seed) {
  Random random(seed + 1'000'000);
  const int n = seed % 16 == 3 ? 5 : 4;
  const auto built = elimination::random_grid(random, n);
  Neighbourhoods neighbourhoods(*built);
  BettiCounter counter(neighbourhoods);
  for (int i = 0; i < 2; ++i) {
    const CellSet set = elimination::random_set(*built, random);
    const BettiNumbers ours = counter.of(set);
    elimination::Numbers over_q;
    const elimination::Numbers over_z2 = elimination::eliminate(*built, set, n, over_q);
    if (ours.z2 != over_z2)
      return "set " + std::to_string(i) + " of " + text_of(set) + ": " + text_of(ours.z2) + " over Z/2, not " +
             text_of(over_z2);
    if (ours.q != over_q)
      return "set " + std::to_string(i) + " of " + text_of(set) + ": " + text_of(ours.q) + " over Q, not " +
             text_of(over_q);
  }
  return {};
}

struct Sets {
  std::uint64_t seed = 0;
  std::vector<scenes::Leaf> leaves;
};

std::string compare_duality(const Sets& sets) {
  const auto built = build_complex(scenes::make_soup(sets.leaves), {.threads = 1});
  const Complex& complex = *built;
  if (std::string f = cnrg::validate(complex); !f.empty()) return "the complex is not valid: " + f;
  Neighbourhoods neighbourhoods(complex);
  BettiCounter counter(neighbourhoods);
  Random random(sets.seed + 7);
  for (int i = 0; i < 3; ++i) {
    const CellSet set = elimination::random_set(complex, random);
    if (set.empty()) continue;
    const BettiNumbers b = counter.of(set);
    const std::string words = "set " + std::to_string(i) + " of " + text_of(set) + ": ";
    if (b.z2[2] != elimination::complement_pieces(complex, set) - 1) return words + "cavities";
    const CellSet rest = subtract(all_cells(complex), set);
    const bool in = std::binary_search(set.regions.begin(), set.regions.end(), RegionId(0));
    const BettiNumbers c = counter.of(rest);
    if (b.z2[1] != c.z2[1]) return words + "loops of the complement";
    if (b.z2[2] != c.z2[0] - (in ? 0 : 1)) return words + "pieces of the complement";
    if (!rest.empty() && c.z2[2] != b.z2[0] - (in ? 1 : 0)) return words + "cavities of the complement";
  }
  return {};
}

}  // namespace

void add_betti(Families& families) {
  Recipe<std::uint64_t> grid;
  grid.name = "betti-grids";
  grid.oracle = "elimination over Z/2 and Q";
  grid.share = 0.3;
  grid.make = [](std::uint64_t seed) { return seed; };
  grid.compare = compare_grid;
  grid.smaller = [](std::uint64_t) { return std::vector<std::uint64_t>(); };
  grid.text = [](std::uint64_t) { return std::string("# sets of cells of a grid, made by the seed alone\n"); };
  add(families, grid);

  Recipe<Sets> scenes_of;
  scenes_of.name = "betti-scenes";
  scenes_of.oracle = "Alexander duality";
  scenes_of.share = 1.5;
  scenes_of.make = [](std::uint64_t seed) {
    const auto position = static_cast<scenes::Position>(seed % 3);
    return Sets{seed, scenes::random_leaves(seed + 50'000'000, 2, position)};
  };
  scenes_of.compare = compare_duality;
  scenes_of.smaller = [](const Sets& sets) {
    std::vector<Sets> out;
    for (std::vector<scenes::Leaf>& less : scenes::smaller(sets.leaves))
      out.push_back({sets.seed, std::move(less)});
    return out;
  };
  scenes_of.text = [](const Sets& sets) { return scenes::tree_file(sets.leaves); };
  add(families, scenes_of);
}

}  // namespace cnrg::campaign
