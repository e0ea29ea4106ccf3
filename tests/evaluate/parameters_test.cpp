// Cylinders, spheres, cones and tori are patches as others are; parameters on patches after Booleans.
#include <cmath>
#include <string>

#include "csg/curves/control_nets.h"
#include "csg/evaluate/evaluate.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/node_value.h"
#include "csg/topology/topology.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Cells = std::array<std::size_t, 4>;

Evaluation evaluated_text(const std::string& text, bool each = true) {
  const Tree tree = parse_tree(text, "t.yaml");
  EvaluateOptions options;
  options.validate = true;
  options.proof = AskedProof::none;  // with the facets of the leaves alone
  if (!each) return evaluate(tree, options);
  for (NodeId id : IdRange<NodeId>(tree.nodes.size())) options.nodes.push_back(id);
  return evaluate(tree, options);
}

const NodeRow& row(const Evaluation& evaluation, const std::string& name) {
  for (const NodeRow& r : evaluation.rows) {
    if (r.name == name) return r;
  }
  FAIL(name);
  return evaluation.rows[0];
}

std::string topology(const std::string& leaf) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n  a: {" + leaf + "}\nresult: a\n", "t.yaml");
  const Evaluation evaluation = evaluate(tree);
  const KeptValue& kept = evaluation.value(tree.result);
  return topology_text(*evaluation.complex, selection_of(*evaluation.complex, *kept.value), *kept.simplified,
                       kept.value->attributes());
}

std::vector<LeafId> all_leaves(const Evaluation& evaluation) {
  std::vector<LeafId> leaves;
  for (const LeafId leaf : IdRange<LeafId>(evaluation.leaf_names.size())) leaves.push_back(leaf);
  return leaves;
}

double distance(const RationalPoint& a, const RationalPoint& b) { return std::sqrt(to_double(dot(a - b, a - b))); }

const std::string kCylinder = "cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 12}";
const std::string kCone = "cone: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 12}";
const std::string kSphere = "sphere: {center: [0, 0, 0], radius: 1, segments: 32, rings: 16}";
const std::string kTorus =
    "torus: {center: [0, 0, 0], axis: [0, 0, 1], radius: 3, tube: 1, segments: 24, rings: 16}";

// Half of a circle as a rational cubic, a circle as a rational quintic: points x, y with their weights.
using Arc = std::vector<std::array<Rational, 3>>;
const Arc kHalf{{0, -1, 1}, {2, -1, Rational(1, 3)}, {2, 1, Rational(1, 3)}, {0, 1, 1}};
const Arc kCircle{{0, -1, 5}, {4, -1, 1}, {2, 3, 1}, {-2, 3, 1}, {-4, -1, 1}, {0, -1, 5}};

/// A profile (x from the axis) turned about the z axis, as one Bézier patch.
std::string turned(const Arc& profile) {
  std::string points, weights;
  for (const auto& [x, z, w] : profile) {
    points += points.empty() ? "[" : "], [";
    weights += weights.empty() ? "[" : "], [";
    std::string before;
    for (const auto& [cx, cy, cw] : kCircle) {
      points +=
          before + "[\"" + to_string(cx * x) + "\", \"" + to_string(cy * x) + "\", \"" + to_string(z) + "\"]";
      weights += before + "\"" + to_string(cw * w) + "\"";
      before = ", ";
    }
  }
  return "bezier: {patch: {points: [" + points + "]], weights: [" + weights + "]]}, fill: winding, chord: 1/20}";
}

}  // namespace

