// sqrt(n / d) = sqrt(n d) / d. Small square factors of n d go out by division; two radicands differ by a square
// exactly when their product is one.
#include "csg/compare/root_sum.h"

#include <algorithm>
#include <array>

#include "csg/text/number.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

constexpr std::size_t kMostTerms = 8;

constexpr auto kPrimes = [] {
  std::array<unsigned, 95> primes{};  // all below 500
  std::size_t count = 0;
  for (unsigned n = 2; count < primes.size(); ++n) {
    bool prime = true;
    for (std::size_t i = 0; i < count && primes[i] * primes[i] <= n; ++i) prime = prime && n % primes[i] != 0;
    if (prime) primes[count++] = n;
  }
  return primes;
}();

bool is_square(const Integer& n) { return mpz_perfect_square_p(n.get_mpz_t()) != 0; }

/// Takes squares out of a positive number: n = out^2 n'.
Integer take_squares(Integer& n) {
  if (is_square(n)) {
    Integer root = sqrt(n);
    n = 1;
    return root;
  }
  Integer out = 1;
  for (const unsigned p : kPrimes) {
    for (const unsigned square = p * p; n % square == 0; n /= square) out *= p;
  }
  if (is_square(n)) {
    out *= sqrt(n);
    n = 1;
  }
  return out;
}

}  // namespace

void RootSum::add(Term term) {
  for (Term& known : terms_) {
    const Integer product = known.radicand * term.radicand;
    if (known.radicand != term.radicand && !is_square(product)) continue;
    // f sqrt(r) = f sqrt(r k) / k sqrt(k)
    known.factor += term.factor * Rational(sqrt(product)) / Rational(known.radicand);
    return;
  }
  if (terms_.size() < kMostTerms) terms_.push_back(std::move(term));
  else squares_.push_back(term.factor * term.factor * Rational(term.radicand));
}

void RootSum::add_root(const Rational& square) {
  if (sgn(square) == 0) return;
  Integer radicand = square.get_num() * square.get_den();
  Rational factor(take_squares(radicand), square.get_den());
  factor.canonicalize();
  add(Term{std::move(factor), std::move(radicand)});
}

void RootSum::add(const RootSum& other) {
  for (const Term& term : other.terms_) add(term);
  for (const Rational& square : other.squares_) add_root(square);
}

Rational RootSum::value(int digits) const {
  std::vector<Rational> terms;
  for (const Term& term : terms_) terms.push_back(term.factor * square_root(Rational(term.radicand), digits));
  for (const Rational& square : squares_) terms.push_back(square_root(square, digits));
  return sum(std::move(terms));
}

std::string RootSum::text() const {
  if (is_zero()) return "0";
  constexpr std::size_t kTold = 3, kReadable = 40;
  if (squares_.empty() && terms_.size() <= kTold) {
    std::vector<Term> terms = terms_;
    std::sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.radicand < b.radicand; });
    if (terms.back().radicand == 1) return number_text(terms[0].factor, {});
    std::string text;
    for (const Term& term : terms) {
      text += text.empty() ? "" : " + ";
      if (term.radicand == 1) text += to_string(term.factor);
      else
        text += (term.factor == 1 ? "" : to_string(term.factor) + " ") + "sqrt(" + to_string(term.radicand) + ")";
    }
    if (text.size() <= kReadable) return text;
  }
  // The nearest decimal is certain once both ends of an enclosure have it. The sum is no decimal itself: sums of
  // roots that do not differ by rational factors are irrational, and one that is rational was told above.
  for (int digits = 30;; digits *= 2) {
    const Rational middle = value(digits);
    Integer power = 1;
    for (int i = 0; i < digits; ++i) power *= 10;
    const Rational slack = middle / Rational(power);
    std::string low = to_decimal(middle - slack);
    if (low == to_decimal(middle + slack)) return low + " (rounded)";
  }
}

}  // namespace cnrg
