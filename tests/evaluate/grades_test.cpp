// Graded materials in trees: which region has which, where it is placed, what its distance is measured to.
#include <string>

#include "csg/evaluate/evaluate.h"
#include "csg/materials/sampler.h"
#include "csg/operators/node_value.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

const std::string kHead = R"(cnrg: 1
materials:
  steel: {}
  ceramic: {}
  rubber: {}
  blend: {linear: {from: [0, 0, 0], to: [0, 0, 4], stops: [[0, steel], [1, ceramic]]}}
  coat: {distance: {to: bolt, stops: [[0, ceramic], [2, rubber]]}}
nodes:
  body: {box: {min: [0, 0, 0], max: [4, 4, 4]}, material: blend}
  bolt: {polyline: [[2, 2, -1], [2, 2, 5]]}
  sleeve: {box: {min: [1, 1, 0], max: [3, 3, 4]}, material: coat, dominance: 2}
  plain: {box: {min: [2, 0, 0], max: [6, 4, 4]}, material: rubber}
)";

struct GradeRun {
  Tree tree;
  Evaluation evaluation;
};

GradeRun run_grades(const std::string& nodes) {
  GradeRun r{parse_tree(kHead + nodes + "result: r\n", "t.yaml"), {}};
  EvaluateOptions options;
  options.validate = true;
  r.evaluation = evaluate(r.tree, options);
  return r;
}

/// What the component that holds the point is made of there.
std::string mixture_text_at(const GradeRun& r, const RationalPoint& p) {
  const KeptValue& kept = r.evaluation.value(r.tree.result);
  const Locator locator(*r.evaluation.complex);
  const auto place = kept.simplified->place(*r.evaluation.complex, locator.locate(p));
  const Component component = component_of(*kept.simplified, place);
  if (component == 0) return "outside";
  return to_text(MaterialSampler(kept.value->attributes(component).material).at(p));
}

TEST_CASE("graded materials are combined by dominance, through every operator", "[grades]") {
  const RationalPoint in_both{Rational(3, 2), 2, 1}, in_body{Rational(1, 2), 2, 1};
  for (const std::string op : {"union: [body, sleeve]", "sum: [body, sleeve]"}) {
    INFO(op);
    const GradeRun r = run_grades("  r: {" + op + "}\n");
    CHECK(mixture_text_at(r, in_body) == "steel 3/4, ceramic 1/4");
    CHECK(mixture_text_at(r, in_both) == "ceramic 3/4, rubber 1/4");  // half a unit from the bolt
  }
  for (const std::string op : {"intersection: [body, sleeve]", "product: [body, sleeve]"}) {
    INFO(op);
    CHECK(mixture_text_at(run_grades("  r: {" + op + "}\n"), in_both) == "ceramic 3/4, rubber 1/4");
  }
  for (const std::string op : {"difference: [body, sleeve]", "subtract: [body, sleeve]"}) {
    INFO(op);
    const GradeRun r = run_grades("  r: {" + op + "}\n");
    CHECK(mixture_text_at(r, in_body) == "steel 3/4, ceramic 1/4");
    CHECK(mixture_text_at(r, in_both) == "outside");
  }
  CHECK(mixture_text_at(run_grades("  r: {union: [body, sleeve], dominance: left}\n"), in_both) ==
        "steel 3/4, ceramic 1/4");
  CHECK(mixture_text_at(run_grades("  r: {regularize: {closure: {interior: body}}}\n"), in_body) ==
        "steel 3/4, ceramic 1/4");
  CHECK(mixture_text_at(run_grades("  r: {unify: {difference: [body, sleeve]}}\n"), in_body) ==
        "steel 3/4, ceramic 1/4");
  CHECK(mixture_text_at(run_grades("  r: {union: [body, sleeve], material: coat}\n"), in_body) ==
        "rubber 3/4, ceramic 1/4");
}

TEST_CASE("equal dominance keeps the left grade and says so", "[grades]") {
  const GradeRun r = run_grades("  r: {union: [body, plain]}\n");
  REQUIRE(r.evaluation.diagnostics.size() == 1);
  CHECK_THAT(r.evaluation.diagnostics[0].message,
             Catch::Contains("keeps the material `blend` where `rubber` has"));
  CHECK(mixture_text_at(r, {3, 1, 1}) == "steel 3/4, ceramic 1/4");
}

