// Random trees of boxes, sheets, wires and points on a grid, compared, against arrays over all cells of the grid.
//
// A cell of the grid is a point of half-integers: odd coordinates are those in which it extends. Operators are
// their definitions on such arrays (csg/SEMANTICS.md#components). What is only in one of two arrays is counted
// there: its connected pieces, and its cells that bound no larger one. Nothing of the program is used but its
// answers.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "tests/catch.h"
#include "tests/compare/trees.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using scenes::Random;

constexpr int kSize = 4;              // the grid goes from 0 to kSize, shapes stay off its border
constexpr int kSide = 2 * kSize + 1;  // cells along an axis

using Cell = std::array<int, 3>;                  // twice the coordinates of its middle
using Labels = std::map<Cell, std::vector<int>>;  // of active cells: what tells components apart

int dimension(const Cell& c) { return c[0] % 2 + c[1] % 2 + c[2] % 2; }

template <class F>
void for_all(F visit) {
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      for (int z = 0; z < kSide; ++z) visit(Cell{x, y, z});
    }
  }
}

/// f(cell) for all cells whose boundary holds `c`, in the grid, `c` included.
template <class F>
void for_star(const Cell& c, F visit) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const Cell d{c[0] + x, c[1] + y, c[2] + z};
        bool larger = true;
        for (int k = 0; k < 3; ++k)
          larger = larger && d[k] >= 0 && d[k] < kSide && (d[k] == c[k] || c[k] % 2 == 0);
        if (larger) visit(d);
      }
    }
  }
}

/// An operand: its text, and its components on the grid.
struct Value {
  std::string text;
  Labels cells;
};

/// All cells of a closed box with corners of integers; flat in some axes, perhaps in all.
Value leaf(Random& random) {
  Cell low, high;
  std::vector<int> wide;
  const int wanted = random.below(4);
  for (int k = 0; k < 3; ++k) {
    low[k] = 1 + random.below(kSize - 2);
    high[k] = low[k];
  }
  std::array<int, 3> axes{0, 1, 2};
  std::swap(axes[0], axes[random.below(3)]);
  std::swap(axes[1], axes[1 + random.below(2)]);
  for (int i = 0; i < wanted; ++i) {
    high[axes[i]] = low[axes[i]] + 1 + random.below(kSize - 1 - low[axes[i]]);
    wide.push_back(axes[i]);
  }
  const auto point = [](const Cell& p) {
    return "[" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + "]";
  };
  Value value;
  if (wanted == 3) value.text = "{box: {min: " + point(low) + ", max: " + point(high) + "}}";
  if (wanted == 2) {
    Cell p = low, q = high;
    p[wide[0]] = high[wide[0]], q[wide[0]] = low[wide[0]];
    value.text = "{polygon: [" + point(low) + ", " + point(p) + ", " + point(high) + ", " + point(q) + "]}";
  }
  if (wanted == 1) value.text = "{polyline: [" + point(low) + ", " + point(high) + "]}";
  if (wanted == 0) value.text = "{points: [" + point(low) + "]}";
  value.text = "{unify: " + value.text + "}";
  for_all([&](const Cell& c) {
    bool inside = true;
    for (int k = 0; k < 3; ++k) inside = inside && c[k] >= 2 * low[k] && c[k] <= 2 * high[k];
    if (inside) value.cells[c] = {0};
  });
  return value;
}

bool has(const Labels& cells, const Cell& c) { return cells.contains(c); }

Labels inner_labels(const Labels& x) {
  Labels out;
  for (const auto& [c, label] : x) {
    bool inside = true;
    for_star(c, [&](const Cell& d) { inside = inside && has(x, d); });
    if (inside) out[c] = label;
  }
  return out;
}

/// What is added is one more component.
Labels closed_labels(const Labels& x) {
  Labels out = x;
  for_all([&](const Cell& c) {
    bool beside = false;
    for_star(c, [&](const Cell& d) { beside = beside || has(x, d); });
    if (beside && !has(x, c)) out[c] = {-1};
  });
  return out;
}

/// Label k first, then those of the component: components of different operands stay apart.
std::vector<int> tagged(int k, const std::vector<int>& label) {
  std::vector<int> out{k};
  out.insert(out.end(), label.begin(), label.end());
  return out;
}

