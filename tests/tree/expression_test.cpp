// Expressions of tree files: random ones whose values are known as they are made, faults, parameters in trees.
#include "csg/tree/expression.h"

#include <array>
#include <cmath>
#include <random>
#include <sstream>

#include "csg/evaluate/evaluate.h"
#include "csg/tree/selector.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using Catch::Contains;

struct DrawnExpression {
  std::string text;
  Rational value;
};

class DrawExpressions {
 public:
  DrawExpressions(unsigned seed, const ParameterValues& parameters) : random_(seed), parameters_(parameters) {}

  DrawnExpression any(int depth) {
    const auto kind = depth == 0 ? random_() % 2 : random_() % 9;
    if (kind == 0) {
      const long n = long(random_() % 2000);
      const int digits = int(random_() % 3);
      DrawnExpression drawn{std::to_string(n), n};
      if (digits > 0) drawn.text += "e-" + std::to_string(digits), drawn.value /= digits == 1 ? 10 : 100;
      return drawn;
    }
    if (kind == 1) {
      auto it = parameters_.begin();
      std::advance(it, long(random_() % parameters_.size()));
      return {it->first, it->second};
    }
    const DrawnExpression a = any(depth - 1);
    if (kind == 2) return {"-" + bracketed(a), -a.value};
    if (kind == 3) {
      const unsigned n = random_() % 4;
      Rational value = 1;
      for (unsigned i = 0; i < n; ++i) value *= a.value;
      return {bracketed(a) + blank() + "^" + blank() + std::to_string(n), value};
    }
    const DrawnExpression b = any(depth - 1);
    if (kind == 4) return {"max(" + a.text + blank() + "," + b.text + ")", std::max(a.value, b.value)};
    if (kind == 5) return {bracketed(a) + blank() + "+" + b.text, a.value + b.value};
    if (kind == 6) return {a.text + "-" + blank() + bracketed(b), a.value - b.value};
    if (kind == 7 && b.value != 0) return {bracketed(a) + "/" + bracketed(b), a.value / b.value};
    return {bracketed(a) + "*" + blank() + bracketed(b), a.value * b.value};
  }

 private:
  static std::string bracketed(const DrawnExpression& x) { return "(" + x.text + ")"; }
  std::string blank() { return random_() % 2 == 0 ? "" : " "; }
  std::mt19937 random_;
  const ParameterValues& parameters_;
};