TEST_CASE("cylinders and cones are what revolve makes of their profiles", "[evaluate][curved]") {
  for (const auto& [shape, profile, cells] :
       {std::tuple{kCylinder, "[[0, 0], [1, 0], [1, 2], [0, 2]]", Cells{0, 2, 3, 1}},
        std::tuple{kCone, "[[0, 0], [1, 0], [0, 2]]", Cells{0, 1, 2, 1}}}) {
    const std::string swept = std::string("revolve: {profile: ") + profile + ", segments: 12}";
    const Evaluation evaluation = evaluated_text(
        "cnrg: 1\nnodes:\n  a: {" + shape + "}\n  b: {" + swept +
        "}\n  less: {subtract: [a, b]}\n  more: {subtract: [b, a]}\n  u: {union: [a, b], dominance: equal}\n"
        "  all: {aggregate: [less, more]}\nresult: all\n");
    CHECK(row(evaluation, "a").cells == cells);
    CHECK(row(evaluation, "b").cells == cells);
    CHECK(row(evaluation, "u").cells == cells);
    CHECK(row(evaluation, "all").cells == Cells{0, 0, 0, 0});  // the same points of space
    CHECK(row(evaluation, "a").volume() == row(evaluation, "b").volume());
    CHECK(topology(shape) == topology(swept));
    // Both know the side; the sweep has (v, u) of the cylinder.
    const std::vector<LeafId> leaves = all_leaves(evaluation);
    const Complex& complex = *evaluation.complex;
    std::size_t both = 0;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
      const RationalPoint p = interior_point(complex, f).rational();
      const auto at = evaluation.parameters->on_patches({2, {}, {}, f, {}}, p, leaves);
      if (at.empty() || at[0].leaf != LeafId(0)) continue;  // a cap
      REQUIRE(at.size() == 2);
      CHECK(at[0].at == Parameters{at[1].at[1], at[1].at[0]});
      ++both;
    }
    CHECK(both == 12);
  }
}

TEST_CASE("spheres and tori have the cells and the topology of rational patches and turned arcs",
          "[evaluate][curved]") {
  Arc tube = kCircle;
  for (auto& [x, z, w] : tube) x += 3;
  const std::string arc =
      "revolve: {profile: [[0, -1], {bezier: [[2, -1], [2, 1]], weights: [1, 1/3, 1/3, 1]}, [0, 1]], chord: 1/20}";
  for (const auto& [shape, same, volume] :
       {std::tuple{kSphere, turned(kHalf), 4.18879020478639}, std::tuple{kSphere, arc, 4.18879020478639},
        std::tuple{kTorus, turned(tube), 59.2176264065361}}) {
    INFO(same);
    const Evaluation evaluation = evaluated_text("cnrg: 1\nnodes:\n  a: {" + shape + "}\n  b: {" + same +
                                                 ", translate: [9, 0, 0]}\n  all: {union: [a, b]}\nresult: all\n");
    for (const char* name : {"a", "b"}) {
      CHECK(row(evaluation, name).cells == Cells{0, 0, 1, 1});
      CHECK(std::abs(to_double(*row(evaluation, name).volume()) / volume - 1) < 0.06);
    }
    CHECK(topology(shape) == topology(same));
    // Vertices lie on the exact surface, exactly for the patches.
    const LeafId b(1);
    for (const VertexId v : evaluation.complex->vertices) {
      const RationalPoint p = evaluation.complex->points.rational(v);
      for (const PatchPoint& at : evaluation.parameters->on_patches({0, v, {}, {}, {}}, p, std::span(&b, 1))) {
        const Rational x = p[0] - 9, r2 = x * x + p[1] * p[1], z2 = p[2] * p[2];
        if (shape == kTorus) {  // (r - 3)^2 + z^2 = 1, squared
          const Rational k = r2 + z2 + 8;
          CHECK(k * k == 36 * r2);
        } else if (same != arc) {
          CHECK(r2 + z2 == 1);
        } else {
          CHECK(std::abs(to_double(r2 + z2) - 1) < 1e-15);
        }
        CHECK((at.at[0] >= 0 && at.at[0] <= 1));
      }
    }
  }
}

