// Nets in doubles with their errors; the formulas are in the header.
#include "csg/curves/chord.h"

#include <algorithm>
#include <cmath>

namespace cnrg {
namespace {

using Entry = std::array<double, 4>;

double vector_length(const Entry& e) { return std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]); }

Entry difference(const Entry& a, const Entry& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}; }

/// Control points of the part from a to b of one row: point i is the blossom at a, n - i times, and b, i times.
void cut_row(std::vector<Entry>& row, double a, double b) {
  const std::size_t n = row.size() - 1;
  std::vector<Entry> result(n + 1), work;
  for (std::size_t i = 0; i <= n; ++i) {
    work = row;
    for (std::size_t r = 0; r < n; ++r) {
      const double t = r < i ? b : a;
      for (std::size_t j = 0; j + r < n; ++j) {
        for (std::size_t k = 0; k < 4; ++k) work[j][k] = (1 - t) * work[j][k] + t * work[j + 1][k];
      }
    }
    result[i] = work[0];
  }
  row = std::move(result);
}

/// Moves the origin to the middle of the control points, so that |S| is small against the patch.
void move_to_middle(std::vector<std::vector<Entry>>& net) {
  Entry middle{0, 0, 0, 0};
  double count = 0;
  for (const auto& row : net) {
    for (const Entry& e : row) {
      for (std::size_t k = 0; k < 3; ++k) middle[k] += e[k] / e[3];
      ++count;
    }
  }
  for (auto& row : net) {
    for (Entry& e : row) {
      for (std::size_t k = 0; k < 3; ++k) e[k] -= middle[k] / count * e[3];
    }
  }
}

/// Largest lengths of the Bernstein coefficients of a derivative, points and weights.
struct Largest {
  double point = 0, weight = 0;
  void see(const Entry& e, double factor) {
    point = std::max(point, factor * vector_length(e));
    weight = std::max(weight, factor * std::abs(e[3]));
  }
};

}  // namespace

PatchChord::PatchChord(const BezierPatch& patch) {
  const RationalPoint origin = project(patch.net[0][0]);
  const Rational unit = patch.net[0][0][3];
  double largest = 0, largest_weight = 0;
  for (const ControlRow& row : patch.net) {
    net_.emplace_back();
    for (const Homogeneous& h : row) {
      const Rational w = h[3] / unit;
      rational_ = rational_ || w != 1;
      Entry e;
      for (std::size_t k = 0; k < 3; ++k) e[k] = to_double(h[k] / unit - origin[k] * w);
      e[3] = to_double(w);
      largest = std::max(largest, vector_length(e));
      largest_weight = std::max(largest_weight, e[3]);
      net_.back().push_back(e);
    }
  }
  // An entry is rounded once; each of the at most p + q blends of a cut adds at most three roundings of numbers
  // not larger than the largest entry, and moving the origin four. Where all weights are 1 they stay so: 1 - t and
  // t are exact.
  const double steps = 3.0 * static_cast<double>(patch.degree_u() + patch.degree_v()) + 6;
  error_ = 2 * steps * largest * 0x1p-53;
  weight_error_ = rational_ ? 2 * steps * largest_weight * 0x1p-53 : 0;
}

PatchChord::Net PatchChord::part(const std::array<double, 2>& low, const std::array<double, 2>& high) const {
  Net net = net_;
  if (low[0] > 0 || high[0] < 1) {
    for (auto& row : net) cut_row(row, low[0], high[0]);
  }
  if (low[1] > 0 || high[1] < 1) {
    std::vector<Entry> column(net.size());
    for (std::size_t i = 0; i < net[0].size(); ++i) {
      for (std::size_t j = 0; j < net.size(); ++j) column[j] = net[j][i];
      cut_row(column, low[1], high[1]);
      for (std::size_t j = 0; j < net.size(); ++j) net[j][i] = column[j];
    }
  }
  return net;
}

ChordTerms PatchChord::terms(const std::array<double, 2>& low, const std::array<double, 2>& high) const {
  Net net = part(low, high);
  if (rational_) move_to_middle(net);
  const std::size_t rows = net.size(), columns = net[0].size();
  const double p = static_cast<double>(columns - 1), q = static_cast<double>(rows - 1);
  double least = net[0][0][3], reach = 0;
  Largest u, v, uu, uv, vv;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      least = std::min(least, net[j][i][3]);
      reach = std::max(reach, (vector_length(net[j][i]) + error_) / (net[j][i][3] - weight_error_));
      const bool right = i + 1 < columns, up = j + 1 < rows;
      if (right) u.see(difference(net[j][i + 1], net[j][i]), p);
      if (up) v.see(difference(net[j + 1][i], net[j][i]), q);
      if (right && up) {
        uv.see(difference(difference(net[j + 1][i + 1], net[j + 1][i]), difference(net[j][i + 1], net[j][i])),
               p * q);
      }
      if (i + 2 < columns) {
        uu.see(difference(difference(net[j][i + 2], net[j][i + 1]), difference(net[j][i + 1], net[j][i])),
               p * (p - 1));
      }
      if (j + 2 < rows) {
        vv.see(difference(difference(net[j + 2][i], net[j + 1][i]), difference(net[j + 1][i], net[j][i])),
               q * (q - 1));
      }
    }
  }
  // What the errors of the entries may add to a first difference (2 entries) and to a second one (4).
  const auto widen = [&](Largest& d, double factor, double entries) {
    if (factor == 0) return;
    d.point += factor * entries * error_;
    d.weight += factor * entries * weight_error_;
  };
  widen(u, p, 2), widen(v, q, 2), widen(uu, p * (p - 1), 4), widen(uv, p * q, 4), widen(vv, q * (q - 1), 4);
  least -= weight_error_;
  if (!(least > 0)) return {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  const double su = (u.point + reach * u.weight) / least, sv = (v.point + reach * v.weight) / least;
  ChordTerms result;
  result.uu = (uu.point + reach * uu.weight + 2 * su * u.weight) / least / 8;
  result.uv = (uv.point + reach * uv.weight + su * v.weight + sv * u.weight) / least / 8;
  result.vv = (vv.point + reach * vv.weight + 2 * sv * v.weight) / least / 8;
  return result;
}

}  // namespace cnrg
