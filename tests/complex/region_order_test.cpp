// Regions have the numbers that follow from where they are: what else lies there changes none.
//
// Leaves are refined alone, and with others in another order and with their faces the other way round. In the
// second complex a region of the first is in pieces: the first pieces of all regions have to come in the order of
// regions.
#include <algorithm>
#include <numeric>

#include "kernel/complex/complex.h"
#include "kernel/complex/interior.h"
#include "tests/catch.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using namespace cnrg::scenes;

TEST_CASE("numbers of regions depend on no other leaf", "[complex][regions][random]") {
  const auto [first, end] = seeds(150);
  std::size_t regions = 0, pieces = 0;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    CAPTURE(seed);
    const auto position = std::array{Position::degenerate, Position::tilted, Position::general}[seed % 3];
    const std::vector<Leaf> leaves = random_leaves(seed, 5, position);
    const std::vector<Leaf> some(leaves.begin(), leaves.begin() + 2);
    SoupOptions options;
    options.reverse_faces = seed % 2 == 1;
    options.order.resize(leaves.size());
    std::iota(options.order.begin(), options.order.end(), std::size_t{0});
    Random random(seed);
    for (std::size_t i = leaves.size(); i > 1; --i)
      std::swap(options.order[i - 1], options.order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    const auto alone = build_complex(make_soup(some)), together = build_complex(make_soup(leaves, options));

    const Locator place(*alone), inside(*together);
    std::vector<std::uint32_t> seen;
    for (std::uint32_t r = 1; r < together->region_count; ++r) {
      const Location at = place.locate(interior_point(*together, inside, RegionId(r)));
      REQUIRE(at.dimension == 3);
      const std::uint32_t number = at.region.value();
      if (number != 0 && std::find(seen.begin(), seen.end(), number) == seen.end()) seen.push_back(number);
    }
    std::vector<std::uint32_t> all(alone->region_count - 1);
    std::iota(all.begin(), all.end(), 1);
    CHECK(seen == all);
    regions += seen.size();
    pieces += together->region_count;
  }
  CHECK(regions > end - first);
  CHECK(pieces > 2 * regions);
}
