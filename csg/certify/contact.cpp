// Pencils of quadrics; see the header.
#include "csg/certify/contact.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "csg/geometry/circle.h"
#include "kernel/exact/enclosure.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

using Row = std::vector<Rational>;
using Matrix = std::vector<Row>;  // rows
using Polynomial = Row;           // the constant first; no zero at the end

Matrix transpose(const Matrix& m) {
  Matrix t(m.empty() ? 0 : m[0].size(), Row(m.size()));
  for (std::size_t i = 0; i < m.size(); ++i) {
    for (std::size_t j = 0; j < m[i].size(); ++j) t[j][i] = m[i][j];
  }
  return t;
}
Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c(a.size(), Row(b.empty() ? 0 : b[0].size(), 0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (a[i][k] == 0) continue;
      for (std::size_t j = 0; j < b[k].size(); ++j) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}
/// The form on the space that the columns of `basis` span.
Matrix on(const Matrix& form, const Matrix& basis) { return product(product(transpose(basis), form), basis); }

/// Which columns have a pivot, and the product of pivots, with the sign of the order of rows.
struct Echelon {
  std::vector<std::size_t> pivots;
  Rational product = 1;
};
/// Makes each pivot 1, and alone in its column.
Echelon reduce_rows(Matrix& m, std::size_t n) {
  Echelon result;
  std::size_t row = 0;
  for (std::size_t col = 0; col < n && row < m.size(); ++col) {
    std::size_t at = row;
    while (at < m.size() && m[at][col] == 0) ++at;
    if (at == m.size()) continue;
    std::swap(m[at], m[row]);
    const Rational pivot = m[row][col];
    result.product *= at == row ? pivot : Rational(-pivot);
    for (Rational& x : m[row]) x /= pivot;
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (i == row || m[i][col] == 0) continue;
      const Rational factor = m[i][col];
      for (std::size_t j = 0; j < n; ++j) m[i][j] -= factor * m[row][j];
    }
    result.pivots.push_back(col);
    ++row;
  }
  return result;
}
/// Columns that span the kernel.
Matrix kernel(Matrix m, std::size_t n) {
  const std::vector<std::size_t> pivots = reduce_rows(m, n).pivots;
  Matrix columns(n);
  for (std::size_t col = 0; col < n; ++col) {
    if (std::find(pivots.begin(), pivots.end(), col) != pivots.end()) continue;
    for (std::size_t i = 0; i < n; ++i) columns[i].push_back(i == col ? 1 : 0);
    for (std::size_t r = 0; r < pivots.size(); ++r) columns[pivots[r]].back() = -m[r][col];
  }
  return columns;
}

/// True if no two values of the form have opposite signs: by Gauss's elimination of a symmetric matrix.
bool semidefinite(Matrix m) {
  int sign = 0;
  const std::size_t n = m.size();
  std::vector<char> done(n);
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t pivot = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (!done[i] && m[i][i] != 0) pivot = i;
    }
    if (pivot == n) break;
    const int own = sgn(m[pivot][pivot]);
    if (sign != 0 && own != sign) return false;
    sign = own;
    done[pivot] = 1;
    for (std::size_t i = 0; i < n; ++i) {
      if (done[i] || m[i][pivot] == 0) continue;
      const Rational factor = m[i][pivot] / m[pivot][pivot];
      for (std::size_t j = 0; j < n; ++j) m[i][j] -= factor * m[pivot][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (!done[i] && !done[j] && m[i][j] != 0) return false;  // a zero on the diagonal alone
    }
  }
  return true;
}

Rational determinant(Matrix m) {
  const Echelon echelon = reduce_rows(m, m.size());
  return echelon.pivots.size() == m.size() ? echelon.product : Rational(0);
}

void trim(Polynomial& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}
Polynomial derivative(const Polynomial& p) {
  Polynomial d;
  for (std::size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * Rational(to_integer(i)));
  return d;
}
/// What is left of p after division by q, and the quotient.
std::pair<Polynomial, Polynomial> divided(Polynomial p, const Polynomial& q) {
  Polynomial quotient(p.size() < q.size() ? 0 : p.size() - q.size() + 1, 0);
  while (p.size() >= q.size()) {
    const std::size_t shift = p.size() - q.size();
    const Rational factor = quotient[shift] = p.back() / q.back();
    for (std::size_t i = 0; i < q.size(); ++i) p[i + shift] -= factor * q[i];
    p.pop_back();
    trim(p);
  }
  return {std::move(p), std::move(quotient)};
}
Polynomial common_divisor(Polynomial p, Polynomial q) {
  while (!q.empty()) {
    Polynomial r = divided(std::move(p), q).first;
    p = std::move(q);
    q = std::move(r);
  }
  return p;
}

