// Nets as polynomials in Bernstein form: raising and lowering degrees, products, blossoms; see the header.
#include "csg/curves/bezier.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

/// (1 - t) a + t b. Weights that are all 1 stay so without a product.
Homogeneous between(const Homogeneous& a, const Homogeneous& b, const Rational& t) {
  Homogeneous h;
  for (std::size_t k = 0; k < 4; ++k) {
    if (a[k] == b[k]) h[k] = a[k];
    else h[k] = a[k] + t * (b[k] - a[k]);
  }
  return h;
}

Rational ratio(std::size_t a, std::size_t b) {
  return fraction(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
}

// Numbers in Bernstein form.
using Polynomial = std::vector<Rational>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  const std::size_t m = a.size() - 1, n = b.size() - 1;
  Polynomial result(m + n + 1, 0);
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) result[i + j] += binomial(m, i) * binomial(n, j) * a[i] * b[j];
  }
  for (std::size_t k = 0; k <= m + n; ++k) result[k] /= binomial(m + n, k);
  return result;
}

ControlRow product(const ControlRow& a, const Polynomial& b) {
  ControlRow result(a.size() + b.size() - 1);
  for (std::size_t k = 0; k < 4; ++k) {
    Polynomial entries;
    for (const Homogeneous& h : a) entries.push_back(h[k]);
    const Polynomial p = product(entries, b);
    for (std::size_t i = 0; i < p.size(); ++i) result[i][k] = p[i];
  }
  return result;
}

/// False where positive weights become others by lowering the degree: the lower degree is then not taken.
bool all_positive(const ControlRow& lower, const ControlRow& row) {
  const auto positive = [](const Homogeneous& h) { return h[3] > 0; };
  return std::all_of(lower.begin(), lower.end(), positive) || !std::all_of(row.begin(), row.end(), positive);
}

/// The weights of a curve as a polynomial of least degree.
Polynomial weights(const BezierCurve& curve) {
  ControlRow row;
  for (const Homogeneous& h : curve.net) row.push_back({0, 0, 0, h[3]});
  Polynomial result;
  for (const Homogeneous& h : reduced(row)) result.push_back(h[3]);
  return result;
}

BezierCurve reversed_curve(BezierCurve curve) {
  std::reverse(curve.net.begin(), curve.net.end());
  return curve;
}

void divide_by_first_weight(std::vector<ControlRow>& net) {
  const Rational first = net[0][0][3];
  if (first == 1) return;
  for (ControlRow& row : net) {
    for (Homogeneous& h : row) h = (1 / first) * h;
  }
}

/// The same curve with a degree less, or nothing if there is none.
std::optional<ControlRow> lowered(const ControlRow& row) {
  const std::size_t n = row.size() - 1;
  // Raising the degree of c gives b_i = (i c_{i-1} + (n - i) c_i) / n; solved for c from the front, the last
  // equation tells whether there is such a c.
  ControlRow lower;
  for (std::size_t i = 0; i < n; ++i) {
    lower.push_back(i == 0 ? row[0] : ratio(1, n - i) * (Rational(n) * row[i] - Rational(i) * lower[i - 1]));
  }
  if (lower.back() != row.back()) return std::nullopt;
  return lower;
}

/// Brings all rows to one degree, the least that serves them all; `least_of` lowers one row.
template <class Least>
void reduce_rows(std::vector<ControlRow>& rows, Least least_of) {
  std::size_t degree = 0;
  std::vector<ControlRow> least;
  for (const ControlRow& row : rows) {
    least.push_back(least_of(row));
    if (least.back().size() == row.size()) return;  // it has the degree that it came with, and so have all
    degree = std::max(degree, least.back().size() - 1);
  }
  for (std::size_t j = 0; j < rows.size(); ++j) rows[j] = elevated(least[j], degree);
}

}  // namespace

Homogeneous homogeneous(const RationalPoint& p, const Rational& weight) {
  return {p[0] * weight, p[1] * weight, p[2] * weight, weight};
}

RationalPoint project(const Homogeneous& h) {
  if (h[3] == 1) return {h[0], h[1], h[2]};
  return {h[0] / h[3], h[1] / h[3], h[2] / h[3]};
}

ControlRow reduced(ControlRow row) {
  while (row.size() > 1) {
    std::optional<ControlRow> lower = lowered(row);
    if (!lower || !all_positive(*lower, row)) return row;
    row = std::move(*lower);
  }
  return row;
}

