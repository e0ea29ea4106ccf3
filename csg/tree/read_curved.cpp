// Numbers and their counts are checked here, where their place is known; what a shape means is checked by
// `prepare`.
#include "csg/tree/read_curved.h"

#include <map>
#include <optional>

#include "csg/curves/boundary_curves.h"
#include "csg/curves/control_nets.h"

namespace cnrg {
namespace {

/// Positive numbers, `count` of them.
std::vector<Rational> read_weights(const Value& value, const std::string& what, std::size_t count) {
  std::vector<Rational> result;
  for (const Value& w : value.list(what, "a list of positive numbers")) {
    result.push_back(w.number(what));
    if (result.back() <= 0) w.fail(what + ": a weight must be positive");
  }
  if (result.size() != count) {
    value.fail(what + ": there are " + std::to_string(count) + " control points and " +
               std::to_string(result.size()) + " weights; give one weight for each point");
  }
  return result;
}

int read_degree(const Value& value, const std::string& what, std::size_t points) {
  const int degree = static_cast<int>(value.integer(what, 1, kMostDegree));
  if (points < static_cast<std::size_t>(degree) + 1) {
    value.fail(what + ": degree " + std::to_string(degree) + " takes at least " + std::to_string(degree + 1) +
               " control points, there are " + std::to_string(points) + "; add points or lower the degree");
  }
  return degree;
}

std::vector<Rational> read_knots(const Value& value, const std::string& what, std::size_t points, int degree) {
  std::vector<Rational> knots;
  for (const Value& k : value.list(what, "a list of numbers that ascend")) {
    knots.push_back(k.number(what));
    if (knots.size() > 1 && knots.back() < knots[knots.size() - 2]) {
      k.fail(what + ": this knot is less than the one before it; give knots that ascend");
    }
  }
  const std::size_t wanted = points + static_cast<std::size_t>(degree) + 1;
  if (knots.size() != wanted) {
    value.fail(what + ": " + std::to_string(points) + " control points of degree " + std::to_string(degree) +
               " take " + std::to_string(wanted) + " knots, not " + std::to_string(knots.size()) +
               "; give points + degree + 1");
  }
  return knots;
}

/// A list of control points, or a map with weights (and, of a spline, degree and knots).
CurveNet read_curve(const Value& value, const std::string& what, bool spline) {
  CurveNet net;
  if (!value.is_map() && !spline) {
    net.points = value.points(what);
    return net;
  }
  const Fields f(value, form(spline ? "spline curve" : "curve"), what);
  f.read("points", net.points);
  if (const Value* weights = f.find("weights")) {
    net.weights = read_weights(*weights, f.name("weights"), net.points.size());
  }
  if (!spline) return net;
  net.degree = read_degree(f.at("degree"), f.name("degree"), net.points.size());
  if (const Value* knots = f.find("knots")) {
    net.knots = read_knots(*knots, f.name("knots"), net.points.size(), net.degree);
  }
  return net;
}

/// A list of rows, or a map likewise.
PatchNet read_patch(const Value& value, const std::string& what, bool spline) {
  PatchNet net;
  const auto read_points = [&](const Value& rows, const std::string& name) {
    for (const Value& row : rows.list(name, "a list of rows [[[x, y, z], ...], ...]")) {
      net.points.push_back(row.points("each row of " + name));
      if (net.points.back().size() != net.points[0].size()) {
        row.fail("this row has " + std::to_string(net.points.back().size()) +
                 " control points and the first has " + std::to_string(net.points[0].size()) +
                 "; all rows must be equally long");
      }
    }
    if (net.points.size() < 2 || net.points[0].size() < 2)
      rows.fail(name + ": give at least two rows of two points");
  };
  if (!value.is_map() && !spline) {
    read_points(value, what);
    return net;
  }
  const Fields f(value, form(spline ? "spline patch" : "patch"), what);
  read_points(f.at("points"), f.name("points"));
  if (const Value* weights = f.find("weights")) {
    const std::vector<Value> rows = weights->list(f.name("weights"), "a list of rows [[w, ...], ...]");
    if (rows.size() != net.points.size()) {
      weights->fail(f.name("weights") + ": there are " + std::to_string(net.points.size()) +
                    " rows of control points and " + std::to_string(rows.size()) +
                    " of weights; give one for each");
    }
    for (const Value& row : rows) {
      net.weights.push_back(read_weights(row, "each row of " + f.name("weights"), net.points[0].size()));
    }
  }
  if (!spline) return net;
  const std::size_t count[] = {net.points[0].size(), net.points.size()};
  const std::vector<Value> degree = f.at("degree").list(f.name("degree"), "a list of two degrees [u, v]");
  if (degree.size() != 2) f.at("degree").fail_type(f.name("degree"), "a list of two degrees [u, v]");
  for (std::size_t k = 0; k < 2; ++k) net.degree[k] = read_degree(degree[k], f.name("degree"), count[k]);
  if (const Value* knots = f.find("knots")) {
    const std::vector<Value> both = knots->list(f.name("knots"), "two lists of knots [[...], [...]]");
    if (both.size() != 2) knots->fail_type(f.name("knots"), "two lists of knots [[...], [...]]");
    for (std::size_t k = 0; k < 2; ++k) {
      net.knots[k] = read_knots(both[k], f.name("knots"), count[k], net.degree[k]);
    }
  }
  return net;
}

/// One value under `one`, or a list of them under `many`.
template <class Read>
void read_each(const Fields& f, const char* one, const char* many, Read read) {
  if (const Value* value = f.find(one)) read(*value, f.name(one));
  f.each(many, [&](const Value& value) { read(value, "each of " + f.name(many)); });
}

Shape read_nets(const Value& value, const char* name, bool spline) {
  const Fields f(value, form(name));
  BezierShape shape;
  shape.is_spline = spline;
  read_each(f, "patch", "patches", [&](const Value& v, const std::string& what) {
    shape.patches.push_back(read_patch(v, what, spline));
  });
  read_each(f, "curve", "curves",
            [&](const Value& v, const std::string& what) { shape.curves.push_back(read_curve(v, what, spline)); });
  if (shape.patches.empty() && shape.curves.empty())
    value.fail(std::string(name) + " is empty; add a patch or a curve");
  if (f.has("fill")) shape.fill = read_fill(f);
  shape.tessellation = read_tessellation(f);
  return shape;
}

/// A point of a profile: three numbers, or of a revolution two, r and z.
RationalPoint read_profile_point(const Value& value, const std::string& what, bool plane) {
  if (!plane) return value.point("each point of " + what);
  const std::array<Rational, 2> rz = value.pair("each point of " + what);
  return {rz[0], 0, rz[1]};
}

ProfileLine read_line(const Value& value, const std::string& what, bool plane, bool closed) {
  const std::vector<Value> items =
      value.list(what, std::string("a list of corners ") + (plane ? "[[r, z], ...]" : "[[x, y, z], ...]"));
  ProfileLine line;
  std::optional<RationalPoint> last;
  const Value* curve = nullptr;
  const auto corner = [&](const RationalPoint& p) {
    if (last) {
      CurveNet& net = line.segments.emplace_back();
      net.points.push_back(*last);
      if (curve) {
        const Fields f(*curve, form(plane ? "curve of a flat line" : "curve of a line"), "a curve of " + what);
        f.each("bezier",
               [&](const Value& q) { net.points.push_back(read_profile_point(q, f.name("bezier"), plane)); });
        if (const Value* weights = f.find("weights")) {
          net.weights = read_weights(*weights, f.name("weights"), net.points.size() + 1);
        }
      }
      net.points.push_back(p);
    }
    last = p;
    curve = nullptr;
  };
  std::optional<RationalPoint> first;
  for (const Value& item : items) {
    if (item.is_map()) {
      if (!last) item.fail("a curve stands between two corners; begin with a corner");
      if (curve) item.fail("two curves follow each other; give the corner between them");
      curve = &item;
      continue;
    }
    corner(read_profile_point(item, what, plane));
    if (!first) first = last;
  }
  if (!first) value.fail(what + " is empty; give its corners");
  if (closed) corner(*first);
  else if (curve) curve->fail("a curve stands between two corners; end with a corner");
  if (line.segments.size() < (closed ? 2u : 1u)) value.fail(what + ": give at least two corners");
  return line;
}

/// A closed profile, which `what` names.
Profile read_closed(const Value& value, const std::string& what, bool plane) {
  Profile profile;
  if (!value.is_map()) {
    profile.lines.push_back(read_line(value, what, plane, true));
    return profile;
  }
  const Fields parts(value, form(plane ? "flat profile" : "profile"), what);
  profile.lines.push_back(read_line(parts.at("outer"), parts.name("outer"), plane, true));
  parts.each("holes", [&](const Value& hole) {
    profile.lines.push_back(read_line(hole, "each of " + parts.name("holes"), plane, true));
  });
  return profile;
}

Profile read_profile(const Fields& f, bool plane) {
  if (f.has("profile")) return read_closed(f.at("profile"), f.name("profile"), plane);
  return {{read_line(f.at("curve"), f.name("curve"), plane, false)}, false};
}

}  // namespace

Tessellation read_tessellation(const Fields& f) {
  Tessellation result;
  f.read("chord", result.chord, "segments", result.segments);
  if (result.chord && *result.chord <= 0) f.at("chord").fail(f.name("chord") + " must be a positive length");
  return result;
}

Fill read_fill(const Fields& f) {
  static const std::map<std::string, Fill> kFills{{"winding", Fill::winding},
                                                  {"parity", Fill::parity},
                                                  {"cells", Fill::cells},
                                                  {"solids", Fill::solids},
                                                  {"none", Fill::none}};
  std::string name;
  f.read("fill", name);
  return kFills.at(name);
}

Shape read_bezier(const Value& value, const LeafContext&) { return read_nets(value, "bezier", false); }

Shape read_bspline(const Value& value, const LeafContext&) { return read_nets(value, "bspline", true); }

Shape read_coons(const Value& value, const LeafContext&) {
  const Fields f(value, form("coons"));
  CoonsShape shape;
  read_each(f, "patch", "patches", [&](const Value& v, const std::string& what) {
    const std::vector<Value> curves = v.list(what, "a list of four curves that go round");
    if (curves.size() != 4) v.fail_type(what, "a list of four curves that go round");
    auto& round = shape.patches.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) round[k] = read_curve(curves[k], "each curve of coons", false);
  });
  if (shape.patches.empty()) value.fail("coons is empty; add a patch");
  if (f.has("fill")) shape.fill = read_fill(f);
  shape.tessellation = read_tessellation(f);
  return shape;
}

