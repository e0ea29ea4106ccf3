// The driver of refinement: symbols first, coordinates where a decision needs them, one subdivision per sheet.
//
// `Refiner::run` is the pipeline: identify equal input points; find where inputs meet; gather coplanar faces that
// touch into sheets; give contacts their vertices and segments; list what lies in each sheet; cross the segments
// of each sheet; cut each segment at its points; subdivide each sheet by what is left of its segments; number the
// faces of all sheets.
//
// Why sheets that are subdivided one by one, in parallel, fit together: kernel/README.md#why-points-meet.
#include "kernel/refine/refine.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/contacts.h"
#include "kernel/refine/edges.h"
#include "kernel/refine/faces.h"
#include "kernel/refine/keyed_points.h"

namespace cnrg {
namespace {

// What many threads found, made into sets: their pairs come in an order of chance and more than once.

/// As `sort_unique` of kernel/base/sorted.h, for long lists.
template <class T>
void sort_unique_in_parallel(std::vector<T>& list) {
  tbb::parallel_sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// For each first id below n the second ids of the pairs, ascending and unique. The pairs are not sorted: each
/// list is, by itself.
template <class A, class B>
Csr<Id<A>, Id<B>> lists_of(std::size_t n, const std::vector<std::pair<Id<A>, Id<B>>>& pairs) {
  using Lists = Csr<Id<A>, Id<B>>;
  Lists lists = Lists::counted(n, [&](const auto& add) {
    for (const auto& [first, second] : pairs) add(first, second);
  });
  std::vector<std::uint32_t> offsets(n + 1, 0);
  for_each_index(n, [&](std::size_t i) {
    const auto list = lists[Id<A>(i)];
    std::sort(list.begin(), list.end());
    offsets[i + 1] = static_cast<std::uint32_t>(std::unique(list.begin(), list.end()) - list.begin());
  });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  if (offsets[n] == lists.value_count()) return lists;
  std::vector<Id<B>> values(offsets[n]);
  for_each_index(n, [&](std::size_t i) {
    std::copy_n(lists[Id<A>(i)].begin(), offsets[i + 1] - offsets[i], values.begin() + offsets[i]);
  });
  return Lists::from_parts(std::move(offsets), std::move(values));
}

/// A part of the common line of two sheets.
struct PlaneTrace {
  SheetId p, q;
  VertexId a, b;  // the lexicographically smaller first
  auto operator<=>(const PlaneTrace&) const = default;
};

/// Cuts the traces of two sheets at each other's ends, and adds them to `out`.
void part_overlaps(const PointTable& t, std::span<PlaneTrace> traces, std::vector<PlaneTrace>& out) {
  const auto less = [&](VertexId v, VertexId w) { return v != w && compare_lex(t, v, w) < 0; };
  std::ranges::sort(traces, less, &PlaneTrace::a);
  std::vector<VertexId> ends;
  for (const PlaneTrace& trace : traces) ends.insert(ends.end(), {trace.a, trace.b});
  std::ranges::sort(ends, less);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  VertexId reach = traces[0].a;  // of all that begin before
  auto trace = traces.begin();
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    for (; trace != traces.end() && trace->a == ends[k]; ++trace) reach = std::max(reach, trace->b, less);
    if (less(ends[k], reach)) out.push_back({traces[0].p, traces[0].q, ends[k], ends[k + 1]});
  }
}

/// Each once, without overlaps: between two ends on the common line of two sheets is one trace, however many pairs
/// of coplanar faces found it.
void part_overlaps(const PointTable& t, std::vector<PlaneTrace>& traces) {
  sort_unique_in_parallel(traces);
  std::vector<PlaneTrace> parted;
  parted.reserve(traces.size());
  for (auto first = traces.begin(); first != traces.end();) {
    const auto last = std::find_if(first, traces.end(), [&](const PlaneTrace& x) {
      return std::tie(x.p, x.q) != std::tie(first->p, first->q);
    });
    if (last - first == 1) parted.push_back(*first);
    else part_overlaps(t, {first, last}, parted);
    first = last;
  }
  traces = std::move(parted);
}

/// Vertices of two leaves in one place are the kind of contact that no pair of elements is tested for. This is how
/// often a vertex of one leaf is a vertex of another (vertex-vertex in Gursoz et al. 1991): each place counts once
/// for every pair of leaves that have a corner, an end or a point there. Within a leaf equal points are one. Each
/// vertex is held by the leaf that comes first; who comes later is listed. Which leaf that is depends on the
/// threads, how many there are does not.
std::uint64_t shared_vertices(const Soup& soup, const RefineInput& in) {
  if (soup.leaf_count() < 2) return 0;
  constexpr std::uint32_t kFree = 0xffffffffu;
  using Later = std::vector<std::pair<VertexId, LeafId>>;
  std::vector<std::uint32_t> holders(in.points.size(), kFree);
  tbb::enumerable_thread_specific<Later> lists;
  const auto enter = [&](VertexId v, LeafId leaf) {
    const std::atomic_ref entry(holders[v.index()]);
    std::uint32_t holder = entry.load(std::memory_order_relaxed);
    if (holder == leaf.value()) return;
    if (holder == kFree && entry.compare_exchange_strong(holder, leaf.value(), std::memory_order_relaxed)) return;
    if (holder != leaf.value()) lists.local().emplace_back(v, leaf);
  };
  for_each_index(in.corners.size(), [&](std::size_t i) {
    const LeafId leaf = soup.face(SourceId(i)).leaf;
    if (leaf == soup.frame()) return;
    for (const VertexId v : in.corners[SourceId(i)]) {
      if (v.valid()) enter(v, leaf);
    }
  });
  for_each_of(soup.wires(), [&](const Soup::Wire& wire) {
    for (const PointId p : {wire.a, wire.b}) enter(in.vertex_of[p.index()], wire.leaf);
  });
  for_each_of(soup.isolated(), [&](const Soup::Isolated& p) { enter(in.vertex_of[p.point.index()], p.leaf); });
  Later later;
  for (const Later& list : lists) later.insert(later.end(), list.begin(), list.end());
  sort_unique(later);
  // The leaf that is the k-th one to come after the first makes a pair with each of the k before it.
  std::uint64_t count = 0, before = 0;
  for (std::size_t i = 0; i < later.size(); ++i) {
    before = i > 0 && later[i - 1].first == later[i].first ? before + 1 : 1;
    count += before;
  }
  return count;
}

/// All the state on the way from the soup to the refinement.
class Refiner {
 public:
  Refiner(const Soup& soup, RefineReport& report, const Watch& watch)
      : soup_(soup), report_(report), watch_(watch) {}
  Refinement run();

