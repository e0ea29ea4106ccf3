// The soup made ready, in four steps: points become vertices, faces lose repeated corners, each face gets its
// plane or is dropped, and sides and wires become segments.
//
// One vertex per distinct point: doubles by a hash of their bits, rationals by exact order (a point that is not
// three doubles can never equal one that is). Vertices are numbered by first appearance.
#include "kernel/refine/input.h"

#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <bit>
#include <cmath>
#include <map>

#include "kernel/base/leaf_words.h"
#include "kernel/base/parallel.h"
#include "kernel/base/point_hash.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/predicates.h"

namespace cnrg {

namespace {

/// Points of doubles by value. All points are entered at once, by any number of threads; equal ones share a slot,
/// which keeps the smallest number. A NumberTable is for one thread.
class EqualPoints {
 public:
  explicit EqualPoints(const Soup& soup)
      : soup_(soup), slots_(std::bit_ceil(2 * soup.point_count() + 1)), mask_(slots_.size() - 1) {
    for_each_index(slots_.size(), [&](std::size_t i) { slots_[i] = kFree; });
  }
  /// Enters point i; returns its slot.
  std::uint32_t enter(std::uint32_t i) {
    const std::array<double, 3> c = at(i);
    for (std::size_t slot = hash_of_point(c.data()) & mask_;; slot = (slot + 1) & mask_) {
      const std::atomic_ref entry(slots_[slot]);
      std::uint32_t holder = entry.load(std::memory_order_relaxed);
      if (holder == kFree && entry.compare_exchange_strong(holder, i, std::memory_order_relaxed)) {
        return static_cast<std::uint32_t>(slot);
      }
      if (at(holder) != c) continue;
      while (i < holder && !entry.compare_exchange_weak(holder, i, std::memory_order_relaxed)) {
      }
      return static_cast<std::uint32_t>(slot);
    }
  }
  /// The smallest number of the points that share a slot, once all are entered.
  std::uint32_t first(std::uint32_t slot) const { return slots_[slot]; }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffu;
  std::array<double, 3> at(std::uint32_t i) const {
    const double* c = soup_.xyz(PointId(i));
    return {c[0], c[1], c[2]};
  }

