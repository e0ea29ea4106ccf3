// For two faces: signs of the corners of each against the plane of the other, which settle most pairs; then the
// points
// (`Event`) of each face on the common line, sorted; then one merge of both lists, in which the intervals that
// both faces cover are the traces.
#include "kernel/refine/pair_tester.h"

#include <optional>

#include "kernel/exact/predicates.h"
#include "kernel/refine/box.h"

namespace cnrg {
namespace {

/// The loops of a face: calls `visit(i, j)` for each side from corner i to corner j.
template <class Visit>
void for_each_side(std::span<const VertexId> corners, const Visit& visit) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!corners[i].valid()) {
      begin = i + 1;
      continue;
    }
    visit(i, i + 1 < corners.size() && corners[i + 1].valid() ? i + 1 : begin);
  }
}

}  // namespace

PairTester::Contact PairTester::signs(SourceId f, SourceId g, std::vector<int>& out) {
  const auto corners = in_.corners[f];
  const PlaneFilter& plane = in_.filters[g.index()];
  out.assign(corners.size(), 0);
  bool positive = false, negative = false, zero = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const VertexId v = corners[i];
    if (!v.valid()) continue;
    if (!has_corner(g, v)) {
      out[i] = plane.side(t_.lower(v), width_of(t_, v));
      if (out[i] != kUndecided) ++filtered;
      else if (known_coplanar(f, g)) return Contact::coplanar;
      else out[i] = side_of_plane(t_, RefineInput::plane(g), v);
    }
    positive = positive || out[i] > 0;
    negative = negative || out[i] < 0;
    zero = zero || out[i] == 0;
  }
  if (!zero && positive != negative) return Contact::none;
  return positive || negative ? Contact::possible : Contact::coplanar;
}

/// True if f touches the plane of g from one side, in corners and sides that g shares: then the contact is a
/// corner or a side of both faces already.
bool PairTester::only_shared(SourceId f, SourceId g, const std::vector<int>& sign) const {
  const auto corners = in_.corners[f];
  bool positive = false, negative = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!corners[i].valid()) continue;
    if (sign[i] > 0) positive = true;
    if (sign[i] < 0) negative = true;
    if (sign[i] == 0 && !has_corner(g, corners[i])) return false;
  }
  if (positive && negative) return false;
  const auto sides = in_.sides[f];
  bool shared = true;
  for_each_side(corners, [&](std::size_t i, std::size_t j) {
    if (sign[i] != 0 || sign[j] != 0) return;
    shared = shared && boundaries_.has_side(g, sides[i]);
  });
  return shared;
}

/// True if two triangles, each with corners on both sides of the other's plane and none on it, do not meet: their
/// intervals on the common line are apart (Guigue & Devillers 2003, "Fast and robust triangle-triangle overlap
/// test using orientation predicates"). Two signs instead of four constructions and a sort.
bool PairTester::apart(SourceId f, SourceId g) const {
  struct Corners {
    std::array<VertexId, 3> v;  // the one alone on its side first, cyclic order kept
    int side = 0;               // its side
  };
  const auto rotated = [&](SourceId face, const std::vector<int>& sign) -> Corners {
    const auto corners = in_.corners[face];
    if (corners.size() != 3 || sign[0] * sign[1] * sign[2] == 0) return {};
    const std::size_t lone = sign[1] == sign[2] ? 0 : (sign[0] == sign[2] ? 1 : 2);
    return {{corners[lone], corners[(lone + 1) % 3], corners[(lone + 2) % 3]}, sign[lone]};
  };
  Corners p = rotated(f, sign_f_), q = rotated(g, sign_g_);
  if (p.side == 0 || q.side == 0) return false;
  if (p.side < 0) std::swap(q.v[1], q.v[2]);
  if (q.side < 0) std::swap(p.v[1], p.v[2]);
  return orient3d(t_, p.v[0], p.v[1], q.v[0], q.v[1]) > 0 || orient3d(t_, p.v[0], p.v[2], q.v[2], q.v[0]) > 0;
}

/// A definition's enclosure as a view; the exact value is made when `order` needs it.
PointView PairTester::view_of_key(const PointKey& key, const Definition& d) {
  if (key.kind == PointKey::Kind::vertex) return t_.view(VertexId(key.id[0]));
  PointView p;
  t_.enclose(d, p.lo, p.hi);
  return p;
}