std::string fault_of_expression(const std::string& expression) {
  try {
    evaluate_expression(expression, {{"radius", 4}});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

Tree tree_with(const std::string& head, const std::string& radius, const ReadOptions& options = {}) {
  return parse_tree("cnrg: 1\n" + head + "nodes:\n  \"ball ${n}\":\n    sphere: {center: [0, 0, 0], radius: \"" +
                        radius + "\"}\nresult: ball ${n}\n",
                    "t.yaml", options);
}
Rational radius_of(const Tree& tree) {
  return std::get<SphereShape>(*tree.nodes[tree.find("ball 3")].shape).radius;
}

}  // namespace

TEST_CASE("random expressions have their value", "[tree]") {
  const ParameterValues parameters{{"R", 4}, {"half_1", Rational(-1, 2)}, {"z", 0}};
  const auto [first, end] = scenes::seeds(300);
  for (auto seed = first; seed < end; ++seed) {
    const DrawnExpression drawn = DrawExpressions(unsigned(seed), parameters).any(4);
    INFO("seed " << seed << ": " << drawn.text);
    if (drawn.text.size() <= 1000) CHECK(evaluate_expression(drawn.text, parameters) == drawn.value);
  }
}

TEST_CASE("signs, powers and functions are those of paper", "[tree]") {
  const auto is = [](const std::string& text, const Rational& value) {
    INFO(text);
    CHECK(evaluate_expression(text, {}) == value);
  };
  is("-2^2", -4), is("2^3^2", 512), is("2^-2", Rational(1, 4)), is("7-4-2", 1), is("8/4/2", 1), is("2--1", 3);
  is("1.5e1*2", 30), is("min(2, 3) + max(2, 3)", 5), is("abs(-1/3)", Rational(1, 3));
  is("floor(-1/2)", -1), is("ceil(-1/2)", 0), is("sqrt(4/9)", Rational(2, 3)), is("sin(30)", Rational(1, 2));
  is("cos(60)", Rational(1, 2)), is("tan(45)", 1), is("0^0", 1);
  for (int n = 2; n < 200; ++n) {  // of whole numbers IEEE demands the nearest double
    INFO(n);
    CHECK(evaluate_expression("sqrt(" + std::to_string(n) + ")", {}) == from_double(std::sqrt(double(n))));
  }
}

TEST_CASE("random numbers are those of their arguments, and even", "[tree]") {
  const auto drawn = [](const std::string& of) {
    return evaluate_expression("random(" + of + ")", {{"seed", 7}});
  };
  CHECK(drawn("seed, 1") == drawn("7, 2/2"));
  CHECK(drawn("1, 23") != drawn("12, 3"));
  CHECK(drawn("0") == evaluate_expression("random(0)", {}));  // of this machine and every other one
  CHECK(to_string(drawn("1, 2")) == "1044315/1048576");
  constexpr int kCount = 4000, kParts = 16;
  std::array<int, kParts> parts{};
  for (int i = 0; i < kCount; ++i) {
    const Rational x = drawn("seed, " + std::to_string(i));
    REQUIRE((x >= 0 && x < 1));
    ++parts[static_cast<std::size_t>(to_double(x) * kParts)];
  }
  double chi = 0;  // 15 degrees of freedom: above 45 once in 10,000
  for (const int n : parts) chi += (n - kCount / kParts) * double(n - kCount / kParts) / (kCount / kParts);
  CHECK(chi < 45);
}

TEST_CASE("repeat is the union of its copies, written out", "[tree]") {
  const auto tree_of = [](const std::string& nodes) {
    return parse_tree("cnrg: 1\nparameters: {n: 3}\nnodes:\n  peg: {box: {min: [0, 0, 0], max: [1, 1, 2]}}\n" +
                          nodes + "result: all\n",
                      "t.yaml");
  };
  const std::string outer = "  all: {difference: [{box: {min: [-1, -1, -1], max: [20, 2, 1]}}, pegs]}\n";
  const Tree repeated = tree_of(
      "  pegs: {repeat: {of: {union: [{simplify: peg, translate: [\"${3 * i}\", 0, 0]}, {repeat: {of: {box: {min: "
      "[\"${3 * i}\", \"${j}\", 0], max: [\"${3 * i + 1/2}\", \"${j + 1/2}\", 3]}}, count: 2, index: j}}]}, "
      "count: \"${n}\", index: i}, rotate: {axis: [0, 0, 1], degrees: 90}}\n" +
      outer);
  std::string copies;
  for (int i = 0; i < 3; ++i) {
    const std::string x = std::to_string(3 * i);
    copies += (i == 0 ? "" : ", ") + ("{union: [{simplify: peg, translate: [" + x + ", 0, 0]}, {union: [");
    for (int j = 0; j < 2; ++j)
      copies += (j == 0 ? "{box: {min: [" : ", {box: {min: [") + x + ", " + std::to_string(j) + ", 0], max: [" +
                x + ".5, " + std::to_string(j) + ".5, 3]}}";
    copies += "]}]}";
  }
  const Tree written =
      tree_of("  pegs: {union: [" + copies + "], rotate: {axis: [0, 0, 1], degrees: 90}}\n" + outer);
  REQUIRE(repeated.nodes.size() == written.nodes.size());
  const auto text = [](const Tree& tree) {
    std::ostringstream out;
    for (const NodeRow& row : evaluate(tree).rows)
      out << row.name << ' ' << row.cells[0] << ' ' << row.cells[2] << ' ' << row.regions << ' '
          << to_string(row.volume().value()) << '\n';
    return out.str();
  };
  CHECK(text(repeated) == text(written));
  CHECK(
      text(tree_of(
          "  pegs: {repeat: {of: peg, count: 3, rotate: {axis: [0, 0, 1], degrees: 40}, translate: [3, 0, 0]}}\n" +
          outer)) ==
      text(tree_of("  pegs: {union: [{simplify: peg}, {simplify: peg, rotate: {axis: [0, 0, 1], degrees: 40}, "
                   "translate: [3, "
                   "0, 0]}, {simplify: peg, rotate: {axis: [0, 0, 1], degrees: 80}, translate: [6, 0, 0]}]}\n" +
                   outer)));
  const auto fault = [&](const std::string& nodes) {
    try {
      tree_of("  all: " + nodes + "\n");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(fault("{repeat: {of: peg, count: 2}}"), Contains("index"));
  CHECK_THAT(fault("{repeat: {of: peg, count: 2, index: i, translate: [1, 0, 0]}}"), Contains("translate"));
  CHECK_THAT(fault("{repeat: {of: peg, count: 2, translate: [1, 0]}}"), Contains("translate"));
  CHECK_THAT(fault("{repeat: {of: peg, count: 2, index: i}}"),
             Contains("t.yaml:5:22: error: `of` of repeat must be a node"));
  CHECK_THAT(fault("{repeat: {of: {simplify: peg}, count: 2, index: n}}"), Contains("that no parameter has"));
  CHECK_THAT(fault("{repeat: {of: {simplify: peg}, count: 0, index: i}}"), Contains("`count` of repeat must be"));
  CHECK_THAT(fault("{repeat: {of: {simplify: peg}, count: 50001, index: i}}"), Contains("from 1 to 50000"));
  CHECK_THAT(
      fault("{repeat: {of: {repeat: {of: {simplify: peg}, count: 5000, index: j}}, count: 5000, index: i}}"),
      Contains("repeat too much"));
  CHECK_THAT(fault("{repeat: &r {of: {union: [peg, {repeat: *r}]}, count: 2, index: i}}"),
             Contains("that no parameter"));
  CHECK_THAT(fault("&r {repeat: {of: {union: [peg, *r]}, count: 2, index: i}}"), Contains("in a cycle"));
  CHECK_THAT(fault("{sphere: {center: [0, 0, 0], radius: 1 + n}}"), Contains("is written \"${1 + n}\""));
  CHECK(fault("{box: {min: [0, 0, 0], max: [1, 1, 1]}, x-price: \"${USD}\"}") == "");
  CHECK(fault("{repeat: {of: {simplify: peg, x-a: \"${n}\"}, count: 1, index: i}}\nx-b: {c: 1}") == "");
}

TEST_CASE("what is no expression is told", "[tree]") {
  const auto fault_of = fault_of_expression;
  CHECK_THAT(fault_of("radis * 2"),
             Contains("`${radis * 2}`: there is no parameter `radis`") && Contains("did you mean `radius`?"));
  CHECK_THAT(fault_of("sqr(2)"), Contains("there is no function `sqr`; did you mean `sqrt`?"));
  CHECK_THAT(fault_of("radius 2"), Contains("nothing is expected at `2`"));
  CHECK_THAT(fault_of("(radius"), Contains("`)` is missing at its end"));
  CHECK_THAT(fault_of("2 +"), Contains("a number or a name is missing at its end"));
  CHECK_THAT(fault_of("* 2"), Contains("is missing before `* 2`"));
  CHECK_THAT(fault_of(""), Contains("is missing at its end"));
  CHECK_THAT(fault_of("1/(radius-4)"), Contains("divides by 0"));
  CHECK_THAT(fault_of("0^-1"), Contains("divides by 0"));
  CHECK_THAT(fault_of("2^(1/2)"), Contains("whole number"));
  CHECK_THAT(fault_of("2^10001"), Contains("at most 10,000"));
  CHECK_THAT(fault_of("(3^10000)^10000"), Contains("too long"));
  CHECK_THAT(fault_of("sqrt(-1)"), Contains("negative"));
  CHECK_THAT(fault_of("tan(90)"), Contains("no tangent"));
  CHECK_THAT(fault_of("min(1)"), Contains("`min` is of two numbers"));
  CHECK_THAT(fault_of("abs(1, 2)"), Contains("`abs` is of one number"));
  CHECK_THAT(fault_of("1.2.3"), Contains("1.2.3"));
  CHECK_THAT(fault_of(std::string(1001, '(')), Contains("1,000 letters"));
  CHECK_THAT(fault_of(std::string(1000, '(')), Contains("missing"));
}

TEST_CASE("parameters stand in texts, names and numbers of a tree", "[tree]") {
  const std::string head = "parameters: {n: 3, R: 4, half: \"${R / 2}\"}\n";
  CHECK(radius_of(tree_with(head, "${half + 1/3}")) == Rational(7, 3));
  CHECK(radius_of(tree_with(head, "${half}", {.parameters = {{"R", "7"}}})) == Rational(7, 2));
  CHECK(radius_of(tree_with(head, "${half}", {.parameters = {{"half", "R * n"}}})) == 12);
  CHECK(radius_of(tree_with(head, "1${n}")) == 13);
  // What a node picks on the command line, numbers of any length, texts that begin like numbers.
  Tree tree = tree_with(head, "${half}");
  CHECK(tree.nodes[add_selection(tree, tree.result, "{dimension: \"${n}\"}", "--select")]
            .selector->criteria.dimensions == std::vector<int>{3});
  CHECK(radius_of(tree_with(head, "${R}", {.parameters = {{"R", std::string(2000, '7')}}})) ==
        Rational(std::string(2000, '7')));
  const auto property = [](const std::string& text) {
    const Tree made =
        parse_tree("cnrg: 1\nparameters: {n: 3}\nnodes: {a: {points: [[0, 0, 0]], attributes: {k: \"" + text +
                       "\"}}}\nresult: a\n",
                   "t.yaml");
    return made.nodes[made.result].properties.at("k");
  };
  CHECK(property("${n}") == Property(Rational(3)));
  CHECK(property("0${n}") == Property(std::string("03")));
  std::set<std::string> unknown;
  tree_with(head, "1", {.parameters = {{"r", "1"}, {"R", "1"}}, .unknown = &unknown});
  CHECK(unknown == std::set<std::string>{"r"});
  CHECK(with_values("a $${n} ${n}${n} $", {{"n", 3}}) == "a ${n} 33 $");
  const auto fault = [&](const std::string& start, const std::string& radius, const ReadOptions& options = {}) {
    try {
      tree_with(start, radius, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(fault(head, "${Rr}"), Contains("t.yaml:5:41: error: `${Rr}`: there is no parameter `Rr`"));
  CHECK_THAT(fault(head, "${R"), Contains("t.yaml:5:41: error:") && Contains("`}` is missing"));
  CHECK_THAT(fault(head, "a${R}"), Contains("t.yaml:5:41: error:") && Contains("`a4` is no number"));
  CHECK_THAT(fault("parameters: {n: 3, a: \"${b}\", b: 1}\n", "1"), Contains("t.yaml:2:23: error: `${b}`"));
  CHECK_THAT(fault("parameters: {n: 3, 2a: 1}\n", "1"), Contains("t.yaml:2:20: error: the parameter `2a`"));
  CHECK_THAT(fault("parameters: {n: 3, n: 4}\n", "1"), Contains("t.yaml:2:20: error:") && Contains("twice"));
  CHECK_THAT(fault("parameters: {n: [3]}\n", "1"),
             Contains("t.yaml:2:17: error: the parameter `n` must be a number or an expression"));
  CHECK_THAT(fault("parameters: 3\n", "1"), Contains("t.yaml:2:13: error: `parameters` must be a map"));
  CHECK_THAT(fault("parameters:\n", "1"), Contains("t.yaml:2:1: error: `parameters` must be a map"));
  const std::string huge = "parameters: {n: 3, z: \"${10^9999}\"}\n";
  std::string much;
  for (int i = 0; i < 20; ++i) much += "${z}";
  CHECK_THAT(fault(huge, much), Contains("too long"));
  CHECK_THAT(fault_of_expression("sin"), Contains("`sin` is a function: `sin(...)`"));
  CHECK(fault_of_expression(std::string(5000, 'a')).size() < 200);
  CHECK_THAT(fault("", "1"),
             Contains("t.yaml:3:3: error: `${n}`: there is no parameter `n`; add it to `parameters`"));
  CHECK_THAT(fault(head, "1", {.parameters = {{"r", "1"}}}),
             Contains("the parameter `r`: t.yaml has no such one; did you mean `R`?"));
  CHECK_THAT(fault(head, "1", {.parameters = {{"R", "1/0"}}}),
             Contains("the parameter `R`: `${1/0}`: this divides by 0"));
}

}  // namespace cnrg