ControlRow elevated(ControlRow row, std::size_t degree) {
  while (row.size() <= degree) {
    const std::size_t n = row.size();  // the new degree
    ControlRow higher;
    for (std::size_t i = 0; i <= n; ++i) {
      if (i == 0 || i == n) higher.push_back(i == 0 ? row.front() : row.back());
      else higher.push_back(between(row[i], row[i - 1], ratio(i, n)));
    }
    row = std::move(higher);
  }
  return row;
}

ControlRow part(ControlRow row, const Rational& low, const Rational& high) {
  const std::size_t n = row.size() - 1;
  if (low != 0) {  // the points that end in b_n, from each step of de Casteljau one
    for (std::size_t r = 1; r <= n; ++r) {
      for (std::size_t i = 0; i + r <= n; ++i) row[i] = between(row[i], row[i + 1], low);
    }
  }
  if (high != 1) {
    const Rational t = (high - low) / (1 - low);
    for (std::size_t r = 1; r <= n; ++r) {
      for (std::size_t i = n; i >= r; --i) row[i] = between(row[i - 1], row[i], t);
    }
  }
  return row;
}

Homogeneous de_casteljau(ControlRow row, const Rational& t) {
  if (t == 0) return row.front();
  if (t == 1) return row.back();
  for (std::size_t n = row.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) row[i] = between(row[i], row[i + 1], t);
  }
  return row[0];
}

bool BezierCurve::is_point() const {
  const RationalPoint first = project(net[0]);
  return std::all_of(net.begin(), net.end(), [&](const Homogeneous& h) { return project(h) == first; });
}

RationalPoint BezierPatch::at(const Rational& u, const Rational& v) const {
  ControlRow column;
  for (const ControlRow& row : net) column.push_back(de_casteljau(row, u));
  return project(de_casteljau(std::move(column), v));
}

BezierPatch transposed(const BezierPatch& patch) {
  BezierPatch result;
  result.net.assign(patch.degree_u() + 1, ControlRow(patch.degree_v() + 1));
  for (std::size_t j = 0; j < patch.net.size(); ++j) {
    for (std::size_t i = 0; i < patch.net[j].size(); ++i) result.net[i][j] = patch.net[j][i];
  }
  return result;
}

BezierCurve BezierPatch::side(std::size_t k) const {
  if (k == 0) return {net.front()};
  if (k == 2) return reversed_curve({net.back()});
  BezierCurve curve;
  for (const ControlRow& row : net) curve.net.push_back(k == 1 ? row.back() : row.front());
  return k == 1 ? curve : reversed_curve(curve);
}

BezierPatch reduced(const BezierPatch& patch) {
  const auto least = [](ControlRow row) {
    while (row.size() > 1) {
      std::optional<ControlRow> lower = lowered(row);
      if (!lower) break;
      row = std::move(*lower);
    }
    return row;
  };
  BezierPatch result = patch;
  reduce_rows(result.net, least);
  BezierPatch turned = transposed(result);
  reduce_rows(turned.net, least);
  result = transposed(turned);
  // The given net shows that this ends: raising degrees leaves positive weights positive.
  const auto positive = [](const BezierPatch& p) {
    return std::all_of(p.net.begin(), p.net.end(), [](const ControlRow& row) {
      return std::all_of(row.begin(), row.end(), [](const Homogeneous& h) { return h[3] > 0; });
    });
  };
  while (!positive(result)) {
    const std::size_t u = result.degree_u() + 1, v = result.degree_v() + 1;
    for (ControlRow& row : result.net) row = elevated(row, u);
    turned = transposed(result);
    for (ControlRow& row : turned.net) row = elevated(row, v);
    result = transposed(turned);
  }
  return result;
}

BezierPatch part(const BezierPatch& patch, const std::array<Rational, 2>& u, const std::array<Rational, 2>& v) {
  BezierPatch result = patch;
  for (ControlRow& row : result.net) row = part(std::move(row), u[0], u[1]);
  if (v[0] == 0 && v[1] == 1) return result;
  BezierPatch turned = transposed(result);
  for (ControlRow& row : turned.net) row = part(std::move(row), v[0], v[1]);
  return transposed(turned);
}

