// A mesh leaf: points merged, faces cleaned and made planar, its fill decided, coplanar faces joined.
//
// Polygons with more than three corners stay polygons where all corners lie on one plane exactly. Others are cut
// into triangles: ears are clipped in the order of the file, the first corner last, in a projection along the
// largest component of the polygon's normal; so a convex quadrilateral 0 1 2 3 becomes 0 1 2 and 0 2 3. The choice
// depends on the polygon alone, in IEEE arithmetic without contraction: it is the same everywhere.
//
// Faces of zero area take part in deciding whether the mesh is closed, since their own boundary is zero in space
// (they sew T-junctions), and are left out afterwards.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "csg/geometry/mesh_boundary.h"
#include "csg/imports/mesh_file.h"
#include "csg/imports/mesh_points.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/prepare_shapes.h"
#include "csg/weld/weld.h"
#include "kernel/base/counts.h"
#include "kernel/base/error.h"
#include "kernel/base/union_find.h"
#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// The polygons of a mesh as input of the weld, and what it made.
struct MeshWeld {
  WeldModel model;  ///< before it
  Weld made;
};

/// Moves the points of the mesh. Polygons may lose corners, or all of their area. `name` is for messages.
MeshWeld weld_mesh(MeshData& data, const std::string& name, const Rational& d, bool only_planes) {
  MeshWeld result;
  WeldModel& model = result.model;
  model.only_planes = only_planes;
  auto next_exact = data.exact.begin();
  for (std::uint32_t i = 0; i < data.point_count(); ++i) {
    const double* const p = data.xyz.data() + 3 * std::size_t{i};
    if (next_exact != data.exact.end() && next_exact->first == i) model.points.push_back((next_exact++)->second);
    else model.points.push_back({from_double(p[0]), from_double(p[1]), from_double(p[2])});
  }
  for (std::uint32_t f = 0; f < data.face_count(); ++f) {
    model.faces.push_back({.may_vanish = true});
    model.facets.push_back(
        {f, {{data.corners.begin() + data.offsets[f], data.corners.begin() + data.offsets[f + 1]}}});
  }
  model.subject = name + ": ";
  model.face_name = [](std::uint32_t f) { return "face " + std::to_string(f); };
  result.made = weld(model, d);
  if (!result.made.changed()) return result;
  data.exact.clear();
  for (std::uint32_t i = 0; i < data.point_count(); ++i) {
    const RationalPoint& p = result.made.points[i];
    for (std::size_t k = 0; k < 3; ++k) data.xyz[3 * std::size_t{i} + k] = to_double(p[k]);
    if (!std::all_of(p.begin(), p.end(), [](const Rational& x) { return is_double(x); }))
      data.exact.emplace_back(i, p);
  }
  return result;
}

/// Throws InputError if polygons that are closed now have other signs of volume than before.
void check_volume(const MeshWeld& weld, const Rational& d) {
  WeldModel::Solid solid{"the solid", {}};
  for (std::uint32_t f = 0; f < weld.model.facets.size(); ++f) solid.facets.emplace_back(f, true);
  check_solid(weld.model, solid, weld.made.points, d);
}

using Polygon = std::vector<std::uint32_t>;

/// Three corners of a face that are not collinear; none for a face of zero area.
struct Frame3 {
  std::uint32_t a = 0, b = 0, c = 0;
  bool flat = true;  ///< of zero area
};

class MeshLeaf {
 public:
  explicit MeshLeaf(const MeshShape& shape)
      : shape_(shape),
        name_(shape.data ? "mesh" : "mesh '" + shape.file + "'"),
        within_(shape.weld ? shape.weld : shape.fit),
        own_(!shape.data ? read_mesh(shape.file, shape.decimal, shape.inside)
             : within_   ? *shape.data
                         : MeshData()),
        weld_(within_ ? weld_mesh(own_, name_, *within_, shape.fit.has_value()) : MeshWeld()),
        data_(shape.data && !within_ ? *shape.data : own_),
        points_(data_) {}

  std::unique_ptr<PreparedLeaf> prepare() {
    if (data_.face_count() == 0 && data_.wires.empty() && data_.points.empty()) {
      throw InputError(
          name_ + " has no faces" +
          (data_.point_count() > 0 ? ", only points: give them as a leaf `points`" : ": write the mesh again"));
    }
    collect_faces();
    const SideTable sides = side_table();
    const Fill fill = decide_fill(sides);
    if (weld_.made.changed() && fill == Fill::winding) check_volume(weld_, *within_);
    const std::vector<std::uint32_t> leaf_faces = join_coplanar(sides);
    note_changes();
    if (fill == Fill::winding && is_inside_out()) {
      notices_.push_back(name_ +
                         ": its faces look inward; it is taken as the solid that they enclose: turn the "
                         "faces around");
    }
    return build(fill, leaf_faces);
  }

