// What fans.h says of an axis holds of any direction d. Here it is made of sums, and the projection
// along it is the pair of linear maps w -> dz wx - dx wz and w -> dz wy - dy wz (or with the axes turned, so that
// dz is the largest): both vanish on d exactly, and they keep the orientation of what d looks at if dz is
// positive.
//
// Bounds. With u = 2^-53 and w the width of the coordinates (plane_filter.h), dz (q - p) is off by at most 3 u of
// itself and 2 w |dz|, and so is the other product; the difference adds one rounding.
#include "kernel/refine/large_fans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "kernel/base/hypotenuse.h"

namespace cnrg {

namespace {

constexpr std::uint32_t kLargeFan = 64;  // triangles

/// The fan of all faces at a vertex.
class Fan {
 public:
  Fan(const RefineInput& in, VertexId middle, const std::vector<SourceId>& faces)
      : in_(in), t_(in.points), middle_(middle), faces_(faces) {}

  /// True only if its triangles certainly meet in nothing but what they share.
  bool is_embedded() {
    std::array<double, 3> normals{}, spokes{};
    for (const SourceId f : faces_) {
      const auto sides = in_.sides[f];
      if (sides.size() != 3) return false;
      const std::size_t i = corner(f);
      const std::optional<std::array<double, 3>> normal = in_.filters[f.index()].unit_normal();
      if (!in_.paired[sides[i]] || !in_.paired[sides[(i + 2) % 3]] || !normal) return false;
      const double *p = t_.lower(middle_), *q = t_.lower(in_.corners[f][(i + 1) % 3]);
      const double length = hypotenuse(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
      for (std::size_t k = 0; k < 3; ++k) {
        normals[k] += (*normal)[k];
        spokes[k] += (q[k] - p[k]) / length;
      }
    }
    // Of a flat fan the normals show the way, of a sharp convex one its inside, from within or from without.
    const std::array<double, 3> back{-spokes[0], -spokes[1], -spokes[2]};
    return is_embedded_along(normals) || is_embedded_along(spokes) || is_embedded_along(back);
  }

 private:
  bool is_embedded_along(const std::array<double, 3>& direction) {
    const auto smaller = [](double a, double b) { return std::fabs(a) < std::fabs(b); };
    axis_ = static_cast<std::size_t>(std::max_element(direction.begin(), direction.end(), smaller) -
                                     direction.begin());
    const double largest = std::fabs(direction[axis_]);
    if (!(largest > 1e-3 && largest < 1e10)) return false;
    for (std::size_t k = 0; k < 3; ++k) d_[k] = direction[k] / largest;
    for (const SourceId f : faces_) {
      if (in_.filters[f.index()].side_of_normal(d_) <= 0) return false;
    }
    // The sectors that pass a direction are counted; one in which a corner may lie is no good.
    return go_around_once(0.618) || go_around_once(-1.325) || go_around_once(0.382);
  }
  std::size_t corner(SourceId f) const {
    const auto c = in_.corners[f];
    return static_cast<std::size_t>(std::find(c.begin(), c.end(), middle_) - c.begin());
  }
  struct Bounded {
    double value, error;
  };
  /// The map of the coordinate after the axis (`after` 1 or 2) of the way from the middle to v.
  Bounded image(VertexId v, std::size_t after) const {
    const std::size_t k = (axis_ + after) % 3;
    const double *p = t_.lower(middle_), *q = t_.lower(v);
    const double width = std::max(width_of(t_, middle_), width_of(t_, v));
    const double a = d_[axis_] * (q[k] - p[k]), b = d_[k] * (q[axis_] - p[axis_]);
    return {a - b, 1e-15 * (std::fabs(a) + std::fabs(b)) + 2.1 * width * (1 + std::fabs(d_[k])) + 1e-300};
  }
  /// Does the image of v lie in the half plane v >= -tilt u? 1, 0 or kUndecided.
  int above(VertexId v, double tilt) const {
    const Bounded x = image(v, 1), y = image(v, 2);
    const double s = y.value + tilt * x.value, error = y.error + std::fabs(tilt) * x.error;
    const double bound = error + 1e-15 * (std::fabs(y.value) + std::fabs(tilt * x.value));
    return s > bound ? 1 : (s < -bound ? 0 : kUndecided);
  }
  bool go_around_once(double tilt) const {
    int turns = 0;
    for (const SourceId f : faces_) {
      const auto corners = in_.corners[f];
      const std::size_t i = corner(f);
      VertexId from = corners[(i + 1) % 3], to = corners[(i + 2) % 3];
      if (d_[axis_] < 0) std::swap(from, to);
      const int first = above(from, tilt), second = above(to, tilt);
      if (first == kUndecided || second == kUndecided) return false;
      turns += first == 0 && second == 1;
    }
    return turns == 1;
  }

  const RefineInput& in_;
  const PointTable& t_;
  const VertexId middle_;
  const std::vector<SourceId>& faces_;
  std::array<double, 3> d_{};
  std::size_t axis_ = 0;
};

}  // namespace

LargeFans::LargeFans(const RefineInput& input, std::vector<char>& fans) : in_(input), large_(fans.size(), 0) {
  std::vector<std::uint32_t> count(fans.size(), 0);
  for (const VertexId v : in_.corners.values()) {
    if (v.valid()) ++count[v.index()];
  }
  std::vector<VertexId> open;
  for (std::size_t v = 0; v < fans.size(); ++v) {
    if (count[v] <= kLargeFan) continue;
    large_[v] = fans[v];
    if (fans[v] == 0) open.push_back(VertexId(v));
  }
  if (open.empty()) return;
  std::vector<std::pair<VertexId, SourceId>> around;
  for (const SourceId f : IdRange<SourceId>(in_.corners.size())) {
    for (const VertexId v : in_.corners[f]) {
      if (v.valid() && count[v.index()] > kLargeFan && fans[v.index()] == 0) around.push_back({v, f});
    }
  }
  std::sort(around.begin(), around.end());
  std::vector<SourceId> faces;
  for (std::size_t i = 0; i < around.size();) {
    const VertexId v = around[i].first;
    faces.clear();
    for (; i < around.size() && around[i].first == v; ++i) faces.push_back(around[i].second);
    if (Fan(in_, v, faces).is_embedded()) large_[v.index()] = fans[v.index()] = 1;
  }
}

std::vector<std::pair<SourceId, SourceId>> LargeFans::neighbours() const {
  std::vector<std::pair<SegmentId, SourceId>> spokes;
  for (const SourceId f : IdRange<SourceId>(in_.corners.size())) {
    const auto corners = in_.corners[f];
    if (corners.size() != 3) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      if (at(corners[i]) || at(corners[(i + 1) % 3])) spokes.push_back({in_.sides[f][i], f});
    }
  }
  std::sort(spokes.begin(), spokes.end());
  std::vector<std::pair<SourceId, SourceId>> out;
  for (std::size_t i = 1; i < spokes.size(); ++i) {
    if (spokes[i].first == spokes[i - 1].first) out.push_back({spokes[i - 1].second, spokes[i].second});
  }
  return out;
}

}  // namespace cnrg