/// det(a - l b) as a polynomial in l, from its values at 0, 1, ... n.
Polynomial characteristic(const Matrix& a, const Matrix& b) {
  const std::size_t n = a.size();
  Polynomial result(n + 1, 0), basis{1};
  std::vector<Rational> values;
  for (std::size_t x = 0; x <= n; ++x) {
    Matrix m = a;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) m[i][j] -= Rational(to_integer(x)) * b[i][j];
    }
    values.push_back(determinant(std::move(m)));
  }
  // Newton's divided differences.
  for (std::size_t level = 1; level <= n; ++level) {
    for (std::size_t i = n; i >= level; --i) values[i] = (values[i] - values[i - 1]) / Rational(to_integer(level));
  }
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t i = 0; i < basis.size(); ++i) result[i] += values[k] * basis[i];
    Polynomial next(basis.size() + 1, 0);
    for (std::size_t i = 0; i < basis.size(); ++i) {
      next[i + 1] += basis[i];
      next[i] -= Rational(to_integer(k)) * basis[i];
    }
    basis = std::move(next);
  }
  trim(result);
  return result;
}

/// Rational roots of more than one multiplicity, as far as they are found: of what p and its derivative have in
/// common, if that is of degree 1 or 2 when each factor counts once.
std::vector<Rational> double_roots(const Polynomial& p) {
  Polynomial g = common_divisor(p, derivative(p));
  if (g.size() < 2) return {};
  const Polynomial repeated = common_divisor(g, derivative(g));
  if (repeated.size() > 1) g = divided(std::move(g), repeated).second;  // each factor once
  if (g.size() == 2) return {Rational(-g[0] / g[1])};
  if (g.size() != 3) return {};
  const auto root = rational_root(g[1] * g[1] - 4 * g[0] * g[2]);
  if (!root) return {};
  return {Rational((-g[1] + *root) / (2 * g[2])), Rational((-g[1] - *root) / (2 * g[2]))};
}

/// Nearly the real roots of the derivative: between two roots of p in which it keeps its sign there is one.
std::vector<Rational> turning_points(const Polynomial& p) {
  const Polynomial exact = derivative(p);
  if (exact.size() < 2) return {};
  const enclosure::RoundNearest nearest;
  std::vector<double> c;
  for (const Rational& x : exact) c.push_back(to_double(x / exact.back()));
  const std::size_t n = c.size() - 1;
  double bound = 1;
  for (const double x : c) bound = std::max(bound, 1 + std::abs(x));
  std::vector<std::complex<double>> roots{bound};
  while (roots.size() < n) roots.push_back(roots.back() * std::complex<double>(0.4, 0.9));
  for (int step = 0; step < 200; ++step) {  // Durand and Kerner's
    for (std::size_t i = 0; i < n; ++i) {
      std::complex<double> value = 0, others = 1;
      for (std::size_t k = n + 1; k-- > 0;) value = value * roots[i] + c[k];
      for (std::size_t j = 0; j < n; ++j) {
        if (j != i) others *= roots[i] - roots[j];
      }
      // The library's quotients differ from machine to machine.
      if (const double square = std::norm(others); square > 0) roots[i] -= value * std::conj(others) / square;
    }
  }
  std::vector<Rational> result;
  for (const auto& root : roots) {
    if (std::isfinite(root.real()) && std::abs(root.imag()) <= 1e-6 * (1 + std::abs(root.real())))
      result.push_back(from_double(root.real()));
  }
  return result;
}