TEST_CASE("a quarter of a cylinder as a rational patch lies on the cylinder", "[evaluate][curved]") {
  const std::string quarter =
      "bezier: {patch: {points: [[[1, 0, 0], [1, 1, 0], [0, 1, 0]], [[1, 0, 2], [1, 1, 2], [0, 1, 2]]], "
      "weights: [[1, 1, 2], [1, 1, 2]]}, chord: 1/500}";
  const Evaluation evaluation =
      evaluated_text("cnrg: 1\nnodes:\n  a: {" + quarter +
                     "}\n  b: {cylinder: {from: [0, 0, 0], "
                     "to: [0, 0, 2], radius: 2, segments: 8}}\n  u: {union: [a, b]}\nresult: u\n");
  CHECK(row(evaluation, "a").cells == Cells{4, 4, 1, 0});
  const Complex& complex = *evaluation.complex;
  const LeafId leaf(0);
  std::size_t seen = 0;
  for (const VertexId v : complex.vertices) {
    const RationalPoint p = complex.points.rational(v);
    for (const PatchPoint& at : evaluation.parameters->on_patches({0, v, {}, {}, {}}, p, std::span(&leaf, 1))) {
      ++seen;
      CHECK(p[0] * p[0] + p[1] * p[1] == 1);
      CHECK(p[2] == 2 * at.at[1]);
      const Rational& u = at.at[0];  // the rational parametrization of the circle, exactly
      CHECK(p[0] == (1 - u * u) / (1 + u * u));
    }
  }
  CHECK(seen > 8);
}

namespace {

const LeafId kVaseLeaf(0), kSheetLeaf(1);
const char* const kSheet =
    "[[[-2, -2, 0], [0, -2, 2], [2, -2, 0]], [[-2, 0, 1], [0, 0, 5], [2, 0, 1]], "
    "[[-2, 2, 0], [0, 2, 1], [2, 2, 0]]]";

Evaluation scene(const std::string& chord) {
  return evaluated_text(
      std::string("cnrg: 1\nnodes:\n  sheet: {bezier: {patch: ") + kSheet + ", chord: " + chord +
          "}}\n  vase: {revolve: {profile: [[0, -1], [1, -1], {bezier: [[2, 1]], weights: [1, 2, 1]}, [1, 3], "
          "[0, 3]], chord: " +
          chord +
          "}}\n  u: {union: [vase, sheet], dominance: right}\n"
          "  d: {difference: [vase, {box: {min: [0, 0, 1], max: [3, 3, 4]}}]}\n"
          "  all: {union: [u, d]}\nresult: all\n",
      false);
}

RationalPoint sheet_at(const Parameters& at) {
  static const PatchNet kNet{{{{-2, -2, 0}, {0, -2, 2}, {2, -2, 0}},
                              {{-2, 0, 1}, {0, 0, 5}, {2, 0, 1}},
                              {{-2, 2, 0}, {0, 2, 1}, {2, 2, 0}}},
                             {},
                             {0, 0},
                             {}};
  return patch_pieces(kNet, "test")[0].at(at[0], at[1]);
}

/// The wall of the vase, in doubles.
std::array<double, 3> vase_at(const Parameters& at) {
  const double t = to_double(at[0]), a = to_double(at[1]) * 6.283185307179586, s = 1 - t;
  const double w = s * s + 2 * 2 * s * t + t * t;
  const double radius = (s * s + 4 * s * t * 2 + t * t) / w, z = (-s * s + 4 * s * t * 1 + 3 * t * t) / w;
  return {radius * std::cos(a), radius * std::sin(a), z};
}

}  // namespace

