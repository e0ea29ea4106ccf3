// Translations by leading coefficients, scales by rational roots; see the header.
#include "csg/carriers/net_carriers.h"

#include <algorithm>
#include <tuple>

namespace cnrg {
namespace {

bool is_zero_point(const Homogeneous& h) { return h[0] == 0 && h[1] == 0 && h[2] == 0 && h[3] == 0; }

/// The first coordinate that is not zero; 4 if all are.
std::size_t first_of(const Homogeneous& h) {
  std::size_t e = 0;
  while (e < 4 && h[e] == 0) ++e;
  return e;
}

void add(Homogeneous& sum, const Rational& factor, const Homogeneous& h) {
  for (std::size_t e = 0; e < 4; ++e) {
    if (h[e] != 0) sum[e] += factor * h[e];
  }
}

Rational power(const Rational& base, int exponent) {
  Rational result = 1;
  const Rational factor = exponent < 0 ? Rational(1 / base) : base;
  for (int i = 0; i < std::abs(exponent); ++i) result *= factor;
  return result;
}

std::size_t degree_u(const PowerBasis& c) { return c.size() - 1; }
std::size_t degree_v(const PowerBasis& c) { return c[0].size() - 1; }

PowerBasis transpose(const PowerBasis& c) {
  PowerBasis result(c[0].size(), std::vector<Homogeneous>(c.size()));
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (std::size_t j = 0; j < c[i].size(); ++j) result[j][i] = c[i][j];
  }
  return result;
}

/// Leaves out leading coefficients that are zero.
void trim(PowerBasis& c) {
  while (c.size() > 1 && std::all_of(c.back().begin(), c.back().end(), is_zero_point)) c.pop_back();
  while (c[0].size() > 1 &&
         std::all_of(c.begin(), c.end(), [](const auto& row) { return is_zero_point(row.back()); })) {
    for (auto& row : c) row.pop_back();
  }
}

/// From a row of control points to powers: coefficient i is binomial(n, i) times the i-th forward difference.
void to_powers(ControlRow& row) {
  const std::size_t n = row.size() - 1;
  for (std::size_t r = 1; r <= n; ++r) {
    for (std::size_t i = n; i >= r; --i) add(row[i], -1, row[i - 1]);
  }
  Rational binomial = 1;
  for (std::size_t i = 0; i <= n; ++i) {
    for (Rational& x : row[i]) x *= binomial;
    binomial = binomial * Rational(n - i) / Rational(i + 1);
  }
}

/// c(u + s, v).
void shift_u(PowerBasis& c, const Rational& s) {
  if (s == 0) return;
  for (std::size_t r = 0; r + 1 < c.size(); ++r) {
    for (std::size_t i = c.size() - 1; i-- > r;) {
      for (std::size_t j = 0; j < c[i].size(); ++j) add(c[i][j], s, c[i + 1][j]);
    }
  }
}

/// c(u, v + t).
void shift_v(PowerBasis& c, const Rational& t) {
  if (t == 0) return;
  c = transpose(c);
  shift_u(c, t);
  c = transpose(c);
}

/// The s for which the second highest power of u in c(u + s, v) has a zero where the highest has its first
/// coordinate that is none. Nothing if there is no power of u.
std::optional<Rational> middle_u(const PowerBasis& c) {
  const std::size_t m = degree_u(c);
  if (m == 0) return std::nullopt;
  for (std::size_t j = 0; j <= degree_v(c); ++j) {
    const std::size_t e = first_of(c[m][j]);
    if (e < 4) return -c[m - 1][j][e] / (Rational(m) * c[m][j][e]);
  }
  return std::nullopt;
}

/// c(p - l q, q) as powers of p and q.
PowerBasis sheared(const PowerBasis& c, const Rational& l) {
  const std::size_t most = degree_u(c) + degree_v(c);
  PowerBasis result(degree_u(c) + 1, std::vector<Homogeneous>(most + 1));
  for (std::size_t i = 0; i <= degree_u(c); ++i) {
    Rational factor = 1;  // binomial(i, k) (-l)^k
    for (std::size_t k = 0; k <= i; ++k) {
      for (std::size_t j = 0; j <= degree_v(c); ++j) add(result[i - k][k + j], factor, c[i][j]);
      factor *= -l * Rational(i - k) / Rational(k + 1);
    }
  }
  trim(result);
  return result;
}

/// The net with the origin of its parameters moved to a place that belongs to the carrier: c(u + s, v + t).
struct Centred {
  PowerBasis c;
  Rational s = 0, t = 0;
};

/// Let H be the terms of the highest total degree and G those of one less. A move by (s, t) changes G by
/// s H_u + t H_v: two linear equations, zeros at two places of G, fix s and t. Which places does not depend on the
/// parametrization, since scales of u and v multiply each coefficient by a number of its own. If H_u and H_v are
/// in proportion, one equation is left; the other is that of the highest power across.
std::optional<Centred> centred(PowerBasis c) {
  const std::size_t m = degree_u(c), n = degree_v(c);
  if (m == 0 || n == 0) return std::nullopt;
  std::size_t total = 0;
  for (std::size_t i = 0; i <= m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      if (!is_zero_point(c[i][j])) total = std::max(total, i + j);
    }
  }
  if (total < 2 && m == 1 && n == 1) return std::nullopt;  // a parallelogram
  struct Equation {
    Rational u, v, g;
  };
  std::optional<Equation> first, second;
  for (std::size_t i = 0; i <= std::min(m, total - 1) && !second; ++i) {
    const std::size_t j = total - 1 - i;
    if (j > n) continue;
    for (std::size_t e = 0; e < 4 && !second; ++e) {
      const Equation row{i < m ? Rational(Rational(i + 1) * c[i + 1][j][e]) : Rational(0),
                         j < n ? Rational(Rational(j + 1) * c[i][j + 1][e]) : Rational(0), c[i][j][e]};
      if (row.u == 0 && row.v == 0) continue;
      if (!first) first = row;
      else if (first->u * row.v != first->v * row.u) second = row;
    }
  }
  if (!first) return std::nullopt;
  Centred result;
  if (second) {
    const Rational whole = first->u * second->v - first->v * second->u;
    result.s = (first->v * second->g - first->g * second->v) / whole;
    result.t = (first->g * second->u - first->u * second->g) / whole;
  } else if (first->v == 0) {
    result.s = -first->g / first->u;
    PowerBasis moved = c;
    shift_u(moved, result.s);
    const std::optional<Rational> t = middle_u(transpose(moved));
    if (!t) return std::nullopt;
    result.t = *t;
  } else if (first->u == 0) {
    result.t = -first->g / first->v;
    PowerBasis moved = c;
    shift_v(moved, result.t);
    const std::optional<Rational> s = middle_u(moved);
    if (!s) return std::nullopt;
    result.s = *s;
  } else {  // H is a power of u + l v: with p = u + l v only p is fixed so far
    const Rational l = first->v / first->u, p = -first->g / first->u;
    PowerBasis turned = sheared(c, l);
    shift_u(turned, p);
    const std::optional<Rational> q = middle_u(transpose(turned));
    if (!q) return std::nullopt;
    result.t = *q;
    result.s = p - l * *q;
  }
  shift_u(c, result.s);
  shift_v(c, result.t);
  result.c = std::move(c);
  return result;
}

