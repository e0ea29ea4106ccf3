// A constrained triangulation whose points are vertex ids: CGAL does the combinatorics, our staged predicates
// decide. Parts: the traits class that joins the two; short ways for triangles and quads; the inside by
// parity, walking across the triangulation; and Lawson's flips with an in-circle test that must be proven by
// intervals (an unproven one counts as a tie), so that each flip is a true improvement and the flipping ends.
#include "kernel/exact/triangulate.h"

#include <CGAL/Constrained_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <unordered_map>

#include "kernel/base/error.h"
#include "kernel/base/hypotenuse.h"
#include "kernel/exact/enclosure.h"

namespace cnrg {
namespace {

using Triangle = std::array<VertexId, 3>;
using Edge = std::pair<VertexId, VertexId>;  // smaller id first

Edge edge_of(VertexId a, VertexId b) { return a < b ? Edge{a, b} : Edge{b, a}; }

/// The points of a face in the projection, numbered as they came: ids and bounds of the table are those of one
/// refinement, and triangles are to be those of the face.
class FacePoints {
 public:
  FacePoints(const PointTable& table, Projection axes) : table_(table), axes_(axes) {}
  VertexId number(VertexId in_table) {
    const auto [it, fresh] = number_.try_emplace(in_table, VertexId(in_table_.size()));
    if (fresh) in_table_.push_back(in_table);
    return it->second;
  }
  Projection axes() const { return axes_; }
  VertexId in_table(VertexId p) const { return in_table_[p.index()]; }
  int turn(VertexId a, VertexId b, VertexId c) const {
    return orient2d(table_, axes_, in_table(a), in_table(b), in_table(c));
  }
  int compare(int axis, VertexId a, VertexId b) const {
    return cnrg::compare(table_, axis, in_table(a), in_table(b));
  }

  using Bounds = std::array<std::array<double, 2>, 2>;  // of each axis
  /// Around `bounds`, at the cost of no exact number.
  Bounds outer_bounds(VertexId p) const {
    const PointView view = table_.view(in_table(p));
    Bounds out;
    for (std::size_t k = 0; k < 2; ++k) out[k] = around(view.lo[axis(k)], view.hi[axis(k)]);
    return out;
  }
  /// The doubles next to the exact value, or this, if it is one.
  const Bounds& bounds(VertexId p) {
    bounds_.resize(in_table_.size());
    auto& known = bounds_[p.index()];
    if (!known) known = find_bounds(in_table(p));
    return *known;
  }
  double length(VertexId a, VertexId b) {
    const auto middle = [&](VertexId p, int k) {
      const auto& [low, high] = bounds(p)[static_cast<std::size_t>(k)];
      return low == high ? low : std::nextafter(low, high);
    };
    return hypotenuse(middle(a, 0) - middle(b, 0), middle(a, 1) - middle(b, 1));
  }

 private:
  std::size_t axis(std::size_t k) const { return static_cast<std::size_t>(k == 0 ? axes_.u : axes_.v); }
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static std::array<double, 2> around(double low, double high) {
    if (low == high) return {low, low};
    return {std::nextafter(low, -kInfinity), std::nextafter(high, kInfinity)};
  }
  Bounds find_bounds(VertexId v) const {
    const PointView view = table_.view(v);
    std::optional<RationalPoint> exact;
    Bounds out;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t i = axis(k);
      out[k] = {view.lo[i], view.lo[i]};
      if (view.lo[i] == view.hi[i]) continue;
      if (!exact) exact = table_.rational(v);
      const double near = to_double((*exact)[i]);
      out[k] = {near, near};
      if (from_double(near) != (*exact)[i])
        out[k] = {std::nextafter(near, -kInfinity), std::nextafter(near, kInfinity)};
    }
    return out;
  }