std::vector<RationalPoint> points_of(const std::vector<ControlRow>& net) {
  std::vector<RationalPoint> points;
  for (const ControlRow& row : net) std::ranges::transform(row, std::back_inserter(points), project);
  return points;
}

std::optional<RationalPoint> plane_normal(const std::vector<RationalPoint>& points, RationalPoint along) {
  RationalPoint normal{0, 0, 0};
  for (const RationalPoint& p : points) {
    const RationalPoint way = p - points[0];
    if (is_zero(along)) along = way;
    if (is_zero(normal)) normal = cross(along, way);
    if (dot(normal, way) != 0) return std::nullopt;
  }
  return normal;
}

bool on_one_line(const std::vector<RationalPoint>& points) {
  const auto normal = plane_normal(points);
  return normal && is_zero(*normal);
}

bool runs_straight(const std::vector<RationalPoint>& points) {
  const RationalPoint &first = points.front(), way = points.back() - first;
  return std::ranges::all_of(points, [&](const RationalPoint& p) {
    const Rational along = dot(p - first, way);
    return p == first || (is_zero(cross(p - first, way)) && along > 0 && along <= dot(way, way));
  });
}

CanonicalCurve canonical(const BezierCurve& curve) {
  std::vector<ControlRow> one{reduced(curve.net)};
  std::vector<ControlRow> other = one;
  std::reverse(other[0].begin(), other[0].end());
  divide_by_first_weight(one);
  divide_by_first_weight(other);
  if (other < one) return {{other[0]}, true};
  return {{one[0]}, false};
}

CanonicalPatch canonical(const BezierPatch& patch) {
  CanonicalPatch best;
  for (int way = 0; way < 8; ++way) {
    BezierPatch p = way & 4 ? transposed(patch) : patch;
    if (way & 2) std::reverse(p.net.begin(), p.net.end());
    if (way & 1) {
      for (ControlRow& row : p.net) std::reverse(row.begin(), row.end());
    }
    divide_by_first_weight(p.net);
    const bool mirrored = ((way & 1) + (way >> 1 & 1) + (way >> 2)) % 2 == 1;
    if (way == 0 || p.net < best.patch.net)
      best = {std::move(p), mirrored, (way & 4) != 0, (way & 1) != 0, (way & 2) != 0};
  }
  return best;
}

std::array<Rational, 2> CanonicalPatch::given(const Rational& u, const Rational& v) const {
  std::array<Rational, 2> at{backward_u ? Rational(1 - u) : u, backward_v ? Rational(1 - v) : v};
  if (transposed) std::swap(at[0], at[1]);
  return at;
}

