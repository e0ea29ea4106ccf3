// One vertex per distinct point: doubles by a hash of their bits, rationals by exact order (a point that is not
// three doubles can never equal one that is). Vertices are numbered by first appearance.
#include "kernel/refine/input.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "kernel/base/error.h"

namespace cnrg {

namespace {

std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 31;
  h *= 0x9e3779b97f4a7c15ull;
  h ^= h >> 29;
  return h;
}

void identify_points(const Soup& soup, RefineInput& in) {
  const std::size_t n = soup.point_count();
  in.vertex_of.resize(n);
  in.points.reserve(n);
  const std::size_t capacity = std::bit_ceil(2 * n + 1);
  std::vector<std::uint32_t> table(capacity, 0xffffffffu);
  std::vector<std::array<double, 3>> keys;  // by slot value: index into keys
  std::vector<VertexId> vertex_of_key;
  keys.reserve(n);
  std::map<RationalPoint, VertexId> rationals;
  for (std::size_t i = 0; i < n; ++i) {
    const PointId p(i);
    if (const RationalPoint* r = soup.rational(p)) {
      const auto [it, fresh] = rationals.try_emplace(*r, VertexId());
      if (fresh) it->second = in.points.add(*r);
      in.vertex_of[i] = it->second;
      continue;
    }
    std::array<double, 3> c;
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) {
      c[k] = soup.xyz(p)[k] + 0.0;  // -0 is 0
      hash = mix(hash ^ std::bit_cast<std::uint64_t>(c[k]));
    }
    std::size_t slot = hash & (capacity - 1);
    while (table[slot] != 0xffffffffu && keys[table[slot]] != c) slot = (slot + 1) & (capacity - 1);
    if (table[slot] == 0xffffffffu) {
      table[slot] = static_cast<std::uint32_t>(keys.size());
      keys.push_back(c);
      vertex_of_key.push_back(in.points.add(c[0], c[1], c[2]));
    }
    in.vertex_of[i] = vertex_of_key[table[slot]];
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
  double area = 0, size = 0;
  const auto o = t.approx(corners[0]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const auto p = t.approx(corners[i]), q = t.approx(corners[i + 1]);
    const double a = (p[axes.u] - o[axes.u]) * (q[axes.v] - o[axes.v]);
    const double b = (p[axes.v] - o[axes.v]) * (q[axes.u] - o[axes.u]);
    area += a - b;
    size += std::fabs(a) + std::fabs(b);
  }
  // The sum of n terms, each with a few roundings of points good to 2^-52: far below 1e-10 of the sizes' sum for
  // faces of up to a million corners; anything closer is decided exactly.
  if (std::isfinite(size) && size > 1e-200 && n < 1000000 && std::fabs(area) > 1e-8 * size &&
      std::all_of(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(n),
                  [&](VertexId v) { return t.is_double(v); })) {
    return area > 0 ? 1 : -1;
  }
  Rational exact = 0;
  const RationalPoint eo = t.rational(corners[0]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const RationalPoint p = t.rational(corners[i]), q = t.rational(corners[i + 1]);
    exact += (p[axes.u] - eo[axes.u]) * (q[axes.v] - eo[axes.v]) - (p[axes.v] - eo[axes.v]) * (q[axes.u] - eo[axes.u]);
  }
  return sgn(exact);
}

std::string face_name(const Soup& soup, SourceId f) {
  const Soup::Face& face = soup.face(f);
  return "leaf " + std::to_string(face.leaf.value()) + ", face " + std::to_string(face.leaf_face);
}

/// Three corners that span the plane, ordered so that the first loop is counter-clockwise; false: no area.
bool spanning_corners(const Soup& soup, const PointTable& t, SourceId f, std::span<const VertexId> corners,
                      std::array<VertexId, 3>& plane) {
  const VertexId a = corners[0];
  VertexId b = a, c = a;
  std::size_t i = 1;
  b = corners[i++];
  for (; i < corners.size(); ++i) {
    if (corners[i].valid() && corners[i] != a && corners[i] != b && !collinear(t, a, b, corners[i])) {
      c = corners[i];
      break;
    }
  }
  if (c == a) return false;
  plane = {a, b, c};
  if (corners.size() == 3) return true;
  for (; i < corners.size(); ++i) {
    if (corners[i].valid() && orient3d(t, a, b, c, corners[i]) != 0) {
      throw InputError(face_name(soup, f) + ": the face is not planar: its corner " + std::to_string(i + 1) +
                       " is off the plane of the corners before; triangulate the face or correct the point");
    }
  }
  return true;
}

}  // namespace

SegmentId RefineInput::find_segment(VertexId a, VertexId b) const {
  const std::uint64_t k = key(a, b);
  const auto it = std::lower_bound(segment_key.begin(), segment_key.end(), k);
  if (it == segment_key.end() || *it != k) return SegmentId::none();
  return SegmentId(static_cast<std::size_t>(it - segment_key.begin()));
}

