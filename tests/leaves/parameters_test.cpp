// Parameters of facets: interpolation in cells, and that every leaf's cells are points of its patches.
#include "csg/leaves/parameters.h"

#include "csg/curves/control_nets.h"
#include "csg/geometry/circle.h"
#include "kernel/exact/trigonometry.h"
#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Cell = std::vector<PatchCorner>;

/// A leaf made by `prepare`, its soup and its parameters.
struct Made {
  Soup soup;
  std::shared_ptr<const LeafParameters> parameters;
  explicit Made(const Shape& shape) {
    const auto leaf = prepare(shape);
    leaf->add_to(soup, {});
    REQUIRE(leaf->parameters());
    parameters = leaf->parameters()();
  }
};

/// Calls `check(patch, corner)` for all corners of all cells, once each face was found to lie in its cell. Faces
/// without a cell are the ones listed.
template <class Check>
void each_corner(const Made& made, const std::set<std::uint32_t>& flat, Check check) {
  REQUIRE(made.parameters->facet_count() == made.soup.face_count());
  REQUIRE(made.parameters->wire_count() == made.soup.wires().size());
  for (const SourceId f : IdRange<SourceId>(made.soup.face_count())) {
    const std::uint32_t patch = made.soup.face(f).patch;
    CHECK(!made.parameters->patch_name(patch).empty());
    const std::vector<Cell> cells = made.parameters->cells(f.index());
    REQUIRE(cells.size() == (flat.count(patch) ? 0 : 1));
    if (cells.empty()) continue;
    REQUIRE(is_cell(cells[0]));
    std::set<RationalPoint> corners, face;
    for (const PatchCorner& corner : cells[0]) corners.insert(corner.point);
    for (const PointId p : made.soup.corners(f)) face.insert(value(made.soup, p));
    REQUIRE(corners == face);
    for (const PatchCorner& corner : cells[0]) check(patch, corner);
  }
}

/// How often two facets of a patch that share an edge differ inside of it: by whole turns of a closed one only.
void check_edges(const Made& made, const std::set<std::size_t>& closed) {
  std::map<std::array<RationalPoint, 2>, std::vector<std::pair<std::uint32_t, Parameters>>> at;
  for (const SourceId f : IdRange<SourceId>(made.soup.face_count())) {
    const std::vector<Cell> cells = made.parameters->cells(f.index());
    if (cells.empty()) continue;
    const auto loop = loops(made.soup, f)[0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      std::array<RationalPoint, 2> edge{loop[i], loop[(i + 1) % loop.size()]};
      if (edge[1] < edge[0]) std::swap(edge[0], edge[1]);
      const RationalPoint p = edge[0] + Rational(1, 3) * (edge[1] - edge[0]);
      at[edge].emplace_back(made.soup.face(f).patch, parameters_in(cells[0], p));
    }
  }
  std::size_t shared = 0;
  for (const auto& [edge, places] : at) {
    if (places.size() != 2 || places[0].first != places[1].first) continue;
    ++shared;
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational apart = abs(Rational(places[0].second[k] - places[1].second[k]));
      CHECK((apart == 0 || (apart == 1 && closed.count(k))));
    }
  }
  CHECK(shared > 0);
}

RationalPoint by_net(const PatchNet& net, const Rational& u, const Rational& v) {
  const std::vector<BezierPatch> pieces = patch_pieces(net, "test");
  const auto spans = patch_spans(net);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& [in_u, in_v] = spans[k];
    if (u < in_u[0] || in_u[1] < u || v < in_v[0] || in_v[1] < v) continue;
    return pieces[k].at((u - in_u[0]) / (in_u[1] - in_u[0]), (v - in_v[0]) / (in_v[1] - in_v[0]));
  }
  FAIL("parameters beyond the knots");
  return {};
}

PatchNet eighth_of_sphere() {
  return {
      {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}},
      {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}},
      {0, 0},
      {}};
}

PatchNet reversed(PatchNet net, bool along_u, bool along_v, bool transposed) {
  const auto turn = [&](auto& rows) {
    if (along_v) std::reverse(rows.begin(), rows.end());
    for (auto& row : rows) {
      if (along_u) std::reverse(row.begin(), row.end());
    }
    if (!transposed || rows.empty()) return;
    auto columns = std::remove_reference_t<decltype(rows)>(rows[0].size());
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) columns[i].push_back(row[i]);
    }
    rows = columns;
  };
  turn(net.points);
  turn(net.weights);
  return net;
}

}  // namespace

