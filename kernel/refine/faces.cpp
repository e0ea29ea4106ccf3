// Sheets are taken in chunks: first each chunk counts what it will write, then all write to their places at once.
#include "kernel/refine/faces.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace cnrg {

namespace {

/// How much was written before, per array.
struct Totals {
  std::uint64_t faces = 0, loops = 0, half_edges = 0, vertices = 0, covers = 0;
  Totals operator+(const Totals& b) const {
    return {faces + b.faces, loops + b.loops, half_edges + b.half_edges, vertices + b.vertices, covers + b.covers};
  }
};

class Collector {
 public:
  Collector(Refinement& refinement, const IdVector<SheetId, SourceId>& representative,
            const std::vector<SheetId>& work, const std::vector<SheetFaces>& results)
      : r_(refinement), representative_(representative), work_(work), results_(results) {}

  void run() {
    const std::size_t chunks = (representative_.size() + kChunk - 1) / kChunk;
    std::vector<Totals> before(chunks + 1);
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) { before[c + 1] = count(c); });
    for (std::size_t c = 0; c < chunks; ++c) before[c + 1] = before[c] + before[c + 1];
    const Totals& all = before[chunks];
    check_count(all.faces, kPlural<FaceId>);
    check_count(all.loops, kPlural<LoopId>);
    check_count(all.half_edges, "half-edges of loops", kMostPlaces);
    check_count(all.vertices, "vertices in the interior of faces", kMostPlaces);
    check_count(all.covers, "faces of leaves that cover faces", kMostPlaces);
    sheet_.resize(all.faces);
    loop_.resize(all.loops);
    half_edge_.resize(all.half_edges);
    vertex_.resize(all.vertices);
    cover_.resize(all.covers);
    for (auto* offsets : {&face_loop_, &face_vertex_, &face_cover_}) offsets->resize(all.faces + 1);
    loop_begin_.resize(all.loops + 1);
    tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) { write(c, before[c]); });
    close_lists(all);
    r_.face_sheet = IdVector<FaceId, SheetId>(std::move(sheet_));
    r_.face_loops = Csr<FaceId, LoopId>::from_parts(std::move(face_loop_), std::move(loop_));
    r_.loops = Csr<LoopId, HalfEdge>::from_parts(std::move(loop_begin_), std::move(half_edge_));
    r_.face_vertices = Csr<FaceId, VertexId>::from_parts(std::move(face_vertex_), std::move(vertex_));
    r_.face_covers = Csr<FaceId, Cover>::from_parts(std::move(face_cover_), std::move(cover_));
  }

 private:
  static constexpr std::size_t kChunk = 1024;

  /// Calls `subdivided(sheet, faces)` or `lone(sheet)` for the sheets of a chunk.
  template <class Subdivided, class Lone>
  void for_sheets(std::size_t chunk, const Subdivided& subdivided, const Lone& lone) const {
    const SheetId first(chunk * kChunk), last(std::min((chunk + 1) * kChunk, representative_.size()));
    auto next = std::lower_bound(work_.begin(), work_.end(), first);
    for (SheetId sheet = first; sheet < last; ++sheet) {
      if (next != work_.end() && *next == sheet) {
        subdivided(sheet, results_[static_cast<std::size_t>(next - work_.begin())]);
        ++next;
      } else {
        lone(sheet);
      }
    }
  }

  Totals count(std::size_t chunk) const {
    Totals n;
    const auto& chains = r_.edges.chain.offsets();
    for_sheets(
        chunk,
        [&](SheetId, const SheetFaces& x) {
          n = n +
              Totals{x.face_count(), x.loop_end.size(), x.half_edges.size(), x.isolated.size(), x.covers.size()};
        },
        [&](SheetId sheet) {
          ++n.faces, ++n.loops, ++n.covers;
          for (const SegmentId s : std::as_const(r_.input.sides)[representative_[sheet]]) {
            n.half_edges += chains[s.index() + 1] - chains[s.index()];
          }
        });
    return n;
  }

  void write(std::size_t chunk, Totals at) {
    const auto start_face = [&](SheetId sheet) {
      sheet_[at.faces] = sheet;
      face_loop_[at.faces] = static_cast<std::uint32_t>(at.loops);
      face_vertex_[at.faces] = static_cast<std::uint32_t>(at.vertices);
      face_cover_[at.faces] = static_cast<std::uint32_t>(at.covers);
      ++at.faces;
    };
    const auto start_loop = [&] {
      loop_begin_[at.loops] = static_cast<std::uint32_t>(at.half_edges);
      loop_[at.loops] = LoopId(at.loops);
      ++at.loops;
    };
    for_sheets(
        chunk,
        [&](SheetId sheet, const SheetFaces& x) {
          std::size_t loop = 0, half_edge = 0, point = 0, cover = 0;
          for (std::size_t f = 0; f < x.face_count(); ++f) {
            start_face(sheet);
            for (; loop < x.face_loop_end[f]; ++loop) {
              start_loop();
              for (; half_edge < x.loop_end[loop]; ++half_edge) {
                half_edge_[at.half_edges++] = x.half_edges[half_edge];
              }
            }
            for (; point < x.face_isolated_end[f]; ++point) vertex_[at.vertices++] = x.isolated[point];
            for (; cover < x.face_cover_end[f]; ++cover) cover_[at.covers++] = x.covers[cover];
          }
        },
        [&](SheetId sheet) {
          // A lone triangle: its corners run counter-clockwise by the definition of its plane.
          const SourceId f = representative_[sheet];
          const auto corners = std::as_const(r_.input.corners)[f];
          const auto sides = std::as_const(r_.input.sides)[f];
          start_face(sheet);
          start_loop();
          for (std::size_t i = 0; i < 3; ++i) {
            const auto chain = std::as_const(r_.edges.chain)[sides[i]];
            const bool forward = r_.segments.ends[sides[i]][0] == corners[i];
            for (std::size_t k = 0; k < chain.size(); ++k) {
              half_edge_[at.half_edges++] = HalfEdge(chain[forward ? k : chain.size() - 1 - k], forward ? 0 : 1);
            }
          }
          cover_[at.covers++] = Cover{f, true};
        });
  }

  void close_lists(const Totals& all) {
    face_loop_.back() = static_cast<std::uint32_t>(all.loops);
    face_vertex_.back() = static_cast<std::uint32_t>(all.vertices);
    face_cover_.back() = static_cast<std::uint32_t>(all.covers);
    loop_begin_.back() = static_cast<std::uint32_t>(all.half_edges);
  }

  Refinement& r_;
  const IdVector<SheetId, SourceId>& representative_;
  const std::vector<SheetId>& work_;
  const std::vector<SheetFaces>& results_;
  std::vector<SheetId> sheet_;
  std::vector<LoopId> loop_;
  std::vector<HalfEdge> half_edge_;
  std::vector<VertexId> vertex_;
  std::vector<Cover> cover_;
  std::vector<std::uint32_t> face_loop_, face_vertex_, face_cover_, loop_begin_;
};

}  // namespace

void collect_faces(Refinement& refinement, const IdVector<SheetId, SourceId>& representative,
                   const std::vector<SheetId>& work, const std::vector<SheetFaces>& results) {
  Collector(refinement, representative, work, results).run();
}

}  // namespace cnrg
