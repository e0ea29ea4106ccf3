// The driver of refinement: symbols first, coordinates where a decision needs them, one subdivision per sheet.
//
// Why points meet: two constructed points that coincide lie in faces that touch there pairwise, so both are known
// in a common sheet; every sheet therefore subdivides a common line at the same vertices. Segments are split once,
// for all sheets that hold them.
#include "kernel/refine/refine.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <numeric>

#include "kernel/base/error.h"
#include "kernel/base/parallel.h"
#include "kernel/base/union_find.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/contacts.h"
#include "kernel/refine/edges.h"
#include "kernel/refine/faces.h"
#include "kernel/refine/identity.h"

namespace cnrg {

namespace {

template <class T>
void sort_unique(std::vector<T>& list) {
  tbb::parallel_sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// For each first id below n the second ids of the pairs, ascending and unique.
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

/// The place of each key in a list.
class KeyPlaces {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// Without keys, with room for `most`.
  explicit KeyPlaces(std::size_t most = 0) : slots_(std::bit_ceil(2 * most + 1), kNone) {}
  /// Appends the key to the list unless it is in it.
  void add(const PointKey& key, std::vector<PointKey>& list) {
    std::uint32_t& place = slots_[slot_of(key, list)];
    if (place != kNone) return;
    place = static_cast<std::uint32_t>(list.size());
    list.push_back(key);
  }
  std::uint32_t find(const PointKey& key, const std::vector<PointKey>& list) const {
    return slots_[slot_of(key, list)];
  }

 private:
  std::size_t slot_of(const PointKey& key, const std::vector<PointKey>& list) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = key.hash() & mask;
    while (slots_[slot] != kNone && !(list[slots_[slot]] == key)) slot = (slot + 1) & mask;
    return slot;
  }
  std::vector<std::uint32_t> slots_;
};

/// Vertices of keys: new points are added in the order of their keys, then united with what coincides.
class KeyedPoints {
 public:
  void add(PointTable& table, UnionFind& identity, const RefineInput& in, const std::vector<PointKey>& keys) {
    collect(keys);
    std::vector<std::array<double, 3>> lo(keys_.size()), hi(keys_.size());
    tbb::parallel_for(std::size_t{0}, keys_.size(),
                      [&](std::size_t i) { table.enclose(definition_of(keys_[i], in), lo[i], hi[i]); });
    first_ = VertexId(table.size());
    identity_ = &identity;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      table.add(definition_of(keys_[i], in), lo[i], hi[i]);
      identity.add();
    }
    unite_coincident(table, first_, identity);
  }
  VertexId operator()(const PointKey& key) const {
    if (key.kind == PointKey::Kind::vertex) return VertexId(key.id[0]);
    const std::uint32_t place = places_.find(key, keys_);
    require(place != KeyPlaces::kNone, "a point key was never made");
    return VertexId(identity_->find(first_.value() + place));
  }

 private:
  void collect(const std::vector<PointKey>& keys) {
    KeyPlaces seen(keys.size());
    for (const PointKey& key : keys) {
      if (key.kind != PointKey::Kind::vertex) seen.add(key, keys_);
    }
    std::vector<PointKey> sorted = keys_;
    tbb::parallel_sort(sorted.begin(), sorted.end());
    keys_.clear();
    places_ = KeyPlaces(sorted.size());
    for (const PointKey& key : sorted) places_.add(key, keys_);
  }

  std::vector<PointKey> keys_;  // ascending
  KeyPlaces places_;
  VertexId first_;
  UnionFind* identity_ = nullptr;
};

/// All the state on the way from the soup to the refinement.
class Refiner {
 public:
  Refiner(const Soup& soup, RefineReport& report) : soup_(soup), report_(report) {}
  Refinement run();

 private:
  void group_sheets();
  void place_contacts();
  void list_sheet_contents();
  void cross_sheets();
  void split_segments();
  void subdivide_sheets();

  SheetContent content(std::size_t work) const;
  SourceId representative(SourceId f) const { return representative_[r_.sheet_of[f]]; }
  PointKey canonical(PointKey key) const;