std::vector<ControlRow> bezier_pieces(const ControlRow& points, std::size_t degree,
                                      const std::vector<Rational>& knots) {
  require(degree >= 1 && knots.size() == points.size() + degree + 1, "bezier_pieces: wrong number of knots");
  std::vector<ControlRow> pieces;
  for (std::size_t span = degree; span < points.size(); ++span) {
    const Rational &low = knots[span], &high = knots[span + 1];
    if (low == high) continue;
    // Control point i of the piece is the blossom at `low` taken degree - i times and `high` taken i times.
    ControlRow piece;
    for (std::size_t i = 0; i <= degree; ++i) {
      const auto first = points.begin() + static_cast<std::ptrdiff_t>(span - degree);
      ControlRow d(first, first + static_cast<std::ptrdiff_t>(degree + 1));
      for (std::size_t r = 1; r <= degree; ++r) {
        const Rational& x = r <= i ? high : low;
        for (std::size_t j = degree; j >= r; --j) {
          const Rational &from = knots[span - degree + j], &to = knots[span + j - r + 1];
          d[j] = between(d[j - 1], d[j], (x - from) / (to - from));
        }
      }
      piece.push_back(d[degree]);
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<Rational> clamped_knots(std::size_t points, std::size_t degree) {
  std::vector<Rational> knots(degree + 1, 0);
  const std::size_t spans = points - degree;
  for (std::size_t i = 1; i < spans; ++i) knots.push_back(ratio(i, spans));
  knots.insert(knots.end(), degree + 1, 1);
  return knots;
}

BezierPatch coons_patch(const std::array<BezierCurve, 4>& round) {
  // With c = N / w for each curve, a = w0 w2 in u and b = w1 w3 in v, the bilinearly blended patch
  //   (1 - v) c0 + v c2 + (1 - u) c3 + u c1 - (the bilinear patch of the corners)      (coons1967)
  // times a b is a sum of products of a polynomial in u and one in v.
  const BezierCurve c0 = round[0], c1 = round[1], c2 = reversed_curve(round[2]), c3 = reversed_curve(round[3]);
  const Polynomial w0 = weights(c0), w1 = weights(c1), w2 = weights(c2), w3 = weights(c3);
  const Polynomial a = product(w0, w2), b = product(w1, w3);
  const Polynomial rising{0, 1}, falling{1, 0};
  const std::size_t p = std::max({c0.degree() + w2.size() - 1, c2.degree() + w0.size() - 1, a.size()});
  const std::size_t q = std::max({c1.degree() + w3.size() - 1, c3.degree() + w1.size() - 1, b.size()});
  BezierPatch patch;
  patch.net.assign(q + 1, ControlRow(p + 1, Homogeneous{0, 0, 0, 0}));
  const auto as_row = [](const Polynomial& numbers) {
    ControlRow row;
    for (const Rational& x : numbers) row.push_back({x, 0, 0, 0});
    return row;
  };
  const auto add = [&](const ControlRow& in_u, const Polynomial& in_v) {  // a row in u times a number in v
    const ControlRow row = elevated(in_u, p), factor = elevated(as_row(in_v), q);
    for (std::size_t j = 0; j <= q; ++j) {
      for (std::size_t i = 0; i <= p; ++i) patch.net[j][i] = patch.net[j][i] + factor[j][0] * row[i];
    }
  };
  const auto add_in_v = [&](const Polynomial& in_u, const ControlRow& in_v) {
    const ControlRow column = elevated(in_v, q), factor = elevated(as_row(in_u), p);
    for (std::size_t j = 0; j <= q; ++j) {
      for (std::size_t i = 0; i <= p; ++i) patch.net[j][i] = patch.net[j][i] + factor[i][0] * column[j];
    }
  };
  add(product(c0.net, w2), product(falling, b));
  add(product(c2.net, w0), product(rising, b));
  add_in_v(product(falling, a), product(c3.net, w1));
  add_in_v(product(rising, a), product(c1.net, w3));
  const auto corners = [&](const BezierCurve& c) {  // a ((1 - u) first + u last), to be taken away
    ControlRow row = product({homogeneous(project(c.net.front())), homogeneous(project(c.net.back()))}, a);
    for (Homogeneous& h : row) h = Rational(-1) * h;
    return row;
  };
  add(corners(c0), product(falling, b));
  add(corners(c2), product(rising, b));
  const auto least = [](const ControlRow& row) { return reduced(row); };
  reduce_rows(patch.net, least);
  BezierPatch turned = transposed(patch);
  reduce_rows(turned.net, least);
  return transposed(turned);
}

/// Sturm's theorem, with t = s / (1 + s): parameters between the ends are the positive s.
bool is_zero_inside(const ControlRow& row, std::size_t coordinate) {
  const auto strip = [](Polynomial p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
    return p;
  };
  Polynomial a, b;
  for (std::size_t i = 0; i < row.size(); ++i) a.push_back(binomial(row.size() - 1, i) * row[i][coordinate]);
  a = strip(std::move(a));
  a.erase(a.begin(), std::ranges::find_if(a, [](const Rational& x) { return x != 0; }));
  for (std::size_t i = 1; i < a.size(); ++i) b.push_back(Rational(i) * a[i]);
  int roots = 0;  // changes of sign at 0 less those at infinity
  int near = a.empty() ? 0 : sgn(a.front());
  while (!b.empty()) {
    roots += int(near * sgn(b.front()) < 0) - int(sgn(a.back()) * sgn(b.back()) < 0);
    if (b.front() != 0) near = sgn(b.front());
    Polynomial rest = a;
    while (rest.size() >= b.size()) {
      const Rational factor = rest.back() / b.back();
      const std::size_t shift = rest.size() - b.size();
      for (std::size_t i = 0; i < b.size(); ++i) rest[i + shift] -= factor * b[i];
      rest = strip(std::move(rest));
    }
    for (Rational& x : rest) x = -x;
    a = std::exchange(b, std::move(rest));
  }
  return roots != 0;
}

}  // namespace cnrg