TEST_CASE("parameters in a cell are those of the map that has the corners") {
  const auto mix = [](const auto& a, const auto& b, const Rational& t) {
    auto result = a;
    for (std::size_t k = 0; k < a.size(); ++k) result[k] = a[k] + t * (b[k] - a[k]);
    return result;
  };
  const std::vector<Rational> places{0, Rational(1, 7), Rational(1, 2), 1};
  const RationalPoint a{1, 2, 3}, along{3, -1, 2}, up{-1, 4, 1};
  const Parameters at[4] = {{0, 0}, {r("3/4"), r("1/9")}, {1, 1}, {r("-1/5"), r("6/7")}};
  // The side across from a b: longer, shorter, as long, and a point; and a b a point.
  for (const auto& [lower, upper] :
       {std::pair{r("1"), r("3")}, {r("2"), r("1/3")}, {r("1"), r("1")}, {r("1"), r("0")}, {r("0"), r("2")}}) {
    const RationalPoint d = a + up, b = a + lower * along, c = d + upper * along;
    Cell cell{{a, at[0]}, {b, at[1]}, {c, at[2]}, {d, at[3]}};
    for (std::size_t turn = 0; turn < 4; ++turn) {
      REQUIRE(is_cell(cell));
      for (const Rational& t : places) {
        for (const Rational& s : places) {
          const RationalPoint p = mix(mix(a, b, s), mix(d, c, s), t);
          CHECK(holds(cell, p));
          const bool pole = (t == 0 && lower == 0) || (t == 1 && upper == 0);
          const Rational& of = pole ? Rational(1, 2) : s;
          CHECK(parameters_in(cell, p) == mix(mix(at[0], at[1], of), mix(at[3], at[2], of), t));
        }
      }
      CHECK(!holds(cell, a - up));
      std::rotate(cell.begin(), cell.begin() + 1, cell.end());
    }
  }
  // No two sides parallel: two triangles. A triangle: affine.
  const RationalPoint b = a + along, c = a + Rational(2) * along + Rational(3) * up, d = a + up;
  const Cell cell{{a, at[0]}, {b, at[1]}, {c, at[2]}, {d, at[3]}};
  const Cell first{{a, at[0]}, {b, at[1]}, {c, at[2]}}, second{{a, at[0]}, {c, at[2]}, {d, at[3]}};
  for (const Rational& s : places) {
    for (const Rational& t : places) {
      const RationalPoint in_first = mix(a, mix(b, c, s), t), in_second = mix(a, mix(c, d, s), t);
      CHECK(parameters_in(cell, in_first) == mix(at[0], mix(at[1], at[2], s), t));
      CHECK(parameters_in(cell, in_second) == mix(at[0], mix(at[2], at[3], s), t));
      CHECK(parameters_in(first, in_first) == parameters_in(cell, in_first));
      CHECK(parameters_in(second, in_second) == parameters_in(cell, in_second));
    }
  }
  CHECK(!is_cell(Cell{{a, {}}, {b, {}}, {a + Rational(5) * along, {}}}));
  CHECK(!is_cell(Cell{{a, {}}, {b, {}}, {c, {}}, {d + cross(along, up), {}}}));
}

TEST_CASE("vertices of Bézier patches are the patch at their parameters") {
  const PatchNet wild{{{{0, 0, 0}, {1, 0, 3}, {2, 0, 0}, {3, 0, 1}},
                       {{0, 1, 2}, {1, 1, -4}, {2, 1, 0}, {3, 2, 0}},
                       {{0, 3, 0}, {1, 2, 1}, {2, 2, 5}, {4, 4, 0}}},
                      {{1, 2, 1, 3}, {1, 1, 1, 1}, {2, 1, 1, 1}},
                      {0, 0},
                      {}};
  for (const PatchNet& net : {wild, eighth_of_sphere()}) {
    for (int way = 0; way < 8; ++way) {
      BezierShape shape{{reversed(net, way & 1, way & 2, way & 4)}, {}, Fill::none, {r("0.05"), {}}};
      INFO("way " << way);
      const Made made(shape);
      each_corner(made, {}, [&](std::uint32_t, const PatchCorner& c) {
        REQUIRE(by_net(shape.patches[0], c.at[0], c.at[1]) == c.point);
      });
      check_edges(made, {});
      CHECK(made.parameters->patch_name(0) == "bezier patch");
    }
  }
}

