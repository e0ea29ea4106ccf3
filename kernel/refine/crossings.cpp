// Where the segments of one sheet cross or touch. Pairs whose boxes in the projection meet are found by trying all
// if there are few segments, by a box tree otherwise. A zero is the dearest sign, since filters seldom decide it.
// So zeros that are known by symbol (an end of a trace on the edge that defines it, a point of a third sheet on
// the trace of that sheet) are looked up, and no predicate is asked.
#include <tbb/task_arena.h>

#include "kernel/exact/cross_filter.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/box_pairs.h"
#include "kernel/refine/segments.h"

namespace cnrg {

namespace {

class SheetCrossings {
 public:
  SheetCrossings(const SheetContent& content, const PointTable& points, const SegmentTable& segments,
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
    lines_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto& [a, b] = segments_.ends[c_.segments[i]];
      lines_.push_back({c_.segments[i], {place(a), place(b)}});
      for (const VertexId v : {a, b}) extend(boxes[i], v);
    }
    search(boxes);
    count_filtered(filtered_);
  }

 private:
  /// A vertex in the projection: each coordinate lies between the one here and `width` above it.
  struct Place {
    VertexId vertex;
    double u, v, width;
  };
  struct Line {
    SegmentId segment;
    std::array<Place, 2> ends;
  };

  void extend(Box& box, VertexId v) const {
    const int u = c_.axes.u, w = c_.axes.v;
    box.extend({t_.lower(v)[u], t_.lower(v)[w], 0.0}, {t_.upper(v, u), t_.upper(v, w), 0.0});
  }

  Place place(VertexId v) const {
    const double *lo = t_.lower(v), x = lo[c_.axes.u], y = lo[c_.axes.v];
    return {v, x, y, std::max(t_.upper(v, c_.axes.u) - x, t_.upper(v, c_.axes.v) - y)};
  }

