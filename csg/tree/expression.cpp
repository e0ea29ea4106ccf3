// A parser by recursive descent; see the header.
#include "csg/tree/expression.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <vector>

#include "csg/geometry/circle.h"
#include "csg/text/escape.h"
#include "csg/text/number.h"
#include "csg/tree/suggest.h"
#include "kernel/base/error.h"
#include "kernel/exact/integers.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

constexpr std::size_t kMostLetters = 1000;  // which bounds how deep brackets nest, too
constexpr int kMostPower = 10'000;
constexpr std::size_t kMostValueBits = 400'000;  // of a value, about what 100,000 digits are

constexpr std::string_view kFunctions[] = {"abs", "ceil",   "cos", "floor", "max",
                                           "min", "random", "sin", "sqrt",  "tan"};
bool is_function(const std::string& name) {
  return std::find(std::begin(kFunctions), std::end(kFunctions), name) != std::end(kFunctions);
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

Rational nearest_root(const Rational& square) {
  if (const auto exact = rational_root(square)) return *exact;
  return round_cosine(0, square, exponent_of_root(square) - 52);
}

/// The finalizer of MurmurHash3 (Appleby 2011), over the letters of the numbers.
Rational random_number(const std::vector<Rational>& of) {
  std::uint64_t mix = 0;
  const auto add = [&](std::uint64_t letter) {
    mix = (mix ^ letter) + 0x9e3779b97f4a7c15;
    mix = (mix ^ (mix >> 33)) * 0xff51afd7ed558ccd;
    mix = (mix ^ (mix >> 33)) * 0xc4ceb9fe1a85ec53;
    mix ^= mix >> 33;
  };
  for (const Rational& x : of) {
    for (const char c : to_string(x)) add(static_cast<unsigned char>(c));
    add(0);
  }
  return Rational(static_cast<std::int32_t>(mix >> 44)) / (1 << 20);
}

class Expression {
 public:
  Expression(const std::string& text, const ParameterValues& parameters) : text_(text), parameters_(parameters) {
    if (text.size() > kMostLetters) fail("it has more than 1,000 letters; write parts of it as parameters");
  }

  Rational run() {
    Rational value = sum();
    skip_blanks();
    if (at_ < text_.size()) fail("nothing is expected at `" + excerpt(text_.substr(at_)) + "`");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const { throw InputError("`${" + excerpt(text_) + "}`: " + why); }
  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool take(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void need(char c) {
    if (!take(c))
      fail(std::string("`") + c + "` is missing" +
           (at_ < text_.size() ? " before `" + excerpt(text_.substr(at_)) + "`" : " at its end"));
  }
  Rational bounded(Rational x) const {
    if (mpz_sizeinbase(x.get_num_mpz_t(), 2) + mpz_sizeinbase(x.get_den_mpz_t(), 2) > kMostValueBits)
      fail("the value is too long a number");
    return x;
  }

  Rational sum() {
    Rational value = product();
    for (;;) {
      if (take('+')) value = bounded(value + product());
      else if (take('-')) value = bounded(value - product());
      else return value;
    }
  }

  Rational product() {
    Rational value = signed_power();
    for (;;) {
      if (take('*')) {
        value = bounded(value * signed_power());
      } else if (take('/')) {
        const Rational by = signed_power();
        if (by == 0) fail("this divides by 0");
        value = bounded(value / by);
      } else {
        return value;
      }
    }
  }

  /// -2^2 is -4, as on paper, and 2^3^2 is 2^9.
  Rational signed_power() {
    if (take('-')) return -signed_power();
    if (take('+')) return signed_power();
    const Rational base = primary();
    return take('^') ? power(base, signed_power()) : base;
  }

  Rational power(const Rational& base, const Rational& exponent) const {
    if (exponent.get_den() != 1) fail("an exponent is a whole number; there is `sqrt`");
    if (abs(exponent) > kMostPower) fail("an exponent is at most 10,000");
    if (base == 0 && exponent < 0) fail("this divides by 0");
    const std::size_t bits = mpz_sizeinbase(base.get_num_mpz_t(), 2) + mpz_sizeinbase(base.get_den_mpz_t(), 2);
    std::int64_t n = to_machine<std::int64_t>(Integer(abs(exponent.get_num())));
    if (bits * static_cast<std::size_t>(n) > kMostValueBits) fail("the value is too long a number");
    Rational value = 1;
    for (Rational square = base; n > 0; n /= 2) {
      if (n % 2 == 1) value *= square;
      if (n > 1) square *= square;
    }
    return exponent < 0 ? Rational(1 / value) : value;
  }

  Rational primary() {
    skip_blanks();
    if (take('(')) {
      Rational value = sum();
      need(')');
      return value;
    }
    if (at_ == text_.size()) fail("a number or a name is missing at its end");
    const std::size_t begin = at_;
    if (is_letter(text_[at_])) {
      while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) ++at_;
      const std::string name = text_.substr(begin, at_ - begin);
      return take('(') ? function(name) : parameter(name);
    }
    while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
    // An exponent belongs to the number if digits follow.
    if (at_ > begin && at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      std::size_t end = at_ + 1;
      if (end < text_.size() && (text_[end] == '+' || text_[end] == '-')) ++end;
      if (end < text_.size() && is_digit(text_[end])) {
        for (at_ = end; at_ < text_.size() && is_digit(text_[at_]);) ++at_;
      }
    }
    if (at_ == begin) fail("a number or a name is missing before `" + excerpt(text_.substr(at_)) + "`");
    NumberText number = read_number(text_.substr(begin, at_ - begin));
    if (!number.value) fail("`" + text_.substr(begin, at_ - begin) + "`" + number.fault);
    return *number.value;
  }

  Rational parameter(const std::string& name) const {
    const auto it = parameters_.find(name);
    if (it != parameters_.end()) return it->second;
    std::vector<std::string_view> names;
    for (const auto& [known, value] : parameters_) names.push_back(known);
    if (is_function(name)) fail("`" + name + "` is a function: `" + name + "(...)`");
    const std::string hint = did_you_mean(name, names);
    fail("there is no parameter `" + name + "`" +
         (hint.empty() ? "; add it to `parameters`, before what names it" : hint));
  }

  Rational function(const std::string& name) {
    std::vector<Rational> of{sum()};
    while (take(',')) of.push_back(sum());
    need(')');
    const bool two = name == "min" || name == "max";
    if (!is_function(name)) {
      const std::string hint = did_you_mean(name, kFunctions);
      fail("there is no function `" + name + "`" +
           (hint.empty() ? "; there are abs, ceil, cos, floor, max, min, random, sin, sqrt, tan" : hint));
    }
    if (name == "random") return random_number(of);
    if (of.size() != (two ? 2u : 1u)) fail("`" + name + "` is of " + (two ? "two numbers" : "one number"));
    const Rational& x = of[0];
    if (name == "abs") return abs(x);
    if (name == "min") return std::min(x, of[1]);
    if (name == "max") return std::max(x, of[1]);
    if (name == "sin") return from_double(sine_degrees(x));
    if (name == "cos") return from_double(cosine_degrees(x));
    if (name == "tan") {
      const double cosine = cosine_degrees(x);
      if (cosine == 0) fail("there is no tangent of " + to_string(x) + " degrees");
      return from_double(sine_degrees(x)) / from_double(cosine);
    }
    if (name == "sqrt") {
      if (x < 0) fail("there is no root of a negative number");
      return x == 0 ? x : nearest_root(x);
    }
    Integer whole;
    (name == "floor" ? mpz_fdiv_q : mpz_cdiv_q)(whole.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    return whole;
  }

  const std::string& text_;
  const ParameterValues& parameters_;
  std::size_t at_ = 0;
};

}  // namespace

Rational evaluate_expression(const std::string& expression, const ParameterValues& parameters) {
  return Expression(expression, parameters).run();
}

std::string with_values(const std::string& text, const ParameterValues& parameters) {
  std::string out;
  for (std::size_t at = 0;;) {
    if (out.size() > std::max(kMostDigits, text.size()))
      throw InputError("`" + excerpt(text) + "`: with the values of its expressions this text is too long");
    const std::size_t begin = text.find("${", at);
    out += text.substr(at, begin - at);
    if (begin == std::string::npos) return out;
    if (begin > at && text[begin - 1] == '$') {
      out += '{';
      at = begin + 2;
      continue;
    }
    const std::size_t end = text.find('}', begin);
    if (end == std::string::npos)
      throw InputError("`" + excerpt(text.substr(begin)) + "`: `}` is missing at its end");
    out += to_string(evaluate_expression(text.substr(begin + 2, end - begin - 2), parameters));
    at = end + 1;
  }
}

bool is_parameter_name(const std::string& name) {
  return !name.empty() && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

}  // namespace cnrg
