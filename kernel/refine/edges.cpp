// Input segments that nothing cuts are edges, in order already; only pieces of the others are sorted, and the two
// sequences merged. So bodies that hardly touch have next to nothing to sort.
#include "kernel/refine/edges.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "kernel/exact/predicates.h"

namespace cnrg {

namespace {

struct SegmentPart {
  std::uint64_t key;
  std::uint32_t segment, place;  // the place in the chains of all segments
  std::array<VertexId, 2> ends;
};

class Cutter {
 public:
  Cutter(const PointTable& points, const SegmentTable& segments, const Csr<SegmentId, VertexId>& inner)
      : t_(points), segments_(segments), inner_(inner) {}

  EdgeTable run() {
    find_places();
    cut();
    merge();
    out_.segments = Csr<EdgeId, SegmentId>::from_parts(std::move(offsets_), std::move(covering_));
    out_.chain = Csr<SegmentId, EdgeId>::from_parts(std::move(place_), std::move(chain_));
    return std::move(out_);
  }

 private:
  /// A segment whose pieces are sorted: one with points in its interior or a trace, cut or not, for only input
  /// segments are in order.
  struct Cut {
    std::uint32_t segment;
    std::size_t first_piece;  // in `pieces_`
  };

  void find_places() {
    const std::size_t n = segments_.ends.size();
    place_.assign(n + 1, 0);
    std::size_t pieces = 0;
    for (std::size_t s = 0; s < n; ++s) {
      const std::size_t points = inner_[SegmentId(s)].size();
      if (points > 0 || s >= segments_.input_count) {
        cuts_.push_back({static_cast<std::uint32_t>(s), pieces});
        pieces += points + 1;
      }
      place_[s + 1] = static_cast<std::uint32_t>(points) + 1;
    }
    sum_up(place_, "pieces of segments");
    pieces_.resize(pieces);
  }

  void cut() {
    tbb::parallel_for(std::size_t{0}, cuts_.size(), [&](std::size_t c) {
      const Cut& cut = cuts_[c];
      const auto [a, b] = segments_.ends[SegmentId(cut.segment)];
      const auto inner = inner_[SegmentId(cut.segment)];
      std::vector<VertexId> points(inner.begin(), inner.end());
      sort_along(a, b, points);
      points.push_back(b);
      VertexId from = a;
      for (std::size_t k = 0; k < points.size(); ++k) {
        pieces_[cut.first_piece + k] = {RefineInput::key(from, points[k]),
                                        cut.segment,
                                        place_[cut.segment] + static_cast<std::uint32_t>(k),
                                        {from, points[k]}};
        from = points[k];
      }
    });
    tbb::parallel_sort(pieces_.begin(), pieces_.end(), [](const SegmentPart& a, const SegmentPart& b) {
      return a.key != b.key ? a.key < b.key : a.place < b.place;
    });
  }

  /// Any coordinate in which the ends certainly differ orders the points; else all three.
  void sort_along(VertexId a, VertexId b, std::vector<VertexId>& points) const {
    if (points.size() < 2) return;
    int axis = -1, sign = 1;
    double best = 0;
    for (int k = 0; k < 3; ++k) {
      const double up = t_.lower(b)[k] - t_.upper(a, k), down = t_.lower(a)[k] - t_.upper(b, k);
      if (std::max(up, down) > best) {
        best = std::max(up, down);
        axis = k;
        sign = up > 0 ? 1 : -1;
      }
    }
    std::sort(points.begin(), points.end(), [&](VertexId v, VertexId w) {
      if (v == w) return false;
      return (axis >= 0 ? sign * compare(t_, axis, v, w) : compare_lex(t_, v, w)) < 0;
    });
  }

  /// Merges the whole segments with the pieces; both are in order.
  void merge() {
    const std::size_t most = segments_.input_count + pieces_.size();
    out_.ends.reserve(most);
    offsets_.reserve(most + 1);
    covering_.reserve(most);
    chain_.resize(place_.back());
    auto cut = cuts_.begin();
    std::size_t p = 0;
    for (std::uint32_t s = 0; s < segments_.input_count; ++s) {
      if (cut != cuts_.end() && cut->segment == s) {
        ++cut;
        continue;
      }
      const auto& ends = segments_.ends[SegmentId(s)];
      const std::uint64_t key = RefineInput::key(ends[0], ends[1]);
      while (p < pieces_.size() && pieces_[p].key < key) take_pieces(p);
      start_edge(ends);
      while (p < pieces_.size() && pieces_[p].key == key && pieces_[p].segment < s) cover(pieces_[p++]);
      cover(s, place_[s]);
      while (p < pieces_.size() && pieces_[p].key == key) cover(pieces_[p++]);
    }
    while (p < pieces_.size()) take_pieces(p);
    offsets_.push_back(static_cast<std::uint32_t>(covering_.size()));
  }
  /// The edge of all pieces with the key of piece p.
  void take_pieces(std::size_t& p) {
    const std::uint64_t key = pieces_[p].key;
    start_edge(pieces_[p].ends);
    while (p < pieces_.size() && pieces_[p].key == key) cover(pieces_[p++]);
  }
  void start_edge(const std::array<VertexId, 2>& ends) {
    offsets_.push_back(static_cast<std::uint32_t>(covering_.size()));
    out_.ends.push_back(ends);
  }
  void cover(std::uint32_t segment, std::uint32_t place) {
    covering_.push_back(SegmentId(segment));
    chain_[place] = EdgeId(out_.ends.size() - 1);
  }
  void cover(const SegmentPart& piece) { cover(piece.segment, piece.place); }

  const PointTable& t_;
  const SegmentTable& segments_;
  const Csr<SegmentId, VertexId>& inner_;
  std::vector<std::uint32_t> place_;  // by segment: of its first piece in the chains
  std::vector<Cut> cuts_;
  std::vector<SegmentPart> pieces_;
  std::vector<std::uint32_t> offsets_;
  std::vector<SegmentId> covering_;
  std::vector<EdgeId> chain_;
  EdgeTable out_;
};

}  // namespace

EdgeTable cut_segments(const PointTable& points, const SegmentTable& segments,
                       const Csr<SegmentId, VertexId>& inner) {
  return Cutter(points, segments, inner).run();
}

Csr<SegmentId, SourceId> faces_along(const Csr<SourceId, SegmentId>& sides, std::size_t segments) {
  return Csr<SegmentId, SourceId>::counted(segments, [&](const auto& add) {
    for (const SourceId f : IdRange<SourceId>(sides.size())) {
      for (const SegmentId s : sides[f]) {
        if (s.valid()) add(s, f);
      }
    }
  });
}

}  // namespace cnrg
