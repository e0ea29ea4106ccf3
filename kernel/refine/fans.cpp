// Two passes over the triangles: the first notes at each corner along which axes the normals disagree and whether
// the fan is open, the second counts how often the sectors pass one direction. Threads meet in atomic bits and
// counts; the outcome does not depend on their order.
#include "kernel/refine/fans.h"

#include <atomic>
#include <bit>

#include "kernel/base/parallel.h"

namespace cnrg {

namespace {

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

std::vector<char> embedded_fans(const RefineInput& input) { return Fans(input).run(); }

}  // namespace cnrg