 private:
  void collect_faces() {
    corners_.reserve(data_.corners.size());
    offsets_.reserve(data_.face_count() + 1);
    Polygon polygon;
    for (std::size_t f = 0; f < data_.face_count(); ++f) {
      polygon.clear();
      for (std::size_t i = data_.offsets[f]; i < data_.offsets[f + 1]; ++i) {
        const std::uint32_t p = points_.number(data_.corners[i]);
        if (polygon.empty() || polygon.back() != p) polygon.push_back(p);
      }
      while (polygon.size() > 1 && polygon.back() == polygon.front()) polygon.pop_back();
      if (polygon.size() != data_.offsets[f + 1] - data_.offsets[f]) ++repeated_;
      const std::size_t corners = polygon.size() > 3 ? distinct(polygon) : polygon.size();
      if (corners < 3) {
        ++collapsed_;
        continue;
      }
      const std::uint32_t group = data_.groups.empty() ? 0 : data_.groups[f];
      const bool thread = corners < polygon.size() && is_thread(polygon);
      const Frame3 frame = thread ? Frame3() : frame_of(polygon);
      if (frame.flat || polygon.size() == 3 || planar(polygon, frame)) {
        add_face(polygon, frame, group);
        continue;
      }
      ++cut_;
      for (const Polygon& triangle : triangulate(polygon)) add_face(triangle, frame_of(triangle), group);
    }
  }

  static std::size_t distinct(Polygon polygon) {
    std::sort(polygon.begin(), polygon.end());
    return static_cast<std::size_t>(std::unique(polygon.begin(), polygon.end()) - polygon.begin());
  }

