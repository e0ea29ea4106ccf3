// The determinant in Bernstein's form.
//
// With control points b_ij of the quadratic map (b_ii the corners, b_ij = 2 m - (a + b) / 2 for the middle m of an
// edge from a to b) the derivative along the edge from corner 0 to corner k is 2 sum_i l_i (b_ik - b_i0) in
// barycentric coordinates l. So the determinant is 8 sum l_i l_j l_m det(g_1i, g_2j, g_3m), g_ki = b_ik - b_i0,
// and its coefficient for corners i, j, m is the mean of that over the orders of i, j, m: the polar form, which
// gives the coefficients of any smaller tetrahedron, too.
#include "csg/mesh/second_order.h"

#include "kernel/exact/enclosure.h"

namespace cnrg {
namespace {

using enclosure::Interval;

template <class N>
using Polar = std::array<std::array<std::array<N, 4>, 4>, 4>;

template <class N>
Polar<N> determinant(const SecondOrderNodes& nodes) {
  std::array<std::array<std::array<N, 3>, 4>, 4> b;
  for (std::size_t x = 0; x < 3; ++x) {
    const auto at = [&](std::size_t n) { return N(nodes[n][x]) - N(nodes[0][x]); };
    for (std::size_t i = 0; i < 4; ++i) b[i][i][x] = at(i);
    for (std::size_t e = 0; e < 6; ++e) {
      const auto& [i, j] = kSecondOrderEdges[e];
      b[i][j][x] = b[j][i][x] = N(2) * at(4 + e) - (at(i) + at(j)) / N(2);
    }
  }
  std::array<std::array<std::array<N, 3>, 4>, 4> g;  // of k and i
  for (std::size_t k = 1; k < 4; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t x = 0; x < 3; ++x) g[k][i][x] = b[i][k][x] - b[i][0][x];
    }
  }
  Polar<N> single;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t m = 0; m < 4; ++m) {
      const auto &p = g[2][j], &q = g[3][m];
      const std::array<N, 3> c{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
      for (std::size_t i = 0; i < 4; ++i)
        single[i][j][m] = g[1][i][0] * c[0] + g[1][i][1] * c[1] + g[1][i][2] * c[2];
    }
  }
  Polar<N> mean;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t m = 0; m < 4; ++m) {
        mean[i][j][m] = (single[i][j][m] + single[i][m][j] + single[j][i][m] + single[j][m][i] + single[m][i][j] +
                         single[m][j][i]) /
                        N(6);
      }
    }
  }
  return mean;
}

/// The coefficients over the half in which corner `gone` is replaced by the middle of its edge to `kept`.
Polar<Interval> half(Polar<Interval> f, std::size_t gone, std::size_t kept) {
  const Interval two(2);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) f[gone][i][j] = (f[gone][i][j] + f[kept][i][j]) / two;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) f[i][gone][j] = (f[i][gone][j] + f[i][kept][j]) / two;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) f[i][j][gone] = (f[i][j][gone] + f[i][j][kept]) / two;
  }
  return f;
}

bool positive(const Polar<Interval>& f, std::size_t halvings) {
  constexpr std::size_t kMostHalvings = 9;
  bool all = true;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(f[i][i][i].inf() > 0)) return false;  // its value at a corner
    for (std::size_t j = i; j < 4; ++j) {
      for (std::size_t m = j; m < 4; ++m) all = all && f[i][j][m].inf() > 0;
    }
  }
  if (all || halvings == kMostHalvings) return all;
  constexpr std::array<std::array<std::size_t, 2>, 6> kOrder{{{0, 1}, {2, 3}, {0, 2}, {1, 3}, {0, 3}, {1, 2}}};
  const auto& [a, b] = kOrder[halvings % 6];
  return positive(half(f, a, b), halvings + 1) && positive(half(f, b, a), halvings + 1);
}

}  // namespace

bool has_positive_determinant(const SecondOrderNodes& nodes) {
  const enclosure::RoundOutward outward;
  return positive(determinant<Interval>(nodes), 0);
}

std::array<double, 2> six_volumes(const SecondOrderNodes& nodes) {
  const Polar<double> f = determinant<double>(nodes);
  // The mean of the 20 coefficients, which are one for each way to choose three corners with repetition.
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i; j < 4; ++j) {
      for (std::size_t m = j; m < 4; ++m) sum += f[i][j][m];
    }
  }
  SecondOrderNodes straight = nodes;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto& [i, j] = kSecondOrderEdges[e];
    for (std::size_t x = 0; x < 3; ++x) straight[4 + e][x] = nodes[i][x] / 2 + nodes[j][x] / 2;
  }
  return {8 * sum / 20, 8 * determinant<double>(straight)[0][0][0]};
}

}  // namespace cnrg