  const Soup& soup_;
  std::vector<std::uint32_t> slots_;
  std::size_t mask_;
};

void identify_points(const Soup& soup, RefineInput& in) {
  const std::size_t n = soup.point_count();
  std::vector<std::uint32_t> first(n);
  {
    EqualPoints equal(soup);
    for_each_index(n, [&](std::size_t i) {
      if (soup.rational(PointId(i)) == nullptr) first[i] = equal.enter(static_cast<std::uint32_t>(i));
    });
    for_each_index(n, [&](std::size_t i) {
      if (soup.rational(PointId(i)) == nullptr) first[i] = equal.first(first[i]);
    });
  }
  in.vertex_of.resize(n);
  in.points.reserve(n);
  std::map<RationalPoint, VertexId> rationals;
  for (std::size_t i = 0; i < n; ++i) {
    const PointId p(i);
    if (const RationalPoint* r = soup.rational(p)) {
      const auto [it, fresh] = rationals.try_emplace(*r, VertexId());
      if (fresh) it->second = in.points.add(*r);
      in.vertex_of[i] = it->second;
    } else if (first[i] == i) {
      const double* c = soup.xyz(p);
      in.vertex_of[i] = in.points.add(c[0] + 0.0, c[1] + 0.0, c[2] + 0.0);
    } else {
      in.vertex_of[i] = in.vertex_of[first[i]];
    }
  }
}

/// The corners of a face as vertices, repeated neighbours and loops of fewer than three corners removed.
void clean_corners(std::span<const PointId> corners, const std::vector<VertexId>& vertex_of,
                   std::vector<VertexId>& out) {
  out.clear();
  std::size_t loop_begin = 0;
  const auto end_loop = [&] {
    while (out.size() > loop_begin + 1 && out.back() == out[loop_begin]) out.pop_back();
    if (out.size() < loop_begin + 3) out.resize(loop_begin > 0 ? loop_begin - 1 : 0);  // with the separator
  };
  for (const PointId p : corners) {
    if (!p.valid()) {
      end_loop();
      if (!out.empty()) out.push_back(VertexId::none());
      loop_begin = out.size();
      continue;
    }
    const VertexId v = vertex_of[p.index()];
    if (out.size() == loop_begin || out.back() != v) out.push_back(v);
  }
  end_loop();
}

/// Sign of the first loop's area as seen along the plane's projection; 0 only if it vanishes exactly.
int orientation(const PointTable& t, Projection axes, std::span<const VertexId> corners) {
  const std::size_t n =
      static_cast<std::size_t>(std::find(corners.begin(), corners.end(), VertexId::none()) - corners.begin());
  double area = 0, size = 0, lengths = 0, width = 0;
  const auto o = t.approx(corners[0]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const auto p = t.approx(corners[i]), q = t.approx(corners[i + 1]);
    const double a = (p[axes.u] - o[axes.u]) * (q[axes.v] - o[axes.v]);
    const double b = (p[axes.v] - o[axes.v]) * (q[axes.u] - o[axes.u]);
    area += a - b;
    size += std::fabs(a) + std::fabs(b);
    for (const auto* r : {&p, &q})
      lengths += std::fabs((*r)[axes.u] - o[axes.u]) + std::fabs((*r)[axes.v] - o[axes.v]);
  }
  for (std::size_t i = 0; i < n; ++i) width = std::max(width, width_of(t, corners[i]));
  // Of exact coordinates the error is at most about (n + 4) 2^-53 of the sum of sizes, 1.2e-9 for ten million
  // corners. With a width w differences are off by w, products by w times the sum of both and w^2. The bound is
  // far above; what is closer is decided exactly.
  const double bound = 1e-8 * size + 2 * width * (lengths + static_cast<double>(n) * width);
  if (std::isfinite(size) && size > 1e-200 && n < 10000000 && std::fabs(area) > bound) return area > 0 ? 1 : -1;
  Rational exact = 0;
  const RationalPoint eo = t.rational(corners[0]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const RationalPoint p = t.rational(corners[i]), q = t.rational(corners[i + 1]);
    exact +=
        (p[axes.u] - eo[axes.u]) * (q[axes.v] - eo[axes.v]) - (p[axes.v] - eo[axes.v]) * (q[axes.u] - eo[axes.u]);
  }
  return sgn(exact);
}

LeafWords face_name(const Soup& soup, SourceId f) {
  const Soup::Face& face = soup.face(f);
  return LeafPlace{face.leaf.value(), {face.leaf_face}};
}

PlaneFilter filter_of(const PointTable& t, const std::array<VertexId, 3>& plane) {
  const double width = std::max({width_of(t, plane[0]), width_of(t, plane[1]), width_of(t, plane[2])});
  return PlaneFilter(t.lower(plane[0]), t.lower(plane[1]), t.lower(plane[2]), width);
}

/// The first corner that does not lie on the plane; corners.size() if all do.
std::size_t off_plane(const PointTable& t, std::span<const VertexId> corners,
                      const std::array<VertexId, 3>& plane) {
  std::size_t i = 0;
  while (i < corners.size() &&
         (!corners[i].valid() || orient3d(t, plane[0], plane[1], plane[2], corners[i]) == 0)) {
    ++i;
  }
  return i;
}

enum class Shape : char { planar, flat, warped };

/// Finds three corners that span the plane, ordered as in the face, and the plane's filter.
Shape span_plane(const PointTable& t, std::span<const VertexId> corners, std::array<VertexId, 3>& plane,
                 PlaneFilter& filter) {
  if (corners.empty()) return Shape::flat;
  if (corners.size() == 3) {
    plane = {corners[0], corners[1], corners[2]};
    filter = filter_of(t, plane);
    for (int k = 0; k < 3; ++k) {
      if (filter.normal_sign(k) != 0) return Shape::planar;
    }
    return collinear(t, plane[0], plane[1], plane[2]) ? Shape::flat : Shape::planar;
  }
  const VertexId a = corners[0], b = corners[1];
  std::size_t i = 2;
  while (i < corners.size() &&
         (!corners[i].valid() || corners[i] == a || corners[i] == b || collinear(t, a, b, corners[i]))) {
    ++i;
  }
  if (i == corners.size()) return Shape::flat;
  plane = {a, b, corners[i]};
  filter = filter_of(t, plane);
  return off_plane(t, corners, plane) < corners.size() ? Shape::warped : Shape::planar;
}

/// Corners of all faces, cleaned.
void take_corners(const Soup& soup, RefineInput& in) {
  const std::size_t n = soup.face_count();
  const auto clean_triangle = [&](std::span<const PointId> c) {
    if (c.size() != 3 || !c[0].valid() || !c[1].valid() || !c[2].valid()) return false;
    const VertexId u = in.vertex_of[c[0].index()], v = in.vertex_of[c[1].index()], w = in.vertex_of[c[2].index()];
    return u != v && v != w && w != u;
  };
  tbb::enumerable_thread_specific<std::vector<VertexId>> scratch;
  std::vector<std::uint32_t> offsets(n + 1, 0);
  for_each_index(n, [&](std::size_t i) {
    const auto c = soup.corners(SourceId(i));
    std::size_t count = 3;
    if (!clean_triangle(c)) {
      clean_corners(c, in.vertex_of, scratch.local());
      count = scratch.local().size();
    }
    offsets[i + 1] = static_cast<std::uint32_t>(count);
  });
  sum_up(offsets, "corners of faces");
  std::vector<VertexId> corners(offsets[n]);
  for_each_index(n, [&](std::size_t i) {
    const auto c = soup.corners(SourceId(i));
    VertexId* out = corners.data() + offsets[i];
    if (clean_triangle(c)) {
      for (std::size_t k = 0; k < 3; ++k) out[k] = in.vertex_of[c[k].index()];
    } else {
      clean_corners(c, in.vertex_of, scratch.local());
      std::copy(scratch.local().begin(), scratch.local().end(), out);
    }
  });
  in.corners = Csr<SourceId, VertexId>::from_parts(std::move(offsets), std::move(corners));
}

/// Planes and their filters. Faces without area lose their corners; the normal of a polygon agrees with its first
/// loop.
void take_planes(const Soup& soup, RefineInput& in, RefineReport& report) {
  const std::size_t n = soup.face_count();
  const PointTable& t = in.points;
  const auto told = [&](std::size_t i) { return soup.plane(SourceId(i)); };
  std::vector<std::array<VertexId, 3>> planes(n, {VertexId(0), VertexId(0), VertexId(0)});
  std::vector<Shape> shape(n);
  in.filters.resize(n);
  const auto& corners = std::as_const(in.corners);
  for_each_index(n, [&](std::size_t i) {
    if (const std::array<PointId, 3>* plane = told(i)) {
      for (std::size_t k = 0; k < 3; ++k) planes[i][k] = in.vertex_of[(*plane)[k].index()];
      in.filters[i] = filter_of(t, planes[i]);
      shape[i] = Shape::planar;
    } else {
      shape[i] = span_plane(t, corners[SourceId(i)], planes[i], in.filters[i]);
    }
  });
  for (std::size_t i = 0; i < n; ++i) {
    if (shape[i] != Shape::warped) continue;
    throw LeafError(face_name(soup, SourceId(i)) + ": the face is not planar: its corner " +
                    std::to_string(off_plane(t, corners[SourceId(i)], planes[i]) + 1) +
                    " is off the plane of the corners before; triangulate the face or correct the point");
  }
  in.points.set_planes(std::move(planes));
  tbb::enumerable_thread_specific<std::vector<SourceId>> turned;
  for_each_index(n, [&](std::size_t i) {
    const auto c = corners[SourceId(i)];
    if (shape[i] == Shape::flat || c.size() == 3 || told(i) != nullptr) return;
    if (orientation(t, projection_of(t, PlaneId(i)), c) < 0) turned.local().push_back(SourceId(i));
  });
  for (const auto& list : turned) {
    for (const SourceId f : list) {
      in.points.turn_plane(PlaneId(f.index()));
      in.filters[f.index()] = filter_of(t, t.plane_points(PlaneId(f.index())));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (shape[i] == Shape::flat) report.zero_area.push_back(SourceId(i));
  }
  if (report.zero_area.empty()) return;
  Csr<SourceId, VertexId> kept;
  for (const SourceId f : IdRange<SourceId>(n)) {
    kept.push_back(shape[f.index()] == Shape::flat ? std::span<const VertexId>() : corners[f]);
  }
  in.corners = std::move(kept);
}

/// Segments: every side of a face and every wire, once. Sides are gathered at their end of the smaller id, then
/// each such list is put in order by itself.
class Segments {
 public:
  Segments(const Soup& soup, RefineInput& in) : soup_(soup), in_(in), side_count_(in.corners.value_count()) {}

  void run() {
    list_ends();
    gather();
    number();
  }

 private:
  using Place = std::uint32_t;  // in `sides`, or side_count_ + wire

  /// Both ends of every side and wire, the smaller id first; none() for what is no segment.
  void list_ends() {
    check_count(side_count_ + std::uint64_t{soup_.wires().size()}, "sides of faces and wires", kMostPlaces);
    ends_.resize(side_count_ + soup_.wires().size());
    const auto& corners = std::as_const(in_.corners);
    for_each_index(corners.size(), [&](std::size_t f) {
      const auto c = corners[SourceId(f)];
      const std::size_t base = corners.offsets()[f];
      std::size_t loop_begin = 0;
      for (std::size_t i = 0; i < c.size(); ++i) {
        if (!c[i].valid()) {
          loop_begin = i + 1;
          continue;
        }
        const VertexId next = i + 1 < c.size() && c[i + 1].valid() ? c[i + 1] : c[loop_begin];
        ends_[base + i] = std::minmax(c[i], next);
      }
    });
    for (std::size_t w = 0; w < soup_.wires().size(); ++w) {
      const VertexId a = in_.vertex_of[soup_.wires()[w].a.index()], b = in_.vertex_of[soup_.wires()[w].b.index()];
      if (a == b) in_.isolated.push_back(a);
      else ends_[side_count_ + w] = std::minmax(a, b);
    }
  }

  void gather() {
    const std::size_t vertices = in_.points.size();
    begin_.assign(vertices + 1, 0);
    for (const auto& [low, high] : ends_) {
      if (low.valid()) ++begin_[low.index() + 1];
    }
    sum_up(begin_, "sides of faces");
    at_.resize(begin_[vertices]);
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t place = 0; place < ends_.size(); ++place) {
      const auto& [low, high] = ends_[place];
      if (low.valid()) at_[next[low.index()]++] = std::uint64_t{high.value()} << 32 | place;
    }
    in_.segment_begin.assign(vertices + 1, 0);
    for_each_index(vertices, [&](std::size_t v) {
      const auto first = at_.begin() + begin_[v], last = at_.begin() + begin_[v + 1];
      std::sort(first, last);
      std::uint32_t count = 0;
      for (auto i = first; i != last; ++i) count += i == first || *i >> 32 != *(i - 1) >> 32;
      in_.segment_begin[v + 1] = count;
    });
    sum_up(in_.segment_begin, "segments");
  }

  void number() {
    const PointTable& t = in_.points;
    std::vector<SegmentId> sides(side_count_);
    in_.segment_ends.resize(in_.segment_begin.back());
    in_.paired.assign(in_.segment_ends.size(), 0);
    in_.wire_segment.assign(soup_.wires().size(), SegmentId::none());
    for_each_index(t.size(), [&](std::size_t v) {
      SegmentId s(in_.segment_begin[v]);
      for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++s) {
        const std::size_t first = i;
        std::size_t forward = 0;
        for (; i < begin_[v + 1] && at_[i] >> 32 == at_[first] >> 32; ++i) {
          const Place place = static_cast<Place>(at_[i]);
          if (place < side_count_) {
            sides[place] = s;
            forward += in_.corners.values()[place] == VertexId(v);
          } else {
            in_.wire_segment[place - side_count_] = s;
          }
        }
        in_.paired[s] = i - first == 2 && forward == 1 && static_cast<Place>(at_[i - 1]) < side_count_;
        const VertexId low(v), high(at_[first] >> 32);
        in_.segment_ends[s] = compare_lex(t, low, high) > 0 ? std::array{high, low} : std::array{low, high};
      }
    });
    in_.sides = Csr<SourceId, SegmentId>::from_parts(in_.corners.offsets(), std::move(sides));
    for (const SegmentId s : in_.wire_segment) {
      if (s.valid()) in_.wires.push_back(s);
    }
    sort_unique(in_.wires);
  }