/// Of each coefficient the point of projective space.
PowerBasis directions(PowerBasis c) {
  for (auto& row : c) {
    for (Homogeneous& h : row) {
      const std::size_t e = first_of(h);
      if (e == 4 || h[e] == 1) continue;
      const Rational first = h[e];
      for (Rational& x : h) x /= first;
    }
  }
  return c;
}

/// The rational x with x^n = value: none, one, or two of which the other is -x.
std::vector<Rational> roots(const Rational& value, unsigned n) {
  const Rational size = abs(value);
  Integer numerator, denominator;
  if (mpz_root(numerator.get_mpz_t(), size.get_num_mpz_t(), n) == 0) return {};
  if (mpz_root(denominator.get_mpz_t(), size.get_den_mpz_t(), n) == 0) return {};
  const Rational root(numerator, denominator);
  if (n % 2 == 1) return {value < 0 ? Rational(-root) : root};
  if (value < 0) return {};
  return {root, Rational(-root)};
}

/// a^i c^j = value.
struct Monomial {
  int i = 0, j = 0;
  Rational value = 1;
};

/// Euclid's algorithm on exponents of u or v: the product of powers of both equations in which it is the least.
void reduce(Monomial& one, Monomial& other, int Monomial::*by) {
  while (other.*by != 0) {
    const int times = one.*by / (other.*by);
    one.i -= times * other.i;
    one.j -= times * other.j;
    one.value /= power(other.value, times);
    std::swap(one, other);
  }
}