/// What a form whose zeros are the space spanned by columns (of 4 rows) leaves in common with a surface; nothing
/// where these are two points of a line.
std::optional<Contact> contact_in(const Matrix& zeros, const Matrix& surface) {
  const std::size_t dimension = zeros[0].size();
  Contact result;
  std::size_t proper = dimension;  // a column that is no direction
  for (std::size_t k = 0; k < dimension; ++k) {
    if (zeros[3][k] != 0) proper = k;
  }
  if (proper == dimension) return result;  // nothing, or at infinity
  const Matrix there = on(surface, zeros);
  const bool all = std::ranges::all_of(
      there, [](const Row& row) { return std::ranges::all_of(row, [](const Rational& x) { return x == 0; }); });
  for (std::size_t k = 0; k < 3; ++k) result.point[k] = zeros[k][proper] / zeros[3][proper];
  if (dimension == 1) {
    if (all) result.kind = Contact::Kind::point;
    return result;
  }
  if (dimension == 2) {
    if (!all) return std::nullopt;
    result.kind = Contact::Kind::line;
    const Matrix ahead = product(zeros, kernel({{zeros[3][0], zeros[3][1]}}, 2));
    result.direction = {ahead[0][0], ahead[1][0], ahead[2][0]};
    return result;
  }
  if (dimension > 3) return std::nullopt;
  result.kind = Contact::Kind::conic;
  const Matrix covector = kernel(transpose(zeros), 4);
  result.direction = {covector[0][0], covector[1][0], covector[2][0]};
  return result;
}

Matrix matrix_of(const Quadric& q) {
  Matrix m;
  for (const auto& row : q) m.emplace_back(row.begin(), row.end());
  return m;
}

}  // namespace

bool Contact::has(const RationalPoint& p) const {
  if (kind == Kind::point) return p == point;
  if (kind == Kind::line) return is_zero(cross(p - point, direction));
  if (kind == Kind::circle) {
    const RationalPoint way = p - point;
    return dot(way, direction) == 0 && abs(dot(way, way) / (radius * radius) - 1) < fraction(1, 1'000'000'000'000);
  }
  return kind == Kind::conic && dot(p - point, direction) == 0;
}

bool Contact::in(const PlaneEquation& plane) const {
  const RationalPoint normal{plane[0], plane[1], plane[2]};
  if (kind == Kind::none || dot(normal, point) + plane[3] != 0) return false;
  return kind == Kind::point ||
         (kind == Kind::line ? dot(direction, normal) == 0 : is_zero(cross(direction, normal)));
}

std::optional<CylinderAxis> cylinder_axis(const Quadric& quadric) {
  const Matrix a = matrix_of(quadric), centers = kernel({a.begin(), a.begin() + 3}, 4), lines = kernel(a, 4);
  if (lines[0].size() != 1 || lines[3][0] != 0 || centers[0].size() != 2 || centers[3][1] == 0)
    return std::nullopt;
  CylinderAxis result{{lines[0][0], lines[1][0], lines[2][0]}, {}};
  for (std::size_t k = 0; k < 3; ++k) result.middle[k] = centers[k][1] / centers[3][1];
  return result;
}

bool equal_roots(const Rational& x, int sign, const Rational& a, int other, const Rational& b) {
  if (x == 0) return sign == other && a == b;
  const Rational root = sign * (b - x * x - a) / (2 * x);  // sqrt(a), if it is rational
  return root >= 0 && root * root == a && sgn(x + sign * root) == other;
}

std::optional<Contact> contact(const Quadric& first, const Quadric& second) {
  const Matrix a = matrix_of(first), b = matrix_of(second);
  // Without what both have in their kernels, such as the direction of parallel cylinders.
  Matrix both = a;
  both.insert(both.end(), b.begin(), b.end());
  const Matrix idle = kernel(both, 4);
  Matrix basis = idle.empty() || idle[0].empty() ? Matrix{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}
                                                 : kernel(transpose(idle), 4);
  const Matrix small_a = on(a, basis), small_b = on(b, basis);
  const Polynomial p = characteristic(small_a, small_b);
  std::vector<Rational> roots = double_roots(p);
  for (Rational& x : turning_points(p)) roots.push_back(std::move(x));
  for (const Rational& root : roots) {
    Matrix m = a;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) m[i][j] -= root * b[i][j];
    }
    if (!semidefinite(m)) continue;
    const Matrix zeros = kernel(m, 4);
    return zeros[0].empty() ? Contact{} : contact_in(zeros, b);
  }
  return std::nullopt;
}

std::optional<Contact> contact(const PlaneEquation& plane, const Quadric& quadric) {
  const Matrix a = matrix_of(quadric);
  const Matrix basis = kernel({Row(plane.begin(), plane.end())}, 4), small = on(a, basis);
  if (!semidefinite(small)) return std::nullopt;
  const Matrix zeros = kernel(small, basis[0].size());
  if (zeros[0].empty()) return Contact{};
  return contact_in(product(basis, zeros), a);
}

}  // namespace cnrg