  /// True for a walk that goes back all the way that it came: a thread, which encloses nothing.
  static bool is_thread(const Polygon& polygon) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::uint32_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      passes[std::minmax(a, b)] += a < b ? 1 : -1;
    }
    return std::all_of(passes.begin(), passes.end(), [](const auto& side) { return side.second == 0; });
  }

  Frame3 frame_of(const Polygon& polygon) const {
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      if (!points_.collinear(polygon[0], polygon[1], polygon[i]))
        return {polygon[0], polygon[1], polygon[i], false};
    }
    return {};
  }

  bool planar(const Polygon& polygon, const Frame3& frame) const {
    return std::all_of(polygon.begin(), polygon.end(), [&](std::uint32_t p) {
      return p == frame.a || p == frame.b || p == frame.c || points_.coplanar(frame.a, frame.b, frame.c, p);
    });
  }

  void add_face(const Polygon& polygon, const Frame3& frame, std::uint32_t group) {
    corners_.insert(corners_.end(), polygon.begin(), polygon.end());
    offsets_.push_back(place32(corners_.size(), "corners of faces"));
    frames_.push_back(frame);
    groups_.push_back(group);
    if (frame.flat) ++flat_;
  }

  std::vector<Polygon> triangulate(Polygon polygon) const {
    DoubleVector normal{0, 0, 0};  // Newell
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const double *p = points_.xyz(polygon[i]), *q = points_.xyz(polygon[(i + 1) % polygon.size()]);
      for (int k = 0; k < 3; ++k)
        normal[k] += (p[(k + 1) % 3] - q[(k + 1) % 3]) * (p[(k + 2) % 3] + q[(k + 2) % 3]);
    }
    const std::size_t axis = steepest_axis(normal);
    const double sign = normal[axis] < 0 ? -1 : 1;
    const auto turn = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      const double *p = points_.xyz(i), *q = points_.xyz(j), *r = points_.xyz(k);
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      return sign * ((q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]));
    };
    const auto is_ear = [&](std::size_t i) {
      const std::size_t n = polygon.size();
      const std::uint32_t a = polygon[(i + n - 1) % n], b = polygon[i], c = polygon[(i + 1) % n];
      if (!(turn(a, b, c) > 0)) return false;
      return std::none_of(polygon.begin(), polygon.end(), [&](std::uint32_t p) {
        return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
      });
    };
    std::vector<Polygon> triangles;
    while (polygon.size() > 3) {
      std::size_t ear = 1;
      while (ear < polygon.size() && !is_ear(ear)) ++ear;
      if (ear == polygon.size())
        ear = is_ear(0) ? 0 : 1;  // without an ear (not simple): from the second corner on
      const std::size_t n = polygon.size();
      triangles.push_back({polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]});
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back(polygon);
    // A corner that is met twice leaves triangles with two equal corners, whose boundary is zero.
    std::erase_if(triangles, [](const Polygon& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    return triangles;
  }

  std::size_t face_count() const { return frames_.size(); }

  SideTable side_table() const {
    std::vector<PolygonSide> sides;
    sides.reserve(corners_.size());
    for (std::size_t f = 0; f < face_count(); ++f) {
      for (std::size_t i = offsets_[f]; i < offsets_[f + 1]; ++i) {
        const std::uint32_t p = corners_[i], q = corners_[i + 1 < offsets_[f + 1] ? i + 1 : offsets_[f]];
        sides.push_back({std::min(p, q), std::max(p, q), static_cast<std::uint32_t>(f), p < q});
      }
    }
    return SideTable(sides, points_.size());
  }

  Fill decide_fill(const SideTable& sides) {
    if (shape_.fill == Fill::sides) {
      throw InputError(
          "mesh: fill is sides, but a mesh has none: give winding, parity, cells or none, or a group");
    }
    if (face_count() == 0) return shape_.fill.value_or(Fill::none);
    if (shape_.fill == Fill::none || shape_.fill == Fill::cells) return *shape_.fill;
    const bool parity = shape_.fill == Fill::parity;
    ChainEdge example{};
    const auto value = [&](std::uint32_t p) { return points_.value(p); };
    const std::vector<ChainEdge> chain = boundary(sides, parity);
    if (vanishes(chain, parity, value, &example)) return parity ? Fill::parity : Fill::winding;
    const bool only_oriented = !parity && vanishes(boundary(sides, true), true, value);
    const std::string fault =
        name_ + " is " +
        (only_oriented ? "closed, but its faces are not oriented alike along " : "not closed, it has ") +
        std::to_string(chain.size()) + (only_oriented ? "" : " boundary") +
        (chain.size() == 1 ? " edge" : " edges") + ", such as " + describe(points_.value(example.from)) + " to " +
        describe(points_.value(example.to));
    const std::string remedy = only_oriented
                                   ? "`fill: parity` or `fill: cells`, or orient the faces alike"
                                   : "`fill: none` for a surface, `fill: cells` for its cavities, or close it";
    if (shape_.fill) throw InputError(fault + ": give " + remedy);
    notices_.push_back(fault + "; it is taken as a surface without regions: to change or confirm that, give " +
                       remedy);
    return Fill::none;
  }

  /// True if the signed volume of the faces is negative: the sum of the tetrahedra on an origin, one for each
  /// triangle.
  bool is_inside_out() const {
    if (corners_.empty()) return false;
    const double* const origin = points_.xyz(corners_[0]);
    double sum = 0, size = 0;
    for_each_triangle([&](const std::array<std::uint32_t, 3>& corners) {
      double d[3][3];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) d[i][k] = points_.xyz(corners[i])[k] - origin[k];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        sum += d[0][k] * (d[1][l] * d[2][m] - d[1][m] * d[2][l]);
        size += std::abs(d[0][k]) * (std::abs(d[1][l] * d[2][m]) + std::abs(d[1][m] * d[2][l]));
      }
    });
    // Differences of doubles are off by 2^-53 of themselves, products by 7 of these, and each addition by one of
    // the size so far; what is so small that it loses digits is below 2^-1000.
    const double count = 3 * static_cast<double>(corners_.size());
    const double error = (count + 16) * 0x1p-52 * size + count * 0x1p-1000;
    if (data_.exact.empty() && std::abs(sum) > error) return sum < 0;
    const RationalPoint exact_origin = points_.value(corners_[0]);
    std::vector<Rational> terms;
    for_each_triangle([&](const std::array<std::uint32_t, 3>& corners) {
      const auto& [a, b, c] = corners;
      terms.push_back(volume6(exact_origin, points_.value(a), points_.value(b), points_.value(c)));
    });
    return cnrg::sum(std::move(terms)) < 0;
  }

  /// The triangles of each face around its first corner.
  template <class Do>
  void for_each_triangle(Do act) const {
    for (std::size_t f = 0; f < face_count(); ++f) {
      for (std::size_t i = offsets_[f] + 1; i + 1 < offsets_[f + 1]; ++i)
        act({corners_[offsets_[f]], corners_[i], corners_[i + 1]});
    }
  }

  /// Numbers of leaf faces: coplanar faces of one group that share an edge have one.
  std::vector<std::uint32_t> join_coplanar(const SideTable& sides) const {
    UnionFind sets(face_count());
    sides.each_edge([&](std::span<const PolygonSide> around) {
      for (std::size_t i = 1; i < around.size(); ++i) {
        const std::uint32_t f = around[i].face;
        for (std::size_t j = 0; j < i; ++j) {
          const std::uint32_t g = around[j].face;
          if (groups_[f] != groups_[g] || frames_[f].flat || frames_[g].flat) continue;
          if (sets.find(f) != sets.find(g) && coplanar(f, g)) sets.unite(f, g);
        }
      }
    });
    std::vector<std::uint32_t> numbers(face_count());
    std::uint32_t next = 0;
    for (std::uint32_t f = 0; f < face_count(); ++f) {
      if (frames_[f].flat) continue;
      const std::uint32_t root = sets.find(f);  // the smallest member: it has its number already
      numbers[f] = root == f ? next++ : numbers[root];
    }
    return numbers;
  }

  bool coplanar(std::uint32_t f, std::uint32_t g) const {
    const Frame3 &p = frames_[f], &q = frames_[g];
    for (std::uint32_t point : {q.a, q.b, q.c}) {
      if (point == p.a || point == p.b || point == p.c) continue;
      if (!points_.coplanar(p.a, p.b, p.c, point)) return false;
    }
    return true;
  }

  void note(std::size_t count, const char* one, const char* many, const char* what) {
    if (count == 0) return;
    notices_.push_back(name_ + ": " + std::to_string(count) + (count == 1 ? one : many) + what);
  }

  void note_changes() {
    if (within_) {
      const std::string words = weld_.made.notice(*within_).text();
      if (!words.empty()) notices_.push_back(name_ + ": " + words);
    }
    note(repeated_ - std::min(repeated_, collapsed_), " face repeats", " faces repeat",
         " a corner: the repetition was left out");
    note(collapsed_, " face has", " faces have", " fewer than 3 distinct corners: left out");
    note(flat_, " face has", " faces have", " zero area: left out");
    note(cut_, " polygon was", " polygons were", " not exactly planar: cut into triangles");
    note(wires_dropped(), " line has", " lines have", " equal ends: left out");
  }

  std::size_t wires_dropped() const {
    return static_cast<std::size_t>(std::count_if(data_.wires.begin(), data_.wires.end(), [&](const auto& wire) {
      return points_.number(wire[0]) == points_.number(wire[1]);
    }));
  }

  std::unique_ptr<PreparedLeaf> build(Fill fill, const std::vector<std::uint32_t>& leaf_faces) {
    LeafBuilder builder(fill);
    Soup& soup = builder.soup();
    constexpr std::uint32_t kUnused = 0xffffffff;
    std::vector<std::uint32_t> ids(points_.size(), kUnused);  // points that nothing uses are left out
    const auto id = [&](std::uint32_t p) {
      if (ids[p] == kUnused) {
        const RationalPoint* exact = points_.exact(p);
        const double* xyz = points_.xyz(p);
        ids[p] = (exact ? soup.add_point(*exact) : soup.add_point(xyz[0], xyz[1], xyz[2])).value();
      }
      return PointId(ids[p]);
    };
    for (std::size_t f = 0; f < face_count(); ++f) {
      if (frames_[f].flat) continue;
      const std::uint32_t start = offsets_[f], end = offsets_[f + 1], number = leaf_faces[f];
      if (end - start == 3) {
        const PointId a = id(corners_[start]), b = id(corners_[start + 1]), c = id(corners_[start + 2]);
        builder.triangle(a, b, c, number);
        continue;
      }
      std::vector<PointId> loop;
      for (std::uint32_t i = start; i < end; ++i) loop.push_back(id(corners_[i]));
      builder.face(loop, number);
    }
    std::uint32_t edge = 0;
    for (const auto& [from, to] : data_.wires) {
      const std::uint32_t a = points_.number(from), b = points_.number(to);
      if (a == b) continue;
      const PointId first = id(a), second = id(b);
      soup.add_wire(builder.leaf(), first, second, edge++);
    }
    for (std::uint32_t p : data_.points) soup.add_isolated(builder.leaf(), id(points_.number(p)));
    return builder.finish(std::move(notices_));
  }

  const MeshShape& shape_;
  const std::string name_;                // for messages
  const std::optional<Rational> within_;  // of `weld` or `fit`
  MeshData own_;                          // of a file, or moved
  MeshWeld weld_;
  const MeshData& data_;
  MeshPoints points_;
  std::vector<std::uint32_t> corners_, offsets_{0}, groups_;  // cleaned faces
  std::vector<Frame3> frames_;
  std::size_t repeated_ = 0, collapsed_ = 0, flat_ = 0, cut_ = 0;
  std::vector<std::string> notices_;
};

}  // namespace

std::unique_ptr<PreparedLeaf> prepare_leaf(const MeshShape& shape) { return MeshLeaf(shape).prepare(); }

}  // namespace cnrg