const ExactPoint& PairTester::exact(Event& e) {
  if (e.view.table != nullptr) return e.view.exact();
  if (e.view.value == nullptr) {
    exact_.push_back(t_.exact_value(definition_of(e.key, in_)));
    e.view.value = &exact_.back();
  }
  return *e.view.value;
}

/// Order along the common line: -1, 0, 1. The direction is the same within one pair of faces.
int PairTester::order(Event& a, Event& b) {
  if (a.key == b.key) return 0;
  if (axis_ >= 0 && (a.view.hi[axis_] < b.view.lo[axis_])) return -1;
  if (axis_ >= 0 && (a.view.lo[axis_] > b.view.hi[axis_])) return 1;
  const auto known = [&](const PointView& p) { return axis_ >= 0 ? p.lo[axis_] == p.hi[axis_] : p.is_double(); };
  if (!known(a.view) || !known(b.view)) {
    exact(a);
    exact(b);
  }
  return axis_ >= 0 ? compare(axis_, a.view, b.view) : compare_lex(a.view, b.view);
}

/// The events of f on the plane of g, not sorted. With the line shifted a little to the positive side of g, a
/// side of f toggles inside and outside where exactly one of its ends is positive. A side in the plane covers the
/// line between its ends itself; `faces` counts those in `depth`.
void PairTester::cut(SourceId f, SourceId g, const std::vector<int>& sign, std::vector<Event>& events) {
  events.clear();
  const auto corners = in_.corners[f];
  const auto sides = in_.sides[f];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i].valid() && sign[i] == 0) {
      events.push_back({PointKey::vertex(corners[i]), t_.view(corners[i]), false, 0, 0});
    }
  }
  const auto at = [&](std::size_t corner) -> Event& {
    return *std::find_if(events.begin(), events.end(),
                         [&](const Event& e) { return e.key == PointKey::vertex(corners[corner]); });
  };
  for_each_side(corners, [&](std::size_t i, std::size_t j) {
    if (sign[i] * sign[j] < 0) {
      const PointKey key = PointKey::segment_plane(sides[i], g);
      events.push_back({key, view_of_key(key, definition_of(key, in_)), false, 1, 0});
    } else if (sign[i] == 0 && sign[j] > 0) {
      ++at(i).toggles;
    } else if (sign[j] == 0 && sign[i] > 0) {
      ++at(j).toggles;
    }
  });
}

/// A coordinate in which two points of the line certainly differ orders the whole line.
void PairTester::choose_axis() {
  axis_ = -1;
  double best = 0;
  const auto gap = [](const Event& a, const Event& b, int k) {
    return std::max(b.view.lo[k] - a.view.hi[k], a.view.lo[k] - b.view.hi[k]);
  };
  const auto scan = [&](const std::vector<Event>& events) {
    for (std::size_t i = 1; i < events.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const double d = gap(events[0], events[i], k);
        if (d > best) {
          best = d;
          axis_ = k;
        }
      }
    }
  };
  scan(events_f_);
  scan(events_g_);
}