  const Soup& soup_;
  RefineReport& report_;
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
  r_.input = prepare_input(soup_, report_);
  contacts_ = find_contacts(r_.input);
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

/// Contact points become vertices; traces become segments; what is known by symbol is noted.
void Refiner::place_contacts() {
  std::vector<PointKey> keys;
  for (ContactList::Trace& t : contacts_.traces) {
    t.a = canonical(t.a);
    t.b = canonical(t.b);
    keys.push_back(t.a);
    keys.push_back(t.b);
  }
  for (ContactList::OnFace& p : contacts_.on_face) keys.push_back(p.point = canonical(p.point));
  for (ContactList::OnWire& p : contacts_.on_wire) keys.push_back(p.point = canonical(p.point));
  std::vector<std::pair<VertexId, SegmentId>> on_segment;
  std::vector<std::pair<VertexId, SheetId>> in_sheet;
  identity_ = UnionFind(r_.input.points.size());
  contact_points_.add(r_.input.points, identity_, r_.input, keys);

  for (const PointKey& key : keys) {
    if (key.kind == PointKey::Kind::vertex || key.kind == PointKey::Kind::planes) continue;
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

  // Traces by their ends: one segment however many pairs of faces found it.
  r_.segments.ends = r_.input.segment_ends;
  r_.segments.input_count = r_.segments.ends.size();
  r_.segments.trace_sheets.assign(r_.segments.input_count, {SheetId::none(), SheetId::none()});
  struct Trace {
    VertexId a, b;
    SheetId p, q;
    auto operator<=>(const Trace&) const = default;
  };
  std::vector<Trace> traces;
  for (const ContactList::Trace& t : contacts_.traces) {
    VertexId a = contact_points_(t.a), b = contact_points_(t.b);
    const SheetId p = r_.sheet_of[t.f], q = r_.sheet_of[t.g];
    for (const SheetId s : {p, q}) {
      in_sheet.push_back({a, s});
      in_sheet.push_back({b, s});
    }
    if (a == b) {
      sheet_points_.insert(sheet_points_.end(), {{p, a}, {q, a}});
      continue;
    }
    if (compare_lex(r_.input.points, a, b) > 0) std::swap(a, b);
    traces.push_back({a, b, std::min(p, q), std::max(p, q)});
  }
  sort_unique(traces);
  for (std::size_t i = 0; i < traces.size();) {
    const Trace& first = traces[i];
    SegmentId s = r_.input.find_segment(first.a, first.b);
    if (!s.valid()) {
      s = r_.segments.ends.push_back({first.a, first.b});
      r_.segments.trace_sheets.push_back({first.p, first.q});
    }
    for (; i < traces.size() && traces[i].a == first.a && traces[i].b == first.b; ++i) {
      sheet_segments_.push_back({traces[i].p, s});
      sheet_segments_.push_back({traces[i].q, s});
    }
  }
  known_.segments = lists_of(r_.input.points.size(), on_segment);
  known_.sheets = lists_of(r_.input.points.size(), in_sheet);
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

void Refiner::cross_sheets() {
  struct Found {
    std::vector<Crossing> crossings;
    std::vector<std::pair<SegmentId, VertexId>> incidences;
  };
  tbb::enumerable_thread_specific<Found> found;
  tbb::parallel_for(std::size_t{0}, work_.size(), [&](std::size_t i) {
    Found& mine = found.local();
    find_crossings(content(i), r_.input.points, r_.segments, known_, representative_, mine.crossings,
                   mine.incidences);
  });
  for (const Found& f : found) {
    crossings_.insert(crossings_.end(), f.crossings.begin(), f.crossings.end());
    incidences_.insert(incidences_.end(), f.incidences.begin(), f.incidences.end());
  }
  sort_unique(crossings_);
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

void Refiner::subdivide_sheets() {
  results_.resize(work_.size());
  const SubdivisionContext context{r_.input, r_.segments, r_.edges, r_.segment_faces, r_.sheet_of};
  tbb::enumerable_thread_specific<Subdivider> subdividers([&] { return Subdivider(context); });
  tbb::parallel_for(std::size_t{0}, work_.size(),
                    [&](std::size_t i) { results_[i] = subdividers.local().subdivide(content(i)); });
}

}  // namespace

Refinement refine(const Soup& soup, RefineReport& report) { return Refiner(soup, report).run(); }

}  // namespace cnrg