TEST_CASE("one grade placed twice is two materials", "[grades]") {
  const GradeRun same =
      run_grades("  r: {union: [body, {box: {min: [1, 1, 1], max: [5, 3, 3]}, material: blend}]}\n");
  CHECK(same.evaluation.diagnostics.empty());
  const GradeRun r = run_grades("  up: {simplify: body, translate: [0, 0, 1]}\n  r: {union: [body, up]}\n");
  REQUIRE(r.evaluation.diagnostics.size() == 1);
  CHECK_THAT(r.evaluation.diagnostics[0].message,
             Catch::Contains("keeps the material `blend` where `blend` placed otherwise has equal dominance"));
}

TEST_CASE("transforms of nodes above move a grade, the node's own do not", "[grades]") {
  const std::string box = "{box: {min: [0, 0, 0], max: [4, 4, 4]}, material: blend, translate: [0, 0, 1]}";
  CHECK(mixture_text_at(run_grades("  r: " + box + "\n"), {1, 1, 2}) == "ceramic 1/2, steel 1/2");
  const GradeRun r = run_grades("  a: " + box + "\n  r: {simplify: a, translate: [0, 0, 1]}\n");
  CHECK(mixture_text_at(r, {1, 1, 3}) == "ceramic 1/2, steel 1/2");
  // A bolt that stands with its own transform is measured as it stands.
  const GradeRun s = run_grades("  r: {simplify: sleeve, rotate: {axis: [1, 0, 0], degrees: 90}}\n");
  CHECK(mixture_text_at(s, {Rational(3, 2), -1, 2}) == "ceramic 3/4, rubber 1/4");
}

TEST_CASE("a distance is measured to faces, also of solids, and to points", "[grades]") {
  const std::string materials =
      "cnrg: 1\nmaterials: {a: {}, b: {}, g: {distance: {to: t, stops: [[0, a], [4, b]]}}}\nnodes:\n"
      "  body: {box: {min: [-9, -9, -9], max: [9, 9, 9]}, material: g}\n";
  const auto at = [&](const std::string& target, const RationalPoint& p) {
    GradeRun r{parse_tree(materials + "  t: {" + target + "}\nresult: body\n", "t.yaml"), {}};
    r.evaluation = evaluate(r.tree);
    return mixture_text_at(r, p);
  };
  CHECK(at("box: {min: [0, 0, 0], max: [4, 4, 4]}", {2, 2, 1}) == "a 3/4, b 1/4");  // inside of it, from its skin
  CHECK(at("box: {min: [0, 0, 0], max: [4, 4, 4]}", {2, 2, 5}) == "a 3/4, b 1/4");
  CHECK(at("points: [[0, 0, 0], [8, 0, 0]]", {1, 0, 0}) == "a 3/4, b 1/4");
  CHECK(at("interior: {box: {min: [0, 0, 0], max: [4, 4, 4]}}", {2, 2, 5}) == "a 3/4, b 1/4");
  CHECK(at("polygon: {outer: [[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]], holes: [[[-2, -2, 0], [2, -2, 0], "
           "[2, 2, 0], [-2, 2, 0]]]}",
           {0, 0, 0}) == "a 1/2, b 1/2");
}

TEST_CASE("a distance to what is unbounded or empty is refused at its place", "[grades]") {
  const auto message = [](const std::string& target) {
    const Tree tree = parse_tree(
        "cnrg: 1\nmaterials:\n  a: {}\n  g: {distance: {to: t, stops: [[0, a], [4, a]]}}\nnodes:\n"
        "  body: {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: g}\n"
        "  far: {box: {min: [7, 0, 0], max: [8, 1, 1]}}\n  t: {" +
            target + "}\nresult: body\n",
        "t.yaml");
    CHECK(reading_warnings(tree, {tree.result}).size() == (target.find("far") == std::string::npos ? 1 : 0));
    try {
      evaluate(tree);
    } catch (const TreeError& e) {
      return std::string(e.what());
    }
    return std::string("none");
  };
  CHECK_THAT(message("plane: {point: [0, 0, 0], normal: [0, 0, 1]}"), Catch::StartsWith("t.yaml:4:22: error: ") &&
                                                                          Catch::Contains("unbounded") &&
                                                                          Catch::Contains("linear"));
  CHECK_THAT(message("intersection: [far, {translate: [9, 0, 0], simplify: far}]"),
             Catch::StartsWith("t.yaml:4:22: error: ") && Catch::Contains("empty"));
}

}  // namespace
}  // namespace cnrg