TEST_CASE("vertices of B-splines have the parameters of their knots, wires too") {
  PatchNet net;
  for (int j = 0; j < 5; ++j) {
    net.points.emplace_back();
    for (int i = 0; i < 6; ++i) net.points[std::size_t(j)].push_back({i, j, (i * j) % 4});
  }
  net.degree = {3, 2};
  net.knots = {std::vector<Rational>{0, 0, 1, 2, 4, 5, 6, 6, 7, 8}, std::vector<Rational>{0, 0, 0, 1, 1, 3, 3, 3}};
  const CurveNet curve{{{0, 0, 9}, {1, 2, 9}, {2, 0, 9}, {5, 1, 9}}, {}, 2, {0, 0, 0, r("1/3"), 2, 2, 2}};
  BezierShape shape{{net, net}, {curve}, Fill::none, {{}, 5}, true};
  for (auto& row : shape.patches[1].points) {
    for (RationalPoint& p : row) p[2] += 20;
  }
  const Made made(shape);
  Rational least = 99, most = -99;
  each_corner(made, {}, [&](std::uint32_t patch, const PatchCorner& c) {
    REQUIRE(by_net(shape.patches[patch], c.at[0], c.at[1]) == c.point);
    least = std::min(least, c.at[0]), most = std::max(most, c.at[0]);
  });
  CHECK(least == net.knots[0][3]);
  CHECK(most == net.knots[0][6]);
  check_edges(made, {});
  CHECK(made.parameters->patch_name(1) == "bspline patch 2");
  CHECK(made.parameters->curve_name(0) == "bspline curve");
  const std::vector<BezierCurve> pieces = curve_pieces(curve, "test");
  const std::vector<Span> spans = curve_spans(curve);
  Rational last = 0;
  for (std::size_t w = 0; w < made.parameters->wire_count(); ++w) {
    const LeafParameters::Wire wire = made.parameters->wire(w);
    CHECK(wire.at[0] == last);
    last = wire.at[1];
    const std::size_t piece = wire.at[1] <= spans[0][1] ? 0 : 1;
    for (std::size_t k = 0; k < 2; ++k) {
      const Rational t = (wire.at[k] - spans[piece][0]) / (spans[piece][1] - spans[piece][0]);
      CHECK(pieces[piece].at(t) == wire.ends[k]);
    }
  }
  CHECK(last == 2);
}

TEST_CASE("vertices of Coons patches are the blended curves at their parameters") {
  const CurveNet c0{{{0, 0, 0}, {1, 0, 2}, {2, 0, 0}}, {}, 0, {}}, c1{{{2, 0, 0}, {2, 2, 0}}, {}, 0, {}},
      c2{{{2, 2, 0}, {1, 3, 1}, {0, 2, 0}}, {1, 2, 1}, 0, {}}, c3{{{0, 2, 0}, {0, 0, 0}}, {}, 0, {}};
  const Made made(CoonsShape{{{c0, c1, c2, c3}}, Fill::none, {r("0.02"), {}}});
  const auto at = [](const CurveNet& net, const Rational& t) { return curve_pieces(net, "test")[0].at(t); };
  each_corner(made, {}, [&](std::uint32_t, const PatchCorner& c) {
    const auto& [u, v] = c.at;
    const RationalPoint low = at(c0, u), high = at(c2, 1 - u), left = at(c3, 1 - v), right = at(c1, v);
    const RationalPoint corners =
        (1 - v) * ((1 - u) * at(c0, 0) + u * at(c0, 1)) + v * ((1 - u) * at(c2, 1) + u * at(c2, 0));
    REQUIRE(c.point == (1 - v) * low + v * high + (1 - u) * left + u * right - corners);
  });
  check_edges(made, {});
  CHECK(made.parameters->patch_name(0) == "coons patch");
}

