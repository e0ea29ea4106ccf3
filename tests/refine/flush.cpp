// Boxes with faces in common planes: what they cost, and their cells counted on a grid, without any geometry.
#include <array>
#include <bit>
#include <map>
#include <random>

#include "kernel/base/union_find.h"
#include "kernel/exact/predicates.h"
#include "tests/catch.h"
#include "tests/refine/expectation.h"
#include "tests/scenes/fixture.h"
#include "tests/scenes/seeds.h"

namespace cnrg::scenes {
namespace {

using Cell = std::array<int, 3>;  // of a grid: an even coordinate is a plane, an odd one between two
struct GridBox {
  Cell low, high;
};

std::vector<Leaf> leaves_of(const std::vector<GridBox>& boxes) {
  const auto point = [](const Cell& p) {
    return std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]);
  };
  std::string text;
  for (const GridBox& box : boxes) text += "leaf sides\nbox " + point(box.low) + ", " + point(box.high) + "\n";
  return parse_fixture(text);
}

/// Cells of {-1 .. 2 size + 1}^3, with the axes to which faces of boxes that hold them are normal.
class CountedGrid {
 public:
  CountedGrid(int size, const std::vector<GridBox>& boxes)
      : m_(2 * size + 3), normals_(place({m_ - 2, m_ - 2, m_ - 2}) + 1) {
    for (const GridBox& box : boxes) add(box);
  }

  /// A point is a vertex where planes of three axes meet; an edge lies in planes of two, and ends at a vertex; a
  /// face ends where another plane is, a region at a face.
  Expected counts() const {
    Expected out;
    UnionFind squares(normals_.size()), cubes(normals_.size());
    std::size_t square_count = 0, cube_count = 0;
    for_all([&](const Cell& c, int dimension, unsigned normals) {
      const int planes = std::popcount(normals);
      if (dimension == 0) out.vertices += planes == 3;
      if (dimension == 0) out.edges -= planes == 2;
      if (dimension == 1) out.edges += planes == 2;
      if (dimension == 2) square_count += planes == 1;
      if (dimension == 3) ++cube_count;
      if (dimension == 1 && planes == 1) square_count -= joins(c, std::countr_zero(normals), squares);
      if (dimension == 2 && planes == 0) cube_count -= joins(c, -1, cubes);
    });
    out.faces = square_count;
    out.regions = cube_count;
    std::map<std::uint32_t, int> sizes;
    for_all([&](const Cell& c, int dimension, unsigned) {
      if (dimension == 3) ++sizes[cubes.find(place(c))];
    });
    sizes.erase(cubes.find(place({-1, -1, -1})));
    for (const auto& [root, size] : sizes) out.volumes.push_back(size);
    std::sort(out.volumes.begin(), out.volumes.end());
    return out;
  }

 private:
  std::uint32_t place(const Cell& c) const {
    return static_cast<std::uint32_t>(c[0] + 1 + m_ * (c[1] + 1 + m_ * (c[2] + 1)));
  }

  template <class Visit>
  void for_all(const Visit& visit) const {
    for (int x = -1; x < m_ - 1; ++x) {
      for (int y = -1; y < m_ - 1; ++y) {
        for (int z = -1; z < m_ - 1; ++z)
          visit(Cell{x, y, z}, (x & 1) + (y & 1) + (z & 1), normals_[place({x, y, z})]);
      }
    }
  }

  void add(const GridBox& box) {
    for (int x = 2 * box.low[0]; x <= 2 * box.high[0]; ++x) {
      for (int y = 2 * box.low[1]; y <= 2 * box.high[1]; ++y) {
        for (int z = 2 * box.low[2]; z <= 2 * box.high[2]; ++z) {
          const Cell c{x, y, z};
          for (std::size_t k = 0; k < 3; ++k) {
            if (c[k] == 2 * box.low[k] || c[k] == 2 * box.high[k]) normals_[place(c)] |= 1U << k;
          }
        }
      }
    }
  }

  /// Unites the two cells on both sides of c across the even axis that is not `normal`; true if they were two.
  bool joins(const Cell& c, int normal, UnionFind& sets) const {
    Cell before = c, after = c;
    for (int k = 0; k < 3; ++k) {
      if (c[static_cast<std::size_t>(k)] % 2 == 0 && k != normal)
        --before[static_cast<std::size_t>(k)], ++after[static_cast<std::size_t>(k)];
    }
    return sets.unite(place(before), place(after));
  }

  int m_;
  std::vector<unsigned> normals_;
};

/// n boxes in a row, each one further on, that share the planes of their sides.
std::vector<GridBox> row(int n) {
  std::vector<GridBox> boxes;
  for (int i = 0; i < n; ++i) boxes.push_back({{i, 0, 0}, {i + 3 * n, 1, 1}});
  return boxes;
}

TEST_CASE("Boxes with sides in common planes", "[flush]") {
  const std::vector<GridBox> boxes = row(4);
  const Expected counted = CountedGrid(16, boxes).counts();
  // A bar that 2 n planes cut.
  CHECK(counted.vertices == 8 * 4);
  CHECK(counted.faces == 2 * 4 + 4 * (2 * 4 - 1));
  expect(leaves_of(boxes), counted);
}

TEST_CASE("Random boxes on few planes, in each number of copies", "[flush]") {
  const auto [first, last] = seeds(40);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    std::mt19937_64 random(seed);
    const int size = 2 + static_cast<int>(seed % 4);
    std::vector<GridBox> boxes;
    for (std::uint64_t n = 2 + seed % 9; n > 0; --n) {
      GridBox box;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = static_cast<int>(random() % static_cast<unsigned>(size)),
                  b = a + 1 + static_cast<int>(random() % static_cast<unsigned>(size - a));
        box.low[k] = a, box.high[k] = b;
      }
      boxes.insert(boxes.end(), 1 + random() % 3, box);
    }
    INFO("seed " << seed);
    expect(leaves_of(boxes), CountedGrid(size, boxes).counts());
  }
}

std::uint64_t signs_of_boxes(const std::vector<GridBox>& boxes) {
  const Soup soup = make_soup(leaves_of(boxes));
  reset_stage_counts();
  build_complex(soup);
  const StageCounts counts = stage_counts();
  return counts.filter + counts.interval + counts.exact;
}

TEST_CASE("Boxes with sides in common planes cost the square of their number", "[flush][growth]") {
  const auto few = signs_of_boxes(row(20)), many = signs_of_boxes(row(80));
  CHECK(few > 20 * 20);
  CHECK(double(many) < 1.4 * 4 * 4 * double(few));
}

TEST_CASE("Equal boxes are met once, and counted as often as they are there", "[flush][growth]") {
  const auto report_of = [](std::size_t copies) {
    std::vector<GridBox> boxes(copies, {{0, 0, 0}, {4, 4, 4}});
    boxes.insert(boxes.end(), 3, {{1, 1, 1}, {2, 2, 9}});
    RefineReport report;
    build_complex(make_soup(leaves_of(boxes)), {}, &report);
    return report;
  };
  const RefineReport one = report_of(1), many = report_of(50);
  CHECK(many.candidates == one.candidates);
  CHECK(one.contacts[0] > 0);
  CHECK(many.contacts[0] == 50 * one.contacts[0]);
}

}  // namespace
}  // namespace cnrg::scenes