void PairTester::faces(SourceId f, SourceId g) {
  if (in_.corners[f].size() > in_.corners[g].size()) std::swap(f, g);  // the small face decides most pairs alone
  const Contact cf = signs(f, g, sign_f_);
  if (cf == Contact::none) return;
  if (cf == Contact::coplanar) {
    note_coplanar(f, g);
    return;
  }
  if (only_shared(f, g, sign_f_)) return;
  if (signs(g, f, sign_g_) == Contact::none || only_shared(g, f, sign_g_)) return;

  if (apart(f, g)) return;

  exact_.clear();
  cut(f, g, sign_f_, events_f_);
  cut(g, f, sign_g_, events_g_);
  choose_axis();
  const auto sort_events = [&](SourceId face, const std::vector<int>& sign, std::vector<Event>& events) {
    std::sort(events.begin(), events.end(), [&](const Event& a, const Event& b) {
      return order(const_cast<Event&>(a), const_cast<Event&>(b)) < 0;
    });
    // A vertex that appears in two loops is one event.
    std::size_t n = 0;
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (n > 0 && events[n - 1].key == events[i].key) {
        events[n - 1].toggles += events[i].toggles;
      } else {
        events[n++] = events[i];
      }
    }
    events.resize(n);
    const auto corners = in_.corners[face];
    for_each_side(corners, [&](std::size_t i, std::size_t j) {
      if (sign[i] != 0 || sign[j] != 0) return;
      std::size_t p = n, q = n;
      for (std::size_t k = 0; k < n; ++k) {
        if (events[k].key == PointKey::vertex(corners[i])) p = k;
        if (events[k].key == PointKey::vertex(corners[j])) q = k;
      }
      if (p > q) std::swap(p, q);
      ++events[p].depth;
      --events[q].depth;
    });
    int parity = 0, depth = 0;
    for (Event& e : events) {
      parity += e.toggles;
      depth += e.depth;
      e.covered_after = parity % 2 != 0 || depth > 0;
    }
  };
  sort_events(f, sign_f_, events_f_);
  sort_events(g, sign_g_, events_g_);

  // Merge along the line. `last` is the last point found on both faces: the begin of a trace if both cover what
  // follows it.
  bool trace = false;
  std::optional<PointKey> last;
  bool last_was_run = false, f_on = false, g_on = false;
  std::size_t i = 0, j = 0;
  const auto on_both = [&](const PointKey& key) {
    list.on_face.push_back({f, key});
    list.on_face.push_back({g, key});
  };
  while (i < events_f_.size() || j < events_g_.size()) {
    const int o = i == events_f_.size() ? 1 : j == events_g_.size() ? -1 : order(events_f_[i], events_g_[j]);
    const bool take_f = o <= 0, take_g = o >= 0;
    const bool before_f = f_on, before_g = g_on;
    const bool at_f = take_f || f_on, at_g = take_g || g_on;
    PointKey key = take_f ? events_f_[i].key : events_g_[j].key;
    if (take_f && take_g && events_g_[j].key != key) {
      // Two symbols of one point: both are kept, so that identity and incidence are known later.
      const PointKey other = events_g_[j].key;
      if (at_f && at_g) on_both(other);
      if (other.kind == PointKey::Kind::vertex) key = other;
    }
    if (take_f) f_on = events_f_[i].covered_after;
    if (take_g) g_on = events_g_[j].covered_after;
    if (at_f && at_g) {
      if (before_f && before_g && last) {
        list.traces.push_back({std::min(f, g), std::max(f, g), *last, key});
        trace = true;
        last_was_run = true;
      } else {
        last_was_run = false;
      }
      if (!last_was_run && !(f_on && g_on)) {
        // A touching point; corners that both faces share need no record.
        const bool shared = key.kind == PointKey::Kind::vertex && has_corner(f, VertexId(key.id[0])) &&
                            has_corner(g, VertexId(key.id[0]));
        if (!shared) {
          on_both(key);
          list.kinds[key.kind != PointKey::Kind::vertex ? 3 : (take_f && take_g ? 4 : 2)] += copies(f) * copies(g);
        }
      }
      if (take_f && take_g && events_f_[i].key != key) on_both(events_f_[i].key);
      last = key;
    }
    if (take_f) ++i;
    if (take_g) ++j;
  }
  if (trace) list.kinds[0] += copies(f) * copies(g);
}

void PairTester::wire_face(SegmentId s, SourceId f) {
  const auto& ends = in_.segment_ends[s];
  const PlaneId plane = RefineInput::plane(f);
  int side[2];
  for (int i = 0; i < 2; ++i) side[i] = has_corner(f, ends[i]) ? 0 : side_of_plane(t_, plane, ends[i]);
  if (side[0] * side[1] > 0) return;
  if (side[0] == 0 && side[1] == 0) {
    list.wires_in_plane.push_back({f, s});
    list.kinds[1] += copies(f);
    return;
  }
  if (side[0] * side[1] < 0) {
    const PointKey key = PointKey::segment_plane(s, f);
    const Definition d = definition_of(key, in_);
    PointView p;
    t_.enclose(d, p.lo, p.hi);
    exact_.clear();
    // The exact value is made only if the enclosure meets the box of the face.
    const Projection axes = projection_of(t_, plane);
    Box box;
    for (const VertexId v : in_.corners[f]) {
      if (v.valid()) box.extend(t_.view(v).lo, t_.view(v).hi);
    }
    if (!box.meets(Box{p.lo, p.hi})) return;
    const ExactPoint value = t_.exact_value(d);
    p.value = &value;
    if (locate_in_face(in_, f, axes, p) == 0) return;
    list.on_face.push_back({f, key});
    list.on_wire.push_back({s, key});
    list.kinds[1] += copies(f);
    return;
  }
  point_in_plane(side[0] == 0 ? ends[0] : ends[1], f);
}

