// Regions without bounds have numbers of their own: what else there is makes the frame larger, and changes none.
//
// Planes and boxes are refined alone, alone in a larger frame, and with others. Of the third complex the first
// pieces of all regions have to come in the order of the regions.
#include <algorithm>
#include <numeric>
#include <random>

#include "csg/leaves/prepare_shapes.h"
#include "csg/leaves/unbounded.h"
#include "kernel/complex/interior.h"
#include "tests/catch.h"
#include "tests/leaves/soup_checks.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

struct Random {
  std::mt19937_64 numbers;
  int between(int low, int high) {
    return low + static_cast<int>(numbers() % static_cast<std::uint64_t>(high - low + 1));
  }
};

RationalPoint drawn(Random& random, int low, int high) {
  return {random.between(low, high), random.between(low, high), random.between(low, high)};
}

LeafInstance plane(Random& random) {
  RationalPoint normal;
  do normal = drawn(random, -2, 2);
  while (normal == RationalPoint{0, 0, 0});
  return {prepare(PlaneShape{drawn(random, -3, 3), normal})};
}

LeafInstance box(Random& random) {
  const RationalPoint low = drawn(random, -4, 4);
  return {prepare(BoxShape{low, {low[0] + random.between(1, 5), low[1] + random.between(1, 5), low[2] + 2}})};
}

std::vector<LeafInstance> leaves(Random& random, int planes, int boxes) {
  std::vector<LeafInstance> out;
  while (planes-- > 0) out.push_back(plane(random));
  while (boxes-- > 0) out.push_back(box(random));
  return out;
}

/// By region from 1 its number in another complex; 0 outside of that.
std::vector<std::uint32_t> numbers_in(const Complex& other, const Complex& complex) {
  const Locator there(other), here(complex);
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t r = 1; r < complex.region_count; ++r)
    numbers.push_back(there.locate(interior_point(complex, here, RegionId(r))).region.value());
  return numbers;
}

std::vector<std::uint32_t> ascending(std::size_t count) {
  std::vector<std::uint32_t> out(count);
  std::iota(out.begin(), out.end(), 1);
  return out;
}

}  // namespace

TEST_CASE("numbers of regions without bounds depend on no other leaf", "[regions][random]") {
  const auto [first, end] = scenes::seeds(150);
  std::size_t endless = 0;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    CAPTURE(seed);
    Random random{std::mt19937_64(seed)};
    std::vector<LeafInstance> some = leaves(random, random.between(1, 3), random.between(0, 2));
    const auto alone = build_complex(make_soup(some));
    const std::vector<RationalPoint> reach{drawn(random, -90, 90), {400, 7, -1000}};
    const auto larger = build_complex(make_soup(some, reach));
    CHECK(numbers_in(*larger, *alone) == ascending(alone->region_count - 1));
    // Nearly as large as doubles become: the box in which the order is found has no room there.
    const Rational huge = Integer(1) << 1000;
    const auto largest = build_complex(make_soup(some, std::vector<RationalPoint>{{huge, 0, Rational(-huge)}}));
    CHECK(numbers_in(*largest, *alone) == ascending(alone->region_count - 1));

    for (const LeafInstance& other : leaves(random, random.between(0, 2), random.between(1, 3)))
      some.insert(some.begin() + random.between(0, static_cast<int>(some.size())), other);
    const auto together = build_complex(make_soup(some));
    const auto all = build_complex(make_soup(some, reach));
    CHECK(numbers_in(*all, *together) == ascending(together->region_count - 1));
    std::vector<std::uint32_t> seen;
    for (const std::uint32_t number : numbers_in(*larger, *together))
      if (std::find(seen.begin(), seen.end(), number) == seen.end()) seen.push_back(number);
    CHECK(seen == ascending(larger->region_count - 1));
    for (std::uint32_t r = 1; r < alone->region_count; ++r) endless += alone->unbounded(RegionId(r));
  }
  CHECK(endless > 3 * (end - first));
}