  const PointTable& table_;
  Projection axes_;
  std::unordered_map<VertexId, VertexId> number_;
  std::vector<VertexId> in_table_;
  std::vector<std::optional<Bounds>> bounds_;
};

/// What CGAL's triangulations ask of geometry, answered by our predicates on vertex ids.
struct VertexTraits {
  struct Point_2 {
    VertexId id;
  };
  struct Segment_2 {
    Point_2 a, b;
  };
  struct Triangle_2 {
    Point_2 a, b, c;
  };
  struct Construct_point_2 {
    using result_type = Point_2;
    const Point_2& operator()(const Point_2& p) const { return p; }
  };
  struct Construct_segment_2 {
    Segment_2 operator()(const Point_2& a, const Point_2& b) const { return {a, b}; }
  };
  struct Construct_triangle_2 {
    Triangle_2 operator()(const Point_2& a, const Point_2& b, const Point_2& c) const { return {a, b, c}; }
  };
  struct Compare {
    const FacePoints* plane;
    int axis;
    CGAL::Comparison_result operator()(const Point_2& a, const Point_2& b) const {
      return CGAL::Comparison_result(plane->compare(axis, a.id, b.id));
    }
  };
  struct Less : Compare {
    bool operator()(const Point_2& a, const Point_2& b) const {
      return Compare::operator()(a, b) == CGAL::SMALLER;
    }
  };
  using Compare_x_2 = Compare;
  using Compare_y_2 = Compare;
  using Less_x_2 = Less;
  using Less_y_2 = Less;
  struct Orientation_2 {
    const FacePoints* plane;
    CGAL::Orientation operator()(const Point_2& a, const Point_2& b, const Point_2& c) const {
      return CGAL::Orientation(plane->turn(a.id, b.id, c.id));
    }
  };
  struct Side_of_oriented_circle_2 {  // the triangulation is not a Delaunay one: never asked
    CGAL::Oriented_side operator()(const Point_2&, const Point_2&, const Point_2&, const Point_2&) const {
      return CGAL::ON_ORIENTED_BOUNDARY;
    }
  };