TEST_CASE("vertices of spheres, cylinders, cones and tori are their formulas at the parameters") {
  const auto cosine = [](const Rational& turns) { return from_double(cosine_degrees(360 * turns)); };
  const auto sine = [](const Rational& turns) { return from_double(sine_degrees(360 * turns)); };
  const auto rounded = [](const RationalPoint& p) -> RationalPoint {
    return {from_double(to_double(p[0])), from_double(to_double(p[1])), from_double(to_double(p[2]))};
  };
  SECTION("sphere: longitude 360 u, latitude 180 v - 90 degrees") {
    const RationalPoint center{1, 2, 3};
    const Rational radius = r("0.7");
    const Made made(SphereShape{center, radius, 14, 9});
    each_corner(made, {}, [&](std::uint32_t, const PatchCorner& c) {
      const Rational latitude = c.at[1] / 2 - Rational(1, 4), out = radius * cosine(latitude);
      const RationalPoint z{0, 0, radius * sine(latitude)};
      const RationalPoint p = center + RationalPoint{out * cosine(c.at[0]), out * sine(c.at[0]), 0} + z;
      // The poles are exact, all else rounded.
      REQUIRE(c.point == (c.at[1] == 0 || c.at[1] == 1 ? p : rounded(p)));
    });
    check_edges(made, {0});
    CHECK(made.parameters->patch_name(0) == "sphere");
  }
  SECTION("cylinders and cones: angle 360 u, v along the axis") {
    for (const RationalPoint& axis : {RationalPoint{0, 0, 2}, RationalPoint{1, -2, 3}}) {
      for (const char* top : {"3", "1", "0"}) {
        const RationalPoint from{1, 0, 0};
        const Made made(ConeShape{from, from + axis, 3, r(top), 10});
        const CircleFrame frame(axis);
        each_corner(made, {0, 1}, [&](std::uint32_t patch, const PatchCorner& c) {
          CHECK(patch == 2);
          const auto& [u, v] = c.at;
          REQUIRE((v == 0 || v == 1));
          // A cylinder's upper circle is the lower one, moved.
          const Rational radius = v == 0 || r(top) == 3 ? Rational(3) : r(top);
          RationalPoint p = from + (radius == 0 ? RationalPoint{0, 0, 0} : frame.offset(radius, 360 * u));
          const RationalPoint moved = v == 1 ? axis : RationalPoint{0, 0, 0};
          const bool straight = frame.parallel_to() < 3;
          if (radius != 0 && straight) p = rounded(p);
          REQUIRE(c.point == p + moved);
          // As far from the axis as it should be.
          const RationalPoint off = c.point - from - v * axis;
          CHECK(std::abs(std::sqrt(to_double(dot(off, off))) - to_double(radius)) < 4e-15);
        });
        check_edges(made, {0});
        CHECK(made.parameters->patch_name(2) == (r(top) == 3 ? "cylinder side" : "cone side"));
        CHECK(made.parameters->patch_name(0) == (r(top) == 3 ? "cylinder bottom" : "cone bottom"));
      }
    }
  }
  SECTION("torus: 360 u about the axis, 360 v about the tube") {
    const Made made(TorusShape{{0, 0, 1}, {0, 0, 1}, 3, r("0.8"), 9, 7});
    each_corner(made, {}, [&](std::uint32_t, const PatchCorner& c) {
      const RationalPoint direction = CircleFrame({0, 0, 1}).offset(1, 360 * c.at[0]);
      const Rational out = 3 + r("0.8") * cosine(c.at[1]);
      REQUIRE(c.point == rounded(RationalPoint{0, 0, 1 + r("0.8") * sine(c.at[1])} + out * direction));
    });
    check_edges(made, {0, 1});
  }
}