/// All (a, c) for which net(u, v) = k carrier(a u, c v) with a k > 0. Both have the same directions. Of curves c
/// = 1.
std::vector<std::array<Rational, 2>> scales(const PowerBasis& net, const PowerBasis& carrier) {
  std::vector<Monomial> ratios;
  for (std::size_t i = 0; i < net.size(); ++i) {
    for (std::size_t j = 0; j < net[i].size(); ++j) {
      const std::size_t e = first_of(net[i][j]);
      if (e < 4) ratios.push_back({static_cast<int>(i), static_cast<int>(j), net[i][j][e] / carrier[i][j][e]});
    }
  }
  const Monomial base = ratios[0];
  Monomial in_u, in_v;  // a^i c^j = value with the least i; c^j = value
  for (Monomial m : ratios) {
    m.i -= base.i;
    m.j -= base.j;
    m.value /= base.value;
    reduce(in_u, m, &Monomial::i);  // leaves m without u
    reduce(in_v, m, &Monomial::j);
  }
  const bool curve = net[0].size() == 1;
  if (in_u.i == 0 || (in_v.j == 0 && !curve)) return {};  // a curve in the place of a surface, a point of a curve
  std::vector<std::array<Rational, 2>> result;
  for (const Rational& c :
       curve ? std::vector<Rational>{1}
             : roots(power(in_v.value, in_v.j < 0 ? -1 : 1), static_cast<unsigned>(std::abs(in_v.j)))) {
    const Rational of_a = in_u.value / power(c, in_u.j);
    for (const Rational& a : roots(power(of_a, in_u.i < 0 ? -1 : 1), static_cast<unsigned>(std::abs(in_u.i)))) {
      const Rational k = base.value / (power(a, base.i) * power(c, base.j));
      const auto holds = [&](const Monomial& m) { return m.value == k * power(a, m.i) * power(c, m.j); };
      if (k > 0 && std::all_of(ratios.begin(), ratios.end(), holds)) result.push_back({a, c});
    }
  }
  return result;
}

using RationalRange = std::array<Rational, 2>;

RationalRange ascending(const RationalRange& x) { return x[0] < x[1] ? x : RationalRange{x[1], x[0]}; }

}  // namespace

PowerBasis power_basis(const BezierPatch& patch) {
  PowerBasis c;
  for (ControlRow row : patch.net) {
    to_powers(row);
    c.push_back(std::move(row));
  }
  c = transpose(c);
  for (ControlRow& column : c) to_powers(column);
  trim(c);
  return c;
}

PowerBasis power_basis(const ControlRow& row) {
  ControlRow powers = row;
  to_powers(powers);
  PowerBasis c;
  for (const Homogeneous& h : powers) c.push_back({h});
  trim(c);
  return c;
}

std::optional<OnCurve> CurveCarriers::place(const ControlRow& net, const RationalPoint& kind) {
  PowerBasis c = power_basis(net);
  if (degree_u(c) < 2) return std::nullopt;
  const Rational s = *middle_u(c);
  shift_u(c, s);
  std::vector<std::size_t>& alike = known_[{kind, directions(c)}];
  std::optional<OnCurve> best;
  const auto offer = [&](std::size_t carrier, const Rational& a) {
    const OnCurve on{carrier, {-a * s, a * (1 - s)}};
    // Where a carrier is its own mirror image, it is run twice: of both places the smaller one is taken.
    if (!best || ascending(on.at) < ascending(best->at)) best = on;
  };
  for (const std::size_t carrier : alike) {
    for (const auto& scale : scales(c, carriers_[carrier])) offer(carrier, scale[0]);
    if (best) return best;
  }
  for (const auto& scale : scales(c, c)) offer(carriers_.size(), scale[0]);
  if (!best) return std::nullopt;
  alike.push_back(carriers_.size());
  carriers_.push_back(std::move(c));
  return best;
}

std::optional<OnSurface> SurfaceCarriers::place(const BezierPatch& patch) {
  const std::optional<Centred> given = centred(power_basis(patch));
  if (!given) return std::nullopt;
  // The other way to write the net has its own centre: which equations come first depends on the order of u and v.
  const std::optional<Centred> turned = centred(transpose(power_basis(patch)));
  if (!turned) return std::nullopt;
  std::optional<OnSurface> best;
  const auto offer = [&](std::size_t carrier, bool transposed) {
    const Centred& from = transposed ? *turned : *given;
    for (const auto& [a, c] : scales(from.c, carriers_[carrier])) {
      OnSurface on{carrier, {0, 1}, {{{-a * from.s, a * (1 - from.s)}, {-c * from.t, c * (1 - from.t)}}}};
      // Where a carrier is its own mirror image, it covers itself: of all places the smallest is taken.
      const auto rank = [](const OnSurface& x) {
        return std::tuple(ascending(x.at[x.axis[0]]), ascending(x.at[x.axis[1]]));
      };
      if (transposed) {
        std::swap(on.at[0], on.at[1]);
        on.axis = {1, 0};
      }
      if (!best || rank(on) < rank(*best)) best = on;
    }
  };
  const auto look_up = [&] {
    for (const bool transposed : {false, true}) {
      const auto alike = known_.find(directions(transposed ? turned->c : given->c));
      if (alike == known_.end()) continue;
      for (const std::size_t carrier : alike->second) {
        if (!best || best->carrier == carrier) offer(carrier, transposed);
      }
    }
  };
  look_up();
  if (best) return best;
  known_[directions(given->c)].push_back(carriers_.size());
  carriers_.push_back(given->c);
  look_up();
  return best;
}

}  // namespace cnrg