RefineInput prepare_input(const Soup& soup, RefineReport& report) {
  RefineInput in;
  identify_points(soup, in);

  // Faces and planes.
  const std::size_t face_count = soup.face_count();
  std::vector<std::uint32_t> offsets{0};
  std::vector<VertexId> corners, cleaned;
  offsets.reserve(face_count + 1);
  corners.reserve(3 * face_count);
  std::vector<std::array<VertexId, 3>> planes(face_count);
  for (std::size_t i = 0; i < face_count; ++i) {
    const SourceId f(i);
    clean_corners(soup.corners(f), in.vertex_of, cleaned);
    corners.insert(corners.end(), cleaned.begin(), cleaned.end());
    offsets.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  in.corners = Csr<SourceId, VertexId>::from_parts(std::move(offsets), std::move(corners));
  std::vector<char> flat(face_count, 0);
  tbb::parallel_for(std::size_t{0}, face_count, [&](std::size_t i) {
    const auto c = std::as_const(in.corners)[SourceId(i)];
    flat[i] = c.empty() || !spanning_corners(soup, in.points, SourceId(i), c, planes[i]);
  });
  for (const auto& p : planes) {
    in.points.add_plane(p[0].valid() ? p[0] : VertexId(0), p[1].valid() ? p[1] : VertexId(0),
                        p[2].valid() ? p[2] : VertexId(0));
  }
  // Polygons: the plane's normal must agree with the first loop. Flat faces lose their corners.
  std::vector<char> turn(face_count, 0);
  tbb::parallel_for(std::size_t{0}, face_count, [&](std::size_t i) {
    const auto c = std::as_const(in.corners)[SourceId(i)];
    if (flat[i] || c.size() == 3) return;
    turn[i] = orientation(in.points, projection_of(in.points, PlaneId(i)), c) < 0;
  });
  bool any_flat = false;
  for (std::size_t i = 0; i < face_count; ++i) {
    if (flat[i]) {
      report.zero_area.push_back(SourceId(i));
      any_flat = true;
    }
    if (turn[i]) in.points.turn_plane(PlaneId(i));
  }
  if (any_flat) {
    Csr<SourceId, VertexId> kept;
    const auto& all = std::as_const(in.corners);
    for (const SourceId f : IdRange<SourceId>(face_count)) {
      kept.push_back(flat[f.index()] ? std::span<const VertexId>() : all[f]);
    }
    in.corners = std::move(kept);
  }

  // Segments: every side of a face and every wire, once.
  struct Side {
    std::uint64_t key;
    std::uint32_t place;  // in sides, or sides.size() + wire
  };
  std::vector<Side> order;
  std::vector<SegmentId> sides(in.corners.value_count());
  order.reserve(sides.size() + soup.wires().size());
  const auto& corner_csr = std::as_const(in.corners);
  for (const SourceId f : IdRange<SourceId>(face_count)) {
    const auto c = corner_csr[f];
    const std::uint32_t base = in.corners.offsets()[f.index()];
    std::size_t loop_begin = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (!c[i].valid()) {
        loop_begin = i + 1;
        continue;
      }
      const VertexId next = i + 1 < c.size() && c[i + 1].valid() ? c[i + 1] : c[loop_begin];
      order.push_back({RefineInput::key(c[i], next), base + static_cast<std::uint32_t>(i)});
    }
  }
  in.wire_segment.assign(soup.wires().size(), SegmentId::none());
  for (std::size_t w = 0; w < soup.wires().size(); ++w) {
    const VertexId a = in.vertex_of[soup.wires()[w].a.index()], b = in.vertex_of[soup.wires()[w].b.index()];
    if (a == b) {
      in.isolated.push_back(a);
    } else {
      order.push_back({RefineInput::key(a, b), static_cast<std::uint32_t>(sides.size() + w)});
    }
  }
  tbb::parallel_sort(order.begin(), order.end(),
                     [](const Side& a, const Side& b) { return a.key != b.key ? a.key < b.key : a.place < b.place; });
  for (const Side& s : order) {
    if (in.segment_key.empty() || in.segment_key.back() != s.key) {
      in.segment_key.push_back(s.key);
      VertexId a(s.key >> 32), b(s.key & 0xffffffffu);
      if (compare_lex(in.points, a, b) > 0) std::swap(a, b);
      in.segment_ends.push_back({a, b});
    }
    const SegmentId id(in.segment_key.size() - 1);
    if (s.place < sides.size()) {
      sides[s.place] = id;
    } else {
      in.wire_segment[s.place - sides.size()] = id;
      in.wires.push_back(id);
    }
  }
  in.sides = Csr<SourceId, SegmentId>::from_parts(in.corners.offsets(), std::move(sides));
  std::sort(in.wires.begin(), in.wires.end());
  in.wires.erase(std::unique(in.wires.begin(), in.wires.end()), in.wires.end());
  for (const Soup::Isolated& p : soup.isolated()) in.isolated.push_back(in.vertex_of[p.point.index()]);
  std::sort(in.isolated.begin(), in.isolated.end());
  in.isolated.erase(std::unique(in.isolated.begin(), in.isolated.end()), in.isolated.end());
  return in;
}

}  // namespace cnrg