  void search(const std::vector<Box>& boxes) {
    const std::size_t n = lines_.size();
    if (n <= 24) {
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
          if (boxes[i].meets(boxes[j])) pair(lines_[i], lines_[j]);
        }
        for (const VertexId v : c_.points) {
          Box b;
          extend(b, v);
          if (boxes[i].meets(b)) point(place(v), lines_[i]);
        }
      }
      return;
    }
    // The tree sorts in parallel; isolation keeps this thread from taking up another sheet meanwhile.
    tbb::this_task_arena::isolate([&] {
      BoxPairs tree(boxes);
      if (tree.crowded()) {
        const std::vector<std::pair<VertexId, std::uint32_t>> spokes = find_spokes();
        tree.orient(boxes, [&](std::uint32_t i, BoxPairs::Outline& out) {
          std::size_t groups = 0;
          for (const Place& end : lines_[i].ends) {
            extend(out.corners.emplace_back(), end.vertex);
            if (std::binary_search(spokes.begin(), spokes.end(), std::pair(end.vertex, i))) {
              out.groups[groups++] = end.vertex.value();
            }
          }
        });
        pairs_of_wheels(spokes);
      }
      for (std::size_t part = 0; part < tree.part_count(); ++part) {
        tree.find(part,
                  [&](std::uint32_t x, std::uint32_t y) { pair(lines_[tree.item(x)], lines_[tree.item(y)]); });
      }
      for (const VertexId v : c_.points) {
        Box own;
        extend(own, v);
        tree.query(own, [&](std::uint32_t i) { point(place(v), lines_[i]); });
      }
    });
  }

  /// Segments by an end that they share with many others. All of a thousand segments at one end meet there, and no
  /// box parts them.
  std::vector<std::pair<VertexId, std::uint32_t>> find_spokes() const {
    constexpr std::ptrdiff_t kMany = 64;
    std::vector<std::pair<VertexId, std::uint32_t>> spokes;
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      for (const Place& end : lines_[i].ends) spokes.push_back({end.vertex, i});
    }
    std::sort(spokes.begin(), spokes.end());
    auto kept = spokes.begin();
    for (auto first = spokes.begin(); first != spokes.end();) {
      const auto last = std::find_if(first, spokes.end(), [&](const auto& x) { return x.first != first->first; });
      if (last - first > kMany) kept = std::move(first, last, kept);
      first = last;
    }
    spokes.erase(kept, spokes.end());
    return spokes;
  }

  /// The pairs with an end in common: two such segments meet elsewhere only if they look the same way.
  void pairs_of_wheels(std::vector<std::pair<VertexId, std::uint32_t>> spokes) {
    // The order of a segment's ends says in which half plane it looks; there the side tells the order of
    // directions.
    const auto outward = [&](const auto& spoke) { return lines_[spoke.second].ends[0].vertex == spoke.first; };
    const auto side_of = [&](const auto& x, const auto& y) {
      return side(lines_[x.second], lines_[y.second].ends[outward(y) ? 1 : 0]);
    };
    std::sort(spokes.begin(), spokes.end(), [&](const auto& x, const auto& y) {
      if (x.first != y.first) return x.first < y.first;
      if (outward(x) != outward(y)) return outward(x) < outward(y);
      return side_of(x, y) > 0;
    });
    for (std::size_t i = 0; i < spokes.size(); ++i) {
      for (std::size_t j = i + 1; j < spokes.size() && spokes[j].first == spokes[i].first &&
                                  outward(spokes[j]) == outward(spokes[i]) && side_of(spokes[i], spokes[j]) == 0;
           ++j) {
        pair(lines_[spokes[i].second], lines_[spokes[j].second]);
      }
    }
  }

  /// Side of the line on which p lies, up to a sign that depends on the line only.
  int side(const Line& line, const Place& p) {
    const auto& [a, b] = line.ends;
    if (p.vertex == a.vertex || p.vertex == b.vertex) return 0;
    const double width = std::max(p.width, std::max(a.width, b.width));
    if (const int s = filtered_cross(b.u - a.u, b.v - a.v, p.u - a.u, p.v - a.v, width); s != kUndecided) {
      ++filtered_;
      return s;
    }
    const SegmentId s = line.segment;
    if (known_.on(p.vertex, s)) return 0;
    if (segments_.is_trace(s) && known_.in(p.vertex, segments_.other_sheet(s, c_.sheet))) return 0;
    return orient2d(t_, c_.axes, a.vertex, b.vertex, p.vertex);
  }

  /// For a point on the line of s: strictly between its ends?
  bool between(SegmentId s, VertexId v) const {
    const auto& [a, b] = segments_.ends[s];
    if (v == a || v == b) return false;
    // Along a line points are in lexicographic order, a first. A coordinate that certainly grows is enough.
    for (int k = 0; k < 3; ++k) {
      if (t_.upper(a, k) < t_.lower(b)[k]) return compare(t_, k, a, v) < 0 && compare(t_, k, v, b) < 0;
    }
    return compare_lex(t_, a, v) < 0 && compare_lex(t_, v, b) < 0;
  }

  void point(const Place& p, const Line& line) {
    if (p.vertex == line.ends[0].vertex || p.vertex == line.ends[1].vertex) return;
    if (side(line, p) == 0) add(line.segment, p.vertex);
  }
  /// Notes a vertex on the line of s if it lies between the ends.
  void add(SegmentId s, VertexId v) {
    if (between(s, v)) incidences_.push_back({s, v});
  }

  void pair(const Line& x, const Line& y) {
    const SegmentId s = x.segment, t = y.segment;
    const auto &es = x.ends, &et = y.ends;
    const int s0 = side(x, et[0]), s1 = side(x, et[1]);
    if (s0 * s1 > 0) return;
    const bool share = es[0].vertex == et[0].vertex || es[0].vertex == et[1].vertex ||
                       es[1].vertex == et[0].vertex || es[1].vertex == et[1].vertex;
    if (share && (s0 != 0 || s1 != 0)) return;  // two lines meet in one point only
    const int t0 = side(y, es[0]), t1 = side(y, es[1]);
    if (t0 * t1 > 0) return;
    if (s0 * s1 < 0 && t0 * t1 < 0) {
      crossings_.push_back({key(s, t), std::min(s, t), std::max(s, t)});
      return;
    }
    if (s0 == 0) add(s, et[0].vertex);
    if (s1 == 0) add(s, et[1].vertex);
    if (t0 == 0) add(t, es[0].vertex);
    if (t1 == 0) add(t, es[1].vertex);
  }

  PointKey key(SegmentId s, SegmentId t) const {
    if (s > t) std::swap(s, t);  // input segments come first
    if (!segments_.is_trace(t)) return PointKey::segments(s, t);
    const SourceId across_t = representative_[segments_.other_sheet(t, c_.sheet)];
    if (!segments_.is_trace(s)) return PointKey::segment_plane(s, across_t);
    return PointKey::planes(representative_[c_.sheet], representative_[segments_.other_sheet(s, c_.sheet)],
                            across_t);
  }

  const SheetContent& c_;
  const PointTable& t_;
  const SegmentTable& segments_;
  const KnownIncidence& known_;
  const IdVector<SheetId, SourceId>& representative_;
  std::vector<Line> lines_;  // as in c_.segments
  std::uint64_t filtered_ = 0;
  std::vector<Crossing>& crossings_;
  std::vector<std::pair<SegmentId, VertexId>>& incidences_;
};

}  // namespace

void find_crossings(const SheetContent& content, const PointTable& points, const SegmentTable& segments,
                    const KnownIncidence& known, const IdVector<SheetId, SourceId>& representative,
                    std::vector<Crossing>& crossings, std::vector<std::pair<SegmentId, VertexId>>& incidences) {
  SheetCrossings(content, points, segments, known, representative, crossings, incidences).run();
}

}  // namespace cnrg
