#include "csg/weld/order.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "kernel/base/vectors.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/integers.h"

namespace cnrg::welding {
namespace {

/// Sines of angles and ratios of lengths below this are too near to zero to build on.
constexpr double kFlat = 1.0 / 1024;
/// What a few steps make of numbers is this much longer than the longest that was given. In a long row of steps
/// they would grow without bound.
constexpr std::size_t kLonger = 32;

/// Binary digits of the longest fraction.
std::size_t longest(const RationalPoint& p) { return std::max({bits_of(p[0]), bits_of(p[1]), bits_of(p[2])}); }
std::size_t longest(const Plane& plane) { return std::max(longest(plane.normal), bits_of(plane.offset)); }

Rational side_of(const Plane& plane, const RationalPoint& p) {  // times the length of the normal
  return dot(plane.normal, p) - plane.offset;
}

/// The point on up to three planes with independent normals that is nearest to p.
RationalPoint nearest_on(const std::vector<const Plane*>& planes, const RationalPoint& p) {
  if (planes.empty()) return p;
  const RationalPoint& a = planes[0]->normal;
  if (planes.size() == 1) {
    if (side_of(*planes[0], p) == 0) return p;
    return p - Rational(side_of(*planes[0], p) / dot(a, a)) * a;
  }
  const RationalPoint& b = planes[1]->normal;
  const RationalPoint c = cross(a, b);
  const RationalPoint& third = planes.size() == 2 ? c : planes[2]->normal;
  const Rational offset = planes.size() == 2 ? dot(c, p) : planes[2]->offset;
  const RationalPoint sum = planes[0]->offset * cross(b, third) + planes[1]->offset * cross(third, a) + offset * c;
  return Rational(1 / dot(c, third)) * sum;
}

/// The plane through up to three points, not on a line, that is like another one.
Plane like(const Plane& plane, const std::vector<const RationalPoint*>& points) {
  Plane result = plane;
  if (points.empty()) return result;
  if (points.size() == 2) {
    const RationalPoint w = *points[1] - *points[0];
    if (dot(plane.normal, w) != 0) result.normal = plane.normal - Rational(dot(plane.normal, w) / dot(w, w)) * w;
  }
  if (points.size() == 3) {
    result.normal = cross(*points[1] - *points[0], *points[2] - *points[0]);
    Rational most = 0;
    for (const Rational& x : result.normal) most = std::max(most, Rational(abs(x)));
    result.normal = Rational(1 / most) * result.normal;
  }
  result.offset = dot(result.normal, *points[0]);
  return result;
}

class Placer {
 public:
  Placer(Incidence& incidence, const Rational& d) : all_(incidence), square_(d * d) {
    for (const auto& p : all_.points) {
      at_.push_back(to_doubles(p.at));
      most_bits_ = std::max(most_bits_, kLonger * longest(p.at));
    }
    for (const auto& plane : all_.planes) {
      most_bits_ = std::max(most_bits_, kLonger * longest(plane.plane));
      const Vector n = to_doubles(plane.plane.normal);
      normal_.push_back(unit(n));
      double extent = 0;
      for (const Index p : plane.points) extent = std::max(extent, length(minus(at_[p], at_[plane.points[0]])));
      extent_.push_back(extent);
    }
  }

  std::size_t run() {
    take_away();
    placed_point_.assign(all_.points.size(), false);
    placed_plane_.assign(all_.planes.size(), false);
    for (std::size_t i = order_.size(); i-- > 0;) {
      const auto& [is_point, number] = order_[i];
      is_point ? place_point(number) : place_plane(number);
    }
    return broken_;
  }

 private:
  // --- the order

  /// Points with three planes at most, then planes with three points at most, then what has fewest.
  struct Key {
    int rank;
    std::size_t partners;
    bool is_plane;
    Index number;
    auto operator<=>(const Key&) const = default;
  };

  Key key(bool is_plane, Index number) const {
    const std::size_t count = (is_plane ? points_left_ : planes_left_)[number];
    bool free = count <= 3;
    if (free && is_plane) free = plane_is_free(number, present(all_.planes[number].points, point_gone_));
    if (free && !is_plane) free = point_is_free(present(all_.points[number].planes, plane_gone_));
    return {free ? (is_plane ? 1 : 0) : 2, count, is_plane, number};
  }

  static std::vector<Index> present(const std::vector<Index>& list, const std::vector<bool>& gone) {
    std::vector<Index> rest;
    for (const Index i : list) {
      if (!gone[i]) rest.push_back(i);
    }
    return rest;
  }

  bool point_is_free(const std::vector<Index>& planes) const {
    if (planes.size() < 2) return true;
    const Vector line = cross(normal_[planes[0]], normal_[planes[1]]);
    if (planes.size() == 2) return length(line) > kFlat;
    return std::abs(dot(line, normal_[planes[2]])) > kFlat;
  }

  bool plane_is_free(Index number, const std::vector<Index>& points) const {
    if (points.size() < 2) return true;
    const double least = kFlat * extent_[number];
    const Vector a = minus(at_[points[1]], at_[points[0]]);
    if (points.size() == 2) return length(a) > least;
    const Vector b = minus(at_[points[2]], at_[points[0]]), c = minus(b, a);
    return length(cross(a, b)) > least * std::max({length(a), length(b), length(c)});
  }

