// All pairs of segments in one sheet, by their boxes in the projection: a few by trying all, many by a box tree.
// Signs that are known by symbol (an end of a trace on the edge that defines it, a point of a third sheet on the
// trace of that sheet) are never computed.
#include <tbb/task_arena.h>

#include "kernel/refine/box_pairs.h"
#include "kernel/refine/segments.h"

namespace cnrg {

namespace {

class CrossingFinder {
 public:
  CrossingFinder(const SheetContent& content, const PointTable& points, const SegmentTable& segments,
                 const KnownIncidence& known, const IdVector<SheetId, SourceId>& representative,
                 std::vector<Crossing>& crossings, std::vector<std::pair<SegmentId, VertexId>>& incidences)
      : c_(content),
        t_(points),
        segments_(segments),
        known_(known),
        representative_(representative),
        crossings_(crossings),
        incidences_(incidences) {}

  void run() {
    const std::size_t n = c_.segments.size();
    std::vector<Box> boxes(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (const VertexId v : segments_.ends[c_.segments[i]]) extend(boxes[i], v);
    }
    if (n <= 24) {
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
          if (boxes[i].meets(boxes[j])) pair(c_.segments[i], c_.segments[j]);
        }
        for (const VertexId v : c_.points) {
          Box b;
          extend(b, v);
          if (boxes[i].meets(b)) point(v, c_.segments[i]);
        }
      }
      return;
    }
    // The tree sorts in parallel; isolation keeps this thread from taking up another sheet meanwhile.
    tbb::this_task_arena::isolate([&] {
      const BoxPairs tree(boxes);
      for (std::size_t part = 0; part < tree.part_count(); ++part) {
        tree.find(part, [&](std::uint32_t x, std::uint32_t y) {
          pair(c_.segments[tree.item(x)], c_.segments[tree.item(y)]);
        });
      }
      for (const VertexId v : c_.points) {
        Box own;
        extend(own, v);
        tree.query(own, [&](std::uint32_t i) { point(v, c_.segments[i]); });
      }
    });
  }

 private:
  void extend(Box& box, VertexId v) const {
    const PointView p = t_.view(v);
    box.extend({p.lo[c_.axes.u], p.lo[c_.axes.v], 0.0}, {p.hi[c_.axes.u], p.hi[c_.axes.v], 0.0});
  }

  /// Side of the line of s on which v lies, up to a sign that depends on s only.
  int side(SegmentId s, VertexId v) const {
    const auto& [a, b] = segments_.ends[s];
    if (v == a || v == b) return 0;
    if (known_.on(v, s)) return 0;
    if (segments_.is_trace(s) && known_.in(v, segments_.other_sheet(s, c_.sheet))) return 0;
    return orient2d(t_, c_.axes, a, b, v);
  }

  /// For a point on the line of s: strictly between its ends?
  bool between(SegmentId s, VertexId v) const {
    const auto& [a, b] = segments_.ends[s];
    if (v == a || v == b) return false;
    // Ends are in lexicographic order, and so is every point of the line; a coordinate in which the ends certainly
    // differ tells alone.
    for (int k = 0; k < 3; ++k) {
      const bool up = t_.upper(a, k) < t_.lower(b)[k], down = t_.lower(a)[k] > t_.upper(b, k);
      if (up) return compare(t_, k, a, v) < 0 && compare(t_, k, v, b) < 0;
      if (down) return compare(t_, k, a, v) > 0 && compare(t_, k, v, b) > 0;
    }
    return compare_lex(t_, a, v) < 0 && compare_lex(t_, v, b) < 0;
  }

  void point(VertexId v, SegmentId s) {
    const auto& [a, b] = segments_.ends[s];
    if (v == a || v == b) return;
    if (side(s, v) == 0 && between(s, v)) incidences_.push_back({s, v});
  }

  void pair(SegmentId s, SegmentId t) {
    const auto &es = segments_.ends[s], &et = segments_.ends[t];
    const int s0 = side(s, et[0]), s1 = side(s, et[1]);
    if (s0 * s1 > 0) return;
    const bool share = es[0] == et[0] || es[0] == et[1] || es[1] == et[0] || es[1] == et[1];
    if (share && (s0 != 0 || s1 != 0)) return;  // two lines meet in one point only
    const int t0 = side(t, es[0]), t1 = side(t, es[1]);
    if (t0 * t1 > 0) return;
    if (s0 * s1 < 0 && t0 * t1 < 0) {
      crossings_.push_back({key(s, t), std::min(s, t), std::max(s, t)});
      return;
    }
    if (s0 == 0 && between(s, et[0])) incidences_.push_back({s, et[0]});
    if (s1 == 0 && between(s, et[1])) incidences_.push_back({s, et[1]});
    if (t0 == 0 && between(t, es[0])) incidences_.push_back({t, es[0]});
    if (t1 == 0 && between(t, es[1])) incidences_.push_back({t, es[1]});
  }

  PointKey key(SegmentId s, SegmentId t) const {
    if (s > t) std::swap(s, t);  // input segments come first
    if (!segments_.is_trace(t)) return PointKey::segments(s, t);
    const SourceId across_t = representative_[segments_.other_sheet(t, c_.sheet)];
    if (!segments_.is_trace(s)) return PointKey::segment_plane(s, across_t);
    return PointKey::planes(representative_[c_.sheet], representative_[segments_.other_sheet(s, c_.sheet)], across_t);
  }

  const SheetContent& c_;
  const PointTable& t_;
  const SegmentTable& segments_;
  const KnownIncidence& known_;
  const IdVector<SheetId, SourceId>& representative_;
  std::vector<Crossing>& crossings_;
  std::vector<std::pair<SegmentId, VertexId>>& incidences_;
};

}  // namespace

void find_crossings(const SheetContent& content, const PointTable& points, const SegmentTable& segments,
                    const KnownIncidence& known, const IdVector<SheetId, SourceId>& representative,
                    std::vector<Crossing>& crossings, std::vector<std::pair<SegmentId, VertexId>>& incidences) {
  CrossingFinder(content, points, segments, known, representative, crossings, incidences).run();
}

}  // namespace cnrg