Labels overlay(const std::string& op, const Labels& x, const Labels& y) {
  Labels out;
  for (const auto& [c, label] : x) {
    const auto other = y.find(c);
    if (other == y.end()) {
      if (op != "product") out[c] = tagged(1, label);
    } else if (op != "subtract") {
      std::vector<int> both = tagged(3, label);
      both.push_back(1000);
      both.insert(both.end(), other->second.begin(), other->second.end());
      out[c] = both;
    }
  }
  if (op == "sum") {
    for (const auto& [c, label] : y) {
      if (!has(x, c)) out[c] = tagged(2, label);
    }
  }
  return out;
}

Value random_value(Random& random, int depth) {
  if (depth == 0) return leaf(random);
  const int kind = random.below(8);
  if (kind < 6) {
    const char* const op = kind < 3 ? "sum" : kind < 4 ? "product" : "subtract";
    const Value x = random_value(random, depth - 1), y = random_value(random, random.below(depth));
    return {std::string("{") + op + ": [" + x.text + ", " + y.text + "]}", overlay(op, x.cells, y.cells)};
  }
  const Value x = random_value(random, depth - 1);
  if (kind == 6) return {"{interior: " + x.text + "}", inner_labels(x.cells)};
  return {"{closure: " + x.text + "}", closed_labels(x.cells)};
}

using Set = std::set<Cell>;

struct Count {
  std::size_t pieces = 0;
  std::array<std::size_t, 4> cells{};  // by dimension, those that bound no larger one
};

Count count(const Set& set) {
  Count out;
  Set left = set;
  while (!left.empty()) {
    ++out.pieces;
    std::vector<Cell> open{*left.begin()};
    left.erase(left.begin());
    while (!open.empty()) {
      const Cell c = open.back();
      open.pop_back();
      for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
          for (int z = -1; z <= 1; ++z) {
            const Cell d{c[0] + x, c[1] + y, c[2] + z};
            // One of the two is in the closure of the other.
            bool up = true, down = true;
            for (int k = 0; k < 3; ++k) {
              up = up && (d[k] == c[k] || c[k] % 2 == 0), down = down && (d[k] == c[k] || d[k] % 2 == 0);
            }
            if ((up || down) && left.erase(d) != 0) open.push_back(d);
          }
        }
      }
    }
  }
  for (const Cell& c : set) {
    bool bounds = false;
    for_star(c, [&](const Cell& d) { bounds = bounds || (d != c && set.contains(d)); });
    if (!bounds) ++out.cells[static_cast<std::size_t>(dimension(c))];
  }
  return out;
}

Cell cell_of(const RationalPoint& p) {
  Cell c;
  for (int k = 0; k < 3; ++k) {
    const Integer whole = p[k].get_num() / p[k].get_den();
    c[k] = static_cast<int>(2 * whole.get_si()) + (p[k] == Rational(whole) ? 0 : 1);
  }
  return c;
}

/// Holds pieces of a comparison against a set of cells.
void check_pieces(const std::vector<SetPiece>& pieces, const Set& set) {
  const Count expected = count(set);
  CHECK(pieces.size() == expected.pieces);
  Size size;
  for (const SetPiece& piece : pieces) size.add(piece.size);
  REQUIRE(size.volume);
  CHECK(*size.volume == Rational(expected.cells[3]));
  CHECK(size.area.sum.text() == std::to_string(expected.cells[2]));
  CHECK(size.length.sum.text() == std::to_string(expected.cells[1]));
  CHECK(size.points == expected.cells[0]);
  for (const SetPiece& piece : pieces) CHECK(set.contains(cell_of(piece.at)));
  for (std::size_t i = 1; i < pieces.size(); ++i) CHECK(*pieces[i - 1].size.volume >= *pieces[i].size.volume);
}

/// One component of one array is one of the other, cell by cell.
bool one_to_one(const Labels& a, const Labels& b) {
  std::map<std::vector<int>, std::set<std::vector<int>>> to_b, to_a;
  for (const auto& [c, label] : a) {
    const auto it = b.find(c);
    if (it == b.end()) return false;
    to_b[label].insert(it->second), to_a[it->second].insert(label);
  }
  const auto one = [](const auto& entry) { return entry.second.size() == 1; };
  return a.size() == b.size() && std::all_of(to_b.begin(), to_b.end(), one) &&
         std::all_of(to_a.begin(), to_a.end(), one);
}