 private:
  void group_sheets();
  void place_contacts();
  void list_sheet_contents();
  void cross_sheets();
  void split_segments();
  void subdivide_sheets();

  using InSheet = std::vector<std::pair<VertexId, SheetId>>;
  void add_traces(InSheet& in_sheet);
  SheetContent content(std::size_t work) const;
  SourceId representative(SourceId f) const { return representative_[r_.sheet_of[f]]; }
  PointKey canonical(PointKey key) const;

  const Soup& soup_;
  RefineReport& report_;
  const Watch& watch_;
  Refinement r_;
  ContactList contacts_;
  UnionFind identity_;
  KeyedPoints contact_points_, crossing_points_;
  KnownIncidence known_;
  IdVector<SheetId, SourceId> representative_;
  std::vector<std::pair<SheetId, SegmentId>> sheet_segments_;
  std::vector<std::pair<SheetId, VertexId>> sheet_points_;
  std::vector<SheetId> work_;              // sheets that are more than one lone triangle
  Csr<SheetId, SegmentId> work_segments_;  // by index into work_
  Csr<SheetId, VertexId> work_points_;
  std::vector<Crossing> crossings_;
  std::vector<std::pair<SegmentId, VertexId>> incidences_;
  std::vector<SheetFaces> results_;  // by index into work_
};

Refinement Refiner::run() {
  watch_.begin("refine: input");
  r_.input = prepare_input(soup_, report_);
  contacts_ = find_contacts(r_.input, watch_);
  group_sheets();
  place_contacts();
  list_sheet_contents();
  cross_sheets();
  split_segments();
  subdivide_sheets();
  collect_faces(r_, representative_, work_, results_);
  return std::move(r_);
}

/// Coplanar faces that touch are one sheet; its plane is that of its first face.
void Refiner::group_sheets() {
  report_.candidates = contacts_.candidates;
  report_.contacts = contacts_.kinds;
  report_.contacts.back() = shared_vertices(soup_, r_.input);
  const std::size_t n = r_.input.corners.size();
  UnionFind joined(n);
  for (const auto& [f, g] : contacts_.coplanar) joined.unite(f.value(), g.value());
  r_.sheet_of.assign(n, SheetId::none());
  std::vector<std::uint32_t> begin{0, 0};  // by sheet, one place late
  for (const SourceId f : IdRange<SourceId>(n)) {
    if (r_.input.dropped(f)) continue;
    const SourceId root(joined.find(f.value()));
    if (root == f) {
      r_.sheet_of[f] = representative_.push_back(f);
      begin.push_back(0);
    }
    r_.sheet_of[f] = r_.sheet_of[root];
    ++begin[r_.sheet_of[f].index() + 2];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<SourceId> members(begin.back());
  for (const SourceId f : IdRange<SourceId>(n)) {
    if (!r_.input.dropped(f)) members[begin[r_.sheet_of[f].index() + 1]++] = f;
  }
  begin.pop_back();
  r_.sheet_faces = Csr<SheetId, SourceId>::from_parts(std::move(begin), std::move(members));
  for (const SourceId f : representative_) r_.sheet_plane.push_back(RefineInput::plane(f));
  r_.sheet_projection.resize(representative_.size());
  for_each_index(representative_.size(), [&](std::size_t i) {
    const SourceId f = representative_[SheetId(i)];
    r_.sheet_projection[SheetId(i)] =
        projection_of(r_.input.points, RefineInput::plane(f), r_.input.filters[f.index()]);
  });
  r_.input.filters = {};
}

/// The same key for a plane, whichever of its coplanar faces was met.
PointKey Refiner::canonical(PointKey key) const {
  if (key.kind == PointKey::Kind::segment_plane) key.id[1] = representative(SourceId(key.id[1])).value();
  return key;
}

/// Contact points become vertices; what is known by symbol is noted.
void Refiner::place_contacts() {
  std::vector<PointKey> keys;  // of points that are no vertex yet
  const auto take = [&](PointKey& key) {
    key = canonical(key);
    if (key.kind != PointKey::Kind::vertex) keys.push_back(key);
  };
  for (ContactList::Trace& t : contacts_.traces) {
    take(t.a);
    take(t.b);
  }
  for (ContactList::OnFace& p : contacts_.on_face) take(p.point);
  for (ContactList::OnWire& p : contacts_.on_wire) take(p.point);
  std::vector<std::pair<VertexId, SegmentId>> on_segment;
  InSheet in_sheet;
  identity_ = UnionFind(r_.input.points.size());
  contact_points_.add(r_.input.points, identity_, r_.input, keys);

  for (const PointKey& key : keys) {
    if (key.kind == PointKey::Kind::planes) continue;
    const VertexId v = contact_points_(key);
    on_segment.push_back({v, SegmentId(key.id[0])});
    if (key.kind == PointKey::Kind::segments) on_segment.push_back({v, SegmentId(key.id[1])});
  }
  for (const ContactList::OnWire& p : contacts_.on_wire) {
    on_segment.push_back({contact_points_(p.point), p.wire});
  }
  for (const ContactList::OnFace& p : contacts_.on_face) {
    const VertexId v = contact_points_(p.point);
    in_sheet.push_back({v, r_.sheet_of[p.face]});
    sheet_points_.push_back({r_.sheet_of[p.face], v});
  }
  for (const ContactList::WireInPlane& w : contacts_.wires_in_plane) {
    sheet_segments_.push_back({r_.sheet_of[w.face], w.wire});
  }
  add_traces(in_sheet);
  known_.segments = lists_of(r_.input.points.size(), on_segment);
  known_.sheets = lists_of(r_.input.points.size(), in_sheet);
  contacts_ = {};
}

/// The segments: those of the input, then the traces by their ends, each once however many pairs of faces found
/// it. A trace that is one point is a point of its sheets.
void Refiner::add_traces(InSheet& in_sheet) {
  r_.segments.ends = r_.input.segment_ends;
  r_.segments.input_count = r_.segments.ends.size();
  r_.segments.trace_sheets.assign(r_.segments.input_count, {SheetId::none(), SheetId::none()});
  std::vector<PlaneTrace> traces;
  for (const ContactList::Trace& t : contacts_.traces) {
    VertexId a = contact_points_(t.a), b = contact_points_(t.b);
    const SheetId p = r_.sheet_of[t.f], q = r_.sheet_of[t.g];
    if (a == b) {
      in_sheet.insert(in_sheet.end(), {{a, p}, {a, q}});
      sheet_points_.insert(sheet_points_.end(), {{p, a}, {q, a}});
      continue;
    }
    if (compare_lex(r_.input.points, a, b) > 0) std::swap(a, b);
    traces.push_back({std::min(p, q), std::max(p, q), a, b});
  }
  part_overlaps(r_.input.points, traces);
  const auto by_ends = [](const PlaneTrace& t) { return std::tuple(t.a, t.b, t.p, t.q); };
  tbb::parallel_sort(traces.begin(), traces.end(),
                     [&](const PlaneTrace& x, const PlaneTrace& y) { return by_ends(x) < by_ends(y); });
  for (std::size_t i = 0; i < traces.size();) {
    const PlaneTrace& first = traces[i];
    SegmentId s = r_.input.find_segment(first.a, first.b);
    if (!s.valid()) {
      s = r_.segments.ends.push_back({first.a, first.b});
      r_.segments.trace_sheets.push_back({first.p, first.q});
    }
    for (; i < traces.size() && traces[i].a == first.a && traces[i].b == first.b; ++i) {
      for (const SheetId sheet : {traces[i].p, traces[i].q}) {
        in_sheet.insert(in_sheet.end(), {{first.a, sheet}, {first.b, sheet}});
        sheet_segments_.push_back({sheet, s});
      }
    }
  }
}

/// A sheet of one triangle that meets nothing needs no work. All others list their sides, traces, wires, points.
void Refiner::list_sheet_contents() {
  const std::size_t n = representative_.size();
  std::vector<char> works(n, 0);
  for (const auto& [sheet, s] : sheet_segments_) works[sheet.index()] = 1;
  for (const auto& [sheet, v] : sheet_points_) works[sheet.index()] = 1;
  for (const SheetId sheet : IdRange<SheetId>(n)) {
    const auto faces = std::as_const(r_.sheet_faces)[sheet];
    if (faces.size() > 1 || std::as_const(r_.input.corners)[faces[0]].size() != 3) works[sheet.index()] = 1;
    if (works[sheet.index()] == 0) continue;
    work_.push_back(sheet);
    for (const SourceId f : faces) {
      for (const SegmentId s : std::as_const(r_.input.sides)[f]) {
        if (s.valid()) sheet_segments_.push_back({sheet, s});
      }
    }
  }
  std::vector<std::uint32_t> work_of(n, 0);
  for (std::size_t i = 0; i < work_.size(); ++i) work_of[work_[i].index()] = static_cast<std::uint32_t>(i);
  for (auto& [sheet, s] : sheet_segments_) sheet = SheetId(work_of[sheet.index()]);
  for (auto& [sheet, v] : sheet_points_) sheet = SheetId(work_of[sheet.index()]);
  work_segments_ = lists_of(work_.size(), sheet_segments_);
  work_points_ = lists_of(work_.size(), sheet_points_);
  sheet_segments_ = {};
  sheet_points_ = {};
}

SheetContent Refiner::content(std::size_t work) const {
  const SheetId sheet = work_[work];
  return {sheet,
          r_.sheet_plane[sheet],
          r_.sheet_projection[sheet],
          r_.sheet_faces[sheet],
          work_segments_[SheetId(work)],
          work_points_[SheetId(work)]};
}

/// Where segments of a sheet cross is a vertex; then it is known which points lie inside of which segment.
void Refiner::cross_sheets() {
  struct Found {
    std::vector<Crossing> crossings;
    std::vector<std::pair<SegmentId, VertexId>> incidences;
  };
  tbb::enumerable_thread_specific<Found> found;
  Steps steps(watch_, "refine: crossings", work_.size());
  tbb::parallel_for(std::size_t{0}, work_.size(), [&](std::size_t i) {
    Found& mine = found.local();
    find_crossings(content(i), r_.input.points, r_.segments, known_, representative_, mine.crossings,
                   mine.incidences);
    steps.step();
  });
  for (const Found& f : found) {
    crossings_.insert(crossings_.end(), f.crossings.begin(), f.crossings.end());
    incidences_.insert(incidences_.end(), f.incidences.begin(), f.incidences.end());
  }
  sort_unique_in_parallel(crossings_);
  std::vector<PointKey> keys;
  for (const Crossing& c : crossings_) keys.push_back(c.point);
  crossing_points_.add(r_.input.points, identity_, r_.input, keys);
  for (const Crossing& c : crossings_) {
    const VertexId v = crossing_points_(c.point);
    incidences_.push_back({c.s, v});
    incidences_.push_back({c.t, v});
  }
  for (const VertexId v : IdRange<VertexId>(known_.segments.size())) {
    for (const SegmentId s : std::as_const(known_.segments)[v]) incidences_.push_back({s, v});
  }
  std::erase_if(incidences_, [&](const auto& i) {
    const auto& ends = r_.segments.ends[i.first];
    return i.second == ends[0] || i.second == ends[1];
  });
}

/// Every segment is cut at its points, once, for all sheets; meanwhile the faces along each segment are listed.
void Refiner::split_segments() {
  const std::size_t n = r_.segments.ends.size();
  const Csr<SegmentId, VertexId> inner = lists_of(n, incidences_);
  incidences_ = {};
  tbb::parallel_invoke([&] { r_.edges = cut_segments(r_.input.points, r_.segments, inner); },
                       [&] { r_.segment_faces = faces_along(r_.input.sides, n); });
}

/// Each sheet by itself, from its cut segments to its faces.
void Refiner::subdivide_sheets() {
  results_.resize(work_.size());
  const SubdivisionContext context{r_.input, r_.segments, r_.edges, r_.segment_faces, r_.sheet_of};
  tbb::enumerable_thread_specific<Subdivider> subdividers([&] { return Subdivider(context); });
  Steps steps(watch_, "refine: faces", work_.size());
  tbb::parallel_for(std::size_t{0}, work_.size(), [&](std::size_t i) {
    results_[i] = subdividers.local().subdivide(content(i));
    steps.step();
  });
}

}  // namespace

Refinement refine(const Soup& soup, RefineReport& report, const Watch& watch) {
  return Refiner(soup, report, watch).run();
}

}  // namespace cnrg