Shape read_extrude(const Value& value, const LeafContext&) {
  const Fields f(value, form("extrude"));
  ExtrudeShape shape;
  shape.profile = read_profile(f, false);
  f.read("vector", shape.vector, "twist", shape.twist, "scale", shape.scale, "center", shape.center);
  if (shape.scale < 0) f.at("scale").fail(f.name("scale") + " must be 0 or more");
  shape.tessellation = read_tessellation(f);
  return shape;
}

Shape read_sweep(const Value& value, const LeafContext&) {
  const Fields f(value, form("sweep"));
  SweepShape shape;
  shape.profile = read_profile(f, false);
  f.read("path", shape.path, "radius", shape.radius);
  if (shape.radius && *shape.radius <= 0) f.at("radius").fail(f.name("radius") + " must be a positive length");
  shape.tessellation = read_tessellation(f);
  return shape;
}

Shape read_loft(const Value& value, const LeafContext&) {
  const Fields f(value, form("loft"));
  LoftShape shape;
  f.each("profiles", [&](const Value& profile) {
    shape.profiles.push_back(read_closed(profile, "each of " + f.name("profiles"), false));
  });
  if (shape.profiles.size() < 2) f.at("profiles").fail_type(f.name("profiles"), "a list of two profiles or more");
  shape.tessellation = read_tessellation(f);
  return shape;
}

Shape read_revolve(const Value& value, const LeafContext&) {
  const Fields f(value, form("revolve"));
  RevolveShape shape;
  shape.profile = read_profile(f, true);
  f.read("center", shape.center, "axis", shape.axis, "degrees", shape.degrees);
  if (shape.degrees <= 0 || shape.degrees > 360)
    f.at("degrees").fail(f.name("degrees") + " must be more than 0 and at most 360");
  shape.tessellation = read_tessellation(f);
  return shape;
}

}  // namespace cnrg