  void take_away() {
    point_gone_.assign(all_.points.size(), false);
    plane_gone_.assign(all_.planes.size(), false);
    for (const auto& point : all_.points) planes_left_.push_back(point.planes.size());
    for (const auto& plane : all_.planes) points_left_.push_back(plane.points.size());
    std::vector<Key> point_key, plane_key;
    std::set<Key> queue;
    for (Index p = 0; p < all_.points.size(); ++p) point_key.push_back(key(false, p));
    for (Index p = 0; p < all_.planes.size(); ++p) plane_key.push_back(key(true, p));
    queue.insert(point_key.begin(), point_key.end());
    queue.insert(plane_key.begin(), plane_key.end());
    while (!queue.empty()) {
      const Key first = *queue.begin();
      queue.erase(queue.begin());
      order_.emplace_back(!first.is_plane, first.number);
      (first.is_plane ? plane_gone_ : point_gone_)[first.number] = true;
      const auto& partners = first.is_plane ? all_.planes[first.number].points : all_.points[first.number].planes;
      for (const Index partner : partners) {
        if ((first.is_plane ? point_gone_ : plane_gone_)[partner]) continue;
        Key& old = (first.is_plane ? point_key : plane_key)[partner];
        queue.erase(old);
        --(first.is_plane ? planes_left_ : points_left_)[partner];
        old = key(!first.is_plane, partner);
        queue.insert(old);
      }
    }
  }

  // --- places

  void place_point(Index number) {
    Incidence::Point& point = all_.points[number];
    std::vector<Index> planes;
    for (const Index p : point.planes) {
      if (placed_plane_[p]) planes.push_back(p);
    }
    std::stable_sort(planes.begin(), planes.end(),
                     [&](Index a, Index b) { return all_.planes[a].parts > all_.planes[b].parts; });
    std::vector<const Plane*> obeyed;
    RationalPoint at = point.at;
    for (const Index p : planes) {
      const Plane& plane = all_.planes[p].plane;
      if (obeyed.size() < 3 && independent(obeyed, plane.normal)) {
        obeyed.push_back(&plane);
        const RationalPoint there = nearest_on(obeyed, point.at);
        if (longest(there) <= most_bits_ && is_near(point, there)) {
          at = there;
          continue;
        }
        obeyed.pop_back();
      }
      if (side_of(plane, at) != 0) ++broken_;
    }
    point.at = at;
    placed_point_[number] = true;
  }

  static bool independent(const std::vector<const Plane*>& planes, const RationalPoint& normal) {
    if (planes.empty()) return true;
    if (planes.size() == 1) return !is_zero(cross(planes[0]->normal, normal));
    return dot(cross(planes[0]->normal, planes[1]->normal), normal) != 0;
  }

  bool is_near(const Incidence::Point& point, const RationalPoint& at) const {
    return std::all_of(point.members.begin(), point.members.end(), [&](const RationalPoint* member) {
      const RationalPoint by = at - *member;
      return dot(by, by) <= square_;
    });
  }

  void place_plane(Index number) {
    Incidence::Through& through = all_.planes[number];
    std::vector<const RationalPoint*> obeyed;
    Plane plane = through.plane;
    for (const Index p : through.points) {
      if (!placed_point_[p]) continue;
      const RationalPoint& at = all_.points[p].at;
      if (obeyed.size() < 3 && widens(obeyed, at)) {
        obeyed.push_back(&at);
        const Plane there = like(through.plane, obeyed);
        if (!is_zero(there.normal) && longest(there) <= most_bits_ && is_near(through, there)) {
          plane = there;
          continue;
        }
        obeyed.pop_back();
      }
      if (side_of(plane, at) != 0) ++broken_;
    }
    through.plane = plane;
    placed_plane_[number] = true;
  }

  static bool widens(const std::vector<const RationalPoint*>& points, const RationalPoint& p) {
    if (points.empty()) return true;
    if (points.size() == 1) return *points[0] != p;
    return !collinear(*points[0], *points[1], p);
  }

  bool is_near(const Incidence::Through& through, const Plane& plane) const {
    const Rational most = square_ * dot(plane.normal, plane.normal);
    return std::all_of(through.corners.begin(), through.corners.end(), [&](const RationalPoint* corner) {
      const Rational by = side_of(plane, *corner);
      return by * by <= most;
    });
  }

  Incidence& all_;
  Rational square_;
  std::size_t most_bits_ = 0;
  std::vector<Vector> at_, normal_;                     // of points, of planes
  std::vector<double> extent_;                          // of planes
  std::vector<std::size_t> planes_left_, points_left_;  // of points, of planes
  std::vector<bool> point_gone_, plane_gone_, placed_point_, placed_plane_;
  std::vector<std::pair<bool, Index>> order_;  // a point? its number
  std::size_t broken_ = 0;
};

}  // namespace

std::size_t place(Incidence& incidence, const Rational& d) { return Placer(incidence, d).run(); }

}  // namespace cnrg::welding