Set labels_apart(const Labels& a, const Labels& b) {
  Set out;
  for (const auto& [c, label] : a) {
    if (!has(b, c)) out.insert(c);
  }
  return out;
}

struct Verdict {
  bool sets = false, components = false;
};

Verdict check_values(const Value& a, const Value& b) {
  const std::string tree_a = "v: " + a.text, tree_b = "v: " + b.text;
  INFO("A: " << a.text << "\nB: " << b.text);
  const Comparison comparison = test::compared(tree_a, tree_b);
  INFO(comparison_text(comparison, 100));
  const Set only_a = labels_apart(a.cells, b.cells), only_b = labels_apart(b.cells, a.cells);
  check_pieces(comparison.only[0], only_a);
  check_pieces(comparison.only[1], only_b);
  const bool alike = one_to_one(a.cells, b.cells);
  CHECK(comparison.same() == alike);
  CHECK((comparison_text(comparison).empty()) == alike);
  CHECK(comparison.attributes.empty());

  const Comparison mirrored = test::compared(tree_b, tree_a);
  CHECK(mirrored.same() == alike);
  for (std::size_t side = 0; side < 2; ++side) {
    CHECK(mirrored.only[side].size() == comparison.only[1 - side].size());
    CHECK(mirrored.features[side].size() == comparison.features[1 - side].size());
  }
  REQUIRE(mirrored.moved.size() == comparison.moved.size());
  CHECK(mirrored.regrouped.size() == comparison.regrouped.size());
  for (const Comparison::Moved& one : comparison.moved) {
    CHECK(std::any_of(mirrored.moved.begin(), mirrored.moved.end(), [&](const Comparison::Moved& other) {
      return other.in[0] == one.in[1] && other.in[1] == one.in[0] && other.pieces.size() == one.pieces.size();
    }));
  }
  CompareOptions points;
  points.components = false;
  CHECK(test::compared(tree_a, tree_b, points).same() == (only_a.empty() && only_b.empty()));
  return {only_a.empty() && only_b.empty(), alike};
}

TEST_CASE("Random trees of sets differ where arrays over a grid do", "[compare][cubical]") {
  const auto [first, last] = scenes::seeds(150);
  std::size_t sets = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    Random random(seed);
    const Value a = random_value(random, 1 + random.below(3));
    const Value b = random_value(random, 1 + random.below(3));
    sets += check_values(a, b).sets;
    // Changed in one operand at the top: large parts in common.
    const Value c = random_value(random, 1);
    check_values({"{sum: [" + a.text + ", " + b.text + "]}", overlay("sum", a.cells, b.cells)},
                 {"{sum: [" + a.text + ", " + c.text + "]}", overlay("sum", a.cells, c.cells)});
  }
  CHECK(sets < (last - first));
}

TEST_CASE("Random trees of sets, written otherwise, mean the same", "[compare][cubical]") {
  const auto [first, last] = scenes::seeds(150);
  std::size_t alike = 0, regrouped = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    Random random(seed);
    const Value a = random_value(random, 1 + random.below(2)), b = random_value(random, 1 + random.below(2));
    const Value c = random_value(random, 1);
    const auto both = [&](const std::string& op, const Value& x, const Value& y) {
      return Value{"{" + op + ": [" + x.text + ", " + y.text + "]}", overlay(op, x.cells, y.cells)};
    };
    // x + y = y + x, (x + y) + z = x + (y + z), x y = y x, (x - y) - z = x - (y + z), with all components.
    const auto same = [&](const Value& x, const Value& y) {
      const Verdict verdict = check_values(x, y);
      CHECK(verdict.sets);
      CHECK(verdict.components);
      alike += verdict.components;
    };
    same(both("sum", a, b), both("sum", b, a));
    same(both("product", a, b), both("product", b, a));
    same(both("sum", both("sum", a, b), c), both("sum", a, both("sum", b, c)));
    same(both("subtract", both("subtract", a, b), c), both("subtract", a, both("sum", b, c)));
    // x = (x - y) + x y as a set; components of x are parted.
    const Verdict parted = check_values(a, both("sum", both("subtract", a, b), both("product", a, b)));
    CHECK(parted.sets);
    regrouped += !parted.components;
  }
  CHECK(alike == 4 * (last - first));
  CHECK(regrouped > (last - first) / 4);
}

}  // namespace
}  // namespace cnrg
