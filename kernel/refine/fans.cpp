// Two passes over the triangles: the first notes at each corner along which axes the normals disagree and whether
// the fan is open, the second counts how often the sectors pass one direction. Threads meet in atomic bits and
// counts; the outcome does not depend on their order.
#include "kernel/refine/fans.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "kernel/base/hypotenuse.h"
#include "kernel/base/parallel.h"

namespace cnrg {
namespace {

// What fans.h says of an axis holds of any direction d. Here it is made of sums, and the projection
// along it is the pair of linear maps w -> dz wx - dx wz and w -> dz wy - dy wz (or with the axes turned, so that
// dz is the largest): both vanish on d exactly, and they keep the orientation of what d looks at if dz is
// positive.
//
// Bounds. With u = 2^-53 and w the width of the coordinates (plane_filter.h), dz (q - p) is off by at most 3 u of
// itself and 2 w |dz|, and so is the other product; the difference adds one rounding.

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

// Each bit stands for a property that a vertex does not have: all normals around it are negative along x, y, z
// (bits 0..2) or positive (bits 3..5), all fans are closed (bit 6).
constexpr std::uint8_t kOpen = 1 << 6, kNoBits = 0x7f;

class Fans {
 public:
  explicit Fans(const RefineInput& in)
      : in_(in), t_(in.points), excluded_(t_.size(), 0), turns_(t_.size(), 0), embedded_(t_.size(), 0) {}

  std::vector<char> run() {
    for_all_faces([&](SourceId f) { exclude(f); });
    for_all_faces([&](SourceId f) { count_turns(f); });
    for (std::size_t v = 0; v < embedded_.size(); ++v) {
      embedded_[v] = axis_of(excluded_[v]) >= 0 && turns_[v] == 1 ? 1 : 0;
    }
    return std::move(embedded_);
  }

 private:
  template <class Work>
  void for_all_faces(const Work& work) {
    for_each_index(in_.corners.size(), [&](std::size_t i) { work(SourceId(i)); });
  }

  void exclude(SourceId f) {
    const auto corners = in_.corners[f];
    const auto sides = in_.sides[f];
    std::uint8_t bits = kNoBits;
    if (corners.size() == 3) {
      bits = 0;
      for (int k = 0; k < 3; ++k) {
        const int s = in_.filters[f.index()].normal_sign(k);
        if (s >= 0) bits |= static_cast<std::uint8_t>(1 << k);
        if (s <= 0) bits |= static_cast<std::uint8_t>(8 << k);
      }
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!corners[i].valid()) continue;
      std::uint8_t here = bits;
      if (bits != kNoBits && !(in_.paired[sides[i]] && in_.paired[sides[(i + 2) % 3]])) here |= kOpen;
      const std::atomic_ref entry(excluded_[corners[i].index()]);
      if ((entry.load(std::memory_order_relaxed) | here) != entry.load(std::memory_order_relaxed)) {
        entry.fetch_or(here, std::memory_order_relaxed);
      }
    }
  }

  /// 0..2: a negative normal along x, y, z; 3..5: a positive one; -1: none, or the fan is open.
  static int axis_of(std::uint8_t excluded) {
    if ((excluded & kOpen) != 0 || (excluded & 0x3f) == 0x3f) return -1;
    return std::countr_one(excluded);
  }

  /// The sign of the difference of two coordinates by their bounds.
  int order(VertexId v, VertexId w, std::size_t axis) const {
    const double a = t_.lower(v)[axis], b = t_.lower(w)[axis];
    if (t_.is_double(v) && t_.is_double(w)) return a < b ? -1 : a > b;
    if (t_.upper(v, static_cast<int>(axis)) < b) return -1;
    return t_.upper(w, static_cast<int>(axis)) < a ? 1 : kUndecided;
  }

  void count_turns(SourceId f) {
    const auto c = in_.corners[f];
    if (c.size() != 3) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = c[i];
      const int code = axis_of(excluded_[v.index()]);
      if (code < 0) continue;
      VertexId from = c[(i + 1) % 3], to = c[(i + 2) % 3];
      if (code < 3) std::swap(from, to);
      const std::size_t axis = static_cast<std::size_t>(code % 3), x = (axis + 1) % 3, y = (axis + 2) % 3;
      // Is w in the half plane of directions from 0 to less than half a turn? 1, 0 or kUndecided.
      const auto above = [&](VertexId w) -> int {
        if (const int s = order(w, v, y); s != 0) return s == kUndecided ? s : s > 0;
        const int s = order(w, v, x);
        return s == kUndecided ? s : s > 0;
      };
      const int first = above(from), second = above(to);
      const bool certain = first != kUndecided && second != kUndecided;
      if (certain && (first == 1 || second == 0)) continue;
      const std::atomic_ref turns(turns_[v.index()]);
      if (turns.load(std::memory_order_relaxed) < 2) {
        turns.fetch_add(certain ? 1 : 2, std::memory_order_relaxed);
      }
    }
  }

  const RefineInput& in_;
  const PointTable& t_;
  std::vector<std::uint8_t> excluded_;
  std::vector<std::uint16_t> turns_;  // at most 2 and two per thread; 2 or more if that is not certain
  std::vector<char> embedded_;
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

std::vector<char> embedded_fans(const RefineInput& input) { return Fans(input).run(); }

}  // namespace cnrg