TEST_CASE("where patches meet a vertex has parameters on both, exact in every facet", "[evaluate][curved]") {
  double last = 1e9;
  for (const double chord : {0.2, 0.05, 0.0125}) {
    const Evaluation evaluation = scene(to_decimal(from_double(chord)));
    const Complex& complex = *evaluation.complex;
    const std::vector<LeafId> leaves{kVaseLeaf, kSheetLeaf};
    REQUIRE(evaluation.leaf_names[kSheetLeaf.index()] == "sheet");
    REQUIRE(evaluation.leaf_names[kVaseLeaf.index()] == "vase");
    const SurfaceParameters& parameters = *evaluation.parameters;
    CHECK(parameters.patch_name(kVaseLeaf, 1) == "revolve segment 2");
    CHECK(!parameters.has(LeafId(2)));
    std::size_t on_both = 0;
    double farthest = 0;
    for (const VertexId v : complex.vertices) {
      const RationalPoint p = complex.points.rational(v);
      bool sheet = false, wall = false;
      for (const PatchPoint& at : parameters.on_patches({0, v, {}, {}, {}}, p, leaves)) {
        if (at.leaf == kSheetLeaf) {
          sheet = true;
          farthest = std::max(farthest, distance(sheet_at(at.at), p));
        } else if (at.patch == 1) {
          wall = true;
          const auto s = vase_at(at.at);
          farthest = std::max(farthest, distance({from_double(s[0]), from_double(s[1]), from_double(s[2])}, p));
        }
      }
      on_both += sheet && wall;
    }
    CHECK(on_both > 10);
    CHECK(farthest <= chord);
    CHECK(farthest > 0);
    CHECK(farthest < last);
    last = farthest;

    // In each piece of a facet parameters are linear along its edges (and all of a triangle), and a corner's own
    // are those that the facet gives it.
    std::size_t edges = 0;
    for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
      for (const PlacedCell& cell : parameters.cells(f, leaves)) {
        for (const HalfEdge h : complex.loop[complex.face_loops[f].front()]) {
          const VertexId a = complex.origin(h), b = complex.target(h);
          const RationalPoint pa = complex.points.rational(a), pb = complex.points.rational(b);
          const Parameters at = parameters_in(cell.corners, pa), to = parameters_in(cell.corners, pb);
          const auto known = parameters.on_patches({0, a, {}, {}, {}}, pa, leaves);
          CHECK(std::count(known.begin(), known.end(), PatchPoint{cell.leaf, cell.patch, at}) == 1);
          if (cell.corners.size() != 3) continue;
          const RationalPoint third = pa + Rational(1, 3) * (pb - pa);
          const Parameters between = parameters_in(cell.corners, third);
          for (std::size_t k = 0; k < 2; ++k) CHECK(between[k] == at[k] + (to[k] - at[k]) / 3);
          ++edges;
        }
      }
    }
    CHECK(edges > 100);
  }
}

TEST_CASE("parameters follow a leaf through its transforms, curves too", "[evaluate][curved]") {
  const Evaluation evaluation = evaluated_text(
      "cnrg: 1\nnodes:\n  w: {bezier: {curve: [[0, 0, -3], [1, 2, -3], [2, 0, -3]], segments: 4}}\n"
      "  c: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 8}}\n"
      "  m: {union: [w, c], mirror: {normal: [1, 2, 2], point: [1, 0, 0]}, scale: [1, 2, 3]}\n"
      "  all: {union: [m, w]}\nresult: all\n",
      false);
  const std::vector<LeafId> leaves = all_leaves(evaluation);
  const Complex& complex = *evaluation.complex;
  const CurveNet net{{{0, 0, -3}, {1, 2, -3}, {2, 0, -3}}, {}, 0, {}};
  const BezierCurve curve = curve_pieces(net, "test")[0];
  const Transform mirrored = Transform::scaling({1, 2, 3}) * Transform::reflection({1, 2, 2}, {1, 0, 0});
  const Transform scaled = Transform::reflection({1, 2, 2}, {1, 0, 0}) * Transform::scaling({1, 2, 3});
  std::size_t wires = 0, faces = 0;
  for (const VertexId v : complex.vertices) {
    const RationalPoint p = complex.points.rational(v);
    const Location cell{0, v, {}, {}, {}};
    for (const CurvePoint& at : evaluation.parameters->on_curves(cell, p, leaves)) {
      const RationalPoint q = curve.at(at.at);
      CHECK((p == q || p == mirrored.apply(q) || p == scaled.apply(q)));
      CHECK(evaluation.parameters->curve_name(at.leaf, at.curve) == "bezier curve");
      ++wires;
    }
    for (const PatchPoint& at : evaluation.parameters->on_patches(cell, p, leaves)) {
      CHECK((at.at[1] == 0 || at.at[1] == 1));
      CHECK(Rational(8 * at.at[0]).get_den() == 1);
      ++faces;
    }
  }
  CHECK(wires == 10);
  CHECK(faces == 18);  // two on the seam
  CHECK(complex.vertices.size() == 26);
}

}  // namespace cnrg