  const FacePoints* plane;
  Construct_point_2 construct_point_2_object() const { return {}; }
  Construct_segment_2 construct_segment_2_object() const { return {}; }
  Construct_triangle_2 construct_triangle_2_object() const { return {}; }
  Compare_x_2 compare_x_2_object() const { return {plane, plane->axes().u}; }
  Compare_y_2 compare_y_2_object() const { return {plane, plane->axes().v}; }
  Less_x_2 less_x_2_object() const { return {{plane, plane->axes().u}}; }
  Less_y_2 less_y_2_object() const { return {{plane, plane->axes().v}}; }
  Orientation_2 orientation_2_object() const { return {plane}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
};

struct FaceMark {
  bool visited = false;
};
/// CGAL's constrained face with our mark: seen by the walk from outside.
template <class Traits, class Base = CGAL::Constrained_triangulation_face_base_2<Traits>>
struct MarkedFace : Base, FaceMark {
  using Base::Base;
  template <class Tds>
  struct Rebind_TDS {
    using Other = MarkedFace<Traits, typename Base::template Rebind_TDS<Tds>::Other>;
  };
};

using Tds = CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<VertexTraits>,
                                                 MarkedFace<VertexTraits>>;
using Triangulation = CGAL::Constrained_triangulation_2<VertexTraits, Tds, CGAL::No_constraint_intersection_tag>;

/// True if the last point certainly lies inside the circle through the counter-clockwise a, b, c: as `bounds` of
/// the four say.
bool certainly_in_circle(FacePoints& points, const Triangle& t, VertexId d) {
  using enclosure::Interval;
  const auto determinant = [&](const auto& bounds_of) {
    const FacePoints::Bounds bounds[4] = {bounds_of(t[0]), bounds_of(t[1]), bounds_of(t[2]), bounds_of(d)};
    enclosure::RoundOutward rounding;
    constexpr std::size_t u = 0, v = 1;
    const auto at = [&](int i, std::size_t axis) { return Interval(bounds[i][axis][0], bounds[i][axis][1]); };
    const Interval du = at(3, u), dv = at(3, v);
    const Interval au = at(0, u) - du, av = at(0, v) - dv, bu = at(1, u) - du, bv = at(1, v) - dv;
    const Interval cu = at(2, u) - du, cv = at(2, v) - dv;
    const Interval lift_a = au * au + av * av, lift_b = bu * bu + bv * bv, lift_c = cu * cu + cv * cv;
    return lift_a * (bu * cv - bv * cu) - lift_b * (au * cv - av * cu) + lift_c * (au * bv - av * bu);
  };
  const Interval wide = determinant([&](VertexId p) { return points.outer_bounds(p); });
  if (wide.inf() > 0 || wide.sup() <= 0) return wide.inf() > 0;  // that of less wide bounds lies in it
  return determinant([&](VertexId p) { return points.bounds(p); }).inf() > 0;
}

/// Lawson's flips over the edges that are not in `walked`. Corners of a circle that are rounded lie on no circle,
/// and may ask for the square of their number of flips, each of which improves nothing that can be seen: so there
/// is a bound, far above what other shapes need.
template <class IsBetter>
void flip(const std::map<Edge, unsigned>& walked, std::vector<Triangle>& triangles, const IsBetter& is_better) {
  struct Sides {
    std::uint32_t side[2] = {UINT32_MAX, UINT32_MAX};
  };
  struct Hash {
    std::size_t operator()(const Edge& e) const {
      return static_cast<std::size_t>((std::uint64_t{e.first.value()} << 32 | e.second.value()) *
                                      0x9e3779b97f4a7c15ull);
    }
  };
  std::unordered_map<Edge, Sides, Hash> sides;
  std::vector<Edge> stack;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const Edge e = edge_of(triangles[i][k], triangles[i][(k + 1) % 3]);
      Sides& s = sides[e];
      if (s.side[0] == UINT32_MAX) {
        s.side[0] = i;
      } else {
        s.side[1] = i;
        if (!walked.contains(e)) stack.push_back(e);
      }
    }
  }
  const auto apex = [&](std::uint32_t i, const Edge& e) {
    for (const VertexId v : triangles[i]) {
      if (v != e.first && v != e.second) return v;
    }
    return VertexId::none();
  };
  const auto replace_side = [&](VertexId a, VertexId b, std::uint32_t from, std::uint32_t to) {
    Sides& s = sides[edge_of(a, b)];
    s.side[s.side[0] == from ? 0 : 1] = to;
  };
  constexpr std::size_t kFlipsPerTriangle = 16;
  for (std::size_t flips = 0; !stack.empty() && flips < kFlipsPerTriangle * triangles.size();) {
    const Edge e = stack.back();
    stack.pop_back();
    const auto found = sides.find(e);
    if (found == sides.end()) continue;  // flipped away
    const auto [i, j] = found->second.side;
    const VertexId p = apex(i, e), q = apex(j, e);
    // Triangle i is (p, a, b), triangle j is (q, b, a), both counter-clockwise.
    const int k = int(std::find(triangles[i].begin(), triangles[i].end(), p) - triangles[i].begin());
    const VertexId a = triangles[i][(k + 1) % 3], b = triangles[i][(k + 2) % 3];
    if (!is_better(p, a, q, b)) continue;
    ++flips;
    triangles[i] = {p, a, q};
    triangles[j] = {q, b, p};
    sides.erase(found);
    sides[edge_of(p, q)] = {{i, j}};
    replace_side(a, q, j, i);
    replace_side(b, p, i, j);
    for (const Edge& next : {edge_of(p, a), edge_of(a, q), edge_of(q, b), edge_of(b, p)}) {
      if (!walked.contains(next)) stack.push_back(next);
    }
  }
}

std::map<Edge, unsigned> walked_edges(std::span<const std::vector<VertexId>> loops) {
  std::map<Edge, unsigned> walked;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) ++walked[edge_of(loop[i], loop[(i + 1) % loop.size()])];
  return walked;
}

/// Two triangles of a quad, or none if neither diagonal works; of two that work the Delaunay one, or the shorter
/// one.
std::vector<Triangle> split_quad(FacePoints& points, const std::array<VertexId, 4>& q) {
  const auto split = [&](std::size_t k) {
    return std::array<Triangle, 2>{{{q[k], q[k + 1], q[k + 2]}, {q[k], q[k + 2], q[(k + 3) % 4]}}};
  };
  const auto fits = [&](const std::array<Triangle, 2>& s) {
    return points.turn(s[0][0], s[0][1], s[0][2]) > 0 && points.turn(s[1][0], s[1][1], s[1][2]) > 0;
  };
  const auto first = split(0), second = split(1);
  const bool first_fits = fits(first), second_fits = fits(second);
  if (!first_fits && !second_fits) return {};
  const auto take_first = [&] {
    if (!first_fits || !second_fits) return first_fits;
    if (certainly_in_circle(points, first[0], q[3])) return false;
    if (certainly_in_circle(points, second[0], q[0])) return true;
    return points.length(q[0], q[2]) <= points.length(q[1], q[3]);
  };
  const auto& chosen = take_first() ? first : second;
  return {chosen.begin(), chosen.end()};
}

