// Brute force on cubical complexes (tests/oracles/cubical.h): the tables, then whole trees with every operator.
#include "tests/campaign/families/families.h"
#include "tests/oracles/cubical_compare.h"
#include "tests/oracles/cubical_pair.h"

namespace cnrg::campaign {
namespace {

/// Where 2 x 2 x 2 cubes are free, or 3 x 3 x 3.
const cubical::Grid& grid(bool large) {
  static const cubical::Grid small_grid(4), large_grid(5);
  return large ? large_grid : small_grid;
}

struct GridPair {
  bool large = false;
  cubical::Pair pair;
};

struct GridDag {
  bool large = false;
  cubical::CubicalDag dag;
};

}  // namespace

void add_cubes(Families& families) {
  const auto pairs = [&](const char* name, const char* oracle, double share, std::uint64_t offset, bool moved) {
    Recipe<GridPair> pair;
    pair.name = name;
    pair.oracle = oracle;
    pair.share = share;
    pair.make = [=](std::uint64_t seed) {
      GridPair out{seed % 3 == 0, {}};
      out.pair = cubical::random_pair(grid(out.large), seed + offset, seed % 2 == 0 ? 1 : 4);
      if (moved) out.pair.presentation.place = cubical::random_place(seed);
      out.pair.presentation.thorough = seed % 4 == 1;
      return out;
    };
    pair.compare = [](const GridPair& p) {
      return cubical::compare_pair(grid(p.large), p.pair.a, p.pair.b, p.pair.presentation);
    };
    pair.smaller = [](const GridPair& p) {
      std::vector<GridPair> out;
      for (cubical::Group cubical::Pair::*which : {&cubical::Pair::a, &cubical::Pair::b})
        for (cubical::Group& less : cubical::smaller(grid(p.large), p.pair.*which)) {
          out.push_back(p);
          out.back().pair.*which = std::move(less);
        }
      return out;
    };
    pair.text = [](const GridPair& p) { return cubical::tree_file(grid(p.large), p.pair); };
    add(families, pair);
  };
  pairs("cubes", "brute force on cubes: the tables", 4, 60'000'000, false);
  pairs("cubes-mapped", "brute force on cubes turned, sheared, reflected", 2, 70'000'000, true);

  const auto dags = [&](const char* name, const char* oracle, double share, std::uint64_t offset, bool moved) {
    Recipe<GridDag> dag;
    dag.name = name;
    dag.oracle = oracle;
    dag.share = share;
    dag.make = [=](std::uint64_t seed) {
      const bool large = seed % 8 == 0, said = seed % 6 != 5;
      return GridDag{large, said ? cubical::random_said_dag(grid(large), seed + offset, moved)
                                 : cubical::random_cubical_dag(grid(large), seed + offset, moved)};
    };
    dag.compare = [](const GridDag& d) { return cubical::compare_by_brute_force(grid(d.large), d.dag); };
    dag.smaller = [](const GridDag& d) {
      std::vector<GridDag> out;
      for (cubical::CubicalDag& less : cubical::smaller(grid(d.large), d.dag))
        out.push_back({d.large, std::move(less)});
      return out;
    };
    dag.text = [](const GridDag& d) { return cubical::tree_file(d.dag); };
    add(families, dag);
  };
  dags("cube-trees", "brute force on cubes: every operator, what is said of each cell", 2.5, 80'000'000, false);
  dags("cube-trees-mapped", "the same, mapped", 0.7, 90'000'000, true);
}

}  // namespace cnrg::campaign
