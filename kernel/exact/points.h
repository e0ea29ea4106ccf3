// Points: three doubles that bound each coordinate, a definition, and the exact value on demand.
//
// Notation contract of the room:
//   * An *input point* is given by doubles (then lo == hi is its exact value) or by rationals.
//   * A *constructed point* is a definition on input points and planes, never on constructed points:
//       line_plane(a, b, P)      the point of line ab on plane P
//       three_planes(P, Q, R)    the point common to three planes
//       line_line(a, b, c, d)    the point common to two coplanar lines
//     so no construction cascades (kernel/README.md#why-no-construction-cascades).
//   * `lo[k] <= exact[k] <= hi[k]` always holds. A bound may be infinite; then only the exact stage decides.
//   * The exact value is homogeneous, canonical: w > 0, gcd(x, y, z, w) = 1; equal points have equal values.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/exact/rational.h"

namespace cnrg {

/// An exact point in homogeneous integers, canonical: w > 0 and gcd 1.
struct ExactPoint {
  Integer x, y, z, w = 1;
  friend bool operator==(const ExactPoint&, const ExactPoint&) = default;
  RationalPoint rational() const;
  static ExactPoint from(const RationalPoint& p);
};

/// The exact plane a x + b y + c z + d w = 0 with normal (a, b, c), gcd 1.
struct ExactPlane {
  Integer a, b, c, d;
};

/// A coordinate plane to project to: the axes (u, v), chosen so that orientation is preserved for a plane
/// whose normal has a positive component along the third axis (u, v swapped when it is negative).
struct Projection {
  std::uint8_t u = 0, v = 1;
};

/// An enclosure of one point and the way to its exact value; what predicates take.
struct PointView {
  std::array<double, 3> lo, hi;
  const class PointTable* table = nullptr;
  VertexId id;
  const ExactPoint* value = nullptr;  ///< set for points outside of a table (queries)
  const ExactPoint& exact() const;
  bool is_double() const { return lo[0] == hi[0] && lo[1] == hi[1] && lo[2] == hi[2]; }
};

/// How a constructed point is defined; `operands` as the kind says (see the head of this file).
struct Definition {
  enum class Kind : std::uint8_t { line_plane, three_planes, line_line };
  Kind kind = Kind::line_plane;
  std::array<VertexId, 4> points;
  std::array<PlaneId, 3> planes;
};

/// All points and planes of one refinement. Reading is thread-safe; adding is not.
class PointTable {
 public:
  PointTable();
  ~PointTable();
  PointTable(PointTable&&) noexcept;
  PointTable& operator=(PointTable&&) noexcept;

  std::size_t size() const { return row_.size(); }
  VertexId add(double x, double y, double z);
  /// Adds points of doubles, three coordinates each.
  void add(std::span<const double> xyz);
  VertexId add(const RationalPoint& p);
  /// Adds a constructed point; computes its enclosure. The definition must determine one point.
  VertexId add(const Definition& definition);
  /// Adds a constructed point whose enclosure was computed before by `enclose`.
  VertexId add(const Definition& definition, const std::array<double, 3>& lo, const std::array<double, 3>& hi);
  void reserve(std::size_t n);

  /// The plane through three points that are not collinear, normal by the right-hand rule a -> b -> c.
  PlaneId add_plane(VertexId a, VertexId b, VertexId c);
  /// The planes of the whole table at once, as by `add_plane` each.
  void set_planes(std::vector<std::array<VertexId, 3>> planes) { planes_ = std::move(planes); }
  /// Turns the normal of a plane around; nothing may have asked for its exact value before.
  void turn_plane(PlaneId plane) { std::swap(planes_[plane.index()][1], planes_[plane.index()][2]); }
  std::size_t plane_count() const { return planes_.size(); }
  std::array<VertexId, 3> plane_points(PlaneId plane) const { return planes_[plane.index()]; }
  /// Enclosure of the plane's normal.
  void normal(PlaneId plane, std::array<double, 3>& lo, std::array<double, 3>& hi) const;

  bool is_constructed(VertexId v) const;
  /// True if the point is an input point whose coordinates are doubles.
  bool is_double(VertexId v) const { return row_[v.index()] == kDouble; }
  /// The three coordinates of a point that `is_double`, nullptr for any other.
  const double* doubles(VertexId v) const { return is_double(v) ? lower(v) : nullptr; }
  /// The middle of the enclosure; exact where `is_double`.
  std::array<double, 3> approx(VertexId v) const;
  /// The largest value that the coordinate may have; the smallest is `lower(v)[axis]`.
  double upper(VertexId v, int axis) const {
    return is_double(v) ? lower(v)[axis] : upper_[row_[v.index()]][static_cast<std::size_t>(axis)];
  }
  /// The three lower bounds.
  const double* lower(VertexId v) const { return lo_.data() + 3 * v.index(); }
  PointView view(VertexId v) const {
    const double* lo = lower(v);
    PointView p{{lo[0], lo[1], lo[2]}, {lo[0], lo[1], lo[2]}, this, v, nullptr};
    if (!is_double(v)) p.hi = upper_[row_[v.index()]];
    return p;
  }
  /// The canonical exact value, computed once and cached; the reference stays valid while the table lives.
  const ExactPoint& exact(VertexId v) const;
  RationalPoint rational(VertexId v) const { return exact(v).rational(); }
  const ExactPlane& exact_plane(PlaneId plane) const;
  /// The canonical exact value of a definition that is in no table.
  ExactPoint exact_value(const Definition& definition) const;

  /// The doubles nearest to the exact coordinates.
  std::array<double, 3> nearest(VertexId v) const;

  /// The bounds of a definition, without adding it.
  void enclose(const Definition& definition, std::array<double, 3>& lo, std::array<double, 3>& hi) const;

  /// Bytes held, for reports.
  std::size_t memory() const;

 private:
  VertexId last() const;
  struct Caches;
  static constexpr std::uint32_t kDouble = 0xffffffffu;

  std::vector<double> lo_;          // per point three lower bounds
  std::vector<std::uint32_t> row_;  // per point kDouble, or index into `upper_` and `definitions_`
  std::vector<std::array<double, 3>> upper_;
  std::vector<Definition> definitions_;  // points[0] is none() for rational input
  std::vector<std::array<VertexId, 3>> planes_;
  std::unique_ptr<Caches> caches_;  // exact values
};

/// The view of a point that is in no table; `value` must outlive the view.
PointView view_of(const ExactPoint& value);

/// How many signs of expressions in points (predicates.h) each stage decided: the bounds with a filter on doubles,
/// intervals, the exact values.
struct StageCounts {
  std::uint64_t filter = 0, interval = 0, exact = 0;
  double exact_share() const {
    const auto n = filter + interval + exact;
    return n == 0 ? 0.0 : double(exact) / double(n);
  }
};

}  // namespace cnrg