  const Soup& soup_;
  RefineInput& in_;
  std::size_t side_count_;
  std::vector<std::pair<VertexId, VertexId>> ends_;  // by place
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint64_t> at_;  // at the smaller end: the other end, then the place
};

}  // namespace

SegmentId RefineInput::find_segment(VertexId a, VertexId b) const {
  if (b < a) std::swap(a, b);
  if (a.index() + 1 >= segment_begin.size()) return SegmentId::none();  // a constructed vertex
  const auto first = segment_ends.begin() + segment_begin[a.index()];
  const auto last = segment_ends.begin() + segment_begin[a.index() + 1];
  const auto other = [a](const std::array<VertexId, 2>& ends) { return ends[0] == a ? ends[1] : ends[0]; };
  const auto it = std::lower_bound(first, last, b, [&](const auto& ends, VertexId v) { return other(ends) < v; });
  if (it == last || other(*it) != b) return SegmentId::none();
  return SegmentId(static_cast<std::size_t>(it - segment_ends.begin()));
}

RefineInput prepare_input(const Soup& soup, RefineReport& report) {
  RefineInput in;
  identify_points(soup, in);
  take_corners(soup, in);
  take_planes(soup, in, report);
  Segments(soup, in).run();
  for (const Soup::Isolated& p : soup.isolated()) in.isolated.push_back(in.vertex_of[p.point.index()]);
  sort_unique(in.isolated);
  return in;
}

}  // namespace cnrg