TEST_CASE("vertices of sweeps are the profile at u, moved by v") {
  const CurveNet bend{{{1, 0, 0}, {2, 0, 1}, {1, 0, 2}}, {1, 2, 1}, 0, {}}, top{{{1, 0, 2}, {0, 0, 2}}, {}, 0, {}},
      axis{{{0, 0, 2}, {0, 0, 0}}, {}, 0, {}}, bottom{{{0, 0, 0}, {1, 0, 0}}, {}, 0, {}};
  const auto backward = [](CurveNet net) {
    std::reverse(net.points.begin(), net.points.end());
    std::reverse(net.weights.begin(), net.weights.end());
    return net;
  };
  for (const bool turned : {false, true}) {
    std::vector<CurveNet> segments{bottom, bend, top, axis};
    if (turned) segments = {backward(axis), backward(top), backward(bend), backward(bottom)};
    const auto at = [&](std::size_t segment, const Rational& t) {
      return curve_pieces(segments[segment], "test")[0].at(t);
    };
    for (const char* degrees : {"360", "100"}) {
      RevolveShape shape{{{{segments}}, true}, {0, 0, 5}, {0, 0, 1}, r(degrees), {r("0.1"), {}}};
      const Made made(shape);
      const std::uint32_t first = shape.degrees == 360 ? 0 : 2;
      each_corner(made, first == 0 ? std::set<std::uint32_t>{} : std::set<std::uint32_t>{0, 1},
                  [&](std::uint32_t patch, const PatchCorner& c) {
                    const RationalPoint p = at(patch - first, c.at[0]);
                    const CircleFrame frame(shape.axis);
                    const RationalPoint d = first != 0 && c.at[1] == 1 ? frame.turned(shape.degrees)
                                                                       : frame.offset(1, shape.degrees * c.at[1]);
                    REQUIRE(c.point == shape.center + p[0] * d + RationalPoint{0, 0, p[2]});
                  });
      check_edges(made, shape.degrees == 360 ? std::set<std::size_t>{1} : std::set<std::size_t>{});
      CHECK(made.parameters->patch_name(first + 1) == "revolve segment 2");
    }
    const SweepShape sweep{{{{segments}}, true}, {{0, 0, 0}, {0, 3, 0}}, {}, {r("0.1"), {}}};
    each_corner(Made(sweep), {1, 2, 3, 4, 5}, [&](std::uint32_t, const PatchCorner& c) {
      const RationalPoint along = c.at[1] * RationalPoint{0, 3, 0};
      const BezierCurve curve = curve_pieces(bend, "test")[0];
      REQUIRE((c.point == curve.at(c.at[0]) + along || c.point == curve.at(1 - c.at[0]) + along));
    });
    ExtrudeShape shape{{{{segments}}, true}, {0, 3, 1}, 0, 1, {}, {r("0.1"), {}}};
    each_corner(Made(shape), {0, 1}, [&](std::uint32_t patch, const PatchCorner& c) {
      REQUIRE(c.point == at(patch - 2, c.at[0]) + c.at[1] * shape.vector);
    });
    shape.vector = {0, 3, 0};
    shape.scale = 0;
    shape.center = RationalPoint{r("1/2"), 0, 1};
    const Made pointed(shape);
    each_corner(pointed, {0}, [&](std::uint32_t patch, const PatchCorner& c) {
      const RationalPoint p = at(patch - 2, c.at[0]);
      REQUIRE(c.point == *shape.center + (1 - c.at[1]) * (p - *shape.center) + c.at[1] * shape.vector);
    });
    check_edges(pointed, {});
    // Turned: each section is the profile turned by v * twist; those between the ends are rounded.
    shape.scale = 2;
    shape.twist = 80;
    const Made twisted(shape);
    each_corner(twisted, {0, 1}, [&](std::uint32_t patch, const PatchCorner& c) {
      const RationalPoint p = at(patch - 2, c.at[0]);
      const Transform turn = Transform::rotation(shape.vector, c.at[1] * 80, *shape.center);
      const RationalPoint exact =
          turn.apply(*shape.center + (1 + c.at[1]) * (p - *shape.center)) + c.at[1] * shape.vector;
      for (std::size_t k = 0; k < 3; ++k) CHECK(abs(Rational(c.point[k] - exact[k])) < r("1e-15"));
    });
    check_edges(twisted, {});
  }
}

TEST_CASE("a solid that is turned outward has the parameters of its patches") {
  // A tetrahedron of four bilinear patches with one side a point, faces inward.
  const RationalPoint a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  const auto patch = [](const RationalPoint& p, const RationalPoint& q, const RationalPoint& s) {
    return PatchNet{{{p, q}, {s, s}}, {}, {0, 0}, {}};
  };
  const BezierShape shape{{patch(a, b, c), patch(a, d, b), patch(b, d, c), patch(c, d, a)}, {}, Fill::winding, {}};
  const Made made(shape);
  CHECK(volume(made.soup) == Rational(1, 6));
  each_corner(made, {}, [&](std::uint32_t k, const PatchCorner& corner) {
    REQUIRE(by_net(shape.patches[k], corner.at[0], corner.at[1]) == corner.point);
  });
}

TEST_CASE("leaves without curved patches have no parameters") {
  CHECK(!prepare(BoxShape{{0, 0, 0}, {1, 1, 1}})->parameters());
  CHECK(!prepare(PlaneShape{{0, 0, 0}, {0, 0, 1}})->parameters());
}