/// Triangles that a walk from infinity reaches through an odd number of odd edges.
std::vector<Triangle> inside(Triangulation& t, const std::map<Edge, unsigned>& walked) {
  std::vector<Triangle> result;
  std::vector<std::pair<Triangulation::Face_handle, bool>> stack{{t.infinite_face(), false}};
  t.infinite_face()->visited = true;
  while (!stack.empty()) {
    const auto [face, is_inside] = stack.back();
    stack.pop_back();
    if (is_inside) {
      require(!t.is_infinite(face), "triangulate: the loops of a face are not closed");
      result.push_back({face->vertex(0)->point().id, face->vertex(1)->point().id, face->vertex(2)->point().id});
    }
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->visited) continue;
      bool crosses = false;
      if (face->is_constrained(i)) {
        const auto found = walked.find(edge_of(face->vertex(Triangulation::ccw(i))->point().id,
                                               face->vertex(Triangulation::cw(i))->point().id));
        require(found != walked.end(), "triangulate: a point of a face lies inside of one of its edges");
        crosses = found->second % 2 == 1;
      }
      next->visited = true;
      stack.push_back({next, is_inside != crosses});
    }
  }
  return result;
}

std::vector<Triangle> general(FacePoints& points, std::span<const std::vector<VertexId>> loops,
                              std::span<const VertexId> isolated) {
  Triangulation t{VertexTraits{&points}};
  std::unordered_map<VertexId, Triangulation::Vertex_handle> handles;
  Triangulation::Face_handle hint;
  const auto insert = [&](VertexId v) {
    auto& handle = handles[v];
    if (handle != Triangulation::Vertex_handle()) return handle;
    handle = t.insert({v}, hint);
    require(handle->point().id == v, "triangulate: two vertices of a face coincide");
    hint = handle->face();
    return handle;
  };
  for (const auto& loop : loops)
    for (const VertexId v : loop) insert(v);
  const std::map<Edge, unsigned> walked = walked_edges(loops);
  for (const VertexId v : isolated) insert(v);
  try {
    for (const auto& [edge, count] : walked) t.insert_constraint(handles.at(edge.first), handles.at(edge.second));
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    throw InvariantError("triangulate: edges of a face cross");
  }
  if (t.dimension() < 2) return {};
  std::vector<Triangle> triangles = inside(t, walked);
  flip(walked, triangles, [&](VertexId p, VertexId a, VertexId q, VertexId b) {
    return certainly_in_circle(points, {p, a, b}, q);
  });
  return triangles;
}

}  // namespace

std::vector<Triangle> triangulate(const PointTable& table, Projection axes,
                                  std::span<const std::vector<VertexId>> loops,
                                  std::span<const VertexId> isolated) {
  FacePoints points(table, axes);
  std::vector<Triangle> triangles;
  if (loops.size() == 1 && isolated.empty() && (loops[0].size() == 3 || loops[0].size() == 4)) {
    const auto& loop = loops[0];
    if (loop.size() == 3) {
      const int turn = orient2d(table, axes, loop[0], loop[1], loop[2]);
      if (turn > 0) return {{loop[0], loop[1], loop[2]}};
      if (turn < 0) return {{loop[0], loop[2], loop[1]}};
    } else {
      std::array<VertexId, 4> quad;
      for (std::size_t i = 0; i < 4; ++i) quad[i] = points.number(loop[i]);
      triangles = split_quad(points, quad);
      std::reverse(quad.begin(), quad.end());
      if (triangles.empty()) triangles = split_quad(points, quad);
    }
  }
  if (triangles.empty()) {
    std::vector<std::vector<VertexId>> walks(loops.begin(), loops.end());
    std::vector<VertexId> inner(isolated.begin(), isolated.end());
    for (auto& walk : walks) {
      for (VertexId& v : walk) v = points.number(v);
    }
    for (VertexId& v : inner) v = points.number(v);
    triangles = general(points, walks, inner);
  }
  for (Triangle& t : triangles) {
    for (VertexId& p : t) p = points.in_table(p);
  }
  return triangles;
}

void flip_edges(std::vector<Triangle>& triangles, std::span<const std::vector<VertexId>> loops,
                const std::function<bool(VertexId, VertexId, VertexId, VertexId)>& is_better) {
  flip(walked_edges(loops), triangles, is_better);
}

}  // namespace cnrg
