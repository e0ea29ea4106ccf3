// Betti numbers by elimination, over Z/2 and over Q: the oracle of the homology tests.
//
// The poset of a set of cells of a cubical grid, any set, has an order complex (its chains of cells), which the
// point set shrinks to. Its boundary matrices are eliminated column by column.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "kernel/exact/rational.h"

namespace cnrg::elimination {

struct Bit {
  bool value = false;
  explicit Bit(int x) : value(x % 2 != 0) {}
  bool zero() const { return !value; }
  Bit operator-(Bit o) const { return Bit(value != o.value ? 1 : 0); }
  Bit operator*(Bit o) const { return Bit(value && o.value ? 1 : 0); }
  Bit operator/(Bit) const { return *this; }
};

struct Fraction {
  Rational value;
  explicit Fraction(Rational x) : value(std::move(x)) {}
  bool zero() const { return sgn(value) == 0; }
  Fraction operator-(const Fraction& o) const { return Fraction(value - o.value); }
  Fraction operator*(const Fraction& o) const { return Fraction(value * o.value); }
  Fraction operator/(const Fraction& o) const { return Fraction(value / o.value); }
};

template <class T>
using Column = std::vector<std::pair<std::uint32_t, T>>;  // ascending rows, no zeros

/// a - s b.
template <class T>
Column<T> reduced(const Column<T>& a, const T& s, const Column<T>& b) {
  Column<T> out;
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (j == b.size() || (i < a.size() && a[i].first < b[j].first)) {
      out.push_back(a[i++]);
    } else if (i == a.size() || b[j].first < a[i].first) {
      out.emplace_back(b[j].first, T(0) - s * b[j].second);
      ++j;
    } else {
      T x = a[i].second - s * b[j].second;
      if (!x.zero()) out.emplace_back(a[i].first, x);
      ++i, ++j;
    }
  }
  return out;
}

template <class T>
long rank(const std::vector<Column<T>>& columns, std::size_t rows) {
  std::vector<const Column<T>*> pivot(rows, nullptr);
  std::vector<Column<T>> kept;
  kept.reserve(columns.size());
  for (Column<T> column : columns) {
    while (!column.empty() && pivot[column.back().first] != nullptr) {
      const Column<T>& other = *pivot[column.back().first];
      const T factor = column.back().second / other.back().second;
      column = reduced(column, factor, other);
    }
    if (column.empty()) continue;
    kept.push_back(std::move(column));
    pivot[kept.back().back().first] = &kept.back();
  }
  return static_cast<long>(kept.size());
}

/// Chains of cells: `above[i]` lists the cells whose boundary holds cell i. Simplices of dimensions 0 to 3, each
/// by the numbers of its cells in order of inclusion.
using Simplex = std::vector<std::uint32_t>;
inline std::array<std::vector<Simplex>, 4> order_complex(const std::vector<std::vector<std::uint32_t>>& above) {
  std::array<std::vector<Simplex>, 4> out;
  for (std::uint32_t i = 0; i < above.size(); ++i) out[0].push_back({i});
  for (std::size_t d = 0; d < 3; ++d) {
    for (const Simplex& s : out[d]) {
      for (std::uint32_t next : above[s.back()]) {
        out[d + 1].push_back(s);
        out[d + 1].back().push_back(next);
      }
    }
    std::sort(out[d + 1].begin(), out[d + 1].end());
  }
  return out;
}

template <class T>
std::array<long, 3> betti(const std::array<std::vector<Simplex>, 4>& simplices) {
  std::array<long, 5> ranks{};
  for (std::size_t d = 1; d <= 3; ++d) {
    std::vector<Column<T>> columns;
    for (const Simplex& s : simplices[d]) {
      Column<T> column;
      for (std::size_t k = 0; k <= d; ++k) {
        Simplex face = s;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
        const auto at = std::lower_bound(simplices[d - 1].begin(), simplices[d - 1].end(), face);
        column.emplace_back(static_cast<std::uint32_t>(at - simplices[d - 1].begin()), T(k % 2 == 0 ? 1 : -1));
      }
      std::sort(column.begin(), column.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      columns.push_back(std::move(column));
    }
    ranks[d] = rank(columns, simplices[d - 1].size());
  }
  std::array<long, 3> out;
  for (std::size_t d = 0; d < 3; ++d) out[d] = static_cast<long>(simplices[d].size()) - ranks[d] - ranks[d + 1];
  return out;
}

}  // namespace cnrg::elimination