void PairTester::point_face(VertexId p, SourceId f) {
  if (!has_corner(f, p) && side_of_plane(t_, RefineInput::plane(f), p) == 0) point_in_plane(p, f);
}

void PairTester::point_in_plane(VertexId p, SourceId f) {
  if (has_corner(f, p)) return;
  if (locate_in_face(in_, f, projection_of(t_, RefineInput::plane(f)), t_.view(p)) == 0) return;
  list.on_face.push_back({f, PointKey::vertex(p)});
  list.kinds[2] += copies(f);
}

void PairTester::point_wire(VertexId p, SegmentId s) {
  const auto [a, b] = in_.segment_ends[s];
  if (p == a || p == b || !collinear(t_, a, b, p)) return;
  if (compare_lex(t_, a, p) < 0 && compare_lex(t_, p, b) < 0) {
    list.on_wire.push_back({s, PointKey::vertex(p)});
    ++list.kinds[4];
  }
}

void PairTester::wires(SegmentId s, SegmentId t) {
  const auto [a, b] = in_.segment_ends[s];
  const auto [c, d] = in_.segment_ends[t];
  const bool share = a == c || a == d || b == c || b == d;
  if (!share && orient3d(t_, a, b, c, d) != 0) return;
  // Coplanar. If some projection shows c or d off the line ab, there are two lines, and their plane is not seen
  // edge-on: signs in it decide.
  for (std::uint8_t k = 0; k < 3; ++k) {
    const Projection axes{static_cast<std::uint8_t>((k + 1) % 3), static_cast<std::uint8_t>((k + 2) % 3)};
    const int oc = orient2d(t_, axes, a, b, c), od = orient2d(t_, axes, a, b, d);
    if (oc == 0 && od == 0) continue;
    const int oa = orient2d(t_, axes, c, d, a), ob = orient2d(t_, axes, c, d, b);
    if (oc * od > 0 || oa * ob > 0) return;
    if (oc == 0) return point_wire(c, s);
    if (od == 0) return point_wire(d, s);
    if (oa == 0) return point_wire(a, t);
    if (ob == 0) return point_wire(b, t);
    const PointKey key = PointKey::segments(s, t);
    list.on_wire.push_back({s, key});
    list.on_wire.push_back({t, key});
    ++list.kinds[3];
    return;
  }
  // One line: ends of each in the other.
  point_wire(a, t);
  point_wire(b, t);
  point_wire(c, s);
  point_wire(d, s);
}

int locate_in_face(const RefineInput& in, SourceId face, Projection axes, const PointView& p) {
  const PointTable& t = in.points;
  const auto corners = in.corners[face];
  bool inside = false, boundary = false;
  for_each_side(corners, [&](std::size_t i, std::size_t j) {
    if (boundary) return;
    const PointView a = t.view(corners[i]), b = t.view(corners[j]);
    const int ca = compare(axes.v, a, p), cb = compare(axes.v, b, p);
    if (ca == 0 && cb == 0) {
      if (compare(axes.u, a, p) * compare(axes.u, b, p) <= 0) boundary = true;
      return;
    }
    if ((ca <= 0) == (cb <= 0)) {
      if ((ca == 0 && compare(axes.u, a, p) == 0) || (cb == 0 && compare(axes.u, b, p) == 0)) boundary = true;
      return;
    }
    const int o = ca < cb ? orient2d(axes, a, b, p) : orient2d(axes, b, a, p);
    if (o == 0) boundary = true;
    if (o > 0) inside = !inside;
  });
  return boundary ? 1 : (inside ? 2 : 0);
}

}  // namespace cnrg
